//! The JSON schema accepts every description that is read, and refuses those whose structure is wrong.

mod validator;
mod variants;

use std::fs;

use grazing_input::{Description, DescriptionError, SourceError};
use toml::Table;

use self::validator::refusal;
use self::variants::variants;
use crate::examples::files;
use crate::messages::{EDITS, edited};

/// Edits that are refused for their meaning: one key with another, the order of two numbers, the characters of a text.
const OF_MEANING: &[(&str, &str)] = &[
    ("name", "name = \" \""),
    // It may stand in [[walls]].
    ("duration", ""),
    ("range", "range = [1.5, 0.0]"),
    ("range", "range = [1.5, 1.5]"),
    ("range", "range = [0.0, 1.5]\nunit = \"\""),
    ("[impact]", "[units]\nlength = \"<b>mm</b>\"\n[impact]"),
    ("range", "range = [-1e308, 1e308]"),
    ("loops", "loops = [1]\n[[diagrams]]\nfixed = \"zeta\"\nat = 0.5"),
    ("loops", "loops = [1]\n[[diagrams]]\nfixed = \"omega\"\nat = 1.2"),
    ("loops", "loops = [1]\n[[diagrams]]\nfixed = \"omega\"\nat = 0.5\nrange = [0.5, 1.6]"),
    ("loops", "loops = [1]\n[[diagrams]]\nfixed = \"A\"\nat = 0.5\nrange = [0.8, 0.6]"),
    ("loops", "loops = [1]\n[[diagrams]]\nfixed = \"A\"\nat = 0.5\nportraits = [0.3]"),
    ("loops", "loops = [1]\n[[diagrams]]\nfixed = \"A\"\nat = 0.5\nportraits = [0.5, 0.5]"),
    ("loops", "loops = [1]\n[[diagrams]]\nfixed = \"A\"\nat = 0.5\nordinate = \"power\""),
    ("duration", "duration = \"0\"\nmass = \"A - 1\""),
    ("loops", "loops = [1]\n[[curves]]\nname = \"fast\""),
    ("loops", "loops = [1]\n[[curves]]\nname = \"fast\"\nmodulus = 0.9\nimpact_velocity = 0.1"),
    ("loops", "loops = [1]\n[[curves]]\nname = \"far\"\ndistance = 0.1"),
    ("loops", "loops = [1]\n[[curves]]\nname = \"far\"\nmodulus = 0.1\nphase = 0.5"),
    ("loops", "loops = [1]\n[[curves]]\nname = \"$far$\"\nmodulus = 0.9"),
    ("loops", "loops = [1]\n[[curves]]\nname = \"far\"\nmodulus = 0.9\nloops = [2]"),
    (
        "loops",
        "loops = [1]\n[[curves]]\nname = \"a\"\nmodulus = 0.9\n[[curves]]\nname = \"a\"\nmodulus = 0.8",
    ),
    // Names.
    ("zeta", "zeta = 0.1\nx = 1"),
    ("zeta", "zeta = 0.1\nt = 1"),
    ("zeta", "zeta = 0.1\nv = 1"),
    ("zeta", "zeta = 0.1\ny = 1"),
    ("zeta", "zeta = 0.1\nz = 1"),
    ("zeta", "zeta = 0.1\npi = 3"),
    ("zeta", "zeta = 0.1\ne = 3"),
    ("zeta", "zeta = 0.1\nsin = 3"),
    ("zeta", "zeta = 0.1\nomega = 3"),
    ("zeta", "zeta = 0.1\n\"ζ\" = 3"),
    ("name", "name = \"A\""),
    ("name", "name = \"forcing frequency\""),
    // Neither parameter may be without use.
    ("force", "force = \"-2*zeta*v - x - 1 + cos(omega*t)\""),
    ("loops", "loops = [1]\n[figure.colours]\nSN = \"blue\""),
];

fn schema() -> Table {
    Description::requirements().schema("An oscillator")
}

fn examples() -> Vec<Table> {
    let read = |path| fs::read_to_string(path).expect("an example is text").parse().expect("it is TOML");
    files().into_iter().map(read).collect()
}

#[test]
fn every_example_has_the_structure_of_the_schema() {
    let schema = schema();
    for example in examples() {
        assert_eq!(refusal(&schema, &example.clone().into()), None, "{}", example["name"]);
    }
}

#[test]
fn what_is_refused_for_its_structure_is_refused_by_the_schema() {
    let schema = schema();
    let mut of_meaning = Vec::new();
    for (table, key, line) in EDITS {
        let text = edited(table, key, line);
        let error = Description::parse(&text, "invented.toml").expect_err("it is wrong");
        let DescriptionError::Source(error) = error else { continue };
        if matches!(error, SourceError::Syntax { .. }) {
            continue;
        }
        let written: Table = text.parse().expect("it is TOML");
        match refusal(&schema, &written.into()) {
            Some(_) => {}
            None if matches!(error, SourceError::UnknownKey { .. }) => panic!("{error}"),
            None => of_meaning.push((*key, *line)),
        }
    }
    assert_eq!(of_meaning, OF_MEANING);
}

#[test]
fn what_the_schema_refuses_is_not_read() {
    let schema = schema();
    let mut refused = 0;
    for example in examples() {
        for (path, variant) in variants(&example) {
            let Some(reason) = refusal(&schema, &variant.clone().into()) else { continue };
            let text = toml::to_string(&variant).expect("it is a table");
            assert!(Description::parse(&text, "o.toml").is_err(), "{}: {path}: {reason}", example["name"]);
            refused += 1;
        }
    }
    assert!(refused > 1000, "{refused}");
}
