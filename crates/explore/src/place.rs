//! Motion of the oscillator at one place of the plane.

use core::f64::consts::TAU;

use grazing_continuation::mps::Multipliers;
use grazing_model::smooth::Stop;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_results::place::{PlaceAttractor, PlaceSolution};
use grazing_results::{Dimensioned, dimensioned};
use grazing_unfold::described::Prepared;
use grazing_unfold::long_time::Horizon;
use grazing_unfold::place::{Attractor, Nearby, Place, Solution, Starts};
use serde::{Deserialize, Serialize};

use crate::answer::{Cells, Problem, answers, told};
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
    /// Motion found at a place nearby: if it is there, only this is followed, which takes a moment.
    pub(crate) nearby: Option<NearbyMotion>,
}

/// Motion that is known at a place.
#[derive(Deserialize)]
pub(crate) struct NearbyMotion {
    solutions: Vec<Known>,
    /// The number of states that reach each attractor, and a state on it, without dimensions.
    attractors: Vec<(u32, [f64; 3])>,
}

answers! {
    /// Motion at a place.
    MotionAtPlace {
        solutions: Vec<FoundSolution>,
        attractors: Vec<FoundAttractor>,
        /// The forcing period.
        period: f64,
        /// Where the other of two walls is as the first sees it, at even steps of a forcing period; nothing with one wall.
        beyond: Vec<Position>,
        /// The number of initial states, and whether those are of motion that was found nearby.
        states: u32, followed: bool,
    }

    /// A periodic solution; whether an attractor is this solution, and its flights, if they were requested.
    FoundSolution {
        #[serde(flatten)] row: Cells, known: Known, multipliers: Eigenvalues, reached: bool, orbit: Vec<Vec<Moment>>,
    }

    /// An attractor: a state on it, without dimensions, the number of forcing periods for which it was followed, its
    /// flights, and its impacts, with phases in [0, 2π).
    FoundAttractor {
        #[serde(flatten)] row: Cells, state: [f64; 3], waited: u32, orbit: Vec<Vec<Moment>>, strikes: Vec<Impact>,
    }

    /// A solution in a form that is read again: it can be followed from the place where it is known.
    #[derive(Clone, Deserialize)]
    Known {
        /// The number of forcing periods in which it recurs.
        p: u32,
        impacts: Vec<Impact>,
        /// The walls that its impacts hit, from 0, if there are two.
        #[serde(default)]
        stops: Vec<usize>,
    }
}

/// The velocity and the phase of an impact; the phase is not reduced.
#[derive(Clone, Copy, Deserialize, Serialize)]
pub(crate) struct Impact(pub(crate) [f64; 2]);

/// Time, position and velocity of motion; the phase is zero at time zero.
#[derive(Serialize)]
pub(crate) struct Moment([f64; 3]);

/// A position, measured from the wall.
#[derive(Serialize)]
pub(crate) struct Position(f64);

/// Multipliers as two eigenvalues, each with its real and its imaginary part.
pub(crate) type Eigenvalues = [[f64; 2]; 2];

dimensioned! {
    Known, |own| { own.impacts, }
    Impact, |own| { own.0[0] => "length/time", }
    Moment, |own| { own.0[0] => "time", own.0[1] => "length", own.0[2] => "length/time", }
    Position, |own| { own.0 => "length", }
}

impl NearbyMotion {
    /// What can be followed at a place; nothing if there is too much, or too fast.
    fn nearby(&self, here: &AnyOscillator, of: &Prepared) -> Option<Nearby> {
        let solutions = self.solutions.clone().without_dimensions(&of.axes.units);
        let few = solutions.len().max(self.attractors.len()) <= MOST_STATES as usize;
        let counted = self.attractors.iter().all(|(states, _)| (1..=MOST_STATES).contains(states));
        let near = |value: f64| value.abs() <= FARTHEST;
        let mut struck = solutions.iter().flat_map(|solution| &solution.impacts);
        let moderate = struck.all(|Impact([velocity, _])| near(*velocity))
            && self.attractors.iter().all(|(_, [position, velocity, _])| near(*position) && near(*velocity));
        let sought = solutions.into_iter().filter(|solution| solution.is_sought(here, &of.scope.loops));
        let attractors = self.attractors.iter().map(|&(states, [position, velocity, phase])| {
            // No motion begins beyond the wall.
            (states, State { position: position.min(0.0), velocity, phase })
        });
        (few && counted && moderate).then(|| Nearby {
            solutions: sought
                .map(|Known { p, impacts, stops }| {
                    ((p, stops), impacts.into_iter().map(|Impact(impact)| impact).collect())
                })
                .collect(),
            attractors: attractors.collect(),
        })
    }
}

