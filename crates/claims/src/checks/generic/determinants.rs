//! Section 4.3, lemma 4.3: the matrices J and K and their determinants.

use grazing_theorems::GrazingPoint;
use grazing_theorems::auxiliary::lucas_sequence;
use nalgebra::Matrix2;

use super::iterates::printed_iterate;
use super::specimens::{sampled_map, sampled_point, specimens};
use super::vivid::derivatives;
use crate::eigenvalues::{Pair, power};
use crate::outcome::CheckResult;
use crate::sampling::Sampler;
use crate::tally::Deviations;

/// J and K as they are printed in the proof of le:dets.
pub(super) fn printed_matrices(point: &GrazingPoint, p: u32) -> (Matrix2<f64>, Matrix2<f64>) {
    let map = &point.map;
    let (tau, delta) = (map.a.trace(), map.a.determinant());
    let (s, s_next) = (lucas_sequence(p, tau, delta), lucas_sequence(p + 1, tau, delta));
    let b = printed_iterate(map, p).b;
    let (a12, shift) = (map.a.m12, point.forcing_frequency / point.gamma);
    let after = 1.0 - point.alpha();
    let corner = s_next - map.a.m11 * s;
    let j = Matrix2::new(shift * a12 * after * s, a12 * s, shift * (after * corner - 1.0), corner - 1.0);
    (j, Matrix2::new(a12 * s, b.x, corner - 1.0, b.y))
}

/// The matrices of the proof of le:dets against the derivatives of the maps of oscillators.
pub(crate) fn matrices() -> CheckResult {
    let mut deviations = Deviations::default();
    for grazing in specimens()? {
        for p in 1..=8 {
            let [by_velocity, by_phase, by_parameter] = derivatives(&grazing, p)?;
            let (j, k) = printed_matrices(&grazing.grazing_point(), p);
            let numerical = [
                Matrix2::from_columns(&[by_velocity, by_phase]) - j,
                Matrix2::from_columns(&[by_phase, by_parameter]) - k,
            ];
            let size = 1.0 + j.amax() + k.amax();
            numerical.iter().for_each(|difference| deviations.see(difference.amax() / size));
        }
    }
    // Derivatives at event times that are off by rounding, p times, magnified by second derivatives of order ten.
    Ok(deviations.outcome(1e-11, "twelve oscillators, p = 1 to 8"))
}

/// le:dets: det J and det K of oscillators against eq:detJac1detJac2 and eq:detJac2.
pub(crate) fn determinants_of_oscillators() -> CheckResult {
    let mut deviations = Deviations::default();
    for grazing in specimens()? {
        let point = grazing.grazing_point();
        for p in 1..=8 {
            let [by_velocity, by_phase, by_parameter] = derivatives(&grazing, p)?;
            let j = Matrix2::from_columns(&[by_velocity, by_phase]);
            let k = Matrix2::from_columns(&[by_phase, by_parameter]);
            let [first, second, third] = printed_determinants(&point, p);
            deviations.see((j.determinant() - first) / (1.0 + j.amax() * j.amax()));
            deviations.see((k.determinant() - second) / (1.0 + k.amax() * k.amax()));
            deviations.see((k.determinant() - third) / (1.0 + k.amax() * k.amax()));
        }
    }
    // As for the matrices, and the products cancel.
    Ok(deviations.outcome(1e-11, "three formulas on twelve oscillators, p = 1 to 8"))
}

/// The right-hand sides of det J, of det K and of det K in factors.
fn printed_determinants(point: &GrazingPoint, p: u32) -> [f64; 3] {
    let map = &point.map;
    let (tau, delta) = (map.a.trace(), map.a.determinant());
    let (s, s_next) = (lucas_sequence(p, tau, delta), lucas_sequence(p + 1, tau, delta));
    let b = printed_iterate(map, p).b;
    let pair = Pair::new(tau, delta);
    let top =
        pair.monomial(p as i32, p as i32) - power(pair.first, p as i32) - power(pair.second, p as i32) + 1.0;
    [
        point.alpha() * map.a.m12 * point.forcing_frequency * s / point.gamma,
        (1.0 - s_next + map.a.m11 * s) * b.x + map.a.m12 * s * b.y,
        (top / pair.gap()).re * map.transversality(),
    ]
}

/// How much larger than the result the numbers are that a determinant cancels.
fn determinant_size(matrix: &Matrix2<f64>, point: &GrazingPoint) -> f64 {
    let entries = 1.0 + point.map.a.amax();
    (1.0 + matrix.amax()) * (1.0 + matrix.amax()) * entries * entries
}

/// eq:detJac1detJac2: the determinants of the printed matrices.
pub(crate) fn determinants() -> CheckResult {
    let mut sampler = Sampler::new(4);
    let mut deviations = Deviations::default();
    for index in 0..2000 {
        let p = 1 + index % 12;
        let map = sampled_map(&mut sampler);
        let point = sampled_point(&mut sampler, map);
        let (j, k) = printed_matrices(&point, p);
        let [first, second, _] = printed_determinants(&point, p);
        deviations.see((j.determinant() - first) / determinant_size(&j, &point));
        deviations.see((k.determinant() - second) / determinant_size(&k, &point));
    }
    // Tens of roundings of the numbers by which deviations are divided.
    Ok(deviations.outcome(1e-13, "grazing points with (τ, δ) in the trapesium, p = 1 to 12"))
}

/// eq:detJac2: det K in factors, also near τ = δ + 1 and near double eigenvalues.
pub(crate) fn factored_determinant() -> CheckResult {
    let mut sampler = Sampler::new(5);
    let mut deviations = Deviations::default();
    for index in 0..2000 {
        let p = 1 + index % 12;
        let map = sampled_map(&mut sampler);
        let point = sampled_point(&mut sampler, map);
        let (_, k) = printed_matrices(&point, p);
        let [_, _, factored] = printed_determinants(&point, p);
        // The quotient has the rounding of 1 − λ₁ in its denominator.
        let gap = Pair::new(point.map.a.trace(), point.map.a.determinant()).gap().norm().min(1.0);
        deviations.see((k.determinant() - factored) * gap / determinant_size(&k, &point));
    }
    Ok(deviations.outcome(1e-13, "grazing points with (τ, δ) in the trapesium, p = 1 to 12"))
}

/// det J = α a₁₂ ω / γ and det K = β for p = 1.
pub(crate) fn one_loop_determinants() -> CheckResult {
    let mut sampler = Sampler::new(6);
    let mut deviations = Deviations::default();
    for _ in 0..2000 {
        let map = sampled_map(&mut sampler);
        let point = sampled_point(&mut sampler, map);
        let (j, k) = printed_matrices(&point, 1);
        let first = point.alpha() * map.a.m12 * point.forcing_frequency / point.gamma;
        let beta = (1.0 - map.a.m22) * map.b.x + map.a.m12 * map.b.y;
        deviations.see((j.determinant() - first) / determinant_size(&j, &point));
        deviations.see((k.determinant() - beta) / determinant_size(&k, &point));
    }
    // As for any p.
    Ok(deviations.outcome(1e-13, "grazing points with (τ, δ) in the trapesium"))
}
