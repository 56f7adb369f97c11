//! Figure 2 (fig:Z): the one-parameter diagram of the paper's oscillator at a fixed frequency, with
//! a magnification and phase portraits.

mod subjects;

use grazing_continuation::curve::Window;
use grazing_model::AnyOscillator;
use grazing_results::Frame;
use grazing_results::branches::OneParameter;
use grazing_unfold::Scope;
use grazing_unfold::one_parameter::{Cut, Line};

use crate::study::forced;
use crate::{Study, StudyError};

impl Study {
    /// Figure 2.
    ///
    /// # Errors
    /// A portrait's solution is not there.
    pub fn fig02(&self) -> Result<OneParameter, StudyError> {
        let (figure, theory) = (self.parameters.fig02.get()?, self.parameters.oscillator.get()?);
        let (at, range) = (figure.frequency, figure.amplitude);
        let oscillator = AnyOscillator::new(forced(theory, range[0], at)?);
        // Of the frequencies only the lower end matters.
        let window = Window { primary: range, secondary: [at, 2.0 * at] };
        let scope = Scope { window, loops: figure.loops.clone(), start: None };
        let line = Line { diagram: 1, primary_is_fixed: false, at, range };
        let cut = Cut::follow(&oscillator, &scope, &[], line, &*self.progress)
            .ok_or_else(|| StudyError::Failed("it was stopped".to_owned()))?;
        let grazing = theory.grazing(at)?.amplitude();
        let (subjects, mut notes) = subjects::all(figure, grazing, cut.branches())?;
        let mut found = cut.simulated(&figure.attractor, &subjects, &*self.progress);
        for (loops, amplitude, reason) in &found.broken {
            notes.push(format!(
                "a branch of p = {loops} could not be followed beyond amplitude {amplitude:.5}: {reason}"
            ));
        }
        for subject in &subjects {
            if !found.portraits.iter().any(|point| point.primary == subject.across) {
                let said = "the orbit comes to rest at the wall, so that there is no portrait of it";
                notes.push(format!("amplitude {}: {said}", subject.across));
            }
        }
        found.frame.y = figure.x;
        found.magnified = Some(Frame { x: figure.magnified_amplitude, y: figure.magnified_x });
        found.notes = [figure.notes.as_slice(), &notes].concat();
        Ok(found)
    }
}
