//! MPSs checked against the hybrid system itself, simulated from event to event.

use grazing_continuation::mps::{Multipliers, PeriodicSolution};
use grazing_model::motion::Motion;
use grazing_model::orbit::{FlightEnd, Orbit, OrbitEnd};
use grazing_model::{ImpactOscillator, LinearOscillator, OnWall, State};
use nalgebra::{Matrix2, Vector2};

use crate::specimens::assert_within;

/// The state just after the impact of an MPS.
fn recoil(oscillator: &LinearOscillator, solution: &PeriodicSolution) -> State {
    let reset = oscillator.reset::<1>(OnWall::new(solution.unknowns[0], solution.unknowns[1])).value;
    State::on_wall(reset[0], reset[1])
}

/// The time after which an MPS repeats itself.
fn duration(oscillator: &LinearOscillator, solution: &PeriodicSolution) -> f64 {
    f64::from(solution.loops) * oscillator.forcing_period()
}

/// The flight from the impact of an MPS to the next impact: its length, and the velocity of that
/// impact.
fn next_impact(oscillator: &LinearOscillator, solution: &PeriodicSolution) -> [f64; 2] {
    let from = State::on_wall(solution.unknowns[0], solution.unknowns[1]);
    let horizon = 1.5 * duration(oscillator, solution);
    let flight = Orbit::new(oscillator, from, horizon, 10).next().unwrap();
    let FlightEnd::Impact(impact) = flight.end else {
        panic!("no impact after {solution:?}");
    };
    [flight.duration, impact.velocity]
}

/// Fails unless the orbit from the impact of an admissible MPS impacts next after p forcing periods
/// with the same velocity.
///
/// There is then one impact in p periods and a return to (y, z). The position is back at the wall
/// to some 10⁻¹⁴: a zero with its multiplier of order 1/y; velocity and time of the impact are off
/// by that over y.
#[track_caller]
pub(crate) fn assert_returns(oscillator: &LinearOscillator, solution: &PeriodicSolution) {
    let [time, impact_velocity] = next_impact(oscillator, solution);
    let velocity = solution.impact_velocity();
    let bound = 1e-10 + 1e-13 / velocity;
    assert_within(time, duration(oscillator, solution), bound);
    assert_within(impact_velocity, velocity, bound);
}

/// Whether the orbit from the impact of an MPS reaches the wall before p forcing periods are over.
pub(crate) fn impacts_early(oscillator: &LinearOscillator, solution: &PeriodicSolution) -> bool {
    next_impact(oscillator, solution)[0] < duration(oscillator, solution) - 1e-6
}

/// Fails unless the orbit from the impact of an MPS touches the wall within p forcing periods,
/// never crosses it, and is back at the wall with the same velocity after that time.
#[track_caller]
pub(crate) fn assert_touches(oscillator: &LinearOscillator, solution: &PeriodicSolution) {
    let period = duration(oscillator, solution);
    let motion = oscillator.motion(recoil(oscillator, solution));
    let end = motion.at(period);
    assert_within(end.position, 0.0, 1e-10);
    assert_within(end.velocity, solution.unknowns[0], 1e-10);
    // The maximum was solved for to rounding of x, at a time carried along the curve.
    let highest = motion.highest_maximum(period).unwrap();
    assert_within(highest.position, 0.0, PeriodicSolution::TOUCH);
}

/// The stroboscopic map over p forcing periods from a displacement off an MPS, half a period after
/// its impact.
///
/// `None` if there is not exactly one impact.
fn strobe(
    oscillator: &LinearOscillator,
    solution: &PeriodicSolution,
    displacement: Vector2<f64>,
) -> Option<Vector2<f64>> {
    let half = 0.5 * oscillator.forcing_period();
    let middle = oscillator.motion(recoil(oscillator, solution)).at(half);
    let at = Vector2::new(middle.position, middle.velocity);
    let from = State {
        position: at[0] + displacement[0],
        velocity: at[1] + displacement[1],
        phase: solution.unknowns[1] + oscillator.frequency() * half,
    };
    let mut orbit = Orbit::new(oscillator, from, duration(oscillator, solution), 100);
    for _ in orbit.by_ref() {}
    match (orbit.impacts(), orbit.end()) {
        (1, Some(OrbitEnd::TimeIsUp(state))) => Some(Vector2::new(state.position, state.velocity) - at),
        _ => None,
    }
}

/// Trace and determinant of the derivative of the stroboscopic map, by central differences with
/// steps ±h.
///
/// `None` if an orbit does not have exactly one impact.
pub(crate) fn simulated_multipliers(
    oscillator: &LinearOscillator,
    solution: &PeriodicSolution,
    h: f64,
) -> Option<Multipliers> {
    let column = |direction: Vector2<f64>| {
        let ahead = strobe(oscillator, solution, direction * h)?;
        let back = strobe(oscillator, solution, -direction * h)?;
        Some((ahead - back) / (2.0 * h))
    };
    let derivative = Matrix2::from_columns(&[column(Vector2::x())?, column(Vector2::y())?]);
    Some(Multipliers { trace: derivative.trace(), determinant: derivative.determinant() })
}

/// The map from impact to impact over p loops with the wall ignored in between, as (y, z) relative
/// to the MPS.
fn unhindered_return(
    oscillator: &LinearOscillator,
    solution: &PeriodicSolution,
    displacement: Vector2<f64>,
) -> Vector2<f64> {
    let from = Vector2::new(solution.unknowns[0], solution.unknowns[1]) + displacement;
    let reset = oscillator.reset::<1>(OnWall::new(from[0], from[1])).value;
    let motion = oscillator.motion(State::on_wall(reset[0], reset[1]));
    let period = duration(oscillator, solution);
    let mut time = period;
    for _ in 0..8 {
        let here = motion.at(time);
        time -= here.position / here.velocity;
    }
    let lag = oscillator.frequency() * (time - period);
    Vector2::new(motion.at(time).velocity - solution.unknowns[0], displacement[1] + lag)
}

/// Fails unless a zero of the equations comes back to its impact after p forcing periods with the
/// wall ignored in between, with the right trace and determinant of the derivative of this return.
///
/// For solutions that are not admissible and so do not exist in the hybrid system.
#[track_caller]
pub(crate) fn assert_returns_unhindered(oscillator: &LinearOscillator, solution: &PeriodicSolution) {
    const H: f64 = 1e-6;
    assert_within(unhindered_return(oscillator, solution, Vector2::zeros()).norm(), 0.0, 1e-11);
    let column = |direction: Vector2<f64>| {
        let ahead = unhindered_return(oscillator, solution, direction * H);
        (ahead - unhindered_return(oscillator, solution, -direction * H)) / (2.0 * H)
    };
    let derivative = Matrix2::from_columns(&[column(Vector2::x()), column(Vector2::y())]);
    // Impact velocities are above 0.05: (H/y²)² and 10⁻¹⁴/(H y).
    let scale = 1.0 + solution.multipliers.trace.abs();
    assert_within(derivative.trace(), solution.multipliers.trace, 1e-6 * scale);
    assert_within(derivative.determinant(), solution.multipliers.determinant, 1e-6 * scale);
}
