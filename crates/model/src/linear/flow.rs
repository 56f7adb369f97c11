//! The closed-form flow of the linear oscillator with hand-written first and second derivatives.

use nalgebra::{Matrix2, Matrix2x6, Matrix6, Vector2};

use super::oscillator::LinearOscillator;
use crate::jet::FlowJet;
use crate::state::State;
use crate::state::flow_variable::*;

/// The solution eq:flow after a time s, with derivatives in (x₀, y₀, z₀, s, 𝒜, ω).
///
/// With w = (x, y), f(z, ω) the periodic response to unit forcing, M the matrix of the unforced
/// oscillator and E = e^{Ms}, eq:flow reads w(s) = E (w₀ + e₁ − 𝒜 f(z₀)) − e₁ + 𝒜 f(z₀ + ωs). Every
/// derivative below follows by one product rule and f_zz = −f.
pub(super) fn flow<const ORDER: usize>(oscillator: &LinearOscillator, from: State, duration: f64) -> FlowJet {
    let LinearOscillator { damping_ratio, amplitude, frequency, natural_frequency, .. } = *oscillator;
    let decay = libm::exp(-damping_ratio * duration);
    let (sin, cos) = libm::sincos(natural_frequency * duration);
    let (c, q) = (decay * cos, decay * sin / natural_frequency);
    let propagator = Matrix2::new(c + damping_ratio * q, q, -q, c - damping_ratio * q);
    let unforced = Matrix2::new(0.0, 1.0, -1.0, -2.0 * damping_ratio);

    let start = oscillator.response.at(from.phase);
    let end = oscillator.response.at(from.phase + frequency * duration);
    let displacement = Vector2::new(from.position + 1.0, from.velocity) - start.value * amplitude;
    let transient = propagator * displacement;
    let value = transient + end.value * amplitude - Vector2::new(1.0, 0.0);

    let transient_rate = unforced * transient;
    let unforced_propagator = unforced * propagator;
    let e_value = propagator * start.value;
    let e_phase = propagator * start.d_phase;
    let e_frequency = propagator * start.d_frequency;

    let mut jacobian = Matrix2x6::zeros();
    jacobian.fixed_columns_mut::<2>(POSITION).copy_from(&propagator);
    jacobian.set_column(PHASE, &((end.d_phase - e_phase) * amplitude));
    jacobian.set_column(DURATION, &(transient_rate + end.d_phase * (amplitude * frequency)));
    jacobian.set_column(PRIMARY, &(end.value - e_value));
    jacobian.set_column(SECONDARY, &((end.d_frequency + end.d_phase * duration - e_frequency) * amplitude));

    let mut hessians = [Matrix6::zeros(); 2];
    if ORDER >= 2 {
        let mut set = |row: usize, column: usize, entry: Vector2<f64>| {
            for (hessian, value) in hessians.iter_mut().zip(entry.iter()) {
                hessian[(row, column)] = *value;
                hessian[(column, row)] = *value;
            }
        };
        set(POSITION, DURATION, unforced_propagator.column(0).into_owned());
        set(VELOCITY, DURATION, unforced_propagator.column(1).into_owned());
        set(PHASE, PHASE, (e_value - end.value) * amplitude);
        set(PHASE, DURATION, -(unforced * e_phase + end.value * frequency) * amplitude);
        set(PHASE, PRIMARY, end.d_phase - e_phase);
        let phase_frequency =
            end.d_phase_frequency - end.value * duration - propagator * start.d_phase_frequency;
        set(PHASE, SECONDARY, phase_frequency * amplitude);
        set(DURATION, DURATION, unforced * transient_rate - end.value * (amplitude * frequency * frequency));
        set(DURATION, PRIMARY, end.d_phase * frequency - unforced * e_value);
        let duration_frequency =
            end.d_phase + (end.d_phase_frequency - end.value * duration) * frequency - unforced * e_frequency;
        set(DURATION, SECONDARY, duration_frequency * amplitude);
        set(PRIMARY, SECONDARY, end.d_frequency + end.d_phase * duration - e_frequency);
        let frequency_frequency = end.d_frequency_frequency
            + (end.d_phase_frequency * 2.0 - end.value * duration) * duration
            - propagator * start.d_frequency_frequency;
        set(SECONDARY, SECONDARY, frequency_frequency * amplitude);
    }
    FlowJet { value, jacobian, hessians }
}
