//! Curves of grazing bifurcations of the non-impacting solution in the plane of both parameters.
//!
//! The grazing orbit is a zero of P_global(0, z; μ, η) − (0, z) in (z, μ, η): a curve, followed by
//! arclength with folds in μ and η passed like any other point. Paper: Assumption 2.2, satisfied
//! after the change of parameter μ ↦ μ − μ_graz(η).

pub mod along;

use core::f64::consts::TAU;

use grazing_continuation::arclength::{
    CurveEquations, Stall, StepControl, Tangent, Traversal, WalkEnd, across,
};
use grazing_continuation::curve::{Curve, CurvePoint};
use grazing_continuation::mps::{LoopEquations, Multipliers, PeriodicSolution, unknown};
use grazing_continuation::newton::{Linearisation, NewtonFailure};
use grazing_model::maps::MapError;
use grazing_model::motion::Motion;
use grazing_model::{AnyOscillator, AtRest, ImpactOscillator, Passage, State};
use grazing_theorems::GrazingPoint;
use grazing_theorems::from_map::{GrazingOrbit, GrazingPlace};
use nalgebra::{Matrix2, Matrix3, Vector3};

use crate::Scope;
use crate::window_edge::on_the_edge;

/// A point of a grazing curve.
#[derive(Clone, Debug)]
pub struct GrazingCurvePoint {
    /// The grazing orbit, with P_global to second order.
    pub orbit: GrazingOrbit,
    /// The curve's tangent (z, μ, η) there, a unit vector when μ and η are measured in units of
    /// their ranges.
    pub tangent: Vector3<f64>,
    /// The multipliers of the orbit without the wall.
    pub multipliers: Multipliers,
    /// Whether no other maximum of the orbit lies above the wall.
    pub admissible: bool,
}

/// The end of a grazing curve: it leaves the ranges of the parameters, closes, or stops, as where
/// the deceleration at the wall vanishes.
pub type GrazingEnd = WalkEnd<MapError>;

/// A connected piece of the curve of grazing bifurcations.
#[derive(Clone, Debug)]
pub struct GrazingCurve {
    /// The points in order; η is less at the first than at the last.
    pub states: Vec<GrazingCurvePoint>,
    /// The ends before the first point and after the last.
    pub ends: [GrazingEnd; 2],
    /// The number of forcing periods after which the motion recurs; phases are divided by it.
    pub periods: u32,
}

/// Steps in z (radians) and the fractions of both ranges.
const STEPS: StepControl =
    StepControl { first: 1e-3, longest: 0.01, shortest: 1e-6, turn: 0.035, ..StepControl::DRAWING };
/// A curve with this many points is abandoned.
const STEP_LIMIT: usize = 20_000;
/// The angle in radians by which A turns between neighbouring points: a cubic follows a sine this
/// far to two parts in ten thousand, so that the resonances between are separated.
const TURN: f64 = 0.5;
/// Largest number of halvings of the interval between two points.
const HALVINGS: u32 = 12;

impl GrazingCurve {
    /// The curve through a grazing orbit, followed in both directions until it leaves the ranges;
    /// one period of the orbit's oscillator is `periods` forcing periods.
    ///
    /// # Errors
    /// The curve has no unique tangent at the orbit.
    pub fn through(orbit: &GrazingOrbit, scope: &Scope, periods: u32) -> Result<Self, Stall<MapError>> {
        let passage = orbit.passage().clone();
        let equations = GrazingEquations { oscillator: orbit.oscillator(), scope, height: 0.0, passage };
        let start = scope.place(orbit);
        let walk =
            Traversal { equations: &equations, control: STEPS, step_limit: STEP_LIMIT, angle: Some(0) };
        let leaves = |before: &Vector3<f64>, (after, tangent): &Tangent<Vector3<f64>>| {
            let (edge, _) = on_the_edge(&equations, [1, 2], [before, after])?;
            Some((edge, equations.tangent(&edge, tangent).unwrap_or(*tangent)))
        };
        let (mut points, mut ends) = walk.both_ways(start, Vector3::z(), leaves)?;
        if let [(first, _), .., (last, _)] = points.as_slice()
            && first[2] > last[2]
        {
            points.reverse();
            points.iter_mut().for_each(|(_, tangent)| *tangent = -*tangent);
            ends.reverse();
        }
        let states = equations.states(&points);
        // Without a state there the curve has ended before.
        for (end, (point, tangent)) in ends.iter_mut().zip(points.first().into_iter().chain(points.last())) {
            if equations.state(point, tangent).is_none() {
                *end = equations.end_without_state(point);
            }
        }
        Ok(Self { states, ends, periods })
    }

