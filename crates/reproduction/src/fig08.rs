//! Figure 8 (fig:Y): magnifications around resonances with the quadratic approximations.

use grazing_model::LinearOscillator;
use grazing_unfold::Diagram;
use grazing_unfold::magnification::{Polyline, magnify};
use rayon::prelude::*;

use crate::StudyError;
use crate::coefficients::Coefficients;
use crate::diagram::window;
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
}

impl Figure8 {
    /// The tables that are written.
    pub fn tables(&self) -> Vec<Table> {
        vec![self.curves.clone()]
    }

    pub(crate) fn compute(
        parameters: &Parameters,
        diagram: &Diagram<LinearOscillator>,
        coefficients: &[Coefficients],
    ) -> Result<Self, StudyError> {
        let mut printed = columns! { "panel": 0, "p": 0, "n": 0, "c_sn": 0.0, "c_pd": 0.0 };
        let panels = parameters.fig08().panels();
        let polylines: Vec<_> =
            panels.par_iter().map(|panel| follow(diagram, panel)).collect::<Result<_, StudyError>>()?;
        for (number, panel) in (1..).zip(panels) {
            for c in coefficients.iter().filter(|c| c.loops == panel.loops() && c.n == panel.n()) {
                printed.push(row![number, c.loops, c.n, c.closed_form[0], c.closed_form[1]]);
            }
        }
        Ok(Self {
            curves: plane::magnifications("fig08_curves", &Axes::of_the_paper(), &polylines)?,
            coefficients: printed.finish("fig08_coefficients")?,
        })
    }
}

/// The curves of a panel; none if its resonance does not lie in the window of Figure 7.
fn follow(diagram: &Diagram<LinearOscillator>, panel: &Panel) -> Result<Vec<Polyline>, StudyError> {
    let (loops, n) = (panel.loops(), panel.n());
    match diagram.unfolding().find(|(resonance, _)| resonance.loops == loops && resonance.n == n) {
        Some((resonance, point)) => magnify(diagram, resonance, point, window(panel.window()))
            .map_err(|source| StudyError::resonance(loops, n, source)),
        None => Ok(Vec::new()),
    }
}
