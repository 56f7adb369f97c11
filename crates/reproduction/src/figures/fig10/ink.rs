//! Drawing of Figure 10: the path of the proof of Theorem 2.3.

use grazing_drawing::geometry::clip::checked;
use grazing_drawing::geometry::sheet::{Bounds, Spot, distance, inside};
use grazing_drawing::ink::arrow::head_on;
use grazing_drawing::ink::canvas::Canvas;
use grazing_drawing::ink::labels::{Labels, Site};
use grazing_drawing::ink::style::{
    BLACK, Colour, DISC_RADIUS, LABEL_SIZE, Paint, Pen, SMALL_LABEL_SIZE, THRESHOLD,
};
use grazing_drawing::plot::axes::{Marker, Panel};
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
    let panel = Panel::new(&canvas, frame, bounds);
    let mut labels = Labels::new(&canvas, bounds);

    panel.fill(&vertices, PATH_AREA);
    for axis in panel.line(&[(0.0, frame.y[0]), (0.0, frame.y[1])], THRESHOLD) {
        labels.placer.keep_off_nameless(&axis);
    }
    for line in panel.line(&vertices, PATH) {
        labels.placer.keep_off(&line);
        for segment in line.windows(2).filter(|s| distance(s[0], s[1]) >= POINTED_LENGTH) {
            head_on(&canvas, segment, 0.5, PATH);
        }
    }
    for &vertex in &vertices {
        if let Some(taken) = panel.marker(vertex, Marker::Disc) {
            labels.placer.block(taken);
        }
    }
    panel.axes("$u$", "$w$")?;
    // Labels of vertices are placed outside if possible.
    let outline: Vec<_> = vertices.iter().map(|&vertex| panel.spot(vertex)).collect();
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

#[cfg(test)]
mod tests {
    use grazing_drawing::Element;

    use super::*;

    fn path(places: &[(f64, f64)]) -> VisitPath {
        let path = (0..).zip(places).map(|(visit, &(u, w))| Visit { visit, u, w }).collect();
        VisitPath { path }
    }

    fn sample() -> VisitPath {
        path(&[(0.0, -3.7), (-2.5, -3.2), (-3.8, -1.2), (-3.5, 1.0), (-2.2, 2.1), (-0.8, 1.9), (0.0, 0.7)])
    }

    #[test]
    fn every_vertex_is_marked_and_named() {
        let path = sample();
        let svg = draw(&path, SheetWidth::Paper).unwrap().svg();
        assert_eq!(svg.matches("<circle").count(), 7);
        for visit in 0..=6 {
            assert_eq!(svg.matches(&format!(">({visit})</tspan>")).count(), 2, "{visit}");
        }
        assert!(svg.contains('𝒫'));
    }

    #[test]
    fn vertices_are_named_outside_the_path() {
        let path = sample();
        let sheet = draw(&path, SheetWidth::Paper).unwrap();
        let area = sheet.elements.iter().find_map(|element| match element {
            Element::Path(area) if area.attributes.contains("fill-opacity=\"0.1\"") => Some(area),
            _ => None,
        });
        let outline = area.expect("the area is filled").pieces[0].0.iter();
        let outline: Vec<Spot> =
            outline.map(|&(x, y)| (f64::from(x) / 100.0, f64::from(y) / 100.0)).collect();
        let names: Vec<_> = sheet.texts.iter().filter(|(text, _)| text.contains("w^{(")).collect();
        assert_eq!(names.len(), 7);
        for (text, bounds) in names {
            assert!(!inside(&outline, bounds.centre()), "{text}");
        }
    }

    #[test]
    fn a_path_without_width_is_an_error() {
        let path = path(&[(0.0, 0.0), (0.0, 1.0)]);
        let error = draw(&path, SheetWidth::Paper).unwrap_err();
        assert!(error.to_string().contains("range of fig10"), "{error}");
    }
}
