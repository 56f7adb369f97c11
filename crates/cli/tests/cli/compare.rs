//! The table of `grazing compare`, and its verdict. The numbers of the table are invented, none is
//! the paper's.

use std::collections::BTreeMap;
use std::fs;

use crate::program::{DEFAULT, edited, grazing, project, repository, snapshots};
use grazing_claims::published::Published;
use grazing_cli::compare::table;
use grazing_cli::layout::Layout;

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
    let plain = table(Layout::default(), &comparisons, false);
    assert!(!plain.contains('\x1b'));
    snapshots().bind(|| insta::assert_snapshot!("table_of_compare", plain));
    let coloured = table(Layout::default(), &comparisons, true);
    assert!(coloured.contains("\x1b[32mmet"), "met is green");
    assert!(coloured.contains("\x1b[1;31mOFF"), "off is red");
}

#[test]
fn every_published_value_is_met_by_the_default_parameters() {
    let outcome = grazing(&repository(), &["compare"]);
    assert_eq!(outcome.code, Some(0), "{}{}", outcome.output, outcome.messages);
    let rows = Published::printed().values.len();
    assert_eq!(
        outcome.output.lines().filter(|line| line.ends_with("  met")).count(),
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

/// The curves of Figure 7 are those of the closed form; here motion is integrated from a text file.
#[test]
fn curves_of_another_program_are_held_against_those_of_an_oscillator() {
    let folder = project("");
    let table = repository().join("figures/data/fig07_curves.csv").display().to_string();
    let whole = fs::read_to_string(repository().join("examples/paper.toml")).expect("it is there");
    let part = edited(&whole, "[primary]", "range", "range = [0.2, 0.7]");
    let part = edited(&part, "[secondary]", "range", "range = [0.6, 0.88]");
    fs::write(folder.path().join("paper.toml"), part).expect("the folder is ours");
    let named = |file| ["compare", file, "--oscillator", "paper.toml", "--column", "A=amplitude"];
    let same = grazing(folder.path(), &[&named(&table)[..], &["--column", "seen=kind"]].concat());
    assert_eq!(same.code, Some(0), "{}{}", same.output, same.messages);
    for curve in ["graz", "SN of p = 2", "PD of p = 3", "GZ of p = 1"] {
        assert!(same.output.contains(curve), "{curve} is missing in {}", same.output);
    }
    // A place beside a curve, with columns of other names.
    let moved = "amplitude,omega\n0.5024,0.7\n";
    fs::write(folder.path().join("moved.csv"), moved).expect("the folder is ours");
    let within = |share| {
        let line = [&named("moved.csv")[..], &["--curve", "GZ:1", "--within", share]].concat();
        grazing(folder.path(), &line)
    };
    let (near, far) = (within("1"), within("1e-9"));
    assert_eq!(near.code, Some(0), "{}{}", near.output, near.messages);
    assert_eq!(far.code, Some(1), "{}{}", far.output, far.messages);
    assert!(far.errors().contains("1 of 1 points lie farther"), "{}", far.messages);
    let none = grazing(folder.path(), &[&named("moved.csv")[..], &["--column", "seen=kind"]].concat());
    assert_eq!(none.code, Some(2), "{}", none.messages);
    assert!(none.errors().contains("it has no column kind, which should hold seen"), "{}", none.messages);
}
