//! Appendices A and B.

mod closed_forms;
mod oscillator;
mod printed_flow;

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
    closed_forms::diagonal_at_resonance,
    closed_forms::resonant_second_derivative_of_one_loop,
    closed_forms::stability_of_one_loop,
    closed_forms::slope_of_one_loop,
    oscillator::second_derivative_of_many_loops,
    closed_forms::angles_at_resonance,
    closed_forms::resonant_second_derivative_of_many_loops,
    closed_forms::stability_of_many_loops,
    closed_forms::detuning_derivative,
    closed_forms::slope_of_many_loops,
    closed_forms::coefficients,
];
