//! Tests of the formulas and theorems, by lemma, by independent derivation, and by independent computation.
//!
//! Property tests run with a fixed seed and keep no files, so that every run draws the same cases.

mod admissibility_boundary;
mod auxiliary;
mod generic_grazing;
mod oscillator_flow;
mod oscillator_map;
mod oscillator_resonances;
mod resonant_grazing;
mod spectrum;
mod truncated_system;
mod unfolding;
mod vivid;

use nalgebra::{Matrix2, Vector2};
use proptest::prelude::{Just, ProptestConfig, Strategy};
use proptest::test_runner::RngSeed;

use grazing_theorems::admissibility_boundary::admissibility_boundary;
use grazing_theorems::{GrazingPoint, LinearisedMap};

/// A deterministic configuration of a property test.
fn deterministic(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0x6772_617a_696e_6721),
        ..ProptestConfig::default()
    }
}

/// Pairs `(tau, delta)` in the trapesium, up to a relative distance 1e-6 from its slanted sides.
fn trapesium() -> impl Strategy<Value = (f64, f64)> {
    (-0.999_999..0.999_999_f64, 0.001..0.999_f64).prop_map(|(share, delta)| (share * (delta + 1.0), delta))
}

/// Triples `(p, tau, delta)` with `tau` between `h_p(delta)` and `delta + 1`.
fn admissible(loops: core::ops::RangeInclusive<u32>) -> impl Strategy<Value = (u32, f64, f64)> {
    (loops, 0.001..0.999_f64, 1e-6..0.999_999_f64).prop_map(|(p, delta, share)| {
        let boundary = admissibility_boundary(p, delta).expect("p >= 2 and 0 < delta < 1");
        (p, boundary + share * (delta + 1.0 - boundary), delta)
    })
}

/// First-order global maps with `(tau, delta)` in the trapesium and entries of order one.
fn maps() -> impl Strategy<Value = LinearisedMap> {
    (trapesium(), -1.5..1.5_f64, 0.2..2.0_f64, proptest::bool::ANY, -1.0..1.0_f64, -1.0..1.0_f64).prop_map(
        |((tau, delta), a11, size, flip, b1, b2)| {
            let a12 = if flip { -size } else { size };
            let a22 = tau - a11;
            let a21 = (a11 * a22 - delta) / a12;
            LinearisedMap { a: Matrix2::new(a11, a12, a21, a22), b: Vector2::new(b1, b2) }
        },
    )
}

/// Grazing points with a map of [`maps`].
fn grazing_points() -> impl Strategy<Value = GrazingPoint> {
    (maps(), 0.2..3.0_f64, 0.2..3.0_f64, 0.1..1.0_f64, prop_or_zero(-0.5..0.5_f64)).prop_map(
        |(map, forcing_frequency, gamma, phi, psi)| GrazingPoint { map, forcing_frequency, gamma, phi, psi },
    )
}

/// A number from the range, or exactly zero.
fn prop_or_zero(range: core::ops::Range<f64>) -> impl Strategy<Value = f64> {
    proptest::prop_oneof![Just(0.0), range]
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
