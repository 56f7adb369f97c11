//! The limit map at a resonance: all motion near it with one impact in every p periods. Not in the
//! paper.
//!
//! # Derivation
//!
//! An orbit is followed from impact to impact. Let y be the impact velocity and w = z⁽⁰⁾ − z_graz,η
//! the phase of the virtual maximum before the recoil (Fig. 9 of the paper). Section 5 describes
//! the p loops if y, w and η are of one order and x⁽⁰⁾, μ of its square:
//!
//! 1. x⁽⁰⁾ = φ² y²/(2γ), by `eq:x0z0`.
//! 2. x⁽ᵖ⁾ = a x⁽⁰⁾ + b₁ₚ μ + f_p η w + ½ ξ_p w² and z⁽ᵖ⁾ = z_graz,η + d w, by `eq:codim21proof1` and
//!    `eq:codim21proofp`, but for terms of one order more. Here a and d are the diagonal entries of
//!    Aᵖ at the resonance, where its upper right one is zero: a₁₁ and a₂₂ for p = 1, −δ^{p/2} both
//!    for p ≥ 2 (`eq:DPglobalp`); b₁ₚ is b₁, and T_p β for p ≥ 2; f₁ = a₁₂', and f_p is in `eq:fp`.
//! 3. The next impact is at y' with x⁽ᵖ⁾ = y'²/(2γ), and at z' with z⁽ᵖ⁾ = z' + ωy'/γ, by
//!    `eq:xHatzHat`. So y'² = 2γ x⁽ᵖ⁾.
//! 4. After it, by `eq:x0z0`, w' = z' − z_graz,η + ω(1 − α)y'/γ = d w − αωy'/γ.
//!
//! Now let h = αω f_p η, and scale y = h Y, w = (αω/γ) h V, μ = h²/(2γ b₁ₚ) M ([`LimitScale`]).
//! With r = aφ² and k = α²ω² ξ_p/γ all else cancels:
//!
//! ```text
//! Y'² = r Y² + k V² + 2 V + M,     V' = d V − Y'.
//! ```
//!
//! This is the limit map ([`LimitMap`]); the system's own map differs from it by at most a constant
//! times η while velocities stay away from 0. The side of the resonance, m = sgn h, is in Y:
//! impacts have m Y > 0. (Scaled with |h|, impacts have Y > 0 on both sides, and 2V becomes 2mV.)
//!
//! **Admissibility**, to leading order. The map holds as long as Y'² > 0, or else the wall is not
//! reached after p loops; and for p ≥ 2 as long as the visits in between stay before the wall: x⁽ʲ⁾
//! = a₁₂ S_j w + O(η²) by `eq:admp9`, with S_j > 0, so all do as long as m V < 0, as a₁₂α > 0. For
//! p = 1 there are no visits in between; motion that misses the wall goes on by line 2 with x⁽¹⁾
//! instead of x⁽⁰⁾ and may come back: with x = h²/(2γ) X at visits, X' = aX₀ + kV² + 2V + M, where
//! X₀ = X and V goes on to dV as long as X < 0, and X₀ = φ²X and V is less by Y = m√X where X > 0.
//!
//! **The linear oscillator** has a = d = σ, σ = −E_p but for p = 1 and even n, where σ = E₁; γ = ω²,
//! α = 1 + ε, ξ_p = σ² − σ by `eq:xi1proof2` and `eq:xipproof2`. So it has two numbers, σ and ε: r =
//! σε², k = −σ(1 − σ)(1 + ε)². Also f_p = −2πpσ/ω. With the impact phase θ = (1 + ε)V + εY the map is
//! Y'² = σ²u² − 2σθu + σθ² + 2u/(1 + ε) + M, θ' = σu − Y', u = θ − εY.
//!
//! # What follows
//!
//! Y' = dV − V', so that the orbits are those of one relation of second degree between three
//! successive phases. Periodic orbits of up to two impacts are in closed form:
//!
//! *One impact.* V = −Y/(1 − d), M = (2Y − s⁺Y²)/(1 − d) with s^± of `eq:c1`, `eq:cp`, trace r + d +
//! k/(1 − d) − 1/Y and determinant rd of the derivative. Multiplier ±1: Y = 1/s^±, which is
//! `eq:Upsilon1`, `eq:Upsilonp`. M is of second degree in Y with the coefficient −s⁺/(1 − d), so that
//! **saddle-nodes never degenerate** where s⁺ ≠ 0.
//!
//! *Two impacts*, with phases V₁, V₂ = v ± g/2 and velocities Y₁ = dV₂ − V₁, Y₂ = dV₁ − V₂, so that Y₁ + Y₂ =
//! −2(1 − d)v and Y₁ − Y₂ = −(1 + d)g:
//!
//! ```text
//! Y₂² = r Y₁² + k V₁² + 2 V₁ + M,     Y₁² = r Y₂² + k V₂² + 2 V₂ + M.
//! ```
//!
//! Their difference is −2(1 + r)(1 − d²)vg = 2kvg + 2g, so that v = −1/(k + (1 + r)(1 − d²)) = −1/((1 − d)s⁻):
//! the middle stays at the period doubling's. Their sum, with Y₁² + Y₂² = 2(1 − d)²v² + ½(1 + d)²g² and V₁² +
//! V₂² = 2v² + ½g², is that of the period doubling and a multiple of g²:
//!
//! ```text
//! M = M_PD + ¼ C g²,     C = (1 − r)(1 + d)² − k.
//! ```
//!
//! The derivative of one step is (rY/Y', G/Y'; −rY/Y', d − G/Y') with G = kV + 1 and the determinant
//! rdY/Y'. So over both impacts the determinant is (rd)², and the trace T times Y₁Y₂ is linear in g²:
//! (1 − T + r²d²) Y₁Y₂ = −¼ (1 − d)s⁻ C g², which has to be 0 at g = 0. So **the period doubling is
//! supercritical exactly if C s⁻ < 0**; all two-impact orbits begin stable, or none, and none has a
//! saddle-node. For the linear oscillator, with q = σε,
//!
//! ```text
//! s⁺ = −(1 + q)²,  s⁻ = (1 − q)²,  C = (1 − q)(1 + 3σ + 3q + σq).
//! ```
//!
//! Where C = 0 all two-impact orbits are at one M: their behaviour is then decided by the next
//! order in η.
//!
//! *Grazing of two-impact orbits.* For p = 1 one of the impacts loses its velocity: g = 2/((1 + d)s⁻).
//! For p ≥ 2 velocities are dV₂ − V₁ with d < 0, so that a phase reaches 0 first: g = 2/((1 − d)s⁻). There
//! all visits of a loop are at the wall to first order in η, and those of second decide: x⁽ʲ⁾ = S_j (a₁₂ w + …) +
//! (Aʲ)₁₁ x⁽⁰⁾ + b₁ⱼ μ is positive at j = 0 and p. Its differences in j are those of a spiral over half a
//! turn at most, whose sign changes once, so that it falls and then rises: the first to touch is j = 1 or
//! p − 1. With Aʲ and b₁ⱼ of `eq:Ap`, `eq:b1pb2p`, E = δ^{p/2}, x⁽ᵖ⁾ = y²/(2γ) and x⁽⁰⁾ = φ²E²x⁽ᵖ⁾ it is p − 1 exactly if
//!
//! ```text
//! (δ/E − (δ − τ + 1)/(1 + E)) (1 + φ²E³) > τφ²E².
//! ```
//!
//! For φ ≤ 1 that holds: as (1 + E)(1 − E + E²) = 1 + E³ and 1 − E + E² ≥ E, it suffices that δ/E − 1 + τ(1 − E) > 0, and
//! E ≤ δ, τ ≥ 0, one of which is strict for p ≥ 3. **The last visit touches the wall first, if φ ≤ 1.**

