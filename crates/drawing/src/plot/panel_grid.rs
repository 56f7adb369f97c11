//! Sheets of panels: rows of equal panels, with room for headings, numbers and titles.

use std::ops::Range;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::{Frame, Names};

use crate::error::DrawingError;
use crate::geometry::sheet::{Bounds, Spot};
use crate::ink::canvas::{Anchor, Canvas};
use crate::ink::font::Fonts;
use crate::ink::markup::Label;
use crate::ink::sheet::Sheet;
use crate::ink::style::{BLACK, Colour, SheetWidth};
use crate::ink::svg::POINTS_PER_MM;
use crate::plot::axes::{Heading, Panel, overhang, room_for};
use crate::plot::numbers::{Decades, Numbers};

/// The width of these sheets in the paper.
const WIDTH_MM: f64 = 156.0;
/// Sheets at least this wide have panels side by side; on others they are one above the other.
const SIDE_BY_SIDE_MM: f64 = 120.0;
/// The height of a row with headings of two lines, numbers and axis titles, for one, two and three panels
/// side by side and for panels one above the other; three rows and a caption fill a page.
const ROW_MM: [f64; 3] = [92.0, 75.0, 63.0];
const STACKED_ROW_MM: f64 = 54.0;
const ROWS_A_SHEET: usize = 3;
/// Room to the left of a panel for its numbers and the gap to the previous panel, in points; the first
/// one in a row has the axis title too. Longer numbers get more.
const ROOM_LEFT: f64 = 34.0;
const ROOM_LEFT_OF_FIRST: f64 = 44.0;
const PANEL_GAP: f64 = 4.0;
const ROOM_RIGHT: f64 = 9.0;
/// Room above a panel for a heading of two lines, and below it for numbers and axis title, in points.
const ROOM_ABOVE: f64 = 27.0;
const ROOM_BELOW: f64 = 30.0;
/// The height of the baseline of a heading's last line above the panel, in points.
const LAST_LINE_RISE: f64 = 5.0;
/// The distance from the baseline of a heading's first line to that of the second, and between further
/// lines, in points.
const HEADING_LEADING: f64 = 11.0;
const SUBHEADING_LEADING: f64 = 9.5;

/// A panel on one of the sheets.
pub(crate) struct GridPanel<'a> {
    pub(crate) frame: Frame,
    /// The title of the vertical axis.
    pub(crate) up: &'a str,
    /// The decades of the vertical axis, if it is one of decades.
    pub(crate) decades: Option<Decades>,
    /// The names of the parameters; `only` distinguishes the panel's rows. Both are as in [`Panel`].
    pub(crate) names: Option<&'a Names>,
    pub(crate) only: Option<(&'static str, u32)>,
    /// The first line of the heading, and its size.
    pub(crate) first: (String, f64),
    /// The parts of the second line, and their size; each part is on a line of its own if they do not fit
    /// on one.
    pub(crate) parts: (Vec<String>, f64),
}

impl GridPanel<'_> {
    /// The parts of the second line, joined.
    fn joined(&self) -> String {
        self.parts.0.join(",  ")
    }

    /// The numbers along the vertical axis.
    fn numbers_up(&self, fonts: &Fonts, height: f64) -> Result<Numbers, DrawingError> {
        Numbers::up(fonts, self.frame.y, height, self.decades)
    }

    /// Whether the parts of the second line fit on one line of `room` points.
    fn fits(&self, fonts: &Fonts, room: f64) -> Result<bool, DrawingError> {
        let one = self.parts.0.len() < 2;
        Ok(one || fonts.measure(&Label::parse(&self.joined())?, self.parts.1)?.room() <= room)
    }

    /// Writes the heading from a spot on.
    fn write_heading(
        &self,
        canvas: &Canvas,
        (left, mut baseline): Spot,
        split: bool,
    ) -> Result<(), DrawingError> {
        canvas.text((left, baseline), &self.first.0, self.first.1, Anchor::Start, BLACK)?;
        baseline += HEADING_LEADING;
        let lines = if split { self.parts.0.clone() } else { vec![self.joined()] };
        for line in lines {
            canvas.text((left, baseline), &line, self.parts.1, Anchor::Start, BLACK)?;
            baseline += SUBHEADING_LEADING;
        }
        Ok(())
    }
}

