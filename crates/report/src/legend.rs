//! Legends: what colours, widths and markers of a figure mean, as far as its caption does not say it.
//!
//! A figure is drawn in one style, so the pens in its SVG tell what it shows.

use askama::filters::Safe;

use crate::html::Html;

/// What a sample of a legend shows.
enum Sample {
    /// A line with these attributes.
    Line(&'static str),
    /// An area with these attributes.
    Area(&'static str),
    /// Any other drawing, 24 by 10.
    Drawing(&'static str),
}

/// An entry: what stands in the SVG if the figure needs it, its sample, and what that means, as HTML.
type Entry = (&'static str, Sample, &'static str);

/// The pen that only two-parameter diagrams have, and their entries.
const GRAZING: &str = "stroke=\"#78c86e\" stroke-width=\"2.2\"";
const TWO_PARAMETERS: &[Entry] = &[
    (GRAZING, Sample::Line(GRAZING), "grazing of the non-impacting solution"),
    (
        "stroke=\"#1946be\" stroke-width=\"1.15\"",
        Sample::Line("stroke=\"#1946be\" stroke-width=\"1.15\""),
        "saddle-node bifurcation (SN)",
    ),
    (
        "stroke=\"#d62f20\" stroke-width=\"1.15\"",
        Sample::Line("stroke=\"#d62f20\" stroke-width=\"1.15\""),
        "period-doubling bifurcation (PD)",
    ),
    (
        "stroke=\"#005838\" stroke-width=\"1.15\"",
        Sample::Line("stroke=\"#005838\" stroke-width=\"1.15\" stroke-dasharray=\"5 1.2 1.2 1.2\""),
        "grazing of a maximal periodic solution (GZ)",
    ),
    (
        "stroke=\"#0d2668\"",
        Sample::Line("stroke=\"#0d2668\" stroke-width=\"0.9\" stroke-dasharray=\"3.2 2\""),
        "quadratic approximation to SN",
    ),
    (
        "stroke=\"#751911\"",
        Sample::Line("stroke=\"#751911\" stroke-width=\"0.9\" stroke-dasharray=\"3.2 2\""),
        "quadratic approximation to PD",
    ),
    ("fill=\"#e9e9e9\"", Sample::Area("fill=\"#e9e9e9\""), "the non-impacting solution is stable"),
    (
        "fill=\"#282828\" fill-opacity",
        Sample::Area("fill=\"#282828\" fill-opacity=\"0.3\""),
        "a maximal periodic solution is stable; darker where several are",
    ),
    (
        "stroke=\"#6e6e6e\" stroke-width=\"0.45\"/>",
        Sample::Drawing("<path d=\"M2,9l8-8M8,9l8-8M14,9l8-8\" stroke=\"#6e6e6e\" stroke-width=\"0.6\"/>"),
        "stability is not decided",
    ),
    (
        "stroke=\"#000000\" stroke-width=\"1.5\"",
        Sample::Line("stroke=\"#000000\" stroke-width=\"1.5\""),
        "where Figure 2 runs",
    ),
    (
        "stroke=\"#f08200\" stroke-width=\"1\"",
        Sample::Drawing("<rect x=\"5\" y=\"1\" width=\"14\" height=\"8\" stroke=\"#f08200\"/>"),
        "shown larger in the magnifications",
    ),
    (
        "Z\" fill=\"#000000\" stroke=\"#ffffff\"",
        Sample::Drawing("<path d=\"M12,1l4,7h-8Z\" fill=\"#000000\"/>"),
        "resonant grazing",
    ),
    (
        "<circle",
        Sample::Drawing("<circle cx=\"12\" cy=\"5\" r=\"2.6\" fill=\"#000000\"/>"),
        "another codimension-two point",
    ),
];
/// The width that only one-parameter diagrams have, and their entries.
const STABLE: &str = "stroke-width=\"1.7\"";
const ONE_PARAMETER: &[Entry] = &[
    (STABLE, Sample::Line("stroke=\"#000000\" stroke-width=\"1.7\""), "stable"),
    ("stroke-width=\"0.55\"", Sample::Line("stroke=\"#000000\" stroke-width=\"0.55\""), "unstable"),
    (
        "stroke=\"#2d4669\"",
        Sample::Drawing(
            "<path d=\"M4,3h0m5,4h0m3-3h0m5,1h0m3,3h0\" stroke=\"#2d4669\" stroke-width=\"1\" stroke-linecap=\"round\"/>",
        ),
        "long-term forward orbits",
    ),
];
/// The dashes that only the boundaries in the trapesium have, and their entries.
const ADMISSIBLE: &str = "stroke-dasharray=\"2.6 1.3\"";
const BOUNDARIES: &[Entry] = &[
    (ADMISSIBLE, Sample::Line("stroke=\"#000000\" stroke-width=\"1.1\""), "<i>g<sub>p</sub></i>"),
    (
        ADMISSIBLE,
        Sample::Line("stroke=\"#000000\" stroke-width=\"1.1\" stroke-dasharray=\"2.6 1.3\""),
        "<i>h<sub>p</sub></i>",
    ),
];
/// Colours of solutions by their loops, in one-parameter diagrams and among the boundaries.
const LOOPS: &[Entry] = &[
    ("stroke=\"#be5f00\"", Sample::Line("stroke=\"#be5f00\" stroke-width=\"1.7\""), "<i>p</i> = 1"),
    ("stroke=\"#1946be\"", Sample::Line("stroke=\"#1946be\" stroke-width=\"1.7\""), "<i>p</i> = 2"),
    ("stroke=\"#961e6e\"", Sample::Line("stroke=\"#961e6e\" stroke-width=\"1.7\""), "<i>p</i> = 3"),
    ("stroke=\"#007869\"", Sample::Line("stroke=\"#007869\" stroke-width=\"1.7\""), "<i>p</i> = 4"),
    ("stroke=\"#af3c23\"", Sample::Line("stroke=\"#af3c23\" stroke-width=\"1.7\""), "<i>p</i> = 5"),
    ("stroke=\"#5f5f00\"", Sample::Line("stroke=\"#5f5f00\" stroke-width=\"1.7\""), "<i>p</i> = 6"),
];

/// Samples and meanings for the drawing; none for sketches, which say themselves what is what.
pub(crate) fn of(svg: &str) -> Vec<(Html, Html)> {
    let families: [&[Entry]; 2] = if svg.contains(GRAZING) {
        [TWO_PARAMETERS, &[]]
    } else if svg.contains(STABLE) {
        [ONE_PARAMETER, LOOPS]
    } else if svg.contains(ADMISSIBLE) {
        [BOUNDARIES, LOOPS]
    } else {
        [&[], &[]]
    };
    let shown = families.into_iter().flatten().filter(|(mark, ..)| svg.contains(mark));
    shown.map(|(_, sample, meaning)| (drawing(sample), Safe((*meaning).to_owned()))).collect()
}

fn drawing(sample: &Sample) -> Html {
    let content = match sample {
        Sample::Line(attributes) => format!("<path d=\"M0,5h24\" {attributes}/>"),
        Sample::Area(attributes) => format!("<rect y=\"0\" width=\"24\" height=\"10\" {attributes}/>"),
        Sample::Drawing(content) => (*content).to_owned(),
    };
    Safe(format!("<svg viewBox=\"0 0 24 10\" fill=\"none\" aria-hidden=\"true\">{content}</svg>"))
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::*;

    /// What the legend of a figure of the repository says.
    fn legend(name: &str) -> Vec<String> {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../figures/{name}.svg"));
        let svg = fs::read_to_string(file).expect("the figures stand in the repository");
        of(&svg).into_iter().map(|(_, meaning)| meaning.0).collect()
    }

    #[test]
    fn diagrams_have_legends_of_what_they_show_and_sketches_have_none() {
        for sketch in ["fig01", "fig03", "fig06", "fig09", "fig10"] {
            assert!(legend(sketch).is_empty(), "{sketch}");
        }
        let has = |name: &str, words: &str| legend(name).iter().any(|meaning| meaning.contains(words));
        for (name, words, there) in [
            ("fig02", "unstable", true),
            ("fig02", "long-term forward orbits", true),
            ("fig02", "<i>p</i> = 3", true),
            ("fig02", "<i>p</i> = 6", false),
            ("fig04", "<i>h<sub>p</sub></i>", true),
            ("fig04", "<i>p</i> = 6", true),
            ("fig05", "period-doubling bifurcation", true),
            ("fig05", "(GZ)", false),
            ("fig05", "a maximal periodic solution is stable", true),
            ("fig07", "(GZ)", true),
            ("fig07", "where Figure 2 runs", true),
            ("fig07", "quadratic approximation", false),
            ("fig07", "another codimension-two point", true),
            ("fig08", "quadratic approximation to PD", true),
            ("fig08", "the non-impacting solution is stable", true),
            ("fig08", "stability is not decided", false),
        ] {
            assert_eq!(has(name, words), there, "{name}: {words}: {:?}", legend(name));
        }
    }
}
