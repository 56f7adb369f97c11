//! The bifurcation curves near a resonance: eq:Upsilon1, eq:Upsilonp and their consequences.

use crate::checks::main_results::coefficients::resonant;
use crate::*;

/// Rounding of located velocities, phases and positions: quotients of derivatives.
pub(super) const PHASE: f64 = 1e-13;
/// Rounding of a located μ; it enters V directly.
const PARAMETER: f64 = 1e-15;

/// The η at which the leading term gives this impact velocity.
pub(super) fn eta_at(curve: &TheoremCurve, velocity: f64) -> f64 {
    velocity / curve.leading.impact_velocity_slope
}

/// The orders of remainders, one for each loop at most, along both curves in y, which is proportional to
/// η.
pub(super) fn along_curves(
    place: &ResonantSpecimen,
    stated: f64,
    rounding: f64,
    remainders: impl Fn(&TheoremCurve, f64, &Near) -> Option<Vec<f64>>,
) -> Vec<Observed> {
    let mut found = Vec::new();
    for curve in &place.curves() {
        let values = remembered(|size| {
            let eta = eta_at(curve, size);
            remainders(curve, eta, &place.on_curve(curve, eta)?)
        });
        for index in 0..place.loops() as usize {
            let mut seen = false;
            let observed = order(|size| {
                let value = *values(size)?.get(index)?;
                seen = true;
                Some((value, rounding))
            });
            found.extend(seen.then_some((observed, stated)));
        }
    }
    found
}

fn velocity_orders(place: &ResonantSpecimen) -> Result<Vec<Observed>, CheckError> {
    Ok(along_curves(place, 2.0, PHASE, |curve, eta, near| {
        Some(vec![near.unknowns[0] - curve.leading.impact_velocity_slope * eta])
    }))
}

/// μ minus c_SN η² on the SN and c_PD η² on the PD curve, from M(Υ⁺, η) and M(Υ⁻, η).
fn coefficient_orders(place: &ResonantSpecimen) -> Result<Vec<Observed>, CheckError> {
    let branch = place.point().branch_expansion();
    Ok(quadratic_orders(place, |curve, eta| branch.parameter(curve.leading.impact_velocity_slope * eta, eta)))
}

/// The orders of μ minus a quadratic approximation on both curves.
///
/// At each size the larger remainder at η and −η is used, so that terms of higher order do not cancel.
pub(crate) fn quadratic_orders(
    place: &ResonantSpecimen,
    stated: impl Fn(&TheoremCurve, f64) -> f64,
) -> Vec<Observed> {
    along_curves(place, 3.0, PARAMETER, |curve, eta, near| {
        let other = place.on_curve(curve, -eta)?;
        let [here, there] = [near, &other].map(|near| (near.relative()[1] - stated(curve, eta)).abs());
        Some(vec![here.max(there)])
    })
}

/// The orders of μ minus the theorem's quadratic approximations, each only on its side of η = 0.
fn approximations(seed: u64, which: Loops) -> CheckResult {
    let measure = |place: &ResonantSpecimen| {
        let approximation = |curve: &TheoremCurve, eta: f64| {
            let stated = curve.leading.parameter(eta).filter(|_| curve.leading.parameter(-eta).is_none());
            stated.unwrap_or(f64::NAN)
        };
        quadratic_orders(place, approximation)
    };
    let mut found = all_orders(which.clone(), |place| Ok(measure(place)))?;
    let (mut sampler, loops) = (Sampler::new(seed), Vec::from_iter(which));
    for _ in 0..30 {
        found.extend(measure(&resonant(&mut sampler, &loops)?));
    }
    Ok(of_orders(&found, &format!("{EVERYWHERE}, and of random oscillators with ψ ≠ 0")))
}

/// The orders for M(Υ^±, η) with Υ⁺ in both, as printed.
fn printed_orders(place: &ResonantSpecimen) -> Result<Vec<Observed>, CheckError> {
    let branch = place.point().branch_expansion();
    let fold = place.point().saddle_node_velocity_slope();
    Ok(quadratic_orders(place, |_, eta| branch.parameter(fold * eta, eta)))
}

