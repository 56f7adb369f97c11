//! Tests of the continuation: the engine, the equations, and whole curves compared with closed
//! forms and simulation; statements of the paper are checked by the ledger of claims.
//!
//! Property tests run with a fixed seed and keep no files, so that every run draws the same cases.

mod arclength;
mod bifurcation;
mod cascade;
mod closed_forms;
mod criticality;
mod emerging;
mod formulations;
mod hybrid;
mod integrated;
mod limit_map;
mod located_resonances;
mod newton;
mod one_parameter_branches;
mod several_impacts;
mod solution;
mod specimens;
mod two_parameter_curves;
