//! What is stated of one interval of ν, with the witnesses by which it can be checked: a row of the
//! certificate.

use crate::ball::Ball;

/// Witnesses are integers in units of 2⁻⁶⁴.
pub const WITNESS_BITS: u32 = 64;

/// A polynomial in `u = ν − m`, m the base of the interval, by its coefficients.
pub type Witness<const N: usize> = [i128; N];

/// Where the base of an interval lies: in its middle, or, if a resonance of one loop is there, at an
/// end. There stability and contact begin at velocity zero; everything is divided by powers of
/// `|u|`, and the resonance itself is not part of the interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Base {
    /// At the left end.
    Left,
    /// In the middle.
    Middle,
    /// At the right end.
    Right,
}

/// The interval `left/2^level ≤ ν ≤ (left + 1)/2^level`, for motion with one impact in `p` periods.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Interval {
    /// Periods between impacts.
    pub p: i64,
    /// Its left end, in units of its width.
    pub left: i64,
    /// Its width is `2^-level`.
    pub level: u32,
    /// Where witnesses have their origin.
    pub base: Base,
}

impl Interval {
    /// Its ends.
    pub fn ends(self) -> [Ball; 2] {
        [0, 1].map(|end| Ball::dyadic((self.left + end).into(), self.level))
    }

    /// Its middle.
    pub fn middle(self) -> Ball {
        Self { base: Base::Middle, ..self }.origin()
    }

    /// Its base.
    pub fn origin(self) -> Ball {
        Ball::dyadic(i128::from(2 * self.left + self.base as i64), self.level + 1)
    }

    /// All of it, and a sixteenth beyond either end: room for whoever checks with coarser bounds.
    pub fn all(self) -> Ball {
        let room = Ball::dyadic(1, self.level + 4);
        let [left, right] = self.ends();
        Ball::between(left - room, right + room)
    }

    /// The end, if any, at which there is a resonance of one loop: 2ν is an integer.
    pub fn resonance(self) -> Option<Base> {
        let whole = |n: i64| (2 * n) & ((1 << self.level) - 1) == 0;
        if whole(self.left) { Some(Base::Left) } else { whole(self.left + 1).then_some(Base::Right) }
    }

    /// Its two halves.
    pub fn halves(self) -> [Self; 2] {
        [0, 1].map(|half| Self { left: 2 * self.left + half, level: self.level + 1, ..self })
    }
}

/// Cells of time, in all of which the distance from the wall has a positive second derivative.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block {
    /// The first of the cells.
    pub first: i64,
    /// The last of them.
    pub last: i64,
    /// A time, in turns, near which the distance is least.
    pub nearest: Witness<2>,
    /// A lower bound of the second derivative.
    pub curvature: Ball,
    /// Among which times, in turns, the distance is least, whatever the velocity.
    pub contact: Ball,
}

/// How it is shown that motion stays off the wall between impacts: the time of p periods is cut into
/// `p · cells` cells.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Clearance {
    /// Cells in a period.
    pub cells: i64,
    /// In the cells before this one the distance increases.
    pub start: i64,
    /// From this one on it decreases.
    pub end: i64,
    /// In the others it is positive: by its minimum in these blocks, cell by cell elsewhere. First come
    /// those in which motion may touch the wall at the upper of two velocities.
    pub blocks: Vec<Block>,
    /// How many these are.
    pub open: usize,
}

/// What holds for every ν of an interval. `v_GZ` is the velocity up to which motion is admissible,
/// `v_min` that above which it is stable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// `v_min < v_GZ`: stable admissible motion exists in an interval of amplitudes.
    Stable,
    /// No motion in the window is both: `v_GZ < v_min`, or motion becomes stable beyond it.
    None,
    /// It begins or ceases to exist at just one ν (SN-GZ, PD-GZ), or exists for all, and changes at just one where it
    /// ends: the time at which it touches the wall (GZ-GZ), or from contact to period doubling (GZ-PD).
    Point(&'static str),
    /// Nothing is stated, for this reason.
    Undecided(&'static str),
}

/// An interval, what holds in it, and witnesses.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// The interval.
    pub interval: Interval,
    /// What holds in it.
    pub verdict: Verdict,
    /// A velocity below `v_GZ`.
    pub lower: Option<Witness<3>>,
    /// One above `v_GZ`. Without it, stable motion at `lower` is beyond the window or ends below it, or `v_GZ` is
    /// zero.
    pub upper: Option<Witness<3>>,
    /// When motion is beyond the wall at `upper`. Without it, that is beyond the window.
    pub touch: Option<Witness<2>>,
    /// Why it is not at `lower`.
    pub clearance: Option<Clearance>,
}

impl Row {
    /// Without witnesses.
    pub fn new(interval: Interval, verdict: Verdict) -> Self {
        Self { interval, verdict, lower: None, upper: None, touch: None, clearance: None }
    }
}
