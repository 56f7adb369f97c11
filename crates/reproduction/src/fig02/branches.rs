//! Branches of MPSs in the amplitude, from the grazing bifurcation to the edge of the window.

use grazing_continuation::curve::{Curve, CurvePoint, MpsCurve};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{Formulation, LoopEquations, MaximalPeriodicSolution, Memory, Unknowns};
use grazing_model::LinearOscillator;
use grazing_unfold::diagram::Kind;
use rayon::prelude::*;

use super::Setting;
use crate::StudyError;
use crate::diagram::branch_route;
use crate::plane::centred;
use crate::table::{Table, columns, row};

/// The branch of p-loop MPSs that emanates from the grazing bifurcation.
pub(super) struct Branch {
    pub(super) equations: LoopEquations<LinearOscillator>,
    pub(super) curve: Curve,
}

/// A bifurcation on one of the branches, or the grazing bifurcation itself.
pub(super) struct Bifurcation {
    pub(super) kind: &'static str,
    pub(super) loops: u32,
    pub(super) amplitude: f64,
    pub(super) impact_velocity: f64,
    /// x on Π of the loop with the impact.
    pub(super) position: f64,
}

/// Follows the branches of all p asked for.
pub(super) fn follow(setting: &Setting) -> Result<Vec<Branch>, StudyError> {
    let figure = setting.figure;
    let frequency = figure.frequency();
    let route = branch_route(figure.amplitude());
    let amplitude = setting.grazing.amplitude();
    let start = Unknowns::new(0.0, setting.grazing.phase(), amplitude, frequency);
    let oscillator = setting.oscillator(amplitude)?;
    figure
        .loops()
        .par_iter()
        .map(|&loops| {
            let equations = LoopEquations::new(oscillator, loops, Formulation::Vivid);
            let curve = MpsCurve { equations: equations.clone(), condition: Condition::Secondary(frequency) };
            let to_positive_velocity = Unknowns::new(1.0, 0.0, 0.0, 0.0);
            let curve = curve
                .follow(start, to_positive_velocity, Memory::default(), &route)
                .map_err(|stall| StudyError::Branch { loops, reason: stall.to_string() })?;
            Ok(Branch { equations, curve })
        })
        .collect()
}

/// The grazing bifurcation and all bifurcations of admissible MPSs, branch by branch.
pub(super) fn bifurcations(setting: &Setting, branches: &[Branch]) -> Vec<Bifurcation> {
    let graz = Bifurcation {
        kind: "graz",
        loops: 0,
        amplitude: setting.grazing.amplitude(),
        impact_velocity: 0.0,
        position: 0.0,
    };
    let mut list = vec![graz];
    for branch in branches {
        for event in &branch.curve.events {
            let Some(kind) = Kind::of(event.condition) else {
                continue;
            };
            if !event.solution.admissible() {
                continue;
            }
            let visits = branch.equations.visits(&event.solution.unknowns, &event.memory);
            list.push(Bifurcation {
                kind: kind.name(),
                loops: branch.equations.loops(),
                amplitude: event.solution.parameters()[0],
                impact_velocity: event.solution.impact_velocity(),
                position: visits.ok().and_then(|visits| Some(visits.last()?[0])).unwrap_or(f64::NAN),
            });
        }
    }
    list
}

/// `fig02_bifurcations.csv`.
pub(super) fn bifurcation_table(bifurcations: &[Bifurcation]) -> Result<Table, StudyError> {
    let mut columns = columns! { "kind": "", "p": 0, "amplitude": 0.0, "impact_velocity": 0.0, "x": 0.0 };
    for b in bifurcations {
        columns.push(row![b.kind, b.loops, b.amplitude, b.impact_velocity, b.position]);
    }
    Ok(columns.finish("fig02_bifurcations")?)
}

/// Samples of the non-impacting solution, a straight line in this diagram.
const NON_IMPACTING_SAMPLES: u32 = 50;

/// `fig02_branches.csv`.
pub(super) fn table(setting: &Setting, branches: &[Branch]) -> Result<Table, StudyError> {
    let mut columns = columns! {
        "p": 0, "amplitude": 0.0, "x": 0.0, "loop": 0, "impact_velocity": 0.0, "impact_phase": 0.0,
        "stable": false, "admissible": false, "branch": 0,
    };
    let (lower, graz) = (setting.figure.amplitude().lower(), setting.grazing.amplitude());
    for k in 0..=NON_IMPACTING_SAMPLES {
        let amplitude = lower + (graz - lower) * f64::from(k) / f64::from(NON_IMPACTING_SAMPLES);
        // The maximum of eq:phip lies at the phase z_graz, whatever the amplitude.
        let x = setting.oscillator(amplitude)?.non_impacting_solution(setting.grazing.phase()).position;
        columns.push(row![0, amplitude, x, 1, f64::NAN, f64::NAN, true, true, 0]);
    }
    let mut polyline = 0;
    for branch in branches {
        let points = with_events(&branch.curve);
        let visits: Vec<_> =
            points.iter().map(|at| branch.equations.visits(&at.solution.unknowns, &at.memory)).collect();
        for visit in 0..branch.equations.loops() {
            polyline += 1;
            for (at, visits) in points.iter().zip(&visits) {
                let [velocity, phase, amplitude, _] = at.solution.unknowns.into();
                let x = visits.as_ref().map_or(f64::NAN, |visits| visits[visit as usize][0]);
                columns.push(row![
                    branch.equations.loops(),
                    amplitude,
                    x,
                    visit + 1,
                    velocity,
                    centred(phase - setting.grazing.phase()),
                    velocity > 0.0 && at.solution.stable(),
                    admissible(&at.solution),
                    polyline,
                ]);
            }
        }
    }
    Ok(columns.finish("fig02_branches")?)
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
            points.push(CurvePoint { solution: event.solution, memory: event.memory.clone() });
        }
        points.push(point.clone());
    }
    points
}
