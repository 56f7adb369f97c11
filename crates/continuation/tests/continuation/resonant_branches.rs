//! The branches of MPSs near a resonance (section 5): eq:ZM with k₁, k₂, k₃, eq:Upsilon1, eq:Upsilonp, eq:admp7, eq:admp10.

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_model::LinearOscillator;
use grazing_theorems::auxiliary::{lucas_sequence, modulus_power};
use grazing_theorems::resonant_theorem::BifurcationCurve;
use grazing_theorems::{Resonance, ResonantGrazing};

use crate::specimens::{EPSILON, ZETA, assert_vanishes, at_grazing, oscillator_at, resonances};

/// Every resonance with p = 1, …, 4 and 0.35 < ω < 2.
///
/// Next below comes p = 1 with n = 6: s⁻ is so small there that the leading terms dominate only where they are lost in
/// rounding.
fn all() -> Vec<(Resonance, ResonantGrazing)> {
    let list = resonances(ZETA, EPSILON, &[1, 2, 3, 4], [0.35, 2.0]);
    assert!(list.len() > 10);
    let with_theorem = |resonance: Resonance| {
        // The closed forms of a₁₂ and κ_p are zero at the resonance up to rounding.
        let theorem = ResonantGrazing::check(&resonance.resonant_point(), 1e-12).unwrap();
        (resonance, theorem)
    };
    list.into_iter().map(with_theorem).collect()
}

/// Rounding of a located amplitude: the zeros of V are exact to the last places of 𝒜, which enters V directly.
const AMPLITUDE: f64 = 1e-15;

/// Rounding of located velocities, phases and positions: on the bifurcation curves they come from quotients of derivatives.
const PHASE: f64 = 3e-14;

fn vivid(resonance: &Resonance) -> LoopEquations<LinearOscillator> {
    LoopEquations::new(oscillator_at(resonance), resonance.loops(), Formulation::Vivid)
}

/// A zero of the VIVID function relative to grazing at the same η: (y, z − z_graz,η, μ).
fn relative_to_grazing(point: &Unknowns) -> [f64; 3] {
    let (grazing, _) = at_grazing(ZETA, EPSILON, point[3]);
    [point[0], point[1] - grazing.phase(), point[2] - grazing.amplitude()]
}

#[test]
fn phase_and_parameter_on_the_branch_have_the_printed_expansion() {
    for (resonance, theorem) in all() {
        let equations = vivid(&resonance);
        let branch = theorem.branch();
        // y and η of the same size in several ratios, η small enough not to reach the next resonance.
        for (y, eta) in [(1.0, 0.0), (1.0, 0.3), (1.0, -0.3), (-1.0, 0.2)] {
            let errors = |size: f64| {
                let (y, eta) = (y * size, eta * size);
                let (grazing, _) = at_grazing(ZETA, EPSILON, resonance.forcing_frequency() + eta);
                let start = Unknowns::new(
                    y,
                    grazing.phase() + branch.k_1 * y,
                    grazing.amplitude() + branch.parameter(y, eta),
                    grazing.forcing_frequency(),
                );
                let conditions = [Condition::ImpactVelocity(y), Condition::Secondary(start[3])];
                let point = locate(&equations, conditions, start, &mut EventTimes::default()).ok()?;
                let [_, phase, mu] = relative_to_grazing(&point);
                Some([phase - branch.k_1 * y, mu - branch.parameter(y, eta)])
            };
            assert!(errors(1e-3).is_some());
            assert_vanishes(2.0, PHASE, |size| Some(errors(size)?[0]));
            assert_vanishes(3.0, AMPLITUDE, |size| Some(errors(size)?[1]));
        }
    }
}

/// Both bifurcation curves of the theorem with their conditions.
fn bifurcation_curves(theorem: &ResonantGrazing) -> [(Condition, BifurcationCurve); 2] {
    [(Condition::SADDLE_NODE, theorem.saddle_node()), (Condition::PERIOD_DOUBLING, theorem.period_doubling())]
}

/// The point of a bifurcation curve at a distance η from the resonance, by Newton's method from the leading terms.
fn bifurcation_at(
    resonance: &Resonance,
    equations: &LoopEquations<LinearOscillator>,
    (condition, curve): (Condition, BifurcationCurve),
    eta: f64,
) -> Option<Unknowns> {
    let (grazing, _) = at_grazing(ZETA, EPSILON, resonance.forcing_frequency() + eta);
    let start = Unknowns::new(
        curve.impact_velocity_slope * eta,
        grazing.phase() + curve.impact_phase_slope * eta,
        grazing.amplitude() + curve.coefficient * eta * eta,
        grazing.forcing_frequency(),
    );
    let conditions = [condition, Condition::Secondary(start[3])];
    locate(equations, conditions, start, &mut EventTimes::default()).ok()
}

#[test]
fn bifurcation_curves_leave_with_the_printed_slopes_and_curvature() {
    for (resonance, theorem) in all() {
        let equations = vivid(&resonance);
        for (condition, curve) in bifurcation_curves(&theorem) {
            // Sizes are impact velocities, positive on the admissible side.
            let errors = |size: f64| {
                let eta = size / curve.impact_velocity_slope;
                let point = bifurcation_at(&resonance, &equations, (condition, curve), eta)?;
                let [y, phase, mu] = relative_to_grazing(&point);
                Some([
                    y - curve.impact_velocity_slope * eta,
                    phase - curve.impact_phase_slope * eta,
                    mu - curve.coefficient * eta * eta,
                ])
            };
            assert!(curve.impact_velocity_slope * curve.eta_side.signum() > 0.0);
            assert!(errors(1e-4).is_some());
            for (component, (stated, rounding)) in
                [(2.0, PHASE), (2.0, PHASE), (3.0, AMPLITUDE)].into_iter().enumerate()
            {
                assert_vanishes(stated, rounding, |size| Some(errors(size)?[component]));
            }
        }
    }
}

#[test]
fn other_loops_stay_below_the_wall_on_the_bifurcation_curves() {
    // eq:admp10 and eq:admp11: x⁽ʲ⁾ = −a₁₂ S_j α² ω² f_p / (γ (1 + δ^{p/2}) s_p^±) η + O(η²) < 0 for 0 < j < p.
    for (resonance, theorem) in all() {
        let equations = vivid(&resonance);
        let point = resonance.resonant_point();
        let (grazing, loops) = (point.grazing, resonance.loops());
        let (trace, determinant) = (grazing.map.trace(), grazing.map.determinant());
        for (condition, curve) in bifurcation_curves(&theorem) {
            let visits = |size: f64| {
                let eta = size / curve.impact_velocity_slope;
                let point = bifurcation_at(&resonance, &equations, (condition, curve), eta)?;
                equations.visits(&point, &EventTimes::default()).ok()
            };
            for j in 1..loops {
                let index = j as usize - 1;
                // Per impact velocity: f_p η / s_p^± = y / (α ω).
                let numerator = grazing.alpha() * grazing.forcing_frequency;
                let slope = -grazing.map.a.m12 * lucas_sequence(j, trace, determinant) * numerator
                    / (grazing.gamma * (1.0 + modulus_power(loops, determinant)));
                assert!(slope < 0.0);
                assert_vanishes(2.0, PHASE, |size| Some(visits(size)?[index][0] - slope * size));
                assert!(visits(1e-4).unwrap()[index][0] < 0.0);
            }
        }
    }
}
