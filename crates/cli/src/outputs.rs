//! The registry of outputs: what can be made, and from what.

pub mod edition;
mod figures;
pub mod latex;

use std::error::Error;
use std::path::{Path, PathBuf};

use grazing_drawing::SheetWidth;
use grazing_reproduction::parameters::{ParameterError, Parameters};
use grazing_reproduction::{
    CoefficientTable, Figure2, Figure4, Figure5, Figure6, Figure7, Figure8, Figure10, Scene, Study,
    StudyError, TheoremsInAction,
};
use grazing_results::{Names, Plan, Table};

use crate::failure::Failure;
use crate::folder::{DATA, MadeFile};
use crate::tables;
use edition::{Edition, Format};

/// An output when it is made.
pub(crate) struct Made {
    /// The figure as SVG, if it is one.
    pub(crate) svg: Option<String>,
    /// The tables in the order of the registry.
    pub(crate) tables: Vec<Table>,
    /// What is shown otherwise than asked for, in sentences.
    pub(crate) notes: Vec<String>,
    /// What it lacks, so that it is not what was asked for; in the end with the keys to change.
    pub(crate) gaps: Vec<String>,
}

impl Made {
    fn figure(svg: String, tables: Vec<Table>) -> Made {
        Made { svg: Some(svg), ..Made::tables(tables) }
    }

    fn tables(tables: Vec<Table>) -> Made {
        Made { svg: None, tables, notes: Vec::new(), gaps: Vec::new() }
    }
}

type MadeResult = Result<Made, Box<dyn Error>>;

/// One output: a figure with its data, or a table.
pub struct Output {
    /// The name on the command line.
    pub name: &'static str,
    /// What it shows, in one line.
    pub title: &'static str,
    /// The file of the figure as SVG, if it is one.
    pub figure: Option<&'static str>,
    /// Its tables.
    pub tables: &'static [Plan],
    /// Whether the sections of the parameter file that it cannot do without are right.
    check: fn(&Parameters) -> Result<(), ParameterError>,
    /// The keys to change where it cannot be computed.
    keys: &'static str,
    make: fn(&Study<'_>, SheetWidth) -> MadeResult,
}

/// All outputs, in the order in which they are made.
pub const ALL: &[Output] = &[
    Output {
        name: "coefficients",
        title: "Coefficients at all resonances of Figure 7",
        figure: None,
        tables: CoefficientTable::TABLES,
        check: |parameters| parameters.fig07.get().map(drop),
        keys: "fig07.frequency, fig07.amplitude or fig07.loops",
        make: figures::coefficients,
    },
    Output {
        name: "fig01",
        title: "Figure 1: phase space, impacting surface and reset law",
        figure: Some("fig01.svg"),
        tables: &Scene::FIG01,
        check: |parameters| parameters.fig01.get().map(drop),
        keys: "fig01.orbits, fig01.amplitude or fig01.frequency",
        make: figures::fig01,
    },
    Output {
        name: "fig02",
        title: "Figure 2: one-parameter bifurcation diagram with phase portraits",
        figure: Some("fig02.svg"),
        tables: Figure2::TABLES,
        check: |parameters| parameters.fig02.get().map(drop),
        keys: "fig02.frequency, fig02.near or fig02.loops",
        make: figures::fig02,
    },
    Output {
        name: "fig03",
        title: "Figure 3: the return map near a grazing periodic solution",
        figure: Some("fig03.svg"),
        tables: &Scene::FIG03,
        check: |parameters| parameters.fig03.get().map(drop),
        keys: "fig03.start or fig03.frequency",
        make: figures::fig03,
    },
    Output {
        name: "fig04",
        title: "Figure 4: the boundaries g_p and h_p in the trapesium",
        figure: Some("fig04.svg"),
        tables: Figure4::TABLES,
        check: |parameters| parameters.fig04.get().map(drop),
        keys: "fig04.loops",
        make: figures::fig04,
    },
    Output {
        name: "fig05",
        title: "Figure 5: unfolding of a resonant grazing bifurcation",
        figure: Some("fig05.svg"),
        tables: Figure5::TABLES,
        check: |parameters| parameters.fig05.get().map(drop),
        keys: "fig05.loops or fig05.n",
        make: figures::fig05,
    },
    Output {
        name: "fig06",
        title: "Figure 6: the impact oscillator",
        figure: Some("fig06.svg"),
        tables: Figure6::TABLES,
        check: |parameters| parameters.fig06.get().map(drop),
        keys: "fig06.frequency or fig06.amplitude",
        make: figures::fig06,
    },
    Output {
        name: "fig07",
        title: "Figure 7: two-parameter bifurcation diagram",
        figure: Some("fig07.svg"),
        tables: Figure7::TABLES,
        check: |parameters| parameters.fig07.get().map(drop),
        keys: "fig07.frequency, fig07.amplitude or fig07.loops",
        make: figures::fig07,
    },
    Output {
        name: "fig08",
        title: "Figure 8: three magnifications of Figure 7 with quadratic approximations",
        figure: Some("fig08.svg"),
        tables: Figure8::TABLES,
        check: |parameters| parameters.fig08.get().map(drop),
        keys: "fig08.panels, fig07.frequency or fig07.amplitude",
        make: figures::fig08,
    },
    Output {
        name: "fig09",
        title: "Figure 9: points on the impacting surface and on the section",
        figure: Some("fig09.svg"),
        tables: &Scene::FIG09,
        check: |parameters| parameters.fig09.get().map(drop),
        keys: "fig09.impact, fig09.amplitude or fig09.frequency",
        make: figures::fig09,
    },
    Output {
        name: "fig10",
        title: "Figure 10: the path of visits in the proof of Theorem 2.3",
        figure: Some("fig10.svg"),
        tables: Figure10::TABLES,
        check: |parameters| parameters.fig10.get().map(drop),
        keys: "fig10.frequency or fig10.loops",
        make: figures::fig10,
    },
    Output {
        name: "theorems",
        title: "Theorems 2.2 to 2.5 against continuation and simulation",
        figure: None,
        tables: TheoremsInAction::TABLES,
        check: |_| Ok(()),
        // It depends on no parameter.
        keys: "nothing",
        make: |study, _| Ok(Made::tables(study.theorems_in_action()?.tables(&Names::of_the_paper()))),
    },
];

impl Output {
    /// The paths of its files in the output folder of an edition.
    pub fn paths(&self, edition: &Edition) -> Vec<PathBuf> {
        let figures = self.figure.iter().flat_map(|figure| edition.figure_paths(figure));
        let tables = self.tables.iter().map(|table| table_path(table.name));
        figures.chain(tables).chain(self.latex_tables(edition).map(latex::table_path)).collect()
    }

