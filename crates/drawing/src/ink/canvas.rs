//! The sheet on which a figure is drawn, in points from the top left corner.

use std::cell::RefCell;

use crate::error::DrawingError;
use crate::geometry::sheet::{Bounds, Hundredths, Spot, all_in_hundredths, in_hundredths};
use crate::geometry::simplify::simplify;
use crate::ink::font::{Extent, Fonts};
use crate::ink::legend::Sample;
use crate::ink::markup::Label;
use crate::ink::measured::MeasuredMark;
use crate::ink::sheet::{Element, Path, Sheet};
use crate::ink::style::{Colour, LEADER, Paint, Pen, SIZE_LIMIT, hat_pen};
use crate::ink::svg::{POINTS_PER_MM, fill, hex, hundredths, points, spans, stroke};

/// The point of its baseline by which a text is placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// The beginning of the text.
    Start,
    /// The middle of the text.
    Middle,
    /// The end of the text.
    End,
    /// The middle of the text, which reads upwards.
    Upwards,
}

/// An unfinished sheet.
pub struct Canvas {
    /// The fonts, with which labels are measured.
    pub fonts: Fonts,
    /// The width of the sheet, in points.
    pub width: f64,
    /// The height of the sheet, in points.
    pub height: f64,
    elements: RefCell<Vec<Element>>,
    /// Every label drawn so far, with the bounding box of its ink.
    texts: RefCell<Vec<(String, Bounds)>>,
    /// The boxes to which lines are clipped.
    clips: RefCell<Vec<Bounds>>,
    legend: RefCell<Vec<(String, Sample)>>,
}

impl Canvas {
    /// An empty sheet.
    ///
    /// # Errors
    /// The embedded fonts cannot be read.
    pub fn new(width_mm: f64, height_mm: f64) -> Result<Self, DrawingError> {
        let (width, height) = (width_mm * POINTS_PER_MM, height_mm * POINTS_PER_MM);
        let (elements, texts, clips, legend) = Default::default();
        Ok(Canvas { fonts: Fonts::load()?, width, height, elements, texts, clips, legend })
    }

    /// Adds an entry to the legend, unless it exists: the meaning of objects drawn like the sample.
    pub fn explain(&self, meaning: &str, sample: Sample) {
        let mut legend = self.legend.borrow_mut();
        if legend.iter().all(|(known, _)| known != meaning) {
            legend.push((meaning.to_owned(), sample));
        }
    }

    /// Adds an element.
    pub(crate) fn add(&self, element: Element) {
        self.elements.borrow_mut().push(element);
    }

    /// Adds a path; consecutive spots that coincide in the file are written once.
    pub(crate) fn path(&self, pieces: impl IntoIterator<Item = (Vec<Hundredths>, bool)>, attributes: String) {
        let distinct = |(mut spots, closed): (Vec<Hundredths>, bool)| {
            spots.dedup();
            (spots, closed)
        };
        self.add(Element::Path(Path { pieces: pieces.into_iter().map(distinct).collect(), attributes }));
    }

    /// Draws a line, closed if it ends where it begins; a line shorter than the resolution of print is
    /// omitted.
    pub fn line(&self, spots: &[Spot], pen: Pen) {
        self.attributed_line(spots, stroke(Some(pen)));
    }

    /// Draws the leader of a label.
    pub(crate) fn leader(&self, from: Spot, to: Spot) {
        self.attributed_line(&[from, to], format!(" class=\"leader\"{}", stroke(Some(LEADER))));
    }

    /// Draws a line clipped so that no ink leaves a box.
    pub(crate) fn line_within(&self, bounds: &Bounds, spots: &[Spot], pen: Pen) {
        let reach = bounds.grown(-0.5 * pen.width);
        let close = |&(x, y): &Spot| !reach.holds(&Bounds::about((x, y), 0.0, 0.0));
        let clip = if spots.iter().any(close) { self.clip(bounds) } else { String::new() };
        self.attributed_line(spots, stroke(Some(pen)) + &clip);
    }

