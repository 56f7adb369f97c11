//! The multipliers of an MPS near a resonance: eq:U to eq:fp, Lemmas 5.1 and 5.2.

use super::derivatives::Cure;
use crate::*;

/// Rounding of y T and y D, which are accurate to about 10⁻¹⁵ times their size, like P_global.
const ROUNDING: f64 = 1e-14;

impl Symbols {
    /// The linear part of y T (eq:yT1, eq:yTp), with the phase relative to a given origin.
    fn trace(&self, [y, phase, mu, eta]: Offset) -> f64 {
        let loops = self.power.m11 * self.phi * self.phi + self.power.m22;
        let by_velocity =
            loops - self.alpha * self.xi * self.omega * self.omega * (1.0 - self.alpha) / self.gamma;
        by_velocity * y - self.alpha * self.omega * (self.xi * phase + self.e * mu + self.f * eta)
    }

    fn rounding(&self) -> f64 {
        ROUNDING * (1.0 + self.alpha * self.omega * (self.xi.abs() + self.e.abs() + self.f.abs()))
    }
}

fn trace_orders(place: &ResonantSpecimen, cure: Cure) -> Result<Vec<Observed>, CheckError> {
    let symbols = place.symbols()?;
    let one = |direction: &Offset| {
        let observed = order(|size| {
            let mut offset = scaled(direction, size);
            let near = place.near(offset)?;
            let found = offset[0] * place.maps(&near).ok()?.multipliers().trace;
            [offset[1], _] = cure.phase_and_slope(place, &near, symbols.f);
            Some((found - symbols.trace(offset), symbols.rounding()))
        });
        (observed, 2.0)
    };
    Ok(offsets(4).iter().map(one).collect())
}

fn determinant_orders(place: &ResonantSpecimen) -> Result<Vec<Observed>, CheckError> {
    let grazing = place.point().grazing;
    let power = libm::pow(grazing.map.determinant(), f64::from(place.loops()));
    let slope = grazing.phi * grazing.phi * power;
    let one = |direction: &Offset| {
        let observed = order(|size| {
            let offset = scaled(direction, size);
            let found = offset[0] * place.maps(&place.near(offset)?).ok()?.multipliers().determinant;
            Some((found - slope * offset[0], ROUNDING))
        });
        (observed, 2.0)
    };
    Ok(offsets(4).iter().map(one).collect())
}

/// The orders of continuity: y T and y D are three times differentiable across y = 0, as stated for F and
/// R in C⁵.
fn seam_orders(place: &ResonantSpecimen) -> Result<Vec<Observed>, CheckError> {
    let rounding = 32.0 * place.symbols()?.rounding();
    let part = |pick: fn(Multipliers) -> f64| {
        seam(rounding, |y| {
            let near = place.near([y, 0.002, -0.001, 0.003])?;
            Some(y * pick(place.maps(&near).ok()?.multipliers()))
        })
    };
    Ok(vec![part(|both| both.trace), part(|both| both.determinant)])
}

/// Values of η beside a resonance.
const BESIDE: [f64; 2] = [0.03, -0.02];

/// The limit −α ω a₁₂ S_p of y T at η beside the resonance.
fn limits(place: &ResonantSpecimen) -> Result<Vec<f64>, CheckError> {
    let limit = |eta| {
        let point = place.grazing(eta)?.grazing_point();
        Some(-point.alpha() * point.forcing_frequency * point.map.iterate(place.loops()).a.m12)
    };
    let limits: Option<Vec<f64>> = BESIDE.into_iter().map(limit).collect();
    Ok(limits.ok_or("no grazing orbit beside a resonance")?)
}

/// Away from the resonance y T → −α ω a₁₂ S_p ≠ 0, so |T| grows without bound as y → 0.
fn divergence_orders(place: &ResonantSpecimen) -> Result<Vec<Observed>, CheckError> {
    let one = |(eta, limit): (f64, f64)| {
        // A limit of zero would not be a divergence.
        let observed = order(|size| {
            let near = place.near([size, 0.0, 0.0, eta])?;
            Some((size * place.maps(&near).ok()?.multipliers().trace - limit, ROUNDING * (1.0 + limit.abs())))
        });
        (if limit.abs() < 1e-6 { f64::NAN } else { observed }, 1.0)
    };
    Ok(BESIDE.into_iter().zip(limits(place)?).map(one).collect())
}

/// T → ±∞ as y → 0, with the sign of −α a₁₂ S_p.
pub(crate) fn divergence() -> CheckResult {
    let over = "η to either side of resonances: y T less its limit, which is other than zero; for the print, where it is positive";
    let positive = everywhere(ANY, |place, positive: &mut Votes| {
        limits(place)?.iter().for_each(|limit| positive.see(*limit > 0.0));
        Ok(())
    })?;
    Ok(orders(ANY, over, divergence_orders)?.against_print(positive.measure()))
}

checks! {
    /// eq:TD: trace and determinant of U by composing the derivatives of P_disc and P_global at (x̂, ẑ),
    /// as in eq:U, compared with the quotient of the derivatives of the two sides of V.
    // The square root of x̂ ≈ y²/2γ, which is rounded to 10⁻¹⁶: relative errors of 10⁻¹⁶/y² ≈ 10⁻¹² in y
    // and T.
    trace_and_determinant: everywhere(ANY) |place; largest: Deviations| {
        for (y, eta) in [(0.05, 0.0), (0.02, 0.01), (0.1, -0.01), (0.03, 0.02)] {
            let Some(near) = place.on_branch(y, eta) else { continue };
            let oscillator = near.oscillator();
            let maps = place.maps(&near)?;
            let virtual_point = maps.first().impact.value;
            let disc =
                discontinuity_map::<_, 1>(&oscillator, AtRest::new(virtual_point[0], virtual_point[1]))?;
            let around = global_iterate::<_, 1>(&oscillator, place.loops(), disc.image())?;
            let u = around.derivative() * disc.derivative();
            let both = maps.multipliers();
            largest.compare(u.trace(), both.trace, 1.0 + both.trace.abs());
            largest.compare(u.determinant(), both.determinant, 1.0 + both.trace.abs());
        }
    } => largest.outcome(1e-10, "MPSs on branches near resonances");
    /// eq:yT1, about z_graz,η; the print has z_graz,0.
    trace_of_one_loop: orders_against_print(ONE, |at| trace_orders(at, Cure::Moving), |at| trace_orders(at, Cure::AsPrinted));
    /// eq:yTp, about z_graz,η; the print has z_graz,0.
    trace_of_many_loops: orders_against_print(MANY, |at| trace_orders(at, Cure::Moving), |at| trace_orders(at, Cure::AsPrinted));
    /// eq:yD1.
    determinant_of_one_loop: orders(ONE, EVERYWHERE, determinant_orders);
    /// eq:yDp.
    determinant_of_many_loops: orders(MANY, EVERYWHERE, determinant_orders);
    /// Lemma 5.1: y T and y D have a smooth extension through y = 0, p = 1.
    extension_for_one_loop: orders(ONE, "extrapolations to y = 0 from both sides at resonances with p = 1", seam_orders);
    /// Lemma 5.2: y T and y D have a smooth extension through y = 0, p ≥ 2.
    extension_for_many_loops: orders(MANY, "extrapolations to y = 0 from both sides at resonances with p = 2 to 5", seam_orders);
}
