//! The behaviour of an oscillator at one pair of parameters: its periodic solutions, and its
//! attractors.

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Multipliers, Unknowns, unknown};
use grazing_model::motion::Motion;
use grazing_model::orbit::Flight;
use grazing_model::phase::turned;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use nalgebra::Vector2;
use rand_pcg::Pcg64;
use rayon::prelude::*;

use crate::long_time::{
    Exponent, Fate, Horizon, LongOrbit, MotionKind, Patience, random_start, same_impact, sampled,
    sampled_solution, time_of_phase,
};
use crate::progress::Progress;
use crate::search;
use crate::tolerances::BETWEEN_ORBITS;

/// A periodic solution, stable or not.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Number of loops p; 0 for the non-impacting solution.
    pub loops: u32,
    /// Velocity and phase (y, z) of the impact; NaN without one.
    pub impact: [f64; 2],
    /// The multipliers of the solution.
    pub multipliers: Multipliers,
    /// Whether no part of the solution except its impact lies beyond the wall.
    pub admissible: bool,
    /// The orbit (t, x, y) along a period; the phase is zero at t = 0.
    pub orbit: Vec<[f64; 3]>,
}

/// An attractor of some of the initial states.
#[derive(Clone, Debug)]
pub struct Attractor {
    /// The number of initial states that approach it.
    pub states: u32,
    /// The long-term behaviour on the attractor.
    pub fate: Fate,
    /// The largest Lyapunov exponent.
    pub exponent: Exponent,
    /// The flights, (t, x, y) along each; the phase is zero at t = 0.
    pub flights: Vec<Vec<[f64; 3]>>,
    /// Phase, in [0, 2π), and velocity of the impacts.
    pub strikes: Vec<[f64; 2]>,
    /// A state on the attractor, from which it can be followed to a nearby place.
    pub state: State,
}

/// The solutions and attractors found at a nearby place.
#[derive(Clone, Debug)]
pub struct Nearby {
    /// The number of loops p of MPSs, with velocity and phase of their impacts.
    pub solutions: Vec<(u32, [f64; 2])>,
    /// States on attractors, and the number of initial states that approach each.
    pub attractors: Vec<(u32, State)>,
}

/// Random initial states, and the time for which motion from them is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Starts {
    /// The number of states.
    pub states: u32,
    /// The seed of the random states.
    pub seed: u64,
    /// The time for which motion is followed.
    pub horizon: Horizon,
    /// The least x of the states.
    pub lowest: f64,
    /// The number of phases and the number of positions of further states, on a lattice, whose
    /// attractors are reported individually.
    pub lattice: [u32; 2],
}

impl Starts {
    /// The states of the lattice, phase by phase, each in the middle of its cell.
    fn on_lattice(&self) -> impl Iterator<Item = State> + use<> {
        let &Self { lowest, lattice: [phases, positions], .. } = self;
        let middle = |k: u32, count: u32| (f64::from(k) + 0.5) / f64::from(count);
        let at = move |phase| {
            let position = move |k| {
                State::at_rest(lowest * middle(k, positions), core::f64::consts::TAU * middle(phase, phases))
            };
            (0..positions).map(position)
        };
        (0..phases).flat_map(at)
    }
}

impl Default for Starts {
    fn default() -> Self {
        let horizon = Horizon { transient: 400, counted: 64, patience: Patience::Unsettled, longest: 5_000 };
        Self { states: 24, seed: 1, horizon, lowest: -2.0, lattice: [0, 0] }
    }
}

/// The solutions and attractors at one pair of parameters.
#[derive(Clone, Debug)]
pub struct Place {
    /// Periodic solutions, by p.
    pub solutions: Vec<Solution>,
    /// The attractors of random initial states, the most frequent first.
    pub attractors: Vec<Attractor>,
    /// The forcing period.
    pub period: f64,
    /// The states of the lattice, each with the index of its attractor.
    pub basins: Vec<(State, usize)>,
}

/// The name of the stage.
const BASINS: &str = "basins of attraction";

/// Impact velocity below which MPSs are not distinguished from grazing.
const SLOWEST: f64 = BETWEEN_ORBITS * search::USUAL_VELOCITY;

