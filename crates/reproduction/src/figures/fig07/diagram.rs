//! `[fig07]`: the window of the two-parameter diagram, and the diagram that Figures 7 and 8 and the table
//! of coefficients use.

use grazing_continuation::curve::Window;
use grazing_continuation::resonance::ResonanceError;
use grazing_input::kind::{counts, interval};
use grazing_model::AnyOscillator;
use grazing_theorems::{LinearOscillator, Resonance, TheoryError};
use grazing_unfold::{Diagram, Scope};

use crate::figure::prelude::*;
use crate::parameters::contains;
use crate::parameters::limits::{AMPLITUDES, LOOPS, MOST_LOOPS, amplitudes};
use crate::study::forced;

/// The range of forcing frequencies of Figure 7. Resonances accumulate at zero; above the lower bound
/// there are 40 for p = 1.
const WINDOW_FREQUENCIES: [f64; 2] = [0.05, 100.0];

keys! {
    /// Figure 7: the forcing amplitude across, the forcing frequency up.
    pub struct Figure7 {
        /// The forcing amplitudes.
        amplitude: [f64; 2] = amplitudes(), AMPLITUDES;
        /// The forcing frequencies.
        frequency: [f64; 2] = interval(WINDOW_FREQUENCIES[0]..=WINDOW_FREQUENCIES[1]),
            "the forcing frequencies must be a range [lower, upper] with {} <= lower < upper <= {}; resonances accumulate at 0";
        /// The numbers of loops p; one at least has a resonance inside the window.
        loops: Vec<u32> = counts(1..=MOST_LOOPS), LOOPS;
    }
}

impl FileSection for Figure7 {
    const NAME: &'static str = "fig07";
    const REQUIREMENT: &'static str = "the table [fig07] says what Figure 7 shows";

    fn checked(self, section: &Section<'_>, parameters: &Parameters) -> Result<Self, ParameterError> {
        let oscillator = parameters.oscillator()?;
        let refuse = |error: TheoryError| section.forbid("frequency", error.to_string());
        if self.resonances(&oscillator).map_err(refuse)?.is_empty() {
            let beside = |value: f64, [low, high]: [f64; 2]| (value - value.clamp(low, high)).abs();
            let distance = |resonance: &Resonance| {
                let aside = beside(resonance.grazing().amplitude(), self.amplitude);
                libm::hypot(aside, beside(resonance.forcing_frequency(), self.frequency))
            };
            let [lower, upper] = WINDOW_FREQUENCIES;
            let all = oscillator.resonances(&self.loops, lower, upper).map_err(refuse)?;
            let nearest = all.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            let where_one_is = nearest.map_or_else(String::new, |one| {
                let (amplitude, omega) = (one.grazing().amplitude(), one.forcing_frequency());
                let (p, n) = (one.loops(), one.index());
                format!(
                    "; the nearest, p = {p}, n = {n}, is at amplitude {amplitude:.5}, frequency {omega:.5}"
                )
            });
            let allowed = format!(
                "no resonance lies in the window of fig07.amplitude and fig07.frequency{where_one_is}"
            );
            return Err(ParameterError::Unfit(section.forbid("frequency", allowed)));
        }
        Ok(self)
    }
}

impl Figure7 {
    /// The window, with amplitudes as the primary and frequencies as the secondary parameter.
    pub fn window(&self) -> Window {
        Window { primary: self.amplitude, secondary: self.frequency }
    }

    /// The resonances of an oscillator inside the window, by increasing frequency.
    pub(crate) fn resonances(&self, oscillator: &LinearOscillator) -> Result<Vec<Resonance>, TheoryError> {
        let [lower, upper] = self.frequency;
        let mut resonances = oscillator.resonances(&self.loops, lower, upper)?;
        resonances.retain(|resonance| contains(self.amplitude, resonance.grazing().amplitude()));
        Ok(resonances)
    }
}

impl Study {
    /// The diagram in the window of Figure 7: the results of `grazing_unfold` for an oscillator with a
    /// flow in closed form.
    ///
    /// # Errors
    /// The section of the figure or of the oscillator is invalid, or there is no grazing in the window.
    pub fn diagram(&self) -> Result<&Diagram, StudyError> {
        let compute = || {
            let figure: Figure7 = self.parameters.section()?;
            let scope = Scope { window: figure.window(), loops: figure.loops, start: None };
            let theory = self.parameters.oscillator()?;
            let oscillator = forced(&theory, scope.window.primary[0], scope.window.secondary[0])?;
            let oscillator = AnyOscillator::new(oscillator);
            Ok(Diagram::compute(&oscillator, &scope, &*self.progress)?)
        };
        self.diagram.get_or_init(compute).as_ref().map_err(Clone::clone)
    }

    /// Sentences about the resonances that are missing from Figure 7 and the table of coefficients
    /// because they could not be located.
    ///
    /// # Errors
    /// There is no grazing in the window.
    pub fn unlocated(&self) -> Result<Vec<String>, StudyError> {
        let lost = self.diagram()?.unlocated.iter();
        let sentence = lost.map(|lost| {
            format!("the resonance of p = {} near {:?} is missing: {}", lost.loops, lost.near, lost.reason)
        });
        Ok(sentence.collect())
    }
}

/// A message that a curve of a resonance is missing.
pub(crate) fn not_followed(resonance: &str, reason: &ResonanceError) -> String {
    format!("resonance {resonance}: a curve is missing: {reason}")
}
