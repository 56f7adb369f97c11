//! The outputs that `reproduce` writes: the figures and tables of the paper.

use grazing_drawing::{
    DrawingError, Heading, Sheet, SheetWidth, draw_diagram, draw_fig01, draw_fig02, draw_fig03, draw_fig04,
    draw_fig05, draw_fig06, draw_fig09, draw_fig10, draw_magnifications,
};
use grazing_reproduction::parameters::ParameterError;
use grazing_reproduction::{CoefficientTable, Coefficients, Study, TheoremsInAction};
use grazing_results::branches::OneParameter;
use grazing_results::plane::{Magnifications, PlaneDiagram};
use grazing_results::sketches::{Figure4, Figure5, Figure6, Figure10};
use grazing_results::space::Scene;
use grazing_results::{Names, TablePlan};

use super::latex::Caption;
use super::{COEFFICIENT_COLUMNS, ComputedOutput, Figure, Output};
use crate::failure::Failure;

/// All outputs: a first one, the figures of the paper, and a last one. A figure has the parameters
/// of its name, the function of a study of that name, and one that draws what it computes; then
/// come its label, its tables, its title, the keys to change where it cannot be computed, and what
/// else to report: a field of what is computed, or what a function of the study returns.
macro_rules! outputs {
    (first $first:ident; last $last:ident;
    $($name:ident = $draw:ident, $label:literal, $tables:expr, $title:literal, change $keys:literal
        $(report $field:ident)* $(, $reported:ident by $function:ident)*;)+) => {
        &[$first, $(Output {
            label: $label,
            figure: Some(concat!(stringify!($name), ".svg")),
            check: |study| study.parameters.$name.get().map(drop),
            keys: $keys,
            ..Output::new(stringify!($name), $title, $tables, |output, study: &Study, width| {
                let shown = study.$name()?;
                let figure = Figure {
                    file: concat!(stringify!($name), ".svg").to_owned(),
                    sheet: $draw(&shown, width)?,
                    caption: output.caption(study),
                    tables: output.table_names(),
                    only: None,
                };
                Ok(ComputedOutput {
                    figures: vec![figure],
                    tables: shown.tables_as(output.tables, &Names::of_the_paper()),
                    $($field: shown.$field,)*
                    $($reported: study.$function()?,)*
                    ..ComputedOutput::default()
                })
            })
        },)+ $last]
    };
}

/// All outputs, in the order in which they are computed.
pub const ALL: &[Output<Study>] = outputs! {
    first COEFFICIENTS;
    last THEOREMS;
    fig01 = draw_fig01, "fig:Bc", &TablePlan::renamed(Scene::TABLES, ["fig01_curves", "fig01_points", "fig01_surfaces"]),
        "Figure 1: phase space, impacting surface and reset law",
        change "fig01.orbits, fig01.amplitude or fig01.frequency";
    fig02 = draw_fig02, "fig:Z",
        &TablePlan::renamed(OneParameter::TABLES, ["fig02_branches", "fig02_bifurcations", "fig02_attractor", "fig02_portraits"]),
        "Figure 2: one-parameter bifurcation diagram with phase portraits",
        change "fig02.frequency, fig02.near or fig02.loops" report notes;
    fig03 = draw_fig03, "fig:Ba", &TablePlan::renamed(Scene::TABLES, ["fig03_curves", "fig03_points", "fig03_surfaces"]),
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
    fig07 = draw_fig07, "fig:G", &TablePlan::renamed(PlaneDiagram::TABLES, ["fig07_curves", "fig07_points", "fig07_regions"]),
        "Figure 7: two-parameter bifurcation diagram",
        change "fig07.frequency, fig07.amplitude or fig07.loops", gaps by fig07_gaps, notes by undecided;
    fig08 = draw_fig08, "fig:Y", &TablePlan::renamed(Magnifications::TABLES, ["fig08_curves"]),
        "Figure 8: three magnifications of Figure 7 with quadratic approximations",
        change "fig08.panels, fig07.frequency or fig07.amplitude", notes by fig08_notes;
    fig09 = draw_fig09, "fig:Bb", &TablePlan::renamed(Scene::TABLES, ["fig09_curves", "fig09_points", "fig09_surfaces"]),
        "Figure 9: points on the impacting surface and on the section",
        change "fig09.impact, fig09.amplitude or fig09.frequency";
    fig10 = draw_fig10, "fig:I", Figure10::TABLES,
        "Figure 10: the path of visits in the proof of Theorem 2.3",
        change "fig10.frequency or fig10.loops";
};

