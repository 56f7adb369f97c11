//! The behaviour of an oscillator at one pair of parameters: its periodic solutions, and its
//! attractors.

mod basins;
mod from_state;
mod outcome;
mod rows;

use grazing_continuation::mps::{LoopEquations, Multipliers, Unknowns, unknown};
use grazing_model::orbit::Flight;
use grazing_model::phase::turned;
use grazing_model::rest::Rest;
use grazing_model::{AnyOscillator, ImpactOscillator, OnWall, State};
use nalgebra::Vector2;
use rand_pcg::Pcg64;

use self::basins::basins;
pub use self::from_state::simulated;
use self::outcome::{KnownOutcomes, OrbitOutcome, each, long_orbit};
pub use self::rows::at_place;
use crate::Scope;
use crate::long_time::{
    Exponent, Fate, Horizon, LongOrbit, MotionKind, Patience, Strike, random_start, same_impact, sampled,
    sampled_flight, sampled_rest, sampled_solution, time_of_phase,
};
use crate::progress::Progress;
use crate::search;
pub use crate::settled::ImpactPattern;
use crate::settled::{Recurring, Through, equations, kind, solution};
use crate::slices::passing;
use crate::tolerances::BETWEEN_ORBITS;

/// A periodic solution, stable or not.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Number of loops p, or of forcing periods with several impacts; 0 for the non-impacting solution.
    pub loops: u32,
    /// Velocities and phases (y, z) of the impacts in the order of time, the slowest first; phases are not
    /// reduced.
    pub impacts: Vec<[f64; 2]>,
    /// The stops of these impacts: 0 for that at x = 0, 1 for the other, if there are two.
    pub stops: Vec<usize>,
    /// The multipliers of the solution.
    pub multipliers: Multipliers,
    /// Whether no part of the solution except its impact lies beyond the wall.
    pub admissible: bool,
    /// The flights, (t, x, y) along each; the phase is zero at t = 0.
    pub orbit: Vec<Vec<[f64; 3]>>,
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
    /// The stops of these impacts: 0 for that at x = 0, 1 for the other, if there are two.
    pub stops: Vec<usize>,
    /// A state on the attractor, from which it can be followed to a nearby place.
    pub state: State,
}

/// The solutions and attractors found at a nearby place.
#[derive(Clone, Debug)]
pub struct Nearby {
    /// The kinds of solutions, with velocities and phases of their impacts.
    pub solutions: Vec<(ImpactPattern, Vec<[f64; 2]>)>,
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
    /// The number of phases and the number of positions of the lattice.
    pub lattice: [u32; 2],
}

/// The names of the stages.
const RANDOM: &str = "attractors of random states";
const SOLUTIONS: &str = "periodic solutions at a place";
const MOTION: &str = "motion on the attractors";

/// Impact velocity below which MPSs are not distinguished from grazing.
const SLOWEST: f64 = BETWEEN_ORBITS * search::USUAL_VELOCITY;

/// The kind of motion without impacts.
const FREE: ImpactPattern = (0, Vec::new());

/// The most impacts of a solution whose branch is followed.
const MOST_IMPACTS: usize = 8;

/// The horizon for motion from a nearby attractor, which needs little time.
const FOLLOWED: Horizon = Horizon::drifting(100, 32);

impl Solution {
    fn of(equations: &LoopEquations, point: &Unknowns) -> Self {
        let slowest = if equations.has_impacts() { point.lowest_velocity().0 } else { 0 };
        let stops: Vec<usize> = (0..point.impacts()).map(|index| equations.stop(index + slowest)).collect();
        let equations = &if equations.stops().is_empty() {
            equations.clone()
        } else {
            equations.at_stops(stops.iter().copied())
        };
        let point = &match equations.has_impacts() {
            true => point.beginning_with(slowest, equations.loops()),
            false => point.clone(),
        };
        let solution = equations.solution(point);
        let period = equations.oscillator_at(point).forcing_period();
        let begin = time_of_phase(equations.departure(point).phase, period);
        Self {
            loops: equations.loops(),
            impacts: (0..solution.impacts()).map(|index| impact_of(point, index).into()).collect(),
            stops,
            multipliers: solution.multipliers,
            admissible: solution.admissible(),
            orbit: sampled_solution(equations, point, begin),
        }
    }
}

