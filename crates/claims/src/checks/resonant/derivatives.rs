//! The derivatives multiplied in the proofs of Lemmas 5.1 and 5.2: eq:DPvirt to eq:DPglobalp.

use crate::*;

/// Rounding of the entries of D P_virt and D(P_virt ∘ R), numbers of order one.
const VIRTUAL: f64 = 1e-15;
/// Rounding of entries of D P_global^p: 10⁻¹⁵ for each of p ≤ 5 factors, times angles up to ten.
const GLOBAL: f64 = 1e-13;

/// D P_virt and D(P_virt ∘ R) at a point.
fn virtual_derivatives(near: &Near) -> Option<[Matrix2<f64>; 2]> {
    let oscillator = near.oscillator();
    let [y, z] = near.impact().into();
    let ahead = virtual_map::<_, 1>(&oscillator, OnWall::new(y, z), Some(0.0)).ok()?;
    let reset = oscillator.reset::<1>(OnWall::new(y, z));
    let back = virtual_map::<_, 1>(&oscillator, reset.image(), Some(0.0)).ok()?;
    Some([ahead.jet.derivative(), back.jet.after::<1, _>(&reset).derivative()])
}

/// The orders with which the entries of a matrix approach the stated ones, row by row.
fn entries(
    stated: [f64; 4],
    rounding: f64,
    remainder: impl Fn(&Offset) -> Option<Matrix2<f64>>,
) -> Vec<Observed> {
    let one = |direction: &Offset| {
        together(stated.map(|stated| (rounding, stated)), |size| {
            let matrix = remainder(&scaled(direction, size))?;
            Some([matrix.m11, matrix.m12, matrix.m21, matrix.m22])
        })
    };
    offsets(3).iter().flat_map(one).collect()
}

/// The derivative of the leading terms of a virtual map at an impact velocity.
fn slope_of(map: &VirtualMap, velocity: f64) -> Matrix2<f64> {
    Matrix2::new(2.0 * map.x_coefficient * velocity, 0.0, map.z_coefficient, 1.0)
}

/// Interpretations of the print, which leaves open the origin of the phase and the path of the derivative
/// f_p.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Cure {
    /// The phase is measured from z_graz,η, and f_p is taken along the grazing curve.
    Moving,
    /// The phase is measured from z_graz,0, as printed, and f_p is taken along the grazing curve, as in
    /// eq:fp.
    AsPrinted,
    /// The phase is measured from z_graz,0, as printed, and f_p is taken at fixed z, as the print defines
    /// it.
    PartialDerivative,
}

impl Cure {
    /// The phase relative to its origin, and f_p.
    pub(super) fn phase_and_slope(self, place: &ResonantSpecimen, near: &Near, f: f64) -> [f64; 2] {
        let phase = near.unknowns[1];
        match self {
            Self::Moving => [phase - near.orbit.phase(), f],
            Self::AsPrinted => [phase - place.fixed_phase(), f],
            Self::PartialDerivative => {
                let moved = place.point().second_phase_derivative * place.resonance.orbit().phase_slope();
                [phase - place.fixed_phase(), f - moved]
            }
        }
    }
}

/// The orders of D P_global^p at (x⁽⁰⁾, z⁽⁰⁾) minus its expansion.
fn global_orders(place: &ResonantSpecimen, cure: Cure) -> Result<Vec<Observed>, CheckError> {
    let symbols = place.symbols()?;
    Ok(entries([1.0, 2.0, 1.0, 1.0], GLOBAL, |&[x, z, mu, eta]| {
        let near = place.near([0.0, z, mu, eta])?;
        let jet = global_iterate::<_, 1>(&near.oscillator(), place.loops(), AtRest::new(x, near.unknowns[1]))
            .ok()?;
        let [from, f] = cure.phase_and_slope(place, &near, symbols.f);
        let mut leading = symbols.power;
        leading.m12 = symbols.d * x + symbols.xi * from + symbols.e * mu + f * eta;
        Some(jet.derivative() - leading)
    }))
}

