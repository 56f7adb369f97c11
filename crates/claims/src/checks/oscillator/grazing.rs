//! Section 3.3: parameter values associated with grazing.

use crate::checks::main_results::returns::derivatives;
use crate::*;
use grazing_model::LinearOscillator;

/// The closed form at random parameters, and the grazing orbit found from a nearby start.
fn both(sampler: &mut Sampler) -> Result<(GrazingState, GrazingOrbit<LinearOscillator>), CheckError> {
    let (zeta, epsilon) = (sampler.between(0.005, 0.3), sampler.between(0.05, 1.0));
    let omega = sampler.between(0.3, 2.5);
    let closed = grazing_theorems::LinearOscillator::new(zeta, epsilon)?.grazing(omega)?;
    let near = closed.model().with_parameters([closed.amplitude() * 1.001, omega]);
    let orbit = GrazingOrbit::find(&near, closed.phase() + 1e-3)?;
    Ok((closed, orbit))
}

/// The deviations of printed expressions from measurements on the numerical oscillator, at random
/// parameters.
fn compared(
    seed: u64,
    mut sample: impl FnMut(
        &GrazingState,
        &GrazingOrbit<LinearOscillator>,
        &mut Deviations,
    ) -> Result<(), CheckError>,
) -> Result<Deviations, CheckError> {
    drawn(seed, 300, |sampler, largest: &mut Deviations| {
        let (closed, orbit) = both(sampler)?;
        sample(&closed, &orbit, largest)
    })
}

/// The weight of a difference quotient, which is accurate to 10⁻¹⁰ where the tolerance is 10⁻¹³.
const DIFFERENCES: f64 = 1e-3;

checks! {
    /// F, Φ and Ψ of the linear oscillator, with which it is a member of the general class.
    // A handful of operations on numbers of order one.
    general_form: drawn(111, 1000) |sampler; largest: Deviations| {
        let (closed, orbit) = both(sampler)?;
        let oscillator = orbit.oscillator();
        let state = sampler.state();
        let zeta = closed.oscillator().damping_ratio();
        let force = -2.0 * zeta * state.velocity - state.position - 1.0
            + oscillator.amplitude() * libm::cos(state.phase);
        largest.compare(oscillator.acceleration(state), force, 1.0);
        let velocity = sampler.between(0.01, 2.0);
        let image = oscillator.reset::<1>(OnWall::new(velocity, state.phase)).value;
        largest.compare(-image[0] / velocity, closed.oscillator().coefficient_of_restitution(), 1.0);
        largest.compare(image[1], state.phase, 1.0);
    } => largest.outcome(1e-14, "random oscillators, states and impacts");
    /// eq:oscphipsigamma: φ, ψ, γ read off the reset law and the numerical grazing orbit.
    // Newton's method for the grazing orbit leaves about ten roundings of numbers up to five.
    constants: compared(112) |closed, orbit; largest: Deviations| {
        let omega = closed.forcing_frequency();
        let GrazingPoint { phi, psi, gamma, .. } = orbit.grazing_point();
        largest.compare(phi, closed.oscillator().coefficient_of_restitution(), 1.0);
        largest.compare(psi, 0.0, 1.0);
        // 𝒜 cos z_graz has the error of the grazing orbit, times 𝒜 up to five.
        largest.compare(gamma, omega * omega, 1.0);
        let stated = closed.grazing_point();
        largest.compare(stated.gamma, gamma, 1.0);
        largest.compare(stated.phi, phi, 1.0);
        largest.compare(stated.psi, psi, 1.0);
    } => largest.outcome(1e-13, "numerical grazing orbits of random oscillators");
    /// eq:oscalpha.
    // The same sum.
    square_root_factor: compared(113) |closed, orbit; largest: Deviations| {
        let epsilon = closed.oscillator().coefficient_of_restitution();
        largest.compare(orbit.grazing_point().alpha(), 1.0 + epsilon, 1.0);
        largest.compare(closed.grazing_point().alpha(), 1.0 + epsilon, 1.0);
    } => largest.outcome(0.0, "numerical grazing orbits of random oscillators");
    /// eq:oscA: the closed form against jets of the numerical map and differences.
    // Like the constants, with arguments 2πω₁/ω up to twenty.
    first_derivatives: compared(114) |closed, orbit; largest: Deviations| {
        let (jets, stated) = (orbit.grazing_point().map.a, closed.linearised_map().a);
        largest.see((jets - stated).amax());
        let [by_position, by_phase, _] = derivatives(orbit, 1.0)?;
        // Differences have fewer correct digits, and have less weight.
        largest.see(DIFFERENCES * (Matrix2::from_columns(&[by_position, by_phase]) - stated).amax());
    } => largest.outcome(1e-13, "entries of A of random oscillators, by jets and by differences");
    /// eq:oscb, compared in the same way; μ = 𝒜 − 𝒜_graz(ω) at fixed ω.
    // The tolerance is that of A.
    parameter_derivatives: compared(115) |closed, orbit; largest: Deviations| {
        let (jets, stated, amplitude) =
            (orbit.grazing_point().map.b, closed.linearised_map().b, closed.amplitude());
        // Steps are proportional to the amplitude, which is small at resonance.
        let [_, _, by_parameter] = derivatives(orbit, amplitude)?;
        largest.see((jets - stated).amax() * amplitude);
        largest.see(DIFFERENCES * (by_parameter - stated * amplitude).amax());
    } => largest.outcome(1e-13, "entries of b of random oscillators, by jets and by differences");
    /// pr:oscAb: A and b of the numerical map, also at strong damping and high frequencies.
    // Derivatives of maxima: sums of a dozen terms of the size of the entries.
    both_derivatives: drawn(118, 1000) |sampler; largest: Deviations| {
        let zeta = sampler.between(0.002, 0.8);
        let omega = sampler.between(0.25, 5.0);
        let closed = grazing_theorems::LinearOscillator::new(zeta, 0.7)?.grazing(omega)?;
        let map = global_map::<_, 1>(&closed.model(), AtRest::new(0.0, closed.phase()), None)?.jet;
        let stated = closed.linearised_map();
        let scale = stated.a.amax().max(1.0);
        largest.see((map.derivative() - stated.a).amax() / scale);
        let by_primary = map.jacobian.column(2) * closed.amplitude();
        largest.see((by_primary - stated.b * closed.amplitude()).amax() / scale);
    } => largest.outcome(1e-13, "A and b by jets of the map for damping ratios to 0.8, frequencies 0.25 to 5");
    /// eq:osctaudelta: trace and determinant of the numerical A.
    // The tolerance is that of A.
    trace_and_determinant: compared(116) |closed, orbit; largest: Deviations| {
        let map = orbit.grazing_point().map;
        largest.compare(map.trace(), closed.trace(), 1.0);
        largest.compare(map.determinant(), closed.determinant(), 1.0);
    } => largest.outcome(1e-13, "numerical grazing orbits of random oscillators");
    /// The display after eq:osctaudelta: β = (δ − τ + 1)/𝒜_graz.
    // The tolerance is that of b.
    transversality: compared(117) |closed, orbit; largest: Deviations| {
        let map = orbit.grazing_point().map;
        largest.compare(map.transversality(), closed.transversality(), 1.0 / closed.amplitude());
    } => largest.outcome(1e-13, "numerical grazing orbits of random oscillators");
}
