//! Motion between impacts and the exact location of its events.
//!
//! Generic event detection evaluates at steps and misses what happens within one, such as an impact of low velocity
//! followed at once by the way back. Here each cell between two evaluations is *proved* free of events from bounds on the
//! derivatives, or narrowed down until the event is isolated between two evaluations and solved for: local maxima first,
//! then the crossing before the maximum.

/// Position, velocity and acceleration at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kinematics {
    /// x.
    pub position: f64,
    /// y = ẋ.
    pub velocity: f64,
    /// ẍ.
    pub acceleration: f64,
}

/// Bounds of |ẍ|, |d³x/dt³| and |d⁴x/dt⁴| on an interval of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Bound of |ẍ|.
    pub acceleration: f64,
    /// Bound of |d³x/dt³|.
    pub jerk: f64,
    /// Bound of |d⁴x/dt⁴|.
    pub snap: f64,
}

/// A smooth motion x(t), t being the time since it began.
pub trait Motion {
    /// The motion at a time of either sign.
    fn at(&self, time: f64) -> Kinematics;

    /// Bounds of the derivatives for all times between `from` and `to`.
    fn bounds(&self, from: f64, to: f64) -> Bounds;

    /// Spacing of [`walk`](Self::walk).
    fn stride(&self) -> f64;

    /// The motion at the times 0, h, 2h, … with h the stride.
    fn walk(&self) -> impl Iterator<Item = Kinematics>;
}

/// A local maximum of x(t).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Maximum {
    /// Time since the motion began.
    pub time: f64,
    /// The value of x there.
    pub position: f64,
}

/// Below this width two zeros of the velocity count as one (empirical: far above rounding, far below any motion).
const NARROWEST_CELL: f64 = 1e-9;

/// Two evaluations of a motion with nothing known in between but the bounds.
#[derive(Clone, Copy)]
struct Cell {
    start: f64,
    first: Kinematics,
    end: f64,
    last: Kinematics,
}

/// What the velocity does in a cell, as far as the bounds can prove it.
enum Course {
    /// The velocity has no zero.
    Monotone,
    /// The velocity is strictly monotone, so it has at most one zero; `falling` when ẍ < 0.
    Curved { falling: bool },
    /// Not known yet.
    Open,
}

impl Cell {
    fn width(&self) -> f64 {
        (self.end - self.start).abs()
    }

    /// |f − chord| ≤ h²/8 · max|f''|, applied to the velocity and to the acceleration.
    fn course(&self, bounds: &Bounds) -> Course {
        let slack = self.width() * self.width() / 8.0;
        let (v, w) = (self.first.velocity, self.last.velocity);
        if v * w > 0.0 && v.abs().min(w.abs()) > slack * bounds.jerk {
            return Course::Monotone;
        }
        let (a, b) = (self.first.acceleration, self.last.acceleration);
        if a * b > 0.0 && a.abs().min(b.abs()) > slack * bounds.snap {
            return Course::Curved { falling: a < 0.0 };
        }
        Course::Open
    }

    /// No point of the cell lies above this.
    fn ceiling(&self, bounds: &Bounds) -> f64 {
        self.first.position.max(self.last.position)
            + self.width() * self.width() / 8.0 * bounds.acceleration
    }

    fn halves(&self, motion: &impl Motion) -> [Cell; 2] {
        let time = 0.5 * (self.start + self.end);
        let middle = motion.at(time);
        [Cell { end: time, last: middle, ..*self }, Cell { start: time, first: middle, ..*self }]
    }

    /// The zero of the velocity, which is known to be unique in this cell.
    fn stationary_time(&self, motion: &impl Motion) -> f64 {
        bracketed_newton(self.start, self.end, self.first.velocity < self.last.velocity, |time| {
            let here = motion.at(time);
            (here.velocity, here.acceleration)
        })
    }

    /// First crossing from x ≤ 0 to x > 0 in this cell, which begins with x ≤ 0.
    fn crossing(&self, motion: &impl Motion, bounds: &Bounds) -> Option<f64> {
        if self.ceiling(bounds) < 0.0 {
            return None;
        }
        let top = match self.course(bounds) {
            Course::Monotone => (self.last.velocity > 0.0).then_some((self.end, self.last.position)),
            Course::Curved { falling: true } if self.first.velocity <= 0.0 => None,
            Course::Curved { falling: true } if self.last.velocity < 0.0 => {
                let time = self.stationary_time(motion);
                Some((time, motion.at(time).position))
            }
            // Convex, or rising throughout: the end is the highest point that can lie above the wall.
            Course::Curved { .. } => Some((self.end, self.last.position)),
            Course::Open if self.width() < NARROWEST_CELL => Some((self.end, self.last.position)),
            Course::Open => {
                let [left, right] = self.halves(motion);
                return left.crossing(motion, bounds).or_else(|| right.crossing(motion, bounds));
            }
        };
        let (time, position) = top?;
        (position > 0.0).then(|| {
            bracketed_newton(self.start, time, true, |time| {
                let here = motion.at(time);
                (here.position, here.velocity)
            })
        })
    }

