//! Legends: what is drawn, and a sample of it. They put no ink on the sheet; a figure's file holds its legend for those who show it.

use std::fmt::Write;

use crate::geometry::shapes::triangle;
use crate::geometry::sheet::in_hundredths;
use crate::ink::style::{DISC_RADIUS, MARKER, Paint, Pen, TRIANGLE_SIZE};
use crate::ink::svg::{escape, fill, path_data, points, stroke};

/// A sample of what is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Sample {
    Line(Pen),
    Area(Paint),
    Hatching(Pen),
    Rectangle(Pen),
    Dots(Paint),
    Triangle,
    Disc,
}

impl Sample {
    /// Its drawing in a box of 24 by 10 points.
    fn element(self) -> String {
        match self {
            Sample::Line(pen) => format!("<path d=\"M0,5L24,5\"{}/>", stroke(Some(pen))),
            Sample::Area(paint) => format!("<rect width=\"24\" height=\"10\"{}/>", fill(paint)),
            Sample::Hatching(pen) => {
                format!("<path d=\"M2,9L10,1M8,9L16,1M14,9L22,1\"{}/>", stroke(Some(pen)))
            }
            Sample::Rectangle(pen) => {
                format!("<path d=\"M5,1L19,1L19,9L5,9Z\"{}/>", stroke(Some(pen)))
            }
            Sample::Dots(paint) => {
                let dots = [(4, 3), (9, 7), (12, 4), (17, 5), (20, 8)];
                let dot = |(x, y)| format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"0.6\"{}/>", fill(paint));
                dots.into_iter().map(dot).collect()
            }
            Sample::Triangle => {
                let corners = triangle((12.0, 5.5), TRIANGLE_SIZE).map(in_hundredths);
                format!("<path d=\"{}\"{}/>", path_data(&corners, true), fill(MARKER))
            }
            Sample::Disc => {
                format!("<circle cx=\"12\" cy=\"5\" r=\"{}\"{}/>", points(DISC_RADIUS), fill(MARKER))
            }
        }
    }
}

/// The entries, in the order of drawing.
#[derive(Debug, Default)]
pub(crate) struct Legend(Vec<(String, Sample)>);

impl Legend {
    /// Adds an entry unless there is one with this meaning.
    pub(crate) fn explain(&mut self, meaning: &str, sample: Sample) {
        if self.0.iter().all(|(known, _)| known != meaning) {
            self.0.push((meaning.to_owned(), sample));
        }
    }

    /// An element of class `legend` that is not drawn, with a group for each entry: its label is the meaning, in words with formulas
    /// between dollars, its content the sample in a box of 24 by 10 points. Nothing without entries.
    pub(crate) fn element(&self) -> String {
        let mut entries = String::new();
        for (meaning, sample) in &self.0 {
            // Writing to a String cannot fail.
            let _ = write!(entries, "<g aria-label=\"{}\">{}</g>", escape(meaning), sample.element());
        }
        if entries.is_empty() { entries } else { format!("<defs class=\"legend\">{entries}</defs>\n") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ink::style::FRAME;

    #[test]
    fn a_meaning_is_explained_once_and_an_empty_legend_is_no_element() {
        let mut legend = Legend::default();
        assert_eq!(legend.element(), "");
        legend.explain("a < b", Sample::Line(FRAME));
        legend.explain("a < b", Sample::Disc);
        assert_eq!(
            legend.element(),
            "<defs class=\"legend\"><g aria-label=\"a &lt; b\"><path d=\"M0,5L24,5\" stroke=\"#000000\" stroke-width=\"0.6\"/></g></defs>\n"
        );
    }
}
