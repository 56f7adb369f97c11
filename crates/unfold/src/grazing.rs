//! Curves of grazing bifurcations of the non-impacting solution in the plane of both parameters.
//!
//! The grazing orbit is a zero of P_global(0, z; μ, η) − (0, z) in (z, μ, η): a curve, followed by arclength with folds in μ and
//! η passed like any other point. Paper: Assumption 2.2, made true by the change of parameter μ ↦ μ − μ_graz(η).

use grazing_continuation::arclength::{Continuation, CurveEquations, Stall, StepControl};
use grazing_continuation::mps::MaximalPeriodicSolution;
use grazing_continuation::newton::{self, Linearisation};
use grazing_model::maps::{MapError, global_map};
use grazing_model::motion::highest_maximum;
use grazing_model::{ImpactOscillator, State};
use grazing_theorems::from_map::GrazingOrbit;
use grazing_theorems::spectrum::in_trapesium;
use nalgebra::{Matrix3, Vector3};

use crate::Scope;

/// A point of a grazing curve.
#[derive(Clone, Debug)]
pub struct GrazingState<O> {
    /// The grazing orbit, with P_global to second order.
    pub orbit: GrazingOrbit<O>,
    /// The curve's tangent (z, μ, η) there, not normalised.
    pub tangent: Vector3<f64>,
    /// Inside the trapesium: without the wall the orbit is asymptotically stable.
    pub stable: bool,
    /// No other maximum of the orbit lies above the wall.
    pub admissible: bool,
}

/// How a grazing curve ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GrazingEnd {
    /// It leaves the ranges of the parameters.
    LeftWindow,
    /// It is closed: the last point is the first.
    Closed,
    /// No further point was found, as where the deceleration at the wall vanishes.
    Stalled(Stall<MapError>),
    /// The step limit was reached.
    StepLimit,
}

/// A connected piece of the curve of grazing bifurcations.
#[derive(Clone, Debug)]
pub struct GrazingCurve<O> {
    /// Its points in order; η is less at the first than at the last.
    pub states: Vec<GrazingState<O>>,
    /// How it ends before the first point and after the last.
    pub ends: [GrazingEnd; 2],
}

/// Steps in z (radians) and the shares of both ranges, short enough for the resonances between to be told apart.
const STEPS: StepControl = StepControl { first: 1e-3, longest: 0.01, shortest: 1e-6, turn: 0.035 };
/// A curve of this many points goes nowhere.
const STEP_LIMIT: usize = 20_000;

impl<O: ImpactOscillator> GrazingCurve<O> {
    /// The curve through a grazing orbit, followed to both sides until it leaves the ranges.
    ///
    /// # Errors
    /// The curve has no unique tangent at the orbit.
    pub fn through(orbit: &GrazingOrbit<O>, scope: &Scope) -> Result<Self, Stall<MapError>> {
        let equations = GrazingEquations { oscillator: orbit.oscillator(), scope };
        let shares = scope.shares(orbit.oscillator().parameters());
        let start = Vector3::new(orbit.phase(), shares[0], shares[1]);
        let onwards = Vector3::new(0.0, 0.0, 1.0);
        let (mut points, last) = equations.follow(start, onwards)?;
        let mut ends = [last, last];
        if last != GrazingEnd::Closed {
            let (mut back, first) = equations.follow(start, -onwards)?;
            // The start stands in both; tangents point onwards.
            back.reverse();
            back.pop();
            back.iter_mut().for_each(|(_, tangent)| *tangent = -*tangent);
            back.append(&mut points);
            (points, ends[0]) = (back, first);
        }
        if let [(first, _), .., (last, _)] = points.as_slice()
            && first[2] > last[2]
        {
            points.reverse();
            points.iter_mut().for_each(|(_, tangent)| *tangent = -*tangent);
            ends.reverse();
        }
        let states = points.iter().filter_map(|(point, tangent)| equations.state(point, tangent)).collect();
        Ok(Self { states, ends })
    }

    /// The parameters (μ, η) along the curve.
    pub fn parameters(&self) -> impl Iterator<Item = [f64; 2]> {
        self.states.iter().map(|state| state.orbit.oscillator().parameters())
    }

    /// The first grazing orbit of the curve at a value of η, if it comes there.
    pub fn at(&self, secondary: f64) -> Option<GrazingOrbit<O>> {
        let parameters = |state: &GrazingState<O>| state.orbit.oscillator().parameters();
        let pair = self.states.windows(2).find(|pair| {
            let [a, b] = [parameters(&pair[0])[1], parameters(&pair[1])[1]];
            a.min(b) <= secondary && secondary <= a.max(b)
        })?;
        between(pair, secondary)
    }

    /// Whether the curve passes through a grazing orbit.
    pub fn passes(&self, orbit: &GrazingOrbit<O>, scope: &Scope) -> bool {
        let place = |orbit: &GrazingOrbit<O>| {
            let shares = scope.shares(orbit.oscillator().parameters());
            Vector3::new(libm::sin(orbit.phase()), shares[0], shares[1])
        };
        let target = place(orbit);
        self.states.windows(2).any(|pair| {
            let [a, b] = [place(&pair[0].orbit), place(&pair[1].orbit)];
            let along = (target - a).dot(&(b - a)) / (b - a).norm_squared();
            (-ENDS..=1.0 + ENDS).contains(&along) && (a + (b - a) * along - target).norm() < CHORD
        })
    }
}

