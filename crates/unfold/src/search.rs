//! p-loop MPSs looked for on the whole wall, at some pairs of parameters.
//!
//! Slices know branches that begin at grazing, on a neighbouring slice or on a known curve. A sheet of MPSs that is joined to none of these
//! inside the window, as one between two points of its edge, or one that begins where motion of twice the forcing's period grazes, is found by solving
//! for it.

use core::f64::consts::TAU;

use grazing_continuation::curve::{Curve, Window};
use grazing_continuation::locate::{Condition, locate_within};
use grazing_continuation::mps::{
    EventTimes, Formulation, LoopEquations, MaximalPeriodicSolution, Unknowns, unknown,
};
use grazing_model::motion::Motion;
use grazing_model::{ImpactOscillator, OnWall, State};
use nalgebra::Vector2;
use rayon::prelude::*;

use crate::progress::Progress;

/// Cells of the lattice of impacts along y and z.
const CELLS: [usize; 2] = [20, 30];
/// Newton's method does not leave the neighbouring cells, counted in diagonals of a cell.
const REACH: f64 = 1.5;
/// Zeros closer than this are one.
const SAME: f64 = 1e-6;
/// Both edges of the window are looked at on every so many slices.
const EDGES_EVERY: usize = 4;
/// The golden ratio: its multiples are spread evenly, whole numbers left out.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// The share of the largest impact velocity at which MPSs are looked for on the whole of a slice: what begins at grazing, of motion of whatever
/// period, has such velocities not far from there.
const SLOW: f64 = 0.05;

/// MPSs are looked for up to this impact velocity at least: motion is of order one where the wall's distance from rest is.
const USUAL_VELOCITY: f64 = 2.0;

/// The impact velocity up to which MPSs are to be looked for beside curves of them that are known.
pub(crate) fn fastest<'a>(known: impl Iterator<Item = &'a Curve>) -> f64 {
    let points = known.flat_map(|curve| &curve.points);
    points.map(|point| point.solution.impact_velocity()).fold(USUAL_VELOCITY, f64::max)
}

/// MPSs of some numbers of loops p that are admissible or stable, with impact velocities up to some value, each with its p: on every slice at one μ
/// and at one small impact velocity, on some at both ends.
pub(crate) fn on_slices<O: ImpactOscillator>(
    oscillator: &O,
    loops: &[u32],
    window: Window,
    slices: &[f64],
    fastest: f64,
    progress: &dyn Progress,
) -> Vec<(u32, Unknowns)> {
    let lattices = slices.iter().enumerate().flat_map(|(k, &secondary)| {
        let turns = GOLDEN * (k as f64 + 1.0);
        let ends = if k % EDGES_EVERY == 0 { &[0.0, 1.0][..] } else { &[] };
        let shares = ends.iter().copied().chain([turns - libm::floor(turns)]);
        Lattice::of_slice(window, secondary, shares, fastest)
    });
    admissible_or_stable(oscillator, loops, &lattices.collect::<Vec<_>>(), progress)
}

/// The same on one slice, at so many values of μ from end to end and at one small impact velocity.
pub(crate) fn on_slice<O: ImpactOscillator>(
    oscillator: &O,
    loops: &[u32],
    window: Window,
    (secondary, places): (f64, u32),
    fastest: f64,
    progress: &dyn Progress,
) -> Vec<(u32, Unknowns)> {
    let shares = (0..places).map(|k| f64::from(k) / f64::from(places - 1));
    let lattices: Vec<Lattice> = Lattice::of_slice(window, secondary, shares, fastest).collect();
    admissible_or_stable(oscillator, loops, &lattices, progress)
}

/// The MPSs on lattices that are admissible or stable.
///
/// Solutions that are both have neighbours that are one of both beyond each of their borders: beyond grazing those are stable, beyond a saddle-node or
/// period-doubling bifurcation admissible. So a stretch of them is found from places outside of it as well.
fn admissible_or_stable<O: ImpactOscillator>(
    oscillator: &O,
    loops: &[u32],
    lattices: &[Lattice],
    progress: &dyn Progress,
) -> Vec<(u32, Unknowns)> {
    let found = lattices.par_iter().map(|lattice| {
        if progress.stopped() {
            Vec::new()
        } else {
            lattice.zeros(oscillator, loops, |solution| solution.admissible() || solution.stable())
        }
    });
    found.collect::<Vec<_>>().concat()
}

/// The MPSs of an oscillator that are `wanted`, as far as a lattice of impacts tells them apart.
pub(crate) fn at<O: ImpactOscillator>(
    oscillator: &O,
    loops: &[u32],
    fastest: f64,
    wanted: impl Fn(&MaximalPeriodicSolution) -> bool,
) -> Vec<(u32, Unknowns)> {
    let [primary, secondary] = oscillator.parameters();
    let start = Unknowns::new(0.0, 0.0, primary, secondary);
    Lattice { start, side: unknown::VELOCITY, length: fastest }.zeros(oscillator, loops, wanted)
}

/// A lattice of impacts of all phases, and of velocities at one μ or at values of μ with one velocity.
struct Lattice {
    /// Its first corner.
    start: Unknowns,
    /// The unknown that varies besides the phase, y or μ,
    side: usize,
    /// and how far.
    length: f64,
}

impl Lattice {
    /// Those of a slice, at values of μ that are shares of the window and at one small impact velocity.
    fn of_slice(
        window: Window,
        secondary: f64,
        shares: impl Iterator<Item = f64>,
        fastest: f64,
    ) -> impl Iterator<Item = Self> {
        let standing = move |share: f64| {
            let primary = window.parameters([share, 0.0])[0];
            let start = Unknowns::new(0.0, 0.0, primary, secondary);
            Self { start, side: unknown::VELOCITY, length: fastest }
        };
        let [left, right] = window.primary;
        let start = Unknowns::new(SLOW * fastest, 0.0, left, secondary);
        shares.map(standing).chain([Self { start, side: unknown::PRIMARY, length: right - left }])
    }

