//! The behaviour of an oscillator at one place of the parameter plane, as rows.

use grazing_continuation::mps::Multipliers;
use grazing_model::phase::centred;
use grazing_model::smooth::Units;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_results::place::{AtPlace, BasinState, PlaceAttractor, PlaceImpact, PlaceMotion, PlaceSolution};
use grazing_results::{Dimensioned, Stability};

use super::{Place, Starts};
use crate::Scope;
use crate::long_time::MotionKind;
use crate::progress::Progress;

/// The lattice of initial states for basins: numbers of phases and of positions.
const LATTICE: [u32; 2] = [48, 32];

/// The number of a stop in tables, which one has in those of two.
pub(super) fn wall(stop: usize) -> u32 {
    stop as u32 + 1
}

/// The attractors, periodic solutions in a scope, and basins at a place with this number. The oscillator
/// is dimensionless, the place and the rows are in its own units. None if the computation is cancelled.
pub fn at_place(
    oscillator: &AnyOscillator,
    scope: &Scope,
    units: &Units,
    (place, at): (u32, [f64; 2]),
    progress: &dyn Progress,
) -> Option<AtPlace> {
    let at = units.without_dimensions(at);
    let starts = Starts { lattice: LATTICE, ..Starts::default() };
    let found = Place::compute(&oscillator.with_parameters(at), scope, &starts, progress)?;
    Some(found.rows(place, at).with_dimensions(units))
}

impl Place {
    /// The rows of a place with this number at these parameters, dimensionless.
    pub fn rows(&self, place: u32, at: [f64; 2]) -> AtPlace {
        let [primary, secondary] = at;
        let states: u32 = self.attractors.iter().map(|attractor| attractor.states).sum();
        let (mut attractors, mut motion, mut impacts) = (Vec::new(), Vec::new(), Vec::new());
        for (attractor, one) in (1..).zip(&self.attractors) {
            attractors.push(PlaceAttractor {
                place,
                secondary,
                primary,
                attractor,
                states: one.states,
                share: f64::from(one.states) / f64::from(states),
                motion: one.fate.kind.name(),
                periods: one.fate.periods.map_or(f64::NAN, f64::from),
                impacts: one.fate.impacts,
                second: one.fate.second,
                rests: one.fate.rests,
                exponent: one.exponent.mean,
                exponent_error: one.exponent.error,
            });
            for (flight, points) in (1..).zip(&one.flights) {
                let point = |&[time, x, y]: &[f64; 3]| PlaceMotion { place, attractor, flight, time, x, y };
                motion.extend(points.iter().map(point));
            }
            let impact = |(&[phase, impact_velocity], stop): (&[f64; 2], &usize)| {
                let (wall, impact_phase) = (wall(*stop), centred(phase));
                PlaceImpact { place, attractor, wall, impact_phase, impact_velocity }
            };
            impacts.extend(one.strikes.iter().zip(&one.stops).map(impact));
        }
        let basin = |(state, index): &(State, Option<usize>)| BasinState {
            place,
            start_phase: state.phase,
            start_x: state.position,
            motion: index.map_or(MotionKind::Unsettled, |index| self.attractors[index].fate.kind).name(),
            attractor: index.map_or(0, |index| index as u32 + 1),
        };
        AtPlace {
            attractors,
            solutions: self.solutions(place),
            motion,
            impacts,
            basins: self.basins.iter().map(basin).collect(),
            place,
            at,
            states,
            period: self.period,
            from_the_wall: false,
            lattice: self.lattice,
        }
    }

    /// The rows of periodic solutions.
    fn solutions(&self, place: u32) -> Vec<PlaceSolution> {
        let rows = self.solutions.iter().map(|solution| {
            let Multipliers { trace, determinant } = solution.multipliers;
            let [impact_velocity, phase] = solution.impacts.first().copied().unwrap_or([f64::NAN; 2]);
            PlaceSolution {
                place,
                loops: solution.loops,
                impacts: solution.impacts.len() as u32,
                wall: if solution.loops > 0 { wall(solution.stops[0]) } else { 0 },
                impact_velocity,
                impact_phase: centred(phase),
                trace,
                determinant,
                stable: Stability::of(solution.multipliers),
                admissible: solution.admissible,
            }
        });
        rows.collect()
    }
}
