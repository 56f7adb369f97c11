//! A cell of time between two evaluations of a motion: what bounds prove about it, and the events
//! that it holds.

use super::enclosure::{BoundedMotion, DerivativeBounds, Enclosure, Kinematics};
use crate::tolerances::{LAST_STEP_TO_EVENT, NARROWEST_CELL, STEPS_TO_EVENT};

/// A local maximum of x(t).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Maximum {
    /// Time since the motion began.
    pub time: f64,
    /// The value of x there.
    pub position: f64,
}

/// A crossing of the wall from x ≤ 0 to x > 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Time since the motion began.
    pub time: f64,
    /// The velocity y there, not negative.
    pub velocity: f64,
}

/// Two evaluations of a motion; in between only the bounds are known.
#[derive(Clone, Copy)]
pub(super) struct TimeCell {
    start: f64,
    pub(super) first: Kinematics,
    end: f64,
    pub(super) last: Kinematics,
    bounds: DerivativeBounds,
}

/// The behaviour of the velocity in a cell, as far as the bounds can prove it.
pub(super) enum Course {
    /// The velocity has no zero.
    Monotone,
    /// The velocity is strictly monotone, so it has at most one zero; `falling` when ẍ < 0.
    Curved { falling: bool },
    /// Not known yet.
    Open,
}

impl TimeCell {
    /// The cell between two times, in this order, whose bounds an enclosure has.
    #[inline]
    pub(super) fn within(
        enclosure: &impl Enclosure,
        [start, end]: [f64; 2],
        [first, last]: [Kinematics; 2],
    ) -> Self {
        Self { start, first, end, last, bounds: enclosure.bounds_between(start, end) }
    }

    fn width(&self) -> f64 {
        (self.end - self.start).abs()
    }

    /// |f − chord| ≤ h²/8 · max|f''|, applied to the velocity and to the acceleration.
    pub(super) fn course(&self) -> Course {
        let slack = self.width() * self.width() / 8.0;
        let (v, w) = (self.first.velocity, self.last.velocity);
        if v * w > 0.0 && v.abs().min(w.abs()) > slack * self.bounds.jerk {
            return Course::Monotone;
        }
        let (a, b) = (self.first.acceleration, self.last.acceleration);
        if a * b > 0.0 && a.abs().min(b.abs()) > slack * self.bounds.snap {
            return Course::Curved { falling: a < 0.0 };
        }
        Course::Open
    }

    /// An upper bound of x on the cell.
    fn ceiling(&self) -> f64 {
        self.first.position.max(self.last.position) + self.rise()
    }

    /// An upper bound of the height of x above the higher end of the cell.
    fn rise(&self) -> f64 {
        self.width() * self.width() / 8.0 * self.bounds.acceleration
    }

    /// Whether a smaller cell would show no more: zeros of the velocity are one, or nothing is higher than
    /// the ends but for rounding, as where the oscillator is at rest.
    fn is_narrow(&self) -> bool {
        self.width() < NARROWEST_CELL || self.rise() < f64::EPSILON
    }

    /// Both halves; `None` if the motion ceases to exist between them.
    fn halves(&self, motion: &impl BoundedMotion) -> Option<[TimeCell; 2]> {
        let time = 0.5 * (self.start + self.end);
        let middle = motion.kinematics_at(time);
        let exists = !(middle.position.is_nan() || middle.velocity.is_nan());
        exists.then_some([
            TimeCell { end: time, last: middle, ..*self },
            TimeCell { start: time, first: middle, ..*self },
        ])
    }

    /// The zero of the velocity by interpolation; the velocity is strictly monotone in this cell
    /// and changes sign.
    #[inline(always)]
    fn near_stationary_time(&self) -> f64 {
        inverse_hermite(
            [self.first.velocity, self.last.velocity],
            [self.start, self.end],
            [1.0 / self.first.acceleration, 1.0 / self.last.acceleration],
        )
    }

    /// The zero of the velocity, which is strictly monotone in this cell and changes sign.
    fn stationary_point(&self, motion: &impl BoundedMotion) -> (f64, Kinematics) {
        let rising = self.first.velocity < self.last.velocity;
        let bracket = [self.start, self.end];
        bracketed_halley(motion, bracket, rising, self.near_stationary_time(), |here| {
            [here.velocity, here.acceleration, here.jerk]
        })
    }

    /// The zero of the position before `time`, where the position is positive; no other zero lies
    /// between.
    fn crossing_before(&self, motion: &impl BoundedMotion, time: f64, there: &Kinematics) -> Crossing {
        let Kinematics { position, velocity, acceleration, .. } = *there;
        let guess = if acceleration < 0.0 {
            // The parabola through the point beyond the wall, followed back.
            time - (velocity - (velocity * velocity - 2.0 * acceleration * position).sqrt()) / acceleration
        } else {
            0.5 * (self.start + time)
        };
        let (time, there) = bracketed_halley(motion, [self.start, time], true, guess, |here| {
            [here.position, here.velocity, here.acceleration]
        });
        // A crossing that rounding turns into a touch is one with velocity zero.
        Crossing { time, velocity: there.velocity.max(0.0) }
    }

