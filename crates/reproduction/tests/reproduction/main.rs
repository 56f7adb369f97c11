//! The parameter file, the rows that are computed from it, and the same in other units.

mod cells;
mod parameters;
mod readings;
mod study;
mod units;
