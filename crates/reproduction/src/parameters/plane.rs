//! `[fig07]` and `[fig08]`: the window of the two-parameter diagram, and about which resonances Figure 8 magnifies it.

use grazing_continuation::curve::Window;
use grazing_source::Section;
use grazing_theorems::{LinearOscillator, Resonance, TheoryError};

use super::ParameterError;
use super::checks::{amplitudes, any, contains, encloses, range, range_inside, strictly_contains, tables};
use super::requirements::{LEAST_WINDOW_FREQUENCY, MOST_FREQUENCY, MOST_LOOPS, MOST_N, MOST_PANELS};

/// Figure 7: the forcing amplitude across, the forcing frequency up.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Figure7 {
    /// The forcing amplitudes across (primary, from 0 or more) and frequencies up (secondary, from above 0).
    pub window: Window,
    /// The numbers of loops p: at least one, none twice, as ordered in the file; one at least has a resonance inside the window.
    pub loops: Vec<u32>,
}

impl Figure7 {
    pub(super) fn read(section: &Section<'_>, oscillator: &LinearOscillator) -> Result<Self, ParameterError> {
        let whole = [LEAST_WINDOW_FREQUENCY, MOST_FREQUENCY];
        let primary = amplitudes(section, "amplitude")?;
        let secondary = range(section, "frequency", |range| encloses(whole, range))?;
        let figure =
            Self { window: Window { primary, secondary }, loops: section.counts("loops", 1..=MOST_LOOPS)? };
        let refuse = |error: TheoryError| section.forbid("frequency", error.to_string());
        if figure.resonances(oscillator).map_err(refuse)?.is_empty() {
            let beside = |value: f64, [low, high]: [f64; 2]| (value - value.clamp(low, high)).abs();
            let distance = |resonance: &Resonance| {
                let aside = beside(resonance.grazing().amplitude(), primary);
                libm::hypot(aside, beside(resonance.forcing_frequency(), secondary))
            };
            let all = oscillator.resonances(&figure.loops, whole[0], whole[1]).map_err(refuse)?;
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
    /// The integer n of the resonance (eq:resonance1 for p = 1, eq:resonancep with the plus sign for p >= 2).
    pub n: u32,
    /// The amplitudes across, inside those of Figure 7, with that of the resonance inside; none if they are to be chosen.
    pub amplitude: Option<[f64; 2]>,
    /// The frequencies up, likewise.
    pub frequency: Option<[f64; 2]>,
}

impl Figure8 {
    pub(super) fn read(
        section: &Section<'_>,
        fig07: &Figure7,
        oscillator: &LinearOscillator,
    ) -> Result<Self, ParameterError> {
        // Figure 7 was refused if they could not be listed.
        let mut free = fig07.resonances(oscillator).unwrap_or_default();
        let mut figure = Self { panels: Vec::new(), notes: Vec::new() };
        let listed =
            if section.has("panels") { tables(section, "panels", 0..=MOST_PANELS)? } else { Vec::new() };
        if listed.is_empty() {
            let chosen = fig07.loops.iter().cycle().take(MOST_PANELS);
            figure.panels.extend(chosen.map_while(|&p| take(&mut free, p)));
            return Ok(figure);
        }
        let mut replaced = Vec::new();
        for section in listed {
            match Panel::read(&section, fig07, oscillator)? {
                (panel, true) => {
                    free.retain(|other| (other.loops(), other.index()) != (panel.loops, panel.n));
                    figure.panels.push(panel);
                }
                (panel, false) => replaced.push((figure.panels.len(), section, panel)),
            }
        }
        // From the last to the first, as places before one that is filled do not move.
        for (index, section, Panel { loops: p, n, .. }) in replaced.into_iter().rev() {
            let missing = format!(
                "{}: the resonance p = {p}, n = {n} does not lie in the window of Figure 7",
                section.told("n")
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

/// Takes the resonance of highest frequency out of the list for a panel: one with p loops if there is one.
fn take(free: &mut Vec<Resonance>, p: u32) -> Option<Panel> {
    let last = free.iter().rposition(|resonance| resonance.loops() == p).or(free.len().checked_sub(1))?;
    let taken = free.remove(last);
    Some(Panel { loops: taken.loops(), n: taken.index(), amplitude: None, frequency: None })
}

impl Panel {
    /// The panel that the file asks for, and whether there is one: not if its resonance lies outside the window and its own window is
    /// no must.
    fn read(
        section: &Section<'_>,
        fig07: &Figure7,
        oscillator: &LinearOscillator,
    ) -> Result<(Self, bool), ParameterError> {
        let loops: u32 = section.value("loops")?;
        if !fig07.loops.contains(&loops) {
            return Err(section.refusal("loops").into());
        }
        let n = section.count("n", 0..=MOST_N)?;
        let resonance = oscillator.resonance(loops, n).map_err(|_| section.refusal("n"))?;
        let axes = [
            ("amplitude", fig07.window.primary, resonance.grazing().amplitude()),
            ("frequency", fig07.window.secondary, resonance.forcing_frequency()),
        ];
        let mut shown = [None; 2];
        for (shown, (name, whole, at)) in shown.iter_mut().zip(axes) {
            if section.has(name) {
                let range = range_inside(section, name, &format!("fig07.{name}"), whole)?;
                if !strictly_contains(range, at) {
                    let allowed = format!(
                        "the range must contain the {name} {at:.5} of the resonance p = {loops}, n = {n}"
                    );
                    return Err(ParameterError::Unfit(section.forbid(name, allowed)));
                }
                *shown = Some(range);
            }
        }
        let there = axes.iter().all(|&(_, whole, at)| contains(whole, at)) || shown != [None; 2];
        if section.has("near") {
            let section = section.table("near")?;
            let near = [range(&section, "amplitude", any)?, range(&section, "frequency", any)?];
            let fits = |(near, (_, whole, at)): ([f64; 2], (_, [f64; 2], f64))| {
                strictly_contains(near, at) && encloses(whole, near)
            };
            if near.into_iter().zip(axes).all(fits) {
                shown = [shown[0].or(Some(near[0])), shown[1].or(Some(near[1]))];
            }
        }
        let [amplitude, frequency] = shown;
        Ok((Self { loops, n, amplitude, frequency }, there))
    }
}
