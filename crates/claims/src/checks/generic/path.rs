//! Section 4.4, steps 2 and 3 of the proof of theorem 2.3: the affine map Q, the numbers u⁽ʲ⁾ and the path 𝒫.

use grazing_continuation::mps::Memory;
use grazing_model::ImpactOscillator;
use grazing_model::maps::{global_map, virtual_map};
use grazing_theorems::admissibility_boundary::admissibility_boundary;
use grazing_theorems::auxiliary::{
    admissibility_sum, lucas_partial_sum, lucas_sequence, scaled_visit_position,
};
use grazing_theorems::{GrazingPoint, LinearisedMap};
use nalgebra::{Matrix2, Vector2};

use super::iterates::printed_iterate;
use super::specimens::{Grazing, map_with, sampled_map, specimens};
use super::vivid::{derivatives, equations, scale, zero};
use crate::checks::appendices::signs::{along, determinant, search};
use crate::eigenvalues::Pair;
use crate::outcome::CheckResult;
use crate::sampling::Sampler;
use crate::tally::{Deviations, Votes};

/// Tens of roundings of numbers of the size by which deviations are divided.
const ROUNDING: f64 = 1e-12;

/// d(x⁽ʲ⁾, z⁽ʲ⁾)/dμ at grazing, j = 0, …, p, by implicit differentiation of the zero of V and the chain rule through the maps
/// of the oscillator.
fn slopes_of_visits(
    grazing: &Grazing,
    p: u32,
) -> Result<Vec<Vector2<f64>>, Box<dyn std::error::Error + Send + Sync>> {
    let [by_velocity, by_phase, by_parameter] = derivatives(grazing, p)?;
    let jacobian = Matrix2::from_columns(&[by_velocity, by_phase]);
    let impact = -jacobian.lu().solve(&by_parameter).ok_or("det J = 0")?;
    let oscillator = grazing.oscillator();
    let reset = oscillator.reset::<1>(0.0, grazing.phase());
    let recoil = virtual_map::<_, 1>(oscillator, reset.value[0], reset.value[1], None)?.jet;
    let start = recoil.after::<1>(&reset);
    let mut slope = start.derivative() * impact + start.jacobian.column(2);
    let mut slopes = vec![slope];
    let step = global_map::<_, 1>(oscillator, 0.0, grazing.phase(), None)?.jet;
    for _ in 0..p {
        slope = step.derivative() * slope + step.jacobian.column(2);
        slopes.push(slope);
    }
    Ok(slopes)
}

/// S_p, β, and the sum of the moduli of what a slope is made of.
fn scaling(point: &GrazingPoint, p: u32) -> (f64, f64) {
    let s = lucas_sequence(p, point.map.trace(), point.map.determinant());
    (s, point.map.transversality())
}

/// The largest deviation over the specimens and p = 1 to 6 of something made of the numbers (u⁽ʲ⁾, w⁽ʲ⁾) of an oscillator.
fn over_oscillators(
    deviation: impl Fn(&GrazingPoint, u32, &[Vector2<f64>]) -> f64,
    over: &str,
) -> CheckResult {
    let mut deviations = Deviations::default();
    for grazing in specimens()? {
        let point = grazing.grazing_point();
        for p in 1..=6 {
            let (s, beta) = scaling(&point, p);
            let path: Vec<_> =
                slopes_of_visits(&grazing, p)?.into_iter().map(|slope| slope * (s / beta)).collect();
            let size = path.iter().map(Vector2::amax).fold(1.0, f64::max);
            deviations.see(deviation(&point, p, &path) / size);
        }
    }
    // Derivatives of the maps with thirteen digits, and J⁻¹, which S_p cancels.
    Ok(deviations.outcome(1e-11, over))
}

const OSCILLATORS: &str = "nine oscillators, p = 1 to 6, derivatives by the chain rule";

/// eq:ujwj: the scaled derivatives of the visits of oscillators against central differences of their positions.
pub(crate) fn scaled_slopes() -> CheckResult {
    let mut deviations = Deviations::default();
    for grazing in specimens()? {
        for p in 1..=3 {
            let slopes = slopes_of_visits(&grazing, p)?;
            let h = 1e-4 * scale(&grazing, p).ok_or("no emerging orbit")?;
            let visits = |mu: f64| {
                let point = zero(&grazing, p, mu)?;
                equations(&grazing, p).visits(&point, &Memory::default()).ok()
            };
            let (ahead, behind) = (visits(h).ok_or("no zero of V")?, visits(-h).ok_or("no zero of V")?);
            for (j, slope) in slopes.iter().enumerate().skip(1) {
                let difference = (ahead[j - 1] - behind[j - 1]) / (2.0 * h);
                deviations.see((difference - slope).amax() / (1.0 + slope.amax()));
            }
        }
    }
    // Rounding of 10⁻¹⁵ over a step of some 10⁻⁶, magnified near a resonance.
    Ok(deviations.outcome(1e-6, "the visits j = 1 to p of nine oscillators, p = 1 to 3"))
}

