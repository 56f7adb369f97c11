//! Outputs: named figures and tables, with the parameters that they need and the functions that
//! compute and draw them.
//!
//! The figures and tables of the paper are listed in [`paper`], those of an oscillator from a file
//! in `oscillator`, those of a family in `family`. Every output is computed and checked by
//! `Output::compute`, and written to files by `ComputedOutput::files`.

pub mod edition;
pub(crate) mod family;
pub mod latex;
pub(crate) mod oscillator;
pub mod paper;

use std::error::Error;
use std::path::{Path, PathBuf};

use grazing_drawing::{Sheet, SheetWidth};
use grazing_report::FigureEntry;
use grazing_reproduction::StudyError;
use grazing_reproduction::parameters::ParameterError;
use grazing_results::columns::{
    C_PD, C_SN, LOOPS, PRIMARY_AT_GRAZING, RESONANCE_INDEX, S_MINUS, S_PLUS, SECONDARY_AT_RESONANCE,
};
use grazing_results::{Cell, Column, Table, TablePlan, Title};

use crate::failure::{Failure, computation};
use crate::folder::OutputFile;
use crate::{tables, terminal};
use edition::{Edition, Format, Room};
use latex::{Caption, Float};

pub use paper::ALL;

/// A figure with its data, or tables, that can be computed from a `Source`.
pub struct Output<Source> {
    /// The name on the command line, or in messages.
    pub name: &'static str,
    /// The title, in one line.
    pub title: Title<&'static str>,
    /// The label of the figure in the paper, or that of the table in LaTeX; empty where these
    /// depend on the source.
    pub label: &'static str,
    /// Whether the output has a figure.
    pub is_figure: bool,
    /// The tables of the output.
    pub tables: &'static [TablePlan],
    /// The table that a document prints, and its columns, in an edition that has LaTeX.
    pub(crate) printed: Option<PrintedTable>,
    /// Checks the parameters that the output cannot do without.
    check: fn(&Source) -> Result<(), ParameterError>,
    /// The keys to change if the output cannot be computed; empty if there are none.
    keys: &'static str,
    compute: Computation<Source>,
}

/// The function that computes and draws an output, at a width.
type Computation<Source> = fn(&Output<Source>, &Source, SheetWidth) -> Result<ComputedOutput, Box<dyn Error>>;

/// A table that a document prints, by its name, and the columns that it prints.
type PrintedTable = (&'static str, &'static [Column]);

/// The table of coefficients that a document prints, with its columns.
const COEFFICIENT_COLUMNS: PrintedTable = (
    "coefficients",
    &[LOOPS, RESONANCE_INDEX, SECONDARY_AT_RESONANCE, PRIMARY_AT_GRAZING, S_PLUS, S_MINUS, C_SN, C_PD],
);

/// A computed output.
#[derive(Default)]
pub(crate) struct ComputedOutput {
    pub(crate) figures: Vec<DrawnFigure>,
    pub(crate) tables: Vec<Table>,
    /// Sentences about what is shown in another way than requested.
    pub(crate) notes: Vec<String>,
    /// Sentences about what is missing compared with the request, with the keys to change.
    pub(crate) gaps: Vec<String>,
    /// The tables that a document prints.
    printed: Vec<(PrintedTable, Caption)>,
}

/// A computed output with its files, and its floats for a document in LaTeX.
type MadeOutput = (ComputedOutput, Vec<OutputFile>, Vec<Float>);

/// A figure of an output.
pub(crate) struct DrawnFigure {
    /// The file of its SVG.
    pub(crate) file: String,
    pub(crate) sheet: Sheet,
    pub(crate) caption: Caption,
    /// The tables whose rows the figure shows.
    pub(crate) tables: Vec<&'static str>,
    /// A column and the numbers in it that select the rows shown; without it, the figure shows all rows.
    pub(crate) only: Option<(Column, Vec<u32>)>,
}

impl DrawnFigure {
    /// A figure computed from the file `of`, which shows all rows of its tables.
    pub(crate) fn new(
        of: &Path,
        file: String,
        title: impl Into<Title>,
        sheet: Sheet,
        tables: &[&'static str],
    ) -> Self {
        let label = Caption::label("fig", of, file.trim_end_matches(".svg"));
        let caption = Caption { title: title.into(), label, remark: String::new() };
        Self { file, sheet, caption, tables: tables.to_vec(), only: None }
    }
}

impl<Source> Output<Source> {
    /// An output that needs no parameters.
    const fn new(
        name: &'static str,
        title: Title<&'static str>,
        tables: &'static [TablePlan],
        compute: Computation<Source>,
    ) -> Self {
        Self {
            name,
            title,
            label: "",
            is_figure: false,
            tables,
            printed: None,
            check: |_| Ok(()),
            keys: "",
            compute,
        }
    }

