//! Least squares: constants of an oscillator for which curves run through measured bifurcations, and
//! orbits through measured impacts.
//!
//! The method is that of Levenberg and Marquardt (MINPACK's, in the version of CMPFIT); the covariance is that of
//! the linearised problem, (JᵀJ)⁻¹.

use grazing_continuation::curve::Window;
use grazing_model::AnyOscillator;
use rayon::prelude::*;
use rmpfit::{MPConfig, MPError, MPFitter, MPPar, MPResult, MPSide, MPSuccess};
use thiserror::Error;

use crate::residuals::{Datum, Missing, Residuals};

/// The oscillator with these values of the constants, dimensionless, in units that do not depend on the
/// constants; none where it does not exist.
pub type Rig<'a> = &'a (dyn Fn(&[f64]) -> Option<AnyOscillator> + Sync);

/// The constants with the least sum of squares.
#[derive(Clone, Debug)]
pub struct Fit {
    /// The values of the constants.
    pub values: Vec<f64>,
    /// The covariance of the constants.
    pub covariance: Vec<Vec<f64>>,
    /// The sum of squares of the residuals.
    pub chi_squared: f64,
    /// The degrees of freedom: measured numbers minus unknowns.
    pub freedom: usize,
    /// Whether no error is stated, so that the errors of the constants are derived from the scatter.
    pub scattered: bool,
    /// The residuals of all measured numbers, in standard errors, datum by datum.
    pub residuals: Vec<Vec<f64>>,
}

/// The weight of large residuals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    /// Residuals are squared and summed.
    Full,
    /// The squares of residuals of many standard errors grow only in proportion to the residual, so that
    /// a measurement that is still compared with the wrong part of a curve does not outweigh all others.
    Tame,
}

/// The reason why there is no fit.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FitError {
    /// A measurement cannot be computed for the constants with which the search begins.
    #[error("line {line}: {missing}")]
    Start {
        /// The line of the measurement.
        line: u32,
        /// The index of the measurement in the data.
        datum: usize,
        /// The reason.
        missing: Missing,
    },
    /// There are fewer measured numbers than unknowns.
    #[error(
        "{numbers} measured numbers cannot determine {unknowns} unknowns: measure more or free fewer constants"
    )]
    TooFew {
        /// The number of measured numbers.
        numbers: usize,
        /// The number of unknowns: the constants, and two for each series of impacts.
        unknowns: usize,
    },
    /// The measurements do not constrain a constant, or cannot separate it from others.
    #[error("the measurements do not determine constant number {0} of --free: leave it out")]
    Undetermined(usize),
    /// The method does not converge.
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

/// Residuals beyond this number of standard errors have reduced weight.
const TAME: f64 = 3.0;
/// Step for difference quotients: relative for constants; for impacts in units in which motion is of
/// order one. Residuals are accurate to about 1e-11 of the measured values, and derivatives therefore to
/// 1e-6.
const STEP: f64 = 1e-5;
/// Residual, in standard errors, of a trial that cannot be computed, so that it is rejected.
const FAILED: f64 = 1e6;
/// The greatest number of steps of the method; about five are usual.
const MOST_STEPS: usize = 60;
/// The relative accuracy of the sum of squares and of the unknowns, far below any error of measurement.
const TOLERANCE: f64 = 1e-9;

/// The least-squares problem in the form that the method expects.
struct Problem<'a> {
    rig: Rig<'a>,
    window: Window,
    data: Vec<Datum>,
    weight: Loss,
    constants: usize,
    /// For each datum, the indices of its first residual and of its first own unknown.
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

    /// The residuals of all data; an error about the first datum that cannot be computed.
    fn residuals(&self, all: &[f64]) -> Result<Vec<Residuals>, FitError> {
        let start = |datum: usize, (line, missing)| FitError::Start { line, datum, missing };
        let none = || start(0, (self.data[0].line(), Missing::Result));
        let oscillator = (self.rig)(&all[..self.constants]).ok_or_else(none)?;
        let of = |(index, datum): (usize, &Datum)| {
            datum.residuals(&oscillator, self.window, self.own(all, index)).map_err(|lost| start(index, lost))
        };
        self.data.par_iter().enumerate().map(of).collect::<Vec<_>>().into_iter().collect()
    }
}

impl Loss {
    /// The number that is squared in place of a residual.
    fn of(self, residual: f64) -> f64 {
        match self {
            Self::Full => residual,
            Self::Tame => residual / (1.0 + residual.abs() / TAME).sqrt(),
        }
    }

    fn write(self, parts: &[Residuals], into: &mut [f64]) {
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

    /// The Jacobian by central differences; the unknowns of a datum affect only its own residuals.
    fn jacobian(&mut self, all: &[f64], left: &mut [f64], columns: &mut [Option<Vec<f64>>]) -> MPResult<()> {
        let here = self.residuals(all).map_err(|_| MPError::Eval)?;
        self.weight.write(&here, left);
        // The next evaluations start from the points found here.
        for (datum, (_, found)) in self.data.iter_mut().zip(&here) {
            if let (Datum::Bifurcation(located), Some(found)) = (datum, found) {
                located.near = found.clone();
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
                    found.map(|(numbers, _)| numbers).map_err(|_| MPError::Eval)
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

/// The constants with the least sum of squares, searched for from `start`; the window contains the places
/// of all bifurcations.
///
/// # Errors
/// [`FitError`].
pub fn fit(
    rig: Rig<'_>,
    start: &[f64],
    window: Window,
    data: Vec<Datum>,
    weight: Loss,
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
        Datum::Impacts(segment) => segment.errors.iter().flatten().all(|error| error.is_nan()),
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
    problem.residuals(&all)?;
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

/// The number of standard deviations beyond which a sum of squares shows that the oscillator, or the stated errors,
/// are not those of the rig: once in 740 for those that are.
const UNLIKELY: f64 = 3.0;

impl Fit {
    /// Whether the sum of squares is larger than the stated errors explain.
    ///
    /// The distribution is that of chi squared, whose cube root is nearly normal (Wilson and Hilferty 1931).
    pub fn is_refuted(&self) -> bool {
        let freedom = self.freedom as f64;
        let share = 2.0 / (9.0 * freedom);
        let root = 1.0 - share + UNLIKELY * share.sqrt();
        !self.scattered && self.freedom > 0 && self.chi_squared > freedom * root * root * root
    }

    /// The fit with errors of the constants that follow from the scatter instead of from the stated errors.
    pub(crate) fn scaled(mut self) -> Self {
        let scale = self.chi_squared / self.freedom as f64;
        self.covariance.iter_mut().flatten().for_each(|entry| *entry *= scale);
        self
    }

    /// The standard errors of the constants.
    pub fn errors(&self) -> Vec<f64> {
        (0..self.values.len()).map(|place| self.covariance[place][place].sqrt()).collect()
    }

    /// The correlation of two constants.
    pub fn correlation(&self, one: usize, other: usize) -> f64 {
        self.covariance[one][other] / (self.covariance[one][one] * self.covariance[other][other]).sqrt()
    }
}
