//! `grazing compare`: the published values with the computed ones beside them.

use std::fmt::Write;

use grazing_claims::published::{Comparison, Published, Rounding, Tally};
use grazing_reproduction::Study;

use crate::arguments::ParameterFile;
use crate::failure::{Failure, computation};
use crate::{project, terminal};

/// How many digits more than the print has are shown of a computed value.
const DIGITS_BEYOND_PRINT: usize = 4;
/// The space between columns.
const GAP: &str = "  ";

/// Prints the comparison.
///
/// # Errors
/// A value is not met, or there is nothing to compare.
pub(crate) fn run(file: &ParameterFile) -> Result<(), Failure> {
    crate::limits::leave_nothing_behind();
    let parameters = project::parameters(file)?;
    let comparisons = published(&Study::new(&parameters))?;
    terminal::say_coloured(&table(&comparisons, terminal::is_coloured()));
    let tally = Tally::of(&comparisons);
    if !tally.is_complete() {
        return Err(Failure::check(tally.to_string()));
    }
    terminal::say(&format!("\n{tally}.\n"));
    Ok(())
}

/// What the paper prints, with what the study gives.
pub(crate) fn published(study: &Study) -> Result<Vec<Comparison<'static>>, Failure> {
    let computed = study.published_values().map_err(|error| computation("published values", &error))?;
    Ok(Published::printed().compare(&computed))
}

/// The comparisons as a table with aligned columns, one line each.
pub fn table(comparisons: &[Comparison<'_>], coloured: bool) -> String {
    let header = ["quantity", "printed", "computed", "difference", "verdict", "where"].map(str::to_owned);
    let mut rows = vec![(header, None)];
    rows.extend(comparisons.iter().map(|comparison| (cells(comparison), Some(comparison.is_met()))));
    let width = |column: usize| rows.iter().map(|(cells, _)| cells[column].len()).max().unwrap_or(0);
    let [w0, w1, w2, w3, w4] = [0, 1, 2, 3, 4].map(width);
    let mut table = String::new();
    for ([quantity, printed, computed, difference, verdict, place], met) in &rows {
        let verdict = match met.filter(|_| coloured) {
            Some(true) => format!("\x1b[32m{verdict:w4$}\x1b[0m"),
            Some(false) => format!("\x1b[1;31m{verdict:w4$}\x1b[0m"),
            None => format!("{verdict:w4$}"),
        };
        // Writing to a string cannot fail.
        let _ = writeln!(
            table,
            "{quantity:w0$}{GAP}{printed:>w1$}{GAP}{computed:>w2$}{GAP}{difference:>w3$}{GAP}{verdict}{GAP}{place}",
        );
    }
    table
}

/// Quantity, printed, computed, difference, verdict, place.
fn cells(comparison: &Comparison<'_>) -> [String; 6] {
    let published = comparison.published;
    let decimals = published.decimals() + DIGITS_BEYOND_PRINT;
    let computed = comparison.computed.map(|computed| match published.rounding {
        Rounding::Exact => format!("{computed}"),
        Rounding::Significant => format!("{computed:.decimals$}"),
    });
    let difference = comparison
        .difference()
        .map(|difference| if difference == 0.0 { "0".to_owned() } else { format!("{difference:.1e}") });
    let verdict = match comparison.computed {
        Some(_) if comparison.is_met() => "met",
        Some(_) => "OFF",
        None => "NOT COMPUTED",
    };
    [
        published.quantity.clone(),
        published.printed.clone(),
        computed.unwrap_or_default(),
        difference.unwrap_or_default(),
        verdict.to_owned(),
        format!("{} ({})", published.place, published.label),
    ]
}
