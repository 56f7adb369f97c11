//! Outputs that are tables only.

use askama::Template;
use askama::filters::Safe;
use grazing_results::columns::HYPOTHESIS;
use grazing_results::{Cell, Column, Table, Tone};

use crate::columns::heading;
use crate::data::{self, SHOWN_DIGITS};
use crate::formula::signs;
use crate::html::{Html, capitalised, csv_path, escape, number, rendered};
use crate::oscillator::OscillatorEntry;
use crate::report::Report;

/// The most rows of a table that begins open; longer ones begin closed, and the scripts build their
/// rows when they are opened.
const LONGEST_OPEN_TABLE: usize = 40;

/// A table that can be folded away.
#[derive(Template)]
#[template(path = "table.html")]
struct TableSection<'a> {
    table: &'a Table,
    /// A name that no other table on the page has.
    id: String,
    /// The caption, in words.
    caption: String,
    /// The rows for the scripts, if there are many.
    packed: Option<String>,
    /// A link to the file of the table, if it is written.
    link: Option<Html>,
}

impl<'a> TableSection<'a> {
    fn new(table: &'a Table, id: String, caption: String, link: Option<Html>) -> Self {
        let packed = (table.rows.len() > LONGEST_OPEN_TABLE).then(|| data::of_table(table));
        Self { table, id, caption, packed, link }
    }

    /// Verdicts with the classes of their colours, for the scripts.
    fn tones(&self) -> String {
        let tones = verdicts(self.table).into_iter().map(|(word, tone, _)| format!("{word}={}", tone.name()));
        tones.collect::<Vec<_>>().join("|")
    }
}

/// A table of the paper; short ones are open.
pub(crate) fn of_the_paper(report: &Report<'_>, title: &str, table: &Table) -> Html {
    let link = report.links(&[csv_path(table)], false).pop();
    rendered(&TableSection::new(table, table.name.to_owned(), title.to_owned(), link))
}

/// A table of an oscillator.
pub(crate) fn of_oscillator(report: &Report<'_>, oscillator: &OscillatorEntry, table: &Table) -> Html {
    let link = report.links(&[csv_path(table)], true).pop();
    let id = format!("{}-{}", oscillator.anchor(), table.name);
    let caption = format!("{} of {}", capitalised(table.name), oscillator.description.name());
    rendered(&TableSection::new(table, id, caption, link))
}

/// Whether each column holds numbers, with its meaning and its heading.
fn headings(table: &Table) -> Vec<(bool, String, Html)> {
    let numeric =
        |cell: usize| table.rows.first().map(|row| matches!(row[cell], Cell::Integer(_) | Cell::Number(_)));
    let columns = table.columns.iter().enumerate();
    let heading = |(place, column): (usize, &Column)| {
        let unit = match table.units[place].as_str() {
            "" => String::new(),
            unit => format!(", in {unit}"),
        };
        let meaning = format!("{}{unit}", column.meaning().replace('`', ""));
        (numeric(place).unwrap_or(false), meaning, heading(table, place))
    };
    columns.map(heading).collect()
}

fn shown(cell: &Cell, column: &Column) -> Html {
    Safe(match cell {
        Cell::Number(_) => match cell.number() {
            Some(value) => {
                let shown = number(&value, SHOWN_DIGITS).0;
                // The value for sorting, if a script cannot read the text as a number.
                let sort =
                    if shown.contains('<') { format!(" data-value=\"{value:e}\"") } else { String::new() };
                format!("<td class=\"number\"{sort}>{shown}</td>")
            }
            None => "<td class=\"number\"></td>".to_owned(),
        },
        Cell::Integer(value) => format!("<td class=\"number\">{value}</td>"),
        Cell::Flag(value) => format!("<td>{value}</td>"),
        Cell::Verdict(word, tone) => {
            format!("<td><span class=\"verdict {}\">{}</span></td>", tone.name(), escape(word))
        }
        Cell::Text(words) if column.name == HYPOTHESIS.name => format!("<td>{}</td>", escape(&signs(words))),
        Cell::Text(words) => format!("<td>{}</td>", escape(&words.replace('_', " "))),
    })
}

/// The verdicts, with what they mean and their numbers, the most frequent first.
fn verdicts(table: &Table) -> Vec<(&'static str, Tone, usize)> {
    let mut counts: Vec<(&str, Tone, usize)> = Vec::new();
    for cell in table.rows.iter().flatten() {
        let Cell::Verdict(word, tone) = *cell else { continue };
        match counts.iter_mut().find(|(known, ..)| *known == word) {
            Some((.., count)) => *count += 1,
            None => counts.push((word, tone, 1)),
        }
    }
    counts.sort_by(|a, b| b.2.cmp(&a.2).then(a.0.cmp(b.0)));
    counts
}

#[cfg(test)]
mod tests {
    use grazing_results::Names;
    use grazing_results::columns::{self, LOOPS};

    use super::*;

    #[test]
    fn verdicts_are_counted_and_coloured() {
        const COLUMNS: &[Column] = &[LOOPS, columns::VERDICT];
        let [agreement, explained, unexplained] =
            [("agreement", Tone::Passed), ("explained", Tone::Unchecked), ("unexplained", Tone::Failed)];
        let rows = [(1, agreement), (2, unexplained), (3, agreement), (4, explained)];
        let rows = rows.map(|(p, (word, tone))| vec![Cell::from(p), Cell::Verdict(word, tone)]);
        let table = Table::of_cells("sample", COLUMNS, &Names::of_the_paper(), rows.into());
        let counted = [(agreement, 2), (explained, 1), (unexplained, 1)];
        assert_eq!(verdicts(&table), counted.map(|((word, tone), count)| (word, tone, count)));
        let coloured = "<td><span class=\"verdict failed\">unexplained</span></td>";
        assert_eq!(shown(&table.rows[1][1], &columns::VERDICT).0, coloured);
    }

    #[test]
    fn numbers_are_rounded_for_the_eye_and_can_be_sorted() {
        for (cell, html) in [
            (Cell::Number(-5.679_445_287_380_571e2), "<td class=\"number\">−567.9445</td>"),
            (Cell::Number(1.5e-9), "<td class=\"number\" data-value=\"1.5e-9\">1.5 × 10<sup>−9</sup></td>"),
            (Cell::Number(f64::NAN), "<td class=\"number\"></td>"),
            (Cell::from("a<b"), "<td>a&lt;b</td>"),
        ] {
            assert_eq!(shown(&cell, &LOOPS).0, html);
        }
    }
}