use core::ops::Neg;

use num_traits::Num;

use crate::auxiliary::{lucas_partial_sum, modulus_power};
use crate::error::TheoryError;
use crate::generic_theorem::Side;
use crate::grazing::GrazingPoint;
use crate::unfolding::ResonantPoint;

/// Floating-point or exact numbers.
pub trait Arithmetic: Num + Neg<Output = Self> + Copy {}
impl<T: Num + Neg<Output = T> + Copy> Arithmetic for T {}

/// An impact in the limit: velocity Y and phase V after the recoil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitImpact<T = f64> {
    /// The velocity Y, with the sign of the side of the resonance.
    pub velocity: T,
    /// The phase V.
    pub phase: T,
}

/// The map (Y, V) ↦ (Y', V') with Y'² = r Y² + k V² + 2 V + M, V' = d V − Y'.
///
/// Numbers may be exact (rational) as well as floating-point. All are dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitMap<T = f64> {
    loops: u32,
    r: T,
    k: T,
    d: T,
}

/// Why an orbit of the limit map ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Departure {
    /// A visit between the impacts is beyond the wall, p ≥ 2.
    EarlyVisit,
    /// The wall is not reached after p loops.
    Missed,
}

fn half<T: Arithmetic>(x: T) -> T {
    x / (T::one() + T::one())
}

