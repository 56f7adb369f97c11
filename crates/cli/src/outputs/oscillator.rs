//! The outputs that `unfold` writes about an oscillator.

use std::error::Error;
use std::path::{Path, PathBuf};

use grazing_description::Description;
use grazing_drawing::{
    DrawingError, Heading, SheetWidth, draw_diagram, draw_magnifications, draw_one_parameter,
};
use grazing_reproduction::unfolded::{AlongGrazing, AtResonances, Unfolded};
use grazing_results::branches::OneParameter;
use grazing_results::plane::{Magnifications, PlaneDiagram, StraightenedCurves};
use grazing_results::{Names, Tables, brief, columns};

use super::latex::Caption;
use super::{
    COEFFICIENT_COLUMNS, ComputedOutput, Figure, Output, STRAIGHTENED_FILE, sheet_file, straightened,
};
use crate::failure::Failure;

/// What the analysis of an oscillator from a text file comes to.
pub(crate) type Analysis = Unfolded;

/// An oscillator from a file, analysed.
pub(crate) struct AnalysedOscillator {
    file: PathBuf,
    description: Description,
    pub(crate) unfolded: Analysis,
    diagram: PlaneDiagram,
}

impl AnalysedOscillator {
    /// The analysis of the oscillator that the file describes.
    pub(crate) fn new(file: &Path, description: &Description, unfolded: Analysis) -> Self {
        let diagram = unfolded.plane_diagram();
        Self { file: file.to_owned(), description: description.clone(), unfolded, diagram }
    }

    /// What there is to write: files that ask for no one-parameter diagram have no tables of them.
    pub(crate) fn outputs(&self) -> &'static [Output<Self>] {
        let (_, without_diagrams) = ALL.split_last().unwrap_or((&ALL[0], &[]));
        if self.unfolded.diagrams.is_empty() { without_diagrams } else { ALL }
    }

    /// All that there is to write.
    ///
    /// # Errors
    /// Something cannot be drawn.
    pub(crate) fn computed(&self, width: SheetWidth) -> Result<ComputedOutput, Failure> {
        let outputs = self.outputs().iter().map(|output| output.compute(self, width));
        Ok(ComputedOutput::joined(outputs.collect::<Result<Vec<_>, _>>()?))
    }

    fn names(&self) -> &Names {
        &self.unfolded.axes.names
    }
}

/// The file of the magnifications, if all find room on one sheet.
const MAGNIFICATIONS: &str = "magnifications.svg";

/// All outputs: their tables in the order of the page that explains these, and one-parameter
/// diagrams last.
pub(crate) const ALL: &[Output<AnalysedOscillator>] = &[
    Output::new("grazing", "the grazing curve", AlongGrazing::TABLES, |_, of, _| {
        Ok(ComputedOutput::new(Vec::new(), of.unfolded.along_grazing().tables(of.names())))
    }),
    TWO_PARAMETERS,
    Output {
        printed: Some(COEFFICIENT_COLUMNS),
        ..Output::new("resonances", "resonances", AtResonances::TABLES, |_, of: &AnalysedOscillator, _| {
            let title = format!("Coefficients of {}", of.description.name());
            let label = Caption::label("tab", &of.file, COEFFICIENT_COLUMNS.0);
            Ok(ComputedOutput {
                tables: of.unfolded.at_resonances().tables(of.names()),
                printed: vec![(COEFFICIENT_COLUMNS, Caption { title, label, remark: String::new() })],
                ..ComputedOutput::default()
            })
        })
    },
    Output {
        is_figure: true,
        ..Output::new(
            "magnifications",
            "magnifications about the resonances",
            Magnifications::TABLES,
            magnifications,
        )
    },
    Output {
        is_figure: true,
        ..Output::new(
            STRAIGHTENED_FILE,
            "curves that leave resonances in straightened coordinates",
            StraightenedCurves::TABLES,
            |output, of: &AnalysedOscillator, width| {
                let (curves, name) = (of.unfolded.straightened(), of.description.name());
                Ok(straightened(&curves, name, of.names(), width, |file, sheet| {
                    Figure::new(&of.file, file, output.title.to_owned(), sheet, &output.table_names())
                })?)
            },
        )
    },
    Output::new("diagrams", "one-parameter bifurcation diagram", OneParameter::TABLES, one_parameter),
];

/// The two-parameter diagram.
pub(crate) const TWO_PARAMETERS: Output<AnalysedOscillator> = Output {
    is_figure: true,
    ..Output::new("diagram", "two-parameter bifurcation diagram", PlaneDiagram::TABLES, two_parameters)
};

type Computed = Result<ComputedOutput, Box<dyn Error>>;

