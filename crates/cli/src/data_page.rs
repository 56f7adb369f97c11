//! The page beside the CSV files that explains their columns.

use std::path::{Path, PathBuf};

use askama::Template;
use grazing_results::{Names, TablePlan};

use crate::folder::{DATA, OutputFile};
use crate::template::rendered;

#[derive(Template)]
#[template(path = "data.md", escape = "none")]
struct Page<'a> {
    names: &'a Names,
    /// Whether columns have units.
    units: bool,
    /// Tables with the same rows, and their files.
    sections: Vec<(TablePlan, Vec<String>)>,
}

/// The path of the page in a folder of results.
pub(crate) fn path() -> PathBuf {
    Path::new(DATA).join("README.md")
}

/// The page about the tables that `reproduce` writes.
pub(crate) fn of_the_paper(tables: impl IntoIterator<Item = TablePlan>) -> OutputFile {
    page(tables, &Names::of_the_paper(), false)
}

/// The page about the tables of an oscillator whose parameters have these names.
pub(crate) fn of_an_oscillator(tables: impl IntoIterator<Item = TablePlan>, names: &Names) -> OutputFile {
    page(tables, names, true)
}

fn page(tables: impl IntoIterator<Item = TablePlan>, names: &Names, units: bool) -> OutputFile {
    let mut sections: Vec<(TablePlan, Vec<String>)> = Vec::new();
    for table in tables {
        let file = format!("{}.csv", table.name);
        match sections.iter_mut().find(|(plan, _)| plan.columns == table.columns && plan.row == table.row) {
            Some((_, files)) => files.push(file),
            None => sections.push((table, vec![file])),
        }
    }
    OutputFile { path: path(), content: rendered(&Page { names, units, sections }).into_bytes() }
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
        assert!(text.contains("| `F_0` | $F_{0}$ | F_0 | primary parameter"), "{text}");
        assert!(text.contains("| `impact_velocity` | $y_{\\mathrm{imp}}$ | length/time |"), "{text}");
        // The column of walls is left out where there is one.
        assert!(!text.contains("`wall`") && !text.contains("``"), "{text}");
    }
}
