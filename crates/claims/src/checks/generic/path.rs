//! Section 4.4, step 2 of the proof of theorem 2.3: the affine map Q and the numbers u⁽ʲ⁾.

use super::vivid::{derivatives, scale};
use crate::*;

/// The tolerance: tens of roundings of numbers of the size by which deviations are divided.
const ROUNDING: f64 = 1e-14;

/// d(x⁽ʲ⁾, z⁽ʲ⁾)/dμ at grazing for the zero of V, by the chain rule through the oscillator's maps.
fn slopes_of_visits(grazing: &Grazing, p: u32) -> Result<Vec<Vector2<f64>>, CheckError> {
    let vivid = derivatives(grazing, p)?;
    let impact = -vivid.by_impact.lu().solve(&vivid.by_parameter).ok_or("det J = 0")?;
    let oscillator = grazing.oscillator();
    let reset = oscillator.reset::<1>(OnWall::new(0.0, grazing.phase()));
    let recoil = virtual_map::<_, 1>(oscillator, reset.image(), None)?.jet;
    let start = recoil.after::<1, _>(&reset);
    let mut slope = start.derivative() * impact + start.jacobian.column(2);
    let mut slopes = vec![slope];
    let step = global_map::<_, 1>(oscillator, AtRest::new(0.0, grazing.phase()), None)?.jet;
    for _ in 0..p {
        slope = step.derivative() * slope + step.jacobian.column(2);
        slopes.push(slope);
    }
    Ok(slopes)
}

/// d(x⁽ʲ⁾, z⁽ʲ⁾)/dμ for 0 < j ≤ p by central differences of the visits of zeros of V.
fn differences_of_visits(grazing: &Grazing, p: u32) -> Result<Vec<Vector2<f64>>, CheckError> {
    let equations = equations(grazing, p);
    let h = 1e-4 * scale(grazing, p).ok_or("no emerging orbit")?;
    let visits = |mu: f64| equations.visits(&zero(grazing, p, mu)?, &EventTimes::default()).ok();
    let (ahead, behind) = visits(h).zip(visits(-h)).ok_or("no zero of V")?;
    Ok(ahead.iter().zip(&behind).map(|(ahead, behind)| (ahead - behind) / (2.0 * h)).collect())
}

/// S_p and β, the numerator and denominator of the scaling of slopes.
fn scaling(point: &GrazingPoint, p: u32) -> (f64, f64) {
    let s = lucas_sequence(p, point.map.trace(), point.map.determinant());
    (s, point.map.transversality())
}

/// The largest deviation of a function of the (u⁽ʲ⁾, w⁽ʲ⁾) of the specimens, p = 1 to 6.
fn over_oscillators(
    tolerance: f64,
    deviation: impl Fn(&GrazingPoint, u32, &[Vector2<f64>]) -> f64,
) -> CheckResult {
    let mut deviations = Deviations::default();
    for (grazing, p) in specimens_with(1..=6)? {
        let point = grazing.grazing_point();
        let (s, beta) = scaling(&point, p);
        let path: Vec<_> =
            slopes_of_visits(&grazing, p)?.into_iter().map(|slope| slope * (s / beta)).collect();
        let size = path.iter().map(Vector2::amax).fold(1.0, f64::max);
        deviations.see(deviation(&point, p, &path) / size);
    }
    Ok(deviations.outcome(tolerance, "twelve oscillators, p = 1 to 6, derivatives by the chain rule"))
}

/// The tolerance: derivatives of the maps have thirteen digits, and S_p cancels J⁻¹.
const DERIVATIVES: f64 = 1e-12;

