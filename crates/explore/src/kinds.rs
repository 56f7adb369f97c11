//! How kinds of curves look and what they are called, for the page: `grazing_results::kinds` as a script and a style sheet.

use std::fmt::Write;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::kinds::{CURVES, Colour, CurveLook};
use serde_json::{Map, Value, json};

/// Pixels of the page to a point of a figure.
const SCALE: f64 = 1.5;

fn hex([red, green, blue]: Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn pixels(lengths: &[f64]) -> Vec<f64> {
    // To hundredths.
    lengths.iter().map(|length| (100.0 * SCALE * length).round() / 100.0).collect()
}

fn width(width: f64) -> f64 {
    pixels(&[width])[0]
}

/// A module of JavaScript with `LOOKS`: for each kind of curve its meaning, the colours on light and on dark ground of the curve and of its
/// approximation, width and dashes; and with `APPROXIMATION`, width and dashes of approximations.
pub(crate) fn script() -> String {
    let look = |kind: Bifurcation| {
        let look = CurveLook::of(kind);
        let [[light, dark], [light_quadratic, dark_quadratic]] =
            [look.colours, look.approximation()].map(|colours| colours.map(hex));
        let value = json!({
            "meaning": look.meaning,
            "light": { "curve": light, "quadratic": light_quadratic },
            "dark": { "curve": dark, "quadratic": dark_quadratic },
            "width": width(look.width),
            "dashes": pixels(look.dashes),
        });
        (kind.name().to_owned(), value)
    };
    let looks: Map<String, Value> = CURVES.into_iter().map(look).collect();
    let approximation = json!({
        "width": width(CurveLook::APPROXIMATION_WIDTH),
        "dashes": pixels(CurveLook::APPROXIMATION_DASHES),
    });
    format!("export const LOOKS = {};\nexport const APPROXIMATION = {approximation};\n", Value::Object(looks))
}

/// A style sheet with a class for each kind of curve, and `quadratic` for approximations, as the legend shows them.
pub(crate) fn style_sheet() -> String {
    let mut text = String::new();
    let mut rule = |class: &str, colours: [Colour; 2], stroke: f64, dashes: &[f64]| {
        let [light, dark] = colours.map(hex);
        let dashes = pixels(dashes).iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
        let dashes = if dashes.is_empty() { "none".to_owned() } else { dashes };
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            ".legend .{class} {{ stroke: light-dark({light}, {dark}); stroke-width: {}; stroke-dasharray: {dashes}; }}",
            width(stroke)
        );
    };
    for kind in CURVES {
        let look = CurveLook::of(kind);
        rule(kind.name(), look.colours, look.width, look.dashes);
    }
    let colours = CurveLook::of(Bifurcation::SaddleNode).approximation();
    rule("quadratic", colours, CurveLook::APPROXIMATION_WIDTH, CurveLook::APPROXIMATION_DASHES);
    text
}
