//! The bifurcation curves and the orbits on them: eq:Upsilon1 to eq:admp11.

use grazing_continuation::locate::Condition;
use grazing_continuation::mps::Memory;
use grazing_model::ImpactOscillator;
use grazing_model::maps::virtual_map;
use grazing_theorems::auxiliary::{lucas_sequence, resonance_boundary};
use nalgebra::Vector2;

use super::places::{
    Bifurcation, EVERYWHERE, Failure, Loops, Near, Observed, Place, everywhere, lowest, order, remembered,
};
use crate::outcome::{CheckResult, Measure, Outcome};
use crate::sampling::smallest;

/// Rounding of located velocities, phases and positions: on the curves they come from quotients of derivatives.
const PHASE: f64 = 1e-13;

/// Rounding of a located μ; it enters V directly.
const PARAMETER: f64 = 1e-15;

/// η at which the leading term gives this impact velocity.
fn eta_at(curve: &Bifurcation, velocity: f64) -> f64 {
    velocity / curve.leading.impact_velocity_slope
}

/// Both curves: the order of a remainder in the impact velocity, which is in proportion to η.
fn along_curves<O: ImpactOscillator>(
    place: &Place<O>,
    stated: f64,
    rounding: f64,
    remainder: impl Fn(&Bifurcation, f64, &Near<O>) -> Option<f64>,
) -> Vec<Observed> {
    all_along_curves(place, stated, rounding, |curve, eta, near| Some(vec![remainder(curve, eta, near)?]))
}

