//! Figure 7: the two-parameter bifurcation diagram.

use polars::prelude::DataFrame;

use crate::DrawingError;
use crate::axes::{Marker, Panel};
use crate::canvas::Canvas;
use crate::clip::Window;
use crate::frames::{Table, runs};
use crate::kinds::{Kind, read_regions};
use crate::labels::{Labels, Wanted};
use crate::sheet::{Bounds, Spot, area};
use crate::style::{
    BLACK, LABEL_SIZE, MAGNIFIED, MAGNIFIED_TEXT, MPS_AREA, NON_IMPACTING_AREA, SECTION, SMALL_LABEL_SIZE,
    SheetWidth,
};

/// A part of the diagram that Figure 8 magnifies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Magnified {
    /// Number of the panel of Figure 8, from 1.
    pub panel: u32,
    /// Amplitudes (horizontal) and frequencies (vertical) shown there, dimensionless.
    pub window: Window,
}

/// The line along which Figure 2 runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// Forcing frequency, dimensionless.
    pub omega: f64,
    /// Least and greatest forcing amplitude, dimensionless.
    pub amplitude: [f64; 2],
}

/// What Figure 7 shows.
///
/// Paper: Figure 7, fig:G.
#[derive(Debug, Clone, Copy)]
pub struct Figure07<'a> {
    /// Columns kind (graz, SN, PD, GZ), p, n, arc, omega, amplitude, stable, admissible. Rows that follow each other
    /// with equal kind, p, n and arc are one curve; inadmissible rows are not drawn, nor are unstable ones of GZ.
    pub curves: &'a DataFrame,
    /// Columns kind (resonance, or any other word for another codimension-two point), omega, amplitude.
    pub points: &'a DataFrame,
    /// Columns region, kind (non-impacting, mps), p, omega, amplitude: vertices of polygons.
    pub regions: &'a DataFrame,
    /// Amplitudes (horizontal) and frequencies (vertical) shown.
    pub window: Window,
    /// The rectangles of Figure 8.
    pub magnified: &'a [Magnified],
    /// The line of Figure 2.
    pub section: Section,
}

struct Curve {
    kind: Kind,
    points: Vec<(f64, f64)>,
}

/// Width in the paper.
const WIDTH_MM: f64 = 120.0;
/// Height as a share of the width, up to the most that leaves room for a caption and text on the page.
const HEIGHT_SHARE: f64 = 0.8;
const MOST_HEIGHT_MM: f64 = 118.0;
/// On narrower sheets the diagram is taller than this share says, so that its labels find room.
const LEAST_HEIGHT_MM: f64 = 78.0;
/// Curves shorter than this on the sheet (points) stay without a label.
const LABELLED_LENGTH: f64 = 42.0;

/// Draws Figure 7.
///
/// # Errors
/// [`DrawingError`] if a column is missing or of the wrong type, a kind is unknown or a window is empty.
pub fn draw_fig07(figure: &Figure07<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    compose(figure, width)?.finish(
        "fig07",
        "Two-parameter bifurcation diagram",
        "Forcing amplitude across, forcing frequency up. Grazing curve of the non-impacting solution; saddle-node, \
         period-doubling and grazing bifurcations of maximal periodic solutions; regions of stability in grey.",
    )
}

