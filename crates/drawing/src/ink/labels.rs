//! Labels of one panel: positioned while the figure is built, drawn over everything else at the end.

use crate::error::DrawingError;
use crate::geometry::placement::{LabelPlace, Placer, WantedLabel};
use crate::geometry::sheet::{Bounds, Spot, along};
use crate::ink::canvas::{Anchor, Canvas};
use crate::ink::markup::Label;
use crate::ink::style::Colour;

/// Free space around a label's ink, in points.
const PADDING: f64 = 1.2;

/// The intended position of a label.
pub enum Site<'a> {
    /// Beside a curve, near its middle.
    Beside(&'a [Spot]),
    /// Beside a piece of a curve, the first if there is room, or else around one.
    Pieces(&'a [&'a [Spot]]),
    /// Around a spot, at least at this clearance.
    Around(Spot, f64),
    /// Around one of several spots.
    AroundAny(&'a [Spot], f64),
    /// Around one of several spots, however far away, and over lines and markers if there is no room off
    /// them.
    Anyhow(&'a [Spot], f64),
    /// Away from a curve, with a leader to it.
    Led(&'a [Spot]),
    /// Inside a polygon.
    Within(&'a [Spot]),
}

/// The clearance between a curve and the end of a leader to it, in points.
const OFF_CURVE: f64 = 1.5;

/// Spots along a curve to which a leader may point, from its middle outwards.
fn targets(curve: &[Spot]) -> impl Iterator<Item = Spot> {
    const FRACTIONS: [f64; 7] = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8];
    FRACTIONS.into_iter().filter_map(|fraction| along(curve, fraction)).map(|(spot, _)| spot)
}

/// The labels positioned so far.
pub struct Labels<'c> {
    pub(crate) canvas: &'c Canvas,
    /// The objects that labels avoid.
    pub placer: Placer,
    /// The greatest distance of a label from its spot, in points.
    pub(crate) farthest: f64,
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
        Labels { canvas, placer: Placer::new(panel), farthest: f64::INFINITY, placed: Vec::new() }
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
        let (text, farthest) = (sources.join(" "), self.farthest);
        let wanted = |width| WantedLabel {
            text: &text,
            width: width + 2.0 * PADDING,
            height,
            farthest,
            covers: false,
        };
        // The width in the embedded font is used if the wider fallback does not fit.
        let place = self.find(site, widths.map(wanted));
        if let Some(place) = place {
            self.placed.push(Placed { lines, reach: (ascent, descent), size, colour, place });
        }
        Ok(place.is_some())
    }

    /// A position for the first of several versions of a label for which there is one.
    fn find(&mut self, site: &Site<'_>, labels: [WantedLabel<'_>; 2]) -> Option<LabelPlace> {
        let beside = |placer: &mut Placer, curve: &[Spot], over_clouds| {
            labels.iter().find_map(|label| placer.beside_curve(curve, *label, over_clouds))
        };
        let around = |placer: &mut Placer, spots: &[Spot], clearance, led| {
            labels.iter().find_map(|label| placer.around(spots, clearance, *label, led))
        };
        let placer = &mut self.placer;
        match *site {
            Site::Beside(curve) => beside(placer, curve, false).or_else(|| beside(placer, curve, true)),
            Site::Pieces(pieces) => {
                let spots: Vec<Spot> = pieces.iter().flat_map(|piece| targets(piece)).collect();
                let clear = pieces.iter().find_map(|piece| beside(placer, piece, false));
                clear
                    .or_else(|| around(placer, &spots, OFF_CURVE, false))
                    .or_else(|| pieces.iter().find_map(|piece| beside(placer, piece, true)))
            }
            Site::Around(spot, clearance) => around(placer, &[spot], clearance, false),
            Site::AroundAny(spots, clearance) => around(placer, spots, clearance, false),
            Site::Anyhow(spots, clearance) => [false, true].into_iter().find_map(|covers| {
                let far = labels.map(|label| WantedLabel { farthest: f64::INFINITY, covers, ..label });
                far.into_iter().find_map(|label| placer.around(spots, clearance, label, false))
            }),
            Site::Led(curve) => around(placer, &targets(curve).collect::<Vec<_>>(), OFF_CURVE, true),
            Site::Within(polygon) => labels.iter().find_map(|label| placer.within(polygon, *label)),
        }
    }

    /// Draws all labels and their leaders.
    pub fn draw(self) -> Result<(), DrawingError> {
        for Placed { lines, reach: (ascent, descent), size, colour, place } in &self.placed {
            if let Some((from, to)) = place.leader {
                self.canvas.leader(from, to);
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
