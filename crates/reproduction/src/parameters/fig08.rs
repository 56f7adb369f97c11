//! `[fig08]`: about which resonances Figure 8 magnifies Figure 7.

use grazing_source::{Source, place};
use grazing_theorems::{LinearOscillator, Resonance};
use serde::Deserialize;
use toml::Spanned;

use super::requirements::{MOST_N, MOST_PANELS};
use super::validate::{Checked, bound_members, demand, range, range_inside, refusal, unfit};
use super::{Figure7, Range};

/// `[fig08]` as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Raw {
    panels: Option<Spanned<Vec<RawPanel>>>,
}

/// One of `[[fig08.panels]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
struct RawPanel {
    loops: Spanned<u32>,
    n: Spanned<u32>,
    amplitude: Option<Spanned<Vec<f64>>>,
    frequency: Option<Spanned<Vec<f64>>>,
    near: Option<RawNear>,
}

/// `[fig08.panels.near]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
struct RawNear {
    amplitude: Spanned<Vec<f64>>,
    frequency: Spanned<Vec<f64>>,
}

/// Figure 8: magnifications of Figure 7.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure8 {
    panels: Vec<Panel>,
    notes: Vec<String>,
}

impl Figure8 {
    /// The panels from left to right: one to three.
    pub fn panels(&self) -> &[Panel] {
        &self.panels
    }

    /// What is shown in the place of something else, in sentences.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }
}

/// One magnification around a resonance.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    loops: u32,
    n: u32,
    amplitude: Option<Range>,
    frequency: Option<Range>,
}

impl Panel {
    /// The loops p of the resonance, one of [`Figure7::loops`].
    pub fn loops(&self) -> u32 {
        self.loops
    }

    /// The integer n of the resonance (eq:resonance1 for p = 1, eq:resonancep with the plus sign for p >= 2).
    pub fn n(&self) -> u32 {
        self.n
    }

    /// The amplitudes across, inside those of Figure 7, with that of the resonance inside; none if they are to be chosen.
    pub fn amplitude(&self) -> Option<Range> {
        self.amplitude
    }

    /// The frequencies up, likewise.
    pub fn frequency(&self) -> Option<Range> {
        self.frequency
    }
}

pub(super) fn check(
    raw: &Raw,
    fig07: &Figure7,
    oscillator: &LinearOscillator,
    source: &Source<'_>,
) -> Checked<Figure8> {
    // Figure 7 was refused if they could not be listed.
    let mut free = fig07.resonances(oscillator).unwrap_or_default();
    let mut figure = Figure8 { panels: Vec::new(), notes: Vec::new() };
    let Some(panels) = raw.panels.as_ref().filter(|panels| !panels.get_ref().is_empty()) else {
        while figure.panels.len() < MOST_PANELS
            && let Some(next) =
                fig07.loops().iter().cycle().nth(figure.panels.len()).and_then(|&p| take(&mut free, p))
        {
            figure.panels.push(chosen(&next));
        }
        return Ok(figure);
    };
    bound_members(source, "fig08.panels", panels, 0..=MOST_PANELS)?;
    let mut replaced = Vec::new();
    for (panel, number) in panels.get_ref().iter().zip(1..) {
        match panel_about(panel, number, fig07, oscillator, source)? {
            Some(panel) => {
                free.retain(|other| (other.loops(), other.index()) != (panel.loops, panel.n));
                figure.panels.push(panel);
            }
            None => replaced.push((figure.panels.len(), number, panel)),
        }
    }
    // From the last to the first, as places before one that is filled do not move.
    for (index, number, panel) in replaced.into_iter().rev() {
        let (p, n) = (*panel.loops.get_ref(), *panel.n.get_ref());
        let (file, line) = source.place(panel.n.span().start);
        let missing = format!(
            "{}: fig08.panels[{number}].n = {n}: the resonance p = {p}, n = {n} does not lie in the window of Figure 7",
            place(&file, line)
        );
        match take(&mut free, p) {
            Some(other) => {
                let (loops, n) = (other.loops(), other.index());
                figure.notes.push(format!("{missing}; the panel shows p = {loops}, n = {n} instead"));
                figure.panels.insert(index, chosen(&other));
            }
            None => figure
                .notes
                .push(format!("{missing}, nor does another that is not shown; there is no such panel")),
        }
    }
    Ok(figure)
}

/// Takes the resonance of highest frequency out of the list: one with p loops if there is one.
fn take(free: &mut Vec<Resonance>, p: u32) -> Option<Resonance> {
    let last = free.iter().rposition(|resonance| resonance.loops() == p).or(free.len().checked_sub(1))?;
    Some(free.remove(last))
}

fn chosen(resonance: &Resonance) -> Panel {
    Panel { loops: resonance.loops(), n: resonance.index(), amplitude: None, frequency: None }
}

/// The panel that the file asks for; none if its resonance lies outside the window and its own window is no must.
fn panel_about(
    raw: &RawPanel,
    number: usize,
    fig07: &Figure7,
    oscillator: &LinearOscillator,
    source: &Source<'_>,
) -> Checked<Option<Panel>> {
    let key = |name: &str| format!("fig08.panels[{number}].{name}");
    let loops = demand(source, &key("loops"), &raw.loops, |p| fig07.loops().contains(&p))?;
    let n = demand(source, &key("n"), &raw.n, |n| n <= MOST_N)?;
    let resonance = oscillator.resonance(loops, n).map_err(|_| refusal(source, &key("n"), &raw.n))?;
    let (whole, at) = (fig07.window(), [resonance.grazing().amplitude(), resonance.forcing_frequency()]);
    let ranges = [
        ("amplitude", &raw.amplitude, whole.amplitude(), at[0]),
        ("frequency", &raw.frequency, whole.frequency(), at[1]),
    ];
    let mut shown = [None; 2];
    for (shown, (name, written, whole, at)) in shown.iter_mut().zip(ranges) {
        let Some(written) = written else { continue };
        let range = range_inside(source, &key(name), written, &format!("fig07.{name}"), &whole)?;
        if !range.strictly_contains(at) {
            let allowed =
                format!("the range must contain the {name} {at:.5} of the resonance p = {loops}, n = {n}");
            return Err(unfit(source, &key(name), written, allowed));
        }
        *shown = Some(range);
    }
    if !whole.contains(at[0], at[1]) && shown == [None; 2] {
        return Ok(None);
    }
    if let Some(near) = &raw.near {
        let amplitude = range(source, &key("near.amplitude"), &near.amplitude, f64::is_finite)?;
        let frequency = range(source, &key("near.frequency"), &near.frequency, f64::is_finite)?;
        let holds = amplitude.strictly_contains(at[0]) && frequency.strictly_contains(at[1]);
        let inside = whole.amplitude().encloses(&amplitude) && whole.frequency().encloses(&frequency);
        if holds && inside {
            shown = [shown[0].or(Some(amplitude)), shown[1].or(Some(frequency))];
        }
    }
    let [amplitude, frequency] = shown;
    Ok(Some(Panel { loops, n, amplitude, frequency }))
}