pub(crate) fn compose(figure: &Figure07<'_>, width: SheetWidth) -> Result<Canvas, DrawingError> {
    let window = figure.window.checked("fig07")?;
    for magnified in figure.magnified {
        magnified.window.checked("a rectangle of fig07")?;
    }
    let curves = read_curves(Table::new("fig07_curves", figure.curves))?;
    let regions = read_regions(Table::new("fig07_regions", figure.regions))?;
    let markers = read_points(Table::new("fig07_points", figure.points))?;

    let width = width.mm(WIDTH_MM);
    let canvas = Canvas::new(width, (HEIGHT_SHARE * width).clamp(LEAST_HEIGHT_MM, MOST_HEIGHT_MM))?;
    let bounds = Bounds { left: 35.0, top: 5.0, right: canvas.width - 8.0, bottom: canvas.height - 30.0 };
    let panel = Panel::new(&canvas, window, bounds).showing(&["fig07_points", "fig07_curves"]);
    let mut labels = Labels::new(&canvas, bounds);

    let mut shapes: Vec<(i64, Vec<Spot>)> = Vec::new();
    for region in &regions {
        let paint = if region.impacting { MPS_AREA } else { NON_IMPACTING_AREA };
        let shape = panel.fill(&region.vertices, paint)?;
        if region.impacting && !shape.is_empty() {
            shapes.push((region.p, shape));
        }
    }
    let mut drawn: Vec<(Kind, Vec<Spot>)> = Vec::new();
    for curve in &curves {
        for piece in panel.line(&curve.points, curve.kind.pen())? {
            labels.placer.keep_off(&piece);
            drawn.push((curve.kind, piece));
        }
    }
    let section: Vec<(f64, f64)> =
        figure.section.amplitude.iter().map(|&a| (a, figure.section.omega)).collect();
    let section_pieces = panel.line(&section, SECTION)?;
    section_pieces.iter().for_each(|piece| labels.placer.keep_off(piece));
    for (point, marker) in &markers {
        if let Some(taken) = panel.marker(*point, *marker)? {
            labels.placer.block(taken.grown(0.5));
        }
    }
    let mut boxes = Vec::new();
    for magnified in figure.magnified {
        boxes.push((magnified.panel, rectangle(&panel, &magnified.window, &mut labels)?));
    }
    panel.axes(r"$\mathcal{A}$", r"$\omega$")?;

    for (number, outline) in &boxes {
        let reach = 0.5 * (outline.right - outline.left).min(outline.bottom - outline.top);
        let Bounds { left, top, right, bottom } = *outline;
        // A small rectangle among many curves is named at the first corner where there is room.
        let corners =
            [(left, bottom), (left, top), (right, top), (right, bottom)].map(|corner| (corner, 1.0));
        let letter = panel_letter(*number);
        for (spot, clearance) in [(outline.centre(), reach + 1.0)].into_iter().chain(corners) {
            if labels.add(&letter, SMALL_LABEL_SIZE, MAGNIFIED_TEXT, &Wanted::Around(spot, clearance))? {
                break;
            }
        }
    }
    for piece in &section_pieces {
        if let Some(&end) = piece.last() {
            labels.add("Fig. 2", SMALL_LABEL_SIZE, BLACK, &Wanted::Around(end, 2.5))?;
        }
    }
    for (p, shape) in by_area(&shapes) {
        let text = format!("$p={p}$");
        let inside = labels.add(&text, LABEL_SIZE, BLACK, &Wanted::Within(shape))?
            || labels.add(&text, SMALL_LABEL_SIZE, BLACK, &Wanted::Within(shape))?;
        if !inside && let Some(spot) = labels.placer.deep_inside(shape) {
            labels.add(&text, SMALL_LABEL_SIZE, BLACK, &Wanted::Around(spot, 1.0))?;
        }
    }
    labels.name_curves(drawn, LABELLED_LENGTH)?;
    labels.draw()?;
    drop(panel);
    Ok(canvas)
}

/// The letter by which the figures name a panel: (a) for the first.
pub(crate) fn panel_letter(number: u32) -> String {
    let letter = char::from_u32(u32::from('a') + number.saturating_sub(1)).unwrap_or('?');
    format!("({letter})")
}

fn rectangle(panel: &Panel<'_>, window: &Window, labels: &mut Labels<'_>) -> Result<Bounds, DrawingError> {
    let [[left, right], [low, high]] = [window.x, window.y];
    let corners = [(left, low), (right, low), (right, high), (left, high), (left, low)];
    for piece in panel.line(&corners, MAGNIFIED)? {
        labels.placer.keep_off(&piece);
    }
    let (a, b) = (panel.spot((left, high)), panel.spot((right, low)));
    let outline = Bounds { left: a.0, top: a.1, right: b.0, bottom: b.1 };
    Ok(outline)
}

/// Largest first; equal areas keep their order.
fn by_area(shapes: &[(i64, Vec<Spot>)]) -> Vec<(i64, &[Spot])> {
    let mut sorted: Vec<(i64, &[Spot])> = shapes.iter().map(|(p, shape)| (*p, shape.as_slice())).collect();
    sorted.sort_by(|a, b| area(b.1).total_cmp(&area(a.1)));
    sorted
}

