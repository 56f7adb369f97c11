//! The analysis of the paper's oscillator and of any oscillator that a text file describes: the results
//! of `unfold`, in the oscillator's own units and names, as rows of tables. This crate neither draws nor
//! writes files.

pub mod along;
mod described;
pub mod family;
pub mod limit_map;
pub mod nothing;
pub mod one_parameter;
pub mod place;
pub mod plane;
pub mod sequences;
pub mod unfolded;
