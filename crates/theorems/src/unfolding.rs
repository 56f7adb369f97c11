//! The coefficients of the saddle-node and period-doubling curves that emanate from a resonant
//! grazing bifurcation (sections 2.6 and 5 of the paper).

use core::f64::consts::PI;

use crate::auxiliary::{lucas_partial_sum, modulus_power};
use crate::grazing::GrazingPoint;

/// The type of a resonance, and how fast the second parameter `eta` moves the system through it.
///
/// The derivatives are total derivatives along the curve of grazing bifurcations: the grazing phase
/// `z_graz` varies with `eta` and is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unfolding {
    /// The number of loops, p.
    pub loops: u32,
    /// For `p = 1`, where `a12 = 0`: `a12' = d a12 / d eta`; section 2.6, before eq. (21). For
    /// `p >= 2`, where `kappa_p = tau - g_p(delta) = 0`: `kappa_p' = d kappa_p / d eta`; section
    /// 2.6, before eq. (25).
    pub derivative: f64,
}

/// A resonant grazing bifurcation and the quantities that unfold it.
///
/// The methods evaluate the formulas of the paper as printed and check nothing; the hypotheses
/// under which they are meaningful are checked by
/// [`ResonantGrazing`](crate::resonant_theorem::ResonantGrazing). Where a denominator is zero
/// (`s^+- = 0`, `beta = 0`) the result is infinite or NaN.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResonantPoint {
    /// The grazing point at `(mu, eta) = (0, 0)`.
    pub grazing: GrazingPoint,
    /// `xi_p = d^2 P_global,1^p / d z^2` at the grazing point; section 2, eq. (19), `eq:xi`.
    /// Position per radian squared.
    pub second_phase_derivative: f64,
    /// The type of the resonance, and its derivative in `eta`.
    pub unfolding: Unfolding,
}

/// The coefficients `s_p^+` and `s_p^-` of the impact velocity in `y (T -+ D -+ 1)`.
///
/// Paper: section 2, eq. (20) and (24), `eq:c1`, `eq:cp`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StabilityCoefficients {
    /// `s_p^+`: belongs to the stability multiplier 1 and so to the saddle-node curve.
    pub plus: f64,
    /// `s_p^-`: belongs to the stability multiplier -1 and so to the period-doubling curve.
    pub minus: f64,
}

/// The leading terms of the branch of maximal periodic solutions near a resonance, parametrised by
/// the impact velocity: `z = z_graz(eta) + k_1 y`, `mu = k_2 y^2 + k_3 eta y`.
///
/// Paper: section 5, eq. (15), `eq:ZM`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BranchExpansion {
    /// `k_1`: impact phase per unit of impact velocity.
    pub k_1: f64,
    /// `k_2`: the coefficient of `y^2` in mu.
    pub k_2: f64,
    /// `k_3`: the coefficient of `eta y` in mu.
    pub k_3: f64,
}

impl BranchExpansion {
    /// The value of mu on the branch, to second order: `mu = k_2 y^2 + k_3 eta y`.
    pub fn parameter(&self, impact_velocity: f64, eta: f64) -> f64 {
        (self.k_2 * impact_velocity + self.k_3 * eta) * impact_velocity
    }
}

impl ResonantPoint {
    /// The number of loops, p.
    pub fn loops(&self) -> u32 {
        self.unfolding.loops
    }

    /// The derivative in `eta` of the (1, 2) entry of `A^p`.
    ///
    /// `f_1 = a12'`; `f_p = a12 p delta^{p/2 - 1} kappa_p' / (2 sin^2(pi / p))` for `p >= 2`.
    /// Paper: section 5, eq. (8), `eq:fp`.
    ///
    /// This is the total derivative along the grazing curve. The paper introduces `f_p` as the
    /// partial derivative `d^2 P_global,1^p / (d z d eta)` at fixed `z`, which differs from it by
    /// `xi_p d z_graz / d eta`; eq. (8) and all that follows from it hold for the total one.
    pub fn off_diagonal_slope(&self) -> f64 {
        let Unfolding { loops, derivative } = self.unfolding;
        if loops == 1 {
            return derivative;
        }
        let map = &self.grazing.map;
        let p = f64::from(loops);
        let sine = libm::sin(PI / p);
        let power = libm::pow(map.determinant(), 0.5 * p - 1.0);
        map.a.m12 * p * power * derivative / (2.0 * sine * sine)
    }

    /// The coefficients of the impact velocity in the conditions for stability multipliers 1
    /// and -1.
    ///
    /// `s_1^+- = (1 -+ a22) (a11 phi^2 -+ 1) + alpha^2 omega^2 xi_1 / ((1 - a22) gamma)`,
    /// `s_p^+- = (1 +- delta^{p/2}) (-delta^{p/2} phi^2 -+ 1)
    ///           + alpha^2 omega^2 xi_p / ((1 + delta^{p/2}) gamma)`.
    ///
    /// Paper: section 2, eq. (20) and (24), `eq:c1`, `eq:cp`.
    pub fn stability_coefficients(&self) -> StabilityCoefficients {
        let GrazingPoint { map, forcing_frequency, gamma, phi, .. } = self.grazing;
        let alpha_omega = self.grazing.alpha() * forcing_frequency;
        let curvature = alpha_omega * alpha_omega * self.second_phase_derivative / gamma;
        if self.loops() == 1 {
            let (a11, a22) = (map.a.m11, map.a.m22);
            let common = curvature / (1.0 - a22);
            return StabilityCoefficients {
                plus: (1.0 - a22) * (a11 * phi * phi - 1.0) + common,
                minus: (1.0 + a22) * (a11 * phi * phi + 1.0) + common,
            };
        }
        let power = modulus_power(self.loops(), map.determinant());
        let common = curvature / (1.0 + power);
        StabilityCoefficients {
            plus: (1.0 + power) * (-power * phi * phi - 1.0) + common,
            minus: (1.0 - power) * (-power * phi * phi + 1.0) + common,
        }
    }

