//! Least squares: constants of an oscillator for which curves run through measured bifurcations,
//! and orbits through measured impacts.
//!
//! What is left of a bifurcation is its distance from the curve of its kind, in standard errors,
//! in which the nearest place of the curve is looked for as well. What is left of a series of impacts are times and speeds of the orbit that begins
//! with its first impact, whose true time and speed are unknowns as well; so no error of one
//! impact counts as one of the next. The method is that of Levenberg and Marquardt (MINPACK's, by
//! way of CMPFIT); the covariance is that of the linearised problem, (JᵀJ)⁻¹.

use grazing_continuation::arclength::CurveEquations;
use grazing_continuation::curve::{SolutionCurve, Window};
use grazing_continuation::mps::{Formulation, LoopEquations, Unknowns, unknown};
use grazing_continuation::newton;
use grazing_model::maps::MapError;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{AnyOscillator, ImpactOscillator, OnWall, State};
use grazing_unfold::non_impacting;
use rayon::prelude::*;
use rmpfit::{MPConfig, MPError, MPFitter, MPPar, MPResult, MPSide, MPSuccess};
use thiserror::Error;

use crate::associate::Located;

/// The oscillator with these values of the constants, without dimensions, in units that do not
/// depend on them; none where it does not exist.
pub type Rig<'a> = &'a (dyn Fn(&[f64]) -> Option<AnyOscillator> + Sync);

/// Impacts that follow each other, without dimensions.
#[derive(Clone, Debug)]
pub struct Segment {
    /// Primary and secondary parameter.
    pub at: [f64; 2],
    /// The lines of the file.
    pub lines: Vec<u32>,
    /// Time, speed before and speed after; what was not measured is not a number.
    pub impacts: Vec<[f64; 3]>,
    /// The standard errors of these.
    pub errors: Vec<[f64; 3]>,
}

/// What is measured.
#[derive(Clone, Debug)]
pub enum Datum {
    /// A bifurcation.
    Bifurcation(Box<Located>),
    /// Impacts.
    Impacts(Segment),
}

/// The constants with the least sum of squares.
#[derive(Clone, Debug)]
pub struct Fit {
    /// Their values.
    pub values: Vec<f64>,
    /// Their covariance.
    pub covariance: Vec<Vec<f64>>,
    /// The sum of squares.
    pub chi_squared: f64,
    /// How many numbers were measured beyond those that are looked for.
    pub freedom: usize,
    /// No error is stated: those of the constants come from the scatter.
    pub scattered: bool,
    /// What is left of each measured number, in standard errors, datum by datum.
    pub residuals: Vec<Vec<f64>>,
}

/// How much large residuals weigh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weight {
    /// Their squares are summed.
    Full,
    /// Those of many standard errors count no more than in proportion, so that a measurement which is
    /// still compared with the wrong part of a curve does not outweigh all others.
    Tame,
}

/// There is no fit.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FitError {
    /// A measurement cannot be computed for the constants with which the search begins.
    #[error(
        "line {line}: nothing like it is computed for the constants of the file: begin with others by --set, or leave it out"
    )]
    Start {
        /// Its line.
        line: u32,
        /// Its place among the data.
        datum: usize,
    },
    /// There are fewer numbers than are looked for.
    #[error(
        "{numbers} measured numbers cannot determine {unknowns} unknowns: measure more, or free fewer constants"
    )]
    TooFew {
        /// The measured numbers.
        numbers: usize,
        /// The constants, and two for each series of impacts.
        unknowns: usize,
    },
    /// The measurements do not tell a constant, or not apart from others.
    #[error(
        "the measurements do not determine the constant number {0} of those that are free: leave it out of --free"
    )]
    Undetermined(usize),
    /// The method does not come to an end.
    #[error("no least sum of squares was found: begin nearer to it by --set")]
    NoConvergence,
}

