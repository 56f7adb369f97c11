//! The names and looks of kinds of curves, for the page: `grazing_results::kinds` as a script.

use std::collections::BTreeMap;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::kinds::{
    Colour, CurveLook, IRREGULAR, LOOPS, MARKER, MARKER_RIM, OWN, OWN_WIDTHS, PERIODIC, PLACE, SEVERAL,
    region_inks,
};
use grazing_results::plane::RegionKind;

use crate::answer::{answers, written};
use crate::diagram::OWN_CURVE;

/// Pixels of the page to a point of a figure.
const SCALE: f64 = 1.5;

fn hex([red, green, blue]: Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

answers! {
    /// The look of a kind of curves: its meaning, its entry in the legend, its place in the order of painting, and its pen.
    ColoursAndStroke {
        meaning: &'static str, legend: String, layer: u8,
        light: Colours, dark: Colours, #[serde(flatten)] stroke: StrokeInPixels,
    }

    /// The colours of a curve and of its approximation, if it has one.
    Colours { curve: String, quadratic: Option<String>, }

    /// Width and dashes of a line, in pixels.
    StrokeInPixels { width: f64, dashes: Vec<f64>, }

    /// The inks on both grounds.
    Grounds { light: Inks, dark: Inks, }

    /// The inks of motions with so many loops, and those of regions, points and other motions by their names.
    Inks { loops: [String; LOOPS.len()], #[serde(flatten)] others: BTreeMap<&'static str, String>, }
}

fn stroke(width: f64, dashes: &[f64]) -> StrokeInPixels {
    // To hundredths.
    let pixels = |length: f64| (100.0 * SCALE * length).round() / 100.0;
    StrokeInPixels { width: pixels(width), dashes: dashes.iter().copied().map(pixels).collect() }
}

/// The inks on light (0) or on dark ground (1).
fn inks(ground: usize) -> Inks {
    let region = |kind| {
        let ([red, green, blue], opacity) = region_inks(kind)[ground];
        format!("rgba({red},{green},{blue},{opacity})")
    };
    let others = [
        ("calm", region(RegionKind::NonImpacting)),
        ("stable", region(RegionKind::Mps)),
        ("area", region(RegionKind::SeveralImpacts)),
        ("hatching", region(RegionKind::Undecided)),
        ("marker", hex(MARKER[ground])),
        ("rim", hex(MARKER_RIM[ground])),
        ("several", hex(SEVERAL[ground])),
        ("periodic", hex(PERIODIC[ground])),
        ("irregular", hex(IRREGULAR[ground])),
        ("place", hex(PLACE[ground])),
    ];
    Inks { loops: LOOPS.map(|colours| hex(colours[ground])), others: others.into() }
}

/// A module of JavaScript with `KINDS`, the names of all kinds of curves, and `LOOKS`, the look of each and of the curves
/// that a file asks for; with `APPROXIMATION` and `DOTTED`, width and dashes of approximations and of curves that bound
/// no region; and with `INKS`.
pub(crate) fn script() -> String {
    let look = |kind: Bifurcation| {
        let look @ CurveLook { meaning, layer, .. } = CurveLook::of(kind);
        let [light, dark] = [0, 1].map(|ground| Colours {
            curve: hex(look.colours[ground]),
            quadratic: Some(hex(look.approximation()[ground])),
        });
        let legend = match kind {
            Bifurcation::NonImpactingGrazing => look.brief.to_owned(),
            _ => format!("{}, {}", kind.name(), look.brief),
        };
        (
            kind.name(),
            ColoursAndStroke { meaning, legend, layer, light, dark, stroke: stroke(look.width, look.dashes) },
        )
    };
    let mut looks: BTreeMap<&str, ColoursAndStroke> = Bifurcation::ALL.into_iter().map(look).collect();
    let layer = looks.values().map(|look| look.layer).max().unwrap_or_default();
    let [light, dark] = OWN.map(|colour| Colours { curve: hex(colour), quadratic: None });
    let (meaning, legend, stroke_of_own) = ("", String::new(), stroke(OWN_WIDTHS[0], &[]));
    looks.insert(OWN_CURVE, ColoursAndStroke { meaning, legend, layer, light, dark, stroke: stroke_of_own });
    let approximation = stroke(CurveLook::APPROXIMATION_WIDTH, CurveLook::APPROXIMATION_DASHES);
    let constants = [
        ("KINDS", written(&Bifurcation::ALL.map(Bifurcation::name))),
        ("LOOKS", written(&looks)),
        ("APPROXIMATION", written(&approximation)),
        ("DOTTED", written(&stroke(CurveLook::DOT, CurveLook::DOTS))),
        ("INKS", written(&Grounds { light: inks(0), dark: inks(1) })),
    ];
    constants.map(|(name, value)| format!("export const {name} = {value};\n")).concat()
}