    fn attributed_line(&self, spots: &[Spot], attributes: String) {
        let mut path = simplify(&all_in_hundredths(spots));
        let closed = path.len() > 3 && path.first() == path.last();
        if closed {
            path.pop();
        }
        if path.iter().any(|spot| *spot != path[0]) {
            self.path([(path, closed)], attributes);
        }
    }

    /// The attribute that clips an element to a box.
    fn clip(&self, bounds: &Bounds) -> String {
        let mut clips = self.clips.borrow_mut();
        let known = clips.iter().position(|known| known == bounds);
        let number = known.unwrap_or_else(|| {
            let Bounds { left, top, right, bottom } = *bounds;
            let [x, y, width, height] = [left, top, right - left, bottom - top].map(points);
            let number = clips.len();
            self.add(Element::Markup(format!(
                "<clipPath id=\"clip{number}\"><rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"/></clipPath>"
            )));
            clips.push(*bounds);
            number
        });
        format!(" clip-path=\"url(#clip{number})\"")
    }

    /// Draws a filled polygon, optionally with an outline.
    pub fn polygon(&self, corners: &[Spot], paint: Paint, outline: Option<Pen>) {
        self.path([(all_in_hundredths(corners), true)], fill(paint) + &stroke(outline));
    }

    /// Draws a filled area inside its rings by the even-odd rule.
    pub(crate) fn area(&self, rings: &[Vec<Spot>], paint: Paint) {
        let rings = rings.iter().map(|ring| (all_in_hundredths(ring), true));
        self.path(rings, format!(" fill-rule=\"evenodd\"{}", fill(paint)));
    }

    /// Draws an element positioned at one spot, whose coordinates are passed to `write`.
    fn draw_at(&self, spot: Spot, write: impl Fn(String, String) -> String) {
        let (x, y) = in_hundredths(spot);
        self.add(Element::Markup(write(hundredths(x), hundredths(y))));
    }

    /// Draws a filled disc, optionally with an outline.
    pub fn disc(&self, centre: Spot, radius: f64, paint: Paint, outline: Option<Pen>) {
        let (r, fill, outline) = (points(radius), fill(paint), stroke(outline));
        self.draw_at(centre, |x, y| format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{fill}{outline}/>"));
    }

    /// Draws the mark of a measurement about a spot.
    pub(crate) fn measured(&self, mark: MeasuredMark, centre: Spot) {
        for (spots, closed, attributes) in mark.strokes(centre) {
            self.path([(spots, closed)], attributes);
        }
    }

    /// Draws squares of a given side on a grid with its top left corner at `corner`; `data` is path data
    /// in units of the side.
    pub(crate) fn bins(&self, corner: Spot, side: f64, data: &str, paint: Paint) {
        let (side, colour, opacity) = (points(side), hex(paint.colour), points(paint.opacity));
        self.draw_at(corner, |x, y| {
            format!(
                "<path transform=\"translate({x} {y}) scale({side})\" d=\"{data}\" stroke=\"{colour}\" \
                 stroke-opacity=\"{opacity}\" stroke-width=\"1\"/>"
            )
        });
    }

    /// Draws cells of a given width and height like [`bins`](Self::bins), without seams: each slightly
    /// overlaps those above and below.
    pub(crate) fn cells(&self, corner: Spot, [across, up]: [f64; 2], data: &str, paint: Paint) {
        let colour = hex(paint.colour);
        self.draw_at(corner, |x, y| {
            format!(
                "<path transform=\"translate({x} {y}) scale({across} {up})\" d=\"{data}\" stroke=\"{colour}\" \
                 stroke-width=\"1.06\" shape-rendering=\"crispEdges\"/>"
            )
        });
    }

    /// Draws a label with its baseline at the spot.
    ///
    /// # Errors
    /// The label cannot be set in the embedded fonts.
    pub fn text(
        &self,
        spot: Spot,
        source: &str,
        size: f64,
        anchor: Anchor,
        colour: Colour,
    ) -> Result<(), DrawingError> {
        self.label(spot, &Label::parse(source)?, size, anchor, colour)
    }

    /// Draws a parsed label with its baseline at the spot.
    pub(crate) fn label(
        &self,
        (x, y): Spot,
        label: &Label,
        size: f64,
        anchor: Anchor,
        colour: Colour,
    ) -> Result<(), DrawingError> {
        let extent @ Extent { width, ascent, descent } = self.fonts.measure(label, size)?;
        if label.runs.is_empty() {
            return Ok(());
        }
        let (start, attributes) = match anchor {
            Anchor::Start => (0.0, String::new()),
            Anchor::Middle => (-0.5 * width, " text-anchor=\"middle\"".to_owned()),
            Anchor::End => (-width, " text-anchor=\"end\"".to_owned()),
            Anchor::Upwards => {
                let turn = format!("transform=\"rotate(-90 {} {})\"", points(x), points(y));
                (-0.5 * width, format!(" text-anchor=\"middle\" {turn}"))
            }
        };
        // The position at a distance along the baseline from the label's start, and at a distance below
        // the baseline.
        let place = |along: f64, below: f64| match anchor {
            Anchor::Upwards => (x + below, y - (start + along)),
            _ => (x + (start + along), y + below),
        };
        let spare = extent.room() - width;
        let before = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle | Anchor::Upwards => 0.5 * spare,
            Anchor::End => spare,
        };
        let (a, b) = (place(-before, -ascent), place(width + spare - before, descent));
        let taken =
            Bounds { left: a.0.min(b.0), top: a.1.min(b.1), right: a.0.max(b.0), bottom: a.1.max(b.1) };
        self.texts.borrow_mut().push((label.source.clone(), taken));
        let (fill, spans, height) = (hex(colour), spans(label, size), points(size));
        self.draw_at((x, y), |x, y| {
            format!(
                "<text x=\"{x}\" y=\"{y}\" font-size=\"{height}\"{attributes} fill=\"{fill}\">{spans}</text>"
            )
        });
        for hat in self.fonts.hats(label, size)? {
            self.line(&hat.map(|(right, down)| place(right, down)), hat_pen(size, colour));
        }
        Ok(())
    }