impl FitError {
    fn of(error: &MPError) -> Self {
        match error {
            MPError::DoF | MPError::Empty | MPError::NoFree => Self::TooFew { numbers: 0, unknowns: 0 },
            _ => Self::NoConvergence,
        }
    }
}

/// Residuals of so many standard errors begin to be tame.
const TAME: f64 = 3.0;
/// Steps for differences: relative for constants, in units of motion of the order of one for
/// impacts. Residuals are right to some 1e-11 of what is measured, and so derivatives to 1e-6.
const STEP: f64 = 1e-5;
/// A trial that cannot be computed counts so many standard errors, and is not accepted.
const FAILED: f64 = 1e6;
/// The method ends after so many steps; five are usual.
const MOST_STEPS: usize = 60;
/// The nearest place of a curve is found to this share of a standard error, or of the distance, of which
/// the distance knows the square.
const FOOT: f64 = 1e-5;
/// Newton's method ends after so many evaluations, of which it takes five.
const EVALUATIONS: usize = 30;
/// Steps along a curve on the way there, without dimensions.
const LONGEST: f64 = 0.1;
const SHORTEST: f64 = 1e-9;
/// A solution this far (dimensionless) from where it was is another one.
const ANOTHER: f64 = 0.5;
/// Sums of squares, and unknowns, are found to this share of themselves, far below any error.
const TOLERANCE: f64 = 1e-9;

impl Datum {
    /// The line of the file, of a series the first.
    pub(crate) fn line(&self) -> u32 {
        match self {
            Self::Bifurcation(located) => located.line,
            Self::Impacts(segment) => segment.lines.first().copied().unwrap_or(0),
        }
    }

    /// What is unknown of it besides the constants, as measured.
    fn own(&self) -> Vec<f64> {
        match self {
            Self::Bifurcation(_) => Vec::new(),
            Self::Impacts(segment) => segment.impacts[0][..2].to_vec(),
        }
    }

    /// Line, name, and what is left of each number, in the order of [`residuals`](Self::residuals).
    pub(crate) fn quantities(&self) -> Vec<(u32, String)> {
        match self {
            Self::Bifurcation(located) => vec![(located.line, located.quantity.clone())],
            Self::Impacts(segment) => {
                let names = ["time", "velocity_before", "velocity_after"];
                let of = |(impact, line): (&[f64; 3], &u32)| {
                    let known = impact.iter().zip(names).filter(|(value, _)| !value.is_nan());
                    known.map(|(_, name)| (*line, name.to_owned())).collect::<Vec<_>>()
                };
                segment.impacts.iter().zip(&segment.lines).flat_map(of).collect()
            }
        }
    }

    fn count(&self) -> usize {
        match self {
            Self::Bifurcation(_) => 1,
            Self::Impacts(segment) => {
                segment.impacts.iter().flatten().filter(|value| !value.is_nan()).count()
            }
        }
    }

    /// What is left of its numbers, in standard errors, and where the solution of a bifurcation is.
    fn residuals(&self, oscillator: &AnyOscillator, window: Window, own: &[f64]) -> Option<Computed> {
        match self {
            Self::Bifurcation(located) => {
                let found = located.foot(oscillator, window)?;
                Some((vec![located.residual(&found)], Some(found)))
            }
            Self::Impacts(segment) => Some((segment.residuals(oscillator, [own[0], own[1]])?, None)),
        }
    }
}

