//! Beyond the paper: the branches on which the long-term behaviour of Figure 2 lies, where it is periodic.

use grazing_drawing::{Heading, draw_one_parameter};
use grazing_input::kind::{count, list};
use grazing_reproduction::figures::fig02::Figure2;
use grazing_reproduction::prelude::*;
use grazing_results::branches::OneParameter;
use grazing_results::place::briefly;
use grazing_results::{Names, span};
use grazing_unfold::one_parameter::{Sampling, Subject};

/// The greatest number of impacts: the equations have twice as many unknowns, and two more.
const MOST_IMPACTS: u32 = 24;

/// The greatest number of phase portraits.
const MOST_PORTRAITS: usize = 6;
/// Room beside the amplitudes at which orbits are shown, as a fraction of their range.
const MARGIN: f64 = 0.04;

keys! {
    /// Branches of solutions with several impacts in Figure 2.
    pub struct BeyondBranches {
        /// The most impacts of a solution whose branch is followed.
        impacts: u32 = count(2..=MOST_IMPACTS), "the most impacts must be a whole number from {} to {}";
        /// Amplitudes at which phase portraits are drawn, where Figure 2 has them.
        portraits: Vec<f64> = list(MOST_PORTRAITS),
            "the amplitudes of the phase portraits must be a list of at most 6 numbers; [] for none";
    }
}

impl FileSection for BeyondBranches {
    const NAME: &'static str = "beyond_branches";
    const REQUIREMENT: &'static str = "the table [beyond_branches] says which branches of solutions with several impacts are followed in Figure 2";
}

impl StudyFigure for BeyondBranches {
    const LABEL: &'static str = "fig:branches";
    const TITLE: Title<&'static str> = Title::beyond("the branches behind the dots of Figure 2");
    const TABLES: &'static [TablePlan] = &TablePlan::renamed(
        OneParameter::TABLES,
        [
            "beyond_branches",
            "beyond_branches_bifurcations",
            "beyond_branches_attractor",
            "beyond_branches_portraits",
        ],
    );
    const REMEDY: &'static str = Figure2::REMEDY;
    type Shown = OneParameter;

    fn compute(&self, study: &Study) -> Result<OneParameter, StudyError> {
        let figure = study.parameters.section::<Figure2>()?;
        let sampling = Sampling { impacts: self.impacts, ..figure.attractor.clone() };
        let [low, high] = figure.across.value;
        let inside = self.portraits.iter().filter(|across| (low..=high).contains(*across));
        let subjects: Vec<Subject> = inside.map(|&across| Subject { across, loops: None }).collect();
        let mut found = figure.cut(study)?.simulated(&sampling, &subjects, &*study.progress);
        let [low, high] = span(found.attractor.iter().map(|point| point.primary));
        if low < high {
            let margin = MARGIN * (high - low);
            found.frame.x = [low - margin, high + margin];
        }
        Ok(found.fitted())
    }

    fn draw(figure: &OneParameter, width: SheetWidth) -> Result<Sheet, DrawingError> {
        let heading = Heading {
            name: "beyond_branches",
            title: "The branches behind the dots of Figure 2",
            description: "Below: forcing amplitude across, x-value of the return map up; thick curves are stable, thin ones unstable. \
                          Branches of solutions with several impacts are named by their numbers of impacts and of forcing \
                          periods; dots are long-term forward orbits. Above: phase portraits with the wall.",
            names: &Names::of_the_paper(),
            tables: &[
                "beyond_branches_bifurcations",
                "beyond_branches",
                "beyond_branches_attractor",
                "beyond_branches_portraits",
            ],
        };
        draw_one_parameter(figure, &heading, false, width)
    }

    fn remarks(&self, _: &Study, shown: &OneParameter) -> Result<Remarks, StudyError> {
        let lost = |(numbers, amplitude, reason): &([u32; 2], f64, String)| {
            let of = briefly(*numbers);
            format!("a branch of {of} could not be followed beyond amplitude {amplitude:.5}: {reason}")
        };
        Ok(Remarks { notes: shown.broken.iter().map(lost).collect(), ..Remarks::default() })
    }
}
