//! The figures: a two-parameter diagram, and magnifications about its resonances.

use grazing_description::Description;
use grazing_drawing::{Diagram, DrawingError, Magnifications, SheetWidth, draw_diagram, draw_magnifications};
use grazing_reproduction::unfolded::Rows;
use grazing_results::Frame;
use grazing_results::plane::MagnifiedPanel;

use super::Analysis;

/// The files of the figures, if all magnifications find room on one sheet.
pub(super) const FILES: [&str; 2] = ["diagram.svg", "magnifications.svg"];

/// More sheets than a hundred would take some nine hundred resonances.
const MOST_SHEETS: usize = 100;

/// The file of a sheet of magnifications, if there are several numbered from 1.
fn sheet_name(number: usize, count: usize) -> String {
    if count == 1 { FILES[1].to_owned() } else { format!("magnifications-{number}.svg") }
}

/// All names that a sheet of magnifications can have.
pub(super) fn possible_names() -> impl Iterator<Item = String> {
    std::iter::once(sheet_name(1, 1)).chain((1..=MOST_SHEETS).map(|number| sheet_name(number, MOST_SHEETS)))
}

/// The figures as SVG with the names of their files.
pub(crate) fn figures(
    description: &Description,
    unfolded: &Analysis,
    rows: &Rows,
    width: SheetWidth,
) -> Result<Vec<(String, String)>, DrawingError> {
    let (primary, secondary) = (description.primary(), description.secondary());
    let panels = panels(unfolded);
    let axes = format!("{} across, {} up.", primary.name(), secondary.name());
    let diagram = Diagram {
        name: "diagram",
        title: &format!("{}: two-parameter bifurcation diagram", description.name()),
        description: &format!(
            "{axes} Grazing curve of the non-impacting solution; saddle-node, period-doubling and grazing bifurcations of \
             maximal periodic solutions; regions of stability in grey."
        ),
        names: &unfolded.axes.names,
        tables: ["points", "curves"],
        curves: &rows.curves,
        points: &rows.points,
        regions: &rows.regions,
        frame: Frame { x: primary.range(), y: secondary.range() },
        magnified: &panels,
        section: None,
    };
    let mut figures = vec![(FILES[0].to_owned(), draw_diagram(&diagram, width)?)];
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
    figures.extend(sheets.into_iter().zip(1..).map(|(svg, number)| (sheet_name(number, count), svg)));
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
