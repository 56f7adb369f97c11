//! Appendices A and B.

pub(crate) mod eigenvalues;
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
    eigenvalues::polar_coordinates,
    eigenvalues::differences_of_powers,
    eigenvalues::h_as_sum_of_sines,
    eigenvalues::h_in_polar_form,
    eigenvalues::s_as_quotient,
    eigenvalues::s_in_polar_form,
    eigenvalues::zeros_of_s,
    eigenvalues::t_in_polar_form,
    eigenvalues::t_as_sum_of_sines,
    eigenvalues::t_grouped,
    eigenvalues::factored_xi,
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
    signs::numerator_of_u,
    signs::tangent_line,
    signs::power_below_tangent,
];
