//! Intervals of real numbers as integers: a midpoint and a radius, in units of 2⁻⁹⁶.
//!
//! Every operation returns a ball that contains the results for all numbers of its arguments. There
//! is no rounding mode and no floating point in what is proved. A result that does not fit is the
//! ball of all real numbers, [`Ball::ANY`], of which nothing can be shown.

use core::ops::{Add, Mul, Neg, Sub};

/// Binary digits after the point.
const BITS: u32 = 96;
const ONE: u128 = 1 << BITS;
const LOW: u128 = u64::MAX as u128;
/// Midpoints and radii stay below this.
const LIMIT: u128 = 1 << 126;

/// All real numbers within `radius` of `middle`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ball {
    middle: i128,
    radius: u128,
}

/// `⌊a b / 2⁹⁶⌋`, and whether that is not exact; nothing if it does not fit.
fn product(a: u128, b: u128) -> Option<(u128, bool)> {
    let (a1, a0, b1, b0) = (a >> 64, a & LOW, b >> 64, b & LOW);
    let (bottom, first, second) = (a0 * b0, a1 * b0, a0 * b1);
    let middle = (bottom >> 64) + (first & LOW) + (second & LOW);
    let low = (middle << 64) | (bottom & LOW);
    let high = a1 * b1 + (first >> 64) + (second >> 64) + (middle >> 64);
    let fits = high >> (BITS - 2) == 0;
    fits.then_some(((high << (128 - BITS)) | (low >> BITS), low & (ONE - 1) != 0))
}

/// `⌈a b / 2⁹⁶⌉`.
fn product_up(a: u128, b: u128) -> Option<u128> {
    product(a, b).map(|(product, inexact)| product + u128::from(inexact))
}

/// `arctan(1/n)` in units of 2⁻¹²⁰, to within one unit for each of its terms, of which there are
/// fewer than 60.
const fn inverse_tangent(n: i128) -> i128 {
    let (mut power, mut sum, mut k) = ((1 << 120) / n, 0, 0);
    while power != 0 {
        let term = power / (2 * k + 1);
        sum += if k % 2 == 0 { term } else { -term };
        power /= n * n;
        k += 1;
    }
    sum
}

impl Ball {
    /// Zero.
    pub const ZERO: Self = Self { middle: 0, radius: 0 };
    /// One.
    pub const ONE: Self = Self { middle: ONE as i128, radius: 0 };
    /// 1 + 2⁻¹².
    pub const A_LITTLE_ABOVE_ONE: Self = Self { middle: (ONE + (ONE >> 12)) as i128, radius: 0 };
    /// Of which nothing is known.
    pub const ANY: Self = Self { middle: 0, radius: u128::MAX };
    /// π = 16 arctan(1/5) − 4 arctan(1/239).
    pub const PI: Self =
        Self { middle: (16 * inverse_tangent(5) - 4 * inverse_tangent(239)) >> (120 - BITS), radius: 2 };

    fn new(middle: Option<i128>, radius: Option<u128>) -> Self {
        match (middle, radius) {
            (Some(middle), Some(radius)) if middle.unsigned_abs() < LIMIT && radius < LIMIT => {
                Self { middle, radius }
            }
            _ => Self::ANY,
        }
    }

    /// `n / 2^level`: exactly that if `level` is at most 96.
    pub fn dyadic(n: i128, level: u32) -> Self {
        match BITS.checked_sub(level) {
            Some(shift) if n.unsigned_abs() < LIMIT >> shift => Self { middle: n << shift, radius: 0 },
            Some(_) => Self::ANY,
            None => Self::new(Some(n >> (level - BITS).min(127)), Some(1)),
        }
    }

    /// `n / d`, for a positive d, to within one unit.
    pub fn ratio(n: i64, d: i64) -> Self {
        let (n, d) = (i128::from(n), i128::from(d));
        let rest = n.rem_euclid(d) << 64;
        let last = (rest % d) << (BITS - 64);
        let fraction = ((rest / d) << (BITS - 64)) + last / d;
        let exact = Self::dyadic(n.div_euclid(d), 0) + Self { middle: fraction, radius: 0 };
        exact.widened(Some(u128::from(last % d != 0)))
    }

