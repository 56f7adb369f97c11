//! Drawing of Figure 5: the unfolding of a resonant grazing bifurcation.

use grazing_drawing::geometry::clip::checked;
use grazing_drawing::geometry::sheet::{Bounds, Spot};
use grazing_drawing::ink::canvas::Canvas;
use grazing_drawing::ink::labels::{Labels, Site};
use grazing_drawing::ink::markers::Marker;
use grazing_drawing::ink::style::{BLACK, LABEL_SIZE, SMALL_LABEL_SIZE, TICK_SIZE};
use grazing_drawing::plot::axes::Panel;
use grazing_drawing::plot::kinds::{Trace, TraceOf, draw_curves, label, shade, text_colour};
use grazing_results::plane::RegionKind;

use super::{UnfoldingPoint, UnfoldingSketch};
use crate::figure::prelude::*;

fn words(kind: RegionKind) -> &'static [&'static str] {
    match kind {
        RegionKind::NonImpacting => &["stable", "non-impacting", "periodic", "solution"],
        RegionKind::Mps => &["stable", "$p$-loop MPS"],
        RegionKind::Both => &["both", "stable"],
        RegionKind::SeveralImpacts | RegionKind::Undecided => &[],
    }
}

/// The width of this figure in the paper.
const WIDTH_MM: f64 = 64.0;
const HEIGHT_MM: f64 = 58.0;

/// Draws Figure 5.
pub(super) fn draw(figure: &UnfoldingSketch, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let frame = checked(figure.frame, "fig05")?;
    let curve = |points: &[UnfoldingPoint]| Trace {
        kind: points[0].kind,
        of: TraceOf::Bifurcation,
        points: points.iter().map(|point| (point.mu, point.eta)).collect(),
    };
    let curves = figure.curves.chunk_by(|a, b| a.kind == b.kind).map(curve).collect();
    let regions: Vec<(RegionKind, Vec<_>)> = figure
        .regions
        .chunk_by(|a, b| a.region == b.region)
        .map(|vertices| (vertices[0].kind, vertices.iter().map(|vertex| (vertex.mu, vertex.eta)).collect()))
        .collect();

    let canvas = Canvas::new(width.mm(WIDTH_MM), HEIGHT_MM)?;
    let bounds = Bounds { left: 45.0, top: 6.0, right: canvas.width - 7.0, bottom: canvas.height - 29.0 };
    let mut panel = Panel::new(&canvas, frame, bounds)?;
    let mut labels = Labels::new(&canvas, bounds);

    let mut shapes: Vec<(RegionKind, Vec<Spot>)> = Vec::new();
    for (kind, vertices) in &regions {
        let shape = match kind {
            RegionKind::NonImpacting | RegionKind::Mps => {
                shade(&mut panel, std::slice::from_ref(vertices), *kind)?
            }
            // The overlap gets its shade from the two regions that it belongs to.
            RegionKind::Both | RegionKind::SeveralImpacts | RegionKind::Undecided => panel.spots(vertices),
        };
        shapes.push((*kind, shape));
    }
    let drawn = draw_curves(&mut panel, &mut labels, curves)?;
    let points = figure.points.iter().map(|point| (point.mu, point.eta));
    let marks = panel.mark(&mut labels, points, Marker::Triangle)?;
    marks.label("resonant grazing bifurcation").legend(Marker::Triangle.sample())?;
    panel.axes(r"$\mu$", r"$\eta$")?;
    // The overlap is the narrowest region, and is labelled first.
    for (kind, shape) in shapes.iter().rev() {
        let wanted = Site::Within(shape);
        if !labels.add_lines(words(*kind), SMALL_LABEL_SIZE, BLACK, &wanted)? {
            labels.add_lines(words(*kind), TICK_SIZE, BLACK, &wanted)?;
        }
    }
    for (kind, piece) in &drawn {
        labels.add(label(*kind, "grazing"), LABEL_SIZE, text_colour(*kind), &Site::Beside(piece))?;
    }
    labels.draw()?;
    canvas.finish(
        "fig05",
        "Unfolding of a resonant grazing bifurcation",
        "Distance from grazing across, distance from resonance up. Half-parabolas of saddle-node (SN) and period-doubling \
         (PD) bifurcations touch the line of grazing bifurcations in the resonance. Light grey: the non-impacting solution \
         is stable; dark: a p-loop maximal periodic solution is.",
    )
}
