//! Numerical continuation of maximal periodic solutions and of their bifurcations.

#![allow(missing_docs)]
pub mod arclength;
pub mod curve;
pub mod fit;
pub mod locate;
pub mod mps;
pub mod newton;
pub mod resonance;
