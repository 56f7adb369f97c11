//! Flights as they are shown: the points at which they meet Π.

use grazing_model::maps::{next_visit, virtual_map};
use grazing_model::orbit::Flight;
use grazing_model::{AnyMotion, AnyOscillator, AtRest, ImpactOscillator, OnWall, State};

use crate::long_time::Strike;

/// The points (x, z) at which a flight meets Π: the iterates of P_global from the virtual point of its
/// recoil while they lie within the flight, and the virtual maximum beyond the wall at its end. Between two
/// stops only the latter, beyond either of them.
pub(super) fn visits_of(oscillator: &AnyOscillator, flight: &Flight<AnyMotion>) -> Vec<[f64; 2]> {
    let mut visits: Vec<[f64; 2]> = flight.rest.iter().map(|rest| [0.0, rest.phase]).collect();
    let last = Strike::of(flight).and_then(|strike| strike.virtual_top(oscillator));
    if oscillator.other_stop().is_some() {
        // At the end of a rest the flight is where the stop is.
        visits.iter_mut().for_each(|visit| visit[0] = flight.from.position);
        visits.extend(last);
        return visits;
    }
    let State { position, velocity, phase } = flight.from;
    let mut here = match velocity {
        0.0 => Some((0.0, AtRest::new(position, phase))),
        _ => {
            let origin = virtual_map::<_, 1>(oscillator, OnWall::new(velocity, phase), None);
            origin.ok().map(|origin| (origin.time, origin.jet.image()))
        }
    };
    while let Some((time, visit)) = here {
        let next = next_visit(oscillator, visit, None).ok();
        let next = next.map(|next| (time + next.time, next.jet.image()));
        here = next.filter(|(time, _)| *time < flight.duration);
        visits.extend(here.map(|(_, visit)| [visit.position, visit.phase]));
    }
    visits.extend(last);
    visits
}
