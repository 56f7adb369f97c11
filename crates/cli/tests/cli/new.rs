//! `grazing new` writes files that can be unfolded as they are.

use std::fs;

use crate::program::{empty_folder, grazing, listing};
use grazing_cli::examples::{StarterFile, kinds};
use grazing_input::{Description, WallSide};

fn kind(name: &str) -> StarterFile {
    kinds().find(|kind| kind.name == name).expect("there is one")
}

/// Asserts that a file of this kind has a comment for every table, and has resonances as it is.
fn assert_begins(name: &str) {
    let folder = empty_folder();
    let made = grazing(folder.path(), &["new", "my.toml", "--kind", name]);
    assert_eq!((made.code, made.messages.as_str()), (Some(0), ""), "{name}");
    assert!(made.output.contains("\nNext: edit it, then cargo xtask unfold my.toml\n"), "{}", made.output);
    let text = fs::read_to_string(folder.path().join("my.toml")).expect("it was written");
    let description = Description::parse(&text, "my.toml").unwrap_or_else(|error| panic!("{name}: {error}"));
    assert!(description.notes().is_empty(), "{name}: {:?}", description.notes());
    for (number, line) in text.lines().enumerate().filter(|(_, line)| line.starts_with('[')) {
        let before = text.lines().nth(number - 1).expect("the file begins with a comment");
        assert!(before.starts_with("# "), "{name}: {line}");
    }
    let unfolded = grazing(folder.path(), &["unfold", "my.toml", "--loops", "1"]);
    assert_eq!(unfolded.code, Some(0), "{name}: {}", unfolded.messages);
    for wanted in ["\nGrazing of the non-impacting motion\n", "; Theorem 2.4 (p = 1)"] {
        assert!(unfolded.output.contains(wanted), "{name}: {}", unfolded.output);
    }
    for trouble in ["hatched", "unexpectedly", "\nWindow\n", "could not be"] {
        assert!(!unfolded.output.contains(trouble), "{name}: {}", unfolded.output);
    }
}

#[test]
fn the_plain_kind_can_be_unfolded() {
    assert_begins("plain");
}

#[test]
fn the_kind_with_a_moving_wall_can_be_unfolded() {
    assert_begins("moving-wall");
    let description =
        Description::parse(&kind("moving-wall").text("grazing"), "my.toml").expect("it is right");
    assert_eq!(description.wall().side(), WallSide::Above);
    assert_eq!(description.texts().wall, "a*cos(omega*t)");
}

#[test]
fn the_kind_in_si_units_can_be_unfolded() {
    assert_begins("si");
}

#[test]
fn every_kind_is_tried_or_an_example() {
    let plain = kinds().filter(|kind| {
        Description::parse(&kind.text("grazing"), "my.toml").expect("it is right").name().starts_with("My ")
    });
    assert_eq!(plain.map(|kind| kind.name).collect::<Vec<_>>(), ["plain", "moving-wall", "si"]);
    let folder = empty_folder();
    assert_eq!(grazing(folder.path(), &["new", "my.toml", "--kind", "duffing"]).code, Some(0));
    let text = fs::read_to_string(folder.path().join("my.toml")).expect("it was written");
    assert_eq!(text, include_str!("../../../../examples/duffing.toml"));
    let name = |kind: &StarterFile| {
        Description::parse(&kind.text("grazing"), "my.toml").expect("it is right").name().to_owned()
    };
    assert!(kinds().skip(3).all(|kind| kind.about == name(&kind)));
}

#[test]
fn plain_is_what_is_written_if_no_kind_is_asked_for() {
    let folder = empty_folder();
    assert_eq!(grazing(folder.path(), &["new", "my.toml"]).code, Some(0));
    let text = fs::read_to_string(folder.path().join("my.toml")).expect("it was written");
    assert_eq!(text, kind("plain").text("cargo xtask"));
}

#[test]
fn an_installed_program_writes_commands_that_it_knows_and_pages_describe_the_oscillator() {
    for name in ["plain", "moving-wall", "si"] {
        let folder = empty_folder();
        let run = std::process::Command::new(env!("CARGO_BIN_EXE_grazing"))
            .args(["new", "my.toml", "--kind", name])
            .current_dir(folder.path())
            .env_remove("GRAZING_BY_XTASK")
            .output()
            .expect("the program can be started");
        let told = String::from_utf8_lossy(&run.stdout).into_owned();
        let text = fs::read_to_string(folder.path().join("my.toml")).expect("it was written");
        for text in [&text, &told] {
            assert!(text.contains("grazing unfold ") && !text.contains("cargo"), "{name}: {text}");
        }
        // What pages say of the oscillator is the comment before the first line without one.
        let about: Vec<&str> = text.lines().take_while(|line| line.starts_with('#')).collect();
        let about = about.join(" ");
        assert!(about.contains("mass") || about.contains("block"), "{name}: {about}");
        for instruction in ["THIS-FILE", "Change", "change", "your", "mistakes", "docs/"] {
            assert!(!about.contains(instruction), "{name}: {about}");
        }
    }
}

#[test]
fn what_is_there_is_not_replaced() {
    let folder = empty_folder();
    fs::write(folder.path().join("my.toml"), "mine").expect("the folder is ours");
    for (file, reason) in [
        ("my.toml", "my.toml: already exists and is not replaced: move it away or choose another file"),
        (".", ".: already exists"),
        ("below/my.toml", "below/my.toml: cannot be written: its folder does not exist"),
        ("my.toml/my.toml", "my.toml/my.toml: cannot be written"),
    ] {
        let outcome = grazing(folder.path(), &["new", file]);
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{file}");
        assert!(outcome.messages.starts_with(&format!("error: {reason}")), "{}", outcome.messages);
        assert_eq!(outcome.messages.trim_end().lines().count(), 1, "{}", outcome.messages);
    }
    assert_eq!(fs::read_to_string(folder.path().join("my.toml")).expect("it is there"), "mine");
    assert_eq!(listing(folder.path()), ["my.toml"]);
}
