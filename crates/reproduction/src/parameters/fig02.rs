//! `[fig02]`: the one-parameter diagram of Figure 2 and its phase portraits.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_source::kind::{count, counts, maybe, number, table, tables, value};
use grazing_source::{Keys, Section, SourceError, keys};
use grazing_theorems::LinearOscillator;
use grazing_unfold::one_parameter::Sampling;

use super::error::ParameterError;
use super::limits::{
    AMPLITUDES, FREQUENCIES, FREQUENCY, LOOPS, MOST_LOOPS, amplitudes, contains, grazing, must_lie_inside,
    range, strictly_contains,
};

/// The most portraits that fit side by side across a page.
pub(crate) const MOST_PORTRAITS: usize = 6;
/// The most forcing periods of one orbit.
const MOST_PERIODS: u32 = 1_000_000;
/// The most forcing periods of all orbits together, about a minute of computation.
const MOST_PERIODS_IN_ALL: u64 = 200_000_000;

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
    /// The numbers of loops p that are followed: at least one, each 1 or more, none twice, as
    /// ordered in the file.
    pub loops: Vec<u32>,
    /// The amplitudes of the magnification, inside those of the figure.
    pub magnified_amplitude: [f64; 2],
    /// The x-values of the magnification, inside those of the figure.
    pub magnified_x: [f64; 2],
    /// How the long-time behaviour between GZ and PD is sampled, at amplitudes evenly spaced.
    pub attractor: Sampling,
    /// The phase portraits from left to right; none if they are to be chosen.
    pub portraits: Vec<Portrait>,
    /// What is shown in the place of something else, in sentences.
    pub notes: Vec<String>,
}

/// One phase portrait above Figure 2.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Portrait {
    /// The loops p of the maximal periodic solution, one of those of the figure; 0 is the
    /// non-impacting solution.
    pub loops: u32,
    /// The forcing amplitude at which it is shown; if there is none, at any.
    pub amplitude: Option<f64>,
    /// Whether it is shown there or not at all; otherwise, if the solution is not there, at the
    /// nearest amplitude at which it is.
    pub must: bool,
    /// The key of the file that says so, with line and value: the beginning of a message.
    pub key: String,
}

keys! {
    /// The section as it is written.
    pub(super) struct Section2 {
        /// The forcing frequency.
        frequency: f64 = number(FREQUENCIES), FREQUENCY;
        /// The forcing amplitudes, these or none.
        amplitude: Option<[f64; 2]> = maybe(amplitudes()), AMPLITUDES;
        /// The forcing amplitudes, if grazing is among them.
        near: Option<[f64; 2]> = maybe(amplitudes()), AMPLITUDES;
        /// The x-values.
        x: [f64; 2] = range(), "the x-values must be a range [lower, upper] with {} <= lower < upper <= {}";
        /// The numbers of loops.
        loops: Vec<u32> = counts(1..=MOST_LOOPS), LOOPS;
        /// The part that is magnified.
        magnification: Magnification = table(), "the table [fig02.magnification] holds amplitude and x";
        /// Simulation.
        attractor: Sampling = table::<Attractor>().map(sampling),
            "the table [fig02.attractor] holds amplitudes, orbits, transient, recorded and seed";
        /// The phase portraits.
        portraits: Vec<WrittenPortrait> = tables(0..=MOST_PORTRAITS),
            "[[fig02.portraits]] must be at most six tables, one for each phase portrait; without any they are chosen";
    }
}

keys! {
    /// The part of Figure 2 that is magnified.
    pub(super) struct Magnification {
        /// The amplitudes across.
        amplitude: [f64; 2] = range(), "the magnified amplitudes must be a range [lower, upper] inside those of Figure 2";
        /// The x-values up.
        x: [f64; 2] = range(), "the magnified x-values must be a range [lower, upper] inside fig02.x";
    }
}

keys! {
    /// How many orbits run for how long at how many amplitudes.
    struct Attractor {
        /// The amplitudes: at most more than the columns of any printed figure.
        amplitudes: u32 = count(2..=10_000), "the number of amplitudes must be a whole number from {} to {}";
        /// The orbits at one amplitude.
        orbits: u32 = count(1..=1_000), "the number of orbits must be a whole number from {} to {}";
        /// The forcing periods before an orbit is recorded.
        transient: u32 = count(0..=MOST_PERIODS), "the periods before recording must be a whole number from {} to {}";
        /// The forcing periods that are recorded.
        recorded: u32 = count(1..=MOST_PERIODS), "the recorded periods must be a whole number from {} to {}";
        /// The seed of the random initial points.
        seed: u64 = value(), "the seed must be a whole number that is not negative";
    }
}

