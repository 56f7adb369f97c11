//! Diagrams found without prior knowledge of the oscillator, compared with results known by other
//! means.

mod both_stops;
mod calibration;
mod cookbook;
mod corners;
mod damped;
mod examples;
mod family;
mod generations;
mod hard;
mod one_parameter;
mod own_curves;
mod paper;
mod pitchforks;
mod places;
mod regions;
mod resonances;
mod search;
mod sequences;
mod slivers;
mod specimens;
mod straightened;
mod torus;
mod two_stops;
mod units;
mod verdicts;
