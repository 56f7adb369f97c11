//! Branches of MPSs in the amplitude, from the grazing bifurcation to the edge of the window.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{Curve, CurvePoint, MpsCurve};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, MaximalPeriodicSolution, Unknowns};
use grazing_model::LinearOscillator;
use grazing_results::branches::{BranchBifurcation, BranchPoint};
use rayon::prelude::*;

use super::Setting;
use crate::StudyError;
use crate::diagram::branch_route;
use crate::plane::centred;

/// The branch of p-loop MPSs that emanates from the grazing bifurcation.
pub(super) struct Branch {
    pub(super) equations: LoopEquations<LinearOscillator>,
    pub(super) curve: Curve,
}

/// Follows the branches of all p asked for.
pub(super) fn follow(setting: &Setting) -> Result<Vec<Branch>, StudyError> {
    let figure = setting.figure;
    let frequency = figure.frequency;
    let route = branch_route(figure.amplitude);
    let amplitude = setting.grazing.amplitude();
    let start = Unknowns::new(0.0, setting.grazing.phase(), amplitude, frequency);
    let oscillator = setting.oscillator(amplitude)?;
    figure
        .loops
        .par_iter()
        .map(|&loops| {
            let equations = LoopEquations::new(oscillator, loops, Formulation::Vivid);
            let curve = MpsCurve { equations: equations.clone(), condition: Condition::Secondary(frequency) };
            let to_positive_velocity = Unknowns::new(1.0, 0.0, 0.0, 0.0);
            let curve = curve
                .follow(start, to_positive_velocity, EventTimes::default(), &route)
                .map_err(|stall| {
                    StudyError::Failed(format!(
                        "the branch of {loops}-loop solutions cannot be started at the grazing bifurcation: {stall}"
                    ))
                })?;
            Ok(Branch { equations, curve })
        })
        .collect()
}

/// The grazing bifurcation and all bifurcations of admissible MPSs, branch by branch.
pub(super) fn bifurcations(setting: &Setting, branches: &[Branch]) -> Vec<BranchBifurcation> {
    let graz = BranchBifurcation {
        kind: Bifurcation::NonImpactingGrazing,
        loops: 0,
        primary: setting.grazing.amplitude(),
        impact_velocity: 0.0,
        x: 0.0,
    };
    let mut list = vec![graz];
    for branch in branches {
        for event in &branch.curve.events {
            let Some(kind) = Bifurcation::of(event.condition) else {
                continue;
            };
            if !event.solution.admissible() {
                continue;
            }
            let visits = branch.equations.visits(&event.solution.unknowns, &event.times);
            list.push(BranchBifurcation {
                kind,
                loops: branch.equations.loops(),
                primary: event.solution.parameters()[0],
                impact_velocity: event.solution.impact_velocity(),
                x: visits.ok().and_then(|visits| Some(visits.last()?[0])).unwrap_or(f64::NAN),
            });
        }
    }
    list
}

/// Samples of the non-impacting solution, a straight line in this diagram.
const NON_IMPACTING_SAMPLES: u32 = 50;

/// The non-impacting solution and all branches, loop by loop.
pub(super) fn rows(setting: &Setting, branches: &[Branch]) -> Result<Vec<BranchPoint>, StudyError> {
    let mut rows = Vec::new();
    let (lower, graz) = (setting.figure.amplitude[0], setting.grazing.amplitude());
    for k in 0..=NON_IMPACTING_SAMPLES {
        let amplitude = lower + (graz - lower) * f64::from(k) / f64::from(NON_IMPACTING_SAMPLES);
        // The maximum of eq:phip lies at the phase z_graz, whatever the amplitude.
        let x = setting.oscillator(amplitude)?.non_impacting_solution(setting.grazing.phase()).position;
        rows.push(BranchPoint {
            loops: 0,
            primary: amplitude,
            x,
            visit: 1,
            impact_velocity: f64::NAN,
            impact_phase: f64::NAN,
            stable: true,
            admissible: true,
            branch: 0,
        });
    }
    let mut polyline = 0;
    for branch in branches {
        let points = with_events(&branch.curve);
        let visits: Vec<_> =
            points.iter().map(|at| branch.equations.visits(&at.solution.unknowns, &at.times)).collect();
        for visit in 0..branch.equations.loops() {
            polyline += 1;
            for (at, visits) in points.iter().zip(&visits) {
                let [velocity, phase, amplitude, _] = at.solution.unknowns.into();
                let x = visits.as_ref().map_or(f64::NAN, |visits| visits[visit as usize][0]);
                rows.push(BranchPoint {
                    loops: branch.equations.loops(),
                    primary: amplitude,
                    x,
                    visit: visit + 1,
                    impact_velocity: velocity,
                    impact_phase: centred(phase - setting.grazing.phase()),
                    stable: velocity > 0.0 && at.solution.stable(),
                    admissible: admissible(&at.solution),
                    branch: polyline,
                });
            }
        }
    }
    Ok(rows)
}

/// Admissible, or the grazing orbit in which the branch begins.
fn admissible(solution: &MaximalPeriodicSolution) -> bool {
    solution.admissible() || solution.impact_velocity() == 0.0
}

/// The points of a branch with its bifurcation points in their places.
pub(super) fn with_events(curve: &Curve) -> Vec<CurvePoint> {
    let mut points = Vec::with_capacity(curve.points.len() + curve.events.len());
    let mut events = curve.events.iter().peekable();
    for (index, point) in curve.points.iter().enumerate() {
        while let Some(event) = events.next_if(|event| event.index <= index) {
            points.push(CurvePoint { solution: event.solution, times: event.times.clone() });
        }
        points.push(point.clone());
    }
    points
}
