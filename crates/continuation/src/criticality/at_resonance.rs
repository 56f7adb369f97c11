//! The criticality of the period doublings that leave a resonance, in closed form.

use grazing_theorems::ResonantPoint;

/// The limit of y² c towards a resonance along its curve of period doublings, with s counted in the
/// impact velocity, q_y = 1.
///
/// ```text
/// y² c → (1 − d) s_p⁻ (ξ_p (αω / (1 + d))² / γ − (1 − a φ²)) / (4 (1 − (a d φ²)²)),
/// ```
///
/// where a and d are the diagonal entries of Aᵖ, whose upper right one is zero: a₁₁ and a₂₂ for p =
/// 1, and −δ^{p/2} both for p ≥ 2. So its sign is that of s_p⁻ times the bracket, a d φ² = δᵖφ²
/// being the MPS's other multiplier but for its sign. All dimensionless.
///
/// The paper has no such formula; its symbols are those of eq:c1 and eq:cp. To leading order in y
/// the two ways of eq:V lead to one point where, with w = z⁽⁰⁾ − z_graz counted after the reset,
///
/// ```text
/// y'² = a φ² y² + 2γ (a₁₂⁽ᵖ⁾' η w + ½ ξ_p w² + β_p μ),   w' = d w − (αω/γ) y',
/// ```
///
/// by eq:xHatzHat and eq:x0z0, a₁₂⁽ᵖ⁾ and β_p being the entry of Aᵖ and the coefficient of μ. The
/// normal form of this map at its fixed point with the multiplier −1 is the result. Domain: 0 <
/// δᵖφ² < 1.
pub fn coefficient_at_resonance(point: &ResonantPoint) -> f64 {
    let grazing = &point.grazing;
    let [a, d] = match point.loops() {
        1 => [grazing.map.a.m11, grazing.map.a.m22],
        loops => [-libm::pow(grazing.map.determinant(), 0.5 * f64::from(loops)); 2],
    };
    let reset = a * grazing.phi * grazing.phi;
    let turn = grazing.alpha() * grazing.forcing_frequency / (1.0 + d);
    let bracket = point.second_phase_derivative * turn * turn / grazing.gamma - (1.0 - reset);
    let multiplier = reset * d;
    (1.0 - d) * point.stability_coefficients().minus * bracket / (4.0 * (1.0 - multiplier * multiplier))
}
