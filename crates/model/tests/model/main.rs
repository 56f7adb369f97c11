//! Tests of the model: flows, motions, maps, orbits and reset laws, of the linear oscillator in
//! closed form and of others by integration.

mod closed_form;
mod escape;
mod exact;
mod flow;
mod maps;
mod models;
mod nonlinear;
mod orbits;
mod printed;
mod reset;
mod rests;
mod stiff;
mod third_order;
