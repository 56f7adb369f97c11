//! The outputs on the page: figures and tables.

use grazing_drawing::Sheet;
use grazing_results::{Table, Title};

/// A figure with its data.
#[derive(Debug, Clone, PartialEq)]
pub struct FigureEntry {
    /// The name of the figure's files, as `fig07`.
    pub name: String,
    /// The title.
    pub title: Title,
    /// The drawing. Panels give the places of axes; without them the figure can only be zoomed.
    pub sheet: Sheet,
    /// The tables whose rows are drawn.
    pub tables: Vec<Table>,
}

/// An output that is one or more tables.
#[derive(Debug, Clone, PartialEq)]
pub struct TableOutput {
    /// The output's name, as `coefficients`.
    pub name: String,
    /// The title.
    pub title: Title,
    /// The tables.
    pub tables: Vec<Table>,
}
