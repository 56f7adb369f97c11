//! The figures: a two-parameter diagram, and magnifications about its resonances.

use grazing_description::Description;
use grazing_drawing::{
    DrawingError, Magnifications, PlaneDiagram, Section, SheetWidth, draw_diagram, draw_magnifications,
    draw_one_parameter,
};
use grazing_reproduction::unfolded::Rows;
use grazing_results::branches::OneParameter;
use grazing_results::plane::MagnifiedPanel;
use grazing_results::{Frame, brief};

use super::Analysis;

/// The files of the figures, if all magnifications find room on one sheet.
pub(super) const FILES: [&str; 2] = ["diagram.svg", "magnifications.svg"];

/// More sheets than a hundred would take some nine hundred resonances.
const MOST_SHEETS: usize = 100;

/// The file of a sheet of magnifications, if there are several numbered from 1.
fn sheet_name(number: usize, count: usize) -> String {
    if count == 1 { FILES[1].to_owned() } else { format!("magnifications-{number}.svg") }
}

/// The file of a one-parameter diagram.
fn one_parameter_name(number: u32) -> String {
    format!("diagram-{number}.svg")
}

/// All names that a sheet of magnifications or a one-parameter diagram can have.
pub(super) fn possible_names() -> impl Iterator<Item = String> {
    let magnifications = (1..=MOST_SHEETS).map(|number| sheet_name(number, MOST_SHEETS));
    let diagrams = (1..=Description::MOST_DIAGRAMS as u32).map(one_parameter_name);
    std::iter::once(sheet_name(1, 1)).chain(magnifications).chain(diagrams)
}

/// A figure.
pub(crate) struct Sheet {
    /// The name of its file.
    pub(crate) file: String,
    pub(crate) svg: String,
    /// What it shows, in a few words.
    pub(crate) title: String,
    pub(crate) kind: SheetKind,
}

impl Sheet {
    /// The name of its file without the ending.
    pub(crate) fn name(&self) -> &str {
        self.file.trim_end_matches(".svg")
    }
}

/// What a figure shows.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum SheetKind {
    TwoParameters,
    Magnifications,
    /// The one-parameter diagram of this number.
    OneParameter(u32),
}

/// What a one-parameter diagram is of, as `A from 0.26 to 0.34 at omega = 0.854`.
pub(crate) fn of_one_parameter(description: &Description, diagram: &OneParameter) -> String {
    let names = [description.primary().name(), description.secondary().name()];
    let [across, held] = diagram.exchanged(names);
    let [low, high] = diagram.frame.x.map(|end| brief(end, 6));
    format!("{across} from {low} to {high} at {held} = {}", brief(diagram.at, 6))
}

/// The figures.
pub(crate) fn figures(
    description: &Description,
    unfolded: &Analysis,
    rows: &Rows,
    width: SheetWidth,
) -> Result<Vec<Sheet>, DrawingError> {
    let (primary, secondary) = (description.primary(), description.secondary());
    let panels = panels(unfolded);
    let section = |diagram: &OneParameter| {
        let place = |across: f64| diagram.exchanged([across, diagram.at]).into();
        let name = format!("diagram {}", diagram.diagram);
        Section { ends: diagram.frame.x.map(place), name, thin: true }
    };
    let sections: Vec<Section> = unfolded.diagrams.iter().map(section).collect();
    let axes = format!("{} across, {} up.", primary.name(), secondary.name());
    let diagram = PlaneDiagram {
        name: "diagram",
        title: &format!("{}: two-parameter bifurcation diagram", description.name()),
        description: &format!(
            "{axes} Grazing curve of the non-impacting solution; saddle-node, period-doubling and grazing bifurcations of \
             maximal periodic solutions; regions of stability in grey. Triangles: resonances; discs: other codimension-two \
             points; rectangles: magnifications."
        ),
        names: &unfolded.axes.names,
        tables: ["points", "curves"],
        curves: &rows.curves,
        points: &rows.points,
        regions: &rows.regions,
        frame: Frame { x: primary.range(), y: secondary.range() },
        magnified: &panels,
        sections: &sections,
    };
    let mut figures = vec![Sheet {
        file: FILES[0].to_owned(),
        svg: draw_diagram(&diagram, width)?,
        title: "two-parameter bifurcation diagram".to_owned(),
        kind: SheetKind::TwoParameters,
    }];
    let magnifications = Magnifications {
        name: "magnifications",
        title: &format!("{}: magnifications about resonant grazing bifurcations", description.name()),
        description: &format!(
            "{axes} Dashed: the quadratic approximations to the saddle-node and period-doubling curves."
        ),
        names: &unfolded.axes.names,
        table: "magnifications",
        curves: &rows.magnifications,
        points: &rows.points,
        regions: &rows.regions,
        panels: &panels,
    };
    let sheets = draw_magnifications(&magnifications, width)?;
    let count = sheets.len();
    figures.extend(sheets.into_iter().zip(1..).map(|(svg, number)| {
        let title = "magnifications about the resonances";
        let title = if count == 1 { title.to_owned() } else { format!("{title}, sheet {number} of {count}") };
        Sheet { file: sheet_name(number, count), svg, title, kind: SheetKind::Magnifications }
    }));
    for diagram in &unfolded.diagrams {
        let shown = format!("one-parameter bifurcation diagram, {}", of_one_parameter(description, diagram));
        let title = format!("{}: {shown}", description.name());
        figures.push(Sheet {
            file: one_parameter_name(diagram.diagram),
            svg: draw_one_parameter(diagram, &unfolded.axes.names, &title, width)?,
            title: shown,
            kind: SheetKind::OneParameter(diagram.diagram),
        });
    }
    Ok(figures)
}

/// A panel for each resonance whose curves are there, numbered as in `magnifications.csv`.
fn panels(unfolded: &Analysis) -> Vec<MagnifiedPanel> {
    let wide = |[low, high]: [f64; 2]| low.is_finite() && high.is_finite() && low < high;
    let numbered = (1..).zip(&unfolded.resonances);
    let shown = numbered
        .filter(|(_, at)| !at.magnified.is_empty() && wide(at.window.primary) && wide(at.window.secondary));
    shown
        .map(|(panel, at)| {
            let coefficients = at.coefficients.map(|coefficient| coefficient.theorem.value);
            let (frame, n) = (at.window.into(), Some(at.n));
            MagnifiedPanel { panel, frame, loops: at.loops, n, coefficients }
        })
        .collect()
}
