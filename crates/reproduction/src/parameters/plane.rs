//! `[fig07]` and `[fig08]`: the window of the two-parameter diagram, and about which resonances
//! Figure 8 magnifies it.

use grazing_continuation::curve::Window;
use grazing_source::kind::{count, counts, interval, maybe, table, tables, value};
use grazing_source::{Keys, Section, keys};
use grazing_theorems::{LinearOscillator, Resonance, TheoryError};

use super::error::ParameterError;
use super::limits::{
    AMPLITUDES, INDEX, LOOPS, MOST_LOOPS, MOST_N, amplitudes, contains, encloses, must_lie_inside, range,
    strictly_contains,
};

/// The most panels of Figure 8 that fit side by side.
const MOST_PANELS: usize = 3;
/// Forcing frequencies of Figure 7: resonances accumulate at zero, p = 1 has 40 above the least of
/// these.
const WINDOW_FREQUENCIES: [f64; 2] = [0.05, 100.0];

/// Figure 7: the forcing amplitude across, the forcing frequency up.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Figure7 {
    /// The forcing amplitudes across (primary, from 0 or more) and frequencies up (secondary, from
    /// above 0).
    pub window: Window,
    /// The numbers of loops p: at least one, none twice, as ordered in the file; one at least has a
    /// resonance inside the window.
    pub loops: Vec<u32>,
}

keys! {
    /// The section of Figure 7 as it is written.
    pub(super) struct Section7 {
        /// The forcing amplitudes.
        amplitude: [f64; 2] = amplitudes(), AMPLITUDES;
        /// The forcing frequencies.
        frequency: [f64; 2] = interval(WINDOW_FREQUENCIES[0]..=WINDOW_FREQUENCIES[1]),
            "the forcing frequencies must be a range [lower, upper] with {} <= lower < upper <= {}; resonances accumulate at 0";
        /// The numbers of loops.
        loops: Vec<u32> = counts(1..=MOST_LOOPS), LOOPS;
    }
}

impl Figure7 {
    pub(super) fn checked(
        section: &Section<'_>,
        oscillator: &LinearOscillator,
    ) -> Result<Self, ParameterError> {
        let Section7 { amplitude: primary, frequency: secondary, loops } = Section7::read(section)?;
        let figure = Self { window: Window { primary, secondary }, loops };
        let refuse = |error: TheoryError| section.forbid("frequency", error.to_string());
        if figure.resonances(oscillator).map_err(refuse)?.is_empty() {
            let beside = |value: f64, [low, high]: [f64; 2]| (value - value.clamp(low, high)).abs();
            let distance = |resonance: &Resonance| {
                let aside = beside(resonance.grazing().amplitude(), primary);
                libm::hypot(aside, beside(resonance.forcing_frequency(), secondary))
            };
            let [lower, upper] = WINDOW_FREQUENCIES;
            let all = oscillator.resonances(&figure.loops, lower, upper).map_err(refuse)?;
            let nearest = all.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            let where_one_is = nearest.map_or_else(String::new, |one| {
                let (amplitude, omega) = (one.grazing().amplitude(), one.forcing_frequency());
                let (p, n) = (one.loops(), one.index());
                format!(
                    "; the nearest, p = {p}, n = {n}, is at amplitude {amplitude:.5}, frequency {omega:.5}"
                )
            });
            let allowed = format!(
                "no resonance lies in the window of fig07.amplitude and fig07.frequency{where_one_is}"
            );
            return Err(ParameterError::Unfit(section.forbid("frequency", allowed)));
        }
        Ok(figure)
    }

    /// The resonances of an oscillator inside the window, by increasing frequency.
    fn resonances(&self, oscillator: &LinearOscillator) -> Result<Vec<Resonance>, TheoryError> {
        let [lower, upper] = self.window.secondary;
        let mut resonances = oscillator.resonances(&self.loops, lower, upper)?;
        resonances.retain(|resonance| contains(self.window.primary, resonance.grazing().amplitude()));
        Ok(resonances)
    }
}

/// Figure 8: magnifications of Figure 7.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Figure8 {
    /// The panels from left to right: one to three.
    pub panels: Vec<Panel>,
    /// What is shown in the place of something else, in sentences.
    pub notes: Vec<String>,
}

/// One magnification around a resonance.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Panel {
    /// The loops p of the resonance, one of those of Figure 7.
    pub loops: u32,
    /// The integer n of the resonance (eq:resonance1 for p = 1, eq:resonancep with the plus sign
    /// for p >= 2).
    pub n: u32,
    /// The amplitudes across, inside those of Figure 7, with that of the resonance inside; none if
    /// they are to be chosen.
    pub amplitude: Option<[f64; 2]>,
    /// The frequencies up, likewise.
    pub frequency: Option<[f64; 2]>,
}

keys! {
    /// The section of Figure 8 as it is written.
    pub(super) struct Section8 {
        /// The panels.
        panels: Vec<WrittenPanel> = tables(0..=MOST_PANELS),
            "[[fig08.panels]] must be at most three tables, one for each magnification; without any they are chosen";
    }
}

