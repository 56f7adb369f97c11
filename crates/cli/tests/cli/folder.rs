//! The output folder: files are written whole, and every way in which it can differ is named.

use std::fs;
use std::path::{Path, PathBuf};

use crate::program::{empty_folder, listing};
use grazing_cli::folder::{Change, Differences, OutputFile, compare, ensure_writable, write};

fn made(path: &str, content: &str) -> OutputFile {
    OutputFile { path: PathBuf::from(path), content: content.as_bytes().to_vec() }
}

fn two_files() -> Vec<OutputFile> {
    vec![made("a.svg", "<svg>\n</svg>\n"), made("data/a.csv", "kind,x\nSN,1.5\nPD,\n")]
}

/// The differences reported after a change to a folder with the two files: files that differ, and
/// files that do not belong there.
fn differences_after(change: impl Fn(&Path)) -> [Vec<String>; 2] {
    let folder = empty_folder();
    write(folder.path(), &two_files()).expect("the folder is ours");
    change(folder.path());
    let mut found = Differences::default();
    compare(folder.path(), &two_files(), &["parameters.toml"], true, &mut found)
        .expect("the folder can be read");
    let place = format!("{}/", folder.path().display());
    let within = |told: String| told.strip_prefix(&place).expect("it lies in the folder").to_owned();
    [found.differing, found.unexpected].map(|told| told.into_iter().map(within).collect())
}

/// The difference reported when the table has this content.
fn difference_of_table(content: &str) -> String {
    let [found, unexpected] =
        differences_after(|folder| fs::write(folder.join("data/a.csv"), content).expect("the file is ours"));
    assert_eq!((found.len(), unexpected.len()), (1, 0), "{found:?}");
    found[0].clone()
}

#[test]
fn files_are_new_then_unchanged_then_updated() {
    let folder = empty_folder();
    let out = folder.path().join("not/there/yet");
    let first = write(&out, &two_files()).expect("the folder is ours");
    assert_eq!(first, [Change::New, Change::New]);
    assert_eq!(fs::read_to_string(out.join("a.svg")).expect("it was written"), "<svg>\n</svg>\n");
    let second = write(&out, &two_files()).expect("the folder is ours");
    assert_eq!(second, [Change::Unchanged, Change::Unchanged]);
    let mut files = two_files();
    files[1].content.push(b'\n');
    assert_eq!(write(&out, &files).expect("the folder is ours"), [Change::Unchanged, Change::Updated]);
    assert_eq!(listing(&out), ["a.svg", "data", "data/a.csv"], "no temporary file is left");
}

#[cfg(unix)]
#[test]
fn written_files_can_be_read_by_whoever_can_read_other_new_files() {
    use std::os::unix::fs::PermissionsExt;
    let folder = empty_folder();
    write(folder.path(), &two_files()).expect("the folder is ours");
    fs::write(folder.path().join("ordinary"), "").expect("the folder is ours");
    let mode = |name: &str| folder.path().join(name).metadata().expect("it is there").permissions().mode();
    assert_eq!(mode("a.svg"), mode("ordinary"));
}

#[cfg(unix)]
#[test]
fn a_file_that_is_replaced_keeps_who_may_read_it() {
    use std::os::unix::fs::PermissionsExt;
    let folder = empty_folder();
    let path = folder.path().join("a.svg");
    for kept in [0o600, 0o444, 0o664, 0o755] {
        fs::write(&path, "old").expect("the folder is ours");
        fs::set_permissions(&path, fs::Permissions::from_mode(kept)).expect("the folder is ours");
        write(folder.path(), &two_files()).expect("the folder is ours");
        let mode = path.metadata().expect("it is there").permissions().mode();
        assert_eq!(mode & 0o777, kept);
        assert_eq!(fs::read_to_string(&path).expect("it was written"), "<svg>\n</svg>\n");
        fs::remove_file(&path).expect("the folder is ours");
    }
}

