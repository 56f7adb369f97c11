//! Identification of an oscillator's constants: the search from diagram to diagram, and the uncertainties
//! of the resonances that follow.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_model::smooth::Units;
use grazing_model::{AnyOscillator, ImpactOscillator};
use grazing_results::measured::{Correlation, Identified, IdentifiedConstant, IdentifiedResonance, Residual};
use grazing_unfold::described::from_each_wall;
use grazing_unfold::family::{ArcEnd, arcs};
use grazing_unfold::progress::Progress;
use grazing_unfold::resonances::FoundResonance;
use grazing_unfold::sequences::{Sequence, of_diagram};
use grazing_unfold::unfolded::AtResonance;
use grazing_unfold::{Diagram, Scope, UnfoldError};
use thiserror::Error;

use crate::associate::associate;
use crate::fit::{Fit, FitError, Loss, Rig, fit};
use crate::read::{Behaviour, Impact, ImpactRecord, Observation};
use crate::residuals::{Datum, Segment};

/// All measurements for an identification.
#[derive(Clone, Debug, Default)]
pub struct Measurements {
    /// Places of the parameter plane; only bifurcations among them are used.
    pub points: Vec<Observation>,
    /// Records of impacts.
    pub record: Vec<ImpactRecord>,
}

/// The task of an identification.
pub struct IdentificationTask<'a> {
    /// The oscillator as a function of the free constants.
    pub rig: Rig<'a>,
    /// The names of the free constants.
    pub names: &'a [String],
    /// The values with which the search begins.
    pub start: &'a [f64],
    /// Ranges and numbers of loops, dimensionless.
    pub scope: &'a Scope,
    /// The units of the oscillator.
    pub units: Units,
}

/// The reason why nothing was identified.
#[derive(Clone, Debug, Error)]
pub enum IdentifyError {
    /// There is no fit.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// The measurements do not tell a constant, or not apart from others.
    #[error(
        "the measurements do not determine {0}, alone or apart from other constants: leave it out of --free"
    )]
    Undetermined(String),
    /// There is no oscillator, or no diagram, on the way.
    #[error("for {constants} there is nothing to compare with: {reason}")]
    Diagram {
        /// The values of the constants.
        constants: String,
        /// The reason why there is none.
        reason: UnfoldError,
    },
    /// For the constants reached during the search there is no oscillator.
    #[error("with {0} the file has no oscillator")]
    NoOscillator(String),
    /// A measured bifurcation has no curve.
    #[error(
        "line {line}: the diagram has no curve of {words}: start from other constants with --set, or add its p to --loops"
    )]
    NoCurve {
        /// The line of the measurement.
        line: u32,
        /// A description of the bifurcation.
        words: String,
    },
    /// The computation was cancelled.
    #[error("not finished")]
    Stopped,
}

/// The numbers of impacts in the segments of a record. The first round uses single flights, whose ends
/// depend on the constants without folds, so that the search may begin far away; later rounds use longer
/// segments, which contain more information. The length is limited because errors grow along unstable
/// motion.
const FIRST: usize = 2;
const LONGEST: usize = 12;
/// The curves are computed anew with the constants found, until the constants change by less than this
/// fraction of their errors, or for at most this number of rounds.
const SETTLED: f64 = 1e-2;
const MOST_ROUNDS: usize = 8;
/// The number of initial rounds in which large residuals have reduced weight.
const TAMED: usize = 2;
/// Standard errors of times and speeds for which none is stated, dimensionless, before anything is known of them,
/// and the least that are assumed.
const ASSUMED: f64 = 1e-2;
const LEAST: f64 = 1e-9;

