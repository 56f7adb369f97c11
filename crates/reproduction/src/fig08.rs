//! Figure 8 (fig:Y): magnifications around resonances with the quadratic approximations.

use grazing_continuation::curve::Window;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::LinearOscillator;
use grazing_unfold::Diagram;
use grazing_unfold::magnification::{Polyline, magnify, window_about};
use grazing_unfold::resonances::Resonance;
use rayon::prelude::*;

use crate::StudyError;
use crate::diagram::ends;
use crate::parameters::{Panel, Parameters};
use crate::plane::{self, Axes};
use crate::table::{Table, columns, row};

/// The frames of Figure 8.
#[derive(Clone, Debug)]
pub struct Figure8 {
    /// `fig08_curves`: continued curves and quadratic approximations, panel by panel.
    pub curves: Table,
    /// The coefficients printed in each panel; they also stand in `coefficients.csv`.
    pub coefficients: Table,
    /// What is shown in the place of something else, in sentences.
    pub notes: Vec<String>,
}

impl Figure8 {
    /// The tables that are written.
    pub fn tables(&self) -> Vec<Table> {
        vec![self.curves.clone()]
    }

    pub(crate) fn compute(
        parameters: &Parameters,
        diagram: &Diagram<LinearOscillator>,
    ) -> Result<Self, StudyError> {
        let (shown, theory) = (parameters.fig08()?, parameters.oscillator()?);
        let mut printed = columns! { "panel": 0, "p": 0, "n": 0, "c_sn": 0.0, "c_pd": 0.0 };
        let polylines: Vec<_> = shown
            .panels()
            .par_iter()
            .map(|panel| follow(diagram, panel))
            .collect::<Result<_, StudyError>>()?;
        for (number, panel) in (1..).zip(shown.panels()) {
            let c = theory.resonance(panel.loops(), panel.n())?;
            let (c_sn, c_pd) = (c.saddle_node_coefficient(), c.period_doubling_coefficient());
            printed.push(row![number, panel.loops(), panel.n(), c_sn, c_pd]);
        }
        Ok(Self {
            curves: plane::magnifications("fig08_curves", &Axes::of_the_paper(), &polylines)?,
            coefficients: printed.finish("fig08_coefficients")?,
            notes: shown.notes().to_vec(),
        })
    }
}

/// The windows of the panels, as the file has them or chosen about the resonances.
pub(crate) fn windows(
    parameters: &Parameters,
    diagram: &Diagram<LinearOscillator>,
) -> Result<Vec<Window>, StudyError> {
    let panels = parameters.fig08()?.panels().iter();
    panels
        .map(|panel| {
            let (resonance, point) = located(diagram, panel)?;
            Ok(window(diagram, panel, resonance, point))
        })
        .collect()
}

fn window(
    diagram: &Diagram<LinearOscillator>,
    panel: &Panel,
    resonance: &Resonance<LinearOscillator>,
    point: &ResonantGrazingPoint<LinearOscillator>,
) -> Window {
    match (panel.amplitude(), panel.frequency()) {
        (Some(amplitude), Some(frequency)) => Window { primary: ends(amplitude), secondary: ends(frequency) },
        (amplitude, frequency) => {
            let about = window_about(diagram, resonance, point);
            Window {
                primary: amplitude.map_or(about.primary, ends),
                secondary: frequency.map_or(about.secondary, ends),
            }
        }
    }
}

/// The resonance of a panel in the diagram, which holds it as it lies in the window of Figure 7.
fn located<'a>(
    diagram: &'a Diagram<LinearOscillator>,
    panel: &Panel,
) -> Result<(&'a Resonance<LinearOscillator>, &'a ResonantGrazingPoint<LinearOscillator>), StudyError> {
    let (loops, n) = (panel.loops(), panel.n());
    diagram
        .unfolding()
        .find(|(resonance, _)| resonance.loops == loops && resonance.n == n)
        .ok_or(StudyError::NoPanel { loops, n })
}

/// The curves of a panel.
fn follow(diagram: &Diagram<LinearOscillator>, panel: &Panel) -> Result<Vec<Polyline>, StudyError> {
    let (resonance, point) = located(diagram, panel)?;
    magnify(diagram, resonance, point, window(diagram, panel, resonance, point))
        .map_err(|source| StudyError::resonance(panel.loops(), panel.n(), source))
}
