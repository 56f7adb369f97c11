//! Numbers and text as they stand in an SVG file.

use std::fmt::Write;

use crate::font::{SCRIPT_SIZE, SIGN_FAMILY, SUBSCRIPT_DROP, SUPERSCRIPT_RISE};
use crate::markup::{Face, Label, Level};

/// Backend units in a point (1/72 inch).
pub(crate) const UNITS: f64 = 100.0;

/// Hundredths as a decimal number, without needless zeros.
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
    hundredths((value * UNITS).round() as i32)
}

/// Text with the five characters escaped that XML reserves, without control characters, which it forbids, and with marks that
/// change the direction of writing as `\u{202e}`.
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

/// Whether the character changes the direction in which those after it, or around it, are written.
fn directs(character: char) -> bool {
    matches!(character, '\u{200e}' | '\u{200f}' | '\u{61c}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// The runs of a label as text and tspans; scripts by `dy`, which every viewer knows.
pub(crate) fn spans(label: &Label, size: f64) -> String {
    let mut spans = String::new();
    let mut lowered = 0.0;
    for run in &label.runs {
        let wanted = match run.level {
            Level::Line => 0.0,
            Level::Subscript => size * SUBSCRIPT_DROP,
            Level::Superscript => -size * SUPERSCRIPT_RISE,
        };
        let mut attributes = String::new();
        if wanted != lowered {
            let _ = write!(attributes, " dy=\"{}\"", points(wanted - lowered));
            lowered = wanted;
        }
        if run.level != Level::Line {
            let _ = write!(attributes, " font-size=\"{}\"", points(size * SCRIPT_SIZE));
        }
        match run.face {
            Face::Upright => {}
            Face::Italic => attributes.push_str(" font-style=\"italic\""),
            Face::Signs => {
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
    fn a_subscript_is_lowered_and_the_line_comes_back() {
        let label = Label::parse(r"$x_1=2$").unwrap();
        // 0.19 and 0.72 of 10 points, and back up again.
        assert_eq!(
            spans(&label, 10.0),
            "<tspan font-style=\"italic\">x</tspan><tspan dy=\"1.9\" font-size=\"7.2\">1</tspan>\
             <tspan dy=\"-1.9\">\u{2009}=\u{2009}2</tspan>"
        );
    }
}