#[test]
fn if_one_file_cannot_be_written_none_is() {
    let folder = empty_folder();
    fs::write(folder.path().join("a.svg"), "old").expect("the folder is ours");
    fs::write(folder.path().join("data"), "in the way").expect("the folder is ours");
    let failure = write(folder.path(), &two_files()).expect_err("data is no folder");
    assert_eq!(failure.exit_code(), 4);
    assert_eq!(fs::read_to_string(folder.path().join("a.svg")).expect("it is there"), "old");
    assert_eq!(listing(folder.path()), ["a.svg", "data"], "no temporary file is left");
}

#[test]
fn the_trial_of_writing_leaves_no_trace() {
    let folder = empty_folder();
    let out = folder.path().join("not/there/yet");
    ensure_writable(&out, &[PathBuf::from("a.svg")]).expect("the folder is ours");
    assert_eq!(listing(folder.path()), [""; 0]);
}

#[test]
fn a_folder_that_is_what_the_code_makes_has_no_differences() {
    let found = differences_after(|folder| {
        fs::write(folder.join("parameters.toml"), "").expect("the folder is ours");
        fs::write(folder.join(".hidden-by-somebody-else"), "").expect("the folder is ours");
    });
    assert_eq!(found, [[""; 0]; 2]);
}

#[test]
fn a_missing_file_and_a_missing_folder_are_named() {
    let found = differences_after(|folder| fs::remove_file(folder.join("a.svg")).expect("it is there"));
    assert_eq!(found[0], ["a.svg: missing"]);
    let found = differences_after(|folder| fs::remove_dir_all(folder).expect("it is there"));
    assert_eq!(found[0].len(), 2);
}

#[test]
fn files_that_the_code_does_not_make_are_named() {
    let found = differences_after(|folder| {
        for stale in ["old.svg", "data/old.csv", "data/.grazing-8fHq"] {
            fs::write(folder.join(stale), "").expect("the folder is ours");
        }
    });
    let named: Vec<&str> = found[1].iter().map(|told| told.split(':').next().unwrap_or("")).collect();
    assert_eq!(named, ["data/.grazing-8fHq", "data/old.csv", "old.svg"]);
}

#[test]
fn the_first_differing_cell_of_a_table_is_named_with_both_values() {
    let said = difference_of_table("kind,x\nSN,1.25\nGZ,\n");
    assert_eq!(said, "data/a.csv: line 2, x: 1.25 in the file, 1.5 from the code");
    let said = difference_of_table("kind,x\nSN,1.5\nPD,2.5\n");
    assert_eq!(said, "data/a.csv: line 3, x: 2.5 in the file, nothing from the code");
}

#[test]
fn another_header_or_number_of_cells_is_shown_as_whole_lines() {
    let said = difference_of_table("kind,y\nSN,1.5\nPD,\n");
    assert_eq!(said, "data/a.csv: line 1: `kind,y` in the file, `kind,x` from the code");
    let said = difference_of_table("kind,x\nSN\nPD,\n");
    assert_eq!(said, "data/a.csv: line 2: `SN` in the file, `SN,1.5` from the code");
}

#[test]
fn another_number_of_lines_is_told() {
    assert_eq!(
        difference_of_table("kind,x\nSN,1.5\n"),
        "data/a.csv: ends after line 2; the code produces more lines"
    );
    let said = difference_of_table("kind,x\nSN,1.5\nPD,\nPD,\n");
    assert_eq!(said, "data/a.csv: the file has more lines than the 3 that the code produces");
    assert!(difference_of_table("kind,x\r\nSN,1.5\r\nPD,\r\n").contains("line ends"));
}

#[test]
fn another_picture_is_told_with_its_line() {
    let found =
        differences_after(|folder| fs::write(folder.join("a.svg"), "<svg>\n<g/>\n").expect("it is ours"));
    assert_eq!(found[0], ["a.svg: differs from what the code produces, first in line 2"]);
}
