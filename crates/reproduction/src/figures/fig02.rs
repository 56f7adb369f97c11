//! Figure 2 (fig:Z): the one-parameter diagram of the paper's oscillator at a fixed frequency, with
//! a magnification and phase portraits.

mod section;
mod subjects;

use grazing_continuation::curve::Window;
use grazing_drawing::{Heading, draw_one_parameter};
use grazing_model::AnyOscillator;
use grazing_results::branches::OneParameter;
use grazing_results::place::briefly;
use grazing_results::{Frame, Names};
use grazing_unfold::Scope;
use grazing_unfold::one_parameter::{Cut, Line};

use crate::figure::prelude::*;
use crate::study::forced;

pub use section::{Figure2, Magnification, Portrait, Wish, frequency};

impl Figure2 {
    /// The branches of the figure: of the non-impacting solution and of the MPSs with its numbers of loops.
    ///
    /// # Errors
    /// The section of the oscillator is invalid, or the computation was stopped.
    pub fn cut(&self, study: &Study) -> Result<Cut, StudyError> {
        let (at, range) = (self.frequency, self.across.value);
        let oscillator = AnyOscillator::new(forced(&study.parameters.oscillator()?, range[0], at)?);
        // Only the lower end of the frequencies is used.
        let window = Window { primary: range, secondary: [at, 2.0 * at] };
        let scope = Scope { window, loops: self.loops.clone(), start: None };
        let line = Line { diagram: 1, primary_is_fixed: false, at, range };
        Cut::follow(&oscillator, &scope, &[], line, &*study.progress)
            .ok_or_else(|| StudyError::Failed("it was stopped".to_owned()))
    }
}

impl StudyFigure for Figure2 {
    const LABEL: &'static str = "fig:Z";
    const TITLE: Title<&'static str> =
        Title::figure(2, "one-parameter bifurcation diagram with phase portraits");
    const TABLES: &'static [TablePlan] = &TablePlan::renamed(
        OneParameter::TABLES,
        ["fig02_branches", "fig02_bifurcations", "fig02_attractor", "fig02_portraits"],
    );
    const REMEDY: &'static str = "fig02.frequency, fig02.near or fig02.loops";
    type Shown = OneParameter;

    fn compute(&self, study: &Study) -> Result<OneParameter, StudyError> {
        let mut cut = self.cut(study)?;
        let grazing = study.parameters.oscillator()?.grazing(self.frequency)?.amplitude();
        let (subjects, mut notes) = subjects::all(self, grazing, cut.branches())?;
        let mut found = cut.simulated(&self.attractor, &subjects, &*study.progress);
        for (numbers, amplitude, reason) in &found.broken {
            let of = briefly(*numbers);
            notes.push(format!(
                "a branch of {of} could not be followed beyond amplitude {amplitude:.5}: {reason}"
            ));
        }
        for subject in &subjects {
            if !found.portraits.iter().any(|point| point.primary == subject.across) {
                let said = "the orbit rests at the wall for good or cannot be followed, so that there is no portrait of it";
                notes.push(format!("amplitude {}: {said}", subject.across));
            }
        }
        found.frame.y = self.x;
        found.magnified = Some(Frame { x: self.magnification.amplitude, y: self.magnification.x });
        found.notes = [self.notes.as_slice(), &notes].concat();
        Ok(found)
    }

    fn draw(figure: &OneParameter, width: SheetWidth) -> Result<Sheet, DrawingError> {
        let heading = Heading {
            name: "fig02",
            title: "One-parameter bifurcation diagram with phase portraits",
            description: "Below: forcing amplitude across, x-value of the return map up; thick curves are stable, thin ones unstable; \
                          dots are long-term forward orbits. Framed: magnification. Above: phase portraits with the wall.",
            names: &Names::of_the_paper(),
            tables: &["fig02_bifurcations", "fig02_branches", "fig02_attractor", "fig02_portraits"],
        };
        draw_one_parameter(figure, &heading, false, width)
    }

    fn remarks(&self, _: &Study, shown: &OneParameter) -> Result<Remarks, StudyError> {
        Ok(Remarks { notes: shown.notes.clone(), ..Remarks::default() })
    }

    fn constants(study: &Study) -> Result<Vec<(&'static str, f64)>, ParameterError> {
        let mut constants = study.oscillator_constants()?;
        constants.push((r"\omega", frequency(&study.parameters)?));
        Ok(constants)
    }
}
