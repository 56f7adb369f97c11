//! Periodic solutions looked for by solving for them on lattices of impacts, or of states at rest:
//! what nothing that is known leads to.
//!
//! Slices know branches of p-loop MPSs that begin at grazing, on a neighbouring slice or on a known
//! curve. A sheet of MPSs may be joined to none of these inside the window, as one between two
//! points of its edge. Motion without impacts may have branches that are closed, and on which
//! nothing relaxes that begins at rest.

use core::f64::consts::TAU;

use grazing_continuation::curve::{Curve, Window};
use grazing_continuation::locate::{Condition, locate_within};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns, flight_time, unknown};
use grazing_model::motion::Motion;
use grazing_model::{AnyOscillator, ImpactOscillator, OnWall, State};
use nalgebra::Vector2;
use rayon::prelude::*;

use crate::Scope;
use crate::grazing::HighestPoint;
use crate::progress::Progress;
use crate::tolerances::BETWEEN_ZEROS;

/// Cells of a lattice along y, μ or η, and along z,
const CELLS: [usize; 2] = [20, 30];
/// and along y where that is large.
const FAST_CELLS: usize = 10;
/// Newton's method does not leave the neighbouring cells, counted in diagonals of a cell.
const REACH: f64 = 1.5;
/// How often velocities up to twice as great are looked at, as long as there are solutions,
const DOUBLINGS: usize = 2;
/// and where there are none at all: a small window may hold nothing but fast ones.
const MOST_DOUBLINGS: usize = 6;
/// The parts into which the ranges are cut by the lines along which grazing is looked for.
const PARTS: u32 = 8;
/// The golden ratio: its multiples are spread evenly, whole numbers left out.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// The share of the largest impact velocity at which MPSs are looked for on the whole of a slice:
/// what begins at grazing, of motion of whatever period, has such velocities not far from there.
const SLOW: f64 = 0.05;

/// MPSs are looked for up to this impact velocity at least: motion is of order one where the wall's
/// distance from rest is.
const USUAL_VELOCITY: f64 = 2.0;

/// The impact velocity up to which MPSs are to be looked for beside curves of them that are known.
pub(crate) fn fastest<'a>(known: impl Iterator<Item = &'a Curve>) -> f64 {
    let points = known.flat_map(|curve| &curve.points);
    points.map(|point| point.solution.impact_velocity()).fold(USUAL_VELOCITY, f64::max)
}

/// MPSs of some numbers of loops p, with impact velocities up to some value and twice and four
/// times as much, each with its p: on every slice at both ends, at one μ between and at one small
/// impact velocity.
pub(crate) fn on_slices(
    oscillator: &AnyOscillator,
    loops: &[u32],
    window: Window,
    slices: &[f64],
    fastest: f64,
    progress: &dyn Progress,
) -> Vec<(u32, Unknowns)> {
    let slices = || slices.iter().copied().enumerate();
    let place = |share: f64, secondary: f64| [window.parameters([share, 0.0])[0], secondary];
    let share = |k: usize| {
        let turns = GOLDEN * (k as f64 + 1.0);
        turns - libm::floor(turns)
    };
    let slow = slices().flat_map(|(k, secondary)| {
        // What an edge cuts off may be met by no slice but there.
        let standing = [0.0, 1.0, share(k)].map(|share| Lattice::slow(place(share, secondary), fastest));
        standing.into_iter().chain([Lattice::lying(window, secondary, SLOW * fastest)])
    });
    let fast = |doubling: usize, from: f64| {
        let some = slices().filter(|(k, _)| k % (doubling + 1) == 0);
        some.map(|(k, secondary)| Lattice::fast(place(share(k), secondary), from)).collect()
    };
    on_lattices(oscillator, loops, slow.collect(), fast, fastest, progress)
}

/// The same on one slice, at so many values of μ from end to end and at one small impact velocity.
pub(crate) fn on_slice(
    oscillator: &AnyOscillator,
    loops: &[u32],
    window: Window,
    (secondary, places): (f64, u32),
    fastest: f64,
    progress: &dyn Progress,
) -> Vec<(u32, Unknowns)> {
    let share = |k: u32| f64::from(k) / f64::from(places - 1);
    let along = || (0..places).map(|k| [window.parameters([share(k), 0.0])[0], secondary]);
    let slow = along().map(|place| Lattice::slow(place, fastest));
    let slow = slow.chain([Lattice::lying(window, secondary, SLOW * fastest)]);
    let fast = |_, from| along().map(|place| Lattice::fast(place, from)).collect();
    on_lattices(oscillator, loops, slow.collect(), fast, fastest, progress)
}

