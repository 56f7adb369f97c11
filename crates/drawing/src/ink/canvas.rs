//! The sheet a figure is drawn on, in points from the top left corner: plotters' drawing area over a backend that writes SVG.

use std::cell::RefCell;
use std::rc::Rc;

use plotters::coord::Shift;
use plotters::drawing::DrawingArea;

use crate::error::DrawingError;
use crate::geometry::sheet::{Bounds, Hundredths, Spot, in_hundredths};
use crate::geometry::simplify::simplify;
use crate::ink::backend::{Element, SvgBackend};
use crate::ink::font::{Extent, Fonts, TEXT_FAMILY, style_sheet};
use crate::ink::legend::{Legend, Sample};
use crate::ink::markup::Label;
use crate::ink::style::{Colour, Paint, Pen, SIZE_LIMIT, hat_pen};
use crate::ink::svg::{POINTS_PER_MM, escape, fill, hex, hundredths, path_data, points, spans, stroke};

/// Which point of its baseline a text is placed by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
    /// Its middle, and the text reads upwards.
    Upwards,
}

/// An unfinished sheet.
pub(crate) struct Canvas {
    pub(crate) fonts: Fonts,
    pub(crate) width: f64,
    pub(crate) height: f64,
    backend: Rc<RefCell<SvgBackend>>,
    root: DrawingArea<SvgBackend, Shift>,
    /// Every label drawn so far and the box of its ink.
    texts: RefCell<Vec<(String, Bounds)>>,
    /// The boxes to which lines are clipped.
    clips: RefCell<Vec<Bounds>>,
    legend: RefCell<Legend>,
}

impl Canvas {
    pub(crate) fn new(width_mm: f64, height_mm: f64) -> Result<Self, DrawingError> {
        let (width, height) = (width_mm * POINTS_PER_MM, height_mm * POINTS_PER_MM);
        let size = in_hundredths((width, height));
        let backend = Rc::new(RefCell::new(SvgBackend::new(size)));
        let root = DrawingArea::from(&backend);
        let (texts, clips, legend) = Default::default();
        Ok(Canvas { backend, root, fonts: Fonts::load()?, width, height, texts, clips, legend })
    }

    /// Draws an element: its spots, and what is written of them.
    fn draw(&self, spots: &[Spot], write: impl Fn(&[Hundredths]) -> String) {
        let points: Vec<Hundredths> = spots.iter().map(|&spot| in_hundredths(spot)).collect();
        let drawn = self.root.draw(&Element { points, write });
        drawn.expect("the backend cannot fail, and nobody else draws meanwhile");
    }

    /// Adds an entry to the legend, once: what is drawn like the sample.
    pub(crate) fn explain(&self, meaning: &str, sample: Sample) {
        self.legend.borrow_mut().explain(meaning, sample);
    }

    /// Adds what puts no ink on the sheet.
    pub(crate) fn note(&self, element: &str) {
        self.backend.borrow_mut().write(element);
    }

    /// A line, closed if it ends where it begins; one shorter than print resolution is none.
    pub(crate) fn line(&self, spots: &[Spot], pen: Pen) {
        self.attributed_line(spots, &stroke(Some(pen)));
    }

    /// A line of which no ink leaves a box.
    pub(crate) fn line_within(&self, bounds: &Bounds, spots: &[Spot], pen: Pen) {
        let reach = bounds.grown(-0.5 * pen.width);
        let close = |&(x, y): &Spot| !reach.holds(&Bounds::about((x, y), 0.0, 0.0));
        let clip = if spots.iter().any(close) { self.clip(bounds) } else { String::new() };
        self.attributed_line(spots, &(stroke(Some(pen)) + &clip));
    }

    fn attributed_line(&self, spots: &[Spot], attributes: &str) {
        self.draw(spots, |path| {
            let path = simplify(path);
            let closed = path.len() > 3 && path.first() == path.last();
            match path_data(&path[..path.len() - usize::from(closed)], closed) {
                data if data.contains('L') => format!("<path d=\"{data}\"{attributes}/>"),
                _ => String::new(),
            }
        });
    }

    /// The attribute that clips to a box.
    fn clip(&self, bounds: &Bounds) -> String {
        let mut clips = self.clips.borrow_mut();
        let known = clips.iter().position(|known| known == bounds);
        let number = known.unwrap_or_else(|| {
            let Bounds { left, top, right, bottom } = *bounds;
            let [x, y, width, height] = [left, top, right - left, bottom - top].map(points);
            let number = clips.len();
            self.note(&format!(
                "<clipPath id=\"clip{number}\"><rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"/></clipPath>"
            ));
            clips.push(*bounds);
            number
        });
        format!(" clip-path=\"url(#clip{number})\"")
    }

    /// A filled and perhaps outlined polygon.
    pub(crate) fn polygon(&self, corners: &[Spot], paint: Paint, outline: Option<Pen>) {
        self.draw(corners, |path| {
            format!("<path d=\"{}\"{}{}/>", path_data(path, true), fill(paint), stroke(outline))
        });
    }

    /// A filled area, inside where its rings are crossed an odd number of times.
    pub(crate) fn area(&self, rings: &[Vec<Spot>], paint: Paint) {
        self.draw(&rings.concat(), |mut path| {
            let mut data = String::new();
            for ring in rings {
                let (here, rest) = path.split_at(ring.len());
                data.push_str(&path_data(here, true));
                path = rest;
            }
            format!("<path d=\"{data}\" fill-rule=\"evenodd\"{}/>", fill(paint))
        });
    }