/// The orders of y U minus eq:yU.
fn product_orders(place: &ResonantSpecimen, cure: Cure) -> Result<Vec<Observed>, CheckError> {
    let symbols = place.symbols()?;
    Ok(entries([2.0, 2.0, 1.0, 2.0], GLOBAL, |offset| {
        let near = place.near(*offset)?;
        let maps = place.maps(&near).ok()?;
        let [y, _, mu, eta] = *offset;
        let [from, f] = cure.phase_and_slope(place, &near, symbols.f);
        let alpha_omega = symbols.alpha * symbols.omega;
        let phase = symbols.omega * (1.0 - symbols.alpha) / symbols.gamma * y + from;
        let x = symbols.power.m11 * symbols.phi * symbols.phi * y
            - alpha_omega * (symbols.xi * phase + symbols.e * mu + f * eta);
        let leading = Matrix2::new(x, 0.0, -alpha_omega * symbols.power.m22, symbols.power.m22 * y);
        Some(
            maps.first().round_trip.derivative() * maps.first().impact.derivative().try_inverse()? * y
                - leading,
        )
    }))
}

/// The step of differences: their error is about 10⁻¹³, and rounding 10⁻¹⁵ over the step or its square.
const STEP: f64 = 2e-3;
/// The step in the parameters, on which angles of up to seventy radians depend.
const PARAMETER_STEP: f64 = 5e-4;

/// ξ_p, d_p, e_p, f_p by differences of P_global^p; f_p at fixed z and along the grazing curve.
pub(super) struct MapDifferences {
    d: f64,
    e: f64,
    f_fixed: f64,
    pub(super) f_followed: f64,
    pub(super) xi: f64,
}

pub(super) fn differences(place: &ResonantSpecimen) -> Option<MapDifferences> {
    let phase = place.fixed_phase();
    let by_phase = |x: f64, from: f64, mu: f64, eta: f64| {
        let oscillator = place.near([0.0, 0.0, mu, eta])?.oscillator();
        slope(STEP, |z| {
            Some(global_iterate::<_, 1>(&oscillator, place.loops(), AtRest::new(x, from + z)).ok()?.value[0])
        })
    };
    Some(MapDifferences {
        xi: slope(STEP, |z| by_phase(0.0, phase + z, 0.0, 0.0))?,
        d: slope(STEP, |x| by_phase(x, phase, 0.0, 0.0))?,
        e: slope(PARAMETER_STEP, |mu| by_phase(0.0, phase, mu, 0.0))?,
        f_fixed: slope(PARAMETER_STEP, |eta| by_phase(0.0, phase, 0.0, eta))?,
        f_followed: slope(PARAMETER_STEP, |eta| by_phase(0.0, place.grazing(eta)?.phase(), 0.0, eta))?,
    })
}

/// Compares a₁₂' or a₁₂ ∂S_p/∂η, by differences along the grazing curve, with a₁₂' or eq:fp.
fn slope_gaps(place: &ResonantSpecimen, largest: &mut Deviations) -> Result<(), CheckError> {
    let (map, loops) = (place.point().grazing.map, place.loops());
    let by_eta = place.along_grazing(1e-3, |loops, LinearisedMap { a, .. }| {
        if loops == 1 { a.m12 } else { lucas_sequence(loops, a.trace(), a.determinant()) }
    })?;
    let found = if loops == 1 { by_eta } else { map.a.m12 * by_eta };
    let stated = place.symbols()?.f;
    largest.compare(found, stated, stated);
    Ok(())
}

