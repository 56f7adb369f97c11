//! Tests of the continuation: the engine, the equations, the paper's expansions, and whole curves against simulation.
//!
//! Property tests run with a fixed seed and keep no files, so that every run draws the same cases.

mod arclength;
mod closed_forms;
mod criticality;
mod formulations;
mod hybrid;
mod integrated;
mod located_resonances;
mod newton;
mod one_parameter_branches;
mod specimens;
mod two_parameter_curves;