/// eq:affineMap.
pub(crate) fn affine_map() -> CheckResult {
    over_oscillators(
        |point, p, path| {
            let (s, beta) = scaling(point, p);
            path.windows(2)
                .map(|pair| (point.map.a * pair[0] + point.map.b * (s / beta) - pair[1]).amax())
                .fold(0.0, f64::max)
        },
        OSCILLATORS,
    )
}

/// eq:affineMapj: the printed iterate against p steps.
pub(crate) fn affine_map_iterated() -> CheckResult {
    let mut sampler = Sampler::new(2);
    let mut deviations = Deviations::default();
    for index in 0..2000 {
        let j = 1 + index % 12;
        let map = sampled_map(&mut sampler);
        // S_p/β, and the start, are arbitrary here.
        let factor = sampler.between(-2.0, 2.0);
        let start = Vector2::new(sampler.between(-1.0, 1.0), sampler.between(-1.0, 1.0));
        let (mut here, mut size) = (start, 1.0_f64);
        for _ in 0..j {
            here = map.a * here + map.b * factor;
            size = size.max(here.amax());
        }
        let LinearisedMap { a, b } = printed_iterate(&map, j);
        let entries = (1.0 + map.a.amax()) * (1.0 + map.a.amax());
        deviations.see((a * start + b * factor - here).amax() / (entries * (size + a.amax() + b.amax())));
    }
    Ok(deviations.outcome(ROUNDING, "affine maps with (τ, δ) in the trapesium, j = 1 to 12"))
}

/// u⁽⁰⁾ = 0 and w⁽⁰⁾ = −b_1p / (a₁₂ β).
pub(crate) fn start() -> CheckResult {
    over_oscillators(
        |point, p, path| {
            let b = printed_iterate(&point.map, p).b;
            let w = -b.x / (point.map.a.m12 * point.map.transversality());
            (path[0] - Vector2::new(0.0, w)).amax()
        },
        OSCILLATORS,
    )
}

/// eq:ujcodim1proof on oscillators: u⁽ʲ⁾ is made of τ and δ alone.
pub(crate) fn positions_of_oscillators() -> CheckResult {
    over_oscillators(
        |point, p, path| {
            let (tau, delta) = (point.map.trace(), point.map.determinant());
            let deviation = |(j, point): (usize, &Vector2<f64>)| {
                (point.x - scaled_visit_position(j as u32, p, tau, delta)).abs()
            };
            path.iter().enumerate().map(deviation).fold(0.0, f64::max)
        },
        OSCILLATORS,
    )
}

/// eq:ujcodim1proof from eq:affineMapj.
pub(crate) fn positions() -> CheckResult {
    let mut sampler = Sampler::new(3);
    let mut deviations = Deviations::default();
    for index in 0..3000 {
        let p = 1 + index % 12;
        let map = sampled_map(&mut sampler);
        let (tau, delta, beta) = (map.trace(), map.determinant(), map.transversality());
        let (s, last) = (lucas_sequence(p, tau, delta), printed_iterate(&map, p).b);
        let entries = (1.0 + map.a.amax()) * (1.0 + map.a.amax());
        for j in 0..=p {
            // Multiplied by β: u⁽ʲ⁾ β = −A^j₁₂ b_1p / a₁₂ + S_p b_1j.
            let LinearisedMap { a, b } = printed_iterate(&map, j);
            let terms = [-a.m12 * last.x / map.a.m12, s * b.x];
            let size = entries * (1.0 + terms[0].abs() + terms[1].abs() + last.amax() + b.amax());
            let expected = beta * scaled_visit_position(j, p, tau, delta);
            deviations.see((terms[0] + terms[1] - expected) / size);
        }
    }
    Ok(deviations.outcome(ROUNDING, "affine maps with (τ, δ) in the trapesium, p = 1 to 12, j = 0 to p"))
}