    /// The quadratic coefficient of the saddle-node curve, `mu = c_SN eta^2 + O(eta^3)`.
    ///
    /// `c_SN,1 = (alpha omega a12')^2 / (2 beta gamma s_1^+)`,
    /// `c_SN,p = (p a12 alpha omega delta^{p/2-1} kappa_p' / (2 sin^2(pi/p) (1 + delta^{p/2})))^2
    ///           (delta - tau + 1) / (2 beta gamma s_p^+)`.
    ///
    /// Paper: section 2, eq. (21) and (25), `eq:coeffs1`, `eq:coeffsp`.
    pub fn saddle_node_coefficient(&self) -> f64 {
        let GrazingPoint { map, forcing_frequency, gamma, .. } = self.grazing;
        let slope = self.grazing.alpha() * forcing_frequency * self.off_diagonal_slope();
        let denominator = 2.0 * map.transversality() * gamma * self.stability_coefficients().plus;
        if self.loops() == 1 {
            return slope * slope / denominator;
        }
        let scaled = slope / (1.0 + modulus_power(self.loops(), map.determinant()));
        scaled * scaled * map.characteristic_polynomial_at_one() / denominator
    }

    /// The quadratic coefficient of the curve where a stability multiplier is -1,
    /// `mu = c_PD eta^2 + O(eta^3)`.
    ///
    /// `c_PD,p = (s_p^+ / s_p^-) (2 - s_p^+ / s_p^-) c_SN,p`. Paper: section 2, eq. (21) and (25),
    /// `eq:coeffs1`, `eq:coeffsp`.
    pub fn period_doubling_coefficient(&self) -> f64 {
        let StabilityCoefficients { plus, minus } = self.stability_coefficients();
        let ratio = plus / minus;
        ratio * (2.0 - ratio) * self.saddle_node_coefficient()
    }

    /// The leading terms of the branch of maximal periodic solutions, parametrised by impact
    /// velocity.
    ///
    /// For `p = 1`: `k_1 = omega (a22 (1 - alpha) - 1) / ((1 - a22) gamma)`,
    /// `k_2 = -s_1^+ / (2 (1 - a22) b_1 gamma)`,
    /// `k_3 = alpha omega a12' / ((1 - a22) b_1 gamma)`.
    /// For `p >= 2`: `k_1 = -omega (1 + delta^{p/2} (1 - alpha)) / ((1 + delta^{p/2}) gamma)`,
    /// `k_2 = -s_p^+ / (2 (1 + delta^{p/2}) beta gamma T_p)`,
    /// `k_3 = alpha omega f_p / ((1 + delta^{p/2}) beta gamma T_p)`.
    ///
    /// Paper: section 5, eq. (17) and (21), `eq:k1231`, `eq:k123p`.
    pub fn branch_expansion(&self) -> BranchExpansion {
        let GrazingPoint { map, forcing_frequency, gamma, .. } = self.grazing;
        let alpha = self.grazing.alpha();
        // The (2, 2) entry of A^p, and the determinant det(K).
        let (entry, determinant) = match self.loops() {
            1 => (map.a.m22, (1.0 - map.a.m22) * map.b.x),
            loops => {
                let power = modulus_power(loops, map.determinant());
                let t_p = lucas_partial_sum(loops, map.trace(), map.determinant());
                (-power, (1.0 + power) * map.transversality() * t_p)
            }
        };
        BranchExpansion {
            k_1: forcing_frequency * (entry * (1.0 - alpha) - 1.0) / ((1.0 - entry) * gamma),
            k_2: -self.stability_coefficients().plus / (2.0 * determinant * gamma),
            k_3: alpha * forcing_frequency * self.off_diagonal_slope() / (determinant * gamma),
        }
    }

    /// The impact velocity on the saddle-node curve per unit of `eta`.
    ///
    /// `d Upsilon^+ / d eta (0) = alpha omega f_p / s_p^+`. Paper: section 5, eq. (19) and (22),
    /// `eq:Upsilon1`, `eq:Upsilonp`.
    pub fn saddle_node_velocity_slope(&self) -> f64 {
        self.velocity_slope(self.stability_coefficients().plus)
    }

    /// The impact velocity on the period-doubling curve per unit of `eta`.
    ///
    /// `d Upsilon^- / d eta (0) = alpha omega f_p / s_p^-`. Paper: section 5, eq. (19) and (22),
    /// `eq:Upsilon1`, `eq:Upsilonp`.
    pub fn period_doubling_velocity_slope(&self) -> f64 {
        self.velocity_slope(self.stability_coefficients().minus)
    }

    fn velocity_slope(&self, stability_coefficient: f64) -> f64 {
        self.grazing.alpha() * self.grazing.forcing_frequency * self.off_diagonal_slope()
            / stability_coefficient
    }
}
