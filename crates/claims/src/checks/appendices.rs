//! Appendices A and B.

mod closed_forms;
mod eigenvalues;
mod oscillator;
mod polar;
mod printed_flow;
pub(crate) mod signs;

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["appendices":
    eigenvalues::definition_of_h,
    eigenvalues::unit_and_double_eigenvalues,
    eigenvalues::h_by_powers,
    eigenvalues::h_by_geometric_series,
    eigenvalues::h_in_closed_form,
    eigenvalues::t_by_powers,
    eigenvalues::t_in_closed_form,
    polar::polar_coordinates,
    polar::differences_of_powers,
    polar::h_as_sum_of_sines,
    polar::h_in_polar_form,
    eigenvalues::s_as_quotient,
    eigenvalues::condition_of_quotient,
    polar::s_in_polar_form,
    polar::zeros_of_s,
    polar::t_in_polar_form,
    polar::t_as_sum_of_sines,
    polar::t_grouped,
    polar::factored_xi,
    signs::h_at_real_eigenvalues,
    signs::h_above_g_before,
    signs::h_at_g_half,
    signs::h_negative_at_g_half,
    signs::bracket_of_h,
    signs::s_at_real_eigenvalues,
    signs::other_zeros_of_s,
    signs::t_at_resonance,
    signs::t_two,
    signs::t_at_real_eigenvalues,
    signs::t_terms,
    signs::xi_not_negative,
    signs::second_term_not_negative,
    signs::third_term_positive,
    signs::numerator_of_u,
    signs::tangent_line,
    signs::power_below_tangent,
    oscillator::return_by_printed_flow,
    oscillator::first_order_terms,
    oscillator::entries_by_derivatives,
    oscillator::derivatives_at_grazing,
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
