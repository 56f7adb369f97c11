//! Solutions of more loops at a one-loop resonance. Not in the paper.

use grazing_theorems::iterated::{EndEvent, IteratedResonance, last_visit_margin};
use grazing_theorems::{LimitMap, LinearOscillator, Side};
use num_rational::Ratio;
use proptest::prelude::*;

use crate::{assert_close, assert_within, deterministic};

/// Exact fractions, as for the limit map.
type Exact = Ratio<i128>;

fn fraction() -> impl Strategy<Value = Exact> {
    (-4..=4_i128, 2..=5_i128).prop_map(|(numerator, denominator)| Exact::new(numerator, denominator))
}

fn whole(n: i32) -> Exact {
    Exact::from_integer(n.into())
}

/// The positions X at the visits of k loops; the last is the next impact.
fn visits(loops: u32, [a, d, k]: [Exact; 3], start: [Exact; 2], parameter: Exact) -> Vec<Exact> {
    let (mut here, mut found) = (start, Vec::new());
    for _ in 0..loops {
        let [position, phase] = here;
        let next = a * position + k * phase * phase + phase + phase + parameter;
        here = [next, d * phase];
        found.push(next);
    }
    found
}

proptest! {
    #![proptest_config(deterministic(300))]

    #[test]
    fn two_loops_graze_at_twice_the_velocity_of_the_period_doubling(
        a in fraction(), d in fraction(), k in fraction(), restitution in fraction(), velocity in fraction(),
    ) {
        let one = whole(1);
        prop_assume!(d * d < one && a + one != whole(0));
        let r = a * restitution * restitution;
        let Ok(map) = LimitMap::new(1, [r, k, d]) else { return Ok(()) };
        let start = [restitution * restitution * velocity * velocity, -velocity / (one - d * d)];
        // X_2 is linear in M.
        let base = visits(2, [a, d, k], start, whole(0))[1];
        let parameter = (velocity * velocity - base) / (one + a);
        let found = visits(2, [a, d, k], start, parameter);
        prop_assert_eq!(found[1], velocity * velocity);
        let [doubling, _] = map.period_doubling();
        let expected = velocity * (velocity / doubling - whole(2)) / ((one + a) * (one + d));
        prop_assert_eq!(found[0], expected);
        // The period-doubled orbit that grazes there.
        let gap = map.grazing_gap();
        let [fast, still] = map.doubled_impacts(gap);
        let at = if still.velocity == whole(0) { fast } else { still };
        prop_assert_eq!(at.velocity, doubling + doubling);
    }

    #[test]
    fn visits_of_a_linear_oscillator_are_as_the_closed_forms_have_them(
        loops in 2..=4_u32, sigma in fraction(), epsilon in fraction(), velocity in fraction(),
    ) {
        let (one, k) = (whole(1), whole(loops as i32));
        prop_assume!(sigma * sigma < one && sigma != whole(0));
        let power = |j: u32| sigma.pow(j as i32);
        let turn = one - power(loops);
        let start = [epsilon * epsilon * velocity * velocity, -velocity / turn];
        let curvature = -sigma * (one - sigma) * (one + epsilon) * (one + epsilon);
        let grown = one + epsilon * power(loops);
        let by_eta = (k + k) * power(loops - 1) * velocity;
        let parameter = (one - sigma) / (turn * turn) * (grown * grown * velocity * velocity + by_eta);
        let found = visits(loops, [sigma, sigma, curvature], start, parameter);
        for (j, height) in (1..).zip(found) {
            let a = (one - power(j)) / turn;
            let c = k * power(loops - 1) * (one - power(j)) - whole(j as i32) * power(j - 1) * turn;
            let c = c / (turn * turn);
            let square = a - epsilon * (one - a);
            prop_assert_eq!(height, square * square * velocity * velocity + (c + c) * velocity);
        }
    }
}

#[test]
fn two_loops_leave_every_resonance_and_more_those_with_a_small_sigma() {
    for (sigma, epsilon) in (-99..100).flat_map(|s| (1..=20).map(move |e| (s, e))) {
        let (sigma, epsilon) = (f64::from(sigma) / 100.0 + 0.003, f64::from(epsilon) / 20.0);
        for loops in 2..=12 {
            let resonance = IteratedResonance::of_linear_oscillator(loops, sigma, epsilon);
            let emerging = resonance.emerging();
            let margin = last_visit_margin(loops, sigma, epsilon);
            let expected = loops == 2 || (sigma > 0.0 && margin > 0.0);
            assert_eq!(emerging.len(), usize::from(expected), "k = {loops}: {sigma} {epsilon}");
            let Some(found) = emerging.first() else { continue };
            assert_eq!(found.side, Side::Positive);
            let (k, power) = (f64::from(loops), libm::pow(sigma, f64::from(loops)));
            let (first, sign) = match sigma > 0.0 {
                true => (EndEvent::PeriodDoubling, 1.0),
                false => (EndEvent::SaddleNode, -1.0),
            };
            assert_eq!(found.slowest.boundary, first);
            let room = 1.0 - sign * epsilon * power;
            assert_close(found.slowest.velocity_slope, sign * k * power / sigma / (room * room), 1e-10);
            let last = found.fastest.expect("a visit touches the wall");
            assert_eq!(last.boundary, EndEvent::Visit(loops - 1));
            if loops == 2 && sigma < 0.0 {
                let width = resonance.coefficient(&last) - resonance.coefficient(&found.slowest);
                let [up, down] = [1.0 + epsilon * epsilon * sigma * power, 1.0 + epsilon * power];
                let q = 1.0 - epsilon * sigma;
                let closed = up * up / ((1.0 - sigma) * q * q * q * q * down * down);
                // A difference of parameters, which grow as 1/(1 + sigma)^2.
                assert_within(width, 4.0 * closed, 1e-10 * resonance.coefficient(&last).abs().max(1.0));
            }
        }
    }
}

