//! Figure 3 (fig:Ba): the return map P_global on Π and the grazing periodic solution Γ.
//!
//! The phase is taken as an angle, so that Γ closes and a point of Π and its image lie on one and the same Π
//! (`Space::ring`).

use core::f64::consts::TAU;

use grazing_model::maps::{MapError, global_map};
use grazing_model::{ImpactOscillator, LinearOscillator, State};

use crate::StudyError;
use crate::parameters::Parameters;
use crate::space::{Drawn, Points, Space, line, outline, trajectory};
use crate::table::Table;

/// The frames of Figure 3.
#[derive(Clone, Debug)]
pub struct Figure3 {
    /// `fig03_curves`: Γ, the orbit from a point of Π to its image, and the map from the one to the other.
    pub curves: Table,
    /// `fig03_points`: the grazing point, the point (number 0) and its image (number 1).
    pub points: Table,
    /// `fig03_surfaces`: Π, its intersection with Σ, the circle x = 0, y = 0, and the axes.
    pub surfaces: Table,
}

/// Restitution does not enter: P_global ignores impacts.
const ELASTIC: f64 = 1.0;
/// Positions x from which and velocity y up to which the axes reach.
const AXES: ([f64; 2], f64) = ([-0.75, 0.75], 0.75);
/// The part of the circle x = 0, y = 0 that is the axis of z, in radians.
const PHASE_AXIS: f64 = 0.8;

impl Figure3 {
    /// The tables that are written.
    pub fn tables(&self) -> Vec<Table> {
        vec![self.curves.clone(), self.points.clone(), self.surfaces.clone()]
    }

    pub(crate) fn compute(parameters: &Parameters) -> Result<Self, StudyError> {
        let shown = parameters.fig03()?;
        let theory = grazing_theorems::LinearOscillator::new(shown.zeta(), ELASTIC)?;
        let grazing = theory.grazing(shown.frequency())?;
        let oscillator =
            LinearOscillator::new(shown.zeta(), ELASTIC, grazing.amplitude(), shown.frequency())?;
        let origin = grazing.phase();
        let space = Space::ring(shown.view(), shown.radius(), origin);

        let [x, phase] = shown.start();
        let start = State::at_rest(x, origin + phase);
        // Π is crossed at maxima of x near the grazing point.
        let acceleration = oscillator.acceleration(start);
        if acceleration >= 0.0 {
            return Err(StudyError::Map { figure: 3, source: MapError::NotAMaximum { acceleration } });
        }
        let landing = global_map::<_, 1>(&oscillator, start.position, start.phase, None)
            .map_err(|source| StudyError::Map { figure: 3, source })?;
        let image = State::at_rest(landing.jet.value[0], landing.jet.value[1]);

        let mut curves = Drawn::new(&space);
        let top = State::at_rest(0.0, origin);
        curves.curve("periodic", &trajectory(&oscillator, top, 0.0, oscillator.forcing_period()));
        curves.curve("orbit", &trajectory(&oscillator, start, 0.0, landing.time));
        curves.curve("global", &line(start, image));

        let mut points = Points::new(&space);
        points.point("graze", 0, top);
        points.point("section", 0, start);
        points.point("section", 1, image);

        let mut drawn = Drawn::new(&space);
        let [left, right] = [shown.position().lower(), shown.position().upper()];
        let [from, to] = [shown.phase().lower(), shown.phase().upper()].map(|z| origin + z);
        let corners = [(left, from), (right, from), (right, to), (left, to)];
        drawn.face("section", [0.0, 0.0], &outline(corners.map(|(x, z)| State::at_rest(x, z))));
        drawn.curve("tangency", &line(State::at_rest(0.0, from), State::at_rest(0.0, to)));
        drawn.curve("circle", &line(State::at_rest(0.0, to), State::at_rest(0.0, from + TAU)));
        let at = origin + shown.axes();
        let (across, upwards) = AXES;
        drawn.curve("x_axis", &line(State::at_rest(across[0], at), State::at_rest(across[1], at)));
        drawn.curve("y_axis", &line(State::on_wall(0.0, at), State::on_wall(upwards, at)));
        drawn.curve("z_axis", &line(State::at_rest(0.0, at), State::at_rest(0.0, at + PHASE_AXIS)));
        Ok(Self {
            curves: curves.finish("fig03_curves")?,
            points: points.finish("fig03_points")?,
            surfaces: drawn.finish("fig03_surfaces")?,
        })
    }
}
