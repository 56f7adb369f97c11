//! `[fig07]`: the window of the two-parameter diagram.

use grazing_source::Source;
use grazing_theorems::{LinearOscillator, Resonance, TheoryError};
use serde::Deserialize;
use toml::Spanned;

use super::requirements::{LEAST_WINDOW_FREQUENCY, MOST_FREQUENCY};
use super::validate::{Checked, amplitudes, loops, range, refusal, refused, unfit};
use super::{Range, Rectangle};

/// `[fig07]` as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Raw {
    amplitude: Spanned<Vec<f64>>,
    frequency: Spanned<Vec<f64>>,
    loops: Spanned<Vec<Spanned<u32>>>,
}

/// Figure 7: the forcing amplitude across, the forcing frequency up.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure7 {
    window: Rectangle,
    loops: Vec<u32>,
}

impl Figure7 {
    /// The forcing amplitudes across (from 0 or more) and frequencies up (from above 0).
    pub fn window(&self) -> Rectangle {
        self.window
    }

    /// The numbers of loops p: at least one, none twice, as ordered in the file; one at least has a resonance inside the window.
    pub fn loops(&self) -> &[u32] {
        &self.loops
    }

    /// The resonances of an oscillator inside the window, by increasing frequency.
    pub(super) fn resonances(&self, oscillator: &LinearOscillator) -> Result<Vec<Resonance>, TheoryError> {
        inside(oscillator, &self.loops, self.window)
    }
}

fn inside(
    oscillator: &LinearOscillator,
    loops: &[u32],
    window: Rectangle,
) -> Result<Vec<Resonance>, TheoryError> {
    let frequency = window.frequency();
    let mut resonances = oscillator.resonances(loops, frequency.lower(), frequency.upper())?;
    resonances.retain(|resonance| window.amplitude().contains(resonance.grazing().amplitude()));
    Ok(resonances)
}

pub(super) fn check(raw: &Raw, oscillator: &LinearOscillator, source: &Source<'_>) -> Checked<Figure7> {
    let amplitude = amplitudes(source, "fig07.amplitude", &raw.amplitude)?;
    let frequency = frequencies(raw, source)?;
    let window = Rectangle::new(amplitude, frequency);
    let loops = loops(source, "fig07.loops", &raw.loops)?;
    let refuse = |error: TheoryError| refused(source, "fig07.frequency", &raw.frequency, error.to_string());
    let inside = inside(oscillator, &loops, window).map_err(refuse)?;
    if inside.is_empty() {
        let distance = |resonance: &Resonance| {
            let omega = resonance.forcing_frequency();
            (omega - omega.clamp(frequency.lower(), frequency.upper())).abs()
        };
        let all = oscillator.resonances(&loops, LEAST_WINDOW_FREQUENCY, MOST_FREQUENCY).map_err(refuse)?;
        let nearest = all.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let where_one_is = nearest.map_or_else(String::new, |one| {
            let (amplitude, omega) = (one.grazing().amplitude(), one.forcing_frequency());
            let (p, n) = (one.loops(), one.index());
            format!("; the nearest, p = {p}, n = {n}, is at amplitude {amplitude:.5}, frequency {omega:.5}")
        });
        let allowed =
            format!("no resonance lies in the window of fig07.amplitude and fig07.frequency{where_one_is}");
        return Err(unfit(source, "fig07.frequency", &raw.frequency, allowed));
    }
    Ok(Figure7 { window, loops })
}

fn frequencies(raw: &Raw, source: &Source<'_>) -> Checked<Range> {
    let key = "fig07.frequency";
    let range = range(source, key, &raw.frequency, |lower| lower >= LEAST_WINDOW_FREQUENCY)?;
    if range.upper() <= MOST_FREQUENCY { Ok(range) } else { Err(refusal(source, key, &raw.frequency)) }
}
