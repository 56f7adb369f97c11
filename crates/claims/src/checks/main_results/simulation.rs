//! MPSs seen in the hybrid system itself, simulated from impact to impact.

use grazing_continuation::mps::MaximalPeriodicSolution;
use grazing_model::motion::Motion;
use grazing_model::orbit::{FlightEnd, Orbit, OrbitEnd};
use grazing_model::{ImpactOscillator, OnWall, State};
use nalgebra::Vector2;

/// Whether the simulated orbit from the impact of an MPS has its next impact after p forcing periods less what the impact
/// takes, at the same velocity.
///
/// The position there is good to some 10⁻¹⁴; velocity and time of the impact are off by that over y.
pub(crate) fn returns<O: ImpactOscillator>(oscillator: &O, solution: &MaximalPeriodicSolution) -> bool {
    let (velocity, phase) = (solution.unknowns[0], solution.unknowns[1]);
    if velocity <= 0.0 {
        return false;
    }
    let delay = oscillator.reset::<1>(OnWall::new(velocity, phase)).value[1] - phase;
    let period = f64::from(solution.loops) * oscillator.forcing_period()
        - delay / oscillator.forcing_frequency().value;
    let first = Orbit::new(oscillator, State::on_wall(velocity, phase), 1.5 * period, 10).next();
    let bound = 1e-9 + 1e-12 / velocity;
    match first {
        Some(flight) => match flight.end {
            FlightEnd::Impact(impact) => {
                (flight.duration - period).abs() < bound && (impact.velocity - velocity).abs() < bound
            }
            FlightEnd::TimeIsUp(_) => false,
        },
        None => false,
    }
}

/// What the simulated orbit from 10⁻⁷ beside an MPS does: it comes a hundred times nearer (true), or goes a hundred times
/// farther or loses the pattern of one impact in p periods (false); nothing if neither is seen in 10 000 returns.
pub(crate) fn attracts<O: ImpactOscillator>(
    oscillator: &O,
    solution: &MaximalPeriodicSolution,
) -> Option<bool> {
    let (velocity, phase) = (solution.unknowns[0], solution.unknowns[1]);
    let reset = oscillator.reset::<1>(OnWall::new(velocity, phase)).value;
    // Half a period after the impact, where the section of constant phase is crossed without impact.
    let half = 0.5 * oscillator.forcing_period();
    let middle = oscillator.motion(State::on_wall(reset[0], reset[1])).at(half);
    let centre = Vector2::new(middle.position, middle.velocity);
    let section = reset[1] + oscillator.forcing_frequency().value * half;
    let horizon = f64::from(solution.loops) * oscillator.forcing_period();
    let mut displacement = Vector2::new(0.6e-7, -0.8e-7);
    for _ in 0..10_000 {
        let [position, velocity] = (centre + displacement).into();
        let mut orbit = Orbit::new(oscillator, State { position, velocity, phase: section }, horizon, 100);
        for _ in orbit.by_ref() {}
        let Some(OrbitEnd::TimeIsUp(end)) = orbit.end().filter(|_| orbit.impacts() == 1) else {
            return Some(false);
        };
        displacement = Vector2::new(end.position, end.velocity) - centre;
        match displacement.norm() {
            near if near < 1e-9 => return Some(true),
            near if near > 1e-5 => return Some(false),
            _ => {}
        }
    }
    None
}
