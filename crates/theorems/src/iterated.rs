//! Solutions of more loops at a one-loop resonance, to leading order. Not in the paper.
//!
//! At a resonance of p = 1 the entry a₁₂ of A is zero, and with it that of every iterate A^k: det J
//! (section 4, eq. (15), `eq:detJac1detJac2`) vanishes for every number of loops, so that MPSs of
//! every k may leave the resonance together with those of one loop. Theorem 2.5 leaves this case
//! out. Impact velocity y and phase are of order η, positions and μ of order η².
//!
//! Such an MPS has k loops of P_global and one impact: it is a one-loop MPS of P_global^k, whose
//! a₁₂ vanishes at the same place. So Theorem 2.4 describes it with the quantities of the iterate
//! ([`IteratedResonance::point`]),
//!
//! ```text
//! A^k,   b_k,   a12' (a11^k - a22^k) / (a11 - a22),   xi_k,
//! ```
//!
//! as far as curves and stability go. The iterate does not include the wall: the MPS must not reach
//! it at the visits x⁽ʲ⁾ to Π, 0 < j < k. To leading order these are
//!
//! ```text
//! theta_0 = -alpha omega y / ((1 - a22^k) gamma),     theta_(j+1) = a22 theta_j,
//! x_0 = phi^2 y^2 / (2 gamma),   x_(j+1) = a11 x_j + a12' eta theta_j + xi theta_j^2 / 2 + b1 mu,
//! ```
//!
//! where theta is the phase less z_graz(η), and μ = k₂ y² + k₃ η y on the branch: each x⁽ʲ⁾ is y
//! times a linear form in y and η ([`VisitHeight`]). Stability is a pair of such forms as well. So
//! on either side of η the stable, admissible MPSs of k loops, if there are any, are those with
//! y/|η| in one interval ([`IteratedResonance::emerging`]), bounded by curves that all leave the
//! resonance, tangent to the grazing curve: between them lies a region, however thin.
//!
//! # Closed forms
//!
//! Scale as in [`limit_map`](crate::limit_map): y = hY, x = h²X/(2γ), μ = h²M/(2γb₁), with r = aφ²
//! and phases V after the recoil; impacts have mY > 0, m = sgn h. Between impacts V goes on to dV
//! and X to aX + kV² + 2V + M.
//!
//! *Two loops, any oscillator.* V = −Y/(1 − d²), and X₂ = Y² eliminates M:
//!
//! ```text
//! X₁ = Y (s₁⁻Y − 2)/((1 + a)(1 + d)).
//! ```
//!
//! So where s₁⁻ > 0 **two-loop MPSs are admissible on the side of the one-loop PD curve alone, up to twice the impact
//! velocity on it**. There the visit touches, and the MPS is the grazing period-doubled one: its GZ curve is that of
//! c_2GZ ([`doubled_grazing_coefficient`](ResonantPoint::doubled_grazing_coefficient)). They are stable from αω(a + d)a₁₂'/s₂^∓ on: on
//! that side the PD curve bounds them if a + d > 0, the SN curve if not.
//!
//! *Any k, linear oscillator.* a = d = σ, and for the k-th iterate σ is replaced by σᵏ and h by
//! kσᵏ⁻¹h:
//!
//! ```text
//! V = −Y/(1 − σᵏ),   M = (1 − σ)/(1 − σᵏ)² ((1 + εσᵏ)² Y² + 2kσᵏ⁻¹ Y),
//! Y_SN = −kσᵏ⁻¹/(1 + εσᵏ)²,   Y_PD = kσᵏ⁻¹/(1 − εσᵏ)²,
//! X_j = (A − εB)² Y² + 2 C Y,   A = (1 − σʲ)/(1 − σᵏ),   B = 1 − A,
//! C = (kσᵏ⁻¹(1 − σʲ) − jσʲ⁻¹(1 − σᵏ))/(1 − σᵏ)².
//! ```
//!
//! X_j begins at ε²Y² for j = 0 and ends at Y² for j = k. The MPS is admissible if mC < 0 and |Y| < 2|C|/(A − εB)² for all j, 0 < j <
//! k, and stable beyond Y_PD where mσᵏ⁻¹ > 0, beyond Y_SN where not. Let ε ≤ 1.
//!
//! - **k = 2: always, on the side m = 1.** C = −1/(1 + σ)², so that |Y| < 2/(1 − σε)². With u² = |σ| the stable ones begin below
//!   that, since 1 − εσ² > u(1 − εσ) by (1 − u)(1 + εu³) for σ > 0, and 1 + εσ² > u(1 − εσ) by (1 − u)(1 − εu³) for σ < 0. The
//!   region of σ < 0 is M_GZ − M_SN = 4(1 + ε²σ³)²/((1 − σ)(1 − εσ)⁴(1 + εσ²)²) wide.
//! - **σ < 0, k ≥ 3: never.** Let s = |σ|. For odd k, C > 0 at j = 2; and j = 1 needs 2(1 + sᵏ) < ksᵏ⁻¹(1 − s²), which is less than 2. For
//!   even k, C < 0 at j = 1, and C > 0 at j = 2, since (1 − sᵏ)/(1 − s²) = 1 + s² + … + sᵏ⁻² ≥ ½k s^(k/2−1).
//! - **σ > 0, k ≥ 3: on the side m = 1, from the PD curve to where the last visit touches, exactly if**
//!
//! ```text
//! kσ (1 − (1 + ε)σᵏ⁻¹ + εσᵏ)² < 2 (1 − εσᵏ)² (k − 1 − kσ + σᵏ).
//! ```
//!
//!   C < 0, as j/(σ⁻ʲ − 1) decreases. X_j/Y is a convex function of σʲ: its first terms are a square and a linear one, the
//!   last is a multiple of σʲ log σʲ; so j = 1 or k − 1 touches first. It is k − 1: 1 − (1 + ε)σᵏ⁻¹ + εσᵏ ≥ |1 − σ − ε(σ − σᵏ)|, and
//!   C is no larger there, since 1 − σ²ᵏ⁻² ≥ (k − 1)σᵏ⁻²(1 − σ²) as above.
//!
//! For large k that is σ < 2/3; regions of k and k + 1 overlap if σ < 1/4, by M_PD ≈ 3(1 − σ)k²σ²ᵏ⁻² and M_GZ ≈ 4(1 − σ)²k²σ²ᵏ⁻⁴: the
//! period-adding cascade of the square-root map of one variable.

