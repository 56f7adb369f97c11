//! Section 2.1: equations of motion and reset law.

use crate::*;
use grazing_model::motion::Motion;

checks! {
    /// eq:f: the components of the vector field against first differences along the flow.
    // The slack is for the next term; the third component holds exactly, and therefore shows no order.
    vector_field: at_grazing(2, 60) |sampler, orbit; least: Smallest| {
        let oscillator = orbit.oscillator();
        let from = sampler.state();
        let field = [from.velocity, oscillator.acceleration(from), oscillator.forcing_frequency().value];
        let motion = oscillator.motion(from);
        for (i, component) in field.into_iter().enumerate() {
            least.see(order(|h| {
                let at = |time: f64| {
                    let there = motion.at(time);
                    // The acceleration identifies the phase after a time, through the forcing.
                    let forcing = |phase: f64| {
                        oscillator.acceleration(State {
                            position: there.position,
                            velocity: there.velocity,
                            phase,
                        })
                    };
                    let phase = from.phase + component * time;
                    [there.position, there.velocity, there.acceleration - forcing(phase)][i]
                };
                let difference = (at(h) - at(-h)) / (2.0 * h);
                Some((if i < 2 { difference - component } else { difference }, 1e-15 / h))
            }));
        }
    } => least.order(2.0, 0.3, "components of the field at states of random oscillators");
    /// eq:z: along orbits with impacts, which may take time, the phase is ωt in [0, 2π).
    // Phases up to 130 added up over at most 200 impacts.
    phase: drawn(3, 40) |sampler; largest: Deviations| {
        let orbit = Law::random_grazing(sampler)?;
        let at_grazing = orbit.oscillator();
        let [amplitude, frequency] = at_grazing.parameters();
        let oscillator = at_grazing.with_parameters([1.2 * amplitude, frequency]);
        let from = State { position: -0.5, velocity: 0.0, phase: sampler.between(0.0, TAU) };
        let horizon = 20.0 * oscillator.forcing_period();
        for flight in Orbit::new(&oscillator, from, horizon, 200) {
            let phase = flight.from.phase;
            let elapsed = from.phase + frequency * flight.start - phase;
            let turns = libm::round(elapsed / TAU);
            let inside = (0.0..TAU).contains(&phase);
            largest.see(if inside { (elapsed - turns * TAU).abs() } else { f64::INFINITY });
        }
    } => largest.outcome(1e-12, "flights of orbits with impacts");
    /// Σ_graz: where F < 0 at (0, 0, z), and only there, the orbit stays on the free side.
    grazing_set: drawn(4, 300) |sampler; cases: Votes| {
        let orbit = Law::random_grazing(sampler)?;
        let at_grazing = orbit.oscillator();
        let [_, frequency] = at_grazing.parameters();
        // Amplitudes above 1 reach the part of the tangency set where F > 0.
        let oscillator = at_grazing.with_parameters([sampler.between(0.5, 3.0), frequency]);
        let from = State::on_wall(0.0, sampler.between(0.0, TAU));
        let force = oscillator.acceleration(from);
        // At a time of 10⁻⁵ the jerk changes x by 10⁻¹⁵ times a number of order one.
        if force.abs() < 1e-4 {
            return Ok(());
        }
        let motion = oscillator.motion(from);
        let free = [1e-5, -1e-5].map(|time| motion.at(time).position < 0.0);
        cases.see(free == [force < 0.0; 2]);
    } => cases.outcome("points of the tangency set, F of both signs");
    /// eq:R: incoming set to outgoing set, tangency set to itself, in the form with Φ and Ψ.
    reset_form: drawn(5, 40) |sampler; least: Smallest| {
        let orbit = Law::random_grazing(sampler)?;
        let oscillator = orbit.oscillator();
        let (margin, _) = smallest(5, 6, |[a, b]: [f64; 2]| {
            // Down to velocities at which only the quotient is of order one.
            let (velocity, phase) = (0.6 * a * a * a, TAU * b);
            let law = |velocity: f64| oscillator.reset::<1>(OnWall::new(velocity, phase)).value;
            let tangent = law(0.0);
            let image = law(velocity);
            let [restitution, delay] = oscillator.factors(velocity, phase);
            let form =
                (image[0] + velocity * restitution).abs() + (image[1] - phase - velocity * delay).abs();
            // Form and identity hold to a few roundings of the phase.
            if tangent[0] != 0.0 || tangent[1] != phase || form > 4e-15 {
                return -1.0;
            }
            if velocity > 0.0 { -image[0] / velocity } else { restitution }
        });
        least.see(margin);
    } => least.margin("adversarial searches for the smallest recoil velocity per impact velocity");
    /// eq:resetLaw: simulated orbits stay in x ≤ 0, arrive with y > 0, and go on from R(y, z).
    // Event times are exact to rounding; phases are of order ten.
    reset_law: drawn(6, 40) |sampler; largest: Deviations| {
        let orbit = Law::random_grazing(sampler)?;
        let at_grazing = orbit.oscillator();
        let [amplitude, frequency] = at_grazing.parameters();
        let oscillator = at_grazing.with_parameters([sampler.between(1.02, 1.5) * amplitude, frequency]);
        let from = State { position: -0.5, velocity: 0.0, phase: sampler.between(0.0, TAU) };
        let horizon = 30.0 * oscillator.forcing_period();
        let mut expected: Option<State> = None;
        // What is released from rest at the wall does not recoil.
        for flight in Orbit::new(&oscillator, from, horizon, 100).take_while(|flight| flight.rest.is_none()) {
            if let Some(State { velocity, phase, .. }) = expected {
                let turns = libm::round((phase - flight.from.phase) / TAU);
                largest.see(flight.from.position.abs());
                largest.see((velocity - flight.from.velocity).abs());
                largest.see((phase - turns * TAU - flight.from.phase).abs());
            }
            // There is no crossing on the way, and the position at the impact is zero.
            let before = flight.duration * (1.0 - 1e-6);
            let early = flight.motion.first_crossing(before).is_some();
            let top = flight.motion.highest_maximum(before).map_or(0.0, |top| top.position.max(0.0));
            largest.see(if early { f64::INFINITY } else { top });
            expected = None;
            if let FlightEnd::Impact(impact) = flight.end {
                largest.require(impact.velocity >= 0.0);
                largest.see(flight.motion.at(flight.duration).position.abs());
                let [restitution, delay] = oscillator.factors(impact.velocity, impact.phase);
                expected = Some(State::on_wall(
                    -impact.velocity * restitution,
                    impact.phase + impact.velocity * delay,
                ));
            }
        }
    } => largest.outcome(1e-13, "properties of the impacts and flights of orbits");
    /// eq:F: the acceleration against second differences of the position along the flow.
    // Slack for the term of fourth order at the smallest resolved steps.
    equation_of_motion: drawn(1, 60) |sampler; least: Smallest| {
        let orbit = Law::random_grazing(sampler)?;
        let oscillator = orbit.oscillator();
        let from = sampler.state();
        let force = oscillator.acceleration(from);
        let x = |time: f64| oscillator.flow::<1>(from, time).value[0];
        least.see_resolved(order(|h| {
            let difference = (x(h) - 2.0 * from.position + x(-h)) / (h * h);
            // Positions of order one, three of them, over h².
            Some((difference - force, 1e-16 / (h * h)))
        }));
    } => least.order(2.0, 0.3, "states of random oscillators; ẍ by second differences of the flow");
}
