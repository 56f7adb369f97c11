//! Appendices A and B.

mod eigenvalues;
mod polar;
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
];
