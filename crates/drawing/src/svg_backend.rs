//! A plotters backend that writes print-quality SVG: units of 1/100 point, two decimals, dashes, sub- and superscripts.

use std::convert::Infallible;
use std::fmt::Write;

use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
};

use crate::clip::Window;
use crate::font::{self, TEXT_FAMILY};
use crate::markup::Label;
use crate::sheet::Bounds;
use crate::simplify::simplify;
use crate::style::{Colour, Paint, Pen};
use crate::svg_text::{UNITS, escape, hundredths, points, spans};

/// Points in a millimetre.
pub(crate) const POINTS_PER_MM: f64 = 72.0 / 25.4;

/// Horizontal anchor of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// What a program has to know of a panel to read values off the sheet.
pub(crate) struct PanelMark<'a> {
    pub(crate) window: &'a Window,
    pub(crate) bounds: &'a Bounds,
    /// The titles of the axes; an empty one is that of the panel to the left.
    pub(crate) titles: [&'a str; 2],
    /// The tables whose rows are shown, the most telling first; none if any with columns for the axes may be.
    pub(crate) tables: &'a [&'a str],
    /// The column and the number that tell the panel's rows from those of other panels.
    pub(crate) only: Option<(&'a str, u32)>,
    /// The columns that hold what is across and up; none if the titles say it.
    pub(crate) columns: Option<[&'a str; 2]>,
}

/// The column that readers of the sheet take a title for: its letters, and that of the forcing amplitude.
fn column_of(title: &str) -> String {
    let letters = title.replace(r"\mathcal", "").replace(|c: char| !c.is_ascii_alphabetic() && c != '_', "");
    if letters == "A" { "amplitude".to_owned() } else { letters }
}

/// Collects SVG elements; [`SvgBackend::finish`] wraps them into a document.
pub(crate) struct SvgBackend {
    size: (u32, u32),
    body: String,
}

type Outcome = Result<(), DrawingErrorKind<Infallible>>;

fn hex(Colour(red, green, blue): Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn fill(paint: &Paint) -> String {
    let mut attributes = format!(" fill=\"{}\"", hex(paint.colour));
    if paint.opacity < 1.0 {
        let _ = write!(attributes, " fill-opacity=\"{}\"", points(paint.opacity));
    }
    attributes
}

fn stroke(pen: &Pen) -> String {
    let mut attributes = format!(" stroke=\"{}\" stroke-width=\"{}\"", hex(pen.colour), points(pen.width));
    if pen.opacity < 1.0 {
        let _ = write!(attributes, " stroke-opacity=\"{}\"", points(pen.opacity));
    }
    if !pen.dashes.is_empty() {
        let dashes: Vec<String> = pen.dashes.iter().map(|&d| points(d)).collect();
        let _ = write!(attributes, " stroke-dasharray=\"{}\"", dashes.join(" "));
    }
    if pen.round {
        attributes.push_str(" stroke-linecap=\"round\"");
    }
    attributes
}

/// Path data through the points; points that fall together at print resolution are drawn once.
fn path_data(path: impl IntoIterator<Item = BackendCoord>, closed: bool) -> String {
    let mut data = String::new();
    let mut previous = None;
    for (x, y) in path {
        if previous == Some((x, y)) {
            continue;
        }
        let command = match previous {
            None => "M",
            Some(_) => "L",
        };
        let _ = write!(data, "{command}{},{}", hundredths(x), hundredths(y));
        previous = Some((x, y));
    }
    if closed && !data.is_empty() {
        data.push('Z');
    }
    data
}

impl SvgBackend {
    /// An empty drawing of `width` by `height` points.
    pub(crate) fn new(width: f64, height: f64) -> Self {
        let size = ((width * UNITS).round() as u32, (height * UNITS).round() as u32);
        SvgBackend { size, body: String::new() }
    }

    /// The finished document, with its title, its description and the fonts.
    ///
    /// White space is preserved because some viewers drop it at the ends of a tspan otherwise.
    pub(crate) fn finish(&self, title: &str, description: &str) -> String {
        let (width, height) = (f64::from(self.size.0) / UNITS, f64::from(self.size.1) / UNITS);
        let (w, h) = (points(width), points(height));
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {w} {h}\" \
             font-family=\"{TEXT_FAMILY}\" xml:space=\"preserve\" stroke-linejoin=\"round\" fill=\"none\" role=\"img\">\n\
             <title>{}</title>\n<desc>{}</desc>\n<style>\n{}</style>\n\
             <rect width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n{}</svg>\n",
            points(width / POINTS_PER_MM),
            points(height / POINTS_PER_MM),
            escape(title),
            escape(description),
            font::style_sheet(),
            self.body,
        )
    }

    fn element(&mut self, arguments: std::fmt::Arguments<'_>) -> Outcome {
        // Writing to a String cannot fail.
        let _ = writeln!(self.body, "{arguments}");
        Ok(())
    }

    /// An invisible rectangle of class `panel` over the panel: `data-x` and `data-y` are the values at its left and right,
    /// bottom and top edges; `data-columns` the columns that hold them, where the titles do not say it.
    pub(crate) fn mark(&mut self, mark: &PanelMark<'_>) {
        let PanelMark { window: Window { x, y }, bounds, titles, .. } = mark;
        let mut attributes = String::new();
        if !mark.tables.is_empty() {
            let _ = write!(attributes, " data-tables=\"{}\"", escape(&mark.tables.join(" ")));
        }
        if let Some((column, number)) = mark.only {
            let _ = write!(attributes, " data-only=\"{} {number}\"", escape(column));
        }
        if let Some(columns) = mark.columns {
            let said = |(title, column): (&&str, &&str)| title.is_empty() || column_of(title) == *column;
            if !titles.iter().zip(&columns).all(said) {
                let _ = write!(attributes, " data-columns=\"{}\"", escape(&columns.join(" ")));
            }
        }
        let _ = writeln!(
            self.body,
            "<rect class=\"panel\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" data-x=\"{} {}\" data-y=\"{} {}\" \
             data-x-title=\"{}\" data-y-title=\"{}\"{attributes}/>",
            points(bounds.left),
            points(bounds.top),
            points(bounds.right - bounds.left),
            points(bounds.bottom - bounds.top),
            x[0],
            x[1],
            y[0],
            y[1],
            escape(titles[0]),
            escape(titles[1]),
        );
    }

    /// An open path.
    pub(crate) fn line(&mut self, path: impl IntoIterator<Item = BackendCoord>, pen: &Pen) -> Outcome {
        let path: Vec<BackendCoord> = path.into_iter().collect();
        let data = path_data(simplify(&path), false);
        if !data.contains('L') {
            // A line shorter than print resolution is none.
            return Ok(());
        }
        self.element(format_args!("<path d=\"{data}\"{}/>", stroke(pen)))
    }

    /// A filled and perhaps outlined polygon.
    pub(crate) fn polygon(
        &mut self,
        path: impl IntoIterator<Item = BackendCoord>,
        paint: &Paint,
        outline: Option<&Pen>,
    ) -> Outcome {
        let data = path_data(path, true);
        self.element(format_args!(
            "<path d=\"{data}\"{}{}/>",
            fill(paint),
            outline.map(stroke).unwrap_or_default()
        ))
    }

    /// A filled area between rings of so many points each.
    pub(crate) fn area(
        &mut self,
        mut path: impl Iterator<Item = BackendCoord>,
        lengths: &[usize],
        paint: &Paint,
    ) -> Outcome {
        let rings: String =
            lengths.iter().map(|length| path_data(path.by_ref().take(*length), true)).collect();
        self.element(format_args!("<path d=\"{rings}\" fill-rule=\"evenodd\"{}/>", fill(paint)))
    }

    /// A disc of `radius` points, perhaps outlined.
    pub(crate) fn disc(
        &mut self,
        (x, y): BackendCoord,
        radius: f64,
        paint: &Paint,
        outline: Option<&Pen>,
    ) -> Outcome {
        let outline = outline.map(stroke).unwrap_or_default();
        let (x, y, r) = (hundredths(x), hundredths(y), points(radius));
        self.element(format_args!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{}{outline}/>", fill(paint)))
    }

    /// Squares of side `bin` points on a grid hung up at `origin`; `data` is path data in units of the bin.
    pub(crate) fn bins(&mut self, (x, y): BackendCoord, bin: f64, data: &str, paint: &Paint) -> Outcome {
        let (x, y, bin) = (hundredths(x), hundredths(y), points(bin));
        let colour = hex(paint.colour);
        let opacity = points(paint.opacity);
        self.element(format_args!(
            "<path transform=\"translate({x} {y}) scale({bin})\" d=\"{data}\" stroke=\"{colour}\" stroke-opacity=\"{opacity}\" stroke-width=\"1\"/>"
        ))
    }

    /// A label whose baseline starts, is centred or ends at the point.
    pub(crate) fn label(
        &mut self,
        (x, y): BackendCoord,
        label: &Label,
        size: f64,
        anchor: Anchor,
        colour: Colour,
    ) -> Outcome {
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        self.text((x, y), label, size, anchor, colour)
    }

    /// A label that reads upwards, the middle of its baseline at the point.
    pub(crate) fn label_upwards(
        &mut self,
        (x, y): BackendCoord,
        label: &Label,
        size: f64,
        colour: Colour,
    ) -> Outcome {
        let turn =
            format!(" text-anchor=\"middle\" transform=\"rotate(-90 {} {})\"", hundredths(x), hundredths(y));
        self.text((x, y), label, size, &turn, colour)
    }

    fn text(
        &mut self,
        (x, y): BackendCoord,
        label: &Label,
        size: f64,
        attributes: &str,
        colour: Colour,
    ) -> Outcome {
        let spans = spans(label, size);
        let (x, y, colour) = (hundredths(x), hundredths(y), hex(colour));
        self.element(format_args!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\"{attributes} fill=\"{colour}\">{spans}</text>",
            points(size)
        ))
    }
}

fn plain_pen<S: BackendStyle>(style: &S) -> Pen {
    let (colour, opacity) = plain_colour(style.color());
    Pen { colour, width: f64::from(style.stroke_width()) / UNITS, dashes: &[], opacity, round: false }
}

fn plain_colour(colour: BackendColor) -> (Colour, f64) {
    (Colour(colour.rgb.0, colour.rgb.1, colour.rgb.2), colour.alpha)
}

fn plain_paint<S: BackendStyle>(style: &S) -> Paint {
    let (colour, opacity) = plain_colour(style.color());
    Paint { colour, opacity }
}

/// What plotters' own elements draw with; all lengths, stroke widths included, are in 1/100 point.
impl DrawingBackend for SvgBackend {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Outcome {
        Ok(())
    }

    fn present(&mut self) -> Outcome {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, color: BackendColor) -> Outcome {
        self.draw_rect((x, y), (x + 1, y + 1), &color, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Outcome {
        self.line([from, to], &plain_pen(style))
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (left, top): BackendCoord,
        (right, bottom): BackendCoord,
        style: &S,
        filled: bool,
    ) -> Outcome {
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        if filled {
            return self.polygon(corners, &plain_paint(style), None);
        }
        let data = path_data(corners, true);
        self.element(format_args!("<path d=\"{data}\"{}/>", stroke(&plain_pen(style))))
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Outcome {
        self.line(path, &plain_pen(style))
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        filled: bool,
    ) -> Outcome {
        let radius = f64::from(radius) / UNITS;
        if filled {
            return self.disc(center, radius, &plain_paint(style), None);
        }
        let (x, y) = (hundredths(center.0), hundredths(center.1));
        let outline = stroke(&plain_pen(style));
        self.element(format_args!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\"{outline}/>", points(radius)))
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        vert: I,
        style: &S,
    ) -> Outcome {
        self.polygon(vert, &plain_paint(style), None)
    }

    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, (x, y): BackendCoord) -> Outcome {
        let size = style.size() / UNITS;
        let anchor = match style.anchor().h_pos {
            HPos::Left => Anchor::Start,
            HPos::Center => Anchor::Middle,
            HPos::Right => Anchor::End,
        };
        let drop = match style.anchor().v_pos {
            VPos::Top => 0.66,
            VPos::Center => 0.33,
            VPos::Bottom => 0.0,
        };
        let label = Label::plain(text);
        let y = y + (drop * style.size()).round() as i32;
        self.label((x, y), &label, size, anchor, plain_colour(style.color()).0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_escaped_once() {
        assert_eq!(escape("a<b & \"c\">'d'\u{7}"), "a&lt;b &amp; &quot;c&quot;&gt;&#39;d&#39; ");
        let mut svg = SvgBackend::new(10.0, 10.0);
        svg.label((0, 0), &Label::parse("$x$ < 1 & y").unwrap(), 8.0, Anchor::Start, Colour(0, 0, 0))
            .unwrap();
        assert!(
            svg.body.contains("<tspan font-style=\"italic\">x</tspan> &lt; 1 &amp; y</text>"),
            "{}",
            svg.body
        );
    }

    #[test]
    fn points_that_coincide_in_print_are_written_once() {
        assert_eq!(path_data([(0, 0), (0, 0), (150, -25), (150, -25)], false), "M0,0L1.5,-0.25");
        assert_eq!(path_data([(0, 0), (100, 0), (0, 100)], true), "M0,0L1,0L0,1Z");
    }

    #[test]
    fn a_line_that_shrinks_to_a_point_is_not_written() {
        let pen = Pen { colour: Colour(0, 0, 0), width: 1.0, dashes: &[], opacity: 1.0, round: false };
        let mut svg = SvgBackend::new(10.0, 10.0);
        svg.line([(100, 200), (100, 200)], &pen).unwrap();
        assert_eq!(svg.body, "");
    }

    #[test]
    fn dashes_are_real_ones() {
        let pen =
            Pen { colour: Colour(1, 2, 255), width: 1.25, dashes: &[4.0, 1.5], opacity: 0.5, round: false };
        assert_eq!(
            stroke(&pen),
            " stroke=\"#0102ff\" stroke-width=\"1.25\" stroke-opacity=\"0.5\" stroke-dasharray=\"4 1.5\""
        );
    }

    #[test]
    fn a_mark_tells_the_window_and_its_place_and_has_no_ink() {
        let mut svg = SvgBackend::new(100.0, 100.0);
        svg.mark(&PanelMark {
            window: &Window { x: [-0.5, 1.25], y: [0.0, 3.0] },
            bounds: &Bounds { left: 10.0, top: 20.0, right: 90.5, bottom: 80.0 },
            titles: [r"$\omega$", ""],
            tables: &["points", "curves"],
            only: Some(("panel", 2)),
            columns: None,
        });
        assert_eq!(
            svg.body,
            "<rect class=\"panel\" x=\"10\" y=\"20\" width=\"80.5\" height=\"60\" data-x=\"-0.5 1.25\" data-y=\"0 3\" \
             data-x-title=\"$\\omega$\" data-y-title=\"\" data-tables=\"points curves\" data-only=\"panel 2\"/>\n"
        );
        assert!(svg.finish("", "").contains("fill=\"none\""), "nothing is filled unless it says so");
    }

    #[test]
    fn a_mark_names_its_columns_where_readers_would_take_the_titles_for_others() {
        let marked = |columns, titles| {
            let mut svg = SvgBackend::new(100.0, 100.0);
            svg.mark(&PanelMark {
                window: &Window { x: [0.0, 1.0], y: [0.0, 1.0] },
                bounds: &Bounds { left: 10.0, top: 20.0, right: 90.5, bottom: 80.0 },
                titles,
                tables: &[],
                only: None,
                columns: Some(columns),
            });
            svg.body.contains("data-columns")
        };
        assert!(!marked(["amplitude", "omega"], [r"$\mathcal{A}$", r"$\omega$"]));
        assert!(!marked(["amplitude", "omega"], [r"$\mathcal{A}$", ""]));
        assert!(marked(["A", "omega"], ["$A$", r"$\omega$"]));
        assert!(marked(["F_0", "omega_2"], ["$F_{0}$", r"$\omega_{2}$"]));
    }

    #[test]
    fn a_title_may_read_upwards() {
        let mut svg = SvgBackend::new(100.0, 100.0);
        let label = Label::plain("amplitude");
        svg.label_upwards((1050, 5000), &label, 10.0, Colour(0, 0, 0)).unwrap();
        assert!(svg.body.contains("x=\"10.5\" y=\"50\""), "{}", svg.body);
        assert!(svg.body.contains("transform=\"rotate(-90 10.5 50)\""), "{}", svg.body);
    }

    #[test]
    fn elements_of_plotters_keep_their_hundredths() {
        let mut svg = SvgBackend::new(10.0, 10.0);
        let red = BackendColor { alpha: 1.0, rgb: (255, 0, 0) };
        svg.draw_line((1, 2), (333, 444), &red).unwrap();
        assert_eq!(svg.body, "<path d=\"M0.01,0.02L3.33,4.44\" stroke=\"#ff0000\" stroke-width=\"0.01\"/>\n");
    }
}
