//! The figures of the paper as SVG, drawn from data frames.
