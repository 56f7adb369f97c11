//! Resonances as one more parameter of the oscillator varies.
//!
//! A family is a list of oscillators that differ by the values of constants. Resonances of
//! neighbouring members belong together if continuation leads from one to the other: with c between
//! its values at the two members, (z, μ, η, c) lies on the curve
//!
//! ```text
//! P_global(0, z; μ, η, c) = (0, z),   a₁₂ = 0 (p = 1) or κ_p = 0 (p ≥ 2),
//! ```
//!
//! which is followed by arclength, so that it may turn back in c: there a₁₂' or κ_p' vanishes and
//! two resonances are one. Where another quantity in the hypotheses of Theorem 2.4 or 2.5 is zero,
//! the resonance is degenerate: c_SN is infinite where s_p⁺ is zero, c_PD where s_p⁻ is, both where
//! β is. A quantity may change its sign there, or touch zero from one side, as does s_p⁺ = −(1 −
//! ϵE_p)² of the linear oscillator.

use core::f64::consts::TAU;

use grazing_continuation::arclength::{Continuation, CurveEquations, StepControl, across};
use grazing_continuation::mps::PeriodicSolution;
use grazing_continuation::newton::Linearisation;
use grazing_continuation::regula_falsi::zero_between;
use grazing_model::motion::Motion;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_theorems::from_map::{GrazingOrbit, GrazingOrbitError};
use grazing_theorems::hypothesis::{Hypothesis, ImposedCondition, Quantity};
use grazing_theorems::{ResonantGrazing, ResonantPoint};
use nalgebra::{Matrix4, Vector3, Vector4};

use crate::resonances::FoundResonance;
use crate::tolerances::BETWEEN_RESONANCES;
use crate::window_edge::on_the_edge;
use crate::{Diagram, Scope};

/// The oscillator at a fraction of the way from one member to the next, with arbitrary primary and
/// secondary parameters; `None` where it does not exist.
pub type Between<'a> = &'a (dyn Fn(f64) -> Option<AnyOscillator> + Sync);

/// A resonance followed from one member towards another.
#[derive(Clone, Debug)]
pub struct Arc {
    /// The index of the resonance in the member's list.
    pub resonance: usize,
    /// The resonance along the way, the first point at the member itself.
    pub points: Vec<ArcPoint>,
    /// The end of the arc.
    pub end: ArcEnd,
}

/// A resonance on the way from one member to another.
#[derive(Clone, Debug)]
pub struct ArcPoint {
    /// The fraction of the way.
    pub way: f64,
    /// The grazing orbit.
    pub orbit: GrazingOrbit,
    /// The quantities to which the theorem applies.
    pub point: ResonantPoint,
    /// A quantity in the theorem's hypotheses that is zero here: the resonance is degenerate.
    pub zero: Option<Quantity>,
}

/// The end of a resonance that is followed from one member towards another.
#[derive(Clone, Debug, PartialEq)]
pub enum ArcEnd {
    /// The resonance reaches the other member.
    Across,
    /// The resonance turns back to its own member, as the resonance with this index in the list, if
    /// that is known.
    Back(Option<usize>),
    /// The resonance leaves the ranges of the parameters.
    LeftWindow,
    /// Another maximum of the grazing orbit touches the wall.
    Inadmissible,
    /// No further point was found.
    Lost(String),
}

/// Fraction of a period: a maximum nearer than this to that at the wall is that one.
const AT_WALL: f64 = 1e-4;
/// Steps in z (radians), the fractions of both ranges and the fraction of the way; coefficients,
/// which are drawn, may bend where the curve does not.
const STEPS: StepControl =
    StepControl { first: 0.02, longest: 0.08, shortest: 1e-5, turn: 0.05, ..StepControl::DRAWING };
