//! Parameters of Figures 1, 3 and 9, which show orbits in (x, y, z) phase space.

use super::range::Range;

/// From where phase space is looked at: an orthographic view along parallel rays.
///
/// Before any turning x points right, y up and z towards the viewer, a right-handed frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    pub(super) turn: f64,
    pub(super) tilt: f64,
    pub(super) stretch: [f64; 3],
}

impl View {
    /// The angle in degrees by which the scene is turned about the y-axis, in [-180, 180]; z swings to the right.
    pub fn turn(&self) -> f64 {
        self.turn
    }

    /// The angle in degrees by which the viewer stands above the plane y = 0, strictly between 0 and 90.
    pub fn tilt(&self) -> f64 {
        self.tilt
    }

    /// The lengths of the units of x, y and z relative to each other, positive.
    pub fn stretch(&self) -> [f64; 3] {
        self.stretch
    }
}

/// The linear oscillator of one of these figures; it need not be that of the paper's example.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Specimen {
    pub(super) zeta: f64,
    pub(super) epsilon: f64,
    pub(super) amplitude: f64,
    pub(super) frequency: f64,
}

impl Specimen {
    /// The damping ratio zeta, in (0, 1).
    pub fn zeta(&self) -> f64 {
        self.zeta
    }

    /// The coefficient of restitution epsilon, in (0, 1].
    pub fn epsilon(&self) -> f64 {
        self.epsilon
    }

    /// The forcing amplitude, positive.
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// The forcing frequency omega, positive.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }
}

/// Figure 1: orbits that reach the impacting surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure1 {
    pub(super) specimen: Specimen,
    pub(super) velocity: Range,
    pub(super) orbits: Vec<Arrival>,
    pub(super) view: View,
}

impl Figure1 {
    /// The oscillator.
    pub fn specimen(&self) -> &Specimen {
        &self.specimen
    }

    /// The velocities y that the shown part of Sigma reaches; 0 lies strictly inside.
    pub fn velocity(&self) -> Range {
        self.velocity
    }

    /// The orbits, at least one.
    pub fn orbits(&self) -> &[Arrival] {
        &self.orbits
    }

    /// The view.
    pub fn view(&self) -> &View {
        &self.view
    }
}

/// An orbit of Figure 1, given by a point at which it reaches Sigma.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arrival {
    pub(super) velocity: f64,
    pub(super) phase: f64,
    pub(super) before: f64,
    pub(super) after: f64,
}

impl Arrival {
    /// The velocity y at the point on Sigma, not negative; 0 for an orbit that grazes.
    pub fn velocity(&self) -> f64 {
        self.velocity
    }

    /// The phase z at that point in radians; with what follows, the orbit stays within [0, 2 pi].
    pub fn phase(&self) -> f64 {
        self.phase
    }

    /// How much phase before the point the orbit is drawn, in radians, positive.
    pub fn before(&self) -> f64 {
        self.before
    }

    /// How much phase after the point the orbit is drawn, in radians, positive.
    pub fn after(&self) -> f64 {
        self.after
    }
}

/// Figure 3: the return map P_global at grazing, its phase space glued to a ring.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure3 {
    pub(super) zeta: f64,
    pub(super) frequency: f64,
    pub(super) start: [f64; 2],
    pub(super) position: Range,
    pub(super) phase: Range,
    pub(super) radius: f64,
    pub(super) axes: f64,
    pub(super) view: View,
}

impl Figure3 {
    /// The damping ratio zeta, in (0, 1).
    pub fn zeta(&self) -> f64 {
        self.zeta
    }

    /// The forcing frequency omega, positive; the amplitude is that of grazing.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// The point on Pi that is mapped: x and z - z_graz, inside the shown part.
    pub fn start(&self) -> [f64; 2] {
        self.start
    }

    /// The positions x of Pi; 0 lies strictly inside.
    pub fn position(&self) -> Range {
        self.position
    }

    /// The phases z - z_graz of Pi in radians; 0 lies strictly inside.
    pub fn phase(&self) -> Range {
        self.phase
    }

    /// The radius of the circle x = 0, y = 0 about which phase space is bent; above 2, the width of Gamma.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The phase z - z_graz at which the axes of x and y are drawn, in radians.
    pub fn axes(&self) -> f64 {
        self.axes
    }

    /// The view.
    pub fn view(&self) -> &View {
        &self.view
    }
}

/// Figure 9: an impact and the points on Sigma and Pi that it defines.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure9 {
    pub(super) specimen: Specimen,
    pub(super) impact: [f64; 2],
    pub(super) loops: u32,
    pub(super) position: Range,
    pub(super) velocity: Range,
    pub(super) phase: Range,
    pub(super) view: View,
}

impl Figure9 {
    /// The oscillator.
    pub fn specimen(&self) -> &Specimen {
        &self.specimen
    }

    /// The impact: y_imp, positive, and z_imp - z_graz in radians, where z_graz is that of the frequency.
    pub fn impact(&self) -> [f64; 2] {
        self.impact
    }

    /// The number p of applications of P_global, from 1 to 3.
    pub fn loops(&self) -> u32 {
        self.loops
    }

    /// The positions x of Pi; 0 lies strictly inside. Orbits are cut off at the lower end.
    pub fn position(&self) -> Range {
        self.position
    }

    /// The velocities y of Sigma; 0 lies strictly inside.
    pub fn velocity(&self) -> Range {
        self.velocity
    }

    /// The phases z - z_graz of both surfaces in radians.
    pub fn phase(&self) -> Range {
        self.phase
    }

    /// The view.
    pub fn view(&self) -> &View {
        &self.view
    }
}
