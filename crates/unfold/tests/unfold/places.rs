//! Attractors at places of Figure 7: motion is named only where it has been shown to have settled.

use grazing_model::orbit::Orbit;
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator, State};
use grazing_unfold::long_time::{Horizon, MotionKind, Patience};
use grazing_unfold::place::{Attractor, Place, Starts};
use grazing_unfold::progress::Silent;

use crate::specimens::{EPSILON, ZETA};

fn oscillator([amplitude, frequency]: [f64; 2]) -> AnyOscillator {
    AnyOscillator::new(LinearOscillator::new(ZETA, EPSILON, amplitude, frequency).unwrap())
}

/// The attractors of 40 states: kind, impacts and periods of each.
fn attractors(at: [f64; 2], horizon: Horizon) -> Vec<(MotionKind, u32, u32)> {
    let starts = Starts { states: 40, horizon, ..Starts::default() };
    let place = Place::compute(&oscillator(at), &[1], &starts, &Silent).unwrap();
    let named = place.attractors.into_iter().map(|Attractor { fate, exponent, .. }| {
        assert_eq!(exponent.is_positive(), fate.kind == MotionKind::Chaotic);
        // A cycle has an exact exponent, and attracts.
        assert_eq!(exponent.mean < 0.0 && exponent.error == 0.0, fate.periods.is_some());
        let periods = fate.periods.unwrap_or(0);
        (fate.kind, libm::round(fate.impacts * f64::from(periods)) as u32, periods)
    });
    named.collect()
}

#[test]
fn motion_is_named_when_it_has_settled_and_each_attractor_once() {
    let usual = Starts::default().horizon;
    for (at, kind, impacts, periods) in [
        // Transients of over a thousand periods.
        ([0.265, 0.8541], MotionKind::NonImpacting, 0, 1),
        // Motion that approaches its cycle so slowly that it looks like a cycle of twice the
        // length.
        ([0.3, 0.8541], MotionKind::Periodic, 3, 6),
        ([0.25, 0.87], MotionKind::Periodic, 2, 6),
    ] {
        assert_eq!(attractors(at, usual), [(kind, impacts, periods)], "{at:?}");
        // By simulation alone, for a long time.
        let oscillator = oscillator(at);
        let period = oscillator.forcing_period();
        let mut orbit = Orbit::new(&oscillator, State::at_rest(-0.3, 1.0), 20_000.0 * period, usize::MAX);
        let late = orbit.by_ref().filter(|flight| flight.start > 19_900.0 * period);
        let velocities: Vec<f64> = late.map(|flight| flight.from.velocity).collect();
        let again =
            |count: usize| (velocities.iter().zip(&velocities[count..])).all(|(a, b)| (a - b).abs() < 1e-6);
        match impacts {
            0 => assert!(velocities.is_empty()),
            _ => assert_eq!((1..=20).find(|count| again(*count)), Some(impacts as usize), "{at:?}"),
        }
    }
}

#[test]
fn what_has_not_settled_is_not_named_but_chaos_is() {
    let short = Horizon { transient: 5, counted: 6, patience: Patience::Drifting, longest: 0 };
    let [(MotionKind::Unsettled, ..), ..] = attractors([0.265, 0.8541], short)[..] else {
        panic!("it takes longer than that to settle");
    };
    let found = attractors([0.5, 0.6], Starts::default().horizon);
    assert_eq!(found, [(MotionKind::Chaotic, 0, 0), (MotionKind::NonImpacting, 0, 1)]);
}

#[test]
fn fast_solutions_at_a_place_are_found_as_in_the_plane() {
    let at @ [amplitude, frequency] = [4.0, 0.6];
    let exact = grazing_trials::closed_form::orbits(ZETA, EPSILON, amplitude, frequency, 1);
    let exact: Vec<f64> =
        exact.iter().map(|orbit| orbit.velocity).filter(|velocity| *velocity > 0.0).collect();
    assert!(exact.iter().any(|velocity| (2.5..16.0).contains(velocity)), "{exact:?}");
    let horizon = Horizon { transient: 5, counted: 6, patience: Patience::Drifting, longest: 0 };
    let starts = Starts { states: 1, horizon, ..Starts::default() };
    let place = Place::compute(&oscillator(at), &[1], &starts, &Silent).unwrap();
    for velocity in exact {
        let found = place.solutions.iter().filter(|found| (found.impact[0] - velocity).abs() < 1e-6);
        assert_eq!(found.count(), 1, "{velocity}");
    }
}
