//! Oscillators from text files: what they are, and what the theorems, the curves and simulation say of them.

use crate::html::identifier;
use grazing_results::Table;

use crate::Figure;

/// An oscillator with all that was found out about it.
#[derive(Debug, Clone, PartialEq)]
pub struct OscillatorEntry {
    /// A short name that no other oscillator on the page has, as `duffing`; part of addresses.
    pub id: String,
    /// What it is called.
    pub name: String,
    /// The file it comes from, as it is to be named on the page.
    pub file: String,
    /// The path from the page to that file, if it is to be linked.
    pub link: Option<String>,
    /// Where it comes from: the paragraphs of the file's leading comment.
    pub about: Vec<String>,
    /// The force F(x, v, t), as the file has it.
    pub force: String,
    /// The forcing frequency, as the file has it.
    pub frequency: String,
    /// Φ(y, z) of the reset law, as the file has it.
    pub restitution: String,
    /// Ψ(y, z) of the reset law, as the file has it.
    pub duration: String,
    /// The constants with their values.
    pub constants: Vec<(String, f64)>,
    /// The primary parameter μ with its range.
    pub primary: (String, [f64; 2]),
    /// The secondary parameter η with its range.
    pub secondary: (String, [f64; 2]),
    /// The numbers of loops that were analysed.
    pub loops: Vec<u32>,
    /// The figures; their names and those of their tables need be unique in this oscillator only.
    pub figures: Vec<Figure>,
    /// The tables that are shown as such.
    pub tables: Vec<Table>,
    /// The resonant grazing bifurcations, in the order in which they were found.
    pub resonances: Vec<ResonanceEntry>,
    /// What could not be unfolded and why, in words: resonances that were seen and not located, curves that could not be
    /// followed.
    pub lost: Vec<String>,
    /// Where it is not decided whether solutions are stable, with the numbers of their loops, and why not: what is hatched in the figures.
    pub undecided: Vec<(u32, String)>,
    /// The files that were written, as paths from the page's folder: `diagram.svg`, `data/points.csv`. None of them need
    /// be there; those that are get links.
    pub files: Vec<String>,
}

/// A resonant grazing bifurcation.
#[derive(Debug, Clone, PartialEq)]
pub struct ResonanceEntry {
    /// Number of loops p.
    pub loops: u32,
    /// The integer n.
    pub n: u32,
    /// The primary parameter.
    pub primary: f64,
    /// The secondary parameter.
    pub secondary: f64,
    /// What is known of it.
    pub finding: Finding,
}

/// What is known of a resonant grazing bifurcation.
#[derive(Debug, Clone, PartialEq)]
pub enum Finding {
    /// A theorem applies; c_SN and c_PD.
    Unfolded(Box<[CoefficientEntry; 2]>),
    /// The theorem does not apply: the hypotheses that fail, with the values of their quantities.
    Silent(Vec<(String, f64)>),
}

/// What came of comparing something with the theorem.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Judgement {
    /// It is as the theorem says.
    For,
    /// It is otherwise, with the details.
    Against(String),
    /// That cannot be told, for a reason.
    Open(String),
}

/// A coefficient, c_SN or c_PD.
#[derive(Debug, Clone, PartialEq)]
pub struct CoefficientEntry {
    /// By the theorem.
    pub theorem: f64,
    /// Measured on the continued curve, with the number of digits that agree; nothing where it could not be.
    pub measured: Option<(f64, u32)>,
    /// Whether both agree within their errors.
    pub agreement: Judgement,
    /// Whether the simulated system does what the theorem predicts.
    pub simulation: Judgement,
}

/// How many of the coefficients came out how.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Tally {
    /// Coefficients.
    pub(crate) all: usize,
    /// Those that are measured as by the theorem, and those that are measured otherwise.
    pub(crate) agreeing: usize,
    pub(crate) differing: usize,
    /// The fewest digits that agree.
    pub(crate) digits: Option<u32>,
    /// Those at which simulation is as predicted, and those at which it is not.
    pub(crate) predicted: usize,
    pub(crate) contradicted: usize,
}

