//! Pieces of HTML: escaping, identifiers and numbers.

use std::borrow::Borrow;
use std::fmt::{self, Write};

use askama::filters::{Escaper, Safe};
use grazing_results::{Scientific, Table, directs};

/// Text that is markup; values of any other type are escaped in templates.
pub(crate) type Html = Safe<String>;

/// Replaces everything that HTML would read as markup, also inside quoted attributes.
#[derive(Clone, Copy, Default)]
pub(crate) struct HtmlEscape;

impl Escaper for HtmlEscape {
    fn write_escaped_str<W: Write>(&self, mut page: W, text: &str) -> fmt::Result {
        for character in text.chars() {
            match character {
                '&' => page.write_str("&amp;")?,
                '<' => page.write_str("&lt;")?,
                '>' => page.write_str("&gt;")?,
                '"' => page.write_str("&quot;")?,
                '\'' => page.write_str("&#39;")?,
                '\n' | '\r' | '\t' => page.write_char(character)?,
                hidden if hidden.is_control() || directs(hidden) => {
                    write!(page, "{}", hidden.escape_unicode())?
                }
                other => page.write_char(other)?,
            }
        }
        Ok(())
    }
}

/// The text as [`HtmlEscape`] writes it.
pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    // Writing to a String cannot fail.
    let _ = HtmlEscape.write_escaped_str(&mut escaped, text);
    escaped
}

/// The text of a template.
pub(crate) fn rendered(template: &impl askama::Template) -> Html {
    Safe(template.render().expect("a template writes to a String, which cannot fail"))
}

/// The text as a string of JSON that can stand inside a script element.
pub(crate) fn json_string(text: &str) -> String {
    // A script element ends at the first `</script`, whatever surrounds it.
    serde_json::Value::from(text).to_string().replace('<', "\\u003c")
}

/// The identifier of the element for a label of the paper; all characters that links can contain are kept.
pub(crate) fn identifier(prefix: &str, label: &str) -> String {
    let keep = |character: char| character.is_ascii_alphanumeric() || ":/-_.".contains(character);
    let kept: String = label.chars().map(|character| if keep(character) { character } else { '_' }).collect();
    format!("{prefix}-{kept}")
}

/// A number with this many significant digits, formatted for reading: a true minus sign, powers of
/// ten as powers.
pub(crate) fn number(value: &f64, digits: usize) -> Html {
    Safe(rounded(*value, digits))
}

/// A cell of a table with a number, which scripts can sort by.
pub(crate) fn cell(value: &f64, digits: usize) -> Html {
    Safe(format!("<td class=\"number\" data-value=\"{value:e}\">{}</td>", rounded(*value, digits)))
}

/// The pieces with spaces between them.
pub(crate) fn joined(pieces: &[Html]) -> Html {
    Safe(pieces.iter().map(|piece| piece.0.as_str()).collect::<Vec<_>>().join(" "))
}

/// A number in the form by which scripts sort.
pub(crate) fn sortable(value: &f64) -> String {
    format!("{value:e}")
}

/// A number with all its digits.
pub(crate) fn plain(value: &f64) -> String {
    value.to_string().replace('-', "−")
}

fn rounded(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        let infinite = if value > 0.0 { "∞" } else { "−∞" };
        return if value.is_nan() { "not a number" } else { infinite }.to_owned();
    }
    let Scientific { mantissa, exponent } = Scientific::rounded(value, digits);
    let text = if (-3..6).contains(&exponent) {
        let decimals = i32::try_from(digits).unwrap_or(17) - 1 - exponent;
        trimmed(&format!("{value:.*}", usize::try_from(decimals).unwrap_or(0))).to_owned()
    } else {
        match trimmed(&mantissa) {
            "1" => power(exponent),
            "-1" => format!("-{}", power(exponent)),
            mantissa => format!("{mantissa} × {}", power(exponent)),
        }
    };
    match text.strip_prefix('-') {
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

/// The power of ten with this exponent.
pub(crate) fn power(exponent: i32) -> String {
    format!("10<sup>{}</sup>", exponent.to_string().replace('-', "−"))
}

/// The digits without zeros at the end of the decimals.
fn trimmed(mantissa: &str) -> &str {
    if mantissa.contains('.') { mantissa.trim_end_matches('0').trim_end_matches('.') } else { mantissa }
}

/// The path of a table's file among the outputs.
pub(crate) fn csv_path(table: &Table) -> String {
    format!("data/{}.csv", table.name)
}

/// The text with a capital letter first.
pub(crate) fn capitalised(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or_else(String::new, |first| first.to_uppercase().chain(characters).collect())
}

/// `1 file`, `2 files`.
pub(crate) fn counted(count: impl Borrow<usize>, one: &str, many: &str) -> String {
    let count = *count.borrow();
    format!("{count} {}", word(count, one, many))
}

/// The word for a number of things.
pub(crate) fn word<'a>(count: impl Borrow<usize>, one: &'a str, many: &'a str) -> &'a str {
    if *count.borrow() == 1 { one } else { many }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_in_text_is_harmless() {
        assert_eq!(escape("a<b & \"c\" > 'd'"), "a&lt;b &amp; &quot;c&quot; &gt; &#39;d&#39;");
        assert_eq!(json_string("</script>\n\"\\\u{1}"), r#""\u003c/script>\n\"\\\u0001""#);
        assert_eq!(identifier("claim", "eq:a b\"/c"), "claim-eq:a_b_/c");
    }

    #[test]
    fn numbers_read_as_in_print() {
        assert_eq!(rounded(-567.944_528, 6), "−567.945");
        assert_eq!(rounded(0.0, 3), "0");
        assert_eq!(rounded(3.14e-15, 2), "3.1 × 10<sup>−15</sup>");
        assert_eq!(rounded(1e-12, 2), "10<sup>−12</sup>");
        assert_eq!(rounded(-1e7, 2), "−10<sup>7</sup>");
        assert_eq!(rounded(0.012_345, 3), "0.0123");
        assert_eq!(rounded(0.5, 7), "0.5");
        assert_eq!(rounded(123_456.0, 3), "123456");
        assert_eq!(rounded(f64::INFINITY, 3), "∞");
    }
}
