//! The search for periodic solutions on lattices of impacts, or of states at rest: it finds
//! solutions to which no known curve leads.
//!
//! Slices contain branches of p-loop MPSs that begin at grazing, on a neighbouring slice or on a
//! known curve. A sheet of MPSs may be connected to none of these inside the window, such as one
//! between two points of its edge. Motion without impacts may have branches that are closed, and on
//! which no motion relaxes that begins at rest.

mod density;
mod field;

use core::f64::consts::{PI, TAU};

use grazing_continuation::curve::Window;
use grazing_continuation::flights::flight_time;
use grazing_continuation::locate::{Condition, LocateFailure, locate_within};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns, unknown};
use grazing_model::motion::Motion;
use grazing_model::smooth::Purpose;
use grazing_model::{AnyOscillator, ImpactOscillator, OnWall, State};
use nalgebra::{Matrix2, Vector2};

use self::field::{LatticeFunctions, Missed, SIZE};
use crate::Scope;
use crate::grazing::HighestPoint;
use crate::parallel;
use crate::progress::Progress;
use crate::tolerances::BETWEEN_ZEROS;

/// Number of cells of a lattice along y, μ or η, and along z.
const CELLS: [u32; 2] = [5, 10];
/// Number of cells along y where y is large.
const FAST_CELLS: u32 = 3;
/// Reach of Newton's method, which does not leave the neighbouring cells, in diagonals of a cell.
const REACH: f64 = 1.5;
/// Trace of the multipliers above which, all over a small cell, solutions in it do not matter
/// (empirical): what is stable nearby is too small to be drawn.
const LOST_TRACE: f64 = 100.0;
/// Least number of doublings of the impact velocity in the search, which also continues as long as
/// there are solutions; it is the same in every window, whatever is known there.
const DOUBLINGS: usize = 3;
/// Number of doublings where no solution is found: a small window may contain only fast ones.
const MOST_DOUBLINGS: usize = 6;
/// Number of parts into which the ranges are cut by the lines along which grazing is looked for.
const PARTS: u32 = 8;
/// The golden ratio: the fractional parts of its multiples are evenly spread.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Fraction of the usual impact velocities at which MPSs are looked for along the whole of a slice:
/// solutions that begin at grazing, of motion of any period, have such velocities not far from
/// there.
const SLOW: f64 = 0.05;

/// Largest impact velocity in the first search for MPSs: motion is of order one where the wall's
/// distance from rest is.
pub(crate) const USUAL_VELOCITY: f64 = 2.0;

/// MPSs of some numbers of loops p, each with its p: on slices at both ends, at one μ between and at
/// one small impact velocity; on every slice unless motion changes little from one to the next.
pub(crate) fn on_slices(
    oscillator: &AnyOscillator,
    loops: &[u32],
    window: Window,
    slices: &[f64],
    progress: &dyn Progress,
) -> Vec<(u32, Unknowns)> {
    let places = slices.iter().enumerate().map(|(k, secondary)| {
        let turns = GOLDEN * (k as f64 + 1.0);
        // A sheet cut off by an edge may be met by slices only there.
        let shares = [0.0, 1.0, turns - libm::floor(turns)];
        (*secondary, shares.map(|share| [window.parameters([share, 0.0])[0], *secondary]).to_vec())
    });
    on_lattices(oscillator, loops, window, &places.collect::<Vec<_>>(), progress)
}

/// MPSs on one slice, at `places` values of μ from end to end and at one small impact velocity.
pub(crate) fn on_slice(
    oscillator: &AnyOscillator,
    loops: &[u32],
    window: Window,
    (secondary, places): (f64, u32),
    progress: &dyn Progress,
) -> Vec<(u32, Unknowns)> {
    let share = |k: u32| f64::from(k) / f64::from(places - 1);
    let places = (0..places).map(|k| [window.parameters([share(k), 0.0])[0], secondary]);
    on_lattices(oscillator, loops, window, &[(secondary, places.collect())], progress)
}

/// A value of η, and the places on its slice.
type OnSlice = (f64, Vec<[f64; 2]>);

