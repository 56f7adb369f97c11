//! Section 2.4: the auxiliary functions g_p, H_p and h_p, and their consequences for Figure 2.

use super::theorems::general::side_of_orbit;
use super::theorems::only;
use crate::checks::appendices::signs::{scaled_h, search};
use crate::*;
use grazing_theorems::admissibility_region::{AdmissibilityRegion, admissibility_margin, rotation};

/// Figure 2's (τ, δ), the star of Figure 4: g₂ < τ, and h_p < τ < g_p for p = 3, 4, 5 only; by theorem
/// 2.3 two loops then emerge to the right and three to five to the left.
pub(crate) fn star() -> CheckResult {
    let oscillator = grazing_theorems::LinearOscillator::new(printed("zeta"), printed("epsilon"))?;
    let grazing = oscillator.grazing(printed("fig02_frequency"))?;
    let (tau, delta) = (grazing.trace(), grazing.determinant());
    let mut cases = Votes::default();
    cases.see(tau > resonance_boundary(2.0, delta));
    for p in 3..=40 {
        let inside = admissibility_boundary(p, delta)? < tau && tau < resonance_boundary(f64::from(p), delta);
        cases.see(inside == (3..=5).contains(&p));
    }
    let orbit = Law::linear(printed("zeta"), printed("epsilon")).grazing(printed("fig02_frequency"))?;
    for p in 1..=5 {
        let side = GenericGrazing::check(&orbit.grazing_point(), p)?.side();
        cases.see((side == Side::Positive) == (p <= 2));
        cases.see(side_of_orbit(&orbit, p)? == Existence::On(side));
    }
    Ok(cases.outcome("p = 2 to 40 at the star; p = 1 to 5 in the hybrid system on both sides of grazing"))
}

/// p-loop MPSs with τ < h_p(δ) exist near δ = 1 for p = 5 and p ≥ 7, not for p = 3, 4, 6: by the
/// signs of all u⁽ʲ⁾ over a grid of the trapesium, and in simulation. They exist for p = 2 too,
/// where h₂ = −2√δ and u⁽¹⁾ = −1, with real eigenvalues, which no linear oscillator has.
pub(crate) fn beyond_the_boundary() -> CheckResult {
    let (mut cases, mut printed) = (Votes::default(), Votes::default());
    printed.see(!two_loops_below_the_boundary()?);
    cases.see(two_loops_below_the_boundary()?);
    for p in 3..=14 {
        let mut found: Option<(f64, f64)> = None;
        for delta in [0.3, 0.7, 0.9, 0.97, 0.999] {
            let boundary = admissibility_boundary(p, delta)?;
            // From −(δ + 1) to h_p, away from the ends by more than rounding.
            let length = boundary + 1.0 + delta;
            const STEPS: i32 = 1500;
            let admissible = |k: &i32| {
                let tau = -1.0 - delta + length * (f64::from(*k) + 0.5) / f64::from(STEPS);
                lucas_sequence(p, tau, delta) != 0.0
                    && (1..p).all(|j| scaled_visit_position(j, p, tau, delta) < 0.0)
            };
            let inside: Vec<i32> = (0..STEPS).filter(admissible).collect();
            if let Some(middle) = inside.get(inside.len() / 2) {
                found = Some((-1.0 - delta + length * (f64::from(*middle) + 0.5) / f64::from(STEPS), delta));
            }
        }
        cases.see(found.is_some() == (p == 5 || p >= 7));
        printed.see(found.is_some() == (p == 5 || p >= 7));
        if let Some((tau, delta)) = found {
            cases.see(matches!(observed(p, tau, delta, Side::Positive)?.0, Existence::On(_)));
        }
    }
    let over = "p = 2 to 14, p ≥ 3 on grids of the trapesium, and an oscillator for each p found";
    Ok(cases.outcome(over).against_print(printed.measure()))
}

