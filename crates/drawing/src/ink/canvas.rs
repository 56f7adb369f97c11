//! The sheet on which a figure is drawn, in points from the top left corner. Plots are drawn on it by
//! plotters, whose backend it is.

use std::cell::RefCell;
use std::rc::Rc;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::kinds::CurveLook;
use plotters::coord::CoordTranslate;
use plotters::drawing::IntoDrawingArea;
use plotters::element::{Drawable, PointCollection};
use plotters_backend::BackendCoord;

use crate::error::DrawingError;
use crate::geometry::sheet::{Bounds, Hundredths, Spot, all_in_hundredths, in_hundredths, in_points};
use crate::geometry::simplify::simplify;
use crate::ink::font::{Extent, Fonts};
use crate::ink::markup::Label;
use crate::ink::sheet::{Element, Path, Sheet};
use crate::ink::style::{Colour, LEADER, Pen, SIZE_LIMIT, hat_pen};
use crate::ink::svg::{POINTS_PER_MM, hex, hundredths, path_data, points, spans, stroke};

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

/// An unfinished sheet, of which clones are further handles, as plotters takes its backend by value.
#[derive(Clone)]
pub struct Canvas {
    /// The fonts, with which labels are measured.
    pub fonts: Rc<Fonts>,
    /// The width of the sheet, in points.
    pub width: f64,
    /// The height of the sheet, in points.
    pub height: f64,
    /// The colours of kinds of curves that do not have the usual one.
    colours: Rc<[(Bifurcation, Colour)]>,
    drawn: Rc<Drawn>,
}

/// What has been drawn on a sheet.
#[derive(Default)]
struct Drawn {
    elements: RefCell<Vec<Element>>,
    /// Every label drawn so far, with the bounding box of its ink.
    texts: RefCell<Vec<(String, Bounds)>>,
    /// The boxes to which lines are clipped.
    clips: RefCell<Vec<Bounds>>,
    /// Meanings, each with a drawn sample.
    legend: RefCell<Vec<(String, String)>>,
}

/// The coordinates of a sheet: points from the top left corner.
struct InPoints;

impl CoordTranslate for InPoints {
    type From = Spot;

    fn translate(&self, spot: &Spot) -> BackendCoord {
        in_hundredths(*spot)
    }
}

impl Canvas {
    /// An empty sheet.
    ///
    /// # Errors
    /// The embedded fonts cannot be read.
    pub fn new(width_mm: f64, height_mm: f64) -> Result<Self, DrawingError> {
        let (width, height) = (width_mm * POINTS_PER_MM, height_mm * POINTS_PER_MM);
        Ok(Canvas {
            fonts: Rc::new(Fonts::load()?),
            width,
            height,
            colours: Rc::default(),
            drawn: Rc::default(),
        })
    }

    /// The sheet with other colours of kinds of curves.
    #[must_use]
    pub(crate) fn coloured(self, colours: &[(Bifurcation, Colour)]) -> Self {
        Canvas { colours: colours.into(), ..self }
    }

    /// The look of a kind of curve on this sheet.
    pub(crate) fn look(&self, kind: Bifurcation) -> CurveLook {
        let look = CurveLook::of(kind);
        let own = self.colours.iter().find(|(of, _)| *of == kind);
        own.map_or(look, |(_, colour)| look.coloured(*colour))
    }

    /// Draws an element of plotters whose coordinates are points from the top left corner.
    ///
    /// # Errors
    /// A text cannot be set in the embedded fonts.
    pub fn draw<E>(&self, element: &E) -> Result<(), DrawingError>
    where
        for<'e> &'e E: PointCollection<'e, Spot>,
        E: Drawable<Canvas>,
    {
        Ok(self.clone().into_drawing_area().apply_coord_spec(InPoints).draw(element)?)
    }

