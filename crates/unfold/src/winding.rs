//! The integer n of a resonance: the number of oscillations of neighbouring motion about the
//! grazing orbit in a forcing period.
//!
//! For the paper's oscillator n is known from the closed form (Propositions 3.2 and 3.3). For any
//! oscillator the variation (u, u̇) of the motion along the grazing orbit that begins with (0, 1)
//! turns about zero. At a resonance it is, after p periods, at a zero of u: after one period it has
//! made n half-turns (p = 1), or n whole turns plus or minus π/p (p ≥ 2; minus where a₁₂ α < 0).

use core::f64::consts::{PI, TAU};

use grazing_model::motion::Motion;
use grazing_model::{AnyOscillator, ImpactOscillator, State, flow_variable as flow};
use grazing_theorems::from_map::GrazingOrbit;

/// Number of instants of a period at which the variation is evaluated; it must not make half a turn
/// between two.
const SAMPLES: u32 = 256;

/// The integer n of the resonance at a grazing orbit.
pub(crate) fn index(orbit: &GrazingOrbit, loops: u32) -> u32 {
    let angle = angle_in_a_period(orbit.oscillator(), State::on_wall(0.0, orbit.phase()));
    // The conversion to an integer saturates: no turn, or very many.
    libm::round(angle / if loops == 1 { PI } else { TAU }) as u32
}

/// The angle by which the variation of the motion from a state turns in a forcing period, in
/// radians.
pub(crate) fn angle_in_a_period(oscillator: &AnyOscillator, from: State) -> f64 {
    let motion = oscillator.motion(from);
    let period = oscillator.forcing_period();
    // The motion is integrated once, as far as it is needed.
    motion.at(period);
    let angle_at = |sample: u32| {
        let time = period * f64::from(sample) / f64::from(SAMPLES);
        let jet = oscillator.flow_along::<1>(&motion, from, time);
        libm::atan2(jet.jacobian[(0, flow::VELOCITY)], jet.jacobian[(1, flow::VELOCITY)])
    };
    let mut before = angle_at(0);
    (1..=SAMPLES)
        .map(|sample| {
            let after = angle_at(sample);
            let turned = libm::remainder(after - before, TAU);
            before = after;
            turned
        })
        .sum()
}
