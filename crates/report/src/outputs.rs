//! Outputs as the page shows them: figures and tables.

use grazing_drawing::Sheet;
use grazing_results::Table;

/// A figure with its data.
#[derive(Debug, Clone, PartialEq)]
pub struct FigureEntry {
    /// The name of its files, as `fig07`.
    pub name: String,
    /// What it shows, in one line: "Figure 7: two-parameter bifurcation diagram".
    pub title: String,
    /// What is drawn. Panels say where the axes are; without them the figure can be zoomed only.
    pub sheet: Sheet,
    /// The tables that are drawn.
    pub tables: Vec<Table>,
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