/// The MPSs on lattices with impact velocities up to `fastest`, and on those for greater ones as
/// long as there are any; `fast` gives those from some velocity to twice as much.
fn on_lattices(
    oscillator: &AnyOscillator,
    loops: &[u32],
    slow: Vec<Lattice>,
    fast: impl Fn(usize, f64) -> Vec<Lattice>,
    fastest: f64,
    progress: &dyn Progress,
) -> Vec<(u32, Unknowns)> {
    let on = |lattices: Vec<Lattice>| -> Vec<(u32, Unknowns)> {
        let found = lattices.par_iter().map(|lattice| match progress.stopped() {
            true => Vec::new(),
            // Virtual impacts, which leave the wall, are none.
            false => lattice.zeros(oscillator, loops, 0.0),
        });
        found.collect::<Vec<_>>().concat()
    };
    let mut found = on(slow);
    let mut from = fastest;
    for doubling in 0..MOST_DOUBLINGS {
        let more = on(fast(doubling.min(DOUBLINGS - 1), from));
        if !found.is_empty() && (more.is_empty() || doubling + 1 == DOUBLINGS) {
            found.extend(more);
            break;
        }
        found.extend(more);
        from *= 2.0;
    }
    found
}

/// Periodic motion without impacts, with its highest point at some height, at an η.
pub(crate) fn highest_at(
    oscillator: &AnyOscillator,
    scope: &Scope,
    secondary: f64,
    height: f64,
) -> Vec<HighestPoint> {
    Lattice::lying(scope.window, secondary, 0.0).at_rest(oscillator, scope, height)
}

/// Grazing along lines of constant μ through the whole window.
pub(crate) fn grazing(
    oscillator: &AnyOscillator,
    scope: &Scope,
    progress: &dyn Progress,
) -> Vec<HighestPoint> {
    let found = (0..=PARTS).into_par_iter().map(|k| {
        let [primary, low] = scope.window.parameters([f64::from(k) / f64::from(PARTS), 0.0]);
        let start = Unknowns::new(0.0, 0.0, primary, low);
        let length = scope.window.widths()[1];
        let lattice = Lattice { start, side: unknown::SECONDARY, length, cells: CELLS[0] };
        if progress.stopped() { Vec::new() } else { lattice.at_rest(oscillator, scope, 0.0) }
    });
    found.collect::<Vec<_>>().concat()
}

/// The MPSs of an oscillator with impact velocities between two, as far as a lattice of impacts
/// separates them.
pub(crate) fn at(
    oscillator: &AnyOscillator,
    loops: &[u32],
    [slowest, fastest]: [f64; 2],
) -> Vec<(u32, Unknowns)> {
    Lattice::slow(oscillator.parameters(), fastest).zeros(oscillator, loops, slowest)
}

/// A lattice of impacts, or of states at rest, of all phases.
struct Lattice {
    /// Its first corner.
    start: Unknowns,
    /// The unknown that varies besides the phase,
    side: usize,
    /// and how far.
    length: f64,
    /// in so many cells.
    cells: usize,
}

impl Lattice {
    /// At a pair of parameters, impact velocities up to some value.
    fn slow([primary, secondary]: [f64; 2], fastest: f64) -> Self {
        let start = Unknowns::new(0.0, 0.0, primary, secondary);
        Self { start, side: unknown::VELOCITY, length: fastest, cells: CELLS[0] }
    }

    /// The same, from that value to twice as much.
    fn fast(place: [f64; 2], from: f64) -> Self {
        let mut lattice = Self { cells: FAST_CELLS, ..Self::slow(place, from) };
        lattice.start[unknown::VELOCITY] = from;
        lattice
    }

    /// At an η and one impact velocity, through the range of μ.
    fn lying(window: Window, secondary: f64, velocity: f64) -> Self {
        let [left, right] = window.primary;
        let start = Unknowns::new(velocity, 0.0, left, secondary);
        Self { start, side: unknown::PRIMARY, length: right - left, cells: CELLS[0] }
    }

    fn cell(&self) -> Unknowns {
        let mut cell = Unknowns::zeros();
        cell[self.side] = self.length / self.cells as f64;
        cell[unknown::PHASE] = TAU / CELLS[1] as f64;
        cell
    }