use crate::generic_theorem::Side;
use crate::grazing::GrazingPoint;
use crate::spectrum::LinearisedMap;
use crate::unfolding::{ResonantPoint, Unfolding};
use nalgebra::{Matrix2, Vector2};

/// The position of a visit to Π divided by the impact velocity, to leading order: a linear form in
/// impact velocity and η. The visit lies before the wall where it is negative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VisitHeight {
    /// The coefficient of y.
    pub by_velocity: f64,
    /// The coefficient of η.
    pub by_eta: f64,
}

/// The event at which the stable, admissible MPSs that leave a resonance end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EndEvent {
    /// A saddle-node bifurcation.
    SaddleNode,
    /// A multiplier of −1.
    PeriodDoubling,
    /// The visit of this number touches the wall.
    Visit(u32),
}

/// An end of an interval of impact velocities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VelocityBound {
    /// The event at this end.
    pub boundary: EndEvent,
    /// The impact velocity at this end per unit of η; it has the sign of the side of η.
    pub velocity_slope: f64,
}

/// The stable, admissible k-loop MPSs on one side of η: those with an impact velocity between the
/// bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EmergingSolutions {
    /// The sign of η.
    pub side: Side,
    /// The least impact velocity.
    pub slowest: VelocityBound,
    /// The greatest impact velocity; `None` where faster solutions are stable and admissible to
    /// leading order.
    pub fastest: Option<VelocityBound>,
}

/// The k-loop MPSs at a one-loop resonance.
#[derive(Debug, Clone, PartialEq)]
pub struct IteratedResonance {
    loops: u32,
    point: ResonantPoint,
    visits: Vec<VisitHeight>,
}

impl IteratedResonance {
    /// The k = `loops` ≥ 1 loop MPSs near the one-loop resonance `resonance`, to leading order; a₁₂
    /// = 0 is not checked.
    pub fn new(resonance: &ResonantPoint, loops: u32) -> Self {
        let GrazingPoint { map, forcing_frequency, gamma, phi, .. } = resonance.grazing;
        let (a11, a22) = (map.a.m11, map.a.m22);
        let (slope, curvature) = (resonance.unfolding.derivative, resonance.second_phase_derivative);
        // Derivatives of x of the iterate by phase and η, and twice by phase; a₂₂^j.
        let (mut mixed, mut second, mut power) = (0.0, 0.0, 1.0);
        for _ in 0..loops {
            mixed = a11 * mixed + slope * power;
            second = a11 * second + curvature * power * power;
            power *= a22;
        }
        let point = ResonantPoint {
            grazing: GrazingPoint { map: map.iterate(loops), ..resonance.grazing },
            second_phase_derivative: second,
            unfolding: Unfolding { loops: 1, derivative: mixed },
        };
        let branch = point.branch_expansion();
        let mut phase = -resonance.grazing.alpha() * forcing_frequency / ((1.0 - power) * gamma);
        let mut height = VisitHeight { by_velocity: 0.5 * phi * phi / gamma, by_eta: 0.0 };
        let mut visits = Vec::new();
        for _ in 1..loops {
            height = VisitHeight {
                by_velocity: a11 * height.by_velocity
                    + 0.5 * curvature * phase * phase
                    + map.b.x * branch.k_2,
                by_eta: a11 * height.by_eta + slope * phase + map.b.x * branch.k_3,
            };
            phase *= a22;
            visits.push(height);
        }
        Self { loops, point, visits }
    }

