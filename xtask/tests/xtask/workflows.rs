//! Workflows run nothing that can change behind their backs, and what was not checked is said.

use std::fs;
use std::path::Path;

fn text(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)).expect("it is there")
}

const WORKFLOWS: [&str; 2] = [".github/workflows/checks.yml", ".github/workflows/release.yml"];

#[test]
fn actions_are_pinned_by_commit_and_installed_programs_by_version() {
    for file in WORKFLOWS {
        let text = text(file);
        let mut uses = 0;
        for action in text.lines().filter_map(|line| line.split_once("uses: ")).map(|(_, action)| action) {
            let (_, commit) = action.split_once('@').expect("an action has a version");
            let (commit, version) = commit.split_once(" # v").expect("a commit, and its version after #");
            let is_commit = commit.len() == 40 && commit.bytes().all(|digit| digit.is_ascii_hexdigit());
            assert!(is_commit && version.split('.').count() == 3, "{file}: {action}");
            uses += 1;
        }
        assert!(uses > 3, "{file}");
        for line in text.lines().filter(|line| line.contains("cargo install")) {
            assert!(line.contains("--locked") && line.contains('@'), "{file}: {line}");
        }
    }
}

#[test]
fn jobs_may_read_unless_they_say_otherwise_and_all_that_is_released_is_attested() {
    for file in WORKFLOWS {
        assert!(text(file).contains("\npermissions:\n  contents: read\n"), "{file}");
    }
    let release = text(".github/workflows/release.yml");
    let jobs = release.split_once("\njobs:\n").expect("there are jobs").1;
    let jobs: Vec<&str> = jobs.split("\n\n").filter(|job| job.contains("upload-artifact@")).collect();
    assert_eq!(jobs.len(), 4, "the program, the page, the package for Python, the list of libraries");
    for job in jobs {
        for part in ["attest-build-provenance@", "id-token: write", "attestations: write", "contents: read"] {
            assert!(job.contains(part), "{part}: {job}");
        }
    }
}

#[test]
fn what_cannot_be_checked_is_added_to_the_list_at_the_end() {
    let run = text(".ci/run");
    let told =
        ["could not be", "is not found"].map(|words| run.lines().filter(move |line| line.contains(words)));
    let mut lines = told.into_iter().flatten().filter(|line| !line.starts_with('#')).peekable();
    assert!(lines.peek().is_some());
    lines.for_each(|line| assert!(line.trim_start().starts_with("not_checked "), "{line}"));
    let end = run.split("current=\"nothing\"").last().expect("there is an end");
    assert!(end.contains("not checked:") && end.contains("::warning"), "{end}");
}
