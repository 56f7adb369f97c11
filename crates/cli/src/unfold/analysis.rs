//! The analysis of an oscillator from a text file, up to its limits.

use grazing_unfold::UnfoldError;
use grazing_unfold::described::Prepared;
use grazing_unfold::nothing::Nothing;
use grazing_unfold::unfolded::{Keep, Unfolded};

use crate::failure::Failure;
use crate::limits::{EndCause, ended};
use crate::oscillator::OscillatorFile;
use crate::runner::Running;

/// Analyses a prepared oscillator up to the limits of the computation, which include the reading of its file; returns
/// also the cause that ended the analysis, if anything is missing.
///
/// # Errors
/// There is nothing to unfold.
pub(crate) fn analyse(
    of: &OscillatorFile,
    prepared: Prepared,
    running: &Running<'_>,
    keep: Keep<'_>,
) -> Result<(Unfolded, Option<EndCause>), Failure> {
    let unfolded =
        Unfolded::prepared(&of.description, prepared, &**running.progress(), &running.stop(), keep)
            .map_err(|error| failure(of, &error, running.end_cause()))?;
    let met = running.end_cause().filter(|_| !unfolded.diagram.unfinished.is_empty());
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