    /// Adds an entry to the legend, unless it exists: the meaning of objects drawn like the sample, which is drawn from
    /// the middle left of a box of 24 by 10 points, as plotters draws samples. Returns whether the entry is new.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub fn explain<E>(
        &self,
        meaning: &str,
        sample: impl FnOnce(BackendCoord) -> E,
    ) -> Result<bool, DrawingError>
    where
        for<'e> &'e E: PointCollection<'e, BackendCoord>,
        E: Drawable<Canvas>,
    {
        if self.drawn.legend.borrow().iter().any(|(known, _)| known == meaning) {
            return Ok(false);
        }
        let before = self.drawn.elements.borrow().len();
        self.clone().into_drawing_area().draw(&sample((0, 500)))?;
        // The sample belongs to the legend, not to the sheet.
        let sample = self.drawn.elements.borrow_mut().split_off(before);
        let sample = sample.iter().map(|element| element.svg(path_data)).collect();
        self.drawn.legend.borrow_mut().push((meaning.to_owned(), sample));
        Ok(true)
    }

    /// Adds an element.
    pub(crate) fn add(&self, element: Element) {
        self.drawn.elements.borrow_mut().push(element);
    }

    /// Adds a path; consecutive spots that coincide in the file are written once.
    pub(crate) fn path(&self, pieces: impl IntoIterator<Item = (Vec<Hundredths>, bool)>, attributes: String) {
        let distinct = |(mut spots, closed): (Vec<Hundredths>, bool)| {
            spots.dedup();
            (spots, closed)
        };
        self.add(Element::Path(Path { pieces: pieces.into_iter().map(distinct).collect(), attributes }));
    }

    /// Draws the leader of a label.
    pub(crate) fn leader(&self, from: Spot, to: Spot) {
        self.line(&all_in_hundredths(&[from, to]), format!(" class=\"leader\"{}", stroke(Some(LEADER))));
    }

    /// Draws a line clipped so that no ink leaves a box.
    pub(crate) fn line_within(&self, bounds: &Bounds, spots: &[Hundredths], pen: Pen) {
        let reach = bounds.grown(-0.5 * pen.width);
        let close = |&spot: &Hundredths| !reach.holds(&Bounds::about(in_points(spot), 0.0, 0.0));
        let clip = if spots.iter().any(close) { self.clip(bounds) } else { String::new() };
        self.line(spots, stroke(Some(pen)) + &clip);
    }

    /// Draws a line, closed if it ends where it begins; a line shorter than the resolution of print is
    /// omitted.
    pub(crate) fn line(&self, spots: &[Hundredths], attributes: String) {
        let mut path = simplify(spots);
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
        let mut clips = self.drawn.clips.borrow_mut();
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

    /// Adds an SVG element positioned at one spot, whose coordinates are passed to `write`.
    pub(crate) fn add_at(&self, (x, y): Hundredths, write: impl Fn(String, String) -> String) {
        self.add(Element::Markup(write(hundredths(x), hundredths(y))));
    }

    /// Draws a circle.
    pub(crate) fn circle(&self, centre: Hundredths, radius: u32, attributes: &str) {
        let r = hundredths(radius as i32);
        self.add_at(centre, |x, y| format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{attributes}/>"));
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
        spot: Spot,
        label: &Label,
        size: f64,
        anchor: Anchor,
        colour: Colour,
    ) -> Result<(), DrawingError> {
        match anchor {
            Anchor::Upwards => self.turned_label(spot, label, size, Anchor::Middle, colour, 3),
            _ => self.turned_label(spot, label, size, anchor, colour, 0),
        }
    }

    /// Draws a parsed label with its baseline at the spot, about which it is turned clockwise by quarters of a turn.
    pub(crate) fn turned_label(
        &self,
        (x, y): Spot,
        label: &Label,
        size: f64,
        anchor: Anchor,
        colour: Colour,
        turns: u8,
    ) -> Result<(), DrawingError> {
        let extent @ Extent { width, ascent, descent } = self.fonts.measure(label, size)?;
        if label.runs.is_empty() {
            return Ok(());
        }
        let spare = extent.room() - width;
        let (start, before, mut attributes) = match anchor {
            Anchor::Start => (0.0, 0.0, String::new()),
            Anchor::Middle | Anchor::Upwards => {
                (-0.5 * width, 0.5 * spare, " text-anchor=\"middle\"".to_owned())
            }
            Anchor::End => (-width, spare, " text-anchor=\"end\"".to_owned()),
        };
        if turns > 0 {
            let angle = [0, 90, 180, -90][usize::from(turns % 4)];
            attributes += &format!(" transform=\"rotate({angle} {} {})\"", points(x), points(y));
        }
        // The position at a distance along the baseline from the label's start, and at a distance below
        // the baseline.
        let place = |along: f64, below: f64| match turns % 4 {
            0 => (x + (start + along), y + below),
            1 => (x - below, y + (start + along)),
            2 => (x - (start + along), y - below),
            _ => (x + below, y - (start + along)),
        };
        let corners = [place(-before, -ascent), place(width + spare - before, descent)];
        self.drawn.texts.borrow_mut().push((label.source.clone(), Bounds::around(&corners)));
        let (fill, spans, height) = (hex(colour), spans(label, size), points(size));
        self.add_at(in_hundredths((x, y)), |x, y| {
            format!(
                "<text x=\"{x}\" y=\"{y}\" font-size=\"{height}\"{attributes} fill=\"{fill}\">{spans}</text>"
            )
        });
        for hat in self.fonts.hats(label, size)? {
            let spots = all_in_hundredths(&hat.map(|(right, down)| place(right, down)));
            self.line(&spots, stroke(Some(hat_pen(size, colour))));
        }
        Ok(())
    }

    /// The bounds of the whole sheet.
    pub(crate) fn sheet(&self) -> Bounds {
        Bounds { left: 0.0, top: 0.0, right: self.width, bottom: self.height }
    }

    /// The finished figure, with this title and description; an empty sheet is left.
    ///
    /// # Errors
    /// The figure exceeds the size limit.
    pub fn finish(
        &self,
        figure: &'static str,
        title: &str,
        description: &str,
    ) -> Result<Sheet, DrawingError> {
        self.drawn.clips.take();
        let [width, height] = [self.width, self.height].map(|length| (length * 100.0).round() / 100.0);
        let sheet = Sheet {
            title: title.to_owned(),
            description: description.to_owned(),
            size: (width, height),
            elements: self.drawn.elements.take(),
            legend: self.drawn.legend.take(),
            texts: self.drawn.texts.take(),
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
        canvas.line(&[(100, 200), (100, 200)], stroke(Some(FRAME)));
        canvas.line(&[(100, 200), (100, 200), (300, 200), (300, 200)], stroke(Some(FRAME)));
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