/// eq:u1codim1proof.
pub(crate) fn first_position() -> CheckResult {
    let mut sampler = Sampler::new(4);
    let mut deviations = Deviations::default();
    for index in 0..2000 {
        let p = 2 + index % 14;
        let (tau, delta) = sampler.trapesium();
        let pair = Pair::new(tau, delta);
        let size = pair.moduli().t(p).re;
        deviations.see((pair.t(p) + scaled_visit_position(1, p as u32, tau, delta)).norm() / size);
    }
    // As for eq:SpTp.
    Ok(deviations.outcome(1e-13, "points of the trapesium, p = 2 to 15"))
}

/// eq:upm1codim1proof.
pub(crate) fn last_position() -> CheckResult {
    let mut sampler = Sampler::new(5);
    let mut deviations = Deviations::default();
    for index in 0..2000 {
        let p = 2 + index % 14;
        let (tau, delta) = sampler.trapesium();
        let pair = Pair::new(tau, delta);
        let raised = libm::pow(delta, f64::from(p - 2));
        let size = pair.moduli();
        let terms = (size.s(p - 1) * size.t(p) + size.s(p) * size.t(p - 1) + size.h(p) * raised).re;
        let last = scaled_visit_position(p as u32 - 1, p as u32, tau, delta);
        deviations.see((pair.h(p) * raised + last).norm() / terms);
    }
    // As for eq:Hp9.
    Ok(deviations.outcome(1e-13, "points of the trapesium, p = 2 to 15"))
}

/// τ above h_p by a share of the way to δ + 1, both in (0, 1).
fn above(p: u32, [x, y]: [f64; 2]) -> Option<(f64, f64)> {
    let delta = determinant(x);
    let lowest = admissibility_boundary(p, delta).ok()?;
    Some((along(along(y, 1e-6, 1.0), lowest, delta + 1.0), delta))
}

/// r to the power of an integer, r = √δ.
fn r_to(delta: f64, k: u32) -> f64 {
    libm::pow(delta, 0.5 * f64::from(k))
}

/// T_p > 0 and H_p > 0, and so u⁽¹⁾ < 0 and u⁽ᵖ⁻¹⁾ < 0, for τ > h_p.
pub(crate) fn ends_are_negative() -> CheckResult {
    let over = "searches over h_p < τ ≤ δ + 1 up to 10⁻⁶ of its length from h_p, p = 2 to 15: the smallest T_p and r^(p−2) H_p";
    Ok(search(2, over, |p, point| {
        let Some((tau, delta)) = above(p, point) else { return f64::NEG_INFINITY };
        lucas_partial_sum(p, tau, delta).min(admissibility_sum(p, tau, delta) * r_to(delta, p - 2))
    }))
}

/// u⁽ʲ⁾ < 0 for all 0 < j < p and τ > h_p: the conclusion of the proof.
pub(crate) fn all_are_negative() -> CheckResult {
    let over = "searches over h_p < τ ≤ δ + 1 up to 10⁻⁶ of its length from h_p, p = 2 to 15: the smallest −r^(1−j) u⁽ʲ⁾";
    Ok(search(2, over, |p, point| {
        let Some((tau, delta)) = above(p, point) else { return f64::NEG_INFINITY };
        let scaled = |j: u32| -scaled_visit_position(j, p, tau, delta) / r_to(delta, j - 1);
        (1..p).map(scaled).fold(f64::INFINITY, f64::min)
    }))
}

/// The sum of a truncated geometric series.
pub(crate) fn geometric_series() -> CheckResult {
    let mut sampler = Sampler::new(6);
    let mut deviations = Deviations::default();
    for index in 0..1000 {
        let n = 1 + index % 20;
        let r = sampler.between(-1.5, 1.5);
        let (sum, power) = (0..n).fold((0.0, 1.0), |(sum, power), _| (sum + power, power * r));
        // The numerator cancels near r = 1.
        deviations.see((sum * (1.0 - r) - (1.0 - power)) / (1.0 + power.abs()));
    }
    // Twenty roundings.
    Ok(deviations.outcome(1e-13, "ratios between −1.5 and 1.5, one to twenty terms"))
}

