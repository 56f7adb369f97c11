//! The behaviour of an oscillator at one place of the parameter plane, as rows in its own units.

use grazing_continuation::mps::Multipliers;
use grazing_model::orbit::OrbitEnd;
use grazing_model::phase::centred;
use grazing_model::smooth::Units;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_results::place::{
    AtPlace, BasinState, PlaceAttractor, PlaceImpact, PlaceMotion, PlaceSolution, Simulated, SimulatedImpact,
    SimulatedMotion,
};
use grazing_results::{Dimensioned, Stability};
use grazing_unfold::Scope;
use grazing_unfold::long_time::{MotionKind, Trajectory};
use grazing_unfold::place::{Place, Starts};
use grazing_unfold::progress::Progress;

use crate::described::Prepared;

/// The lattice of initial states for basins: numbers of phases and of positions.
pub const LATTICE: [u32; 2] = [48, 32];

/// The greatest number of impacts per forcing period of motion from a given state.
const MOST_IMPACTS: f64 = 1000.0;

/// The number of a stop in tables, which one has in those of two.
fn wall(stop: usize) -> u32 {
    stop as u32 + 1
}

/// Motion of an oscillator at a place, from a position, velocity and time, over a number of forcing
/// periods.
///
/// # Errors
/// An explanation in words why there is no such motion.
pub fn simulated(
    of: &Prepared,
    at: [f64; 2],
    [x, y, time]: [f64; 3],
    periods: f64,
) -> Result<Simulated, String> {
    let (here, units) = (of.oscillator.with_parameters(of.without_dimensions(at)), of.axes.units);
    let frequency = here.forcing_frequency().value;
    if !(frequency > 0.0 && frequency.is_finite()) {
        let frequency = frequency / units.time;
        return Err(format!("the forcing frequency is {frequency} at this place; it must be positive"));
    }
    if !(x <= 0.0 && [x, y, time, periods].iter().all(|number| number.is_finite()) && periods > 0.0) {
        return Err(format!(
            "motion from x = {x}, v = {y} at t = {time} for {periods} forcing periods: all must be finite numbers, x (measured from the wall) at most 0, and the number of periods positive"
        ));
    }
    let (length, velocity, begin) = (units.length, units.velocity(), time / units.time);
    let from = State { position: x / length, velocity: y / velocity, phase: frequency * begin };
    let [beyond, _] = here.gap(from.phase);
    if from.position < -beyond.value {
        let other = -beyond.value * length;
        return Err(format!(
            "motion from x = {x} at t = {time}: the other wall is at x = {other} then, and the motion is between the walls"
        ));
    }
    let impacts = libm::ceil(MOST_IMPACTS * periods) as usize;
    let found = Trajectory::follow(&here, from, begin, (periods * here.forcing_period(), impacts));
    let point = |(flight, points): (u32, &Vec<[f64; 3]>)| {
        let point =
            move |&[time, x, y]: &[f64; 3]| SimulatedMotion { flight, time, x, y }.with_dimensions(&units);
        points.iter().map(point).collect::<Vec<_>>()
    };
    let impact = |(&[time, phase, impact_velocity], stop): (&[f64; 3], &usize)| {
        let impact_phase = centred(phase);
        let row = SimulatedImpact { time, wall: wall(*stop), impact_phase, impact_velocity };
        row.with_dimensions(&units)
    };
    let end = match found.end {
        OrbitEnd::TimeIsUp(end) if end.position.is_finite() => "the time is over".to_owned(),
        OrbitEnd::TimeIsUp(_) => "it cannot be followed".to_owned(),
        OrbitEnd::Resting { rest, held } => {
            let at = (begin + rest.start) * units.time;
            let then =
                if held { ", where the force holds it for whole periods" } else { "; the time is over" };
            format!("it comes to rest at the wall at t = {at}{then}")
        }
        OrbitEnd::TooManyImpacts { impacts, .. } => format!("there are more than {impacts} impacts"),
    };
    Ok(Simulated {
        motion: (1..).zip(&found.flights).flat_map(point).collect(),
        impacts: found.impacts.iter().zip(&found.stops).map(impact).collect(),
        end,
    })
}

/// The attractors, periodic solutions in a scope, and basins at a place with this number. The oscillator
/// is dimensionless, the rows are in its own units. None if the computation is cancelled.
pub fn at_place(
    oscillator: &AnyOscillator,
    scope: &Scope,
    units: &Units,
    (place, [primary, secondary]): (u32, [f64; 2]),
    progress: &dyn Progress,
) -> Option<AtPlace> {
    let here = oscillator.with_parameters(units.without_dimensions([primary, secondary]));
    let starts = Starts { lattice: LATTICE, ..Starts::default() };
    let found = Place::compute(&here, scope, &starts, progress)?;
    let mut all = AtPlace {
        attractors: Vec::new(),
        solutions: Vec::new(),
        motion: Vec::new(),
        impacts: Vec::new(),
        basins: Vec::new(),
        place,
        at: [primary, secondary],
        states: starts.states,
        period: found.period * units.time,
        from_the_wall: false,
        lattice: LATTICE,
    };
    for solution in &found.solutions {
        let Multipliers { trace, determinant } = solution.multipliers;
        let [slowest, phase] = solution.impacts.first().copied().unwrap_or([f64::NAN; 2]);
        let row = PlaceSolution {
            place,
            loops: solution.loops,
            impacts: solution.impacts.len() as u32,
            wall: if solution.loops > 0 { wall(solution.stops[0]) } else { 0 },
            impact_velocity: slowest,
            impact_phase: centred(phase),
            trace,
            determinant,
            stable: Stability::of(solution.multipliers),
            admissible: solution.admissible,
        };
        all.solutions.push(row.with_dimensions(units));
    }
    let number = |index: usize| index as u32 + 1;
    for (index, one) in found.attractors.iter().enumerate() {
        let attractor = number(index);
        let [here_primary, here_secondary] = here.parameters();
        let row = PlaceAttractor {
            place,
            secondary: here_secondary,
            primary: here_primary,
            attractor,
            states: one.states,
            share: f64::from(one.states) / f64::from(starts.states),
            motion: one.fate.kind.name(),
            periods: one.fate.periods.map_or(f64::NAN, f64::from),
            impacts: one.fate.impacts,
            second: one.fate.second,
            rests: one.fate.rests,
            exponent: one.exponent.mean,
            exponent_error: one.exponent.error,
        };
        all.attractors.push(row.with_dimensions(units));
        for (flight, points) in (1..).zip(&one.flights) {
            let point = |&[time, x, y]: &[f64; 3]| {
                PlaceMotion { place, attractor, flight, time, x, y }.with_dimensions(units)
            };
            all.motion.extend(points.iter().map(point));
        }
        let impact = |(&[phase, impact_velocity], stop): (&[f64; 2], &usize)| {
            let (wall, impact_phase) = (wall(*stop), centred(phase));
            PlaceImpact { place, attractor, wall, impact_phase, impact_velocity }.with_dimensions(units)
        };
        all.impacts.extend(one.strikes.iter().zip(&one.stops).map(impact));
    }
    let basin = |(state, index): &(State, Option<usize>)| {
        let row = BasinState {
            place,
            start_phase: state.phase,
            start_x: state.position,
            motion: index.map_or(MotionKind::Unsettled, |index| found.attractors[index].fate.kind).name(),
            attractor: index.map_or(0, number),
        };
        row.with_dimensions(units)
    };
    all.basins.extend(found.basins.iter().map(basin));
    Some(all)
}
