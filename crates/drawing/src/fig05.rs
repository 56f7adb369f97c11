//! Figure 5: the unfolding of a resonant grazing bifurcation.

use polars::prelude::DataFrame;

use crate::DrawingError;
use crate::axes::{Marker, Panel};
use crate::canvas::Canvas;
use crate::clip::Window;
use crate::frames::{Table, runs};
use crate::kinds::Kind;
use crate::labels::{Labels, Wanted};
use crate::sheet::{Bounds, Spot};
use crate::style::{
    BLACK, LABEL_SIZE, MPS_AREA, NON_IMPACTING_AREA, Paint, SMALL_LABEL_SIZE, SheetWidth, TICK_SIZE,
};

/// What Figure 5 shows.
///
/// Paper: Figure 5, fig:E.
#[derive(Debug, Clone, Copy)]
pub struct Figure05<'a> {
    /// Columns kind (graz, SN, PD), mu, eta. Rows that follow each other with equal kind are one curve.
    pub curves: &'a DataFrame,
    /// Columns mu, eta: the resonance.
    pub points: &'a DataFrame,
    /// Columns region, kind (non-impacting, mps, both), mu, eta: vertices of polygons. The third is where the first two
    /// overlap.
    pub regions: &'a DataFrame,
    /// Values of mu (horizontal) and eta (vertical) shown.
    pub window: Window,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stable {
    NonImpacting,
    Mps,
    Both,
}

impl Stable {
    /// The overlap gets its shade from the two areas that make it up.
    fn paint(self) -> Option<Paint> {
        match self {
            Stable::NonImpacting => Some(NON_IMPACTING_AREA),
            Stable::Mps => Some(MPS_AREA),
            Stable::Both => None,
        }
    }

    fn label(self) -> &'static [&'static str] {
        match self {
            Stable::NonImpacting => &["stable", "non-impacting", "periodic", "solution"],
            Stable::Mps => &["stable", "$p$-loop MPS"],
            Stable::Both => &["both", "stable"],
        }
    }
}

/// Width in the paper.
const WIDTH_MM: f64 = 64.0;
const HEIGHT_MM: f64 = 58.0;

/// Draws Figure 5.
///
/// # Errors
/// [`DrawingError`] if a column is missing or of the wrong type, a kind is unknown or the window is empty.
pub fn draw_fig05(figure: &Figure05<'_>, width: SheetWidth) -> Result<String, DrawingError> {
    compose(figure, width)?.finish(
        "fig05",
        "Unfolding of a resonant grazing bifurcation",
        "Distance from grazing across, distance from resonance up. Half-parabolas of saddle-node (SN) and period-doubling \
         (PD) bifurcations touch the line of grazing bifurcations in the resonance. Light grey: the non-impacting solution \
         is stable; dark: a p-loop maximal periodic solution is.",
    )
}

pub(crate) fn compose(figure: &Figure05<'_>, width: SheetWidth) -> Result<Canvas, DrawingError> {
    let window = figure.window.checked("fig05")?;
    let curves = read(Table::new("fig05_curves", figure.curves), "kind", Kind::KNOWN, Kind::parse)?;
    let regions =
        read(Table::new("fig05_regions", figure.regions), "kind", "non-impacting, mps, both", |word| {
            match word {
                "non-impacting" => Some(Stable::NonImpacting),
                "mps" => Some(Stable::Mps),
                "both" => Some(Stable::Both),
                _ => None,
            }
        })?;
    let points = Table::new("fig05_points", figure.points);
    let (mu, eta) = (points.numbers("mu")?, points.numbers("eta")?);

    let canvas = Canvas::new(width.mm(WIDTH_MM), HEIGHT_MM)?;
    let bounds = Bounds { left: 45.0, top: 6.0, right: canvas.width - 7.0, bottom: canvas.height - 29.0 };
    let panel = Panel::new(&canvas, window, bounds);
    let mut labels = Labels::new(&canvas, bounds);

    let mut shapes: Vec<(Stable, Vec<Spot>)> = Vec::new();
    for (stable, vertices) in &regions {
        let shape = match stable.paint() {
            Some(paint) => panel.fill(vertices, paint)?,
            None => vertices.iter().map(|&vertex| panel.spot(vertex)).collect(),
        };
        shapes.push((*stable, shape));
    }
    let mut drawn: Vec<(Kind, Vec<Spot>)> = Vec::new();
    for (kind, points) in &curves {
        for piece in panel.line(points, kind.pen())? {
            labels.placer.keep_off(&piece);
            drawn.push((*kind, piece));
        }
    }
    for point in mu.into_iter().zip(eta) {
        if let Some(taken) = panel.marker(point, Marker::Triangle)? {
            labels.placer.block(taken.grown(0.5));
        }
    }
    panel.axes(r"$\mu$", r"$\eta$")?;
    // The overlap is the narrowest: it chooses first.
    for (stable, shape) in shapes.iter().rev() {
        let wanted = Wanted::Within(shape);
        if !labels.add_lines(stable.label(), SMALL_LABEL_SIZE, BLACK, &wanted)? {
            labels.add_lines(stable.label(), TICK_SIZE, BLACK, &wanted)?;
        }
    }
    for (kind, piece) in &drawn {
        let text = if *kind == Kind::Graz { "grazing" } else { kind.label() };
        labels.add(text, LABEL_SIZE, kind.text_colour(), &Wanted::Beside(piece))?;
    }
    labels.draw()?;
    drop(panel);
    Ok(canvas)
}

