//! Phase space as in Figures 1, 3 and 9: projected along parallel rays, and split into layers.
//!
//! The scenes contain curves and two surfaces, Σ (x = 0) and Π (y = 0). Both are planes, so visibility
//! needs no comparison of depths: from any viewpoint, everything beyond Σ is painted before Σ and the
//! rest after it, and likewise for Π on either side of Σ (a binary space partition with two planes).
//! [`Projection::layer`] is that order; curves are split where they pass from one side to another.

use grazing_input::kind::{above, number, numbers, strictly};
use grazing_input::{Section, SourceError, keys};
use grazing_model::motion::Motion as _;
use grazing_model::{ImpactOscillator, LinearOscillator, OnWall, State};
use grazing_results::space::{Mark, MarkKind, SurfaceKind, Vertex};

use crate::parameters::limits::{
    EPSILON, FREQUENCIES, FREQUENCY, MOST_AMPLITUDE, ZETA, damping_ratio, restitution,
};

/// The number of samples of an orbit per forcing period, so that segments are shorter than a point on the
/// sheet.
const SAMPLES: f64 = 300.0;
/// The number of samples of a line that joins two points.
const LINE_SAMPLES: u32 = 60;

keys! {
    /// The viewpoint in phase space: an orthographic view along parallel rays.
    ///
    /// Before any turning x points right, y up and z towards the viewer, a right-handed frame.
    #[derive(Copy)]
    pub struct Viewpoint {
        /// The angle in degrees by which the scene is turned about the y-axis; z swings to the
        /// right.
        turn: f64 = number(-180.0..=180.0), "the turn must be an angle in degrees from {} to {}";
        /// The angle in degrees by which the viewer stands above the plane y = 0.
        tilt: f64 = number(strictly(0.0, 90.0)), "the tilt must be an angle in degrees strictly between {} and {}";
        /// The lengths of the units of x, y and z relative to each other.
        stretch: [f64; 3] = numbers().such(|units: &[f64; 3]| units.iter().all(|&unit| unit > 0.0)),
            "the stretch must be three positive numbers, for x, y and z";
    }
}

/// The message if a view is missing.
pub(crate) const VIEW: &str = "the table of the view holds turn, tilt and stretch";

keys! {
    /// The linear oscillator of one of these figures, which may differ from the paper's example.
    pub(crate) struct ShownOscillator {
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

/// The oscillator of a figure.
pub(crate) fn oscillator(
    motion: ShownOscillator,
    section: &Section<'_>,
) -> Result<LinearOscillator, SourceError> {
    let ShownOscillator { zeta, epsilon, amplitude, frequency } = motion;
    LinearOscillator::new(zeta, epsilon, amplitude, frequency)
        .map_err(|error| section.forbid("amplitude", error.to_string()))
}

/// The mapping of phase space to the page.
#[derive(Clone, Debug)]
pub(crate) struct Projection {
    /// Radius ρ and origin z₀ of a ring, if the phase is an angle: (x, y, z) ↦ ((ρ + x) cos ψ, y, (ρ + x)
    /// sin ψ) with ψ = z − z₀. Otherwise x, y and z have straight axes.
    ///
    /// The map is one-to-one for x > −ρ, with z and z + 2π the same place, and right-handed like the
    /// straight axes. Π remains in a plane, y = 0.
    ring: Option<[f64; 2]>,
    stretch: [f64; 3],
    /// Sine and cosine of the turn and of the tilt.
    turn: (f64, f64),
    tilt: (f64, f64),
}

impl Projection {
    /// The mapping for a figure's view; for a ring, with its radius and the phase from which the angle is
    /// measured.
    pub(crate) fn new(view: &Viewpoint, ring: Option<[f64; 2]>) -> Self {
        let turned = |degrees: f64| libm::sincos(degrees.to_radians());
        Self { ring, stretch: view.stretch, turn: turned(view.turn), tilt: turned(view.tilt) }
    }

    /// The orthographic projection of a state: its coordinates to the right, upwards, and away from the
    /// viewer.
    ///
    /// With (X, Y, Z) the position in space with stretched units, turned by α about Y and then tilted by
    /// β: across = X cos α + Z sin α, up = Y cos β + D sin β, depth = D cos β − Y sin β, where D = X sin
    /// α − Z cos α.
    fn see(&self, state: State) -> [f64; 3] {
        let State { position: x, velocity: y, phase: z } = state;
        let place = self.ring.map_or([x, y, z], |[radius, origin]| {
            let (sin, cos) = libm::sincos(z - origin);
            [(radius + x) * cos, y, (radius + x) * sin]
        });
        let [right, height, front] = [0, 1, 2].map(|k| self.stretch[k] * place[k]);
        let ((turn_sin, turn_cos), (tilt_sin, tilt_cos)) = (self.turn, self.tilt);
        let away = right * turn_sin - front * turn_cos;
        [
            right * turn_cos + front * turn_sin,
            height * tilt_cos + away * tilt_sin,
            away * tilt_cos - height * tilt_sin,
        ]
    }

    /// The index in the order of painting, by the signs of x and of y; a sign of 0 means on the surface.
    ///
    /// Beyond Σ: beyond Π 0, on Π 1, before Π 2; on Σ 3; before Σ: beyond Π 4, on Π 5, before Π 6. On the
    /// ring Σ is not shown.
    fn layer(&self, x: f64, y: f64) -> u32 {
        // The viewer stands above y = 0, and on the side x < 0 if the scene is turned to the right.
        let about_section = u32::from(y >= 0.0) + u32::from(y > 0.0);
        match self.ring {
            None if x == 0.0 => 3,
            None if x * self.turn.0 < 0.0 => 4 + about_section,
            _ => about_section,
        }
    }

    /// The layer immediately in front of a point of a surface: a mark of the point is painted there,
    /// after everything that ends in the point.
    fn layer_before(&self, state: State) -> u32 {
        let before = |coordinate: f64, side: f64| if coordinate == 0.0 { side } else { coordinate };
        self.layer(before(state.position, -self.turn.0), before(state.velocity, 1.0))
    }

    fn layer_between(&self, a: State, b: State) -> u32 {
        self.layer(0.5 * (a.position + b.position), 0.5 * (a.velocity + b.velocity))
    }

    /// A named point on Σ or Π.
    pub(crate) fn mark(&self, kind: MarkKind, number: u32, state: State) -> Mark {
        let [across, up, depth] = self.see(state);
        let State { position: x, velocity: y, phase: z } = state;
        Mark { kind, number, layer: self.layer_before(state), x, y, z, across, up, depth }
    }
}

/// The image of an impact under the reset law.
pub(crate) fn recoil(oscillator: &LinearOscillator, impact: State) -> State {
    let reset = oscillator.reset::<1>(OnWall::new(impact.velocity, impact.phase)).value;
    State::on_wall(reset[0], reset[1])
}

/// The motion from a state between two times of either sign, sampled, with the wall ignored.
pub(crate) fn trajectory<O: ImpactOscillator>(
    oscillator: &O,
    from: State,
    start: f64,
    end: f64,
) -> Vec<State> {
    let motion = oscillator.motion(from);
    let frequency = oscillator.forcing_frequency().value;
    let steps = libm::ceil(SAMPLES * (end - start).abs() / oscillator.forcing_period()).max(8.0);
    (0..=steps as u32)
        .map(|k| {
            let time = start + (end - start) * f64::from(k) / steps;
            if time == 0.0 {
                return from;
            }
            let here = motion.at(time);
            State { position: here.position, velocity: here.velocity, phase: from.phase + frequency * time }
        })
        .collect()
}

/// The line between two states in the coordinates x, y and z, sampled.
pub(crate) fn line(from: State, to: State) -> Vec<State> {
    (0..=LINE_SAMPLES)
        .map(|k| {
            let share = f64::from(k) / f64::from(LINE_SAMPLES);
            let between = |a: f64, b: f64| if k == LINE_SAMPLES { b } else { a + share * (b - a) };
            State {
                position: between(from.position, to.position),
                velocity: between(from.velocity, to.velocity),
                phase: between(from.phase, to.phase),
            }
        })
        .collect()
}

/// The closed outline through corners, without repeating the first one.
pub(crate) fn outline(corners: [State; 4]) -> Vec<State> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).flat_map(|(&a, &b)| line(a, b).into_iter().take(LINE_SAMPLES as usize)).collect()
}

