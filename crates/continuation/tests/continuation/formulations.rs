//! VIVID (eq:V) and the form without virtual points are the same problem: zeros, multipliers,
//! bifurcations.

use std::sync::OnceLock;

use grazing_continuation::curve::CurveEnd;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{
    EventTimes, Formulation, LoopEquations, Multipliers, Round, Unknowns, unknown,
};
use grazing_model::LinearOscillator;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

use crate::specimens::{EPSILON, OMEGA, ZETA, assert_within, at_grazing, branch, deterministic, route};

/// A zero of the VIVID function, with its event times.
#[derive(Debug)]
struct Specimen {
    equations: LoopEquations<LinearOscillator>,
    point: Unknowns,
    times: EventTimes,
    phi: f64,
    delta: f64,
}

/// A point on a branch of p-loop MPSs that was followed from grazing with VIVID, at a fraction
/// `share` of the branch.
///
/// `None` if the branch has no point with y > 0.01: below, the multipliers are of order 1/y and so
/// are their errors.
fn specimen([zeta, epsilon, omega]: [f64; 3], loops: u32, share: f64) -> Option<Specimen> {
    let (grazing, _) = at_grazing(zeta, epsilon, omega);
    let amplitude = grazing.amplitude();
    let route = route([0.6 * amplitude, 1.4 * amplitude], [0.1, 2.0], false);
    let (equations, curve) = branch([zeta, epsilon, omega], loops, Formulation::Vivid, 1.0, &route);
    let usable =
        curve.points.iter().filter(|point| point.solution.impact_velocity() > 0.01).collect::<Vec<_>>();
    let chosen = usable.get((share * usable.len() as f64) as usize)?;
    Some(Specimen {
        equations,
        point: chosen.solution.unknowns.clone(),
        times: chosen.times.clone(),
        phi: epsilon,
        delta: grazing.determinant(),
    })
}

/// MPSs on branches with p = 1, …, 5 at random parameters; the same ones in every run.
fn specimens() -> &'static [Specimen] {
    static SPECIMENS: OnceLock<Vec<Specimen>> = OnceLock::new();
    SPECIMENS.get_or_init(|| {
        let parameters = (0.005..0.1, 0.5..1.0, 0.55..0.97, 1u32..=5, 0.0..1.0);
        let mut runner = TestRunner::new(deterministic(60));
        let draws = core::iter::repeat_with(|| parameters.new_tree(&mut runner).unwrap().current());
        let drawn = draws.filter_map(|(zeta, epsilon, omega, loops, share)| {
            specimen([zeta, epsilon, omega], loops, share)
        });
        drawn.take(60).collect()
    })
}

#[test]
fn a_zero_of_one_is_a_zero_of_the_other() {
    for Specimen { equations, point, times, .. } in specimens() {
        let vivid = equations.maps::<1>(point, &mut times.clone()).unwrap().first().difference().0;
        let other = equations.with_formulation(Formulation::FixedPhase);
        let fixed_phase = other.maps::<1>(point, &mut EventTimes::default()).unwrap().first().difference().0;
        // A few roundings of velocities and phases of order ten, amplified by p loops.
        assert_within(vivid.norm(), 0.0, 1e-12);
        assert_within(fixed_phase.norm(), 0.0, 1e-12);
    }
}

#[test]
fn newton_without_virtual_points_leads_to_the_zero_of_vivid() {
    let mut compared = 0;
    for Specimen { equations, point, .. } in specimens() {
        let other = equations.with_formulation(Formulation::FixedPhase);
        let jacobian = other.maps::<1>(point, &mut EventTimes::default()).unwrap().first().difference().1;
        // Near a fold the start may be nearer to the other zero.
        if jacobian.fixed_columns::<2>(0).into_owned().determinant().abs() < 1e-2 {
            continue;
        }
        let [primary, secondary] = [point[unknown::PRIMARY], point[unknown::SECONDARY]];
        let conditions = [Condition::Primary(primary), Condition::Secondary(secondary)];
        let start = point + Unknowns::new(1e-5, -1e-5, 0.0, 0.0);
        let found = locate(&other, conditions, start, &mut EventTimes::default()).unwrap();
        // A zero is known to about 10⁻¹⁴ times the condition of DV, at most 10³ with this
        // determinant.
        assert_within((found - point).norm(), 0.0, 1e-11);
        compared += 1;
    }
    // Most MPSs are not near a fold.
    assert!(compared >= 40, "{compared}");
}

#[test]
fn both_give_the_same_multipliers() {
    for Specimen { equations, point, times, .. } in specimens() {
        let vivid = equations.maps::<1>(point, &mut times.clone()).unwrap().multipliers();
        let other = equations.with_formulation(Formulation::FixedPhase);
        let fixed_phase = other.maps::<1>(point, &mut EventTimes::default()).unwrap().multipliers();
        let solution = equations.solution(point).multipliers;
        for multipliers in [vivid, solution] {
            assert_within(multipliers.trace, fixed_phase.trace, noise(&fixed_phase));
            assert_within(multipliers.determinant, fixed_phase.determinant, noise(&fixed_phase));
        }
    }
}

