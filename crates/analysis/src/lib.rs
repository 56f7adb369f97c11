//! The analysis of any oscillator that a text file describes, and of the paper's: what `unfold`
//! finds, in the oscillator's own units and names, as rows of tables. Nothing here draws or writes
//! files.

mod described;
pub mod family;
pub mod limits;
pub mod one_parameter;
pub mod place;
pub mod plane;
pub mod unfolded;