/// Draws panels over one parameter on as many sheets as needed, with other colours of kinds of curves, none if there is
/// no panel; `draw` receives each panel with its number from 0. If there are several sheets, their titles are numbered.
pub(crate) fn draw_panels(
    heading: &Heading<'_>,
    (width, colours): (SheetWidth, &[(Bifurcation, Colour)]),
    across: &str,
    panels: &[GridPanel<'_>],
    draw: impl Fn(&mut Panel<'_>, usize) -> Result<(), DrawingError>,
) -> Result<Vec<Sheet>, DrawingError> {
    let sheets = sheets(width, panels.len());
    let (count, fonts) = (sheets.len(), Fonts::load()?);
    let draw_sheet = |(range, number): (Range<usize>, usize)| {
        let (start, shown) = (range.start, &panels[range]);
        let mut grid = Grid::new(&fonts, width, panels.len(), shown)?;
        // All headings of a sheet have the same number of lines: if one needs more, each gets them.
        let mut split = false;
        for (place, panel) in shown.iter().enumerate() {
            split |= !panel.fits(&fonts, grid.heading_room(place))?;
        }
        if split {
            grid.further += SUBHEADING_LEADING;
        }
        let canvas = Canvas::new(grid.width_mm, grid.height_mm())?.coloured(colours);
        for (place, shown) in shown.iter().enumerate() {
            let GridPanel { frame, only, decades, .. } = *shown;
            let columns = shown.names.and_then(Names::columns);
            let bounds = grid.bounds(place);
            let tables = heading.tables;
            let mut panel = Panel { tables, only, columns, decades, ..Panel::new(&canvas, frame, bounds)? };
            draw(&mut panel, start + place)?;
            panel.axes(across, if grid.is_titled(place) { shown.up } else { "" })?;
            shown.write_heading(&canvas, (bounds.left, bounds.top - grid.heading_rise()), split)?;
        }
        let of = if count > 1 { format!(" ({number} of {count})") } else { String::new() };
        canvas.finish(heading.name, &format!("{}{of}", heading.title), heading.description)
    };
    sheets.into_iter().zip(1..).map(draw_sheet).collect()
}

/// The panels on each sheet, as ranges.
pub(crate) fn sheets(width: SheetWidth, panels: usize) -> Vec<Range<usize>> {
    let (columns, _) = row(width.mm(WIDTH_MM), panels);
    let sheets = panels.div_ceil(columns * ROWS_A_SHEET).max(1);
    let each = panels.div_ceil(sheets).next_multiple_of(columns).max(1);
    (0..panels).step_by(each).map(|first| first..(first + each).min(panels)).collect()
}

/// The panels of one sheet.
struct Grid {
    width_mm: f64,
    row_mm: f64,
    /// Left edges of the columns and the width of a panel, in points.
    lefts: Vec<f64>,
    width: f64,
    rows: usize,
    /// Room for headings beyond [`ROOM_ABOVE`], in points.
    further: f64,
    /// Whether every panel has a title on its vertical axis, because their numbers have different
    /// meanings.
    all_titled: bool,
}

/// The number of panels side by side, and the height of their row.
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
    /// The grid of a sheet that shows these panels; `panels` is the number of panels on all sheets.
    fn new(
        fonts: &Fonts,
        width: SheetWidth,
        panels: usize,
        shown: &[GridPanel<'_>],
    ) -> Result<Self, DrawingError> {
        let width_mm = width.mm(WIDTH_MM);
        let (columns, row_mm) = row(width_mm, panels);
        let height = row_mm * POINTS_PER_MM - ROOM_ABOVE - ROOM_BELOW;
        let mut all_titled = shown.windows(2).any(|pair| pair[0].up != pair[1].up);
        for panel in shown {
            all_titled |= !panel.numbers_up(fonts, height)?.are_plain();
        }
        let mut rooms: Vec<f64> = vec![ROOM_LEFT; columns];
        rooms[0] = ROOM_LEFT_OF_FIRST;
        for (place, panel) in shown.iter().enumerate() {
            let column = place % columns;
            let title = if column == 0 || all_titled { panel.up } else { "" };
            let numbers = panel.numbers_up(fonts, height)?;
            let needed = room_for(fonts, &numbers, title)? + if column == 0 { 0.0 } else { PANEL_GAP };
            rooms[column] = rooms[column].max(needed);
        }
        let beside: f64 = rooms.iter().sum();
        let panel = |right: f64| (width_mm * POINTS_PER_MM - beside - right) / columns as f64;
        let mut right = ROOM_RIGHT;
        for GridPanel { frame, .. } in shown.iter().skip(columns - 1).step_by(columns) {
            right = right.max(overhang(fonts, frame.x, panel(ROOM_RIGHT))? + 1.0);
        }
        let width = panel(right);
        let before = |column: usize| rooms[..=column].iter().sum::<f64>() + width * column as f64;
        Ok(Grid {
            width_mm,
            row_mm,
            lefts: (0..columns).map(before).collect(),
            width,
            rows: shown.len().div_ceil(columns),
            further: 0.0,
            all_titled,
        })
    }

    /// Room for a heading from the left edge of a panel to that of the next one, or to the edge of the
    /// sheet, in points.
    fn heading_room(&self, place: usize) -> f64 {
        let column = place % self.lefts.len();
        match self.lefts.get(column + 1) {
            Some(next) => next - self.lefts[column] - 12.0,
            None => self.width_mm * POINTS_PER_MM - self.lefts[column] - 2.0,
        }
    }

    /// The height of the baseline of a heading's first line above its panel, in points.
    fn heading_rise(&self) -> f64 {
        LAST_LINE_RISE + HEADING_LEADING + self.further
    }

    fn height_mm(&self) -> f64 {
        self.rows as f64 * (self.row_mm + self.further / POINTS_PER_MM)
    }

    /// The bounds of a panel, in points.
    fn bounds(&self, place: usize) -> Bounds {
        let (column, row) = (place % self.lefts.len(), place / self.lefts.len());
        let pitch = self.row_mm * POINTS_PER_MM + self.further;
        let (left, above) = (self.lefts[column], pitch * row as f64);
        let (top, bottom) = (above + self.further + ROOM_ABOVE, above + pitch - ROOM_BELOW);
        Bounds { left, top, right: left + self.width, bottom }
    }

    /// Whether the vertical axis of a panel has a title of its own.
    fn is_titled(&self, place: usize) -> bool {
        self.all_titled || place.is_multiple_of(self.lefts.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_are_spread_evenly_over_as_few_sheets_as_hold_them() {
        let sizes = |width, panels| -> Vec<usize> {
            sheets(width, panels).into_iter().map(|range| range.len()).collect()
        };
        assert_eq!(sizes(SheetWidth::Paper, 0), []);
        assert_eq!(sizes(SheetWidth::Paper, 9), [9]);
        assert_eq!(sizes(SheetWidth::Paper, 10), [6, 4]);
        assert_eq!(sizes(SheetWidth::TwoColumns, 4), [4]);
        assert_eq!(sizes(SheetWidth::OneColumn, 8), [3, 3, 2]);
        for panels in 1..40 {
            for width in [SheetWidth::OneColumn, SheetWidth::Paper] {
                let sheets = sheets(width, panels);
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
                let panel = |_| GridPanel {
                    frame,
                    up: "amplitude",
                    decades: None,
                    names: None,
                    only: None,
                    first: (String::new(), 9.0),
                    parts: (Vec::new(), 7.5),
                };
                let shown: Vec<_> = (0..panels).map(panel).collect();
                let mut grid = Grid::new(&fonts, width, panels, &shown).unwrap();
                grid.further += SUBHEADING_LEADING;
                let sheet = Bounds {
                    left: 0.0,
                    top: 0.0,
                    right: grid.width_mm * POINTS_PER_MM,
                    bottom: grid.height_mm() * POINTS_PER_MM,
                };
                let all: Vec<Bounds> = (0..panels).map(|place| grid.bounds(place)).collect();
                for (place, bounds) in all.iter().enumerate() {
                    // Lengths add up to within a rounding error of about 1e-13 points.
                    assert!((bounds.right - bounds.left - grid.width).abs() < 1e-9);
                    assert!((bounds.bottom - bounds.top - (all[0].bottom - all[0].top)).abs() < 1e-9);
                    assert!(sheet.holds(&bounds.grown(8.0)), "{panels} panels: {bounds:?}");
                    assert!(all[..place].iter().all(|other| !other.grown(9.0).overlaps(bounds)));
                }
            }
        }
    }
}
