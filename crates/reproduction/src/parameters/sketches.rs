//! `[fig04]`, `[fig05]`, `[fig06]` and `[fig10]`: boundaries, an unfolding, the oscillator, a path.

use core::f64::consts::TAU;

use grazing_source::kind::{count, counts, number};
use grazing_source::{Keys, Section, SourceError, keys};
use grazing_theorems::{GenericGrazing, LinearOscillator};

use super::error::ParameterError;
use super::limits::{FREQUENCIES, FREQUENCY, INDEX, MOST_LOOPS, MOST_N, around_zero, grazing};

/// The most coils of Figure 6's spring that can be told apart in print.
const MOST_COILS: u32 = 30;

keys! {
    /// Figure 4: the boundaries g_p and h_p in the trapesium.
    pub struct Figure4 {
        /// The numbers of loops p whose boundaries are drawn.
        loops: Vec<u32> = counts(2..=MOST_LOOPS),
            "the numbers of loops must be a list of different whole numbers from {} to {}, as [2, 3, 4]";
    }
}

keys! {
    /// Figure 5: the unfolding of one resonance.
    ///
    /// Any will do: at all resonances of the linear oscillator s_p⁺ < 0 < s_p⁻ (both are squares up to their signs, by
    /// eq:impFormula1odd to eq:impFormulap) and β > 0, so that c_SN < 0 < c_PD, as the caption has it, and the curves lie on
    /// opposite sides of η = 0.
    pub struct Figure5 {
        /// The loops p of the resonance.
        loops: u32 = count(1..=MOST_LOOPS), "the number of loops must be a whole number from {} to {}";
        /// The integer n of the resonance (eq:resonance1 for p = 1, eq:resonancep with the plus sign for p >= 2).
        n: u32 = count(0..=MOST_N), INDEX;
        /// The values of mu across.
        mu: [f64; 2] = around_zero(), "the values of mu must be a range [lower, upper] with lower < 0 < upper";
        /// The values of eta up.
        eta: [f64; 2] = around_zero(), "the values of eta must be a range [lower, upper] with lower < 0 < upper";
    }
}

impl Figure5 {
    pub(super) fn checked(section: &Section<'_>, oscillator: &LinearOscillator) -> Result<Self, SourceError> {
        let figure = Self::read(section)?;
        oscillator.resonance(figure.loops, figure.n).map_err(|_| section.refusal("n"))?;
        Ok(figure)
    }
}

keys! {
    /// Figure 6: the oscillator in its non-impacting motion at one phase.
    pub struct Figure6 {
        /// The forcing frequency omega.
        frequency: f64 = number(FREQUENCIES), FREQUENCY;
        /// The forcing amplitude, below grazing: the motion does not reach the wall.
        amplitude: f64 = number(0.0..).such(|amplitude| *amplitude > 0.0),
            "the forcing amplitude must lie above 0 and below the grazing amplitude of fig06.frequency";
        /// The forcing phase z in radians.
        phase: f64 = number(0.0..TAU), "the phase must be a number from 0 to below 2 pi";
        /// The coils of the spring.
        coils: u32 = count(1..=MOST_COILS), "the number of coils must be a whole number from {} to {}";
    }
}

impl Figure6 {
    pub(super) fn checked(
        section: &Section<'_>,
        oscillator: &LinearOscillator,
    ) -> Result<Self, ParameterError> {
        let figure = Self::read(section)?;
        let frequency = figure.frequency;
        let grazing = grazing(section, oscillator, frequency)?.amplitude();
        if figure.amplitude < grazing {
            return Ok(figure);
        }
        let allowed = format!(
            "the amplitude must lie above 0 and below the grazing amplitude {grazing:.5} of the frequency {frequency}"
        );
        Err(ParameterError::Unfit(section.forbid("amplitude", allowed)))
    }
}

keys! {
    /// Figure 10: a generic grazing bifurcation to which Theorem 2.3 applies.
    pub struct Figure10 {
        /// The forcing frequency omega; the hypotheses of Theorem 2.3 hold at its grazing bifurcation.
        frequency: f64 = number(FREQUENCIES), FREQUENCY;
        /// The number of loops p.
        loops: u32 = count(3..=MOST_LOOPS), "the number of loops must be a whole number from {} to {}";
    }
}

impl Figure10 {
    pub(super) fn checked(
        section: &Section<'_>,
        oscillator: &LinearOscillator,
    ) -> Result<Self, ParameterError> {
        let Self { frequency, loops } = Self::read(section)?;
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
        FREQUENCIES.contains(&frequency)
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
