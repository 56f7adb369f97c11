//! MPSs at given parameters by continuation alone, without slices, faces and regions.

use core::f64::consts::TAU;

use grazing_continuation::arclength::{Continuation, StepControl};
use grazing_continuation::curve::{SolutionCurve, Window};
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, LoopEquations, PeriodicSolution, Unknowns, parameters, unknown};
use grazing_unfold::Diagram;

/// Steps along branches, short enough for Newton's method.
const STEPS: StepControl =
    StepControl { first: 1e-3, longest: 0.1, shortest: 1e-6, turn: 0.1, ..StepControl::DRAWING };
/// The greatest number of points on a branch; a branch with more has gone astray.
const MOST_POINTS: usize = 3000;
/// The impact velocity at which branches that begin at grazing are started.
const BESIDE_GRAZING: f64 = 1e-4;
/// An MPS that is this close to a chord, as a fraction of the chord's length, lies on the branch, which
/// turns little per step.
const ON_BRANCH: f64 = 0.05;
/// The distance beyond which Newton's method has converged to another solution.
const ELSEWHERE: f64 = 0.5;

/// Whether the solution is a stable, admissible MPS of the hybrid system.
pub fn good(solution: &PeriodicSolution) -> bool {
    solution.stable() && solution.admissible()
}

/// The p-loop MPS at the given parameters that is near a known one.
pub fn near(
    equations: &LoopEquations,
    known: &Unknowns,
    [primary, secondary]: [f64; 2],
) -> Option<PeriodicSolution> {
    let start = Unknowns::new(known[unknown::VELOCITY], known[unknown::PHASE], primary, secondary);
    let conditions = [Condition::Primary(primary), Condition::Secondary(secondary)];
    let found = locate(equations, conditions, start.clone(), &mut EventTimes::default()).ok()?;
    ((&found - start).norm() < ELSEWHERE).then(|| equations.solution(&found))
}

/// The p-loop MPSs at one η and several μ, on branches that start at grazing or on a curve of the
/// diagram.
pub fn along(diagram: &Diagram, loops: u32, secondary: f64, primaries: &[f64]) -> Vec<Vec<PeriodicSolution>> {
    let equations = diagram.equations(loops);
    let curve = SolutionCurve { equations: equations.clone(), condition: Condition::Secondary(secondary) };
    let mut branches: Vec<Vec<Unknowns>> = Vec::new();
    for start in starts(diagram, &equations, loops, secondary) {
        if !branches.iter().any(|branch| lies_on(branch, &start)) {
            let onwards = Unknowns::new(1.0, 0.0, 0.0, 0.0);
            let mut branch = followed(&curve, start.clone(), -&onwards, diagram.scope.window);
            branch.reverse();
            branch.extend(followed(&curve, start, onwards, diagram.scope.window).into_iter().skip(1));
            branches.push(branch);
        }
    }
    let crossings = |primary: f64| {
        let pairs = branches.iter().flat_map(|branch| branch.windows(2));
        let crossing = pairs.filter_map(move |pair| {
            let [from, to] = [0, 1].map(|k| pair[k][unknown::PRIMARY] - primary);
            (from * to <= 0.0 && from != to).then(|| &pair[0] + (&pair[1] - &pair[0]) * (from / (from - to)))
        });
        crossing.filter_map(|known| near(&equations, &known, [primary, secondary])).collect()
    };
    primaries.iter().map(|primary| crossings(*primary)).collect()
}

/// Starting points of branches at one η: near grazing, and on curves of the diagram.
fn starts(diagram: &Diagram, equations: &LoopEquations, loops: u32, secondary: f64) -> Vec<Unknowns> {
    let here = Condition::Secondary(secondary);
    let solved = |condition: Condition, start: Unknowns, mut times: EventTimes| {
        let found = locate(equations, [condition, here], start.clone(), &mut times).ok()?;
        ((&found - start).norm() < ELSEWHERE).then_some(found)
    };
    let grazing = diagram.grazing.iter().flat_map(|curve| curve.all_at(secondary)).filter_map(|place| {
        let start = Unknowns::new(BESIDE_GRAZING, place.phase, place.parameters[0], secondary);
        solved(Condition::ImpactVelocity(BESIDE_GRAZING), start, EventTimes::default())
    });
    let curves = diagram.curves.iter().filter(|curve| curve.loops == loops);
    let crossing = curves.flat_map(|curve| {
        curve.curve.points.windows(2).filter_map(move |pair| {
            let [a, b] = [0, 1].map(|k| pair[k].solution.unknowns.clone());
            let [from, to] = [a.clone(), b.clone()].map(|point| point[unknown::SECONDARY] - secondary);
            let start = (from * to <= 0.0 && from != to).then(|| &a + (b - &a) * (from / (from - to)))?;
            solved(curve.curve.condition, start, pair[0].times.clone())
        })
    });
    grazing.chain(crossing).collect()
}

/// The points of a branch from `start`, as long as it has an impact and is within the window.
fn followed(curve: &SolutionCurve, start: Unknowns, direction: Unknowns, window: Window) -> Vec<Unknowns> {
    let mut points = vec![start.clone()];
    let Ok(mut walker) = Continuation::new(curve, STEPS, start.clone(), direction, EventTimes::default())
    else {
        return points;
    };
    while let Ok(station) = walker.advance() {
        points.push(station.point.clone());
        let gone = !window.contains(parameters(&station.point)) || station.point[unknown::VELOCITY] <= 0.0;
        let closed = points.len() > 10 && lies_on(&points[points.len() - 2..], &start);
        if gone || closed || points.len() > MOST_POINTS {
            break;
        }
    }
    points
}

/// Whether an MPS lies on a branch, given by its points.
fn lies_on(branch: &[Unknowns], point: &Unknowns) -> bool {
    branch.windows(2).any(|pair| {
        let chord = &pair[1] - &pair[0];
        let mut gap = point - &pair[0];
        gap[unknown::PHASE] = libm::remainder(gap[unknown::PHASE], TAU);
        let along = (gap.dot(&chord) / chord.norm_squared()).clamp(0.0, 1.0);
        (gap - &chord * along).norm() < ON_BRANCH * chord.norm()
    })
}
