//! Figure 8 (fig:Y): magnifications around resonances with the quadratic approximations.

use core::cell::LazyCell;

use grazing_continuation::bifurcation::Pair;
use grazing_continuation::curve::Window;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::LinearOscillator;
use grazing_results::plane::MagnifiedPoint;
use grazing_results::tables;
use grazing_unfold::magnification::{magnify, window_about};
use grazing_unfold::resonances::Resonance;
use rayon::prelude::*;

use crate::{Study, StudyError, plane};

tables! {
    /// What Figure 8 shows.
    Figure8 {
        /// Continued curves and quadratic approximations, panel by panel.
        curves: MagnifiedPoint = "fig08_curves", "a point of a curve of a magnification",
        ;
        /// The panels, numbered from 1.
        panels: Vec<ShownPanel>,
        /// What is shown in the place of something else, in sentences.
        notes: Vec<String>,
    }
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

/// A panel whose resonance is in the diagram.
struct Shown<'a> {
    resonance: &'a Resonance<LinearOscillator>,
    point: &'a ResonantGrazingPoint<LinearOscillator>,
    window: Window,
}

impl Study<'_> {
    /// Figure 8.
    ///
    /// # Errors
    /// A resonance could not be located, unfolded or measured.
    pub fn fig08(&self) -> Result<Figure8, StudyError> {
        let (diagram, (shown, notes)) = (self.diagram()?, self.shown()?);
        let curves = |&Shown { resonance, point, window }: &Shown<'_>| {
            magnify(diagram, resonance, point, window)
                .map_err(|source| StudyError::resonance(resonance.loops, resonance.n, source))
        };
        let polylines: Vec<_> = shown.par_iter().map(curves).collect::<Result<_, _>>()?;
        let magnified = shown.iter().zip(&polylines);
        let magnified =
            magnified.map(|(panel, lines)| (panel.resonance.loops, panel.resonance.n, lines.as_slice()));
        Ok(Figure8 {
            curves: plane::magnifications(magnified),
            panels: self.panels()?,
            notes: [self.parameters.fig08.get()?.notes.as_slice(), &notes].concat(),
        })
    }

    /// The panels of Figure 8, without their curves.
    ///
    /// # Errors
    /// No panel can be shown.
    pub fn panels(&self) -> Result<Vec<ShownPanel>, StudyError> {
        let theory = self.parameters.oscillator.get()?;
        let panel = |&Shown { resonance: &Resonance { loops, n, .. }, window, .. }: &Shown<'_>| {
            let known = theory.resonance(loops, n)?;
            let coefficients = Pair {
                saddle_node: known.saddle_node_coefficient(),
                period_doubling: known.period_doubling_coefficient(),
            };
            Ok(ShownPanel { loops, window, coefficients })
        };
        self.shown()?.0.iter().map(panel).collect()
    }

    /// The panels that can be shown, and why others cannot, in sentences.
    fn shown(&self) -> Result<(Vec<Shown<'_>>, Vec<String>), StudyError> {
        let (diagram, asked) = (self.diagram()?, &self.parameters.fig08.get()?.panels);
        let (mut panels, mut notes) = (Vec::new(), Vec::new());
        for panel in asked {
            let (loops, n) = (panel.loops, panel.n);
            let located = diagram.unfolding().find(|(found, _)| (found.loops, found.n) == (loops, n));
            let reason = match located {
                Some((resonance, point)) => {
                    let about = LazyCell::new(|| window_about(diagram, resonance, point));
                    let window = Window {
                        primary: panel.amplitude.unwrap_or_else(|| about.primary),
                        secondary: panel.frequency.unwrap_or_else(|| about.secondary),
                    };
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
        match asked.first() {
            Some(first) if panels.is_empty() => Err(StudyError::NoPanel { loops: first.loops, n: first.n }),
            _ => Ok((panels, notes)),
        }
    }
}
