//! Tests of the parameter file, of the computed rows, and of results in other units.

mod cells;
mod parameters;
mod readings;
mod study;
mod units;
