//! The paper's solution of the linear oscillator as it is printed, for automatic differentiation.

use num_dual::DualNum;

/// eq:flow and its time derivative, with eq:phip and t₀ = z₀/ω, as a function of (x₀, y₀, z₀, s, 𝒜,
/// ω).
pub(crate) fn printed_flow<D: DualNum<Primitive = f64> + Copy>(
    zeta: f64,
    [x0, y0, z0, s, amplitude, omega]: [D; 6],
) -> [D; 2] {
    let omega_1 = (1.0 - zeta * zeta).sqrt();
    let (t0, t) = (z0 / omega, z0 / omega + s);
    let (stiffness, loss) = (-omega * omega + 1.0, omega * (2.0 * zeta));
    let denominator = stiffness * stiffness + loss * loss;
    let periodic = |t: D| {
        let (sine, cosine) = (omega * t).sin_cos();
        let position = amplitude / denominator * (stiffness * cosine + loss * sine) - 1.0;
        let velocity = amplitude / denominator * omega * (loss * cosine - stiffness * sine);
        [position, velocity]
    };
    let [start, start_velocity] = periodic(t0);
    let [end, end_velocity] = periodic(t);
    let (u, v) = (x0 - start, y0 - start_velocity);
    let decay = (-s * zeta).exp();
    let (sine, cosine) = (s * omega_1).sin_cos();
    let sine = sine / omega_1;
    let position = decay * ((cosine + sine * zeta) * u + sine * v);
    let velocity = decay * ((cosine - sine * zeta) * v - sine * u);
    [position + end, velocity + end_velocity]
}
