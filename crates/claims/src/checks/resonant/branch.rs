//! Z(y, η) and M(y, η): from eq:ZM to the expansion of y Ψ^±.

use crate::checks::appendices::signs::{determinant, search};
use crate::*;

/// The ratios of y and η along which points approach the resonance.
const RATIOS: [[f64; 2]; 4] = [[1.0, 0.0], [1.0, 0.3], [1.0, -0.3], [-1.0, 0.2]];
/// Rounding of a located phase relative to z_graz: the quotient of 10⁻¹⁵ and entries of K.
const PHASE: f64 = 3e-14;
/// Rounding of a located μ: the zeros of V are accurate to the last digits of the amplitude.
const PARAMETER: f64 = 1e-15;
/// Rounding of P_global^p.
const MAP: f64 = 1e-15;

/// Orders of Z − z_graz,η − k₁ y and of M − k₂ y² − k₃ η y.
fn branch_orders(place: &ResonantSpecimen) -> Result<Vec<Observed>, CheckError> {
    let branch = place.point().branch_expansion();
    let mut found = Vec::new();
    for [y, eta] in RATIOS {
        found.extend(together([(PHASE, 2.0), (PARAMETER, 3.0)], |size| {
            let (y, eta) = (y * size, eta * size);
            let [phase, mu] = place.on_branch(y, eta)?.relative();
            Some([phase - branch.k_1 * y, mu - branch.parameter(y, eta)])
        }));
    }
    Ok(found)
}

/// The coefficients of μ at resonance: b for p = 1, T_p (β, a₂₁ b₁ + (1 − a₁₁) b₂) for p ≥ 2.
fn parameter_column(place: &ResonantSpecimen) -> Vector2<f64> {
    let map = place.point().grazing.map;
    if place.loops() == 1 {
        return map.b;
    }
    let sum = lucas_partial_sum(place.loops(), map.trace(), map.determinant());
    Vector2::new(map.transversality(), map.a.m21 * map.b.x + (1.0 - map.a.m11) * map.b.y) * sum
}

/// x⁽ᵖ⁾ as a polynomial in z⁽⁰⁾ − z_graz,η, coefficient by coefficient, and z⁽ᵖ⁾.
fn return_orders(place: &ResonantSpecimen) -> Result<Vec<Observed>, CheckError> {
    let symbols = place.symbols()?;
    let column = parameter_column(place);
    let jet = |x: f64, z: f64, mu: f64, eta: f64| {
        let near = place.near([0.0, z, mu, eta])?;
        let jet = global_iterate::<_, 2>(&near.oscillator(), place.loops(), AtRest::new(x, near.unknowns[1]))
            .ok()?;
        Some((jet, near.orbit.phase()))
    };
    // First derivatives have ten times the rounding error of the map, second derivatives a hundred times.
    let rounding = MAP * 10.0;
    let mut found = Vec::new();
    for direction in offsets(2) {
        let at = remembered(|size| {
            let [x, z, mu, eta] = scaled(&direction, size);
            Some((x, z, mu, eta, jet(x, 0.0, mu, eta)?.0))
        });
        let constant = order(|size| {
            let (x, _, mu, _, jet) = at(size)?;
            Some((jet.value[0] - symbols.power.m11 * x - column.x * mu, rounding))
        });
        let linear = order(|size| {
            let (x, _, mu, eta, jet) = at(size)?;
            Some((jet.jacobian[(0, 1)] - symbols.d * x - symbols.e * mu - symbols.f * eta, rounding))
        });
        let quadratic = order(|size| {
            let (.., jet) = at(size)?;
            Some((jet.hessians[0][(1, 1)] - symbols.xi, 10.0 * rounding))
        });
        let cubic = order(|size| {
            // At fixed x, μ, η: the remainder of the second-order Taylor polynomial in z.
            let z = direction[1] * size;
            let (base, _) = jet(0.003, 0.0, -0.002, 0.004)?;
            let (there, _) = jet(0.003, z, -0.002, 0.004)?;
            let taylor = base.value[0] + (base.jacobian[(0, 1)] + 0.5 * base.hessians[0][(1, 1)] * z) * z;
            Some((there.value[0] - taylor, MAP))
        });
        let phase = order(|size| {
            let [x, z, mu, eta] = scaled(&direction, size);
            let (jet, grazing) = jet(x, z, mu, eta)?;
            let linear = symbols.power.m21 * x + symbols.power.m22 * z + column.y * mu;
            Some((jet.value[1] - grazing - linear, rounding))
        });
        found.extend([(constant, 2.0), (linear, 2.0), (quadratic, 1.0), (cubic, 3.0), (phase, 2.0)]);
    }
    Ok(found)
}

