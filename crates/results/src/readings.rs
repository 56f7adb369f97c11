//! Engineering quantities of motion: impact velocities, peak-to-peak amplitudes, forces and power, along
//! branches and as a parameter is swept up and down.

use crate::branches::{AttractorPoint, BranchPoint, OneParameter};
use crate::{rows, words};

words! {
    /// The quantities that the vertical axis of a one-parameter diagram can show.
    Ordinate {
        /// x on the Poincaré section.
        X = "x",
        ImpactVelocity = "impact velocity",
        PeakToPeak = "peak to peak",
        /// The impulse of an impact.
        Impulse = "impulse",
        /// The mean force on the wall over time.
        Force = "mean force",
        /// The power that impacts dissipate.
        Power = "power",
    }

    /// The initial state of motion at a value of the parameter.
    Sweep {
        /// A random state.
        Random = "random",
        /// The final state at the next lower value.
        Up = "up",
        /// The final state at the next higher value.
        Down = "down",
    }
}

rows! {
    /// A solution on a branch of a one-parameter diagram.
    Reading {
        diagram: u32 = DIAGRAM,
        loops: u32 = LOOPS,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        impact_velocity: f64 = IMPACT_VELOCITY,
        impact_phase: f64 = PHASE_OF_IMPACT,
        peak_to_peak: f64 = PEAK_TO_PEAK,
        impulse: f64 = IMPULSE,
        force: f64 = MEAN_FORCE,
        power: f64 = POWER,
        stable: bool = STABLE,
        admissible: bool = ADMISSIBLE,
        branch: u32 = BRANCH,
    }

    /// An impact of simulated motion after its transient, or motion without impacts.
    MotionReading {
        diagram: u32 = DIAGRAM,
        sweep: Sweep = SWEEP,
        orbit: u32 = ORBIT,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        motion: &'static str = MOTION,
        periods: f64 = PERIODS,
        impacts: f64 = IMPACTS_PER_PERIOD,
        x: f64 = X_OF_IMPACT,
        impact_velocity: f64 = IMPACT_VELOCITY,
        impact_phase: f64 = PHASE_OF_IMPACT,
        peak_to_peak: f64 = PEAK_TO_PEAK,
        impulse: f64 = IMPULSE,
        force: f64 = MEAN_FORCE,
        power: f64 = POWER,
    }
}

/// A row with the quantities that the vertical axis can show.
trait Read {
    fn read(&self, ordinate: Ordinate) -> f64;
}

macro_rules! read {
    ($($row:ident: $x:expr,)+) => {$(
        impl Read for $row {
            fn read(&self, ordinate: Ordinate) -> f64 {
                let x: fn(&Self) -> f64 = $x;
                match ordinate {
                    Ordinate::X => x(self),
                    Ordinate::ImpactVelocity => self.impact_velocity,
                    Ordinate::PeakToPeak => self.peak_to_peak,
                    Ordinate::Impulse => self.impulse,
                    Ordinate::Force => self.force,
                    Ordinate::Power => self.power,
                }
            }
        }
    )+};
}

read! {
    Reading: |_| f64::NAN,
    MotionReading: |row| row.x,
}

impl Ordinate {
    /// The header of the ordinate's column, and the unit of its numbers.
    pub const fn column(self) -> (&'static str, &'static str) {
        use crate::columns::{IMPACT_VELOCITY, IMPULSE, MEAN_FORCE, PEAK_TO_PEAK, POWER, X_ON_SECTION};
        let column = match self {
            Self::X => X_ON_SECTION,
            Self::ImpactVelocity => IMPACT_VELOCITY,
            Self::PeakToPeak => PEAK_TO_PEAK,
            Self::Impulse => IMPULSE,
            Self::Force => MEAN_FORCE,
            Self::Power => POWER,
        };
        (column.name, column.unit)
    }
}

impl OneParameter {
    /// The diagram with the chosen ordinate in place of x.
    #[must_use]
    pub fn seen(&self) -> Self {
        let ordinate = self.ordinate;
        if ordinate == Ordinate::X {
            return self.clone();
        }
        let point = |row: &Reading| BranchPoint {
            diagram: row.diagram,
            loops: row.loops,
            secondary: row.secondary,
            primary: row.primary,
            x: row.read(ordinate),
            visit: 1,
            impact_velocity: row.impact_velocity,
            impact_phase: row.impact_phase,
            stable: row.stable,
            admissible: row.admissible,
            branch: row.branch,
        };
        let mut seen = self.clone();
        seen.branches = self.readings.iter().map(point).collect();
        for found in &mut seen.bifurcations {
            // A bifurcation is also a point of a branch; the ordinate is that of the nearest reading.
            let far = |row: &Reading| {
                let velocity = row.impact_velocity - found.impact_velocity;
                let aside = [row.primary - found.primary, row.secondary - found.secondary].map(f64::abs);
                aside[0] + aside[1] + if velocity.is_nan() { 0.0 } else { velocity.abs() }
            };
            let same = self.readings.iter().filter(|row| row.loops == found.loops);
            let nearest = same.min_by(|a, b| far(a).total_cmp(&far(b)));
            found.x = nearest.map_or(f64::NAN, |row| row.read(ordinate));
        }
        let random = self.motion.iter().filter(|row| row.sweep == Sweep::Random);
        let dot = |row: &MotionReading| AttractorPoint {
            diagram: row.diagram,
            secondary: row.secondary,
            primary: row.primary,
            x: row.read(ordinate),
        };
        seen.attractor = random.map(dot).collect();
        seen.fitted()
    }

    /// The varying parameter and the ordinate of simulated motion for one kind of sweep.
    pub fn swept(&self, sweep: Sweep) -> impl Iterator<Item = (f64, f64)> {
        let rows = self.motion.iter().filter(move |row| row.sweep == sweep);
        rows.map(|row| (self.across(row), row.read(self.ordinate))).filter(|(_, value)| value.is_finite())
    }
}
