//! Section 4.4, step 3 of the proof of theorem 2.3: the signs of the u⁽ʲ⁾ and the polygon 𝒫.

use crate::checks::appendices::signs::{along, determinant, search};
use crate::*;

/// A pair (τ, δ), with τ above h_p by a fraction of the way to δ + 1; both fractions lie in (0, 1).
fn above(p: u32, [x, y]: [f64; 2]) -> Option<(f64, f64)> {
    let delta = determinant(x);
    let lowest = admissibility_boundary(p, delta).ok()?;
    Some((along(along(y, 1e-6, 1.0), lowest, delta + 1.0), delta))
}

/// r to an integer power, where r = √δ.
fn r_to(delta: f64, k: u32) -> f64 {
    libm::pow(delta, 0.5 * f64::from(k))
}

/// The path of a map with this trace and determinant; other such maps differ by an affine change of w,
/// which does not affect convexity. This path turns by equal angles where eigenvalues are complex.
fn path(p: u32, tau: f64, delta: f64) -> Vec<Vector2<f64>> {
    let discriminant = 0.25 * tau * tau - delta;
    let a12 = discriminant.abs().sqrt().max(0.1 * delta.sqrt());
    // β = a₁₂ b₂ = 1.
    let map = LinearisedMap {
        a: Matrix2::new(0.5 * tau, a12, discriminant / a12, 0.5 * tau),
        b: Vector2::new(0.0, 1.0 / a12),
    };
    let s = lucas_sequence(p, tau, delta);
    let mut here = Vector2::new(0.0, -map.iterate(p).b.x / a12);
    let mut path = vec![here];
    for _ in 0..p {
        here = map.a * here + map.b * s;
        path.push(here);
    }
    path
}

fn cross(a: Vector2<f64>, b: Vector2<f64>) -> f64 {
    a.x * b.y - a.y * b.x
}

/// The smallest sine of the angles at which the other vertices are seen from the edges: positive if and
/// only if the closed polygon is strictly convex with its vertices in this order.
fn convexity(path: &[Vector2<f64>]) -> f64 {
    let mut range = (f64::INFINITY, f64::NEG_INFINITY);
    for (i, from) in path.iter().enumerate() {
        let next = (i + 1) % path.len();
        let edge = path[next] - from;
        for (k, vertex) in path.iter().enumerate() {
            if k != i && k != next {
                let sine = cross(edge, vertex - from) / (edge.norm() * (vertex - from).norm());
                range = (range.0.min(sine), range.1.max(sine));
            }
        }
    }
    range.0.max(-range.1)
}

/// Whether two segments that have no common vertex intersect.
fn cross_each_other([a, b]: [Vector2<f64>; 2], [c, d]: [Vector2<f64>; 2]) -> bool {
    let side = |from: Vector2<f64>, to: Vector2<f64>, point: Vector2<f64>| cross(to - from, point - from);
    side(a, b, c) * side(a, b, d) <= 0.0 && side(c, d, a) * side(c, d, b) <= 0.0
}