impl Known {
    /// Whether such solutions are sought: MPSs of the numbers of loops, and all with several impacts, but not very
    /// many; between two walls with one for each impact.
    pub(crate) fn is_sought(&self, here: &AnyOscillator, loops: &[u32]) -> bool {
        let Self { p, impacts, stops } = self;
        let few = match impacts.len() {
            1 => loops.contains(p),
            several => (2..=MOST_IMPACTS).contains(&several) && (1..=MOST_LOOPS).contains(p),
        };
        let each = stops.len() == impacts.len() && stops.iter().all(|stop| *stop < 2);
        few && (stops.is_empty() || each && here.other_stop().is_some())
    }
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

pub(crate) fn compute(request: &PlaceRequest, stop: &Stop) -> Result<MotionAtPlace, Problem> {
    let of = request.model.prepared(None, stop)?;
    let here = check(&of, request.at)?;
    let units = &of.axes.units;
    let found = match &request.nearby {
        None => {
            let usual = Starts::default();
            let states = request.states.unwrap_or(usual.states).clamp(1, MOST_STATES);
            let longest = request.periods.unwrap_or(usual.horizon.longest).min(MOST_PERIODS);
            let horizon = Horizon { longest, ..usual.horizon };
            Place::compute(&here, &of.scope, &Starts { states, horizon, ..usual }, stop)
        }
        Some(motion) => {
            let nearby = motion.nearby(&here, &of).ok_or_else(|| {
                Problem::wrong("there are too many nearby solutions, or they are too far away")
            })?;
            Place::followed(&here, &nearby, stop)
        }
    };
    let found = found.ok_or_else(Problem::ended)?;
    let rows = found.rows(1, here.parameters()).with_dimensions(units);
    let reached = reached(&found);
    let orbit = |flights: Vec<Vec<[f64; 3]>>| -> Vec<Vec<Moment>> {
        let flights = flights.into_iter().filter(|_| request.orbits.unwrap_or(true));
        let moments = |flight: Vec<[f64; 3]>| flight.into_iter().map(Moment).collect();
        flights.map(moments).collect::<Vec<_>>().with_dimensions(units)
    };
    // With one wall nothing need be said of which is hit.
    let walls = usize::from(here.other_stop().is_some());
    let solution = |((one, row), reached): ((Solution, &PlaceSolution), bool)| {
        let impacts = one.impacts.into_iter().map(Impact).collect();
        let known = Known { p: one.loops, impacts, stops: one.stops[..walls * one.stops.len()].to_vec() };
        FoundSolution {
            row: told(row),
            known: known.with_dimensions(units),
            multipliers: eigenvalues(&one.multipliers),
            reached,
            orbit: orbit(one.orbit),
        }
    };
    let attractor = |(one, row): (Attractor, &PlaceAttractor)| {
        let strikes = one.strikes.into_iter().map(|[phase, velocity]| Impact([velocity, phase]));
        FoundAttractor {
            row: told(row),
            state: [one.state.position, one.state.velocity, one.state.phase],
            waited: one.fate.followed,
            orbit: orbit(one.flights),
            strikes: strikes.collect::<Vec<_>>().with_dimensions(units),
        }
    };
    let solutions = found.solutions.into_iter().zip(&rows.solutions).zip(reached);
    Ok(MotionAtPlace {
        solutions: solutions.map(solution).collect(),
        attractors: found.attractors.into_iter().zip(&rows.attractors).map(attractor).collect(),
        period: rows.period,
        beyond: other_wall(&here).with_dimensions(units),
        states: rows.states,
        followed: request.nearby.is_some(),
    })
}

/// Where the other of two walls is, without dimensions.
fn other_wall(here: &AnyOscillator) -> Vec<Position> {
    let count = if here.other_stop().is_some() { PHASES } else { 0 };
    let at = |number: u32| Position(-here.gap(TAU * f64::from(number) / f64::from(PHASES))[0].value);
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

/// The eigenvalues with these multipliers.
pub(crate) fn eigenvalues(multipliers: &Multipliers) -> Eigenvalues {
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