/// The horizon for motion from a nearby attractor, which needs little time.
const FOLLOWED: Horizon = Horizon::drifting(100, 32);

impl Solution {
    fn of(equations: &LoopEquations, point: &Unknowns) -> Self {
        let solution = equations.solution(point);
        let period = equations.oscillator_at(point).forcing_period();
        let begin = time_of_phase(equations.departure(point).phase, period);
        Self {
            loops: equations.loops(),
            impact: if equations.has_impacts() { equations.impact(&solution) } else { [f64::NAN; 2] },
            multipliers: solution.multipliers,
            admissible: solution.admissible(),
            orbit: sampled_solution(equations, point, begin),
        }
    }
}

/// The orbit from a state; its exponent is judged if the horizon allows.
fn long_orbit(oscillator: &AnyOscillator, start: State, horizon: Horizon) -> LongOrbit {
    let orbit = LongOrbit::follow(oscillator, start, horizon);
    if horizon.patience == Patience::Unsettled { orbit.judged(oscillator) } else { orbit }
}

/// An attractor in numbers alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// The number of initial states that approach it.
    pub states: u32,
    /// The long-term behaviour on the attractor.
    pub fate: Fate,
    /// The largest Lyapunov exponent.
    pub exponent: Exponent,
}

/// The attractors of some states, in numbers alone: each attractor once, as far as they are
/// distinguished, in the order in which states approach them.
///
/// All states are first followed for a short time, and only those unlike any known attractor for
/// the whole horizon and until their exponent has converged: motion that has not settled in the
/// short time counts as known irregular motion, if there is any.
pub fn seen(oscillator: &AnyOscillator, states: &[State], horizon: Horizon) -> Vec<Seen> {
    let mut found: Vec<(Outcome, Seen)> = Vec::new();
    let shortly = Horizon { patience: Patience::Drifting, ..horizon };
    for &start in states {
        let mut orbit = LongOrbit::follow(oscillator, start, shortly);
        for horizon in [None, Some(horizon)] {
            if let Some(horizon) = horizon.filter(|_| orbit.fate.kind == MotionKind::Unsettled) {
                orbit = LongOrbit::follow(oscillator, start, horizon);
            }
            let outcome = Outcome::at_end(oscillator, start, &orbit);
            if let Some((_, known)) = found.iter_mut().find(|(known, _)| known.is_like(&outcome)) {
                known.states += 1;
                break;
            }
            if horizon.is_some() {
                let orbit = orbit.judged(oscillator);
                let exponent = orbit.exponent(oscillator);
                found.push((outcome, Seen { states: 1, fate: orbit.fate, exponent }));
                break;
            }
        }
    }
    found.into_iter().map(|(_, seen)| seen).collect()
}

/// The properties of an orbit from a state that are compared with those of others.
struct Outcome {
    start: State,
    fate: Fate,
    impacts: Vec<Vector2<f64>>,
    /// The state at phase zero of motion without impacts, and its highest point on a cycle.
    at_phase_zero: Option<State>,
    highest: f64,
}

impl Outcome {
    fn of(oscillator: &AnyOscillator, start: State, horizon: Horizon) -> Self {
        Self::at_end(oscillator, start, &long_orbit(oscillator, start, horizon))
    }

    fn at_end(oscillator: &AnyOscillator, start: State, orbit: &LongOrbit) -> Self {
        let at_phase_zero = orbit.at_phase_zero(oscillator);
        let highest = orbit.cycle.and_then(|cycle| {
            let motion = oscillator.motion(cycle.from);
            motion.highest_maximum(f64::from(cycle.periods) * oscillator.forcing_period())
        });
        let highest = highest.map_or(f64::NAN, |top| top.position);
        Self { start, fate: orbit.fate, impacts: orbit.impacts.clone(), at_phase_zero, highest }
    }

    /// Whether the outcome looks like another one.
    fn is_like(&self, other: &Self) -> bool {
        let (a, b) = (&self.fate, &other.fate);
        if (a.kind, a.periods) != (b.kind, b.periods) {
            return false;
        }
        match a.kind {
            MotionKind::Periodic => {
                let first = &other.impacts[0];
                self.impacts.iter().any(|impact| same_impact(BETWEEN_ORBITS, impact, first))
            }
            MotionKind::NonImpacting => (self.highest - other.highest).abs() < BETWEEN_ORBITS,
            _ => true,
        }
    }
}

