//! Theorems 2.4 and 2.5: each hypothesis violated alone, and agreement with theorems 2.2 and 2.3
//! next to the resonance.

use nalgebra::{Matrix2, Vector2};

use grazing_theorems::generic_theorem::Side;
use grazing_theorems::hypothesis::{Quantity, Theorem};
use grazing_theorems::{
    GenericGrazing, GrazingPoint, LinearOscillator, LinearisedMap, ResonantGrazing, ResonantPoint, Unfolding,
};

const TOLERANCE: f64 = 1e-12;

fn point(a: Matrix2<f64>, unfolding: Unfolding) -> ResonantPoint {
    let map = LinearisedMap { a, b: Vector2::new(0.7, 0.1) };
    let grazing = GrazingPoint { map, forcing_frequency: 1.2, gamma: 0.8, phi: 0.75, psi: 0.0 };
    ResonantPoint { grazing, second_phase_derivative: 0.3, unfolding }
}

/// A point with a12 = 0, delta = 0.06, tau = 1/2.
fn one_loop() -> ResonantPoint {
    point(Matrix2::new(0.3, 0.0, -0.5, 0.2), Unfolding { loops: 1, derivative: 0.5 })
}

/// A point with tau = 0 = g_2, delta = 0.16.
fn two_loops() -> ResonantPoint {
    let unfolding = Unfolding { loops: 2, derivative: 0.5 };
    point(Matrix2::new(-0.2, 0.4, -0.5, 0.2), unfolding)
}

fn violations(point: &ResonantPoint) -> Vec<Quantity> {
    let violated = ResonantGrazing::check(point, TOLERANCE).expect_err("a hypothesis is violated");
    violated.violated().map(|hypothesis| hypothesis.quantity).collect()
}

fn with_grazing(base: ResonantPoint, change: impl Fn(&mut GrazingPoint)) -> ResonantPoint {
    let mut grazing = base.grazing;
    change(&mut grazing);
    ResonantPoint { grazing, ..base }
}

#[test]
fn hypotheses_are_kept_with_the_conclusion() {
    for (base, theorem) in [(one_loop(), Theorem::ResonantOneLoop), (two_loops(), Theorem::ResonantMultiLoop)]
    {
        let unfolded = ResonantGrazing::check(&base, TOLERANCE).expect("the hypotheses hold");
        assert_eq!(unfolded.theorem(), theorem);
        assert!(unfolded.hypotheses().iter().all(|hypothesis| hypothesis.holds()));
        assert_eq!(unfolded.branch(), base.branch_expansion());
        assert_eq!(unfolded.saddle_node().coefficient, base.saddle_node_coefficient());
        assert_eq!(unfolded.period_doubling().coefficient, base.period_doubling_coefficient());
        for curve in [unfolded.saddle_node(), unfolded.period_doubling()] {
            assert_eq!(curve.impact_velocity_slope > 0.0, curve.eta_side == Side::Positive);
        }
    }
}

#[test]
fn each_violated_hypothesis_is_named_alone() {
    for base in [one_loop(), two_loops()] {
        assert_eq!(
            violations(&with_grazing(base, |grazing| grazing.forcing_frequency = -1.0)),
            [Quantity::ForcingFrequency]
        );
        assert_eq!(violations(&with_grazing(base, |grazing| grazing.gamma = -0.8)), [Quantity::Deceleration]);
        assert_eq!(violations(&with_grazing(base, |grazing| grazing.phi = -0.5)), [Quantity::Restitution]);
        let square_root = if base.loops() == 1 {
            Quantity::SquareRootFactor
        } else {
            Quantity::OffDiagonalTimesSquareRootFactor
        };
        assert_eq!(violations(&with_grazing(base, |grazing| grazing.psi = 4.0)), [square_root]);
        let still = violations(&with_grazing(base, |grazing| grazing.map.b = Vector2::zeros()));
        assert_eq!(still, [Quantity::Transversality]);
    }
    let one = |a11, a12, a21, a22| {
        with_grazing(one_loop(), |grazing| grazing.map.a = Matrix2::new(a11, a12, a21, a22))
    };
    assert_eq!(violations(&one(-0.3, 0.0, -0.5, 0.2)), [Quantity::Determinant]);
    assert_eq!(violations(&one(2.0, 0.0, -0.5, 0.6)), [Quantity::Contraction, Quantity::StabilityMargin]);
    assert_eq!(violations(&one(-1.25, 0.0, -0.5, -0.5)), [Quantity::StabilityMargin]);
    assert_eq!(violations(&one(0.3, 1e-9, -0.5, 0.2)), [Quantity::OffDiagonal]);
    let two = |a11, a12, a21, a22| {
        with_grazing(two_loops(), |grazing| grazing.map.a = Matrix2::new(a11, a12, a21, a22))
    };
    assert_eq!(violations(&two(-0.2, 0.4, -2.9, 0.2)), [Quantity::Contraction]);
    assert_eq!(violations(&two(-0.2, -0.4, 0.5, 0.2)), [Quantity::OffDiagonalTimesSquareRootFactor]);
    assert_eq!(violations(&two(-0.2 + 1e-9, 0.4, -0.5, 0.2)), [Quantity::Detuning]);
    let frozen = ResonantPoint { unfolding: Unfolding { loops: 1, derivative: 0.0 }, ..one_loop() };
    assert_eq!(violations(&frozen), [Quantity::OffDiagonalDerivative]);
    let unfolding = Unfolding { loops: 2, derivative: 0.0 };
    assert_eq!(violations(&ResonantPoint { unfolding, ..two_loops() }), [Quantity::DetuningDerivative]);
}

