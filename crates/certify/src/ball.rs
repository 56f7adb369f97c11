//! Intervals of real numbers as integers: a midpoint and a radius, in units of 2⁻⁸⁸.
//!
//! Every operation returns a ball that contains the results for all numbers of its arguments. Proofs use
//! no rounding modes and no floating point. A result that does not fit becomes the ball of all real
//! numbers, [`Ball::ANY`], about which nothing can be proved.

use core::ops::{Add, Mul, Neg, Sub};

/// Binary digits after the point.
const BITS: u32 = 88;
const ONE: u128 = 1 << BITS;
/// Midpoints and radii are less than this, in units of 2⁻⁸⁸.
const LIMIT: u128 = 1 << 126;

/// All real numbers within `radius` of `middle`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ball {
    middle: i128,
    radius: u128,
}

/// The operations on numbers that the closed forms need.
pub trait Number:
    Copy + From<Ball> + Neg<Output = Self> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// `1/x`.
    fn inverse(self) -> Self;
    /// `eˣ`.
    fn exp(self) -> Self;
    /// `sin(2πx)` and `cos(2πx)`.
    fn turn(self) -> (Self, Self);
}

/// `⌊a b / 2⁸⁸⌋` and `⌈a b / 2⁸⁸⌉`; if these do not fit, 0 and the greatest integer.
fn product(a: u128, b: u128) -> (u128, u128) {
    let (low, high) = a.carrying_mul(b, 0);
    if high >> (BITS - 2) != 0 {
        return (0, u128::MAX);
    }
    let floor = (high << (128 - BITS)) | (low >> BITS);
    (floor, floor + u128::from(low & (ONE - 1) != 0))
}

impl Ball {
    /// Zero.
    pub const ZERO: Self = Self { middle: 0, radius: 0 };
    /// One.
    pub const ONE: Self = Self { middle: ONE as i128, radius: 0 };
    /// The ball of all real numbers, about which nothing is known.
    pub const ANY: Self = Self { middle: 0, radius: u128::MAX };
    /// π, from its first 22 hexadecimal digits after the point.
    pub const PI: Self = Self { middle: 0x0324_3F6A_8885_A308_D313_198A, radius: 1 };

    fn new(middle: i128, radius: u128) -> Self {
        if middle.unsigned_abs() < LIMIT && radius < LIMIT { Self { middle, radius } } else { Self::ANY }
    }

    /// `n / 2^level`, exactly; the level is at most 88.
    pub fn dyadic(n: i128, level: u32) -> Self {
        n.checked_mul(1 << (BITS - level)).map_or(Self::ANY, |middle| Self::new(middle, 0))
    }

    /// `n / d`, for a positive d, to within one unit.
    pub fn ratio(n: i64, d: i64) -> Self {
        let (n, d) = (i128::from(n), i128::from(d));
        // In two steps, neither of which overflows.
        let first = n.rem_euclid(d) << (BITS / 2);
        let second = (first % d) << (BITS / 2);
        let fraction = ((first / d) << (BITS / 2)) + second / d;
        Self::dyadic(n.div_euclid(d), 0) + Self { middle: fraction, radius: u128::from(second % d != 0) }
    }

    /// The smallest ball that contains both balls.
    pub fn between(a: Self, b: Self) -> Self {
        let (lower, upper) = (a.lower().min(b.lower()), a.upper().max(b.upper()));
        let middle = (lower + upper) >> 1;
        Self::new(middle, upper.abs_diff(middle) + 1)
    }

    /// Middle and radius in units of 2⁻⁸⁸; nothing for the ball of all numbers.
    pub fn units(self) -> Option<(i128, u128)> {
        self.known().then_some((self.middle, self.radius))
    }

    /// The number nearest to the middle, for searches and guesses.
    pub fn to_f64(self) -> f64 {
        libm::scalbn(self.middle as f64, -(BITS as i32))
    }

