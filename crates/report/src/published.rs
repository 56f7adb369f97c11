//! The numbers that the paper prints.

use crate::Report;
use crate::html::{escape, identifier, number, put};

/// One printed number, with the computed one.
#[derive(Debug, Clone, PartialEq)]
pub struct PublishedEntry {
    /// The identifier in `expected/published.toml`.
    pub id: String,
    /// The quantity in words and symbols.
    pub quantity: String,
    /// The number with the digits of the print.
    pub printed: String,
    /// The computed number, if the parameters give one.
    pub computed: Option<f64>,
    /// Whether the computed number, rounded to the printed digits, is the print.
    pub met: bool,
    /// The label of the paper that it belongs to.
    pub label: String,
    /// Where it is printed.
    pub place: String,
}

/// Digits of a computed number beside a print, which has four or five.
const COMPUTED_DIGITS: usize = 8;

pub(crate) fn section(report: &Report) -> String {
    let mut html = String::from(
        "<section id=\"published\" aria-labelledby=\"published-title\">\n<h2 id=\"published-title\">Published values</h2>\n\
         <p class=\"lead\">Each number that the paper prints, and the same quantity computed here. A value is met if, rounded \
         to the printed digits, it is the print.</p>\n\
         <div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Published values\">\n\
         <table class=\"sortable\"><thead><tr><th scope=\"col\">Quantity</th><th scope=\"col\" class=\"number\">Printed</th>\
         <th scope=\"col\" class=\"number\">Computed</th><th scope=\"col\">Verdict</th><th scope=\"col\">Where</th></tr></thead>\n<tbody>\n",
    );
    for entry in &report.published {
        let computed = entry.computed.map_or_else(String::new, computed);
        let sort = entry.computed.map_or_else(String::new, |value| format!(" data-value=\"{value:e}\""));
        let verdict = match (entry.met, entry.computed) {
            (true, _) => "<span class=\"verdict passed\">met</span>",
            (false, Some(_)) => "<span class=\"verdict failed\">off</span>",
            (false, None) => "<span class=\"verdict unchecked\">not computed</span>",
        };
        put!(
            html,
            "<tr id=\"{}\"><th scope=\"row\">{}</th><td class=\"number\" data-value=\"{}\">{}</td>\
             <td class=\"number\"{sort}>{computed}</td><td>{verdict}</td><td>{} {}</td></tr>\n",
            escape(&identifier("value", &entry.id)),
            symbols(&entry.quantity),
            escape(&entry.printed),
            escape(&entry.printed.replace('-', "−")),
            escape(&entry.place),
            place_of(report, &entry.label),
        );
    }
    html.push_str("</tbody></table>\n</div>\n</section>\n");
    html
}

/// A computed number beside a print; one with few digits, as parameters are, keeps them.
pub(crate) fn computed(value: f64) -> String {
    let whole = value.to_string();
    if whole.len() <= COMPUTED_DIGITS { whole.replace('-', "−") } else { number(value, COMPUTED_DIGITS) }
}

/// The label, as a link where the ledger has it.
fn place_of(report: &Report, label: &str) -> String {
    let name = format!("<code>{}</code>", escape(label));
    if report.claims.iter().any(|claim| claim.label == label) {
        format!("<a href=\"#{}\">{name}</a>", escape(&identifier("claim", label)))
    } else {
        name
    }
}

/// Quantities are written in ASCII beside the print: Greek names become letters and `_` lowers what follows.
pub(crate) fn symbols(quantity: &str) -> String {
    const LETTERS: [(&str, &str); 6] =
        [("zeta", "ζ"), ("epsilon", "ε"), ("omega", "ω"), ("tau", "τ"), ("delta", "δ"), ("A_graz", "𝒜_graz")];
    let words: Vec<String> = quantity
        .split(' ')
        .map(|word| {
            let (bare, comma) = word.strip_suffix(',').map_or((word, ""), |bare| (bare, ","));
            let letter = LETTERS.iter().find(|(name, _)| *name == bare).map_or(bare, |(_, letter)| letter);
            let italic = |text: &str| {
                if text.len() == 1 && text.chars().all(char::is_alphabetic) {
                    format!("<i>{}</i>", escape(text))
                } else {
                    escape(text)
                }
            };
            match letter.split_once('_') {
                Some((base, low)) => format!("{}<sub>{}</sub>{comma}", italic(base), escape(low)),
                None => format!("{}{comma}", italic(letter)),
            }
        })
        .collect();
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_read_as_in_print() {
        assert_eq!(symbols("c_SN,1, n = 3"), "<i>c</i><sub>SN,1</sub>, <i>n</i> = 3");
        assert_eq!(symbols("A_graz of Figure 2"), "𝒜<sub>graz</sub> of Figure 2");
        assert_eq!(symbols("omega, p < 1"), "ω, <i>p</i> &lt; 1");
    }
}
