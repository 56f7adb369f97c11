//! Section 5: calculations for resonant grazing bifurcations; section 6: discussion.

mod branch;
mod criticality;
mod curves;
mod derivatives;
mod discussion;
mod doubled;
pub(crate) mod places;
mod simulation;
mod stability;
mod visits;

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["resonant":
    simulation::multipliers,
    stability::trace_and_determinant,
    stability::divergence,
    derivatives::second_derivatives,
    stability::extension_for_one_loop,
    stability::trace_of_one_loop,
    stability::determinant_of_one_loop,
    stability::extension_for_many_loops,
    stability::trace_of_many_loops,
    stability::determinant_of_many_loops,
    derivatives::slope_of_many_loops,
    derivatives::of_virtual_map,
    derivatives::after_reset,
    derivatives::determinant_quotient,
    derivatives::of_discontinuity_map,
    derivatives::slope_of_one_loop,
    derivatives::of_global_map,
    derivatives::product,
    derivatives::power_at_resonance,
    derivatives::of_iterated_global_map,
    derivatives::other_cure,
    branch::jacobians,
    branch::second_jacobian_is_regular,
    branch::at_zero_velocity,
    branch::form,
    branch::return_of_one_loop,
    branch::vivid_of_one_loop,
    branch::solution,
    branch::coefficients_of_one_loop,
    branch::multiplier_conditions,
    branch::stability_of_one_loop,
    curves::velocity_of_one_loop,
    curves::functions_of_one_loop,
    curves::simplification,
    curves::square_root,
    curves::admissible_with_one_loop,
    branch::return_of_many_loops,
    branch::vivid_of_many_loops,
    branch::coefficients_of_many_loops,
    branch::stability_of_many_loops,
    curves::velocity_of_many_loops,
    curves::functions_of_many_loops,
    curves::admissible_with_many_loops,
    visits::phase,
    visits::position_after_recoil,
    visits::phase_after_recoil,
    visits::visits_by_powers,
    visits::positions_of_visits,
    visits::sums_are_positive,
    visits::signs_of_visits,
    discussion::periodic_response,
    discussion::periodicity_regions,
    discussion::direction_by_parity,
    discussion::finite_differences,
    discussion::impacts_elsewhere,
    criticality::criterion_at_resonance,
    criticality::criticality_of_figure_7,
    criticality::doubled_solutions_graze,
];
