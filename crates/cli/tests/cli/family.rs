//! `grazing unfold --vary` and `grazing merge`, from end to end.

use std::fs;
use std::path::Path;

use crate::program::{empty_folder, grazing, listing, narrow_duffing, snapshots};
use tempfile::TempDir;

fn folder() -> TempDir {
    let folder = empty_folder();
    fs::write(folder.path().join("my.toml"), narrow_duffing()).expect("the folder is ours");
    folder
}

/// The content of every file of a family.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let content = |name: String| {
        let path = folder.join(&name);
        path.is_file().then(|| (name, fs::read(path).expect("it can be read")))
    };
    listing(folder).into_iter().filter_map(content).collect()
}

/// Two constants: four members.
const VARY: [&str; 4] = ["--vary", "kappa=0.08:0.1:2", "--vary", "zeta=0.02:0.03:2"];

#[test]
fn parts_are_merged_to_the_same_bytes_that_one_run_writes_and_say_what_the_members_are() {
    let folder = folder();
    let run = |more: &[&str]| {
        let arguments = [&["unfold", "my.toml"], &VARY[..], more].concat();
        let made = grazing(folder.path(), &arguments);
        assert_eq!((made.code, made.errors()), (Some(0), ""), "{}", made.messages);
        made.output
    };
    let told = run(&["--jobs", "2"]);
    assert!(told.contains("4 members\n"), "{told}");
    for part in ["1/4", "4/4", "3/4", "2/4"] {
        run(&["--part", part, "--output", "parts"]);
    }
    let names = ["1", "2", "3", "4"].map(|part| format!("parts/parts/{part}-of-4.toml"));
    let merge = |names: &[String], folder: &Path| {
        let arguments = ["merge", "--output", "merged"].into_iter().chain(names.iter().map(String::as_str));
        grazing(folder, &arguments.collect::<Vec<_>>())
    };
    let merged = merge(&names, folder.path());
    assert_eq!((merged.code, merged.messages.as_str()), (Some(0), ""));
    let whole = files(&folder.path().join("families/my"));
    assert!(whole.len() == 7 && whole == files(&folder.path().join("merged")));
    assert!(merged.output.contains("\nCurves of resonances, with the values at their ends\n"));

    // Values, not names of machines or times: a header, and a line for each of four members.
    let members =
        fs::read_to_string(folder.path().join("merged/data/family_members.csv")).expect("it is there");
    assert!(members.starts_with("kappa,zeta,resonances,points,missing\n"), "{members}");
    assert_eq!(members.lines().count(), 5);

    let mut refused = String::new();
    let mut refuse = |what: &str, names: &[String]| {
        let outcome = merge(names, folder.path());
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{what}");
        refused.push_str(&format!("{what}\n{}\n", outcome.messages));
    };
    refuse("two parts missing", &names[1..3]);
    refuse("one twice", &[&names[..], &names[..1]].concat());
    refuse("no part", &["my.toml".to_owned()]);
    let other = ["unfold", "my.toml", "--vary", "kappa=0.1:0.2:4", "--part", "2/4", "--output", "other"];
    assert_eq!(grazing(folder.path(), &other).code, Some(0));
    refuse("a part of another family", &[names[0].clone(), "other/parts/2-of-4.toml".to_owned()]);
    snapshots().bind(|| insta::assert_snapshot!("messages_for_parts_that_do_not_fit", refused));
}

#[test]
fn what_cannot_vary_is_told_before_anything_is_computed() {
    let folder = folder();
    let damped = narrow_duffing().replace("restitution = \"0.9\"", "restitution = \"45*zeta\"");
    fs::write(folder.path().join("my.toml"), damped).expect("the folder is ours");
    let before = listing(folder.path());
    let mut transcript = String::new();
    for vary in [
        "kappa",
        "kappa=1",
        "kappa=0.1:0.2",
        "kappa=0.1:0.2:1",
        "kappa=0.1:x:3",
        "kappa=0.1:inf:3",
        "kappa=0.1:0.1:3",
        "kapa=0.1:0.2:3",
        "omega=0.1:0.2:3",
        "zeta=-1:1:3",
    ] {
        let outcome = grazing(folder.path(), &["unfold", "my.toml", "--vary", vary]);
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{vary}: {}", outcome.messages);
        transcript.push_str(&format!("--vary {vary}\n{}\n", outcome.messages));
    }
    for part in ["0/4", "5/4", "1"] {
        let outcome =
            grazing(folder.path(), &["unfold", "my.toml", "--vary", "zeta=0.1:0.2:4", "--part", part]);
        assert_eq!(outcome.code, Some(2), "{part}");
        transcript.push_str(&format!("--part {part}\n{}\n", outcome.messages));
    }
    assert_eq!(listing(folder.path()), before);
    snapshots().bind(|| insta::assert_snapshot!("messages_for_what_cannot_vary", transcript));
}
