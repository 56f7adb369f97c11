//! The names of columns and parameters on the page.

use askama::filters::Safe;
use grazing_results::Table;

use crate::formula::{shown, words};
use crate::html::{Html, escape};

/// A symbol as the page shows it; names in it may have several words.
fn formula(latex: &str) -> Html {
    shown(&latex.replace(r"\mathrm{", r"\text{"), false)
}

/// The name of a parameter as a symbol.
pub(crate) fn symbol(name: &str) -> Html {
    grazing_results::symbol(name).map_or_else(|| Safe(escape(name)), |latex| formula(&latex))
}

/// The heading of a column: its symbol or name, and its unit if it has one.
pub(crate) fn heading(table: &Table, place: usize) -> Html {
    Safe(format!("{}{}", name(table, place).0, in_parentheses(&table.units[place])))
}

/// A unit in parentheses, after the name of a quantity; empty without one.
pub(crate) fn in_parentheses(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" ({})", words(unit).0) }
}

/// The name of a column: its symbol, or its name in words.
pub(crate) fn name(table: &Table, place: usize) -> Html {
    match table.symbols[place].as_str() {
        "" => Safe(escape(&table.headers[place].replace('_', " "))),
        latex => formula(latex),
    }
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
