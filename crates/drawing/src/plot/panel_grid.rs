//! Where the panels of a sheet stand: in rows of equal panels, with room for headings, numbers and titles.

use std::ops::Range;

use grazing_results::Frame;

use crate::error::DrawingError;
use crate::geometry::sheet::Bounds;
use crate::ink::font::Fonts;
use crate::ink::style::SheetWidth;
use crate::ink::svg::POINTS_PER_MM;
use crate::plot::axes::{overhang, room_beside};
use crate::plot::numbers::{Direction, Numbers};

/// Width in the paper.
const WIDTH_MM: f64 = 156.0;
/// Sheets at least this wide have panels side by side; on others they stand one above the other.
const SIDE_BY_SIDE_MM: f64 = 120.0;
/// Height of a row with headings of two lines, numbers and axis titles, for one, two and three panels side by side and
/// for panels one above the other; three rows and a caption fill a page.
const ROW_MM: [f64; 3] = [92.0, 75.0, 63.0];
const STACKED_ROW_MM: f64 = 54.0;
const ROWS_A_SHEET: usize = 3;
/// Room left of a panel for its numbers and the gap to the panel before it, in points; the first of a row has the axis
/// title too. Longer numbers get more.
const ROOM_LEFT: f64 = 34.0;
const ROOM_LEFT_OF_FIRST: f64 = 44.0;
const PANEL_GAP: f64 = 4.0;
const ROOM_RIGHT: f64 = 9.0;
/// Room above a panel for a heading of two lines and below it for numbers and axis title, in points.
const ROOM_ABOVE: f64 = 27.0;
const ROOM_BELOW: f64 = 30.0;
/// How far above a panel the baseline of the last line of its heading is, in points.
const LAST_LINE_RISE: f64 = 5.0;
/// From the baseline of a heading's first line to that of the second, and between further lines, in points.
pub(crate) const HEADING_LEADING: f64 = 11.0;
pub(crate) const SUBHEADING_LEADING: f64 = 9.5;

/// The panels of one sheet.
pub(crate) struct Grid {
    pub(crate) width_mm: f64,
    row_mm: f64,
    /// Left edges of the columns and the width of a panel, in points.
    lefts: Vec<f64>,
    width: f64,
    rows: usize,
    /// Room for headings beyond [`ROOM_ABOVE`], in points.
    further: f64,
    /// Every panel has a title on its vertical axis, since their numbers do not all mean the same.
    all_titled: bool,
}

/// Panels side by side, and the height of their row.
fn row(width_mm: f64, panels: usize) -> (usize, f64) {
    if width_mm < SIDE_BY_SIDE_MM {
        return (1, STACKED_ROW_MM);
    }
    let columns = match panels {
        1 => 1,
        2 | 4 => 2,
        _ => 3,
    };
    (columns, ROW_MM[columns - 1])
}

impl Grid {
    /// Which of so many panels go on which sheet.
    pub(crate) fn sheets(width: SheetWidth, panels: usize) -> Vec<Range<usize>> {
        let (columns, _) = row(width.mm(WIDTH_MM), panels);
        let sheets = panels.div_ceil(columns * ROWS_A_SHEET).max(1);
        let each = panels.div_ceil(sheets).next_multiple_of(columns).max(1);
        (0..panels).step_by(each).map(|first| first..(first + each).min(panels)).collect()
    }

    /// The grid of a sheet that shows these frames with titles on their vertical axes, `panels` being the number of panels on all sheets.
    pub(crate) fn new(
        fonts: &Fonts,
        width: SheetWidth,
        panels: usize,
        frames: &[Frame],
        titles: &[&str],
    ) -> Result<Self, DrawingError> {
        let width_mm = width.mm(WIDTH_MM);
        let (columns, row_mm) = row(width_mm, panels);
        let height = row_mm * POINTS_PER_MM - ROOM_ABOVE - ROOM_BELOW;
        let mut all_titled = titles.windows(2).any(|pair| pair[0] != pair[1]);
        for frame in frames {
            all_titled |= !Numbers::along(fonts, frame.y, height, Direction::Up)?.are_plain();
        }
        let mut rooms: Vec<f64> = vec![ROOM_LEFT; columns];
        rooms[0] = ROOM_LEFT_OF_FIRST;
        for (place, (frame, title)) in frames.iter().zip(titles).enumerate() {
            let column = place % columns;
            let title = if column == 0 || all_titled { title } else { "" };
            let needed =
                room_beside(fonts, frame.y, height, title)? + if column == 0 { 0.0 } else { PANEL_GAP };
            rooms[column] = rooms[column].max(needed);
        }
        let beside: f64 = rooms.iter().sum();
        let panel = |right: f64| (width_mm * POINTS_PER_MM - beside - right) / columns as f64;
        let mut right = ROOM_RIGHT;
        for frame in frames.iter().skip(columns - 1).step_by(columns) {
            right = right.max(overhang(fonts, frame.x, panel(ROOM_RIGHT))? + 1.0);
        }
        let width = panel(right);
        let before = |column: usize| rooms[..=column].iter().sum::<f64>() + width * column as f64;
        Ok(Grid {
            width_mm,
            row_mm,
            lefts: (0..columns).map(before).collect(),
            width,
            rows: frames.len().div_ceil(columns),
            further: 0.0,
            all_titled,
        })
    }

