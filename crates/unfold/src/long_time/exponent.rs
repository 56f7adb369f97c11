//! The largest Lyapunov exponent of an orbit.

use grazing_model::{AnyOscillator, ImpactOscillator, flow_variable};
use nalgebra::{Matrix2, Vector2};

use super::cycle::{MOST_PERIODS, state_at};
use super::derivative::from_impact_to_impact;
use super::orbit::{LongOrbit, MotionKind, Releases};
use super::strike::Strike;

/// The mean rate at which a small displacement grows, with the dimension of a reciprocal time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponent {
    /// The mean over the whole counted time; −∞ for a cycle that rests at the wall in between, which
    /// forgets its state, NaN where motion rests otherwise or cannot be followed.
    pub mean: f64,
    /// The standard error, from parts of that time; 0 for a cycle, from its multipliers.
    pub error: f64,
}

impl Exponent {
    const NONE: Self = Self { mean: f64::NAN, error: f64::NAN };

    /// Whether the exponent has converged, and displacements grow.
    pub fn is_positive(&self) -> bool {
        self.mean > SURE * self.error
    }
}

/// Number of standard errors by which a positive exponent must exceed zero.
const SURE: f64 = 4.0;
/// Number of forcing periods in which an exponent converges.
const COUNTED: u32 = 512;
/// Number of parts of the time, from whose rates the standard error is computed.
const PARTS: usize = 8;

impl LongOrbit {
    /// An orbit that has not settled, followed on until its exponent has converged, if it does.
    #[must_use]
    pub fn judged(self, oscillator: &AnyOscillator) -> Self {
        let Some(end) = self.end.filter(|_| self.fate.kind == MotionKind::Unsettled) else { return self };
        let mut on = Self::after_transient(oscillator, end, [0, COUNTED], Some(&mut Releases::default()));
        on.fate.followed = self.fate.followed + COUNTED;
        if let Some(cycle) = on.cycle {
            return Self::on_cycle(oscillator, cycle, [COUNTED, on.fate.followed]);
        }
        if !on.impacts.is_empty() && on.exponent(oscillator).is_positive() {
            on.fate.kind = MotionKind::Chaotic;
        }
        on
    }

    /// The largest Lyapunov exponent: for a cycle from its multipliers, for other motion from the
    /// derivatives of the maps from impact to impact, or of the flow.
    pub fn exponent(&self, oscillator: &AnyOscillator) -> Exponent {
        let period = oscillator.forcing_period();
        if matches!(self.fate.kind, MotionKind::Resting | MotionKind::Escaping) {
            return Exponent::NONE;
        }
        if let Some(cycle) = &self.cycle {
            return Exponent { mean: cycle.exponent(period), error: 0.0 };
        }
        // The derivative of the map from impact to impact vanishes across a rest.
        if self.flights.iter().any(|flight| flight.rest.is_some()) {
            return Exponent::NONE;
        }
        let mut displacement = Vector2::new(0.6, 0.8);
        let mut stretch = |derivative: Matrix2<f64>, duration: f64| {
            displacement = derivative * displacement;
            let size = displacement.norm();
            displacement /= size;
            (libm::log(size), duration)
        };
        let grown: Vec<(f64, f64)> = match self.free_flight() {
            // The number of whole periods of the flight, up to a limit.
            Some(flight) => (1..=MOST_PERIODS.min((flight.duration / period) as u32))
                .rev()
                .map(|left| {
                    let from = state_at(oscillator, flight, flight.duration - f64::from(left) * period);
                    let jacobian = oscillator.flow::<1>(from, period).jacobian;
                    stretch(jacobian.fixed_columns::<2>(flow_variable::POSITION).into_owned(), period)
                })
                .collect(),
            None => self
                .flights
                .windows(2)
                .filter_map(|pair| {
                    let (impact, _) = (Strike::of(&pair[0])?, Strike::of(&pair[1])?);
                    Some(stretch(from_impact_to_impact(oscillator, impact, &pair[1]), pair[1].duration))
                })
                .collect(),
        };
        let rate = |part: &[(f64, f64)]| {
            let (growth, time) = part.iter().fold((0.0, 0.0), |sum, each| (sum.0 + each.0, sum.1 + each.1));
            growth / time
        };
        let mean = rate(&grown);
        let parts = grown.chunks(grown.len().div_ceil(PARTS).max(1));
        let count = parts.len() as f64;
        let squares: f64 = parts.map(|part| rate(part) - mean).map(|off| off * off).sum();
        let error = (squares / (count * (count - 1.0))).sqrt();
        Exponent { mean, error }
    }
}
