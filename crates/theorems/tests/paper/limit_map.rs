//! The limit map at a resonance. Not in the paper.

use grazing_theorems::limit_map::{Departure, LimitImpact};
use grazing_theorems::{
    GrazingPoint, LimitMap, LinearOscillator, LinearisedMap, ResonantPoint, Side, Unfolding,
};
use nalgebra::{Matrix2, Vector2};
use num_rational::Ratio;
use proptest::prelude::*;

use crate::{assert_close, assert_within, deterministic};

/// Exact fractions: a relation that holds at this many of them, drawn at random, is an identity.
type Exact = Ratio<i128>;

fn whole(n: i128) -> Exact {
    Exact::from_integer(n)
}

fn fraction(largest: i128) -> impl Strategy<Value = Exact> {
    (-largest..=largest, 2..=7_i128).prop_map(|(numerator, denominator)| Exact::new(numerator, denominator))
}

/// A positive fraction below 1.
fn share() -> impl Strategy<Value = Exact> {
    (1..=6_i128).prop_flat_map(|n| (n + 1..=7).prop_map(move |denominator| Exact::new(n, denominator)))
}

/// Maps with random (r, k, d) and p = 1, or p = 2 and d < 0.
fn maps() -> impl Strategy<Value = LimitMap<Exact>> {
    let numbers = (1..=2_u32, fraction(5), fraction(9), share());
    numbers.prop_filter_map("outside of the domain", |(loops, r, k, d)| {
        LimitMap::new(loops, [r, k, if loops == 1 { d } else { -d }]).ok()
    })
}

proptest! {
    #![proptest_config(deterministic(400))]

    #[test]
    fn periodic_orbits_are_orbits(map in maps(), velocity in fraction(9), gap in fraction(9)) {
        let (fixed, parameter) = map.fixed_point(velocity);
        prop_assert_eq!(map.next_square(parameter, fixed), velocity * velocity);
        prop_assert_eq!(map.next_phase(fixed, velocity), fixed.phase);
        let [first, second] = map.doubled_impacts(gap);
        let parameter = map.doubled_parameter(gap * gap);
        for (from, to) in [(first, second), (second, first)] {
            prop_assert_eq!(map.next_square(parameter, from), to.velocity * to.velocity);
            prop_assert_eq!(map.next_phase(from, to.velocity), to.phase);
        }
        prop_assert_eq!(first.phase - second.phase, gap);
    }

    #[test]
    fn saddle_nodes_and_period_doublings_are_where_multipliers_have_it(map in maps()) {
        let [plus, minus] = map.stability();
        let [_, _, d] = map.numbers();
        let one = whole(1);
        let [velocity, parameter] = map.saddle_node();
        let [trace, determinant] = map.multipliers(velocity);
        prop_assert_eq!(one - trace + determinant, whole(0));
        prop_assert_eq!(parameter, one / ((one - d) * plus));
        // eq:coeffs1, eq:coeffsp
        let [velocity, doubling] = map.period_doubling();
        let [trace, determinant] = map.multipliers(velocity);
        prop_assert_eq!(one + trace + determinant, whole(0));
        prop_assert_eq!(doubling, plus / minus * (whole(2) - plus / minus) * parameter);
    }

    #[test]
    fn stability_of_doubled_orbits_is_of_second_degree(map in maps(), gap in fraction(9)) {
        let [first, second] = map.doubled_impacts(gap);
        let product = first.velocity * second.velocity;
        prop_assume!(product != whole(0));
        let trace = map.doubled_trace(gap);
        let ([r, _, d], [_, minus], one) = (map.numbers(), map.stability(), whole(1));
        let determinant = r * r * d * d;
        let expected = -(one - d) * minus * map.bend_of_doubled() * gap * gap / whole(4);
        prop_assert_eq!((one - trace + determinant) * product, expected);
        let at = map.second_doubling();
        let doubling = (one + trace + determinant) * product * at;
        prop_assert_eq!(doubling, whole(2) * (one + determinant) / (minus * minus) * (at - gap * gap));
    }

    #[test]
    fn doubled_orbits_graze_at_a_velocity_of_one_loop_and_a_phase_of_more(map in maps()) {
        let ([r, k, d], [_, minus], one, gap) = (map.numbers(), map.stability(), whole(1), map.grazing_gap());
        let scaled = map.doubled_parameter(gap * gap) * minus * minus / whole(4);
        let turn = (one - d) * (one - d);
        let [_, second] = map.doubled_impacts(-map.grazing_gap());
        let [first, _] = map.doubled_impacts(map.grazing_gap());
        // For one loop d > 0 here.
        prop_assert_eq!(if d > whole(0) { first.velocity } else { first.phase }, whole(0));
        prop_assert_eq!(if d > whole(0) { second.velocity } else { second.phase }, whole(0));
        let expected = if d > whole(0) {
            (one + r * d) / (one - d) + k * d / (turn * (one + d) * (one + d))
        } else {
            (one - r * d * d) / turn
        };
        prop_assert_eq!(scaled, expected);
    }

    #[test]
    fn the_linear_oscillator_has_simple_coefficients(
        sigma in share(), epsilon in share(), velocity in fraction(9), phase in fraction(9),
    ) {
        for (loops, sigma) in [(1, sigma), (1, -sigma), (2, -sigma)] {
            let map = LimitMap::of_linear_oscillator(loops, sigma, epsilon).unwrap();
            let (one, q) = (whole(1), sigma * epsilon);
            let fourth = (one - q) * (one - q) * (one - q) * (one - q);
            prop_assert_eq!(map.stability(), [-(one + q) * (one + q), (one - q) * (one - q)]);
            let bend = (one - q) * (one + whole(3) * (sigma + q) + sigma * q);
            prop_assert_eq!(map.bend_of_doubled(), bend);
            let grazing = if loops == 1 {
                let numerator = one + whole(2) * sigma * (one - q + q * q) + sigma * sigma * q * q;
                numerator / ((one - sigma) * (one + sigma) * (one + sigma))
            } else {
                (one - sigma * q * q) / ((one - sigma) * (one - sigma))
            };
            let gap = map.grazing_gap();
            prop_assert_eq!(map.doubled_parameter(gap * gap), whole(4) * grazing / fourth);
            // In the impact phase.
            let theta = (one + epsilon) * phase + epsilon * velocity;
            let u = theta - epsilon * velocity;
            let expected = sigma * sigma * u * u - whole(2) * sigma * theta * u
                + sigma * theta * theta + whole(2) * u / (one + epsilon);
            let from = LimitImpact { velocity, phase };
            prop_assert_eq!(map.next_square(whole(0), from), expected);
            let next = LimitImpact { velocity, phase: map.next_phase(from, velocity) };
            let theta = (one + epsilon) * next.phase + epsilon * velocity;
            prop_assert_eq!(theta, sigma * u - velocity);
        }
    }
}