/// An attractor in numbers alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AttractorSummary {
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
pub fn seen(oscillator: &AnyOscillator, states: &[State], horizon: Horizon) -> Vec<AttractorSummary> {
    let mut found: Vec<(OrbitOutcome, AttractorSummary)> = Vec::new();
    let shortly = Horizon { patience: Patience::Drifting, ..horizon };
    for &start in states {
        let mut orbit = LongOrbit::follow(oscillator, start, shortly);
        for horizon in [None, Some(horizon)] {
            if let Some(horizon) = horizon.filter(|_| orbit.fate.kind == MotionKind::Unsettled) {
                orbit = LongOrbit::follow(oscillator, start, horizon);
            }
            let outcome = OrbitOutcome::at_end(oscillator, start, &orbit);
            if let Some((_, known)) = found.iter_mut().find(|(known, _)| known.is_like(&outcome)) {
                known.states += 1;
                break;
            }
            if horizon.is_some() {
                let orbit = orbit.judged(oscillator);
                let exponent = orbit.exponent(oscillator);
                found.push((outcome, AttractorSummary { states: 1, fate: orbit.fate, exponent }));
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
                let over_a_period = |rest| Rest { phase: 0.0, duration: period, ..rest };
                vec![
                    orbit
                        .at_rest
                        .map_or(Vec::new(), |rest| sampled_rest(oscillator, &over_a_period(rest), |t| t)),
                ]
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
                shown
                    .iter()
                    .map(|flight| sampled_flight(oscillator, flight, flight.start - began, period))
                    .collect()
            }
        };
        let free = orbit.at_phase_zero(oscillator);
        Self {
            states,
            fate: orbit.fate,
            exponent: orbit.exponent(oscillator),
            flights,
            strikes: orbit
                .impacts
                .iter()
                .map(|&Strike { impact, .. }| [turned(impact[1]), impact[0]])
                .collect(),
            stops: orbit.impacts.iter().map(|strike| strike.stop).collect(),
            state: free.or(orbit.flights.last().map(|flight| flight.from)).unwrap_or(start),
        }
    }
}

impl Place {
    /// The place at the oscillator's own parameters; `None` if the computation was cancelled.
    ///
    /// Solutions with several impacts are those on which some state settles, and all others on the same
    /// branches in the range of the primary parameter.
    pub fn compute(
        oscillator: &AnyOscillator,
        scope: &Scope,
        starts: &Starts,
        progress: &dyn Progress,
    ) -> Option<Self> {
        let start = |state| {
            let mut random = Pcg64::new(u128::from(starts.seed), u128::from(state));
            (1, random_start(oscillator, starts.lowest, &mut random))
        };
        let states: Vec<(u32, State)> = (0..starts.states).map(start).collect();
        let lattice: Vec<State> = starts.on_lattice().collect();
        let found = |settled: &[Recurring]| {
            let at = |seen: &AnyOscillator, stops: Vec<usize>| {
                let found = search::at(seen, &scope.loops, SLOWEST, progress).into_iter();
                found.map(move |(loops, point)| ((loops, stops.clone()), point)).collect::<Vec<_>>()
            };
            let mut found = at(oscillator, Vec::new());
            found.extend(oscillator.other_stop().into_iter().flat_map(|other| at(&other, vec![1])));
            found.extend(on_branches(oscillator, scope, settled));
            found
        };
        let found = Self::of(oscillator, (&states, &lattice), starts.horizon, progress, found)?;
        Some(Self { lattice: starts.lattice, ..found })
    }