keys! {
    /// A panel as it is written.
    pub(super) struct WrittenPanel {
        /// The loops p of the resonance.
        loops: u32 = value(), "the number of loops must be one of fig07.loops";
        /// Its integer n.
        n: u32 = count(0..=MOST_N), INDEX;
        /// The forcing amplitudes, these or none.
        amplitude: Option<[f64; 2]> = maybe(range()),
            "the forcing amplitudes must be a range [lower, upper] inside fig07.amplitude";
        /// The forcing frequencies, these or none.
        frequency: Option<[f64; 2]> = maybe(range()),
            "the forcing frequencies must be a range [lower, upper] inside fig07.frequency";
        /// The window, if it fits.
        near: Option<Near> = maybe(table()), "the table [fig08.panels.near] holds amplitude and frequency";
    }
}

keys! {
    /// A window that may be replaced.
    pub(super) struct Near {
        /// The forcing amplitudes.
        amplitude: [f64; 2] = range(), "the forcing amplitudes must be a range [lower, upper]";
        /// The forcing frequencies.
        frequency: [f64; 2] = range(), "the forcing frequencies must be a range [lower, upper]";
    }
}

impl Figure8 {
    pub(super) fn checked(
        section: &Section<'_>,
        fig07: &Figure7,
        oscillator: &LinearOscillator,
    ) -> Result<Self, ParameterError> {
        // Figure 7 was refused if they could not be listed.
        let mut free = fig07.resonances(oscillator).unwrap_or_default();
        let mut figure = Self { panels: Vec::new(), notes: Vec::new() };
        let listed = Section8::read(section)?.panels;
        if listed.is_empty() {
            let chosen = fig07.loops.iter().cycle().take(MOST_PANELS);
            figure.panels.extend(chosen.map_while(|&p| take(&mut free, p)));
            return Ok(figure);
        }
        let mut replaced = Vec::new();
        for (number, written) in (1..).zip(&listed) {
            let at = format!("panels[{number}]");
            match Panel::checked(written, fig07, oscillator, (section, &at))? {
                (panel, true) => {
                    free.retain(|other| (other.loops(), other.index()) != (panel.loops, panel.n));
                    figure.panels.push(panel);
                }
                (panel, false) => replaced.push((figure.panels.len(), at, panel)),
            }
        }
        // From the last to the first, as places before one that is filled do not move.
        for (index, at, Panel { loops: p, n, .. }) in replaced.into_iter().rev() {
            let missing = format!(
                "{}: the resonance p = {p}, n = {n} does not lie in the window of Figure 7",
                section.shown(&format!("{at}.n"))
            );
            match take(&mut free, p) {
                Some(other) => {
                    let Panel { loops, n, .. } = other;
                    figure.notes.push(format!("{missing}; the panel shows p = {loops}, n = {n} instead"));
                    figure.panels.insert(index, other);
                }
                None => figure
                    .notes
                    .push(format!("{missing}, nor does another that is not shown; there is no such panel")),
            }
        }
        Ok(figure)
    }
}

/// Takes the resonance of highest frequency out of the list for a panel: one with p loops if there
/// is one.
fn take(free: &mut Vec<Resonance>, p: u32) -> Option<Panel> {
    let last = free.iter().rposition(|resonance| resonance.loops() == p).or(free.len().checked_sub(1))?;
    let taken = free.remove(last);
    Some(Panel { loops: taken.loops(), n: taken.index(), amplitude: None, frequency: None })
}

impl Panel {
    /// The panel that the file asks for, and whether it can be shown: not if its resonance lies
    /// outside the window and its own window may be replaced.
    fn checked(
        written: &WrittenPanel,
        fig07: &Figure7,
        oscillator: &LinearOscillator,
        (section, at): (&Section<'_>, &str),
    ) -> Result<(Self, bool), ParameterError> {
        let WrittenPanel { loops, n, .. } = *written;
        let place = |name: &str| format!("{at}.{name}");
        if !fig07.loops.contains(&loops) {
            return Err(section.refusal(&place("loops")).into());
        }
        let resonance = oscillator.resonance(loops, n).map_err(|_| section.refusal(&place("n")))?;
        let axes = [
            ("amplitude", fig07.window.primary, resonance.grazing().amplitude()),
            ("frequency", fig07.window.secondary, resonance.forcing_frequency()),
        ];
        let mut shown = [written.amplitude, written.frequency];
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
        if let Some(Near { amplitude, frequency }) = written.near {
            let near = [amplitude, frequency];
            let fits = |(near, (_, whole, value)): ([f64; 2], (_, [f64; 2], f64))| {
                strictly_contains(near, value) && encloses(whole, near)
            };
            if near.into_iter().zip(axes).all(fits) {
                shown = [shown[0].or(Some(near[0])), shown[1].or(Some(near[1]))];
            }
        }
        let [amplitude, frequency] = shown;
        Ok((Self { loops, n, amplitude, frequency }, there))
    }
}
