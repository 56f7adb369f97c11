//! The rectangles of a diagram that panels of another sheet magnify, and the letters of both.

use grazing_results::Frame;

use crate::error::DrawingError;
use crate::geometry::sheet::Bounds;
use crate::ink::labels::{Labels, Site};
use crate::ink::legend;
use crate::ink::style::{AROUND_MAGNIFIED, MAGNIFIED, MAGNIFIED_TEXT, SMALL_LABEL_SIZE, TRIANGLE_SIZE};
use crate::plot::axes::Panel;

/// Rectangles smaller than this (points) would hide the triangle inside, and those lower or narrower than
/// [`BAR`] would be bars across their contents.
const HIDING: f64 = TRIANGLE_SIZE;
const BAR: f64 = 3.0 * MAGNIFIED.width;
/// The least width and height, in points, of the dotted rectangle that is drawn around such a rectangle.
const LEAST: f64 = TRIANGLE_SIZE + 3.0;

/// The distance from a resonance to its label, in points: the triangle and its rim, along the diagonal.
pub(crate) const OFF_TRIANGLE: f64 = 5.4;

/// The letter that figures use for a panel: (a) for the first, (aa) for the 27th.
pub(crate) fn panel_letter(number: u32) -> String {
    let mut letters = String::new();
    let mut rest = number;
    while let Some(before) = rest.checked_sub(1) {
        letters.insert(0, char::from(b'a' + (before % 26) as u8));
        rest = before / 26;
    }
    format!("({letters})")
}

/// Draws a rectangle, or a dotted one around it if it is too small; returns the visible outline, if any.
pub(crate) fn rectangle(
    panel: &mut Panel<'_>,
    frame: &Frame,
    labels: &mut Labels<'_>,
) -> Result<Option<Bounds>, DrawingError> {
    let [[left, right], [low, high]] = [frame.x, frame.y];
    let (a, b) = (panel.spot((left, high)), panel.spot((right, low)));
    let own = Bounds { left: a.0, top: a.1, right: b.0, bottom: b.1 };
    let seen = own.common(panel.bounds);
    if seen.left > seen.right || seen.top > seen.bottom {
        return Ok(None);
    }
    let [wide, high] = [own.right - own.left, own.bottom - own.top];
    let is_small = wide.max(high) < HIDING || wide.min(high) < BAR;
    let whole = if is_small { Bounds::about(own.centre(), wide.max(LEAST), high.max(LEAST)) } else { own };
    let (meaning, pen, outline) = if is_small {
        let values = [(whole.left, whole.bottom), (whole.right, whole.top)].map(|corner| panel.at(corner));
        let [(left, low), (right, high)] = values;
        (
            "place of a magnification whose area is too small to be drawn",
            AROUND_MAGNIFIED,
            Frame { x: [left, right], y: [low, high] },
        )
    } else {
        ("area of a magnification", MAGNIFIED, *frame)
    };
    let drawn = panel.draw_series(panel.curve(&outline.outline(), pen))?;
    let drawn = drawn.label(meaning).legend(legend::rectangle(pen))?;
    drawn.pieces.iter().for_each(|piece| labels.placer.keep_off(piece));
    Ok(Some(whole.common(panel.bounds)))
}

/// Labels a rectangle: around its middle or, for a small one among many curves, at the first corner with
/// room, or else from farther away than other labels, and rather over lines and markers than not at all.
pub(crate) fn letter(labels: &mut Labels<'_>, number: u32, outline: &Bounds) -> Result<(), DrawingError> {
    let Bounds { left, top, right, bottom } = *outline;
    let reach = 0.5 * (right - left).min(bottom - top);
    let corners = [(left, bottom), (left, top), (right, top), (right, bottom)];
    let near = [(outline.centre(), reach + 1.0)].into_iter().chain(corners.map(|corner| (corner, 1.0)));
    let letter = panel_letter(number);
    for (spot, clearance) in near {
        if labels.add(&letter, SMALL_LABEL_SIZE, MAGNIFIED_TEXT, &Site::Around(spot, clearance))? {
            return Ok(());
        }
    }
    let middle = outline.centre();
    let sides = [(left, middle.1), (right, middle.1), (middle.0, top), (middle.0, bottom)];
    let around = [corners, sides].concat();
    labels.add(&letter, SMALL_LABEL_SIZE, MAGNIFIED_TEXT, &Site::Anyhow(&around, 1.0))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_have_letters_beyond_z() {
        let letters = [1, 3, 26, 27, 52, 53, 703].map(panel_letter);
        assert_eq!(letters, ["(a)", "(c)", "(z)", "(aa)", "(az)", "(ba)", "(aaa)"]);
    }
}
