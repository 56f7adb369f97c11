//! Oscillators to test with.

use grazing_description::Description;

/// An elastic impact oscillator with a force that depends on neither parameter.
pub(crate) fn unforced(force: &str) -> Description {
    let text = format!(
        "name = \"Test\"\n[parameters]\n[primary]\nname = \"mu\"\nrange = [0, 1]\n[secondary]\nname = \"eta\"\n\
         range = [0.5, 1]\n[motion]\nforce = \"{force}\"\nfrequency = \"1\"\n[impact]\nrestitution = \"1\"\n\
         duration = \"0\"\n[analysis]\nloops = [1]\n"
    );
    Description::parse(&text, "test.toml").unwrap_or_else(|error| panic!("{error}"))
}