impl Located {
    /// The point of the curve nearest to the measured place, and its direction there.
    fn foot(&self, oscillator: &AnyOscillator, window: Window) -> Option<[Unknowns; 2]> {
        let equations = match self.loops {
            0 => non_impacting::equations(oscillator, window),
            loops => LoopEquations::new(oscillator.clone(), loops, Formulation::FixedPhase),
        };
        let curve = SolutionCurve { equations, condition: self.condition };
        // By steps of least length, with the direction of the curve where they lead.
        let onto = |near: Unknowns, mut along: Unknowns| {
            let mut times = self.times.clone();
            let found = newton::solve(near, EVALUATIONS, |point| {
                let system = curve.evaluate(point, &mut times).map_err(Some)?;
                let null = system.bordered(0.0, &along).jacobian.lu().solve(&Unknowns::w());
                along = null.ok_or(None)?.normalize();
                Ok::<_, Option<MapError>>(system.bordered(0.0, &along))
            });
            found.ok().map(|found| (found.point, along))
        };
        let [near, along] = self.near;
        let (mut at, mut along) = onto(near, along)?;
        // The last step, and what it seemed to be from where it began.
        let mut last: Option<[f64; 2]> = None;
        for _ in 0..MOST_STEPS {
            let plane = [unknown::PRIMARY, unknown::SECONDARY].map(|place| along[place]);
            let plane = [0, 1].map(|k| plane[k] / self.metric.scales[k]);
            let (gap, square) = (self.gap(&at), plane[0] * plane[0] + plane[1] * plane[1]);
            let straight = -(gap[0] * plane[0] + gap[1] * plane[1]) / square;
            let least = FOOT * (1.0 + length(gap));
            if straight.abs() * square.sqrt() <= least {
                let near = (at - near).norm() < ANOTHER;
                return near.then_some([at, along]);
            }
            // Where the curve bends, the way along its tangent is too long or too short; by how much the last
            // step tells.
            let slope = last.map_or(-1.0, |[step, before]| (straight - before) / step);
            let mut step = if slope < 0.0 { -straight / slope } else { straight };
            step = step.clamp(-LONGEST, LONGEST);
            (at, along) = loop {
                match onto(at + along * step, along) {
                    Some(next) if length(self.gap(&next.0)) < length(gap) + least => break next,
                    _ if step.abs() < SHORTEST => return None,
                    _ => step *= 0.5,
                }
            };
            last = Some([step, straight]);
        }
        None
    }

    /// From the measured place to a point, in standard errors.
    fn gap(&self, point: &Unknowns) -> [f64; 2] {
        self.metric.counted(self.at, [point[unknown::PRIMARY], point[unknown::SECONDARY]])
    }

    /// The distance from the curve, in standard errors; its sign is the side.
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
    /// What is left if the first impact has this time and speed.
    fn residuals(&self, oscillator: &AnyOscillator, [time, speed]: [f64; 2]) -> Option<Vec<f64>> {
        let here = oscillator.with_parameters(self.at);
        if !(speed > 0.0 && time.is_finite()) {
            return None;
        }
        let first = State::on_wall(speed, here.forcing_frequency().value * time);
        let count = self.impacts.len();
        // Twice as long as it took: whatever comes later is another orbit.
        let horizon = 2.0 * (self.impacts[count - 1][0] - self.impacts[0][0]) + here.forcing_period();
        let flights = Orbit::new(&here, first, horizon, count);
        let struck = flights.filter_map(|flight| match flight.end {
            FlightEnd::Impact(state) => Some((flight.start + flight.duration, state)),
            FlightEnd::TimeIsUp(_) => None,
        });
        let mut left = Vec::with_capacity(self.count());
        let mut seen = 0;
        for ((measured, errors), (after, state)) in
            self.impacts.iter().zip(&self.errors).zip([(0.0, first)].into_iter().chain(struck))
        {
            let recoil = here.reset::<0>(OnWall::new(state.velocity, state.phase)).image();
            let computed = [time + after, state.velocity, -recoil.velocity];
            let numbers = (0..3).filter(|k| !measured[*k].is_nan());
            left.extend(numbers.map(|k| (computed[k] - measured[k]) / errors[k]));
            seen += 1;
        }
        (seen == count && left.iter().all(|value| value.is_finite())).then_some(left)
    }

    fn count(&self) -> usize {
        self.impacts.iter().flatten().filter(|value| !value.is_nan()).count()
    }
}

