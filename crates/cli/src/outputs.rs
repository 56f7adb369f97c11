//! The registry of outputs: what can be made, and from what.

pub mod edition;
pub mod latex;

use std::error::Error;
use std::path::PathBuf;

use grazing_drawing::{
    SheetWidth, draw_fig01, draw_fig02, draw_fig03, draw_fig04, draw_fig05, draw_fig06, draw_fig07,
    draw_fig08, draw_fig09, draw_fig10,
};
use grazing_reproduction::parameters::{ParameterError, Parameters};
use grazing_reproduction::{CoefficientTable, Coefficients, Study, StudyError, TheoremsInAction};
use grazing_results::branches::Figure2;
use grazing_results::plane::{Figure7, Figure8};
use grazing_results::sketches::{Figure4, Figure5, Figure6, Figure10};
use grazing_results::space::Scene;
use grazing_results::{Names, Plan, Table};

use crate::failure::Failure;
use crate::folder::MadeFile;
use crate::tables;
use edition::{Edition, Format};
use latex::Float;

/// An output when it is made.
#[derive(Default)]
pub(crate) struct Made {
    /// The figure as SVG, if it is one.
    pub(crate) svg: Option<String>,
    /// The tables in the order of the registry.
    pub(crate) tables: Vec<Table>,
    /// What is shown otherwise than asked for, in sentences.
    pub(crate) notes: Vec<String>,
    /// Its figure or tables in LaTeX, in an edition that has it.
    pub(crate) floats: Vec<Float>,
    /// What it lacks, so that it is not what was asked for; in the end with the keys to change.
    pub(crate) gaps: Vec<String>,
}

type MadeResult = Result<Made, Box<dyn Error>>;

/// One output: a figure with its data, or a table.
pub struct Output {
    /// The name on the command line.
    pub name: &'static str,
    /// What it shows, in one line.
    pub title: &'static str,
    /// The label of the figure in the paper, or that of the table in LaTeX.
    pub label: &'static str,
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

/// All outputs: a first one, the figures of the paper, and a last one. A figure has the parameters of its name, the function of a study of that
/// name, and one that draws what it makes; then come its label, its tables, its title, the keys to change where it cannot be computed, and what is
/// to be told of it.
macro_rules! outputs {
    (first $first:ident; last $last:ident;
    $($name:ident = $draw:ident, $label:literal, $tables:expr, $title:literal, change $keys:literal $(, telling $told:ident)*;)+) => {
        &[$first, $(Output {
            name: stringify!($name),
            title: $title,
            label: $label,
            figure: Some(concat!(stringify!($name), ".svg")),
            tables: $tables,
            check: |parameters| parameters.$name.get().map(drop),
            keys: $keys,
            make: |study, width| {
                let made = study.$name()?;
                Ok(Made {
                    svg: Some($draw(&made, width)?),
                    tables: made.tables(&Names::of_the_paper()),
                    $($told: made.$told,)*
                    ..Made::default()
                })
            },
        },)+ $last]
    };
}

/// All outputs, in the order in which they are made.
pub const ALL: &[Output] = outputs! {
    first COEFFICIENTS;
    last THEOREMS;
    fig01 = draw_fig01, "fig:Bc", &Scene::FIG01,
        "Figure 1: phase space, impacting surface and reset law",
        change "fig01.orbits, fig01.amplitude or fig01.frequency";
    fig02 = draw_fig02, "fig:Z", Figure2::TABLES,
        "Figure 2: one-parameter bifurcation diagram with phase portraits",
        change "fig02.frequency, fig02.near or fig02.loops", telling notes;
    fig03 = draw_fig03, "fig:Ba", &Scene::FIG03,
        "Figure 3: the return map near a grazing periodic solution",
        change "fig03.start or fig03.frequency";
    fig04 = draw_fig04, "fig:D", Figure4::TABLES,
        "Figure 4: the boundaries g_p and h_p in the trapesium",
        change "fig04.loops";
    fig05 = draw_fig05, "fig:E", Figure5::TABLES,
        "Figure 5: unfolding of a resonant grazing bifurcation",
        change "fig05.loops or fig05.n";
    fig06 = draw_fig06, "fig:F", Figure6::TABLES,
        "Figure 6: the impact oscillator",
        change "fig06.frequency or fig06.amplitude";
    fig07 = draw_fig07, "fig:G", Figure7::TABLES,
        "Figure 7: two-parameter bifurcation diagram",
        change "fig07.frequency, fig07.amplitude or fig07.loops", telling gaps, telling notes;
    fig08 = draw_fig08, "fig:Y", Figure8::TABLES,
        "Figure 8: three magnifications of Figure 7 with quadratic approximations",
        change "fig08.panels, fig07.frequency or fig07.amplitude", telling notes;
    fig09 = draw_fig09, "fig:Bb", &Scene::FIG09,
        "Figure 9: points on the impacting surface and on the section",
        change "fig09.impact, fig09.amplitude or fig09.frequency";
    fig10 = draw_fig10, "fig:I", Figure10::TABLES,
        "Figure 10: the path of visits in the proof of Theorem 2.3",
        change "fig10.frequency or fig10.loops";
};

pub(crate) const COEFFICIENTS: Output = Output {
    name: "coefficients",
    title: "Coefficients at all resonances of Figure 7",
    label: "tab:coefficients",
    figure: None,
    tables: CoefficientTable::TABLES,
    check: |parameters| parameters.fig07.get().map(drop),
    keys: "fig07.frequency, fig07.amplitude or fig07.loops",
    make: |study, _| {
        let made = study.coefficients()?;
        Ok(Made {
            tables: made.tables(&Names::of_the_paper()),
            notes: made.rows.iter().flat_map(Coefficients::doubts).collect(),
            gaps: study.unlocated()?,
            ..Made::default()
        })
    },
};

const THEOREMS: Output = Output {
    name: "theorems",
    title: "Theorems 2.2 to 2.5 against continuation and simulation",
    label: "tab:theorems",
    figure: None,
    tables: TheoremsInAction::TABLES,
    check: |_| Ok(()),
    // It depends on no parameter.
    keys: "nothing",
    make: |study, _| {
        let tables = study.theorems_in_action()?.tables(&Names::of_the_paper());
        Ok(Made { tables, ..Made::default() })
    },
};

impl Output {
    /// The paths of its files in the output folder of an edition.
    pub fn paths(&self, edition: &Edition) -> Vec<PathBuf> {
        let figures = self.figure.iter().flat_map(|figure| edition.figure_paths(figure));
        let tables = self.tables.iter().map(|table| tables::path(table.name));
        figures.chain(tables).chain(self.latex_tables(edition).map(latex::table_path)).collect()
    }

