//! Branches of MPSs in the amplitude: from the grazing bifurcation to the edge of the window, and what else there is of them inside.

use grazing_continuation::arclength::StepControl;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::{MpsCurve, Route, Window};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_model::LinearOscillator;
use grazing_results::branches::{BranchBifurcation, BranchPoint};
use grazing_unfold::Scope;
use grazing_unfold::diagram::route;
use grazing_unfold::one_parameter::{self, Branch, Strand};
use grazing_unfold::progress::Progress;
use rayon::prelude::*;

use super::Setting;
use crate::StudyError;
use crate::one_parameter::{bifurcation_row, strand_rows};
use crate::plane::centred;

/// What is drawn of a branch.
pub(super) type Shown = (Vec<Strand>, Vec<one_parameter::BranchBifurcation>);

/// Follows the branches of all p asked for: first those from grazing.
pub(super) fn follow(
    setting: &Setting,
    progress: &dyn Progress,
) -> Result<Vec<Branch<LinearOscillator>>, StudyError> {
    let figure = setting.figure;
    let frequency = figure.frequency;
    let window = Window { primary: figure.amplitude, secondary: [0.0, f64::INFINITY] };
    let past_all_events = Route { stop_at_events: false, ..route(window, StepControl::DRAWING) };
    let amplitude = setting.grazing.amplitude();
    let start = Unknowns::new(0.0, setting.grazing.phase(), amplitude, frequency);
    let oscillator = setting.oscillator(amplitude)?;
    let begun = figure.loops.par_iter().map(|&loops| {
            let equations = LoopEquations::new(oscillator, loops, Formulation::FixedPhase);
            let curve = MpsCurve { equations: equations.clone(), condition: Condition::Secondary(frequency) };
            let to_positive_velocity = Unknowns::new(1.0, 0.0, 0.0, 0.0);
            let curve = curve
                .follow(start, to_positive_velocity, EventTimes::default(), &past_all_events)
                .map_err(|stall| {
                    StudyError::Failed(format!(
                        "the branch of {loops}-loop solutions cannot be started at the grazing bifurcation: {stall}"
                    ))
                })?;
            Ok(Branch { equations, curve })
        });
    let begun: Vec<Branch<_>> = begun.collect::<Result<_, StudyError>>()?;
    let window = Window { primary: figure.amplitude, secondary: [frequency; 2] };
    let scope = Scope { window, loops: figure.loops.clone(), start: None };
    let all = one_parameter::completed(&oscillator, &scope, frequency, begun, progress);
    let from_grazing = |branch: &Branch<_>| {
        branch.curve.points.first().is_some_and(|first| first.solution.impact_velocity() == 0.0)
    };
    let (begun, others): (Vec<_>, Vec<_>) = all.into_iter().partition(from_grazing);
    Ok([begun, others].concat())
}

/// The grazing bifurcation and all bifurcations of admissible MPSs, branch by branch.
pub(super) fn bifurcations(setting: &Setting, shown: &[Shown]) -> Vec<BranchBifurcation> {
    let graz = BranchBifurcation {
        kind: Bifurcation::NonImpactingGrazing,
        loops: 0,
        primary: setting.grazing.amplitude(),
        impact_velocity: 0.0,
        x: 0.0,
    };
    let found = shown.iter().flat_map(|(_, bifurcations)| bifurcations);
    core::iter::once(graz).chain(found.map(bifurcation_row)).collect()
}

/// Samples of the non-impacting solution, a straight line in this diagram.
const NON_IMPACTING_SAMPLES: u32 = 50;

/// The non-impacting solution and all branches, loop by loop.
pub(super) fn rows(setting: &Setting, shown: &[Shown]) -> Result<Vec<BranchPoint>, StudyError> {
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
    let strands = (1..).zip(shown.iter().flat_map(|(strands, _)| strands));
    for (polyline, strand) in strands {
        rows.extend(strand_rows(polyline, strand).map(|row| BranchPoint {
            impact_phase: centred(row.impact_phase - setting.grazing.phase()),
            ..row
        }));
    }
    Ok(rows)
}
