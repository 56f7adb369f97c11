//! `grazing reproduce` from end to end, in a temporary folder.

use std::fs;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use crate::family::is_of_one_run;
use crate::program::{grazing, listing, project, quick_parameters};
use grazing_cli::outputs;
use grazing_cli::outputs::edition::Edition;

#[test]
fn the_whole_reproduction_passes_its_own_check_whatever_the_number_of_threads() {
    let folder = project(&quick_parameters());
    let made = grazing(folder.path(), &["reproduce", "--jobs", "1"]);
    assert_eq!(made.code, Some(0), "{}", made.messages);
    let files: Vec<String> = outputs::ALL
        .iter()
        .flat_map(|output| output.paths(&Edition::default()))
        .map(|path| path.display().to_string())
        .collect();
    for file in &files {
        assert!(folder.path().join("figures").join(file).is_file(), "{file} was not written");
    }
    assert_eq!(
        listing(folder.path()).len(),
        files.len() + 6,
        "two folders, the parameters, the page about the data, the list and codecheck.yml, nothing else"
    );
    assert!(is_of_one_run(&folder.path().join("figures")));
    assert!(made.output.contains("published values are met"), "{}", made.output);
    assert!(made.output.contains("\nNext: cargo xtask report\n"), "{}", made.output);
    assert!(made.output.contains(" files new\n"), "{}", made.output);

    let checked = grazing(folder.path(), &["reproduce", "--check", "--jobs", "2"]);
    assert_eq!(checked.code, Some(0), "{}", checked.messages);

    // Incomplete results never replace complete ones.
    let figures = folder.path().join("figures");
    let whole = listing(&figures);
    let line = ["reproduce", "--output", "figures", "--set", "fig10.frequency=0.6"];
    let made = grazing(folder.path(), &line);
    assert_eq!(made.code, Some(3), "{}", made.messages);
    let told =
        "figures: the results there are kept; the finished part of this run goes to figures/unfinished\n";
    assert!(made.messages.contains(told), "{}", made.messages);
    let unfinished = figures.join("unfinished");
    assert!(is_of_one_run(&unfinished) && !unfinished.join("fig10.svg").exists());
    let checked = grazing(folder.path(), &[&line[..], &["--check"]].concat());
    assert_eq!(checked.code, Some(3), "it is what the code makes, and incomplete: {}", checked.messages);
    fs::remove_dir_all(&unfinished).expect("the folder is ours");
    assert_eq!(listing(&figures), whole);
    // A list of other files is noticed.
    fs::write(figures.join("manifest.sha256"), "# The files of one run.\n").expect("the folder is ours");
    let checked = grazing(folder.path(), &["reproduce", "--check"]);
    assert_eq!(checked.code, Some(1), "{}", checked.messages);
    assert!(checked.messages.contains("figures/manifest.sha256: "), "{}", checked.messages);
}

#[test]
fn a_check_names_the_tampered_files_and_the_command_that_mends_them() {
    let folder = project(&quick_parameters());
    let here = |name: &str| folder.path().join(name);
    let made = grazing(folder.path(), &["reproduce", "--only", "coefficients"]);
    assert_eq!(made.code, Some(0), "{}", made.messages);
    assert_eq!(listing(&here("figures/data")), ["coefficients.csv"]);
    let list = fs::read_to_string(here("figures/manifest.sha256")).expect("it was written");
    assert!(list.starts_with("# The files of some outputs, computed from "), "{list}");

    let table = fs::read_to_string(here("figures/data/coefficients.csv")).expect("it was written");
    let (head, last) = table.trim_end().rsplit_once(',').expect("there are columns");
    assert!(!last.is_empty());
    let tampered = format!("{head},1.0\n");
    fs::write(here("figures/data/coefficients.csv"), &tampered).expect("the folder is ours");
    let before = listing(folder.path());
    let checked = grazing(folder.path(), &["reproduce", "--only", "coefficients", "--check"]);
    assert_eq!(checked.code, Some(1), "{}", checked.messages);
    let line = table.lines().count();
    let column =
        table.lines().next().and_then(|header| header.rsplit(',').next()).expect("there is a header");
    // Marks around nothing are no content.
    let made = if last == "\"\"" { "nothing" } else { last };
    let told = format!(
        "figures/data/coefficients.csv: line {line}, {column}: 1.0 in the file, {made} from the code\n"
    );
    assert!(checked.messages.contains(&told), "{told} is not told in {}", checked.messages);
    assert!(checked.errors().contains("`cargo xtask reproduce --only coefficients`"), "{}", checked.messages);
    assert_eq!(listing(folder.path()), before);
    let unmended = fs::read_to_string(here("figures/data/coefficients.csv")).expect("it is there");
    assert_eq!(unmended, tampered, "a check writes nothing");
}

