//! The behaviour of an oscillator at one pair of parameters: its periodic solutions, and its
//! attractors.

mod basins;
mod outcome;

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Multipliers, Unknowns, unknown};
use grazing_model::orbit::Flight;
use grazing_model::phase::turned;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use nalgebra::Vector2;
use rand_pcg::Pcg64;

use self::basins::basins;
use self::outcome::{Known, Outcome, each, long_orbit};
use crate::long_time::{
    Exponent, Fate, Horizon, LongOrbit, MotionKind, Patience, random_start, same_impact, sampled,
    sampled_flight, sampled_solution, time_of_phase,
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
    /// The number of random initial states that approach it.
    pub states: u32,
    /// The long-term behaviour on the attractor.
    pub fate: Fate,
    /// The largest Lyapunov exponent.
    pub exponent: Exponent,
    /// The flights, (t, x, y) along each, with the rest at the wall before it; the phase is zero at
    /// t = 0. Motion that rests for good is one.
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
        let horizon = Horizon { transient: 400, counted: 64, patience: Patience::Unsettled, longest: 3_000 };
        Self { states: 24, seed: 1, horizon, lowest: -2.0, lattice: [0, 0] }
    }
}

/// The solutions and attractors at one pair of parameters.
#[derive(Clone, Debug)]
pub struct Place {
    /// Periodic solutions, by p.
    pub solutions: Vec<Solution>,
    /// The attractors, the most frequent first.
    pub attractors: Vec<Attractor>,
    /// The forcing period.
    pub period: f64,
    /// The states of the lattice, each with the index of its attractor; `None` if it has not settled in
    /// the time for which it was followed.
    pub basins: Vec<(State, Option<usize>)>,
}

/// The names of the stages.
const RANDOM: &str = "attractors of random states";
const SOLUTIONS: &str = "periodic solutions at a place";
const MOTION: &str = "motion on the attractors";

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
            None if orbit.fate.kind == MotionKind::Resting => {
                vec![[0.0, period].map(|time| [time, 0.0, 0.0]).to_vec()]
            }
            None => {
                let shown = orbit.shown();
                let begin = |first: &Flight<_>| match first.rest {
                    Some(rest) => (rest.start, rest.phase),
                    None => (first.start, first.from.phase),
                };
                let began = shown
                    .first()
                    .map(begin)
                    .map_or(0.0, |(start, phase)| start - time_of_phase(phase, period));
                shown.iter().map(|flight| sampled_flight(flight, flight.start - began, period)).collect()
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
        let states: Vec<(u32, State)> = (0..starts.states).map(start).collect();
        let lattice: Vec<State> = starts.on_lattice().collect();
        let found = || search::at(oscillator, loops, SLOWEST, progress);
        Self::of(oscillator, (&states, &lattice), starts.horizon, progress, found)
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
        Self::of(oscillator, (&nearby.attractors, &[]), FOLLOWED, progress, found)
    }

    /// The place with the attractors of some states, each with a weight, and these MPSs.
    fn of(
        oscillator: &AnyOscillator,
        (starts, lattice): (&[(u32, State)], &[State]),
        horizon: Horizon,
        progress: &dyn Progress,
        found: impl FnOnce() -> Vec<(u32, Unknowns)>,
    ) -> Option<Self> {
        let period = oscillator.forcing_period();
        let follow = |&(states, from): &(u32, State)| (states, Outcome::of(oscillator, from, horizon));
        let outcomes = each(RANDOM, starts, progress, follow)?;
        let mut known = Known { different: Vec::new() };
        for (states, outcome) in outcomes {
            known.add(states, outcome);
        }
        let lattice = basins(oscillator, lattice, horizon, &mut known, progress)?;
        progress.begin(SOLUTIONS, 1);
        let outcomes = || known.different.iter().map(|(_, outcome)| outcome);
        let free = non_impacting(oscillator, outcomes());
        let mut found: Vec<(u32, Unknowns)> =
            free.into_iter().map(|point| (0, point)).chain(found()).collect();
        // A periodic attractor is a solution as well, even if no other search has found it.
        for one in outcomes() {
            let near = one.fate.loops().filter(|loops| *loops > 0).zip(one.impacts.first());
            let Some((loops, impact)) = near else { continue };
            if !is_known(&found, loops, impact) {
                found.extend(solved(oscillator, loops, impact).map(|point| (loops, point)));
            }
        }
        found.sort_by_key(|(loops, _)| *loops);
        let solution = |(loops, point)| Solution::of(&equations(oscillator, loops), &point);
        let solutions = found.into_iter().map(solution).collect();
        progress.step(SOLUTIONS);
        progress.end(SOLUTIONS);
        let mut order: Vec<usize> = (0..known.different.len()).collect();
        order.sort_by_key(|&index| core::cmp::Reverse(known.different[index].0));
        let shown: Vec<_> = order.iter().map(|&index| &known.different[index]).collect();
        let attractor = |(states, one): &&(u32, Outcome)| {
            // Motion from a random state is computed as before.
            Attractor::of(oscillator, *states, if *states > 0 { one.start } else { one.late }, horizon)
        };
        let attractors = each(MOTION, &shown, progress, attractor)?;
        let place = |index: usize| order.iter().position(|known| *known == index);
        let basins = lattice.into_iter().map(|(start, index)| (start, index.and_then(place))).collect();
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
        if !found.iter().any(|known| (known - &orbit).norm() < BETWEEN_ORBITS) {
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
