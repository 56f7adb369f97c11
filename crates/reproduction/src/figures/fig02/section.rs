//! `[fig02]`: the one-parameter diagram of Figure 2 and its phase portraits.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_input::SourceError;
use grazing_input::kind::{count, counts, derived, maybe, number, table, tables, unwritten, value};
use grazing_unfold::one_parameter::Sampling;

use crate::figure::prelude::*;
use crate::parameters::limits::{
    AMPLITUDES, FREQUENCIES, FREQUENCY, LOOPS, MOST_LOOPS, amplitudes, grazing, must_lie_inside, range,
};
use crate::parameters::{contains, strictly_contains};

/// The greatest number of portraits side by side on a page.
pub(super) const MOST_PORTRAITS: usize = 6;
/// The greatest number of forcing periods of one orbit.
const MOST_PERIODS: u32 = 1_000_000;
/// The greatest number of forcing periods of all orbits together, about a minute of computation.
const MOST_PERIODS_IN_ALL: u64 = 200_000_000;

keys! {
    /// Figure 2: one frequency, the amplitude across, x on Pi up.
    pub struct Figure2 {
        /// The forcing frequency omega.
        frequency: f64 = number(FREQUENCIES), FREQUENCY;
        /// The forcing amplitudes across, with that of grazing strictly inside.
        across: Wish<[f64; 2]> = derived(wished_range);
        /// The x-values up.
        x: [f64; 2] = range(), "the x-values must be a range [lower, upper] with {} <= lower < upper <= {}";
        /// The numbers of loops p that are followed.
        loops: Vec<u32> = counts(1..=MOST_LOOPS), LOOPS;
        /// The part that is magnified.
        magnification: Magnification = table(), "the table [fig02.magnification] holds amplitude and x";
        /// How the long-time behaviour between GZ and PD is sampled, at amplitudes evenly spaced.
        attractor: Sampling = table::<Attractor>().map(sampling),
            "the table [fig02.attractor] holds amplitudes, orbits, transient, recorded and seed";
        /// The phase portraits from left to right; none if they are to be chosen.
        portraits: Vec<Portrait> = tables(0..=MOST_PORTRAITS),
            "[[fig02.portraits]] must be at most six tables, one for each phase portrait; without any they are chosen";
        /// Sentences about contents that differ from those requested.
        notes: Vec<String> = unwritten();
    }
}

/// A requested value: mandatory under `amplitude`, replaceable under `near`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wish<T> {
    /// The range of amplitudes, or one amplitude.
    pub value: T,
    /// Whether the value is mandatory.
    pub must: bool,
}

impl<T> Wish<T> {
    /// The mandatory value takes precedence over the replaceable one.
    fn new(amplitude: Option<T>, near: Option<T>) -> Option<Self> {
        let must = amplitude.is_some();
        Some(Self { value: amplitude.or(near)?, must })
    }

    /// The key that holds the value.
    fn key(&self) -> &'static str {
        if self.must { "amplitude" } else { "near" }
    }
}

keys! {
    /// The amplitudes across as they are written.
    struct Range {
        /// The forcing amplitudes, these or none.
        amplitude: Option<[f64; 2]> = maybe(amplitudes()), AMPLITUDES;
        /// The forcing amplitudes, if grazing is among them.
        near: Option<[f64; 2]> = maybe(amplitudes()), AMPLITUDES;
    }
}

fn wished_range(written: Range, section: &Section<'_>) -> Result<Wish<[f64; 2]>, SourceError> {
    Wish::new(written.amplitude, written.near).ok_or_else(|| section.lack("near"))
}