/// The constants with the least sum of squares, and the tables of results.
///
/// # Errors
/// [`IdentifyError`].
pub fn identify(
    task: &IdentificationTask<'_>,
    measured: &Measurements,
    progress: &dyn Progress,
) -> Result<(Fit, Identified), IdentifyError> {
    let mut at = task.start.to_vec();
    let mut both = Both::default();
    let mut last = Err(IdentifyError::Stopped);
    let mut assumed = [ASSUMED; 3];
    let bifurcation = |point: &Observation| match point.seen {
        Behaviour::Bifurcation { kind, walls, .. } => Some((kind, walls)),
        _ => None,
    };
    let bifurcations = || measured.points.iter().filter_map(bifurcation);
    let needs_curves = bifurcations().next().is_some();
    let needs_both =
        bifurcations().any(|(kind, walls)| kind != Bifurcation::NonImpactingGrazing && walls.may_be_both());
    for round in 0..MOST_ROUNDS {
        let (mut data, mut lost) = (Vec::new(), None);
        if needs_curves {
            let diagrams = task.curves(&at, progress)?;
            if needs_both && !both.are_near(&at) {
                let solutions = of_diagram(&diagrams[0], 1, progress).solutions;
                both = Both { solutions, at: at.clone(), within: Vec::new() };
            }
            let known = (&diagrams[0], diagrams.get(1), both.solutions.as_slice());
            for point in &measured.points {
                match associate(std::slice::from_ref(point), known, &task.units) {
                    Ok(located) => {
                        data.extend(located.into_iter().map(|one| Datum::Bifurcation(Box::new(one))))
                    }
                    Err((line, words)) => lost = Some(IdentifyError::NoCurve { line, words }),
                }
            }
        }
        let longest = if round == 0 { FIRST } else { LONGEST };
        let mut weight = if round < TAMED { Loss::Tame } else { Loss::Full };
        data.extend(task.segments(&measured.record, longest, assumed).into_iter().map(Datum::Impacts));
        // Data that cannot be compared for these constants may become comparable for better ones.
        let found = loop {
            match fit(task.rig, &at, task.scope.window, data.clone(), weight) {
                Err(error @ FitError::Start { datum, .. }) if data.len() > 1 => {
                    data.remove(datum);
                    lost = Some(error.into());
                }
                // Where all residuals are large, as of a rig that does not fit, reduced weights may not converge.
                Err(FitError::NoConvergence) if weight == Loss::Tame => weight = Loss::Full,
                found => break found,
            }
        };
        if progress.stopped() {
            return Err(IdentifyError::Stopped);
        }
        let found = found.map_err(|error| match (error, &lost) {
            // What was left out is missed.
            (FitError::TooFew { .. } | FitError::Undetermined(_), Some(lost)) => lost.clone(),
            (FitError::Undetermined(place), None) => IdentifyError::Undetermined(task.names[place].clone()),
            (error, _) => error.into(),
        })?;
        let errors = found.errors();
        both.within.clone_from(&errors);
        let seen = scatter(&found, &data, assumed);
        let settled = (0..at.len()).all(|k| (found.values[k] - at[k]).abs() <= SETTLED * errors[k])
            && (0..3).all(|k| (seen[k] - assumed[k]).abs() <= SETTLED * assumed[k]);
        assumed = seen;
        at.clone_from(&found.values);
        match lost {
            Some(lost) => last = Err(lost),
            None => last = Ok((found, data)),
        }
        if settled && round >= TAMED {
            break;
        }
    }
    let (found, data) = last?;
    let found = if found.is_refuted() { found.scaled() } else { found };
    let identified = task.identified(&found, &data, progress)?;
    if progress.stopped() { Err(IdentifyError::Stopped) } else { Ok((found, identified)) }
}

/// Solutions that hit both of two walls, which take long to find. They are found anew where a constant has moved by more
/// than its error since.
#[derive(Default)]
struct Both {
    solutions: Vec<Sequence>,
    /// The constants with which they were found.
    at: Vec<f64>,
    /// The errors of the constants, once they are known.
    within: Vec<f64>,
}

impl Both {
    fn are_near(&self, at: &[f64]) -> bool {
        let mut moved = at.iter().zip(&self.at).zip(&self.within);
        self.within.len() == at.len() && moved.all(|((one, other), error)| (one - other).abs() <= *error)
    }
}