checks! {
    /// eq:ujwj: the scaled derivatives of the visits against central differences of positions.
    // Rounding of 10⁻¹⁵ over a step of about 10⁻⁶, amplified by J⁻¹.
    scaled_slopes: over(specimens_with(1..=3)?) |(grazing, p); deviations: Deviations| {
        let differences = differences_of_visits(&grazing, p)?;
        let stated = grazing.grazing_point().emerging_orbit(p)?;
        for (j, slope) in (0..=p).zip(slopes_of_visits(&grazing, p)?) {
            deviations.see((stated.visit_slope(j) - slope).amax() / (1.0 + slope.amax()));
            // The visits begin with the first return.
            if let Some(k) = (j as usize).checked_sub(1) {
                deviations.see((differences[k] - slope).amax() / (1.0 + slope.amax()));
            }
        }
    } => deviations.outcome(1e-7, "the visits j = 1 to p of twelve oscillators, p = 1 to 3");
    /// eq:affineMapj: the printed iterate against p steps.
    affine_map_iterated: sampled(2, 2000, 1..=12) |sampler, j; deviations: Deviations| {
        let map = sampled_map(sampler);
        // S_p/β, and the start, are arbitrary here.
        let factor = sampler.between(-2.0, 2.0);
        let start = Vector2::new(sampler.between(-1.0, 1.0), sampler.between(-1.0, 1.0));
        let (mut here, mut size) = (start, 1.0_f64);
        for _ in 0..j {
            here = map.a * here + map.b * factor;
            size = size.max(here.amax());
        }
        let LinearisedMap { a, b } = map.iterate(j);
        let entries = (1.0 + map.a.amax()) * (1.0 + map.a.amax());
        deviations.see((a * start + b * factor - here).amax() / (entries * (size + a.amax() + b.amax())));
    } => deviations.outcome(ROUNDING, "affine maps with (τ, δ) in the trapesium, j = 1 to 12");
    /// eq:ujcodim1proof from eq:affineMapj.
    positions: sampled(3, 3000, 1..=12) |sampler, p; deviations: Deviations| {
        let map = sampled_map(sampler);
        let (tau, delta, beta) = (map.trace(), map.determinant(), map.transversality());
        let (s, last) = (lucas_sequence(p, tau, delta), map.iterate(p).b);
        let entries = (1.0 + map.a.amax()) * (1.0 + map.a.amax());
        for j in 0..=p {
            // Multiplied by β: u⁽ʲ⁾ β = −A^j₁₂ b_1p / a₁₂ + S_p b_1j.
            let LinearisedMap { a, b } = map.iterate(j);
            let terms = [-a.m12 * last.x / map.a.m12, s * b.x];
            let size = entries * (1.0 + terms[0].abs() + terms[1].abs() + last.amax() + b.amax());
            let expected = beta * scaled_visit_position(j, p, tau, delta);
            deviations.see((terms[0] + terms[1] - expected) / size);
        }
    } => deviations.outcome(ROUNDING, "affine maps with (τ, δ) in the trapesium, p = 1 to 12, j = 0 to p");
    /// eq:u1codim1proof.
    // The tolerance is that of eq:SpTp.
    first_position: sampled(4, 2000, 2..=15) |sampler, p; deviations: Deviations| {
        let (tau, delta) = sampler.trapesium();
        let pair = EigenvaluePair::new(tau, delta);
        let size = pair.moduli().t(p).re;
        let first = scaled_visit_position(1, p, tau, delta);
        let by_recurrence = (first + lucas_partial_sum(p, tau, delta)).abs();
        deviations.see((pair.t(p) + first).norm().max(by_recurrence) / size);
    } => deviations.outcome(1e-14, "points of the trapesium, p = 2 to 15");
    /// eq:upm1codim1proof.
    // The tolerance is that of eq:Hp9.
    last_position: sampled(5, 2000, 2..=15) |sampler, p; deviations: Deviations| {
        let (tau, delta) = sampler.trapesium();
        let pair = EigenvaluePair::new(tau, delta);
        let raised = libm::pow(delta, f64::from(p - 2));
        let size = pair.moduli();
        let terms = (size.s(p - 1) * size.t(p) + size.s(p) * size.t(p - 1) + size.h(p) * raised).re;
        let last = scaled_visit_position(p - 1, p, tau, delta);
        deviations.see((pair.h(p) * raised + last).norm() / terms);
        deviations.see((admissibility_sum(p, tau, delta) * raised + last) / terms);
    } => deviations.outcome(1e-14, "points of the trapesium, p = 2 to 15");
    /// eq:affineMap: Q between successive visits of MPSs on both sides of grazing.
    // The tolerance is that of the differences.
    affine_map: over(specimens_with(2..=4)?) |(grazing, p); deviations: Deviations| {
        let point = grazing.grazing_point();
        let (s, beta) = scaling(&point, p);
        let path: Vec<_> = differences_of_visits(&grazing, p)?.iter().map(|slope| slope * (s / beta)).collect();
        let size = path.iter().map(Vector2::amax).fold(1.0, f64::max);
        for pair in path.windows(2) {
            deviations.see((point.map.a * pair[0] + point.map.b * (s / beta) - pair[1]).amax() / size);
        }
    } => deviations.outcome(1e-7, "the visits j = 1 to p of twelve oscillators, p = 2 to 4");
    /// u⁽⁰⁾ = 0 and w⁽⁰⁾ = −b_1p / (a₁₂ β).
    start: over_oscillators(DERIVATIVES, |point, p, path| {
        let (s, beta) = scaling(point, p);
        let stated = point.emerging_orbit(p).map(|orbit| orbit.visit_slope(0) * (s / beta));
        stated.map_or(f64::NAN, |stated| (path[0] - stated).amax() + stated.x.abs())
    });
    /// eq:ujcodim1proof on oscillators: u⁽ʲ⁾ depends only on τ and δ.
    positions_of_oscillators: over_oscillators(DERIVATIVES, |point, p, path| {
        let (tau, delta) = (point.map.trace(), point.map.determinant());
        let deviation = |(j, point): (usize, &Vector2<f64>)| {
            (point.x - scaled_visit_position(j as u32, p, tau, delta)).abs()
        };
        path.iter().enumerate().map(deviation).fold(0.0, f64::max)
    });
    /// fig:I: the path starts and ends on the w-axis.
    ends_on_axis: over_oscillators(DERIVATIVES, |_, p, path| path[0].x.abs().max(path[p as usize].x.abs()));
}
