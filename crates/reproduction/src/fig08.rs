//! Figure 8 (fig:Y): magnifications around resonances with the quadratic approximations.

use grazing_continuation::bifurcation::Pair;
use grazing_continuation::curve::Window;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::LinearOscillator;
use grazing_results::plane::MagnifiedPoint;
use grazing_results::{Names, Table};
use grazing_unfold::Diagram;
use grazing_unfold::magnification::{Polyline, magnify, window_about};
use grazing_unfold::resonances::Resonance;
use rayon::prelude::*;

use crate::StudyError;
use crate::diagram::ends;
use crate::parameters::{Panel, Parameters};
use crate::plane;

/// What Figure 8 shows.
#[derive(Clone, Debug)]
pub struct Figure8 {
    /// Continued curves and quadratic approximations, panel by panel.
    pub curves: Vec<MagnifiedPoint>,
    /// The panels, numbered from 1.
    pub panels: Vec<ShownPanel>,
    /// What is shown in the place of something else, in sentences.
    pub notes: Vec<String>,
}

/// A panel of Figure 8.
#[derive(Clone, Copy, Debug)]
pub struct ShownPanel {
    /// Number of loops p of its resonance.
    pub loops: u32,
    /// What it shows of the plane.
    pub window: Window,
    /// The coefficients by the closed form.
    pub coefficients: Pair<f64>,
}

impl Figure8 {
    /// The tables that are written.
    pub fn tables(&self) -> Vec<Table> {
        vec![Table::new("fig08_curves", &Names::of_the_paper(), &self.curves)]
    }

    pub(crate) fn compute(
        parameters: &Parameters,
        diagram: &Diagram<LinearOscillator>,
    ) -> Result<Self, StudyError> {
        let (shown, notes) = shown(parameters, diagram)?;
        let polylines: Vec<_> =
            shown.par_iter().map(|panel| panel.curves(diagram)).collect::<Result<_, StudyError>>()?;
        let magnified = shown.iter().zip(&polylines);
        let magnified =
            magnified.map(|(panel, lines)| (panel.resonance.loops, panel.resonance.n, lines.as_slice()));
        Ok(Self {
            curves: plane::magnifications(magnified),
            panels: panels(parameters, diagram)?,
            notes: [parameters.fig08()?.notes(), &notes].concat(),
        })
    }
}

/// The panels that are shown, without their curves.
pub(crate) fn panels(
    parameters: &Parameters,
    diagram: &Diagram<LinearOscillator>,
) -> Result<Vec<ShownPanel>, StudyError> {
    let theory = parameters.oscillator()?;
    let panel = |panel: &Shown<'_>| {
        let (loops, window) = (panel.resonance.loops, panel.window);
        let known = theory.resonance(loops, panel.resonance.n)?;
        let coefficients = Pair {
            saddle_node: known.saddle_node_coefficient(),
            period_doubling: known.period_doubling_coefficient(),
        };
        Ok(ShownPanel { loops, window, coefficients })
    };
    shown(parameters, diagram)?.0.iter().map(panel).collect()
}

/// A panel whose resonance is in the diagram.
struct Shown<'a> {
    resonance: &'a Resonance<LinearOscillator>,
    point: &'a ResonantGrazingPoint<LinearOscillator>,
    window: Window,
}

impl Shown<'_> {
    /// Its curves.
    fn curves(&self, diagram: &Diagram<LinearOscillator>) -> Result<Vec<Polyline>, StudyError> {
        let Self { resonance, point, window } = *self;
        magnify(diagram, resonance, point, window)
            .map_err(|source| StudyError::resonance(resonance.loops, resonance.n, source))
    }
}

/// The panels that can be shown, and why others cannot, in sentences.
fn shown<'a>(
    parameters: &Parameters,
    diagram: &'a Diagram<LinearOscillator>,
) -> Result<(Vec<Shown<'a>>, Vec<String>), StudyError> {
    let (mut panels, mut notes) = (Vec::new(), Vec::new());
    for panel in parameters.fig08()?.panels() {
        let (loops, n) = (panel.loops(), panel.n());
        let reason = match located(diagram, panel) {
            Some((resonance, point)) => {
                let window = window(diagram, panel, resonance, point);
                let is_range = |[low, high]: [f64; 2]| low < high;
                if is_range(window.primary) && is_range(window.secondary) {
                    panels.push(Shown { resonance, point, window });
                    continue;
                }
                "its curves lie too close together to be told apart"
            }
            None => "it was not found in the window of Figure 7, or no theorem applies there",
        };
        notes.push(format!(
            "no panel shows the resonance p = {loops}, n = {n}: {reason}; choose another in fig08.panels"
        ));
    }
    match (panels.is_empty(), parameters.fig08()?.panels()) {
        (true, [first, ..]) => Err(StudyError::NoPanel { loops: first.loops(), n: first.n() }),
        _ => Ok((panels, notes)),
    }
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

/// The resonance of a panel in the diagram.
fn located<'a>(
    diagram: &'a Diagram<LinearOscillator>,
    panel: &Panel,
) -> Option<(&'a Resonance<LinearOscillator>, &'a ResonantGrazingPoint<LinearOscillator>)> {
    diagram.unfolding().find(|(resonance, _)| (resonance.loops, resonance.n) == (panel.loops(), panel.n()))
}
