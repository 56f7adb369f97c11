//! Figure 8 (fig:Y): magnifications around resonances with the quadratic approximations.

mod section;

use core::cell::LazyCell;

use grazing_continuation::curve::Window;
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_drawing::{Heading, draw_magnifications};
use grazing_results::Names;
use grazing_results::plane::{Magnifications, MagnifiedPanel};
use grazing_unfold::magnification::{self, magnify, window_about};
use grazing_unfold::resonances::FoundResonance;
use rayon::prelude::*;

use super::fig07::diagram::not_followed;
use crate::coefficients::closed_form_coefficients;
use crate::figure::prelude::*;
use grazing_unfold::plane;

use section::MOST_PANELS;
pub use section::{Figure8, MagnifiedResonance, NearWindow};

/// A panel whose resonance is in the diagram.
struct Shown<'a> {
    resonance: &'a FoundResonance,
    point: &'a ResonantGrazingPoint,
    window: Window,
}

impl StudyFigure for Figure8 {
    const LABEL: &'static str = "fig:Y";
    const TITLE: Title<&'static str> =
        Title::figure(8, "magnifications of Figure~7 with quadratic approximations");
    const TABLES: &'static [TablePlan] = &TablePlan::renamed(Magnifications::TABLES, ["fig08_curves"]);
    const REMEDY: &'static str = "fig08.panels, fig07.frequency or fig07.amplitude";
    type Shown = Magnifications;

    /// The magnifications of Figure 7. A resonance that cannot be located, unfolded or measured is an
    /// error.
    fn compute(&self, study: &Study) -> Result<Magnifications, StudyError> {
        let (diagram, (shown, _)) = (study.diagram()?, self.shown(study)?);
        let curves = |&Shown { resonance, point, window }: &Shown<'_>| {
            magnify(diagram, resonance, point, window).map_err(|reason| {
                StudyError::Failed(not_followed(
                    &format!("p = {}, n = {}", resonance.loops, resonance.n),
                    &reason,
                ))
            })
        };
        let curves: Vec<_> = shown.par_iter().map(curves).collect::<Result<_, _>>()?;
        Ok(Magnifications {
            curves: magnification::numbered(&curves),
            points: plane::points(diagram),
            regions: plane::regions(&diagram.regions),
            panels: self.panels(study)?,
        })
    }

    fn draw(magnifications: &Magnifications, width: SheetWidth) -> Result<Sheet, DrawingError> {
        let heading = Heading {
            name: "fig08",
            title: "Magnifications about three resonant grazing bifurcations",
            description: "Forcing amplitude across, forcing frequency up. Dashed: the quadratic approximations to the \
             saddle-node and period-doubling curves.",
            names: &Names::of_the_paper(),
            tables: &["fig08_curves"],
        };
        // The greatest possible number of panels fits on one sheet.
        let found = magnifications.panels.len();
        let sheet = draw_magnifications(magnifications, &heading, width)?.pop();
        let sheet = sheet.filter(|_| found <= MOST_PANELS);
        sheet.ok_or_else(|| DrawingError(format!("fig08 has one to three panels, but {found} were given")))
    }

    fn remarks(&self, study: &Study, _: &Magnifications) -> Result<Remarks, StudyError> {
        let notes = [self.notes.as_slice(), &self.shown(study)?.1].concat();
        Ok(Remarks { notes, ..Remarks::default() })
    }

    fn constants(study: &Study) -> Result<Vec<(&'static str, f64)>, ParameterError> {
        study.oscillator_constants()
    }
}

impl Figure8 {
    /// The panels, without their curves.
    pub(super) fn panels(&self, study: &Study) -> Result<Vec<MagnifiedPanel>, StudyError> {
        let theory = study.parameters.oscillator()?;
        let panel = |(panel, shown): (u32, &Shown<'_>)| {
            let &Shown { resonance: &FoundResonance { loops, n, .. }, window, .. } = shown;
            let coefficients = closed_form_coefficients(&theory.resonance(loops, n)?);
            Ok(MagnifiedPanel { panel, frame: window.into(), loops, wall: 0, n: None, coefficients })
        };
        (1..).zip(&self.shown(study)?.0).map(panel).collect()
    }

    /// The panels that can be shown, and sentences about the reasons why others cannot.
    fn shown<'a>(&self, study: &'a Study) -> Result<(Vec<Shown<'a>>, Vec<String>), StudyError> {
        let (diagram, asked) = (study.diagram()?, &self.panels);
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
