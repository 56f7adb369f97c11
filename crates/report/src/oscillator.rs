//! Oscillators from text files: their descriptions, and the results of theorems, curves and simulation.

use askama::filters::Safe;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_input::Description;
pub(crate) use grazing_results::columns::{C_SN, PRIMARY, SECONDARY};
use grazing_results::{Column, Table};
use grazing_unfold::described::Axes;
use grazing_unfold::unfolded::{AtResonance, CurveFinding, curves};
use grazing_unfold::verdict::{Coefficient, Verdict};
use grazing_unfold::verification::Simulated;

use crate::columns::in_parentheses;
use crate::html::{Html, counted, identifier};
use crate::outputs::FigureEntry;

/// An oscillator with all results about it.
#[derive(Debug, Clone)]
pub struct OscillatorEntry {
    /// A short name that no other oscillator on the page has, as `duffing`; part of addresses.
    pub id: String,
    /// The name of its file on the page.
    pub file: String,
    /// The address of that file, if it is to be linked.
    pub link: Option<String>,
    /// The paragraphs of the file's leading comment, about the origin of the oscillator.
    pub about: Vec<String>,
    /// The content of the file.
    pub description: Description,
    /// The figures; their names and those of their tables need to be unique in this oscillator only.
    pub figures: Vec<FigureEntry>,
    /// The tables that are shown as tables.
    pub tables: Vec<Table>,
    /// The resonant grazing bifurcations, in the order in which they were found.
    pub resonances: Vec<AtResonance>,
    /// Sentences about what could not be unfolded, with the reasons: resonances that were found and
    /// not located, curves that could not be followed.
    pub lost: Vec<String>,
    /// The regions in which the stability of solutions is undecided, with the numbers of their
    /// loops and the reasons: the figures show them hatched.
    pub undecided: Vec<(u32, String)>,
}

/// Significant digits of coefficients and of parameters.
pub(crate) const COEFFICIENT: usize = 9;
pub(crate) const PARAMETER: usize = 7;

/// The class of the colour of the verdict on a coefficient.
pub(crate) fn agreement(coefficient: &Coefficient) -> &'static str {
    match coefficient.verdict() {
        Verdict::Agree => "passed",
        Verdict::Contradict => "failed",
        Verdict::NotMeasurable(_) => "unchecked",
    }
}

/// The class of the colour of the verdict on a simulation.
pub(crate) fn simulation(simulated: &Simulated) -> &'static str {
    match simulated {
        Simulated::AsPredicted(_) => "passed",
        Simulated::Against(_) => "failed",
        Simulated::Undecided(_) => "unchecked",
    }
}

/// Counts of the verdicts on coefficients and simulation.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct VerdictCounts {
    /// The number of resonances.
    pub(crate) resonances: usize,
    /// The number of coefficients.
    pub(crate) all: usize,
    /// Coefficients measured as the theorem predicts, and those measured otherwise.
    pub(crate) agreeing: usize,
    pub(crate) differing: usize,
    /// The fewest digits that agree.
    pub(crate) digits: Option<u32>,
    /// Coefficients at which simulation is as predicted, and those at which it is not.
    pub(crate) predicted: usize,
    pub(crate) contradicted: usize,
}

impl OscillatorEntry {
    /// The identifier of the oscillator's part of the page.
    pub(crate) fn anchor(&self) -> String {
        identifier("oscillator", &self.id)
    }

    /// The oscillator as the second of two walls sees it, if there is one.
    pub(crate) fn second_wall(&self) -> Option<Description> {
        self.description.from_each_wall().nth(1)
    }

    /// The unit of a column in parentheses, after its heading.
    pub(crate) fn unit(&self, column: Column) -> Html {
        Safe(in_parentheses(&column.unit(&Axes::of(&self.description).names)))
    }

    /// The resonances at which a theorem applies, or those at which none does.
    pub(crate) fn resonances_where(&self, applies: bool) -> Vec<&AtResonance> {
        self.resonances.iter().filter(|at| at.curves.is_some() == applies).collect()
    }

    /// The SN and PD curves of all resonances.
    pub(crate) fn curves(&self) -> Vec<(&AtResonance, Bifurcation, &CurveFinding)> {
        curves(&self.resonances).collect()
    }

    /// Results on these curves that differ from the prediction of a theorem, or are unknown, with the reason.
    pub(crate) fn doubts(&self) -> Vec<(&AtResonance, Bifurcation, String, String)> {
        let all = |(at, kind, known): (_, _, &CurveFinding)| {
            known.doubts().map(move |(doubt, reason)| (at, kind, doubt, reason))
        };
        curves(&self.resonances).flat_map(all).collect()
    }

    fn tally(&self) -> VerdictCounts {
        VerdictCounts::of_all(std::slice::from_ref(self))
    }