checks! {
    /// The display of d_p, e_p, f_p with ξ_p. For f_p to be that of eq:fp, or a₁₂' for p = 1, the
    /// derivative must be along the grazing curve; at fixed z, as printed, it is different.
    // Nested differences: a factor of 10² for each order at large p n, rounding 10⁻¹⁵ over the squared
    // step.
    second_derivatives: everywhere(ANY) |place; (followed, fixed): (Deviations, Deviations)| {
        let symbols = place.symbols()?;
        let found = differences(place).ok_or("P_global is not defined around a resonance")?;
        let rest = [(found.xi, symbols.xi), (found.d, symbols.d), (found.e, symbols.e)];
        for (deviations, f) in [(followed, found.f_followed), (fixed, found.f_fixed)] {
            let mut gaps = Deviations::default();
            gaps.pairs(rest.into_iter().chain([(f, symbols.f)]));
            deviations.see(gaps.largest());
        }
    } =>
        followed.outcome(1e-7, "ξ, d, e, f by differences of P_global^p at resonances with p up to 5")
            .against_print(fixed.measure(1e-7));
    /// At κ_p = 0: S_p = 0, S_{p+1} = −δ^{p/2}, A^p = −δ^{p/2} I.
    // Roundings of up to five factors.
    power_at_resonance: everywhere(MANY) |place; largest: Deviations| {
        let map = place.point().grazing.map;
        let (loops, tau, delta) = (place.loops(), map.trace(), map.determinant());
        let orbit = place.resonance.orbit();
        let power =
            global_iterate::<_, 1>(orbit.oscillator(), loops, AtRest::new(0.0, orbit.phase()))?.derivative();
        let modulus = modulus_power(loops, delta);
        let sums = [
            detuning(loops, tau, delta),
            lucas_sequence(loops, tau, delta),
            lucas_sequence(loops + 1, tau, delta) + modulus,
        ];
        let rest = power + Matrix2::identity() * modulus;
        sums.iter().chain(rest.iter()).for_each(|gap| largest.see(*gap));
    } => largest.outcome(1e-13, "located resonances with p = 2 to 5");
    /// det D P_virt = y G₁ with G₁ = 1/γ at the resonance.
    determinant_quotient: orders(ANY, EVERYWHERE, |place| {
        let gamma = place.symbols()?.gamma;
        let one = |direction: &Offset| {
            let observed = order(|size| {
                let offset = scaled(direction, size);
                let determinant = virtual_derivatives(&place.near(offset)?)?[0].determinant();
                // The remainder is divided by y, and so is the rounding.
                Some((determinant / offset[0] - 1.0 / gamma, VIRTUAL / offset[0].abs()))
            });
            (observed, 1.0)
        };
        Ok(offsets(4).iter().map(one).collect())
    });
    /// eq:DPdisc, and that y D P_disc extends through y = 0: y has either sign.
    of_discontinuity_map: orders(ANY, EVERYWHERE, |place| {
        let symbols = place.symbols()?;
        // y (D P_virt)⁻¹ is y/det ≈ γ times the adjugate: rounding as that of the factors.
        Ok(entries([2.0, 3.0, 1.0, 2.0], 3.0 * VIRTUAL, |offset| {
            let [ahead, back] = virtual_derivatives(&place.near(*offset)?)?;
            let y = offset[0];
            let leading = Matrix2::new(symbols.phi * symbols.phi * y, 0.0, -symbols.alpha * symbols.omega, y);
            Some(back * ahead.try_inverse()? * y - leading)
        }))
    });
    /// eq:DPvirt.
    of_virtual_map: orders(ANY, EVERYWHERE, |place| {
        let grazing = place.point().grazing;
        Ok(entries([2.0, 2.0, 1.0, 1.0], VIRTUAL, |offset| {
            Some(virtual_derivatives(&place.near(*offset)?)?[0] - slope_of(&grazing.virtual_map(), offset[0]))
        }))
    });
    /// eq:DPvirtR.
    after_reset: orders(ANY, EVERYWHERE, |place| {
        let grazing = place.point().grazing;
        Ok(entries([2.0, 2.0, 1.0, 1.0], VIRTUAL, |offset| {
            let leading = slope_of(&grazing.virtual_map_after_reset(), offset[0]);
            Some(virtual_derivatives(&place.near(*offset)?)?[1] - leading)
        }))
    });
    /// The alternative interpretation: with f_p at fixed z the expansions about z_graz,0 hold as printed.
    other_cure: orders(ANY, EVERYWHERE, |place| {
        let mut found = global_orders(place, Cure::PartialDerivative)?;
        if place.loops() == 1 {
            found.extend(product_orders(place, Cure::PartialDerivative)?);
        }
        Ok(found)
    });
    /// eq:yU, about z_graz,η; the print has z_graz,0.
    product: orders_against_print(ONE, |at| product_orders(at, Cure::Moving), |at| product_orders(at, Cure::AsPrinted));
    /// eq:DPglobal, about z_graz,η; the print has z_graz,0.
    of_global_map: orders_against_print(ONE, |at| global_orders(at, Cure::Moving), |at| global_orders(at, Cure::AsPrinted));
    /// eq:DPglobalp, about z_graz,η; the print has z_graz,0.
    of_iterated_global_map: orders_against_print(MANY, |at| global_orders(at, Cure::Moving), |at| global_orders(at, Cure::AsPrinted));
    /// f₁ = a₁₂', along the grazing curve: rounding 10⁻¹⁵ over the step of 10⁻³.
    slope_of_one_loop: everywhere(ONE, slope_gaps)
        .map(|largest| largest.outcome(1e-10, "the grazing curve around resonances with p = 1"));
    /// eq:fp, from f_p = a₁₂ ∂S_p/∂η: 10⁻¹⁸ times seventh derivatives of up to 10¹⁰.
    slope_of_many_loops: everywhere(MANY, slope_gaps)
        .map(|largest| largest.outcome(1e-7, "the grazing curve around resonances with p = 2 to 5"));
}
