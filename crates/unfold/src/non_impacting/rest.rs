//! Rest positions of an oscillator in front of the wall.
//!
//! Where attraction at the wall exceeds the spring, as in adhesion, motion that begins near the
//! wall may run away, or settle in another well behind the wall, while motion from the rest
//! position still relaxes. That position may be hundreds of units of length away, since the unit
//! depends on how fast the force changes at the wall.

use core::f64::consts::TAU;

use grazing_continuation::regula_falsi::zero_between;
use grazing_model::{AnyOscillator, ImpactOscillator, State};

/// Number of instants of a forcing period at which the force is evaluated.
const INSTANTS: u32 = 16;
/// Number of distances from the wall between which rest positions are looked for.
const DISTANCES: u32 = 80;
/// The first of these distances.
const FIRST: f64 = 1.0 / 256.0;
/// The ratio of each distance to the previous one. The last is some 3600 units of length
/// (empirical): a unit is the distance from rest or, where the force is steep at the wall, down to
/// a thousandth of it.
const RATIO: f64 = 1.19;
/// Positions farther off than this multiple of the nearest one are left out: a pendulum has
/// infinitely many rest positions, which differ only in its turns.
const REACH: f64 = 4.0;
/// Largest difference of forces that count as equal: rest positions are known only to [`ENOUGH`],
/// and equal forces of the order of one therefore to slightly less.
const SAME_FORCE: f64 = 0.02;
/// Accuracy of a rest position, as the ratio of the mean force there to that around it: motion
/// relaxes from beside a rest position as well.
const ENOUGH: f64 = 1e-3;

/// The stable rest positions in front of the wall, in the order of their distance: the force at
/// rest, averaged over a forcing period, is zero there and drives back to there.
pub fn positions(oscillator: &AnyOscillator) -> Vec<f64> {
    let stable = zeros(oscillator).into_iter().filter_map(|(position, stable)| stable.then_some(position));
    let mut found: Vec<f64> = stable.collect();
    if let [first, second, ..] = found[..] {
        let turn = first - second;
        if is_period(oscillator, second, turn) {
            found.retain(|position| position.abs() <= 0.5 * turn);
        }
    }
    found
}

/// All rest positions in front of the wall, the stable ones first.
pub(super) fn all_positions(oscillator: &AnyOscillator) -> Vec<f64> {
    let mut found = zeros(oscillator);
    found.sort_by_key(|(_, stable)| !stable);
    found.into_iter().map(|(position, _)| position).collect()
}

/// The rest positions in front of the wall, in the order of their distance, and whether the force
/// drives back to them.
fn zeros(oscillator: &AnyOscillator) -> Vec<(f64, bool)> {
    let mean = |position: f64| {
        let phases = (0..INSTANTS).map(|k| TAU * f64::from(k) / f64::from(INSTANTS));
        let forces = phases.map(|phase| oscillator.acceleration(State::at_rest(position, phase)));
        forces.sum::<f64>() / f64::from(INSTANTS)
    };
    let mut found = Vec::new();
    let [mut near, mut at_near] = [0.0, mean(0.0)];
    let mut far = -FIRST;
    for _ in 0..DISTANCES {
        let nearest = found.iter().find_map(|(position, stable): &(f64, bool)| stable.then_some(*position));
        if nearest.is_some_and(|nearest| far < REACH * nearest) {
            break;
        }
        let at_far = mean(far);
        if (at_near < 0.0) != (at_far < 0.0) {
            let at = |share: f64| {
                let position = near + share * (far - near);
                let force = mean(position);
                Ok::<_, core::convert::Infallible>((position, force))
            };
            let enough = |_: &f64, force: f64| force.abs() <= ENOUGH * (at_far - at_near).abs();
            let Ok(position) = zero_between([at_near, at_far], at, enough);
            found.push((position, at_near < 0.0));
        }
        [near, at_near] = [far, at_far];
        far *= RATIO;
    }
    found
}

/// Whether the force is the same a turn further on: motion about rest positions that differ by
/// turns is the same, and only that next to the wall matters, on either side.
fn is_period(oscillator: &AnyOscillator, from: f64, turn: f64) -> bool {
    const SHARES: [f64; 5] = [0.0, 0.137, 0.361, 0.592, 0.823];
    SHARES.iter().zip(SHARES.iter().rev()).all(|(place, phase)| {
        let force = |position: f64| {
            let velocity = turn * (place - 0.5) * oscillator.forcing_frequency().value;
            oscillator.acceleration(State { position, velocity, phase: TAU * phase })
        };
        let here = [force(from + place * turn), force(from + (place + 1.0) * turn)];
        (here[0] - here[1]).abs() <= SAME_FORCE * (here[0].abs() + here[1].abs() + 1.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rest_positions_are_those_in_front_of_the_wall_to_which_the_force_drives_back() {
        let cases: [(&str, &[f64]); 5] = [
            ("-x - 1", &[-1.0]),
            ("1 - x", &[]),
            // Two wells with a hill between them, and a pendulum, which has one well and its turns.
            ("-(x + 1)*(x + 2)*(x + 3)", &[-1.0, -3.0]),
            ("-sin(x + 0.4)", &[-0.4]),
            // The attraction is twice the spring at the wall, and a millionth of it where it rests.
            ("-x - 1000 + 2000/(1 + x^2)", &[-1000.0]),
        ];
        for (force, expected) in cases {
            let found = positions(&crate::specimens::unforced(force).oscillator([0.0, 1.0]));
            // Where the force is a thousandth of that beside it the position has no larger error.
            let near = |(found, expected): (&f64, &f64)| (found / expected - 1.0).abs() < ENOUGH;
            assert!(
                found.len() == expected.len() && found.iter().zip(expected).all(near),
                "{force}: {found:?}"
            );
        }
    }
}
