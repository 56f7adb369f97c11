//! A row of the certificate: the statement for one interval of ν, with the witnesses by which it can be
//! checked.

use core::fmt;

use crate::ball::Ball;

/// Witnesses are integers in units of 2⁻⁶⁴.
pub const WITNESS_BITS: u32 = 64;

/// A polynomial in `u = ν − m`, where m is the base of the interval, by its coefficients.
pub type Witness<const N: usize> = [i128; N];

/// The position of the base of an interval: the middle or, if a resonance of one loop is there, an end.
/// At such a resonance, stability and contact begin at velocity zero; everything is divided by powers of
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
    /// The number of periods between impacts.
    pub p: i64,
    /// The left end, in units of the width.
    pub left: i64,
    /// The level: the width is `2^-level`.
    pub level: u32,
    /// The position of the base, the origin of witnesses.
    pub base: Base,
}

impl Interval {
    /// The two ends of the interval.
    pub fn ends(self) -> [Ball; 2] {
        [0, 1].map(|end| Ball::dyadic((self.left + end).into(), self.level))
    }

    /// The middle of the interval.
    pub fn middle(self) -> Ball {
        Self { base: Base::Middle, ..self }.origin()
    }

    /// The base of the interval.
    pub fn origin(self) -> Ball {
        Ball::dyadic(i128::from(2 * self.left + self.base as i64), self.level + 1)
    }

    /// The interval extended by a sixteenth of its width at either end, which leaves room for checkers
    /// with coarser bounds.
    pub fn all(self) -> Ball {
        let room = Ball::dyadic(1, self.level + 4);
        let [left, right] = self.ends();
        Ball::between(left - room, right + room)
    }

    /// The end, if any, at which there is a resonance of one loop, where 2ν is an integer.
    pub fn resonance(self) -> Option<Base> {
        let whole = |n: i64| (2 * n) & ((1 << self.level) - 1) == 0;
        if whole(self.left) { Some(Base::Left) } else { whole(self.left + 1).then_some(Base::Right) }
    }

    /// The resonance in the interval, if any, of a number of loops q that divides `p`, and its index:
    /// `ν = n/2` for q = 1, `n + 1/(2q)` for q ≥ 2. There `sin 2πpν = 0`.
    pub fn resonance_within(self) -> Option<[i64; 2]> {
        let (p, scale) = (self.p, 1_i64 << self.level);
        let j = (2 * p * self.left + scale - 1).div_euclid(scale);
        let divisor = (1..=p).rev().find(|&d| p % d == 0 && j % d == 0)?;
        let (q, j) = (p / divisor, j / divisor);
        let within = divisor * j * scale <= 2 * p * (self.left + 1);
        match q {
            _ if !within => None,
            1 => Some([1, j]),
            _ => (j % (2 * q) == 1).then_some([q, j / (2 * q)]),
        }
    }

    /// The two halves of the interval.
    pub fn halves(self) -> [Self; 2] {
        [0, 1].map(|half| Self { left: 2 * self.left + half, level: self.level + 1, ..self })
    }
}

/// Consecutive cells of time, in all of which the distance from the wall has a positive second
/// derivative.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block {
    /// The first of the cells.
    pub first: i64,
    /// The last of the cells.
    pub last: i64,
    /// A time, in turns, near which the distance is least.
    pub nearest: Witness<2>,
    /// A lower bound of the second derivative.
    pub curvature: Ball,
    /// A range of times, in turns, in which the distance is least, for any of the velocities.
    pub contact: Ball,
}

/// The proof that motion does not touch the wall between impacts; the time of p periods is divided into
/// `p · cells` cells.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Clearance {
    /// The number of cells in a period.
    pub cells: i64,
    /// The first cell after those in which the distance increases.
    pub start: i64,
    /// The first of the final cells, in which the distance decreases.
    pub end: i64,
    /// The blocks. In cells from `start` to `end` the distance is positive: by its minimum in these
    /// blocks, cell by cell elsewhere. The blocks in which motion may touch the wall at the upper of two
    /// velocities come first.
    pub blocks: Vec<Block>,
    /// The number of blocks in which motion may touch the wall at the upper velocity.
    pub open: usize,
}

/// Why nothing is proved for an interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// There is a resonance of p loops with index n.
    Resonance {
        /// The number of loops.
        p: i64,
        /// The index.
        n: i64,
    },
    /// Motion touches the wall where it becomes stable.
    Coincidence,
    /// There may be a point, and it may be in the window or beyond it.
    Edge,
    /// The bounds are too wide.
    Width,
    /// The limit on the number of intervals was reached.
    Number,
    /// The run was interrupted.
    Interruption,
}

/// Writes the reason in words, without commas.
impl fmt::Display for Reason {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Resonance { p, n } => {
                return write!(
                    formatter,
                    "the resonance p = {p} and n = {n}: stability begins at velocity zero and so does contact"
                );
            }
            Self::Coincidence => "motion touches the wall where it becomes stable",
            Self::Edge => "there may be a point on the edge of the window",
            Self::Width => "the bounds are too wide",
            Self::Number => "the limit on the number of intervals was reached",
            Self::Interruption => "the run was interrupted",
        })
    }
}

/// The statement that holds for every ν of an interval. `v_GZ` is the velocity up to which motion is
/// admissible, `v_min` the velocity above which it is stable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IntervalVerdict {
    /// `v_min < v_GZ`: stable admissible motion exists in an interval of amplitudes.
    Stable,
    /// No motion in the window is stable and admissible: `v_GZ < v_min`, or motion becomes stable beyond
    /// the window.
    None,
    /// A codimension-two point. Stable admissible motion begins or ceases to exist at exactly one ν
    /// (SN-GZ, PD-GZ); or it exists for all ν, and at exactly one ν its end changes: in the time of
    /// contact with the wall (GZ-GZ), or from contact to period doubling (GZ-PD).
    Point(&'static str),
    /// Stable admissible motion is within the width of a tube of the grazing curve of motion without
    /// impacts, if there is any.
    Thin,
    /// Nothing is proved, for this reason.
    Undecided(Reason),
}

/// An interval with its verdict and witnesses.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CertificateRow {
    /// The interval.
    pub interval: Interval,
    /// The statement that holds in the interval.
    pub verdict: IntervalVerdict,
    /// A velocity below `v_GZ`.
    pub lower: Option<Witness<3>>,
    /// A velocity above `v_GZ`. If it is missing, stable motion at `lower` is beyond the window or ends
    /// below that velocity, or `v_GZ` is zero.
    pub upper: Option<Witness<3>>,
    /// A time at which motion with velocity `upper` is beyond the wall. If it is missing, that motion is
    /// beyond the window.
    pub touch: Option<Witness<2>>,
    /// The proof that motion with velocity `lower` does not touch the wall.
    pub clearance: Option<Clearance>,
}

impl CertificateRow {
    /// A row without witnesses.
    pub fn new(interval: Interval, verdict: IntervalVerdict) -> Self {
        Self { interval, verdict, lower: None, upper: None, touch: None, clearance: None }
    }
}
