//! Drawing of Figure 10: the path of the proof of Theorem 2.3.

use grazing_drawing::geometry::clip::checked;
use grazing_drawing::geometry::sheet::{Bounds, Spot, distance, inside};
use grazing_drawing::ink::arrow::head_on;
use grazing_drawing::ink::canvas::Canvas;
use grazing_drawing::ink::labels::{Labels, Site};
use grazing_drawing::ink::markers::Marker;
use grazing_drawing::ink::style::{
    BLACK, Colour, DISC_RADIUS, LABEL_SIZE, Paint, Pen, SMALL_LABEL_SIZE, THRESHOLD,
};
use grazing_drawing::plot::axes::Panel;
use grazing_results::{Frame, span};

use super::{Visit, VisitPath};
use crate::figure::prelude::*;

const BLUE: Colour = [25, 70, 190];
/// The pen of the path between visits, and the paint of the area between it and the w-axis.
const PATH: Pen = Pen::solid(BLUE, 1.15);
const PATH_AREA: Paint = Paint { colour: BLUE, opacity: 0.1 };

/// The width of this figure in the paper.
const WIDTH_MM: f64 = 80.0;
const HEIGHT_MM: f64 = 68.0;
/// The fractions of the path's width and height that are left free beside it for labels.
const MARGIN: [f64; 2] = [0.46, 0.14];
/// Segments shorter than this (points) have no arrowhead.
const POINTED_LENGTH: f64 = 14.0;

/// Draws Figure 10.
pub(super) fn draw(figure: &VisitPath, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let vertices: Vec<(f64, f64)> = figure.path.iter().map(|visit| (visit.u, visit.w)).collect();
    let frame = Frame { x: extent(&vertices, |v| v.0, MARGIN[0]), y: extent(&vertices, |v| v.1, MARGIN[1]) };
    let frame = checked(frame, "fig10")?;

    let canvas = Canvas::new(width.mm(WIDTH_MM), HEIGHT_MM)?;
    let bounds = Bounds { left: 37.0, top: 6.0, right: canvas.width - 6.0, bottom: canvas.height - 30.0 };
    let mut panel = Panel::new(&canvas, frame, bounds)?;
    let mut labels = Labels::new(&canvas, bounds);

    panel.draw_series(panel.area(std::slice::from_ref(&vertices), PATH_AREA))?;
    let axis = panel.curve(&[(0.0, frame.y[0]), (0.0, frame.y[1])], THRESHOLD);
    for axis in panel.draw_series(axis)?.pieces {
        labels.placer.keep_off_nameless(&axis);
    }
    for line in panel.draw_series(panel.curve(&vertices, PATH))?.pieces {
        labels.placer.keep_off(&line);
        for segment in line.windows(2).filter(|s| distance(s[0], s[1]) >= POINTED_LENGTH) {
            head_on(&canvas, segment, 0.5, PATH)?;
        }
    }
    panel.mark(&mut labels, vertices.iter().copied(), Marker::Disc)?;
    panel.axes("$u$", "$w$")?;
    // Labels of vertices are placed outside if possible.
    let outline = panel.spots(&vertices);
    labels.placer.avoid(inner_spots(&outline));
    for (Visit { visit, .. }, &vertex) in figure.path.iter().zip(&vertices) {
        let text = format!(r"$(u^{{({visit})}},\,w^{{({visit})}})$");
        let wanted = Site::Around(panel.spot(vertex), DISC_RADIUS + 1.0);
        labels.add(&text, SMALL_LABEL_SIZE, BLACK, &wanted)?;
    }
    labels.add(r"$\mathcal{P}$", LABEL_SIZE, PATH.colour, &Site::Within(&outline))?;
    labels.draw()?;
    canvas.finish(
        "fig10",
        "The path P",
        "The scaled visits of an emerging maximal periodic solution to the Poincaré section, joined in order: a convex path \
         that begins and ends on the w-axis and lies left of it between.",
    )
}

/// A grid of spots, a point apart, inside a polygon.
fn inner_spots(outline: &[Spot]) -> impl Iterator<Item = Spot> {
    let across = outline.iter().map(|spot| spot.0).fold(0.0, f64::max) as u32;
    let down = outline.iter().map(|spot| spot.1).fold(0.0, f64::max) as u32;
    let grid =
        (0..=down).flat_map(move |y| (0..=across).map(move |x| (f64::from(x) + 0.5, f64::from(y) + 0.5)));
    grid.filter(|&spot| inside(outline, spot))
}

/// The range of a coordinate with its margin.
fn extent(vertices: &[(f64, f64)], coordinate: impl Fn(&(f64, f64)) -> f64, share: f64) -> [f64; 2] {
    let [low, high] = span(vertices.iter().map(coordinate));
    let margin = share * (high - low);
    [low - margin, high + margin]
}
