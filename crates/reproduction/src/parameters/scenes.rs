//! `[fig01]`, `[fig03]` and `[fig09]`: orbits in (x, y, z) phase space.

use core::f64::consts::TAU;

use grazing_model::LinearOscillator;
use grazing_source::kind::{above, count, derived, number, numbers, strictly, table, tables};
use grazing_source::{Keys, Section, SourceError, keys};

use super::limits::{
    AROUND_ZERO, EPSILON, FREQUENCIES, FREQUENCY, MOST_AMPLITUDE, ZETA, around_zero, contains, damping_ratio,
    encloses, range, restitution, strictly_contains,
};

/// Radii of the ring of Figure 3: Gamma is two units of x wide, so that a ring with a smaller
/// radius would overlap itself, and one with a larger radius looks straight.
const RADII: [f64; 2] = [2.0, 100.0];
/// Phases this far from grazing are still on one side of the ring.
const SECTION_REACH: f64 = 1.5;
/// Loops that can be told apart near the wall.
const MOST_LOOPS: u32 = 3;
/// The most orbits of Figure 1: more could not be told apart.
const MOST_ARRIVALS: usize = 8;

keys! {
    /// From where phase space is looked at: an orthographic view along parallel rays.
    ///
    /// Before any turning x points right, y up and z towards the viewer, a right-handed frame.
    #[derive(Copy)]
    pub struct View {
        /// The angle in degrees by which the scene is turned about the y-axis; z swings to the right.
        turn: f64 = number(-180.0..=180.0), "the turn must be an angle in degrees from {} to {}";
        /// The angle in degrees by which the viewer stands above the plane y = 0.
        tilt: f64 = number(strictly(0.0, 90.0)), "the tilt must be an angle in degrees strictly between {} and {}";
        /// The lengths of the units of x, y and z relative to each other.
        stretch: [f64; 3] = numbers().such(|units: &[f64; 3]| units.iter().all(|&unit| unit > 0.0)),
            "the stretch must be three positive numbers, for x, y and z";
    }
}

const VIEW: &str = "the table of the view holds turn, tilt and stretch";

keys! {
    /// The linear oscillator of one of these figures; it need not be that of the paper's example.
    struct Motion {
        /// The damping ratio zeta.
        zeta: f64 = damping_ratio(), ZETA;
        /// The coefficient of restitution.
        epsilon: f64 = restitution(), EPSILON;
        /// The forcing amplitude.
        amplitude: f64 = number(above(0.0, MOST_AMPLITUDE)),
            "the forcing amplitude must lie above {} and be at most {}";
        /// The forcing frequency omega.
        frequency: f64 = number(FREQUENCIES), FREQUENCY;
    }
}

fn oscillator(motion: Motion, section: &Section<'_>) -> Result<LinearOscillator, SourceError> {
    let Motion { zeta, epsilon, amplitude, frequency } = motion;
    LinearOscillator::new(zeta, epsilon, amplitude, frequency)
        .map_err(|error| section.forbid("amplitude", error.to_string()))
}

keys! {
    /// Figure 1: orbits that reach the impacting surface.
    pub struct Figure1 {
        /// The oscillator.
        oscillator: LinearOscillator = derived(oscillator);
        /// The velocities y that the shown part of Sigma reaches.
        velocity: [f64; 2] = around_zero(), AROUND_ZERO;
        /// The view.
        view: View = table(), VIEW;
        /// The orbits.
        orbits: Vec<Arrival> = tables(1..=MOST_ARRIVALS),
            "[[fig01.orbits]] must be one to eight tables, one for each orbit";
    }
}

keys! {
    /// An orbit of Figure 1, given by a point at which it reaches Sigma.
    #[derive(Copy)]
    pub struct Arrival {
        /// The velocity y at the point on Sigma; 0 for an orbit that grazes.
        velocity: f64 = number(0.0..),
            "the velocity must not be negative, and lie inside fig01.velocity as its recoil does";
        /// The phase z at that point in radians; with what follows, the orbit stays within [0, 2 pi].
        phase: f64 = number(strictly(0.0, TAU)), "the phase must lie strictly between 0 and 2 pi";
        /// How much phase before the point the orbit is drawn, in radians.
        before: f64 = number(0.0..).such(|before| *before > 0.0),
            "the phase before must be positive, and the orbit must begin at 0 or later";
        /// How much phase after the point the orbit is drawn, in radians.
        after: f64 = number(0.0..).such(|after| *after > 0.0),
            "the phase after must be positive, and the orbit must end before 2 pi";
    }
}

