//! From results without dimensions to the oscillator's own units.

use grazing_continuation::curve::Window;
use grazing_continuation::fit::{Estimate, FitError, Measurement};
use grazing_model::smooth::Units;
use grazing_theorems::hypothesis::{Hypothesis, Quantity};
use grazing_theorems::{GrazingPoint, ResonantPoint, Unfolding};

use crate::escape::Escape;
use crate::non_impacting::Height;
use crate::sides::{self, Sides, Simulated};
use crate::verdict::Coefficient;
use crate::{Scope, UnfoldError, regions};

impl Scope {
    /// The same, which is in an oscillator's own units, without dimensions.
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

/// What was computed without dimensions.
pub trait InUnits {
    /// The same in the oscillator's own units.
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

/// All that follows by formulas is in the oscillator's own units then.
impl InUnits for ResonantPoint {
    fn in_units(&self, units: &Units) -> Self {
        let Unfolding { loops, derivative } = self.unfolding;
        // a₁₂ is a length, κ_p a number.
        let derivative = if loops == 1 { derivative * units.length } else { derivative } / units.secondary;
        Self {
            grazing: self.grazing.in_units(units),
            second_phase_derivative: self.second_phase_derivative * units.length,
            unfolding: Unfolding { loops, derivative },
        }
    }
}

/// Whether it holds stays what it is.
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
        let (unit, velocity) = (primary / (secondary * secondary), units.velocity());
        let estimate =
            |estimate: Estimate| Estimate { value: estimate.value * unit, error: estimate.error * unit };
        let fit = |fit: Measurement| {
            let [eta, mu] = [secondary / velocity, primary / (velocity * velocity)];
            Measurement {
                coefficient: estimate(fit.coefficient),
                eta: [fit.eta[0] * eta, fit.eta[1] * eta / velocity],
                mu: [fit.mu[0] * mu, fit.mu[1] * mu / velocity],
                velocity: fit.velocity * velocity,
            }
        };
        let failure = |error| match error {
            FitError::NoPoint { velocity: at, failure } => {
                FitError::NoPoint { velocity: at * velocity, failure }
            }
            other => other,
        };
        Self {
            stability: self.stability,
            theorem: estimate(self.theorem),
            fit: self.fit.map(fit).map_err(failure),
        }
    }
}

impl InUnits for Simulated {
    fn in_units(&self, units: &Units) -> Self {
        let unit = units.velocity();
        match *self {
            Self::AsPredicted(sides) => Self::AsPredicted(Sides { velocity: sides.velocity * unit, ..sides }),
            Self::Against(sides) => Self::Against(Sides { velocity: sides.velocity * unit, ..sides }),
            Self::Undecided(doubt) => Self::Undecided(doubt.in_units(units)),
        }
    }
}

impl InUnits for sides::Doubt {
    fn in_units(&self, units: &Units) -> Self {
        let unit = units.velocity();
        match *self {
            Self::TooSlow { leading, least } => {
                Self::TooSlow { leading: leading * unit, least: least * unit }
            }
            Self::NoSolution { velocity, failure } => Self::NoSolution { velocity: velocity * unit, failure },
            Self::SlowConvergence { velocity, returns } => {
                Self::SlowConvergence { velocity: velocity * unit, returns }
            }
            Self::OnlyHere { velocity } => Self::OnlyHere { velocity: velocity * unit },
            Self::NotMeasured => Self::NotMeasured,
        }
    }
}

impl InUnits for regions::Doubt {
    fn in_units(&self, units: &Units) -> Self {
        match self {
            Self::Disagreement { secondary, primary } => Self::Disagreement {
                secondary: secondary * units.secondary,
                primary: primary.map(|value| value * units.primary),
            },
            other => other.clone(),
        }
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

impl InUnits for UnfoldError {
    fn in_units(&self, units: &Units) -> Self {
        match self {
            Self::RunsAway { escape } => Self::RunsAway { escape: escape.in_units(units) },
            Self::NoGrazing { lowest, highest } => {
                Self::NoGrazing { lowest: lowest.in_units(units), highest: highest.in_units(units) }
            }
            Self::Pushed { at } => Self::Pushed { at: at.in_units(units) },
            Self::NoOrbit | Self::Stopped { .. } => self.clone(),
        }
    }
}
