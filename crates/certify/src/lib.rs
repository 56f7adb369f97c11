//! Proofs, in ball arithmetic over integers, of what Figure 7 shows of the paper's oscillator.
#![allow(missing_docs)]
pub mod ball;
pub mod certificate;
pub mod orbit;
pub mod proof;
pub mod row;
pub mod search;
pub mod series;