fn square<T: Arithmetic>(x: T) -> T {
    x * x
}

impl<T: Arithmetic> LimitMap<T> {
    /// The map with these numbers, for p loops: −1 < d < 1, d < 0 if p ≥ 2, s^± ≠ 0 and |rd| ≠ 1.
    ///
    /// # Errors
    /// [`TheoryError::NoLimitMap`] outside of this domain.
    pub fn new(loops: u32, [r, k, d]: [T; 3]) -> Result<Self, TheoryError>
    where
        T: PartialOrd,
    {
        let (zero, one) = (T::zero(), T::one());
        let map = Self { loops, r, k, d };
        let turns = -one < d && d < one && (loops == 1 || (loops > 1 && d < zero));
        // The comparison is false for NaN.
        let simple = map.stability().into_iter().all(|s| square(s) > zero);
        if turns && simple && square(r * d) != one { Ok(map) } else { Err(TheoryError::NoLimitMap) }
    }

    /// The limit map of a linear oscillator with p loops: r = σε², k = −σ(1 − σ)(1 + ε)², d = σ.
    ///
    /// # Errors
    /// [`TheoryError::NoLimitMap`] if ε ≤ 0, or as [`new`](Self::new).
    pub fn of_linear_oscillator(loops: u32, sigma: T, epsilon: T) -> Result<Self, TheoryError>
    where
        T: PartialOrd,
    {
        let one = T::one();
        let k = -sigma * (one - sigma) * square(one + epsilon);
        let map = Self::new(loops, [sigma * square(epsilon), k, sigma])?;
        if epsilon > T::zero() { Ok(map) } else { Err(TheoryError::NoLimitMap) }
    }

    /// The numbers r, k and d.
    pub fn numbers(&self) -> [T; 3] {
        [self.r, self.k, self.d]
    }

    /// Y'², the square of the next impact velocity; there is a next impact where it is positive.
    pub fn next_square(&self, parameter: T, from: LimitImpact<T>) -> T {
        let LimitImpact { velocity, phase } = from;
        self.r * square(velocity) + self.k * square(phase) + phase + phase + parameter
    }

    /// The next phase V' from the next velocity Y'.
    pub fn next_phase(&self, from: LimitImpact<T>, velocity: T) -> T {
        self.d * from.phase - velocity
    }

    /// The coefficients s⁺ and s⁻, (1 ∓ d)(r ∓ 1) + k/(1 − d). Paper: `eq:c1`, `eq:cp`.
    pub fn stability(&self) -> [T; 2] {
        let one = T::one();
        let Self { r, k, d, .. } = *self;
        let bend = k / (one - d);
        [(one - d) * (r - one) + bend, (one + d) * (r + one) + bend]
    }

    /// The fixed point with a given velocity, and the M at which it is one.
    pub fn fixed_point(&self, velocity: T) -> (LimitImpact<T>, T) {
        let [plus, _] = self.stability();
        let turn = T::one() - self.d;
        let parameter = (velocity + velocity - plus * square(velocity)) / turn;
        (LimitImpact { velocity, phase: -velocity / turn }, parameter)
    }

    /// Trace and determinant of the derivative at the fixed point with a given velocity.
    pub fn multipliers(&self, velocity: T) -> [T; 2] {
        let Self { r, k, d, .. } = *self;
        [r + d + k / (T::one() - d) - T::one() / velocity, r * d]
    }

    /// Y and M at the saddle-node: 1/s⁺, 1/((1 − d)s⁺).
    pub fn saddle_node(&self) -> [T; 2] {
        let velocity = T::one() / self.stability()[0];
        [velocity, self.fixed_point(velocity).1]
    }

    /// Y and M at the period doubling: Y = 1/s⁻.
    pub fn period_doubling(&self) -> [T; 2] {
        let velocity = T::one() / self.stability()[1];
        [velocity, self.fixed_point(velocity).1]
    }

    /// The coefficient C: M of two-impact orbits is M_PD + ¼ C g².
    pub fn bend_of_doubled(&self) -> T {
        let one = T::one();
        (one - self.r) * square(one + self.d) - self.k
    }

