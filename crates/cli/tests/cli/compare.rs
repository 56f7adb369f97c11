//! The table of `grazing compare`, and its verdict. The numbers of the table are invented, none is
//! the paper's.

use std::collections::BTreeMap;

use crate::program::{DEFAULT, edited, grazing, project, repository, snapshots};
use grazing_claims::published::Published;
use grazing_cli::compare::table;

fn invented() -> Published {
    let mut text = String::new();
    for (id, value, rounding) in [
        ("chosen", "0.7", "exact"),
        ("met", "-1234.5", "significant"),
        ("off", "9.99", "significant"),
        ("none", "1", "significant"),
    ] {
        text.push_str(&format!(
            "[[value]]\nid = \"{id}\"\nquantity = \"quantity {id}\"\nlabel = \"eq:{id}\"\nwhere = \"section 9\"\n\
             value = \"{value}\"\nrounding = \"{rounding}\"\n"
        ));
    }
    toml::from_str(&text).expect("a valid list")
}

#[test]
fn the_table_is_aligned_and_tells_every_verdict() {
    let published = invented();
    let computed =
        [("chosen", 0.7), ("met", -1234.51), ("off", 10.0)].map(|(id, value)| (id.to_owned(), value));
    let comparisons = published.compare(&BTreeMap::from(computed));
    let plain = table(&comparisons, false);
    assert!(!plain.contains('\x1b'));
    snapshots().bind(|| insta::assert_snapshot!("table_of_compare", plain));
    let coloured = table(&comparisons, true);
    assert!(coloured.contains("\x1b[32mmet"), "met is green");
    assert!(coloured.contains("\x1b[1;31mOFF"), "off is red");
}

#[test]
fn every_published_value_is_met_by_the_default_parameters() {
    let outcome = grazing(&repository(), &["compare"]);
    assert_eq!(outcome.code, Some(0), "{}{}", outcome.output, outcome.messages);
    let rows = Published::printed().values.len();
    assert_eq!(
        outcome.output.lines().filter(|line| line.contains("  met  ")).count(),
        rows,
        "{}",
        outcome.output
    );
    assert!(!outcome.output.contains('\x1b'), "no colour but on a terminal");
}

#[test]
fn another_damping_ratio_misses_the_print_and_fails() {
    let folder = project(&edited(DEFAULT, "[oscillator]", "zeta", "zeta = 0.03"));
    let outcome = grazing(folder.path(), &["compare"]);
    assert_eq!(outcome.code, Some(1), "{}", outcome.messages);
    assert!(outcome.output.contains("OFF"), "{}", outcome.output);
    assert!(
        outcome.messages.contains(" computed published values are met, and 2 of 3 that are parameters"),
        "{}",
        outcome.messages
    );
}