    /// Draws an element that hangs on one spot, whose coordinates `write` is given.
    fn draw_at(&self, spot: Spot, write: impl Fn(String, String) -> String) {
        self.draw(&[spot], |path| path.iter().map(|&(x, y)| write(hundredths(x), hundredths(y))).collect());
    }

    /// A filled and perhaps outlined disc.
    pub(crate) fn disc(&self, centre: Spot, radius: f64, paint: Paint, outline: Option<Pen>) {
        let (r, fill, outline) = (points(radius), fill(paint), stroke(outline));
        self.draw_at(centre, |x, y| format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{fill}{outline}/>"));
    }

    /// Squares of a side on a grid that hangs on its top left corner; `data` is path data in units of the side.
    pub(crate) fn bins(&self, corner: Spot, side: f64, data: &str, paint: Paint) {
        let (side, colour, opacity) = (points(side), hex(paint.colour), points(paint.opacity));
        self.draw_at(corner, |x, y| {
            format!(
                "<path transform=\"translate({x} {y}) scale({side})\" d=\"{data}\" stroke=\"{colour}\" \
                 stroke-opacity=\"{opacity}\" stroke-width=\"1\"/>"
            )
        });
    }

    /// A label with its baseline at the spot.
    pub(crate) fn text(
        &self,
        spot: Spot,
        source: &str,
        size: f64,
        anchor: Anchor,
        colour: Colour,
    ) -> Result<(), DrawingError> {
        self.label(spot, &Label::parse(source)?, size, anchor, colour)
    }

    /// A label that has been parsed with its baseline at the spot.
    pub(crate) fn label(
        &self,
        (x, y): Spot,
        label: &Label,
        size: f64,
        anchor: Anchor,
        colour: Colour,
    ) -> Result<(), DrawingError> {
        let Extent { width, ascent, descent } = self.fonts.measure(label, size)?;
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
        // So far along the baseline from where the label starts, and so far below it.
        let place = |along: f64, below: f64| match anchor {
            Anchor::Upwards => (x + below, y - (start + along)),
            _ => (x + (start + along), y + below),
        };
        let (a, b) = (place(0.0, -ascent), place(width, descent));
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

    /// The labels as they were written, in the order of drawing.
    #[cfg(test)]
    pub(crate) fn texts(&self) -> Vec<String> {
        self.texts.borrow().iter().map(|(source, _)| source.clone()).collect()
    }

    /// Panics with the labels that overlap another one or leave the sheet, if there are any.
    #[cfg(test)]
    pub(crate) fn assert_well_placed(&self, what: &dyn std::fmt::Debug) {
        let texts = self.texts.borrow();
        let spoilt = |i: usize| {
            !self.sheet().holds(&texts[i].1)
                || texts.iter().enumerate().any(|(j, other)| i != j && other.1.overlaps(&texts[i].1))
        };
        let misplaced: Vec<_> = (0..texts.len()).filter(|&i| spoilt(i)).map(|i| &texts[i]).collect();
        assert!(misplaced.is_empty(), "{what:?}: {misplaced:?}");
    }

    /// All of the sheet.
    pub(crate) fn sheet(&self) -> Bounds {
        Bounds { left: 0.0, top: 0.0, right: self.width, bottom: self.height }
    }

    /// The documents of sheets, each of several with its number in the title.
    pub(crate) fn finish_all(
        sheets: Vec<Canvas>,
        figure: &'static str,
        title: &str,
        description: &str,
    ) -> Result<Vec<String>, DrawingError> {
        let count = sheets.len();
        let finish = |(canvas, number): (Canvas, usize)| {
            let of = if count > 1 { format!(" ({number} of {count})") } else { String::new() };
            canvas.finish(figure, &format!("{title}{of}"), description)
        };
        sheets.into_iter().zip(1..).map(finish).collect()
    }

    /// The document with its title, its description and the fonts, if it is light enough.
    ///
    /// White space is preserved because some viewers drop it at the ends of a tspan otherwise.
    pub(crate) fn finish(
        self,
        figure: &'static str,
        title: &str,
        description: &str,
    ) -> Result<String, DrawingError> {
        let [width, height] = [self.width, self.height].map(|length| (length * 100.0).round() / 100.0);
        let (w, h) = (points(width), points(height));
        let document = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {w} {h}\" \
             font-family=\"{TEXT_FAMILY}\" xml:space=\"preserve\" stroke-linejoin=\"round\" fill=\"none\" role=\"img\">\n\
             <title>{}</title>\n<desc>{}</desc>\n<style>\n{}</style>\n\
             <rect width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n{}{}</svg>\n",
            points(width / POINTS_PER_MM),
            points(height / POINTS_PER_MM),
            escape(title),
            escape(description),
            style_sheet(),
            self.backend.borrow().body(),
            self.legend.borrow().element(),
        );
        if document.len() > SIZE_LIMIT {
            let bytes = document.len();
            return Err(DrawingError(format!("{figure} came to {bytes} bytes; the limit is {SIZE_LIMIT}")));
        }
        Ok(document)
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
        assert_eq!(canvas.backend.borrow().body(), "");
    }

    #[test]
    fn a_title_may_read_upwards() {
        let canvas = Canvas::new(100.0, 100.0).unwrap();
        canvas.text((10.5, 50.0), "amplitude", 10.0, Anchor::Upwards, BLACK).unwrap();
        let svg = canvas.finish("test", "", "").unwrap();
        assert!(svg.contains("x=\"10.5\" y=\"50\"") && svg.contains("rotate(-90 10.5 50)"), "{svg}");
        assert!(svg.contains("fill=\"none\""), "nothing is filled unless it says so");
    }
}
