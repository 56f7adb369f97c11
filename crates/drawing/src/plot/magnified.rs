//! The rectangles of a diagram that panels of another sheet magnify, and the letters of both.

use grazing_results::Frame;

use crate::error::DrawingError;
use crate::geometry::sheet::Bounds;
use crate::ink::labels::{Labels, Site};
use crate::ink::legend::Sample;
use crate::ink::style::{MAGNIFIED, MAGNIFIED_TEXT, SMALL_LABEL_SIZE, TRIANGLE_SIZE};
use crate::plot::axes::Panel;

/// Rectangles smaller than this (points) are not drawn, because they would hide the triangle inside; the
/// triangle gets the letter.
const HIDDEN: f64 = TRIANGLE_SIZE;
/// Rectangles lower or narrower than this are not drawn, because they would be bars across their
/// contents.
const BAR: f64 = 3.0 * MAGNIFIED.width;

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

fn is_hidden(outline: &Bounds) -> bool {
    let [wide, high] = [outline.right - outline.left, outline.bottom - outline.top];
    wide.max(high) < HIDDEN || wide.min(high) < BAR
}

/// Draws a rectangle unless it is too small; returns its visible outline, if any.
pub(crate) fn rectangle(panel: &Panel<'_>, frame: &Frame, labels: &mut Labels<'_>) -> Option<Bounds> {
    let [[left, right], [low, high]] = [frame.x, frame.y];
    let (a, b) = (panel.spot((left, high)), panel.spot((right, low)));
    let whole = Bounds { left: a.0, top: a.1, right: b.0, bottom: b.1 };
    if !is_hidden(&whole) {
        for piece in panel.line(&frame.outline(), MAGNIFIED) {
            panel.canvas.explain("area of a magnification", Sample::Rectangle(MAGNIFIED));
            labels.placer.keep_off(&piece);
        }
    }
    let seen = whole.common(panel.bounds);
    (seen.left <= seen.right && seen.top <= seen.bottom).then_some(seen)
}

/// Labels a rectangle: around its middle or, for a small one among many curves, at the first corner with
/// room.
pub(crate) fn letter(labels: &mut Labels<'_>, number: u32, outline: &Bounds) -> Result<(), DrawingError> {
    let Bounds { left, top, right, bottom } = *outline;
    let reach = 0.5 * (right - left).min(bottom - top);
    let clearance = if is_hidden(outline) { OFF_TRIANGLE } else { reach + 1.0 };
    let corners = [(left, bottom), (left, top), (right, top), (right, bottom)].map(|corner| (corner, 1.0));
    let letter = panel_letter(number);
    for (spot, clearance) in [(outline.centre(), clearance)].into_iter().chain(corners) {
        if labels.add(&letter, SMALL_LABEL_SIZE, MAGNIFIED_TEXT, &Site::Around(spot, clearance))? {
            break;
        }
    }
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
