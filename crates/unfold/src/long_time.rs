//! Long-term behaviour of orbits: simulated motion after its transient.
//!
//! Diagrams, places of the plane and phase portraits all follow orbits by [`LongOrbit::follow`].
//! Whether an orbit has settled is decided in one place: it has if Newton's method leads from it to
//! a neighbouring periodic solution ([`Cycle`]) that attracts according to its multipliers, or if the
//! force releases it from rest at the wall at a phase for the second time: all that follows a release
//! depends on its phase alone.

mod cycle;
mod derivative;
mod exponent;
mod orbit;
mod samples;
mod strike;

use core::f64::consts::TAU;

use grazing_model::{AnyOscillator, ImpactOscillator, State};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

pub use cycle::{Cycle, same_impact};
pub use exponent::Exponent;
pub use orbit::{Fate, Horizon, LONGEST_TRANSIENT, LongOrbit, MotionKind, Patience};
pub use samples::{Trajectory, sampled, sampled_solution, time_of_phase};
pub(crate) use samples::{sampled_flight, sampled_rest};
pub use strike::Strike;

/// A random point of Π: x uniform between `lowest` and the wall, or between both stops if there are two;
/// the phase uniform.
pub fn random_start(oscillator: &AnyOscillator, lowest: f64, random: &mut Pcg64) -> State {
    let [share, phase] = [uniform(random), TAU * uniform(random)];
    let [gap, _] = oscillator.gap(phase);
    State::at_rest(lowest.max(-gap.value) * share, phase)
}

/// A number uniform in [0, 1), with 53 random bits.
fn uniform(random: &mut Pcg64) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}
