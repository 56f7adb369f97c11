//! Section 3: the harmonically forced linear oscillator.

mod coefficients;
mod diagram;
mod grazing;
mod motion;
mod propositions;
mod resonances;

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["oscillator":
    motion::equation_of_motion,
    motion::reset_law,
    motion::damped_frequency,
    motion::flow,
    motion::periodic_solution,
    motion::attraction,
    motion::grazing_amplitude,
    motion::grazing_phase,
    grazing::general_form,
    grazing::constants,
    grazing::square_root_factor,
    grazing::first_derivatives,
    grazing::parameter_derivatives,
    grazing::both_derivatives,
    grazing::trace_and_determinant,
    grazing::transversality,
    resonances::one_loop,
    resonances::many_loops,
    resonances::indices,
    resonances::off_diagonal,
    resonances::virtual_solutions,
    resonances::stable_two_loops,
    coefficients::decay,
    propositions::one_loop,
    propositions::one_loop_odd,
    propositions::one_loop_even,
    propositions::many_loops,
    propositions::many_loops_misprint,
    coefficients::signs,
    coefficients::opposite_sides,
    coefficients::quadratic_approximation,
    diagram::non_impacting_region,
    diagram::boundaries,
];
