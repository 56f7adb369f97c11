//! Numbers other than balls of which the closed forms are made: `f64`, to steer by, and Taylor
//! polynomials with balls for coefficients.

use core::ops::{Add, Mul, Neg, Sub};

use crate::ball::{Ball, Number};

impl From<Ball> for f64 {
    fn from(x: Ball) -> Self {
        x.to_f64()
    }
}

impl Number for f64 {
    fn inverse(self) -> Self {
        1.0 / self
    }

    fn exp(self) -> Self {
        libm::exp(self)
    }

    fn turn(self) -> (Self, Self) {
        // Whole turns are taken off exactly, and quarters are exact.
        let rest = self - libm::rint(self);
        libm::sincos(2.0 * core::f64::consts::PI * rest)
    }
}

/// The Taylor coefficients `f(x)`, `f'(x)`, `f''(x)/2` and `f'''(x)/6` of a function.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Series(pub [Ball; 4]);

impl Series {
    /// The variable itself.
    pub fn variable(at: Ball) -> Self {
        Self([at, Ball::ONE, Ball::ZERO, Ball::ZERO])
    }

    /// From a value and the first derivatives.
    pub fn of_derivatives([value, first, second, third]: [Ball; 4]) -> Self {
        Self([value, first, Ball::ratio(1, 2) * second, Ball::ratio(1, 6) * third])
    }

    /// The function of this one that has this Taylor series where this begins.
    fn composed(self, outer: Self) -> Self {
        let [_, first, second, third] = self.0;
        let rest = Self([Ball::ZERO, first, second, third]);
        outer.0.into_iter().rev().fold(Ball::ZERO.into(), |sum, term| sum * rest + term.into())
    }

    /// A polynomial that is the function all over an interval, for some number of the ball that is its
    /// last coefficient (Taylor): from the coefficients at one place, and all over the interval.
    pub fn with_remainder(self, over_all: Self) -> Self {
        let ([first, second, third, _], [.., last]) = (self.0, over_all.0);
        Self([first, second, third, last])
    }

    /// The derivative of a polynomial.
    pub fn derivative(self) -> Self {
        let [_, first, second, third] = self.0;
        Self([first, Ball::from(2) * second, Ball::from(3) * third, Ball::ZERO])
    }

    /// A polynomial divided by a power of its variable; of any value unless that is exact.
    pub fn divided(mut self, power: usize) -> Self {
        let exact = self.0[..power].iter().all(|&coefficient| coefficient == Ball::ZERO);
        self.0.rotate_left(power);
        if exact { self } else { Ball::ANY.into() }
    }

    /// The values of a polynomial.
    pub fn values(self, variable: Ball) -> Ball {
        self.0.into_iter().rev().fold(Ball::ZERO, |sum, coefficient| coefficient + variable * sum)
    }
}

impl From<Ball> for Series {
    fn from(x: Ball) -> Self {
        Self([x, Ball::ZERO, Ball::ZERO, Ball::ZERO])
    }
}

impl Neg for Series {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(Ball::neg))
    }
}

impl Add for Series {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(core::array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl Sub for Series {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Series {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let terms = |n: usize| (0..=n).map(move |k| self.0[k] * other.0[n - k]);
        Self(core::array::from_fn(|n| terms(n).fold(Ball::ZERO, Ball::add)))
    }
}

impl Number for Series {
    fn inverse(self) -> Self {
        let first = Self::from(self.0[0].inverse());
        first * (self * first).composed(Self([Ball::ONE, -Ball::ONE, Ball::ONE, -Ball::ONE]))
    }

    fn exp(self) -> Self {
        self.composed(Self::of_derivatives([self.0[0].exp(); 4]))
    }

    fn turn(self) -> (Self, Self) {
        let (sine, cosine) = self.0[0].turn();
        let angle = self * Self::from(Ball::PI + Ball::PI);
        (
            angle.composed(Self::of_derivatives([sine, cosine, -sine, -cosine])),
            angle.composed(Self::of_derivatives([cosine, -sine, -cosine, sine])),
        )
    }
}