/// The MPSs at places on some slices, at increasing impact velocities, and along the slices at one small
/// impact velocity; on fewer of them where motion changes little from one to the next.
fn on_lattices(
    oscillator: &AnyOscillator,
    loops: &[u32],
    window: Window,
    slices: &[OnSlice],
    progress: &dyn Progress,
) -> Vec<(u32, Unknowns)> {
    let on = |lattices: Vec<Lattice>| -> Vec<(u32, Unknowns)> {
        let found = parallel::map(lattices, |lattice| match progress.stopped() {
            true => Vec::new(),
            // Virtual impacts, which leave the wall, do not count.
            false => Purpose::Lattices.during(|| lattice.zeros(oscillator, loops, 0.0)),
        });
        found.concat()
    };
    let needed = |lattice: &dyn Fn([f64; 2]) -> Lattice| {
        let stride = || density::stride(slices.len() - 1, lattice, (oscillator, loops), window);
        slices.iter().step_by(Purpose::Lattices.during(stride))
    };
    let slow = |place: [f64; 2]| Lattice::slow(place, USUAL_VELOCITY);
    let seen = needed(&slow);
    let lying = seen.clone().filter(|_| window.widths()[0] > 0.0);
    let lying = lying.map(|(secondary, _)| Lattice::lying(window, *secondary, SLOW * USUAL_VELOCITY));
    let mut found = on(seen.flat_map(|(_, places)| places).map(|place| slow(*place)).chain(lying).collect());
    let mut from = USUAL_VELOCITY;
    for doubling in 0..MOST_DOUBLINGS {
        let fast = |place: [f64; 2]| Lattice::fast(place, from);
        let more = on(needed(&fast).flat_map(|(_, places)| places).map(|place| fast(*place)).collect());
        if !found.is_empty() && more.is_empty() && doubling + 1 >= DOUBLINGS {
            break;
        }
        found.extend(more);
        from *= 2.0;
    }
    found
}

/// Periodic motion without impacts, with its highest point at a given height and η.
pub(crate) fn highest_at(
    oscillator: &AnyOscillator,
    scope: &Scope,
    secondary: f64,
    height: f64,
) -> Vec<HighestPoint> {
    let lattice = Lattice::lying(scope.window, secondary, 0.0);
    Purpose::Lattices.during(|| lattice.at_rest(oscillator, scope, height))
}

/// Grazing along lines of constant μ through the whole window.
pub(crate) fn grazing(
    oscillator: &AnyOscillator,
    scope: &Scope,
    progress: &dyn Progress,
) -> Vec<HighestPoint> {
    let found = parallel::map(0..=PARTS, |k| {
        let [primary, low] = scope.window.parameters([f64::from(k) / f64::from(PARTS), 0.0]);
        let start = Unknowns::new(0.0, 0.0, primary, low);
        let length = scope.window.widths()[1];
        let lattice = Lattice { start, side: unknown::SECONDARY, length, cells: CELLS[0] };
        match progress.stopped() {
            true => Vec::new(),
            false => Purpose::Lattices.during(|| lattice.at_rest(oscillator, scope, 0.0)),
        }
    });
    found.concat()
}

/// The MPSs of an oscillator that are faster than `slowest`, as far as lattices of impacts separate them;
/// impact velocities are those at which slices are searched.
pub(crate) fn at(
    oscillator: &AnyOscillator,
    loops: &[u32],
    slowest: f64,
    progress: &dyn Progress,
) -> Vec<(u32, Unknowns)> {
    let place @ [primary, secondary] = oscillator.parameters();
    let window = Window { primary: [primary; 2], secondary: [secondary; 2] };
    let mut found: Vec<(u32, Unknowns)> = Vec::new();
    for (loops, zero) in on_lattices(oscillator, loops, window, &[(secondary, vec![place])], progress) {
        // One on the border of two lattices is found on both.
        let known = found.iter().any(|(other, at)| *other == loops && same(at, &zero));
        if zero[unknown::VELOCITY] > slowest && !known {
            found.push((loops, zero));
        }
    }
    found.sort_by_key(|(loops, _)| *loops);
    found
}

/// A lattice of impacts, or of states at rest, of all phases.
struct Lattice {
    /// The first corner of the lattice.
    start: Unknowns,
    /// The unknown that varies besides the phase.
    side: usize,
    /// The length of the range of that unknown.
    length: f64,
    /// The number of cells along it.
    cells: u32,
}