#[test]
fn two_loop_regions_of_the_paper_s_oscillator_end_where_period_doubled_solutions_graze() {
    for n in 1..=6 {
        let resonance = resonance(n);
        let iterated = IteratedResonance::new(&resonance, 2);
        let last = iterated.emerging()[0].fastest.expect("the visit touches the wall");
        assert_close(iterated.coefficient(&last), resonance.doubled_grazing_coefficient(), 1e-11);
        assert_close(last.velocity_slope, 2.0 * resonance.period_doubling_velocity_slope(), 1e-12);
    }
}

fn resonance(n: u32) -> grazing_theorems::ResonantPoint {
    let oscillator = LinearOscillator::new(0.02, 0.9).unwrap();
    oscillator.resonance(1, n).unwrap().resonant_point()
}

#[test]
fn one_loop_is_the_case_of_theorem_2_4() {
    for n in 1..=6 {
        let point = resonance(n);
        let iterated = IteratedResonance::new(&point, 1);
        assert!(iterated.visits().is_empty());
        let coefficient = point.saddle_node_coefficient();
        assert_close(iterated.point().saddle_node_coefficient(), coefficient, 1e-13);
        // SN and PD curves leave to opposite sides, and solutions are stable at greater velocities.
        let emerging = iterated.emerging();
        assert_eq!(emerging.len(), 2);
        for solutions in emerging {
            assert_eq!(solutions.fastest, None);
            let slope = match solutions.slowest.boundary {
                EndEvent::SaddleNode => point.saddle_node_velocity_slope(),
                _ => point.period_doubling_velocity_slope(),
            };
            assert_close(solutions.slowest.velocity_slope, slope, 1e-13);
            assert_eq!(solutions.side, Side::of(slope));
        }
    }
}

#[test]
fn the_last_visit_is_the_next_impact() {
    // One visit more than the MPS has: x of the point beyond the wall from which the orbit comes to
    // the impact, y² / (2 gamma), for any eta.
    for n in 1..=6 {
        let point = resonance(n);
        for loops in 2..=5 {
            let iterated = IteratedResonance::new(&point, loops);
            let [map, gamma] = [point.grazing.map.a.m11, point.grazing.gamma].map(|value| value);
            let branch = iterated.point().branch_expansion();
            let a22 = point.grazing.map.a.m22;
            let power = (0..loops).fold(1.0, |power, _| power * a22);
            let alpha_omega = point.grazing.alpha() * point.grazing.forcing_frequency;
            let phase = -alpha_omega / ((1.0 - power) * gamma) * power / a22;
            let before = iterated.visits()[loops as usize - 2];
            let by_velocity = map * before.by_velocity
                + 0.5 * point.second_phase_derivative * phase * phase
                + point.grazing.map.b.x * branch.k_2;
            let by_eta =
                map * before.by_eta + point.unfolding.derivative * phase + point.grazing.map.b.x * branch.k_3;
            assert_close(by_velocity, 0.5 / gamma, 1e-10);
            // The terms are as large as a12' times the phase.
            assert_within(by_eta, 0.0, 1e-12 * (point.unfolding.derivative * phase).abs());
        }
    }
}

#[test]
fn two_loop_regions_leave_every_one_loop_resonance_of_the_paper_s_oscillator() {
    for n in 1..=6 {
        let emerging = IteratedResonance::new(&resonance(n), 2).emerging();
        let [solutions] = emerging.as_slice() else { panic!("n = {n}: {emerging:?}") };
        let fastest = solutions.fastest.expect("the visit touches the wall");
        assert_eq!(fastest.boundary, EndEvent::Visit(1));
        let [slow, fast] = [solutions.slowest, fastest].map(|bound| bound.velocity_slope);
        // Slivers for odd n, between SN and GZ; wide regions for even n, between PD and GZ.
        let (boundary, side, wide) = match n % 2 {
            1 => (EndEvent::SaddleNode, Side::Positive, 0.0..0.1),
            _ => (EndEvent::PeriodDoubling, Side::Negative, 1.0..3.0),
        };
        assert_eq!((solutions.slowest.boundary, solutions.side), (boundary, side));
        assert!(wide.contains(&(fast / slow - 1.0)), "n = {n}: {slow} to {fast}");
        // None of three loops or four is stable and admissible.
        assert!((3..=4).all(|loops| IteratedResonance::new(&resonance(n), loops).emerging().is_empty()));
    }
}
