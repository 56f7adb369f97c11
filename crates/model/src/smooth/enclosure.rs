//! Derivatives of a motion, and bounds of them between two nodes that are proved by interval
//! arithmetic.

use super::integrator::{Node, PositionVelocity};
use super::interval::Interval;
use super::jet::{Jet, PLANAR};
use super::oscillator::{Integrated, SmoothOscillator};
use super::series::Series;
use crate::motion::DerivativeBounds;
use crate::scalar::Scalar;

/// The derivatives d²x/dt² and d³x/dt³ at a point of the motion.
#[inline]
pub(super) fn derivatives<M: SmoothOscillator>(
    oscillator: &Integrated<M>,
    [x, y]: PositionVelocity<f64>,
    t: f64,
) -> [f64; 2] {
    let [mu, eta] = oscillator.parameters.map(Jet::<PLANAR>::constant);
    // First in time, along the motion but with its velocity held, then in the velocity.
    let force = oscillator.model.force(Jet([x, y, 0.0]), Jet([y, 0.0, 1.0]), Jet([t, 1.0, 0.0]), mu, eta);
    let acceleration = force.value();
    [acceleration, force.first(0) + force.first(1) * acceleration]
}

/// The ranges of d³x/dt³ and d⁴x/dt⁴ from those of position, velocity and acceleration.
fn ranges<M: SmoothOscillator>(
    oscillator: &Integrated<M>,
    [x, y, acceleration]: [Interval; 3],
    time: Interval,
) -> [Interval; 2] {
    let [zero, one] = [0.0, 1.0].map(Interval::constant);
    let [mu, eta] = oscillator.parameters.map(Series::constant);
    let position = Series([x, y, acceleration.scale(0.5), zero]);
    // The term of second order in the velocity is half the jerk, which is not known yet: F_y goes
    // with it.
    let velocity = Series([y, acceleration, zero, one]);
    let Series([_, jerk, bend, by_velocity]) =
        oscillator.model.force(position, velocity, Series([time, one, zero, zero]), mu, eta);
    [jerk, bend.scale(2.0) + by_velocity * jerk]
}

/// A first box holds both ends, with this share of room for motion that turns in between
/// (empirical: most boxes are then right at once).
const ROOM: f64 = 0.05;

/// Ranges that were too small, or may be, grow by this share (empirical, likewise).
const WIDENED: f64 = 0.1;

/// Number of times that a box is tried and grown before the interval of time is halved.
const TRIALS: usize = 8;

/// Limit on the halvings of an interval of time: a motion that cannot be enclosed for so short a
/// time escapes.
const HALVINGS: u32 = 12;

/// An enclosure of the motion between two nodes, as a box or as bounds of the derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) enum Cage {
    /// A box of positions, velocities and accelerations that the motion does not leave in an
    /// interval of time.
    Box([Interval; 3], Interval),
    /// Bounds of the derivatives.
    Bounds(DerivativeBounds),
}

impl Cage {
    /// A bound of |ẍ|.
    pub(super) fn acceleration(&self) -> f64 {
        match self {
            Self::Box([.., acceleration], _) => acceleration.modulus(),
            Self::Bounds(bounds) => bounds.acceleration,
        }
    }

    /// The bounds of all derivatives, which are computed on the first request: most boxes lie too
    /// far from any event for these to matter.
    pub(super) fn bounds<M: SmoothOscillator>(
        &mut self,
        oscillator: &Integrated<M>,
        [node, next]: [&Node; 2],
    ) -> DerivativeBounds {
        let bounds = match *self {
            Self::Bounds(bounds) => return bounds,
            Self::Box(cage, time) => {
                sharp(oscillator, cage, time).or_else(|| halved(oscillator, node, next, HALVINGS)).unwrap_or(
                    DerivativeBounds { acceleration: self.acceleration(), ..DerivativeBounds::UNKNOWN },
                )
            }
        };
        *self = Self::Bounds(bounds);
        bounds
    }
}

/// A cage of the motion between two nodes; `None` if nothing can be proved.
pub(super) fn enclose<M: SmoothOscillator>(
    oscillator: &Integrated<M>,
    node: &Node,
    next: &Node,
) -> Option<Cage> {
    boxed(oscillator, node, next).or_else(|| halved(oscillator, node, next, HALVINGS).map(Cage::Bounds))
}

/// A cage estimated, without proof, from the step that led to a node; `None` if it is not finite.
pub(super) fn estimate(next: &Node) -> Option<Cage> {
    let bounds = next.last.as_ref()?.bounds();
    (bounds.acceleration + bounds.jerk + bounds.snap).is_finite().then_some(Cage::Bounds(bounds))
}

/// Bounds from boxes around parts of the way between two nodes.
fn halved<M: SmoothOscillator>(
    oscillator: &Integrated<M>,
    node: &Node,
    next: &Node,
    halvings: u32,
) -> Option<DerivativeBounds> {
    let halvings = halvings.checked_sub(1)?;
    let time = 0.5 * (node.time + next.time);
    let middle = oscillator.next_node(&Node { last: None, ..*node }, time - node.time)?;
    let [a, b] = [[node, &middle], [&middle, next]].map(|[a, b]| {
        let bounds = match boxed(oscillator, a, b) {
            Some(Cage::Box(cage, time)) => sharp(oscillator, cage, time),
            _ => None,
        };
        bounds.or_else(|| halved(oscillator, a, b, halvings))
    });
    Some(a?.joined(&b?))
}

/// The bounds of all derivatives in a box; `None` if they are not finite.
fn sharp<M: SmoothOscillator>(
    oscillator: &Integrated<M>,
    cage: [Interval; 3],
    time: Interval,
) -> Option<DerivativeBounds> {
    let [jerk, snap] = ranges(oscillator, cage, time).map(|range| range.modulus());
    let bounds = DerivativeBounds { acceleration: cage[2].modulus(), jerk, snap };
    (bounds.acceleration + jerk + snap).is_finite().then_some(bounds)
}

/// A box that the solution cannot leave (Picard's criterion): with F taken over the box, velocity
/// and position stay inside it.
fn boxed<M: SmoothOscillator>(oscillator: &Integrated<M>, node: &Node, next: &Node) -> Option<Cage> {
    let [mu, eta] = oscillator.parameters.map(Interval::constant);
    let time = Interval::new(node.time, next.time);
    let duration = Interval::new(0.0, next.time - node.time);
    let start = node.state.map(Interval::constant);
    let mut force = oscillator.model.force_at(time, mu, eta);
    // F over a box that holds both ends, grown to include where a box with this F would reach.
    let [x, y] = [0, 1].map(|i| Interval::new(node.state[i], next.state[i]).grown(ROOM));
    let velocity = start[1] + duration * force(x, y).grown(WIDENED);
    let mut guess = [start[0] + duration * velocity.joined(&y), velocity.joined(&y)];
    for _ in 0..TRIALS {
        let [x, y] = guess;
        let acceleration = force(x, y);
        let reached = [start[0] + duration * y, start[1] + duration * acceleration];
        if guess[0].holds(&reached[0]) && guess[1].holds(&reached[1]) {
            let [x, y] = reached;
            return acceleration.modulus().is_finite().then_some(Cage::Box([x, y, acceleration], time));
        }
        // Only the component that is too small grows: growing the other as well would make both
        // grow without end.
        for (guess, reached) in guess.iter_mut().zip(&reached) {
            if !guess.holds(reached) {
                *guess = guess.joined(reached).grown(WIDENED);
            }
        }
    }
    None
}
