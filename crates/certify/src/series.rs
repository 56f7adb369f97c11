//! Numbers of which the closed forms are made: `f64` to steer by, balls, and Taylor polynomials with
//! balls for coefficients.

use core::ops::{Add, Mul, Neg, Sub};

use crate::ball::Ball;

/// What the closed forms need of a number.
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

impl Number for Ball {
    fn inverse(self) -> Self {
        self.inverse()
    }

    fn exp(self) -> Self {
        self.exp()
    }

    fn turn(self) -> (Self, Self) {
        self.turn()
    }
}

/// Terms of a [`Series`].
pub const TERMS: usize = 4;

/// The Taylor coefficients `f(ν)`, `f'(ν)`, `f''(ν)/2` and `f'''(ν)/6` of a function of ν.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Series(pub [Ball; TERMS]);

impl Series {
    /// The variable itself.
    pub fn variable(at: Ball) -> Self {
        Self([at, Ball::ONE, Ball::ZERO, Ball::ZERO])
    }

    /// `Σ a_k b_(n−k)` for k from `first` to n.
    fn convolution(&self, other: &Self, n: usize, first: usize) -> Ball {
        (first..=n).fold(Ball::ZERO, |sum, k| sum + self.0[k] * other.0[n - k])
    }

    /// `k a_k`: the derivative, times the variable.
    fn scaled_derivative(&self) -> Self {
        Self(core::array::from_fn(|k| Ball::from(k as i64) * self.0[k]))
    }

    /// Series that solve `n y_n = Σ k x_k z_(n−k)`, k from 1 to n.
    fn solved<const M: usize>(
        &self,
        mut solution: [Self; M],
        right: impl Fn(&[Self; M], usize) -> Self,
    ) -> [Self; M] {
        let slope = self.scaled_derivative();
        for n in 1..TERMS {
            let over_n = Ball::ratio(1, n as i64);
            for which in 0..M {
                solution[which].0[n] = over_n * slope.convolution(&right(&solution, which), n, 1);
            }
        }
        solution
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
        Self(core::array::from_fn(|n| self.convolution(&other, n, 0)))
    }
}

impl Number for Series {
    fn inverse(self) -> Self {
        let first = self.0[0].inverse();
        let mut inverse = Self::from(first);
        for n in 1..TERMS {
            inverse.0[n] = -(first * self.convolution(&inverse, n, 1));
        }
        inverse
    }

    fn exp(self) -> Self {
        let [exponential] = self.solved([Self::from(self.0[0].exp())], |[exponential], _| *exponential);
        exponential
    }

    fn turn(self) -> (Self, Self) {
        let (sine, cosine) = self.0[0].turn();
        let angle = self * Self::from(Ball::PI + Ball::PI);
        let [sine, cosine] =
            angle.solved(
                [sine.into(), cosine.into()],
                |[sine, cosine], which| if which == 0 { *cosine } else { -*sine },
            );
        (sine, cosine)
    }
}