    /// A point of a cell in which the velocity falls through zero: the highest one, or any above
    /// the wall if there is one, or one that proves that there is none.
    fn top(&self, motion: &impl BoundedMotion) -> (f64, Kinematics) {
        let near = self.near_stationary_time();
        let there = motion.kinematics_at(near);
        let within = self.start < near && near < self.end;
        // −ẍ is at least this, so that no point is higher than x + y²/(2·this).
        let slack = self.width() * self.width() / 8.0 * self.bounds.snap;
        let deceleration = self.first.acceleration.abs().min(self.last.acceleration.abs()) - slack;
        let highest = there.position + there.velocity * there.velocity / (2.0 * deceleration);
        if within && (there.position > 0.0 || highest < 0.0) {
            return (near, there);
        }
        self.stationary_point(motion)
    }

    /// First crossing from x ≤ 0 to x > 0 in this cell, which begins with x ≤ 0.
    pub(super) fn crossing(&self, motion: &impl BoundedMotion) -> Option<Crossing> {
        if self.ceiling() < 0.0 {
            return None;
        }
        // The highest point of the cell that can lie above the wall, and its time.
        let (time, top) = match self.course() {
            Course::Monotone if self.last.velocity < 0.0 => return None,
            Course::Curved { falling: true } if self.first.velocity <= 0.0 => return None,
            Course::Curved { falling: true } if self.last.velocity < 0.0 => self.top(motion),
            Course::Open if !self.is_narrow() => {
                let [left, right] = self.halves(motion)?;
                return left.crossing(motion).or_else(|| right.crossing(motion));
            }
            Course::Monotone | Course::Curved { .. } | Course::Open => (self.end, self.last),
        };
        (top.position > 0.0).then(|| self.crossing_before(motion, time, &top))
    }

    /// Calls `visit` with the local maxima of the cell (its start excluded, its end included) that
    /// can exceed `threshold`. `visit` returns a threshold of its own; the highest of all is
    /// returned.
    pub(super) fn maxima(
        &self,
        motion: &impl BoundedMotion,
        threshold: f64,
        visit: &mut impl FnMut(Maximum) -> f64,
    ) -> f64 {
        if self.ceiling() < threshold {
            return threshold;
        }
        let rising =
            self.first.velocity > 0.0 || (self.first.velocity == 0.0 && self.first.acceleration > 0.0);
        let isolated = match self.course() {
            Course::Monotone | Course::Curved { falling: false } => return threshold,
            Course::Curved { falling: true } => true,
            Course::Open => self.is_narrow(),
        };
        if !isolated {
            let Some([left, right]) = self.halves(motion) else { return threshold };
            let threshold = left.maxima(motion, threshold, visit);
            return right.maxima(motion, threshold, visit);
        }
        if rising && self.last.velocity <= 0.0 {
            let (time, top) = self.stationary_point(motion);
            return threshold.max(visit(Maximum { time, position: top.position }));
        }
        threshold
    }

    /// First zero of the velocity in this cell, in the cell's direction of time; `None` if
    /// `patience`, the number of times that a cell may be halved, is used up.
    pub(super) fn rest(&self, motion: &impl BoundedMotion, patience: &mut u32) -> Option<f64> {
        let changes = self.first.velocity * self.last.velocity <= 0.0;
        match self.course() {
            Course::Monotone => None,
            Course::Curved { .. } => changes.then(|| self.stationary_point(motion).0),
            Course::Open if self.width() < NARROWEST_CELL => changes.then_some(self.end),
            Course::Open => {
                *patience = patience.checked_sub(1)?;
                let [near, far] = self.halves(motion)?;
                near.rest(motion, patience).or_else(|| far.rest(motion, patience))
            }
        }
    }
}

/// The argument at which a strictly monotone function vanishes, by cubic Hermite interpolation of
/// its inverse.
fn inverse_hermite([f, g]: [f64; 2], [a, b]: [f64; 2], [da, db]: [f64; 2]) -> f64 {
    let width = g - f;
    let s = -f / width;
    let r = 1.0 - s;
    r * r * (1.0 + 2.0 * s) * a + s * s * (1.0 + 2.0 * r) * b + s * r * width * (r * da - s * db)
}

/// The zero of a component of a motion that changes sign in a bracket, by Halley's method kept
/// inside it.
///
/// `component` picks value, slope and curvature; `rising` says that the value is negative at the
/// bracket's first end.
fn bracketed_halley(
    motion: &impl BoundedMotion,
    [a, b]: [f64; 2],
    rising: bool,
    guess: f64,
    component: impl Fn(&Kinematics) -> [f64; 3],
) -> (f64, Kinematics) {
    let (mut low, mut high) = if rising { (a, b) } else { (b, a) };
    let inside = |time: f64, low: f64, high: f64| (time - low) * (time - high) < 0.0;
    let mut time = if inside(guess, low, high) { guess } else { 0.5 * (a + b) };
    let mut here = motion.kinematics_at(time);
    for _ in 0..STEPS_TO_EVENT {
        let [value, slope, curvature] = component(&here);
        if value == 0.0 {
            break;
        }
        if value < 0.0 {
            low = time
        } else {
            high = time
        }
        let newton = value / slope;
        let halley = time - newton / (1.0 - 0.5 * newton * curvature / slope);
        let accepted = inside(halley, low, high);
        let next = if accepted { halley } else { 0.5 * (low + high) };
        let tolerance = if accepted { LAST_STEP_TO_EVENT } else { 4.0 * f64::EPSILON * time.abs().max(1.0) };
        let step = next - time;
        time = next;
        if step.abs() <= tolerance {
            here = here.after(step);
            break;
        }
        here = motion.kinematics_at(time);
    }
    (time, here)
}