    /// The k-loop MPSs of a linear oscillator with this σ and ε, in the scales of the limit map:
    /// velocities per η are Y, parameters per η² are M, and the sign of η is m.
    pub fn of_linear_oscillator(loops: u32, sigma: f64, epsilon: f64) -> Self {
        let map = LinearisedMap { a: Matrix2::from_diagonal_element(sigma), b: Vector2::new(0.5, 0.0) };
        let grazing = GrazingPoint { map, forcing_frequency: 1.0, gamma: 1.0, phi: epsilon, psi: 0.0 };
        let resonance = ResonantPoint {
            grazing,
            second_phase_derivative: -sigma * (1.0 - sigma),
            unfolding: Unfolding { loops: 1, derivative: 1.0 / (1.0 + epsilon) },
        };
        Self::new(&resonance, loops)
    }

    /// The number k of loops.
    pub fn loops(&self) -> u32 {
        self.loops
    }

    /// The resonance as a one-loop resonance of the k-th iterate of P_global, to which Theorem 2.4
    /// applies.
    pub fn point(&self) -> &ResonantPoint {
        &self.point
    }

    /// The heights of the visits x⁽ʲ⁾, 0 < j < k, in order.
    pub fn visits(&self) -> &[VisitHeight] {
        &self.visits
    }

    /// The quadratic coefficient of the curve along which a bound holds.
    pub fn coefficient(&self, bound: &VelocityBound) -> f64 {
        self.point.branch_expansion().parameter(bound.velocity_slope, 1.0)
    }

    /// The stable, admissible MPSs, for either side of η on which there are some.
    ///
    /// In terms of V = y/|η|, they satisfy s⁺V < ±αω a₁₂', s⁻V > ±αω a₁₂' (section 5, after
    /// `eq:Upsilon1`, with the quantities of the iterate), and all visits lie before the wall. As V
    /// tends to zero one of the first two conditions fails, so that there is a least velocity.
    /// Empty where b₁ = 0, or for a map that is not contracting.
    pub fn emerging(&self) -> Vec<EmergingSolutions> {
        let contracting = self.point.grazing.map.determinant().abs() < 1.0;
        let sides = [Side::Negative, Side::Positive].into_iter();
        sides.filter(|_| contracting).filter_map(|side| self.emerging_to(side)).collect()
    }

    fn emerging_to(&self, side: Side) -> Option<EmergingSolutions> {
        let stability = self.point.stability_coefficients();
        let grazing = &self.point.grazing;
        let turn = grazing.alpha() * grazing.forcing_frequency * self.point.off_diagonal_slope();
        // Linear forms in V and the sign of η that are positive where the condition holds.
        let stable = [
            (EndEvent::SaddleNode, -stability.plus, turn),
            (EndEvent::PeriodDoubling, stability.minus, -turn),
        ];
        let visits = (1..).zip(&self.visits);
        let before_the_wall =
            visits.map(|(number, visit)| (EndEvent::Visit(number), -visit.by_velocity, -visit.by_eta));
        let (mut slowest, mut fastest): (Option<VelocityBound>, Option<VelocityBound>) = (None, None);
        for (boundary, by_velocity, by_eta) in stable.into_iter().chain(before_the_wall) {
            let bound = VelocityBound { boundary, velocity_slope: -by_eta / by_velocity };
            let velocity = bound.velocity_slope * side.signum();
            if velocity.is_nan() {
                return None;
            }
            let faster = |known: &VelocityBound| known.velocity_slope.abs() > velocity;
            match (by_velocity > 0.0, velocity > 0.0) {
                // The condition holds at all velocities.
                (true, false) => {}
                (true, true) => slowest = Some(slowest.filter(faster).unwrap_or(bound)),
                (false, true) => fastest = Some(fastest.filter(|known| !faster(known)).unwrap_or(bound)),
                // The condition holds at no velocity.
                (false, false) => return None,
            }
        }
        let slowest = slowest?;
        let is_interval =
            fastest.is_none_or(|fastest| fastest.velocity_slope.abs() > slowest.velocity_slope.abs());
        is_interval.then_some(EmergingSolutions { side, slowest, fastest })
    }
}

/// The right-hand side minus the left-hand side of the condition on which stable, admissible MPSs
/// of k = `loops` ≥ 2 loops leave the resonances with σ > 0 of a linear oscillator with 0 < ε ≤ 1:
/// 2(1 − εσᵏ)²(k − 1 − kσ + σᵏ) − kσ(1 − (1 + ε)σᵏ⁻¹ + εσᵏ)².
pub fn last_visit_margin(loops: u32, sigma: f64, epsilon: f64) -> f64 {
    let k = f64::from(loops);
    let before = libm::pow(sigma, k - 1.0);
    let power = before * sigma;
    let [room, reach] = [1.0 - epsilon * power, 1.0 - (1.0 + epsilon) * before + epsilon * power];
    2.0 * room * room * (k - 1.0 - k * sigma + power) - k * sigma * reach * reach
}
