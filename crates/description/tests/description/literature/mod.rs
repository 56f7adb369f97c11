//! What other publications give for the examples, in `expected/published_examples.toml`, against
//! what is computed here.

mod clearance;
mod published;
mod vivid;
