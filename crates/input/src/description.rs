//! The checked description, and the oscillator that it defines.

use std::sync::{Arc, OnceLock};

use grazing_model::AnyOscillator;
use grazing_model::smooth::{
    Dimensionless, Exact, Partials, Scalar, SmoothOscillator, Stop, Stoppable, Units,
};

use grazing_results::plane::Property;
use grazing_results::readings::Ordinate;

use crate::error::{KeyPlace, Note};
use crate::expression::Expression;
use crate::file::{AnalysisLimits, Axis, FigureStyle, File, MOST_DIAGRAMS, WallSide, WrittenAnalysis};

/// An oscillator with a wall, as described by a file; a clone shares everything with the original.
///
/// Paper: eq:F, eq:R. All quantities are in the units of the file, dimensionless or not. If there are two
/// walls, it is seen from one of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Description(pub(crate) Arc<Content>, pub(crate) usize);

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Content {
    /// The file as written, except that the constants are in alphabetical order.
    pub(crate) file: File,
    /// What is seen from each wall: one, or two in the order of the file.
    pub(crate) stops: Vec<WallView>,
    pub(crate) start: Option<[f64; 2]>,
    pub(crate) curves: Vec<OwnCurve>,
    pub(crate) diagrams: Vec<OneParameterRequest>,
    pub(crate) notes: Vec<Note>,
    /// The units, once they have been determined.
    pub(crate) units: OnceLock<Units>,
}

/// The oscillator as it is seen from one of its walls.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WallView {
    pub(crate) texts: Expressions<String>,
    pub(crate) places: Expressions<KeyPlace>,
    pub(crate) side: WallSide,
    /// The mass that hits this wall, as written.
    pub(crate) mass_text: Option<String>,
    pub(crate) formulas: Formulas,
    pub(crate) mass: Option<Expression>,
    /// The number of harmonics, if motion is known in closed form.
    pub(crate) harmonics: Option<u32>,
}

/// The formulas for computation; the force is that seen from the wall.
pub(crate) type Formulas = Expressions<Expression, Wall>;

/// A one-parameter diagram that the file requests.
#[derive(Debug, Clone, PartialEq)]
pub struct OneParameterRequest {
    /// Whether the primary parameter is held, rather than the secondary one.
    pub primary_is_fixed: bool,
    /// The value of the parameter that is held, inside its range.
    pub at: f64,
    /// The range of the other parameter, inside its range in the file.
    pub range: [f64; 2],
    /// Values in that range at which phase portraits are drawn, in increasing order.
    pub portraits: Vec<f64>,
    /// The seed of random initial states.
    pub seed: u64,
    /// The quantity on the vertical axis.
    pub ordinate: Ordinate,
    /// Whether motion is followed as the parameter goes up and down.
    pub sweeps: bool,
    /// The most impacts of solutions whose branches are followed.
    pub impacts: u32,
}

/// A curve that the file requests, on which MPSs have a property.
#[derive(Debug, Clone, PartialEq)]
pub struct OwnCurve {
    /// The name of the curve.
    pub name: String,
    /// The numbers of loops p, among those of the analysis.
    pub loops: Vec<u32>,
    /// The property that holds along the curve, in the units of the file.
    pub property: Property,
}

/// The wall, and the conversion from its coordinates, in which the oscillator has the form of the
/// paper, to those of the file.
///
/// With the wall at W(t), u = x − W for motion below it and W − x for motion above it: u ≤ 0, and
/// impacts have the relative velocity u̇ > 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Wall {
    pub(crate) side: WallSide,
    /// The position x and velocity v as expressions in u, u̇, t, μ, η.
    pub(crate) outside: [Expression; 2],
}

impl Wall {
    /// Whether the wall stands still at x = 0 with the motion below it, the default of a file.
    pub fn is_usual(&self) -> bool {
        // x and v are then u and u̇, which takes no instruction.
        self.side == WallSide::Below && self.outside.iter().all(|coordinate| coordinate.instructions() == 0)
    }

    /// The side of the wall on which the motion is.
    pub fn side(&self) -> WallSide {
        self.side
    }

    /// Position x and velocity v, in the coordinates of the file, of motion that is at u with u̇
    /// seen from the wall.
    pub fn outside(&self, [u, velocity]: [f64; 2], time: f64, [mu, eta]: [f64; 2]) -> [f64; 2] {
        self.outside.each_ref().map(|coordinate| coordinate.evaluate(&[u, velocity, time, mu, eta]))
    }

