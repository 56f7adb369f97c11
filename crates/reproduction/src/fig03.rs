//! Figure 3 (fig:Ba): the return map P_global on Π and the grazing periodic solution Γ.
//!
//! The phase is taken as an angle, so that Γ closes and a point of Π and its image lie on one and
//! the same Π (`Space`).

use core::f64::consts::TAU;

use grazing_model::maps::{MapError, global_map};
use grazing_model::{AtRest, ImpactOscillator, LinearOscillator, State};
use grazing_results::space::{CurveKind, MarkKind, Scene, SurfaceKind};

use crate::space::{Drawn, Space, line, outline, trajectory};
use crate::{Study, StudyError};

/// Restitution does not enter: P_global ignores impacts.
const ELASTIC: f64 = 1.0;
/// Positions x from which and velocity y up to which the axes reach.
const AXES: ([f64; 2], f64) = ([-0.75, 0.75], 0.75);
/// The part of the circle x = 0, y = 0 that is the axis of z, in radians.
const PHASE_AXIS: f64 = 0.8;

impl Study {
    /// Figure 3: Γ, the orbit from a point of Π (number 0) to its image (number 1), the map from
    /// the one to the other, Π, and the circle x = 0, y = 0.
    ///
    /// # Errors
    /// P_global is not defined at the point.
    pub fn fig03(&self) -> Result<Scene, StudyError> {
        let shown = self.parameters.fig03.get()?;
        let theory = grazing_theorems::LinearOscillator::new(shown.zeta, ELASTIC)?;
        let grazing = theory.grazing(shown.frequency)?;
        let oscillator = LinearOscillator::new(shown.zeta, ELASTIC, grazing.amplitude(), shown.frequency)?;
        let origin = grazing.phase();
        let space = Space::new(&shown.view, Some([shown.radius, origin]));

        let [x, phase] = shown.start;
        let start = State::at_rest(x, origin + phase);
        let failed = |reason: MapError| StudyError::Failed(format!("figure 3: {reason}"));
        // Π is crossed at maxima of x near the grazing point.
        let acceleration = oscillator.acceleration(start);
        if acceleration >= 0.0 {
            return Err(failed(MapError::NotAMaximum { acceleration }));
        }
        let landing = global_map::<_, 1>(&oscillator, AtRest::new(start.position, start.phase), None)
            .map_err(failed)?;
        let image = State::at_rest(landing.jet.value[0], landing.jet.value[1]);

        let mut curves = Drawn::new(&space);
        let top = State::at_rest(0.0, origin);
        curves.curve(CurveKind::Periodic, &trajectory(&oscillator, top, 0.0, oscillator.forcing_period()));
        curves.curve(CurveKind::Orbit, &trajectory(&oscillator, start, 0.0, landing.time));
        curves.curve(CurveKind::Global, &line(start, image));

        let points = vec![
            space.mark(MarkKind::Graze, 0, top),
            space.mark(MarkKind::Section, 0, start),
            space.mark(MarkKind::Section, 1, image),
        ];

        let mut drawn = Drawn::new(&space);
        let [left, right] = shown.position;
        let [from, to] = shown.phase.map(|z| origin + z);
        let corners = [(left, from), (right, from), (right, to), (left, to)];
        drawn.face(SurfaceKind::Section, [0.0, 0.0], &outline(corners.map(|(x, z)| State::at_rest(x, z))));
        drawn.curve(SurfaceKind::Tangency, &line(State::at_rest(0.0, from), State::at_rest(0.0, to)));
        drawn.curve(SurfaceKind::Circle, &line(State::at_rest(0.0, to), State::at_rest(0.0, from + TAU)));
        let at = origin + shown.axes;
        let (across, upwards) = AXES;
        drawn.curve(SurfaceKind::AxisX, &line(State::at_rest(across[0], at), State::at_rest(across[1], at)));
        drawn.curve(SurfaceKind::AxisY, &line(State::on_wall(0.0, at), State::on_wall(upwards, at)));
        drawn.curve(SurfaceKind::AxisZ, &line(State::at_rest(0.0, at), State::at_rest(0.0, at + PHASE_AXIS)));
        Ok(Scene { curves: curves.vertices, points, surfaces: drawn.vertices })
    }
}
