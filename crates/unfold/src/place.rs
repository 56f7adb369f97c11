//! What an oscillator does at one pair of parameters: its periodic solutions, and what motion comes to in the long run.

mod long_orbit;

use core::f64::consts::TAU;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{
    EventTimes, Formulation, LoopEquations, MaximalPeriodicSolution, Multipliers, Unknowns, unknown,
};
use grazing_model::{ImpactOscillator, State};
use nalgebra::Vector2;
use rand_pcg::Pcg64;
use rayon::prelude::*;

use long_orbit::{LongOrbit, Seen, begins};

use crate::Scope;
use crate::non_impacting::orbits::{OrbitPoint, PeriodicOrbits};
use crate::one_parameter::{random_start, sampled};
use crate::progress::Progress;
use crate::search;

/// A periodic solution, stable or not.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Number of loops p; 0 for the non-impacting solution.
    pub loops: u32,
    /// Velocity and phase (y, z) of its impact; not numbers without one.
    pub impact: [f64; 2],
    /// Its multipliers.
    pub multipliers: Multipliers,
    /// Nothing of it lies beyond the wall but its impact.
    pub admissible: bool,
    /// (t, x, y) along a period; the phase is zero at t = 0.
    pub orbit: Vec<[f64; 3]>,
}

/// What motion comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionKind {
    /// Motion that does not reach the wall.
    NonImpacting,
    /// Motion with impacts that comes again.
    Periodic,
    /// Motion with impacts that does not, as far as it was followed.
    Aperiodic,
    /// It comes to rest at the wall for a while, or for good.
    Resting,
    /// It cannot be followed.
    Escaping,
}

impl MotionKind {
    /// In a word.
    pub const fn name(self) -> &'static str {
        match self {
            Self::NonImpacting => "non-impacting",
            Self::Periodic => "periodic",
            Self::Aperiodic => "aperiodic",
            Self::Resting => "resting",
            Self::Escaping => "escaping",
        }
    }
}

/// What an orbit comes to, in numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fate {
    /// What it is.
    pub kind: MotionKind,
    /// The forcing periods after which it comes again, if it does.
    pub periods: Option<u32>,
    /// Impacts in a forcing period, on average.
    pub impacts: f64,
}

impl Fate {
    /// The number of loops p of a solution with one impact in p forcing periods; 0 without impacts.
    pub fn loops(&self) -> Option<u32> {
        match self.kind {
            MotionKind::NonImpacting if self.periods == Some(1) => Some(0),
            // A whole number of impacts, counted over a whole number of periods.
            MotionKind::Periodic => {
                self.periods.filter(|periods| (self.impacts * f64::from(*periods) - 1.0).abs() < 0.5)
            }
            _ => None,
        }
    }
}

/// What some of the initial states come to.
#[derive(Clone, Debug)]
pub struct Attractor {
    /// How many of them.
    pub states: u32,
    /// What it is.
    pub fate: Fate,
    /// The largest Lyapunov exponent, of the dimension of a reciprocal time; not a number where motion rests or cannot be followed.
    pub lyapunov: f64,
    /// Its flights, (t, x, y) along each; the phase is zero at t = 0.
    pub flights: Vec<Vec<[f64; 3]>>,
    /// Phase, in [0, 2π), and velocity of its impacts.
    pub strikes: Vec<[f64; 2]>,
    /// A state of it, from which it can be followed to a place nearby.
    pub state: State,
}

/// What was found at a place nearby.
#[derive(Clone, Debug)]
pub struct Nearby {
    /// The number of loops p of MPSs, with velocity and phase of their impacts.
    pub solutions: Vec<(u32, [f64; 2])>,
    /// States of attractors, and how many initial states have come to each.
    pub attractors: Vec<(u32, State)>,
}

/// How motion is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Random initial states.
    pub states: u32,
    /// Their seed.
    pub seed: u64,
    /// The forcing periods before motion counts, and those in which it does.
    pub periods: [u32; 2],
    /// Initial states lie between the wall and this x.
    pub lowest: f64,
}

