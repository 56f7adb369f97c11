//! Oscillators from text files, as the page shows them, and a page about one of them.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use grazing_description::{Description, DescriptionError};
use grazing_drawing::SheetWidth;
use grazing_export::ExportError;
use grazing_report::{FigureEntry, Manifest, OscillatorEntry, OutputFile, Report};
use grazing_reproduction::unfolded::Rows;
use grazing_results::branches::OneParameterRows;
use grazing_results::{Cell, Column, Plan, Table, columns};
use grazing_source::Setting;

use super::{file_name, links, noted, versions};
use crate::failure::Failure;
use crate::folder::MadeFile;
use crate::outputs::computation;
use crate::outputs::edition::Edition;
use crate::outputs::latex::{self, Float};
use crate::unfold::sheets::{Sheet, SheetKind};
use crate::unfold::{self, Analysis, reason, sheets};
use crate::{project, tables};

/// The examples that the page shows anyway; any other can be asked for.
const EXAMPLES: [&str; 4] =
    ["clearance.toml", "duffing.toml", "quadratic-damping.toml", "varying-impact.toml"];
/// The tables that are shown as such.
const SHOWN: [&str; 3] = ["coefficients", "hypotheses", "points"];
/// The name of the page about an oscillator, in the folder of its results.
pub(crate) const PAGE: &str = "report.html";

/// A file that describes an oscillator.
pub(crate) struct OscillatorFile {
    pub(crate) file: PathBuf,
    /// What stands in it, with what was set over it on top.
    pub(crate) text: String,
    pub(crate) description: Description,
}

/// What there is of an oscillator once it is unfolded.
pub(crate) struct Material<'a> {
    of: &'a OscillatorFile,
    unfolded: &'a Analysis,
    pub(crate) figures: Vec<Sheet>,
    /// All tables, and what a row of each is.
    tables: Vec<Table>,
    pub(crate) plans: Vec<Plan>,
}

impl OscillatorFile {
    /// Reads a file, with settings that take the place of values in it.
    ///
    /// # Errors
    /// It cannot be read, or something in it is not right.
    pub(crate) fn read(file: &Path, settings: &[Setting]) -> Result<Self, Failure> {
        let description = Description::from_file_with(file, settings)?;
        let text = noted(&grazing_source::read_file(file).map_err(DescriptionError::from)?, settings);
        Ok(Self { file: file.to_owned(), text, description })
    }

    /// Some examples of the repository, then the given files.
    ///
    /// # Errors
    /// One cannot be read, or something in it is not right.
    pub(crate) fn all(root: Option<&Path>, given: &[PathBuf]) -> Result<Vec<Self>, Failure> {
        let folder = root.map(|root| root.join(project::EXAMPLES));
        let examples = folder.iter().flat_map(|folder| EXAMPLES.map(|name| folder.join(name)));
        let mut files: Vec<PathBuf> = examples.filter(|file| file.is_file()).collect();
        files.extend_from_slice(given);
        files.iter().map(|file| Self::read(file, &[])).collect()
    }

    /// Unfolds the oscillator, up to its limits; what was met, if one was. A file of the repository's examples is named as such, and linked
    /// by way of the link to the root.
    ///
    /// # Errors
    /// There is nothing to unfold, or a figure or table could not be made.
    pub(crate) fn entry(
        &self,
        root: Option<&Path>,
        link: Option<&str>,
    ) -> Result<(OscillatorEntry, Option<Failure>), Failure> {
        // Finished curves are not kept: the page is made quickly.
        let (unfolded, met) = unfold::analyse(self, self.description.limits(), &|_| ())?;
        let outcome = "what was not finished is named on the page";
        let met = met.map(|met| unfold::ended(&self.file, met, outcome));
        let mut entry = Material::new(self, &unfolded, SheetWidth::Paper)?.entry();
        if root.is_some_and(|root| self.file.parent() == Some(&root.join(project::EXAMPLES))) {
            entry.file = format!("{}/{}", project::EXAMPLES, entry.file);
            entry.link = link.map(|link| format!("{link}{}", entry.file));
        }
        Ok((entry, met))
    }
}

