//! Oscillators to test with.

use grazing_input::Description;
use grazing_model::{AnyOscillator, LinearOscillator};

/// The linear oscillator with damping ratio ζ, ε = 0.9 and (𝒜, ω).
pub(crate) fn linear(zeta: f64, [amplitude, frequency]: [f64; 2]) -> AnyOscillator {
    let linear = LinearOscillator::new(zeta, 0.9, amplitude, frequency);
    AnyOscillator::new(linear.expect("it is in the domain"))
}

/// An elastic impact oscillator with this force and μ cos ηt, which vanishes at (0, 1).
pub(crate) fn unforced(force: &str) -> Description {
    forced(force, 1.0)
}

/// An impact oscillator with this force, μ cos ηt and a coefficient of restitution.
pub(crate) fn forced(force: &str, restitution: f64) -> Description {
    let text = format!(
        "name = \"Test\"\n[parameters]\n[primary]\nname = \"mu\"\nrange = [0, 1]\n[secondary]\nname = \"eta\"\n\
         range = [0.5, 1]\n[motion]\nforce = \"{force} + mu*cos(eta*t)\"\nfrequency = \"eta\"\n[impact]\nrestitution = \"{restitution}\"\n\
         duration = \"0\"\n[analysis]\nloops = [1]\n"
    );
    Description::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{error}"))
}
