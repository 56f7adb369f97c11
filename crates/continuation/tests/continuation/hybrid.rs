//! MPSs checked against the hybrid system itself, simulated from event to event.

use grazing_continuation::mps::MaximalPeriodicSolution;
use grazing_model::motion::Motion;
use grazing_model::orbit::{FlightEnd, Orbit, OrbitEnd};
use grazing_model::{ImpactOscillator, LinearOscillator, State};
use nalgebra::Matrix2;

/// What the simulated orbit from an impact does until it impacts again.
pub(crate) struct Return {
    /// Time to the next impact, in forcing periods.
    pub(crate) periods: f64,
    /// Velocity of the next impact.
    pub(crate) velocity: f64,
}

/// Simulates from the impact of an MPS to the next impact.
pub(crate) fn next_impact(oscillator: &LinearOscillator, solution: &MaximalPeriodicSolution) -> Return {
    let [velocity, phase] = [solution.unknowns[0], solution.unknowns[1]];
    let period = oscillator.forcing_period();
    let horizon = 2.0 * f64::from(solution.loops) * period;
    let flight = Orbit::new(oscillator, State::on_wall(velocity, phase), horizon, 10)
        .next()
        .unwrap();
    let FlightEnd::Impact(impact) = flight.end else {
        panic!("no impact within {horizon} after {solution:?}");
    };
    Return {
        periods: flight.duration / period,
        velocity: impact.velocity,
    }
}

/// The stroboscopic map over p forcing periods: (x, y) to (x, y), with the number of impacts on the way.
fn strobe(oscillator: &LinearOscillator, from: State, loops: u32) -> ([f64; 2], usize) {
    let horizon = f64::from(loops) * oscillator.forcing_period();
    let mut orbit = Orbit::new(oscillator, from, horizon, 100);
    for _ in orbit.by_ref() {}
    let Some(OrbitEnd::TimeIsUp(state)) = orbit.end() else {
        panic!("{:?}", orbit.end());
    };
    ([state.position, state.velocity], orbit.impacts())
}

/// The derivative of the stroboscopic map half a period after the impact of an MPS, by central differences with steps ±h.
///
/// Panics unless all orbits have exactly one impact.
pub(crate) fn strobe_derivative(
    oscillator: &LinearOscillator,
    solution: &MaximalPeriodicSolution,
    h: f64,
) -> Matrix2<f64> {
    let [velocity, phase] = [solution.unknowns[0], solution.unknowns[1]];
    let half = 0.5 * oscillator.forcing_period();
    let recoil = oscillator.reset::<1>(velocity, phase).value;
    let middle = oscillator.motion(State::on_wall(recoil[0], recoil[1])).at(half);
    let image = |dx: f64, dy: f64| {
        let from = State {
            position: middle.position + dx,
            velocity: middle.velocity + dy,
            phase: phase + oscillator.frequency() * half,
        };
        let (image, impacts) = strobe(oscillator, from, solution.loops);
        assert_eq!(impacts, 1, "{solution:?}");
        image
    };
    let columns = [[image(h, 0.0), image(-h, 0.0)], [image(0.0, h), image(0.0, -h)]];
    Matrix2::from_fn(|i, j| (columns[j][0][i] - columns[j][1][i]) / (2.0 * h))
}