keys! {
    /// The part of Figure 2 that is magnified.
    pub struct Magnification {
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
    /// One phase portrait above Figure 2.
    pub struct Portrait {
        /// The loops p of the maximal periodic solution; 0 is the non-impacting solution.
        loops: u32 = value(), "the number of loops must be one of fig02.loops, or 0 for the non-impacting solution";
        /// The forcing amplitude at which it is shown or not at all, or else, if the solution is
        /// not there, at the nearest amplitude at which it is; if there is none, at any.
        wish: Option<Wish<f64>> = derived(|written: Place, _| Ok(Wish::new(written.amplitude, written.near)));
        /// The key of the file that says so, with line and value: the beginning of a message.
        key: String = unwritten();
    }
}

keys! {
    /// The amplitude of a portrait as it is written.
    struct Place {
        /// The forcing amplitude, this or none.
        amplitude: Option<f64> = maybe(number(..)), "the forcing amplitude must lie inside those of Figure 2";
        /// The forcing amplitude, or the nearest at which the solution is there.
        near: Option<f64> = maybe(number(0.0..)), "the forcing amplitude must be a number that is not negative";
    }
}

impl FileSection for Figure2 {
    const NAME: &'static str = "fig02";
    const REQUIREMENT: &'static str = "the table [fig02] says what Figure 2 shows";

    fn checked(mut self, section: &Section<'_>, parameters: &Parameters) -> Result<Self, ParameterError> {
        let grazing = grazing(section, &parameters.oscillator()?, self.frequency)?.amplitude();
        let factor = self.hold(grazing, section)?;
        must_lie_inside(section, "magnification.x", self.magnification.x, ("fig02.x", self.x))?;
        for (mut portrait, number) in std::mem::take(&mut self.portraits).into_iter().zip(1..) {
            let at = |name: &str| format!("portraits[{number}].{name}");
            if portrait.loops != 0 && !self.loops.contains(&portrait.loops) {
                if portrait.wish.is_some_and(|wish| wish.must) {
                    return Err(section.refusal(&at("loops")).into());
                }
                let key = section.shown(&at("loops"));
                self.notes
                    .push(format!("{key}: no such portrait, as p is none of fig02.loops: add it there"));
                continue;
            }
            match &mut portrait.wish {
                Some(Wish { value, must: true }) if !contains(self.across.value, *value) => {
                    return Err(section.refusal(&at("amplitude")).into());
                }
                Some(Wish { value, must: false }) => *value *= factor,
                _ => {}
            }
            portrait.key = section.shown(&at(portrait.wish.map_or("loops", |wish| wish.key())));
            self.portraits.push(portrait);
        }
        // Orbits begin above the lower edge of the figure.
        self.attractor.lowest = Some(self.x[0].min(0.0));
        Ok(self)
    }
}

/// The fraction of the magnified amplitudes below grazing, if the program chooses them: the magnification
/// shows the vicinity of grazing.
const BEFORE: f64 = 0.1;

impl Figure2 {
    /// Makes the range of amplitudes contain that of grazing: a replaceable range is scaled, with its
    /// magnification. Returns the factor by which requested amplitudes are to be multiplied.
    fn hold(&mut self, grazing: f64, section: &Section<'_>) -> Result<f64, ParameterError> {
        let Wish { value: amplitude, must } = self.across;
        let (name, frequency, magnified) = (self.across.key(), self.frequency, self.magnification.amplitude);
        let key = section.key(name);
        let there = strictly_contains(amplitude, grazing);
        if must && !there {
            let allowed = format!(
                "the range must contain the grazing amplitude {grazing:.5} of the frequency {frequency}, from which the \
                 branches emanate"
            );
            return Err(ParameterError::Unfit(section.forbid(name, allowed)));
        }
        must_lie_inside(section, "magnification.amplitude", magnified, (&key, amplitude))?;
        if there {
            return Ok(1.0);
        }
        let factor = grazing / (magnified[0] + BEFORE * (magnified[1] - magnified[0]));
        let [moved, magnified] = [amplitude, magnified].map(|range| range.map(|end| end * factor));
        if [moved, magnified].iter().any(|[lower, upper]| !(upper.is_finite() && lower < upper)) {
            return Err(section.refusal(name).into());
        }
        let ([lower, upper], [from, to]) = (amplitude, moved);
        self.notes.push(format!(
            "{}: {key} = [{lower}, {upper}] does not contain the grazing amplitude {grazing:.5} of the frequency {frequency}: \
             the figure shows [{from:.5}, {to:.5}], with its magnification and its portraits in the same proportion",
            section.place(name),
        ));
        (self.across.value, self.magnification.amplitude) = (moved, magnified);
        Ok(factor)
    }
}

/// The forcing frequency of Figure 2, which Figure 4 and the printed numbers use as well, regardless of
/// the rest of its section.
///
/// # Errors
/// [`ParameterError`]: the frequency is invalid.
pub fn frequency(parameters: &Parameters) -> Result<f64, ParameterError> {
    parameters.read(Figure2::NAME, |section| Ok(number(FREQUENCIES).read(section, "frequency")?))
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
    Ok(Sampling {
        values,
        between,
        orbits,
        transient,
        recorded,
        lowest: None,
        seed,
        readings: false,
        impacts: 1,
    })
}
