//! Clouds of points: one path per shade and one square per bin, so that files with sixty thousand points
//! stay small.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::geometry::sheet::Bounds;
use crate::ink::legend::Sample;
use crate::ink::style::{CLOUD, CLOUD_BIN, Colour, Paint};
use crate::plot::axes::Panel;

/// The meaning of a cloud in the legend.
pub(crate) const LONG_TIME: &str = "long-time behaviour";

/// Draws the points within the frame as squares of `CLOUD_BIN` points, darker where several points share
/// a bin.
pub fn draw_cloud(panel: &Panel<'_>, points: &[(f64, f64)]) {
    let mut counts: BTreeMap<(i64, i64), u32> = BTreeMap::new();
    for &point in points.iter().filter(|&&p| panel.frame.contains(p)) {
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
    for (level, paint) in CLOUD.iter().enumerate() {
        let bins: Vec<(i64, i64)> = counts.iter().filter(|c| shade(*c.1) == level).map(|c| *c.0).collect();
        if !bins.is_empty() {
            panel.canvas.explain(LONG_TIME, Sample::Dots(CLOUD[2]));
            let corner = (panel.bounds.left, panel.bounds.top);
            panel.canvas.bins(corner, CLOUD_BIN, &path_of_bins(&bins), *paint);
        }
    }
}

/// Fills cells (row, column) of a grid over the panel with these numbers of columns and rows, rows
/// counted from the top; cells must be sorted.
pub fn draw_cells(panel: &Panel<'_>, [columns, rows]: [u32; 2], cells: &[(i64, i64)], colour: Colour) {
    let Bounds { left, top, right, bottom } = panel.bounds;
    let size = [(right - left) / f64::from(columns), (bottom - top) / f64::from(rows)];
    panel.canvas.cells((left, top), size, &path_of_bins(cells), Paint::opaque(colour));
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