/// A curve with this many points between two members is abandoned.
const STEP_LIMIT: usize = 2_000;
/// Differences in the fraction of the way for the derivative with respect to it, which affects only
/// the direction of steps: its error, the square of this and a rounding over it, is no larger than
/// 1e-9.
const DIFFERENCE: f64 = 1e-5;
/// Length, on either side, of the differences that give rates of change along the curve. Values are
/// right to 1e-13, and so rates to 1e-10; the location of a zero of a rate is off by the square of
/// this.
const RATE: f64 = 1e-3;
/// A quantity touches zero where its least modulus is this fraction of the values at both ends, or
/// a rounding of terms of order one: the square of that error in its location is less.
const DOUBLE_ZERO: f64 = 1e-9;
const ROUNDING: f64 = 1e-12;
/// A zero is located when this fraction of the values at both ends remains; where more than the
/// second fraction remains the quantity has a pole.
const ZERO: f64 = 1e-11;
const POLE: f64 = 1e-6;

/// The resonances of a member, followed towards another. An arc that turns back to its own member
/// is listed once.
pub fn arcs(diagram: &Diagram, between: Between<'_>) -> Vec<Arc> {
    let followed = diagram.resonances.iter().enumerate().filter_map(|(index, resonance)| {
        let path = Path { between, scope: &diagram.scope, loops: resonance.loops };
        let arc = path.follow(index, resonance, &diagram.resonances)?;
        // The same path in the opposite direction belongs to the other resonance.
        (!matches!(arc.end, ArcEnd::Back(Some(other)) if other < index)).then_some(arc)
    });
    followed.collect()
}

/// The path of one resonance.
struct Path<'a> {
    between: Between<'a>,
    scope: &'a Scope,
    loops: u32,
}

impl CurveEquations for Path<'_> {
    type Point = Vector4<f64>;
    type Carried = ();
    type Failure = Missing;

    fn evaluate(&self, point: &Vector4<f64>, (): &mut ()) -> Result<Linearisation<Vector4<f64>>, Missing> {
        let orbit = self.orbit(point)?;
        let map = orbit.map();
        let widths = self.scope.window.widths();
        let mut system = Linearisation { residual: Vector4::zeros(), jacobian: Matrix4::zeros() };
        system.residual.fixed_rows_mut::<3>(0).copy_from(&self.residual(&orbit, point[0]));
        for (column, width) in [1.0, widths[0], widths[1]].into_iter().enumerate() {
            let along = Vector3::ith(column, width);
            for row in 0..2 {
                system.jacobian[(row, column)] = map.jacobian[(row, column + 1)] * width;
            }
            let [_, rate] = orbit.detuning(self.loops, &orbit.derivative_along(&along));
            system.jacobian[(2, column)] = rate;
        }
        system.jacobian[(1, 0)] -= 1.0;
        let aside = |step: f64| {
            let aside = point + Vector4::ith(3, step);
            Ok::<_, Missing>(self.residual(&self.orbit(&aside)?, point[0]))
        };
        let slope = (aside(DIFFERENCE)? - aside(-DIFFERENCE)?) / (2.0 * DIFFERENCE);
        system.jacobian.fixed_view_mut::<3, 1>(0, 3).copy_from(&slope);
        Ok(system)
    }
}

/// The reason why nothing can be evaluated at a point.
#[derive(Clone, Copy, Debug, thiserror::Error)]
enum Missing {
    #[error("there is no such oscillator")]
    Oscillator,
    #[error(transparent)]
    Orbit(#[from] GrazingOrbitError),
}

/// A point of the curve, as z, the fractions of both ranges and the fraction of the way.
type Coordinates = Vector4<f64>;

impl Path<'_> {
    fn orbit(&self, point: &Coordinates) -> Result<GrazingOrbit, Missing> {
        let oscillator = (self.between)(point[3]).ok_or(Missing::Oscillator)?;
        Ok(GrazingOrbit::at(self.scope.oscillator_at(&oscillator, [point[1], point[2]]), point[0])?)
    }

    /// The functions that vanish at a resonance.
    fn residual(&self, orbit: &GrazingOrbit, phase: f64) -> Vector3<f64> {
        let value = orbit.map().value;
        let [detuning, _] = orbit.detuning(self.loops, &Default::default());
        Vector3::new(value[0], value[1] - phase, detuning)
    }

    fn at(&self, point: &Coordinates) -> Option<ArcPoint> {
        let orbit = self.orbit(point).ok()?;
        let resonant = orbit.resonant_point(self.loops).ok()?;
        Some(ArcPoint { way: point[3], orbit, point: resonant, zero: None })
    }

