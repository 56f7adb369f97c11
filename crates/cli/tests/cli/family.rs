//! `grazing unfold --vary` and `grazing merge`, from end to end.

use std::fs;
use std::path::Path;

use crate::program::{digest, empty_folder, grazing, listing, narrow_duffing, narrow_linear, snapshots};
use tempfile::TempDir;

fn folder() -> TempDir {
    let folder = empty_folder();
    fs::write(folder.path().join("my.toml"), narrow_linear()).expect("the folder is ours");
    folder
}

/// The content of every file of a family or a map.
pub(crate) fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let content = |name: String| {
        let path = folder.join(&name);
        path.is_file().then(|| (name, fs::read(path).expect("it can be read")))
    };
    listing(folder).into_iter().filter_map(content).collect()
}

/// A part with another text after the digest of that text, as anybody might write it.
pub(crate) fn forged(text: &str) -> String {
    format!("sha256 = \"{}\"\n{text}", digest(text.as_bytes()))
}

/// The text of a part after its digest.
pub(crate) fn behind_digest(part: &str) -> &str {
    part.split_once('\n').expect("it has lines").1
}

/// The options for two constants that vary: four members.
pub(crate) const VARY: [&str; 4] = ["--vary", "kappa=0.08:0.1:2", "--vary", "zeta=0.02:0.03:2"];

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
    assert!(whole.len() == 8 && whole == files(&folder.path().join("merged")));
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

    // Parts from an untrusted source.
    let part = fs::read_to_string(folder.path().join(&names[0])).expect("it was written");
    let forge = |name: &str, from: &str, to: &str| {
        let text = behind_digest(&part).replacen(from, to, 1);
        assert!(text != behind_digest(&part), "{from} stands in a part");
        fs::write(folder.path().join(name), forged(&text)).expect("the folder is ours");
        vec![name.to_owned()]
    };
    fs::write(folder.path().join("a.toml"), part.replacen("0.08", "0.09", 1)).expect("the folder is ours");
    refuse("a changed number", &["a.toml".to_owned()]);
    refuse("as many parts as memory has bytes", &forge("b.toml", "\"1/4\"", "\"1/3000000000\""));
    let four = "vary = [\"a=0:1:2\", \"b=0:1:2\", ";
    refuse("a constant that is not there", &forge("c.toml", "\"zeta=", "\"zeat="));
    let text = "\n[parameters]\na = 0.0\nb = 0.0\n";
    let text = part.replacen("vary = [", four, 1).replacen("\n[parameters]\n", text, 1);
    fs::write(folder.path().join("d.toml"), forged(behind_digest(&text))).expect("the folder is ours");
    refuse("four constants", &["d.toml".to_owned()]);
    refuse("a member that is not there", &forge("e.toml", "index = 0", "index = 4294967296"));
    let program = behind_digest(&part).split('"').nth(1).expect("it says which program made it");
    refuse("another program", &forge("f.toml", program, "another program"));
    refuse("a value of another member", &forge("g.toml", "varied = [nan, 0.08, ", "varied = [nan, 0.1, "));
    let refused = refused.replace(program, "PROGRAM");
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
    for part in ["0/4", "5/4", "1", "1/5", "1/3000000000"] {
        let outcome =
            grazing(folder.path(), &["unfold", "my.toml", "--vary", "zeta=0.1:0.2:4", "--part", part]);
        assert_eq!(outcome.code, Some(2), "{part}");
        transcript.push_str(&format!("--part {part}\n{}\n", outcome.messages));
    }
    assert_eq!(listing(folder.path()), before);
    snapshots().bind(|| insta::assert_snapshot!("messages_for_what_cannot_vary", transcript));
}

/// Whether every line of the list of files has the digest of its file.
pub(crate) fn is_of_one_run(folder: &Path) -> bool {
    let list = fs::read_to_string(folder.join("manifest.sha256")).expect("it was written");
    let lines = list.lines().filter(|line| !line.starts_with('#'));
    let mut files = lines.map(|line| line.split_once("  ").expect("digest and path"));
    files.all(|(sha256, path)| fs::read(folder.join(path)).is_ok_and(|content| digest(&content) == sha256))
}

#[test]
fn a_family_that_is_cut_off_replaces_no_results_and_files_of_another_run_are_told() {
    let folder = folder();
    let results = folder.path().join("families/my");
    let run = |more: &[&str]| {
        let line = [&["unfold", "my.toml", "--jobs", "1", "--vary", "kappa=0.08:0.1:2"], more].concat();
        grazing(folder.path(), &line)
    };
    assert_eq!(run(&["--step-limit", "1000"]).code, Some(3));
    assert!(!results.exists(), "of no member nothing is written");
    assert_eq!(run(&[]).code, Some(0));
    let whole = files(&results);
    assert!(is_of_one_run(&results));
    // A number of steps at which one member of two is finished.
    let mut limit = 2_000.0;
    let cut = loop {
        limit *= 1.3;
        let cut = run(&["--step-limit", &format!("{limit}")]);
        assert_eq!(cut.code, Some(3), "{}", cut.messages);
        if results.join("unfinished").exists() {
            break cut;
        }
    };
    assert!(cut.errors().contains("1 of 2 members are missing; the others are written"), "{}", cut.messages);
    let told = "families/my: the results there are kept; the finished part of this run goes to families/my/unfinished\n";
    assert!(cut.messages.contains(told), "{}", cut.messages);
    let members =
        fs::read_to_string(results.join("unfinished/data/family_members.csv")).expect("it is there");
    assert_eq!(members.lines().count(), 2, "a header and a member");
    assert!(is_of_one_run(&results) && is_of_one_run(&results.join("unfinished")));
    fs::remove_dir_all(results.join("unfinished")).expect("the folder is ours");
    assert!(files(&results) == whole);

    // Results that were cut off are replaced by later ones, and files of another run are reported.
    assert_eq!(run(&["--output", "new", "--step-limit", &format!("{limit}")]).code, Some(3));
    let again = run(&["--output", "new"]);
    assert_eq!(
        (again.code, again.messages.contains("manifest.sha256")),
        (Some(0), false),
        "{}",
        again.messages
    );
    assert!(files(&folder.path().join("new")) == whole);
    fs::write(results.join("data/family_points.csv"), "of another run").expect("the folder is ours");
    assert!(!is_of_one_run(&results));
    let again = run(&[]);
    assert_eq!(again.code, Some(0), "{}", again.messages);
    let told = "families/my: 1 of 7 files differed from those that manifest.sha256 lists: ";
    assert!(again.messages.contains(told), "{}", again.messages);
    assert!(files(&results) == whole);
}
