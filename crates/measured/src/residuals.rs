//! Residuals of measurements: distances from curves, and from orbits.
//!
//! The residual of a bifurcation is its distance in standard errors from the nearest point of the curve
//! of its kind. The residuals of a series of impacts are those of times and speeds on the orbit that
//! begins with the first impact; the true time and speed of that impact are unknowns as well, so an error
//! in one impact is not counted again in the next.

use grazing_continuation::arclength::CurveEquations;
use grazing_continuation::curve::{SolutionCurve, Window};
use grazing_continuation::mps::{Formulation, LoopEquations, Unknowns, unknown};
use grazing_continuation::newton;
use grazing_model::maps::MapError;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{AnyOscillator, ImpactOscillator, OnWall, State};
use grazing_unfold::non_impacting;
use thiserror::Error;

use crate::associate::{Located, Solutions};

/// Consecutive impacts, dimensionless.
#[derive(Clone, Debug)]
pub struct Segment {
    /// Primary and secondary parameter.
    pub at: [f64; 2],
    /// The line of the file and the stop that is hit, of each impact: 0 for that at x = 0, 1 for the other of two. Between two
    /// walls one more may follow, of the next impact, which must hit its stop as well.
    pub struck: Vec<(u32, usize)>,
    /// Time, speed before and speed after each impact; a quantity that was not measured is NaN.
    pub impacts: Vec<[f64; 3]>,
    /// The standard errors of time, speed before and speed after; NaN where none is stated.
    pub errors: Vec<[f64; 3]>,
    /// The standard errors that are assumed where none is stated.
    pub assumed: [f64; 3],
}

/// A measured datum.
#[derive(Clone, Debug)]
pub enum Datum {
    /// A bifurcation in the parameter plane.
    Bifurcation(Box<Located>),
    /// A series of impacts.
    Impacts(Segment),
}

/// The reason why a datum cannot be computed.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum Missing {
    /// There is no such impact, or no such curve.
    #[error(
        "the constants in the file give no such result: start from other constants with --set, or leave the line out"
    )]
    Result,
    /// The motion from the impact before hits the other wall first.
    #[error(
        "the motion from the impact before hits wall {0} first: is the wall right here and there, and is no impact missing? Otherwise start from other constants with --set, or leave the line out"
    )]
    AtWall(usize),
}

/// The residuals of a datum in standard errors and, for a bifurcation, the point of the curve with the
/// direction.
pub(crate) type Residuals = (Vec<f64>, Option<[Unknowns; 2]>);

/// The greatest number of steps towards the nearest point of a curve.
const MOST_STEPS: usize = 60;
/// Accuracy of the nearest point of a curve, as a fraction of a standard error or of the distance; the
/// error of the distance is the square of this.
const FOOT: f64 = 1e-5;
/// The greatest number of evaluations of Newton's method, which usually takes five.
const EVALUATIONS: usize = 30;
/// The longest and the shortest step along a curve towards the nearest point, dimensionless.
const LONGEST: f64 = 0.1;
const SHORTEST: f64 = 1e-9;
/// A solution farther than this (dimensionless) from the previous one is a different solution.
const ANOTHER: f64 = 0.5;

impl Datum {
    /// The line of the datum in the file; for a series, the first line.
    pub(crate) fn line(&self) -> u32 {
        match self {
            Self::Bifurcation(located) => located.line,
            Self::Impacts(segment) => segment.struck.first().map_or(0, |(line, _)| *line),
        }
    }

    /// The measured values of the unknowns that belong to this datum alone.
    pub(crate) fn own(&self) -> Vec<f64> {
        match self {
            Self::Bifurcation(_) => Vec::new(),
            Self::Impacts(segment) => segment.impacts[0][..2].to_vec(),
        }
    }

    /// Line and name of each residual, in the order of [`residuals`](Self::residuals).
    pub(crate) fn quantities(&self) -> Vec<(u32, String)> {
        match self {
            Self::Bifurcation(located) => vec![(located.line, located.quantity.clone())],
            Self::Impacts(segment) => {
                let names = ["time", "velocity_before", "velocity_after"];
                let of = |(impact, (line, _)): (&[f64; 3], &(u32, usize))| {
                    let known = impact.iter().zip(names).filter(|(value, _)| !value.is_nan());
                    known.map(|(_, name)| (*line, name.to_owned())).collect::<Vec<_>>()
                };
                segment.impacts.iter().zip(&segment.struck).flat_map(of).collect()
            }
        }
    }

    pub(crate) fn count(&self) -> usize {
        match self {
            Self::Bifurcation(_) => 1,
            Self::Impacts(segment) => segment.count(),
        }
    }

    /// The residuals of the datum in standard errors and, for a bifurcation, the solution on the curve.
    ///
    /// # Errors
    /// The line of what cannot be computed, and the reason.
    pub(crate) fn residuals(
        &self,
        oscillator: &AnyOscillator,
        window: Window,
        own: &[f64],
    ) -> Result<Residuals, (u32, Missing)> {
        match self {
            Self::Bifurcation(located) => {
                let found = located.foot(oscillator, window).ok_or((located.line, Missing::Result))?;
                Ok((vec![located.residual(&found)], Some(found)))
            }
            Self::Impacts(segment) => Ok((segment.residuals(oscillator, [own[0], own[1]])?, None)),
        }
    }
}