/// What is left of the numbers of a datum, in standard errors, and the point of a curve with its
/// direction.
type Computed = (Vec<f64>, Option<[Unknowns; 2]>);

/// The least squares, as the method sees them.
struct Problem<'a> {
    rig: Rig<'a>,
    window: Window,
    data: Vec<Datum>,
    weight: Weight,
    constants: usize,
    /// For each datum, where its numbers and its own unknowns begin.
    begins: Vec<[usize; 2]>,
    numbers: usize,
    parameters: Vec<MPPar>,
    config: MPConfig,
}

impl Problem<'_> {
    fn own<'p>(&self, all: &'p [f64], datum: usize) -> &'p [f64] {
        let from = self.begins[datum][1];
        &all[from..from + self.data[datum].own().len()]
    }

    /// What is left of all numbers; none with the first datum that cannot be computed.
    fn residuals(&self, all: &[f64]) -> Result<Vec<Computed>, usize> {
        let oscillator = (self.rig)(&all[..self.constants]).ok_or(0_usize)?;
        let of = |(index, datum): (usize, &Datum)| {
            datum.residuals(&oscillator, self.window, self.own(all, index)).ok_or(index)
        };
        self.data.par_iter().enumerate().map(of).collect::<Vec<_>>().into_iter().collect()
    }
}

impl Weight {
    /// What of a residual is squared.
    fn of(self, residual: f64) -> f64 {
        match self {
            Self::Full => residual,
            Self::Tame => residual / (1.0 + residual.abs() / TAME).sqrt(),
        }
    }

    fn write(self, parts: &[Computed], into: &mut [f64]) {
        let numbers = parts.iter().flat_map(|(numbers, _)| numbers);
        into.iter_mut().zip(numbers).for_each(|(place, number)| *place = self.of(*number));
    }
}

impl MPFitter for Problem<'_> {
    fn eval(&mut self, all: &[f64], left: &mut [f64]) -> MPResult<()> {
        match self.residuals(all) {
            Ok(parts) => self.weight.write(&parts, left),
            Err(_) => left.fill(FAILED),
        }
        Ok(())
    }

    fn number_of_points(&self) -> usize {
        self.numbers
    }

    fn config(&self) -> &MPConfig {
        &self.config
    }

    fn parameters(&self) -> &[MPPar] {
        &self.parameters
    }

    /// Central differences; the unknowns of a datum move what is left of it alone.
    fn jacobian(&mut self, all: &[f64], left: &mut [f64], columns: &mut [Option<Vec<f64>>]) -> MPResult<()> {
        let here = self.residuals(all).map_err(|_| MPError::Eval)?;
        self.weight.write(&here, left);
        // What comes next begins where this was found.
        for (datum, (_, found)) in self.data.iter_mut().zip(&here) {
            if let (Datum::Bifurcation(located), Some(found)) = (datum, found) {
                located.near = *found;
            }
        }
        let moved = |place: usize, by: f64| {
            let mut moved = all.to_vec();
            moved[place] += by;
            moved
        };
        for (place, column) in columns.iter_mut().enumerate().take(self.constants) {
            let Some(column) = column else { continue };
            let step = STEP * if all[place] == 0.0 { 1.0 } else { all[place].abs() };
            let side = |by: f64| self.residuals(&moved(place, by)).map_err(|_| MPError::Eval);
            let (above, mut below) = (side(step)?, vec![0.0; self.numbers]);
            self.weight.write(&above, column);
            self.weight.write(&side(-step)?, &mut below);
            column.iter_mut().zip(below).for_each(|(slope, below)| *slope = (*slope - below) / (2.0 * step));
        }
        let oscillator = (self.rig)(&all[..self.constants]).ok_or(MPError::Eval)?;
        for (index, datum) in self.data.iter().enumerate() {
            let [first, from] = self.begins[index];
            let own = columns.iter_mut().enumerate().skip(from).take(datum.own().len());
            for (place, column) in own.filter_map(|(place, column)| Some((place, column.as_mut()?))) {
                let side = |by: f64| {
                    let moved = moved(place, by);
                    let found = datum.residuals(&oscillator, self.window, self.own(&moved, index));
                    found.map(|(numbers, _)| numbers).ok_or(MPError::Eval)
                };
                let (above, below) = (side(STEP)?, side(-STEP)?);
                column.fill(0.0);
                for ((slope, above), below) in column[first..].iter_mut().zip(above).zip(below) {
                    *slope = (self.weight.of(above) - self.weight.of(below)) / (2.0 * STEP);
                }
            }
        }
        Ok(())
    }
}

