//! `grazing compare`: the published values with the computed ones beside them.

use std::fmt::Write;

use grazing_reproduction::Study;
use grazing_reproduction::published::{Comparison, Published, Rounding, Verdict};

use crate::arguments::Compare;
use crate::failure::Failure;
use crate::outputs::computation;
use crate::{project, terminal};

/// How many digits more than the print has are shown of a computed value.
const DIGITS_BEYOND_PRINT: usize = 4;
/// The space between columns.
const GAP: &str = "  ";

/// Prints the comparison.
///
/// # Errors
/// [`Failure::PublishedOff`] if a value is not met; any other [`Failure`] if there is nothing to compare.
pub(crate) fn run(arguments: &Compare) -> Result<(), Failure> {
    let parameters = project::parameters(&arguments.parameters)?;
    let published = Published::printed()?;
    let computed = Study::new(&parameters)
        .published_values()
        .map_err(|error| computation("published values", &error))?;
    let comparisons = published.compare(&computed);
    terminal::say_coloured(&table(&comparisons, terminal::is_coloured()));
    let off = comparisons.iter().filter(|comparison| !comparison.is_met()).count();
    if off > 0 {
        return Err(Failure::PublishedOff { off, all: comparisons.len() });
    }
    terminal::say(&format!("\nAll {} published values are met.\n", comparisons.len()));
    Ok(())
}

/// The comparisons as a table with aligned columns, one line each.
pub fn table(comparisons: &[Comparison<'_>], coloured: bool) -> String {
    let mut rows = vec![Row::header()];
    rows.extend(comparisons.iter().map(Row::new));
    let mut widths = [0; 5];
    for row in &rows {
        for (width, cell) in widths.iter_mut().zip(&row.cells) {
            *width = (*width).max(cell.len());
        }
    }
    let mut table = String::new();
    for row in &rows {
        let [quantity, printed, computed, difference, verdict] = &row.cells;
        let [w0, w1, w2, w3, w4] = widths;
        let verdict = format!("{verdict:w4$}");
        let verdict = if coloured { row.paint(&verdict) } else { verdict };
        let line = format!(
            "{quantity:w0$}{GAP}{printed:>w1$}{GAP}{computed:>w2$}{GAP}{difference:>w3$}{GAP}{verdict}{GAP}{}",
            row.place
        );
        // Writing to a string cannot fail.
        let _ = writeln!(table, "{}", line.trim_end());
    }
    table
}

struct Row {
    /// Quantity, printed, computed, difference, verdict.
    cells: [String; 5],
    place: String,
    met: Option<bool>,
}

impl Row {
    fn header() -> Row {
        let cells = ["quantity", "printed", "computed", "difference", "verdict"].map(str::to_owned);
        Row { cells, place: "where".to_owned(), met: None }
    }

    fn new(comparison: &Comparison<'_>) -> Row {
        let published = comparison.published;
        let (computed, difference, verdict) = match comparison.verdict {
            Verdict::Met { computed, difference } => (Some(computed), Some(difference), "met"),
            Verdict::Off { computed, difference } => (Some(computed), Some(difference), "OFF"),
            Verdict::NotComputed => (None, None, "NOT COMPUTED"),
        };
        let decimals = published.decimals() + DIGITS_BEYOND_PRINT;
        let computed = computed.map(|computed| match published.rounding() {
            Rounding::Exact => format!("{computed}"),
            Rounding::Significant => format!("{computed:.decimals$}"),
        });
        let difference = difference
            .map(|difference| if difference == 0.0 { "0".to_owned() } else { format!("{difference:.1e}") });
        Row {
            cells: [
                published.quantity().to_owned(),
                published.printed().to_owned(),
                computed.unwrap_or_default(),
                difference.unwrap_or_default(),
                verdict.to_owned(),
            ],
            place: format!("{} ({})", published.place(), published.label()),
            met: Some(comparison.is_met()),
        }
    }

    fn paint(&self, verdict: &str) -> String {
        match self.met {
            Some(true) => format!("\x1b[32m{verdict}\x1b[0m"),
            Some(false) => format!("\x1b[1;31m{verdict}\x1b[0m"),
            None => verdict.to_owned(),
        }
    }
}
