//! Regions of admissible p-loop solutions in the whole trapesium. Not in the paper.

use core::f64::consts::PI;

use grazing_theorems::Side;
use grazing_theorems::admissibility_boundary::admissibility_boundary;
use grazing_theorems::admissibility_region::{
    AdmissibilityRegion, admissibility_margin, is_closest_return, rotation,
};
use grazing_theorems::auxiliary::{lucas_sequence, scaled_visit_position};
use proptest::prelude::*;

use crate::{assert_within, deterministic};

const SIDES: [Side; 2] = [Side::Positive, Side::Negative];

/// The number of regions that contain a point of the trapesium.
fn holding(p: u32, tau: f64, delta: f64, factor: Side) -> usize {
    let holds = |region: &AdmissibilityRegion| {
        let found = region.traces(delta).filter(|_| region.factor() == factor);
        found.is_some_and(|[(low, _), (high, _)]| low < tau && tau < high)
    };
    AdmissibilityRegion::all(p).iter().filter(|region| holds(region)).count()
}

proptest! {
    #![proptest_config(deterministic(1500))]

    #[test]
    fn the_margin_is_that_of_all_visits(p in 2..=12_u32, delta in 0.01..0.999_f64, share in -1.0..1.0_f64) {
        let tau = share * (1.0 + delta);
        for factor in SIDES {
            let visits = (1..p).map(|j| -factor.signum() * scaled_visit_position(j, p, tau, delta));
            assert_within(admissibility_margin(p, tau, delta, factor).0, visits.fold(f64::INFINITY, f64::min), 1e-10);
        }
    }

    #[test]
    fn regions_are_all_places_where_solutions_are_admissible(
        p in 2..=12_u32, delta in 0.02..0.9999_f64, share in 1e-9..0.999_999_f64, is_positive in any::<bool>(),
    ) {
        let (tau, factor) = ((2.0 * share - 1.0) * (1.0 + delta), SIDES[usize::from(is_positive)]);
        let (margin, _) = admissibility_margin(p, tau, delta, factor);
        // Rounding of sums of up to a hundred terms of order one.
        prop_assume!(margin.abs() > 1e-13);
        prop_assert_eq!(holding(p, tau, delta, factor), usize::from(margin > 0.0));
    }

    #[test]
    fn without_contraction_solutions_are_admissible_at_closest_returns(p in 2..=40_u32, x in 0.001..0.999_f64) {
        // Away from rational numbers with small denominators, where a margin vanishes.
        let nearest = (1..=p).map(|j| (f64::from(j) * x - libm::round(f64::from(j) * x)).abs());
        prop_assume!(nearest.fold(f64::INFINITY, f64::min) > 1e-4 && (x - 0.5).abs() > 1e-3);
        let factor = Side::of(0.5 - x);
        let (margin, _) = admissibility_margin(p, 2.0 * libm::cos(2.0 * PI * x), 1.0, factor);
        prop_assert_eq!(margin > 0.0, is_closest_return(p, x));
        let between = |region: &AdmissibilityRegion| region.rotations()[0] < x && x < region.rotations()[1];
        prop_assert_eq!(AdmissibilityRegion::all(p).iter().filter(|region| between(region)).count(), usize::from(margin > 0.0));
    }
}

#[test]
fn the_region_of_one_turn_is_that_of_theorem_2_3() {
    for p in 3..=12 {
        let region = AdmissibilityRegion { loops: p, turns: 1 };
        for delta in [0.05, 0.5, 0.9, 0.999] {
            let [(low, visit), (high, side)] = region.traces(delta).expect("it reaches down to 0");
            assert_within(low, admissibility_boundary(p, delta).expect("in the domain"), 1e-12);
            // H_p is the condition of the last visit but one.
            assert_eq!((high, visit, side), (1.0 + delta, Some(p - 1), None));
        }
    }
}

#[test]
fn others_lie_beside_the_stable_non_impacting_motion_without_a_resonance() {
    for region in (2..=12).flat_map(AdmissibilityRegion::all).filter(|region| region.turns > 1) {
        let lowest = region.lowest_determinant();
        for share in [0.1, 0.3, 0.9, 0.999] {
            let delta = lowest + share * (1.0 - lowest);
            let [low, high] = region.traces(delta).expect("it reaches down to there").map(|(tau, _)| tau);
            for part in [0.01, 0.5, 0.99] {
                let tau = low + part * (high - low);
                // βμ has the sign of a12 α S_p.
                let side = region.factor().signum() * lucas_sequence(region.loops, tau, delta);
                assert!(side < 0.0, "{region:?} {tau} {delta}");
                let ([left, right], x) = (region.rotations(), rotation(tau, delta, region.factor()));
                assert!(x.is_nan() || (left < x && x < right), "{region:?} {x} {delta}");
            }
        }
        assert!(region.traces(lowest - 1e-9).is_none(), "{region:?}");
        // The curve of the visit that touches turns there.
        if lowest > 0.0 {
            let width = |above: f64| region.traces(lowest + above).map(|[from, to]| to.0 - from.0);
            let [near, far] = [1e-9, 4e-9].map(|above| width(above).expect("just above"));
            assert!(near < 1e-4 && (far / near - 2.0).abs() < 1e-2, "{region:?} {near} {far}");
        }
    }
}

#[test]
fn one_visit_touches_the_wall_along_the_whole_boundary_of_a_region() {
    for region in (2..=12).flat_map(AdmissibilityRegion::all) {
        for level in 1..400 {
            for (tau, visit) in region.traces(f64::from(level) / 400.0).into_iter().flatten() {
                assert!(
                    visit.is_none_or(|visit| visit == region.touching_visit()),
                    "{region:?} {tau} {visit:?}"
                );
            }
        }
    }
    // 1 + tau + tau^2 = delta
    let lowest = AdmissibilityRegion { loops: 4, turns: 3 }.lowest_determinant();
    assert_within(lowest, 0.75, 1e-14);
}
