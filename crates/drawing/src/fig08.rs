//! Figure 8: magnifications about three resonances, with the quadratic approximations.

use polars::prelude::DataFrame;

use crate::DrawingError;
use crate::axes::Panel;
use crate::canvas::Canvas;
use crate::fig07::{Magnified, MarkedPoint, panel_letter, read_points};
use crate::frames::{Table, runs};
use crate::kinds::{Kind, Region, read_regions};
use crate::labels::Labels;
use crate::sheet::{Bounds, Spot};
use crate::style::{BLACK, LABEL_SIZE, MPS_AREA, NON_IMPACTING_AREA, SheetWidth, TICK_SIZE, approximation};
use crate::svg_backend::Anchor;
use crate::ticks::significant;

/// What Figure 8 shows.
///
/// Paper: Figure 8, fig:Y.
#[derive(Debug, Clone, Copy)]
pub struct Figure08<'a> {
    /// Columns panel, kind (graz, SN, PD, GZ), source (continuation, quadratic), arc, omega, amplitude. Rows that
    /// follow each other with equal panel, kind, source and arc are one curve.
    pub curves: &'a DataFrame,
    /// The points of Figure 7.
    pub points: &'a DataFrame,
    /// The regions of Figure 7.
    pub regions: &'a DataFrame,
    /// Columns panel, p, c_sn, c_pd.
    pub coefficients: &'a DataFrame,
    /// The windows, panels 1, 2 and 3 in order.
    pub panels: &'a [Magnified],
}

struct Curve {
    panel: i64,
    kind: Kind,
    approximate: bool,
    points: Vec<(f64, f64)>,
}

/// The coefficients printed over a panel.
struct Coefficients {
    panel: i64,
    p: i64,
    saddle_node: f64,
    period_doubling: f64,
}

const PANELS: usize = 3;
/// Width in the paper.
const WIDTH_MM: f64 = 156.0;
/// Sheets at least this wide have the panels side by side; on others they stand one above the other.
const SIDE_BY_SIDE_MM: f64 = 120.0;
/// Height of a panel with its heading, numbers and axis title, side by side and one above the other.
const HEIGHT_MM: f64 = 63.0;
const STACKED_HEIGHT_MM: f64 = 62.0;
/// Room left of each panel for its numbers, in points; the first of a row has the axis title too.
const LEFT: f64 = 31.0;
const TITLE_ROOM: f64 = 13.0;
/// Room above a panel for its heading and below for numbers and axis title, in points.
const TOP: f64 = 27.0;
const BOTTOM: f64 = 30.0;
/// Curves shorter than this on the sheet (points) stay without a label.
const LABELLED_LENGTH: f64 = 24.0;

/// Draws Figure 8.
///
/// # Errors
/// [`DrawingError`] if a column is missing or of the wrong type, a kind is unknown, a window is empty or their
/// number is not three.
pub fn draw_fig08(figure: &Figure08<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    compose(figure, width)?.finish(
        "fig08",
        "Magnifications about three resonant grazing bifurcations",
        "Forcing amplitude across, forcing frequency up. Dashed: the quadratic approximations to the saddle-node and \
         period-doubling curves.",
    )
}

