//! Section 4.4, step 1 of the proofs of theorems 2.2 and 2.3: the zero of V and its points on Π.

use super::maps::{impact_and_recoil, virtual_point};
use super::vivid::{derivatives, scale};
use crate::checks::appendices::signs::{determinant, search};
use crate::*;
use grazing_theorems::grazing::EmergingOrbit;

/// The smallest order of a remainder at the zero of V for ±μ, over oscillators and loops.
fn smallest_order(
    loops: core::ops::RangeInclusive<u32>,
    stated: f64,
    remainder: impl Fn(&Grazing, &EmergingOrbit, f64) -> Option<f64>,
) -> CheckResult {
    let mut orders = Smallest::default();
    for (grazing, p) in specimens_with(loops)? {
        let emerging = grazing.grazing_point().emerging_orbit(p)?;
        let size = scale(&grazing, p).ok_or("no emerging orbit")?;
        let inverse = derivatives(&grazing, p)?.by_impact.try_inverse().ok_or("det J = 0")?;
        // The rounding of a phase for each return, propagated to the zero.
        let rounding = 2e-15 * f64::from(p + 1) * (1.0 + inverse.amax());
        orders.see(uniform_order(&[[size], [-size]], |[direction], h| {
            Some((remainder(&grazing, &emerging, h * direction)?, rounding))
        }));
    }
    // The next term is of relative size h < 10⁻³ at the last size, but its coefficient is large near
    // resonance.
    Ok(orders.order(stated, 0.1, "the zero of V by Newton's method on twelve oscillators, μ of both signs"))
}

/// The order at which y and z of the zero of V follow their first-order change with μ.
fn zero_order(loops: core::ops::RangeInclusive<u32>, component: usize) -> CheckResult {
    smallest_order(loops, 2.0, |grazing, emerging, mu| {
        let zero = zero(grazing, emerging.loops, mu)?;
        let first_order = [
            zero[0] - emerging.impact_velocity_slope * mu,
            zero[1] - grazing.phase() - emerging.impact_phase_slope * mu,
        ];
        Some(first_order[component])
    })
}

/// The points (x⁽⁰⁾, z⁽⁰⁾) and (x⁽ᵖ⁾, z⁽ᵖ⁾) of the zero of V, the last one by p returns.
fn ends(grazing: &Grazing, p: u32, mu: f64) -> Option<[Vector2<f64>; 2]> {
    let point = zero(grazing, p, mu)?;
    let oscillator = equations(grazing, p).oscillator_at(&point);
    let [_, recoil] = impact_and_recoil(&oscillator, point[0], point[1]);
    let first = virtual_point(&oscillator, recoil).ok()?;
    let last = global_iterate::<_, 1>(&oscillator, p, AtRest::new(first[0], first[1])).ok()?.value;
    Some([first, last])
}

/// The order at which a position equals that of a virtual map at the first-order impact velocity.
fn position_order(index: usize, map: fn(&GrazingPoint) -> VirtualMap) -> CheckResult {
    smallest_order(1..=4, 3.0, |grazing, emerging, mu| {
        let leading = map(&grazing.grazing_point()).apply(emerging.impact_velocity_slope * mu, 0.0);
        Some(ends(grazing, emerging.loops, mu)?[index][0] - leading[0])
    })
}

/// The order at which a phase follows the first-order change with μ of the first or the last visit.
fn end_phase_order(index: usize) -> CheckResult {
    smallest_order(1..=4, 2.0, |grazing, emerging, mu| {
        let p = emerging.loops;
        let slope = emerging.visit_slope([0, p][index]).y;
        Some(ends(grazing, p, mu)?[index][1] - grazing.phase() - slope * mu)
    })
}

/// A grazing point with τ > h_p; a₁₂ and α of either sign.
fn above_boundary(sampler: &mut Sampler, p: u32) -> GrazingPoint {
    let delta = sampler.between(0.01, 0.99);
    let lowest = admissibility_boundary(p, delta).expect("p ≥ 2 and 0 < δ < 1");
    let share = sampler.between(0.001, 0.999);
    let map = map_with(sampler, lowest + share * (delta + 1.0 - lowest), delta);
    let mut point = sampled_point(sampler, map);
    if sampler.between(0.0, 1.0) < 0.3 {
        // γψ/ω between 2 and 5, so that α < 0.
        point.psi = sampler.between(2.1, 5.0) * point.forcing_frequency / point.gamma;
    }
    point
}