/// S_j at τ = δ + 1.
pub(crate) fn sums_at_unit_eigenvalue() -> CheckResult {
    let mut sampler = Sampler::new(7);
    let mut deviations = Deviations::default();
    for index in 0..1000 {
        let p = 2 + index % 14;
        let delta = sampler.between(0.001, 0.999);
        let pair = Pair::new(delta + 1.0, delta);
        deviations.see((pair.first - 1.0).norm() * (1.0 - delta));
        deviations.see((pair.second - delta).norm() * (1.0 - delta));
        let top = libm::pow(delta, f64::from(p));
        // The quotients, multiplied by their denominators.
        let s = lucas_sequence(p, delta + 1.0, delta) * (1.0 - delta);
        deviations.see((s - (1.0 - top)) / f64::from(p));
        let t = lucas_partial_sum(p, delta + 1.0, delta) * (1.0 - delta) * (1.0 - delta);
        deviations.see((t - (f64::from(p) * (1.0 - delta) - (1.0 - top))) / f64::from(p * p));
    }
    // δ + 1 is rounded, which changes an eigenvalue by that over 1 − δ.
    Ok(deviations.outcome(1e-14, "λ₁, λ₂, S_p and T_p for determinants from 0.001 to 0.999, p = 2 to 15"))
}

/// eq:ujeig1.
pub(crate) fn positions_at_unit_eigenvalue() -> CheckResult {
    let mut sampler = Sampler::new(8);
    let mut deviations = Deviations::default();
    for index in 0..1000 {
        let p = 2 + index % 14;
        let delta = sampler.between(0.001, 0.999);
        let raised = |k: u32| libm::pow(delta, f64::from(k));
        for j in 1..p {
            let expected = f64::from(j) * (1.0 - raised(p)) - f64::from(p) * (1.0 - raised(j));
            let u = scaled_visit_position(j, p, delta + 1.0, delta);
            // S and T reach p and p², and cancel.
            let size = 1.0 + f64::from(p * p * p) * (1.0 - delta) * (1.0 - delta);
            deviations.see((u * (1.0 - delta) * (1.0 - delta) - expected) / size);
        }
    }
    Ok(deviations.outcome(1e-14, "determinants from 0.001 to 0.999, p = 2 to 15, all j"))
}

/// fig:I: the path starts and ends on the w-axis.
pub(crate) fn ends_on_axis() -> CheckResult {
    over_oscillators(|_, p, path| path[0].x.abs().max(path[p as usize].x.abs()), OSCILLATORS)
}