impl Located {
    /// The point of the curve nearest to the measured place, and the direction of the curve there.
    fn foot(&self, oscillator: &AnyOscillator, window: Window) -> Option<[Unknowns; 2]> {
        let Solutions { condition, loops, stops } = &self.of;
        let equations = match *loops {
            0 => non_impacting::equations(oscillator, window),
            loops => LoopEquations::new(oscillator.clone(), loops, Formulation::FixedPhase)
                .at_stops(stops.iter().copied()),
        };
        let curve = SolutionCurve { equations, condition: *condition };
        // Newton's method with steps of least norm; it also returns the direction of the curve at the
        // solution.
        let onto = |near: Unknowns, mut along: Unknowns| {
            let mut times = self.times.clone();
            let found = newton::solve(near, EVALUATIONS, |point| {
                let system = curve.evaluate(point, &mut times).map_err(Some)?;
                along = system.clone().bordered(0.0, &along).null_direction().ok_or(None)?;
                Ok::<_, Option<MapError>>(system.bordered(0.0, &along))
            });
            found.ok().map(|found| (found.point, along))
        };
        let [near, along] = self.near.clone();
        let (mut at, mut along) = onto(near.clone(), along)?;
        // The last step, and the remaining distance that was estimated before it.
        let mut last: Option<[f64; 2]> = None;
        for _ in 0..MOST_STEPS {
            let plane = [unknown::PRIMARY, unknown::SECONDARY].map(|place| along[place]);
            let plane = [0, 1].map(|k| plane[k] / self.metric.scales[k]);
            let (gap, square) = (self.gap(&at), plane[0] * plane[0] + plane[1] * plane[1]);
            let straight = -(gap[0] * plane[0] + gap[1] * plane[1]) / square;
            let least = FOOT * (1.0 + length(gap));
            if straight.abs() * square.sqrt() <= least {
                let near = (&at - near).norm() < ANOTHER;
                return near.then_some([at, along]);
            }
            // Where the curve bends, the distance along its tangent is too long or too short; the last
            // step shows by how much.
            let slope = last.map_or(-1.0, |[step, before]| (straight - before) / step);
            let mut step = if slope < 0.0 { -straight / slope } else { straight };
            step = step.clamp(-LONGEST, LONGEST);
            (at, along) = loop {
                match onto(&at + &along * step, along.clone()) {
                    Some(next) if length(self.gap(&next.0)) < length(gap) + least => break next,
                    _ if step.abs() < SHORTEST => return None,
                    _ => step *= 0.5,
                }
            };
            last = Some([step, straight]);
        }
        None
    }

    /// The difference from the measured place to a point, in standard errors.
    fn gap(&self, point: &Unknowns) -> [f64; 2] {
        self.metric.counted(self.at, [point[unknown::PRIMARY], point[unknown::SECONDARY]])
    }

    /// The distance from the curve, in standard errors, with a sign for the side.
    fn residual(&self, [at, along]: &[Unknowns; 2]) -> f64 {
        let [primary, secondary] = self.gap(at);
        let scales = self.metric.scales;
        let tangent = [along[unknown::PRIMARY] / scales[0], along[unknown::SECONDARY] / scales[1]];
        (tangent[0] * secondary - tangent[1] * primary) / length(tangent)
    }
}

fn length([one, other]: [f64; 2]) -> f64 {
    (one * one + other * other).sqrt()
}

impl Segment {
    /// The residuals of the series if the first impact has this time and speed.
    ///
    /// # Errors
    /// The line of the first impact that the motion does not have, or has at the other wall.
    fn residuals(
        &self,
        oscillator: &AnyOscillator,
        [time, speed]: [f64; 2],
    ) -> Result<Vec<f64>, (u32, Missing)> {
        let here = oscillator.with_parameters(self.at);
        let other = here.other_stop();
        let (line, stop) = self.struck[0];
        let first = State::on_wall(speed, here.forcing_frequency().value * time);
        let walls_meet = other.is_some() && here.gap(first.phase)[0].value <= 0.0;
        if !(speed > 0.0 && time.is_finite()) || walls_meet {
            return Err((line, Missing::Result));
        }
        // Twice the measured duration: anything later belongs to another orbit.
        let duration = self.impacts[self.impacts.len() - 1][0] - self.impacts[0][0];
        let horizon = 2.0 * duration + here.forcing_period();
        let flights = Orbit::from_stop(&here, (stop, first), horizon, self.struck.len());
        let hits = flights.filter_map(|flight| match flight.end {
            FlightEnd::Impact(state) => Some((flight.stop, flight.start + flight.duration, state)),
            FlightEnd::TimeIsUp(_) => None,
        });
        let mut hits = [(stop, 0.0, first)].into_iter().chain(hits);
        let mut left = Vec::with_capacity(self.count());
        for (index, &(line, stop)) in self.struck.iter().enumerate() {
            let measured = self.impacts.get(index).zip(self.errors.get(index));
            match (hits.next(), measured) {
                (Some((hit, ..)), _) if hit != stop => return Err((line, Missing::AtWall(hit + 1))),
                (Some((_, after, state)), Some((measured, errors))) => {
                    let seen = if stop == 0 { &here } else { other.as_ref().unwrap_or(&here) };
                    let recoil = seen.reset::<0>(OnWall::new(state.velocity, state.phase)).image();
                    let computed = [time + after, state.velocity, -recoil.velocity];
                    let numbers = (0..3).filter(|k| !measured[*k].is_nan());
                    let error = |k: usize| if errors[k].is_nan() { self.assumed[k] } else { errors[k] };
                    left.extend(numbers.map(|k| (computed[k] - measured[k]) / error(k)));
                }
                (None, Some(_)) => return Err((line, Missing::Result)),
                // The impact after the last one is not measured here, and may be missing.
                (_, None) => {}
            }
        }
        if left.iter().all(|value| value.is_finite()) { Ok(left) } else { Err((line, Missing::Result)) }
    }

    fn count(&self) -> usize {
        self.impacts.iter().flatten().filter(|value| !value.is_nan()).count()
    }
}