    /// All numbers of two balls, and between them.
    pub fn between(a: Self, b: Self) -> Self {
        let lower = a.lower().zip(b.lower()).map(|(a, b)| a.min(b));
        let upper = a.upper().zip(b.upper()).map(|(a, b)| a.max(b));
        let middle = lower.zip(upper).and_then(|(lower, upper)| Some(lower.checked_add(upper)? >> 1));
        let radius = middle.zip(upper).map(|(middle, upper)| upper.abs_diff(middle) + 1);
        Self::new(middle, radius)
    }

    /// Middle and radius in units of 2⁻⁹⁶; nothing for all numbers.
    pub fn units(self) -> Option<(i128, u128)> {
        self.known().then_some((self.middle, self.radius))
    }

    /// The number nearest to the middle, to steer by.
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

    fn lower(self) -> Option<i128> {
        self.known().then(|| self.middle - self.radius as i128)
    }

    fn upper(self) -> Option<i128> {
        self.known().then(|| self.middle + self.radius as i128)
    }

    /// Whether all its numbers are positive.
    pub fn is_positive(self) -> bool {
        self.lower().is_some_and(|lower| lower > 0)
    }

    /// Whether all its numbers are negative.
    pub fn is_negative(self) -> bool {
        (-self).is_positive()
    }

    /// Whether zero is none of them.
    pub fn is_not_zero(self) -> bool {
        self.is_positive() || self.is_negative()
    }

    /// Whether all numbers of `other` lie in it.
    pub fn contains(self, other: Self) -> bool {
        let within = |(a, b): (i128, i128), (c, d)| a <= c && d <= b;
        match (self.lower().zip(self.upper()), other.lower().zip(other.upper())) {
            (None, _) => true,
            (Some(outer), Some(inner)) => within(outer, inner),
            (Some(_), None) => false,
        }
    }

    /// The ball around zero of all numbers no greater in size.
    pub fn size(self) -> Self {
        Self::new(Some(0), self.known().then(|| self.middle.unsigned_abs() + self.radius))
    }

    /// The greatest of its numbers.
    pub fn top(self) -> Self {
        Self::new(self.upper(), Some(0))
    }

    /// The least of its numbers.
    pub fn bottom(self) -> Self {
        Self::new(self.lower(), Some(0))
    }

    /// Around its middle, with this radius more.
    fn widened(self, more: Option<u128>) -> Self {
        Self::new(Some(self.middle), more.and_then(|more| self.radius.checked_add(more)))
    }

    fn middle(self) -> Self {
        Self { middle: self.middle, radius: 0 }
    }

    /// Divided by a positive integer.
    fn over(self, n: i128) -> Self {
        if !self.known() {
            return self;
        }
        let inexact = u128::from(self.middle % n != 0);
        Self { middle: self.middle / n, radius: self.radius.div_ceil(n as u128) + inexact }
    }

    /// `1/x`. With `y` near it and `e = 1 − x y`, `|e| ≤ 1/2`: `1/x = y/(1 − e)`, and
    /// `|1/x − y| ≤ |y| |e| (1 + 2 |e|)`.
    pub fn inverse(self) -> Self {
        let guess = libm::scalbn(1.0 / self.to_f64(), BITS as i32);
        if !(self.known() && guess.abs() < LIMIT as f64) {
            return Self::ANY;
        }
        let guess = Self::new(Some(guess as i128), Some(0));
        let closer = (guess + guess * (Self::ONE - self.middle() * guess)).middle();
        let error = (Self::ONE - self * closer).size();
        if !error.known() || error.radius > ONE / 2 {
            return Self::ANY;
        }
        let bound = closer.size() * error * (Self::ONE + error + error);
        closer.widened(bound.known().then_some(bound.radius))
    }

    /// `√x`. With `y` near it, `|√x − y| ≤ |x − y²| / y`.
    pub fn sqrt(self) -> Self {
        let root = libm::scalbn(self.to_f64().sqrt(), BITS as i32);
        if !self.is_positive() || root < 1.0 {
            return Self::ANY;
        }
        let guess = Self::new(Some(root as i128), Some(0));
        let closer = (guess + self.middle() * guess.inverse()).over(2).middle();
        let bound = (self - closer * closer).size() * closer.inverse().size();
        closer.widened(bound.known().then_some(bound.radius))
    }

