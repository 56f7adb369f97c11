//! What an oscillator does at one place of the parameter plane, as rows in its own units.

use grazing_continuation::mps::Multipliers;
use grazing_model::phase::centred;
use grazing_model::smooth::Units;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_results::place::{AtPlace, BasinState, PlaceAttractor, PlaceImpact, PlaceMotion, PlaceSolution};
use grazing_unfold::place::{Place, Starts};
use grazing_unfold::progress::Progress;

/// The initial states of basins: phases, positions.
pub const LATTICE: [u32; 2] = [48, 32];

/// What there is at a place, which has this number, for these p; in the units of an oscillator that is
/// counted without dimensions. None if an end was asked for.
pub fn at_place(
    oscillator: &AnyOscillator,
    loops: &[u32],
    units: &Units,
    (place, [primary, secondary]): (u32, [f64; 2]),
    progress: &dyn Progress,
) -> Option<AtPlace> {
    let here = oscillator.with_parameters([primary / units.primary, secondary / units.secondary]);
    let starts = Starts { lattice: LATTICE, ..Starts::default() };
    let found = Place::compute(&here, loops, &starts, progress)?;
    let (length, velocity) = (units.length, units.velocity());
    let total: u32 = found.attractors.iter().map(|attractor| attractor.states).sum();
    let mut all = AtPlace {
        attractors: Vec::new(),
        solutions: Vec::new(),
        motion: Vec::new(),
        impacts: Vec::new(),
        basins: Vec::new(),
        place,
        period: found.period * units.time,
        from_the_wall: false,
        lattice: LATTICE,
    };
    for solution in &found.solutions {
        let Multipliers { trace, determinant } = solution.multipliers;
        all.solutions.push(PlaceSolution {
            place,
            loops: solution.loops,
            impact_velocity: solution.impact[0] * velocity,
            impact_phase: centred(solution.impact[1]),
            trace,
            determinant,
            stable: solution.multipliers.stable(),
            admissible: solution.admissible,
        });
    }
    for (attractor, one) in (1..).zip(&found.attractors) {
        all.attractors.push(PlaceAttractor {
            place,
            secondary,
            primary,
            attractor,
            share: f64::from(one.states) / f64::from(total),
            motion: one.fate.kind.name(),
            periods: one.fate.periods.map_or(f64::NAN, f64::from),
            impacts: one.fate.impacts,
            exponent: one.exponent.mean / units.time,
            exponent_error: one.exponent.error / units.time,
        });
        for (flight, points) in (1..).zip(&one.flights) {
            let point = |[time, x, y]: &[f64; 3]| PlaceMotion {
                place,
                attractor,
                flight,
                time: time * units.time,
                x: x * length,
                y: y * velocity,
            };
            all.motion.extend(points.iter().map(point));
        }
        let impact = |[phase, speed]: &[f64; 2]| PlaceImpact {
            place,
            attractor,
            impact_phase: centred(*phase),
            impact_velocity: speed * velocity,
        };
        all.impacts.extend(one.strikes.iter().map(impact));
    }
    let basin = |(state, index): &(State, usize)| BasinState {
        place,
        start_phase: state.phase,
        start_x: state.position * length,
        attractor: *index as u32 + 1,
    };
    all.basins.extend(found.basins.iter().map(basin));
    Some(all)
}
