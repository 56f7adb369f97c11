//! Figure 9 (fig:Bb): an impact and the points on Σ and Π that it defines, for p loops.

use core::f64::consts::TAU;

use grazing_drawing::geometry::sheet::Bounds;
use grazing_drawing::ink::style::{BLACK, RESET_COLOUR, RETURN_COLOUR, SMALL_LABEL_SIZE, TITLE_SIZE};
use grazing_drawing::plot::scene::{NamedPart, SpaceSheet};
use grazing_input::kind::{count, derived, numbers, table};
use grazing_model::maps::{MapError, global_map, virtual_map};
use grazing_model::motion::Motion;
use grazing_model::{AtRest, ImpactOscillator, LinearOscillator, OnWall, State};
use grazing_results::space::{CurveKind, MarkKind, Scene, SurfaceKind};

use crate::figure::prelude::*;
use crate::parameters::contains;
use crate::parameters::limits::{AROUND_ZERO, around_zero, range};
use crate::space::{Drawn, Projection, VIEW, Viewpoint, axes, line, oscillator, outline, recoil, trajectory};

/// The greatest number of loops that can be distinguished near the wall.
const MOST_LOOPS: u32 = 3;
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
        view: Viewpoint = table(), VIEW;
    }
}

impl FileSection for Figure9 {
    const NAME: &'static str = "fig09";
    const REQUIREMENT: &'static str = "the table [fig09] says what Figure 9 shows";

    fn checked(self, section: &Section<'_>, _: &Parameters) -> Result<Self, ParameterError> {
        let [y, z] = self.impact;
        let shown = y > 0.0 && contains(self.velocity, y) && contains(self.phase, z);
        if shown { Ok(self) } else { Err(section.refusal("impact").into()) }
    }
}

impl StudyFigure for Figure9 {
    const LABEL: &'static str = "fig:Bb";
    const TITLE: Title<&'static str> = Title::figure(9, "points on the impacting surface and on the section");
    const TABLES: &'static [TablePlan] =
        &TablePlan::renamed(Scene::TABLES, ["fig09_curves", "fig09_points", "fig09_surfaces"]);
    const REMEDY: &'static str = "fig09.impact, fig09.amplitude or fig09.frequency";
    type Shown = Scene;

    /// Real and virtual parts of the orbit near the wall, the reset law, P_global from point to point,
    /// and Π on both sides of the wall. The marks are the impact, the recoil, (x̂, 0, ẑ) as virtual, and
    /// (x⁽ʲ⁾, 0, z⁽ʲ⁾) with number j. It is an error if P_virt or P_global is not defined.
    fn compute(&self, _: &Study) -> Result<Scene, StudyError> {
        let oscillator = self.oscillator;
        let theory =
            grazing_theorems::LinearOscillator::new(oscillator.damping_ratio(), oscillator.restitution())?;
        let origin = theory.grazing(oscillator.frequency())?.phase();
        let space = Projection::new(&self.view, None);

        let failed = |reason: MapError| StudyError::Failed(format!("figure 9: {reason}"));
        // The virtual point of a state on the wall, and the time to it.
        let virtual_point = |from: State| {
            let landing = virtual_map::<_, 1>(&oscillator, OnWall::new(from.velocity, from.phase), None);
            let landing = landing.map_err(failed)?;
            Ok::<_, StudyError>((State::at_rest(landing.jet.value[0], landing.jet.value[1]), landing.time))
        };
        let impact = State::on_wall(self.impact[0], origin + self.impact[1]);
        let recoil = recoil(&oscillator, impact);
        let (ahead, time_ahead) = virtual_point(impact)?;
        let (behind, time_behind) = virtual_point(recoil)?;
        let mut points = vec![
            space.mark(MarkKind::Impact, 0, impact),
            space.mark(MarkKind::Recoil, 0, recoil),
            space.mark(MarkKind::Virtual, 0, ahead),
            space.mark(MarkKind::Section, 0, behind),
        ];

        let piece = |state: State, from: f64, to: f64| trajectory(&oscillator, state, from, to);
        let fallen = |state: State, forwards, level| to_level(&oscillator, state, forwards, level);
        let edge = self.position[0];
        let mut drawn = Drawn::new(&space);
        drawn.curve(CurveKind::Orbit, &piece(impact, fallen(impact, false, edge), 0.0));
        drawn.curve(CurveKind::Virtual, &piece(impact, 0.0, time_ahead));
        drawn.curve(CurveKind::Reset, &line(impact, recoil));
        drawn.curve(CurveKind::Virtual, &piece(recoil, time_behind, 0.0));
        drawn.curve(CurveKind::Orbit, &piece(recoil, 0.0, fallen(recoil, true, edge)));
        let mut last = behind;
        for number in 1..=self.loops {
            let landing = global_map::<_, 1>(&oscillator, AtRest::new(last.position, last.phase), None);
            let landing = landing.map_err(failed)?;
            let next = State::at_rest(landing.jet.value[0], landing.jet.value[1]);
            points.push(space.mark(MarkKind::Section, number, next));
            drawn.curve(CurveKind::Global, &line(last, next));
            let beyond = next.position > 0.0;
            let kind = if beyond { CurveKind::Virtual } else { CurveKind::Orbit };
            let begin = fallen(next, false, edge);
            if beyond {
                let wall = fallen(next, false, 0.0);
                drawn.curve(CurveKind::Orbit, &piece(next, begin, wall));
                drawn.curve(kind, &piece(next, wall, 0.0));
            } else {
                drawn.curve(kind, &piece(next, begin, 0.0));
            }
            if number < self.loops {
                drawn.curve(kind, &piece(next, 0.0, fallen(next, true, edge)));
            }
            last = next;
        }
        let surfaces = surfaces(&space, self, origin).vertices;
        Ok(Scene { curves: drawn.vertices, points, surfaces })
    }

