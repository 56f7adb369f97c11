//! `grazing attractors`, from end to end.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::family::{VARY, behind_digest, files, forged, is_of_one_run};
use crate::program::{DEFAULT, grazing, listing, narrow_linear, project, snapshots};

const SIZE: [&str; 3] = ["attractors", "--size", "23x14"];

fn run(folder: &Path, more: &[&str]) -> String {
    let made = grazing(folder, &[&SIZE, more].concat());
    assert_eq!((made.code, made.errors()), (Some(0), ""), "{}", made.messages);
    made.output
}

#[test]
fn parts_of_a_map_are_merged_to_the_same_bytes_that_one_run_writes_and_those_of_others_are_refused() {
    let project = project(DEFAULT);
    let folder = project.path();
    let told = run(folder, &["--jobs", "2"]);
    assert!(told.contains("  p  in regions  settled  unseen  unexplained\n"), "{told}");
    let whole = files(&folder.join("attractors"));
    assert!(whole.len() == 6 && is_of_one_run(&folder.join("attractors")), "{}", whole.len());
    let merge = |names: &[String], to: &str| {
        let arguments = ["merge", "--output", to].into_iter().chain(names.iter().map(String::as_str));
        grazing(folder, &arguments.collect::<Vec<_>>())
    };
    let mut first = Vec::new();
    for count in [1, 3, 14] {
        for part in (1..=count).rev() {
            run(folder, &["--jobs", "1", "--part", &format!("{part}/{count}"), "--output", "out"]);
        }
        let digits = count.to_string().len();
        let name = |part| format!("out/parts/{part:0digits$}-of-{count}.toml");
        let names: Vec<String> = (1..=count).map(name).collect();
        let merged = merge(&names, "merged");
        assert_eq!((merged.code, merged.errors()), (Some(0), ""), "{}", merged.messages);
        assert!(files(&folder.join("merged")) == whole, "{count}");
        first.extend(names.first().cloned());
    }
    // The figure that `reproduce` draws is the same map.
    let set = ["columns=23", "rows=14"].map(|size| format!("beyond_attractors.{size}"));
    let line =
        ["reproduce", "--only", "beyond_attractors", "--output", "same", "--set", &set[0], "--set", &set[1]];
    assert_eq!(grazing(folder, &line).code, Some(0));
    let svg = "beyond_attractors.svg";
    assert!(
        fs::read(folder.join("same").join(svg)).unwrap()
            == fs::read(folder.join("merged").join(svg)).unwrap()
    );

    let before = listing(folder);
    let mut refused = String::new();
    let mut refuse = |what: &str, names: &[String]| {
        let outcome = merge(names, "refused");
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{what}");
        refused.push_str(&format!("{what}\n{}\n", outcome.messages));
    };
    refuse("two parts missing", &first[1..2]);
    refuse("one twice", &[&first[..1], &first[..1]].concat());
    refuse("a part of as many others", &first[1..]);
    let part = fs::read_to_string(folder.join(&first[1])).expect("it was written");
    let program = behind_digest(&part).split('"').nth(1).expect("it says which program made it");
    let forge = |name: &str, from: &str, to: &str| {
        let text = behind_digest(&part).replacen(from, to, 1);
        assert!(text != behind_digest(&part), "{from} stands in a part");
        fs::write(folder.join(name), forged(&text)).expect("the folder is ours");
        vec![name.to_owned()]
    };
    refuse("more places than there are", &forge("out/a.toml", "places = ", "places = 9"));
    refuse("another place", &forge("out/b.toml", "first = 0.0", "first = 0.1"));
    refuse("motion of no name", &forge("out/c.toml", "motion = \"non-", "motion = \"un"));
    refuse("another row", &forge("out/d.toml", "row = 0", "row = 7"));
    refuse("more rows than there are", &forge("out/e.toml", "rows=14", "rows=20000"));
    refuse("not damped", &forge("out/f.toml", "zeta = 0.02", "zeta = 2.0"));
    refuse("another program", &forge("out/g.toml", program, "another program"));
    fs::write(folder.join("my.toml"), narrow_linear()).expect("the folder is ours");
    let family = [&["unfold", "my.toml"], &VARY[..], &["--part", "1/4", "--output", "out"]].concat();
    assert_eq!(grazing(folder, &family).code, Some(0));
    refuse("a part of a family", &[first[1].clone(), "out/parts/1-of-4.toml".to_owned()]);
    let refused = refused.replace(program, "PROGRAM");
    snapshots().bind(|| insta::assert_snapshot!("messages_for_parts_of_a_map_that_do_not_fit", refused));
    assert!(listing(folder).iter().all(|path| before.contains(path) || !path.starts_with("refused")));
}

#[test]
fn a_map_that_cannot_be_made_is_told_before_anything_is_computed() {
    let project = project(DEFAULT);
    let before = listing(project.path());
    let mut transcript = String::new();
    let mut refuse = |line: &[&str]| {
        let outcome = grazing(project.path(), line);
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{line:?}: {}", outcome.messages);
        transcript.push_str(&format!("{}\n{}\n", line.join(" "), outcome.messages));
    };
    for size in ["1000", "0x10", "10x1", "10x20000", "10xx10", "tenxten", "-3x4"] {
        refuse(&["attractors", &format!("--size={size}")]);
    }
    for part in ["0/2", "3/2", "1/15"] {
        refuse(&["attractors", "--size", "23x14", "--part", part]);
    }
    refuse(&["attractors", "--set", "oscillator.zeta=2"]);
    refuse(&["attractors", "--set", "oscillator.zetta=0.1"]);
    refuse(&["attractors", "--parameters", "absent.toml"]);
    refuse(&["attractors", "--output", "figures/parameters.toml"]);
    snapshots().bind(|| insta::assert_snapshot!("messages_for_maps_that_cannot_be_made", transcript));
    assert_eq!(listing(project.path()), before);
    // A setting that does not fit the oscillator, although it would fit another one.
    let unfit = ["attractors", "--set", "fig07.frequency=[0.9,0.95]"];
    assert_eq!(grazing(project.path(), &unfit).code, Some(3));
    assert_eq!(listing(project.path()), before);
}

#[test]
fn a_new_folder_of_results_appears_with_all_its_files() {
    let project = project(DEFAULT);
    let results = project.path().join("results/map");
    let mut run = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .args(SIZE)
        .args(["--output", "results/map"])
        .current_dir(project.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    // Without a pause: a folder that is filled file by file is seen before it is whole.
    let mut ended = None;
    while !results.exists() && ended.is_none() {
        ended = run.try_wait().expect("it is ours");
    }
    let first = listing(&results);
    assert!(run.wait().expect("it ends").success());
    assert_eq!(first, listing(&results));
    assert!(first.contains(&"manifest.sha256".to_owned()) && is_of_one_run(&results), "{first:?}");
    assert_eq!(listing(project.path()).iter().filter(|path| path.contains(".grazing-")).count(), 0);
}