    /// The first corners of cells with a zero inside, as far as the lattice shows, of each of
    /// several functions.
    ///
    /// There both components change sign between the corners.
    fn cells(
        &self,
        functions: usize,
        values: impl Fn(&Unknowns) -> Vec<Vector2<f64>>,
    ) -> Vec<(usize, Unknowns)> {
        let cell = self.cell();
        let corner = |i: usize, k: usize| {
            let mut corner = self.start;
            corner[self.side] += cell[self.side] * i as f64;
            corner[unknown::PHASE] = cell[unknown::PHASE] * k as f64;
            corner
        };
        let values: Vec<Vec<Vec<Vector2<f64>>>> =
            (0..=self.cells).map(|i| (0..=CELLS[1]).map(|k| values(&corner(i, k))).collect()).collect();
        let places = (0..functions)
            .flat_map(|index| (0..self.cells).flat_map(move |i| (0..CELLS[1]).map(move |k| (index, i, k))));
        let changes = |index: usize, i: usize, k: usize, component: usize| {
            let corners = [(i, k), (i, k + 1), (i + 1, k), (i + 1, k + 1)];
            let positive = corners.iter().filter(|(i, k)| values[*i][*k][index][component] > 0.0).count();
            0 < positive && positive < corners.len()
        };
        let both = places.filter(|&(index, i, k)| changes(index, i, k, 0) && changes(index, i, k, 1));
        both.map(|(index, i, k)| (index, corner(i, k))).collect()
    }

    /// The MPSs that are faster than `slowest`, as far as the lattice separates them: zeros of how
    /// much an impact is missed by motion that begins with it, p forcing periods later and the wall
    /// ignored meanwhile, (x, ẋ − y).
    fn zeros(&self, oscillator: &AnyOscillator, loops: &[u32], slowest: f64) -> Vec<(u32, Unknowns)> {
        let Self { start, side, .. } = *self;
        let held = match side {
            unknown::VELOCITY => Condition::Primary(start[unknown::PRIMARY]),
            _ => Condition::ImpactVelocity(start[unknown::VELOCITY]),
        };
        let here = [held, Condition::Secondary(start[unknown::SECONDARY])];
        let cell = self.cell();
        // Only their signs are asked for.
        let rough = oscillator.roughly();
        let mut found: Vec<(u32, Unknowns)> = Vec::new();
        for (index, first) in self.cells(loops.len(), |impact| misses(&rough, loops, impact)) {
            let loops = loops[index];
            let inside = |zero: &Unknowns| {
                [side, unknown::PHASE]
                    .iter()
                    .all(|&side| (0.0..=1.0).contains(&((zero[side] - first[side]) / cell[side])))
            };
            if found.iter().any(|(other, zero)| *other == loops && inside(zero)) {
                continue;
            }
            let equations = LoopEquations::new(oscillator.clone(), loops, Formulation::FixedPhase);
            let reach = REACH * cell.norm();
            let middle = first + cell * 0.5;
            let zero = locate_within(reach, &equations, here, middle, &mut EventTimes::default());
            let new = zero.ok().filter(|zero| {
                zero[unknown::VELOCITY] > slowest
                    && !found.iter().any(|(other, at)| *other == loops && same(at, zero))
            });
            found.extend(new.map(|zero| (loops, zero)));
        }
        found
    }

    /// Periodic motion without impacts with its highest point at some height.
    fn at_rest(&self, oscillator: &AnyOscillator, scope: &Scope, height: f64) -> Vec<HighestPoint> {
        let rough = oscillator.roughly();
        let held = if self.side == unknown::PRIMARY { unknown::SECONDARY } else { unknown::PRIMARY };
        let missed = |state: &Unknowns| {
            let [_, phase, primary, secondary] = (*state).into();
            let oscillator = rough.with_parameters([primary, secondary]);
            let end = oscillator.motion(State::at_rest(height, phase)).at(oscillator.forcing_period());
            vec![Vector2::new(end.position - height, end.velocity)]
        };
        let cells = self.cells(1, missed).into_iter().filter_map(|(_, first)| {
            let [_, phase, primary, secondary] = (first + self.cell() * 0.5).into();
            let near = HighestPoint { height, phase, parameters: [primary, secondary] };
            near.located(oscillator, scope, held).filter(|found| scope.window.contains(found.parameters))
        });
        cells.collect()
    }
}

/// Whether two MPSs are one.
fn same(a: &Unknowns, b: &Unknowns) -> bool {
    let mut gap = a - b;
    gap[unknown::PHASE] = libm::remainder(gap[unknown::PHASE], TAU);
    gap.norm() < BETWEEN_ZEROS
}