    fn draw(scene: &Scene, width: SheetWidth) -> Result<Sheet, DrawingError> {
        SHEET.draw(scene, width)
    }
}

/// The layout and the names of Figure 9.
const SHEET: SpaceSheet = SpaceSheet {
    name: "fig09",
    title: "Points on the impacting surface and on the section",
    description: "Solid: the orbit near the wall. Dashed: its virtual parts beyond the wall. Arrows: the reset law, and the global \
         map on the section.",
    width_mm: 120.0,
    margin: Bounds { left: 8.0, right: 20.0, top: 14.0, bottom: 8.0 },
    mark_size: SMALL_LABEL_SIZE,
    mark: |mark| match mark.kind {
        MarkKind::Impact => Some(r"$(0,y_{\mathrm{imp}},z_{\mathrm{imp}})$".to_owned()),
        MarkKind::Recoil => Some(r"$(0,y_{\mathrm{rec}},z_{\mathrm{rec}})$".to_owned()),
        MarkKind::Virtual => Some(r"$(\hat{x},0,\hat{z})$".to_owned()),
        MarkKind::Section => Some(format!("$(x^{{({0})}},0,z^{{({0})}})$", mark.number)),
        MarkKind::Graze => None,
    },
    names: &[
        (NamedPart::Curves(CurveKind::Reset), "$R$", SMALL_LABEL_SIZE, RESET_COLOUR),
        (NamedPart::Curves(CurveKind::Global), r"$P_{\mathrm{global}}$", SMALL_LABEL_SIZE, RETURN_COLOUR),
        (NamedPart::Face(SurfaceKind::Incoming), r"$\Sigma$", TITLE_SIZE, BLACK),
        (NamedPart::Face(SurfaceKind::Section), r"$\Pi$", TITLE_SIZE, BLACK),
    ],
};

/// The time from a state near the wall, forwards or backwards, to where x has fallen to a level, or to
/// the turning point if it does not fall so far.
fn to_level(oscillator: &LinearOscillator, state: State, forwards: bool, level: f64) -> f64 {
    /// The fraction of a period after which an orbit that starts at rest on Π is moving.
    const MOMENT: f64 = 1e-3;
    let motion = oscillator.motion(state);
    let period = oscillator.forcing_period() * if forwards { 1.0 } else { -1.0 };
    let moment = if state.velocity == 0.0 { MOMENT * period } else { 0.0 };
    let there = motion.at(moment);
    let phase = state.phase + oscillator.frequency() * moment;
    let moving = State { position: there.position, velocity: there.velocity, phase };
    let rest = oscillator.motion(moving).first_rest(forwards, period.abs());
    let turning = moment + rest.unwrap_or(period);
    if motion.at(turning).position >= level {
        return turning;
    }
    // Up to the turning point x decreases monotonically.
    let (mut above, mut below) = (0.0, turning);
    loop {
        let middle = 0.5 * (above + below);
        if middle == above || middle == below {
            return middle;
        }
        if motion.at(middle).position >= level {
            above = middle;
        } else {
            below = middle;
        }
    }
}

fn surfaces<'a>(space: &'a Projection, shown: &Figure9, origin: f64) -> Drawn<'a, SurfaceKind> {
    let Figure9 { position, velocity, .. } = *shown;
    let phase = shown.phase.map(|z| origin + z);
    let mut drawn = Drawn::new(space);
    let corners = |end: f64| [(0.0, phase[0]), (end, phase[0]), (end, phase[1]), (0.0, phase[1])];
    for (kind, end) in [(SurfaceKind::Outgoing, velocity[0]), (SurfaceKind::Incoming, velocity[1])] {
        drawn.face(kind, [0.0, end], &outline(corners(end).map(|(y, z)| State::on_wall(y, z))));
    }
    for end in position {
        drawn.face(
            SurfaceKind::Section,
            [end, 0.0],
            &outline(corners(end).map(|(x, z)| State::at_rest(x, z))),
        );
    }
    drawn.curve(SurfaceKind::Tangency, &line(State::on_wall(0.0, phase[0]), State::on_wall(0.0, phase[1])));
    axes(&mut drawn, [position, velocity, phase], phase[0]);
    drawn
}
