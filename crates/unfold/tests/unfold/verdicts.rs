//! Verdicts on theorem, curve and simulation where one of them is difficult.

use grazing_continuation::bifurcation::Pair;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_unfold::progress::Silent;
use grazing_unfold::simulation::{ReturnOutcome, Suspect};
use grazing_unfold::verdict::{Coefficient, Obstacle, Verdict, coefficients};
use grazing_unfold::verification::{Inconclusive, Sides, Simulated, simulate};
use grazing_unfold::{Diagram, Scope};

use crate::specimens::{EPSILON, ZETA, assert_within, described, scope, written};

/// The resonance of the linear oscillator with the given numbers, located from its closed form.
fn linear(zeta: f64, loops: u32, n: u32) -> ResonantGrazingPoint {
    let known = grazing_theorems::LinearOscillator::new(zeta, EPSILON).unwrap().resonance(loops, n).unwrap();
    let (amplitude, omega) = (known.grazing().amplitude(), known.forcing_frequency());
    let oscillator = crate::specimens::linear(zeta, EPSILON, [amplitude, omega]);
    ResonantGrazingPoint::find(&oscillator, loops, known.grazing().phase()).unwrap()
}

fn simulated(point: &ResonantGrazingPoint, both: &Pair<Coefficient>) -> [Simulated; 2] {
    Pair::BIFURCATIONS.map(|kind| simulate(point, kind, both)).into_array()
}

#[test]
fn coefficients_with_the_parameters_swapped_are_those_of_the_other_way_round() {
    // s₁⁻ is small where n is even, and the curve leaves the quadratic law at once: c_PD is near
    // 10⁶.
    let swapped: Scope = scope([0.45, 0.55], [0.7, 0.8], &[1]);
    let force = format!("-2*{ZETA}*v - x - 1 + eta*cos(mu*t)");
    let diagram = Diagram::located(&written(&force, "mu", &swapped), &swapped, &Silent).unwrap();
    let found: Vec<_> = diagram.unfolding().collect();
    assert_eq!(found.len(), 1);
    let (resonance, point) = found[0];
    let straight = linear(ZETA, 1, resonance.n);
    // With A = a(ω) + c η² the same curve is ω = a⁻¹(A) − c/a'³ η² to leading order.
    let slope = straight.orbit().primary_slope();
    let theorem = straight.theorem();
    let wanted = [theorem.saddle_node(), theorem.period_doubling()]
        .map(|curve| -curve.coefficient / (slope * slope * slope));
    for (coefficient, wanted) in coefficients(point).into_array().into_iter().zip(wanted) {
        assert_eq!(coefficient.verdict(), Verdict::Agree, "{coefficient:?}");
        assert_within(coefficient.theorem.value, wanted, coefficient.theorem.error + 1e-9 * wanted.abs());
        let fit = coefficient.fit.unwrap().coefficient;
        assert_within(fit.value, wanted, fit.error + coefficient.theorem.error);
        assert!(fit.error < 1e-6 * wanted.abs(), "{fit:?}");
    }
}

#[test]
fn errors_of_coefficients_cover_those_of_integrating_a_force_of_short_pulses() {
    let window @ [primary, secondary] = [[0.0, 3.0], [0.3, 1.4]];
    let force = "-0.06*v - x - 1 + mu*exp(6*(cos(eta*t) - 1))";
    let pulses = described([force, "eta", "0"], 0.8, window).oscillator([0.3, 1.0]);
    let diagram = Diagram::located(&pulses, &scope(primary, secondary, &[1]), &Silent).unwrap();
    let both: Vec<_> = diagram.unfolding().flat_map(|(_, point)| coefficients(point).into_array()).collect();
    assert!(both.len() >= 10);
    for coefficient in both {
        let measured = coefficient.measured();
        let deviation = (measured.value - coefficient.theorem.value).abs();
        assert!(
            deviation < measured.error && measured.error < 1e-7 * measured.value.abs(),
            "{coefficient:?}"
        );
    }
}

