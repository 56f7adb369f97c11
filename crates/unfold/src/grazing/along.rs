//! What holds along pieces of a grazing curve, in words.

use grazing_model::smooth::Units;
use grazing_results::brief;

use super::{GrazingCurve, GrazingCurvePoint};

/// Where neighbouring motion is forgotten within a period; nothing if that is nowhere.
pub fn forgotten(curve: &GrazingCurve, secondary: &str, units: &Units) -> Option<String> {
    let words = |state: &GrazingCurvePoint| {
        state.is_forgotten().then_some("neighbouring motion is forgotten within a period")
    };
    let places = along_curve(curve, secondary, units, words);
    (!places.is_empty()).then(|| format!("{places}: nothing is resonant there"))
}

/// What words say of the points of a curve, piece by piece; nothing of those without words.
pub fn along_curve(
    curve: &GrazingCurve,
    secondary: &str,
    units: &Units,
    words: impl Fn(&GrazingCurvePoint) -> Option<&'static str>,
) -> String {
    let mut pieces: Vec<(Option<&str>, [f64; 2])> = Vec::new();
    for state in &curve.states {
        let [_, here] = units.parameters(state.parameters());
        let words = words(state);
        match pieces.last_mut() {
            Some((last, to)) if *last == words => to[1] = here,
            _ => pieces.push((words, [here, here])),
        }
    }
    let piece = |(words, ends): &(Option<&str>, [f64; 2])| match pieces.len() {
        1 => words.map(|words| format!("{words} throughout")),
        _ => {
            let [from, to] = ends.map(|end| brief(end, 6));
            words.map(|words| format!("{words} for {secondary} {from} to {to}"))
        }
    };
    pieces.iter().filter_map(piece).collect::<Vec<_>>().join(", ")
}
