//! Proofs: what is drawn in Figure 7, and what is proved.

use grazing_beyond::proofs::BeyondProofs;

use super::study;

#[test]
fn what_is_drawn_in_figure_7_lies_where_it_is_proved_to_be() {
    let shown = study().shown::<BeyondProofs>().expect("it can be computed");
    assert!(shown.undecided.is_empty(), "{:?}", shown.undecided);
    let count = |object: &str| shown.items.iter().filter(|item| item.object == object).count();
    assert_eq!([count("point"), count("region")], [25, 12]);
    for item in &shown.items {
        // A corner may lie beyond the end of an interval by rounding.
        assert!(item.within + u32::from(item.object != "point") >= item.drawn, "{item:?}");
        assert!(item.object == "point" || item.width <= 1e-6, "{item:?}");
    }
}
