//! Signals that end a run, and its exit code.
#![cfg(target_os = "linux")]

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::program::{DEFAULT, DEFAULT_SIGNALS, project, started, wait_until};

/// Starts the program behind another one, and sends it a signal as soon as it computes; returns the
/// exit code and the messages.
fn sent(signal: &str, before: &[&str], folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let messages = folder.join("messages");
    let mut program = Command::new(before[0]);
    program.args(&before[1..]).arg(env!("CARGO_BIN_EXE_grazing")).args(arguments);
    let mut run = started(&mut program, folder, &messages);
    let told = || fs::read_to_string(&messages).expect("the folder is ours");
    wait_until(&mut run, "it computes", || told().contains(": started"));
    let kill = Command::new("kill").args([signal, &run.id().to_string()]).status().expect("there is kill");
    assert!(kill.success());
    (run.wait().expect("it ends").code(), told())
}

#[test]
fn whoever_ends_claims_leaves_exit_code_three() {
    for signal in ["-INT", "-TERM", "-HUP"] {
        let folder = project(DEFAULT);
        let (code, told) = sent(signal, &DEFAULT_SIGNALS, folder.path(), &["claims"]);
        assert_eq!(code, Some(3), "{signal}: {told}");
        assert!(told.ends_with("error: interrupted: nothing more is written\n"), "{told}");
    }
}

#[test]
fn a_map_that_is_interrupted_leaves_nothing() {
    let folder = project(DEFAULT);
    for part in [&["--output", "out"][..], &["--output", "out", "--part", "1/2"]] {
        let line = [&["attractors", "--size", "2000x2000"], part].concat();
        let (code, told) = sent("-INT", &DEFAULT_SIGNALS, folder.path(), &line);
        assert_eq!(code, Some(3), "{told}");
        assert!(told.ends_with("error: interrupted: nothing more is written\n"), "{told}");
        assert!(!folder.path().join("out").exists());
    }
}

#[test]
fn a_run_that_is_to_survive_its_terminal_does() {
    let folder = project(DEFAULT);
    let line = ["reproduce", "--only", "fig02", "--output", "out"];
    let (code, told) = sent("-HUP", &["nohup"], folder.path(), &line);
    assert_eq!(code, Some(0), "{told}");
    assert!(folder.path().join("out/fig02.svg").is_file());
}
