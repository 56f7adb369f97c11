//! Continuation of MPSs: time per point of a branch and of a bifurcation curve.
//!
//! A point includes its correction, its multipliers and its admissibility over the whole orbit;
//! events and the ends of the curve are located along the way.

use core::hint::black_box;

use divan::Bencher;
use divan::counter::ItemsCount;
use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Curve, Route, SolutionCurve, Window};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::smooth::{Function, Integrated, Scalar, SmoothOscillator};
use grazing_model::{ImpactOscillator, LinearOscillator};

fn main() {
    divan::main();
}

const ZETA: f64 = 0.02;
const EPSILON: f64 = 0.9;

/// A curve that is ready to be followed.
struct Start<O> {
    curve: SolutionCurve<O>,
    point: Unknowns,
    direction: Unknowns,
    route: Route<'static>,
}

impl<O: ImpactOscillator> Start<O> {
    fn follow(&self) -> Curve {
        let Self { curve, point, direction, route } = self;
        curve.clone().follow(point.clone(), direction.clone(), EventTimes::default(), route).unwrap()
    }

    /// Benchmark in which one item is one point of the curve.
    fn bench(&self, bencher: Bencher<'_, '_>) {
        let points = self.follow().points.len();
        bencher.counter(ItemsCount::new(points)).bench(|| black_box(self).follow());
    }
}

fn route(amplitudes: [f64; 2], frequencies: [f64; 2], stop_at_events: bool) -> Route<'static> {
    Route {
        window: Window { primary: amplitudes, secondary: frequencies },
        control: StepControl::DRAWING,
        step_limit: 20_000,
        stop_at_events,
        pace: None,
    }
}

/// The number of loops p.
struct Loops(u32);

impl core::fmt::Display for Loops {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "p = {}", self.0)
    }
}

/// The n-th resonance of p-loop MPSs.
#[derive(Clone, Copy)]
struct Place {
    p: u32,
    n: u32,
}

impl core::fmt::Display for Place {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "p = {}, n = {}", self.p, self.n)
    }
}

/// The branch of p-loop MPSs at ω = 0.855 from the grazing bifurcation on, for amplitudes from 0.2
/// to 0.6.
#[divan::bench(args = [Loops(1), Loops(2), Loops(3)])]
fn point_of_a_one_parameter_branch(bencher: Bencher<'_, '_>, &Loops(p): &Loops) {
    one_parameter_branch(bencher, p, Formulation::Vivid);
}

/// The branch of p-loop MPSs at ω = 0.855, with the maps compared on a plane of constant phase.
#[divan::bench(args = [Loops(1), Loops(2), Loops(3)])]
fn point_of_a_one_parameter_branch_at_fixed_phase(bencher: Bencher<'_, '_>, &Loops(p): &Loops) {
    one_parameter_branch(bencher, p, Formulation::FixedPhase);
}

fn one_parameter_branch(bencher: Bencher<'_, '_>, p: u32, formulation: Formulation) {
    const OMEGA: f64 = 0.855;
    let theory = grazing_theorems::LinearOscillator::new(ZETA, EPSILON).unwrap();
    let grazing = theory.grazing(OMEGA).unwrap();
    let start = Start {
        curve: SolutionCurve {
            equations: LoopEquations::new(grazing.model(), p, formulation),
            condition: Condition::Secondary(OMEGA),
        },
        point: Unknowns::new(0.0, grazing.phase(), grazing.amplitude(), OMEGA),
        direction: Unknowns::new(1.0, 0.0, 0.0, 0.0),
        route: route([0.2, 0.6], [0.5, 1.5], false),
    };
    start.bench(bencher);
}

/// The number of impacts K.
struct Impacts(usize);

impl core::fmt::Display for Impacts {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "K = {}", self.0)
    }
}

