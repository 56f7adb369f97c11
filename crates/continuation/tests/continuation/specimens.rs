//! Oscillators, resonances and MPSs to test with, and ways to compare numbers.

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Curve, Route, SolutionCurve, Window};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator};
use grazing_model::{ImpactOscillator, LinearOscillator};
use grazing_theorems::{GrazingState, Resonance};
use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// The parameters of the paper's figures.
pub(crate) const ZETA: f64 = 0.02;
pub(crate) const EPSILON: f64 = 0.9;
pub(crate) const OMEGA: f64 = 0.855;

/// The paper's oscillator, defined by its force, with an additional spring of cubic stiffness κ.
#[derive(Clone, Debug)]
pub(crate) struct Spring {
    pub(crate) kappa: f64,
    /// Whether Φ falls with the impact velocity and varies with the phase, and an impact takes
    /// time.
    pub(crate) varying: bool,
    /// The unit of positions.
    pub(crate) length: f64,
}

impl Spring {
    /// The paper's oscillator.
    pub(crate) const LINEAR: Self = Self { kappa: 0.0, varying: false, length: 1.0 };
    /// An oscillator that is nonlinear in every respect.
    pub(crate) const DUFFING: Self = Self { kappa: 0.1, varying: true, length: 1.0 };
}

/// Resonances of [`Spring::DUFFING`], as p and a start for Newton's method (empirical, by homotopy
/// from the linear oscillator's with n = 3 and n = 1).
pub(crate) const DUFFING: [(u32, [f64; 3]); 2] =
    [(1, [0.0668, 0.6734, 0.7597]), (2, [0.0868, 0.3983, 0.9134])];

pub(crate) fn duffing(
    loops: u32,
    [phase, amplitude, omega]: [f64; 3],
) -> ResonantGrazingPoint<Integrated<Spring>> {
    let oscillator = Integrated::new(Spring::DUFFING, [amplitude, omega]);
    ResonantGrazingPoint::find(&oscillator, loops, phase).unwrap()
}

impl SmoothOscillator for Spring {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
        let (x, y) = (x.scale(self.length), y.scale(self.length));
        let spring = x + x.power(3).scale(self.kappa) + S::constant(1.0);
        let force = amplitude * (omega * t).apply(Function::Cos) - y.scale(2.0 * ZETA) - spring;
        force.scale(1.0 / self.length)
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, y: S, z: S, _: S, _: S) -> S {
        let varied = y.scale(0.1 * self.length) + z.apply(Function::Sin).scale(0.02);
        S::constant(EPSILON) - varied.scale(f64::from(u8::from(self.varying)))
    }

    fn impact_duration<S: Scalar>(&self, y: S, _: S, _: S, _: S) -> S {
        let duration = S::constant(0.05) + y.scale(0.01 * self.length);
        duration.scale(f64::from(u8::from(self.varying)) * self.length)
    }
}

/// A deterministic configuration of a property test.
pub(crate) fn deterministic(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0x6772_617a_696e_6721),
        ..ProptestConfig::default()
    }
}

/// The closed form of the grazing bifurcation, and the oscillator there.
pub(crate) fn at_grazing(zeta: f64, epsilon: f64, omega: f64) -> (GrazingState, LinearOscillator) {
    let theory = grazing_theorems::LinearOscillator::new(zeta, epsilon).unwrap();
    let grazing = theory.grazing(omega).unwrap();
    (grazing, grazing.model())
}

/// The closed forms of all resonances with the given numbers of loops and forcing frequencies in
/// the given range.
pub(crate) fn resonances(
    zeta: f64,
    epsilon: f64,
    loops: &[u32],
    [lowest, highest]: [f64; 2],
) -> Vec<Resonance> {
    let theory = grazing_theorems::LinearOscillator::new(zeta, epsilon).unwrap();
    theory.resonances(loops, lowest, highest).unwrap()
}

/// The oscillator at a resonance, in closed form.
pub(crate) fn oscillator_at(resonance: &Resonance) -> LinearOscillator {
    resonance.grazing().model()
}

/// The resonance located numerically, from a slightly displaced start.
pub(crate) fn located(resonance: &Resonance) -> ResonantGrazingPoint<LinearOscillator> {
    let oscillator = oscillator_at(resonance);
    let [amplitude, omega] = oscillator.parameters();
    let off = oscillator.with_parameters([amplitude + 1e-4, omega - 1e-4]);
    ResonantGrazingPoint::find(&off, resonance.loops(), resonance.grazing().phase() + 1e-4).unwrap()
}

/// A route through a window of amplitudes and frequencies, with steps as for drawing.
pub(crate) fn route(amplitudes: [f64; 2], frequencies: [f64; 2], stop_at_events: bool) -> Route<'static> {
    Route {
        window: Window { primary: amplitudes, secondary: frequencies },
        control: StepControl::DRAWING,
        step_limit: 5_000,
        stop_at_events,
        pace: None,
    }
}

/// The branch of p-loop MPSs at fixed frequency that leaves the grazing bifurcation, towards y > 0
/// (`side` 1) or y < 0 (−1).
pub(crate) fn branch(
    [zeta, epsilon, omega]: [f64; 3],
    loops: u32,
    formulation: Formulation,
    side: f64,
    route: &Route<'_>,
) -> (LoopEquations<LinearOscillator>, Curve) {
    let (grazing, oscillator) = at_grazing(zeta, epsilon, omega);
    let equations = LoopEquations::new(oscillator, loops, formulation);
    let curve = SolutionCurve { equations: equations.clone(), condition: Condition::Secondary(omega) };
    let start = Unknowns::new(0.0, grazing.phase(), grazing.amplitude(), omega);
    let direction = Unknowns::new(side, 0.0, 0.0, 0.0);
    let curve = curve.follow(start, direction, EventTimes::default(), route).unwrap();
    (equations, curve)
}

/// The observed order of convergence of an error as its scale is halved: log₂ of the ratio.
pub(crate) fn order([coarse, fine]: [f64; 2]) -> f64 {
    libm::log2(coarse.abs() / fine.abs())
}

/// Fails unless an error vanishes with at least the stated order in a size.
///
/// The sizes fall by halves from 2⁻⁷ to 2⁻²⁰. The order is measured at the two smallest at which
/// the error, where there is one, still exceeds its `rounding` a hundredfold, with slack for the
/// next order there (large for p = 1 and even n, where s⁻ is small); an error that never does
/// counts as none.
#[track_caller]
pub(crate) fn assert_vanishes(stated: f64, rounding: f64, error: impl Fn(f64) -> Option<f64>) {
    let mut size = libm::exp2(-7.0);
    let mut resolved = Vec::new();
    for _ in 0..14 {
        resolved.extend(error(size).filter(|error| error.abs() > 100.0 * rounding));
        size *= 0.5;
    }
    if let [.., coarse, fine] = resolved[..] {
        let observed = order([coarse, fine]);
        assert!(observed > stated - 0.3, "order {observed} instead of {stated}: {resolved:?}");
    }
}

/// Fails unless the numbers differ by at most `tolerance` in proportion to the expected one.
#[track_caller]
pub(crate) fn assert_close(computed: f64, expected: f64, tolerance: f64) {
    assert_within(computed, expected, tolerance * expected.abs());
}

/// Fails unless the numbers differ by at most `bound`.
#[track_caller]
pub(crate) fn assert_within(computed: f64, expected: f64, bound: f64) {
    let difference = (computed - expected).abs();
    assert!(
        difference <= bound,
        "{computed:e} instead of {expected:e}: off by {difference:e}, more than {bound:e}"
    );
}
