//! From the file as written to parameters that can be computed with.

mod space;

use std::ops::RangeInclusive;

use grazing_theorems::{LinearOscillator, Resonance, TheoryError};
use toml::Spanned;

use super::ParameterError;
use super::range::{Range, Rectangle};
use super::raw;
use super::requirements::{
    MOST_AMPLITUDES, MOST_LOOPS, MOST_N, MOST_ORBITS, MOST_PERIODS, MOST_PERIODS_IN_ALL, MOST_PORTRAITS,
    PANELS, requirement,
};
use super::{Attractor, Figure2, Figure7, Figure8, Panel, Parameters, Portrait};
use super::{fig04, fig05, fig06, fig10};
use grazing_source::Source;

type Checked<T> = Result<T, ParameterError>;

/// Checks everything in the order of the file.
pub(super) fn parameters(file: raw::File, source: &Source<'_>) -> Checked<Parameters> {
    let zeta = demand(source, "oscillator.zeta", &file.oscillator.zeta, |zeta| 0.0 < zeta && zeta < 1.0)?;
    let epsilon = demand(source, "oscillator.epsilon", &file.oscillator.epsilon, |epsilon| {
        0.0 < epsilon && epsilon <= 1.0
    })?;
    let oscillator = LinearOscillator::new(zeta, epsilon)
        .map_err(|error| source.forbid("oscillator.zeta", &file.oscillator.zeta, error.to_string()))?;
    let fig01 = space::figure1(&file.fig01, source)?;
    let fig02 = figure2(&file.fig02, &oscillator, source)?;
    let fig03 = space::figure3(&file.fig03, source)?;
    let fig04 = fig04::check(&file.fig04, source)?;
    let fig05 = fig05::check(&file.fig05, &oscillator, source)?;
    let fig06 = fig06::check(&file.fig06, &oscillator, source)?;
    let fig07 = figure7(&file.fig07, &oscillator, source)?;
    let fig08 = figure8(&file.fig08, &fig07, &oscillator, source)?;
    let fig09 = space::figure9(&file.fig09, source)?;
    let fig10 = fig10::check(&file.fig10, &oscillator, source)?;
    Ok(Parameters { zeta, epsilon, fig01, fig02, fig03, fig04, fig05, fig06, fig07, fig08, fig09, fig10 })
}

fn figure2(raw: &raw::Figure2, oscillator: &LinearOscillator, source: &Source<'_>) -> Checked<Figure2> {
    let frequency = demand(source, "fig02.frequency", &raw.frequency, |frequency| frequency > 0.0)?;
    let amplitude = range(source, "fig02.amplitude", &raw.amplitude, |lower| lower >= 0.0)?;
    let grazing = oscillator
        .grazing(frequency)
        .map_err(|error| source.forbid("fig02.frequency", &raw.frequency, error.to_string()))?
        .amplitude();
    if !amplitude.strictly_contains(grazing) {
        let allowed = format!(
            "the range must contain the grazing amplitude {grazing:.5} of the frequency {frequency}, from which the \
             branches emanate"
        );
        return Err(source.forbid("fig02.amplitude", &raw.amplitude, allowed));
    }
    let x = range(source, "fig02.x", &raw.x, f64::is_finite)?;
    let loops = loops(source, "fig02.loops", &raw.loops)?;
    let part = &raw.magnification;
    let magnified_amplitude = range_inside(
        source,
        "fig02.magnification.amplitude",
        &part.amplitude,
        "fig02.amplitude",
        &amplitude,
    )?;
    let magnified_x = range_inside(source, "fig02.magnification.x", &part.x, "fig02.x", &x)?;
    let attractor = attractor(&raw.attractor, source)?;
    bound_members(source, "fig02.portraits", &raw.portraits, 1..=MOST_PORTRAITS)?;
    let mut portraits = Vec::new();
    for (portrait, number) in raw.portraits.get_ref().iter().zip(1..) {
        let key = format!("fig02.portraits[{number}].loops");
        let shown = demand(source, &key, &portrait.loops, |p| p == 0 || loops.contains(&p))?;
        let key = format!("fig02.portraits[{number}].amplitude");
        let at = demand(source, &key, &portrait.amplitude, |a| amplitude.contains(a))?;
        portraits.push(Portrait { loops: shown, amplitude: at });
    }
    Ok(Figure2 { frequency, amplitude, x, loops, magnified_amplitude, magnified_x, attractor, portraits })
}

fn attractor(raw: &raw::Attractor, source: &Source<'_>) -> Checked<Attractor> {
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
        return Err(source.forbid("fig02.attractor.transient", &raw.transient, allowed));
    }
    Ok(Attractor { amplitudes, orbits, transient, recorded, seed: *raw.seed.get_ref() })
}