impl Figure1 {
    pub(super) fn checked(section: &Section<'_>) -> Result<Self, SourceError> {
        let figure = Self::read(section)?;
        for (orbit, number) in figure.orbits.iter().zip(1..) {
            let reached = [orbit.velocity, -figure.oscillator.restitution() * orbit.velocity];
            for (name, right) in [
                ("velocity", reached.iter().all(|y| contains(figure.velocity, *y))),
                ("before", orbit.before <= orbit.phase),
                ("after", orbit.phase + orbit.after < TAU),
            ] {
                if !right {
                    return Err(section.refusal(&format!("orbits[{number}].{name}")));
                }
            }
        }
        Ok(figure)
    }
}

keys! {
    /// Figure 3: the return map P_global at grazing, its phase space glued to a ring.
    pub struct Figure3 {
        /// The damping ratio zeta.
        zeta: f64 = damping_ratio(), ZETA;
        /// The forcing frequency omega; the amplitude is that of grazing.
        frequency: f64 = number(FREQUENCIES), FREQUENCY;
        /// The point on Pi that is mapped: x and z - z_graz, inside the shown part.
        start: [f64; 2] = numbers(),
            "the point must be [x, z - z_graz] with x in fig03.position and z - z_graz in fig03.phase";
        /// The positions x of Pi.
        position: [f64; 2] = around_zero(), AROUND_ZERO;
        /// The phases z - z_graz of Pi in radians.
        phase: [f64; 2] = around_zero().such(|range| encloses([-SECTION_REACH, SECTION_REACH], *range)),
            "the phases must be a range [lower, upper] within 1.5 on either side of 0, with 0 inside";
        /// The radius of the circle x = 0, y = 0 about which phase space is bent.
        radius: f64 = number(above(RADII[0], RADII[1])),
            "the radius must lie above {}, which is the width of the grazing orbit, and be at most {}";
        /// The phase z - z_graz at which the axes of x and y are drawn, in radians.
        axes: f64 = number(0.0..=TAU), "the phase of the axes must lie between 0 and 2 pi";
        /// The view.
        view: View = table(), VIEW;
    }
}

impl Figure3 {
    pub(super) fn checked(section: &Section<'_>) -> Result<Self, SourceError> {
        let figure = Self::read(section)?;
        let [x, z] = figure.start;
        let shown = strictly_contains(figure.position, x) && strictly_contains(figure.phase, z);
        if shown { Ok(figure) } else { Err(section.refusal("start")) }
    }
}

keys! {
    /// Figure 9: an impact and the points on Sigma and Pi that it defines.
    pub struct Figure9 {
        /// The oscillator.
        oscillator: LinearOscillator = derived(oscillator);
        /// The impact: y_imp, and z_imp - z_graz in radians, where z_graz is that of the frequency.
        impact: [f64; 2] = numbers(),
            "the impact must be [y, z - z_graz] with 0 < y in fig09.velocity and z - z_graz in fig09.phase";
        /// The number p of applications of P_global.
        loops: u32 = count(1..=MOST_LOOPS), "the number of loops must be a whole number from {} to {}";
        /// The positions x of Pi. Orbits are cut off at the lower end.
        position: [f64; 2] = around_zero(), AROUND_ZERO;
        /// The velocities y of Sigma.
        velocity: [f64; 2] = around_zero(), AROUND_ZERO;
        /// The phases z - z_graz of both surfaces in radians.
        phase: [f64; 2] = range().such(|[lower, upper]| upper - lower <= TAU),
            "the phases must be a range [lower, upper] with lower < upper, not wider than 2 pi";
        /// The view.
        view: View = table(), VIEW;
    }
}

impl Figure9 {
    pub(super) fn checked(section: &Section<'_>) -> Result<Self, SourceError> {
        let figure = Self::read(section)?;
        let [y, z] = figure.impact;
        let shown = y > 0.0 && contains(figure.velocity, y) && contains(figure.phase, z);
        if shown { Ok(figure) } else { Err(section.refusal("impact")) }
    }
}