impl Symbols {
    /// X₁, X₂, X₃ for any k₁, k₂, k₃; `by_parameter` is b₁ or T_p β.
    fn x(&self, [k_1, k_2, k_3]: [f64; 3], by_parameter: f64) -> [f64; 3] {
        let shift = (1.0 - self.alpha) * self.omega / self.gamma;
        let (a, c) = (self.power.m11, self.power.m22);
        [
            -(1.0 - c) * k_1 + self.omega / self.gamma * (c * (1.0 - self.alpha) - 1.0),
            by_parameter * k_2
                + (a * self.phi * self.phi - 1.0) / (2.0 * self.gamma)
                + 0.5 * self.xi * (k_1 + shift) * (k_1 + shift),
            by_parameter * k_3 + self.f * (k_1 + shift),
        ]
    }
}

/// V(y, Z, M, η) for arbitrary k₁, k₂, k₃ in eq:ZM.
fn vivid_orders(place: &ResonantSpecimen) -> Result<Vec<Observed>, CheckError> {
    let symbols = place.symbols()?;
    let by_parameter = parameter_column(place).x;
    let mut sampler = Sampler::new(8);
    let mut found = Vec::new();
    for [y, eta] in RATIOS {
        let k = core::array::from_fn(|_| sampler.between(-1.0, 1.0));
        let x = symbols.x(k, by_parameter);
        found.extend(together([(MAP, 3.0), (MAP, 2.0)], |size| {
            let (y, eta) = (y * size, eta * size);
            let near = place.near([y, k[0] * y, k[1] * y * y + k[2] * eta * y, eta])?;
            let maps = place.maps(&near).ok()?;
            let v = maps.first().difference().0;
            Some([v[0] - x[1] * y * y - x[2] * eta * y, v[1] - x[0] * y])
        }));
    }
    Ok(found)
}

/// Ψ⁺ and Ψ⁻.
fn psi(multipliers: &grazing_continuation::mps::Multipliers) -> [f64; 2] {
    let (trace, determinant) = (multipliers.trace, multipliers.determinant);
    [trace - determinant - 1.0, trace + determinant + 1.0]
}

fn psi_orders(place: &ResonantSpecimen) -> Result<Vec<Observed>, CheckError> {
    let symbols = place.symbols()?;
    let stability = place.point().stability_coefficients();
    let by_eta = symbols.alpha * symbols.omega * symbols.f;
    // The phase of the zero is known to within PHASE, and enters y T with the factor α ω ξ_p.
    let rounding = PHASE * (1.0 + by_eta.abs() + symbols.alpha * symbols.omega * symbols.xi.abs());
    let along = |[y, eta]: [f64; 2]| {
        together([(rounding, 2.0); 2], |size| {
            let (y, eta) = (y * size, eta * size);
            let [plus, minus] = psi(&place.maps(&place.on_branch(y, eta)?).ok()?.multipliers());
            Some(
                [plus * y - stability.plus * y, minus * y - stability.minus * y]
                    .map(|gap| gap + by_eta * eta),
            )
        })
    };
    Ok(RATIOS.into_iter().flat_map(along).collect())
}

