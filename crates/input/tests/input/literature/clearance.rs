//! The oscillator of Budd, Dux and Cliffe without damping, whose single-impact orbits are known in
//! closed form.
//!
//! An orbit with one impact in n forcing periods, their (1, n) orbit, is an n-loop MPS. Orbits,
//! bifurcations and resonances are found here by continuation from the grazing orbit; the formulas
//! are used only for comparison.

use core::f64::consts::PI;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Curve, Route, SolutionCurve, Window};
use grazing_continuation::fit;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_input::Description;
use grazing_model::smooth::Integrated;
use grazing_theorems::from_map::GrazingOrbit;

use super::published::{Published, assert_within, description, text};

const EXAMPLE: &str = "clearance.toml";

/// The example with a different damping.
fn with_damping(alpha: f64) -> Description {
    let written = text(EXAMPLE);
    let line = written.lines().find(|line| line.starts_with("alpha = ")).expect("the damping has its line");
    let text = written.replace(line, &format!("alpha = {alpha:?}"));
    Description::parse(&text, EXAMPLE).unwrap_or_else(|error| panic!("{error}"))
}

fn undamped() -> Integrated<Description> {
    Integrated::new(with_damping(0.0), [0.5, 2.0])
}

/// The closed forms at one frequency.
struct LinearOscillator {
    published: Published,
    letters: Vec<(&'static str, f64)>,
}

impl LinearOscillator {
    fn at(omega: f64, n: u32) -> Self {
        let restitution = description(EXAMPLE).constants().find(|(name, _)| *name == "r").expect("r").1;
        let letters = vec![("omega", omega), ("n", f64::from(n)), ("r", restitution)];
        Self { published: Published::read(), letters }
    }

    fn value(&self, id: &str) -> f64 {
        self.published.formula(EXAMPLE, id, &self.letters)
    }