/// Makes identifiers differ from each other: files in different folders can have the same name.
pub(crate) fn distinguish<'a>(identifiers: impl IntoIterator<Item = &'a mut String>) {
    let mut taken = BTreeSet::new();
    for identifier in identifiers {
        let stem = identifier.clone();
        let mut number = 1;
        while !taken.insert(identifier.clone()) {
            number += 1;
            *identifier = format!("{stem}-{number}");
        }
    }
}

impl<'a> Material<'a> {
    /// Makes tables and figures.
    pub(crate) fn new(
        of: &'a OscillatorFile,
        unfolded: &'a Analysis,
        width: SheetWidth,
    ) -> Result<Self, Failure> {
        let rows = unfolded.rows();
        let figures = sheets::figures(&of.description, unfolded, &rows, width)
            .map_err(|error| computation("figures", &error))?;
        let names = &unfolded.axes.names;
        let (mut tables, mut plans) = (rows.tables(names), Rows::TABLES.to_vec());
        // Files that ask for no one-parameter diagram have no tables of them.
        if !unfolded.diagrams.is_empty() {
            tables.extend(OneParameterRows::of(&unfolded.diagrams).tables(names));
            plans.extend(OneParameterRows::TABLES);
        }
        Ok(Self { of, unfolded, figures, tables, plans })
    }

    /// The oscillator as a page shows it.
    pub(crate) fn entry(&self) -> OscillatorEntry {
        let OscillatorFile { file, text, description } = self.of;
        OscillatorEntry {
            id: file.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
            file: file_name(file),
            link: None,
            about: leading_comment(text),
            description: description.clone(),
            figures: self.figures(),
            tables: SHOWN.iter().filter_map(|name| self.table(name)).collect(),
            resonances: self.unfolded.entries(),
            lost: lost(description, self.unfolded),
            undecided: undecided(description, self.unfolded),
        }
    }

    /// Figures and tables as files.
    pub(crate) fn files(&self, edition: &Edition) -> Result<Vec<MadeFile>, Failure> {
        let mut files = Vec::new();
        for sheet in &self.figures {
            let made = edition.figure_files(&sheet.file, sheet.svg.clone());
            files.extend(made.map_err(|error| computation("figures", &error))?);
        }
        for table in &self.tables {
            files.push(tables::file(table, "tables")?);
        }
        Ok(files)
    }

    /// The figures and the coefficients for a document in LaTeX.
    ///
    /// # Errors
    /// A figure cannot be read.
    pub(crate) fn latex(&self) -> Result<Vec<MadeFile>, ExportError> {
        let (mut floats, mut files) = (Vec::new(), Vec::new());
        for sheet in &self.figures {
            let label = Float::label("fig", &self.of.file, sheet.name());
            floats.push(Float::figure(&sheet.file, &sheet.svg, &sheet.title, &label)?);
        }
        for table in self.tables.iter().filter(|table| table.name == SHOWN[0]) {
            let title = format!("Coefficients of {}", self.of.description.name());
            let made = Float::table(table, &title, &Float::label("tab", &self.of.file, table.name));
            made.into_iter().for_each(|(float, file)| {
                floats.push(float);
                files.push(file);
            });
        }
        files.push(latex::snippet(&floats));
        Ok(files)
    }

    /// The page about this oscillator alone, to stand in the folder of the files that were made of it.
    pub(crate) fn page(&self, made: &[MadeFile]) -> MadeFile {
        let outputs: Vec<OutputFile> =
            made.iter().map(|file| OutputFile::of(links::with_slashes(&file.path), &file.content)).collect();
        let entry = self.entry();
        let report = Report {
            manifest: Manifest {
                parameter_file: entry.file.clone(),
                parameters: self.of.text.clone(),
                outputs,
                ..versions::manifest()
            },
            oscillators: vec![entry],
            ..Report::default()
        };
        MadeFile { path: PathBuf::from(PAGE), content: grazing_report::page(&report).into_bytes() }
    }

    /// The figures, each with the tables that it shows.
    fn figures(&self) -> Vec<FigureEntry> {
        let figure = |sheet: &Sheet| {
            let tables = match sheet.kind {
                SheetKind::TwoParameters => ["points", "curves"].map(|name| self.table(name)).to_vec(),
                SheetKind::Magnifications => {
                    let panels = panels_of(&sheet.svg);
                    let shown = |table| with(table, columns::PANEL, |panel| panels.contains(&panel));
                    vec![self.table("magnifications").map(shown)]
                }
                SheetKind::OneParameter(number) => {
                    let shown = |table| with(table, columns::DIAGRAM, |diagram| diagram == number);
                    OneParameterRows::TABLES.iter().map(|plan| self.table(plan.name).map(shown)).collect()
                }
            };
            let name = sheet.name().to_owned();
            let tables = tables.into_iter().flatten().collect();
            FigureEntry { name, title: sheet.title.clone(), svg: sheet.svg.clone(), tables }
        };
        self.figures.iter().map(figure).collect()
    }

