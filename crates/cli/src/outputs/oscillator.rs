//! The outputs that `unfold` writes about an oscillator.

use std::error::Error;
use std::path::Path;

use grazing_drawing::{
    DrawingError, Heading, Look, Sheet, SheetWidth, draw_diagram, draw_magnifications, draw_one_parameter,
    draw_place, draw_straightened,
};
use grazing_input::{FigureStyle, LabelKind};
use grazing_results::Title;
use grazing_results::branches::{OneParameter, Orbits, Readings};
use grazing_results::grazing::AlongGrazing;
use grazing_results::measured::Comparison;
use grazing_results::place::AtPlace;
use grazing_results::plane::{Magnifications, OwnCurves, PlaneDiagram, SequenceDiagram, StraightenedCurves};
use grazing_results::readings::{Ordinate, Sweep};
use grazing_results::resonance::AtResonances;
use grazing_results::{Names, Stability, Tables, brief, columns};
use grazing_unfold::unfolded::Unfolded;

use super::latex::Caption;
use super::{COEFFICIENT_COLUMNS, ComputedOutput, DrawnFigure, Output, sheet_file};
use crate::failure::Failure;
use crate::oscillator::OscillatorFile;

/// An oscillator from a file, analysed.
pub(crate) struct AnalysedOscillator {
    pub(crate) oscillator: OscillatorFile,
    pub(crate) unfolded: Unfolded,
    diagram: PlaneDiagram,
    /// The comparison with measurements.
    pub(crate) compared: Option<Comparison>,
    /// Motion at the places that were asked for.
    pub(crate) places: Vec<AtPlace>,
}

impl AnalysedOscillator {
    /// The analysis of the oscillator that the file describes.
    pub(crate) fn new(oscillator: OscillatorFile, unfolded: Unfolded) -> Self {
        let diagram = unfolded.plane_diagram();
        Self { oscillator, unfolded, diagram, compared: None, places: Vec::new() }
    }

    /// Adds the comparison with measurements.
    pub(crate) fn measured(mut self, compared: Option<Comparison>) -> Self {
        self.diagram.measured = compared.iter().flat_map(|compared| compared.points.clone()).collect();
        self.compared = compared;
        self
    }

    /// Adds motion at places.
    pub(crate) fn at(self, places: Vec<AtPlace>) -> Self {
        Self { places, ..self }
    }

    /// The outputs to write: without one-parameter diagrams, own curves, measurements or places
    /// there are no tables of these.
    pub(crate) fn outputs(&self) -> impl Iterator<Item = &'static Output<Self>> {
        let missing = [
            self.unfolded.diagrams.is_empty().then_some(DIAGRAMS),
            self.unfolded.diagrams.iter().all(|diagram| diagram.readings.is_empty()).then_some(READINGS),
            self.unfolded.diagram.requested.is_empty().then_some(OWN),
            self.unfolded.sequences.solutions.is_empty().then_some(SEVERAL),
            self.compared.is_none().then_some(MEASURED),
            self.places.is_empty().then_some(PLACES.name),
        ];
        ALL.iter().filter(move |output| !missing.contains(&Some(output.name)))
    }

    /// All outputs, computed and joined.
    ///
    /// # Errors
    /// A figure cannot be drawn.
    pub(crate) fn computed(&self, width: SheetWidth) -> Result<ComputedOutput, Failure> {
        let outputs = self.outputs().map(|output| output.compute(self, width));
        Ok(ComputedOutput::joined(outputs.collect::<Result<Vec<_>, _>>()?))
    }

    fn named(&self, width: SheetWidth) -> NamedOscillator<'_> {
        NamedOscillator {
            of: &self.oscillator.file,
            name: self.oscillator.description.name(),
            names: self.names(),
            width,
        }
    }

    fn names(&self) -> &Names {
        &self.unfolded.axes.names
    }
}

/// The names of outputs that not every file has.
const OWN: &str = "own-curves";
const SEVERAL: &str = "several-impacts";
const DIAGRAMS: &str = "diagrams";
const STRAIGHTENED: &str = "straightened";
const READINGS: &str = "readings";