/// By how much motion that begins with an impact misses it some numbers of forcing periods later.
fn misses(oscillator: &AnyOscillator, loops: &[u32], impact: &Unknowns) -> Vec<Vector2<f64>> {
    let [velocity, phase, primary, secondary] = (*impact).into();
    let oscillator = oscillator.with_parameters([primary, secondary]);
    let recoil = oscillator.reset::<1>(OnWall::new(velocity, phase)).value;
    let motion = oscillator.motion(State::on_wall(recoil[0], recoil[1]));
    let after = |loops: &u32| {
        let end = motion.at(flight_time(&oscillator, *loops, phase, recoil[1]));
        Vector2::new(end.position, end.velocity - velocity)
    };
    loops.iter().map(after).collect()
}

#[cfg(test)]
mod tests {

    use super::*;
    use crate::progress::Silent;
    use crate::simulation::{ReturnOutcome, Suspect};

    #[test]
    fn simulation_comes_back_to_the_admissible_ones_of_the_solutions_that_are_found() {
        let oscillator = crate::specimens::linear(0.05, [0.5, 0.9]);
        let window = Window { primary: [0.3, 1.2], secondary: [0.6, 1.0] };
        let slices = [0.65, 0.75, 0.85, 0.95];
        let found = on_slices(&oscillator, &[1, 2], window, &slices, 2.0, &Silent);
        for (loops, zero) in &found {
            let here = oscillator.with_parameters([zero[2], zero[3]]);
            let suspect = Suspect::of(&here, *loops, zero);
            let solution = LoopEquations::new(here.clone(), *loops, Formulation::FixedPhase).solution(zero);
            assert_eq!(suspect.follow() == ReturnOutcome::Returns, solution.admissible(), "{loops}: {zero}");
        }
        let of = |p: u32| found.iter().filter(|(loops, _)| *loops == p).count();
        assert!(of(1) >= slices.len() && of(2) >= 1, "{found:?}");
        let known = |k: usize| {
            found[..k].iter().any(|(p, at)| {
                *p == found[k].0 && at[3] == found[k].1[3] && at[2] == found[k].1[2] && same(at, &found[k].1)
            })
        };
        assert!(!(1..found.len()).any(known));
    }

    #[test]
    fn a_zero_in_the_last_row_is_found_once_wherever_phases_begin_and_impacts_from_behind_are_none() {
        let oscillator = crate::specimens::linear(0.05, [0.5, 0.9]);
        let lattice = Lattice::slow([0.5, 0.9], 2.0);
        let all = lattice.zeros(&oscillator, &[1], 0.0);
        let (_, zero) = *all.iter().max_by(|a, b| a.1[0].total_cmp(&b.1[0])).expect("there are some");
        let count = |lattice: &Lattice| {
            let found = lattice.zeros(&oscillator, &[1], 0.0);
            // Zeros are located to some 10⁻¹⁰.
            let near = |other: &Unknowns| {
                libm::cos(other[unknown::PHASE] - zero[unknown::PHASE]) > 1.0 - 1e-12
                    && (other[unknown::VELOCITY] - zero[unknown::VELOCITY]).abs() < 1e-6
            };
            found.iter().filter(|(_, other)| near(other)).count()
        };
        // It lies in the middle of the last row.
        let rows = lattice.cells as f64;
        let last = Lattice::slow([0.5, 0.9], zero[0] * rows / (rows - 0.5));
        assert_eq!(count(&last), 1);
        // And with the seam of the phases in the middle of its cell, and at the cell's both edges.
        for share in [-1.0, -0.5, -0.01, 0.0, 0.01, 0.5] {
            let mut seam = Lattice::slow([0.5, 0.9], 2.0);
            seam.start[unknown::PHASE] = zero[unknown::PHASE] + share * seam.cell()[unknown::PHASE];
            assert_eq!(count(&seam), 1, "{share}");
        }
        assert!(same(&zero, &(zero + Unknowns::y() * TAU)) && !same(&zero, &(zero + Unknowns::y())));
        // Zeros with y < 0 are there, beyond grazing, and are left out.
        let mut behind = Lattice::slow([0.5, 0.9], 4.0);
        behind.start[unknown::VELOCITY] = -2.0;
        let zeros = |slowest: f64| behind.zeros(&oscillator, &[1, 2, 3], slowest);
        assert!(zeros(f64::NEG_INFINITY).iter().any(|(_, zero)| zero[0] < 0.0));
        assert!(zeros(0.0).iter().all(|(_, zero)| zero[0] > 0.0));
    }
}
