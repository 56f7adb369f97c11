//! The checks of Figures 1, 3 and 9.

use core::f64::consts::TAU;

use toml::Spanned;

use super::range::Range;
use super::raw;
use super::requirements::{MOST_AMPLITUDE, MOST_ARRIVALS};
use super::space::{Arrival, Figure1, Figure3, Figure9, Specimen, View};
use super::validate::{Checked, bound_members, demand, frequency, range, refusal};
use grazing_source::Source;

/// Gamma is two units of x wide; a ring with a smaller radius would overlap itself.
const LEAST_RADIUS: f64 = 2.0;
/// A ring so wide looks straight.
const MOST_RADIUS: f64 = 100.0;
/// Phases this far from grazing are still on one side of the ring.
const SECTION_REACH: f64 = 1.5;
/// Loops that can be told apart near the wall.
const MOST_LOOPS: u32 = 3;

pub(super) fn figure1(raw: &raw::Figure1, source: &Source<'_>) -> Checked<Figure1> {
    let specimen = specimen(source, "fig01", [&raw.zeta, &raw.epsilon, &raw.amplitude, &raw.frequency])?;
    let velocity = around_zero(source, "fig01.velocity", &raw.velocity)?;
    let view = view(source, "fig01", &raw.view)?;
    bound_members(source, "fig01.orbits", &raw.orbits, 1..=MOST_ARRIVALS)?;
    let mut orbits = Vec::new();
    for (orbit, number) in raw.orbits.get_ref().iter().zip(1..) {
        let key = |name: &str| format!("fig01.orbits[{number}].{name}");
        let shown = demand(source, &key("velocity"), &orbit.velocity, |y| {
            y >= 0.0 && velocity.contains(y) && velocity.contains(-specimen.epsilon * y)
        })?;
        let phase = demand(source, &key("phase"), &orbit.phase, |z| 0.0 < z && z < TAU)?;
        let before = demand(source, &key("before"), &orbit.before, |span| 0.0 < span && span <= phase)?;
        let after = demand(source, &key("after"), &orbit.after, |span| 0.0 < span && phase + span < TAU)?;
        orbits.push(Arrival { velocity: shown, phase, before, after });
    }
    Ok(Figure1 { specimen, velocity, orbits, view })
}

pub(super) fn figure3(raw: &raw::Figure3, source: &Source<'_>) -> Checked<Figure3> {
    let zeta = demand(source, "fig03.zeta", &raw.zeta, |zeta| 0.0 < zeta && zeta < 1.0)?;
    let frequency = frequency(source, "fig03.frequency", &raw.frequency)?;
    let position = around_zero(source, "fig03.position", &raw.position)?;
    let phase = around_zero(source, "fig03.phase", &raw.phase)?;
    if phase.lower() < -SECTION_REACH || phase.upper() > SECTION_REACH {
        return Err(refusal(source, "fig03.phase", &raw.phase));
    }
    let start = numbers(source, "fig03.start", &raw.start, |[x, z]| {
        position.strictly_contains(x) && phase.strictly_contains(z)
    })?;
    let radius = demand(source, "fig03.radius", &raw.radius, |r| LEAST_RADIUS < r && r <= MOST_RADIUS)?;
    let axes = demand(source, "fig03.axes", &raw.axes, |z| (0.0..=TAU).contains(&z))?;
    let view = view(source, "fig03", &raw.view)?;
    Ok(Figure3 { zeta, frequency, start, position, phase, radius, axes, view })
}

pub(super) fn figure9(raw: &raw::Figure9, source: &Source<'_>) -> Checked<Figure9> {
    let specimen = specimen(source, "fig09", [&raw.zeta, &raw.epsilon, &raw.amplitude, &raw.frequency])?;
    let position = around_zero(source, "fig09.position", &raw.position)?;
    let velocity = around_zero(source, "fig09.velocity", &raw.velocity)?;
    let phase = range(source, "fig09.phase", &raw.phase, f64::is_finite)?;
    if phase.width() > TAU {
        return Err(refusal(source, "fig09.phase", &raw.phase));
    }
    let impact = numbers(source, "fig09.impact", &raw.impact, |[y, z]| {
        y > 0.0 && velocity.contains(y) && phase.contains(z)
    })?;
    let loops = demand(source, "fig09.loops", &raw.loops, |p| (1..=MOST_LOOPS).contains(&p))?;
    let view = view(source, "fig09", &raw.view)?;
    Ok(Figure9 { specimen, impact, loops, position, velocity, phase, view })
}

fn specimen(
    source: &Source<'_>,
    figure: &str,
    [zeta, epsilon, amplitude, omega]: [&Spanned<f64>; 4],
) -> Checked<Specimen> {
    let key = |name: &str| format!("{figure}.{name}");
    Ok(Specimen {
        zeta: demand(source, &key("zeta"), zeta, |zeta| 0.0 < zeta && zeta < 1.0)?,
        epsilon: demand(source, &key("epsilon"), epsilon, |epsilon| 0.0 < epsilon && epsilon <= 1.0)?,
        amplitude: demand(source, &key("amplitude"), amplitude, |a| 0.0 < a && a <= MOST_AMPLITUDE)?,
        frequency: frequency(source, &key("frequency"), omega)?,
    })
}

fn view(source: &Source<'_>, figure: &str, raw: &raw::View) -> Checked<View> {
    let key = |name: &str| format!("{figure}.view.{name}");
    let turn = demand(source, &key("turn"), &raw.turn, |turn| (-180.0..=180.0).contains(&turn))?;
    let tilt = demand(source, &key("tilt"), &raw.tilt, |tilt| 0.0 < tilt && tilt < 90.0)?;
    let stretch = numbers(source, &key("stretch"), &raw.stretch, |units: [f64; 3]| {
        units.iter().all(|&unit| unit > 0.0)
    })?;
    Ok(View { turn, tilt, stretch })
}

/// A range that has 0 strictly inside.
fn around_zero(source: &Source<'_>, key: &str, value: &Spanned<Vec<f64>>) -> Checked<Range> {
    let found = range(source, key, value, |lower| lower < 0.0)?;
    if found.strictly_contains(0.0) {
        return Ok(found);
    }
    Err(refusal(source, key, value))
}

/// A list of N finite numbers that passes the test.
fn numbers<const N: usize>(
    source: &Source<'_>,
    key: &str,
    value: &Spanned<Vec<f64>>,
    holds: impl Fn([f64; N]) -> bool,
) -> Checked<[f64; N]> {
    <[f64; N]>::try_from(value.get_ref().as_slice())
        .ok()
        .filter(|list| list.iter().all(|number| number.is_finite()) && holds(*list))
        .ok_or_else(|| refusal(source, key, value))
}
