//! `[fig01]`, `[fig03]` and `[fig09]`: orbits in (x, y, z) phase space.

use core::f64::consts::TAU;

use grazing_model::LinearOscillator;
use grazing_source::{Section, SourceError};

use super::checks::{
    around_zero, contains, damping_ratio, encloses, frequency, range, restitution, strictly_contains, tables,
};
use super::requirements::{MOST_AMPLITUDE, MOST_ARRIVALS};

/// Gamma is two units of x wide; a ring with a smaller radius would overlap itself.
const LEAST_RADIUS: f64 = 2.0;
/// A ring so wide looks straight.
const MOST_RADIUS: f64 = 100.0;
/// Phases this far from grazing are still on one side of the ring.
const SECTION_REACH: f64 = 1.5;
/// Loops that can be told apart near the wall.
const MOST_LOOPS: u32 = 3;

/// From where phase space is looked at: an orthographic view along parallel rays.
///
/// Before any turning x points right, y up and z towards the viewer, a right-handed frame.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct View {
    /// The angle in degrees by which the scene is turned about the y-axis, in [-180, 180]; z swings to the right.
    pub turn: f64,
    /// The angle in degrees by which the viewer stands above the plane y = 0, strictly between 0 and 90.
    pub tilt: f64,
    /// The lengths of the units of x, y and z relative to each other, positive.
    pub stretch: [f64; 3],
}

impl View {
    /// The view of a figure.
    fn read(figure: &Section<'_>) -> Result<Self, SourceError> {
        let section = &figure.table("view")?;
        Ok(Self {
            turn: section.number("turn", |turn| contains([-180.0, 180.0], turn))?,
            tilt: section.number("tilt", |tilt| strictly_contains([0.0, 90.0], tilt))?,
            stretch: section.numbers("stretch", |units| units.iter().all(|&unit| unit > 0.0))?,
        })
    }
}

/// The linear oscillator of one of these figures; it need not be that of the paper's example.
fn oscillator(section: &Section<'_>) -> Result<LinearOscillator, SourceError> {
    let amplitude = section.number("amplitude", |a| 0.0 < a && a <= MOST_AMPLITUDE)?;
    LinearOscillator::new(damping_ratio(section)?, restitution(section)?, amplitude, frequency(section)?)
        .map_err(|error| section.forbid("amplitude", error.to_string()))
}

/// Figure 1: orbits that reach the impacting surface.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Figure1 {
    /// The oscillator.
    pub oscillator: LinearOscillator,
    /// The velocities y that the shown part of Sigma reaches; 0 lies strictly inside.
    pub velocity: [f64; 2],
    /// The orbits, at least one.
    pub orbits: Vec<Arrival>,
    /// The view.
    pub view: View,
}

/// An orbit of Figure 1, given by a point at which it reaches Sigma.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Arrival {
    /// The velocity y at the point on Sigma, not negative; 0 for an orbit that grazes.
    pub velocity: f64,
    /// The phase z at that point in radians; with what follows, the orbit stays within [0, 2 pi].
    pub phase: f64,
    /// How much phase before the point the orbit is drawn, in radians, positive.
    pub before: f64,
    /// How much phase after the point the orbit is drawn, in radians, positive.
    pub after: f64,
}

impl Figure1 {
    pub(super) fn read(section: &Section<'_>) -> Result<Self, SourceError> {
        let oscillator = oscillator(section)?;
        let shown = around_zero(section, "velocity")?;
        let view = View::read(section)?;
        let mut orbits = Vec::new();
        for orbit in &tables(section, "orbits", 1..=MOST_ARRIVALS)? {
            let velocity = orbit.number("velocity", |y| {
                y >= 0.0 && contains(shown, y) && contains(shown, -oscillator.restitution() * y)
            })?;
            let phase = orbit.number("phase", |z| strictly_contains([0.0, TAU], z))?;
            let before = orbit.number("before", |span| 0.0 < span && span <= phase)?;
            let after = orbit.number("after", |span| 0.0 < span && phase + span < TAU)?;
            orbits.push(Arrival { velocity, phase, before, after });
        }
        Ok(Self { oscillator, velocity: shown, orbits, view })
    }
}

/// Figure 3: the return map P_global at grazing, its phase space glued to a ring.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Figure3 {
    /// The damping ratio zeta, in (0, 1).
    pub zeta: f64,
    /// The forcing frequency omega, positive; the amplitude is that of grazing.
    pub frequency: f64,
    /// The point on Pi that is mapped: x and z - z_graz, inside the shown part.
    pub start: [f64; 2],
    /// The positions x of Pi; 0 lies strictly inside.
    pub position: [f64; 2],
    /// The phases z - z_graz of Pi in radians; 0 lies strictly inside.
    pub phase: [f64; 2],
    /// The radius of the circle x = 0, y = 0 about which phase space is bent; above 2, the width of Gamma.
    pub radius: f64,
    /// The phase z - z_graz at which the axes of x and y are drawn, in radians.
    pub axes: f64,
    /// The view.
    pub view: View,
}

impl Figure3 {
    pub(super) fn read(section: &Section<'_>) -> Result<Self, SourceError> {
        let (zeta, frequency) = (damping_ratio(section)?, frequency(section)?);
        let position = around_zero(section, "position")?;
        let phase = range(section, "phase", |range| {
            strictly_contains(range, 0.0) && encloses([-SECTION_REACH, SECTION_REACH], range)
        })?;
        let start = section
            .numbers("start", |[x, z]| strictly_contains(position, x) && strictly_contains(phase, z))?;
        let radius = section.number("radius", |r| LEAST_RADIUS < r && r <= MOST_RADIUS)?;
        let axes = section.number("axes", |z| contains([0.0, TAU], z))?;
        let view = View::read(section)?;
        Ok(Self { zeta, frequency, start, position, phase, radius, axes, view })
    }
}

/// Figure 9: an impact and the points on Sigma and Pi that it defines.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Figure9 {
    /// The oscillator.
    pub oscillator: LinearOscillator,
    /// The impact: y_imp, positive, and z_imp - z_graz in radians, where z_graz is that of the frequency.
    pub impact: [f64; 2],
    /// The number p of applications of P_global, from 1 to 3.
    pub loops: u32,
    /// The positions x of Pi; 0 lies strictly inside. Orbits are cut off at the lower end.
    pub position: [f64; 2],
    /// The velocities y of Sigma; 0 lies strictly inside.
    pub velocity: [f64; 2],
    /// The phases z - z_graz of both surfaces in radians.
    pub phase: [f64; 2],
    /// The view.
    pub view: View,
}

impl Figure9 {
    pub(super) fn read(section: &Section<'_>) -> Result<Self, SourceError> {
        let oscillator = oscillator(section)?;
        let position = around_zero(section, "position")?;
        let velocity = around_zero(section, "velocity")?;
        let phase = range(section, "phase", |[lower, upper]| upper - lower <= TAU)?;
        let impact =
            section.numbers("impact", |[y, z]| y > 0.0 && contains(velocity, y) && contains(phase, z))?;
        let loops = section.count("loops", 1..=MOST_LOOPS)?;
        Ok(Self { oscillator, impact, loops, position, velocity, phase, view: View::read(section)? })
    }
}