    /// The curve along which solutions with impacts touch the wall, as a curve of grazing bifurcations of motion
    /// that has impacts elsewhere.
    pub fn of_impacting(equations: &LoopEquations, curve: &Curve, scope: &Scope) -> Self {
        let ends = [WalkEnd::LeftWindow, WalkEnd::LeftWindow];
        let mut states: Vec<GrazingCurvePoint> = Vec::with_capacity(curve.points.len());
        for CurvePoint { solution, times } in &curve.points {
            let Some(orbit) = equations.touching_orbit(&solution.unknowns, times) else { continue };
            let passage = orbit.passage().clone();
            let equations = GrazingEquations { oscillator: orbit.oscillator(), scope, height: 0.0, passage };
            let place = scope.place(&orbit);
            let onwards = states.last().map_or(Vector3::z(), |last| place - scope.place(&last.orbit));
            let state =
                equations.tangent(&place, &onwards).and_then(|tangent| equations.state(&place, &tangent));
            let Some(state) = state else { continue };
            if let Some(last) = states.pop() {
                equations.fill(last, &state, HALVINGS, &mut states);
            }
            states.push(state);
        }
        Self { states, ends, periods: 1 }
    }

    /// The parameters (μ, η) along the curve.
    pub fn parameters(&self) -> impl Iterator<Item = [f64; 2]> {
        self.states.iter().map(GrazingCurvePoint::parameters)
    }

    /// The first place of the curve at a value of η, if it reaches that value.
    pub fn at(&self, secondary: f64) -> Option<GrazingPlace> {
        self.all_at(secondary).next()
    }

    /// The places of the curve at a value of η, in the order of the curve.
    pub fn all_at(&self, secondary: f64) -> impl Iterator<Item = GrazingPlace> {
        let around = move |pair: &&[GrazingCurvePoint]| {
            let [a, b] = [0, 1].map(|k| pair[k].parameters()[1]);
            a.min(b) <= secondary && secondary <= a.max(b)
        };
        self.states.windows(2).filter(around).filter_map(move |pair| interpolated(pair, secondary))
    }

    /// Whether the curve passes through a grazing orbit.
    pub fn passes(&self, orbit: &GrazingOrbit, scope: &Scope) -> bool {
        let target = scope.place(orbit);
        self.states.windows(2).any(|pair| {
            let [mut gap, next] = [0, 1].map(|k| scope.place(&pair[k].orbit) - target);
            let chord = next - gap;
            // Phases may be whole turns of the forcing apart.
            gap[0] = libm::remainder(gap[0], TAU / f64::from(self.periods));
            let along = -gap.dot(&chord) / chord.norm_squared();
            (-ENDS..=1.0 + ENDS).contains(&along) && (gap + chord * along).norm() < CHORD
        })
    }
}

/// The place at a value of η between two neighbouring points of a curve.
pub(crate) fn interpolated(neighbours: &[GrazingCurvePoint], secondary: f64) -> Option<GrazingPlace> {
    let [first, last] = [neighbours.first()?, neighbours.last()?].map(|state| &state.orbit);
    let [[a, from], [b, to]] = [first, last].map(|orbit| orbit.oscillator().parameters());
    let way = if to == from { 0.0 } else { (secondary - from) / (to - from) };
    let near = first.oscillator().with_parameters([a + (b - a) * way, secondary]);
    let phase = first.phase() + (last.phase() - first.phase()) * way;
    GrazingPlace::along(&near, phase, first.passage().clone()).ok()
}

