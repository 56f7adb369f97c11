//! The output that `unfold --vary` writes: the resonances of a family.

use std::error::Error;
use std::path::PathBuf;

use grazing_drawing::{SheetWidth, draw_family};
use grazing_results::Title;
use grazing_results::family::Family;
use grazing_results::{Names, Tables};

use super::{ComputedOutput, DrawnFigure, Output, sheet_file};

/// A family with its names.
pub(crate) struct NamedFamily {
    /// The file of the oscillator.
    pub(crate) file: PathBuf,
    /// The name of the oscillator.
    pub(crate) name: String,
    /// The names of the parameters and of the constants that vary.
    pub(crate) names: Names,
    pub(crate) family: Family,
}

/// The figure, if there is room for it on one sheet, and the tables of a family.
pub(crate) const FAMILY: Output<NamedFamily> = Output {
    is_figure: true,
    ..Output::new(
        "family",
        Title::plain("resonant grazing bifurcations of a family"),
        Family::TABLES,
        compute,
    )
};

fn compute(
    output: &Output<NamedFamily>,
    of: &NamedFamily,
    width: SheetWidth,
) -> Result<ComputedOutput, Box<dyn Error>> {
    let title = format!("{}: {}", of.name, output.title);
    let sheets = draw_family(&of.family, &of.names, &title, width)?;
    let count = sheets.len();
    let file = output.figure_file();
    let figures = sheets.into_iter().zip(1..).map(|(sheet, number)| {
        let file = sheet_file(&file, number, count);
        DrawnFigure::new(&of.file, file, output.title.owned(), sheet, &output.table_names())
    });
    Ok(ComputedOutput::new(figures.collect(), of.family.tables(&of.names)))
}