/// A generic resonance, of no particular oscillator.
fn general(loops: u32) -> ResonantPoint {
    let a = if loops == 1 { Matrix2::new(0.3, 0.0, -0.5, 0.2) } else { Matrix2::new(-0.2, 0.4, -0.5, 0.2) };
    let map = LinearisedMap { a, b: Vector2::new(0.7, 0.1) };
    let grazing = GrazingPoint { map, forcing_frequency: 1.2, gamma: 0.8, phi: 0.75, psi: 0.2 };
    let unfolding = Unfolding { loops, derivative: -0.5 };
    ResonantPoint { grazing, second_phase_derivative: 0.3, unfolding }
}

/// Relative tolerance: twelve digits.
const DIGITS: f64 = 1e-12;

fn assert_gives_the_coefficients(point: &ResonantPoint) {
    let (map, scale) = (point.limit_map(), point.limit_scale());
    let [[_, saddle_node], [_, period_doubling]] = [map.saddle_node(), map.period_doubling()];
    assert_close(scale.parameter * saddle_node, point.saddle_node_coefficient(), DIGITS);
    assert_close(scale.parameter * period_doubling, point.period_doubling_coefficient(), DIGITS);
    let [[saddle_node, _], [period_doubling, _]] = [map.saddle_node(), map.period_doubling()];
    assert_close(scale.velocity * saddle_node, point.saddle_node_velocity_slope(), DIGITS);
    assert_close(scale.velocity * period_doubling, point.period_doubling_velocity_slope(), DIGITS);
    // The impact phase.
    let (fixed, _) = map.fixed_point(period_doubling);
    let [velocity, phase] = scale.impact(1.0, fixed);
    assert_close(scale.limit(1.0, [velocity, phase]).phase, fixed.phase, DIGITS);
    let expected = point.branch_expansion().k_1 * point.period_doubling_velocity_slope();
    assert_close(phase, expected, DIGITS);
}

#[test]
fn fixed_points_give_the_coefficients_of_the_theorems() {
    let paper = LinearOscillator::new(0.02, 0.9).unwrap();
    for (p, n) in [(1, 2), (1, 3), (1, 4), (1, 5), (2, 1), (2, 2), (3, 1), (3, 2)] {
        assert_gives_the_coefficients(&paper.resonance(p, n).unwrap().resonant_point());
    }
    for loops in 1..=2 {
        assert_gives_the_coefficients(&general(loops));
    }
}