pub(crate) fn compose(figure: &Figure08<'_>, width: SheetWidth) -> Result<Canvas, DrawingError> {
    if figure.panels.len() != PANELS {
        let found = figure.panels.len();
        return Err(DrawingError::PanelCount { figure: "fig08", wanted: "three panels", found });
    }
    let curves = read_curves(Table::new("fig08_curves", figure.curves))?;
    let regions = read_regions(Table::new("fig07_regions", figure.regions))?;
    let markers = read_points(Table::new("fig07_points", figure.points))?;
    let coefficients = read_coefficients(Table::new("fig08_coefficients", figure.coefficients))?;

    let width = width.mm(WIDTH_MM);
    let columns = if width >= SIDE_BY_SIDE_MM { PANELS } else { 1 };
    let (rows, row_mm) = if columns == 1 { (PANELS, STACKED_HEIGHT_MM) } else { (1, HEIGHT_MM) };
    let canvas = Canvas::new(width, rows as f64 * row_mm)?;
    let pitch = (canvas.width - TITLE_ROOM - 6.0) / columns as f64;
    let row_pitch = canvas.height / rows as f64;
    for (place, magnified) in figure.panels.iter().enumerate() {
        let window = magnified.window.checked("a panel of fig08")?;
        let (column, row) = (place % columns, place / columns);
        let left = TITLE_ROOM + pitch * column as f64 + LEFT;
        let right = TITLE_ROOM + pitch * (column + 1) as f64 - 3.0;
        let above = row_pitch * row as f64;
        let bounds = Bounds { left, top: above + TOP, right, bottom: above + row_pitch - BOTTOM };
        let panel =
            Panel::new(&canvas, window, bounds).showing(&["fig08_curves"]).only("panel", magnified.panel);
        let number = i64::from(magnified.panel);
        let own: Vec<&Curve> = curves.iter().filter(|c| c.panel == number).collect();
        draw_panel(&panel, &own, &regions, &markers)?;
        panel.axes(r"$\mathcal{A}$", if column == 0 { r"$\omega$" } else { "" })?;
        let own = coefficients.iter().find(|c| c.panel == number);
        draw_heading(&canvas, &bounds, magnified.panel, own)?;
    }
    Ok(canvas)
}

fn draw_panel(
    panel: &Panel<'_>,
    curves: &[&Curve],
    regions: &[Region],
    markers: &[MarkedPoint],
) -> Result<(), DrawingError> {
    let mut labels = Labels::new(panel.canvas, panel.bounds);
    for region in regions {
        panel.fill(&region.vertices, if region.impacting { MPS_AREA } else { NON_IMPACTING_AREA })?;
    }
    let mut drawn: Vec<(Kind, Vec<Spot>)> = Vec::new();
    for curve in curves {
        let pen = if curve.approximate { approximation(curve.kind.pen()) } else { curve.kind.pen() };
        for piece in panel.line(&curve.points, pen)? {
            if curve.approximate {
                labels.placer.keep_off_nameless(&piece);
            } else {
                labels.placer.keep_off(&piece);
                drawn.push((curve.kind, piece));
            }
        }
    }
    for (point, marker) in markers {
        if let Some(taken) = panel.marker(*point, *marker)? {
            labels.placer.block(taken.grown(0.5));
        }
    }
    labels.name_curves(drawn, LABELLED_LENGTH)?;
    labels.draw()
}

/// Panel letter and p on the first line above the panel, the coefficients on the second.
fn draw_heading(
    canvas: &Canvas,
    bounds: &Bounds,
    panel: u32,
    coefficients: Option<&Coefficients>,
) -> Result<(), DrawingError> {
    let first = (bounds.left, bounds.top - 16.0);
    let letter = panel_letter(panel);
    let Some(Coefficients { p, saddle_node, period_doubling, .. }) = coefficients else {
        canvas.text(first, &letter, LABEL_SIZE, Anchor::Start, BLACK)?;
        return Ok(());
    };
    canvas.text(first, &format!("{letter}  $p={p}$"), LABEL_SIZE, Anchor::Start, BLACK)?;
    let (sn, pd) = (significant(*saddle_node, 4), significant(*period_doubling, 4));
    let text = format!(r"$c_{{\mathrm{{SN,}}{p}}}={sn}$,  $c_{{\mathrm{{PD,}}{p}}}={pd}$");
    canvas.text((bounds.left, bounds.top - 5.0), &text, TICK_SIZE, Anchor::Start, BLACK)?;
    Ok(())
}

