//! The normal form of period doublings of MPSs against the orbits that are created there.

mod invariance;
mod period_doublings;
mod specimens;
