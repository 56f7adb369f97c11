//! What columns and parameters are called on the page.

use std::collections::BTreeMap;

use grazing_results::Table;

use crate::formula::shown;
use crate::html::{escape, json_string, put};

/// A symbol as the page shows it; names in it may be of several words.
fn formula(latex: &str) -> String {
    shown(&latex.replace(r"\mathrm{", r"\text{"), false)
}

/// The name of a parameter as a symbol.
pub(crate) fn symbol(name: &str) -> String {
    grazing_results::symbol(name).map_or_else(|| escape(name), |latex| formula(&latex))
}

/// The heading of a column: its symbol, or its name in words.
pub(crate) fn heading(table: &Table, place: usize) -> String {
    match table.symbols[place].as_str() {
        "" => escape(&table.headers[place].replace('_', " ")),
        latex => formula(latex),
    }
}

/// The headings of all columns by their names, for the scripts.
pub(crate) fn json<'a>(tables: impl Iterator<Item = &'a Table>) -> String {
    let columns =
        tables.flat_map(|table| table.headers.iter().enumerate().map(move |column| (table, column)));
    let headings: BTreeMap<&str, String> =
        columns.map(|(table, (place, name))| (name.as_str(), heading(table, place))).collect();
    let mut json = String::from("{");
    for (index, (name, heading)) in headings.iter().enumerate() {
        let comma = if index == 0 { "" } else { "," };
        put!(json, "{comma}{}:{}", json_string(name), json_string(heading));
    }
    json.push('}');
    json
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
            assert!(symbol(name).contains(shown), "{name}: {}", symbol(name));
        }
        assert_eq!(symbol("<b>"), "&lt;b&gt;");
    }
}
