//! Outputs that are tables only.

use grazing_results::{Cell, Table};

use crate::columns::heading;
use crate::html::{counted, escape, number, put};
use crate::{OscillatorEntry, Report, prose};

/// The path of a table's file among the outputs.
pub(crate) fn path(table: &Table) -> String {
    format!("data/{}.csv", table.name)
}

/// An output that is one or more tables.
#[derive(Debug, Clone, PartialEq)]
pub struct TableOutput {
    /// The output's name, as `coefficients`.
    pub name: String,
    /// What it shows, in one line.
    pub title: String,
    /// The tables.
    pub tables: Vec<Table>,
}

/// Significant digits shown; the whole number is in the data file.
const DIGITS: usize = 7;
/// Tables with more rows begin closed.
const LONG: usize = 40;
/// The column that says how a case came out.
const VERDICT: &str = "verdict";

pub(crate) fn section(report: &Report) -> String {
    let mut html = String::from(
        "<section id=\"tables\" aria-labelledby=\"tables-title\">\n<h2 id=\"tables-title\">Tables</h2>\n\
         <p class=\"lead scripted\">A click on a heading sorts. Numbers are shown with seven significant digits; the files have all.</p>\n",
    );
    for output in &report.tables {
        put!(html, "<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n", escape(&output.name));
        put!(html, "<h3 id=\"{}-title\">{}</h3>\n", escape(&output.name), prose(&output.title));
        for table in &output.tables {
            html.push_str(&one(report, table));
        }
        html.push_str("</section>\n");
    }
    html.push_str("</section>\n");
    html
}

fn one(report: &Report, table: &Table) -> String {
    let path = path(table);
    let written = report.manifest.outputs.iter().any(|file| file.path == path);
    let link = written.then(|| report.manifest.link(&path));
    // Short ones are open.
    let open = table.rows.len() <= LONG;
    folded(table, table.name, open, link)
}

/// A table of an oscillator.
pub(crate) fn of_oscillator(oscillator: &OscillatorEntry, table: &Table) -> String {
    let path = path(table);
    let written = oscillator.files.contains(&path);
    let link = written.then(|| format!("<a href=\"{0}\"><code>{0}</code></a>", escape(&path)));
    folded(table, &format!("{}-{}", oscillator.anchor(), table.name), false, link)
}

/// A table that can be folded away, with a name that no other on the page has.
fn folded(table: &Table, id: &str, open: bool, link: Option<String>) -> String {
    let (name, id) = (escape(table.name), escape(id));
    let open = if open { " open" } else { "" };
    let mut html = format!(
        "<details class=\"table\"{open}>\n<summary><code>{name}</code> <span>{}</span>{}</summary>\n",
        counted(table.rows.len(), "row", "rows"),
        verdicts(table),
    );
    put!(
        html,
        "<p class=\"scripted filter\"><label>Filter <input type=\"search\" data-filters=\"table-{id}\" \
         placeholder=\"text of a row\"></label> <output>{}</output></p>\n",
        counted(table.rows.len(), "row", "rows"),
    );
    put!(
        html,
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{name}\">\n<table class=\"sortable data\" id=\"table-{id}\"><thead><tr>"
    );
    for (place, column) in table.columns.iter().enumerate() {
        let numeric =
            table.rows.first().is_some_and(|row| matches!(row[place], Cell::Integer(_) | Cell::Number(_)));
        let class = if numeric { " class=\"number\"" } else { "" };
        put!(
            html,
            "<th scope=\"col\"{class} title=\"{}\">{}</th>",
            escape(column.meaning()),
            heading(table, place)
        );
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for row in &table.rows {
        html.push_str("<tr>");
        for (cell, column) in row.iter().zip(table.columns) {
            html.push_str(&shown(cell, column.name == VERDICT));
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody></table>\n</div>\n");
    if let Some(link) = link {
        put!(html, "<p class=\"links\"><span>File</span> {link}</p>\n");
    }
    html.push_str("</details>\n");
    html
}

fn shown(cell: &Cell, verdict: bool) -> String {
    match cell {
        Cell::Number(_) => match cell.number() {
            Some(value) => {
                let shown = number(value, DIGITS);
                // What a script cannot read as a number is given for sorting.
                let sort =
                    if shown.contains('<') { format!(" data-value=\"{value:e}\"") } else { String::new() };
                format!("<td class=\"number\"{sort}>{shown}</td>")
            }
            None => "<td class=\"number\"></td>".to_owned(),
        },
        Cell::Integer(value) => format!("<td class=\"number\">{value}</td>"),
        Cell::Flag(value) => format!("<td>{value}</td>"),
        Cell::Text(words) if verdict => {
            format!("<td><span class=\"verdict {}\">{}</span></td>", tone(words), escape(words))
        }
        Cell::Text(words) => format!("<td>{}</td>", escape(&words.replace('_', " "))),
    }
}

/// How often each verdict occurs, the most frequent first.
fn verdicts(table: &Table) -> String {
    let Some(cells) = table.column(VERDICT) else {
        return String::new();
    };
    let mut counts: Vec<(&str, usize)> = Vec::new();
    for cell in cells {
        let Cell::Text(word) = cell else { continue };
        match counts.iter_mut().find(|(known, _)| known == word) {
            Some((_, count)) => *count += 1,
            None => counts.push((word, 1)),
        }
    }
    counts.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
    let mut html = String::new();
    for (word, count) in counts {
        put!(html, " <span class=\"verdict {}\">{count} {}</span>", tone(word), escape(word));
    }
    html
}

/// The colour of a verdict: agreement, disagreement, or neither.
fn tone(verdict: &str) -> &'static str {
    let verdict = verdict.to_ascii_lowercase();
    if ["disagree", "unexplained", "fail"].iter().any(|word| verdict.contains(word)) {
        "failed"
    } else if verdict.contains("agree") || verdict == "met" || verdict == "passed" {
        "passed"
    } else {
        "unchecked"
    }
}

#[cfg(test)]
mod tests {
    use grazing_results::columns::{self, LOOPS};
    use grazing_results::{Column, Names};

    use super::*;

    #[test]
    fn verdicts_are_counted_and_coloured() {
        const COLUMNS: &[Column] = &[LOOPS, columns::VERDICT];
        let rows = [(1, "agreement"), (2, "unexplained"), (3, "agreement"), (4, "explained")];
        let rows = rows.map(|(p, word)| vec![Cell::from(p), Cell::from(word)]);
        let html = verdicts(&Table::of_cells("sample", COLUMNS, &Names::of_the_paper(), rows.into()));
        let at = |text: &str| html.find(text).unwrap_or_else(|| panic!("{text} is missing in {html}"));
        assert!(at("passed\">2 agreement") < at("unchecked\">1 explained"));
        assert!(at("unchecked\">1 explained") < at("failed\">1 unexplained"));
    }

    #[test]
    fn numbers_are_rounded_for_the_eye_and_can_be_sorted() {
        let number = |value: f64| shown(&Cell::Number(value), false);
        assert_eq!(number(-5.679_445_287_380_571e2), "<td class=\"number\">−567.9445</td>");
        assert_eq!(number(1.5e-9), "<td class=\"number\" data-value=\"1.5e-9\">1.5 × 10<sup>−9</sup></td>");
        assert_eq!(number(f64::NAN), "<td class=\"number\"></td>");
        assert_eq!(shown(&Cell::from("a<b"), false), "<td>a&lt;b</td>");
    }
}
