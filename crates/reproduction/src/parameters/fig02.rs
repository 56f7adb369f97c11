//! `[fig02]`: the one-parameter diagram of Figure 2 and its phase portraits.

use grazing_source::{Source, place as place_of};
use grazing_theorems::LinearOscillator;
use serde::Deserialize;
use toml::Spanned;

use super::requirements::{MOST_AMPLITUDES, MOST_ORBITS, MOST_PERIODS, MOST_PERIODS_IN_ALL, MOST_PORTRAITS};
use super::validate::{
    Checked, amplitudes, bound_members, demand, loops, range, range_inside, refusal, refused, unfit,
};
use super::{Range, validate};

/// `[fig02]` as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub(super) struct Raw {
    frequency: Spanned<f64>,
    amplitude: Option<Spanned<Vec<f64>>>,
    near: Option<Spanned<Vec<f64>>>,
    x: Spanned<Vec<f64>>,
    loops: Spanned<Vec<Spanned<u32>>>,
    magnification: RawMagnification,
    attractor: RawAttractor,
    portraits: Option<Spanned<Vec<RawPortrait>>>,
}

/// `[fig02.magnification]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
struct RawMagnification {
    amplitude: Spanned<Vec<f64>>,
    x: Spanned<Vec<f64>>,
}

/// `[fig02.attractor]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
struct RawAttractor {
    amplitudes: Spanned<u32>,
    orbits: Spanned<u32>,
    transient: Spanned<u32>,
    recorded: Spanned<u32>,
    seed: Spanned<u64>,
}

/// One of `[[fig02.portraits]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
struct RawPortrait {
    loops: Spanned<u32>,
    amplitude: Option<Spanned<f64>>,
    near: Option<Spanned<f64>>,
}

/// Figure 2: one frequency, the amplitude across, x on Pi up.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure2 {
    frequency: f64,
    amplitude: Range,
    x: Range,
    loops: Vec<u32>,
    magnified_amplitude: Range,
    magnified_x: Range,
    attractor: Attractor,
    portraits: Vec<Portrait>,
    notes: Vec<String>,
}

impl Figure2 {
    /// The forcing frequency omega, positive.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// The forcing amplitudes across; A_graz of the frequency lies strictly inside.
    pub fn amplitude(&self) -> Range {
        self.amplitude
    }

    /// The x-values up.
    pub fn x(&self) -> Range {
        self.x
    }

    /// The numbers of loops p that are followed: at least one, each 1 or more, none twice, as ordered in the file.
    pub fn loops(&self) -> &[u32] {
        &self.loops
    }

    /// The amplitudes of the magnification, inside [`Figure2::amplitude`].
    pub fn magnified_amplitude(&self) -> Range {
        self.magnified_amplitude
    }

    /// The x-values of the magnification, inside [`Figure2::x`].
    pub fn magnified_x(&self) -> Range {
        self.magnified_x
    }

    /// How the long-time behaviour between GZ and PD is sampled.
    pub fn attractor(&self) -> &Attractor {
        &self.attractor
    }

    /// The phase portraits from left to right; none if they are to be chosen.
    pub fn portraits(&self) -> &[Portrait] {
        &self.portraits
    }

    /// What is shown in the place of something else, in sentences.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }
}

/// How many orbits of Figure 2 run for how long between GZ and PD.
#[derive(Debug, Clone, PartialEq)]
pub struct Attractor {
    amplitudes: u32,
    orbits: u32,
    transient: u32,
    recorded: u32,
    seed: u64,
}

impl Attractor {
    /// The number of amplitudes, evenly spaced between GZ and PD, at least 2.
    pub fn amplitudes(&self) -> u32 {
        self.amplitudes
    }

    /// The orbits at each amplitude, from random initial points, at least 1.
    pub fn orbits(&self) -> u32 {
        self.orbits
    }

    /// The forcing periods before an orbit is recorded; may be 0.
    pub fn transient(&self) -> u32 {
        self.transient
    }

    /// The forcing periods for which an orbit is recorded, at least 1.
    pub fn recorded(&self) -> u32 {
        self.recorded
    }

    /// The seed of the random initial points.
    pub fn seed(&self) -> u64 {
        self.seed
    }
}

/// One phase portrait above Figure 2.
#[derive(Debug, Clone, PartialEq)]
pub struct Portrait {
    loops: u32,
    place: Place,
    key: String,
}

impl Portrait {
    /// The loops p of the maximal periodic solution, one of [`Figure2::loops`]; 0 is the non-impacting solution.
    pub fn loops(&self) -> u32 {
        self.loops
    }

    /// At which amplitude it is shown.
    pub fn place(&self) -> Place {
        self.place
    }

    /// The key of the file that says so, with line and value: the beginning of a message.
    pub fn key(&self) -> &str {
        &self.key
    }
}

/// The forcing amplitude at which a portrait is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// This one, inside [`Figure2::amplitude`].
    At(f64),
    /// This one, or if the solution is not there, the nearest at which it is.
    Near(f64),
    /// Any.
    Anywhere,
}

pub(super) fn check(raw: &Raw, oscillator: &LinearOscillator, source: &Source<'_>) -> Checked<Figure2> {
    let frequency = frequency(raw, source)?;
    let grazing = oscillator
        .grazing(frequency)
        .map_err(|error| refused(source, "fig02.frequency", &raw.frequency, error.to_string()))?
        .amplitude();
    let across = across(raw, source, frequency, grazing)?;
    let x = range(source, "fig02.x", &raw.x, f64::is_finite)?;
    let loops = loops(source, "fig02.loops", &raw.loops)?;
    let magnified_x = range_inside(source, "fig02.magnification.x", &raw.magnification.x, "fig02.x", &x)?;
    let attractor = attractor(&raw.attractor, source)?;
    let portraits = match &raw.portraits {
        Some(portraits) => self::portraits(portraits, &loops, &across, source)?,
        None => Vec::new(),
    };
    let Across { amplitude, magnified: magnified_amplitude, notes, .. } = across;
    Ok(Figure2 {
        frequency,
        amplitude,
        x,
        loops,
        magnified_amplitude,
        magnified_x,
        attractor,
        portraits,
        notes,
    })
}

