//! Figure 8 (fig:Y): magnifications around resonances with the quadratic approximations.

use core::cell::LazyCell;

use grazing_continuation::curve::Window;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_results::plane::{Magnifications, MagnifiedPanel};
use grazing_unfold::magnification::{magnify, window_about};
use grazing_unfold::resonances::Resonance;
use rayon::prelude::*;

use crate::coefficients::closed_form_coefficients;
use crate::fig07::not_followed;
use crate::plane::{self, Axes};
use crate::{Study, StudyError};

/// A panel whose resonance is in the diagram.
struct Shown<'a> {
    resonance: &'a Resonance,
    point: &'a ResonantGrazingPoint,
    window: Window,
}

impl Study {
    /// Figure 8: magnifications of Figure 7.
    ///
    /// # Errors
    /// A resonance could not be located, unfolded or measured.
    pub fn fig08(&self) -> Result<Magnifications, StudyError> {
        let (diagram, (shown, _), axes) = (self.diagram()?, self.shown()?, Axes::of_the_paper());
        let curves = |&Shown { resonance, point, window }: &Shown<'_>| {
            magnify(diagram, resonance, point, window)
                .map_err(|reason| StudyError::Failed(not_followed(resonance.loops, resonance.n, &reason)))
        };
        let polylines: Vec<_> = shown.par_iter().map(curves).collect::<Result<_, _>>()?;
        Ok(Magnifications {
            curves: plane::magnified_curves(&polylines),
            points: plane::points(&axes, diagram),
            regions: plane::regions(&axes, &diagram.regions),
            panels: self.panels()?,
        })
    }

    /// What Figure 8 shows in the place of something else, in sentences.
    ///
    /// # Errors
    /// As [`fig08`](Self::fig08).
    pub fn fig08_notes(&self) -> Result<Vec<String>, StudyError> {
        Ok([self.parameters.fig08.get()?.notes.as_slice(), &self.shown()?.1].concat())
    }

    /// The panels of Figure 8, without their curves.
    pub(crate) fn panels(&self) -> Result<Vec<MagnifiedPanel>, StudyError> {
        let theory = self.parameters.oscillator.get()?;
        let panel = |(panel, shown): (u32, &Shown<'_>)| {
            let &Shown { resonance: &Resonance { loops, n, .. }, window, .. } = shown;
            let coefficients = closed_form_coefficients(&theory.resonance(loops, n)?);
            Ok(MagnifiedPanel { panel, frame: window.into(), loops, n: None, coefficients })
        };
        (1..).zip(&self.shown()?.0).map(panel).collect()
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
            Some(first) if panels.is_empty() => Err(StudyError::Failed(format!(
                "the resonance p = {}, n = {} of the first panel was not found, nor can another be shown; choose others in fig08.panels",
                first.loops, first.n
            ))),
            _ => Ok((panels, notes)),
        }
    }
}