fn read_curves(table: Table<'_>) -> Result<Vec<Curve>, DrawingError> {
    let kinds = table.words("kind", Kind::KNOWN, Kind::parse)?;
    let (p, n, arc) = (table.integers("p")?, table.integers("n")?, table.integers("arc")?);
    let (omega, amplitude) = (table.numbers("omega")?, table.numbers("amplitude")?);
    let (stable, admissible) = (table.flags("stable")?, table.flags("admissible")?);
    let keys: Vec<_> = (0..kinds.len()).map(|i| (kinds[i], p[i], n[i], arc[i])).collect();
    let curves = runs(&keys).into_iter().map(|rows| {
        let (first, last) = (rows.start, rows.end - 1);
        let points = rows.map(|i| {
            // At an end of a GZ curve, a codimension-two point, stability is marginal and its flag a toss-up.
            let shown = admissible[i] && (kinds[i] != Kind::Grazing || stable[i] || i == first || i == last);
            if shown { (amplitude[i], omega[i]) } else { (f64::NAN, f64::NAN) }
        });
        Curve { kind: kinds[first], points: points.collect() }
    });
    let mut curves: Vec<Curve> = curves.collect();
    // The wide grazing curve lies below the others.
    curves.sort_by_key(|curve| curve.kind != Kind::Graz);
    Ok(curves)
}

/// A codimension-two point (amplitude, omega) and its marker.
pub(crate) type MarkedPoint = ((f64, f64), Marker);

/// Triangles for resonances, discs for all other points.
pub(crate) fn read_points(table: Table<'_>) -> Result<Vec<MarkedPoint>, DrawingError> {
    let markers = table.words("kind", "any word", |word| {
        Some(if word == "resonance" { Marker::Triangle } else { Marker::Disc })
    })?;
    let (omega, amplitude) = (table.numbers("omega")?, table.numbers("amplitude")?);
    let mut points: Vec<_> =
        markers.into_iter().enumerate().map(|(i, marker)| ((amplitude[i], omega[i]), marker)).collect();
    points.sort_by_key(|(_, marker)| *marker == Marker::Triangle);
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    fn with_sample<T>(test: impl Fn(&Figure07<'_>) -> T) -> T {
        let (curves, points, regions) =
            (samples::fig07_curves(), samples::fig07_points(), samples::fig07_regions());
        test(&Figure07 {
            curves: &curves,
            points: &points,
            regions: &regions,
            window: samples::WINDOW,
            magnified: &samples::magnified(),
            section: samples::SECTION,
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
    fn all_things_of_the_caption_are_labelled() {
        let svg = with_sample(|figure| draw_fig07(figure, SheetWidth::Paper).unwrap());
        for label in [">SN<", ">PD<", ">GZ<", ">Fig. 2<", ">(a)<", ">(b)<", ">(c)<", ">graz</tspan>"] {
            assert!(svg.contains(label), "{label}");
        }
        for p in 1..=3 {
            assert!(svg.contains(&format!(">p</tspan>\u{2009}=\u{2009}{p}<")), "p = {p}");
        }
    }

    #[test]
    fn equal_input_gives_equal_bytes() {
        assert_eq!(
            with_sample(|f| draw_fig07(f, SheetWidth::Paper).unwrap()),
            with_sample(|f| draw_fig07(f, SheetWidth::Paper).unwrap())
        );
    }

    #[test]
    fn inadmissible_rows_are_not_drawn() {
        with_sample(|figure| {
            let all = draw_fig07(figure, SheetWidth::Paper).unwrap();
            let none = vec![false; figure.curves.height()];
            let mut curves = figure.curves.clone();
            curves.with_column(polars::prelude::Column::new("admissible".into(), none)).unwrap();
            let without = draw_fig07(&Figure07 { curves: &curves, ..*figure }, SheetWidth::Paper).unwrap();
            let blue = "stroke=\"#1946be\"";
            assert!(all.contains(blue) && !without.contains(blue));
        });
    }

    #[test]
    fn a_missing_column_and_a_reversed_window_are_errors() {
        with_sample(|figure| {
            let curves = figure.curves.drop("arc").unwrap();
            let error = draw_fig07(&Figure07 { curves: &curves, ..*figure }, SheetWidth::Paper).unwrap_err();
            assert!(matches!(
                error,
                DrawingError::MissingColumn { frame: "fig07_curves", column: "arc", .. }
            ));
            let window = Window { x: [1.0, 0.0], ..figure.window };
            let error = draw_fig07(&Figure07 { window, ..*figure }, SheetWidth::Paper).unwrap_err();
            assert!(matches!(error, DrawingError::Window { window: "fig07", .. }));
        });
    }
}
