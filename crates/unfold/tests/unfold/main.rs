//! What is found of an oscillator that nothing is known about, against oscillators of which it is
//! known otherwise.

mod calibration;
mod cookbook;
mod corners;
mod examples;
mod family;
mod levels;
mod one_parameter;
mod paper;
mod pitchforks;
mod places;
mod regions;
mod resonances;
mod search;
mod slivers;
mod specimens;
mod straightened;
mod torus;
mod units;
mod verdicts;