    /// Room for a heading from the left edge of a panel to that of the next one or to the sheet's edge, in points.
    pub(crate) fn heading_room(&self, place: usize) -> f64 {
        let column = place % self.lefts.len();
        match self.lefts.get(column + 1) {
            Some(next) => next - self.lefts[column] - 12.0,
            None => self.width_mm * POINTS_PER_MM - self.lefts[column] - 2.0,
        }
    }

    /// Keeps room for one more line in every heading.
    pub(crate) fn add_heading_line(&mut self) {
        self.further += SUBHEADING_LEADING;
    }

    /// How far above a panel the baseline of its heading's first line is, in points.
    pub(crate) fn heading_rise(&self) -> f64 {
        LAST_LINE_RISE + HEADING_LEADING + self.further
    }

    pub(crate) fn height_mm(&self) -> f64 {
        self.rows as f64 * (self.row_mm + self.further / POINTS_PER_MM)
    }

    /// Where a panel is, in points.
    pub(crate) fn bounds(&self, place: usize) -> Bounds {
        let (column, row) = (place % self.lefts.len(), place / self.lefts.len());
        let pitch = self.row_mm * POINTS_PER_MM + self.further;
        let (left, above) = (self.lefts[column], pitch * row as f64);
        let (top, bottom) = (above + self.further + ROOM_ABOVE, above + pitch - ROOM_BELOW);
        Bounds { left, top, right: left + self.width, bottom }
    }

    /// Whether the vertical axis of a panel has a title of its own.
    pub(crate) fn is_titled(&self, place: usize) -> bool {
        self.all_titled || place.is_multiple_of(self.lefts.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_are_spread_evenly_over_as_few_sheets_as_hold_them() {
        let sizes = |width, panels| -> Vec<usize> {
            Grid::sheets(width, panels).into_iter().map(|range| range.len()).collect()
        };
        assert_eq!(sizes(SheetWidth::Paper, 0), []);
        assert_eq!(sizes(SheetWidth::Paper, 9), [9]);
        assert_eq!(sizes(SheetWidth::Paper, 10), [6, 4]);
        assert_eq!(sizes(SheetWidth::TwoColumns, 4), [4]);
        assert_eq!(sizes(SheetWidth::OneColumn, 8), [3, 3, 2]);
        for panels in 1..40 {
            for width in [SheetWidth::OneColumn, SheetWidth::Paper] {
                let sheets = Grid::sheets(width, panels);
                let places: Vec<usize> = sheets.into_iter().flatten().collect();
                assert_eq!(places, (0..panels).collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn panels_of_a_sheet_are_equal_and_apart_and_on_it() {
        let fonts = Fonts::load().unwrap();
        let frame = Frame { x: [0.123_456, 0.123_466], y: [0.5, 0.6] };
        for panels in 1..=9 {
            for width in [SheetWidth::Paper, SheetWidth::TwoColumns] {
                let mut grid =
                    Grid::new(&fonts, width, panels, &vec![frame; panels], &vec!["amplitude"; panels])
                        .unwrap();
                grid.add_heading_line();
                let sheet = Bounds {
                    left: 0.0,
                    top: 0.0,
                    right: grid.width_mm * POINTS_PER_MM,
                    bottom: grid.height_mm() * POINTS_PER_MM,
                };
                let all: Vec<Bounds> = (0..panels).map(|place| grid.bounds(place)).collect();
                for (place, bounds) in all.iter().enumerate() {
                    // Lengths add up to a rounding error, of the order of 1e-13 points.
                    assert!((bounds.right - bounds.left - grid.width).abs() < 1e-9);
                    assert!((bounds.bottom - bounds.top - (all[0].bottom - all[0].top)).abs() < 1e-9);
                    assert!(sheet.holds(&bounds.grown(8.0)), "{panels} panels: {bounds:?}");
                    assert!(all[..place].iter().all(|other| !other.grown(9.0).overlaps(bounds)));
                }
            }
        }
    }
}
