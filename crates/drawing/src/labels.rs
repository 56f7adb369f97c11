//! Labels of one panel: placed while the figure is built up, drawn over everything else at the end.

use crate::DrawingError;
use crate::canvas::{Bounds, Canvas, Ink, Spot};
use crate::markup::Label;
use crate::placement::{Place, Placer};
use crate::style::{Colour, LEADER};

/// Free space kept around a label's ink, in points.
const PADDING: f64 = 1.2;

/// Where a label is wanted.
pub(crate) enum Wanted<'a> {
    /// Beside a curve, near its middle.
    Beside(&'a [Spot]),
    /// Around a spot, at least the clearance away.
    Around(Spot, f64),
    /// Inside a polygon.
    Within(&'a [Spot]),
}

/// Labels placed so far.
pub(crate) struct Labels<'c> {
    canvas: &'c Canvas,
    pub(crate) placer: Placer,
    placed: Vec<(Label, f64, Colour, Place)>,
}

impl<'c> Labels<'c> {
    pub(crate) fn new(canvas: &'c Canvas, panel: Bounds) -> Self {
        Labels {
            canvas,
            placer: Placer::new(panel),
            placed: Vec::new(),
        }
    }

    /// Finds a place for a label; false if there is none.
    pub(crate) fn add(
        &mut self,
        source: &str,
        size: f64,
        colour: Colour,
        wanted: &Wanted<'_>,
    ) -> Result<bool, DrawingError> {
        let label = Label::parse(source)?;
        let extent = self.canvas.measure(&label, size)?;
        let (width, height) = (extent.width + 2.0 * PADDING, extent.height() + 2.0 * PADDING);
        let place = match wanted {
            Wanted::Beside(curve) => self.placer.beside_curve(curve, width, height),
            Wanted::Around(spot, clearance) => self.placer.around(*spot, *clearance, width, height),
            Wanted::Within(polygon) => self.placer.within(polygon, width, height),
        };
        if let Some(place) = place {
            self.placed.push((label, size, colour, place));
        }
        Ok(place.is_some())
    }

    /// Draws all labels and their leaders.
    pub(crate) fn draw(self) -> Result<(), DrawingError> {
        for (label, size, colour, place) in &self.placed {
            if let Some((from, to)) = place.leader {
                self.canvas.draw(&[from, to], Ink::Line(LEADER))?;
            }
            self.canvas.text_in(&place.bounds, label, *size, *colour)?;
        }
        Ok(())
    }
}
