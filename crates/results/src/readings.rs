//! Engineering quantities of motion: impact velocities, peak-to-peak amplitudes, forces and power, along
//! branches and as a parameter is swept up and down.

use crate::{Column, Stability, rows, words};

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
        impacts: u32 = SOLUTION_IMPACTS,
        wall: u32 = WALL,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        impact_velocity: f64 = IMPACT_VELOCITY,
        impact_phase: f64 = PHASE_OF_IMPACT,
        peak_to_peak: f64 = PEAK_TO_PEAK,
        impulse: f64 = IMPULSE,
        force: f64 = MEAN_FORCE,
        power: f64 = POWER,
        stable: Stability = STABLE,
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
        rests: f64 = RESTS_PER_PERIOD,
        wall: u32 = WALL,
        x: f64 = X_OF_IMPACT,
        impact_velocity: f64 = IMPACT_VELOCITY,
        impact_phase: f64 = PHASE_OF_IMPACT,
        peak_to_peak: f64 = PEAK_TO_PEAK,
        impulse: f64 = IMPULSE,
        force: f64 = MEAN_FORCE,
        power: f64 = POWER,
    }
}

macro_rules! read {
    ($($row:ident: $x:expr,)+) => {$(
        impl $row {
            /// The quantity that the vertical axis shows.
            pub(crate) fn read(&self, ordinate: Ordinate) -> f64 {
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
    /// Whether the quantity needs the mass that hits the wall.
    pub fn needs_mass(self) -> bool {
        self.whole_column().dimension.has_mass()
    }

    /// The header of the ordinate's column, and the unit of its numbers.
    pub const fn column(self) -> (&'static str, &'static str) {
        let column = self.whole_column();
        (column.name, column.unit)
    }

    const fn whole_column(self) -> Column {
        use crate::columns::{IMPACT_VELOCITY, IMPULSE, MEAN_FORCE, PEAK_TO_PEAK, POWER, X_ON_SECTION};
        match self {
            Self::X => X_ON_SECTION,
            Self::ImpactVelocity => IMPACT_VELOCITY,
            Self::PeakToPeak => PEAK_TO_PEAK,
            Self::Impulse => IMPULSE,
            Self::Force => MEAN_FORCE,
            Self::Power => POWER,
        }
    }
}
