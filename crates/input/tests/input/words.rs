//! Suggestions for misspelt names, and shortened texts.

use grazing_input::{nearest, shortened};

#[test]
fn only_what_can_have_been_meant_is_suggested() {
    let known = ["x", "v", "t", "m", "A", "omega", "kappa", "zeta"];
    for (name, wanted) in [
        ("omga", Some("omega")),
        ("Omega", Some("omega")),
        ("a", Some("A")),
        ("omegaf", Some("omega")),
        ("zeat", Some("zeta")),
        ("w", None),
        ("time", None),
        ("gamma", None),
    ] {
        assert_eq!(nearest(name, &known), wanted, "{name}");
    }
    assert_eq!(nearest("omega", &["x", "m", "zeta"]), None);
    assert_eq!(nearest("cosine", &["sin", "cos"]), Some("cos"));
    assert_eq!(nearest("loop", &["loops", "start"]), Some("loops"));
    assert_eq!(nearest("anything", &[]), None);
    // Names that nobody types are not compared.
    let long = "omega".repeat(200_000);
    assert_eq!((nearest(&long, &["omega"]), nearest("omega", &[&long])), (None, None));
}

#[test]
fn long_texts_are_shortened_and_others_are_not() {
    assert_eq!(shortened("short", 10), "short");
    let long = "ab".repeat(500_000);
    let shown = shortened(&long, 100);
    assert!(shown.len() <= 100 && shown.starts_with("abab") && shown.ends_with("abab"), "{shown}");
    assert!(shortened(&"\u{3b6}".repeat(1000), 40).contains(" ... "));
}
