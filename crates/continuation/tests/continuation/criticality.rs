//! Normal forms of the bifurcations of MPSs against what is created there, solved for and simulated.

mod doubled;
mod invariance;
mod period_doublings;
mod saddle_nodes;
mod specimens;