/// The path of a map with this trace and determinant. Others differ by an affine change of the w-coordinate, which does not
/// matter to convexity; this one turns by equal angles where the eigenvalues are complex.
fn path(p: u32, tau: f64, delta: f64) -> Vec<Vector2<f64>> {
    let discriminant = 0.25 * tau * tau - delta;
    let a12 = discriminant.abs().sqrt().max(0.1 * delta.sqrt());
    // β = a₁₂ b₂ = 1.
    let map = LinearisedMap {
        a: Matrix2::new(0.5 * tau, a12, discriminant / a12, 0.5 * tau),
        b: Vector2::new(0.0, 1.0 / a12),
    };
    let s = lucas_sequence(p, tau, delta);
    let mut here = Vector2::new(0.0, -printed_iterate(&map, p).b.x / a12);
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

/// The smallest sine of the angles under which the other vertices are seen from the edges of the closed polygon: positive if
/// and only if it is strictly convex with its vertices in this order.
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

/// Whether two segments that share no vertex have a point in common.
fn cross_each_other([a, b]: [Vector2<f64>; 2], [c, d]: [Vector2<f64>; 2]) -> bool {
    let side = |from: Vector2<f64>, to: Vector2<f64>, point: Vector2<f64>| cross(to - from, point - from);
    side(a, b, c) * side(a, b, d) <= 0.0 && side(c, d, a) * side(c, d, b) <= 0.0
}

/// The path is convex for h_p < τ < δ + 1, by search for the smallest of the numbers that decide it.
///
/// With e = p₁ − p₀ and c = e × Ae, a vertex n − 1 after the end of the edge at i lies on the side of δⁱ T_n c of it, one n before
/// its start on that of δ^(i−1) H_(n+1) c, and u⁽ʲ⁾ tells the side of the edge that closes the polygon. So the polygon is convex, and its
/// vertices in order, exactly if T_n > 0 and H_n > 0 for n = 2, …, p and u⁽ʲ⁾ < 0 for 0 < j < p.
pub(crate) fn convex() -> CheckResult {
    let over = "searches over h_p < τ ≤ δ + 1 up to 10⁻⁶ of its length from h_p, p = 2 to 15: the smallest T_n, r^(n−2) H_n and \
                −r^(1−j) u⁽ʲ⁾, n ≤ p, j < p";
    Ok(search(2, over, |p, point| {
        let Some((tau, delta)) = above(p, point) else { return f64::NEG_INFINITY };
        (2..=p)
            .map(|n| {
                let h = admissibility_sum(n, tau, delta) * r_to(delta, n - 2);
                let u = -scaled_visit_position(n - 1, p, tau, delta) / r_to(delta, n - 2);
                lucas_partial_sum(n, tau, delta).min(h).min(u)
            })
            .fold(f64::INFINITY, f64::min)
    }))
}

/// The path seen as a polygon: convex, in order and without intersections for τ > h_p, and not convex for smaller τ (p ≥ 3),
/// although Q is affine there too.
pub(crate) fn polygon() -> CheckResult {
    let mut sampler = Sampler::new(9);
    let mut votes = Votes::default();
    for index in 0..3000 {
        let p = 2 + index % 7;
        // For smaller determinants the path shrinks below its rounding.
        let delta = sampler.between(0.2, 0.98);
        let boundary = admissibility_boundary(p, delta)?;
        let tau = sampler.between(-0.999 * (delta + 1.0), 0.999 * (delta + 1.0));
        if (tau - boundary).abs() < 1e-3 || p == 2 && tau < boundary {
            continue;
        }
        let vertices = path(p, tau, delta);
        let convex = convexity(&vertices) > 1e-12;
        votes.see(convex == (tau > boundary));
        if tau > boundary {
            let edge = |i: usize| [vertices[i], vertices[i + 1]];
            let apart = |i: usize, k: usize| !cross_each_other(edge(i), edge(k));
            votes.see((0..p as usize).all(|i| (i + 2..p as usize).all(|k| apart(i, k))));
        }
    }
    Ok(votes.outcome("paths for τ on either side of h_p, p = 2 to 8, as polygons of computed vertices"))
}

/// As τ decreases from δ + 1, no u⁽ˡ⁾ vanishes before τ = h_p, and there it is u⁽ᵖ⁻¹⁾ (p ≥ 3).
pub(crate) fn first_zero() -> CheckResult {
    let mut sampler = Sampler::new(10);
    let mut votes = Votes::default();
    for index in 0..600 {
        let p = 3 + index % 13;
        let delta = sampler.between(0.001, 0.999);
        let boundary = admissibility_boundary(p, delta)?;
        let scaled = |j: u32, tau: f64| scaled_visit_position(j, p, tau, delta) / r_to(delta, j - 1);
        for k in 1..50 {
            let tau = along(f64::from(k) / 50.0, boundary, delta + 1.0);
            votes.see((1..p).all(|j| scaled(j, tau) < 0.0));
        }
        // At h_p itself, to the p² roundings of terms of order p.
        votes.see(scaled(p - 1, boundary).abs() < 1e-11);
        votes.see((1..p - 1).all(|j| scaled(j, boundary) < -1e-6));
        votes.see(scaled(p - 1, boundary - 1e-4 * delta.sqrt()) > 0.0);
    }
    Ok(votes
        .outcome("600 determinants, p = 3 to 15, fifty values of τ each from δ + 1 down to h_p and beyond"))
}

/// u⁽ʲ⁾ depends on the map through τ and δ alone, so that it may be followed in τ at fixed δ.
pub(crate) fn invariance() -> CheckResult {
    let mut sampler = Sampler::new(11);
    let mut deviations = Deviations::default();
    for index in 0..1000 {
        let p = 2 + index % 7;
        let (tau, delta) = sampler.trapesium();
        let expected: Vec<f64> = path(p, tau, delta).iter().map(|point| point.x).collect();
        let map = map_with(&mut sampler, tau, delta);
        let (s, beta) = (lucas_sequence(p, tau, delta), map.transversality());
        let mut here = Vector2::new(0.0, -printed_iterate(&map, p).b.x / map.a.m12);
        // Multiplied by β, which may be small.
        let size = (1.0 + here.amax()) * (1.0 + map.a.amax()) * (1.0 + map.a.amax());
        for position in expected {
            deviations.see((here.x - beta * position) / (size * (1.0 + position.abs())));
            here = map.a * here + map.b * s;
        }
    }
    // The balanced map divides by a₁₂, at least a tenth of r ≥ 0.03.
    Ok(deviations.outcome(1e-11, "pairs of maps with the same τ and δ, p = 2 to 8"))
}