    /// The zero of a function of the point, which has these values at the ends of a chord; `None`
    /// at a pole.
    fn zero(
        &self,
        [from, to]: [&Coordinates; 2],
        values: [f64; 2],
        function: impl Fn(&Coordinates) -> Option<f64>,
    ) -> Option<Coordinates> {
        let (chord, size) = (to - from, values[0].abs() + values[1].abs());
        let at = |share: f64| {
            let near = from + chord * share;
            let point = across(self, near, &chord, &near).ok_or(())?.point;
            let value = function(&point).ok_or(())?;
            Ok::<_, ()>(((point, value), value))
        };
        let (point, value) = zero_between(values, at, |_, value| value.abs() <= ZERO * size).ok()?;
        (value.abs() <= POLE * size).then_some(point)
    }

    fn follow(&self, index: usize, resonance: &FoundResonance, all: &[FoundResonance]) -> Option<Arc> {
        let orbit = resonance.located.orbit();
        let place = self.scope.place(orbit);
        let start = Vector4::new(place[0], place[1], place[2], 0.0);
        let point = *resonance.located.resonant_point();
        let mut arc = Arc {
            resonance: index,
            points: vec![ArcPoint { way: 0.0, orbit: orbit.clone(), point, zero: None }],
            end: ArcEnd::Lost("it turns without an end".to_owned()),
        };
        let mut walker = match Continuation::new(self, STEPS, start, Vector4::w(), ()) {
            Ok(walker) => walker,
            Err(stall) => {
                arc.end = ArcEnd::Lost(stall.to_string());
                return Some(arc);
            }
        };
        let mut known = self.known(&start, &walker.here().tangent)?;
        for _ in 0..STEP_LIMIT {
            let before = walker.here().point;
            let (after, tangent) = match walker.advance() {
                Ok(station) => (station.point, station.tangent),
                Err(stall) => {
                    arc.end = ArcEnd::Lost(stall.to_string());
                    return Some(arc);
                }
            };
            let (mut after, mut end) = match self.leaves(&before, &after) {
                Some((edge, end)) => (edge, Some(end)),
                None => (after, None),
            };
            let heights = [self.height(&before)?, self.height(&after)?];
            if heights[1] > PeriodicSolution::TOUCH {
                let touching = self.zero([&before, &after], heights, |point| self.height(point));
                (after, end) = (touching.unwrap_or(before), Some(ArcEnd::Inadmissible));
            }
            let (Some(next), Some(known_next)) = (self.at(&after), self.known(&after, &tangent)) else {
                arc.end = ArcEnd::Lost("the map has no second derivatives there".to_owned());
                return Some(arc);
            };
            arc.points.extend(self.degenerate([&before, &after], [&known, &known_next]));
            arc.points.push(next);
            known = known_next;
            if let Some(end) = end {
                arc.end = match end {
                    ArcEnd::Back(_) => {
                        let home = |other: &FoundResonance| {
                            other.loops == self.loops && self.same(&after, other.located.orbit())
                        };
                        ArcEnd::Back(all.iter().position(home))
                    }
                    other => other,
                };
                return Some(arc);
            }
        }
        Some(arc)
    }

    fn same(&self, place: &Coordinates, orbit: &GrazingOrbit) -> bool {
        let mut gap = self.scope.place(orbit) - place.fixed_rows::<3>(0);
        gap[0] = libm::remainder(gap[0], TAU);
        gap.norm() < BETWEEN_RESONANCES
    }

    /// The point at which the curve leaves the ranges, or reaches either member, between two of its
    /// points, if it does.
    fn leaves(&self, before: &Coordinates, after: &Coordinates) -> Option<(Coordinates, ArcEnd)> {
        let (point, unknown) = on_the_edge(self, [1, 2, 3], [before, after])?;
        let end = match (unknown, point[unknown]) {
            (3, 1.0) => ArcEnd::Across,
            (3, _) => ArcEnd::Back(None),
            _ => ArcEnd::LeftWindow,
        };
        Some((point, end))
    }

