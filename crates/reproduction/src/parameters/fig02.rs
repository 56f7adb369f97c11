//! `[fig02]`: the one-parameter diagram of Figure 2 and its phase portraits.

use grazing_source::{Section, SourceError};
use grazing_theorems::LinearOscillator;
use grazing_unfold::one_parameter::Plan;

use super::ParameterError;
use super::checks::{
    amplitudes, any, contains, frequency, grazing, range, range_inside, strictly_contains, tables,
};
use super::requirements::{
    MOST_AMPLITUDES, MOST_LOOPS, MOST_ORBITS, MOST_PERIODS, MOST_PERIODS_IN_ALL, MOST_PORTRAITS,
};

/// Figure 2: one frequency, the amplitude across, x on Pi up.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Figure2 {
    /// The forcing frequency omega, positive.
    pub frequency: f64,
    /// The forcing amplitudes across; A_graz of the frequency lies strictly inside.
    pub amplitude: [f64; 2],
    /// The x-values up.
    pub x: [f64; 2],
    /// The numbers of loops p that are followed: at least one, each 1 or more, none twice, as ordered in the file.
    pub loops: Vec<u32>,
    /// The amplitudes of the magnification, inside those of the figure.
    pub magnified_amplitude: [f64; 2],
    /// The x-values of the magnification, inside those of the figure.
    pub magnified_x: [f64; 2],
    /// How the long-time behaviour between GZ and PD is sampled, at amplitudes evenly spaced.
    pub attractor: Plan,
    /// The phase portraits from left to right; none if they are to be chosen.
    pub portraits: Vec<Portrait>,
    /// What is shown in the place of something else, in sentences.
    pub notes: Vec<String>,
}

/// One phase portrait above Figure 2.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Portrait {
    /// The loops p of the maximal periodic solution, one of those of the figure; 0 is the non-impacting solution.
    pub loops: u32,
    /// The forcing amplitude at which it is shown; if there is none, at any.
    pub amplitude: Option<f64>,
    /// Whether it is shown there or not at all; otherwise, if the solution is not there, at the nearest amplitude at which it is.
    pub must: bool,
    /// The key of the file that says so, with line and value: the beginning of a message.
    pub key: String,
}

impl Figure2 {
    pub(super) fn read(section: &Section<'_>, oscillator: &LinearOscillator) -> Result<Self, ParameterError> {
        let frequency = frequency(section)?;
        let grazing = grazing(section, oscillator, frequency)?.amplitude();
        let across = Across::read(section, frequency, grazing)?;
        let x = range(section, "x", any)?;
        let loops = section.counts("loops", 1..=MOST_LOOPS)?;
        let magnified_x = range_inside(&section.table("magnification")?, "x", "fig02.x", x)?;
        let attractor = plan(&section.table("attractor")?)?;
        let mut portraits = Vec::new();
        if section.has("portraits") {
            for portrait in tables(section, "portraits", 0..=MOST_PORTRAITS)? {
                portraits.push(Portrait::read(&portrait, &loops, &across)?);
            }
        }
        let Across { amplitude, magnified: magnified_amplitude, notes, .. } = across;
        Ok(Self {
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
}

/// The amplitudes across.
struct Across {
    amplitude: [f64; 2],
    magnified: [f64; 2],
    /// What wishes for amplitudes are multiplied by.
    factor: f64,
    notes: Vec<String>,
}

/// The part of the magnified amplitudes that lies below grazing where the program places them: next to it is what they are to show.
const BEFORE: f64 = 0.1;

impl Across {
    /// The amplitudes across, which contain that of grazing: those of the file, or if these are no must, others in the same proportions.
    fn read(section: &Section<'_>, frequency: f64, grazing: f64) -> Result<Self, ParameterError> {
        // Of the right type even where it does not matter.
        section.optional::<Vec<f64>>("near")?;
        let must = section.has("amplitude");
        let name = if must { "amplitude" } else { "near" };
        let (key, amplitude) = (section.key(name), amplitudes(section, name)?);
        let there = strictly_contains(amplitude, grazing);
        if must && !there {
            let allowed = format!(
                "the range must contain the grazing amplitude {grazing:.5} of the frequency {frequency}, from which the \
                 branches emanate"
            );
            return Err(ParameterError::Unfit(section.forbid(name, allowed)));
        }
        let magnified = range_inside(&section.table("magnification")?, "amplitude", &key, amplitude)?;
        if there {
            return Ok(Self { amplitude, magnified, factor: 1.0, notes: Vec::new() });
        }
        let factor = grazing / (magnified[0] + BEFORE * (magnified[1] - magnified[0]));
        let [moved, magnified] = [amplitude, magnified].map(|range| range.map(|end| end * factor));
        if [moved, magnified].iter().any(|[lower, upper]| !(upper.is_finite() && lower < upper)) {
            return Err(section.refusal(name).into());
        }
        let ([lower, upper], [from, to]) = (amplitude, moved);
        let note = format!(
            "{}: {key} = [{lower}, {upper}] does not contain the grazing amplitude {grazing:.5} of the frequency {frequency}: \
             the figure shows [{from:.5}, {to:.5}], with its magnification and its portraits in the same proportion",
            section.place(name),
        );
        Ok(Self { amplitude: moved, magnified, factor, notes: vec![note] })
    }
}

impl Portrait {
    fn read(section: &Section<'_>, loops: &[u32], across: &Across) -> Result<Self, SourceError> {
        let shown: u32 = section.value("loops")?;
        if shown != 0 && !loops.contains(&shown) {
            return Err(section.refusal("loops"));
        }
        let near: Option<f64> = section.optional("near")?;
        let must = section.has("amplitude");
        let (name, amplitude) = if must {
            ("amplitude", Some(section.number("amplitude", |a| contains(across.amplitude, a))?))
        } else if near.is_some() {
            ("near", Some(across.factor * section.number("near", |a| a >= 0.0)?))
        } else {
            ("loops", None)
        };
        Ok(Self { loops: shown, amplitude, must, key: section.told(name) })
    }
}

/// How many orbits run for how long at how many amplitudes.
fn plan(section: &Section<'_>) -> Result<Plan, SourceError> {
    let values = section.count("amplitudes", 2..=MOST_AMPLITUDES)?;
    let orbits = section.count("orbits", 1..=MOST_ORBITS)?;
    let transient = section.count("transient", 0..=MOST_PERIODS)?;
    let recorded = section.count("recorded", 1..=MOST_PERIODS)?;
    let periods = u64::from(values) * u64::from(orbits) * (u64::from(transient) + u64::from(recorded));
    if periods > MOST_PERIODS_IN_ALL {
        let allowed = format!(
            "amplitudes * orbits * (transient + recorded) = {periods} forcing periods are too many, at most \
             {MOST_PERIODS_IN_ALL} are allowed"
        );
        return Err(section.forbid("transient", allowed));
    }
    Ok(Plan { values, orbits, transient, recorded, seed: section.value("seed")? })
}