    /// Coordinates u and u̇, seen from the wall, of motion with position x and velocity v.
    pub fn inside(&self, [x, v]: [f64; 2], time: f64, parameters: [f64; 2]) -> [f64; 2] {
        let [position, velocity] = self.outside([0.0, 0.0], time, parameters);
        [self.side.sign() * (x - position), self.side.sign() * (v - velocity)]
    }
}

/// A value for each expression of a file, such as its text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Expressions<T, W = T> {
    /// The force F.
    pub force: T,
    /// The position of the wall.
    pub wall: W,
    /// The forcing frequency ω.
    pub frequency: T,
    /// The restitution Φ.
    pub restitution: T,
    /// The impact duration Ψ.
    pub duration: T,
}

impl<T> Expressions<T> {
    pub(crate) fn map<U>(&self, of: impl Fn(&T) -> U) -> Expressions<U> {
        Expressions {
            force: of(&self.force),
            wall: of(&self.wall),
            frequency: of(&self.frequency),
            restitution: of(&self.restitution),
            duration: of(&self.duration),
        }
    }
}

impl Description {
    /// The largest number of one-parameter diagrams.
    pub const MOST_DIAGRAMS: usize = MOST_DIAGRAMS;

    /// The oscillator at parameters (μ, η), in the units of the file. Its force, maps and laws are right in any
    /// units; long motion with impacts is followed in those of [`units`](Self::units), of which it is of the order
    /// of one ([`counted`](Self::counted)).
    pub fn oscillator(&self, parameters: [f64; 2]) -> AnyOscillator {
        self.counted(parameters, &Units::ONE, &Stop::default())
    }

    /// The oscillator at parameters (μ, η) in these units, as is its motion; nothing moves once the
    /// computation is cancelled.
    pub fn counted(&self, parameters: [f64; 2], units: &Units, stop: &Stop) -> AnyOscillator {
        let model = Stoppable::new(Dimensionless::new(self.clone(), *units), stop.clone());
        AnyOscillator::new(Exact::new(model, parameters))
    }

    /// The name of the oscillator.
    pub fn name(&self) -> &str {
        &self.0.file.name
    }

    /// The constants with their values, in alphabetical order.
    pub fn constants(&self) -> impl Iterator<Item = (&str, f64)> {
        self.0.file.parameters.iter().map(|(name, value)| (name.as_str(), *value))
    }

    /// The primary parameter, μ of the trait's functions.
    pub fn primary(&self) -> &Axis {
        &self.0.file.primary
    }

    /// The secondary parameter, η of the trait's functions.
    pub fn secondary(&self) -> &Axis {
        &self.0.file.secondary
    }

    /// The names of the units of length, time and mass that the file gives.
    pub fn unit_names(&self) -> [Option<&str>; 3] {
        let Some(units) = &self.0.file.units else { return [None; 3] };
        [&units.length, &units.time, &units.mass].map(Option::as_deref)
    }

    /// The wall.
    pub fn wall(&self) -> &Wall {
        &self.seen().formulas.wall
    }

    /// What is seen from the wall.
    pub(crate) fn seen(&self) -> &WallView {
        &self.0.stops[self.1]
    }

    /// The oscillator as seen from each of its walls: one, or two in the order of the file.
    pub fn from_each_wall(&self) -> impl Iterator<Item = Description> {
        (0..self.0.stops.len()).map(|stop| Description(self.0.clone(), stop))
    }

    /// Whether motion takes place between two walls.
    pub fn has_two_walls(&self) -> bool {
        self.0.stops.len() == 2
    }

    /// The formulas for computation: the force seen from the [`Wall`], in u, u̇, t, μ, η; ω in μ,
    /// η; Φ and Ψ in y, z, μ, η.
    pub fn formulas(&self) -> [&Expression; 4] {
        let Formulas { force, frequency, restitution, duration, .. } = &self.seen().formulas;
        [force, frequency, restitution, duration]
    }

    /// The expressions as written in the file.
    pub fn texts(&self) -> &Expressions<String> {
        &self.seen().texts
    }

    /// The start (u, u̇) at time zero of the search for the non-impacting motion, if the file gives
    /// position and velocity; seen from the wall where it is in the middle of the ranges.
    pub fn start(&self) -> Option<[f64; 2]> {
        self.0.start
    }

    /// Notes on values that are allowed but perhaps not intended.
    pub fn notes(&self) -> &[Note] {
        &self.0.notes
    }

    /// The limits of the analysis; all are positive.
    pub fn limits(&self) -> AnalysisLimits {
        let WrittenAnalysis { time_limit: time, memory_limit: memory, step_limit: steps, .. } =
            self.0.file.analysis;
        AnalysisLimits { time, memory, steps }
    }

