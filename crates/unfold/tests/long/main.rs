//! Tests that take minutes, for which `cargo test --workspace` is too often. Run all of them with
//! `cargo test -p grazing-unfold --test long` when regions or curves have changed; `.ci/run` runs a few.

mod regions;
#[expect(dead_code, reason = "the other test program uses the rest")]
#[path = "../unfold/specimens.rs"]
mod specimens;
