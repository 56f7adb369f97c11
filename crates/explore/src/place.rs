//! Motion of the oscillator at one place of the plane.

use core::f64::consts::TAU;
use core::iter;

use grazing_continuation::mps::Multipliers;
use grazing_model::smooth::Stop;
use grazing_model::smooth::Units;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_results::Stability;
use grazing_unfold::described::Prepared;
use grazing_unfold::long_time::Horizon;
use grazing_unfold::place::{Attractor, Nearby, Place, Solution, Starts};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::answer::Problem;
use crate::model::Model;

/// The request for motion at a place.
#[derive(Deserialize)]
pub(crate) struct PlaceRequest {
    model: Model,
    at: [f64; 2],
    states: Option<u32>,
    /// The number of forcing periods for which motion that does not settle is followed.
    periods: Option<u32>,
    /// Whether orbits are also requested as curves: they are if it is missing.
    orbits: Option<bool>,
    /// Motion found at a place nearby: if it is there, only this is followed.
    nearby: Option<NearbyMotion>,
}

/// Solutions, as p with velocity and phase of their impacts, and attractors, as the number of states that
/// reach it and a state on it, in a form that only this program reads.
#[derive(Deserialize)]
struct NearbyMotion {
    solutions: Vec<(u32, Vec<[f64; 2]>)>,
    /// The walls that the impacts of each solution hit, from 0, if there are two.
    #[serde(default)]
    stops: Vec<Vec<usize>>,
    attractors: Vec<(u32, [f64; 3])>,
}

impl NearbyMotion {
    fn nearby(&self, here: &AnyOscillator, loops: &[u32], units: &Units) -> Option<Nearby> {
        let few = self.solutions.len().max(self.attractors.len()) <= MOST_STATES as usize;
        let counted = self.attractors.iter().all(|(states, _)| (1..=MOST_STATES).contains(states));
        let none = Vec::new();
        let stops = self.stops.iter().chain(iter::repeat(&none));
        let solutions =
            self.solutions.iter().zip(stops).filter(|((p, impacts), stops)| {
                is_sought(loops, *p, impacts) && are_stops(here, impacts, stops)
            });
        let attractors = self.attractors.iter();
        let near = |value: f64| value.abs() <= FARTHEST;
        let struck =
            |impacts: &[[f64; 2]]| impacts.iter().all(|[velocity, _]| near(velocity / units.velocity()));
        let moderate = self.solutions.iter().all(|(_, impacts)| struck(impacts))
            && self.attractors.iter().all(|(_, [position, velocity, _])| near(*position) && near(*velocity));
        let without_dimensions = |impacts: &[[f64; 2]]| {
            impacts.iter().map(|[velocity, phase]| [velocity / units.velocity(), *phase]).collect()
        };
        (few && counted && moderate).then(|| Nearby {
            solutions: solutions
                .map(|((p, impacts), stops)| ((*p, stops.clone()), without_dimensions(impacts)))
                .collect(),
            attractors: attractors
                .map(|&(states, [position, velocity, phase])| {
                    // No motion begins beyond the wall.
                    (states, State { position: position.min(0.0), velocity, phase })
                })
                .collect(),
        })
    }
}

/// Whether solutions with such impacts in so many forcing periods are sought: MPSs of the numbers of loops, and
/// all with several impacts, but not very many.
pub(crate) fn is_sought(loops: &[u32], p: u32, impacts: &[[f64; 2]]) -> bool {
    match impacts.len() {
        1 => loops.contains(&p),
        several => (2..=MOST_IMPACTS).contains(&several) && (1..=MOST_LOOPS).contains(&p),
    }
}

/// Whether stops are those of impacts: one for each between two walls, and otherwise none.
pub(crate) fn are_stops(here: &AnyOscillator, impacts: &[[f64; 2]], stops: &[usize]) -> bool {
    let each = stops.len() == impacts.len() && stops.iter().all(|stop| *stop < 2);
    stops.is_empty() || each && here.other_stop().is_some()
}