    /// The M of the two-impact orbits whose phases lie g apart, from g².
    pub fn doubled_parameter(&self, squared_gap: T) -> T {
        self.period_doubling()[1] + half(half(self.bend_of_doubled() * squared_gap))
    }

    /// The impacts of the two-impact orbit whose phases lie g apart; if g > 0, the one with the
    /// greater phase comes first.
    pub fn doubled_impacts(&self, gap: T) -> [LimitImpact<T>; 2] {
        let middle = -self.period_doubling()[0] / (T::one() - self.d);
        let [one, other] = [middle + half(gap), middle - half(gap)];
        let impact = |before: T, phase: T| LimitImpact { velocity: self.d * before - phase, phase };
        [impact(other, one), impact(one, other)]
    }

    /// The trace T of the two-impact orbit whose phases lie g apart.
    pub fn doubled_trace(&self, gap: T) -> T {
        let Self { r, k, d, .. } = *self;
        let impacts = self.doubled_impacts(gap);
        // Half the derivative of Y'² by V, from each impact to the next.
        let [g_1, g_2] = impacts.map(|impact| k * impact.phase + T::one());
        let [y_1, y_2] = impacts.map(|impact| impact.velocity);
        // The trace of the product of (rY/Y', g/Y'; −rY/Y', d − g/Y') over both impacts.
        square(r) + (d - g_1 / y_2) * (d - g_2 / y_1) - r * (g_2 / y_2 + g_1 / y_1)
    }

    /// The gap g at which the two-impact orbit grazes: 2/((1 + d)s⁻) for p = 1, 2/((1 − d)s⁻) for p ≥ 2.
    pub fn grazing_gap(&self) -> T {
        let one = T::one();
        let [velocity, _] = self.period_doubling();
        (velocity + velocity) / if self.loops == 1 { one + self.d } else { one - self.d }
    }

    /// g² where the two-impact orbit doubles its period, by (1 + T + r²d²) Y₁Y₂ = 0: 2 (1 +
    /// r²d²)/s⁻² over ½ (1 + r²d²)(1 + d)² − ¼ (1 − d)s⁻ C. The orbit doubles before it grazes if
    /// that is positive and less than the squared [`grazing_gap`](Self::grazing_gap).
    pub fn second_doubling(&self) -> T {
        let one = T::one();
        let [_, minus] = self.stability();
        let product = one + square(self.r * self.d);
        let across = half(half((one - self.d) * minus * self.bend_of_doubled()));
        (product + product) / (square(minus) * (half(product * square(one + self.d)) - across))
    }

    /// M at which the two-impact orbits graze.
    pub fn doubled_grazing(&self) -> T {
        let gap = self.grazing_gap();
        self.doubled_parameter(gap * gap)
    }

    /// M at which the two-impact orbits double their period; `None` unless they do so before they
    /// graze.
    pub fn doubled_doubling(&self) -> Option<T>
    where
        T: PartialOrd,
    {
        let (at, gap) = (self.second_doubling(), self.grazing_gap());
        (T::zero() < at && at < gap * gap).then(|| self.doubled_parameter(at))
    }

    /// The coefficient y² c of the period doubling's normal form λs + cs³, with s measured in the
    /// impact velocity: −(1 − d)s⁻C/(4(1 + d)²(1 − r²d²)). Positive: supercritical.
    ///
    /// By M = M_PD + ¼Cg² and Y₁ − Y₂ = −(1 + d)g, or from the map's derivatives up to the third.
    pub fn criticality(&self) -> T {
        let one = T::one();
        let [_, minus] = self.stability();
        let across = half(half((one - self.d) * minus * self.bend_of_doubled()));
        -across / (square(one + self.d) * (one - square(self.r * self.d)))
    }
}

impl LimitMap {
    /// The next visit (X, V) for p = 1, before its recoil: an impact if X > 0, otherwise a miss of
    /// the wall; `entry` is a₁₁.
    pub fn next_visit(
        &self,
        side: Side,
        parameter: f64,
        entry: f64,
        [position, phase]: [f64; 2],
    ) -> [f64; 2] {
        let velocity = side.signum() * position.max(0.0).sqrt();
        let from = LimitImpact { velocity, phase: phase - velocity };
        [self.next_square(parameter, from) + entry * position.min(0.0), self.next_phase(from, 0.0)]
    }