#[test]
fn the_list_of_some_outputs_says_whether_they_belong_together() {
    let folder = project(&quick_parameters());
    let list = |options: &[&str]| {
        let made = grazing(folder.path(), &[&["reproduce", "--output", "out", "--only"], options].concat());
        assert_eq!(made.code, Some(0), "{}", made.messages);
        let list = fs::read_to_string(folder.path().join("out/manifest.sha256")).expect("it was written");
        let (head, files) = list.split_once('\n').expect("there are lines");
        assert!(is_of_one_run(&folder.path().join("out")), "{list}");
        (head.to_owned(), files.matches("fig04").count(), files.matches("coefficients").count())
    };
    let first = list(&["fig04"]);
    assert!(first.0.starts_with("# The files of some outputs, computed from ") && first.1 > 0, "{first:?}");
    let both = list(&["coefficients"]);
    assert_eq!((&both.0, both.1, both.2), (&first.0, first.1, 1));
    // The same outputs from other parameters replace all that is there, or only a part.
    let mixed = list(&["coefficients", "--set", "oscillator.zeta=0.021"]);
    assert_eq!(mixed.0, "# The files of several runs.");
}

#[test]
fn outputs_that_can_be_made_are_and_the_others_are_named_with_their_keys() {
    let folder = project(&quick_parameters());
    // Theorem 2.3 does not apply there.
    let made = grazing(folder.path(), &["reproduce", "--set", "fig10.frequency=0.6"]);
    assert_eq!(made.code, Some(3), "{}", made.messages);
    let told = "error: fig10: --set: fig10.frequency = 0.6: ";
    assert!(made.messages.contains(told) && made.messages.contains("they hold from"), "{}", made.messages);
    let told = format!("1 of {} outputs failed or are incomplete", outputs::ALL.len());
    assert!(made.errors().contains(&told), "{}", made.messages);
    for output in outputs::ALL {
        for path in output.paths(&Edition::default()) {
            let is_there = folder.path().join("varied").join(&path).is_file();
            assert_eq!(is_there, output.name != "fig10", "{}", path.display());
        }
    }
    assert_eq!(listing(&folder.path().join("figures")), ["parameters.toml"], "figures/ is not touched");
    let settings = fs::read_to_string(folder.path().join("varied/settings.txt")).expect("it was written");
    assert_eq!(settings, "computed from parameters.toml with\n--set fig10.frequency=0.6\n");
    // No other output needs what Figure 10 does not have.
    let made = grazing(folder.path(), &["reproduce", "--only", "fig05", "--set", "fig10.frequency=-1"]);
    assert_eq!(made.code, Some(0), "{}", made.messages);
    let checked =
        grazing(folder.path(), &["reproduce", "--only", "fig05", "--set", "fig10.frequency=-1", "--check"]);
    assert_eq!(checked.code, Some(0), "{}", checked.messages);
}

#[test]
fn other_oscillators_have_their_portraits_and_panels_where_they_exist() {
    let folder = project(&quick_parameters());
    for setting in
        ["oscillator.zeta=0.01", "oscillator.zeta=0.05", "oscillator.epsilon=0.95", "oscillator.epsilon=1"]
    {
        let line = ["reproduce", "--only", "fig02", "--only", "fig08", "--set", setting];
        let made = grazing(folder.path(), &line);
        assert_eq!(made.code, Some(0), "{setting}: {}", made.messages);
        let moved = "fig02.portraits[2].near = 0.2755: the portrait of p = 3 is at 0.2";
        assert!(made.messages.contains(moved), "{setting}: {}", made.messages);
    }
    // An amplitude at which there is no such portrait is rejected, with one at which there is.
    let setting = "fig02.portraits[2].amplitude=0.3";
    let made = grazing(folder.path(), &["reproduce", "--only", "fig02", "--set", setting]);
    assert_eq!(made.code, Some(3), "{}", made.messages);
    assert!(made.errors().contains("there is one from 0.2"), "{}", made.messages);
}

#[test]
fn an_interrupted_run_leaves_every_file_as_it_was() {
    let folder = project(&quick_parameters());
    let figure = folder.path().join("figures/fig07.svg");
    fs::write(&figure, "old").expect("the folder is ours");
    let before = listing(folder.path());
    let mut run = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .arg("reproduce")
        .current_dir(folder.path())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // The first line of progress comes when the computation begins, long before anything is written.
    let mut line = String::new();
    let messages = run.stderr.take().expect("it is piped");
    BufReader::new(messages).read_line(&mut line).expect("the program tells of its progress");
    assert!(line.ends_with("started\n"), "{line}");
    run.kill().expect("it still runs");
    run.wait().expect("it ends");
    assert_eq!(listing(folder.path()), before);
    assert_eq!(fs::read_to_string(&figure).expect("it is there"), "old");
}
