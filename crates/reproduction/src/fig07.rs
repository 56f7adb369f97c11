//! Figure 7 (fig:G): the two-parameter bifurcation diagram of the paper's oscillator, which Figure
//! 8 and the table of coefficients share.

use grazing_continuation::resonance::ResonanceError;
use grazing_model::AnyOscillator;
use grazing_results::brief;
use grazing_results::plane::{PlaneDiagram, Section};
use grazing_unfold::regions::{Doubt, Region};
use grazing_unfold::{Diagram, Scope};

use crate::plane::{self, Axes};
use crate::study::forced;
use crate::{Study, StudyError};

impl Study {
    /// The diagram in the window of Figure 7: what `grazing_unfold` finds of an oscillator whose
    /// flow is known in closed form.
    pub(crate) fn diagram(&self) -> Result<&Diagram, StudyError> {
        let compute = || {
            let figure = self.parameters.fig07.get()?;
            let scope = Scope { window: figure.window, loops: figure.loops.clone(), start: None };
            let theory = self.parameters.oscillator.get()?;
            let oscillator = forced(theory, scope.window.primary[0], scope.window.secondary[0])?;
            let oscillator = AnyOscillator::new(oscillator);
            Ok(Diagram::compute(&oscillator, &scope, &*self.progress)?)
        };
        self.diagram.get_or_init(compute).as_ref().map_err(Clone::clone)
    }

    /// Figure 7, with the line along which Figure 2 runs and the panels of Figure 8, as far as
    /// these can be computed.
    ///
    /// # Errors
    /// There is no grazing in the window.
    pub fn fig07(&self) -> Result<PlaneDiagram, StudyError> {
        let panels = self.panels().unwrap_or_default();
        let section = self.parameters.fig02.get().ok().map(|fig02| Section {
            ends: fig02.amplitude.map(|amplitude| (amplitude, fig02.frequency)),
            name: "Fig. 2".to_owned(),
            thin: false,
        });
        let axes = Axes::of_the_paper();
        Ok(plane::plane_diagram(&axes, self.diagram()?, panels, section.into_iter().collect()))
    }

    /// What Figure 7 and the table of coefficients lack: resonances that could not be located, in
    /// sentences.
    ///
    /// # Errors
    /// As [`fig07`](Self::fig07).
    pub fn unlocated(&self) -> Result<Vec<String>, StudyError> {
        let lost = self.diagram()?.unlocated.iter();
        let sentence = lost.map(|lost| {
            format!("the resonance of p = {} near {:?} is missing: {}", lost.loops, lost.near, lost.reason)
        });
        Ok(sentence.collect())
    }

    /// What Figure 7 lacks: resonances that could not be located, and curves that could not be
    /// followed, in sentences.
    ///
    /// # Errors
    /// As [`fig07`](Self::fig07).
    pub fn fig07_gaps(&self) -> Result<Vec<String>, StudyError> {
        let lost = self.diagram()?.not_unfolded.iter();
        let not_followed = lost.map(|lost| not_followed(lost.loops, lost.n, &lost.reason));
        Ok(self.unlocated()?.into_iter().chain(not_followed).collect())
    }

    /// Where it is not decided whether solutions are stable, with the reason: one sentence for the
    /// regions of one p.
    ///
    /// # Errors
    /// As [`fig07`](Self::fig07).
    pub fn undecided(&self) -> Result<Vec<String>, StudyError> {
        let regions = self.diagram()?.regions.iter();
        let doubts: Vec<_> = regions.filter_map(|region| Some((region, region.doubt.as_ref()?))).collect();
        let sentences = doubts.chunk_by(|(a, _), (b, _)| a.loops == b.loops).map(undecided);
        Ok(sentences.collect())
    }
}

fn undecided(doubts: &[(&Region, &Doubt)]) -> String {
    let (first, doubt) = doubts[0];
    let [from, to] = first.extent().map(|[amplitude, frequency]| {
        format!("amplitude {}, frequency {}", brief(amplitude, 6), brief(frequency, 6))
    });
    let more = match doubts.len() - 1 {
        0 => String::new(),
        more => format!("; and in {more} more places, see fig07_regions.csv"),
    };
    format!("p = {} is undecided, and hatched, from {from} to {to}: {doubt}{more}", first.loops)
}

/// That a curve of a resonance is missing.
pub(crate) fn not_followed(loops: u32, n: u32, reason: &ResonanceError) -> String {
    format!("resonance p = {loops}, n = {n}: a curve is missing: {reason}")
}
