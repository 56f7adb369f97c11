//! The MPSs on the bifurcation curves, visit by visit: eq:admp7 to eq:admp11.

use super::curves::{PHASE, along_curves, eta_at};
use crate::checks::appendices::signs::{determinant, loop_index, search};
use crate::checks::generic::maps::{impact_and_recoil, virtual_point};
use crate::*;

/// (x⁽⁰⁾, z⁽⁰⁾) of a point of a curve, with the phase relative to z_graz,η.
fn recoil(near: &Near) -> Option<Vector2<f64>> {
    let oscillator = near.oscillator();
    let [y, z] = near.impact().into();
    let [_, recoil] = impact_and_recoil(&oscillator, y, z);
    Some(virtual_point(&oscillator, recoil).ok()? - Vector2::new(0.0, near.orbit.phase()))
}

impl ResonantSpecimen {
    /// d(z⁽⁰⁾ − z_graz,η)/dη on a curve, in the two forms of eq:admp8b.
    fn recoil_phase_slopes(&self, curve: &TheoremCurve) -> Result<[f64; 2], CheckError> {
        let symbols = self.symbols()?;
        let (k_1, modulus) = (self.point().branch_expansion().k_1, -symbols.power.m11);
        let alpha_omega = symbols.alpha * symbols.omega;
        Ok([
            curve.leading.impact_velocity_slope
                * (k_1 + self.point().grazing.virtual_map_after_reset().z_coefficient),
            -alpha_omega * alpha_omega * symbols.f / (symbols.gamma * (1.0 + modulus) * curve.stability),
        ])
    }
}

/// The visits (x⁽ʲ⁾, z⁽ʲ⁾ − z_graz,η) for 0 < j ≤ p.
fn visits(place: &ResonantSpecimen, near: &Near) -> Option<Vec<Vector2<f64>>> {
    let visits = place.resonance.equations().visits(&near.unknowns, &EventTimes::default()).ok()?;
    Some(visits.iter().map(|visit| visit - Vector2::new(0.0, near.orbit.phase())).collect())
}

checks! {
    /// eq:admp7.
    phase: orders(MANY, EVERYWHERE, |place| {
        Ok(along_curves(place, 2.0, PHASE, |curve, eta, near| {
            Some(vec![near.relative()[0] - curve.leading.impact_phase_slope * eta])
        }))
    });
    /// eq:admp8a.
    position_after_recoil: orders(MANY, EVERYWHERE, |place| {
        Ok(along_curves(place, 2.0, PHASE, |_, _, near| Some(vec![recoil(near)?[0]])))
    });
    /// eq:admp8b, both forms.
    phase_after_recoil: orders(MANY, EVERYWHERE, |place| {
        Ok(along_curves(place, 2.0, PHASE, |curve, eta, near| {
            let (slopes, phase) = (place.recoil_phase_slopes(curve).ok()?, recoil(near)?[1]);
            Some(slopes.iter().map(|slope| phase - slope * eta).collect())
        }))
    });
    /// eq:admp9.
    visits_by_powers: orders(MANY, EVERYWHERE, |place| {
        let map = place.point().grazing.map;
        Ok(along_curves(place, 2.0, PHASE, |_, _, near| {
            let start = recoil(near)?;
            let gaps = visits(place, near)?
                .into_iter()
                .zip(1..)
                .map(|(visit, j)| (visit - map.iterate(j).a * start).norm());
            Some(gaps.collect())
        }))
    });
    /// eq:admp10.
    positions_of_visits: orders(MANY, EVERYWHERE, |place| {
        let map = place.point().grazing.map;
        Ok(along_curves(place, 2.0, PHASE, |curve, eta, near| {
            let [_, slope] = place.recoil_phase_slopes(curve).ok()?;
            let gap = |(visit, j): (&Vector2<f64>, u32)| {
                let entry = map.a.m12 * lucas_sequence(j, map.trace(), map.determinant());
                visit[0] - entry * slope * eta
            };
            let all = visits(place, near)?;
            // The last visit is the virtual point of the impact.
            Some(all[..all.len() - 1].iter().zip(1..).map(gap).collect())
        }))
    });
    /// eq:admp11, and x⁽ᵖ⁾ > 0.
    signs_of_visits: everywhere(MANY) |place; cases: Votes| {
        let unfolding = place.point().unfolding.derivative;
        for curve in place.curves() {
            for size in [1e-3, -1e-3, 1e-4, -1e-4] {
                let eta = eta_at(&curve, size);
                let found = place.on_curve(&curve, eta).and_then(|near| visits(place, &near));
                let Some((last, inner)) = found.as_deref().and_then(<[_]>::split_last) else { continue };
                cases.see(last[0] > 0.0);
                cases.see(inner.iter().all(|visit| visit[0] * unfolding * curve.stability * eta < 0.0));
            }
        }
    } => cases.outcome("all loops of MPSs on SN and PD curves, η of either sign");
    /// S_j > 0 for 0 < j < p at resonance, in units of δ^{(j−1)/2}: search over δ, p and j.
    sums_are_positive: search(2..=15, "the determinant and 0 < j < p at τ = g_p", "S_j / r^(j−1)", |p, [x, y]| {
        let (delta, j) = (determinant(x), loop_index(y, p));
        let sum = lucas_sequence(j as u32, resonance_boundary(f64::from(p), delta), delta);
        sum / libm::pow(delta, 0.5 * (j - 1.0))
    });
}