impl Default for Plan {
    fn default() -> Self {
        Self { states: 24, seed: 1, periods: [400, 64], lowest: -2.0 }
    }
}

/// What there is at one pair of parameters.
#[derive(Clone, Debug)]
pub struct Place {
    /// Periodic solutions, by p.
    pub solutions: Vec<Solution>,
    /// What random initial states come to, the most frequent first.
    pub attractors: Vec<Attractor>,
    /// The forcing period.
    pub period: f64,
}

/// MPSs are looked for up to this impact velocity: motion is of the order of one.
const FASTEST: f64 = 2.5;
/// Impacts closer than this are one: orbits have settled to far less.
const SAME: f64 = 1e-3;

/// The forcing periods before motion counts that was followed from an attractor nearby, and those in which it does: it has not far to go.
const FOLLOWED: [u32; 2] = [100, 32];

impl Place {
    /// What there is at the oscillator's own parameters; none if an end was asked for.
    pub fn compute<O: ImpactOscillator>(
        oscillator: &O,
        loops: &[u32],
        plan: &Plan,
        progress: &dyn Progress,
    ) -> Option<Self> {
        let start = |state| {
            let mut random = Pcg64::new(u128::from(plan.seed), u128::from(state));
            (1, random_start(plan.lowest, &mut random))
        };
        let starts: Vec<(u32, State)> = (0..plan.states).map(start).collect();
        let found = || search::at(oscillator, loops, [SAME * FASTEST, FASTEST]);
        Self::of(oscillator, &starts, plan.periods, progress, found)
    }

    /// What has become of that which was found nearby, which takes a small part of the time: what is new here is not seen.
    pub fn followed<O: ImpactOscillator>(
        oscillator: &O,
        nearby: &Nearby,
        progress: &dyn Progress,
    ) -> Option<Self> {
        let found = || {
            let mut found: Vec<(u32, Unknowns)> = Vec::new();
            for (loops, impact) in &nearby.solutions {
                let here = solved(oscillator, *loops, &Vector2::from(*impact));
                let new = here.filter(|here| {
                    here[unknown::VELOCITY] > SAME * FASTEST && !is_known(&found, *loops, &impact_of(here))
                });
                found.extend(new.map(|here| (*loops, here)));
            }
            found
        };
        Self::of(oscillator, &nearby.attractors, FOLLOWED, progress, found)
    }

    /// What motion comes to from some states, each of which stands for so many, and these MPSs.
    fn of<O: ImpactOscillator>(
        oscillator: &O,
        starts: &[(u32, State)],
        periods: [u32; 2],
        progress: &dyn Progress,
        found: impl FnOnce() -> Vec<(u32, Unknowns)>,
    ) -> Option<Self> {
        let period = oscillator.forcing_period();
        let seen = starts.par_iter().map(|&(states, from)| {
            let seen = || LongOrbit::new(oscillator, from, periods).seen(oscillator, from);
            (!progress.stopped()).then(|| (states, seen()))
        });
        let seen: Vec<(u32, Seen)> = seen.collect::<Option<_>>()?;
        let mut solutions = non_impacting(oscillator, seen.iter().map(|(_, seen)| seen));
        let mut found = found();
        // What motion comes to is a solution, too, even if nothing else led to it.
        for (_, one) in &seen {
            let near = one.fate.loops().filter(|loops| *loops > 0).zip(one.impacts.first());
            let Some((loops, impact)) = near else { continue };
            if !is_known(&found, loops, impact) {
                found.extend(solved(oscillator, loops, impact).map(|point| (loops, point)));
            }
        }
        found.sort_by_key(|(loops, _)| *loops);
        solutions.extend(found.into_iter().map(|(loops, point)| {
            let equations = LoopEquations::new(oscillator.clone(), loops, Formulation::FixedPhase);
            let solution = equations.solution(&point);
            let recoil = equations.recoil(&point);
            let lag = (recoil.phase - point[unknown::PHASE]) / oscillator.forcing_frequency().value;
            let flight = f64::from(loops) * period - lag;
            Solution {
                loops,
                impact: [point[unknown::VELOCITY], point[unknown::PHASE]],
                multipliers: solution.multipliers,
                admissible: solution.admissible(),
                orbit: sampled(&oscillator.motion(recoil), begins(recoil.phase, period), flight, period),
            }
        }));
        let mut different: Vec<(u32, &Seen)> = Vec::new();
        for (states, one) in &seen {
            match different.iter_mut().find(|(_, known)| known.is_like(one)) {
                Some((known, _)) => *known += states,
                None => different.push((*states, one)),
            }
        }
        let shown = different.into_iter().map(|(states, seen)| {
            let orbit = LongOrbit::new(oscillator, seen.start, periods);
            Attractor { states, ..orbit.attractor(oscillator, seen.start) }
        });
        let mut attractors: Vec<Attractor> = shown.collect();
        attractors.sort_by_key(|attractor| core::cmp::Reverse(attractor.states));
        (!progress.stopped()).then_some(Self { solutions, attractors, period })
    }
}