/// The curves or the surfaces of a figure, projected from its viewpoint.
pub(crate) struct Drawn<'a, K> {
    space: &'a Projection,
    pub(crate) vertices: Vec<Vertex<K>>,
    number: u32,
}

impl<'a, K: Copy> Drawn<'a, K> {
    pub(crate) fn new(space: &'a Projection) -> Self {
        Self { space, vertices: Vec::new(), number: 0 }
    }

    /// Adds a curve, split into pieces where it changes its layer.
    pub(crate) fn curve(&mut self, kind: K, states: &[State]) {
        self.number += 1;
        let layers: Vec<u32> =
            states.windows(2).map(|pair| self.space.layer_between(pair[0], pair[1])).collect();
        let (mut start, mut piece) = (0, 0);
        for end in 1..=layers.len() {
            if end == layers.len() || layers[end] != layers[start] {
                piece += 1;
                for &state in &states[start..=end] {
                    self.push(kind, piece, layers[start], state);
                }
                start = end;
            }
        }
    }

    /// Adds a face of a surface: a closed outline on it, and the signs of x and y over it.
    pub(crate) fn face(&mut self, kind: K, [x, y]: [f64; 2], outline: &[State]) {
        self.number += 1;
        let layer = self.space.layer(x, y);
        for &state in outline {
            self.push(kind, 1, layer, state);
        }
    }

    fn push(&mut self, kind: K, piece: u32, layer: u32, state: State) {
        let State { position: x, velocity: y, phase: z } = state;
        let (number, place) = (self.number, self.space.see(state));
        self.vertices.push(Vertex { kind, number, piece, layer, state: [x, y, z], place });
    }
}

/// Adds the three axes along the edges of a box that meet at (0, 0, `origin`), each slightly longer than
/// the box.
pub(crate) fn axes(drawn: &mut Drawn<'_, SurfaceKind>, [x, y, z]: [[f64; 2]; 3], origin: f64) {
    /// The fraction of the box by which an axis is longer than it.
    const OVERSHOOT: f64 = 0.12;
    let beyond = |[low, high]: [f64; 2]| high + OVERSHOOT * (high - low);
    drawn.curve(SurfaceKind::AxisX, &line(State::at_rest(x[0], origin), State::at_rest(beyond(x), origin)));
    drawn.curve(SurfaceKind::AxisY, &line(State::on_wall(y[0], origin), State::on_wall(beyond(y), origin)));
    drawn.curve(SurfaceKind::AxisZ, &line(State::on_wall(0.0, z[0]), State::on_wall(0.0, beyond(z))));
}