/// The constants with the least sum of squares, looked for from `start`; the window holds the
/// places of all bifurcations.
///
/// # Errors
/// [`FitError`].
pub fn fit(
    rig: Rig<'_>,
    start: &[f64],
    window: Window,
    data: Vec<Datum>,
    weight: Weight,
) -> Result<Fit, FitError> {
    let constants = start.len();
    let (mut begins, mut numbers, mut all) = (Vec::new(), 0, start.to_vec());
    for datum in &data {
        begins.push([numbers, all.len()]);
        numbers += datum.count();
        all.extend(datum.own());
    }
    if numbers < all.len() || data.is_empty() {
        return Err(FitError::TooFew { numbers, unknowns: all.len() });
    }
    let scattered = data.iter().all(|datum| match datum {
        Datum::Bifurcation(located) => !located.metric.stated,
        Datum::Impacts(_) => false,
    });
    let config = MPConfig {
        max_iter: MOST_STEPS,
        ftol: TOLERANCE,
        xtol: TOLERANCE,
        gtol: TOLERANCE,
        ..MPConfig::new()
    };
    let free = || MPPar { side: MPSide::User, ..MPPar::new() };
    let parameters = all.iter().map(|_| free()).collect();
    let mut problem = Problem { rig, window, data, weight, constants, begins, numbers, parameters, config };
    problem.residuals(&all).map_err(|datum| FitError::Start { line: problem.data[datum].line(), datum })?;
    let status = problem.mpfit(&mut all).map_err(|error| FitError::of(&error))?;
    if status.success == MPSuccess::MaxIter {
        return Err(FitError::NoConvergence);
    }
    if let Some(place) =
        status.xerror[..constants].iter().position(|error| !(error.is_finite() && *error > 0.0))
    {
        return Err(FitError::Undetermined(place));
    }
    let found = problem.residuals(&all).map_err(|_| FitError::NoConvergence)?;
    let squares = found.iter().flat_map(|(numbers, _)| numbers).map(|number| number * number);
    let (freedom, chi_squared) = (numbers - all.len(), squares.sum::<f64>());
    let scale = if !scattered {
        1.0
    } else if freedom == 0 {
        return Err(FitError::TooFew { numbers, unknowns: all.len() });
    } else {
        chi_squared / freedom as f64
    };
    let entry = |row: usize, column: usize| scale * status.covar[row * status.n_par + column];
    Ok(Fit {
        values: all[..constants].to_vec(),
        covariance: (0..constants)
            .map(|row| (0..constants).map(|column| entry(row, column)).collect())
            .collect(),
        chi_squared,
        freedom,
        scattered,
        residuals: found.into_iter().map(|(numbers, _)| numbers).collect(),
    })
}

impl Fit {
    /// The standard errors of the constants.
    pub fn errors(&self) -> Vec<f64> {
        (0..self.values.len()).map(|place| self.covariance[place][place].sqrt()).collect()
    }

    /// The correlation of two constants.
    pub fn correlation(&self, one: usize, other: usize) -> f64 {
        self.covariance[one][other] / (self.covariance[one][one] * self.covariance[other][other]).sqrt()
    }
}