keys! {
    /// A portrait as it is written.
    pub(super) struct WrittenPortrait {
        /// The loops p of the solution.
        loops: u32 = value(), "the number of loops must be one of fig02.loops, or 0 for the non-impacting solution";
        /// The forcing amplitude, this or none.
        amplitude: Option<f64> = maybe(number(..)), "the forcing amplitude must lie inside those of Figure 2";
        /// The forcing amplitude, or the nearest at which the solution is there.
        near: Option<f64> = maybe(number(0.0..)), "the forcing amplitude must be a number that is not negative";
    }
}

impl Figure2 {
    pub(super) fn checked(
        section: &Section<'_>,
        oscillator: &LinearOscillator,
    ) -> Result<Self, ParameterError> {
        let written = Section2::read(section)?;
        let grazing = grazing(section, oscillator, written.frequency)?.amplitude();
        let across = Across::new(section, &written, grazing)?;
        let Section2 { frequency, x, loops, magnification, attractor, portraits, .. } = written;
        must_lie_inside(section, "magnification.x", magnification.x, ("fig02.x", x))?;
        let portrait = |(portrait, number): (&WrittenPortrait, u32)| {
            Portrait::new(portrait, &loops, &across, section, &format!("portraits[{number}]"))
        };
        let portraits = portraits.iter().zip(1..).map(portrait).collect::<Result<_, _>>()?;
        let Across { amplitude, magnified: magnified_amplitude, notes, .. } = across;
        let magnified_x = magnification.x;
        Ok(Self {
            frequency,
            amplitude,
            x,
            loops,
            magnified_amplitude,
            magnified_x,
            // Orbits begin above the lower edge of the figure.
            attractor: Sampling { lowest: Some(x[0].min(0.0)), ..attractor },
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

/// The part of the magnified amplitudes that lies below grazing where the program places them: next
/// to it is what they are to show.
const BEFORE: f64 = 0.1;

impl Across {
    /// The amplitudes across, which contain that of grazing: those of the file, or if other ones
    /// may be shown, those in the same proportions.
    fn new(section: &Section<'_>, written: &Section2, grazing: f64) -> Result<Self, ParameterError> {
        let (name, amplitude) = match (written.amplitude, written.near) {
            (Some(amplitude), _) => ("amplitude", amplitude),
            (None, Some(near)) => ("near", near),
            (None, None) => return Err(section.lack("near").into()),
        };
        let (key, frequency) = (section.key(name), written.frequency);
        let there = strictly_contains(amplitude, grazing);
        if written.amplitude.is_some() && !there {
            let allowed = format!(
                "the range must contain the grazing amplitude {grazing:.5} of the frequency {frequency}, from which the \
                 branches emanate"
            );
            return Err(ParameterError::Unfit(section.forbid(name, allowed)));
        }
        let magnified = written.magnification.amplitude;
        must_lie_inside(section, "magnification.amplitude", magnified, (&key, amplitude))?;
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
    fn new(
        written: &WrittenPortrait,
        known: &[u32],
        across: &Across,
        section: &Section<'_>,
        at: &str,
    ) -> Result<Self, SourceError> {
        let WrittenPortrait { loops, amplitude, near } = *written;
        let place = |name: &str| format!("{at}.{name}");
        if loops != 0 && !known.contains(&loops) {
            return Err(section.refusal(&place("loops")));
        }
        let must = amplitude.is_some();
        let (name, amplitude) = match (amplitude, near) {
            (Some(amplitude), _) if !contains(across.amplitude, amplitude) => {
                return Err(section.refusal(&place("amplitude")));
            }
            (Some(amplitude), _) => ("amplitude", Some(amplitude)),
            (None, Some(near)) => ("near", Some(across.factor * near)),
            (None, None) => ("loops", None),
        };
        Ok(Self { loops, amplitude, must, key: section.shown(&place(name)) })
    }
}

fn sampling(written: Attractor, section: &Section<'_>, name: &str) -> Result<Sampling, SourceError> {
    let Attractor { amplitudes: values, orbits, transient, recorded, seed } = written;
    let periods = u64::from(values) * u64::from(orbits) * (u64::from(transient) + u64::from(recorded));
    if periods > MOST_PERIODS_IN_ALL {
        let allowed = format!(
            "amplitudes * orbits * (transient + recorded) = {periods} forcing periods are too many, at most \
             {MOST_PERIODS_IN_ALL} are allowed"
        );
        return Err(section.forbid(&format!("{name}.transient"), allowed));
    }
    let between = Some([Bifurcation::Grazing, Bifurcation::PeriodDoubling]);
    Ok(Sampling { values, between, orbits, transient, recorded, lowest: None, seed })
}