    /// The table of a name.
    fn table(&self, name: &str) -> Option<Table> {
        self.tables.iter().find(|table| table.name == name).cloned()
    }
}

/// The numbers of the panels on a sheet.
fn panels_of(svg: &str) -> BTreeSet<u32> {
    const MARK: &str = "data-only=\"panel ";
    let marks = svg.match_indices(MARK).filter_map(|(at, _)| svg[at + MARK.len()..].split('"').next());
    marks.filter_map(|panel| panel.parse().ok()).collect()
}

/// The table with those rows alone whose number in a column is right.
fn with(mut table: Table, column: Column, right: impl Fn(u32) -> bool) -> Table {
    if let Some(place) = table.position(column.name) {
        table.rows.retain(|row| matches!(row[place], Cell::Integer(number) if right(number)));
    }
    table
}

/// The paragraphs of the comment with which a file begins.
fn leading_comment(text: &str) -> Vec<String> {
    let comment = text.lines().map_while(|line| line.trim_start().strip_prefix('#')).map(str::trim);
    let mut paragraphs = vec![String::new()];
    for line in comment {
        match paragraphs.last_mut() {
            Some(last) if !line.is_empty() => {
                if !last.is_empty() {
                    last.push(' ');
                }
                last.push_str(line);
            }
            _ => paragraphs.push(String::new()),
        }
    }
    paragraphs.retain(|paragraph| !paragraph.is_empty());
    paragraphs
}

/// What could not be located, followed or finished, in words.
fn lost(description: &Description, unfolded: &Analysis) -> Vec<String> {
    let (diagram, units) = (&unfolded.diagram, &unfolded.axes.units);
    let lost = reason::lost(description, units, diagram).map(|(what, why)| format!("{what}: {why}"));
    let cut = diagram.unfinished.iter();
    let cut = cut.map(|cut| format!("not finished: {}", reason::unfinished(description, units, cut)));
    lost.chain(cut).collect()
}

/// Where it is not decided whether solutions are stable, with their loops.
fn undecided(description: &Description, unfolded: &Analysis) -> Vec<(u32, String)> {
    let (units, regions) = (&unfolded.axes.units, unfolded.diagram.regions.iter());
    regions
        .filter_map(|region| Some((region.loops, reason::undecided(description, units, region)?)))
        .collect()
}

#[cfg(test)]
mod tests {
    use grazing_results::{Column, Names};

    use super::*;

    #[test]
    fn the_leading_comment_is_put_together_by_paragraphs() {
        let text = "# A block on a spring\n#   beside a wall.\n#\n# Values are ours.\n\nname = \"o\" # not this\n# nor this\n";
        assert_eq!(leading_comment(text), ["A block on a spring beside a wall.", "Values are ours."]);
        assert_eq!(leading_comment("name = \"o\"\n# later\n"), [""; 0]);
    }

    #[test]
    fn a_sheet_gets_the_rows_of_its_own_panels() {
        const COLUMNS: &[Column] = &[columns::PANEL];
        let table = |panels: &[u32]| {
            let rows = panels.iter().map(|panel| vec![Cell::from(*panel)]).collect();
            Table::of_cells("magnifications", COLUMNS, &Names::of_the_paper(), rows)
        };
        let svg = "<rect data-only=\"panel 2\"/>\n<rect data-only=\"panel 10\"/>";
        let panels = panels_of(svg);
        let shown = with(table(&[1, 2, 2, 10]), columns::PANEL, |panel| panels.contains(&panel));
        assert_eq!(shown, table(&[2, 2, 10]));
    }

    #[test]
    fn files_of_the_same_name_have_addresses_of_their_own() {
        let mut identifiers = ["a", "b", "a", "a"].map(str::to_owned);
        distinguish(&mut identifiers);
        assert_eq!(identifiers, ["a", "b", "a-2", "a-3"]);
    }
}
