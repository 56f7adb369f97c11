//! Lines with arrowheads: axes, forces, dimensions.

use crate::DrawingError;
use crate::canvas::{Canvas, Ink};
use crate::sheet::{Spot, distance};
use crate::style::{Paint, Pen};

/// Half the width of an arrowhead over its length.
const SLENDERNESS: f64 = 0.32;

/// A filled arrowhead `length` points long with its tip at `tip`, pointing away from `from`.
pub(crate) fn arrowhead(
    canvas: &Canvas,
    from: Spot,
    tip: Spot,
    length: f64,
    pen: Pen,
) -> Result<(), DrawingError> {
    let reach = distance(from, tip);
    if reach == 0.0 {
        return Ok(());
    }
    let (right, down) = ((tip.0 - from.0) / reach, (tip.1 - from.1) / reach);
    let (x, y) = (tip.0 - length * right, tip.1 - length * down);
    let half = SLENDERNESS * length;
    let corners = [tip, (x - half * down, y + half * right), (x + half * down, y - half * right)];
    canvas.draw(&corners, Ink::Polygon(Paint { colour: pen.colour, opacity: pen.opacity }, None))
}

/// A line that ends in an arrowhead at `to`.
pub(crate) fn arrow(
    canvas: &Canvas,
    from: Spot,
    to: Spot,
    length: f64,
    pen: Pen,
) -> Result<(), DrawingError> {
    canvas.draw(&[from, short_of(to, from, 0.8 * length)], Ink::Line(pen))?;
    arrowhead(canvas, from, to, length, pen)
}

/// A line with arrowheads at both ends.
pub(crate) fn dimension(
    canvas: &Canvas,
    from: Spot,
    to: Spot,
    length: f64,
    pen: Pen,
) -> Result<(), DrawingError> {
    let kept = 0.8 * length;
    canvas.draw(&[short_of(from, to, kept), short_of(to, from, kept)], Ink::Line(pen))?;
    arrowhead(canvas, to, from, length, pen)?;
    arrowhead(canvas, from, to, length, pen)
}

/// The spot `by` points before `end` on the way from `start`: a wide line must not show beyond the tip of its head.
fn short_of(end: Spot, start: Spot, by: f64) -> Spot {
    let reach = distance(start, end);
    let share = if reach > by { by / reach } else { 1.0 };
    (end.0 + share * (start.0 - end.0), end.1 + share * (start.1 - end.1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::FORCE;

    #[test]
    fn the_line_of_an_arrow_stops_inside_its_head_whose_tip_is_the_end() {
        let canvas = Canvas::new(40.0, 40.0).unwrap();
        arrow(&canvas, (10.0, 20.0), (30.0, 20.0), 5.0, FORCE).unwrap();
        let svg = canvas.finish("test", "", "").unwrap();
        assert!(svg.contains("M10,20L26,20") && svg.contains("M30,20L25,21.6L25,18.4Z"), "{svg}");
    }

    #[test]
    fn an_arrow_without_length_has_no_head() {
        let canvas = Canvas::new(40.0, 40.0).unwrap();
        arrow(&canvas, (10.0, 20.0), (10.0, 20.0), 5.0, FORCE).unwrap();
        assert!(!canvas.finish("test", "", "").unwrap().contains("NaN"));
    }
}
