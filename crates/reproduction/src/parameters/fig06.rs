//! `[fig06]`: the instant at which Figure 6 shows the oscillator.

use grazing_theorems::LinearOscillator;
use serde::Deserialize;
use toml::Spanned;

use super::requirements::MOST_COILS;
use super::validate::{Checked, demand, frequency, refused, unfit};
use grazing_source::Source;

/// `[fig06]` as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Raw {
    frequency: Spanned<f64>,
    amplitude: Spanned<f64>,
    phase: Spanned<f64>,
    coils: Spanned<u32>,
}

/// Figure 6: the oscillator in its non-impacting motion at one phase.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure6 {
    frequency: f64,
    amplitude: f64,
    phase: f64,
    coils: u32,
}

impl Figure6 {
    /// The forcing frequency omega, positive.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// The forcing amplitude, positive and below grazing: the motion does not reach the wall.
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// The forcing phase z in radians, from 0 to below 2 pi.
    pub fn phase(&self) -> f64 {
        self.phase
    }

    /// The coils of the spring.
    pub fn coils(&self) -> u32 {
        self.coils
    }
}

pub(super) fn check(raw: &Raw, oscillator: &LinearOscillator, source: &Source<'_>) -> Checked<Figure6> {
    let frequency = frequency(source, "fig06.frequency", &raw.frequency)?;
    let grazing = oscillator
        .grazing(frequency)
        .map_err(|error| refused(source, "fig06.frequency", &raw.frequency, error.to_string()))?
        .amplitude();
    let amplitude = demand(source, "fig06.amplitude", &raw.amplitude, |amplitude| amplitude > 0.0)?;
    if amplitude >= grazing {
        let allowed = format!(
            "the amplitude must lie above 0 and below the grazing amplitude {grazing:.5} of the frequency {frequency}"
        );
        return Err(unfit(source, "fig06.amplitude", &raw.amplitude, allowed));
    }
    let phase = demand(source, "fig06.phase", &raw.phase, |z| (0.0..core::f64::consts::TAU).contains(&z))?;
    let coils = demand(source, "fig06.coils", &raw.coils, |coils| (1..=MOST_COILS).contains(&coils))?;
    Ok(Figure6 { frequency, amplitude, phase, coils })
}