checks! {
    /// V = 0 has one solution (y, z) near grazing: Newton's method converges to it from all starts.
    implicit_function: drawn_over(1, specimens_with(1..=4)?) |sampler, (grazing, p); votes: Votes| {
        let equations = equations(&grazing, p);
        for sign in [1.0, -1.0] {
            let mu = sign * 0.002 * scale(&grazing, p).ok_or("no emerging orbit")?;
            let expected = zero(&grazing, p, mu).ok_or("no zero of V")?;
            let reach = 5.0 * (expected[0].abs() + (expected[1] - grazing.phase()).abs());
            for _ in 0..6 {
                let mut start = expected.clone();
                start[0] += sampler.between(-reach, reach);
                start[1] += sampler.between(-reach, reach);
                let found = at_parameters(&equations, start);
                votes.see(found.is_some_and(|found| (found - &expected).amax() < 1e-10));
            }
            votes.see(vivid(&equations, &expected).is_some_and(|value| value.amax() < 1e-13));
        }
    } => votes.outcome("starts up to five times as far from the solution as grazing is, twelve oscillators, p = 1 to 4");
    /// The one-loop MPS has y > 0 on the side of sgn(a₁₂ β) if α > 0, on the other if α < 0.
    one_loop_side: over(specimens()?.into_iter().chain(delayed()?)) |grazing; votes: Votes| {
        let point = grazing.grazing_point();
        let size = 0.01 * scale(&grazing, 1).ok_or("no emerging orbit")?;
        for mu in [size, -size] {
            let y = zero(&grazing, 1, mu).ok_or("no zero of V")?[0];
            votes.see(
                (y > 0.0)
                    == match GenericGrazing::check(&point, 1) {
                        Ok(theorem) => theorem.side().signum() * mu > 0.0,
                        // α < 0: the MPS is on the other side.
                        Err(_) => point.map.a.m12 * point.map.transversality() * mu < 0.0,
                    },
            );
        }
    } => votes.outcome("twelve oscillators with α > 0 and three with α < 0, where the hypothesis is violated, μ of both signs");
    /// For τ > h_p and τ ≠ g_p: det J has the sign of α a₁₂ κ_p; dy*/dμ has the sign of βκ_p if
    /// a₁₂α > 0, and the other sign where this hypothesis is violated; and on the side of the sign
    /// of βκ_p all visits between the impacts lie below the wall: dx⁽ʲ⁾/dμ has the other sign.
    side: sampled(2, 2000, 2..=15) |sampler, p; votes: Votes| {
        let point = above_boundary(sampler, p);
        let kappa = detuning(p, point.map.trace(), point.map.determinant());
        let side = point.map.transversality() * kappa;
        let factor = point.map.a.m12 * point.alpha();
        votes.see(point.impact_jacobian_determinant(p) * factor * kappa > 0.0);
        let orbit = point.emerging_orbit(p).expect("det J is not zero");
        votes.see((orbit.impact_velocity_slope * side > 0.0) == (factor > 0.0));
        let stated = GenericGrazing::check(&point, p).map(|theorem| theorem.side().signum() * side > 0.0);
        votes.see(stated.unwrap_or(factor < 0.0));
        // Positions decrease with the eigenvalues, down to the rounding of their terms.
        let rounding = 1e-12 * (1.0 + orbit.visit_slope(0).amax()) * (1.0 + point.map.a.amax());
        votes.see((1..p).all(|j| orbit.visit_slope(j).x * side.signum() < rounding));
    } => votes.outcome("grazing points with τ > h_p, a₁₂α of either sign, p = 2 to 15, all visits");
    /// det K / β > 0 in the trapesium, by search.
    sign_of_det_k: search(2..=15, "the trapesium up to 10⁻⁶ from its slanted sides", "det K / β", |p, [x, y]| {
        let delta = determinant(x);
        geometric_sum_determinant(p, 0.999_999 * (2.0 * y - 1.0) * (delta + 1.0), delta)
    });
    /// eq:yStar1codim1proof.
    one_loop_velocity: zero_order(1..=1, 0);
    /// eq:zStar1codim1proof.
    one_loop_phase: zero_order(1..=1, 1);
    /// eq:yStarpcodim1proof.
    velocity: zero_order(2..=4, 0);
    /// eq:zStarpcodim1proof.
    phase: zero_order(2..=4, 1);
    /// eq:x0codim1proof.
    first_position: position_order(0, GrazingPoint::virtual_map_after_reset);
    /// eq:z0codim1proof.
    first_phase: end_phase_order(0);
    /// eq:xpcodim1proof.
    last_position: position_order(1, GrazingPoint::virtual_map);
    /// eq:zpcodim1proof.
    last_phase: end_phase_order(1);
}