/// The grazing orbit at a value of η between those of two neighbouring points of a curve.
pub(crate) fn between<O: ImpactOscillator>(
    neighbours: &[GrazingState<O>],
    secondary: f64,
) -> Option<GrazingOrbit<O>> {
    let [first, last] = [neighbours.first()?, neighbours.last()?].map(|state| &state.orbit);
    let [[a, from], [b, to]] = [first, last].map(|orbit| orbit.oscillator().parameters());
    let way = if to == from { 0.0 } else { (secondary - from) / (to - from) };
    let near = first.oscillator().with_parameters([a + (b - a) * way, secondary]);
    GrazingOrbit::find(&near, first.phase() + (last.phase() - first.phase()) * way).ok()
}

/// A point of the curve lies no farther than this from the chord between two neighbours: an eighth of the longest step times
/// the angle by which the tangent turns, several times over.
const CHORD: f64 = 3e-4;

/// An orbit on the edge of the ranges lies at the end of the curve, give or take rounding.
const ENDS: f64 = 1e-6;

/// The equations of the curve: unknowns are z and the shares of the ranges of μ and η.
struct GrazingEquations<'a, O> {
    oscillator: &'a O,
    scope: &'a Scope,
}

type Points = Vec<(Vector3<f64>, Vector3<f64>)>;

impl<O: ImpactOscillator> CurveEquations<3> for GrazingEquations<'_, O> {
    /// The return time of P_global.
    type Memory = Option<f64>;
    type Failure = MapError;

    fn evaluate(&self, point: &Vector3<f64>, time: &mut Option<f64>) -> Result<Linearisation<3>, MapError> {
        let oscillator = self.oscillator_at(point);
        let landing = global_map::<O, 1>(&oscillator, 0.0, point[0], *time)?;
        *time = Some(landing.time);
        let [primary, secondary] = self.scope.widths();
        let jacobian = landing.jet.jacobian;
        let mut system = Linearisation { residual: Vector3::zeros(), jacobian: Matrix3::zeros() };
        for i in 0..2 {
            system.residual[i] = landing.jet.value[i];
            system.jacobian[(i, 0)] = jacobian[(i, 1)];
            system.jacobian[(i, 1)] = jacobian[(i, 2)] * primary;
            system.jacobian[(i, 2)] = jacobian[(i, 3)] * secondary;
        }
        system.residual[1] -= point[0];
        system.jacobian[(1, 0)] -= 1.0;
        Ok(system)
    }
}

impl<O: ImpactOscillator> GrazingEquations<'_, O> {
    fn oscillator_at(&self, point: &Vector3<f64>) -> O {
        self.scope.oscillator_at(self.oscillator, [point[1], point[2]])
    }

    /// Points with tangents from `start` to the side of `direction`, and how they end.
    fn follow(
        &self,
        start: Vector3<f64>,
        direction: Vector3<f64>,
    ) -> Result<(Points, GrazingEnd), Stall<MapError>> {
        let mut walker = Continuation::new(self, STEPS, start, direction, None)?;
        let mut points = vec![(start, walker.here().tangent)];
        while points.len() < STEP_LIMIT {
            let station = match walker.advance() {
                Ok(station) => station,
                Err(stall) => return Ok((points, GrazingEnd::Stalled(stall))),
            };
            let (point, tangent) = (station.point, station.tangent);
            if let Some(edge) = self.on_the_edge(&points[points.len() - 1].0, &point) {
                points.push((edge, tangent));
                return Ok((points, GrazingEnd::LeftWindow));
            }
            points.push((point, tangent));
            if points.len() > 10 && self.is_back(&start, &point) {
                return Ok((points, GrazingEnd::Closed));
            }
        }
        Ok((points, GrazingEnd::StepLimit))
    }

    /// The curve has come back to its start, within a step.
    fn is_back(&self, start: &Vector3<f64>, point: &Vector3<f64>) -> bool {
        let mut gap = point - start;
        gap[0] = libm::remainder(gap[0], core::f64::consts::TAU);
        gap.norm() < 0.5 * STEPS.longest
    }

    /// The point at which the curve leaves the ranges between two of its points, if it does.
    fn on_the_edge(&self, inside: &Vector3<f64>, outside: &Vector3<f64>) -> Option<Vector3<f64>> {
        let crossed = [1, 2].into_iter().filter_map(|share| {
            let edge = if outside[share] < 0.0 {
                0.0
            } else if outside[share] > 1.0 {
                1.0
            } else {
                return None;
            };
            let way = (edge - inside[share]) / (outside[share] - inside[share]);
            Some((way, share, edge))
        });
        let (way, share, edge) = crossed.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let mut time = None;
        let located = newton::solve(inside + (outside - inside) * way, 20, |point| {
            let mut system = self.evaluate(point, &mut time)?;
            system.residual[2] = point[share] - edge;
            system.jacobian[(2, share)] = 1.0;
            Ok::<_, MapError>(system)
        });
        let mut point = located.map_or(*outside, |solution| solution.point);
        point[share] = edge;
        Some(point)
    }

    /// All that is known at a point; nothing where P_global has no second derivatives.
    fn state(&self, point: &Vector3<f64>, tangent: &Vector3<f64>) -> Option<GrazingState<O>> {
        let orbit = GrazingOrbit::at(self.oscillator_at(point), point[0]).ok()?;
        let oscillator = orbit.oscillator();
        let map = orbit.grazing_point().map;
        let motion = oscillator.motion(State::on_wall(0.0, point[0]));
        let ceiling = highest_maximum(&motion, oscillator.forcing_period());
        let [primary, secondary] = self.scope.widths();
        Some(GrazingState {
            tangent: Vector3::new(tangent[0], tangent[1] * primary, tangent[2] * secondary),
            stable: in_trapesium(map.trace(), map.determinant()),
            admissible: ceiling.is_none_or(|maximum| maximum.position <= MaximalPeriodicSolution::TOUCH),
            orbit,
        })
    }
}
