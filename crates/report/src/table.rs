//! Outputs that are tables only.

use crate::columns::{explanation, heading};
use crate::csv::Cells;
use crate::html::{counted, escape, number, put};
use crate::{OscillatorEntry, Report, prose};

/// A table as CSV: a header, commas, no quotes.
#[derive(Debug, Clone, PartialEq)]
pub struct CsvTable {
    /// File name without ending, as `fig07_curves`.
    pub name: String,
    /// The text.
    pub csv: String,
}

impl CsvTable {
    /// The path of its file among the outputs.
    pub(crate) fn path(&self) -> String {
        format!("data/{}.csv", self.name)
    }
}

/// An output that is one or more tables.
#[derive(Debug, Clone, PartialEq)]
pub struct TableOutput {
    /// The output's name, as `coefficients`.
    pub name: String,
    /// What it shows, in one line.
    pub title: String,
    /// The tables.
    pub tables: Vec<CsvTable>,
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

fn one(report: &Report, table: &CsvTable) -> String {
    let path = table.path();
    let written = report.manifest.outputs.iter().any(|file| file.path == path);
    let link = written.then(|| report.manifest.link(&path));
    // Short ones are open.
    let open = table.csv.lines().count() <= LONG + 1;
    folded(table, &table.name, open, link)
}

/// A table of an oscillator.
pub(crate) fn of_oscillator(oscillator: &OscillatorEntry, table: &CsvTable) -> String {
    let path = table.path();
    let written = oscillator.files.contains(&path);
    let link = written.then(|| format!("<a href=\"{0}\"><code>{0}</code></a>", escape(&path)));
    folded(table, &format!("{}-{}", oscillator.anchor(), table.name), false, link)
}

/// A table that can be folded away, with a name that no other on the page has.
fn folded(table: &CsvTable, id: &str, open: bool, link: Option<String>) -> String {
    let cells = Cells::read(&table.csv);
    let (name, id) = (escape(&table.name), escape(id));
    let open = if open { " open" } else { "" };
    let mut html = format!(
        "<details class=\"table\"{open}>\n<summary><code>{name}</code> <span>{}</span>{}</summary>\n",
        counted(cells.rows.len(), "row", "rows"),
        verdicts(&cells),
    );
    put!(
        html,
        "<p class=\"scripted filter\"><label>Filter <input type=\"search\" data-filters=\"table-{id}\" \
         placeholder=\"text of a row\"></label> <output>{}</output></p>\n",
        counted(cells.rows.len(), "row", "rows"),
    );
    put!(
        html,
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{name}\">\n<table class=\"sortable data\" id=\"table-{id}\"><thead><tr>"
    );
    let numeric: Vec<bool> = (0..cells.header.len())
        .map(|column| {
            cells
                .rows
                .iter()
                .all(|row| row.get(column).is_none_or(|cell| cell.is_empty() || cell.parse::<f64>().is_ok()))
        })
        .collect();
    for (column, numeric) in cells.header.iter().zip(&numeric) {
        let class = if *numeric { " class=\"number\"" } else { "" };
        put!(
            html,
            "<th scope=\"col\"{class} title=\"{}\">{}</th>",
            escape(explanation(column)),
            heading(column)
        );
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for row in &cells.rows {
        html.push_str("<tr>");
        for ((cell, column), numeric) in row.iter().zip(&cells.header).zip(&numeric) {
            html.push_str(&shown(cell, column, *numeric));
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

fn shown(cell: &str, column: &str, numeric: bool) -> String {
    match cell.parse::<f64>() {
        Ok(value) if numeric && cell.contains('.') => {
            let shown = number(value, DIGITS);
            // What a script cannot read as a number is given for sorting.
            let sort = if shown.contains('<') { format!(" data-value=\"{value:e}\"") } else { String::new() };
            format!("<td class=\"number\"{sort}>{shown}</td>")
        }
        Ok(_) if numeric => format!("<td class=\"number\">{}</td>", escape(&cell.replace('-', "−"))),
        _ if numeric => "<td class=\"number\"></td>".to_owned(),
        _ if column == VERDICT => {
            format!("<td><span class=\"verdict {}\">{}</span></td>", tone(cell), escape(cell))
        }
        _ => format!("<td>{}</td>", escape(&cell.replace('_', " "))),
    }
}

/// How often each verdict occurs, the most frequent first.
fn verdicts(cells: &Cells<'_>) -> String {
    let Some(column) = cells.column(VERDICT) else {
        return String::new();
    };
    let mut counts: Vec<(&str, usize)> = Vec::new();
    for word in cells.rows.iter().filter_map(|row| row.get(column)).map(AsRef::as_ref) {
        match counts.iter_mut().find(|(known, _)| *known == word) {
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
    use super::*;

    #[test]
    fn verdicts_are_counted_and_coloured() {
        let cells = Cells::read("p,verdict\n1,agreement\n2,unexplained\n3,agreement\n4,explained\n");
        let html = verdicts(&cells);
        let at = |text: &str| html.find(text).unwrap_or_else(|| panic!("{text} is missing in {html}"));
        assert!(at("passed\">2 agreement") < at("unchecked\">1 explained"));
        assert!(at("unchecked\">1 explained") < at("failed\">1 unexplained"));
    }

    #[test]
    fn numbers_are_rounded_for_the_eye_and_can_be_sorted() {
        let cell = shown("-5.6794452873805710e2", "c_sn", true);
        assert_eq!(cell, "<td class=\"number\">−567.9445</td>");
        assert_eq!(
            shown("1.5000000000000000e-9", "c_sn", true),
            "<td class=\"number\" data-value=\"1.5e-9\">1.5 × 10<sup>−9</sup></td>"
        );
        assert_eq!(shown("a<b", "kind", false), "<td>a&lt;b</td>");
    }
}