    /// The MPSs that are `wanted`, as far as the lattice tells them apart.
    ///
    /// By how much motion that begins with an impact misses it p forcing periods later, the wall ignored meanwhile, is (x, ẋ − y). Where both
    /// change sign between the impacts at a cell's corners there may be a zero inside.
    fn zeros<O: ImpactOscillator>(
        &self,
        oscillator: &O,
        loops: &[u32],
        wanted: impl Fn(&MaximalPeriodicSolution) -> bool,
    ) -> Vec<(u32, Unknowns)> {
        let Self { start, side, length } = *self;
        let held = match side {
            unknown::VELOCITY => Condition::Primary(start[unknown::PRIMARY]),
            _ => Condition::ImpactVelocity(start[unknown::VELOCITY]),
        };
        let here = [held, Condition::Secondary(start[unknown::SECONDARY])];
        let sides = [side, unknown::PHASE];
        let mut cell = Unknowns::zeros();
        cell[side] = length / CELLS[0] as f64;
        cell[unknown::PHASE] = TAU / CELLS[1] as f64;
        let corner = |i: usize, k: usize| {
            let mut corner = start;
            corner[side] += cell[side] * i as f64;
            corner[unknown::PHASE] = cell[unknown::PHASE] * k as f64;
            corner
        };
        // Only their signs are asked for.
        let rough = oscillator.roughly();
        let misses: Vec<Vec<Vec<Vector2<f64>>>> = (0..=CELLS[0])
            .map(|i| (0..=CELLS[1]).map(|k| misses(&rough, loops, &corner(i, k))).collect())
            .collect();
        let mut found: Vec<(u32, Unknowns)> = Vec::new();
        for (index, &loops) in loops.iter().enumerate() {
            let equations = LoopEquations::new(oscillator.clone(), loops, Formulation::FixedPhase);
            for (i, k) in (0..CELLS[0]).flat_map(|i| (0..CELLS[1]).map(move |k| (i, k))) {
                let corners =
                    [(i, k), (i, k + 1), (i + 1, k), (i + 1, k + 1)].map(|(i, k)| misses[i][k][index]);
                let changes = |component: usize| {
                    let positive = corners.iter().filter(|miss| miss[component] > 0.0).count();
                    0 < positive && positive < corners.len()
                };
                let first = corner(i, k);
                let inside = |zero: &Unknowns| {
                    sides.iter().all(|&side| (0.0..=1.0).contains(&((zero[side] - first[side]) / cell[side])))
                };
                let known = || found.iter().any(|(other, zero)| *other == loops && inside(zero));
                if !(changes(0) && changes(1)) || known() {
                    continue;
                }
                let reach = REACH * cell.norm();
                let middle = first + cell * 0.5;
                let zero = locate_within(reach, &equations, here, middle, &mut EventTimes::default());
                let new = zero.ok().filter(|zero| {
                    !found.iter().any(|(other, at)| *other == loops && same(at, zero))
                        && wanted(&equations.solution(zero))
                });
                found.extend(new.map(|zero| (loops, zero)));
            }
        }
        found
    }
}

/// Whether two MPSs are one.
fn same(a: &Unknowns, b: &Unknowns) -> bool {
    let mut gap = a - b;
    gap[unknown::PHASE] = libm::remainder(gap[unknown::PHASE], TAU);
    gap.norm() < SAME
}

/// By how much motion that begins with an impact misses it some numbers of forcing periods later.
fn misses<O: ImpactOscillator>(oscillator: &O, loops: &[u32], impact: &Unknowns) -> Vec<Vector2<f64>> {
    let [velocity, phase, primary, secondary] = (*impact).into();
    let oscillator = oscillator.with_parameters([primary, secondary]);
    let recoil = oscillator.reset::<1>(OnWall::new(velocity, phase)).value;
    let lag = (recoil[1] - phase) / oscillator.forcing_frequency().value;
    let motion = oscillator.motion(State::on_wall(recoil[0], recoil[1]));
    let after = |loops: &u32| {
        let end = motion.at(f64::from(*loops) * oscillator.forcing_period() - lag);
        Vector2::new(end.position, end.velocity - velocity)
    };
    loops.iter().map(after).collect()
}

#[cfg(test)]
mod tests {
    use grazing_model::LinearOscillator;

    use super::*;
    use crate::progress::Silent;
    use crate::simulation::{Seen, Suspect};

    #[test]
    fn simulation_comes_back_to_the_admissible_ones_of_the_solutions_that_are_found() {
        let oscillator = LinearOscillator::new(0.05, 0.9, 0.5, 0.9).expect("it is in the domain");
        let window = Window { primary: [0.3, 1.2], secondary: [0.6, 1.0] };
        let slices = [0.65, 0.75, 0.85, 0.95];
        let found = on_slices(&oscillator, &[1, 2], window, &slices, 2.0, &Silent);
        for (loops, zero) in &found {
            let here = oscillator.with_parameters([zero[2], zero[3]]);
            let suspect = Suspect { oscillator: &here, loops: *loops, velocity: zero[0], phase: zero[1] };
            let solution = LoopEquations::new(here, *loops, Formulation::FixedPhase).solution(zero);
            assert!(solution.admissible() || solution.stable(), "{loops}: {zero}");
            assert_eq!(suspect.follow() == Seen::Returns, solution.admissible(), "{loops}: {zero}");
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
}
