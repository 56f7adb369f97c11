//! Figure 1 (fig:Bc): orbits in phase space, the impacting surface Σ and the reset law.

use core::f64::consts::TAU;

use grazing_drawing::geometry::sheet::Bounds;
use grazing_drawing::ink::style::{BLACK, LABEL_SIZE, RESET_COLOUR, SMALL_LABEL_SIZE, TITLE_SIZE};
use grazing_drawing::plot::scene::{NamedPart, SpaceSheet};
use grazing_input::kind::{derived, number, positive, strictly, table, tables};
use grazing_model::motion::Motion;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{ImpactOscillator, LinearOscillator, State};
use grazing_results::space::{CurveKind, MarkKind, Scene, SurfaceKind};

use crate::figure::prelude::*;
use crate::parameters::contains;
use crate::parameters::limits::{AROUND_ZERO, around_zero};
use crate::space::{Drawn, Projection, VIEW, Viewpoint, axes, line, oscillator, outline, recoil, trajectory};

/// The positions x that the axis of x spans; nothing else depends on it.
const AXIS: [f64; 2] = [-1.0, 0.6];
/// The greatest number of impacts of an orbit in a picture.
const MOST_IMPACTS: usize = 20;
/// The tolerance for x and z of an impact that is reached again from another start: a thousand times the
/// rounding error of root finding.
const SAME: f64 = 1e-9;

/// The greatest number of orbits in Figure 1, so that they can be distinguished.
const MOST_ARRIVALS: usize = 8;

keys! {
    /// Figure 1: orbits that reach the impacting surface.
    pub struct Figure1 {
        /// The oscillator.
        oscillator: LinearOscillator = derived(oscillator);
        /// The velocities y that the shown part of Sigma reaches.
        velocity: [f64; 2] = around_zero(), AROUND_ZERO;
        /// The view.
        view: Viewpoint = table(), VIEW;
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
        /// The phase z at that point in radians; with what follows, the orbit stays within [0, 2
        /// pi].
        phase: f64 = number(strictly(0.0, TAU)), "the phase must lie strictly between 0 and 2 pi";
        /// How much phase before the point the orbit is drawn, in radians.
        before: f64 = positive(),
            "the phase before must be positive, and the orbit must begin at 0 or later";
        /// How much phase after the point the orbit is drawn, in radians.
        after: f64 = positive(),
            "the phase after must be positive, and the orbit must end before 2 pi";
    }
}

impl FileSection for Figure1 {
    const NAME: &'static str = "fig01";
    const REQUIREMENT: &'static str = "the table [fig01] says what Figure 1 shows";

    fn checked(self, section: &Section<'_>, _: &Parameters) -> Result<Self, ParameterError> {
        for (orbit, number) in self.orbits.iter().zip(1..) {
            let reached = [orbit.velocity, -self.oscillator.restitution() * orbit.velocity];
            for (name, right) in [
                ("velocity", reached.iter().all(|y| contains(self.velocity, *y))),
                ("before", orbit.before <= orbit.phase),
                ("after", orbit.phase + orbit.after < TAU),
            ] {
                if !right {
                    return Err(section.refusal(&format!("orbits[{number}].{name}")).into());
                }
            }
        }
        Ok(self)
    }
}

impl StudyFigure for Figure1 {
    const LABEL: &'static str = "fig:Bc";
    const TITLE: Title<&'static str> = Title::figure(1, "phase space, impacting surface and reset law");
    const TABLES: &'static [TablePlan] =
        &TablePlan::renamed(Scene::TABLES, ["fig01_curves", "fig01_points", "fig01_surfaces"]);
    const REMEDY: &'static str = "fig01.orbits, fig01.amplitude or fig01.frequency";
    type Shown = Scene;

    /// The free flights of orbits, the reset law from each impact to its recoil, their marks with the
    /// number of the orbit, and Σ. An orbit that does not reach the wall where it should is an error.
    fn compute(&self, _: &Study) -> Result<Scene, StudyError> {
        let oscillator = self.oscillator;
        let space = Projection::new(&self.view, None);
        let (mut curves, mut points) = (Drawn::new(&space), Vec::new());
        for (number, arrival) in (1..).zip(&self.orbits) {
            let from = beginning(&oscillator, arrival);
            if arrival.velocity == 0.0 {
                graze(&oscillator, from, arrival, &mut curves)?;
                points.push(space.mark(MarkKind::Graze, number, State::on_wall(0.0, arrival.phase)));
            } else {
                for (impact, recoil) in fly(&oscillator, from, arrival, &mut curves)? {
                    points.push(space.mark(MarkKind::Impact, number, impact));
                    points.push(space.mark(MarkKind::Recoil, number, recoil));
                }
            }
        }
        let surfaces = surfaces(&space, self.velocity).vertices;
        Ok(Scene { curves: curves.vertices, points, surfaces })
    }

    fn draw(scene: &Scene, width: SheetWidth) -> Result<Sheet, DrawingError> {
        SHEET.draw(scene, width)
    }
}

