//! `[fig04]`, `[fig05]`, `[fig06]` and `[fig10]`: boundaries, an unfolding, the oscillator, a path.

use core::f64::consts::TAU;

use grazing_source::{Section, SourceError};
use grazing_theorems::{GenericGrazing, LinearOscillator};

use super::ParameterError;
use super::checks::{around_zero, contains, frequency, grazing};
use super::requirements::{LEAST_FREQUENCY, MOST_COILS, MOST_FREQUENCY, MOST_LOOPS, MOST_N};

/// Figure 4: the boundaries g_p and h_p in the trapesium.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Figure4 {
    /// The numbers of loops p whose boundaries are drawn: at least one, each 2 or more, none twice.
    pub loops: Vec<u32>,
}

impl Figure4 {
    pub(super) fn read(section: &Section<'_>) -> Result<Self, SourceError> {
        Ok(Self { loops: section.counts("loops", 2..=MOST_LOOPS)? })
    }
}

/// Figure 5: the unfolding of one resonance.
///
/// Any will do: at all resonances of the linear oscillator s_p⁺ < 0 < s_p⁻ (both are squares up to their signs, by eq:impFormula1odd
/// to eq:impFormulap) and β > 0, so that c_SN < 0 < c_PD, as the caption has it, and the curves lie on opposite sides of η = 0.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Figure5 {
    /// The loops p of the resonance.
    pub loops: u32,
    /// The integer n of the resonance (eq:resonance1 for p = 1, eq:resonancep with the plus sign for p >= 2).
    pub n: u32,
    /// The values of mu across; 0 lies strictly inside.
    pub mu: [f64; 2],
    /// The values of eta up; 0 lies strictly inside.
    pub eta: [f64; 2],
}

impl Figure5 {
    pub(super) fn read(section: &Section<'_>, oscillator: &LinearOscillator) -> Result<Self, SourceError> {
        let loops = section.count("loops", 1..=MOST_LOOPS)?;
        let n = section.count("n", 0..=MOST_N)?;
        oscillator.resonance(loops, n).map_err(|_| section.refusal("n"))?;
        Ok(Self { loops, n, mu: around_zero(section, "mu")?, eta: around_zero(section, "eta")? })
    }
}

/// Figure 6: the oscillator in its non-impacting motion at one phase.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Figure6 {
    /// The forcing frequency omega, positive.
    pub frequency: f64,
    /// The forcing amplitude, positive and below grazing: the motion does not reach the wall.
    pub amplitude: f64,
    /// The forcing phase z in radians, from 0 to below 2 pi.
    pub phase: f64,
    /// The coils of the spring.
    pub coils: u32,
}

impl Figure6 {
    pub(super) fn read(section: &Section<'_>, oscillator: &LinearOscillator) -> Result<Self, ParameterError> {
        let frequency = frequency(section)?;
        let grazing = grazing(section, oscillator, frequency)?.amplitude();
        let amplitude = section.number("amplitude", |amplitude| amplitude > 0.0)?;
        if amplitude >= grazing {
            let allowed = format!(
                "the amplitude must lie above 0 and below the grazing amplitude {grazing:.5} of the frequency {frequency}"
            );
            return Err(ParameterError::Unfit(section.forbid("amplitude", allowed)));
        }
        let phase = section.number("phase", |z| (0.0..TAU).contains(&z))?;
        Ok(Self { frequency, amplitude, phase, coils: section.count("coils", 1..=MOST_COILS)? })
    }
}

/// Figure 10: a generic grazing bifurcation to which Theorem 2.3 applies.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Figure10 {
    /// The forcing frequency omega, positive; the hypotheses of Theorem 2.3 hold at its grazing bifurcation.
    pub frequency: f64,
    /// The number of loops p, at least 3.
    pub loops: u32,
}

impl Figure10 {
    pub(super) fn read(section: &Section<'_>, oscillator: &LinearOscillator) -> Result<Self, ParameterError> {
        let frequency = frequency(section)?;
        let loops = section.count("loops", 3..=MOST_LOOPS)?;
        let grazing = grazing(section, oscillator, frequency)?;
        GenericGrazing::check(&grazing.grazing_point(), loops).map_err(|violated| {
            let remedy = remedy(oscillator, frequency, loops);
            let allowed = format!("the path belongs to Theorem 2.3; {violated}; {remedy}");
            ParameterError::Unfit(section.forbid("frequency", allowed))
        })?;
        Ok(Self { frequency, loops })
    }
}

/// The ratio of the frequencies at which the hypotheses of Theorem 2.3 are tried for a remedy.
const RATIO: f64 = 1.001;
/// How many are tried to either side: to three times the frequency and a third of it.
const TRIED: u32 = 1100;

/// Where the hypotheses hold, nearest to the frequency.
fn remedy(oscillator: &LinearOscillator, frequency: f64, loops: u32) -> String {
    let holds = |frequency: f64| {
        contains([LEAST_FREQUENCY, MOST_FREQUENCY], frequency)
            && oscillator
                .grazing(frequency)
                .is_ok_and(|grazing| GenericGrazing::check(&grazing.grazing_point(), loops).is_ok())
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
