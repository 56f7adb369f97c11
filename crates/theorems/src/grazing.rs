//! The discontinuity map, the VIVID function and the maximal periodic solutions at a generic
//! grazing bifurcation, to leading order (sections 2.5 and 4 of the paper).

use nalgebra::{Matrix2, Vector2};

use crate::auxiliary::{geometric_sum_determinant, lucas_sequence};
use crate::error::TheoryError;
use crate::spectrum::LinearisedMap;

/// The quantities of a grazing point that enter the theorems.
///
/// Paper: section 2, eq. (6) to (8) for the map and eq. (18), `eq:phipsigamma`, for `phi`, `psi`,
/// `gamma`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrazingPoint {
    /// The global map `P_global`, to first order.
    pub map: LinearisedMap,
    /// The forcing frequency omega, radians per unit of time; positive.
    pub forcing_frequency: f64,
    /// The deceleration at grazing, `gamma = -F(0, 0, z_graz / omega; 0)`; positive on the grazing
    /// set.
    pub gamma: f64,
    /// The coefficient of restitution at zero impact velocity, `phi = Phi(0, z_graz; 0)`,
    /// dimensionless; positive.
    pub phi: f64,
    /// The phase that passes during an impact, per unit of impact velocity, `psi = Psi(0, z_graz;
    /// 0)`.
    pub psi: f64,
}

/// The leading terms of a map from the impacting surface `Sigma`, with coordinates `(y, z)`, to the
/// section `Pi`, with coordinates `(x, z)`: `(y, z) -> (x_coefficient y^2, z + z_coefficient y)`.
///
/// Paper: section 4, eq. (3) and (4), `eq:xHatzHat`, `eq:x0z0`. The errors are of third order in x
/// and of second order in z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VirtualMap {
    /// The coefficient of `y^2` in x.
    pub x_coefficient: f64,
    /// The coefficient of `y` in z.
    pub z_coefficient: f64,
}

impl VirtualMap {
    /// The point `(x, z)` on `Pi`, to leading order, for the velocity `y` and the phase `z`
    /// (radians, any origin) on `Sigma`.
    pub fn apply(&self, y: f64, z: f64) -> Vector2<f64> {
        Vector2::new(self.x_coefficient * y * y, z + self.z_coefficient * y)
    }
}

/// The VIVID function of a `p`-loop maximal periodic solution, to first order at grazing:
/// `V = by_impact (y, z - z_graz) + by_parameter mu`.
///
/// Paper: section 4, eq. (17) and (18), `eq:V1`, `eq:V2`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VividLinearisation {
    /// The matrix `J` of derivatives in `(y_imp, z_imp)`; section 4, eq. (14), `eq:Jac1Jac2`.
    pub by_impact: Matrix2<f64>,
    /// The derivative in `mu`, `(b_1p, b_2p)`: the second column of the matrix `K` of the same
    /// equation.
    pub by_parameter: Vector2<f64>,
}

impl VividLinearisation {
    /// The matrix `K` of derivatives in `(z_imp, mu)`. Paper: section 4, eq. (14), `eq:Jac1Jac2`.
    pub fn by_phase_and_parameter(&self) -> Matrix2<f64> {
        Matrix2::from_columns(&[self.by_impact.column(1).into_owned(), self.by_parameter])
    }
}

impl GrazingPoint {
    /// The factor of the square-root term of the discontinuity map.
    ///
    /// `alpha = 1 + phi - gamma psi / omega`. Paper: section 2, eq. (17), `eq:alpha`.
    /// Dimensionless.
    pub fn alpha(&self) -> f64 {
        1.0 + self.phi - self.gamma * self.psi / self.forcing_frequency
    }

    /// The map `P_virt` from an impact to the virtual maximum beyond the wall, to leading order.
    ///
    /// `x_hat = y^2 / (2 gamma)`, `z_hat = z + omega y / gamma`. Paper: section 4, eq. (3),
    /// `eq:xHatzHat`.
    pub fn virtual_map(&self) -> VirtualMap {
        VirtualMap { x_coefficient: 0.5 / self.gamma, z_coefficient: self.forcing_frequency / self.gamma }
    }

    /// The map `P_virt o R` from an impact to the virtual maximum that precedes the recoil, to
    /// leading order.
    ///
    /// `x^(0) = phi^2 y^2 / (2 gamma)`, `z^(0) = z + omega (1 - alpha) y / gamma`. Paper: section
    /// 4, eq. (4), `eq:x0z0`.
    pub fn virtual_map_after_reset(&self) -> VirtualMap {
        VirtualMap {
            x_coefficient: 0.5 * self.phi * self.phi / self.gamma,
            z_coefficient: self.forcing_frequency * (1.0 - self.alpha()) / self.gamma,
        }
    }

    /// The discontinuity map `P_disc`, to leading order.
    ///
    /// `x^(0) = phi^2 x_hat`, `z^(0) = z_hat - (alpha omega sqrt(2) / sqrt(gamma)) sqrt(x_hat)`.
    /// Paper: section 4, eq. (5) and (6), `eq:Pdisc`.
    ///
    /// `x_hat`: position on `Pi` beyond the wall, not negative (NaN otherwise, because of the
    /// square root); `z_hat`: phase, radians, any origin. Returns `(x^(0), z^(0))`.
    pub fn discontinuity_map(&self, x_hat: f64, z_hat: f64) -> Vector2<f64> {
        let square_root = (2.0 * x_hat / self.gamma).sqrt();
        Vector2::new(self.phi * self.phi * x_hat, z_hat - self.alpha() * self.forcing_frequency * square_root)
    }