/// Tolerance for T and D, which are of order 1/y ≤ 100, divided by det D P_virt of order y: 10⁻¹⁵ ·
/// 10⁴, relative to T.
fn noise(multipliers: &Multipliers) -> f64 {
    1e-11 * (1.0 + multipliers.trace.abs())
}

#[test]
fn determinant_of_the_multipliers_is_that_of_p_loops_and_one_impact() {
    // Liouville: every loop contracts areas by δ and the impact by φ².
    for specimen in specimens() {
        let Specimen { equations, point, times, .. } = specimen;
        let multipliers = equations.maps::<1>(point, &mut times.clone()).unwrap().multipliers();
        let expected = specimen.phi * specimen.phi * libm::pow(specimen.delta, f64::from(equations.loops()));
        assert_within(multipliers.determinant, expected, noise(&multipliers));
    }
}

#[test]
fn characteristic_is_the_characteristic_polynomial_times_a_factor_without_zeros() {
    // VIVID's function over det D P_virt is 1 ∓ T + D, with T and D taken from the other form.
    for Specimen { equations, point, times, .. } in specimens() {
        let pair = equations.maps::<1>(point, &mut times.clone()).unwrap();
        let factor = pair.first().impact.derivative().determinant();
        let other = equations.solution(point).multipliers;
        for sign in [1.0, -1.0] {
            let expected = 1.0 - sign * other.trace + other.determinant;
            assert_within(pair.characteristic(sign).0 / factor, expected, noise(&other));
        }
        assert_within(pair.product_less(1.0).0 / factor, other.determinant - 1.0, noise(&other));
    }
}

/// A function that vanishes at a bifurcation, with its gradient.
type Vanishing = fn(&Round) -> (f64, Unknowns);

#[test]
fn gradients_of_what_vanishes_at_bifurcations_agree_with_differences() {
    const H: f64 = 1e-5;
    for Specimen { equations, point, times, .. } in specimens() {
        for formulation in [Formulation::Vivid, Formulation::FixedPhase] {
            let equations = equations.with_formulation(formulation);
            // The event times hold the plane of constant phase while the phase is varied.
            let mut times = times.clone();
            let pair = equations.maps::<2>(point, &mut times).unwrap();
            let functions: [Vanishing; 4] = [
                |pair| pair.characteristic(1.0),
                |pair| pair.characteristic(-1.0),
                |pair| pair.product_less(1.0),
                |pair| pair.product_less(0.3),
            ];
            for function in functions {
                let (_, gradient) = function(&pair);
                let mut value = |k: usize, h: f64| {
                    let mut moved = point.clone();
                    moved[k] += h;
                    function(&equations.maps::<1>(&moved, &mut times).unwrap()).0
                };
                for k in 0..4 {
                    let central = |value: &mut dyn FnMut(usize, f64) -> f64, h: f64| {
                        (value(k, h) - value(k, -h)) / (2.0 * h)
                    };
                    let difference = (4.0 * central(&mut value, H) - central(&mut value, 2.0 * H)) / 3.0;
                    // Rounding, 10⁻¹⁴/h; the error of fourth order in h is less.
                    assert_within(difference, gradient[k], 1e-8 * (1.0 + gradient.norm()));
                }
            }
        }
    }
}

#[test]
fn folds_and_period_doublings_are_the_same_points() {
    let mut compared = 0;
    for loops in 1..=5 {
        for omega in [0.7, OMEGA, 0.92] {
            let route = route([0.05, 0.7], [0.1, 2.0], false);
            let (equations, curve) = branch([ZETA, EPSILON, omega], loops, Formulation::Vivid, 1.0, &route);
            assert!(matches!(curve.end, CurveEnd::LeftWindow), "{:?}", curve.end);
            for event in &curve.events {
                if event.condition == Condition::InteriorGrazing {
                    continue;
                }
                let other = equations.with_formulation(Formulation::FixedPhase);
                let start = &event.solution.unknowns + Unknowns::new(1e-5, -1e-5, 1e-6, 0.0);
                let conditions = [event.condition, Condition::Secondary(omega)];
                let found = locate(&other, conditions, start, &mut EventTimes::default()).unwrap();
                // Two regular systems with condition numbers of about a thousand at most, solved to
                // rounding.
                assert_within((found - &event.solution.unknowns).norm(), 0.0, 1e-11);
                compared += 1;
            }
        }
    }
    // Fifteen branches, of which most have a fold or a period doubling in the window.
    assert!(compared >= 10, "only {compared} events");
}
