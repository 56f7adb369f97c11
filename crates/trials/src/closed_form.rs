//! All p-loop MPSs of the linear oscillator at given parameters, from a quadratic equation
//! ([`LoopSolutions`]). The only part of the program that is used is the search for maxima.

use core::f64::consts::TAU;

use grazing_claims::sweep::closed_form::{LoopSolution, LoopSolutions};
use grazing_model::motion::Motion;
use grazing_model::{ImpactOscillator, LinearOscillator, State};

/// One of the at most two p-loop MPSs.
#[derive(Clone, Copy, Debug)]
pub struct ClosedFormOrbit {
    /// Impact velocity y.
    pub velocity: f64,
    /// Impact phase z.
    pub phase: f64,
    /// Trace T of the derivative of the impact map.
    pub trace: f64,
    /// Determinant D of the derivative of the impact map.
    pub determinant: f64,
    /// The highest interior maximum of x; minus infinity without one.
    pub ceiling: f64,
}

impl ClosedFormOrbit {
    /// Whether both multipliers lie inside the unit circle; D is less than one for every oscillator of
    /// this kind.
    pub fn stable(&self) -> bool {
        self.trace.abs() - 1.0 < self.determinant
    }

    /// Whether the orbit has an impact with y > 0, and no interior maximum above the wall.
    pub fn admissible(&self) -> bool {
        self.velocity > 0.0 && self.ceiling <= 0.0
    }
}

/// Accuracy in amplitude with which folds are located; solutions still exist at a located fold.
const AT_FOLD: f64 = 1e-12;

/// The MPSs with p = `loops` at this amplitude and frequency, including virtual ones (y < 0).
pub fn orbits(zeta: f64, epsilon: f64, amplitude: f64, omega: f64, loops: u32) -> Vec<ClosedFormOrbit> {
    let solutions = LoopSolutions::new(zeta, epsilon, omega, loops);
    let mu = amplitude - solutions.grazing_amplitude();
    let mut found = solutions.at(mu);
    let fold = solutions.saddle_node();
    if found.is_empty() && fold.mu - mu < AT_FOLD {
        found.push(fold);
    }
    found.iter().map(|solution| orbit(zeta, epsilon, solution, omega, loops)).collect()
}

/// A solution with its highest interior maximum.
pub(crate) fn orbit(
    zeta: f64,
    epsilon: f64,
    solution: &LoopSolution,
    omega: f64,
    loops: u32,
) -> ClosedFormOrbit {
    let LoopSolution { velocity, phase, amplitude, trace, determinant, .. } = *solution;
    let oscillator = LinearOscillator::new(zeta, epsilon, amplitude, omega).expect("valid parameters");
    let motion = oscillator.motion(State::on_wall(-epsilon * velocity, phase));
    let highest = motion.highest_maximum(TAU * f64::from(loops) / omega);
    let ceiling = highest.map_or(f64::NEG_INFINITY, |maximum| maximum.position);
    ClosedFormOrbit { velocity, phase, trace, determinant, ceiling }
}
