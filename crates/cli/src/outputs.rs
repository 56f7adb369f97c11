//! The registry of outputs: what can be made, and from what.

pub mod edition;
mod figures;
pub mod latex;

use std::error::Error;
use std::path::{Path, PathBuf};

use grazing_drawing::SheetWidth;
use grazing_reproduction::{Study, Table};

use crate::failure::Failure;
use crate::folder::{DATA, MadeFile};
use crate::tables;
use edition::{Edition, Format};

/// An output when it is made: the figure as SVG, if it is one, and the tables in the order of the registry.
struct Made {
    figure: Option<String>,
    tables: Vec<Table>,
}

type MadeResult = Result<Made, Box<dyn Error>>;

/// One output: a figure with its data, or a table.
pub struct Output {
    /// The name on the command line.
    pub name: &'static str,
    /// What it shows, in one line.
    pub title: &'static str,
    /// The file of the figure.
    figure: Option<&'static str>,
    /// The names of the tables.
    tables: &'static [&'static str],
    make: fn(&Study<'_>, SheetWidth) -> MadeResult,
}

/// All outputs, in the order in which they are made.
pub const ALL: &[Output] = &[
    Output {
        name: "coefficients",
        title: "Coefficients at all resonances of Figure 7",
        figure: None,
        tables: &["coefficients"],
        make: |study, _| Ok(Made { figure: None, tables: vec![study.coefficient_table()?] }),
    },
    Output {
        name: "fig01",
        title: "Figure 1: phase space, impacting surface and reset law",
        figure: Some("fig01.svg"),
        tables: &["fig01_curves", "fig01_points", "fig01_surfaces"],
        make: figures::fig01,
    },
    Output {
        name: "fig02",
        title: "Figure 2: one-parameter bifurcation diagram with phase portraits",
        figure: Some("fig02.svg"),
        tables: &["fig02_branches", "fig02_bifurcations", "fig02_attractor", "fig02_portraits"],
        make: figures::fig02,
    },
    Output {
        name: "fig03",
        title: "Figure 3: the return map near a grazing periodic solution",
        figure: Some("fig03.svg"),
        tables: &["fig03_curves", "fig03_points", "fig03_surfaces"],
        make: figures::fig03,
    },
    Output {
        name: "fig04",
        title: "Figure 4: the boundaries g_p and h_p in the trapesium",
        figure: Some("fig04.svg"),
        tables: &["fig04_curves", "fig04_points"],
        make: figures::fig04,
    },
    Output {
        name: "fig05",
        title: "Figure 5: unfolding of a resonant grazing bifurcation",
        figure: Some("fig05.svg"),
        tables: &["fig05_curves", "fig05_points", "fig05_regions"],
        make: figures::fig05,
    },
    Output {
        name: "fig06",
        title: "Figure 6: the impact oscillator",
        figure: Some("fig06.svg"),
        tables: &["fig06_parts"],
        make: figures::fig06,
    },
    Output {
        name: "fig07",
        title: "Figure 7: two-parameter bifurcation diagram",
        figure: Some("fig07.svg"),
        tables: &["fig07_curves", "fig07_points", "fig07_regions"],
        make: figures::fig07,
    },
    Output {
        name: "fig08",
        title: "Figure 8: three magnifications of Figure 7 with quadratic approximations",
        figure: Some("fig08.svg"),
        tables: &["fig08_curves"],
        make: figures::fig08,
    },
    Output {
        name: "fig09",
        title: "Figure 9: points on the impacting surface and on the section",
        figure: Some("fig09.svg"),
        tables: &["fig09_curves", "fig09_points", "fig09_surfaces"],
        make: figures::fig09,
    },
    Output {
        name: "fig10",
        title: "Figure 10: the path of visits in the proof of Theorem 2.3",
        figure: Some("fig10.svg"),
        tables: &["fig10_path"],
        make: figures::fig10,
    },
    Output {
        name: "theorems",
        title: "Theorems 2.2 to 2.5 against continuation and simulation",
        figure: None,
        tables: &["theorems_generic", "theorems_resonant"],
        make: |study, _| Ok(Made { figure: None, tables: study.theorems_in_action()?.tables() }),
    },
];

impl Output {
    /// The paths of its files in the output folder.
    pub fn paths(&self) -> impl Iterator<Item = PathBuf> {
        self.paths_in(&Edition::default()).into_iter()
    }

    /// The paths of its files in the output folder of an edition.
    pub fn paths_in(&self, edition: &Edition) -> Vec<PathBuf> {
        let figures = self.figure.iter().flat_map(|figure| edition.figure_paths(figure));
        let tables = self.tables.iter().map(|table| table_path(table));
        figures.chain(tables).chain(self.latex_tables(edition).map(latex::table_path)).collect()
    }

    /// The file of the figure as SVG, if it is one.
    pub fn figure(&self) -> Option<&'static str> {
        self.figure
    }

    /// The names of its tables.
    pub fn tables(&self) -> &'static [&'static str] {
        self.tables
    }

    /// The tables that are printed, in an edition that has LaTeX: those of outputs without a figure.
    pub(crate) fn latex_tables(&self, edition: &Edition) -> impl Iterator<Item = &'static str> {
        let printed = self.figure.is_none() && edition.has(Format::Tex);
        self.tables.iter().copied().filter(move |_| printed)
    }

    /// Computes the output.
    ///
    /// # Errors
    /// [`Failure::Computation`]; [`Failure::Registry`] if other tables were made than announced.
    pub(crate) fn files(&self, study: &Study<'_>, edition: &Edition) -> Result<Vec<MadeFile>, Failure> {
        let made = (self.make)(study, edition.width()).map_err(|error| computation(self.name, &*error))?;
        let names: Vec<&'static str> = made.tables.iter().map(|table| table.name).collect();
        if names != self.tables {
            return Err(Failure::Registry { output: self.name, made: names, registered: self.tables });
        }
        let mut files = Vec::new();
        if let (Some(file), Some(svg)) = (self.figure, made.figure) {
            files.extend(edition.figure_files(file, svg).map_err(|error| computation(self.name, &error))?);
        }
        let printed: Vec<&str> = self.latex_tables(edition).collect();
        for table in &made.tables {
            let content = tables::csv(&table.frame).map_err(|error| computation(self.name, &error))?;
            files.push(MadeFile { path: table_path(table.name), content });
        }
        for table in made.tables.iter().filter(|table| printed.contains(&table.name)) {
            let content = latex::table(table, self.title).map_err(|error| computation(self.name, &error))?;
            files.push(MadeFile { path: latex::table_path(table.name), content: content.into_bytes() });
        }
        Ok(files)
    }
}

/// The failure of a computation, with the error and all that it came from and does not tell itself.
pub(crate) fn computation(what: &'static str, error: &dyn Error) -> Failure {
    let mut reason = error.to_string();
    let mut cause = error.source();
    while let Some(deeper) = cause {
        let told = deeper.to_string();
        if !reason.contains(&told) {
            reason.push_str(&format!(": {told}"));
        }
        cause = deeper.source();
    }
    Failure::Computation { what, reason }
}

/// Where a table lies in the output folder.
pub(crate) fn table_path(name: &str) -> PathBuf {
    Path::new(DATA).join(format!("{name}.csv"))
}
