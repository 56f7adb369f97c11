//! Conversion of nondimensional results to the oscillator's own units.

use grazing_continuation::curve::Window;
use grazing_continuation::fit::{Estimate, FitError, Measurement};
use grazing_model::smooth::Units;
use grazing_results::branches::OneParameter;
use grazing_results::{Dimension, Frame};
use grazing_theorems::hypothesis::{Hypothesis, Quantity};
use grazing_theorems::{GrazingPoint, ResonantPoint};

use crate::escape::Escape;
use crate::levels::Property;
use crate::non_impacting::Height;
use crate::one_parameter::Line;
use crate::straightened::StraightCurve;
use crate::verdict::Coefficient;
use crate::verification::{Inconclusive, Simulated};
use crate::{Scope, UnfoldError};

impl Scope {
    /// The nondimensional scope, from one in an oscillator's own units.
    #[must_use]
    pub fn without_dimensions(&self, units: &Units) -> Self {
        let window = Window {
            primary: self.window.primary.map(|value| value / units.primary),
            secondary: self.window.secondary.map(|value| value / units.secondary),
        };
        let start = self.start.map(|[x, y]| [x / units.length, y / units.velocity()]);
        Self { window, loops: self.loops.clone(), start }
    }
}

impl Line {
    /// The nondimensional line, from one in an oscillator's own units.
    #[must_use]
    pub fn without_dimensions(&self, units: &Units) -> Self {
        let Units { primary, secondary, .. } = *units;
        let [across, held] = if self.primary_is_fixed { [secondary, primary] } else { [primary, secondary] };
        Self { at: self.at / held, range: self.range.map(|value| value / across), ..*self }
    }
}

/// A nondimensional result that can be converted.
pub trait InUnits {
    /// The result in the oscillator's own units.
    #[must_use]
    fn in_units(&self, units: &Units) -> Self;
}

impl InUnits for Window {
    fn in_units(&self, units: &Units) -> Self {
        Self {
            primary: self.primary.map(|value| value * units.primary),
            secondary: self.secondary.map(|value| value * units.secondary),
        }
    }
}

impl InUnits for GrazingPoint {
    fn in_units(&self, units: &Units) -> Self {
        let mut own = *self;
        own.map.a.m12 *= units.length;
        own.map.a.m21 /= units.length;
        own.map.b.x *= units.length / units.primary;
        own.map.b.y /= units.primary;
        own.forcing_frequency /= units.time;
        own.gamma *= units.acceleration();
        own.psi /= units.velocity();
        own
    }
}

impl InUnits for Property {
    fn in_units(&self, units: &Units) -> Self {
        match *self {
            Self::ImpactVelocity(velocity) => Self::ImpactVelocity(velocity * units.velocity()),
            Self::Modulus(modulus) => Self::Modulus(modulus),
            Self::Distance { phase, distance } => Self::Distance { phase, distance: distance * units.length },
        }
    }
}

/// All quantities computed by formulas are then in the oscillator's own units.
impl InUnits for ResonantPoint {
    fn in_units(&self, units: &Units) -> Self {
        let mut own = *self;
        own.grazing = self.grazing.in_units(units);
        own.second_phase_derivative *= units.length;
        // The dimension of a₁₂ is a length; κ_p is a number.
        let length = if own.unfolding.loops == 1 { units.length } else { 1.0 };
        own.unfolding.derivative *= length / units.secondary;
        own
    }
}

/// The conversion does not change whether the hypothesis holds.
impl InUnits for Hypothesis {
    fn in_units(&self, units: &Units) -> Self {
        let Units { length, primary, secondary, .. } = *units;
        self.in_units_of(match self.quantity {
            Quantity::ForcingFrequency => 1.0 / units.time,
            Quantity::Deceleration => units.acceleration(),
            Quantity::OffDiagonal | Quantity::OffDiagonalTimesSquareRootFactor => length,
            Quantity::OffDiagonalTimesTransversality => length * length / primary,
            Quantity::Transversality | Quantity::TransversalityTimesDetuning => length / primary,
            Quantity::OffDiagonalDerivative => length / secondary,
            Quantity::DetuningDerivative => 1.0 / secondary,
            Quantity::Loops
            | Quantity::Restitution
            | Quantity::Determinant
            | Quantity::Contraction
            | Quantity::StabilityMargin
            | Quantity::SquareRootFactor
            | Quantity::AdmissibilityMargin
            | Quantity::Detuning
            | Quantity::SaddleNodeStability
            | Quantity::PeriodDoublingStability => 1.0,
        })
    }
}

