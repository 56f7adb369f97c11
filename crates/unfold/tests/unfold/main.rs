//! What is found of an oscillator that nothing is known about, against oscillators of which it is known otherwise.

mod examples;
mod paper;
mod resonances;
mod search;
mod specimens;
