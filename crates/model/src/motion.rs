//! Motion between impacts and the exact location of its events.
//!
//! Generic event detection evaluates at steps and misses what happens within one, such as an impact of low velocity
//! followed at once by the way back. Here each cell between two evaluations is *proved* free of events from bounds on the
//! derivatives, or narrowed down until the event is isolated between two evaluations and solved for: local maxima first,
//! then the crossing before the maximum.

mod cell;

use cell::{Cell, Course};

/// Position and its first three derivatives at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kinematics {
    /// x.
    pub position: f64,
    /// y = ẋ.
    pub velocity: f64,
    /// ẍ.
    pub acceleration: f64,
    /// d³x/dt³.
    pub jerk: f64,
}

impl Kinematics {
    /// The kinematics a very short time later, by Taylor's formula.
    fn after(&self, time: f64) -> Self {
        let Self { position, velocity, acceleration, jerk } = *self;
        Self {
            position: position + (velocity + (0.5 * acceleration + jerk * time / 6.0) * time) * time,
            velocity: velocity + (acceleration + 0.5 * jerk * time) * time,
            acceleration: acceleration + jerk * time,
            jerk,
        }
    }
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

impl Bounds {
    /// Nothing is known, so that nothing can be proved.
    pub(crate) const UNKNOWN: Self = Self::all(f64::INFINITY);
    /// Over no time at all nothing happens.
    pub(crate) const NO_TIME: Self = Self::all(0.0);

    const fn all(bound: f64) -> Self {
        Self { acceleration: bound, jerk: bound, snap: bound }
    }

    /// Bounds that hold wherever one of the two does.
    pub(crate) fn joined(&self, other: &Self) -> Self {
        Self {
            acceleration: self.acceleration.max(other.acceleration),
            jerk: self.jerk.max(other.jerk),
            snap: self.snap.max(other.snap),
        }
    }
}

/// A smooth motion x(t), t being the time since it began.
pub trait Motion {
    /// The motion at a time of either sign; NaN where it has ceased to exist.
    fn at(&self, time: f64) -> Kinematics;

    /// The derivatives bounded from the beginning to a horizon, which may lie in the past.
    fn enclose(&self, horizon: f64) -> impl Window;

    /// How far bounds are worth having when the first event may come sooner; all the way, where they cost nothing.
    #[inline]
    fn foresight(&self) -> f64 {
        f64::INFINITY
    }
}

/// The time from a motion's beginning to a horizon, over which its derivatives have been bounded: the only source of bounds.
///
/// It is divided into strides, such that the motion is cheap to evaluate between two.
pub trait Window {
    /// Bounds for the whole window, as far as the motion exists.
    fn bounds(&self) -> Bounds;

    /// Bounds between two times, in this order; infinite outside of the window. Those for the whole will do where they are about as good.
    fn bounds_between(&self, from: f64, to: f64) -> Bounds;

    /// The length of the longest stride.
    fn stride(&self) -> f64;

    /// The number of whole strides in the window.
    fn strides(&self) -> usize;

    /// The time after so many strides, at most [`strides`](Self::strides).
    fn time_after(&self, strides: usize) -> f64;

    /// A walk through the times after 0, 1, 2, … strides, standing at 0.
    fn walk(&self) -> impl Walk;
}

/// A walk along a motion in strides: the position at once, the derivatives when they are asked for.
pub trait Walk: Copy {
    /// x.
    fn position(&self) -> f64;

    /// x and its derivatives.
    fn kinematics(&self) -> Kinematics;

