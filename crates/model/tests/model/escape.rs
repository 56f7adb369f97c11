//! Solutions that cease to exist.

use grazing_model::motion::Motion;
use grazing_model::smooth::Integrated;
use grazing_model::{ImpactOscillator, State};

use crate::models::Escaping;

/// With ẋ = x²/√2 and no forcing x = √2/(t* − t): from x = 1 it escapes at t* = √2, from −1
/// likewise downwards.
fn escaping(position: f64) -> (Integrated<Escaping>, State) {
    let velocity = core::f64::consts::FRAC_1_SQRT_2 * position;
    (Integrated::new(Escaping, [0.0, 1.0]), State { position, velocity, phase: 0.0 })
}

#[test]
fn flow_is_exact_up_to_the_escape_and_not_a_number_beyond() {
    let (oscillator, from) = escaping(1.0);
    let escape = core::f64::consts::SQRT_2;
    for fraction in [0.5, 0.9, 0.99] {
        let position = 1.0 / (1.0 - fraction);
        let value = oscillator.flow::<1>(from, fraction * escape).value;
        // The derivative in the initial state grows like the fourth power of x.
        let tolerance = 1e-14 * position * position * position * position;
        assert!((value[0] - position).abs() < tolerance * (1.0 + position), "{fraction}");
    }
    for duration in [1.01 * escape, 100.0] {
        let jet = oscillator.flow::<2>(from, duration);
        assert!(jet.value[0].is_nan() && jet.jacobian[(0, 0)].is_nan() && jet.hessians[1][(0, 0)].is_nan());
        assert!(oscillator.motion(from).at(duration).position.is_nan());
    }
}

#[test]
fn searches_for_events_end_where_the_solution_does() {
    for position in [1.0, -1.0] {
        let (oscillator, from) = escaping(position);
        let motion = oscillator.motion(from);
        assert_eq!(motion.highest_maximum(50.0), None);
        assert_eq!(motion.local_maxima(50.0), []);
        assert_eq!(motion.first_rest(true, 50.0), None);
    }
    let (oscillator, from) = escaping(-1.0);
    assert_eq!(oscillator.motion(from).first_crossing(50.0), None);
}

/// Newton's method may try such a frequency.
#[test]
fn an_escape_ends_the_integration_though_the_forcing_has_no_frequency_or_a_negative_one() {
    for frequency in [-1.0, 0.0, f64::NAN, f64::INFINITY] {
        let oscillator = Integrated::new(Escaping, [0.0, frequency]);
        let position =
            oscillator.motion(State { position: 1.0, velocity: 0.8, phase: 0.0 }).at(100.0).position;
        assert!(position.is_nan(), "{frequency}: {position}");
    }
}

#[test]
fn an_event_before_the_escape_is_found() {
    let (oscillator, _) = escaping(1.0);
    // Thrown at the wall from below: x rises through zero, and escapes later.
    let motion = oscillator.motion(State { position: -0.5, velocity: 1.0, phase: 0.0 });
    let crossing = motion.first_crossing(50.0).unwrap();
    // ẏ = x³ keeps y² − x⁴/2.
    let velocity = (1.0_f64 - 0.5 / 16.0).sqrt();
    assert!((crossing.velocity - velocity).abs() < 1e-12);
}
