//! Tests of what columns and kinds are called, and how they look.

mod cell;
mod dimensions;
mod kinds;
mod names;
mod rows;
mod words;