/// Whether an oscillator with τ ≤ −2√δ has a two-loop MPS on the side of βκ₂, as for larger τ.
///
/// Near a p = 1 resonance of a nonlinear force the eigenvalues are near a₁₁ ≠ a₂₂.
fn two_loops_below_the_boundary() -> Result<bool, CheckError> {
    let law = Law { delay: Exponential::constant(0.0), ..Law::nonlinear(damping_for_decay(1, 1, 0.5)) };
    let resonance = law.resonance(1, 1)?;
    let [_, omega] = resonance.orbit().oscillator().parameters();
    // On the side where a₁₂ > 0.
    let off = libm::copysign(1e-3, resonance.resonant_point().unfolding.derivative);
    let orbit = law.grazing(omega * (1.0 + off))?;
    let point = orbit.grazing_point();
    let (tau, delta) = (point.map.trace(), point.map.determinant());
    let violated = GenericGrazing::check(&point, 2).err();
    let only_the_margin = violated.is_some_and(|violated| only(&violated, Quantity::AdmissibilityMargin));
    let stated = Existence::On(Side::of(point.map.transversality() * detuning(2, tau, delta)));
    Ok(only_the_margin && side_of_orbit(&orbit, 2)? == stated)
}

/// The side on which simulation of the linear oscillator with this trace and determinant finds p-loop
/// MPSs near grazing, and the sign of β. The rotation of its grazing orbits is 2πω₁/ω = 2π(1 + x), where
/// 0 < x < ½ makes a₁₂ positive.
fn observed(p: u32, tau: f64, delta: f64, factor: Side) -> Result<(Existence, Side), CheckError> {
    let turns = 1.0 + rotation(tau, delta, factor);
    let ratio = -libm::log(delta) / (4.0 * PI * turns);
    let zeta = ratio / (1.0 + ratio * ratio).sqrt();
    let orbit = Law::linear(zeta, 0.7).grazing((1.0 - zeta * zeta).sqrt() / turns)?;
    let map = orbit.grazing_point().map;
    if (map.trace() - tau).abs() + (map.determinant() - delta).abs() > 1e-9
        || map.a.m12 * factor.signum() <= 0.0
    {
        return Err("an oscillator with another rotation".into());
    }
    Ok((side_of_orbit(&orbit, p)?, Side::of(map.transversality())))
}

/// The regions of all p-loop MPSs over the trapesium: inside each one simulation finds the MPS on the
/// side βμa₁₂αS_p > 0, and beside it none.
pub(crate) fn regions() -> CheckResult {
    let mut cases = Votes::default();
    for region in (2..=12).flat_map(AdmissibilityRegion::all) {
        let (p, factor, lowest) = (region.loops, region.factor(), region.lowest_determinant());
        for share in [0.2, 0.6, 0.95] {
            let delta = lowest.max(0.3) + share * (1.0 - lowest.max(0.3));
            let ends = region.traces(delta).ok_or("it reaches down to there")?.map(|(tau, _)| tau);
            // Complex eigenvalues, as for linear oscillators.
            let [low, high] = ends.map(|tau| tau.clamp(-1.99 * delta.sqrt(), 1.99 * delta.sqrt()));
            let width = high - low;
            // Away from the resonance of m = 1; no points where all eigenvalues are real.
            for tau in [0.13, 0.47, 0.88].map(|part| low + part * width).into_iter().filter(|_| width > 0.0) {
                let (seen, beta) = observed(p, tau, delta, factor)?;
                let side = beta.signum() * factor.signum() * lucas_sequence(p, tau, delta);
                cases.see(seen == Existence::On(Side::of(side)));
            }
            let is_complex = |tau: f64| tau.abs() < 1.99 * delta.sqrt();
            for (end, tau) in [(ends[0], low - 0.1 * width), (ends[1], high + 0.1 * width)] {
                let is_outside = || admissibility_margin(p, tau, delta, factor).0 < 0.0;
                if width > 0.0 && is_complex(end) && is_complex(tau) && is_outside() {
                    cases.see(observed(p, tau, delta, factor)?.0 == Existence::Nowhere);
                }
            }
        }
    }
    Ok(cases.outcome(
        "oscillators inside and beside all regions of p = 2 to 12, a₁₂α of both signs, at three determinants",
    ))
}

