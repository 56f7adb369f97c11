//! Listings on terminals of different widths.

use grazing_input::Description;
use grazing_model::smooth::Stop;
use grazing_unfold::progress::Silent;
use grazing_unfold::unfolded::Unfolded;

use super::{oscillator, results};
use crate::layout::Layout;
use crate::unfold::explanation;

/// A rig with units, a one-parameter diagram and a curve of its own.
const RIG: &str = r#"
name = "A rig of which the name is as long as that of some others, and longer than a narrow terminal"
parameters = { zeta = 0.05, kappa = 0.125 }
primary = { name = "A", range = [0.4, 1.2], unit = "m/s^2" }
secondary = { name = "omega", range = [0.6, 0.9], unit = "rad/s" }
units = { length = "m", time = "s" }
motion = { force = "-2*zeta*v - x - kappa*x^3 - 1 + A*cos(omega*t)", frequency = "omega" }
impact = { restitution = "0.8", duration = "0" }
analysis = { loops = [1] }
curves = [{ name = "hard", impact_velocity = 0.5 }]
diagrams = [{ fixed = "omega", at = 0.75 }]
"#;

#[test]
fn no_line_is_wider_than_the_terminal_and_joined_the_lines_are_the_text() {
    let description = Description::parse(RIG, "rig.toml").expect("it is right");
    let unfolded = Unfolded::described(&description, &Silent, &Stop::default(), &|_| ());
    let unfolded = unfolded.expect("there is grazing");
    let listed = |layout| {
        [
            oscillator(layout, &description, "a/rig.toml".as_ref()),
            results(layout, &description, &unfolded),
            explanation::all(layout, &description, &unfolded),
        ]
    };
    let whole = listed(Layout::new(10_000));
    for width in [80, 60] {
        for (text, whole) in listed(Layout::new(width)).iter().zip(&whole) {
            for line in text.lines() {
                assert!(line.chars().count() <= width, "{width}: {line}");
            }
            assert!(text.split_whitespace().eq(whole.split_whitespace()), "{text}");
        }
    }
    let formula = "x'' = -2*zeta*v - x - kappa*x^3 - 1 + A*cos(omega*t)";
    assert!(listed(Layout::new(80))[0].contains(formula), "no formula is broken");
    for head in
        ["omega (rad/s)", "A (m/s^2)", "impact velocity (m/s)", "c (theorem, (m/s^2)/(rad/s)^2)", "x (m)"]
    {
        assert!(whole[1].contains(head), "{head}: {}", whole[1]);
    }
}
