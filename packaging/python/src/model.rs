//! An oscillator, and its computations.

use std::collections::BTreeMap;
use std::path::PathBuf;

use grazing_cli::failure::Failure;
use grazing_cli::library::{self, LibraryTask, StartProgress};
use grazing_cli::variation::Variation;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_explore::{Model as Described, View, Wanted};
use grazing_input::Setting;
use grazing_results::kinds::{CurveLook, region_inks};
use grazing_results::plane::RegionKind;
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;

use crate::compute::compute;
use crate::table::Table;

/// The text of an oscillator with values of constants and numbers of loops, or the paper's oscillator without a text.
#[pyclass(frozen, module = "grazing._grazing")]
pub(crate) struct Model {
    model: Described,
    file: String,
}

/// The results of a computation.
#[pyclass(frozen, get_all, module = "grazing._grazing")]
pub(crate) struct Results {
    names: [String; 2],
    listing: String,
    missing: Vec<String>,
    tables: Vec<Py<Table>>,
    figures: Vec<(String, String)>,
}

impl Results {
    fn new(py: Python<'_>, found: library::Results) -> PyResult<Self> {
        let library::Results { names, listing, missing, tables, figures } = found;
        let tables = tables.into_iter().map(|table| Py::new(py, Table::new(table)));
        Ok(Self { names, listing, missing, tables: tables.collect::<PyResult<_>>()?, figures })
    }
}

/// Two parameters, or two ends of a range.
type Both = [f64; 2];
/// The receiver of a computation's progress, if there is one.
type Hears<'a, 'py> = Option<&'a Bound<'py, PyAny>>;

impl Model {
    /// Computes results about the oscillator.
    fn found(
        &self,
        py: Python<'_>,
        progress: Hears<'_, '_>,
        of: impl FnOnce(&LibraryTask<'_>) -> Result<library::Results, Failure> + Send,
    ) -> PyResult<Results> {
        let Self { model, file } = self;
        let work = |report: StartProgress<'_>| of(&LibraryTask { model, file, report });
        Results::new(py, compute(py, progress, work)?)
    }
}

#[pymethods]
impl Model {
    #[new]
    fn new(text: Option<String>, file: String, set: BTreeMap<String, f64>, loops: Option<Vec<u32>>) -> Self {
        Self { model: Described { text, set, loops }, file }
    }

    /// The listing that precedes all results, and names and ranges of the two parameters.
    fn checked(&self, py: Python<'_>) -> PyResult<(String, [(String, Both); 2])> {
        let Self { model, file } = self;
        let (description, listing) =
            compute(py, None, |report| LibraryTask { model, file, report }.checked())?;
        let axis = |axis: &grazing_input::Axis| (axis.name().to_owned(), axis.range());
        Ok((listing, [description.primary(), description.secondary()].map(axis)))
    }

    /// The results of `unfold`, in these ranges of the two parameters.
    fn diagram(&self, py: Python<'_>, view: Option<[Both; 2]>, progress: Hears<'_, '_>) -> PyResult<Results> {
        let view = view.map(|[primary, secondary]| View { primary, secondary });
        self.found(py, progress, |task| task.diagram(view.as_ref()))
    }

    /// The results that the page of `explore` shows, requested in JSON as the page does.
    fn seen(&self, py: Python<'_>, wanted: &str, progress: Hears<'_, '_>) -> PyResult<Results> {
        let wanted: Wanted =
            serde_json::from_str(wanted).map_err(|error| PyValueError::new_err(error.to_string()))?;
        self.found(py, progress, |task| task.seen(&wanted))
    }

    /// Motion at a place from x, v, t, over a number of forcing periods.
    fn simulated(&self, py: Python<'_>, at: Both, start: [f64; 3], periods: f64) -> PyResult<Results> {
        self.found(py, None, |task| task.simulated(at, start, periods))
    }

    /// The results of `unfold --vary`.
    fn family(&self, py: Python<'_>, vary: Vec<String>, progress: Hears<'_, '_>) -> PyResult<Results> {
        let vary: Result<Vec<Variation>, String> = vary.iter().map(|written| written.parse()).collect();
        let vary = vary.map_err(PyValueError::new_err)?;
        self.found(py, progress, |task| task.family(&vary))
    }
}

/// The results of `reproduce --only NAME --set ...`.
#[pyfunction]
pub(crate) fn reproduce(
    py: Python<'_>,
    name: &str,
    set: Vec<String>,
    progress: Hears<'_, '_>,
) -> PyResult<Results> {
    let set: Result<Vec<Setting>, _> = set.iter().map(|setting| setting.parse::<Setting>()).collect();
    let set = set.map_err(|error| PyValueError::new_err(error.to_string()))?;
    Results::new(py, compute(py, progress, |report| library::paper(name, &set, report))?)
}

/// The outputs of `reproduce`: names and titles.
#[pyfunction]
pub(crate) fn outputs() -> Vec<(&'static str, String)> {
    library::outputs_of_the_paper().collect()
}

/// The text of a file.
#[pyfunction]
pub(crate) fn read(path: PathBuf) -> PyResult<String> {
    grazing_input::read_file(&path).map_err(|error| PyOSError::new_err(error.to_string()))
}

/// Meaning, colour, width in points and dashes of a kind of curve, by its name.
type Looks = BTreeMap<&'static str, (&'static str, [u8; 3], f64, &'static [f64])>;

/// The looks of kinds of curves, and colour and opacity of kinds of regions.
#[pyfunction]
pub(crate) fn looks() -> (Looks, BTreeMap<&'static str, ([u8; 3], f64)>) {
    let curve = |kind: Bifurcation| {
        let look = CurveLook::of(kind);
        (kind.name(), (look.meaning, look.colours[0], look.width, look.dashes))
    };
    let region = |kind: &RegionKind| (kind.name(), region_inks(*kind)[0]);
    (Bifurcation::ALL.into_iter().map(curve).collect(), RegionKind::ALL.iter().map(region).collect())
}
