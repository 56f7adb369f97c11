//! The page beside the CSV files that explains their columns.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use grazing_results::{Column, Names, TablePlan};

use crate::folder::{DATA, OutputFile};

/// Where the page lies in a folder of results.
pub(crate) fn path() -> PathBuf {
    Path::new(DATA).join("README.md")
}

const HEAD: &str = "# The data\n\nA header, `.` decimals, 17 significant digits, empty cells where there is no value. This page is made with the tables, from the \
                    same declarations.\n";

/// The page about the tables that `reproduce` makes.
pub(crate) fn of_the_paper(tables: impl IntoIterator<Item = TablePlan>) -> OutputFile {
    let head = format!(
        "{HEAD}\nWhatever a figure draws also stands here. All quantities are dimensionless, as in eq:oscf; phases and angles are in radians. Where no \
         parameter file matters, this is said.\n"
    );
    OutputFile { path: path(), content: page(head, tables, &Names::of_the_paper(), false).into_bytes() }
}

/// The page about the tables of an oscillator whose parameters have these names.
pub(crate) fn of_an_oscillator(tables: impl IntoIterator<Item = TablePlan>, names: &Names) -> OutputFile {
    let head = format!(
        "{HEAD}\nAll quantities have the units of the oscillator's file, in which length, time, `{}` and `{}` are counted; where there is no unit it is \
         1. μ is `{0}`, η is `{1}`.\n",
        names.primary, names.secondary
    );
    OutputFile { path: path(), content: page(head, tables, names, true).into_bytes() }
}

/// Tables with the same rows share a section.
fn page(mut text: String, tables: impl IntoIterator<Item = TablePlan>, names: &Names, units: bool) -> String {
    let mut sections: Vec<(TablePlan, Vec<&str>)> = Vec::new();
    for table in tables {
        match sections.iter_mut().find(|(plan, _)| plan.columns == table.columns && plan.row == table.row) {
            Some((_, files)) => files.push(table.name),
            None => sections.push((table, vec![table.name])),
        }
    }
    for (plan, files) in sections {
        let files: Vec<String> = files.iter().map(|name| format!("{name}.csv")).collect();
        let (unit, line) = if units { (" unit |", "---|") } else { ("", "") };
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "\n## {}\n\nA row is {}.\n\n| column | symbol |{unit} meaning | in the paper |\n|---|---|{line}---|---|\n",
            files.join(", "),
            plan.row
        );
        for column in plan.columns {
            text.push_str(&row(column, names, units));
        }
    }
    text
}

fn row(column: &Column, names: &Names, units: bool) -> String {
    let symbol = column.symbol(names);
    let symbol = if symbol.is_empty() { symbol } else { format!("${symbol}$") };
    let unit = match column.unit {
        _ if !units => String::new(),
        "1" => " |".to_owned(),
        unit => format!(" {} |", names.unit(unit)),
    };
    let (header, meaning) = (column.header(names), column.meaning());
    // A bar would end the cell.
    let [symbol, meaning] = [symbol, meaning.to_owned()].map(|text| text.replace('|', "\\|"));
    format!("| `{header}` | {symbol} |{unit} {meaning} | {} |\n", column.equations)
}

#[cfg(test)]
mod tests {
    use grazing_results::plane::PlanePoint;

    use super::*;

    #[test]
    fn columns_bear_the_names_symbols_and_units_of_the_parameters() {
        let tables = ["one", "two"].map(|name| TablePlan::of::<PlanePoint>(name, "a point"));
        let made = of_an_oscillator(tables, &Names::new("F_0", "omega"));
        let text = String::from_utf8(made.content).expect("it is text");
        assert!(text.contains("\n## one.csv, two.csv\n\nA row is a point.\n"), "{text}");
        assert!(text.contains("| `F_0` | $F_{0}$ | F_0 | the primary parameter"), "{text}");
        assert!(text.contains("| `impact_velocity` | $y_{\\mathrm{imp}}$ | length/time |"), "{text}");
    }
}
