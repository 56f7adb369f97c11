//! `[fig05]`: the resonance that Figure 5 unfolds.

use grazing_theorems::LinearOscillator;
use serde::Deserialize;
use toml::Spanned;

use super::Range;
use super::requirements::{MOST_LOOPS, MOST_N};
use super::validate::{Checked, demand, range, refusal};
use grazing_source::Source;

/// `[fig05]` as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Raw {
    loops: Spanned<u32>,
    n: Spanned<u32>,
    mu: Spanned<Vec<f64>>,
    eta: Spanned<Vec<f64>>,
}

/// Figure 5: the unfolding of one resonance.
///
/// Any will do: at all resonances of the linear oscillator s_p⁺ < 0 < s_p⁻ (both are squares up to their signs, by eq:impFormula1odd
/// to eq:impFormulap) and β > 0, so that c_SN < 0 < c_PD, as the caption has it, and the curves lie on opposite sides of η = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure5 {
    loops: u32,
    n: u32,
    mu: Range,
    eta: Range,
}

impl Figure5 {
    /// The loops p of the resonance.
    pub fn loops(&self) -> u32 {
        self.loops
    }

    /// The integer n of the resonance (eq:resonance1 for p = 1, eq:resonancep with the plus sign for p >= 2).
    pub fn n(&self) -> u32 {
        self.n
    }

    /// The values of mu across; 0 lies strictly inside.
    pub fn mu(&self) -> Range {
        self.mu
    }

    /// The values of eta up; 0 lies strictly inside.
    pub fn eta(&self) -> Range {
        self.eta
    }
}

pub(super) fn check(raw: &Raw, oscillator: &LinearOscillator, source: &Source<'_>) -> Checked<Figure5> {
    let loops = demand(source, "fig05.loops", &raw.loops, |p| (1..=MOST_LOOPS).contains(&p))?;
    let n = demand(source, "fig05.n", &raw.n, |n| n <= MOST_N)?;
    oscillator.resonance(loops, n).map_err(|_| refusal(source, "fig05.n", &raw.n))?;
    let about_zero = |key: &str, value: &Spanned<Vec<f64>>| {
        let range = range(source, key, value, |lower| lower < 0.0)?;
        if range.upper() > 0.0 {
            return Ok(range);
        }
        Err(refusal(source, key, value))
    };
    let mu = about_zero("fig05.mu", &raw.mu)?;
    let eta = about_zero("fig05.eta", &raw.eta)?;
    Ok(Figure5 { loops, n, mu, eta })
}