    /// The paths of the output's files in the output folder of an edition.
    pub fn paths(&self, edition: &Edition) -> Vec<PathBuf> {
        let figure = self.is_figure.then(|| self.figure_file());
        let figures = figure.iter().flat_map(|figure| edition.figure_paths(figure));
        let tables = self.tables.iter().map(|table| tables::path(table.name));
        let parquet = self.tables.iter().filter(|_| edition.has(Format::Parquet));
        let tables = tables.chain(parquet.map(|table| tables::parquet_path(table.name)));
        let printed = self.printed.iter().filter(|_| edition.has(Format::Tex));
        figures.chain(tables).chain(printed.map(|(table, _)| latex::table_path(table))).collect()
    }

    /// The SVG file of the figure; each of several sheets has its number in the name.
    pub fn figure_file(&self) -> String {
        format!("{}.svg", self.name)
    }

    /// The names of the output's tables.
    fn table_names(&self) -> Vec<&'static str> {
        self.tables.iter().map(|table| table.name).collect()
    }

    /// Computes the output and draws its figures.
    ///
    /// # Errors
    /// A section of the parameter file is wrong, the computation failed, or the tables are other
    /// ones than announced.
    pub(crate) fn compute(&self, source: &Source, width: SheetWidth) -> Result<ComputedOutput, Failure> {
        (self.check)(source)?;
        let mut computed = (self.compute)(self, source, width).map_err(|error| self.failure(&*error))?;
        let names: Vec<&'static str> = computed.tables.iter().map(|table| table.name).collect();
        if names != self.table_names() {
            let announced = self.table_names();
            let reason = format!("the tables are {names:?}, but the list of outputs has {announced:?}");
            return Err(Failure::output(self.name, reason));
        }
        computed.gaps.iter_mut().for_each(|gap| gap.push_str(&self.remedy()));
        Ok(computed)
    }

    /// Computes the output, with its files in an edition and its floats for a document in LaTeX.
    ///
    /// # Errors
    /// Those of [`compute`](Self::compute) and [`ComputedOutput::files`].
    pub(crate) fn made(&self, source: &Source, edition: &Edition) -> Result<MadeOutput, Failure> {
        let computed = self.compute(source, edition.columns)?;
        let (files, floats) = computed.files(edition)?;
        computed.notes.iter().for_each(|note| terminal::note(&format!("{}: {note}", self.name)));
        Ok((computed, files, floats))
    }

    fn remedy(&self) -> String {
        if self.keys.is_empty() { String::new() } else { format!("; change {}", self.keys) }
    }

    /// The failure to compute the output, with the keys to change unless the error names one itself.
    fn failure(&self, error: &(dyn Error + 'static)) -> Failure {
        let mut failure = computation(self.name, error);
        if !matches!(error.downcast_ref(), Some(StudyError::NoPortrait(_) | StudyError::Parameters(_))) {
            failure.reason.push_str(&self.remedy());
        }
        failure
    }
}

/// The files beside figures and tables: those for a document in LaTeX, if the edition has it, and the page about the
/// tables.
pub(crate) fn accompanying<'c>(
    edition: &Edition,
    floats: &[Float],
    constants: impl IntoIterator<Item = (&'c str, f64)>,
    about: OutputFile,
) -> impl Iterator<Item = OutputFile> {
    let latex = edition.has(Format::Tex).then(|| latex::files(floats, constants));
    latex.into_iter().flatten().chain([about])
}

/// The files of an edition, the floats for a document in LaTeX, and the pictures for which there is no room.
pub(crate) type FilesWithin = (Vec<OutputFile>, Vec<Float>, Vec<PathBuf>);

impl ComputedOutput {
    /// An output of figures and tables alone.
    pub(crate) fn new(figures: Vec<DrawnFigure>, tables: Vec<Table>) -> Self {
        Self { figures, tables, ..Self::default() }
    }

    /// Several outputs joined into one.
    pub(crate) fn joined(outputs: impl IntoIterator<Item = Self>) -> Self {
        let mut all = Self::default();
        for output in outputs {
            all.figures.extend(output.figures);
            all.tables.extend(output.tables);
            all.notes.extend(output.notes);
            all.gaps.extend(output.gaps);
            all.printed.extend(output.printed);
        }
        all
    }

