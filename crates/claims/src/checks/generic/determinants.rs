//! Section 4.3, lemma 4.3: the matrices J and K and their determinants.

use super::vivid::derivatives;
use crate::*;

/// The matrices J and K.
fn matrices(vivid: &VividLinearisation) -> [Matrix2<f64>; 2] {
    [vivid.by_impact, vivid.by_phase_and_parameter()]
}

/// The stated det J, det K, and det K in factors.
fn stated(point: &GrazingPoint, p: u32) -> [f64; 3] {
    [
        point.impact_jacobian_determinant(p),
        point.parameter_jacobian_determinant(p),
        point.parameter_jacobian_determinant_factored(p),
    ]
}

/// det K in factors as printed, with eigenvalues; it is undefined if one of them is 1.
fn factored_by_eigenvalues(point: &GrazingPoint, p: i32) -> f64 {
    let pair = EigenvaluePair::new(point.map.a.trace(), point.map.a.determinant());
    let top = pair.monomial(p, p) - power(pair.first, p) - power(pair.second, p) + 1.0;
    (top / pair.gap()).re * point.map.transversality()
}

/// The size of the numbers that cancel in a determinant, relative to the result.
fn determinant_size(matrix: &Matrix2<f64>, point: &GrazingPoint) -> f64 {
    let entries = 1.0 + point.map.a.amax();
    (1.0 + matrix.amax()) * (1.0 + matrix.amax()) * entries * entries
}

checks! {
    /// le:dets: matrices of the proof, det J and det K against derivatives of oscillators' maps.
    // Event times have p rounding errors, amplified by second derivatives of order ten.
    determinants_of_oscillators: over(specimens_with(1..=8)?) |(grazing, p); deviations: Deviations| {
        let point = grazing.grazing_point();
        let [j, k] = matrices(&derivatives(&grazing, p)?);
        let [j_stated, k_stated] = matrices(&point.vivid_linearisation(p));
        let size = 1.0 + j_stated.amax() + k_stated.amax();
        deviations.see((j - j_stated).amax() / size);
        deviations.see((k - k_stated).amax() / size);
        let [first, second, third] = stated(&point, p);
        deviations.see((j.determinant() - first) / (1.0 + j.amax() * j.amax()));
        deviations.see((k.determinant() - second) / (1.0 + k.amax() * k.amax()));
        deviations.see((k.determinant() - third) / (1.0 + k.amax() * k.amax()));
    } => deviations.outcome(1e-13, "matrices and three formulas on twelve oscillators, p = 1 to 8");
    /// eq:detJac1detJac2: the determinants of the printed matrices; for p = 1 det K is β.
    // Tens of roundings of the numbers by which deviations are divided.
    determinants: sampled(4, 2000, 1..=12) |sampler, p; deviations: Deviations| {
        let map = sampled_map(sampler);
        let point = sampled_point(sampler, map);
        let [j, k] = matrices(&point.vivid_linearisation(p));
        let [first, second, _] = stated(&point, p);
        deviations.see((j.determinant() - first) / determinant_size(&j, &point));
        deviations.see((k.determinant() - second) / determinant_size(&k, &point));
        if p == 1 {
            deviations.see((k.determinant() - map.transversality()) / determinant_size(&k, &point));
        }
    } => deviations.outcome(1e-15, "grazing points with (τ, δ) in the trapesium, p = 1 to 12");
    /// eq:detJac2: det K in factors, also near τ = δ + 1 and near double eigenvalues.
    factored_determinant: sampled(5, 2000, 1..=12) |sampler, p; deviations: Deviations| {
        let map = sampled_map(sampler);
        let point = sampled_point(sampler, map);
        let [_, k] = matrices(&point.vivid_linearisation(p));
        let printed = factored_by_eigenvalues(&point, p as i32);
        let [_, _, factored] = stated(&point, p);
        deviations.see((k.determinant() - factored) / determinant_size(&k, &point));
        // The quotient has the rounding of 1 − λ₁ in its denominator.
        let gap = EigenvaluePair::new(point.map.a.trace(), point.map.a.determinant()).gap().norm().min(1.0);
        deviations.see((k.determinant() - printed) * gap / determinant_size(&k, &point));
    } => deviations.outcome(1e-15, "grazing points with (τ, δ) in the trapesium, p = 1 to 12");
}