/// What it is, and its points (mu, eta).
type Polyline<K> = (K, Vec<(f64, f64)>);

/// Rows of (mu, eta) that follow each other with one kind.
fn read<K: Copy + PartialEq>(
    table: Table<'_>,
    column: &'static str,
    known: &'static str,
    parse: impl Fn(&str) -> Option<K>,
) -> Result<Vec<Polyline<K>>, DrawingError> {
    let kinds = table.words(column, known, parse)?;
    let (mu, eta) = (table.numbers("mu")?, table.numbers("eta")?);
    let group = |rows: std::ops::Range<usize>| (kinds[rows.start], rows.map(|i| (mu[i], eta[i])).collect());
    Ok(runs(&kinds).into_iter().map(group).collect())
}

#[cfg(test)]
mod tests {
    use polars::prelude::df;

    use super::*;
    use crate::inspection::{coordinates, off_the_sheet};

    fn frame(rows: &[(&str, f64, f64)]) -> DataFrame {
        let kinds: Vec<_> = rows.iter().map(|r| r.0).collect();
        let mut region = 0;
        let regions = kinds.iter().enumerate().map(|(i, kind)| {
            region += i64::from(i > 0 && kinds[i - 1] != *kind);
            region
        });
        df!(
            "region" => regions.collect::<Vec<_>>(),
            "kind" => kinds,
            "mu" => rows.iter().map(|r| r.1).collect::<Vec<_>>(),
            "eta" => rows.iter().map(|r| r.2).collect::<Vec<_>>(),
        )
        .unwrap()
    }

    fn with_sample<T>(test: impl Fn(&Figure05<'_>) -> T) -> T {
        let parabola = |c: f64, side: f64| {
            (0..=50).map(move |k| side * f64::from(k) / 50.0).map(move |eta| (c * eta * eta, eta))
        };
        let (sn, pd) = (|| parabola(-0.8, -1.0), || parabola(0.3, 1.0));
        let mut curves = vec![("graz", 0.0, -1.0), ("graz", 0.0, 1.0)];
        curves.extend(sn().map(|(mu, eta)| ("SN", mu, eta)));
        curves.extend(pd().map(|(mu, eta)| ("PD", mu, eta)));
        let mut regions = [(0.0, -1.0), (0.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)]
            .map(|(m, e)| ("non-impacting", m, e))
            .to_vec();
        regions.extend(sn().collect::<Vec<_>>().into_iter().rev().chain(pd()).map(|(m, e)| ("mps", m, e)));
        regions.extend([("mps", 1.0, 1.0), ("mps", 1.0, -1.0)]);
        regions.extend(sn().chain([(0.0, -1.0)]).map(|(m, e)| ("both", m, e)));
        test(&Figure05 {
            curves: &frame(&curves),
            points: &frame(&[("resonance", 0.0, 0.0)]),
            regions: &frame(&regions),
            window: Window { x: [-1.0, 1.0], y: [-1.0, 1.0] },
        })
    }

    #[test]
    fn no_two_labels_overlap_and_none_leaves_the_sheet() {
        for width in [SheetWidth::Paper, SheetWidth::OneColumn, SheetWidth::TwoColumns] {
            let misplaced = with_sample(|figure| compose(figure, width).unwrap().misplaced_texts());
            assert!(misplaced.is_empty(), "{width:?}: {misplaced:?}");
        }
    }

    #[test]
    fn curves_and_regions_are_named() {
        let svg = with_sample(|figure| draw_fig05(figure, SheetWidth::Paper).unwrap());
        for label in [">SN<", ">PD<", ">grazing<", ">non-impacting<", ">both<", ">μ<", ">η<"] {
            assert!(svg.contains(label), "{label}");
        }
        assert!(svg.contains("-loop MPS<"));
    }

    #[test]
    fn the_overlap_is_shaded_by_its_two_regions_and_not_once_more() {
        let svg = with_sample(|figure| draw_fig05(figure, SheetWidth::Paper).unwrap());
        assert_eq!(svg.matches("fill=\"#e9e9e9\"").count(), 1);
        assert_eq!(svg.matches("fill-opacity=\"0.3\"").count(), 1);
    }

    #[test]
    fn everything_is_on_the_sheet() {
        let svg = with_sample(|figure| draw_fig05(figure, SheetWidth::Paper).unwrap());
        assert!(coordinates(&svg).len() > 50);
        assert!(off_the_sheet(&svg).is_empty(), "{:?}", off_the_sheet(&svg));
    }

    #[test]
    fn a_reversed_window_is_an_error() {
        with_sample(|figure| {
            let window = Window { x: [1.0, -1.0], ..figure.window };
            let error = draw_fig05(&Figure05 { window, ..*figure }, SheetWidth::Paper).unwrap_err();
            assert!(matches!(error, DrawingError::Window { window, .. } if window == "fig05"));
        });
    }
}
