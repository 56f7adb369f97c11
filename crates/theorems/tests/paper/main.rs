//! Tests of what the ledger of claims (`crates/claims`) does not cover: domains, hypotheses, digits
//! and lists.
//!
//! Property tests run with a fixed seed and keep no files, so that every run draws the same cases.

mod admissibility_boundary;
mod admissibility_region;
mod auxiliary;
mod generic_grazing;
mod identities;
mod iterated;
mod limit_map;
mod linear_oscillator;
mod resonant_grazing;
mod spectrum;

use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// A deterministic configuration of a property test.
fn deterministic(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0x6772_617a_696e_6721),
        ..ProptestConfig::default()
    }
}

/// Fails unless the numbers differ by at most `tolerance` in proportion to the expected one.
#[track_caller]
fn assert_close(computed: f64, expected: f64, tolerance: f64) {
    assert_within(computed, expected, tolerance * expected.abs());
}

/// Fails unless the numbers differ by at most `bound`.
#[track_caller]
fn assert_within(computed: f64, expected: f64, bound: f64) {
    let difference = (computed - expected).abs();
    assert!(
        difference <= bound,
        "{computed:e} instead of {expected:e}: off by {difference:e}, more than {bound:e}"
    );
}