    /// The tables that are printed, in an edition that has LaTeX: those of outputs without a figure.
    pub(crate) fn latex_tables(&self, edition: &Edition) -> impl Iterator<Item = &'static str> {
        let printed = self.figure.is_none() && edition.has(Format::Tex);
        self.tables.iter().map(|table| table.name).filter(move |_| printed)
    }

    /// Computes the output, and makes its files.
    ///
    /// # Errors
    /// A section of the parameter file is not right, the computation failed, or other tables were made than announced.
    pub(crate) fn files(
        &self,
        study: &Study<'_>,
        edition: &Edition,
    ) -> Result<(Made, Vec<MadeFile>), Failure> {
        (self.check)(&study.parameters)?;
        let mut made = (self.make)(study, edition.width()).map_err(|error| self.failure(&*error))?;
        let names: Vec<&'static str> = made.tables.iter().map(|table| table.name).collect();
        let registered: Vec<&'static str> = self.tables.iter().map(|table| table.name).collect();
        if names != registered {
            let reason =
                format!("the tables {names:?} were made, the registry of outputs says {registered:?}");
            return Err(Failure::computation(self.name, reason));
        }
        let mut files = Vec::new();
        if let (Some(file), Some(svg)) = (self.figure, &made.svg) {
            files.extend(
                edition.figure_files(file, svg.clone()).map_err(|error| computation(self.name, &error))?,
            );
        }
        let printed: Vec<&str> = self.latex_tables(edition).collect();
        for table in &made.tables {
            let content = tables::csv(table).map_err(|error| computation(self.name, &error))?;
            files.push(MadeFile { path: table_path(table.name), content });
        }
        for table in made.tables.iter().filter(|table| printed.contains(&table.name)) {
            let content = latex::table(table, self.title).into_bytes();
            files.push(MadeFile { path: latex::table_path(table.name), content });
        }
        made.gaps.iter_mut().for_each(|gap| gap.push_str(&format!("; change {}", self.keys)));
        Ok((made, files))
    }

    /// The failure to compute it, with the keys to change unless it names one itself.
    fn failure(&self, error: &(dyn Error + 'static)) -> Failure {
        let mut failure = computation(self.name, error);
        if !matches!(error.downcast_ref(), Some(StudyError::NoPortrait { .. } | StudyError::Parameters(_))) {
            failure.reason.push_str(&format!("; change {}", self.keys));
        }
        failure
    }
}

/// Refuses parameters that would be wrong for any oscillator: that is a slip, better mended than worked around.
///
/// # Errors
/// The first that some output needs.
pub(crate) fn refuse_malformed<'a>(
    outputs: impl Iterator<Item = &'a Output>,
    parameters: &Parameters,
) -> Result<(), Failure> {
    let mut refused = outputs.filter_map(|output| (output.check)(parameters).err());
    match refused.find(|error| matches!(error, ParameterError::Malformed(_))) {
        Some(error) => Err(error.into()),
        None => Ok(()),
    }
}

/// The failure of a computation, with the error and all that it came from and does not tell itself; that of a section of the
/// parameter file if it is one.
pub(crate) fn computation(what: &'static str, error: &(dyn Error + 'static)) -> Failure {
    if let Some(StudyError::Parameters(error)) = error.downcast_ref() {
        return error.clone().into();
    }
    let mut reason = error.to_string();
    let mut cause = error.source();
    while let Some(deeper) = cause {
        let told = deeper.to_string();
        if !reason.contains(&told) {
            reason.push_str(&format!(": {told}"));
        }
        cause = deeper.source();
    }
    Failure::computation(what, reason)
}

/// Where a table lies in the output folder.
pub(crate) fn table_path(name: &str) -> PathBuf {
    Path::new(DATA).join(format!("{name}.csv"))
}