/// Tests that an MPS on the curves is admissible for the stated sign of η, and that y < 0 for the other.
fn sides(place: &ResonantSpecimen, cases: &mut Votes) -> Result<(), CheckError> {
    for curve in place.curves() {
        let sign = curve.leading.eta_side.signum();
        for velocity in [1e-3, 3e-4, 1e-4] {
            let eta = sign * eta_at(&curve, velocity).abs();
            let Some((right, wrong)) = place.on_curve(&curve, eta).zip(place.on_curve(&curve, -eta)) else {
                // The leading terms hold over a smaller range where s^- is small.
                continue;
            };
            let solution = place.solution(&right);
            cases.see(solution.admissible() && wrong.unknowns[0] < 0.0);
        }
    }
    Ok(())
}

const SIDES: &str =
    "points of SN and PD curves for both signs of η: admissible for the stated one, y < 0 for the other";

checks! {
    /// Two zeros of V separate from the SN curve like a square root: the exponent, less 1/2.
    // The next term changes the exponent by the squared relative distance, about 10⁻³.
    square_root: everywhere(ANY) |place; largest: Deviations| {
        let [fold, _] = place.curves();
        let k_2 = place.point().branch_expansion().k_2;
        for velocity in [0.01, 0.03] {
            let Some(at) = place.on_curve(&fold, eta_at(&fold, velocity)) else { continue };
            let eta = eta_at(&fold, velocity);
            let [_, mu_fold] = at.relative();
            let separated = |change: f64| {
                // Two points of the branch at the same μ, by the secant method in y.
                let zero = |side: f64| {
                    let mu = |y: f64| Some(place.on_branch(y, eta)?.relative()[1] - mu_fold - change);
                    let half = (change / k_2).sqrt() * side;
                    let (mut a, mut b) = (at.unknowns[0] + half, at.unknowns[0] + 1.01 * half);
                    let (mut at_a, mut at_b) = (mu(a)?, mu(b)?);
                    for _ in 0..8 {
                        if at_b == at_a {
                            break;
                        }
                        let next = b - at_b * (b - a) / (at_b - at_a);
                        (a, at_a, b) = (b, at_b, next);
                        at_b = mu(b)?;
                    }
                    Some(b)
                };
                Some(zero(1.0)? - zero(-1.0)?)
            };
            // A 32nd and a 64th of y from the fold: the next terms are of the size of their squares.
            let change = k_2 * at.unknowns[0] * at.unknowns[0] / 1024.0;
            let (wide, narrow) =
                separated(change).zip(separated(change / 4.0)).ok_or("no zeros beyond a fold")?;
            largest.see(libm::log2(wide / narrow) / 2.0 - 0.5);
        }
    } => largest.outcome(1e-4, "exponents on either fold: zeros of V at two distances from SN curves");
    /// eq:coeffs1 and eq:coeffsp follow from k₂, k₃ and Υ^±, with T_p and f_p.
    // Tens of roundings; T_p is used in closed form on one side only, where κ_p is up to 10⁻¹³.
    simplification: everywhere(ANY) |place; largest: Deviations| {
        let branch = place.point().branch_expansion();
        for TheoremCurve { leading, .. } in place.curves() {
            let slope = leading.impact_velocity_slope;
            let terms = (branch.k_2 * slope * slope).abs() + (branch.k_3 * slope).abs();
            largest.compare(branch.parameter(slope, 1.0), leading.coefficient, terms);
        }
    } => largest.outcome(1e-13, "resonances with p up to 5");
    /// eq:sn1 and eq:pd1.
    quadratic_for_one_loop: approximations(66, ONE);
    /// eq:snp and eq:pdp.
    quadratic_for_many_loops: approximations(70, MANY);
    /// eq:Upsilon1.
    velocity_of_one_loop: orders(ONE, EVERYWHERE, velocity_orders);
    /// eq:Upsilonp.
    velocity_of_many_loops: orders(MANY, EVERYWHERE, velocity_orders);
    /// g_SN = M(Υ⁺, η) and g_PD = M(Υ⁻, η), p = 1; the print has Υ⁺ in both.
    functions_of_one_loop: orders_against_print(ONE, coefficient_orders, printed_orders);
    /// g_SN = M(Υ⁺, η) and g_PD = M(Υ⁻, η), p ≥ 2; the print has Υ⁺ in both.
    functions_of_many_loops: orders_against_print(MANY, coefficient_orders, printed_orders);
    /// With sgn η = sgn(a₁₂' s₁^±) the one-loop MPS is admissible on the curves.
    admissible_with_one_loop: everywhere(ONE, sides).map(|cases| cases.outcome(SIDES));
    /// With sgn η = sgn(κ_p' s_p^±) the p-loop MPS is admissible on the curves.
    admissible_with_many_loops: everywhere(MANY, sides).map(|cases| cases.outcome(SIDES));
}