    /// The tables that are printed, in an edition that has LaTeX: those of outputs without a figure, as far as they fit a page.
    pub(crate) fn latex_tables(&self, edition: &Edition) -> impl Iterator<Item = &'static str> {
        let printed = self.figure.is_none() && edition.has(Format::Tex);
        let tables = self.tables.iter().filter(|table| latex::is_printed(table.name, table.columns));
        tables.map(|table| table.name).filter(move |_| printed)
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
        let mut made = (self.make)(study, edition.columns).map_err(|error| self.failure(&*error))?;
        let names: Vec<&'static str> = made.tables.iter().map(|table| table.name).collect();
        let registered: Vec<&'static str> = self.tables.iter().map(|table| table.name).collect();
        if names != registered {
            let reason =
                format!("the tables {names:?} were made, the registry of outputs says {registered:?}");
            return Err(Failure::computation(self.name, reason));
        }
        let told = |error| computation(self.name, &error);
        let mut files = Vec::new();
        if let (Some(file), Some(svg)) = (self.figure, &made.svg) {
            files.extend(edition.figure_files(file, svg.clone()).map_err(told)?);
            if edition.has(Format::Tex) {
                let float = Float::figure(file, svg, self.title, self.label).map_err(told)?;
                made.floats.push(float.with(&latex::values(self.name, &study.parameters)));
            }
        }
        let printed: Vec<&str> = self.latex_tables(edition).collect();
        for table in &made.tables {
            files.push(tables::file(table, self.name)?);
        }
        for table in made.tables.iter().filter(|table| printed.contains(&table.name)) {
            if let Some((float, file)) = Float::table(table, self.title, self.label) {
                made.floats.push(float);
                files.push(file);
            }
        }
        made.gaps.iter_mut().for_each(|gap| gap.push_str(&format!("; change {}", self.keys)));
        Ok((made, files))
    }

    /// The failure to compute it, with the keys to change unless it names one itself.
    fn failure(&self, error: &(dyn Error + 'static)) -> Failure {
        let mut failure = computation(self.name, error);
        if !matches!(error.downcast_ref(), Some(StudyError::NoPortrait(_) | StudyError::Parameters(_))) {
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