#[test]
fn coefficients_lost_in_rounding_are_not_measurable_and_others_of_the_same_oscillator_agree() {
    // With δ = exp(−4πζ/ω) the coefficients fall as δ^(p − 1), and the velocities at which leading
    // terms decide with them.
    let point = linear(0.5, 1, 2);
    let both = coefficients(&point);
    assert!(both.into_array().iter().all(|coefficient| coefficient.verdict() == Verdict::Agree), "{both:?}");
    let sides = simulated(&point, &both);
    assert!(sides.iter().all(|sides| matches!(sides, Simulated::AsPredicted(_))), "{sides:?}");

    let point = linear(0.5, 3, 2);
    let both = coefficients(&point);
    for coefficient in both.into_array() {
        let verdict = coefficient.verdict();
        assert!(matches!(verdict, Verdict::NotMeasurable(Obstacle::Rounding { .. })), "{coefficient:?}");
        assert!(!verdict.reason().is_empty());
    }
    for sides in simulated(&point, &both) {
        assert!(matches!(sides, Simulated::Undecided(Inconclusive::TooSlow { .. })), "{sides:?}");
        assert!(!sides.reason().is_empty());
    }
}

#[test]
fn a_difference_beyond_the_errors_contradicts_and_a_value_without_digits_is_not_measurable() {
    let Pair { mut saddle_node, mut period_doubling } = coefficients(&linear(ZETA, 1, 3));
    assert_eq!(saddle_node.verdict(), Verdict::Agree);
    saddle_node.theorem.value *= 1.0 + 1e-6;
    assert_eq!(saddle_node.verdict(), Verdict::Contradict);
    // This is the error where s_p^- is zero to rounding.
    for error in [0.1 * period_doubling.theorem.value, f64::INFINITY, f64::NAN] {
        period_doubling.theorem.error = error;
        let verdict = period_doubling.verdict();
        assert!(matches!(verdict, Verdict::NotMeasurable(Obstacle::NearlyDegenerate { .. })), "{verdict:?}");
    }
}

#[test]
fn motion_goes_elsewhere_beyond_a_saddle_node_and_beside_an_unstable_solution_alone() {
    let point = linear(ZETA, 1, 3);
    let Simulated::AsPredicted(sides) = simulated(&point, &coefficients(&point))[0] else {
        panic!("it is as predicted here")
    };
    assert_eq!(sides.gone_beyond, Some(true));
    let (equations, saddle_node) = (point.equations(), Pair::CONDITIONS.saddle_node);
    let find = |conditions, near| {
        locate(equations, conditions, near, &mut EventTimes::default()).expect("there is a solution")
    };
    let direction = point.direction(saddle_node);
    let near = point.unknowns() + &direction * (sides.velocity / direction[unknown::VELOCITY]);
    let fold = find([saddle_node, Condition::ImpactVelocity(sides.velocity)], near);
    assert_ne!(sides.predicted[0], sides.predicted[1]);
    for (share, stable) in [0.7, 1.3].into_iter().zip(sides.predicted) {
        let mut near = fold.clone();
        near[unknown::VELOCITY] *= share;
        let velocity = Condition::ImpactVelocity(near[unknown::VELOCITY]);
        let solution = find([Condition::Secondary(fold[unknown::SECONDARY]), velocity], near);
        let oscillator = equations.oscillator_at(&solution);
        assert_eq!(Suspect::of(&oscillator, 1, &solution).leaves(), Some(!stable), "{share}, {sides:?}");
    }
}

#[test]
fn motion_is_as_predicted_only_if_all_of_it_is() {
    let good = Sides {
        velocity: 0.01,
        predicted: [false, true],
        seen: [ReturnOutcome::Returns; 2],
        attracts: [Some(false), Some(true)],
        gone_beyond: Some(true),
    };
    assert_eq!(good.as_predicted(), Some(true));
    for undecided in [Sides { attracts: [Some(false), None], ..good }, Sides { gone_beyond: None, ..good }] {
        assert_eq!(undecided.as_predicted(), None);
    }
    for (bad, told) in [
        (
            Sides { attracts: [Some(true); 2], ..good },
            "the slower solution is predicted to be unstable but attracts",
        ),
        (
            Sides { attracts: [Some(false); 2], ..good },
            "the faster solution is predicted to be stable but repels",
        ),
        (
            Sides { seen: [ReturnOutcome::MeetsTheWall, ReturnOutcome::Returns], ..good },
            "the slower solution hits the wall too early",
        ),
        (Sides { gone_beyond: Some(false), ..good }, "motion stays although no solution remains"),
    ] {
        assert_eq!(bad.as_predicted(), Some(false));
        assert_eq!(bad.to_string(), format!("at impact velocity 1e-2 {told}"));
    }
}
