//! Derivatives of a motion, and bounds of them between two nodes that are proved by interval arithmetic.

use super::integrator::Node;
use super::interval::Interval;
use super::scalar::{Coefficient, Scalar};
use super::series::Series;
use super::{Integrated, SmoothOscillator};
use crate::motion::Bounds;

/// d³x/dt³ and d⁴x/dt⁴ at a point of the motion, or their ranges, from position, velocity, and acceleration; the second only
/// if it is `wanted`.
#[inline]
pub(super) fn derivatives<M: SmoothOscillator, C: Coefficient>(
    oscillator: &Integrated<M>,
    [x, y, acceleration]: [C; 3],
    t: C,
    wanted: bool,
) -> [C; 2] {
    let zero = C::constant(0.0);
    let [mu, eta] = oscillator.parameters.map(Series::constant);
    let time = Series([t, C::constant(1.0), zero]);
    let force = |x, y| oscillator.model.force(Series(x), Series(y), time, mu, eta).0;
    let [_, jerk, _] = force([x, y, zero], [y, acceleration, zero]);
    if !wanted {
        return [jerk, zero];
    }
    let [_, _, snap] = force([x, y, acceleration.scale(0.5)], [y, acceleration, jerk.scale(0.5)]);
    [jerk, snap.scale(2.0)]
}

/// A box is tried and grown this often before the interval of time is halved.
const TRIALS: usize = 8;

/// An interval of time is halved this often at most: what cannot be enclosed for so short a time escapes.
const HALVINGS: u32 = 12;

/// Bounds of the derivatives between two nodes; `None` if nothing can be proved.
pub(super) fn enclose<M: SmoothOscillator>(
    oscillator: &Integrated<M>,
    node: &Node,
    next: &Node,
) -> Option<Bounds> {
    halved(oscillator, node, next, HALVINGS)
}

fn halved<M: SmoothOscillator>(
    oscillator: &Integrated<M>,
    node: &Node,
    next: &Node,
    halvings: u32,
) -> Option<Bounds> {
    if let Some(bounds) = boxed(oscillator, node, next) {
        return Some(bounds);
    }
    let halvings = halvings.checked_sub(1)?;
    let time = 0.5 * (node.time + next.time);
    let middle = oscillator.next_node(&Node { last: None, ..*node }, time - node.time)?;
    let [a, b] = [[node, &middle], [&middle, next]].map(|[a, b]| halved(oscillator, a, b, halvings));
    let (a, b) = (a?, b?);
    Some(Bounds {
        acceleration: a.acceleration.max(b.acceleration),
        jerk: a.jerk.max(b.jerk),
        snap: a.snap.max(b.snap),
    })
}

/// Bounds from a box that the solution cannot leave (Picard's criterion): with F taken over the box, velocity and position
/// stay inside it.
fn boxed<M: SmoothOscillator>(oscillator: &Integrated<M>, node: &Node, next: &Node) -> Option<Bounds> {
    let [mu, eta] = oscillator.parameters.map(Interval::constant);
    let time = Interval::new(node.time, next.time);
    let duration = Interval::new(0.0, next.time - node.time);
    let start = node.state.map(Interval::constant);
    let mut guess = [0, 1].map(|i| Interval::new(node.state[i], next.state[i]).grown(0.05));
    for _ in 0..TRIALS {
        let [x, y] = guess;
        let acceleration = oscillator.model.force(x, y, time, mu, eta);
        let reached = [start[0] + duration * y, start[1] + duration * acceleration];
        if guess[0].holds(&reached[0]) && guess[1].holds(&reached[1]) {
            let [x, y] = reached;
            let [jerk, snap] = derivatives(oscillator, [x, y, acceleration], time, true).map(|c| c.modulus());
            let bounds = Bounds { acceleration: acceleration.modulus(), jerk, snap };
            return (bounds.acceleration + jerk + snap).is_finite().then_some(bounds);
        }
        // Only what is too small grows: the one that is large enough would drive the other on.
        for (guess, reached) in guess.iter_mut().zip(&reached) {
            if !guess.holds(reached) {
                *guess = guess.joined(reached).grown(0.1);
            }
        }
    }
    None
}