    /// The next impact.
    ///
    /// # Errors
    /// The reason why the map does not hold for this flight; `from` has to be on the side.
    pub fn step(&self, side: Side, parameter: f64, from: LimitImpact) -> Result<LimitImpact, Departure> {
        // NaN counts as departed as well.
        let before_the_wall = self.loops == 1 || from.phase * side.signum() < 0.0;
        let next = self.next_square(parameter, from);
        match (before_the_wall, next > 0.0) {
            (false, _) => Err(Departure::EarlyVisit),
            (true, false) => Err(Departure::Missed),
            (true, true) => {
                let velocity = side.signum() * next.sqrt();
                Ok(LimitImpact { velocity, phase: self.next_phase(from, velocity) })
            }
        }
    }
}

/// The scales of the limit map: y = `velocity` η Y, w = `phase` η V, μ = `parameter` η² M.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitScale {
    /// αω f_p.
    pub velocity: f64,
    /// (αω)² f_p/γ.
    pub phase: f64,
    /// (αω f_p)²/(2γ b₁ₚ).
    pub parameter: f64,
    /// The impact phase minus w, per impact velocity: ω(α − 1)/γ.
    pub lag: f64,
}

impl LimitScale {
    /// The side m of the resonance on which η lies.
    pub fn side(&self, eta: f64) -> Side {
        Side::of(self.velocity * eta)
    }

    /// The impact (y, z − z_graz,η) that corresponds to an impact of the limit map.
    pub fn impact(&self, eta: f64, impact: LimitImpact) -> [f64; 2] {
        let velocity = self.velocity * eta * impact.velocity;
        [velocity, self.phase * eta * impact.phase + self.lag * velocity]
    }

    /// The impact of the limit map that corresponds to the impact (y, z − z_graz,η).
    pub fn limit(&self, eta: f64, [velocity, phase]: [f64; 2]) -> LimitImpact {
        LimitImpact {
            velocity: velocity / (self.velocity * eta),
            phase: (phase - self.lag * velocity) / (self.phase * eta),
        }
    }
}

impl ResonantPoint {
    /// The numbers a, d and b₁ₚ: the diagonal of Aᵖ at the resonance, and the derivative of x⁽ᵖ⁾ in
    /// μ.
    fn power(&self) -> [f64; 3] {
        let map = &self.grazing.map;
        match self.loops() {
            1 => [map.a.m11, map.a.m22, map.b.x],
            loops => {
                let entry = -modulus_power(loops, map.determinant());
                let sum = lucas_partial_sum(loops, map.trace(), map.determinant());
                [entry, entry, sum * map.transversality()]
            }
        }
    }

    /// The limit map, under the hypotheses of [`ResonantGrazing`](crate::ResonantGrazing).
    pub fn limit_map(&self) -> LimitMap {
        let GrazingPoint { forcing_frequency, gamma, phi, .. } = self.grazing;
        let [a, d, _] = self.power();
        let turn = self.grazing.alpha() * forcing_frequency;
        let k = turn * turn * self.second_phase_derivative / gamma;
        LimitMap { loops: self.loops(), r: a * phi * phi, k, d }
    }

    /// The scales of the limit map.
    pub fn limit_scale(&self) -> LimitScale {
        let GrazingPoint { forcing_frequency, gamma, .. } = self.grazing;
        let alpha = self.grazing.alpha();
        let [_, _, rise] = self.power();
        let velocity = alpha * forcing_frequency * self.off_diagonal_slope();
        LimitScale {
            velocity,
            phase: alpha * forcing_frequency / gamma * velocity,
            parameter: 0.5 * velocity * velocity / (gamma * rise),
            lag: forcing_frequency * (alpha - 1.0) / gamma,
        }
    }

    /// The coefficient c_2GZ: two-impact orbits, which begin at the period doubling, graze at μ =
    /// c_2GZ η² + O(η³), on the side of η where the period doubling is.
    ///
    /// For the linear oscillator, in units of (αω f_p)²/(2γ b₁ₚ) and with q = σε:
    /// 4(1 + 2σ(1 − q + q²) + σ²q²)/((1 − σ)(1 + σ)²(1 − q)⁴) for p = 1, 4(1 − σq²)/((1 − σ)²(1 − q)⁴) for p ≥ 2.
    pub fn doubled_grazing_coefficient(&self) -> f64 {
        self.limit_scale().parameter * self.limit_map().doubled_grazing()
    }
}
