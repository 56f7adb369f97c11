//! `[fig08]`: the resonances about which Figure 8 magnifies Figure 7.

use grazing_input::kind::{count, maybe, table, tables, unwritten};
use grazing_theorems::{LinearOscillator, Resonance};

use crate::figure::prelude::*;
use crate::figures::fig07::diagram::Figure7;
use crate::parameters::limits::{INDEX, MOST_LOOPS, MOST_N, must_lie_inside, range};
use crate::parameters::{contains, encloses, strictly_contains};

/// The greatest number of panels that fit side by side.
pub(super) const MOST_PANELS: usize = 3;

keys! {
    /// Figure 8: magnifications of Figure 7.
    pub struct Figure8 {
        /// The panels from left to right.
        panels: Vec<MagnifiedResonance> = tables(0..=MOST_PANELS),
            "[[fig08.panels]] must be at most three tables, one for each magnification; without any they are chosen";
        /// Sentences about contents that differ from those requested.
        notes: Vec<String> = unwritten();
    }
}

keys! {
    /// One magnification around a resonance.
    pub struct MagnifiedResonance {
        /// The loops p of the resonance.
        loops: u32 = count(1..=MOST_LOOPS), "the number of loops must be a whole number from {} to {}";
        /// Its integer n (eq:resonance1 for p = 1, eq:resonancep with the plus sign for p >= 2).
        n: u32 = count(0..=MOST_N), INDEX;
        /// The forcing amplitudes across, with that of the resonance inside; none if they are to be
        /// chosen.
        amplitude: Option<[f64; 2]> = maybe(range()),
            "the forcing amplitudes must be a range [lower, upper] inside fig07.amplitude";
        /// The forcing frequencies up, likewise.
        frequency: Option<[f64; 2]> = maybe(range()),
            "the forcing frequencies must be a range [lower, upper] inside fig07.frequency";
        /// What takes the place of those that are to be chosen, if it fits.
        near: Option<NearWindow> = maybe(table()), "the table [fig08.panels.near] holds amplitude and frequency";
    }
}

keys! {
    /// A window that may be replaced.
    pub struct NearWindow {
        /// The forcing amplitudes.
        amplitude: [f64; 2] = range(), "the forcing amplitudes must be a range [lower, upper]";
        /// The forcing frequencies.
        frequency: [f64; 2] = range(), "the forcing frequencies must be a range [lower, upper]";
    }
}

impl FileSection for Figure8 {
    const NAME: &'static str = "fig08";
    const REQUIREMENT: &'static str = "the table [fig08] holds the panels of Figure 8";

    fn checked(mut self, section: &Section<'_>, parameters: &Parameters) -> Result<Self, ParameterError> {
        let (fig07, oscillator) = (parameters.section::<Figure7>()?, parameters.oscillator()?);
        // An error in this list would have been reported for Figure 7.
        let mut free = fig07.resonances(&oscillator).unwrap_or_default();
        if self.panels.is_empty() {
            let chosen = fig07.loops.iter().cycle().take(MOST_PANELS);
            self.panels.extend(chosen.map_while(|&p| take(&mut free, p)));
            return Ok(self);
        }
        let mut replaced = Vec::new();
        for (number, mut panel) in (1..).zip(std::mem::take(&mut self.panels)) {
            let at = format!("panels[{number}]");
            if panel.fit(&fig07, &oscillator, (section, &at))? {
                free.retain(|other| (other.loops(), other.index()) != (panel.loops, panel.n));
                self.panels.push(panel);
            } else {
                replaced.push((self.panels.len(), at, panel));
            }
        }
        // From the last to the first, so that the positions of the remaining ones do not change.
        for (index, at, MagnifiedResonance { loops: p, n, .. }) in replaced.into_iter().rev() {
            let (key, reason) = match fig07.loops.contains(&p) {
                true => ("n", "does not lie in the window of Figure 7"),
                false => ("loops", "is not in Figure 7, as its p is not among fig07.loops"),
            };
            let key = section.shown(&format!("{at}.{key}"));
            let missing = format!("{key}: the resonance p = {p}, n = {n} {reason}");
            match take(&mut free, p) {
                Some(other) => {
                    let MagnifiedResonance { loops, n, .. } = other;
                    self.notes.push(format!("{missing}; the panel shows p = {loops}, n = {n} instead"));
                    self.panels.insert(index, other);
                }
                None => self.notes.push(format!(
                    "{missing}; there is no such panel, as every resonance that is there is shown"
                )),
            }
        }
        Ok(self)
    }
}

/// Takes the resonance with the highest frequency out of the list for a panel: one with p loops if there
/// is one.
fn take(free: &mut Vec<Resonance>, p: u32) -> Option<MagnifiedResonance> {
    let last = free.iter().rposition(|resonance| resonance.loops() == p).or(free.len().checked_sub(1))?;
    let taken = free.remove(last);
    Some(MagnifiedResonance {
        loops: taken.loops(),
        n: taken.index(),
        amplitude: None,
        frequency: None,
        near: None,
    })
}

impl MagnifiedResonance {
    /// Adopts the parts of the replaceable window that fit, and returns whether the panel can be shown.
    /// It cannot if its p is not among those of Figure 7, or if its resonance lies outside the window of
    /// Figure 7 and the panel has no mandatory window.
    fn fit(
        &mut self,
        fig07: &Figure7,
        oscillator: &LinearOscillator,
        (section, at): (&Section<'_>, &str),
    ) -> Result<bool, ParameterError> {
        let Self { loops, n, .. } = *self;
        let place = |name: &str| format!("{at}.{name}");
        let resonance = oscillator.resonance(loops, n).map_err(|_| section.refusal(&place("n")))?;
        if !fig07.loops.contains(&loops) {
            return Ok(false);
        }
        let axes = [
            ("amplitude", fig07.amplitude, resonance.grazing().amplitude()),
            ("frequency", fig07.frequency, resonance.forcing_frequency()),
        ];
        let mut shown = [self.amplitude, self.frequency];
        for (range, (name, whole, value)) in shown.iter().zip(axes) {
            let Some(range) = *range else { continue };
            must_lie_inside(section, &place(name), range, (&format!("fig07.{name}"), whole))?;
            if !strictly_contains(range, value) {
                let allowed = format!(
                    "the range must contain the {name} {value:.5} of the resonance p = {loops}, n = {n}"
                );
                return Err(ParameterError::Unfit(section.forbid(&place(name), allowed)));
            }
        }
        let there = axes.iter().all(|&(_, whole, value)| contains(whole, value)) || shown != [None; 2];
        if let Some(NearWindow { amplitude, frequency }) = self.near {
            let near = [amplitude, frequency];
            let fits = |(near, (_, whole, value)): ([f64; 2], (_, [f64; 2], f64))| {
                strictly_contains(near, value) && encloses(whole, near)
            };
            if near.into_iter().zip(axes).all(fits) {
                shown = [shown[0].or(Some(near[0])), shown[1].or(Some(near[1]))];
            }
        }
        [self.amplitude, self.frequency] = shown;
        Ok(there)
    }
}
