//! Section 4: calculations for generic grazing bifurcations.

mod iterates;
pub(crate) mod specimens;

use super::{Check, checks};

pub(crate) const CHECKS: &[Check] = checks!["generic":
    iterates::sums_of_eigenvalues,
    iterates::h_as_sum_of_s,
    iterates::difference_of_products,
    iterates::iterated_map,
    iterates::powers,
    iterates::parameter_terms,
    iterates::induction,
    iterates::sign_of_s,
    iterates::values_at_resonance,
    iterates::sign_of_t,
    iterates::signs_and_values,
];