/// The most impacts and forcing periods of a solution: motion with more is not recognised as periodic.
const MOST_IMPACTS: usize = 256;
const MOST_LOOPS: u32 = 256;
/// The most initial states: more take longer than anybody waits.
const MOST_STATES: u32 = 200;
/// The most forcing periods: more take longer than anybody waits.
const MOST_PERIODS: u32 = 1_000_000;
/// The greatest distance from rest at the wall, and the greatest velocity, of motion that was
/// found: motion is of order one in the oscillator's units.
pub(crate) const FARTHEST: f64 = 1e6;

impl PlaceRequest {
    /// Whether motion found nearby is followed, which takes a moment.
    pub(crate) fn is_followed(&self) -> bool {
        self.nearby.is_some()
    }
}

/// The oscillator at a place, which is checked.
///
/// # Errors
/// There is no motion there.
pub(crate) fn check(of: &Prepared, at: [f64; 2]) -> Result<AnyOscillator, Problem> {
    if !at.iter().all(|value| value.is_finite()) {
        return Err(Problem::wrong("the place must be two numbers"));
    }
    let here = of.oscillator.with_parameters(of.without_dimensions(at));
    let frequency = here.forcing_frequency().value / of.axes.units.time;
    if !(frequency > 0.0 && frequency.is_finite()) {
        return Err(Problem::wrong(format!(
            "the forcing frequency is {frequency} at this place: it must be positive"
        )));
    }
    Ok(here)
}

pub(crate) fn compute(request: &PlaceRequest, stop: &Stop) -> Result<Value, Problem> {
    let of = request.model.prepared(None, stop)?;
    let here = check(&of, request.at)?;
    let units = of.axes.units;
    let found = match &request.nearby {
        None => {
            let usual = Starts::default();
            let states = request.states.unwrap_or(usual.states).clamp(1, MOST_STATES);
            let longest = request.periods.unwrap_or(usual.horizon.longest).min(MOST_PERIODS);
            let horizon = Horizon { longest, ..usual.horizon };
            Place::compute(&here, &of.scope, &Starts { states, horizon, ..usual }, stop)
        }
        Some(motion) => {
            let nearby = motion.nearby(&here, &of.scope.loops, &units).ok_or_else(|| {
                Problem::wrong("there are too many nearby solutions, or they are too far away")
            })?;
            Place::followed(&here, &nearby, stop)
        }
    };
    let found = found.ok_or_else(Problem::ended)?;
    let states: u32 = found.attractors.iter().map(|attractor| attractor.states).sum();
    let flights = |flights: &[Vec<[f64; 3]>]| match request.orbits.unwrap_or(true) {
        true => flights.iter().map(|flight| in_units(flight, &units)).collect(),
        false => Vec::new(),
    };
    let reached = reached(&found);
    // With one wall nothing need be said of which is hit.
    let walls = usize::from(here.other_stop().is_some());
    let solution = |(solution, reached): (&Solution, &bool)| {
        let Solution { loops, impacts, stops, multipliers, admissible, orbit } = solution;
        let impacts = impacts.iter().map(|[velocity, phase]| [velocity * units.velocity(), *phase]);
        json!({
            "p": loops,
            "impacts": impacts.collect::<Vec<_>>(),
            "stops": stops[..walls * stops.len()],
            "multipliers": eigenvalues(multipliers),
            "stability": Stability::of(*multipliers).name(),
            "admissible": admissible,
            "reached": reached,
            "orbit": flights(orbit),
        })
    };
    let attractor = |attractor: &Attractor| {
        let Attractor { states: own_states, fate, exponent, flights: own, strikes, state, .. } = attractor;
        let strikes = strikes.iter().map(|[phase, velocity]| [*phase, velocity * units.velocity()]);
        json!({
            "share": f64::from(*own_states) / f64::from(states),
            "states": own_states,
            "state": [state.position, state.velocity, state.phase],
            "kind": fate.kind.name(),
            "loops": fate.loops(),
            "periods": fate.periods,
            "impacts": fate.impacts,
            "second": fate.second,
            "rests": fate.rests,
            "waited": fate.followed,
            "exponent": exponent.mean / units.time,
            "exponent_error": exponent.error / units.time,
            "orbit": flights(own),
            "strikes": strikes.collect::<Vec<_>>(),
        })
    };
    Ok(json!({
        "solutions": found.solutions.iter().zip(&reached).map(solution).collect::<Vec<_>>(),
        "attractors": found.attractors.iter().map(attractor).collect::<Vec<_>>(),
        "period": found.period * units.time,
        "beyond": other_wall(&here, &units),
        "states": states,
        "followed": request.nearby.is_some(),
    }))
}