#[test]
fn vanishing_stability_coefficients_are_named() {
    // a11 = a22 = 0 violates delta > 0 too, and makes s_1^+- = -+1 + (alpha omega)^2 xi / gamma
    // vanish exactly for dyadic numbers.
    let base = with_grazing(one_loop(), |grazing| {
        grazing.map.a = Matrix2::new(0.0, 0.0, -0.5, 0.0);
        grazing.phi = 1.0;
        grazing.forcing_frequency = 1.0;
        grazing.gamma = 1.0;
    });
    let plus = ResonantPoint { second_phase_derivative: 0.25, ..base };
    assert_eq!(violations(&plus), [Quantity::Determinant, Quantity::SaddleNodeStability]);
    let minus = ResonantPoint { second_phase_derivative: -0.25, ..base };
    assert_eq!(violations(&minus), [Quantity::Determinant, Quantity::PeriodDoublingStability]);
}

#[test]
fn no_loop_is_no_resonance() {
    let unfolding = Unfolding { loops: 0, derivative: 0.5 };
    assert!(violations(&ResonantPoint { unfolding, ..two_loops() }).contains(&Quantity::Loops));
}

#[test]
fn tolerance_decides_what_counts_as_a_resonance() {
    let near = with_grazing(one_loop(), |grazing| grazing.map.a.m12 = 1e-6);
    assert!(ResonantGrazing::check(&near, 1e-5).is_ok());
    let violated = ResonantGrazing::check(&near, 1e-7).expect_err("1e-6 is not zero within 1e-7");
    assert_eq!(
        violated.to_string(),
        "theorem 2.4 (resonant grazing, p = 1) does not apply: it needs a12 = 0 (within 1e-7), \
         where a12 is 0.000001"
    );
    for tolerance in [-1.0, f64::NAN] {
        assert!(ResonantGrazing::check(&one_loop(), tolerance).is_err());
    }
    assert!(ResonantGrazing::check(&one_loop(), 0.0).is_ok());
}

#[test]
fn saddle_node_lies_on_the_side_where_the_generic_theorem_lets_the_unstable_solution_emerge() {
    // Close to the resonance, on the side of eta where the fold exists, the unstable solution that
    // emerges at mu = 0 turns around in the fold: c_SN has the sign of its mu. On the other side of
    // eta it emerges the other way.
    let oscillator = LinearOscillator::new(0.07, 0.7).expect("valid");
    for (p, n) in [(1, 1), (1, 2), (1, 5), (2, 1), (3, 1), (4, 2)] {
        let resonance = oscillator.resonance(p, n).expect("valid");
        let theorem =
            ResonantGrazing::check(&resonance.resonant_point(), TOLERANCE).expect("the hypotheses hold");
        let side = |eta: f64| {
            let grazing =
                oscillator.grazing(resonance.forcing_frequency() + eta).expect("a positive frequency");
            GenericGrazing::check(&grazing.grazing_point(), p).expect("the hypotheses hold").side().signum()
        };
        let eta = 1e-3 * theorem.saddle_node().eta_side.signum();
        let fold = theorem.saddle_node().coefficient.signum();
        assert_eq!((side(eta), side(-eta)), (fold, -fold), "p = {p}, n = {n}");
    }
}
