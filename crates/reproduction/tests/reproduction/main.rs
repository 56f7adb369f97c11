//! The parameter file, the rows that are computed from it, and the same in other units.

mod parameters;
mod study;
mod units;
