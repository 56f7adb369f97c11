//! Published results for the examples, from `expected/published_examples.toml`, compared with
//! computed ones.

mod clearance;
mod published;
mod vivid;
