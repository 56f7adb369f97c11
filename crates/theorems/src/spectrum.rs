//! The global map to first order, its eigenvalues and iterates, and the non-impacting periodic
//! solution (sections 2.2, 2.3 and 4.2 of the paper).

use nalgebra::{Matrix2, Vector2};

use crate::auxiliary::{lucas_partial_sum, lucas_sequence};
use crate::error::TheoryError;

/// The return map `P_global` at grazing, to first order in the distance from the grazing point and
/// in `mu`.
///
/// `(x, z - z_graz) -> A (x, z - z_graz) + b mu`
///
/// Paper: section 2, eq. (6) to (8), `eq:Pglobal`, `eq:A`, `eq:b`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearisedMap {
    /// `A = D P_global(0, z_graz; 0)`, 2 x 2 in the order (x, z): position, phase in radians.
    pub a: Matrix2<f64>,
    /// `b = d P_global / d mu (0, z_graz; 0)`, in the order (x, z), per unit of mu.
    pub b: Vector2<f64>,
}

impl LinearisedMap {
    /// The trace of `A`.
    ///
    /// `tau = a11 + a22`. Paper: section 2, eq. (9). Dimensionless.
    pub fn trace(&self) -> f64 {
        self.a.trace()
    }

    /// The determinant of `A`.
    ///
    /// `delta = a11 a22 - a12 a21`. Paper: section 2, eq. (9). Dimensionless.
    pub fn determinant(&self) -> f64 {
        self.a.determinant()
    }

    /// The stability multipliers of the grazing orbit when impacts are ignored.
    ///
    /// `lambda_{1,2} = (tau +- sqrt(tau^2 - 4 delta)) / 2`. Paper: section 2, eq. (13), `eq:eigs`.
    ///
    /// The discriminant is taken as `(a11 - a22)^2 + 4 a12 a21`, which keeps its digits near a
    /// double eigenvalue.
    pub fn eigenvalues(&self) -> Eigenvalues {
        let difference = self.a.m11 - self.a.m22;
        let discriminant = difference * difference + 4.0 * self.a.m12 * self.a.m21;
        Eigenvalues::from_discriminant(self.trace(), self.determinant(), discriminant)
    }

    /// The transversality coefficient of the grazing bifurcation: it is non-zero when the
    /// non-impacting periodic solution crosses the wall at a non-zero rate.
    ///
    /// `beta = (1 - a22) b1 + a12 b2`. Paper: section 2, eq. (12), `eq:beta`. Position per unit of
    /// mu.
    pub fn transversality(&self) -> f64 {
        (1.0 - self.a.m22) * self.b.x + self.a.m12 * self.b.y
    }

    /// The characteristic polynomial of `A` at 1.
    ///
    /// `det(I - A) = delta - tau + 1`, the denominator of eq. (11) of section 2,
    /// `eq:xStarzStarDeriv`. Dimensionless; positive when `(tau, delta)` lies in the trapesium.
    pub fn characteristic_polynomial_at_one(&self) -> f64 {
        (1.0 - self.a.m11) * (1.0 - self.a.m22) - self.a.m12 * self.a.m21
    }

    /// How fast the non-impacting periodic solution moves on `Pi` as `mu` varies.
    ///
    /// `d (x*, z*) / d mu (0) = (I - A)^{-1} b`. Paper: section 2, eq. (10), `eq:xStarzStar`.
    ///
    /// # Errors
    /// [`TheoryError::UnitEigenvalue`] when `det(I - A)` is zero or NaN.
    pub fn fixed_point_slope(&self) -> Result<Vector2<f64>, TheoryError> {
        let determinant = self.characteristic_polynomial_at_one();
        if determinant == 0.0 || determinant.is_nan() {
            return Err(TheoryError::UnitEigenvalue { determinant });
        }
        let adjugate_second = self.a.m21 * self.b.x + (1.0 - self.a.m11) * self.b.y;
        Ok(Vector2::new(self.transversality(), adjugate_second) / determinant)
    }

    /// How fast the maximum of the non-impacting periodic solution approaches the wall as `mu`
    /// varies.
    ///
    /// `d x* / d mu (0) = beta / (delta - tau + 1)`. Paper: section 2, eq. (11),
    /// `eq:xStarzStarDeriv`.
    ///
    /// # Errors
    /// [`TheoryError::UnitEigenvalue`] when `det(I - A)` is zero or NaN.
    pub fn fixed_point_position_slope(&self) -> Result<f64, TheoryError> {
        Ok(self.fixed_point_slope()?.x)
    }

