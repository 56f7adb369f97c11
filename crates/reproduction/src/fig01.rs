//! Figure 1 (fig:Bc): orbits in phase space, the impacting surface Σ and the reset law.

use core::f64::consts::TAU;

use grazing_model::motion::Motion;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{ImpactOscillator, LinearOscillator, State};
use grazing_results::space::{CurveKind, MarkKind, Scene, SurfaceKind};

use crate::parameters::Arrival;
use crate::space::{Drawn, Space, axes, line, outline, recoil, trajectory};
use crate::{Study, StudyError};

/// Positions x that the axis of x reaches; nothing else depends on it.
const AXIS: [f64; 2] = [-1.0, 0.6];
/// The most impacts of one orbit that a picture can show.
const MOST_IMPACTS: usize = 20;
/// What root finding leaves of x and z at an impact that is met again from another start (rounding,
/// a thousandfold).
const SAME: f64 = 1e-9;

impl Study {
    /// Figure 1: free flights of orbits, the reset law from each impact to its recoil, the marks of
    /// these with the number of their orbit, and Σ.
    ///
    /// # Errors
    /// An orbit does not reach the wall where it should.
    pub fn fig01(&self) -> Result<Scene, StudyError> {
        let shown = self.parameters.fig01.get()?;
        let oscillator = shown.oscillator;
        let space = Space::new(&shown.view, None);
        let (mut curves, mut points) = (Drawn::new(&space), Vec::new());
        for (number, arrival) in (1..).zip(&shown.orbits) {
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
        let surfaces = surfaces(&space, shown.velocity).vertices;
        Ok(Scene { curves: curves.vertices, points, surfaces })
    }
}

/// The state at which an orbit begins: before the point on Σ, the wall ignored.
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

/// An orbit with impacts, simulated from its beginning; its first impact must be the point that was
/// asked for. Returns impacts and recoils.
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

fn surfaces(space: &Space, velocity: [f64; 2]) -> Drawn<'_, SurfaceKind> {
    let mut drawn = Drawn::new(space);
    for (kind, end) in [(SurfaceKind::Incoming, velocity[1]), (SurfaceKind::Outgoing, velocity[0])] {
        let corners = [(0.0, 0.0), (end, 0.0), (end, TAU), (0.0, TAU)];
        drawn.face(kind, [0.0, end], &outline(corners.map(|(y, z)| State::on_wall(y, z))));
    }
    drawn.curve(SurfaceKind::Tangency, &line(State::on_wall(0.0, 0.0), State::on_wall(0.0, TAU)));
    axes(&mut drawn, [AXIS, velocity, [0.0, TAU]], 0.0);
    drawn
}
