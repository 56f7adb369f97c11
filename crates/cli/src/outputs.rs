//! The registry of outputs: what can be made, and from what.

use std::error::Error;
use std::path::{Path, PathBuf};

use grazing_drawing::{
    Figure02, Figure07, Figure08, Magnified, Section, Window, draw_fig02, draw_fig07, draw_fig08,
};
use grazing_reproduction::parameters::{Parameters, Range, Rectangle};
use grazing_reproduction::{Study, Table};

use crate::failure::Failure;
use crate::folder::{DATA, MadeFile};
use crate::tables;

/// An output when it is made: the figure as SVG, if it is one, and the tables in the order of the registry.
struct Made {
    figure: Option<String>,
    tables: Vec<Table>,
}

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
    make: fn(&Study<'_>) -> Result<Made, Box<dyn Error>>,
}

/// All outputs, in the order in which they are made.
pub const ALL: &[Output] = &[
    Output {
        name: "coefficients",
        title: "Coefficients at all resonances of Figure 7",
        figure: None,
        tables: &["coefficients"],
        make: |study| Ok(Made { figure: None, tables: vec![study.coefficient_table()?] }),
    },
    Output {
        name: "fig02",
        title: "Figure 2: one-parameter bifurcation diagram with phase portraits",
        figure: Some("fig02.svg"),
        tables: &["fig02_branches", "fig02_bifurcations", "fig02_attractor", "fig02_portraits"],
        make: fig02,
    },
    Output {
        name: "fig07",
        title: "Figure 7: two-parameter bifurcation diagram",
        figure: Some("fig07.svg"),
        tables: &["fig07_curves", "fig07_points", "fig07_regions"],
        make: fig07,
    },
    Output {
        name: "fig08",
        title: "Figure 8: three magnifications of Figure 7 with quadratic approximations",
        figure: Some("fig08.svg"),
        tables: &["fig08_curves"],
        make: fig08,
    },
];

fn fig02(study: &Study<'_>) -> Result<Made, Box<dyn Error>> {
    let made = study.fig02()?;
    let shown = study.parameters().fig02();
    let figure = draw_fig02(&Figure02 {
        branches: &made.branches.frame,
        bifurcations: &made.bifurcations.frame,
        attractor: &made.attractor.frame,
        portraits: &made.portraits.frame,
        window: window(shown.amplitude(), shown.x()),
        magnification: window(shown.magnified_amplitude(), shown.magnified_x()),
    })?;
    Ok(Made { figure: Some(figure), tables: made.tables() })
}

fn fig07(study: &Study<'_>) -> Result<Made, Box<dyn Error>> {
    let made = study.fig07()?;
    let parameters = study.parameters();
    let section = parameters.fig02();
    let figure = draw_fig07(&Figure07 {
        curves: &made.curves.frame,
        points: &made.points.frame,
        regions: &made.regions.frame,
        window: plane(parameters.fig07().window()),
        magnified: &magnified(parameters),
        section: Section { omega: section.frequency(), amplitude: ends(section.amplitude()) },
    })?;
    Ok(Made { figure: Some(figure), tables: made.tables() })
}

fn fig08(study: &Study<'_>) -> Result<Made, Box<dyn Error>> {
    let (made, whole) = (study.fig08()?, study.fig07()?);
    let figure = draw_fig08(&Figure08 {
        curves: &made.curves.frame,
        points: &whole.points.frame,
        regions: &whole.regions.frame,
        coefficients: &made.coefficients.frame,
        panels: &magnified(study.parameters()),
    })?;
    Ok(Made { figure: Some(figure), tables: made.tables() })
}

/// The panels of Figure 8, numbered from 1.
fn magnified(parameters: &Parameters) -> Vec<Magnified> {
    let panels = parameters.fig08().panels().iter().zip(1..);
    panels.map(|(shown, panel)| Magnified { panel, window: plane(shown.window()) }).collect()
}

/// The amplitudes across and the frequencies up.
fn plane(rectangle: Rectangle) -> Window {
    window(rectangle.amplitude(), rectangle.frequency())
}

fn window(across: Range, up: Range) -> Window {
    Window { x: ends(across), y: ends(up) }
}

fn ends(range: Range) -> [f64; 2] {
    [range.lower(), range.upper()]
}

impl Output {
    /// The paths of its files in the output folder.
    pub fn paths(&self) -> impl Iterator<Item = PathBuf> {
        self.figure.iter().map(PathBuf::from).chain(self.tables.iter().map(|table| table_path(table)))
    }

    /// Computes the output.
    ///
    /// # Errors
    /// [`Failure::Computation`]; [`Failure::Registry`] if other tables were made than announced.
    pub(crate) fn files(&self, study: &Study<'_>) -> Result<Vec<MadeFile>, Failure> {
        let made = (self.make)(study).map_err(|error| computation(self.name, &*error))?;
        let names: Vec<&'static str> = made.tables.iter().map(|table| table.name).collect();
        if names != self.tables {
            return Err(Failure::Registry { output: self.name, made: names, registered: self.tables });
        }
        let mut files = Vec::new();
        if let (Some(file), Some(svg)) = (self.figure, made.figure) {
            files.push(MadeFile { path: PathBuf::from(file), content: svg.into_bytes() });
        }
        for table in &made.tables {
            let content = tables::csv(&table.frame).map_err(|error| computation(self.name, &error))?;
            files.push(MadeFile { path: table_path(table.name), content });
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

fn table_path(name: &str) -> PathBuf {
    Path::new(DATA).join(format!("{name}.csv"))
}