    /// The radius, rounded up by a part in 2⁵⁰.
    pub fn radius(self) -> f64 {
        libm::scalbn(self.radius as f64 * (1.0 + 1e-15), -(BITS as i32))
    }

    fn known(self) -> bool {
        self.radius != u128::MAX
    }

    fn lower(self) -> i128 {
        self.middle.saturating_sub_unsigned(self.radius)
    }

    fn upper(self) -> i128 {
        self.middle.saturating_add_unsigned(self.radius)
    }

    /// Whether all numbers of the ball are positive.
    pub fn is_positive(self) -> bool {
        self.lower() > 0
    }

    /// Whether all numbers of the ball are negative.
    pub fn is_negative(self) -> bool {
        self.upper() < 0
    }

    /// Whether all numbers of `other` lie in the ball.
    pub fn contains(self, other: Self) -> bool {
        self.lower() <= other.lower() && other.upper() <= self.upper()
    }

    /// The ball around zero of all numbers no greater in absolute value than those of this ball.
    pub fn size(self) -> Self {
        Self::new(0, self.radius.saturating_add(self.middle.unsigned_abs()))
    }

    /// The greatest number of the ball.
    pub fn top(self) -> Self {
        Self::new(self.upper(), 0)
    }

    /// The least number of the ball.
    pub fn bottom(self) -> Self {
        Self::new(self.lower(), 0)
    }

    /// The ball with its radius increased by `more` units.
    fn widened(self, more: u128) -> Self {
        Self::new(self.middle, self.radius.saturating_add(more))
    }

    fn middle(self) -> Self {
        Self { middle: self.middle, radius: 0 }
    }

    /// The ball divided by a positive integer.
    fn over(self, n: i128) -> Self {
        let inexact = u128::from(self.middle % n != 0);
        if self.known() {
            Self { middle: self.middle / n, radius: self.radius.div_ceil(n as u128) + inexact }
        } else {
            Self::ANY
        }
    }

    /// `√x`. For `y` near it, `|√x − y| ≤ |x − y²| / y`.
    pub fn sqrt(self) -> Self {
        if !self.is_positive() {
            return Self::ANY;
        }
        let guess = Self::from(self.to_f64().sqrt()).middle();
        let closer = (guess + self.middle() * guess.inverse()).over(2).middle();
        closer.widened(((self - closer * closer).size() * closer.inverse().size()).radius)
    }

    /// Sine and cosine by their series: the angle is at most π/4, and the remainder is less than
    /// (π/4)²⁸/28! < 2⁻¹⁰⁷.
    fn within_an_eighth(self) -> (Self, Self) {
        let angle = (self + self) * Self::PI;
        let square = angle * angle;
        let series = |first: i128| {
            let factor = |n: i128| (2 * n - 1 + first) * (2 * n + first);
            let next = |sum, n| Self::ONE - (square * sum).over(factor(n));
            (1..14).rev().fold(Self::ONE, next).widened(1)
        };
        (angle * series(1), series(0))
    }
}

impl Number for Ball {
    /// `1/x`. For `y` near it and `e = 1 − x y` with `|e| ≤ 1/2`: `1/x = y/(1 − e)`, and
    /// `|1/x − y| ≤ |y| |e| (1 + 2 |e|)`.
    fn inverse(self) -> Self {
        let guess = Self::from(1.0 / self.to_f64()).middle();
        let closer = (guess + guess * (Self::ONE - self.middle() * guess)).middle();
        let error = (Self::ONE - self * closer).size();
        if error.radius > ONE / 2 {
            return Self::ANY;
        }
        closer.widened((closer.size() * error * (Self::ONE + error + error)).radius)
    }

