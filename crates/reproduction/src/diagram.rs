//! The two-parameter diagram of the paper's oscillator, which Figures 7 and 8 and the table share.

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Route, Window};
use grazing_model::LinearOscillator;
use grazing_unfold::diagram::route;
use grazing_unfold::progress::Progress;
use grazing_unfold::{Diagram, Scope};

use crate::StudyError;
use crate::parameters::{Parameters, Range, Rectangle};

/// The diagram in the window of Figure 7: what `grazing_unfold` finds of an oscillator whose flow is known in closed form.
pub(crate) fn compute(
    parameters: &Parameters,
    progress: &dyn Progress,
) -> Result<Diagram<LinearOscillator>, StudyError> {
    let figure = parameters.fig07()?;
    let window = window(figure.window());
    let scope = Scope { window, loops: figure.loops().to_vec(), start: None };
    let oscillator = forced(parameters.oscillator()?, window.primary[0], window.secondary[0])?;
    Ok(Diagram::compute(&oscillator, &scope, progress)?)
}

/// What was seen and is not in the diagram.
pub(crate) fn gaps(diagram: &Diagram<LinearOscillator>) -> Vec<StudyError> {
    let unlocated = diagram.unlocated.iter().map(|lost| StudyError::Unlocated {
        loops: lost.loops,
        near: lost.near,
        source: lost.reason.clone(),
    });
    let failed = diagram.not_unfolded.iter();
    unlocated
        .chain(failed.map(|failed| StudyError::resonance(failed.loops, failed.n, failed.reason.clone())))
        .collect()
}

/// The oscillator of theory with its forcing.
pub(crate) fn forced(
    theory: &grazing_theorems::LinearOscillator,
    amplitude: f64,
    frequency: f64,
) -> Result<LinearOscillator, StudyError> {
    let (zeta, epsilon) = (theory.damping_ratio(), theory.coefficient_of_restitution());
    Ok(LinearOscillator::new(zeta, epsilon, amplitude, frequency)?)
}

/// Amplitudes and frequencies as ranges of the primary and the secondary parameter.
pub(crate) fn window(rectangle: Rectangle) -> Window {
    Window { primary: ends(rectangle.amplitude()), secondary: ends(rectangle.frequency()) }
}

/// The route along a branch of fixed frequency through a range of amplitudes, past all events.
pub(crate) fn branch_route(amplitude: Range) -> Route {
    let window = Window { primary: ends(amplitude), secondary: [0.0, f64::INFINITY] };
    Route { stop_at_events: false, ..route(window, StepControl::DRAWING) }
}

pub(crate) fn ends(range: Range) -> [f64; 2] {
    [range.lower(), range.upper()]
}