/// The amplitudes across.
struct Across {
    amplitude: Range,
    magnified: Range,
    /// What wishes for amplitudes are multiplied by.
    factor: f64,
    notes: Vec<String>,
}

/// The part of the magnified amplitudes that lies below grazing where the program places them: next to it is what they are to show.
const BEFORE: f64 = 0.1;

/// The amplitudes across, which contain that of grazing: those of the file, or if these are no must, others in the same proportions.
fn across(raw: &Raw, source: &Source<'_>, frequency: f64, grazing: f64) -> Checked<Across> {
    let (key, written) = match (&raw.amplitude, &raw.near) {
        (Some(written), _) => ("fig02.amplitude", written),
        (None, Some(written)) => ("fig02.near", written),
        (None, None) => return Err(source.missing("fig02", "near", raw.frequency.span().start).into()),
    };
    let amplitude = amplitudes(source, key, written)?;
    if raw.amplitude.is_some() && !amplitude.strictly_contains(grazing) {
        let allowed = format!(
            "the range must contain the grazing amplitude {grazing:.5} of the frequency {frequency}, from which the \
             branches emanate"
        );
        return Err(unfit(source, key, written, allowed));
    }
    let part = &raw.magnification.amplitude;
    let magnified = range_inside(source, "fig02.magnification.amplitude", part, key, &amplitude)?;
    if amplitude.strictly_contains(grazing) {
        return Ok(Across { amplitude, magnified, factor: 1.0, notes: Vec::new() });
    }
    let factor = grazing / (magnified.lower() + BEFORE * magnified.width());
    let scaled = |range: Range| Range::new(range.lower() * factor, range.upper() * factor);
    let Some([moved, magnified]) = scaled(amplitude).zip(scaled(magnified)).map(|(a, b)| [a, b]) else {
        return Err(refusal(source, key, written));
    };
    let (file, line) = source.place(written.span().start);
    let note = format!(
        "{}: {key} = [{}, {}] does not contain the grazing amplitude {grazing:.5} of the frequency {frequency}: the figure shows \
         [{:.5}, {:.5}], with its magnification and its portraits in the same proportion",
        place_of(&file, line),
        amplitude.lower(),
        amplitude.upper(),
        moved.lower(),
        moved.upper()
    );
    Ok(Across { amplitude: moved, magnified, factor, notes: vec![note] })
}

/// The forcing frequency alone.
pub(super) fn frequency(raw: &Raw, source: &Source<'_>) -> Checked<f64> {
    validate::frequency(source, "fig02.frequency", &raw.frequency)
}

fn portraits(
    raw: &Spanned<Vec<RawPortrait>>,
    loops: &[u32],
    across: &Across,
    source: &Source<'_>,
) -> Checked<Vec<Portrait>> {
    bound_members(source, "fig02.portraits", raw, 0..=MOST_PORTRAITS)?;
    let mut portraits = Vec::new();
    for (portrait, number) in raw.get_ref().iter().zip(1..) {
        let key = |name: &str| format!("fig02.portraits[{number}].{name}");
        let shown = demand(source, &key("loops"), &portrait.loops, |p| p == 0 || loops.contains(&p))?;
        let place = match (&portrait.amplitude, &portrait.near) {
            (Some(at), _) => {
                Place::At(demand(source, &key("amplitude"), at, |a| across.amplitude.contains(a))?)
            }
            (None, Some(near)) => {
                Place::Near(across.factor * demand(source, &key("near"), near, |a| a >= 0.0)?)
            }
            (None, None) => Place::Anywhere,
        };
        let (name, span, value) = match (&portrait.amplitude, &portrait.near) {
            (Some(at), _) => ("amplitude", at.span(), source.raw(at.span()).to_owned()),
            (None, Some(near)) => ("near", near.span(), source.raw(near.span()).to_owned()),
            (None, None) => ("loops", portrait.loops.span(), shown.to_string()),
        };
        let (file, line) = source.place(span.start);
        let key = format!("{}: {} = {value}", place_of(&file, line), key(name));
        portraits.push(Portrait { loops: shown, place, key });
    }
    Ok(portraits)
}

fn attractor(raw: &RawAttractor, source: &Source<'_>) -> Checked<Attractor> {
    let count = |key: &str, value: &Spanned<u32>, least: u32, most: u32| {
        demand(source, &format!("fig02.attractor.{key}"), value, |count| least <= count && count <= most)
    };
    let amplitudes = count("amplitudes", &raw.amplitudes, 2, MOST_AMPLITUDES)?;
    let orbits = count("orbits", &raw.orbits, 1, MOST_ORBITS)?;
    let transient = count("transient", &raw.transient, 0, MOST_PERIODS)?;
    let recorded = count("recorded", &raw.recorded, 1, MOST_PERIODS)?;
    let periods = u64::from(amplitudes) * u64::from(orbits) * (u64::from(transient) + u64::from(recorded));
    if periods > MOST_PERIODS_IN_ALL {
        let allowed = format!(
            "amplitudes * orbits * (transient + recorded) = {periods} forcing periods are too many, at most \
             {MOST_PERIODS_IN_ALL} are allowed"
        );
        return Err(refused(source, "fig02.attractor.transient", &raw.transient, allowed));
    }
    Ok(Attractor { amplitudes, orbits, transient, recorded, seed: *raw.seed.get_ref() })
}
