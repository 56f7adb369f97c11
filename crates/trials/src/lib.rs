//! Long trials of the program at random parameters, compared with independently computed solutions.

pub mod closed_form;
pub mod continued;
pub mod damped;
pub mod errors;
pub mod lines;
pub mod nonlinear;
pub mod oscillators;
pub mod parts;
pub mod random;
pub mod regions;
pub mod simulation;