fn read_curves(table: Table<'_>) -> Result<Vec<Curve>, DrawingError> {
    let (panel, arc) = (table.integers("panel")?, table.integers("arc")?);
    let kinds = table.words("kind", Kind::KNOWN, Kind::parse)?;
    let approximate = table.words("source", "continuation, quadratic", |word| match word {
        "continuation" => Some(false),
        "quadratic" => Some(true),
        _ => None,
    })?;
    let (omega, amplitude) = (table.numbers("omega")?, table.numbers("amplitude")?);
    let keys: Vec<_> = (0..kinds.len()).map(|i| (panel[i], kinds[i], approximate[i], arc[i])).collect();
    let mut curves: Vec<Curve> = runs(&keys)
        .into_iter()
        .map(|rows| Curve {
            panel: panel[rows.start],
            kind: kinds[rows.start],
            approximate: approximate[rows.start],
            points: rows.map(|i| (amplitude[i], omega[i])).collect(),
        })
        .collect();
    // The wide grazing curve lies lowest, approximations on top of the curves they approximate.
    curves.sort_by_key(|curve| (curve.kind != Kind::Graz, curve.approximate));
    Ok(curves)
}

fn read_coefficients(table: Table<'_>) -> Result<Vec<Coefficients>, DrawingError> {
    let (panel, p) = (table.integers("panel")?, table.integers("p")?);
    let (sn, pd) = (table.numbers("c_sn")?, table.numbers("c_pd")?);
    let rows = 0..panel.len();
    Ok(rows
        .map(|i| Coefficients { panel: panel[i], p: p[i], saddle_node: sn[i], period_doubling: pd[i] })
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    fn with_sample<T>(test: impl Fn(&Figure08<'_>) -> T) -> T {
        let (curves, coefficients) = (samples::fig08_curves(), samples::fig08_coefficients());
        let (points, regions) = (samples::fig07_points(), samples::fig07_regions());
        test(&Figure08 {
            curves: &curves,
            points: &points,
            regions: &regions,
            coefficients: &coefficients,
            panels: &samples::magnified(),
        })
    }

    #[test]
    fn no_two_labels_overlap_and_none_leaves_the_sheet_however_wide_it_is() {
        for width in [SheetWidth::OneColumn, SheetWidth::Paper, SheetWidth::TwoColumns] {
            let misplaced = with_sample(|figure| compose(figure, width).unwrap().misplaced_texts());
            assert!(misplaced.is_empty(), "{width:?}: {misplaced:?}");
        }
    }

    #[test]
    fn panels_stand_one_above_the_other_in_one_column() {
        let size =
            |width| with_sample(|figure| compose(figure, width).map(|sheet| (sheet.width, sheet.height)));
        let (one, paper) = (size(SheetWidth::OneColumn).unwrap(), size(SheetWidth::Paper).unwrap());
        assert!(one.1 > 2.0 * one.0 && paper.0 > 2.0 * paper.1, "{one:?} {paper:?}");
    }

    #[test]
    fn coefficients_are_printed_to_four_figures() {
        let svg = with_sample(|figure| draw_fig08(figure, SheetWidth::Paper).unwrap());
        for number in ["−123.5", "98.77", "−9876", "1234"] {
            assert!(svg.contains(number), "{number}");
        }
    }

    #[test]
    fn only_approximations_are_plainly_dashed() {
        let svg = with_sample(|figure| draw_fig08(figure, SheetWidth::Paper).unwrap());
        // Two approximations in each of three panels.
        assert_eq!(svg.matches("stroke-dasharray=\"3.2 2\"").count(), 6);
    }

    #[test]
    fn another_number_of_panels_is_an_error() {
        with_sample(|figure| {
            let error = draw_fig08(&Figure08 { panels: &figure.panels[..2], ..*figure }, SheetWidth::Paper)
                .unwrap_err();
            assert!(matches!(error, DrawingError::PanelCount { found: 2, .. }));
        });
    }
}