    /// Units in which the motion is of the order of one in the ranges.
    pub fn units(&self) -> Units {
        *self.0.units.get_or_init(|| self.units_until(&Stop::default()))
    }

    /// Units in which the motion is of the order of one; meaningless once the computation is
    /// cancelled.
    pub(crate) fn units_until(&self, stop: &Stop) -> Units {
        let ranges = [self.primary().range(), self.secondary().range()];
        Units::of(&Stoppable::new(self.clone(), stop.clone()), ranges)
    }

    /// The numbers of loops p to analyse: at least one, each 1 or more, without repetition, in the
    /// order of the file.
    pub fn loops(&self) -> &[u32] {
        &self.0.file.analysis.loops
    }

    /// The generation up to which solutions with impacts are sought; 1 for those with one impact alone.
    pub fn generations(&self) -> u32 {
        self.0.file.analysis.generations
    }

    /// The style of the two-parameter diagram and its magnifications.
    pub fn figure(&self) -> &FigureStyle {
        &self.0.file.figure
    }

    /// Whether the file gives the mass that hits the wall.
    pub fn has_mass(&self) -> bool {
        self.0.stops.iter().all(|seen| seen.mass.is_some())
    }

    /// The impulse m (1 + Φ) y of an impact and the energy m/2 (1 − Φ²) y² that it dissipates; NaN
    /// where the file gives no mass.
    pub fn impulse_and_loss(&self, [y, z]: [f64; 2], [mu, eta]: [f64; 2]) -> [f64; 2] {
        let mass = self.seen().mass.as_ref().map_or(f64::NAN, |mass| mass.evaluate(&[mu, eta]));
        let restitution = self.restitution(y, z, mu, eta);
        [mass * (1.0 + restitution) * y, 0.5 * mass * (1.0 - restitution * restitution) * y * y]
    }

    /// The own curves that the file requests.
    pub fn curves(&self) -> &[OwnCurve] {
        &self.0.curves
    }

    /// The one-parameter diagrams that the file requests.
    pub fn diagrams(&self) -> &[OneParameterRequest] {
        &self.0.diagrams
    }
}

impl SmoothOscillator for Description {
    fn force<S: Scalar>(&self, x: S, y: S, t: S, mu: S, eta: S) -> S {
        self.seen().formulas.force.evaluate(&[x, y, t, mu, eta])
    }

    fn force_at<T: Scalar, S: Scalar + From<T>>(&self, t: T, mu: T, eta: T) -> impl FnMut(S, S) -> S {
        let mut force = self.seen().formulas.force.hold(&[t, mu, eta]);
        move |x, y| force(&[&x, &y])
    }

    fn slopes_at<S: Scalar>(&self, t: S, mu: S, eta: S) -> Option<impl FnMut(S, S, bool) -> [S; 3]> {
        let mut force = self.seen().formulas.force.hold_slopes(&[t, mu, eta])?;
        Some(move |x, y, slopes| force(&[&x, &y], slopes))
    }

    fn partials<S: Scalar>(&self, arguments: &[S; 5], second: bool, partials: &mut Partials<S>) -> bool {
        self.seen().formulas.force.partials(arguments, second, partials)
    }

    fn forcing_frequency<S: Scalar>(&self, mu: S, eta: S) -> S {
        self.seen().formulas.frequency.evaluate(&[mu, eta])
    }

    fn restitution<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        self.seen().formulas.restitution.evaluate(&[y, z, mu, eta])
    }

    fn impact_duration<S: Scalar>(&self, y: S, z: S, mu: S, eta: S) -> S {
        self.seen().formulas.duration.evaluate(&[y, z, mu, eta])
    }

    fn harmonics(&self) -> Option<u32> {
        self.seen().harmonics
    }

    fn other_stop(&self) -> Option<Self> {
        self.has_two_walls().then(|| Self(self.0.clone(), 1 - self.1))
    }

    fn gap<S: Scalar>(&self, t: S, mu: S, eta: S) -> [S; 2] {
        let [own, other] =
            [self.1, 1 - self.1].map(|stop| self.0.stops.get(stop).map(|seen| &seen.formulas.wall));
        let (Some(own), Some(other)) = (own, other) else { return [f64::INFINITY, 0.0].map(S::constant) };
        let still = S::constant(0.0);
        let at = [still, still, t, mu, eta];
        let apart =
            |k: usize| (own.outside[k].evaluate(&at) - other.outside[k].evaluate(&at)).scale(own.side.sign());
        [apart(0), apart(1)]
    }
}