    /// The highest maximum of the grazing orbit other than that at the wall; far below it if there
    /// is none.
    fn height(&self, point: &Coordinates) -> Option<f64> {
        let orbit = self.orbit(point).ok()?;
        let oscillator = orbit.oscillator();
        let motion = oscillator.motion(State::on_wall(0.0, orbit.phase()));
        // The maximum at the wall recurs after a period, a little sooner perhaps by rounding.
        let horizon = (1.0 - AT_WALL) * oscillator.forcing_period();
        Some(motion.highest_maximum(horizon).map_or(-1.0, |maximum| maximum.position))
    }

    /// The quantities in the theorem's hypotheses at a point with a tangent.
    fn known(&self, place: &Coordinates, tangent: &Coordinates) -> Option<Vec<QuantityTrend>> {
        let at = |step: f64| Some(asked(&self.at(&(place + tangent * step))?.point));
        let (here, before, after) = (at(0.0)?, at(-RATE)?, at(RATE)?);
        let known = |asked: &Hypothesis| {
            let quantity = asked.quantity;
            let rate = value_of(&after, quantity)? - value_of(&before, quantity)?;
            Some(QuantityTrend { quantity, value: asked.value, rate })
        };
        Some(here.iter().filter_map(known).collect())
    }

    /// The degenerate resonances between two points of the curve.
    fn degenerate(&self, ends: [&Coordinates; 2], known: [&[QuantityTrend]; 2]) -> Vec<ArcPoint> {
        let chord = ends[1] - ends[0];
        let mut found: Vec<(f64, ArcPoint)> = known[0]
            .iter()
            .filter_map(|from| {
                let quantity = from.quantity;
                let to = known[1].iter().find(|to| to.quantity == quantity)?;
                let value = |point: &Coordinates| value_of(&asked(&self.at(point)?.point), quantity);
                let zero = if from.value * to.value < 0.0 {
                    self.zero(ends, [from.value, to.value], value)?
                } else if from.falls(chord.norm()) && to.falls(-chord.norm()) {
                    let beside = |point: &Coordinates, share: f64| {
                        let near = point + chord * share;
                        value(&across(self, near, &chord, &near)?.point)
                    };
                    let step = RATE / chord.norm();
                    let rate = |point: &Coordinates| Some(beside(point, step)? - beside(point, -step)?);
                    let least = self.zero(ends, [from.rate, to.rate], rate)?;
                    let zero = DOUBLE_ZERO * (from.value.abs() + to.value.abs()) + ROUNDING;
                    Some(least).filter(|least| value(least).is_some_and(|value| value.abs() <= zero))?
                } else {
                    return None;
                };
                Some((chord.dot(&zero), ArcPoint { zero: Some(quantity), ..self.at(&zero)? }))
            })
            .collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        found.into_iter().map(|(_, point)| point).collect()
    }
}

/// A quantity at a point of the curve, and its change there from one side to the other.
struct QuantityTrend {
    quantity: Quantity,
    value: f64,
    rate: f64,
}

impl QuantityTrend {
    /// Whether the quantity, extrapolated linearly, would be zero within a distance `length`
    /// onwards: a quantity that touches zero falls twice as fast.
    fn falls(&self, length: f64) -> bool {
        self.value * self.rate * length < 0.0 && (self.rate * length).abs() > 2.0 * RATE * self.value.abs()
    }
}

/// The quantities whose zeros are of interest: all that must be positive, or non-zero.
fn asked(point: &ResonantPoint) -> Vec<Hypothesis> {
    let mut hypotheses = match ResonantGrazing::check(point, f64::INFINITY) {
        Ok(theorem) => theorem.hypotheses().to_vec(),
        Err(violated) => violated.hypotheses,
    };
    hypotheses
        .retain(|asked| matches!(asked.condition, ImposedCondition::Positive | ImposedCondition::NonZero));
    hypotheses
}

/// The value of one of the quantities.
fn value_of(asked: &[Hypothesis], quantity: Quantity) -> Option<f64> {
    Some(asked.iter().find(|asked| asked.quantity == quantity)?.value)
}
