//! Labels of one panel: positioned while the figure is built, drawn over everything else at the end.

use crate::error::DrawingError;
use crate::geometry::placement::{LabelPlace, Placer};
use crate::geometry::sheet::{Bounds, Spot, along};
use crate::ink::canvas::{Anchor, Canvas};
use crate::ink::markup::Label;
use crate::ink::style::{Colour, LEADER};

/// Free space around a label's ink, in points.
const PADDING: f64 = 1.2;

/// The intended position of a label.
pub enum Site<'a> {
    /// Beside a curve, near its middle.
    Beside(&'a [Spot]),
    /// Around a spot, at least at this clearance.
    Around(Spot, f64),
    /// Inside a polygon.
    Within(&'a [Spot]),
}

/// The labels positioned so far.
pub struct Labels<'c> {
    canvas: &'c Canvas,
    /// The objects that labels avoid.
    pub placer: Placer,
    placed: Vec<Placed>,
}

/// A label of one or more centred lines at its position.
struct Placed {
    lines: Vec<Label>,
    /// The greatest reach of the ink of any line above and below its baseline.
    reach: (f64, f64),
    size: f64,
    colour: Colour,
    place: LabelPlace,
}

/// The distance between consecutive baselines, in units of the font size.
const LEADING: f64 = 1.15;

impl<'c> Labels<'c> {
    /// An empty set of labels, which will stay inside the panel and be drawn on the canvas.
    pub fn new(canvas: &'c Canvas, panel: Bounds) -> Self {
        Labels { canvas, placer: Placer::new(panel), placed: Vec::new() }
    }

    /// Finds a position for a label; false if there is none.
    pub fn add(
        &mut self,
        source: &str,
        size: f64,
        colour: Colour,
        site: &Site<'_>,
    ) -> Result<bool, DrawingError> {
        self.add_lines(&[source], size, colour, site)
    }

    /// Finds a position for a label of several centred lines; false if there is none.
    pub fn add_lines(
        &mut self,
        sources: &[&str],
        size: f64,
        colour: Colour,
        site: &Site<'_>,
    ) -> Result<bool, DrawingError> {
        let mut lines = Vec::new();
        let (mut widths, mut ascent, mut descent) = ([0.0_f64; 2], 0.0_f64, 0.0_f64);
        for source in sources {
            let label = Label::parse(source)?;
            let extent = self.canvas.fonts.measure(&label, size)?;
            widths = [widths[0].max(extent.room()), widths[1].max(extent.width)];
            ascent = ascent.max(extent.ascent);
            descent = descent.max(extent.descent);
            lines.push(label);
        }
        let further = LEADING * size * lines.len().saturating_sub(1) as f64;
        let height = ascent + further + descent + 2.0 * PADDING;
        let placer = &mut self.placer;
        // The width in the embedded font is used if the wider fallback does not fit.
        let place = widths.map(|width| width + 2.0 * PADDING).into_iter().find_map(|width| match site {
            Site::Beside(curve) => placer.beside_curve(curve, width, height),
            Site::Around(spot, clearance) => placer.around(*spot, *clearance, width, height),
            Site::Within(polygon) => placer.within(polygon, width, height),
        });
        if let Some(place) = place {
            self.placed.push(Placed { lines, reach: (ascent, descent), size, colour, place });
        }
        Ok(place.is_some())
    }

    /// Labels a curve beside it or, if there is no room, farther away with a leader to its middle.
    pub fn name_curve(
        &mut self,
        source: &str,
        size: f64,
        colour: Colour,
        curve: &[Spot],
    ) -> Result<(), DrawingError> {
        if self.add(source, size, colour, &Site::Beside(curve))? {
            return Ok(());
        }
        if let Some((middle, _)) = along(curve, 0.5) {
            self.add(source, size, colour, &Site::Around(middle, 1.5))?;
        }
        Ok(())
    }

    /// Draws all labels and their leaders.
    pub fn draw(self) -> Result<(), DrawingError> {
        for Placed { lines, reach: (ascent, descent), size, colour, place } in &self.placed {
            if let Some((from, to)) = place.leader {
                self.canvas.line(&[from, to], LEADER);
            }
            let (x, y) = place.bounds.centre();
            let middle = y + 0.5 * (ascent - descent);
            for (index, label) in lines.iter().enumerate() {
                let line = index as f64 - 0.5 * (lines.len() as f64 - 1.0);
                let baseline = middle + LEADING * size * line;
                self.canvas.label((x, baseline), label, *size, Anchor::Middle, *colour)?;
            }
        }
        Ok(())
    }
}
