//! Number types with which a force can be evaluated: plain numbers, jets, time series, intervals.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// Sum, difference and negative of an array of numbers, entry by entry.
macro_rules! entrywise {
    ([$($generics:tt)*] $type:ty) => {
        impl<$($generics)*> core::ops::Add for $type {
            type Output = Self;

            #[inline(always)]
            #[allow(clippy::assign_op_pattern, reason = "not every entry has assigning operators")]
            fn add(mut self, other: Self) -> Self {
                for (a, b) in self.0.iter_mut().zip(other.0) {
                    *a = *a + b;
                }
                self
            }
        }

        impl<$($generics)*> core::ops::Sub for $type {
            type Output = Self;

            #[inline(always)]
            #[allow(clippy::assign_op_pattern, reason = "not every entry has assigning operators")]
            fn sub(mut self, other: Self) -> Self {
                for (a, b) in self.0.iter_mut().zip(other.0) {
                    *a = *a - b;
                }
                self
            }
        }

        impl<$($generics)*> core::ops::Neg for $type {
            type Output = Self;

            #[inline(always)]
            fn neg(mut self) -> Self {
                for a in &mut self.0 {
                    *a = -*a;
                }
                self
            }
        }
    };
}
pub(crate) use entrywise;

/// Arithmetic of a [`Scalar`] with plain numbers on its right.
macro_rules! with_plain_numbers {
    ([$($generics:tt)*] $type:ty) => {
        impl<$($generics)*> core::ops::Add<f64> for $type {
            type Output = Self;

            #[inline]
            fn add(self, other: f64) -> Self {
                self + <Self as $crate::scalar::Scalar>::constant(other)
            }
        }

        impl<$($generics)*> core::ops::Sub<f64> for $type {
            type Output = Self;

            #[inline]
            fn sub(self, other: f64) -> Self {
                self - <Self as $crate::scalar::Scalar>::constant(other)
            }
        }

        impl<$($generics)*> core::ops::Mul<f64> for $type {
            type Output = Self;

            #[inline]
            fn mul(self, factor: f64) -> Self {
                $crate::scalar::Scalar::scale(self, factor)
            }
        }

        impl<$($generics)*> core::ops::Div<f64> for $type {
            type Output = Self;

            #[inline]
            fn div(self, divisor: f64) -> Self {
                self / <Self as $crate::scalar::Scalar>::constant(divisor)
            }
        }
    };
}
pub(crate) use with_plain_numbers;

/// A smooth function of one variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Hyperbolic tangent.
    Tanh,
    /// Arc tangent.
    Atan,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Square root.
    Sqrt,
}

impl Function {
    /// All functions.
    pub const ALL: [Self; 8] =
        [Self::Sin, Self::Cos, Self::Tan, Self::Tanh, Self::Atan, Self::Exp, Self::Ln, Self::Sqrt];

    /// The function's value and first and second derivative at a number of any type.
    #[inline]
    pub(crate) fn derivatives<S: Scalar>(self, x: S) -> [S; 3] {
        let value = x.apply(self);
        match self {
            Self::Sin => [value, x.apply(Self::Cos), -value],
            Self::Cos => [value, -x.apply(Self::Sin), -value],
            Self::Tan => {
                let slope = value.square() + 1.0;
                [value, slope, value.scale(2.0) * slope]
            }
            Self::Tanh => {
                let slope = -value.square() + 1.0;
                [value, slope, value.scale(-2.0) * slope]
            }
            Self::Atan => {
                let slope = S::constant(1.0) / (x.square() + 1.0);
                [value, slope, x.scale(-2.0) * slope * slope]
            }
            Self::Exp => [value; 3],
            Self::Ln => [value, S::constant(1.0) / x, S::constant(-1.0) / x.square()],
            Self::Sqrt => [value, S::constant(0.5) / value, S::constant(-0.25) / (value * x)],
        }
    }
}

/// A number in an expression; plain numbers may stand on its right, as in `x * x - 1.0`.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// A constant.
    fn constant(value: f64) -> Self;

    /// The function of this number.
    fn apply(self, function: Function) -> Self;

    /// The number times a plain one.
    #[inline]
    fn scale(self, factor: f64) -> Self {
        self * Self::constant(factor)
    }

    /// The sum with a multiple of another number.
    #[inline]
    fn plus(self, factor: f64, other: &Self) -> Self {
        self + other.scale(factor)
    }

    /// The square; for an interval it is tighter than the product with itself.
    #[inline]
    fn square(self) -> Self {
        self * self
    }

    /// The sine.
    fn sin(self) -> Self {
        self.apply(Function::Sin)
    }

    /// The cosine.
    fn cos(self) -> Self {
        self.apply(Function::Cos)
    }

    /// The exponential.
    fn exp(self) -> Self {
        self.apply(Function::Exp)
    }

    /// The square root.
    fn sqrt(self) -> Self {
        self.apply(Function::Sqrt)
    }

    /// A whole power, by squaring; negative ones through the reciprocal.
    fn power(self, exponent: i32) -> Self {
        if exponent < 0 {
            return Self::constant(1.0) / self.power(-exponent);
        }
        match exponent {
            0 => Self::constant(1.0),
            1 => self,
            even if even % 2 == 0 => self.power(even / 2).square(),
            odd => self.power(odd - 1) * self,
        }
    }
}

/// A number whose functions come with their derivatives, as the coefficients of a series need.
pub(crate) trait SeriesCoefficient: Scalar {
    /// The function with its first and second derivative.
    fn derivatives(self, function: Function) -> [Self; 3];
}

impl Scalar for f64 {
    #[inline]
    fn constant(value: f64) -> Self {
        value
    }

    #[inline]
    fn apply(self, function: Function) -> Self {
        match function {
            Function::Sin => libm::sin(self),
            Function::Cos => libm::cos(self),
            Function::Tan => libm::tan(self),
            Function::Tanh => libm::tanh(self),
            Function::Atan => libm::atan(self),
            Function::Exp => libm::exp(self),
            Function::Ln => libm::log(self),
            Function::Sqrt => self.sqrt(),
        }
    }
}

impl SeriesCoefficient for f64 {
    /// NaN outside the domain.
    #[inline]
    fn derivatives(self, function: Function) -> [Self; 3] {
        match function {
            // `sincos` computes both at once.
            Function::Sin | Function::Cos => {
                let (sin, cos) = libm::sincos(self);
                if function == Function::Sin { [sin, cos, -sin] } else { [cos, -sin, -cos] }
            }
            function => function.derivatives(self),
        }
    }
}
