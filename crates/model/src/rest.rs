//! Rest at the wall: how impacts accumulate to it, and when the force ends it.

use core::f64::consts::TAU;

use crate::oscillator::ImpactOscillator;
use crate::state::{OnWall, State};
use crate::tolerances::{GEOMETRIC, LEAST_RISE, MOST_IMPACTS_LEFT, ROUNDING_OF_POSITION};

/// A time at rest at the wall, where the force presses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest {
    /// Time at which it begins, counted from the start of the orbit.
    pub start: f64,
    /// Phase at which it begins, in [0, 2π).
    pub phase: f64,
    /// The length of this time: until the force turns away from the wall, or until the orbit was
    /// followed for the whole requested time.
    pub duration: f64,
    /// Whether infinitely many impacts accumulate where it begins.
    pub accumulated: bool,
    /// The stop at which the motion rests, if there are two: 0 for that at x = 0, 1 for the other.
    pub stop: usize,
}

/// Number of phases between which the least force at the wall is bracketed, and of steps by which it
/// is then narrowed down.
const PHASES: i32 = 512;
const NARROWINGS: u32 = 40;

/// The first phase, from `phase` on, at which the force no longer presses what rests at the wall
/// against it: F(0, 0, z) < 0. `None` if it presses for a whole period, so that rest is for good.
pub fn release(oscillator: &impl ImpactOscillator, phase: f64) -> Option<f64> {
    let force = |phase: f64| oscillator.acceleration(State::on_wall(0.0, phase));
    // What is not a number presses nothing.
    let turned = |force: f64| force < 0.0 || force.is_nan();
    let at = |k: i32| phase + TAU * f64::from(k) / f64::from(PHASES);
    let mut forces = [force(at(-1)), force(phase), force(at(1))];
    if turned(forces[1]) {
        return Some(phase);
    }
    for k in 0..=PHASES {
        let [before, here, after] = forces;
        // A minimum may lie between the phases beside this one, and the change of sign before it.
        let least = (here <= before && here <= after)
            .then(|| least_between(force, [at((k - 1).max(0)), at(k + 1)]))
            .filter(|least| turned(force(*least)));
        let turn = least.or(turned(after).then_some(at(k + 1)));
        let pressed = if least.is_some() { at((k - 1).max(0)) } else { at(k) };
        if let Some(turn) = turn {
            return Some(change_between(|phase| turned(force(phase)), [pressed, turn]));
        }
        forces = [here, after, force(at(k + 2))];
    }
    None
}

/// The place of the only minimum of a function between two places.
fn least_between(function: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    for _ in 0..NARROWINGS {
        let [first, second] = [(2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0];
        if function(first) < function(second) { high = second } else { low = first }
    }
    0.5 * (low + high)
}

/// The place, to rounding, from which on a condition holds that does not hold at the first of two
/// places, and holds at the second.
fn change_between(holds: impl Fn(f64) -> bool, [mut low, mut high]: [f64; 2]) -> f64 {
    loop {
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            return high;
        }
        if holds(middle) { high = middle } else { low = middle }
    }
}

/// The end of a sequence of impacts that accumulate: the time until then, and the state, which is at
/// rest unless the force turns before.
pub(crate) struct Accumulation {
    pub(crate) duration: f64,
    pub(crate) state: State,
}

/// The end of a sequence of impacts, after the recoil (0, −u, z) of one of them, if they accumulate and
/// are too slow to be followed one by one.
///
/// During a flight between slow impacts the acceleration is a parabola in time, but for a share of the
/// order of u³: with a₀, a₁ and a₂ at its beginning, in its middle and at its end it takes
/// τ = 6u/(a₀ + 2a₁), and the next impact has the velocity (a₀ + 4a₁ + a₂)τ/6 − u. All that is left takes
/// τ/(1 − Φ) to leading order, a geometric series, in which the force changes by the share
/// s = (|a₁ − a₀| + |a₂ − a₁|)/(a₀(1 − Φ)); summed impact by impact, its duration is wrong by a share of
/// the order of s³. If impacts are followed instead, rounding of x by ε moves each by ε/u, and so their
/// end by 2ε/(u(1 − Φ)). They count as too slow where the first error is below the second, or where a
/// flight is lost in rounding.
pub(crate) fn accumulation(oscillator: &impl ImpactOscillator, recoil: State) -> Option<Accumulation> {
    let frequency = oscillator.forcing_frequency().value;
    let (mut speed, mut duration) = (-recoil.velocity, 0.0);
    for count in 0..MOST_IMPACTS_LEFT {
        let phase = recoil.phase + frequency * duration;
        let acceleration = |position: f64, velocity: f64, time: f64| {
            oscillator.acceleration(State { position, velocity, phase: phase + frequency * time })
        };
        let first = acceleration(0.0, -speed, 0.0);
        let (mut flight, mut middle, mut last) = (2.0 * speed / first, first, first);
        let velocity =
            |flight: f64, middle: f64, last: f64| (first + 4.0 * middle + last) * flight / 6.0 - speed;
        // Each time exact to one more order of u.
        for _ in 0..2 {
            let half = 0.5 * flight;
            let risen = half * half * (2.0 * first + middle) / 6.0 - half * speed;
            middle = acceleration(risen, half * (first + middle) / 2.0 - speed, half);
            flight = 6.0 * speed / (first + 2.0 * middle);
            last = acceleration(0.0, velocity(flight, middle, last), flight);
        }
        let impact = OnWall::new(velocity(flight, middle, last), phase + frequency * flight);
        if !(first > 0.0 && flight > 0.0 && impact.velocity > 0.0) {
            let state = State::on_wall(-speed, phase);
            return (count > 0).then_some(Accumulation { duration, state });
        }
        let image: OnWall = oscillator.reset::<1>(impact).image();
        let step = flight + (image.phase - impact.phase) / frequency;
        let loss = 1.0 + image.velocity / speed;
        let (left, change) = (step / loss, ((middle - first).abs() + (last - middle).abs()) / (first * loss));
        let rises = speed * speed > 2.0 * LEAST_RISE * first;
        let followed = 2.0 * ROUNDING_OF_POSITION / (speed * loss);
        if count == 0 && rises && !(loss > 0.0 && left * change * change * change < followed) {
            return None;
        }
        // Impacts that do not lose velocity are followed only where flights are below rounding.
        if !(loss > 0.0 && left * change > GEOMETRIC) {
            duration += if loss > 0.0 { left } else { 0.0 };
            break;
        }
        (speed, duration) = (-image.velocity, duration + step);
    }
    Some(Accumulation { duration, state: State::on_wall(0.0, recoil.phase + frequency * duration) })
}