fn figure7(raw: &raw::Figure7, oscillator: &LinearOscillator, source: &Source<'_>) -> Checked<Figure7> {
    let amplitude = range(source, "fig07.amplitude", &raw.amplitude, |lower| lower >= 0.0)?;
    let frequency = range(source, "fig07.frequency", &raw.frequency, |lower| lower > 0.0)?;
    let window = Rectangle::new(amplitude, frequency);
    let loops = loops(source, "fig07.loops", &raw.loops)?;
    let refuse = |error: TheoryError| source.forbid("fig07.frequency", &raw.frequency, error.to_string());
    let resonances = oscillator.resonances(&loops, frequency.lower(), frequency.upper()).map_err(refuse)?;
    let inside: Vec<u32> = resonances
        .iter()
        .filter(|resonance| amplitude.contains(resonance.grazing().amplitude()))
        .map(Resonance::loops)
        .collect();
    for (written, &p) in raw.loops.get_ref().iter().zip(&loops) {
        if inside.contains(&p) {
            continue;
        }
        let first = oscillator.resonance(p, 1).map_err(refuse)?;
        let where_one_is = format!(
            "that of p = {p}, n = 1, for one, lies at amplitude {:.5}, frequency {:.5}",
            first.grazing().amplitude(),
            first.forcing_frequency()
        );
        return Err(if inside.is_empty() {
            let allowed = format!(
                "no resonance lies in the window of fig07.amplitude and fig07.frequency; {where_one_is}"
            );
            source.forbid("fig07.frequency", &raw.frequency, allowed)
        } else {
            let allowed = format!(
                "p = {p} has no resonance in the window of fig07.amplitude and fig07.frequency; {where_one_is}"
            );
            source.forbid("fig07.loops", written, allowed)
        });
    }
    Ok(Figure7 { window, loops })
}

fn figure8(
    raw: &raw::Figure8,
    fig07: &Figure7,
    oscillator: &LinearOscillator,
    source: &Source<'_>,
) -> Checked<Figure8> {
    bound_members(source, "fig08.panels", &raw.panels, PANELS..=PANELS)?;
    let mut panels = Vec::new();
    for (panel, number) in raw.panels.get_ref().iter().zip(1..) {
        let key = |name: &str| format!("fig08.panels[{number}].{name}");
        let loops = demand(source, &key("loops"), &panel.loops, |p| fig07.loops.contains(&p))?;
        let n = demand(source, &key("n"), &panel.n, |n| n <= MOST_N)?;
        let resonance = oscillator
            .resonance(loops, n)
            .map_err(|_| source.forbid(&key("n"), &panel.n, requirement(&key("n")).to_owned()))?;
        let whole = fig07.window;
        let amplitude =
            range_inside(source, &key("amplitude"), &panel.amplitude, "fig07.amplitude", &whole.amplitude())?;
        let frequency =
            range_inside(source, &key("frequency"), &panel.frequency, "fig07.frequency", &whole.frequency())?;
        let (a, omega) = (resonance.grazing().amplitude(), resonance.forcing_frequency());
        if !amplitude.strictly_contains(a) {
            let allowed =
                format!("the range must contain the amplitude {a:.5} of the resonance p = {loops}, n = {n}");
            return Err(source.forbid(&key("amplitude"), &panel.amplitude, allowed));
        }
        if !frequency.strictly_contains(omega) {
            let allowed = format!(
                "the range must contain the frequency {omega:.5} of the resonance p = {loops}, n = {n}"
            );
            return Err(source.forbid(&key("frequency"), &panel.frequency, allowed));
        }
        panels.push(Panel { loops, n, window: Rectangle::new(amplitude, frequency) });
    }
    Ok(Figure8 { panels })
}

/// A number that is finite and passes the test, or the refusal with the key's requirement.
pub(super) fn demand<T: Copy + Into<f64>>(
    source: &Source<'_>,
    key: &str,
    value: &Spanned<T>,
    holds: impl Fn(T) -> bool,
) -> Checked<T> {
    let number = *value.get_ref();
    if number.into().is_finite() && holds(number) {
        Ok(number)
    } else {
        Err(source.forbid(key, value, requirement(key).to_owned()))
    }
}

/// A range whose lower end passes the test.
pub(super) fn range(
    source: &Source<'_>,
    key: &str,
    value: &Spanned<Vec<f64>>,
    holds: impl Fn(f64) -> bool,
) -> Checked<Range> {
    let range = match value.get_ref()[..] {
        [lower, upper] => Range::new(lower, upper),
        _ => None,
    };
    range
        .filter(|range| holds(range.lower()))
        .ok_or_else(|| source.forbid(key, value, requirement(key).to_owned()))
}

/// A range inside another one, which is named in the refusal.
fn range_inside(
    source: &Source<'_>,
    key: &str,
    value: &Spanned<Vec<f64>>,
    outer_key: &str,
    outer: &Range,
) -> Checked<Range> {
    let inner = range(source, key, value, f64::is_finite)?;
    if outer.encloses(&inner) {
        return Ok(inner);
    }
    let allowed = format!("the range must lie inside {outer_key} = [{}, {}]", outer.lower(), outer.upper());
    Err(source.forbid(key, value, allowed))
}

/// A list of numbers of loops: some, none twice, each from 1 on.
pub(super) fn loops(source: &Source<'_>, key: &str, value: &Spanned<Vec<Spanned<u32>>>) -> Checked<Vec<u32>> {
    let mut numbers = Vec::new();
    for written in value.get_ref() {
        let p = demand(source, key, written, |p| (1..=MOST_LOOPS).contains(&p))?;
        if numbers.contains(&p) {
            return Err(source.forbid(
                key,
                value,
                format!("{p} stands there twice, each number may stand once"),
            ));
        }
        numbers.push(p);
    }
    if numbers.is_empty() {
        return Err(source.forbid(key, value, requirement(key).to_owned()));
    }
    Ok(numbers)
}

fn bound_members<T>(
    source: &Source<'_>,
    key: &str,
    members: &Spanned<Vec<T>>,
    allowed: RangeInclusive<usize>,
) -> Checked<()> {
    if allowed.contains(&members.get_ref().len()) {
        return Ok(());
    }
    Err(source.forbid(key, members, requirement(key).to_owned()))
}
