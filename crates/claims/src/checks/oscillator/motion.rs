//! Section 3.1: equation of motion, flow, the periodic solution and its grazing.

use crate::checks::appendices::printed_flow::Printed;
use crate::*;
use grazing_model::LinearOscillator;

/// An oscillator with random parameters from their whole domains, with frequencies around the natural
/// one.
fn oscillator(sampler: &mut Sampler) -> Result<LinearOscillator, CheckError> {
    Ok(LinearOscillator::new(
        sampler.between(0.005, 0.9),
        sampler.between(0.01, 1.0),
        sampler.between(0.3, 3.0),
        sampler.between(0.2, 3.0),
    )?)
}

/// ẍ + 2ζẋ + x + 1 − 𝒜 cos ωt by central differences of a motion x(t), and its rounding.
fn defect(oscillator: &LinearOscillator, x: impl Fn(f64) -> f64, time: f64, h: f64) -> (f64, f64) {
    let [back, here, ahead] = [x(time - h), x(time), x(time + h)];
    let acceleration = (ahead - 2.0 * here + back) / (h * h);
    let velocity = (ahead - back) / (2.0 * h);
    let force = oscillator.amplitude() * libm::cos(oscillator.frequency() * time);
    let (zeta, omega) = (oscillator.damping_ratio(), oscillator.frequency());
    // Positions are sums of terms of the size of the response, which is large at resonance.
    let size =
        1.0 + here.abs() + oscillator.amplitude() / libm::hypot(1.0 - omega * omega, 2.0 * zeta * omega);
    (acceleration + 2.0 * oscillator.damping_ratio() * velocity + here + 1.0 - force, 1e-16 * size / (h * h))
}

/// An initial phase; it depends on the frequency, so that no special phase occurs.
fn sampler_phase(omega: f64) -> f64 {
    1.0 + 2.0 * omega
}

