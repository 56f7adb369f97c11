//! Oscillators from text files, prepared for an analysis.

use grazing_continuation::curve::Window;
use grazing_input::{Axis, Description, OwnCurve};
use grazing_model::smooth::{Stop, Units};
use grazing_model::{AnyOscillator, ImpactOscillator};
use grazing_results::branches::{OneParameter, Readings};
use grazing_results::family::Family;
use grazing_results::grazing::AlongGrazing;
use grazing_results::measured::{Comparison, Identified};
use grazing_results::plane::{Magnifications, OwnCurves, PlaneDiagram, SequenceDiagram, StraightenedCurves};
use grazing_results::resonance::AtResonances;
use grazing_results::{Dimensioned, Names, TablePlan, Tables, UnitNames};

use crate::progress::Progress;
use crate::{Diagram, Scope, UnfoldError};

/// The names of the two parameters, which head their columns, and the units of the tables, to which
/// dimensionless results are converted.
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// The names; a name that is already that of another column has `_` appended.
    pub names: Names,
    /// The oscillator's own units.
    pub units: Units,
}

/// The tables of an oscillator.
const TABLES: [&[TablePlan]; 12] = [
    AlongGrazing::TABLES,
    PlaneDiagram::TABLES,
    OwnCurves::TABLES,
    SequenceDiagram::TABLES,
    AtResonances::TABLES,
    Magnifications::TABLES,
    StraightenedCurves::TABLES,
    OneParameter::TABLES,
    Readings::TABLES,
    Family::TABLES,
    Comparison::TABLES,
    Identified::TABLES,
];

impl Axes {
    /// The axes of the paper's oscillator: amplitude and frequency.
    pub fn of_the_paper() -> Self {
        Self { names: Names::of_the_paper(), units: Units::ONE }
    }

    /// The names of an oscillator's parameters, and its own units.
    pub fn of(description: &Description) -> Self {
        let parameters = [description.primary(), description.secondary()];
        let [primary, secondary] =
            parameters.map(|axis| own_header(axis.name(), TABLES.into_iter().flatten()));
        let owned = |unit: Option<&str>| unit.map(str::to_owned);
        let [length, time, mass] = description.unit_names().map(owned);
        let [of_primary, of_secondary] = parameters.map(|axis| owned(axis.unit()));
        let units = UnitNames { length, time, mass, primary: of_primary, secondary: of_secondary };
        let names =
            Names::new(&primary, &secondary).with_units(units).between_walls(description.has_two_walls());
        Self { names, units: description.units() }
    }
}

/// The name of a parameter as a header in tables, with `_` appended while another column has that name.
pub(crate) fn own_header<'a>(name: &str, tables: impl Iterator<Item = &'a TablePlan>) -> String {
    let taken: Vec<_> = tables.flat_map(|table| table.columns).map(|column| column.name).collect();
    let mut name = name.to_owned();
    while taken.contains(&name.as_str()) {
        name.push('_');
    }
    name
}

/// An oscillator prepared for an analysis.
pub struct Prepared {
    /// The oscillator, whose computations end when the analysis is cancelled.
    pub oscillator: AnyOscillator,
    /// Ranges and numbers of loops.
    pub scope: Scope,
    /// The curves that the file requests, in dimensionless form.
    pub requested: Vec<OwnCurve>,
    /// The names of the parameters, and the oscillator's units.
    pub axes: Axes,
}

impl Prepared {
    /// The oscillator that a file describes, with the names and units in `axes`; its motion ends when `stop` is set.
    pub fn new(description: &Description, axes: Axes, stop: &Stop) -> Self {
        let [primary, secondary] = [description.primary(), description.secondary()].map(Axis::range);
        let window = Window { primary, secondary };
        let scope = Scope { window, loops: description.loops().to_vec(), start: description.start() };
        let scope = scope.without_dimensions(&axes.units);
        let at = [scope.window.primary[0], scope.window.secondary[0]];
        let own = |curve: &OwnCurve| {
            let property = curve.property.without_dimensions(&axes.units);
            OwnCurve { property, ..curve.clone() }
        };
        Self {
            oscillator: description.counted(at, &axes.units, stop),
            scope,
            requested: description.curves().iter().map(own).collect(),
            axes,
        }
    }

    /// The oscillator that a file describes, with the file's own names and units.
    pub fn of(description: &Description, stop: &Stop) -> Self {
        Self::new(description, Axes::of(description), stop)
    }

    /// What is to be computed as each wall sees it: the first, and then the other one if there are two.
    pub fn from_each_wall(&self) -> impl Iterator<Item = AtWall> {
        from_each_wall(&self.oscillator, &self.scope, &self.requested)
    }

    /// A place given in the oscillator's own units, in dimensionless form.
    pub fn without_dimensions(&self, place: [f64; 2]) -> [f64; 2] {
        self.axes.units.without_dimensions(place)
    }
}

/// What is to be computed of an oscillator as each wall sees it: the first, and then the other one if there are two.
pub fn from_each_wall(
    oscillator: &AnyOscillator,
    scope: &Scope,
    requested: &[OwnCurve],
) -> impl Iterator<Item = AtWall> + use<> {
    let other = oscillator.other_stop();
    let wall = u32::from(other.is_some());
    let (oscillator, first) = (oscillator.clone(), scope.clone());
    let first = AtWall { wall, oscillator, scope: first, requested: requested.to_vec() };
    // The start of the search, and the curves that a file requests, are seen from the first wall.
    let scope = Scope { start: None, ..scope.clone() };
    let other = other.map(|oscillator| AtWall { wall: 2, oscillator, scope, requested: Vec::new() });
    [first].into_iter().chain(other)
}

/// An oscillator as one of its walls sees it, and what is to be computed of it.
pub struct AtWall {
    /// The number of the wall, 1 or 2, if there are two; 0 otherwise.
    pub wall: u32,
    /// The oscillator.
    pub oscillator: AnyOscillator,
    scope: Scope,
    requested: Vec<OwnCurve>,
}

impl AtWall {
    /// The first half of a diagram: [`Diagram::located`].
    ///
    /// # Errors
    /// The computation was cancelled before anything was found.
    pub fn located(self, progress: &dyn Progress) -> Result<Diagram, UnfoldError> {
        let Self { wall, oscillator, scope, requested } = self;
        let located = Diagram::located(&oscillator, &scope, progress)?;
        Ok(Diagram { wall, ..located }.requesting(requested))
    }

    /// The whole diagram, with its regions, even if there is nothing in it.
    ///
    /// # Errors
    /// As [`located`](Self::located).
    pub fn whole(self, progress: &dyn Progress) -> Result<Diagram, UnfoldError> {
        let located = self.located(progress)?;
        let followed = located.follow(progress, &|_, _| ());
        Ok(located.with(followed, progress))
    }
}