pub(crate) const COEFFICIENTS: Output<Study> = Output {
    label: "tab:coefficients",
    printed: Some(COEFFICIENT_COLUMNS),
    check: |study| study.parameters.fig07.get().map(drop),
    keys: "fig07.frequency, fig07.amplitude or fig07.loops",
    ..Output::new(
        "coefficients",
        "Coefficients at all resonances of Figure 7",
        CoefficientTable::TABLES,
        |output, study: &Study, _| {
            let table = study.coefficients()?;
            Ok(ComputedOutput {
                tables: table.tables(&Names::of_the_paper()),
                notes: table.rows.iter().flat_map(Coefficients::doubts).collect(),
                gaps: study.unlocated()?,
                printed: vec![(COEFFICIENT_COLUMNS, output.caption(study))],
                ..ComputedOutput::default()
            })
        },
    )
};

/// It depends on no parameter.
const THEOREMS: Output<Study> = Output {
    label: "tab:theorems",
    ..Output::new(
        "theorems",
        "Theorems 2.2 to 2.5 against continuation and simulation",
        TheoremsInAction::TABLES,
        |_, study: &Study, _| {
            let tables = study.theorems_in_action()?.tables(&Names::of_the_paper());
            Ok(ComputedOutput::new(Vec::new(), tables))
        },
    )
};

/// Figure 7. Paper: fig:G.
fn draw_fig07(diagram: &PlaneDiagram, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let heading = Heading {
        name: "fig07",
        title: "Two-parameter bifurcation diagram",
        description: "Forcing amplitude across, forcing frequency up. Grazing curve of the non-impacting solution; \
             saddle-node, period-doubling and grazing bifurcations of maximal periodic solutions; regions of stability \
             in grey. Triangles: resonances; discs: other codimension-two points. Rectangles: the panels of Figure 8; thick \
             line: where Figure 2 runs.",
        names: &Names::of_the_paper(),
        tables: &["fig07_points", "fig07_curves"],
    };
    draw_diagram(diagram, &heading, width)
}

/// Figure 8. Paper: fig:Y.
fn draw_fig08(magnifications: &Magnifications, width: SheetWidth) -> Result<Sheet, DrawingError> {
    let heading = Heading {
        name: "fig08",
        title: "Magnifications about three resonant grazing bifurcations",
        description: "Forcing amplitude across, forcing frequency up. Dashed: the quadratic approximations to the \
             saddle-node and period-doubling curves.",
        names: &Names::of_the_paper(),
        tables: &["fig08_curves"],
    };
    // As many panels as there can be stand on one sheet.
    let found = magnifications.panels.len();
    let sheet = draw_magnifications(magnifications, &heading, width)?.pop().filter(|_| found <= 3);
    sheet.ok_or_else(|| DrawingError(format!("fig08 has one to three panels, but {found} were given")))
}

impl Output<Study> {
    /// Its caption in a document; of diagrams with the values of the paper's oscillator.
    fn caption(&self, study: &Study) -> Caption {
        let remark = self.values(study).unwrap_or_default();
        Caption { title: self.title.to_owned(), label: self.label.to_owned(), remark }
    }

    /// The values with which a diagram is computed, as a sentence after others; none for sketches
    /// and tables.
    fn values(&self, study: &Study) -> Option<String> {
        let oscillator = study.parameters.oscillator.get().ok()?;
        let mut values = vec![
            (r"\zeta", oscillator.damping_ratio()),
            (r"\epsilon", oscillator.coefficient_of_restitution()),
        ];
        match self.name {
            "fig07" | "fig08" => {}
            "fig02" => values.extend(study.parameters.fig02_frequency.get().map(|omega| (r"\omega", *omega))),
            _ => return None,
        }
        let values: Vec<String> = values.iter().map(|(name, value)| format!("${name} = {value}$")).collect();
        Some(format!(" Here {}.", values.join(", ")))
    }
}

/// Refuses parameters that would be wrong for any oscillator: that is a slip, better mended than
/// worked around.
///
/// # Errors
/// The first that some output needs.
pub(crate) fn refuse_malformed<'a>(
    outputs: impl Iterator<Item = &'a Output<Study>>,
    study: &Study,
) -> Result<(), Failure> {
    let mut refused = outputs.filter_map(|output| (output.check)(study).err());
    match refused.find(|error| matches!(error, ParameterError::Malformed(_))) {
        Some(error) => Err(error.into()),
        None => Ok(()),
    }
}