    /// Goes on by one stride.
    fn advance(&mut self);
}

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

/// The cells of a motion from time 0 to `horizon`, up to which a window reaches, in which x may exceed `level`.
#[inline]
fn cells_above(
    motion: &impl Motion,
    window: &impl Window,
    horizon: f64,
    level: f64,
) -> impl Iterator<Item = Cell> {
    let stride = window.stride();
    // Positions at both ends below this rule the cell out: |x − chord| ≤ h²/8 · max|ẍ|.
    let relevant = level - stride * stride / 8.0 * window.bounds().acceleration;
    let whole_cells = window.strides();
    let mut walk = window.walk();
    let (mut index, mut position) = (0, walk.position());
    // The derivatives at the point where the walk stands, if the cell before needed them.
    let mut known: Option<Kinematics> = None;
    core::iter::from_fn(move || {
        // Local copies, so that the loop over ruled-out cells runs in registers.
        let (mut here, mut cell, mut above) = (walk, index, position >= relevant);
        while cell < whole_cells {
            let before = here;
            here.advance();
            cell += 1;
            let next = here.position();
            let next_above = next >= relevant;
            if above || next_above {
                let first = known.filter(|_| cell == index + 1).unwrap_or_else(|| before.kinematics());
                let last = here.kinematics();
                (walk, index, position, known) = (here, cell, next, Some(last));
                let [start, end] = [cell - 1, cell].map(|strides| window.time_after(strides));
                return Some(Cell::within(window, [start, end], [first, last]));
            }
            above = next_above;
        }
        if cell > index {
            (walk, index, known) = (here, cell, None);
        }
        let start = window.time_after(index.min(whole_cells));
        // The rest of the time, shorter than a stride, comes last, unless the motion ends before the horizon.
        if index > whole_cells || start >= horizon {
            return None;
        }
        index += 1;
        let last = motion.at(horizon);
        let first = known.unwrap_or_else(|| walk.kinematics());
        last.position.is_finite().then(|| Cell::within(window, [start, horizon], [first, last]))
    })
}

/// The first crossing of x = 0 upwards, at a time in (0, horizon], by a motion that begins with x ≤ 0.
///
/// A maximum that only touches the wall (x ≤ 0 to rounding) is no crossing.
#[inline]
pub fn first_crossing(motion: &impl Motion, horizon: f64) -> Option<Crossing> {
    let mut reach = motion.foresight().min(horizon);
    loop {
        let window = motion.enclose(reach);
        let crossing = cells_above(motion, &window, reach, 0.0).find_map(|cell| cell.crossing(motion));
        if crossing.is_some() || reach >= horizon {
            return crossing;
        }
        reach = (2.0 * reach).min(horizon);
    }
}

/// All local maxima of x(t) for t in (0, horizon), in order of time.
pub fn local_maxima(motion: &impl Motion, horizon: f64) -> Vec<Maximum> {
    let mut found = Vec::new();
    for cell in cells_above(motion, &motion.enclose(horizon), horizon, f64::NEG_INFINITY) {
        cell.maxima(motion, f64::NEG_INFINITY, &mut |maximum| {
            found.push(maximum);
            f64::NEG_INFINITY
        });
    }
    found
}

/// The highest local maximum of x(t) for t in (0, horizon), or `None` if there is no local maximum.
pub fn highest_maximum(motion: &impl Motion, horizon: f64) -> Option<Maximum> {
    let mut candidates: Vec<Cell> = Vec::with_capacity(16);
    // Where the velocity changes from + to − there is a maximum, at least as high as the cell's ends.
    let mut threshold = f64::NEG_INFINITY;
    for cell in cells_above(motion, &motion.enclose(horizon), horizon, f64::NEG_INFINITY) {
        match cell.course() {
            Course::Monotone | Course::Curved { falling: false } => continue,
            Course::Curved { falling: true } | Course::Open => {}
        }
        if cell.first.velocity > 0.0 && cell.last.velocity <= 0.0 {
            threshold = threshold.max(cell.first.position.max(cell.last.position));
        }
        candidates.push(cell);
    }
    let mut highest: Option<Maximum> = None;
    for cell in candidates {
        threshold = cell.maxima(motion, threshold, &mut |maximum| {
            if highest.is_none_or(|other| other.position < maximum.position) {
                highest = Some(maximum);
            }
            maximum.position
        });
    }
    highest
}

/// How many cells the search for a zero of the velocity looks at. Motion that is one to the eye needs some hundred; where the oscillator
/// has come to rest but for rounding, or the forcing hardly moves, there would be no end of them (empirical: some milliseconds).
const PATIENCE: u32 = 100_000;

/// The zero of the velocity nearest to time 0 in the given direction of time, at most `horizon` away.
///
/// For a motion that begins with a velocity other than zero; paper: the evolution time of P_virt.
pub fn first_rest(motion: &impl Motion, forwards: bool, horizon: f64) -> Option<f64> {
    let sign = if forwards { 1.0 } else { -1.0 };
    let window = motion.enclose(sign * horizon);
    let stride = window.stride();
    let (mut start, mut first) = (0.0, motion.at(0.0));
    let mut patience = PATIENCE;
    while start < horizon && patience > 0 {
        let end = (start + stride).min(horizon);
        let last = motion.at(sign * end);
        if !last.position.is_finite() {
            return None;
        }
        let cell = Cell::within(&window, [sign * start, sign * end], [first, last]);
        if let Some(time) = cell.rest(motion, &mut patience) {
            return Some(time);
        }
        (start, first) = (end, last);
        patience = patience.saturating_sub(1);
    }
    None
}