checks! {
    /// The path as a polygon: convex and in order for τ > h_p, and not for smaller τ (p ≥ 3).
    polygon: drawn_over(9, 0..3000) |sampler, index; (votes, printed): (Votes, Votes)| {
        let p = 2 + index % 7;
        // For smaller determinants the path shrinks below its rounding error.
        let delta = sampler.between(0.2, 0.98);
        let boundary = admissibility_boundary(p, delta)?;
        let tau = sampler.between(-0.999 * (delta + 1.0), 0.999 * (delta + 1.0));
        if (tau - boundary).abs() < 1e-3 || p == 2 && tau < boundary {
            return Ok(());
        }
        let vertices = path(p, tau, delta);
        let convex = convexity(&vertices) > 1e-12;
        votes.see(convex == (tau > boundary));
        printed.see(convex);
        if tau > boundary {
            let edge = |i: usize| [vertices[i], vertices[i + 1]];
            let apart = |i: usize, k: usize| !cross_each_other(edge(i), edge(k));
            votes.see((0..p as usize).all(|i| (i + 2..p as usize).all(|k| apart(i, k))));
        }
    } =>
        votes.outcome("paths for τ on either side of h_p, p = 2 to 8, as polygons of computed vertices")
            .against_print(printed.measure());
    /// The first zero: as τ decreases from δ + 1, no u⁽ˡ⁾ vanishes before τ = h_p, and there u⁽ᵖ⁻¹⁾ does
    /// (p ≥ 3).
    first_zero: drawn_over(10, 0..600) |sampler, index; votes: Votes| {
        let p = 3 + index % 13;
        let delta = sampler.between(0.001, 0.999);
        let boundary = admissibility_boundary(p, delta)?;
        let scaled = |j: u32, tau: f64| scaled_visit_position(j, p, tau, delta) / r_to(delta, j - 1);
        for k in 1..50 {
            let tau = along(f64::from(k) / 50.0, boundary, delta + 1.0);
            votes.see((1..p).all(|j| scaled(j, tau) < 0.0));
        }
        // At h_p itself, to within p² roundings of terms of order p.
        votes.see(scaled(p - 1, boundary).abs() < 1e-11);
        votes.see((1..p - 1).all(|j| scaled(j, boundary) < -1e-6));
        votes.see(scaled(p - 1, boundary - 1e-4 * delta.sqrt()) > 0.0);
    } => votes.outcome("600 determinants, p = 3 to 15, fifty values of τ each from δ + 1 down to h_p and beyond");
    /// The sum of a truncated geometric series.
    // Twenty roundings.
    geometric_series: sampled(6, 1000, 1..=20) |sampler, n; deviations: Deviations| {
        let r = sampler.between(-1.5, 1.5);
        let (sum, power) = (0..n).fold((0.0, 1.0), |(sum, power), _| (sum + power, power * r));
        // The numerator cancels near r = 1.
        deviations.see((sum * (1.0 - r) - (1.0 - power)) / (1.0 + power.abs()));
    } => deviations.outcome(1e-14, "ratios between −1.5 and 1.5, one to twenty terms");
    /// S_j at τ = δ + 1.
    // δ + 1 is rounded, which changes an eigenvalue by the rounding error over 1 − δ.
    sums_at_unit_eigenvalue: sampled(7, 1000, 2..=15) |sampler, p; deviations: Deviations| {
        let delta = sampler.between(0.001, 0.999);
        let pair = EigenvaluePair::new(delta + 1.0, delta);
        deviations.see((pair.first - 1.0).norm() * (1.0 - delta));
        deviations.see((pair.second - delta).norm() * (1.0 - delta));
        let top = libm::pow(delta, f64::from(p));
        // The quotients, multiplied by their denominators.
        let s = lucas_sequence(p, delta + 1.0, delta) * (1.0 - delta);
        deviations.see((s - (1.0 - top)) / f64::from(p));
        let t = lucas_partial_sum(p, delta + 1.0, delta) * (1.0 - delta) * (1.0 - delta);
        deviations.see((t - (f64::from(p) * (1.0 - delta) - (1.0 - top))) / f64::from(p * p));
    } => deviations.outcome(1e-14, "λ₁, λ₂, S_p and T_p for determinants from 0.001 to 0.999, p = 2 to 15");
    /// eq:ujeig1.
    positions_at_unit_eigenvalue: sampled(8, 1000, 2..=15) |sampler, p; deviations: Deviations| {
        let delta = sampler.between(0.001, 0.999);
        let raised = |k: u32| libm::pow(delta, f64::from(k));
        for j in 1..p {
            let expected = f64::from(j) * (1.0 - raised(p)) - f64::from(p) * (1.0 - raised(j));
            let u = scaled_visit_position(j, p, delta + 1.0, delta);
            // S and T reach p and p², and cancel.
            let size = 1.0 + f64::from(p * p * p) * (1.0 - delta) * (1.0 - delta);
            deviations.see((u * (1.0 - delta) * (1.0 - delta) - expected) / size);
        }
    } => deviations.outcome(1e-14, "determinants from 0.001 to 0.999, p = 2 to 15, all j");
    /// u⁽ʲ⁾ depends on the map only through τ and δ, and at fixed δ it is a polynomial in τ of degree at
    /// most p + j − 3, so that it may be followed in τ.
    // The balanced map divides by a₁₂, at least a tenth of r ≥ 0.03.
    invariance: sampled(11, 1000, 2..=8) |sampler, p; deviations: Deviations| {
        let (tau, delta) = sampler.trapesium();
        let expected: Vec<f64> = path(p, tau, delta).iter().map(|point| point.x).collect();
        let map = map_with(sampler, tau, delta);
        let (s, beta) = (lucas_sequence(p, tau, delta), map.transversality());
        let mut here = Vector2::new(0.0, -map.iterate(p).b.x / map.a.m12);
        // Multiplied by β, which may be small.
        let size = (1.0 + here.amax()) * (1.0 + map.a.amax()) * (1.0 + map.a.amax());
        for position in expected {
            deviations.see((here.x - beta * position) / (size * (1.0 + position.abs())));
            here = map.a * here + map.b * s;
        }
        // Differences of one order higher vanish, at steps over the whole range of τ.
        let order = 2 * p as usize - 3;
        let paths: Vec<Vec<Vector2<f64>>> = (0..=order)
            .map(|k| path(p, along((k as f64 + 0.5) / (order as f64 + 1.0), -delta - 1.0, delta + 1.0), delta))
            .collect();
        for j in 0..=p as usize {
            let (mut binomial, mut difference, mut size) = (1.0, 0.0, 0.0);
            for (k, path) in paths.iter().enumerate() {
                difference += if k % 2 == 0 { binomial } else { -binomial } * path[j].x;
                size += binomial * (1.0 + path[j].x.abs());
                binomial *= (order - k) as f64 / (k as f64 + 1.0);
            }
            deviations.see(difference / size);
        }
    } => deviations.outcome(1e-14, "pairs of maps with the same τ and δ, and differences of order 2p − 3 in τ, p = 2 to 8");
    /// The path is convex for h_p < τ < δ + 1, and u⁽ʲ⁾ < 0, 0 < j < p: by search.
    ///
    /// With e = p₁ − p₀ and c = e × Ae, a vertex n − 1 after the end of the edge at i lies on the side
    /// given by δⁱ T_n c, one n before its start on the side given by δ^(i−1) H_(n+1) c, and u⁽ʲ⁾ decides
    /// for the closing edge. So T_n > 0 and H_n > 0, 2 ≤ n ≤ p, and u⁽ʲ⁾ < 0 make it convex.
    convex: search(2..=15, "h_p < τ ≤ δ + 1 up to 10⁻⁶ of its length from h_p", "T_n, r^(n−2) H_n and −r^(1−j) u⁽ʲ⁾, n ≤ p, j < p", |p, point| {
        let Some((tau, delta)) = above(p, point) else { return f64::NEG_INFINITY };
        (2..=p)
            .map(|n| {
                let h = admissibility_sum(n, tau, delta) * r_to(delta, n - 2);
                let u = -scaled_visit_position(n - 1, p, tau, delta) / r_to(delta, n - 2);
                lucas_partial_sum(n, tau, delta).min(h).min(u)
            })
            .fold(f64::INFINITY, f64::min)
    });
}