impl OscillatorEntry {
    /// The identifier of its part of the page.
    pub(crate) fn anchor(&self) -> String {
        identifier("oscillator", &self.id)
    }

    pub(crate) fn tally(&self) -> Tally {
        let mut tally = Tally::default();
        for coefficient in self.resonances.iter().flat_map(ResonanceEntry::coefficients) {
            tally.all += 1;
            if let Some((_, digits)) = coefficient.measured {
                tally.digits = Some(tally.digits.map_or(digits, |least| least.min(digits)));
            }
            match coefficient.agreement {
                Judgement::For => tally.agreeing += 1,
                Judgement::Against(_) => tally.differing += 1,
                Judgement::Open(_) => {}
            }
            match coefficient.simulation {
                Judgement::For => tally.predicted += 1,
                Judgement::Against(_) => tally.contradicted += 1,
                Judgement::Open(_) => {}
            }
        }
        tally
    }
}

impl ResonanceEntry {
    /// c_SN and c_PD, if a theorem gives them.
    pub(crate) fn coefficients(&self) -> &[CoefficientEntry] {
        match &self.finding {
            Finding::Unfolded(coefficients) => coefficients.as_slice(),
            Finding::Silent(_) => &[],
        }
    }
}

impl Tally {
    /// The verdict on the agreement of theorem and curve, with the class of its colour.
    pub(crate) fn agreement(&self) -> (&'static str, String) {
        let Tally { all, agreeing, differing, digits, .. } = *self;
        match digits {
            Some(digits) if agreeing == all => {
                ("passed", format!("theorem and curves agree to {digits} digits or more"))
            }
            _ if differing > 0 => {
                ("failed", format!("theorem and curves contradict at {differing} of {all}"))
            }
            _ => {
                let open = all - agreeing;
                (
                    "misprint",
                    format!("theorem and curves agree at {agreeing} of {all}, {open} not measurable"),
                )
            }
        }
    }

    /// The verdict on the simulation.
    pub(crate) fn simulation(&self) -> (&'static str, String) {
        let Tally { all, predicted, contradicted, .. } = *self;
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
    use super::*;

    fn resonance(agreement: [Judgement; 2], simulation: [Judgement; 2]) -> ResonanceEntry {
        let entry = |(agreement, simulation): (Judgement, Judgement)| {
            let measured = (agreement == Judgement::For).then_some((1.0, 7));
            CoefficientEntry { theorem: 1.0, measured, agreement, simulation }
        };
        let mut both = agreement.into_iter().zip(simulation).map(entry);
        let finding = Finding::Unfolded(Box::new([(); 2].map(|()| both.next().expect("there are two"))));
        ResonanceEntry { loops: 1, n: 1, primary: 0.0, secondary: 0.0, finding }
    }

    fn tally(resonances: Vec<ResonanceEntry>) -> Tally {
        let mut entry = crate::sample::oscillator("a", "a");
        entry.resonances = resonances;
        entry.tally()
    }

    #[test]
    fn a_verdict_is_good_only_if_every_coefficient_agrees_and_every_simulation_is_as_predicted() {
        use Judgement::{Against, For, Open};
        let all_good = tally(vec![resonance([For, For], [For, For])]);
        assert_eq!(
            all_good.agreement(),
            ("passed", "theorem and curves agree to 7 digits or more".to_owned())
        );
        assert_eq!(all_good.simulation(), ("passed", "simulation as predicted at 2 of 2".to_owned()));
        for (second, tone) in [(Open(String::new()), "misprint"), (Against(String::new()), "failed")] {
            assert_eq!(tally(vec![resonance([For, second.clone()], [For, For])]).agreement().0, tone);
            assert_eq!(tally(vec![resonance([For, For], [For, second])]).simulation().0, tone);
        }
    }
}
