//! Oscillators, resonances and bifurcations whose normal forms are tested, and ways to measure.

use grazing_continuation::curve::Curve;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{Formulation, Memory, Unknowns, unknown};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator};
use grazing_model::{ImpactOscillator, LinearOscillator};

use crate::specimens::{EPSILON, ZETA, located, resonances, route};

/// A cubic spring with restitution and impact duration that vary, with positions in units of `length`.
#[derive(Clone, Debug)]
pub(super) struct Duffing {
    pub(super) length: f64,
}

impl SmoothOscillator for Duffing {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
        let (x, y) = (x.scale(self.length), y.scale(self.length));
        let force = amplitude * (omega * t).apply(Function::Cos)
            - y.scale(2.0 * ZETA)
            - x
            - x.power(3).scale(0.1)
            - S::constant(1.0);
        force.scale(1.0 / self.length)
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, y: S, z: S, _: S, _: S) -> S {
        S::constant(EPSILON) - y.scale(0.1 * self.length) - z.apply(Function::Sin).scale(0.02)
    }

    fn impact_duration<S: Scalar>(&self, y: S, _: S, _: S, _: S) -> S {
        (S::constant(0.05) + y.scale(0.01 * self.length)).scale(self.length)
    }
}

/// The paper's oscillator, given by its force.
#[derive(Clone, Debug)]
pub(super) struct Linear;

impl SmoothOscillator for Linear {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
        amplitude * (omega * t).apply(Function::Cos) - y.scale(2.0 * ZETA) - x - S::constant(1.0)
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(EPSILON)
    }

    fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(0.0)
    }
}

/// Resonances of the Duffing oscillator, as p and where Newton's method starts (empirical, by homotopy from the linear one).
pub(super) const DUFFING: [(u32, [f64; 3]); 2] =
    [(1, [0.0668, 0.6734, 0.7597]), (2, [0.0868, 0.3983, 0.9134])];

pub(super) fn duffing(
    loops: u32,
    [phase, amplitude, omega]: [f64; 3],
) -> ResonantGrazingPoint<Integrated<Duffing>> {
    let oscillator = Integrated::new(Duffing { length: 1.0 }, [amplitude, omega]);
    ResonantGrazingPoint::find(&oscillator, loops, phase).unwrap()
}

/// The located resonance with one loop and an index.
pub(super) fn one_loop(index: u32) -> ResonantGrazingPoint<LinearOscillator> {
    let all = resonances(ZETA, EPSILON, &[1], [0.35, 1.02]);
    located(all.iter().find(|resonance| resonance.index() == index).unwrap())
}

/// The SN and PD curves of a resonance.
pub(super) fn curves<O: ImpactOscillator>(resonance: &ResonantGrazingPoint<O>) -> [Curve; 2] {
    let unfolded = resonance.unfold(&route([0.0, 1.3], [0.35, 1.02], true)).unwrap();
    [unfolded.saddle_node, unfolded.period_doubling]
}

/// Points of a curve away from y = 0, evenly spread over its length.
pub(super) fn spread(curve: &Curve, count: usize) -> Vec<Unknowns> {
    let all: Vec<Unknowns> = curve.points.iter().map(|point| point.solution.unknowns).collect();
    let away: Vec<Unknowns> = all.into_iter().filter(|point| point[unknown::VELOCITY] > 3e-2).collect();
    (0..count).map(|k| away[k * (away.len() - 1) / (count - 1)]).collect()
}

/// The point of a resonance's curve with the impact velocity y.
pub(super) fn at_velocity<O: ImpactOscillator>(
    resonance: &ResonantGrazingPoint<O>,
    condition: Condition,
    y: f64,
) -> Unknowns {
    let direction = resonance.direction(condition);
    let start = resonance.unknowns() + direction * (y / direction[0]);
    let equations = resonance.equations().with_formulation(Formulation::FixedPhase);
    let conditions = [condition, Condition::ImpactVelocity(y)];
    locate(&equations, conditions, start, &mut Memory::default()).unwrap()
}

/// An even function of s without its term of second order, from values at two sizes one of which is half the other.
pub(super) fn extrapolated([coarse, fine]: [f64; 2]) -> f64 {
    (4.0 * fine - coarse) / 3.0
}

/// What extrapolation leaves is of fourth order in s/y = 1/32. Rounding is 10⁻¹⁴ (y/s)²/y or so, for impact velocities of 0.03 and
/// more. Values of y² c are 10⁻³ and more, but next to a change of sign.
pub(super) const BY_EXTRAPOLATION: f64 = 1e-6;