/// The highest point of periodic motion without impacts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HighestPoint {
    /// The height of the point above the wall.
    pub(crate) height: f64,
    pub(crate) phase: f64,
    /// The parameters (μ, η).
    pub(crate) parameters: [f64; 2],
}

/// An orbit that Newton's method finds farther than this, in phase and fractions of the ranges,
/// from its start is another one.
const NEARBY: f64 = 0.5;

impl HighestPoint {
    /// The highest point of the same height near this place, with one of the parameters held.
    pub(crate) fn located(&self, oscillator: &AnyOscillator, scope: &Scope, held: usize) -> Option<Self> {
        let Self { height, phase, parameters } = *self;
        let passage = Passage::direct();
        let equations = GrazingEquations { oscillator, scope, height, passage };
        let [primary, secondary] = scope.window.shares(parameters);
        let near = Vector3::new(phase, primary, secondary);
        let direction = if held == unknown::PRIMARY { Vector3::y() } else { Vector3::z() };
        let point = across(&equations, near, &direction, &near)?.point;
        let oscillator = equations.oscillator_at(&point);
        let found = Self { height, phase: point[0], parameters: oscillator.parameters() };
        let turns_back = oscillator.acceleration(State::at_rest(height, found.phase)) < 0.0;
        let here = (point - near).norm() <= NEARBY;
        (here && turns_back && found.is_highest(&oscillator)).then_some(found)
    }

    /// Whether the motion of an oscillator with these parameters reaches no greater height in a
    /// forcing period.
    fn is_highest(&self, oscillator: &AnyOscillator) -> bool {
        let motion = oscillator.motion(State::at_rest(self.height, self.phase));
        motion
            .highest_maximum(oscillator.forcing_period())
            .is_none_or(|maximum| maximum.position <= self.height + PeriodicSolution::TOUCH)
    }

    /// Whether the motion does not reach the other stop, if there are two.
    fn is_clear_of_other_stop(&self, oscillator: &AnyOscillator) -> bool {
        oscillator.other_stop().is_none_or(|other| {
            let motion = other.motion(oscillator.across(State::at_rest(self.height, self.phase)));
            let highest = motion.highest_maximum(1.25 * oscillator.forcing_period());
            highest.is_none_or(|maximum| maximum.position <= PeriodicSolution::TOUCH)
        })
    }

    /// The point at which a grazing orbit touches the wall.
    fn of(orbit: &GrazingOrbit) -> Self {
        Self { height: 0.0, phase: orbit.phase(), parameters: orbit.oscillator().parameters() }
    }

    /// The grazing orbit, where the point lies on the wall.
    pub(crate) fn grazing(&self, oscillator: &AnyOscillator) -> Option<GrazingOrbit> {
        GrazingOrbit::at(oscillator.with_parameters(self.parameters), self.phase).ok()
    }
}

/// Largest distance of a point of the curve from the chord between two neighbours: an eighth of the
/// longest step times the angle by which the tangent turns, several times over.
const CHORD: f64 = 3e-4;

/// An orbit on the edge of the ranges lies at the end of the curve, up to rounding.
const ENDS: f64 = 1e-6;

/// The equations of the curve, or of one on which the highest point lies at another height:
/// unknowns are z and the fractions of the ranges of μ and η.
struct GrazingEquations<'a> {
    oscillator: &'a AnyOscillator,
    scope: &'a Scope,
    height: f64,
    /// The way of an orbit of the curve.
    passage: Passage,
}