/// Where the other of two walls is as the first sees it, at even steps of a forcing period; none with one wall.
fn other_wall(here: &AnyOscillator, units: &Units) -> Vec<f64> {
    let count = if here.other_stop().is_some() { PHASES } else { 0 };
    let at = |number: u32| -here.gap(TAU * f64::from(number) / f64::from(PHASES))[0].value * units.length;
    (0..count).map(at).collect()
}

/// The number of phases at which the other wall is told.
const PHASES: u32 = 64;

/// Of each solution, whether it is the nearest to an attractor with as many impacts and loops.
fn reached(found: &Place) -> Vec<bool> {
    let highest = |flights: &[Vec<[f64; 3]>]| {
        flights.iter().flatten().map(|[_, x, _]| *x).fold(f64::NEG_INFINITY, f64::max)
    };
    // What tells solutions with the same numbers apart.
    let of_solution = |solution: &Solution| match solution.impacts.first() {
        None => highest(&solution.orbit),
        Some([slowest, _]) => *slowest,
    };
    let mut reached = vec![false; found.solutions.len()];
    for attractor in &found.attractors {
        let Some((impacts, loops)) = attractor.fate.numbers() else { continue };
        let own = match impacts {
            0 => highest(&attractor.flights),
            _ => attractor.strikes.iter().map(|[_, velocity]| *velocity).fold(f64::INFINITY, f64::min),
        };
        let alike = (0..reached.len()).filter(|k| {
            let solution = &found.solutions[*k];
            let second = solution.stops.iter().filter(|stop| **stop == 1).count() as f64;
            let apart = (attractor.fate.second * f64::from(loops) - second).abs();
            // Of one wall it is not a number, as there is no second.
            (apart.is_nan() || apart < 0.5)
                && (solution.impacts.len(), solution.loops) == (impacts, loops)
                && solution.multipliers.stable()
                && solution.admissible
        });
        let far = |k: usize| (of_solution(&found.solutions[k]) - own).abs();
        if let Some(nearest) = alike.min_by(|a, b| far(*a).total_cmp(&far(*b))) {
            reached[nearest] = true;
        }
    }
    reached
}

/// A flight in the file's units, with positions measured from the wall.
fn in_units(flight: &[[f64; 3]], units: &Units) -> Vec<[f64; 3]> {
    flight.iter().map(|[t, x, v]| [t * units.time, x * units.length, v * units.velocity()]).collect()
}

/// The eigenvalues with these multipliers, real and imaginary parts.
pub(crate) fn eigenvalues(multipliers: &Multipliers) -> [[f64; 2]; 2] {
    let Multipliers { trace, determinant } = *multipliers;
    let (middle, square) = (0.5 * trace, 0.25 * trace * trace - determinant);
    let root = square.abs().sqrt();
    if square < 0.0 {
        return [[middle, root], [middle, -root]];
    }
    // This form has no cancellation.
    let first = middle + root.copysign(middle);
    [[first, 0.0], [if first == 0.0 { 0.0 } else { determinant / first }, 0.0]]
}
