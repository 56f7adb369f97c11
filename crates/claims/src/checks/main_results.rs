//! Section 1, introduction, and section 2, main results.

mod auxiliary;
mod coefficients;
mod curves;
mod first_figures;
mod global_map;
mod grazing_point;
mod non_impacting;
mod resonant;
pub(crate) mod returns;
pub(crate) mod simulation;
mod system;

mod theorems;

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["main_results":
    first_figures::emanating_solutions,
    first_figures::stability_gained,
    first_figures::singular_jacobian,
    system::equation_of_motion,
    system::phase,
    system::vector_field,
    system::grazing_set,
    system::reset_form,
    system::reset_law,
    global_map::grazing_orbit,
    global_map::expansion,
    global_map::derivative,
    global_map::parameter_derivative,
    non_impacting::trace_and_determinant,
    non_impacting::fixed_point_expansion,
    non_impacting::position_slope,
    non_impacting::transversality,
    non_impacting::eigenvalues,
    non_impacting::trapesium,
    non_impacting::stability,
    auxiliary::resonance_boundary_is_a_zero,
    auxiliary::admissibility_boundary_is_the_largest_zero,
    auxiliary::bounds,
    auxiliary::limit,
    auxiliary::star,
    auxiliary::beyond_the_boundary,
    grazing_point::square_root_factor,
    grazing_point::constants,
    grazing_point::detuning_has_the_sign_of_the_entry,
    resonant::grazing_orbits,
    resonant::second_phase_derivative,
    coefficients::stability_one_loop,
    coefficients::stability_many_loops,
    coefficients::curves_one_loop,
    coefficients::curves_many_loops,
    coefficients::unfolding_derivatives,
    curves::saddle_node_one_loop,
    curves::period_doubling_one_loop,
    curves::saddle_node_many_loops,
    curves::period_doubling_many_loops,
    curves::crossing,
    resonant::sketch,
    resonant::remark,
    theorems::generic_grazing_one_loop,
    theorems::generic_grazing_p_loops,
    theorems::resonant_grazing_one_loop,
    theorems::resonant_grazing_p_loops,
];