fn two_parameters(
    output: &Output<AnalysedOscillator>,
    of: &AnalysedOscillator,
    width: SheetWidth,
) -> Computed {
    let file = output.figure_file();
    plane(&of.file, of.description.name(), of.names(), &of.diagram, (file, output.title), width)
}

/// The two-parameter diagram of what a file calls so, and its tables.
pub(crate) fn plane(
    of: &Path,
    name: &str,
    names: &Names,
    diagram: &PlaneDiagram,
    (file, shown): (String, &str),
    width: SheetWidth,
) -> Computed {
    let tables = ["points", "curves"];
    let title = format!("{name}: {shown}");
    let frames = if diagram.magnified.is_empty() { "" } else { "; rectangles: magnifications" };
    let description = format!(
        "{} across, {} up. Grazing curve of the non-impacting solution; saddle-node, period-doubling and grazing \
         bifurcations of maximal periodic solutions; regions of stability in grey. Triangles: resonances; discs: other \
         codimension-two points{frames}.",
        names.primary, names.secondary
    );
    let heading =
        Heading { name: "diagram", title: &title, description: &description, names, tables: &tables };
    let sheet = draw_diagram(diagram, &heading, width)?;
    let figure = Figure::new(of, file, shown.to_owned(), sheet, &tables);
    Ok(ComputedOutput::new(vec![figure], diagram.tables(names)))
}

fn magnifications(
    output: &Output<AnalysedOscillator>,
    of: &AnalysedOscillator,
    width: SheetWidth,
) -> Computed {
    let tables = ["magnifications"];
    let title = format!("{}: magnifications about resonant grazing bifurcations", of.description.name());
    let description = format!(
        "{} Dashed: the quadratic approximations to the saddle-node and period-doubling curves.",
        axes(&of.description)
    );
    let magnifications = of.unfolded.magnifications(&of.diagram);
    let (title, description) = (title.as_str(), description.as_str());
    let heading = Heading { name: "magnifications", title, description, names: of.names(), tables: &tables };
    let sheets = draw_magnifications(&magnifications, &heading, width)?;
    let count = sheets.len();
    let figures = sheets.into_iter().zip(1..).map(|(sheet, number)| {
        let title = match count {
            1 => output.title.to_owned(),
            _ => format!("{}, sheet {number} of {count}", output.title),
        };
        let panels = sheet.panels().filter_map(|panel| Some(panel.only?.1)).collect();
        let file = sheet_file(MAGNIFICATIONS, number, count);
        let figure = Figure::new(&of.file, file, title, sheet, &tables);
        Figure { only: Some((columns::PANEL, panels)), ..figure }
    });
    Ok(ComputedOutput::new(figures.collect(), magnifications.tables(of.names())))
}

fn one_parameter(
    output: &Output<AnalysedOscillator>,
    of: &AnalysedOscillator,
    width: SheetWidth,
) -> Computed {
    let figure = |diagram: &OneParameter| {
        let shown = format!("{}, {}", output.title, of_one_parameter(&of.description, diagram));
        let title = format!("{}: {shown}", of.description.name());
        let heading = Heading {
            name: "diagram",
            title: &title,
            description: "Below: the parameter across, x-value of the return map up; thick curves are stable, thin ones unstable; dots are \
                          long-term forward orbits. Above: phase portraits with the wall.",
            names: of.names(),
            tables: &["diagram_bifurcations", "diagram_branches", "diagram_attractor", "diagram_portraits"],
        };
        let sheet = draw_one_parameter(diagram, &heading, true, width)?;
        let file = one_parameter_file(diagram.diagram);
        let figure = Figure::new(&of.file, file, shown, sheet, &output.table_names());
        Ok(Figure { only: Some((columns::DIAGRAM, vec![diagram.diagram])), ..figure })
    };
    let diagrams = &of.unfolded.diagrams;
    let figures = diagrams.iter().map(figure).collect::<Result<_, DrawingError>>()?;
    Ok(ComputedOutput::new(figures, OneParameter::tables_of(diagrams, of.names())))
}

/// What stands on the axes of the plane, as a sentence.
fn axes(description: &Description) -> String {
    format!("{} across, {} up.", description.primary().name(), description.secondary().name())
}

/// What a one-parameter diagram is of, as `A from 0.26 to 0.34 at omega = 0.855`.
pub(crate) fn of_one_parameter(description: &Description, diagram: &OneParameter) -> String {
    let names = [description.primary().name(), description.secondary().name()];
    let [across, held] = diagram.exchanged(names);
    let [low, high] = diagram.frame.x.map(|end| brief(end, 6));
    format!("{across} from {low} to {high} at {held} = {}", brief(diagram.at, 6))
}

/// The file of a one-parameter diagram.
fn one_parameter_file(number: u32) -> String {
    format!("diagram-{number}.svg")
}