checks! {
    /// eq:Psi: det(U − I) = −Ψ⁺ and det(U + I) = Ψ⁻, zero where U has the eigenvalue ±1.
    // Determinants of matrices with entries of size 1/y, relative to their squares.
    multiplier_conditions: everywhere(ANY) |place; largest: Deviations| {
        for (y, eta) in [(0.1, 0.0), (0.03, 0.01), (0.05, -0.01), (0.02, -0.02)] {
            let Some(near) = place.on_branch(y, eta) else { continue };
            let maps = place.maps(&near)?;
            let inverse = maps.first().impact.derivative().try_inverse().ok_or("D P_virt is singular")?;
            let u = maps.first().round_trip.derivative() * inverse;
            let [plus, minus] = psi(&maps.multipliers());
            let one = Matrix2::identity();
            let size = 1.0 + u.amax() * u.amax();
            // The functions that continuation uses for curves: det(U ∓ I) det D P_virt, smooth through y
            // = 0.
            let scaled = |multiplier: f64| maps.characteristic(multiplier).0 * inverse.determinant();
            for (at_one, at_minus_one) in
                [(scaled(1.0), scaled(-1.0)), ((u - one).determinant(), (u + one).determinant())]
            {
                largest.see((at_one + plus) / size);
                largest.see((at_minus_one - minus) / size);
            }
        }
    } => largest.outcome(1e-14, "MPSs on branches near resonances");
    /// At the resonance det J = 0 and det K is as in eq:detJac2.
    // Sums of products, with several tens of roundings.
    jacobians: everywhere(ANY) |place; largest: Deviations| {
        let start = place.resonance.unknowns();
        let maps = place.resonance.equations().maps::<1>(&start, &mut EventTimes::default())?;
        let derivative = maps.first().difference().1;
        let determinant = |first: usize| {
            Matrix2::from_columns(&[derivative.column(first), derivative.column(first + 1)]).determinant()
        };
        let expected = place.point().grazing.parameter_jacobian_determinant_factored(place.loops());
        largest.see(determinant(0));
        largest.pairs([(determinant(1), expected)]);
    } => largest.outcome(1e-13, "derivatives of V at located resonances");
    /// det K/β > 0 at resonance, so that K is non-singular: adversarial search over δ and p.
    second_jacobian_is_regular: search(2..=15, "the determinant at τ = g_p", "det K / β", |p, [x, _]| {
        let delta = determinant(x);
        geometric_sum_determinant(p, resonance_boundary(f64::from(p), delta), delta)
    });
    /// Z(0, η) = z_graz,η and M(0, η) = 0.
    // Both are located to about 10⁻¹⁴; K has entries down to 0.1.
    at_zero_velocity: everywhere(ANY) |place; largest: Deviations| {
        for near in [-0.03, -0.01, 0.005, 0.02].into_iter().filter_map(|eta| place.on_branch(0.0, eta)) {
            near.relative().into_iter().for_each(|gap| largest.see(gap));
        }
    } => largest.outcome(1e-13, "zeros of V with y = 0 for η up to 0.03 around resonances");
    /// eq:ZM: Z − z_graz,η is of first order, M of second.
    form: orders(ANY, EVERYWHERE, |place| {
        let mut found = Vec::new();
        for [y, eta] in RATIOS {
            found.extend(together([(PHASE, 1.0), (PARAMETER, 2.0)], |size| {
                Some(place.on_branch(y * size, eta * size)?.relative())
            }));
        }
        Ok(found)
    });
    /// X₁ = X₂ = X₃ = 0 has the solution eq:k1231 or eq:k123p.
    // A dozen roundings, and a₁₂ or κ_p of up to 10⁻¹³ at the located resonance.
    solution: everywhere(ANY) |place; largest: Deviations| {
        let branch = place.point().branch_expansion();
        let symbols = place.symbols()?;
        let by_parameter = parameter_column(place).x;
        let k = [branch.k_1, branch.k_2, branch.k_3];
        let (found, sizes) = (symbols.x(k, by_parameter), symbols.x([0.0; 3], by_parameter));
        for i in 0..3 {
            largest.see(found[i] / (sizes[i].abs() + k[i].abs() + 1.0 + symbols.f.abs()));
        }
    } => largest.outcome(1e-14, "resonances with p up to 5");
    /// eq:k1231 in eq:ZM.
    coefficients_of_one_loop: orders(ONE, EVERYWHERE, branch_orders);
    /// eq:k123p in eq:ZM.
    coefficients_of_many_loops: orders(MANY, EVERYWHERE, branch_orders);
    /// eq:codim21proof1.
    return_of_one_loop: orders(ONE, EVERYWHERE, return_orders);
    /// eq:codim21proofp.
    return_of_many_loops: orders(MANY, EVERYWHERE, return_orders);
    /// The display of V(y, Z, M, η) with X₁, X₂, X₃, p = 1.
    vivid_of_one_loop: orders(ONE, EVERYWHERE, vivid_orders);
    /// The display of V(y, Z, M, η) with X₁, X₂, X₃, p ≥ 2.
    vivid_of_many_loops: orders(MANY, EVERYWHERE, vivid_orders);
    /// y Ψ^± = s₁^± y − α ω a₁₂' η + O(2), and at η = 0 eq:c1.
    stability_of_one_loop: orders(ONE, EVERYWHERE, psi_orders);
    /// y Ψ^± = s_p^± y − α ω f_p η + O(2), and at η = 0 eq:cp.
    stability_of_many_loops: orders(MANY, EVERYWHERE, psi_orders);
}
