//! Oscillators that are given by their force: the integrated flow, its derivatives, motions, bounds and reset laws.

mod closed_form;
mod escape;
mod models;
mod nonlinear;
mod reset;
mod stiff;
mod third_order;
