//! Figure 1 (fig:Bc): orbits in phase space, the impacting surface Σ and the reset law.

use core::f64::consts::TAU;

use grazing_model::motion::highest_maximum;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{ImpactOscillator, LinearOscillator, State};

use crate::StudyError;
use crate::parameters::{Arrival, Parameters};
use crate::space::{Drawn, Points, Space, axes, line, outline, trajectory};
use crate::table::Table;

/// The frames of Figure 1.
#[derive(Clone, Debug)]
pub struct Figure1 {
    /// `fig01_curves`: the free flights of the orbits, and the reset law from each impact to its recoil.
    pub curves: Table,
    /// `fig01_points`: impacts, recoils and grazing points, with the number of their orbit.
    pub points: Table,
    /// `fig01_surfaces`: incoming and outgoing set, tangency set, and the axes.
    pub surfaces: Table,
}

/// Positions x that the axis of x reaches; nothing else depends on it.
const AXIS: [f64; 2] = [-1.0, 0.6];
/// The most impacts of one orbit that a picture can show.
const MOST_IMPACTS: usize = 20;
/// What root finding leaves of x and z at an impact that is met again from another start (rounding, a thousandfold).
const SAME: f64 = 1e-9;

impl Figure1 {
    /// The tables that are written.
    pub fn tables(&self) -> Vec<Table> {
        vec![self.curves.clone(), self.points.clone(), self.surfaces.clone()]
    }

    pub(crate) fn compute(parameters: &Parameters) -> Result<Self, StudyError> {
        let shown = parameters.fig01()?;
        let of = shown.specimen();
        let oscillator = LinearOscillator::new(of.zeta(), of.epsilon(), of.amplitude(), of.frequency())?;
        let space = Space::straight(shown.view());
        let (mut curves, mut points) = (Drawn::new(&space), Points::new(&space));
        for (number, arrival) in (1..).zip(shown.orbits()) {
            let from = beginning(&oscillator, arrival);
            if arrival.velocity() == 0.0 {
                graze(&oscillator, from, arrival, number, &mut curves, &mut points)?;
            } else {
                fly(&oscillator, from, arrival, number, &mut curves, &mut points)?;
            }
        }
        let velocity = [shown.velocity().lower(), shown.velocity().upper()];
        Ok(Self {
            curves: curves.finish("fig01_curves")?,
            points: points.finish("fig01_points")?,
            surfaces: surfaces(&space, velocity)?,
        })
    }
}

/// The state at which an orbit begins: before the point on Σ, the wall ignored.
fn beginning(oscillator: &LinearOscillator, arrival: &Arrival) -> State {
    let at = State::on_wall(arrival.velocity(), arrival.phase());
    let back = -arrival.before() / oscillator.frequency();
    let jet = oscillator.flow::<1>(at, back);
    State { position: jet.value[0], velocity: jet.value[1], phase: arrival.phase() - arrival.before() }
}

fn duration(oscillator: &LinearOscillator, arrival: &Arrival) -> f64 {
    (arrival.before() + arrival.after()) / oscillator.frequency()
}

/// An orbit that touches Σ at the tangency set, where the reset law is the identity.
fn graze(
    oscillator: &LinearOscillator,
    from: State,
    arrival: &Arrival,
    number: u32,
    curves: &mut Drawn<'_>,
    points: &mut Points<'_>,
) -> Result<(), StudyError> {
    let top = State::on_wall(0.0, arrival.phase());
    let whole = duration(oscillator, arrival);
    let highest = highest_maximum(&oscillator.motion(from), whole);
    if from.position > 0.0
        || oscillator.acceleration(top) >= 0.0
        || highest.is_none_or(|top| top.position > SAME)
    {
        return Err(unreachable_arrival(arrival));
    }
    let start = -arrival.before() / oscillator.frequency();
    let mut states = trajectory(oscillator, top, start, 0.0);
    states.extend(trajectory(oscillator, top, 0.0, arrival.after() / oscillator.frequency()).drain(1..));
    curves.curve("orbit", &states);
    points.point("graze", number, top);
    Ok(())
}

/// An orbit with impacts, simulated from its beginning; its first impact must be the point that was asked for.
fn fly(
    oscillator: &LinearOscillator,
    from: State,
    arrival: &Arrival,
    number: u32,
    curves: &mut Drawn<'_>,
    points: &mut Points<'_>,
) -> Result<(), StudyError> {
    let mut first = true;
    for flight in Orbit::new(oscillator, from, duration(oscillator, arrival), MOST_IMPACTS) {
        curves.curve("orbit", &trajectory(oscillator, flight.from, 0.0, flight.duration));
        let FlightEnd::Impact(impact) = flight.end else {
            break;
        };
        let missed = (impact.velocity - arrival.velocity()).abs() + (impact.phase - arrival.phase()).abs();
        if core::mem::take(&mut first) && missed > SAME {
            return Err(unreachable_arrival(arrival));
        }
        let reset = oscillator.reset::<1>(impact.velocity, impact.phase).value;
        let recoil = State::on_wall(reset[0], reset[1]);
        curves.curve("reset", &line(impact, recoil));
        points.point("impact", number, impact);
        points.point("recoil", number, recoil);
    }
    if first { Err(unreachable_arrival(arrival)) } else { Ok(()) }
}

fn unreachable_arrival(arrival: &Arrival) -> StudyError {
    StudyError::Arrival { velocity: arrival.velocity(), phase: arrival.phase(), before: arrival.before() }
}

fn surfaces(space: &Space, velocity: [f64; 2]) -> Result<Table, StudyError> {
    let mut drawn = Drawn::new(space);
    for (kind, end) in [("incoming", velocity[1]), ("outgoing", velocity[0])] {
        let corners = [(0.0, 0.0), (end, 0.0), (end, TAU), (0.0, TAU)];
        drawn.face(kind, [0.0, end], &outline(corners.map(|(y, z)| State::on_wall(y, z))));
    }
    drawn.curve("tangency", &line(State::on_wall(0.0, 0.0), State::on_wall(0.0, TAU)));
    axes(&mut drawn, [AXIS, velocity, [0.0, TAU]], 0.0);
    drawn.finish("fig01_surfaces")
}
