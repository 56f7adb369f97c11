//! Arrows: lines that end in a head, and heads along a curve.

use crate::error::DrawingError;
use crate::geometry::sheet::{Spot, along, distance};
use crate::ink::canvas::Canvas;
use crate::ink::elements::{Area, Stroke};
use crate::ink::style::{Colour, Paint, Pen};

/// The length of the head of a line one point wide, from its tip to its barbs, in points; it increases
/// with the width of the line.
const HEAD_LENGTH: f64 = 5.6;
/// The width of a head and the depth of the notch in its back, in units of its length.
const HEAD_SHAPE: (f64, f64) = (0.68, 0.24);

/// The length of a head for a line, in points.
fn head_length(pen: Pen) -> f64 {
    HEAD_LENGTH * (0.5 + 0.5 * pen.width)
}

/// Draws a head of a given length with its tip at a spot, pointing along a unit vector.
fn arrowhead(
    canvas: &Canvas,
    tip: Spot,
    direction: Spot,
    size: f64,
    colour: Colour,
) -> Result<(), DrawingError> {
    let at = |back: f64, aside: f64| {
        let (back, aside) = (back * size, aside * size);
        (tip.0 - back * direction.0 - aside * direction.1, tip.1 - back * direction.1 + aside * direction.0)
    };
    let (width, notch) = HEAD_SHAPE;
    let outline = [tip, at(1.0, 0.5 * width), at(1.0 - notch, 0.0), at(1.0, -0.5 * width)];
    canvas.draw(&Area::ring(outline, Paint::opaque(colour), None))
}

/// Draws a head with its middle at a fraction of a curve's length, pointing along the curve.
///
/// # Errors
/// As [`Canvas::draw`].
pub fn head_on(canvas: &Canvas, curve: &[Spot], share: f64, pen: Pen) -> Result<(), DrawingError> {
    let Some((middle, direction)) = along(curve, share) else { return Ok(()) };
    let size = head_length(pen);
    let tip = (middle.0 + 0.5 * size * direction.0, middle.1 + 0.5 * size * direction.1);
    arrowhead(canvas, tip, direction, size, pen.colour)
}

/// Draws a line with a head whose tip stops `short` of the line's end; nothing if the line is too short
/// for a head.
///
/// # Errors
/// As [`Canvas::draw`].
pub fn arrow(canvas: &Canvas, path: &[Spot], short: f64, pen: Pen) -> Result<(), DrawingError> {
    let size = head_length(pen);
    let to_tip = shortened(path, short);
    let shaft = shortened(&to_tip, (1.0 - HEAD_SHAPE.1) * size);
    let (Some(&tip), Some(&neck)) = (to_tip.last(), shaft.last()) else {
        return Ok(());
    };
    canvas.draw(&Stroke::new(shaft, pen))?;
    let length = distance(neck, tip);
    let direction = ((tip.0 - neck.0) / length, (tip.1 - neck.1) / length);
    arrowhead(canvas, tip, direction, size, pen.colour)
}

/// Draws a line with heads at both ends, as for a dimension.
///
/// # Errors
/// As [`Canvas::draw`].
pub fn double_arrow(canvas: &Canvas, [from, to]: [Spot; 2], pen: Pen) -> Result<(), DrawingError> {
    let middle = (0.5 * (from.0 + to.0), 0.5 * (from.1 + to.1));
    arrow(canvas, &[middle, from], 0.0, pen)?;
    arrow(canvas, &[middle, to], 0.0, pen)
}

/// The path without the last `by` points of its length; empty if it is not longer than that.
fn shortened(path: &[Spot], by: f64) -> Vec<Spot> {
    let mut left = by;
    for end in (1..path.len()).rev() {
        let (from, to) = (path[end - 1], path[end]);
        let step = distance(from, to);
        if step > left {
            let share = left / step;
            let mut kept = path[..end].to_vec();
            kept.push((to.0 + share * (from.0 - to.0), to.1 + share * (from.1 - to.1)));
            return kept;
        }
        left -= step;
    }
    Vec::new()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ink::style::RETURN;
    use crate::ink::svg::points;

    #[test]
    fn shortening_is_measured_along_the_path() {
        let hook = [(0.0, 0.0), (10.0, 0.0), (10.0, 4.0)];
        assert_eq!(shortened(&hook, 6.0), [(0.0, 0.0), (8.0, 0.0)]);
        assert_eq!(shortened(&hook, 0.0), hook);
        assert!(shortened(&hook, 14.0).is_empty());
    }

    #[test]
    fn an_arrow_is_a_shaft_and_a_head_that_stops_short_of_the_end() {
        let canvas = Canvas::new(40.0, 40.0).unwrap();
        arrow(&canvas, &[(10.0, 20.0), (60.0, 20.0)], 2.0, RETURN).unwrap();
        let svg = canvas.finish("test", "", "").unwrap().svg();
        let size = head_length(RETURN);
        let neck = points(58.0 - (1.0 - HEAD_SHAPE.1) * size);
        let barb = points(58.0 - size);
        let (shaft, head) = (format!("M10,20L{neck},20\""), format!("M58,20L{barb},"));
        assert!(svg.contains(&shaft) && svg.contains(&head), "{shaft} {head} {svg}");
    }

    #[test]
    fn a_line_shorter_than_its_head_is_left_out() {
        let canvas = Canvas::new(40.0, 40.0).unwrap();
        arrow(&canvas, &[(10.0, 20.0), (15.0, 20.0)], 2.0, RETURN).unwrap();
        assert!(!canvas.finish("test", "", "").unwrap().svg().contains("<path"));
    }
}