    /// The files of an edition, and the floats for a document in LaTeX, if the edition has it.
    ///
    /// # Errors
    /// A figure cannot be converted, or a table cannot be written.
    pub(crate) fn files(&self, edition: &Edition) -> Result<(Vec<OutputFile>, Vec<Float>), Failure> {
        let (files, floats, _) = self.files_within(edition, &|_| true)?;
        Ok((files, floats))
    }

    /// The same as far as there is room, and the pictures for which there is none.
    ///
    /// # Errors
    /// Those of [`files`](Self::files).
    pub(crate) fn files_within(&self, edition: &Edition, room: &Room<'_>) -> Result<FilesWithin, Failure> {
        let (mut files, mut floats, mut left_out) = (Vec::new(), Vec::new(), Vec::new());
        let has_latex = edition.has(Format::Tex);
        for DrawnFigure { file, sheet, caption, .. } in &self.figures {
            let made = edition.figure_files(file, sheet, room);
            let (made, too_large) = made.map_err(|error| computation("figures", &error))?;
            files.extend(made);
            left_out.extend(too_large);
            if has_latex {
                floats.push(Float::figure(file, sheet, caption));
            }
        }
        for table in &self.tables {
            files.push(tables::file(table, "tables")?);
            if edition.has(Format::Parquet) {
                files.push(tables::parquet_file(table, "tables")?);
            }
        }
        for ((name, columns), caption) in self.printed.iter().filter(|_| has_latex) {
            let table = self.tables.iter().find(|table| table.name == *name);
            if let Some((float, file)) = table.and_then(|table| Float::table(table, columns, caption)) {
                floats.push(float);
                files.push(file);
            }
        }
        Ok((files, floats, left_out))
    }

    /// The figures as entries of a page, each with the rows that it shows.
    pub(crate) fn entries(&self) -> impl Iterator<Item = FigureEntry> {
        self.figures.iter().map(|DrawnFigure { file, sheet, caption, tables, only }| {
            let tables = tables.iter().filter_map(|name| self.table(name));
            FigureEntry {
                name: file.trim_end_matches(".svg").to_owned(),
                title: caption.title.clone(),
                sheet: sheet.clone(),
                tables: tables.map(|table| with_only(table.clone(), only.as_ref())).collect(),
            }
        })
    }

    /// The table with this name.
    pub(crate) fn table(&self, name: &str) -> Option<&Table> {
        self.tables.iter().find(|table| table.name == name)
    }
}

/// The table with only those rows that have one of the numbers in the column.
fn with_only(mut table: Table, only: Option<&(Column, Vec<u32>)>) -> Table {
    if let Some((place, numbers)) =
        only.and_then(|(column, numbers)| Some((table.position(column.name)?, numbers)))
    {
        table.rows.retain(|row| matches!(&row[place], Cell::Integer(number) if numbers.contains(number)));
    }
    table
}

/// The file of a sheet of a figure; several sheets are numbered from 1: `family.svg` or `family-2.svg`.
pub(crate) fn sheet_file(file: &str, number: usize, count: usize) -> String {
    let name = Path::new(file).file_stem().unwrap_or_default().to_string_lossy();
    if count == 1 { file.to_owned() } else { format!("{name}-{number}.svg") }
}

#[cfg(test)]
mod tests {
    use grazing_results::{Names, columns};

    use super::*;

    #[test]
    fn a_sheet_gets_the_rows_of_its_own_panels() {
        const COLUMNS: &[Column] = &[columns::PANEL];
        let table = |panels: &[u32]| {
            let rows = panels.iter().map(|panel| vec![Cell::from(*panel)]).collect();
            Table::of_cells("magnifications", COLUMNS, &Names::of_the_paper(), rows)
        };
        let only = (columns::PANEL, vec![2, 10]);
        assert_eq!(with_only(table(&[1, 2, 2, 10]), Some(&only)), table(&[2, 2, 10]));
        assert_eq!(with_only(table(&[1, 2]), None), table(&[1, 2]));
    }

    #[test]
    fn sheets_are_numbered_if_there_are_several() {
        assert_eq!(sheet_file("family.svg", 1, 1), "family.svg");
        assert_eq!(sheet_file("family.svg", 2, 3), "family-2.svg");
    }
}
