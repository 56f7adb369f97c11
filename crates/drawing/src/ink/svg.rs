//! Numbers, pens, paths and text as they are written in an SVG file.

use std::fmt::Write;

use grazing_results::directs;

use crate::geometry::sheet::Hundredths;
use crate::ink::font::SIGN_FAMILY;
use crate::ink::markup::{FontFace, Label, Level};
use crate::ink::style::{Colour, Paint, Pen};

/// The number of points in a millimetre.
pub const POINTS_PER_MM: f64 = 72.0 / 25.4;

/// Hundredths as a decimal number, without redundant zeros.
pub(crate) fn hundredths(value: i32) -> String {
    let (sign, size) = (if value < 0 { "-" } else { "" }, value.unsigned_abs());
    let (whole, rest) = (size / 100, size % 100);
    match (rest, rest % 10) {
        (0, _) => format!("{sign}{whole}"),
        (_, 0) => format!("{sign}{whole}.{}", rest / 10),
        _ => format!("{sign}{whole}.{rest:02}"),
    }
}

/// A length in points, rounded to hundredths.
pub(crate) fn points(value: f64) -> String {
    hundredths((value * 100.0).round() as i32)
}

pub(crate) fn hex([red, green, blue]: Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// The attributes that fill an area.
pub fn fill(paint: Paint) -> String {
    let mut attributes = format!(" fill=\"{}\"", hex(paint.colour));
    if paint.opacity < 1.0 {
        let _ = write!(attributes, " fill-opacity=\"{}\"", points(paint.opacity));
    }
    attributes
}

/// The attributes that draw a line; none without a pen.
pub(crate) fn stroke(pen: Option<Pen>) -> String {
    let Some(pen) = pen else { return String::new() };
    let mut attributes = format!(" stroke=\"{}\" stroke-width=\"{}\"", hex(pen.colour), points(pen.width));
    if !pen.dashes.is_empty() {
        let dashes: Vec<String> = pen.dashes.iter().map(|&d| points(d)).collect();
        let _ = write!(attributes, " stroke-dasharray=\"{}\"", dashes.join(" "));
    }
    if pen.round {
        attributes.push_str(" stroke-linecap=\"round\"");
    }
    attributes
}

/// Path data through the spots.
pub(crate) fn path_data(path: &[Hundredths], closed: bool) -> String {
    let mut data = String::new();
    for (place, &(x, y)) in path.iter().enumerate() {
        let command = if place == 0 { "M" } else { "L" };
        let _ = write!(data, "{command}{},{}", hundredths(x), hundredths(y));
    }
    if closed && !data.is_empty() {
        data.push('Z');
    }
    data
}

/// The text with the five characters escaped that XML reserves, without control characters, which it
/// forbids, and with characters that change the direction of writing spelt like `\u{202e}`.
pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            control if control.is_control() => escaped.push(' '),
            mark if directs(mark) => escaped.extend(mark.escape_unicode()),
            other => escaped.push(other),
        }
    }
    escaped
}

/// The runs of a label as text and tspans; scripts use `dy`, which every viewer supports.
pub(crate) fn spans(label: &Label, size: f64) -> String {
    let mut spans = String::new();
    let mut rise = 0.0;
    for run in &label.runs {
        let (own_size, own_rise) = run.level.size_and_rise(size);
        let mut attributes = String::new();
        if own_rise != rise {
            let _ = write!(attributes, " dy=\"{}\"", points(rise - own_rise));
            rise = own_rise;
        }
        if run.level != Level::Line {
            let _ = write!(attributes, " font-size=\"{}\"", points(own_size));
        }
        match run.face {
            FontFace::Upright => {}
            FontFace::Italic => attributes.push_str(" font-style=\"italic\""),
            FontFace::Signs => {
                let _ = write!(attributes, " font-family=\"{SIGN_FAMILY}\"");
            }
        }
        let text = escape(&run.text);
        let _ = if attributes.is_empty() {
            write!(spans, "{text}")
        } else {
            write!(spans, "<tspan{attributes}>{text}</tspan>")
        };
    }
    spans
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_have_at_most_two_decimals_and_no_needless_zeros() {
        let printed: Vec<String> =
            [0, 7, 10, 100, 12_345, -5, -50, -1_200].into_iter().map(hundredths).collect();
        assert_eq!(printed, ["0", "0.07", "0.1", "1", "123.45", "-0.05", "-0.5", "-12"]);
        assert_eq!(points(1.0 / 3.0), "0.33");
    }

    #[test]
    fn text_is_escaped_once() {
        assert_eq!(escape("a<b & \"c\">'d'\u{7}"), "a&lt;b &amp; &quot;c&quot;&gt;&#39;d&#39; ");
        assert_eq!(
            spans(&Label::parse("$x$ < 1 & y").unwrap(), 8.0),
            "<tspan font-style=\"italic\">x</tspan> &lt; 1 &amp; y"
        );
    }

    #[test]
    fn closed_paths_say_so() {
        assert_eq!(path_data(&[(0, 0), (150, -25)], false), "M0,0L1.5,-0.25");
        assert_eq!(path_data(&[(0, 0), (100, 0), (0, 100)], true), "M0,0L1,0L0,1Z");
    }

    #[test]
    fn dashes_are_real_ones() {
        let pen = Pen::dashed([1, 2, 255], 1.25, &[4.0, 1.5]);
        assert_eq!(stroke(Some(pen)), " stroke=\"#0102ff\" stroke-width=\"1.25\" stroke-dasharray=\"4 1.5\"");
    }

    #[test]
    fn a_subscript_is_lowered_and_the_line_comes_back() {
        let label = Label::parse(r"$x_1=2$").unwrap();
        // 0.19 and 0.72 of 10 points, and then back up.
        assert_eq!(
            spans(&label, 10.0),
            "<tspan font-style=\"italic\">x</tspan><tspan dy=\"1.9\" font-size=\"7.2\">1</tspan>\
             <tspan dy=\"-1.9\">\u{2009}=\u{2009}2</tspan>"
        );
    }
}
