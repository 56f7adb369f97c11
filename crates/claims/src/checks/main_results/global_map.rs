//! Section 2.2: grazing and the global return map.

use super::returns::{derivatives, returned};
use crate::*;

/// The tolerance of the differences: empirical, about ten times the largest deviation.
const DIFFERENCES: f64 = 1e-10;

checks! {
    /// ass:grazing: the orbit from (0, 0, z_graz) is periodic, touches the wall once a period and
    /// lies below it otherwise, and F < 0 where it touches; at another μ there is none.
    grazing_orbit: at_grazing(11, 100) |_, orbit; cases: Votes| {
        let oscillator = orbit.oscillator();
        let period = oscillator.forcing_period();
        let from = State::at_rest(0.0, orbit.phase());
        let end = oscillator.flow::<1>(from, period).value;
        // Over one period from half a period before the contact.
        let middle = oscillator.flow::<1>(from, 0.5 * period).value;
        let start = State {
            position: middle[0],
            velocity: middle[1],
            phase: orbit.phase() + 0.5 * core::f64::consts::TAU,
        };
        let maxima = oscillator.motion(start).local_maxima(period);
        // Positions of order one are accurate to a few roundings; other maxima are far lower.
        let touching = maxima.iter().filter(|maximum| maximum.position > -1e-12).count();
        let inside = maxima.iter().all(|maximum| maximum.position < 1e-12);
        let periodic = end.amax() < 1e-12;
        cases.see(periodic && touching == 1 && inside && oscillator.acceleration(from) < 0.0);
        // A violated hypothesis: away from the grazing value of μ no such orbit is periodic.
        let [primary, secondary] = oscillator.parameters();
        let off = oscillator.with_parameters([primary * 1.01, secondary]);
        let [x, z] = returned(&off, [0.0, orbit.phase()])?.into();
        cases.see(x.abs() + (z - orbit.phase()).abs() > 1e-6);
    } => cases.outcome("grazing orbits of random oscillators, and values of μ beside them");
    /// eq:Pglobal: the remainder after the linear part is of second order.
    // Slack for the cubic terms at the smallest resolved sizes.
    expansion: at_grazing(12, 60) |sampler, orbit; least: Smallest| {
        let oscillator = orbit.oscillator();
        let [primary, secondary] = oscillator.parameters();
        let map = orbit.grazing_point().map;
        let [x, z, mu] = [(); 3].map(|()| sampler.between(-1.0, 1.0));
        let mut failure = None;
        least.see_resolved(order(|h| {
            let near = oscillator.with_parameters([primary + h * mu, secondary]);
            let image = match returned(&near, [h * x, orbit.phase() + h * z]) {
                Ok(image) => image,
                Err(error) => {
                    failure = Some(error);
                    return None;
                }
            };
            let linear = map.a * Vector2::new(h * x, h * z) + map.b * (h * mu);
            let remainder = image - Vector2::new(0.0, orbit.phase()) - linear;
            // The phase of a maximum is accurate to about 10⁻¹⁵, its derivatives are up to ten.
            Some((remainder.norm(), 1e-14))
        }));
        if let Some(error) = failure {
            return Err(error);
        }
    } => least.order(2.0, 0.3, "directions in (x, z, μ) at grazing orbits of random oscillators");
    /// eq:A: ∂(x', z')/∂(x, z) by hand-written derivatives, compared with differences of event locations.
    derivative: at_grazing(13, 60) |_, orbit; largest: Deviations| {
        let a = orbit.grazing_point().map.a;
        let [by_position, by_phase, _] = derivatives(orbit, 1.0)?;
        largest.see((Matrix2::from_columns(&[by_position, by_phase]) - a).amax() / a.amax().max(1.0));
    } => largest.outcome(DIFFERENCES, "entries of A of random oscillators");
    /// eq:b: ∂P_global/∂μ, compared in the same way, with the amplitude or the frequency as μ.
    parameter_derivative: at_grazing(14, 60) |_, orbit; largest: Deviations| {
        let b = orbit.grazing_point().map.b;
        let [_, _, by_parameter] = derivatives(orbit, 1.0)?;
        largest.see((by_parameter - b).amax() / b.amax().max(1.0));
    } => largest.outcome(DIFFERENCES, "entries of b of random oscillators");
}