    /// Calls `visit` with the local maxima of the cell (its start excluded, its end included) that can exceed `threshold`;
    /// `visit` returns the new threshold.
    fn maxima(
        &self,
        motion: &impl Motion,
        bounds: &Bounds,
        threshold: &mut f64,
        visit: &mut impl FnMut(Maximum) -> f64,
    ) {
        if self.ceiling(bounds) < *threshold {
            return;
        }
        let rising =
            self.first.velocity > 0.0 || (self.first.velocity == 0.0 && self.first.acceleration > 0.0);
        let isolated = match self.course(bounds) {
            Course::Monotone | Course::Curved { falling: false } => return,
            Course::Curved { falling: true } => true,
            Course::Open => self.width() < NARROWEST_CELL,
        };
        if isolated {
            if rising && self.last.velocity <= 0.0 {
                let time = self.stationary_time(motion);
                *threshold = visit(Maximum { time, position: motion.at(time).position });
            }
            return;
        }
        for half in self.halves(motion) {
            half.maxima(motion, bounds, threshold, visit);
        }
    }
}

/// The cells of a motion from time 0 to `horizon`.
fn cells(motion: &impl Motion, horizon: f64) -> impl Iterator<Item = Cell> {
    let stride = motion.stride();
    let mut walk = motion.walk();
    let mut first = walk.next();
    let mut index = 0.0;
    core::iter::from_fn(move || {
        let start = index * stride;
        if start >= horizon {
            return None;
        }
        index += 1.0;
        let end = (index * stride).min(horizon);
        let last = if index * stride <= horizon { walk.next()? } else { motion.at(horizon) };
        let cell = Cell { start, first: first?, end, last };
        first = Some(last);
        Some(cell)
    })
}

/// The first time in (0, horizon] at which the motion, which begins with x ≤ 0, crosses x = 0 upwards.
///
/// A maximum that only touches the wall (x ≤ 0 to rounding) is no crossing.
pub fn first_crossing(motion: &impl Motion, horizon: f64) -> Option<f64> {
    let bounds = motion.bounds(0.0, horizon);
    cells(motion, horizon).find_map(|cell| cell.crossing(motion, &bounds))
}

/// All local maxima of x(t) for t in (0, horizon), in order of time.
pub fn local_maxima(motion: &impl Motion, horizon: f64) -> Vec<Maximum> {
    let bounds = motion.bounds(0.0, horizon);
    let mut found = Vec::new();
    let mut threshold = f64::NEG_INFINITY;
    for cell in cells(motion, horizon) {
        cell.maxima(motion, &bounds, &mut threshold, &mut |maximum| {
            found.push(maximum);
            f64::NEG_INFINITY
        });
    }
    found
}

/// The highest local maximum of x(t) for t in (0, horizon), or `None` if there is no local maximum.
pub fn highest_maximum(motion: &impl Motion, horizon: f64) -> Option<Maximum> {
    let bounds = motion.bounds(0.0, horizon);
    let mut highest: Option<Maximum> = None;
    let mut threshold = f64::NEG_INFINITY;
    for cell in cells(motion, horizon) {
        cell.maxima(motion, &bounds, &mut threshold, &mut |maximum| {
            let best = match highest {
                Some(other) if other.position >= maximum.position => other,
                _ => maximum,
            };
            highest = Some(best);
            best.position
        });
    }
    highest
}

/// The zero of the velocity nearest to time 0 in the given direction of time, at most `horizon` away.
///
/// For a motion that begins with a velocity other than zero; paper: the evolution time of P_virt.
pub fn first_rest(motion: &impl Motion, forwards: bool, horizon: f64) -> Option<f64> {
    let sign = if forwards { 1.0 } else { -1.0 };
    let bounds = motion.bounds(0.0, sign * horizon);
    let mut first = motion.at(0.0);
    let mut start = 0.0;
    while start < horizon {
        let end = (start + motion.stride()).min(horizon);
        let last = motion.at(sign * end);
        let cell = Cell { start: sign * start, first, end: sign * end, last };
        if let Some(time) = cell.rest(motion, &bounds) {
            return Some(time);
        }
        (start, first) = (end, last);
    }
    None
}

impl Cell {
    /// First zero of the velocity in this cell, in the cell's direction of time.
    fn rest(&self, motion: &impl Motion, bounds: &Bounds) -> Option<f64> {
        let changes = self.first.velocity * self.last.velocity <= 0.0;
        match self.course(bounds) {
            Course::Monotone => None,
            Course::Curved { .. } => changes.then(|| self.stationary_time(motion)),
            Course::Open if self.width() < NARROWEST_CELL => changes.then_some(self.end),
            Course::Open => {
                let [near, far] = self.halves(motion);
                near.rest(motion, bounds).or_else(|| far.rest(motion, bounds))
            }
        }
    }
}

/// The zero of a function that changes sign between `a` and `b`, by Newton's method kept inside the bracket.
///
/// `rising` says that the function is negative at `a`. The answer is exact to rounding: the iteration ends when a step no
/// longer changes the argument by more than a few units in the last place, or the bracket is empty.
fn bracketed_newton(a: f64, b: f64, rising: bool, f: impl Fn(f64) -> (f64, f64)) -> f64 {
    let (mut low, mut high) = if rising { (a, b) } else { (b, a) };
    let mut time = 0.5 * (a + b);
    // Bisection alone empties a bracket of doubles in at most about 60 steps near 1; twice that is ample.
    for _ in 0..128 {
        let (value, slope) = f(time);
        if value == 0.0 {
            return time;
        }
        if value < 0.0 { low = time } else { high = time }
        let newton = time - value / slope;
        let inside = (newton - low) * (newton - high) < 0.0;
        let next = if inside { newton } else { 0.5 * (low + high) };
        if (next - time).abs() <= 4.0 * f64::EPSILON * time.abs().max(1.0) {
            return next;
        }
        time = next;
    }
    time
}
