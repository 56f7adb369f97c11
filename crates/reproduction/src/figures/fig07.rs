//! Figure 7 (fig:G): the two-parameter bifurcation diagram of the paper's oscillator.

pub(crate) mod diagram;

use grazing_drawing::{Heading, draw_diagram};
use grazing_results::plane::{DiagramLine, PlaneDiagram};
use grazing_results::{Names, brief};
use grazing_unfold::regions::{Doubt, Region};

use super::fig02::Figure2;
use super::fig08::Figure8;
use crate::figure::prelude::*;
use grazing_unfold::plane;

pub use diagram::Figure7;
use diagram::not_followed;

impl StudyFigure for Figure7 {
    const LABEL: &'static str = "fig:G";
    const TITLE: Title<&'static str> = Title::figure(7, "two-parameter bifurcation diagram");
    const TABLES: &'static [TablePlan] =
        &TablePlan::renamed(PlaneDiagram::TABLES, ["fig07_curves", "fig07_points", "fig07_regions"]);
    const REMEDY: &'static str = "fig07.frequency, fig07.amplitude or fig07.loops";
    type Shown = PlaneDiagram;

    /// The diagram, with the line of Figure 2 and the panels of Figure 8, as far as these can be
    /// computed.
    fn compute(&self, study: &Study) -> Result<PlaneDiagram, StudyError> {
        let panels = study.parameters.section::<Figure8>().map_err(StudyError::from);
        let panels = panels.and_then(|figure| figure.panels(study)).unwrap_or_default();
        let section = study.parameters.section::<Figure2>().ok().map(|fig02| DiagramLine {
            ends: fig02.across.value.map(|amplitude| (amplitude, fig02.frequency)),
            name: "Fig. 2".to_owned(),
            thin: false,
        });
        let sections = section.into_iter().collect();
        Ok(PlaneDiagram { magnified: panels, sections, ..plane::rows(study.diagram()?, None) })
    }

    fn draw(diagram: &PlaneDiagram, width: SheetWidth) -> Result<Sheet, DrawingError> {
        let heading = Heading {
            name: "fig07",
            title: "Two-parameter bifurcation diagram",
            description: "Forcing amplitude across, forcing frequency up. Grazing curve of the non-impacting solution; \
             saddle-node, period-doubling and grazing bifurcations of maximal periodic solutions; regions of stability \
             in grey. Triangles: resonances; discs: other codimension-two points. Rectangles: the panels of Figure~8; thick \
             line: section shown in Figure~2.",
            names: &Names::of_the_paper(),
            tables: &["fig07_points", "fig07_curves"],
        };
        draw_diagram(diagram, &heading, width)
    }

    /// Remarks on undecided regions, resonances that could not be located, and curves that could not be
    /// followed.
    fn remarks(&self, study: &Study, _: &PlaneDiagram) -> Result<Remarks, StudyError> {
        let diagram = study.diagram()?;
        let regions = diagram.regions.iter();
        let doubts: Vec<_> = regions.filter_map(|region| Some((region, region.doubt.as_ref()?))).collect();
        let doubtful = doubts.chunk_by(|(a, _), (b, _)| a.loops == b.loops).map(undecided);
        let thin = diagram.regions.iter().filter(|region| region.is_thin(diagram.scope.window)).map(thin);
        let notes = doubtful.chain(thin).collect();
        let lost = diagram.not_unfolded.iter().map(|lost| not_followed(&lost.name(), &lost.reason));
        Ok(Remarks { notes, gaps: study.unlocated()?.into_iter().chain(lost).collect() })
    }

    fn constants(study: &Study) -> Result<Vec<(&'static str, f64)>, ParameterError> {
        study.oscillator_constants()
    }
}

/// A remark on a region too thin to be visible.
fn thin(region: &Region) -> String {
    let [from, to] = corners(region);
    format!(
        "p = {}: a region thinner than 1e-4 of the ranges, from {from} to {to}, is in fig07_regions.csv",
        region.loops
    )
}

/// The least and the greatest parameters of a region.
fn corners(region: &Region) -> [String; 2] {
    region.extent().map(|[amplitude, frequency]| {
        format!("amplitude {}, frequency {}", brief(amplitude, 6), brief(frequency, 6))
    })
}

/// A remark on the undecided regions of one p.
fn undecided(doubts: &[(&Region, &Doubt)]) -> String {
    let (first, doubt) = doubts[0];
    let [from, to] = corners(first);
    let more = match doubts.len() - 1 {
        0 => String::new(),
        more => format!("; and in {more} more places, see fig07_regions.csv"),
    };
    format!("p = {} is undecided, and hatched, from {from} to {to}: {doubt}{more}", first.loops)
}