/// The branch of MPSs with p = 1 at ω = 0.855, each counted K times as a solution with K impacts in K periods.
#[divan::bench(args = [Impacts(1), Impacts(2), Impacts(4)])]
fn point_of_a_branch_with_several_impacts(bencher: Bencher<'_, '_>, &Impacts(count): &Impacts) {
    const OMEGA: f64 = 0.855;
    let theory = grazing_theorems::LinearOscillator::new(ZETA, EPSILON).unwrap();
    let grazing = theory.grazing(OMEGA).unwrap();
    let condition = Condition::Secondary(OMEGA);
    let single = Start {
        curve: SolutionCurve {
            equations: LoopEquations::new(grazing.model(), 1, Formulation::FixedPhase),
            condition,
        },
        point: Unknowns::new(0.0, grazing.phase(), grazing.amplitude(), OMEGA),
        direction: Unknowns::new(1.0, 0.0, 0.0, 0.0),
        route: route([0.2, 0.6], [0.5, 1.5], false),
    };
    let once = single.follow();
    let [at, onwards] = [1, 2].map(|index| {
        let solution = &once.points[index].solution.unknowns;
        (1..count).fold(solution.clone(), |all, periods| all.followed_by(solution, periods as u32))
    });
    let equations = LoopEquations::new(grazing.model(), count as u32, Formulation::FixedPhase);
    let direction = &onwards - &at;
    Start { curve: SolutionCurve { equations, condition }, point: at, direction, ..single }.bench(bencher);
}

/// A bifurcation curve from a resonance to its end.
fn from_resonance(Place { p, n }: Place, condition: Condition) -> Start<LinearOscillator> {
    let theory = grazing_theorems::LinearOscillator::new(ZETA, EPSILON).unwrap();
    let grazing = theory.resonance(p, n).unwrap().grazing();
    let resonance = ResonantGrazingPoint::find(&grazing.model(), p, grazing.phase()).unwrap();
    Start {
        curve: resonance.curve(condition),
        point: resonance.unknowns(),
        direction: resonance.direction(condition),
        route: route([0.0, 1.3], [0.35, 1.02], true),
    }
}

/// The resonances with the largest regions of p = 1, 2, 3.
const RESONANCES: [Place; 3] = [Place { p: 1, n: 3 }, Place { p: 2, n: 1 }, Place { p: 3, n: 1 }];

#[divan::bench(args = RESONANCES)]
fn point_of_a_saddle_node_curve(bencher: Bencher<'_, '_>, resonance: &Place) {
    from_resonance(*resonance, Condition::SADDLE_NODE).bench(bencher);
}

#[divan::bench(args = RESONANCES)]
fn point_of_a_period_doubling_curve(bencher: Bencher<'_, '_>, resonance: &Place) {
    from_resonance(*resonance, Condition::PERIOD_DOUBLING).bench(bencher);
}

/// The paper's oscillator with a cubic spring, and a reset law that varies, given by its force.
#[derive(Clone, Debug)]
struct Duffing;

impl SmoothOscillator for Duffing {
    #[inline]
    fn force<S: Scalar>(&self, x: S, y: S, t: S, amplitude: S, omega: S) -> S {
        amplitude * (omega * t).apply(Function::Cos)
            - y.scale(2.0 * ZETA)
            - x
            - x.square() * x.scale(0.1)
            - S::constant(1.0)
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, y: S, _: S, _: S, _: S) -> S {
        S::constant(EPSILON) - y.scale(0.1)
    }

    fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(0.05)
    }
}

/// A formulation as a benchmark argument.
struct Way(Formulation);

impl core::fmt::Display for Way {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{:?}", self.0)
    }
}

/// The saddle-node curve of the Duffing oscillator with p = 1, its flow integrated.
#[divan::bench(args = [Way(Formulation::Vivid), Way(Formulation::FixedPhase)])]
fn point_of_a_saddle_node_curve_of_an_integrated_oscillator(
    bencher: Bencher<'_, '_>,
    &Way(formulation): &Way,
) {
    // Near the resonance that continues n = 3 of the linear oscillator.
    let oscillator = Integrated::new(Duffing, [0.673, 0.7597]);
    let resonance = ResonantGrazingPoint::find(&oscillator, 1, -0.3).unwrap();
    let condition = Condition::SADDLE_NODE;
    let start = Start {
        curve: SolutionCurve { equations: resonance.equations().with_formulation(formulation), condition },
        point: resonance.unknowns(),
        direction: resonance.direction(condition),
        route: route([0.3, 1.0], [0.7, 0.8], true),
    };
    start.bench(bencher);
}
