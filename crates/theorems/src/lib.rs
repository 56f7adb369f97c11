//! The formulas and theorems of the paper as functions and checked types.