impl Attractor {
    /// The attractor that `states` initial states approach, computed from one of them.
    fn of(oscillator: &AnyOscillator, states: u32, start: State, horizon: Horizon) -> Self {
        let orbit = long_orbit(oscillator, start, horizon);
        let period = oscillator.forcing_period();
        let flights = match orbit.free_cycle(oscillator) {
            Some((from, periods)) => {
                let begin = time_of_phase(from.phase, period);
                vec![sampled(&oscillator.motion(from), begin, periods * period, period)]
            }
            None => {
                let shown = orbit.shown();
                let began =
                    shown.first().map_or(0.0, |first| first.start - time_of_phase(first.from.phase, period));
                let curve = |flight: &Flight<_>| {
                    sampled(&flight.motion, flight.start - began, flight.duration, period)
                };
                shown.iter().map(curve).collect()
            }
        };
        let free = orbit.at_phase_zero(oscillator);
        Self {
            states,
            fate: orbit.fate,
            exponent: orbit.exponent(oscillator),
            flights,
            strikes: orbit.impacts.iter().map(|impact| [turned(impact[1]), impact[0]]).collect(),
            state: free.or(orbit.flights.last().map(|flight| flight.from)).unwrap_or(start),
        }
    }
}

impl Place {
    /// The place at the oscillator's own parameters; `None` if the computation was cancelled.
    pub fn compute(
        oscillator: &AnyOscillator,
        loops: &[u32],
        starts: &Starts,
        progress: &dyn Progress,
    ) -> Option<Self> {
        let start = |state| {
            let mut random = Pcg64::new(u128::from(starts.seed), u128::from(state));
            (1, random_start(starts.lowest, &mut random))
        };
        // States of the lattice have no weight: fractions are those of random states.
        let states = (0..starts.states).map(start).chain(starts.on_lattice().map(|state| (0, state)));
        let states: Vec<(u32, State)> = states.collect();
        let found = || search::at(oscillator, loops, SLOWEST, progress);
        Self::of(oscillator, &states, starts.horizon, progress, found)
    }

    /// The continuation of the solutions and attractors of a nearby place, which takes little time;
    /// new ones are not found.
    pub fn followed(oscillator: &AnyOscillator, nearby: &Nearby, progress: &dyn Progress) -> Option<Self> {
        let found = || {
            let mut found: Vec<(u32, Unknowns)> = Vec::new();
            for (loops, impact) in &nearby.solutions {
                let here = solved(oscillator, *loops, &Vector2::from(*impact));
                let new = here.filter(|here| {
                    here[unknown::VELOCITY] > SLOWEST && !is_known(&found, *loops, &impact_of(here))
                });
                found.extend(new.map(|here| (*loops, here)));
            }
            found
        };
        Self::of(oscillator, &nearby.attractors, FOLLOWED, progress, found)
    }

