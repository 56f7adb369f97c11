//! Tests of the continuation: the engine, the equations, the paper's expansions, and whole curves against simulation.
//!
//! Property tests run with a fixed seed and keep no files, so that every run draws the same cases.

mod arclength;
mod formulations;
mod hybrid;
mod newton;
mod specimens;
mod stability_expansions;
mod vivid_function;
