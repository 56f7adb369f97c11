//! Appendices A and B.

mod oscillator;

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["appendices":
    oscillator::return_by_printed_flow,
    oscillator::first_order_terms,
    oscillator::entries_by_derivatives,
    oscillator::derivatives_at_grazing,
    oscillator::matrix_and_vector,
    oscillator::second_derivative_by_flow,
    oscillator::second_derivative_in_start,
    oscillator::second_derivative_of_one_loop,
    oscillator::diagonal_at_resonance,
    oscillator::resonant_second_derivative_of_one_loop,
    oscillator::stability_of_one_loop,
    oscillator::slope_of_one_loop,
    oscillator::second_derivative_of_many_loops,
    oscillator::angles_at_resonance,
    oscillator::resonant_second_derivative_of_many_loops,
    oscillator::stability_of_many_loops,
    oscillator::detuning_derivative,
    oscillator::slope_of_many_loops,
    oscillator::coefficients,
];