proptest! {
    #![proptest_config(deterministic(200))]

    #[test]
    fn a_linear_oscillator_s_map_is_that_of_sigma_and_epsilon(
        zeta in 0.005..0.2_f64, epsilon in 0.1..1.0_f64, loops in 1..=6_u32, index in 1..=6_u32,
    ) {
        let resonance = LinearOscillator::new(zeta, epsilon).unwrap().resonance(loops, index).unwrap();
        let point = resonance.resonant_point();
        assert_gives_the_coefficients(&point);
        let decay = resonance.grazing().decay(loops);
        let sigma = if loops == 1 && index.is_multiple_of(2) { decay } else { -decay };
        let map = LimitMap::of_linear_oscillator(loops, sigma, epsilon).unwrap();
        for (computed, expected) in point.limit_map().numbers().into_iter().zip(map.numbers()) {
            assert_close(computed, expected, DIGITS);
        }
        // f_p is −2πpσ/ω.
        let slope = -core::f64::consts::TAU * f64::from(loops) * sigma / point.grazing.forcing_frequency;
        assert_close(point.off_diagonal_slope(), slope, DIGITS);
    }
}

#[test]
fn traces_are_those_of_the_map_s_differences() {
    for point in [general(1), general(2)] {
        let map = point.limit_map();
        let [velocity, _] = map.period_doubling();
        let side = Side::of(velocity);
        let trace = |parameter: f64, at: LimitImpact, steps: u32| {
            let image = |dy: f64, dv: f64| {
                let mut here = LimitImpact { velocity: at.velocity + dy, phase: at.phase + dv };
                for _ in 0..steps {
                    here = map.step(side, parameter, here).expect("it is admissible");
                }
                [here.velocity, here.phase]
            };
            let h = 1e-5;
            let by_velocity = (image(h, 0.0)[0] - image(-h, 0.0)[0]) / (2.0 * h);
            by_velocity + (image(0.0, h)[1] - image(0.0, -h)[1]) / (2.0 * h)
        };
        let (fixed, parameter) = map.fixed_point(1.3 * velocity);
        assert_within(trace(parameter, fixed, 1), map.multipliers(1.3 * velocity)[0], 1e-8);
        let gap = 0.4 * map.grazing_gap();
        let doubled = map.doubled_impacts(gap);
        let parameter = map.doubled_parameter(gap * gap);
        assert_within(trace(parameter, doubled[0], 2), map.doubled_trace(gap), 1e-8);
    }
}

#[test]
fn motion_departs_where_it_is_not_admissible() {
    let one = LimitMap::of_linear_oscillator(1, -0.6, 0.8).unwrap();
    let more = LimitMap::of_linear_oscillator(2, -0.6, 0.8).unwrap();
    let behind = LimitImpact { velocity: 1.0, phase: 0.1 };
    assert!(one.step(Side::Positive, 1.0, behind).is_ok());
    assert_eq!(more.step(Side::Positive, 1.0, behind), Err(Departure::EarlyVisit));
    assert_eq!(one.step(Side::Positive, -9.0, behind), Err(Departure::Missed));
    // On the other side of the resonance all signs are reversed.
    let mirrored = LimitImpact { velocity: -1.0, phase: 0.1 };
    let next = more.step(Side::Negative, 1.0, mirrored).unwrap();
    assert!(next.velocity < 0.0);
    for (loops, sigma, epsilon) in
        [(0, -0.5, 0.5), (2, 0.5, 0.5), (1, 1.0, 0.5), (1, 0.5, 0.0), (1, 0.5, 2.0)]
    {
        assert!(LimitMap::of_linear_oscillator(loops, sigma, epsilon).is_err());
    }
    assert!(LimitMap::of_linear_oscillator(1, f64::NAN, 0.5).is_err());
}

#[test]
fn period_doublings_of_the_linear_oscillator_turn_at_one_line() {
    // E (3 + 3ε − Eε) = 1, which for ε = 1 is E = 3 − √8; for even n and p = 1 there is none.
    let supercritical = |loops, sigma: f64, epsilon| {
        LimitMap::of_linear_oscillator(loops, sigma, epsilon).unwrap().criticality() > 0.0
    };
    for loops in 1..=3 {
        for epsilon in [0.1, 0.5, 0.9, 1.0] {
            let root: f64 = (3.0 + 3.0 * epsilon) / (2.0 * epsilon);
            let decay = root - (root * root - 1.0 / epsilon).sqrt();
            assert!(supercritical(loops, -decay - 1e-9, epsilon));
            assert!(!supercritical(loops, 1e-9 - decay, epsilon));
            assert!(!supercritical(1, decay, epsilon));
        }
    }
}
