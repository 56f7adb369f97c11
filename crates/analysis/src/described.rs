//! Oscillators from text files, prepared for an analysis.

use core::f64::consts::TAU;

use grazing_continuation::curve::Window;
use grazing_input::{Axis, Description, OwnCurve, Property as Written};
use grazing_model::smooth::{Stop, Stoppable, Units};
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator, OscillatorError};
use grazing_results::Dimensioned;
use grazing_unfold::own_curves::{Level, Property};
use grazing_unfold::progress::Progress;
use grazing_unfold::{Diagram, Scope, UnfoldError};

use crate::plane::Axes;

/// An oscillator prepared for an analysis.
pub struct Prepared {
    /// The oscillator, whose computations end when the analysis is cancelled.
    pub oscillator: AnyOscillator,
    /// Ranges and numbers of loops.
    pub scope: Scope,
    /// The curves that the file requests.
    pub asked: Vec<Level>,
    /// The names of the parameters, and the oscillator's units.
    pub axes: Axes,
}

impl Prepared {
    /// The oscillator that a file describes, with the names and units in `axes`.
    pub fn new(description: &Description, axes: Axes, stop: &Stop) -> Self {
        let (oscillator, scope) = prepared(description, &axes.units, stop);
        Self { oscillator, scope, asked: levels(description, &axes.units), axes }
    }

    /// The paper's oscillator, whose flow is known in closed form, with the constants, ranges and loops
    /// of a file that describes it.
    ///
    /// # Errors
    /// ζ, ε, a frequency or an amplitude is out of its domain.
    pub fn of_the_paper(description: &Description, stop: &Stop) -> Result<Self, OscillatorError> {
        let [zeta, epsilon] = ["zeta", "epsilon"].map(|wanted| {
            let mut constants = description.constants();
            constants.find(|(name, _)| *name == wanted).map_or(f64::NAN, |(_, value)| value)
        });
        let axes = Axes::of_the_paper();
        let scope = scope(description).without_dimensions(&axes.units);
        let [amplitude, frequency] = [scope.window.primary[0], scope.window.secondary[0]];
        let oscillator = LinearOscillator::new(zeta, epsilon, amplitude, frequency)?;
        let oscillator = AnyOscillator::new(Stoppable::new(oscillator, stop.clone()));
        Ok(Self {
            oscillator,
            scope: Scope { start: None, ..scope },
            asked: levels(description, &axes.units),
            axes,
        })
    }

    /// What is to be computed as each wall sees it: the first, and then the other one if there are two.
    pub fn from_each_wall(&self) -> impl Iterator<Item = AtWall> {
        from_each_wall(&self.oscillator, &self.scope, &self.asked)
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
    asked: &[Level],
) -> impl Iterator<Item = AtWall> + use<> {
    let other = oscillator.other_stop();
    let wall = u32::from(other.is_some());
    let first = AtWall { wall, oscillator: oscillator.clone(), scope: scope.clone(), asked: asked.to_vec() };
    // The start of the search, and the curves that a file requests, are seen from the first wall.
    let scope = Scope { start: None, ..scope.clone() };
    let other = other.map(|oscillator| AtWall { wall: 2, oscillator, scope, asked: Vec::new() });
    [first].into_iter().chain(other)
}

/// An oscillator as one of its walls sees it, and what is to be computed of it.
pub struct AtWall {
    /// The number of the wall, 1 or 2, if there are two; 0 otherwise.
    pub wall: u32,
    /// The oscillator.
    pub oscillator: AnyOscillator,
    scope: Scope,
    asked: Vec<Level>,
}

impl AtWall {
    /// The first half of a diagram: [`Diagram::located`].
    ///
    /// # Errors
    /// The computation was cancelled before anything was found.
    pub fn located(self, progress: &dyn Progress) -> Result<Diagram, UnfoldError> {
        let Self { wall, oscillator, scope, asked } = self;
        let located = Diagram::located(&oscillator, &scope, progress)?;
        Ok(Diagram { wall, ..located }.asking_for(asked))
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

/// The ranges, numbers of loops and starting point that a file requests, in its units.
fn scope(description: &Description) -> Scope {
    let [primary, secondary] = [description.primary(), description.secondary()].map(Axis::range);
    let window = Window { primary, secondary };
    Scope { window, loops: description.loops().to_vec(), start: description.start() }
}

/// The curves that a file requests, in dimensionless form.
pub fn levels(description: &Description, units: &Units) -> Vec<Level> {
    let level = |OwnCurve { name, loops, property }: &OwnCurve| {
        let property = match *property {
            Written::ImpactVelocity(velocity) => Property::ImpactVelocity(velocity),
            Written::Modulus(modulus) => Property::Modulus(modulus),
            Written::Distance { distance, phase } => Property::Distance { phase: TAU * phase, distance },
        };
        Level { name: name.clone(), loops: loops.clone(), property: property.without_dimensions(units) }
    };
    description.curves().iter().map(level).collect()
}

/// The oscillator in these units, which stops when `stop` is set, and the scope that its file requests.
pub fn prepared(description: &Description, units: &Units, stop: &Stop) -> (AnyOscillator, Scope) {
    let scope = scope(description).without_dimensions(units);
    let at = [scope.window.primary[0], scope.window.secondary[0]];
    (description.counted(at, units, stop), scope)
}