    /// The place with the attractors of some states, each with a weight, and these MPSs.
    fn of(
        oscillator: &AnyOscillator,
        starts: &[(u32, State)],
        horizon: Horizon,
        progress: &dyn Progress,
        found: impl FnOnce() -> Vec<(u32, Unknowns)>,
    ) -> Option<Self> {
        let period = oscillator.forcing_period();
        // Most states of the lattice soon approach attractors that others approach as well.
        let outcomes = starts.par_iter().map(|&(states, from)| {
            let horizon = if states == 0 { FOLLOWED } else { horizon };
            let outcome = (!progress.stopped()).then(|| (states, Outcome::of(oscillator, from, horizon)));
            progress.step(BASINS);
            outcome
        });
        let outcomes =
            progress.during(BASINS, starts.len() as u64, || outcomes.collect::<Option<Vec<_>>>())?;
        let (mut outcomes, mut lattice): (Vec<_>, Vec<_>) =
            outcomes.into_iter().partition(|(states, _)| *states > 0);
        let unlike = |one: &Outcome| !outcomes.iter().any(|(_, known)| known.is_like(one));
        lattice.par_iter_mut().filter(|(_, one)| unlike(one)).for_each(|(_, one)| {
            if !progress.stopped() {
                *one = Outcome::of(oscillator, one.start, horizon);
            }
        });
        outcomes.append(&mut lattice);
        let free = non_impacting(oscillator, outcomes.iter().map(|(_, outcome)| outcome));
        let mut found: Vec<(u32, Unknowns)> =
            free.into_iter().map(|point| (0, point)).chain(found()).collect();
        // A periodic attractor is a solution as well, even if no other search has found it.
        for (_, one) in &outcomes {
            let near = one.fate.loops().filter(|loops| *loops > 0).zip(one.impacts.first());
            let Some((loops, impact)) = near else { continue };
            if !is_known(&found, loops, impact) {
                found.extend(solved(oscillator, loops, impact).map(|point| (loops, point)));
            }
        }
        found.sort_by_key(|(loops, _)| *loops);
        let solution = |(loops, point)| Solution::of(&equations(oscillator, loops), &point);
        let solutions = found.into_iter().map(solution).collect();
        let mut different: Vec<(u32, &Outcome)> = Vec::new();
        for (states, one) in &outcomes {
            match different.iter_mut().find(|(_, known)| known.is_like(one)) {
                Some((known, _)) => *known += states,
                None => different.push((*states, one)),
            }
        }
        different.sort_by_key(|(states, _)| core::cmp::Reverse(*states));
        let shown = different.iter();
        let shown = shown.map(|(states, one)| Attractor::of(oscillator, *states, one.start, horizon));
        let attractors: Vec<Attractor> = shown.collect();
        let lattice = outcomes.iter().filter(|(states, _)| *states == 0);
        let basin = |(_, one): &(u32, Outcome)| {
            let index = different.iter().position(|(_, known)| known.is_like(one))?;
            Some((one.start, index))
        };
        let basins = lattice.filter_map(basin).collect();
        (!progress.stopped()).then_some(Self { solutions, attractors, period, basins })
    }
}

/// The non-impacting solutions to which free motion, or rest, leads.
fn non_impacting<'a>(
    oscillator: &AnyOscillator,
    outcomes: impl Iterator<Item = &'a Outcome>,
) -> Vec<Unknowns> {
    let starts = outcomes.filter_map(|one| one.at_phase_zero).map(|state| [state.position, state.velocity]);
    let rest = [[0.0, 0.0], [-1.0, 0.0], [-0.5, 0.5], [-0.5, -0.5]];
    let mut found: Vec<Unknowns> = Vec::new();
    for [x, y] in starts.chain(rest) {
        let Some(orbit) = solved(oscillator, 0, &Vector2::new(x, y)) else { continue };
        if !found.iter().any(|known| (known - orbit).norm() < BETWEEN_ORBITS) {
            found.push(orbit);
        }
    }
    found
}

/// The equations of solutions with p loops.
fn equations(oscillator: &AnyOscillator, loops: u32) -> LoopEquations {
    LoopEquations::new(oscillator.clone(), loops, Formulation::FixedPhase)
}

/// Velocity and phase of the impact of an MPS.
fn impact_of(point: &Unknowns) -> Vector2<f64> {
    Vector2::new(point[unknown::VELOCITY], point[unknown::PHASE])
}

/// Whether the MPS with an impact is among these.
fn is_known(found: &[(u32, Unknowns)], loops: u32, impact: &Vector2<f64>) -> bool {
    found
        .iter()
        .any(|(other, point)| *other == loops && same_impact(BETWEEN_ORBITS, &impact_of(point), impact))
}

/// The solution with an impact near another; for p = 0 the one whose position and velocity at phase
/// zero are near others.
fn solved(oscillator: &AnyOscillator, loops: u32, impact: &Vector2<f64>) -> Option<Unknowns> {
    let [primary, secondary] = oscillator.parameters();
    let equations = equations(oscillator, loops);
    let here = [Condition::Primary(primary), Condition::Secondary(secondary)];
    let near = Unknowns::new(impact[0], impact[1], primary, secondary);
    locate(&equations, here, near, &mut EventTimes::default()).ok()
}
