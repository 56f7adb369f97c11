//! Clouds of points: one path per shade and one square per bin, so that files with sixty thousand points
//! stay small.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::error::DrawingError;
use crate::geometry::sheet::{Bounds, Hundredths};
use crate::ink::canvas::Canvas;
use crate::ink::elements::{Ink, Shape};
use crate::ink::legend::dots;
use crate::ink::style::{CLOUD, CLOUD_BIN, Colour};
use crate::ink::svg::{hex, points};
use crate::plot::axes::Panel;

/// The meaning of a cloud in the legend.
pub(crate) const LONG_TIME: &str = "long-time behaviour";

/// The ink of bins of a grid: strokes in units of the size of a bin, from the corner of the grid.
struct Bins {
    /// The width and height of a bin, in points.
    scale: String,
    data: String,
    attributes: String,
}

impl Ink for Bins {
    fn draw(&self, rings: Vec<Vec<Hundredths>>, canvas: &Canvas) {
        let Bins { scale, data, attributes } = self;
        let path = |x, y| {
            format!("<path transform=\"translate({x} {y}) scale({scale})\" d=\"{data}\" {attributes}/>")
        };
        rings.iter().flatten().for_each(|corner| canvas.add_at(*corner, path));
    }
}

/// Draws the points within the frame as squares of `CLOUD_BIN` points, darker where several points share
/// a bin.
///
/// # Errors
/// As [`Canvas::draw`].
pub fn draw_cloud(panel: &mut Panel<'_>, cloud: &[(f64, f64)]) -> Result<(), DrawingError> {
    let mut counts: BTreeMap<(i64, i64), u32> = BTreeMap::new();
    for &point in cloud.iter().filter(|&&p| panel.frame.contains(p)) {
        let (x, y) = panel.spot(point);
        let column = ((x - panel.bounds.left) / CLOUD_BIN).floor() as i64;
        let row = ((y - panel.bounds.top) / CLOUD_BIN).floor() as i64;
        *counts.entry((row, column)).or_default() += 1;
    }
    let shade = |count: u32| match count {
        1 => 0,
        2..=3 => 1,
        _ => 2,
    };
    let corner = (panel.frame.x[0], panel.frame.y[1]);
    let shades = CLOUD.iter().enumerate().filter_map(|(level, paint)| {
        let bins: Vec<(i64, i64)> = counts.iter().filter(|c| shade(*c.1) == level).map(|c| *c.0).collect();
        let (colour, opacity) = (hex(paint.colour), points(paint.opacity));
        let attributes = format!("stroke=\"{colour}\" stroke-opacity=\"{opacity}\" stroke-width=\"1\"");
        let ink = Bins { scale: points(CLOUD_BIN), data: path_of_bins(&bins), attributes };
        (!bins.is_empty()).then(|| Shape::at(corner, ink))
    });
    panel.draw_series(shades)?.label(LONG_TIME).legend(dots(CLOUD[2]))?;
    Ok(())
}

/// Fills cells (row, column) of a grid over the panel with these numbers of columns and rows, rows
/// counted from the top, without seams: each slightly overlaps those above and below. Cells must be sorted.
///
/// # Errors
/// As [`Canvas::draw`].
pub fn draw_cells(
    panel: &mut Panel<'_>,
    [columns, rows]: [u32; 2],
    cells: &[(i64, i64)],
    colour: Colour,
) -> Result<(), DrawingError> {
    let Bounds { left, top, right, bottom } = panel.bounds;
    let [across, up] = [(right - left) / f64::from(columns), (bottom - top) / f64::from(rows)];
    let attributes =
        format!("stroke=\"{}\" stroke-width=\"1.06\" shape-rendering=\"crispEdges\"", hex(colour));
    let corner = (panel.frame.x[0], panel.frame.y[1]);
    let ink = Bins { scale: format!("{across} {up}"), data: path_of_bins(cells), attributes };
    panel.draw_series([Shape::at(corner, ink)])?;
    Ok(())
}

/// Path data that strokes each bin (row, column) by a horizontal line through its middle; bins must be
/// sorted.
fn path_of_bins(bins: &[(i64, i64)]) -> String {
    let mut data = String::new();
    let mut index = 0;
    let mut pen = None;
    while index < bins.len() {
        let (row, start) = bins[index];
        let mut end = start + 1;
        index += 1;
        while bins.get(index) == Some(&(row, end)) {
            end += 1;
            index += 1;
        }
        // Writing to a String cannot fail.
        let _ = match pen {
            None => write!(data, "M{start},{row}.5"),
            Some((pen_row, pen_column)) => write!(data, "m{},{}", start - pen_column, row - pen_row),
        };
        let _ = write!(data, "h{}", end - start);
        pen = Some((row, end));
    }
    data
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbouring_bins_of_a_row_become_one_stroke() {
        let data = path_of_bins(&[(2, 3), (2, 4), (2, 7), (5, 1)]);
        assert_eq!(data, "M3,2.5h2m2,0h1m-7,3h1");
    }
}
