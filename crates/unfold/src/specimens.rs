//! Oscillators to test with.

use grazing_description::Description;

/// An elastic impact oscillator with this force and μ cos ηt, which vanishes at (0, 1).
pub(crate) fn unforced(force: &str) -> Description {
    let text = format!(
        "name = \"Test\"\n[parameters]\n[primary]\nname = \"mu\"\nrange = [0, 1]\n[secondary]\nname = \"eta\"\n\
         range = [0.5, 1]\n[motion]\nforce = \"{force} + mu*cos(eta*t)\"\nfrequency = \"eta\"\n[impact]\nrestitution = \"1\"\n\
         duration = \"0\"\n[analysis]\nloops = [1]\n"
    );
    Description::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{error}"))
}