/// The same for several remainders, whose number is that of the loops at most.
fn all_along_curves<O: ImpactOscillator>(
    place: &Place<O>,
    stated: f64,
    rounding: f64,
    remainders: impl Fn(&Bifurcation, f64, &Near<O>) -> Option<Vec<f64>>,
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

fn velocity_orders<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<Observed>, Failure> {
    Ok(along_curves(place, 2.0, PHASE, |curve, eta, near| {
        Some(near.unknowns[0] - curve.leading.impact_velocity_slope * eta)
    }))
}

/// eq:Upsilon1.
pub(super) fn velocity_of_one_loop() -> CheckResult {
    let orders = everywhere!(Loops::One, velocity_orders);
    Ok(Outcome::new(lowest(&orders), orders.len(), EVERYWHERE))
}

/// eq:Upsilonp.
pub(super) fn velocity_of_many_loops() -> CheckResult {
    let orders = everywhere!(Loops::Many, velocity_orders);
    Ok(Outcome::new(lowest(&orders), orders.len(), EVERYWHERE))
}

/// μ less c_SN η² on the SN and c_PD η² on the PD curve, as M(Υ⁺, η) and M(Υ⁻, η) give them.
fn coefficient_orders<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<Observed>, Failure> {
    let branch = place.point().branch_expansion();
    Ok(along_curves(place, 3.0, PARAMETER, |curve, eta, near| {
        Some(near.relative()[1] - branch.parameter(curve.leading.impact_velocity_slope * eta, eta))
    }))
}

/// The same with Υ⁺ for both curves.
fn printed_orders<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<Observed>, Failure> {
    let branch = place.point().branch_expansion();
    let fold = place.point().saddle_node_velocity_slope();
    Ok(along_curves(place, 3.0, PARAMETER, |_, eta, near| {
        Some(near.relative()[1] - branch.parameter(fold * eta, eta))
    }))
}

fn coefficients(which: Loops) -> CheckResult {
    let orders = everywhere!(which, coefficient_orders);
    let printed = everywhere!(which, printed_orders);
    Ok(Outcome::new(lowest(&orders), orders.len(), EVERYWHERE).against_print(lowest(&printed)))
}

/// g_SN = M(Υ⁺, η) and g_PD = M(Υ⁻, η), p = 1; the print has Υ⁺ in both.
pub(super) fn functions_of_one_loop() -> CheckResult {
    coefficients(Loops::One)
}

/// The same for p ≥ 2.
pub(super) fn functions_of_many_loops() -> CheckResult {
    coefficients(Loops::Many)
}

/// c_SN and c_PD from k₂, k₃ and Υ^±, against eq:coeffs1 and eq:coeffsp.
fn simplification_gaps<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<f64>, Failure> {
    let branch = place.point().branch_expansion();
    let gap = |curve: &Bifurcation| {
        let slope = curve.leading.impact_velocity_slope;
        let terms = (branch.k_2 * slope * slope).abs() + (branch.k_3 * slope).abs();
        (branch.parameter(slope, 1.0) - curve.leading.coefficient).abs() / terms
    };
    Ok(place.curves().iter().map(gap).collect())
}

/// eq:coeffs1 and eq:coeffsp follow from k₂, k₃, Υ^±, T_p and f_p.
pub(super) fn simplification() -> CheckResult {
    let gaps = everywhere!(Loops::Any, simplification_gaps);
    let largest = gaps.iter().copied().fold(0.0, f64::max);
    // Some tens of roundings; T_p is used in closed form on one side only, at κ_p of up to 10⁻¹³.
    Ok(Outcome::new(
        Measure::Deviation { largest, tolerance: 1e-10 },
        gaps.len(),
        "resonances with p up to 5",
    ))
}

/// The exponent with which the two zeros of V separate behind the fold, less 1/2.
fn separation<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<f64>, Failure> {
    let mut found = Vec::new();
    let [fold, _] = place.curves();
    let k_2 = place.point().branch_expansion().k_2;
    for velocity in [0.01, 0.03] {
        let Some(at) = place.on_curve(&fold, eta_at(&fold, velocity)) else { continue };
        let eta = eta_at(&fold, velocity);
        let [_, mu_fold] = at.relative();
        let separated = |change: f64| {
            // The branch as a graph over y: its two points at the same μ, by the secant method from the parabola.
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
        // Distances from the fold of a 32nd and a 64th of y: next terms of the relative size of their squares.
        let change = k_2 * at.unknowns[0] * at.unknowns[0] / 1024.0;
        let (wide, narrow) =
            separated(change).zip(separated(change / 4.0)).ok_or("no zeros beyond a fold")?;
        found.push((libm::log2(wide / narrow) / 2.0 - 0.5).abs());
    }
    Ok(found)
}

/// Two zeros of V separate from the SN curve like the square root of the change of μ.
pub(super) fn square_root() -> CheckResult {
    let gaps = everywhere!(Loops::Any, separation);
    let largest = gaps.iter().copied().fold(0.0, f64::max);
    // The next term of the parabola changes the exponent by the square of the relative distance, some 10⁻³ times curvatures.
    let measure = Measure::Deviation { largest, tolerance: 0.01 };
    Ok(Outcome::new(
        measure,
        gaps.len(),
        "exponents on either fold: zeros of V at two distances from SN curves",
    ))
}

/// Whether an MPS on the curves is admissible for the stated sign of η, and has y < 0 for the other.
fn sides<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<bool>, Failure> {
    let mut found = Vec::new();
    for curve in place.curves() {
        let sign = libm::copysign(1.0, place.point().unfolding.derivative() * curve.stability);
        for velocity in [1e-3, 3e-4, 1e-4] {
            let eta = sign * eta_at(&curve, velocity).abs();
            let Some((right, wrong)) = place.on_curve(&curve, eta).zip(place.on_curve(&curve, -eta)) else {
                // The leading terms reach less far where s^- is small.
                continue;
            };
            let (solution, _) = place.resonance.equations().solution(&right.unknowns);
            found.push(solution.admissible() && wrong.unknowns[0] < 0.0);
        }
    }
    Ok(found)
}

fn admissible(which: Loops) -> CheckResult {
    let cases = everywhere!(which, sides);
    let agreeing = cases.iter().filter(|agrees| **agrees).count();
    let measure = Measure::Agreement { agreeing, cases: cases.len() };
    let over =
        "points of SN and PD curves for both signs of η: admissible for the stated one, y < 0 for the other";
    Ok(Outcome::new(measure, cases.len(), over))
}

/// With sgn η = sgn(a₁₂' s₁^±) the one-loop MPS is admissible on the curves.
pub(super) fn admissible_with_one_loop() -> CheckResult {
    admissible(Loops::One)
}

/// With sgn η = sgn(κ_p' s_p^±) the p-loop MPS is admissible on the curves.
pub(super) fn admissible_with_many_loops() -> CheckResult {
    admissible(Loops::Many)
}

fn phase_orders<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<Observed>, Failure> {
    let symbols = place.symbols()?;
    let k_1 = place.point().branch_expansion().k_1;
    Ok(along_curves(place, 2.0, PHASE, |curve, eta, near| {
        let slope = symbols.alpha * symbols.omega * symbols.f * k_1 / curve.stability;
        Some(near.relative()[0] - slope * eta)
    }))
}

/// eq:admp7.
pub(super) fn phase() -> CheckResult {
    let orders = everywhere!(Loops::Many, phase_orders);
    Ok(Outcome::new(lowest(&orders), orders.len(), EVERYWHERE))
}

/// (x⁽⁰⁾, z⁽⁰⁾) of a point of a curve, the phase counted from z_graz,η.
fn recoil<O: ImpactOscillator>(near: &Near<O>) -> Option<Vector2<f64>> {
    let oscillator = near.oscillator();
    let [y, z] = near.impact().into();
    let reset = oscillator.reset::<1>(y, z).value;
    let point = virtual_map::<O, 1>(&oscillator, reset[0], reset[1], Some(0.0)).ok()?.jet.value;
    Some(point - Vector2::new(0.0, near.orbit.phase()))
}

fn position_orders<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<Observed>, Failure> {
    Ok(along_curves(place, 2.0, PHASE, |_, _, near| Some(recoil(near)?[0])))
}

/// eq:admp8a.
pub(super) fn position_after_recoil() -> CheckResult {
    let orders = everywhere!(Loops::Many, position_orders);
    Ok(Outcome::new(lowest(&orders), orders.len(), EVERYWHERE))
}

impl<O: ImpactOscillator> Place<O> {
    /// d(z⁽⁰⁾ − z_graz,η)/dη on a curve, in the two forms of eq:admp8b.
    fn recoil_phase_slopes(&self, curve: &Bifurcation) -> Result<[f64; 2], Failure> {
        let symbols = self.symbols()?;
        let (k_1, modulus) = (self.point().branch_expansion().k_1, -symbols.power.m11);
        let alpha_omega = symbols.alpha * symbols.omega;
        Ok([
            alpha_omega * symbols.f / curve.stability
                * (k_1 + symbols.omega * (1.0 - symbols.alpha) / symbols.gamma),
            -alpha_omega * alpha_omega * symbols.f / (symbols.gamma * (1.0 + modulus) * curve.stability),
        ])
    }
}

fn recoil_phase_orders<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<Observed>, Failure> {
    let [fold, flip] = place.curves().map(|curve| place.recoil_phase_slopes(&curve));
    let (fold, flip) = (fold?, flip?);
    Ok(all_along_curves(place, 2.0, PHASE, |curve, eta, near| {
        let slopes = if curve.condition == Condition::SADDLE_NODE { fold } else { flip };
        let phase = recoil(near)?[1];
        Some(slopes.iter().map(|slope| phase - slope * eta).collect())
    }))
}

/// eq:admp8b, both forms.
pub(super) fn phase_after_recoil() -> CheckResult {
    let orders = everywhere!(Loops::Many, recoil_phase_orders);
    Ok(Outcome::new(lowest(&orders), orders.len(), EVERYWHERE))
}

/// The visits (x⁽ʲ⁾, z⁽ʲ⁾ − z_graz,η) for 0 < j ≤ p.
fn visits<O: ImpactOscillator>(place: &Place<O>, near: &Near<O>) -> Option<Vec<Vector2<f64>>> {
    let visits = place.resonance.equations().visits(&near.unknowns, &Memory::default()).ok()?;
    Some(visits.iter().map(|visit| visit - Vector2::new(0.0, near.orbit.phase())).collect())
}

fn power_orders<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<Observed>, Failure> {
    let map = place.point().grazing.map;
    Ok(all_along_curves(place, 2.0, PHASE, |_, _, near| {
        let start = recoil(near)?;
        let gaps = visits(place, near)?
            .into_iter()
            .zip(1..)
            .map(|(visit, j)| (visit - map.iterate(j).a * start).norm());
        Some(gaps.collect())
    }))
}

/// eq:admp9.
pub(super) fn visits_by_powers() -> CheckResult {
    let orders = everywhere!(Loops::Many, power_orders);
    Ok(Outcome::new(lowest(&orders), orders.len(), EVERYWHERE))
}

fn visit_orders<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<Observed>, Failure> {
    let recoil = place.curves().map(|curve| place.recoil_phase_slopes(&curve));
    let [fold, flip] = recoil;
    let (fold, flip) = (fold?[1], flip?[1]);
    let map = place.point().grazing.map;
    Ok(all_along_curves(place, 2.0, PHASE, |curve, eta, near| {
        let slope = if curve.condition == Condition::SADDLE_NODE { fold } else { flip };
        let gap = |(visit, j): (&Vector2<f64>, u32)| {
            let entry = map.a.m12 * lucas_sequence(j, map.trace(), map.determinant());
            visit[0] - entry * slope * eta
        };
        let all = visits(place, near)?;
        // The last visit is the virtual point of the impact.
        Some(all[..all.len() - 1].iter().zip(1..).map(gap).collect())
    }))
}

/// eq:admp10.
pub(super) fn positions_of_visits() -> CheckResult {
    let orders = everywhere!(Loops::Many, visit_orders);
    Ok(Outcome::new(lowest(&orders), orders.len(), EVERYWHERE))
}

fn visit_signs<O: ImpactOscillator>(place: &Place<O>) -> Result<Vec<bool>, Failure> {
    let mut found = Vec::new();
    let unfolding = place.point().unfolding.derivative();
    for curve in place.curves() {
        for size in [1e-3, -1e-3, 1e-4, -1e-4] {
            let eta = eta_at(&curve, size);
            let Some(visits) = place.on_curve(&curve, eta).and_then(|near| visits(place, &near)) else {
                continue;
            };
            let loops = place.loops() as usize;
            let ends = [
                visits[loops - 1][0] > 0.0,
                visits[..loops - 1].iter().all(|visit| visit[0] * unfolding * curve.stability * eta < 0.0),
            ];
            found.extend(ends);
        }
    }
    Ok(found)
}

/// eq:admp11, and x⁽ᵖ⁾ > 0.
pub(super) fn signs_of_visits() -> CheckResult {
    let cases = everywhere!(Loops::Many, visit_signs);
    let agreeing = cases.iter().filter(|agrees| **agrees).count();
    let measure = Measure::Agreement { agreeing, cases: cases.len() };
    Ok(Outcome::new(measure, cases.len(), "all loops of MPSs on SN and PD curves, η of either sign"))
}

/// S_j > 0 for 0 < j < p at resonance, in units of δ^{(j−1)/2}: adversarial search over δ, p and j.
pub(super) fn sums_are_positive() -> CheckResult {
    let mut found = f64::INFINITY;
    let mut searches = 0;
    for p in 2..=12_u32 {
        for j in 1..p {
            let scaled = |[share]: [f64; 1]| {
                let delta = 1e-6 + share * (1.0 - 2e-6);
                let sum = lucas_sequence(j, resonance_boundary(f64::from(p), delta), delta);
                sum / libm::pow(delta, 0.5 * f64::from(j - 1))
            };
            found = found.min(smallest(u64::from(100 * p + j), 5, scaled).0);
            searches += 5;
        }
    }
    Ok(Outcome::new(
        Measure::Margin { smallest: found },
        searches,
        "searches over δ in (0, 1), 0 < j < p ≤ 12",
    ))
}
