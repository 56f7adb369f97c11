//! Non-impacting motion in the whole window: its grazing curves, its folds and period doublings,
//! and its regions of stability.
//!
//! The survey is the same as for MPSs (`survey`), with p = 0. Only the search for the first
//! solutions and for grazing differs: motion is left to relax, and grazing is looked for on
//! lattices.

mod relaxation;
mod rest;
mod symmetry;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::CurvePoint;
use grazing_continuation::mps::LoopEquations;
use grazing_model::AnyOscillator;

pub use relaxation::{Height, PeriodicMotion, periodic_motion};
pub(crate) use relaxation::{is_whole, motion};
pub use rest::positions as rest_positions;
pub use symmetry::equations;

use crate::curves::{DiagramCurve, Net};
use crate::grazing::GrazingCurve;
use crate::parallel;
use crate::progress::Progress;
use crate::regions::{self, Region, crossed, decided};
use crate::slices::Slice;
use crate::subharmonic::over_periods;
use crate::survey::Survey;
use crate::tolerances::BETWEEN_HEIGHTS;
use crate::unfinished::Unfinished;
use crate::{Scope, UnfoldError, search};

/// The results for motion without impacts.
#[derive(Clone, Debug)]
pub(crate) struct NonImpacting {
    pub(crate) grazing: Vec<GrazingCurve>,
    /// Grazing of motion over two forcing periods, four, and so on.
    pub(crate) doubled: Vec<GrazingCurve>,
    /// The reason why there is no grazing, if there is none.
    pub(crate) no_grazing: Option<UnfoldError>,
    pub(crate) curves: Vec<DiagramCurve>,
    pub(crate) regions: Vec<Region>,
    /// Parts that were not finished when the computation was cancelled.
    pub(crate) unfinished: Vec<Unfinished>,
}

/// The name of the stage.
const STAGE: &str = "motion without impacts";

/// Finds grazing of the non-impacting solutions and their regions.
///
/// # Errors
/// The computation was cancelled before any was found.
pub(crate) fn find(
    oscillator: &AnyOscillator,
    scope: &Scope,
    progress: &dyn Progress,
) -> Result<NonImpacting, UnfoldError> {
    // On every other slice motion is left to relax from rest, which finds branches to which grazing
    // does not lead.
    let levels = regions::levels(scope.window);
    let [relaxed, between] =
        [0, 1].map(|first| levels.iter().copied().skip(first).step_by(2).collect::<Vec<_>>());
    progress
        .during(STAGE, relaxed.len() as u64, || on_slices(oscillator, scope, &relaxed, &between, progress))
}

/// The results from slices on which motion is left to relax from rest, and others between them.
fn on_slices(
    oscillator: &AnyOscillator,
    scope: &Scope,
    relaxed: &[f64],
    between: &[f64],
    progress: &dyn Progress,
) -> Result<NonImpacting, UnfoldError> {
    let motions = parallel::map(relaxed, |secondary| {
        let motion = periodic_motion(oscillator, scope, *secondary);
        progress.step(STAGE);
        motion
    });
    let equations = equations(oscillator, scope.window);
    let mut net = Net::new(equations.clone());
    let mut survey = Survey::new(&mut net, scope, &[], Vec::new());
    for (secondary, motion) in relaxed.iter().zip(&motions) {
        survey.add_slice(Slice::new(*secondary, motion.branches.clone()));
    }
    // From the middle outwards: a curve is reported once, from the first slice that meets it.
    let mut order: Vec<usize> = (0..motions.len()).collect();
    order.sort_by_key(|k| k.abs_diff(motions.len() / 2));
    for orbit in order.into_iter().flat_map(|k| &motions[k].grazing) {
        survey.add_grazing(orbit);
    }
    survey.follow_columns(progress);
    // Grazing to which no known curve leads, and the branches through the range of η on which it
    // lies.
    for highest in search::grazing(oscillator, scope, progress) {
        if let Some(orbit) = highest.grazing(oscillator)
            && survey.add_grazing(&orbit)
            && let Some(start) = survey.slicer.with_highest(&highest)
        {
            survey.follow_column(&start, progress);
        }
    }
    let no_grazing = match survey.grazing.is_empty() {
        true if progress.stopped() => return Err(UnfoldError::Stopped { stage: STAGE }),
        true => Some(explanation(&equations, &motions)),
        false => None,
    };
    let regions = decided(scope.window, &mut survey, between, progress);
    let grazing = survey.grazing;
    let doubled = doubled(oscillator, scope, net.clone(), progress);
    let regions = regions.unwrap_or_else(|| vec![Region::not_finished(scope.window, 0)]);
    let unfinished = if progress.stopped() { vec![Unfinished::stage(STAGE)] } else { Vec::new() };
    Ok(NonImpacting { grazing, doubled, no_grazing, curves: net.curves, regions, unfinished })
}

/// Grazing of the motion over two forcing periods that leaves the period doublings of motion over
/// one, and so on, as long as solutions with one impact for a requested p may begin there.
fn doubled(
    oscillator: &AnyOscillator,
    scope: &Scope,
    mut net: Net,
    progress: &dyn Progress,
) -> Vec<GrazingCurve> {
    let (mut grazing, mut periods) = (Vec::new(), 2);
    while scope.loops.iter().any(|loops| loops.is_multiple_of(periods))
        && net.curves.iter().any(|curve| curve.kind == Bifurcation::PeriodDoubling)
        && !progress.stopped()
    {
        let slow = over_periods(oscillator, periods);
        let mut next = Net::new(LoopEquations::without_impacts(slow, scope.window.widths()));
        let mut survey = Survey::of_doubled(&mut next, scope, periods, &net);
        crossed(scope.window, &mut survey, &regions::levels(scope.window), progress);
        grazing.append(&mut survey.grazing);
        net = next;
        periods *= 2;
    }
    grazing
}

/// The reason why no survey has found grazing.
fn explanation(equations: &LoopEquations, motions: &[PeriodicMotion]) -> UnfoldError {
    if let Some(at) = motions.iter().flat_map(|motion| &motion.pushed).next() {
        return UnfoldError::Pushed { at: *at };
    }
    let branches = motions.iter().flat_map(|motion| &motion.branches);
    let whole = branches.clone().all(is_whole);
    let points = branches.flat_map(|branch| &branch.points);
    let height = |point: &CurvePoint| point.solution.ceiling();
    let above = |a: &CurvePoint, b: &CurvePoint| height(a) - height(b) > BETWEEN_HEIGHTS * height(b).abs();
    let lowest = points.clone().reduce(|a, b| if above(a, b) { b } else { a });
    let highest = points.reduce(|a, b| if above(b, a) { b } else { a });
    match (lowest.zip(highest), motions.iter().find_map(|motion| motion.ran_away)) {
        (Some((lowest, highest)), _) => UnfoldError::NoGrazing {
            lowest: Height::of(equations, &lowest.solution),
            highest: Height::of(equations, &highest.solution),
            whole,
        },
        (None, Some(escape)) => UnfoldError::RunsAway { escape },
        (None, None) => UnfoldError::NoOrbit,
    }
}