impl InUnits for Coefficient {
    fn in_units(&self, units: &Units) -> Self {
        let Units { primary, secondary, .. } = *units;
        let (unit, unit_of_velocity) = (primary / (secondary * secondary), units.velocity());
        let mut own = *self;
        let estimate = |estimate: &mut Estimate| {
            estimate.value *= unit;
            estimate.error *= unit;
        };
        estimate(&mut own.theorem);
        match &mut own.fit {
            Ok(Measurement { coefficient, eta, mu, velocity }) => {
                estimate(coefficient);
                let slopes = [secondary / unit_of_velocity, primary / (unit_of_velocity * unit_of_velocity)];
                for (terms, slope) in [eta, mu].into_iter().zip(slopes) {
                    *terms = [terms[0] * slope, terms[1] * slope / unit_of_velocity];
                }
                *velocity *= unit_of_velocity;
            }
            Err(FitError::NoPoint { velocity, .. }) => *velocity *= unit_of_velocity,
            Err(FitError::GrazingOrbit(_) | FitError::NotFinished) => {}
        }
        own
    }
}

impl InUnits for StraightCurve {
    fn in_units(&self, units: &Units) -> Self {
        let unit = units.primary / (units.secondary * units.secondary);
        let mut own = Self { coefficient: self.coefficient * unit, ..self.clone() };
        for point in &mut own.points {
            point.eta *= units.secondary;
            point.distance.value *= unit;
            point.distance.error *= unit;
        }
        own
    }
}

impl InUnits for Simulated {
    fn in_units(&self, units: &Units) -> Self {
        let mut own = *self;
        let velocities = match &mut own {
            Self::AsPredicted(sides) | Self::Against(sides) => vec![&mut sides.velocity],
            Self::Undecided(doubt) => match doubt {
                Inconclusive::TooSlow { leading, least } => vec![leading, least],
                Inconclusive::NoSolution { velocity, .. }
                | Inconclusive::SlowConvergence { velocity, .. }
                | Inconclusive::OtherStop { velocity }
                | Inconclusive::OnlyHere { velocity } => vec![velocity],
                Inconclusive::NotMeasured => Vec::new(),
            },
        };
        velocities.into_iter().for_each(|velocity| *velocity *= units.velocity());
        own
    }
}

impl InUnits for Height {
    fn in_units(&self, units: &Units) -> Self {
        Self {
            position: self.position * units.length,
            parameters: units.parameters(self.parameters),
            acceleration: self.acceleration * units.acceleration(),
        }
    }
}

impl InUnits for Escape {
    fn in_units(&self, units: &Units) -> Self {
        Self {
            parameters: units.parameters(self.parameters),
            time: self.time * units.time,
            position: self.position * units.length,
            velocity: self.velocity * units.velocity(),
            force: self.force * units.acceleration(),
        }
    }
}

impl InUnits for OneParameter {
    fn in_units(&self, units: &Units) -> Self {
        let mut own = self.clone();
        let in_units = &mut |dimension: Dimension, number: &mut f64| *number *= dimension.size(units);
        own.each_row(&mut |row| row.each_number(in_units));
        let [across, held] = own.exchanged([units.primary, units.secondary]);
        own.at *= held;
        for frame in own.magnified.iter_mut().chain([&mut own.frame]) {
            *frame = Frame { x: frame.x.map(|x| x * across), y: frame.y.map(|x| x * units.length) };
        }
        own.broken.iter_mut().for_each(|(_, at, _)| *at *= across);
        own
    }
}

impl InUnits for UnfoldError {
    fn in_units(&self, units: &Units) -> Self {
        match self {
            Self::RunsAway { escape } => Self::RunsAway { escape: escape.in_units(units) },
            Self::NoGrazing { lowest, highest, whole } => Self::NoGrazing {
                lowest: lowest.in_units(units),
                highest: highest.in_units(units),
                whole: *whole,
            },
            Self::Pushed { at } => Self::Pushed { at: at.in_units(units) },
            Self::NoOrbit | Self::Stopped { .. } => self.clone(),
        }
    }
}