/// All outputs: tables in the order of the page that explains them, and one-parameter diagrams last.
pub(crate) const ALL: &[Output<AnalysedOscillator>] = &[
    Output::new("grazing", Title::plain("the grazing curve"), AlongGrazing::TABLES, |_, of, _| {
        Ok(ComputedOutput::new(Vec::new(), of.unfolded.along_grazing().tables(of.names())))
    }),
    TWO_PARAMETERS,
    Output::new(OWN, Title::plain("own curves"), OwnCurves::TABLES, |_, of, _| {
        let own = OwnCurves { own: of.diagram.own.clone() };
        Ok(ComputedOutput::new(Vec::new(), own.tables(of.names())))
    }),
    Output::new(
        SEVERAL,
        Title::plain("solutions with several impacts"),
        SequenceDiagram::TABLES,
        |_, of, _| Ok(ComputedOutput::new(Vec::new(), of.unfolded.sequences().tables(of.names()))),
    ),
    Output {
        printed: Some(COEFFICIENT_COLUMNS),
        ..Output::new(
            "resonances",
            Title::plain("resonances"),
            AtResonances::TABLES,
            |_, of: &AnalysedOscillator, _| {
                let title = format!("Coefficients of {}", of.oscillator.description.name().replace('$', ""));
                let label = Caption::label("tab", &of.oscillator.file, COEFFICIENT_COLUMNS.0);
                Ok(ComputedOutput {
                    tables: of.unfolded.at_resonances().tables(of.names()),
                    printed: vec![(
                        COEFFICIENT_COLUMNS,
                        Caption { title: title.into(), label, remark: String::new() },
                    )],
                    ..ComputedOutput::default()
                })
            },
        )
    },
    Output {
        is_figure: true,
        ..Output::new(
            "magnifications",
            Title::plain("magnifications about the resonances"),
            Magnifications::TABLES,
            |output, of: &AnalysedOscillator, width| of.named(width).magnifications(output, of),
        )
    },
    STRAIGHTENED_CURVES,
    Output::new(
        READINGS,
        Title::plain("readings of one-parameter diagrams"),
        Readings::TABLES,
        |_, of, _| {
            let readings =
                |of: &OneParameter| Readings { readings: of.readings.clone(), motion: of.motion.clone() };
            let all = of.unfolded.diagrams.iter().map(readings);
            let all = all.reduce(|mut all, mut one| {
                all.readings.append(&mut one.readings);
                all.motion.append(&mut one.motion);
                all
            });
            Ok(ComputedOutput::new(Vec::new(), all.map_or(Vec::new(), |all| all.tables(of.names()))))
        },
    ),
    ONE_PARAMETER,
    Output::new(
        MEASURED,
        Title::plain("measurements compared with the diagram"),
        Comparison::TABLES,
        |_, of, _| {
            let tables = of.compared.as_ref().map(|compared| compared.tables(of.names()));
            Ok(ComputedOutput::new(Vec::new(), tables.unwrap_or_default()))
        },
    ),
    PLACES,
];

const MEASURED: &str = "measured";

/// Motion at the places that were asked for.
pub(crate) const PLACES: Output<AnalysedOscillator> =
    Output::new("places", Title::plain("motion at a place"), AtPlace::TABLES, |_, of, width| {
        of.named(width).places(&of.places)
    });

/// The two-parameter diagram.
pub(crate) const TWO_PARAMETERS: Output<AnalysedOscillator> = Output {
    is_figure: true,
    ..Output::new(
        "diagram",
        Title::plain("two-parameter bifurcation diagram"),
        PlaneDiagram::TABLES,
        |_, of: &AnalysedOscillator, width| {
            of.named(width).plane(&of.diagram, of.oscillator.description.figure().clone())
        },
    )
};

/// One-parameter diagrams.
pub(crate) const ONE_PARAMETER: Output<AnalysedOscillator> = Output::new(
    DIAGRAMS,
    Title::plain("one-parameter bifurcation diagram"),
    OneParameter::TABLES,
    |_, of, width| {
        let (named, diagrams) = (of.named(width), &of.unfolded.diagrams);
        let figures =
            diagrams.iter().map(|diagram| named.one_parameter(diagram)).collect::<Result<_, _>>()?;
        Ok(ComputedOutput::new(figures, OneParameter::tables_of(diagrams, of.names())))
    },
);