checks! {
    /// eq:oscResetLaw: at every simulated impact y becomes −εy, and x and z do not change.
    // The same product, and the same phase.
    reset_law: drawn(102, 60) |sampler; largest: Deviations| {
        let oscillator = oscillator(sampler)?;
        let from = sampler.state();
        let mut before: Option<State> = None;
        let flights = Orbit::new(&oscillator, from, 20.0 * oscillator.forcing_period(), 60);
        // What is released from rest at the wall does not recoil.
        for flight in flights.take_while(|flight| flight.rest.is_none()) {
            if let Some(impact) = before {
                largest.see((flight.from.velocity + oscillator.restitution() * impact.velocity).abs());
                largest.see(flight.from.position.abs());
                let turns = libm::round((impact.phase - flight.from.phase) / TAU);
                largest.see((impact.phase - turns * TAU - flight.from.phase).abs());
            }
            before = if let FlightEnd::Impact(impact) = flight.end { Some(impact) } else { None };
        }
    } => largest.outcome(0.0, "impacts of orbits of random oscillators");
    /// ω₁ and −ζ ± iω₁: trace and determinant of the matrix of the free oscillator.
    // Numbers of order one; near ζ = 0.9 the time 2π/ω₁ is about fifteen.
    damped_frequency: drawn(103, 500) |sampler; largest: Deviations| {
        let oscillator = oscillator(sampler)?;
        let (zeta, omega_1) = (oscillator.damping_ratio(), oscillator.natural_frequency());
        let free = Matrix2::new(0.0, 1.0, -1.0, -2.0 * zeta);
        // Sum and product of −ζ + iω₁ and −ζ − iω₁.
        largest.compare(-2.0 * zeta, free.trace(), 1.0);
        largest.compare(zeta * zeta + omega_1 * omega_1, free.determinant(), 1.0);
        let theory = grazing_theorems::LinearOscillator::new(zeta, oscillator.restitution())?;
        largest.compare(theory.damped_natural_frequency(), omega_1, 1.0);
        // Free motion returns to its direction after 2π/ω₁, shrunk by e^{−2πζ/ω₁}.
        let still = oscillator.with_parameters([0.0, oscillator.frequency()]);
        let from = sampler.state();
        let end = still.flow::<1>(from, TAU / omega_1).value;
        let shrunk = libm::exp(-TAU * zeta / omega_1);
        largest.compare(end[0] + 1.0, shrunk * (from.position + 1.0), 3.0);
        largest.compare(end[1], shrunk * from.velocity, 3.0);
    } => largest.outcome(1e-14, "random damping ratios");
    /// eq:flow: the print satisfies initial condition and equation, and is the model's flow.
    // The slack is for the next term; values agree to within roundings of the periodic solution's size.
    flow: drawn(104, 300) |sampler; least: Smallest| {
        let oscillator = oscillator(sampler)?;
        let from = sampler.state();
        let start = from.phase / oscillator.frequency();
        let printed = Printed::of(&oscillator);
        let x = |t: f64| printed.flow(t, [from.position, from.velocity], start, oscillator.amplitude());
        let time = start + sampler.between(0.0, 10.0);
        least.see_resolved(order(|h| Some(defect(&oscillator, x, time, h))));
        // Initial position and velocity, the latter by a central difference of second order.
        least.see_resolved(order(|h| {
            Some(((x(start + h) - x(start - h)) / (2.0 * h) - from.velocity, 1e-14 / h))
        }));
        let gain = printed.periodic(0.0, oscillator.amplitude()).map(f64::abs);
        let size = 10.0 + gain[0] + gain[1];
        let same = (x(start) - from.position).abs() < 1e-14 * size
            && (x(time) - oscillator.flow::<1>(from, time - start).value[0]).abs() < 1e-13 * size;
        least.require(same);
    } => least.order(2.0, 0.3, "the printed solution: defect, initial state, and the model's flow");
    /// eq:phip: the print satisfies the equation, has period 2π/ω, and is the model's.
    // The slack is for the next term.
    periodic_solution: drawn(105, 300) |sampler; least: Smallest| {
        let oscillator = oscillator(sampler)?;
        let time = sampler.between(0.0, 10.0);
        let printed = |t: f64| Printed::of(&oscillator).periodic(t, oscillator.amplitude());
        let x = |t: f64| printed(t)[0];
        // At two times a quarter of a period apart: the fourth derivative is not small at both.
        let later = time + 0.25 * oscillator.forcing_period();
        least.see_resolved(order(|h| {
            let [(one, rounding), (other, _)] = [time, later].map(|time| defect(&oscillator, x, time, h));
            Some((libm::hypot(one, other), rounding))
        }));
        let model = oscillator.non_impacting_solution(oscillator.frequency() * time);
        let [position, velocity] = printed(time);
        let size = 1.0 + position.abs() + velocity.abs();
        let from = State { position, velocity, phase: oscillator.frequency() * time };
        let returned = oscillator.flow::<1>(from, oscillator.forcing_period()).value;
        let same = (model.position - position).abs() + (model.velocity - velocity).abs() < 1e-12 * size
            && (returned[0] - position).abs() + (returned[1] - velocity).abs() < 1e-12 * size;
        least.require(same);
    } => least.order(2.0, 0.3, "the printed periodic solution: defect, period, and the model's");
    /// eq:Agraz: at the printed amplitude the highest maximum of φ_p is at the wall; at other amplitudes
    /// it is not.
    // Positions are of order one, and gains up to a hundred when 𝒜 is correspondingly small.
    grazing_amplitude: drawn(107, 500) |sampler; largest: Deviations| {
        let oscillator = oscillator(sampler)?;
        let (zeta, omega) = (oscillator.damping_ratio(), oscillator.frequency());
        let stiffness = 1.0 - omega * omega;
        let amplitude = (stiffness * stiffness + 4.0 * zeta * zeta * omega * omega).sqrt();
        let top = |amplitude: f64| {
            let oscillator = oscillator.with_parameters([amplitude, omega]);
            let from = oscillator.non_impacting_solution(sampler_phase(omega));
            oscillator.motion(from).highest_maximum(1.01 * oscillator.forcing_period())
                .map_or(f64::NAN, |top| top.position)
        };
        largest.see(top(amplitude).abs());
        let theory = grazing_theorems::LinearOscillator::new(zeta, 0.7)?.grazing(omega)?;
        largest.compare(theory.amplitude(), amplitude, amplitude);
        // The maximum is 𝒜/𝒜_graz − 1, on both sides of grazing.
        for factor in [0.99, 1.01] {
            largest.compare(top(factor * amplitude), factor - 1.0, 1.0);
        }
    } => largest.outcome(1e-14, "random damping ratios and frequencies; maxima by search");
    /// The display after eq:Agraz: z_graz is the phase of that maximum.
    // The time of a maximum: rounding of the velocity over its slope ω², which is 0.04 at least.
    grazing_phase: drawn(108, 500) |sampler; largest: Deviations| {
        let (zeta, omega) = (sampler.between(0.005, 0.9), sampler.between(0.2, 3.0));
        let theory = grazing_theorems::LinearOscillator::new(zeta, 0.7)?.grazing(omega)?;
        let oscillator = theory.model();
        let start = sampler_phase(omega);
        let from = oscillator.non_impacting_solution(start);
        let top = oscillator.motion(from).highest_maximum(1.01 * oscillator.forcing_period())
            .ok_or("φ_p has no maximum")?;
        let (sin, cos) = libm::sincos(start + omega * top.time);
        largest.compare(sin, 2.0 * zeta * omega / theory.amplitude(), 1.0);
        largest.compare(cos, (1.0 - omega * omega) / theory.amplitude(), 1.0);
        let (stated_sin, stated_cos) = libm::sincos(theory.phase());
        largest.compare(sin, stated_sin, 1.0);
        largest.compare(cos, stated_cos, 1.0);
    } => largest.outcome(1e-13, "random damping ratios and frequencies; maxima by search");
    /// eq:oscf: the model's flow has no defect.
    // Slack for the term of fourth order.
    equation_of_motion: drawn(101, 300) |sampler; least: Smallest| {
        let oscillator = oscillator(sampler)?;
        let from = sampler.state();
        let start = from.phase / oscillator.frequency();
        let time = start + sampler.between(0.0, 10.0);
        let x = |t: f64| oscillator.flow::<1>(from, t - start).value[0];
        least.see_resolved(order(|h| Some(defect(&oscillator, x, time, h))));
    } => least.order(2.0, 0.3, "random oscillators and orbits of the model; defect by central differences");
    /// Attraction: as t → ∞ solutions converge to φ_p, with distances that decrease like e^{−ζt}.
    // Differences of positions that reach a hundred at resonance.
    attraction: drawn(106, 300) |sampler; largest: Deviations| {
        let oscillator = oscillator(sampler)?;
        let from = sampler.state();
        let zeta = oscillator.damping_ratio();
        let distance = |time: f64| {
            let there = oscillator.flow::<1>(from, time).value;
            let periodic = oscillator.non_impacting_solution(from.phase + oscillator.frequency() * time);
            // The norm that the rotation of the free oscillator preserves: x² + 2ζxy + y².
            let (x, y) = (there[0] - periodic.position, there[1] - periodic.velocity);
            (x * x + 2.0 * zeta * x * y + y * y).sqrt()
        };
        let time = sampler.between(1.0, 8.0);
        largest.compare(distance(time), libm::exp(-zeta * time) * distance(0.0), distance(0.0));
    } => largest.outcome(1e-14, "random oscillators; distance to φ_p in the norm of the free motion");
}