impl CurveEquations for GrazingEquations<'_> {
    type Point = Vector3<f64>;
    /// The way of the last orbit.
    type Carried = Option<Passage>;
    type Failure = MapError;

    fn evaluate(
        &self,
        point: &Vector3<f64>,
        passage: &mut Option<Passage>,
    ) -> Result<Linearisation<Vector3<f64>>, MapError> {
        let oscillator = self.oscillator_at(point);
        let passage = passage.get_or_insert_with(|| self.passage.clone());
        let jet = passage.global_map::<_, 1>(&oscillator, AtRest::new(self.height, point[0]))?.jet;
        let [primary, secondary] = self.scope.window.widths();
        let jacobian = jet.jacobian;
        let mut system = Linearisation { residual: Vector3::zeros(), jacobian: Matrix3::zeros() };
        for i in 0..2 {
            system.residual[i] = jet.value[i];
            system.jacobian[(i, 0)] = jacobian[(i, 1)];
            system.jacobian[(i, 1)] = jacobian[(i, 2)] * primary;
            system.jacobian[(i, 2)] = jacobian[(i, 3)] * secondary;
        }
        system.residual[0] -= self.height;
        system.residual[1] -= point[0];
        system.jacobian[(1, 0)] -= 1.0;
        Ok(system)
    }
}

impl GrazingCurvePoint {
    /// The parameters (μ, η).
    pub fn parameters(&self) -> [f64; 2] {
        self.orbit.oscillator().parameters()
    }

    /// Whether neighbouring motion is forgotten within a period: a₁₂ and κ_p are then rounding, and
    /// nothing is resonant.
    pub fn is_forgotten(&self) -> bool {
        self.multipliers.forget(1)
    }

    /// The approximate angle, in radians, by which A turns over a length in z and the fractions of
    /// the ranges.
    ///
    /// A and its derivative along the curve are compared in units of x in which a₁₂ and a₂₁ are
    /// equally large. What is rounding does not turn.
    fn turn(&self, length: f64) -> f64 {
        if self.is_forgotten() {
            return 0.0;
        }
        let a = self.orbit.grazing_point().map.a;
        let change = self.orbit.derivative_along(&self.tangent) * length;
        let square = |i: usize, j: usize| a[(i, j)] * a[(i, j)] + change[(i, j)] * change[(i, j)];
        let unit = (square(1, 0) / square(0, 1)).sqrt();
        let size = |m: Matrix2<f64>| {
            let [p, q, r, s] = [m[(0, 0)], m[(0, 1)], m[(1, 0)], m[(1, 1)]];
            p * p + s * s + q * q * unit + r * r / unit
        };
        // NaN where nothing turns, which requires no points in between.
        (size(change) / size(a)).sqrt()
    }
}