impl Lattice {
    /// A lattice at a pair of parameters, with impact velocities up to `fastest`.
    fn slow([primary, secondary]: [f64; 2], fastest: f64) -> Self {
        let start = Unknowns::new(0.0, 0.0, primary, secondary);
        Self { start, side: unknown::VELOCITY, length: fastest, cells: CELLS[0] }
    }

    /// A lattice with impact velocities from `from` to twice that value.
    fn fast(place: [f64; 2], from: f64) -> Self {
        let mut lattice = Self { cells: FAST_CELLS, ..Self::slow(place, from) };
        lattice.start[unknown::VELOCITY] = from;
        lattice
    }

    /// A lattice at an η and one impact velocity, through the range of μ.
    fn lying(window: Window, secondary: f64, velocity: f64) -> Self {
        let [left, right] = window.primary;
        let start = Unknowns::new(velocity, 0.0, left, secondary);
        Self { start, side: unknown::PRIMARY, length: right - left, cells: CELLS[0] }
    }

    /// The sides of the cells in which the search begins, or of the lattice's coordinates if `parts` is the
    /// length of one of these.
    fn sides(&self, parts: u32) -> [Unknowns; 2] {
        let mut sides = [self.start.filled(0.0), self.start.filled(0.0)];
        sides[0][self.side] = self.length / f64::from(self.cells * parts);
        sides[1][unknown::PHASE] = TAU / f64::from(CELLS[1] * parts);
        sides
    }

    /// The cells in which some functions may vanish, as [`LatticeFunctions::cells`] finds them.
    fn cells(
        &self,
        functions: usize,
        values: impl Fn(&Unknowns, &[usize]) -> Vec<Missed>,
        is_idle: impl Fn(&[Unknowns; 2], &[Missed; 4]) -> bool,
    ) -> Vec<(usize, [Unknowns; 2])> {
        let [across, up] = self.sides(SIZE);
        let place = |[i, k]: [u32; 2]| &self.start + &across * f64::from(i) + &up * f64::from(k);
        LatticeFunctions::new(place, CELLS[1] * SIZE, functions, values, is_idle)
            .cells([self.cells, CELLS[1]])
    }

    /// The MPSs that are faster than `slowest`, as far as the lattice separates them: zeros of (x,
    /// ẋ − y), the distance by which motion that begins with an impact misses it after p forcing
    /// periods, with the wall ignored meanwhile.
    fn zeros(&self, oscillator: &AnyOscillator, loops: &[u32], slowest: f64) -> Vec<(u32, Unknowns)> {
        let Self { start, side, .. } = self;
        let side = *side;
        let held = match side {
            unknown::VELOCITY => Condition::Primary(start[unknown::PRIMARY]),
            _ => Condition::ImpactVelocity(start[unknown::VELOCITY]),
        };
        let here = [held, Condition::Secondary(start[unknown::SECONDARY])];
        // Only the signs are needed.
        let rough = oscillator.roughly();
        let mut found: Vec<(u32, Unknowns)> = Vec::new();
        let values = |impact: &Unknowns, indices: &[usize]| {
            misses(&rough, indices.iter().map(|index| loops[*index]), impact)
        };
        let here_rough = rough.with_parameters([start[unknown::PRIMARY], start[unknown::SECONDARY]]);
        let is_idle = |cell: &[Unknowns; 2], corners: &[Missed; 4]| {
            side == unknown::VELOCITY && is_violent(&here_rough, cell, corners)
        };
        for (index, [first, cell]) in self.cells(loops.len(), values, is_idle) {
            let loops = loops[index];
            let inside = |zero: &Unknowns| {
                [side, unknown::PHASE]
                    .iter()
                    .all(|&side| (0.0..=1.0).contains(&((zero[side] - first[side]) / cell[side])))
            };
            if found.iter().any(|(other, zero)| *other == loops && inside(zero)) {
                continue;
            }
            let reach = REACH * cell.norm();
            let locate = |oscillator: &AnyOscillator, near: Unknowns| {
                let equations = LoopEquations::new(oscillator.clone(), loops, Formulation::FixedPhase);
                locate_within(reach, &equations, here, near, &mut EventTimes::default())
            };
            // Newton's method leaves most cells, for which few digits are enough.
            let middle = &first + &cell * 0.5;
            let near = match locate(&rough, middle.clone()) {
                Err(LocateFailure::Elsewhere { .. }) => continue,
                found => found.unwrap_or(middle),
            };
            let zero = locate(oscillator, near).ok();
            let new = zero.filter(|zero| {
                zero[unknown::VELOCITY] > slowest
                    && !found.iter().any(|(other, at)| *other == loops && same(at, zero))
            });
            found.extend(new.map(|zero| (loops, zero)));
        }
        found
    }