    /// `eˣ` for `−64 ≤ x ≤ 32`: the series at `x/2⁸`, squared eight times. A radius `r ≤ 1` of `x`
    /// contributes a factor within `2 r` of one. Below, it is less than one unit, as e⁻⁶² < 2⁻⁸⁸.
    fn exp(self) -> Self {
        if self.known() && self.upper() < -62 * ONE as i128 {
            return Self::ZERO.widened(1);
        }
        if self.middle > 32 * ONE as i128 || self.radius > ONE {
            return Self::ANY;
        }
        let small = self.middle().over(256);
        let series = (1..18).rev().fold(Self::ONE, |sum, n| Self::ONE + (small * sum).over(n));
        // The remainder is less than (1/4)¹⁸/18! < 2⁻⁸⁸.
        let power = (0..8).fold(series.widened(1), |power, _| power * power);
        power * Self::ONE.widened(2 * self.radius)
    }

    /// `sin(2πx)` and `cos(2πx)`: whole and quarter turns are subtracted exactly.
    fn turn(self) -> (Self, Self) {
        let all = Self { middle: 0, radius: ONE };
        if self.radius > ONE / 4 {
            return (all, all);
        }
        let quarters = (self.middle + (ONE / 8) as i128) >> (BITS - 2);
        let rest = Self { middle: self.middle - (quarters << (BITS - 2)), radius: 0 };
        let (sine, cosine) =
            if rest == Self::ZERO { (Self::ZERO, Self::ONE) } else { rest.within_an_eighth() };
        let (sine, cosine) = match quarters & 3 {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        };
        // 2π < 7.
        (sine.widened(7 * self.radius), cosine.widened(7 * self.radius))
    }
}

impl From<i64> for Ball {
    fn from(n: i64) -> Self {
        Self::dyadic(n.into(), 0)
    }
}

impl From<f64> for Ball {
    /// The ball of this number: exact, or to within one unit if it has more digits.
    fn from(x: f64) -> Self {
        let units = libm::scalbn(x, BITS as i32);
        if units.abs() < LIMIT as f64 {
            Self { middle: units as i128, radius: u128::from(units % 1.0 != 0.0) }
        } else {
            Self::ANY
        }
    }
}

impl Neg for Ball {
    type Output = Self;

    fn neg(self) -> Self {
        Self { middle: -self.middle, ..self }
    }
}

impl Add for Ball {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.middle + other.middle, self.radius.saturating_add(other.radius))
    }
}

impl Sub for Ball {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Ball {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self == Self::ZERO || other == Self::ZERO {
            return Self::ZERO;
        }
        if !(self.known() && other.known()) {
            return Self::ANY;
        }
        let (a, b) = (self.middle.unsigned_abs(), other.middle.unsigned_abs());
        let sign = (self.middle ^ other.middle).signum() | 1;
        let (floor, ceiling) = product(a, b);
        let by_radii = [product(a, other.radius), product(self.radius, b + other.radius)];
        let radius = by_radii.into_iter().fold(ceiling - floor, |sum, (_, up)| sum.saturating_add(up));
        Self::new(sign * floor as i128, radius)
    }
}

/// Units of 2⁻⁸⁸ as a decimal number, with leading zeros so that all have equal length.
fn decimal(units: u128) -> String {
    let mut rest = units;
    let places = (0..26).map(|_| {
        rest = 10 * (rest & (ONE - 1));
        char::from(b'0' + (rest >> BITS) as u8)
    });
    format!("{:012}.{}", units >> BITS, places.collect::<String>())
}

/// Writes the decimal digits that are certain, at most twenty significant ones.
impl core::fmt::Display for Ball {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let [lower, upper] = [self.lower(), self.upper()].map(|end| decimal(end.unsigned_abs()));
        let same = lower.bytes().zip(upper.bytes()).take_while(|(a, b)| a == b).count();
        let (certain, point) = (&lower[..same], lower.find('.').unwrap_or_default());
        if same <= point || (self.lower() < 0) != (self.upper() < 0) {
            return formatter.write_str("?");
        }
        let leading = certain.bytes().take_while(|byte| matches!(byte, b'0' | b'.')).count();
        let end = same.min(leading + 20 + usize::from(leading < point));
        let sign = if self.is_negative() { "-" } else { "" };
        write!(formatter, "{sign}{}", &certain[leading.min(point - 1)..end])
    }
}