/// The layout and the names of Figure 1.
const SHEET: SpaceSheet = SpaceSheet {
    name: "fig01",
    title: "Phase space of an impacting hybrid system",
    description: "The impacting surface, x = 0, with its incoming set above, its outgoing set below and the tangency set between \
         them. Solid: orbits. Dashed: the reset law from the incoming to the outgoing set.",
    width_mm: 80.0,
    margin: Bounds { left: 5.0, right: 13.0, top: 14.0, bottom: 5.0 },
    mark_size: LABEL_SIZE,
    mark: |_| None,
    names: &[
        (NamedPart::Curves(CurveKind::Reset), "$R$", LABEL_SIZE, RESET_COLOUR),
        (NamedPart::Face(SurfaceKind::Incoming), "incoming set", SMALL_LABEL_SIZE, BLACK),
        (NamedPart::Face(SurfaceKind::Incoming), r"$\Sigma$", TITLE_SIZE, BLACK),
        (NamedPart::Face(SurfaceKind::Outgoing), "outgoing set", SMALL_LABEL_SIZE, BLACK),
        (NamedPart::Border(SurfaceKind::Tangency), "tangency set", SMALL_LABEL_SIZE, BLACK),
    ],
};

/// The state at which an orbit begins: before the point on Σ, with the wall ignored.
fn beginning(oscillator: &LinearOscillator, arrival: &Arrival) -> State {
    let at = State::on_wall(arrival.velocity, arrival.phase);
    let back = -arrival.before / oscillator.frequency();
    let jet = oscillator.flow::<1>(at, back);
    State { position: jet.value[0], velocity: jet.value[1], phase: arrival.phase - arrival.before }
}

fn duration(oscillator: &LinearOscillator, arrival: &Arrival) -> f64 {
    (arrival.before + arrival.after) / oscillator.frequency()
}

/// An orbit that touches Σ at the tangency set, where the reset law is the identity.
fn graze(
    oscillator: &LinearOscillator,
    from: State,
    arrival: &Arrival,
    curves: &mut Drawn<'_, CurveKind>,
) -> Result<(), StudyError> {
    let top = State::on_wall(0.0, arrival.phase);
    let whole = duration(oscillator, arrival);
    let highest = oscillator.motion(from).highest_maximum(whole);
    if from.position > 0.0
        || oscillator.acceleration(top) >= 0.0
        || highest.is_none_or(|top| top.position > SAME)
    {
        return Err(unreachable_arrival(arrival));
    }
    let start = -arrival.before / oscillator.frequency();
    let mut states = trajectory(oscillator, top, start, 0.0);
    states.extend(trajectory(oscillator, top, 0.0, arrival.after / oscillator.frequency()).drain(1..));
    curves.curve(CurveKind::Orbit, &states);
    Ok(())
}

/// An orbit with impacts, simulated from its beginning; its first impact must be the requested point.
/// Returns impacts and recoils.
fn fly(
    oscillator: &LinearOscillator,
    from: State,
    arrival: &Arrival,
    curves: &mut Drawn<'_, CurveKind>,
) -> Result<Vec<(State, State)>, StudyError> {
    let mut impacts = Vec::new();
    for flight in Orbit::new(oscillator, from, duration(oscillator, arrival), MOST_IMPACTS) {
        curves.curve(CurveKind::Orbit, &trajectory(oscillator, flight.from, 0.0, flight.duration));
        let FlightEnd::Impact(impact) = flight.end else {
            break;
        };
        let missed = (impact.velocity - arrival.velocity).abs() + (impact.phase - arrival.phase).abs();
        if impacts.is_empty() && missed > SAME {
            return Err(unreachable_arrival(arrival));
        }
        let recoil = recoil(oscillator, impact);
        curves.curve(CurveKind::Reset, &line(impact, recoil));
        impacts.push((impact, recoil));
    }
    if impacts.is_empty() { Err(unreachable_arrival(arrival)) } else { Ok(impacts) }
}

fn unreachable_arrival(arrival: &Arrival) -> StudyError {
    let Arrival { velocity, phase, before, .. } = arrival;
    StudyError::Failed(format!(
        "figure 1: the orbit through (0, {velocity}, {phase}) on Sigma, begun {before} in phase earlier, meets the wall at \
         another place first"
    ))
}

fn surfaces(space: &Projection, velocity: [f64; 2]) -> Drawn<'_, SurfaceKind> {
    let mut drawn = Drawn::new(space);
    for (kind, end) in [(SurfaceKind::Incoming, velocity[1]), (SurfaceKind::Outgoing, velocity[0])] {
        let corners = [(0.0, 0.0), (end, 0.0), (end, TAU), (0.0, TAU)];
        drawn.face(kind, [0.0, end], &outline(corners.map(|(y, z)| State::on_wall(y, z))));
    }
    drawn.curve(SurfaceKind::Tangency, &line(State::on_wall(0.0, 0.0), State::on_wall(0.0, TAU)));
    axes(&mut drawn, [AXIS, velocity, [0.0, TAU]], 0.0);
    drawn
}
