//! What columns and parameters are called on the page.

use std::collections::BTreeMap;

use askama::filters::Safe;
use grazing_results::Table;

use crate::Report;
use crate::formula::{shown, words};
use crate::html::{Html, escape, json_string};

/// A symbol as the page shows it; names in it may be of several words.
fn formula(latex: &str) -> Html {
    shown(&latex.replace(r"\mathrm{", r"\text{"), false)
}

/// The name of a parameter as a symbol.
pub(crate) fn symbol(name: &str) -> Html {
    grazing_results::symbol(name).map_or_else(|| Safe(escape(name)), |latex| formula(&latex))
}

/// The heading of a column: what it is called, and its unit if it has one.
pub(crate) fn heading(table: &Table, place: usize) -> Html {
    Safe(format!("{}{}", name(table, place).0, in_parentheses(&table.units[place])))
}

/// A unit after what is counted in it; nothing without one.
pub(crate) fn in_parentheses(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" ({})", words(unit).0) }
}

/// What a column is called: its symbol, or its name in words.
fn name(table: &Table, place: usize) -> Html {
    match table.symbols[place].as_str() {
        "" => Safe(escape(&table.headers[place].replace('_', " "))),
        latex => formula(latex),
    }
}

/// What all columns are called that figures show by their names, for the scripts.
pub(crate) fn json(report: &Report<'_>) -> String {
    let columns = report
        .all_figures()
        .flat_map(|figure| &figure.tables)
        .flat_map(|table| table.headers.iter().enumerate().map(move |column| (table, column)));
    let headings: BTreeMap<&str, Html> =
        columns.map(|(table, (place, header))| (header.as_str(), name(table, place))).collect();
    let pairs: Vec<String> = headings
        .iter()
        .map(|(name, heading)| format!("{}:{}", json_string(name), json_string(&heading.0)))
        .collect();
    format!("{{{}}}", pairs.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_parameters_become_symbols_and_words_stay() {
        for (name, shown) in [
            ("A", "<mi>A</mi>"),
            ("omega", "ω"),
            ("F_0", "<msub>"),
            ("forcing_amplitude", "forcing amplitude"),
        ] {
            assert!(symbol(name).0.contains(shown), "{name}: {}", symbol(name).0);
        }
        assert_eq!(symbol("<b>").0, "&lt;b&gt;");
    }
}
