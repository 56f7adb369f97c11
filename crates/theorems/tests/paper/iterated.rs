//! Solutions of more loops at a one-loop resonance. Not in the paper.

use grazing_theorems::iterated::{Boundary, IteratedResonance};
use grazing_theorems::{LinearOscillator, Side};

use crate::{assert_close, assert_within};

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
                Boundary::SaddleNode => point.saddle_node_velocity_slope(),
                _ => point.period_doubling_velocity_slope(),
            };
            assert_close(solutions.slowest.velocity_slope, slope, 1e-13);
            assert_eq!(solutions.side, Side::of(slope));
        }
    }
}

#[test]
fn the_last_visit_is_the_next_impact() {
    // One visit more than there is: x of the point beyond the wall from which the orbit comes to the
    // impact, y² / (2 gamma), whatever eta is.
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
        assert_eq!(fastest.boundary, Boundary::Visit(1));
        let [slow, fast] = [solutions.slowest, fastest].map(|bound| bound.velocity_slope);
        // Slivers for odd n, between SN and GZ; wide regions for even n, between PD and GZ.
        let (boundary, side, wide) = match n % 2 {
            1 => (Boundary::SaddleNode, Side::Positive, 0.0..0.1),
            _ => (Boundary::PeriodDoubling, Side::Negative, 1.0..3.0),
        };
        assert_eq!((solutions.slowest.boundary, solutions.side), (boundary, side));
        assert!(wide.contains(&(fast / slow - 1.0)), "n = {n}: {slow} to {fast}");
        // None of three loops or four is stable and admissible.
        assert!((3..=4).all(|loops| IteratedResonance::new(&resonance(n), loops).emerging().is_empty()));
    }
}
