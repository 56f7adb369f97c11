//! Legends: a figure tells in its SVG what its lines, shades and marks mean.

use askama::filters::Safe;

use crate::figure::unescaped;
use crate::formula::prose;
use crate::html::Html;

/// The legend that a drawing holds, if it holds one, and the drawing without it.
pub(crate) fn cut_out(svg: &str) -> (&str, String) {
    let split = svg.split_once("<defs class=\"legend\">");
    let Some((before, (legend, after))) =
        split.and_then(|(before, rest)| Some((before, rest.split_once("</defs>")?)))
    else {
        return ("", svg.to_owned());
    };
    (legend, format!("{before}{after}"))
}

/// Samples and meanings.
pub(crate) fn entries(legend: &str) -> Vec<(Html, Html)> {
    let entries = legend
        .split("</g>")
        .filter_map(|entry| entry.trim_start().strip_prefix("<g aria-label=\"")?.split_once("\">"));
    let shown = |(meaning, sample): (&str, &str)| {
        let sample = format!("<svg viewBox=\"0 0 24 10\" fill=\"none\" aria-hidden=\"true\">{sample}</svg>");
        (Safe(sample), prose(&unescaped(meaning)))
    };
    entries.map(shown).collect()
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::*;

    #[test]
    fn diagrams_have_legends_of_what_they_show_and_sketches_have_none() {
        let legend = |name: &str| -> Vec<String> {
            let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../figures/{name}.svg"));
            let svg = fs::read_to_string(file).expect("the figures stand in the repository");
            entries(cut_out(&svg).0).into_iter().map(|(_, meaning)| meaning.0).collect()
        };
        for sketch in ["fig01", "fig03", "fig06", "fig09", "fig10"] {
            assert!(legend(sketch).is_empty(), "{sketch}");
        }
        for (name, words, there) in [
            ("fig02", "unstable", true),
            ("fig02", "long-time behaviour", true),
            ("fig02", "<mn>3</mn>", true),
            ("fig02", "<mn>6</mn>", false),
            ("fig04", "<mi>h</mi>", true),
            ("fig04", "<mn>6</mn>", true),
            ("fig05", "period-doubling bifurcation", true),
            ("fig05", "(GZ)", false),
            ("fig05", "a maximal periodic solution is stable", true),
            ("fig07", "(GZ)", true),
            ("fig07", "where a one-parameter diagram runs", true),
            ("fig07", "quadratic approximation", false),
            ("fig07", "another codimension-two point", true),
            ("fig08", "quadratic approximation to PD", true),
            ("fig08", "the non-impacting solution is stable", true),
            ("fig08", "stability is not decided", false),
        ] {
            let found = legend(name).iter().any(|meaning| meaning.contains(words));
            assert_eq!(found, there, "{name}: {words}: {:?}", legend(name));
        }
    }

    #[test]
    fn a_drawing_without_a_legend_stays_whole() {
        assert_eq!(cut_out("<defs/><path/>"), ("", "<defs/><path/>".to_owned()));
    }
}