    fn value_at(&self, clearance: f64, id: &str) -> f64 {
        self.published.formula(EXAMPLE, id, &[&self.letters[..], &[("sigma", clearance)]].concat())
    }
}

/// The grazing orbit at a frequency above 1, where the motion without impacts is opposite to the
/// force.
fn grazing(omega: f64) -> GrazingOrbit<Integrated<Description>> {
    // Away from the closed form, near enough for Newton's method.
    let start = 0.9 / (omega * omega - 1.0);
    let oscillator = Integrated::new(with_damping(0.0), [start, omega]);
    GrazingOrbit::find(&oscillator, PI - 0.05).expect("a grazing orbit")
}

/// The branch of (1, n) orbits at a fixed frequency that leaves the grazing orbit.
fn branch(omega: f64, n: u32) -> Curve {
    let orbit = grazing(omega);
    let equations = LoopEquations::new(undamped(), n, Formulation::FixedPhase);
    let curve = SolutionCurve { equations, condition: Condition::Secondary(omega) };
    let route = Route {
        window: Window { primary: [0.0, 2.0], secondary: [0.0, 10.0] },
        control: StepControl::DRAWING,
        step_limit: 2_000,
        stop_at_events: false,
        pace: None,
    };
    let start = Unknowns::new(0.0, orbit.phase(), orbit.primary(), omega);
    curve
        .follow(start, Unknowns::new(1.0, 0.0, 0.0, 0.0), EventTimes::default(), &route)
        .unwrap_or_else(|stall| panic!("{stall}"))
}

/// The first bifurcation of a kind on a branch, as (impact velocity, clearance).
fn bifurcation(curve: &Curve, condition: Condition) -> [f64; 2] {
    let event = curve.events.iter().find(|event| event.condition == condition).expect("the bifurcation");
    let found = event.solution.unknowns.clone();
    [found[unknown::VELOCITY], found[unknown::PRIMARY]]
}

#[test]
fn the_orbit_without_impacts_grazes_at_the_published_amplitude() {
    for omega in [1.7, 2.0, 2.5, 3.7, 4.3] {
        // The integrator's tolerance.
        assert_within(grazing(omega).primary(), LinearOscillator::at(omega, 1).value("gamma").abs(), 1e-12);
    }
}

#[test]
fn impact_velocities_along_a_branch_lie_on_the_published_ellipse() {
    for (omega, n) in [(1.9, 1), (2.1, 1), (3.9, 2), (4.2, 2), (5.8, 3)] {
        let closed = LinearOscillator::at(omega, n);
        let curve = branch(omega, n);
        let mut compared = 0;
        for point in &curve.points {
            let [velocity, clearance] =
                [point.solution.impact_velocity(), point.solution.unknowns[unknown::PRIMARY]];
            // At the tip of the ellipse rounding of the clearance moves the velocity by its square
            // root.
            if clearance > 0.999 * closed.value("greatest_clearance") {
                continue;
            }
            let known = ["upper_velocity", "lower_velocity"].map(|id| closed.value_at(clearance, id));
            let error = known.iter().map(|known| (known - velocity).abs()).fold(f64::INFINITY, f64::min);
            // The integrator's tolerance, magnified by the steepness of the ellipse.
            assert_within(error, 0.0, 1e-11);
            compared += 1;
        }
        assert!(compared > 50, "{compared}");
    }
}

#[test]
fn saddle_node_bifurcations_lie_at_the_published_clearance() {
    for (omega, n) in [(1.9, 1), (3.7, 2), (3.9, 2), (5.8, 3)] {
        let closed = LinearOscillator::at(omega, n);
        let [velocity, clearance] = bifurcation(&branch(omega, n), Condition::SADDLE_NODE);
        let tip = closed.value("greatest_clearance");
        // The integrator's tolerance.
        assert_within(clearance, tip, 1e-12);
        // At the tip both velocities are the same; a little before it their mean is, to first
        // order.
        let near = tip * (1.0 - 1e-10);
        let mean = 0.5 * (closed.value_at(near, "upper_velocity") + closed.value_at(near, "lower_velocity"));
        assert_within(velocity, mean, 1e-8 * velocity);
    }
}

#[test]
fn period_doublings_lie_at_the_published_impact_velocity() {
    for (omega, n) in [(2.1, 1), (2.3, 1), (4.2, 2), (6.2, 3)] {
        let closed = LinearOscillator::at(omega, n);
        let [velocity, clearance] = bifurcation(&branch(omega, n), Condition::PERIOD_DOUBLING);
        // The integrator's tolerance.
        assert_within(velocity, closed.value("period_doubling_velocity"), 1e-12);
        assert_within(velocity, closed.value_at(clearance, "upper_velocity"), 1e-12);
    }
}

#[test]
fn resonances_and_their_coefficients_are_those_of_the_published_formulas() {
    for n in [1, 2, 3] {
        let resonant = LinearOscillator::at(2.0, n).value("resonance");
        let orbit = grazing(resonant - 0.03);
        let equations = LoopEquations::new(undamped(), n, Formulation::Vivid);
        let start = Unknowns::new(0.0, orbit.phase(), orbit.primary(), resonant - 0.03);
        let conditions = [Condition::SADDLE_NODE, Condition::ImpactVelocity(0.0)];
        let found = locate(&equations, conditions, start, &mut EventTimes::default())
            .unwrap_or_else(|failure| panic!("{failure}"));
        // The integrator's tolerance.
        assert_within(found[unknown::SECONDARY], resonant, 1e-12);

        // Without damping δ = 1, at the edge of the trapesium, so that the theorems do not apply;
        // their formulas do. With η = ω − 2n and μ = σ − |γ|, to leading order |γ| = g = 1/(4n²
        // − 1), ρ = (1 − r)/(2n), k = k'η, k' = π(1 + r)/(4n), and the ellipse is μ = −(V²ρ² + 4 g
        // k V)/(8g). It is greatest at V = −2gk/ρ², where μ = g(k'/ρ)² η²/2: c_SN. The period
        // doubling has V = 2πngη/(1 + r), which gives c_PD.
        let closed = LinearOscillator::at(resonant, n);
        let r = closed.letters[2].1;
        let (g, ratio) = (closed.value("gamma").abs(), (1.0 - r) / (1.0 + r));
        let saddle_node = 0.125 * PI * PI * g / (ratio * ratio);
        let period_doubling = -0.125 * PI * PI * g * (2.0 + ratio * ratio);
        let orbit =
            GrazingOrbit::find(&equations.oscillator_at(&found), found[unknown::PHASE]).expect("it is there");
        let theory = orbit.resonant_point(n).expect("the global map is smooth there");
        // The integrator's tolerance, magnified by differentiating twice and by ((1 + r)/(1 -
        // r))^2.
        assert_within(theory.saddle_node_coefficient(), saddle_node, 1e-11 * saddle_node);
        assert_within(theory.period_doubling_coefficient(), period_doubling, 1e-11);
    }
}

#[test]
fn with_damping_the_theorems_hold_and_tend_to_the_published_formulas() {
    for n in [1, 2] {
        let closed = LinearOscillator::at(2.0 * f64::from(n), n);
        let r = closed.letters[2].1;
        let (g, ratio) = (closed.value("gamma").abs(), (1.0 - r) / (1.0 + r));
        let limit = 0.125 * PI * PI * g / (ratio * ratio);
        let unfolded = |description: Description| {
            let start = Integrated::new(description, [g, closed.value("resonance")]);
            ResonantGrazingPoint::find(&start, n, PI).unwrap_or_else(|error| panic!("{error}"))
        };
        let resonance = unfolded(description(EXAMPLE));
        for (condition, curve) in [
            (Condition::SADDLE_NODE, resonance.theorem().saddle_node()),
            (Condition::PERIOD_DOUBLING, resonance.theorem().period_doubling()),
        ] {
            let fitted = fit::quadratic_coefficient(&resonance, condition).expect("the curve is there");
            // Six digits, the accuracy of the extrapolation itself.
            assert_within(fitted.value, curve.coefficient, 1e-6 * curve.coefficient.abs());
        }
        let defect = |alpha| unfolded(with_damping(alpha)).theorem().saddle_node().coefficient / limit - 1.0;
        let [coarse, fine] = [defect(2e-4), defect(1e-4)];
        // The defect is of first order in the damping: halved with it, up to the second order.
        assert_within(fine / coarse, 0.5, 0.01);
    }
}