checks! {
    /// eq:gp: (Aᵖ)₁₂ = 0 at τ = g_p(δ), with the sign of a₁₂ above; and g_p for half-integer p.
    // Powers of a matrix of norm two in fifteen steps; the entry results from cancellation.
    resonance_boundary_is_a_zero: drawn(31, 3000) |sampler; largest: Deviations| {
        let p = sampler.one_of(&[2, 3, 4, 5, 6, 7, 9, 12, 15]);
        let delta = sampler.between(0.001, 0.999);
        let boundary = resonance_boundary(f64::from(p), delta);
        largest.compare(boundary, 2.0 * delta.sqrt() * libm::cos(PI / f64::from(p)), 1.0);
        let entry = |tau: f64, a11: f64| {
            let a = Matrix2::new(a11, 1.0, a11 * (tau - a11) - delta, tau - a11);
            (1..p).fold(a, |power, _| power * a)[(0, 1)]
        };
        let a11 = sampler.between(-1.0, 1.0);
        largest.see(entry(boundary, a11).abs());
        let above = boundary + sampler.between(1e-3, 1.0) * (delta + 1.0 - boundary);
        largest.require(entry(above, a11) > 0.0);
        // g_{p/2}: the doubled angle, 2√δ cos(2π/p) = (g_p² − 2δ)/√δ, by the double-angle formula.
        let doubled = (boundary * boundary - 2.0 * delta) / delta.sqrt();
        largest.compare(resonance_boundary(0.5 * f64::from(p), delta), doubled, 1.0 + 1.0 / delta.sqrt());
    } => largest.outcome(1e-12, "p up to 15 and random A with τ = g_p(δ), and with τ above it");
    /// The limit p → ∞: both families tend to 2√δ, with second order in 1/p.
    // Slack for terms in 1/p³ at p near a thousand.
    limit: drawn(35, 10) |sampler; least: Smallest| {
        let delta = sampler.between(0.05, 0.95);
        let end = 2.0 * delta.sqrt();
        for lower in [true, false] {
            least.see_resolved(order(|h| {
                // The size is 1/p; p up to 1024 shows the order.
                let loops = libm::round(1.0 / h) as u32;
                if loops > 1024 {
                    return Some((0.0, 1.0));
                }
                let value = if lower {
                    admissibility_boundary(loops, delta).ok()?
                } else {
                    resonance_boundary(1.0 / h, delta)
                };
                Some((end - value, 1e-15))
            }));
        }
    } => least.order(2.0, 0.05, "g_p and h_p at random δ, p up to 1024");
    /// h_p: H_p vanishes there and H_p/(τ − h_p) > 0 above it, by search; h₂ = −2√δ.
    admissibility_boundary_is_the_largest_zero: search(2..=20, "τ > h_p and the determinant", "r^(p−2) H_p / (τ − h_p)", |p, [d, s]| {
        let delta = 0.01 + 0.989_999 * d;
        let Ok(boundary) = admissibility_boundary(p, delta) else { return f64::NAN };
        // Zero to within roundings of 2√δ times a slope of about p³; H₂ has no zero, and h₂ is defined
        // separately.
        let rounding = 1e-13 * f64::from(p * p * p);
        let off = if p == 2 { boundary + 2.0 * delta.sqrt() } else { scaled_h(p, boundary, delta) };
        if off.abs() > rounding {
            return -1.0;
        }
        // Cubed, so that many points are close to the boundary.
        let above = (1e-4 + s * s * s) * (delta + 1.0 - boundary);
        scaled_h(p, boundary + above, delta) / above
    });
    /// le:admissibilityBoundary: g_{p/2} < h_p < g_{p−1} by search, from δ = 10⁻⁶ to 1 − 10⁻⁶.
    ///
    /// Margins that vanish like 1 − √δ and √δ at an end, beyond 2√δ, are divided by these.
    bounds: search(3..=30, "the determinant", "of both scaled margins", |p, [d, _]| {
        // r = √δ, arbitrarily close to either end.
        let modulus = 1e-3 + (1.0 - 1e-3 - 5e-7) * (d * d * (3.0 - 2.0 * d));
        let (delta, loops) = (modulus * modulus, f64::from(p));
        let Ok(boundary) = admissibility_boundary(p, delta) else { return f64::NAN };
        let below = (boundary - resonance_boundary(0.5 * loops, delta)) / (1.0 - modulus);
        let above = (resonance_boundary(loops - 1.0, delta) - boundary) / modulus;
        below.min(above) / (2.0 * modulus)
    });
}