    /// The `p`-th iterate of the global map, to first order.
    ///
    /// `A^p = S_{p+1} I + S_p [-a22, a12; a21, -a11]`,
    /// `b_p = S_p b + T_p (beta, a21 b1 + (1 - a11) b2)`.
    ///
    /// Paper: section 4, eq. (10) and (11), `eq:Ap`, `eq:b1pb2p`. `p = 0` gives the identity.
    pub fn iterate(&self, p: u32) -> Self {
        let (tau, delta) = (self.trace(), self.determinant());
        let (s_p, s_next) = (lucas_sequence(p, tau, delta), lucas_sequence(p + 1, tau, delta));
        let t_p = lucas_partial_sum(p, tau, delta);
        let LinearisedMap { a, b } = self;
        let companion = Matrix2::new(-a.m22, a.m12, a.m21, -a.m11);
        let drift = Vector2::new(self.transversality(), a.m21 * b.x + (1.0 - a.m11) * b.y);
        Self { a: Matrix2::identity() * s_next + companion * s_p, b: b * s_p + drift * t_p }
    }
}

/// The eigenvalues of a real 2 x 2 matrix.
///
/// Paper: section 2, eq. (13), `eq:eigs`, and section A, eq. (6), `eq:polarCoords`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Eigenvalues {
    /// Two real eigenvalues, `lambda_1 >= lambda_2`.
    Real {
        /// The larger eigenvalue.
        lambda_1: f64,
        /// The smaller eigenvalue.
        lambda_2: f64,
    },
    /// A complex conjugate pair, `lambda_{1,2} = modulus exp(+- i argument)`.
    ComplexPair {
        /// `r = sqrt(delta)`.
        modulus: f64,
        /// `theta = arccos(tau / (2 sqrt(delta)))`, in (0, pi), radians.
        argument: f64,
    },
}

impl Eigenvalues {
    /// The eigenvalues of a matrix with trace `tau` and determinant `delta`.
    ///
    /// `lambda_{1,2} = (tau +- sqrt(tau^2 - 4 delta)) / 2`. Paper: section 2, eq. (13), `eq:eigs`.
    ///
    /// `tau`, `delta`: dimensionless. With `tau^2 = 4 delta` both real eigenvalues are `tau / 2`.
    pub fn from_trace_and_determinant(tau: f64, delta: f64) -> Self {
        Self::from_discriminant(tau, delta, tau * tau - 4.0 * delta)
    }

    fn from_discriminant(tau: f64, delta: f64, discriminant: f64) -> Self {
        let root = discriminant.abs().sqrt();
        if discriminant < 0.0 {
            return Self::ComplexPair { modulus: delta.sqrt(), argument: libm::atan2(root, tau) };
        }
        // The eigenvalue of larger modulus has no cancellation; the other one follows from the
        // product delta.
        let dominant = 0.5 * if tau < 0.0 { tau - root } else { tau + root };
        let other = if dominant == 0.0 { 0.0 } else { delta / dominant };
        if tau < 0.0 {
            Self::Real { lambda_1: other, lambda_2: dominant }
        } else {
            Self::Real { lambda_1: dominant, lambda_2: other }
        }
    }

    /// The larger modulus of the two eigenvalues.
    pub fn spectral_radius(&self) -> f64 {
        match *self {
            Self::Real { lambda_1, lambda_2 } => lambda_1.abs().max(lambda_2.abs()),
            Self::ComplexPair { modulus, .. } => modulus,
        }
    }
}

/// Whether `(tau, delta)` lies in the trapesium where the grazing orbit is asymptotically stable
/// (impacts ignored) and the global map preserves orientation.
///
/// `T = { 0 < delta < 1, |tau| < delta + 1 }`. Paper: section 2, eq. (14), `eq:cT`.
///
/// `tau`, `delta`: dimensionless. The boundary does not belong to the trapesium; with NaN the
/// answer is no.
pub fn in_trapesium(tau: f64, delta: f64) -> bool {
    0.0 < delta && delta < 1.0 && tau.abs() < delta + 1.0
}
