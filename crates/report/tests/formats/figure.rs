//! The fonts of figures.

use crate::sample;

#[test]
fn only_the_fonts_of_the_figures_are_known() {
    let figure = sample();
    let fonts = figure.tree().fontdb();
    let mut families: Vec<String> = fonts.faces().map(|face| face.families[0].0.clone()).collect();
    families.sort();
    assert_eq!(families, ["STIX Two Math", "STIX Two Text", "STIX Two Text"]);
}