    /// The VIVID function of the `p`-loop maximal periodic solution, to first order.
    ///
    /// `V = A^p (x^(0), z^(0)) + b_p mu - (x_hat, z_hat)`. Paper: section 4, eq. (13), (17) and
    /// (18), `eq:V`, `eq:V1`, `eq:V2`.
    pub fn vivid_linearisation(&self, p: u32) -> VividLinearisation {
        let LinearisedMap { a, b } = self.map.iterate(p);
        let shift = self.forcing_frequency / self.gamma;
        let after_reset = 1.0 - self.alpha();
        VividLinearisation {
            by_impact: Matrix2::new(
                shift * after_reset * a.m12,
                a.m12,
                shift * (after_reset * a.m22 - 1.0),
                a.m22 - 1.0,
            ),
            by_parameter: b,
        }
    }

    /// The determinant of the derivative of the VIVID function in the impact velocity and the
    /// impact phase.
    ///
    /// `det(J) = alpha a12 omega S_p / gamma`. Paper: section 4, eq. (15), `eq:detJac1detJac2`. It
    /// vanishes at a resonance.
    pub fn impact_jacobian_determinant(&self, p: u32) -> f64 {
        let s_p = lucas_sequence(p, self.map.trace(), self.map.determinant());
        self.alpha() * self.map.a.m12 * self.forcing_frequency * s_p / self.gamma
    }

    /// The determinant of the derivative of the VIVID function in the impact phase and `mu`.
    ///
    /// `det(K) = (1 - S_{p+1} + a11 S_p) b_1p + a12 S_p b_2p`. Paper: section 4, eq. (15),
    /// `eq:detJac1detJac2`.
    ///
    /// By eq. (10), `eq:Ap`, this is the transversality coefficient of the `p`-th iterate.
    pub fn parameter_jacobian_determinant(&self, p: u32) -> f64 {
        self.map.iterate(p).transversality()
    }

    /// The determinant `det(K)` as the product of `beta` and a factor that is positive in the
    /// trapesium.
    ///
    /// `det(K) = beta (1 - lambda_1^p) (1 - lambda_2^p) / ((1 - lambda_1) (1 - lambda_2))`. Paper:
    /// section 4, eq. (16), `eq:detJac2`; here also valid for `tau = delta + 1`.
    pub fn parameter_jacobian_determinant_factored(&self, p: u32) -> f64 {
        self.map.transversality() * geometric_sum_determinant(p, self.map.trace(), self.map.determinant())
    }

    /// The `p`-loop maximal periodic solution that emanates from a generic grazing bifurcation, to
    /// first order in `mu`.
    ///
    /// `y* = gamma det(K) mu / (alpha a12 omega S_p)`,
    /// `z* = z_graz + (((S_{p+1} - a11 S_p) (1 - alpha) - 1) b_1p - a12 S_p (1 - alpha) b_2p) mu
    ///       / (alpha a12 S_p)`.
    ///
    /// Paper: section 4, eq. (21) and (22), `eq:yStarpcodim1proof`, `eq:zStarpcodim1proof`; for
    /// `p = 1` eq. (19) and (20), `eq:yStar1codim1proof`, `eq:zStar1codim1proof`.
    ///
    /// # Errors
    /// [`TheoryError::TooFewLoops`] when `p = 0`; [`TheoryError::SingularVividJacobian`] when
    /// `det(J)` is zero (resonance, or `alpha = 0`) or NaN.
    pub fn emerging_orbit(&self, p: u32) -> Result<EmergingOrbit, TheoryError> {
        if p == 0 {
            return Err(TheoryError::TooFewLoops { loops: p, minimum: 1 });
        }
        let determinant = self.impact_jacobian_determinant(p);
        if determinant == 0.0 || determinant.is_nan() {
            return Err(TheoryError::SingularVividJacobian { determinant });
        }
        let LinearisedMap { a, b } = self.map.iterate(p);
        let alpha = self.alpha();
        let after_reset = 1.0 - alpha;
        Ok(EmergingOrbit {
            map: self.map,
            loops: p,
            impact_velocity_slope: self.parameter_jacobian_determinant(p) / determinant,
            impact_phase_slope: ((a.m22 * after_reset - 1.0) * b.x - a.m12 * after_reset * b.y)
                / (alpha * a.m12),
        })
    }
}

/// The first-order terms in `mu` of a `p`-loop maximal periodic solution near a generic grazing
/// bifurcation.
///
/// Computed by [`GrazingPoint::emerging_orbit`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EmergingOrbit {
    map: LinearisedMap,
    /// The number of loops, p.
    pub loops: u32,
    /// `d y* / d mu (0)`: impact velocity per unit of mu.
    pub impact_velocity_slope: f64,
    /// `d z* / d mu (0)`: impact phase, radians per unit of mu.
    pub impact_phase_slope: f64,
}

impl EmergingOrbit {
    /// The velocity of the `j`-th visit to `Pi` as `mu` varies, `d (x^(j), z^(j)) / d mu (0)`.
    ///
    /// `A^j (0, -b_1p / (a12 S_p)) + b_j`; its first component is `(beta / S_p) u^(j)`.
    ///
    /// Paper: section 4, eq. (27) and (29), `eq:ujwj`, `eq:affineMapj`; ends in eq. (23) to (26),
    /// `eq:x0codim1proof`, `eq:z0codim1proof`, `eq:xpcodim1proof`, `eq:zpcodim1proof`.
    ///
    /// `j` from 0 (just after the impact) to `p` (just before the next one); positions at both ends
    /// are of second order.
    pub fn visit_slope(&self, j: u32) -> Vector2<f64> {
        let last = self.map.iterate(self.loops);
        let start = Vector2::new(0.0, -last.b.x / last.a.m12);
        let LinearisedMap { a, b } = self.map.iterate(j);
        a * start + b
    }
}
