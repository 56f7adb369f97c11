//! The names and looks of kinds of curves, for the page: `grazing_results::kinds` as a script.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::kinds::{
    Colour, CurveLook, IRREGULAR, LOOPS, MARKER, MARKER_RIM, OWN, OWN_WIDTHS, PERIODIC, PLACE, SEVERAL,
    region_inks,
};
use grazing_results::plane::RegionKind;
use serde_json::{Map, Value, json};

use crate::diagram::OWN_CURVE;

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

/// The inks of regions, points and motions on light (0) or on dark ground (1).
fn inks(ground: usize) -> Value {
    let region = |kind| {
        let ([red, green, blue], opacity) = region_inks(kind)[ground];
        format!("rgba({red},{green},{blue},{opacity})")
    };
    json!({
        "calm": region(RegionKind::NonImpacting),
        "stable": region(RegionKind::Mps),
        "area": region(RegionKind::SeveralImpacts),
        "hatching": region(RegionKind::Undecided),
        "marker": hex(MARKER[ground]),
        "rim": hex(MARKER_RIM[ground]),
        "loops": LOOPS.map(|colours| hex(colours[ground])),
        "several": hex(SEVERAL[ground]),
        "periodic": hex(PERIODIC[ground]),
        "irregular": hex(IRREGULAR[ground]),
        "place": hex(PLACE[ground]),
    })
}

/// A module of JavaScript with `KINDS`, the names of all kinds of curves, and `LOOKS`: for each its meaning, its entry in the legend, its
/// place in the order of painting, the colours on light
/// and on dark ground of the curve and of its approximation, width and dashes; with `APPROXIMATION`
/// and `DOTTED`, width and dashes of approximations and of curves that bound no region; and with
/// `INKS`.
pub(crate) fn script() -> String {
    let look = |kind: Bifurcation| {
        let look = CurveLook::of(kind);
        let [[light, dark], [light_quadratic, dark_quadratic]] =
            [look.colours, look.approximation()].map(|colours| colours.map(hex));
        let legend = match kind {
            Bifurcation::NonImpactingGrazing => look.brief.to_owned(),
            _ => format!("{}, {}", kind.name(), look.brief),
        };
        let value = json!({
            "meaning": look.meaning,
            "legend": legend,
            "layer": look.layer,
            "light": { "curve": light, "quadratic": light_quadratic },
            "dark": { "curve": dark, "quadratic": dark_quadratic },
            "width": width(look.width),
            "dashes": pixels(look.dashes),
        });
        (kind.name().to_owned(), value)
    };
    let mut looks: Map<String, Value> = Bifurcation::ALL.into_iter().map(look).collect();
    let [light, dark] = OWN.map(|colour| json!({ "curve": hex(colour) }));
    let top = Bifurcation::ALL.into_iter().map(|kind| CurveLook::of(kind).layer).max();
    let own = json!({ "meaning": "", "layer": top, "light": light, "dark": dark, "width": width(OWN_WIDTHS[0]), "dashes": [] });
    looks.insert(OWN_CURVE.to_owned(), own);
    let approximation = json!({
        "width": width(CurveLook::APPROXIMATION_WIDTH),
        "dashes": pixels(CurveLook::APPROXIMATION_DASHES),
    });
    let dotted = json!({"width": width(CurveLook::DOT), "dashes": pixels(CurveLook::DOTS)});
    let inks = json!({"light": inks(0), "dark": inks(1)});
    format!(
        "export const KINDS = {};\nexport const LOOKS = {};\nexport const APPROXIMATION = {approximation};\nexport const DOTTED = {dotted};\nexport const INKS = {inks};\n",
        json!(Bifurcation::ALL.map(Bifurcation::name)),
        Value::Object(looks)
    )
}