/// What motion from a state comes to, in numbers.
pub fn fate<O: ImpactOscillator>(oscillator: &O, from: State, periods: [u32; 2]) -> Fate {
    LongOrbit::new(oscillator, from, periods).fate
}

/// The non-impacting solutions to which free motion, or rest, leads.
fn non_impacting<'a, O: ImpactOscillator>(
    oscillator: &O,
    seen: impl Iterator<Item = &'a Seen>,
) -> Vec<Solution> {
    let [primary, secondary] = oscillator.parameters();
    let window = grazing_continuation::curve::Window {
        primary: [primary, primary + 1.0],
        secondary: [secondary, secondary + 1.0],
    };
    let scope = Scope { window, loops: Vec::new(), start: None };
    let orbits = PeriodicOrbits { oscillator, scope: &scope, control: StepControl::DRAWING };
    let starts = seen.filter_map(|one| one.at_phase_zero);
    let rest = [[0.0, 0.0], [-1.0, 0.0], [-0.5, 0.5], [-0.5, -0.5]];
    let mut found: Vec<(OrbitPoint, Solution)> = Vec::new();
    for [x, y] in starts.chain(rest) {
        let Some(orbit) = orbits.at(&OrbitPoint::new(x, y, 0.0, 0.0)) else { continue };
        if found.iter().any(|(known, _)| (known - orbit).norm() < SAME) {
            continue;
        }
        let seen = orbits.seen(&orbit);
        let from = State { position: orbit[0], velocity: orbit[1], phase: 0.0 };
        let period = oscillator.forcing_period();
        let solution = Solution {
            loops: 0,
            impact: [f64::NAN; 2],
            multipliers: seen.multipliers,
            admissible: seen.height.position <= MaximalPeriodicSolution::TOUCH,
            orbit: sampled(&oscillator.motion(from), 0.0, period, period),
        };
        found.push((orbit, solution));
    }
    found.into_iter().map(|(_, solution)| solution).collect()
}

/// Whether two impacts are one.
fn is_same(a: &Vector2<f64>, b: &Vector2<f64>) -> bool {
    (a[0] - b[0]).abs() < SAME && libm::remainder(a[1] - b[1], TAU).abs() < SAME
}

/// Velocity and phase of the impact of an MPS.
fn impact_of(point: &Unknowns) -> Vector2<f64> {
    Vector2::new(point[unknown::VELOCITY], point[unknown::PHASE])
}

/// Whether the MPS with an impact is among these.
fn is_known(found: &[(u32, Unknowns)], loops: u32, impact: &Vector2<f64>) -> bool {
    found.iter().any(|(other, point)| *other == loops && is_same(&impact_of(point), impact))
}

/// The MPS with an impact near another.
fn solved<O: ImpactOscillator>(oscillator: &O, loops: u32, impact: &Vector2<f64>) -> Option<Unknowns> {
    let [primary, secondary] = oscillator.parameters();
    let equations = LoopEquations::new(oscillator.clone(), loops, Formulation::FixedPhase);
    let here = [Condition::Primary(primary), Condition::Secondary(secondary)];
    let near = Unknowns::new(impact[0], impact[1], primary, secondary);
    locate(&equations, here, near, &mut EventTimes::default()).ok()
}