/// Curves in straightened coordinates.
pub(crate) const STRAIGHTENED_CURVES: Output<AnalysedOscillator> = Output {
    is_figure: true,
    ..Output::new(
        STRAIGHTENED,
        Title::plain("curves that leave resonances in straightened coordinates"),
        StraightenedCurves::TABLES,
        |_, of: &AnalysedOscillator, width| of.named(width).straightened(&of.unfolded.straightened()),
    )
};

pub(crate) type Computed = Result<ComputedOutput, Box<dyn Error>>;

/// An oscillator by its file, its name and the names of its parameters, drawn at a width.
pub(crate) struct NamedOscillator<'a> {
    pub(crate) of: &'a Path,
    pub(crate) name: &'a str,
    pub(crate) names: &'a Names,
    pub(crate) width: SheetWidth,
}

impl NamedOscillator<'_> {
    fn heading<'h>(
        &'h self,
        name: &'static str,
        title: &'h str,
        description: &'h str,
        tables: &'h [&'static str],
    ) -> Heading<'h> {
        Heading { name, title, description, names: self.names, tables }
    }

    /// Figures and tables of motion at places of the parameter plane.
    pub(crate) fn places(&self, places: &[AtPlace]) -> Computed {
        let figure = |place: &AtPlace| {
            let [primary, secondary] = self.names.shown();
            let [mu, eta] = place.at.map(|value| brief(value, 6));
            let shown = format!("motion at {primary} = {mu}, {secondary} = {eta}");
            let title = format!("{}: {shown}", self.name);
            let description = "Above: time series. Below: phase portrait, impacts by phase and velocity, and the basins of \
                               attraction of motion that starts at rest.";
            let tables = ["place_motion", "place_impacts", "place_basins"];
            let sheet =
                draw_place(place, &self.heading(PLACES.name, &title, description, &tables), self.width)?;
            let file = format!("place-{}.svg", place.place);
            let figure = DrawnFigure::new(self.of, file, shown, sheet, &PLACES.table_names());
            Ok(DrawnFigure { only: Some((columns::PLACE, vec![place.place])), ..figure })
        };
        let figures = places.iter().map(figure).collect::<Result<_, DrawingError>>()?;
        Ok(ComputedOutput::new(figures, AtPlace::tables_of(places, self.names)))
    }

    /// The two-parameter diagram and its tables.
    pub(crate) fn plane(&self, diagram: &PlaneDiagram, style: FigureStyle) -> Computed {
        let (shown, tables) = (TWO_PARAMETERS.title.owned(), ["points", "curves"]);
        let title = format!("{}: {shown}", self.name);
        let frames = if diagram.magnified.is_empty() || !style.names.contains(&LabelKind::Magnifications) {
            ""
        } else {
            "; rectangles: magnifications"
        };
        let description = format!(
            "{} Grazing curve of the non-impacting solution; saddle-node, period-doubling and grazing \
             bifurcations of maximal periodic solutions; regions of stability in grey. Triangles: resonances; discs: other \
             codimension-two points{frames}.",
            self.axes(style.swap)
        );
        let heading = self.heading("diagram", &title, &description, &tables);
        let sheet = draw_diagram(diagram, &heading, Look { columns: self.width, style })?;
        let figure = DrawnFigure::new(self.of, TWO_PARAMETERS.figure_file(), shown, sheet, &tables);
        Ok(ComputedOutput::new(vec![figure], diagram.tables(self.names)))
    }

    fn magnifications(&self, output: &Output<AnalysedOscillator>, of: &AnalysedOscillator) -> Computed {
        let (style, tables) = (of.oscillator.description.figure().clone(), ["magnifications"]);
        let title = format!("{}: magnifications about resonant grazing bifurcations", self.name);
        let description = format!(
            "{} Dashed: the quadratic approximations to the saddle-node and period-doubling curves.",
            self.axes(style.swap)
        );
        let magnifications = of.unfolded.magnifications(&of.diagram);
        let heading = self.heading("magnifications", &title, &description, &tables);
        let sheets = draw_magnifications(&magnifications, &heading, Look { columns: self.width, style })?;
        let count = sheets.len();
        let title = |number| match count {
            1 => output.title.owned(),
            _ => format!("{}, sheet {number} of {count}", output.title).into(),
        };
        let figures = self.panelled(&output.figure_file(), sheets, title, &tables);
        Ok(ComputedOutput::new(figures, magnifications.tables(self.names)))
    }

    /// Curves in straightened coordinates.
    pub(crate) fn straightened(&self, curves: &StraightenedCurves) -> Computed {
        let (output, [primary, secondary]) = (&STRAIGHTENED_CURVES, self.names.shown());
        let description = format!(
            "Across $\\mu/\\eta^{{2}}$, where $\\mu$ is {primary} minus its value at grazing; up, by decades, $\\eta$, which is {secondary} minus \
             its value at the resonance. Solid: curves that bound where maximal periodic solutions are stable. Dashed: their \
             theoretical limits."
        );
        let title = format!("{}: {}", self.name, output.title);
        let sheets =
            draw_straightened(curves, &self.heading(STRAIGHTENED, &title, &description, &[]), self.width)?;
        let title = |_| output.title.owned();
        let figures = self.panelled(&output.figure_file(), sheets, title, &output.table_names());
        Ok(ComputedOutput::new(figures, curves.tables(self.names)))
    }

    /// Sheets as figures, each of which shows the rows of its own panels.
    fn panelled(
        &self,
        file: &str,
        sheets: Vec<Sheet>,
        title: impl Fn(usize) -> Title,
        tables: &[&'static str],
    ) -> Vec<DrawnFigure> {
        let count = sheets.len();
        let figure = |(sheet, number): (Sheet, usize)| {
            let panels = sheet.panels().filter_map(|panel| Some(panel.only?.1)).collect();
            let figure =
                DrawnFigure::new(self.of, sheet_file(file, number, count), title(number), sheet, tables);
            DrawnFigure { only: Some((columns::PANEL, panels)), ..figure }
        };
        sheets.into_iter().zip(1..).map(figure).collect()
    }

    /// A one-parameter diagram.
    pub(crate) fn one_parameter(&self, diagram: &OneParameter) -> Result<DrawnFigure, DrawingError> {
        let (output, names) = (&ONE_PARAMETER, self.names);
        let shown = format!("{}, {}", output.title, of_one_parameter(names.shown(), diagram));
        let title = format!("{}: {shown}", self.name);
        let [across, _] = diagram.exchanged(names.titles());
        let up = match diagram.ordinate {
            Ordinate::X => "x-value of the return map",
            other => other.name(),
        };
        let sweeps = match diagram.swept(Sweep::Up).next() {
            Some(_) => "; arrowheads up and down: motion as the parameter is swept up and down",
            None => "",
        };
        let neutral = match diagram.branches.iter().any(|point| point.stable == Stability::Neutral) {
            true => ", broken ones neutral",
            false => "",
        };
        let description = format!(
            "Below: {across} across, {up} up; thick curves are stable, thin ones unstable{neutral}; dots are long-term forward \
             orbits{sweeps}. Above: phase portraits with the wall."
        );
        let tables: &[_] = match diagram.ordinate {
            Ordinate::X => {
                &["diagram_bifurcations", "diagram_branches", "diagram_attractor", "diagram_portraits"]
            }
            _ => &["diagram_readings", "diagram_portraits"],
        };
        let heading = self.heading("diagram", &title, &description, tables);
        let sheet = draw_one_parameter(diagram, &heading, true, self.width)?;
        let file = format!("diagram-{}.svg", diagram.diagram);
        let left_out = diagram.simulated.iter().flat_map(Orbits::left_out);
        let shown = left_out.fold(shown, |shown, words| format!("{shown}; left out: {words}"));
        let figure = DrawnFigure::new(self.of, file, shown, sheet, &output.table_names());
        Ok(DrawnFigure { only: Some((columns::DIAGRAM, vec![diagram.diagram])), ..figure })
    }

    /// A sentence about the axes of the plane.
    fn axes(&self, swapped: bool) -> String {
        let [primary, secondary] = self.names.titles();
        let [across, up] = if swapped { [secondary, primary] } else { [primary, secondary] };
        format!("{across} across, {up} up.")
    }
}

/// The extent of a one-parameter diagram, as `A from 0.26 to 0.34 at omega = 0.855` if those are
/// the names of the parameters.
pub(crate) fn of_one_parameter<T: std::fmt::Display>(names: [T; 2], diagram: &OneParameter) -> String {
    let [across, held] = diagram.exchanged(names);
    let [low, high] = diagram.frame.x.map(|end| brief(end, 6));
    format!("{across} from {low} to {high} at {held} = {}", brief(diagram.at, 6))
}