impl GrazingEquations<'_> {
    fn oscillator_at(&self, point: &Vector3<f64>) -> AnyOscillator {
        self.scope.oscillator_at(self.oscillator, [point[1], point[2]])
    }

    /// The unit tangent at a point of the curve, in the direction closer to `onwards`.
    fn tangent(&self, point: &Vector3<f64>, onwards: &Vector3<f64>) -> Option<Vector3<f64>> {
        let jacobian = self.evaluate(point, &mut None).ok()?.jacobian;
        let across = jacobian.row(0).transpose().cross(&jacobian.row(1).transpose());
        let tangent = across.try_normalize(0.0)?;
        Some(if tangent.dot(onwards) < 0.0 { -tangent } else { tangent })
    }

    /// The states at the points, and at more points between them where A turns far from one to the
    /// next.
    fn states(&self, points: &[Tangent<Vector3<f64>>]) -> Vec<GrazingCurvePoint> {
        let mut states: Vec<GrazingCurvePoint> = Vec::with_capacity(points.len());
        for (point, tangent) in points {
            let Some(state) = self.state(point, tangent) else { continue };
            if let Some(last) = states.pop() {
                self.fill(last, &state, HALVINGS, &mut states);
            }
            states.push(state);
        }
        states
    }

    /// Adds a point and the points between it and the next.
    fn fill(
        &self,
        from: GrazingCurvePoint,
        to: &GrazingCurvePoint,
        halvings: u32,
        states: &mut Vec<GrazingCurvePoint>,
    ) {
        let gap = self.scope.place(&to.orbit) - self.scope.place(&from.orbit);
        let turn = from.turn(gap.norm()).max(to.turn(gap.norm()));
        let nearby = || Self { passage: from.orbit.passage().clone(), ..*self };
        let middle = if turn > TURN && halvings > 0 { nearby().middle(&from, &gap) } else { None };
        let Some(middle) = middle else { return states.push(from) };
        self.fill(from, &middle, halvings - 1, states);
        self.fill(middle, to, halvings - 1, states);
    }

    /// The point of the curve half-way on from a point.
    fn middle(&self, from: &GrazingCurvePoint, gap: &Vector3<f64>) -> Option<GrazingCurvePoint> {
        let half = self.scope.place(&from.orbit) + gap * 0.5;
        let point = across(self, half, gap, &half)?.point;
        if (point - half).norm() > 0.5 * gap.norm() {
            return None;
        }
        self.state(&point, &self.tangent(&point, gap)?)
    }

    /// The end of the curve before a point without a state.
    fn end_without_state(&self, point: &Vector3<f64>) -> GrazingEnd {
        let acceleration = self.oscillator_at(point).acceleration(State::at_rest(0.0, point[0]));
        if acceleration.is_nan() {
            return WalkEnd::Stopped;
        }
        let cause = self.evaluate(point, &mut None).err().unwrap_or(MapError::NotAMaximum { acceleration });
        WalkEnd::Stalled(Stall { step: 0.0, failure: NewtonFailure::Undefined { iteration: 1, cause } })
    }

    /// The grazing orbit at a point; `None` where P_global has no second derivatives.
    fn orbit(&self, point: &Vector3<f64>) -> Option<GrazingOrbit> {
        GrazingOrbit::through(self.oscillator_at(point), point[0], self.passage.clone()).ok()
    }

    /// The state at a point; `None` where P_global has no second derivatives, or motion is not
    /// turned back from the wall.
    fn state(&self, point: &Vector3<f64>, tangent: &Vector3<f64>) -> Option<GrazingCurvePoint> {
        let mut orbit = self.orbit(point)?;
        let admissible = |orbit: &GrazingOrbit| match orbit.impacts() {
            [] => {
                let (top, oscillator) = (HighestPoint::of(orbit), orbit.oscillator());
                top.is_highest(oscillator) && top.is_clear_of_other_stop(oscillator)
            }
            _ => orbit.ceiling() <= PeriodicSolution::TOUCH,
        };
        // In wide ranges the last digits of a fraction may appear as a difference in the next
        // maximum, which is the same one.
        if !admissible(&orbit) {
            let (there, passage) = (orbit.oscillator(), orbit.passage().clone());
            orbit = GrazingOrbit::along(there, orbit.phase(), passage).unwrap_or(orbit);
        }
        let GrazingPoint { gamma, .. } = orbit.grazing_point();
        let [primary, secondary] = self.scope.window.widths();
        let admissible = admissible(&orbit);
        // At the limit of integration steps there are no values, and earlier ones are uncertain.
        let multipliers = match orbit.impacts() {
            [] => multipliers(orbit.oscillator(), orbit.phase()),
            _ => {
                let map = orbit.grazing_point().map;
                Multipliers { trace: map.trace(), determinant: map.determinant() }
            }
        };
        (gamma > 0.0 && multipliers.trace.is_finite()).then(|| GrazingCurvePoint {
            tangent: Vector3::new(tangent[0], tangent[1] * primary, tangent[2] * secondary),
            multipliers,
            admissible,
            orbit,
        })
    }
}

/// The multipliers of the grazing orbit with this phase, with the wall ignored, from the flow over a period: the
/// entries of P_global's derivative grow as 1/γ.
pub(crate) fn multipliers(oscillator: &AnyOscillator, phase: f64) -> Multipliers {
    let flow = oscillator.flow::<1>(State::at_rest(0.0, phase), oscillator.forcing_period());
    let derivative = flow.jacobian.fixed_columns::<2>(0);
    Multipliers { trace: derivative.trace(), determinant: derivative.determinant() }
}