    /// The continuation of the solutions and attractors of a nearby place, which takes little time;
    /// new ones are not found.
    pub fn followed(oscillator: &AnyOscillator, nearby: &Nearby, progress: &dyn Progress) -> Option<Self> {
        let found = |_: &[Recurring]| {
            let mut found: Vec<Recurring> = Vec::new();
            for (kind, impacts) in &nearby.solutions {
                let impacts: Vec<OnWall> = impacts.iter().map(|&[y, z]| OnWall::new(y, z)).collect();
                let near = Unknowns::of_impacts(&impacts, oscillator.parameters());
                let here = solved(oscillator, kind, &near);
                let new =
                    here.filter(|here| here.lowest_velocity().1 > SLOWEST && !is_known(&found, kind, here));
                found.extend(new.map(|here| (kind.clone(), here)));
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
        found: impl FnOnce(&[Recurring]) -> Vec<Recurring>,
    ) -> Option<Self> {
        let period = oscillator.forcing_period();
        let follow = |&(states, from): &(u32, State)| (states, OrbitOutcome::of(oscillator, from, horizon));
        let outcomes = each(RANDOM, starts, progress, follow)?;
        let mut known = KnownOutcomes { different: Vec::new() };
        for (states, outcome) in outcomes {
            known.add(states, outcome);
        }
        let lattice = basins(oscillator, lattice, horizon, &mut known, progress)?;
        progress.begin(SOLUTIONS, 1);
        let outcomes = || known.different.iter().map(|(_, outcome)| outcome);
        let free = non_impacting(oscillator, outcomes());
        let settled: Vec<Recurring> = outcomes().filter_map(|one| one.near.clone()).collect();
        let mut found: Vec<Recurring> =
            free.into_iter().map(|point| (FREE, point)).chain(found(&settled)).collect();
        // A periodic attractor is a solution as well, even if no other search has found it.
        for (kind, near) in settled {
            if !is_known(&found, &kind, &near) {
                found.extend(solved(oscillator, &kind, &near).map(|point| (kind, point)));
            }
        }
        found.sort_by_key(|(kind, point)| (point.impacts(), kind.clone()));
        let solution = |(kind, point)| Solution::of(&equations(oscillator, &kind), &point);
        let solutions = found.into_iter().map(solution).collect();
        progress.step(SOLUTIONS);
        progress.end(SOLUTIONS);
        let mut order: Vec<usize> = (0..known.different.len()).collect();
        order.sort_by_key(|&index| core::cmp::Reverse(known.different[index].0));
        let shown: Vec<_> = order.iter().map(|&index| &known.different[index]).collect();
        let attractor = |(states, one): &&(u32, OrbitOutcome)| {
            // Motion from a random state is computed as before.
            Attractor::of(oscillator, *states, if *states > 0 { one.start } else { one.late }, horizon)
        };
        let attractors = each(MOTION, &shown, progress, attractor)?;
        let place = |index: usize| order.iter().position(|known| *known == index);
        let basins = lattice.into_iter().map(|(start, index)| (start, index.and_then(place))).collect();
        (!progress.stopped()).then_some(Self { solutions, attractors, period, basins, lattice: [0, 0] })
    }
}

/// The non-impacting solutions to which free motion, or rest, leads.
fn non_impacting<'a>(
    oscillator: &AnyOscillator,
    outcomes: impl Iterator<Item = &'a OrbitOutcome>,
) -> Vec<Unknowns> {
    let starts = outcomes.filter_map(|one| one.at_phase_zero).map(|state| [state.position, state.velocity]);
    let rest = [[0.0, 0.0], [-1.0, 0.0], [-0.5, 0.5], [-0.5, -0.5]];
    let mut found: Vec<Unknowns> = Vec::new();
    for [x, y] in starts.chain(rest) {
        let [primary, secondary] = oscillator.parameters();
        let Some(orbit) = solved(oscillator, &FREE, &Unknowns::new(x, y, primary, secondary)) else {
            continue;
        };
        if !found.iter().any(|known| (known - &orbit).norm() < BETWEEN_ORBITS) {
            found.push(orbit);
        }
    }
    found
}

/// The solutions at a place on the branches of solutions with several impacts through some of them.
fn on_branches(oscillator: &AnyOscillator, scope: &Scope, settled: &[Recurring]) -> Vec<Recurring> {
    let here @ [primary, secondary] = oscillator.parameters();
    let most = MOST_IMPACTS;
    let starts = settled.iter().filter(|(_, near)| (2..=most).contains(&near.impacts()));
    let starts = starts.filter_map(|(kind, near)| Some((kind.clone(), solved(oscillator, kind, near)?)));
    let starts: Vec<Recurring> = starts.collect();
    let through = Through { oscillator, window: scope.window, secondary, most };
    let mut found: Vec<Recurring> = Vec::new();
    for (equations, branch) in through.branches(&starts, &[]) {
        for place in passing(&branch, unknown::PRIMARY, primary) {
            let kind = kind(&equations);
            let new = solution(&equations, &place, here).filter(|point| {
                point.lowest_velocity().1 > SLOWEST
                    && !equations.recurs_sooner(point)
                    && !is_known(&found, &kind, point)
            });
            found.extend(new.map(|point| (kind.clone(), point)));
        }
    }
    found
}

/// Velocity and phase of the impact of a solution with an index.
fn impact_of(point: &Unknowns, index: usize) -> Vector2<f64> {
    let OnWall { velocity, phase } = point.impact(index);
    Vector2::new(velocity, phase)
}

/// Whether a solution is among these, whichever of its impacts is the first.
fn is_known(found: &[Recurring], kind: &ImpactPattern, one: &Unknowns) -> bool {
    let first = impact_of(one, 0);
    let (_, stops) = kind;
    let at_its_stop = |index: usize| stops.is_empty() || stops[index % stops.len()] == stops[0];
    let alike = found.iter().filter(|(other, point)| (other, point.impacts()) == (kind, one.impacts()));
    alike.into_iter().any(|(_, point)| {
        let same = |index| same_impact(BETWEEN_ORBITS, &impact_of(point, index), &first);
        (0..point.impacts()).any(|index| at_its_stop(index) && same(index))
    })
}

/// The solution near a point; for p = 0 the one whose position and velocity at phase zero are near.
fn solved(oscillator: &AnyOscillator, kind: &ImpactPattern, near: &Unknowns) -> Option<Unknowns> {
    solution(&equations(oscillator, kind), near, oscillator.parameters())
}