    /// The verdicts on agreement and simulation, if a theorem applies, and the number of gaps.
    pub(crate) fn verdicts(&self) -> Html {
        let tally = self.tally();
        let mut verdicts = match tally.all {
            0 => vec![("unchecked", "no theorem applies".to_owned())],
            _ => vec![tally.agreement(), tally.simulation()],
        };
        if !self.lost.is_empty() {
            verdicts.push(("misprint", format!("{} not unfolded", self.lost.len())));
        }
        if !self.undecided.is_empty() {
            verdicts
                .push(("misprint", counted(self.undecided.len(), "region undecided", "regions undecided")));
        }
        let verdicts =
            verdicts.iter().map(|(tone, words)| format!("<span class=\"verdict {tone}\">{words}</span>"));
        Safe(verdicts.collect::<Vec<_>>().join(" "))
    }
}

impl VerdictCounts {
    /// The counts over all of these oscillators.
    pub(crate) fn of_all(oscillators: &[OscillatorEntry]) -> Self {
        let resonances = oscillators.iter().map(|oscillator| oscillator.resonances.len()).sum();
        let mut tally = VerdictCounts { resonances, ..VerdictCounts::default() };
        let known = oscillators.iter().flat_map(OscillatorEntry::curves);
        for (_, _, CurveFinding { coefficient, simulated }) in known {
            tally.all += 1;
            if let Some((_, digits)) = coefficient.compared() {
                tally.digits = Some(tally.digits.map_or(digits, |least| least.min(digits)));
            }
            tally.agreeing += usize::from(coefficient.verdict() == Verdict::Agree);
            tally.differing += usize::from(coefficient.verdict() == Verdict::Contradict);
            tally.predicted += usize::from(matches!(simulated, Simulated::AsPredicted(_)));
            tally.contradicted += usize::from(matches!(simulated, Simulated::Against(_)));
        }
        tally
    }

    /// The class of the colour for numbers of good and of bad results.
    pub(crate) fn tone(&self, good: &usize, bad: &usize) -> &'static str {
        match bad {
            0 if *good == self.all => "passed",
            0 => "neutral",
            _ => "failed",
        }
    }

    /// The verdict on the agreement of theorem and curve, with the class of its colour.
    pub(crate) fn agreement(&self) -> (&'static str, String) {
        let VerdictCounts { all, agreeing, differing, digits, .. } = *self;
        match digits {
            Some(digits) if agreeing == all => {
                ("passed", format!("theorem and curves agree to {digits} digits or more"))
            }
            _ if differing > 0 => ("failed", format!("theorem and curves disagree at {differing} of {all}")),
            _ => {
                let open = all - agreeing;
                (
                    "misprint",
                    format!("theorem and curves agree at {agreeing} of {all}; {open} not measurable"),
                )
            }
        }
    }

    /// The verdict on the simulation.
    pub(crate) fn simulation(&self) -> (&'static str, String) {
        let VerdictCounts { all, predicted, contradicted, .. } = *self;
        let tone = match (predicted == all, contradicted) {
            (true, _) => "passed",
            (false, 0) => "misprint",
            (false, _) => "failed",
        };
        (tone, format!("simulation as predicted at {predicted} of {all}"))
    }
}

#[cfg(test)]
mod tests {
    use grazing_continuation::bifurcation::Pair;
    use grazing_unfold::verification::Inconclusive;

    use super::*;
    use crate::sample::{MEASURED, NOT_MEASURED, SIDES, coefficient};

    const PREDICTED: Simulated = Simulated::AsPredicted(SIDES);

    /// The tally of a resonance whose SN curve agrees, with this result for the PD curve.
    fn tally((value, error): (f64, f64), simulated: Simulated) -> VerdictCounts {
        let mut entry = crate::sample::oscillator("a", "a");
        let good = coefficient(MEASURED.0, MEASURED.1);
        let finding = |coefficient, simulated| CurveFinding { coefficient, simulated };
        entry.resonances[0].curves.as_mut().expect("the theorem applies").findings = Pair {
            saddle_node: finding(good, PREDICTED),
            period_doubling: finding(coefficient(value, error), simulated),
        };
        entry.tally()
    }

    #[test]
    fn digits_that_agree_are_counted() {
        for (value, digits) in [(-12.5, 15), (-12.500_25, 4), (-12.6, 2), (12.5, 0)] {
            assert_eq!(coefficient(value, 1e-9).compared(), Some((value, digits)));
        }
        assert_eq!(coefficient(NOT_MEASURED.0, NOT_MEASURED.1).compared(), None);
    }

    #[test]
    fn a_verdict_is_good_only_if_every_coefficient_agrees_and_every_simulation_is_as_predicted() {
        let all_good = tally(MEASURED, PREDICTED);
        assert_eq!(
            all_good.agreement(),
            ("passed", "theorem and curves agree to 7 digits or more".to_owned())
        );
        assert_eq!(all_good.simulation(), ("passed", "simulation as predicted at 2 of 2".to_owned()));
        assert_eq!(tally(NOT_MEASURED, PREDICTED).agreement().0, "misprint");
        assert_eq!(tally((-13.0, 1e-5), PREDICTED).agreement().0, "failed");
        assert_eq!(
            tally(MEASURED, Simulated::Undecided(Inconclusive::NotMeasured)).simulation().0,
            "misprint"
        );
        assert_eq!(tally(MEASURED, Simulated::Against(SIDES)).simulation().0, "failed");
    }
}
