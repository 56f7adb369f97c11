//! `[fig10]`: the grazing bifurcation whose path P Figure 10 shows.

use grazing_theorems::{GenericGrazing, LinearOscillator};
use serde::Deserialize;
use toml::Spanned;

use super::ParameterError;
use super::requirements::MOST_LOOPS;
use super::validate::demand;
use grazing_source::Source;

/// `[fig10]` as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Raw {
    frequency: Spanned<f64>,
    loops: Spanned<u32>,
}

/// Figure 10: a generic grazing bifurcation to which Theorem 2.3 applies.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure10 {
    frequency: f64,
    loops: u32,
}

impl Figure10 {
    /// The forcing frequency omega, positive; the hypotheses of Theorem 2.3 hold at its grazing bifurcation.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// The number of loops p, at least 3.
    pub fn loops(&self) -> u32 {
        self.loops
    }
}

pub(super) fn check(
    raw: &Raw,
    oscillator: &LinearOscillator,
    source: &Source<'_>,
) -> Result<Figure10, ParameterError> {
    let frequency = demand(source, "fig10.frequency", &raw.frequency, |frequency| frequency > 0.0)?;
    let loops = demand(source, "fig10.loops", &raw.loops, |p| (3..=MOST_LOOPS).contains(&p))?;
    let refuse = |reason: String| source.forbid("fig10.frequency", &raw.frequency, reason);
    let grazing = oscillator.grazing(frequency).map_err(|error| refuse(error.to_string()))?;
    GenericGrazing::check(&grazing.grazing_point(), loops)
        .map_err(|violated| refuse(format!("the path belongs to Theorem 2.3; {violated}")))?;
    Ok(Figure10 { frequency, loops })
}
