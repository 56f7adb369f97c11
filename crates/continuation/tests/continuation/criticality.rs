//! The normal form of period doublings of MPSs, compared with the orbits that are created there.

mod invariance;
mod normal_form;
mod period_doublings;
mod specimens;
