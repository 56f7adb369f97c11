//! Figure 3 (fig:Ba): the return map P_global on Π and the grazing periodic solution Γ.
//!
//! The phase is an angle here, so that Γ closes and a point of Π and its image lie on the same Π
//! (`Projection`).

use core::f64::consts::TAU;

use grazing_drawing::geometry::sheet::Bounds;
use grazing_drawing::ink::style::{BLACK, LABEL_SIZE, RETURN_COLOUR, SMALL_LABEL_SIZE, TITLE_SIZE};
use grazing_drawing::plot::scene::{NamedPart, SpaceSheet};
use grazing_input::kind::{above, number, numbers, table};
use grazing_model::maps::{MapError, global_map};
use grazing_model::{AtRest, ImpactOscillator, LinearOscillator, State};
use grazing_results::space::{CurveKind, MarkKind, Scene, SurfaceKind};

use crate::figure::prelude::*;
use crate::parameters::limits::{
    AROUND_ZERO, FREQUENCIES, FREQUENCY, ZETA, around_zero, damping_ratio, encloses, strictly_contains,
};
use crate::space::{Drawn, Projection, VIEW, Viewpoint, line, outline, trajectory};

/// The coefficient of restitution, which does not matter: P_global ignores impacts.
const ELASTIC: f64 = 1.0;
/// The positions x that the axis of x spans, and the velocity y up to which that of y extends.
const AXES: ([f64; 2], f64) = ([-0.75, 0.75], 0.75);
/// The part of the circle x = 0, y = 0 that is drawn as the axis of z, in radians.
const PHASE_AXIS: f64 = 0.8;

/// The bounds of the radius of the ring in Figure 3: Γ is two units of x wide, so a ring with a smaller
/// radius would overlap itself, and one with a larger radius looks straight.
const RADII: [f64; 2] = [2.0, 100.0];
/// The greatest phase from grazing that is still on one side of the ring.
const SECTION_REACH: f64 = 1.5;
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
        view: Viewpoint = table(), VIEW;
    }
}

impl FileSection for Figure3 {
    const NAME: &'static str = "fig03";
    const REQUIREMENT: &'static str = "the table [fig03] says what Figure 3 shows";

    fn checked(self, section: &Section<'_>, _: &Parameters) -> Result<Self, ParameterError> {
        let [x, z] = self.start;
        let shown = strictly_contains(self.position, x) && strictly_contains(self.phase, z);
        if shown { Ok(self) } else { Err(section.refusal("start").into()) }
    }
}

impl StudyFigure for Figure3 {
    const LABEL: &'static str = "fig:Ba";
    const TITLE: Title<&'static str> = Title::figure(3, "the return map near a grazing periodic solution");
    const TABLES: &'static [TablePlan] =
        &TablePlan::renamed(Scene::TABLES, ["fig03_curves", "fig03_points", "fig03_surfaces"]);
    const REMEDY: &'static str = "fig03.start or fig03.frequency";
    type Shown = Scene;

    /// Γ, the orbit from a point of Π (number 0) to its image (number 1), the map from one to the other,
    /// Π, and the circle x = 0, y = 0. It is an error if P_global is not defined.
    fn compute(&self, _: &Study) -> Result<Scene, StudyError> {
        let theory = grazing_theorems::LinearOscillator::new(self.zeta, ELASTIC)?;
        let grazing = theory.grazing(self.frequency)?;
        let oscillator = LinearOscillator::new(self.zeta, ELASTIC, grazing.amplitude(), self.frequency)?;
        let origin = grazing.phase();
        let space = Projection::new(&self.view, Some([self.radius, origin]));

        let [x, phase] = self.start;
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
        let [left, right] = self.position;
        let [from, to] = self.phase.map(|z| origin + z);
        let corners = [(left, from), (right, from), (right, to), (left, to)];
        drawn.face(SurfaceKind::Section, [0.0, 0.0], &outline(corners.map(|(x, z)| State::at_rest(x, z))));
        drawn.curve(SurfaceKind::Tangency, &line(State::at_rest(0.0, from), State::at_rest(0.0, to)));
        drawn.curve(SurfaceKind::Circle, &line(State::at_rest(0.0, to), State::at_rest(0.0, from + TAU)));
        let at = origin + self.axes;
        let (across, upwards) = AXES;
        drawn.curve(SurfaceKind::AxisX, &line(State::at_rest(across[0], at), State::at_rest(across[1], at)));
        drawn.curve(SurfaceKind::AxisY, &line(State::on_wall(0.0, at), State::on_wall(upwards, at)));
        drawn.curve(SurfaceKind::AxisZ, &line(State::at_rest(0.0, at), State::at_rest(0.0, at + PHASE_AXIS)));
        Ok(Scene { curves: curves.vertices, points, surfaces: drawn.vertices })
    }

    fn draw(scene: &Scene, width: SheetWidth) -> Result<Sheet, DrawingError> {
        SHEET.draw(scene, width)
    }
}

/// The layout and the names of Figure 3.
const SHEET: SpaceSheet = SpaceSheet {
    name: "fig03",
    title: "The return map near a grazing periodic solution",
    description: "Phase space with the phase as an angle. The grazing periodic solution meets the section once; the orbit of a \
         point of the section returns to it after one turn.",
    width_mm: 120.0,
    margin: Bounds { left: 12.0, right: 52.0, top: 8.0, bottom: 8.0 },
    mark_size: LABEL_SIZE,
    mark: |mark| match (mark.kind, mark.number) {
        (MarkKind::Graze, _) => Some(r"$(0,0,z_{\mathrm{graz}})$".to_owned()),
        (MarkKind::Section, 0) => Some("$(x,0,z)$".to_owned()),
        (MarkKind::Section, 1) => Some("$(x',0,z')$".to_owned()),
        _ => None,
    },
    names: &[
        (NamedPart::Curves(CurveKind::Global), r"$P_{\mathrm{global}}$", LABEL_SIZE, RETURN_COLOUR),
        (NamedPart::Curves(CurveKind::Periodic), r"$\Gamma$", TITLE_SIZE, BLACK),
        (NamedPart::Face(SurfaceKind::Section), r"$\Pi$", TITLE_SIZE, BLACK),
        (NamedPart::Line(SurfaceKind::Circle), "$x=y=0$", SMALL_LABEL_SIZE, BLACK),
    ],
};