/// The standard errors of times and of speeds for which none is stated, from the residuals.
fn scatter(found: &Fit, data: &[Datum], assumed: [f64; 3]) -> [f64; 3] {
    let mut sums = [[0.0_f64; 2]; 2];
    for (datum, residuals) in data.iter().zip(&found.residuals) {
        let Datum::Impacts(segment) = datum else { continue };
        let mut residuals = residuals.iter();
        for (impact, errors) in segment.impacts.iter().zip(&segment.errors) {
            for k in (0..3).filter(|k| !impact[*k].is_nan()) {
                let Some(residual) = residuals.next() else { continue };
                if errors[k].is_nan() {
                    let [squares, count] = &mut sums[k.min(1)];
                    *squares += residual * residual;
                    *count += 1.0;
                }
            }
        }
    }
    // Unknowns take up a part of the scatter.
    let numbers = found.residuals.iter().flatten().count() as f64;
    let share = numbers / found.freedom.max(1) as f64;
    let of = |k: usize| {
        let [squares, count] = sums[k.min(1)];
        if count > 0.0 { (assumed[k] * (share * squares / count).sqrt()).max(LEAST) } else { assumed[k] }
    };
    [0, 1, 2].map(of)
}

impl IdentificationTask<'_> {
    fn constants(&self, values: &[f64]) -> String {
        let named = self.names.iter().zip(values).map(|(name, value)| format!("{name} = {value}"));
        named.collect::<Vec<_>>().join(", ")
    }

    /// The oscillator, located as each wall sees it, for values of the constants: the first, and then the other if there are two.
    fn located(&self, at: &[f64], progress: &dyn Progress) -> Result<Vec<Diagram>, IdentifyError> {
        let oscillator = (self.rig)(at).ok_or_else(|| IdentifyError::NoOscillator(self.constants(at)))?;
        let views = from_each_wall(&oscillator, self.scope, &[]);
        views.map(|view| view.located(progress)).collect::<Result<_, _>>().map_err(|reason| match reason {
            UnfoldError::Stopped { .. } => IdentifyError::Stopped,
            reason => IdentifyError::Diagram { constants: self.constants(at), reason },
        })
    }

    /// The diagrams as each wall sees them, with their curves, for values of the constants.
    fn curves(&self, at: &[f64], progress: &dyn Progress) -> Result<Vec<Diagram>, IdentifyError> {
        let followed = |located: Diagram| {
            let followed = located.follow(progress, &|_, _| ());
            located.with_curves(followed)
        };
        Ok(self.located(at, progress)?.into_iter().map(followed).collect())
    }

    /// The oscillator as a wall sees it, for values of the constants.
    fn seen(&self, at: &[f64], wall: u32) -> Option<AnyOscillator> {
        let oscillator = (self.rig)(at)?;
        if wall < 2 { Some(oscillator) } else { oscillator.other_stop() }
    }

    /// The record in dimensionless form, divided into segments.
    fn segments(&self, record: &[ImpactRecord], longest: usize, assumed: [f64; 3]) -> Vec<Segment> {
        let Units { time, primary, secondary, .. } = self.units;
        let scales = [time, self.units.velocity(), self.units.velocity()];
        let without = |values: [f64; 3]| [0, 1, 2].map(|k| values[k] / scales[k]);
        let pieces = record.iter().flat_map(|series| {
            let struck = |impact: &Impact| (impact.line, impact.stop());
            // With one wall nothing is to be said of the impact after the last.
            let next = usize::from(series.impacts.iter().any(|impact| impact.wall > 1));
            let begins = (0..series.impacts.len()).step_by(longest);
            begins.zip(series.impacts.chunks(longest)).map(move |(begin, impacts)| Segment {
                at: [series.at[0] / primary, series.at[1] / secondary],
                struck: series.impacts[begin..].iter().take(impacts.len() + next).map(struck).collect(),
                impacts: impacts.iter().map(|impact| without(impact.values)).collect(),
                errors: impacts.iter().map(|impact| without(impact.errors)).collect(),
                assumed,
            })
        });
        pieces.collect()
    }

    fn identified(
        &self,
        found: &Fit,
        data: &[Datum],
        progress: &dyn Progress,
    ) -> Result<Identified, IdentifyError> {
        let (errors, count) = (found.errors(), self.names.len());
        let constants = (0..count).map(|k| IdentifiedConstant {
            constant: self.names[k].clone(),
            value: found.values[k],
            error: errors[k],
            start: self.start[k],
        });
        let pairs = (0..count).flat_map(|one| (one + 1..count).map(move |other| (one, other)));
        let correlations = pairs.map(|(one, other)| Correlation {
            constant: self.names[one].clone(),
            other: self.names[other].clone(),
            correlation: found.correlation(one, other),
        });
        let residuals =
            data.iter().zip(&found.residuals).flat_map(|(datum, numbers)| {
                let source = if matches!(datum, Datum::Impacts(_)) { "record" } else { "points" };
                datum.quantities().into_iter().zip(numbers).map(move |((line, quantity), residual)| {
                    Residual { source: source.to_owned(), line, quantity, residual: *residual }
                })
            });
        Ok(Identified {
            constants: constants.collect(),
            correlations: correlations.collect(),
            residuals: residuals.collect(),
            resonances: self.resonances(found, progress)?,
        })
    }

    /// The resonances at each wall, with the errors that follow from those of the constants; those of walls that are alike are
    /// listed once, at the first.
    fn resonances(
        &self,
        found: &Fit,
        progress: &dyn Progress,
    ) -> Result<Vec<IdentifiedResonance>, IdentifyError> {
        let diagrams = self.located(&found.values, progress)?;
        let mut known: Vec<AtResonance> = Vec::new();
        let mut all = Vec::new();
        for diagram in &diagrams {
            let at_wall = |resonance| AtResonance::new(resonance, diagram.wall);
            let here: Vec<AtResonance> = diagram.resonances.iter().map(at_wall).collect();
            let rows = self.resonances_at(found, diagram).into_iter().zip(&here);
            let new = rows.filter(|(_, at)| !known.iter().any(|known| at.is_like(known)));
            all.extend(new.map(|(row, _)| row));
            known.extend(here);
        }
        Ok(all)
    }

    /// The resonances at one wall.
    ///
    /// A resonance is followed by one standard error of each constant to both sides; half the difference
    /// is the first-order change, and the covariance follows from these changes.
    fn resonances_at(&self, found: &Fit, diagram: &Diagram) -> Vec<IdentifiedResonance> {
        let (errors, count) = (found.errors(), found.values.len());
        let mut changes = vec![vec![[f64::NAN; 2]; count]; diagram.resonances.len()];
        for k in 0..count {
            let [above, below] = [1.0, -1.0].map(|side| {
                let between = |way: f64| {
                    let mut at = found.values.clone();
                    at[k] += side * way * errors[k];
                    self.seen(&at, diagram.wall)
                };
                let mut ends = vec![None; diagram.resonances.len()];
                for arc in arcs(diagram, &between) {
                    if let (ArcEnd::Across, Some(last)) = (&arc.end, arc.points.last()) {
                        ends[arc.resonance] = Some(last.orbit.oscillator().parameters());
                    }
                }
                ends
            });
            for (place, change) in changes.iter_mut().enumerate() {
                if let (Some(above), Some(below)) = (above[place], below[place]) {
                    change[k] = [0, 1].map(|axis| 0.5 * (above[axis] - below[axis]));
                }
            }
        }
        let one = |(resonance, changes): (&FoundResonance, Vec<[f64; 2]>)| {
            let variance = |axis: usize| -> f64 {
                let pairs = (0..count).flat_map(|one| (0..count).map(move |other| (one, other)));
                pairs.map(|(a, b)| changes[a][axis] * changes[b][axis] * found.correlation(a, b)).sum()
            };
            let [primary, secondary] =
                self.units.parameters(resonance.located.orbit().oscillator().parameters());
            let deviations = [0, 1].map(|axis| variance(axis).max(0.0).sqrt());
            // NaN must not become an error of zero, to which max() would turn it.
            let known = changes.iter().flatten().all(|change| change.is_finite());
            let [primary_error, secondary_error] =
                if known { self.units.parameters(deviations) } else { [f64::NAN; 2] };
            let lost =
                "within one standard error of a constant it leaves the ranges, ends or meets another one";
            let reason = if known { String::new() } else { lost.to_owned() };
            let (loops, n) = (resonance.loops, resonance.n);
            let wall = diagram.wall;
            IdentifiedResonance { loops, wall, n, secondary, secondary_error, primary, primary_error, reason }
        };
        diagram.resonances.iter().zip(changes).map(one).collect()
    }
}
