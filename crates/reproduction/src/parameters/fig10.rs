//! `[fig10]`: the grazing bifurcation whose path P Figure 10 shows.

use grazing_theorems::{GenericGrazing, LinearOscillator};
use serde::Deserialize;
use toml::Spanned;

use super::requirements::{LEAST_FREQUENCY, MOST_FREQUENCY, MOST_LOOPS};
use super::validate::{Checked, demand, frequency, refused, unfit};
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

/// The ratio of the frequencies at which the hypotheses are tried for a remedy.
const RATIO: f64 = 1.001;
/// How many are tried to either side: to three times the frequency and a third of it.
const TRIED: u32 = 1100;

pub(super) fn check(raw: &Raw, oscillator: &LinearOscillator, source: &Source<'_>) -> Checked<Figure10> {
    let frequency = frequency(source, "fig10.frequency", &raw.frequency)?;
    let loops = demand(source, "fig10.loops", &raw.loops, |p| (3..=MOST_LOOPS).contains(&p))?;
    let grazing = oscillator
        .grazing(frequency)
        .map_err(|error| refused(source, "fig10.frequency", &raw.frequency, error.to_string()))?;
    GenericGrazing::check(&grazing.grazing_point(), loops).map_err(|violated| {
        let remedy = remedy(oscillator, frequency, loops);
        let allowed = format!("the path belongs to Theorem 2.3; {violated}; {remedy}");
        unfit(source, "fig10.frequency", &raw.frequency, allowed)
    })?;
    Ok(Figure10 { frequency, loops })
}

/// Where the hypotheses hold, nearest to the frequency.
fn remedy(oscillator: &LinearOscillator, frequency: f64, loops: u32) -> String {
    let holds = |frequency: f64| {
        if !(LEAST_FREQUENCY..=MOST_FREQUENCY).contains(&frequency) {
            return false;
        }
        let grazing = oscillator.grazing(frequency);
        grazing.is_ok_and(|grazing| GenericGrazing::check(&grazing.grazing_point(), loops).is_ok())
    };
    let mut sides = [(RATIO, frequency), (1.0 / RATIO, frequency)];
    for _ in 0..TRIED {
        for (ratio, tried) in &mut sides {
            *tried *= *ratio;
            if holds(*tried) {
                let mut last = *tried;
                while holds(last * *ratio) && last < 3.0 * frequency && last > frequency / 3.0 {
                    last *= *ratio;
                }
                let [low, high] = [tried.min(last), tried.max(last)];
                return format!("they hold from {low:.5} to {high:.5}");
            }
        }
    }
    format!(
        "no frequency within a factor of three will do for fig10.loops = {loops}, choose another number there"
    )
}