    /// The bounds of the whole sheet.
    pub(crate) fn sheet(&self) -> Bounds {
        Bounds { left: 0.0, top: 0.0, right: self.width, bottom: self.height }
    }

    /// The finished figure, with this title and description.
    ///
    /// # Errors
    /// The figure exceeds the size limit.
    pub fn finish(self, figure: &'static str, title: &str, description: &str) -> Result<Sheet, DrawingError> {
        let legend = self.legend.into_inner().into_iter();
        let [width, height] = [self.width, self.height].map(|length| (length * 100.0).round() / 100.0);
        let sheet = Sheet {
            title: title.to_owned(),
            description: description.to_owned(),
            size: (width, height),
            elements: self.elements.into_inner(),
            legend: legend.map(|(meaning, sample)| (meaning, sample.element())).collect(),
            texts: self.texts.into_inner(),
        };
        let bytes = sheet.svg().len();
        if bytes > SIZE_LIMIT {
            return Err(DrawingError(format!("{figure} came to {bytes} bytes; the limit is {SIZE_LIMIT}")));
        }
        Ok(sheet)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ink::style::{BLACK, FRAME};

    #[test]
    fn a_line_that_shrinks_to_a_point_is_not_written() {
        let canvas = Canvas::new(10.0, 10.0).unwrap();
        canvas.line(&[(1.0, 2.0), (1.0, 2.0)], FRAME);
        canvas.line(&[(1.0, 2.0), (1.0, 2.0), (3.0, 2.0), (3.0, 2.0)], FRAME);
        let svg = canvas.finish("test", "", "").unwrap().svg();
        assert!(svg.contains("d=\"M1,2L3,2\"") && svg.matches("<path").count() == 1, "{svg}");
    }

    #[test]
    fn a_title_may_read_upwards() {
        let canvas = Canvas::new(100.0, 100.0).unwrap();
        canvas.text((10.5, 50.0), "amplitude", 10.0, Anchor::Upwards, BLACK).unwrap();
        let svg = canvas.finish("test", "", "").unwrap().svg();
        assert!(svg.contains("x=\"10.5\" y=\"50\"") && svg.contains("rotate(-90 10.5 50)"), "{svg}");
        assert!(svg.contains("fill=\"none\""), "nothing is filled unless it says so");
    }
}
