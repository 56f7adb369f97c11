//! The Snakemake workflow in examples/workflow/, run on this machine with two workers.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::Command;
use std::time::SystemTime;

use crate::program::{DEFAULT, empty_folder, grazing, narrow_linear, project, repository};

/// Runs the workflow in a folder with these keys; `None` without Snakemake.
fn snakemake(folder: &Path, keys: &[&str]) -> Option<()> {
    let program = format!("program={}", env!("CARGO_BIN_EXE_grazing"));
    let run = Command::new("snakemake")
        .current_dir(folder)
        .arg("--snakefile")
        .arg(repository().join("examples/workflow/Snakefile").canonicalize().expect("it is there"))
        .args(["--cores", "2", "--config", &program, "parts=3", "output=out"])
        .args(keys)
        .output();
    match run {
        Ok(run) => {
            assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
            Some(())
        }
        Err(reason) => {
            // Written directly to the stream, which the harness does not capture, for readers of CI's log.
            let line = format!("\nskipped: no Snakemake here, so the workflow was not run ({reason})\n");
            let _ = std::io::stderr().write_all(line.as_bytes());
            None
        }
    }
}

fn changed(path: &Path) -> SystemTime {
    path.metadata()
        .and_then(|about| about.modified())
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn the_workflow_makes_what_one_run_makes_and_resumes_with_what_is_missing() {
    let folder = empty_folder();
    let folder = folder.path();
    fs::write(folder.join("my.toml"), narrow_linear()).expect("the folder is ours");
    let keys = ["oscillator=my.toml", "vary=[\"kappa=0.08:0.12:4\"]"];
    if snakemake(folder, &keys).is_none() {
        return;
    }
    let one = grazing(folder, &["unfold", "my.toml", "--vary", "kappa=0.08:0.12:4", "--output", "one"]);
    assert_eq!(one.code, Some(0), "{}", one.messages);
    let read = |file: &str| fs::read(folder.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
    let files = ["family.svg", "data/family_resonances.csv", "data/family_curves.csv", "data/README.md"];
    let same = || files.iter().all(|file| read(&format!("one/{file}")) == read(&format!("out/{file}")));
    assert!(same());

    // As after an interrupted run: one part and all results of the parts are missing.
    let parts = ["1", "2", "3"].map(|part| folder.join(format!("out/parts/{part}-of-3.toml")));
    let before = parts.each_ref().map(|part| changed(part));
    fs::remove_file(&parts[1]).expect("it can be removed");
    fs::remove_file(folder.join("out/data/family_resonances.csv")).expect("it can be removed");
    snakemake(folder, &keys);
    assert!(same());
    let after = parts.each_ref().map(|part| changed(part));
    assert!(after[0] == before[0] && after[2] == before[2] && after[1] > before[1]);
}

#[test]
fn the_workflow_makes_the_map_that_one_run_makes() {
    let folder = project(DEFAULT);
    let folder = folder.path();
    if snakemake(folder, &["map=20x9", "oscillator=figures/parameters.toml"]).is_none() {
        return;
    }
    let one = grazing(folder, &["attractors", "--size", "20x9", "--output", "one"]);
    assert_eq!(one.code, Some(0), "{}", one.messages);
    let read = |file: &str| fs::read(folder.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
    for file in ["beyond_attractors.svg", "data/beyond_attractors.csv", "data/README.md"] {
        assert!(read(&format!("one/{file}")) == read(&format!("out/{file}")), "{file}");
    }
}