    /// Periodic motion without impacts with its highest point at a given height.
    fn at_rest(&self, oscillator: &AnyOscillator, scope: &Scope, height: f64) -> Vec<HighestPoint> {
        let rough = oscillator.roughly();
        let held = if self.side == unknown::PRIMARY { unknown::SECONDARY } else { unknown::PRIMARY };
        let missed = |state: &Unknowns, _: &[usize]| {
            let [_, phase, primary, secondary] = (*state).clone().into();
            let oscillator = rough.with_parameters([primary, secondary]);
            let end = oscillator.motion(State::at_rest(height, phase)).at(oscillator.forcing_period());
            // Motion at rest is slow: its energy would add nothing.
            let missed = Vector2::new(end.position - height, end.velocity);
            vec![missed.push(missed.x)]
        };
        let cells = self.cells(1, missed, |_, _| false).into_iter().filter_map(|(_, [first, cell])| {
            let [_, phase, primary, secondary] = (first + cell * 0.5).into();
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

/// The distances by which motion that begins with an impact misses it after some numbers of forcing
/// periods.
fn misses(oscillator: &AnyOscillator, loops: impl Iterator<Item = u32>, impact: &Unknowns) -> Vec<Missed> {
    let [velocity, phase, primary, secondary] = (*impact).clone().into();
    let oscillator = oscillator.with_parameters([primary, secondary]);
    let recoil = oscillator.reset::<1>(OnWall::new(velocity, phase)).value;
    let motion = oscillator.motion(State::on_wall(recoil[0], recoil[1]));
    let after = |loops: u32| {
        let end = motion.at(flight_time(&oscillator, loops, phase, recoil[1]));
        let kinetic = 0.5 * (end.velocity * end.velocity - velocity * velocity);
        Missed::new(
            end.position,
            end.velocity - velocity,
            kinetic + potential(&oscillator, end.position, phase),
        )
    };
    loops.map(after).collect()
}

/// The potential energy at a position, compared with that at the wall: the work against the force on a
/// motionless oscillator, half of it at a phase and half of it half a period later, by Simpson's rule.
fn potential(oscillator: &AnyOscillator, position: f64, phase: f64) -> f64 {
    let force = |share: f64| {
        let at = |phase| oscillator.acceleration(State::at_rest(share * position, phase));
        0.5 * (at(phase) + at(phase + PI))
    };
    -position * (force(0.0) + 4.0 * force(0.5) + force(1.0)) / 6.0
}

/// Whether no solution in a cell of impacts (y, z) can be stable: the trace of its multipliers is large
/// and of one sign, as far as differences between the corners show.
fn is_violent(oscillator: &AnyOscillator, [first, cell]: &[Unknowns; 2], corners: &[Missed; 4]) -> bool {
    let middle = first + cell * 0.5;
    let frequency = oscillator.forcing_frequency().value;
    let [velocity, phase] = [middle[unknown::VELOCITY], middle[unknown::PHASE]];
    // The derivative of the straight way to the plane of the phase of impact.
    let acceleration = oscillator.acceleration(State::on_wall(velocity, phase));
    let straight = Matrix2::new(0.0, -velocity, frequency, -acceleration) / frequency;
    let [a, b, c, d] = corners.map(|corner| corner.xy());
    let (across, up) = (cell[unknown::VELOCITY], cell[unknown::PHASE]);
    let (across, up) = ([(c - a) / across, (d - b) / across], [(b - a) / up, (d - c) / up]);
    let traces = across.iter().flat_map(|by_velocity| {
        up.iter().map(|by_phase| {
            let missed = Matrix2::from_columns(&[*by_velocity, *by_phase]);
            let [one, minus_one] = [missed, missed + straight * 2.0].map(|matrix| matrix.determinant());
            0.5 * (minus_one - one) / straight.determinant()
        })
    });
    traces.filter(|trace| trace.abs() > LOST_TRACE).count() > 2
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
        let found = on_slices(&oscillator, &[1, 2], window, &slices, &Silent);
        for (loops, zero) in &found {
            let here = oscillator.with_parameters([zero[2], zero[3]]);
            let suspect = Suspect::of(&here, *loops, zero);
            let solution = LoopEquations::new(here.clone(), *loops, Formulation::FixedPhase).solution(zero);
            assert_eq!(
                suspect.follow() == ReturnOutcome::Returns,
                solution.admissible(),
                "{loops}: {zero:?}"
            );
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
    fn a_sheet_of_fast_solutions_beside_the_hill_of_a_pendulum_is_found_in_windows_of_several_sizes() {
        let pendulum = crate::specimens::forced("-0.04*v - 4*sin(x/4 + 0.4)", 0.8).oscillator([1.2, 0.9]);
        for width in [0.002, 0.01, 0.05, 0.3] {
            // There are two to the right of a saddle-node at 1.19, and each leads to the other.
            let window = Window { primary: [1.2 - width, 1.2 + width], secondary: [0.9, 0.95] };
            let found = on_slices(&pendulum, &[1], window, &[0.9], &Silent);
            let fast = found.iter().filter(|(_, zero)| (7.5..9.0).contains(&zero[unknown::VELOCITY]));
            let fast: Vec<Unknowns> = fast.map(|(_, zero)| zero.clone()).collect();
            assert!(!fast.is_empty(), "{width}");
        }
    }

    #[test]
    fn a_zero_in_the_last_row_is_found_once_wherever_phases_begin_and_impacts_from_behind_are_none() {
        let oscillator = crate::specimens::linear(0.05, [0.5, 0.9]);
        let lattice = Lattice::slow([0.5, 0.9], 2.0);
        let all = lattice.zeros(&oscillator, &[1], 0.0);
        let (_, zero) = all.iter().max_by(|a, b| a.1[0].total_cmp(&b.1[0])).expect("there are some").clone();
        let count = |lattice: &Lattice| {
            let found = lattice.zeros(&oscillator, &[1], 0.0);
            // Zeros are located to some 10⁻¹⁰.
            let near = |other: &Unknowns| {
                libm::cos(other[unknown::PHASE] - zero[unknown::PHASE]) > 1.0 - 1e-12
                    && (other[unknown::VELOCITY] - zero[unknown::VELOCITY]).abs() < 1e-6
            };
            found.iter().filter(|(_, other)| near(other)).count()
        };
        // The zero lies in the middle of the last row.
        let rows = f64::from(lattice.cells);
        let last = Lattice::slow([0.5, 0.9], zero[0] * rows / (rows - 0.5));
        assert_eq!(count(&last), 1);
        // Likewise with the seam of the phases in the middle of its cell, and at both edges of the
        // cell.
        for share in [-1.0, -0.5, -0.01, 0.0, 0.01, 0.5] {
            let mut seam = Lattice::slow([0.5, 0.9], 2.0);
            seam.start[unknown::PHASE] = zero[unknown::PHASE] + share * seam.sides(1)[1][unknown::PHASE];
            assert_eq!(count(&seam), 1, "{share}");
        }
        assert!(
            same(&zero, &(&zero + zero.along(unknown::PHASE) * TAU))
                && !same(&zero, &(&zero + zero.along(unknown::PHASE)))
        );
        // Zeros with y < 0 exist, beyond grazing, and are left out.
        let mut behind = Lattice::slow([0.5, 0.9], 4.0);
        behind.start[unknown::VELOCITY] = -2.0;
        let zeros = |slowest: f64| behind.zeros(&oscillator, &[1, 2, 3], slowest);
        assert!(zeros(f64::NEG_INFINITY).iter().any(|(_, zero)| zero[0] < 0.0));
        assert!(zeros(0.0).iter().all(|(_, zero)| zero[0] > 0.0));
    }
}
