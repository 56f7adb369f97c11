//! The end of a motion that runs away, or reaches a point where the force has no value.

use grazing_model::motion::Motion;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_results::dimensioned;

/// The last known point of a motion without the wall that does not last for a forcing period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Escape {
    /// The parameters (μ, η).
    pub parameters: [f64; 2],
    /// The time t since phase zero of the last known point.
    pub time: f64,
    /// Position x there.
    pub position: f64,
    /// Velocity there.
    pub velocity: f64,
    /// The force there; if it cannot be computed immediately behind this point, its value there,
    /// which is not finite.
    pub force: f64,
}

dimensioned! {
    Escape, |own| {
        own.parameters[0] => "{primary}",
        own.parameters[1] => "{secondary}",
        own.time => "time",
        own.position => "length",
        own.velocity => "length/time",
        own.force => "length/time^2",
    }
}

/// Number of halvings of the period by which the time of the end is narrowed down.
const HALVINGS: u32 = 40;
/// Times behind the end at which the force is evaluated, as fractions of the period: a step of the
/// integration, and less.
const BEHIND: [f64; 4] = [1e-6, 1e-4, 1e-2, 1e-1];

impl Escape {
    /// The end of the motion from a state at phase zero within a forcing period.
    pub fn of(oscillator: &AnyOscillator, [position, velocity]: [f64; 2]) -> Self {
        let from = State { position, velocity, phase: 0.0 };
        let frequency = oscillator.forcing_frequency().value;
        let period = oscillator.forcing_period();
        let motion = oscillator.motion(from);
        let exists = |time: f64| {
            let there = motion.at(time);
            there.position.is_finite() && there.velocity.is_finite()
        };
        let (mut known, mut end) = (0.0, period);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (known + end);
            if exists(middle) { known = middle } else { end = middle }
        }
        let force = |state: State| oscillator.acceleration(state);
        let last = if known > 0.0 { motion.at(known).state(frequency * known) } else { from };
        let mut value = force(last);
        // Straight on from there, over the distance of a step of the integration.
        for share in BEHIND {
            let time = share * period;
            let ahead = State {
                position: last.position + last.velocity * time,
                velocity: last.velocity + value * time,
                phase: last.phase + frequency * time,
            };
            let next = force(ahead);
            if value.is_finite() && !next.is_finite() {
                value = next;
            }
        }
        let State { position, velocity, .. } = last;
        Self { parameters: oscillator.parameters(), time: known, position, velocity, force: value }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_place_is_that_beyond_which_the_force_has_no_value() {
        // The force is undefined in x < −2.
        let edge = crate::specimens::unforced("-sqrt(x + 2) - 1");
        let escape = Escape::of(&edge.oscillator([0.0, 1.0]), [-1.0, 0.0]);
        // The integration ends with a step of a billionth, next to the place.
        assert!((escape.position + 2.0).abs() < 1e-2, "{escape:?}");
        assert!(escape.velocity < 0.0 && escape.force.is_nan(), "{escape:?}");
    }
}