    /// `eˣ`, for `|x| ≤ 32`: the series at `x/2⁸`, squared eight times. A radius `r ≤ 1` of `x` is a
    /// factor within `2 r` of one.
    pub fn exp(self) -> Self {
        if !self.known() || self.middle.unsigned_abs() > 32 * ONE || self.radius > ONE {
            return Self::ANY;
        }
        let small = self.middle().over(256);
        // What is left out is less than (1/8)¹⁸/18! < 2⁻¹⁰⁶.
        let mut sum = Self::ONE;
        for n in (1..18).rev() {
            sum = Self::ONE + (small * sum).over(n);
        }
        sum = sum.widened(Some(1));
        for _ in 0..8 {
            sum = sum * sum;
        }
        if self.radius == 0 { sum } else { sum * Self::ONE.widened(Some(2 * self.radius)) }
    }

    /// `sin(2πx)` and `cos(2πx)`: whole turns and quarters are taken off exactly.
    pub fn turn(self) -> (Self, Self) {
        let all = Self { middle: 0, radius: ONE };
        if !self.known() || self.radius > ONE / 4 {
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
        let more = Some(7 * self.radius);
        (sine.widened(more), cosine.widened(more))
    }

    /// Sine and cosine by their series: the angle is at most π/4, and what is left out less than
    /// (π/4)²⁸/28! < 2⁻¹⁰⁷.
    fn within_an_eighth(self) -> (Self, Self) {
        let angle = (self + self) * Self::PI;
        let square = angle * angle;
        let (mut sine, mut cosine) = (Self::ONE, Self::ONE);
        for n in (1..14).rev() {
            cosine = Self::ONE - (square * cosine).over((2 * n - 1) * 2 * n);
            sine = Self::ONE - (square * sine).over(2 * n * (2 * n + 1));
        }
        ((angle * sine).widened(Some(1)), cosine.widened(Some(1)))
    }
}

impl From<i64> for Ball {
    fn from(n: i64) -> Self {
        Self::dyadic(n.into(), 0)
    }
}

impl From<f64> for Ball {
    /// The rational number that it is.
    fn from(x: f64) -> Self {
        let (fraction, exponent) = libm::frexp(x);
        if !x.is_finite() || exponent > 38 {
            return Self::ANY;
        }
        Self::dyadic(libm::scalbn(fraction, 53) as i128, (53 - exponent) as u32)
    }
}

impl Neg for Ball {
    type Output = Self;

    fn neg(self) -> Self {
        Self { middle: -self.middle, radius: self.radius }
    }
}

impl Add for Ball {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.middle.checked_add(other.middle), self.radius.checked_add(other.radius))
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
        let multiplied = || {
            let (middle, inexact) = product(a, b)?;
            let radius = product_up(a, other.radius)?
                .checked_add(product_up(self.radius, b.checked_add(other.radius)?)?)?;
            Some((middle as i128 * sign, radius + u128::from(inexact)))
        };
        multiplied().map_or(Self::ANY, |(middle, radius)| Self::new(Some(middle), Some(radius)))
    }
}

/// All its decimal digits that are certain, twenty significant ones at most.
impl core::fmt::Display for Ball {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Some((lower, upper)) = self.lower().zip(self.upper()) else { return formatter.write_str("?") };
        if (lower < 0) != (upper < 0) {
            return formatter.write_str("?");
        }
        let digits = |end: i128| {
            let (whole, mut rest) =
                ((end.unsigned_abs() >> BITS).to_string(), end.unsigned_abs() & (ONE - 1));
            let mut text = format!("{whole}.");
            for _ in 0..26 {
                rest *= 10;
                text.push(char::from(b'0' + (rest >> BITS) as u8));
                rest &= ONE - 1;
            }
            text
        };
        let (lower_digits, upper_digits) = (digits(lower), digits(upper));
        if lower_digits.find('.') != upper_digits.find('.') {
            return formatter.write_str("?");
        }
        let same = lower_digits.bytes().zip(upper_digits.bytes()).take_while(|(a, b)| a == b).count();
        let leading = lower_digits.bytes().take_while(|byte| matches!(byte, b'0' | b'.')).count();
        let point = usize::from(leading == 0);
        let shown = lower_digits.get(..same.min(leading + 20 + point)).unwrap_or_default();
        write!(formatter, "{}{shown}", if lower < 0 { "-" } else { "" })
    }
}
