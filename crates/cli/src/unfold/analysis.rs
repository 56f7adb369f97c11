//! The analysis of an oscillator from a text file, up to its limits.

use grazing_analysis::nothing::Nothing;
use grazing_analysis::unfolded::{Keep, Prepared, Unfolded, axes};
use grazing_unfold::UnfoldError;
use grazing_unfold::progress::Progress;

use crate::failure::Failure;
use crate::limits::{EndCause, Watch, ended};
use crate::oscillator::OscillatorFile;
use crate::progress::Display;

pub(crate) use crate::outputs::oscillator::Analysis;

/// Analyses an oscillator up to the limits of a watch, which include the reading of its file; returns also the
/// cause that ended the analysis, if anything is missing. The watch ends with the analysis, so that motion of the
/// oscillator goes on afterwards.
///
/// # Errors
/// There is nothing to unfold.
pub(crate) fn analyse(
    of: &OscillatorFile,
    watch: Watch,
    keep: Keep<'_>,
) -> Result<(Analysis, Option<EndCause>), Failure> {
    let display = Display::counting(watch.stop());
    let prepared = Prepared::new(&of.description, axes(&of.description), &watch.stop());
    analyse_prepared(of, prepared, &watch, &display, keep)
}

/// Analyses a prepared oscillator as [`analyse`] does, with a given watch and receiver of progress.
///
/// # Errors
/// There is nothing to unfold.
pub(crate) fn analyse_prepared(
    of: &OscillatorFile,
    prepared: Prepared,
    watch: &Watch,
    progress: &dyn Progress,
    keep: Keep<'_>,
) -> Result<(Analysis, Option<EndCause>), Failure> {
    let unfolded = Unfolded::prepared(&of.description, prepared, progress, &watch.stop(), keep)
        .map_err(|error| failure(of, &error, watch.end_cause()))?;
    let met = watch.end_cause().filter(|_| !unfolded.diagram.unfinished.is_empty());
    Ok((unfolded, met))
}

/// The failure of an analysis with nothing to unfold, with the file's names of the parameters, or
/// with the cause that ended the search.
fn failure(of: &OscillatorFile, error: &UnfoldError, met: Option<EndCause>) -> Failure {
    let OscillatorFile { file, description, .. } = of;
    match (error, met) {
        (UnfoldError::Stopped { stage }, Some(met)) => {
            let outcome = "nothing is written, because there were no results yet; cancelled in the stage";
            ended(file, Some(met), &format!("{outcome} `{stage}`"))
        }
        _ => Failure::incomplete(format!("{}: {}", file.display(), Nothing::new(error, description))),
    }
}
