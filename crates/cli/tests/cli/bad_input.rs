//! Bad input gives one clear message and exit code 2, and nothing is written.

use std::fs;
use std::path::Path;

use crate::program::{INVENTED, edited, empty_folder, grazing, listing, project, repository, snapshots};

/// Edits of valid parameters: a section, a key after it, and the line that replaces the key's line.
pub(crate) const EDITS: &[(&str, &str, &str)] = &[
    ("[oscillator]", "zeta", "zetta = 0.1"),
    ("[oscillator]", "zeta", ""),
    ("[oscillator]", "zeta", "zeta = \"small\""),
    ("[oscillator]", "zeta", "zeta = 0.1.1"),
    ("[oscillator]", "zeta", "zeta = 0"),
    ("[oscillator]", "zeta", "zeta = 1.5"),
    ("[oscillator]", "zeta", "zeta = nan"),
    ("[oscillator]", "epsilon", "epsilon = 0.0"),
    ("[oscillator]", "epsilon", "epsilon = 1.01"),
    ("[oscillator]", "epsilon", "epsilon = inf"),
    ("[oscillator]", "epsilon", "epsilon = 0.7\nepsilon = 0.8"),
    ("[fig02]", "frequency", "frequency = -1"),
    ("[fig02]", "amplitude", "amplitude = [0.4, 0.2]"),
    ("[fig02]", "amplitude", "amplitude = [0.2, 0.2]"),
    ("[fig02]", "amplitude", "amplitude = [0.2, 0.3, 0.4]"),
    ("[fig02]", "amplitude", "amplitude = [0.2, nan]"),
    ("[fig02]", "x", "x = [0.1, -inf]"),
    ("[fig02]", "loops", "loops = [0, 1]"),
    ("[fig02]", "loops", "loops = []"),
    ("[fig02]", "loops", "loops = [1, 2, 2]"),
    ("[fig02]", "loops", "loops = [1, 2.5]"),
    ("[fig02.magnification]", "amplitude", "amplitude = [0, 9]"),
    ("[fig02.attractor]", "orbits", "orbits = 0"),
    ("[fig02.attractor]", "orbits", "orbits = 1000\nrecoded = 20"),
    ("[fig02.attractor]", "transient", "transient = 1000000"),
    ("[[fig02.portraits]]", "loops", "loops = 7"),
    ("[fig07]", "frequency", "frequency = [0.0, 1.1]"),
    ("[fig07]", "frequency", "frequency = [1e-9, 1.1]"),
    ("[[fig08.panels]]", "loops", "loops = 13"),
    ("[[fig08.panels]]", "frequency", "frequency = [0.4, 4]"),
    ("[fig07]", "[[fig08.panels]]", "[[fig8.panels]]"),
    ("[fig02]", "[fig02.attractor]", "[fig2.attractor]"),
];

#[test]
fn every_bad_parameter_file_is_refused_with_file_line_key_value_and_what_is_allowed() {
    let mut transcript = String::new();
    for (section, key, line) in EDITS {
        let edit = format!(
            "{section} {key}: {}",
            if line.is_empty() { "removed".to_owned() } else { line.replace('\n', "; ") }
        );
        let folder = project(&edited(INVENTED, section, key, line));
        let before = listing(folder.path());
        let outcome = grazing(folder.path(), &["reproduce"]);
        assert_eq!(outcome.code, Some(2), "{edit}: {}", outcome.messages);
        assert_eq!(outcome.output, "", "{edit}");
        assert_eq!(outcome.messages.lines().count(), 1, "{edit}: {}", outcome.messages);
        assert_eq!(listing(folder.path()), before, "{edit}");
        transcript.push_str(&format!("{edit}\n{}\n", outcome.messages));
    }
    snapshots().bind(|| insta::assert_snapshot!("messages_for_bad_parameters", transcript));
}

/// Settings that do not fit the invented oscillator, although they would fit another one.
const MISFITS: &[(&str, &str, &str, &str)] = &[
    ("fig02", "[fig02]", "amplitude", "amplitude = [0.001, 0.002]"),
    ("fig07", "[fig07]", "frequency", "frequency = [0.9, 0.95]"),
    ("fig08", "[[fig08.panels]]", "n", "n = 5"),
];

#[test]
fn what_does_not_fit_the_oscillator_is_told_of_the_output_that_needs_it() {
    let mut transcript = String::new();
    for (output, section, key, line) in MISFITS {
        let folder = project(&edited(INVENTED, section, key, line));
        let before = listing(folder.path());
        let outcome = grazing(folder.path(), &["reproduce", "--only", output]);
        assert_eq!(outcome.code, Some(3), "{line}: {}", outcome.messages);
        assert_eq!(listing(folder.path()), before, "{line}");
        assert_eq!(outcome.messages, outcome.errors(), "nothing is computed");
        transcript.push_str(&format!("{section} {key}: {line}\n{}\n", outcome.messages));
    }
    snapshots().bind(|| insta::assert_snapshot!("messages_for_parameters_that_do_not_fit", transcript));
}

#[test]
fn settings_are_refused_with_what_would_be_right() {
    let folder = project(INVENTED);
    let oscillator = fs::read_to_string(repository().join("examples/duffing.toml")).expect("it is there");
    fs::write(folder.path().join("o.toml"), oscillator).expect("the folder is ours");
    let before = listing(folder.path());
    let mut transcript = String::new();
    for arguments in [
        ["reproduce", "oscillator.zetta=0.1"],
        ["reproduce", "oscillator.zeta=2"],
        ["reproduce", "oscillator.zeta"],
        ["reproduce", "oscillator.zeta=small"],
        ["reproduce", "fig08.panels[7].n=1"],
        ["reproduce", "fig07.frequency=[0.0001, 1.02]"],
        ["reproduce", "fig01.frequency=1e-9"],
        ["compare", "fig07.loops=[0]"],
        ["unfold", "kapa=0.2"],
        ["unfold", "kappa=\"much\""],
        ["unfold", "secondary.rang=[0.4, 1.1]"],
        ["unfold", "analysis.loops=[1, 1]"],
        ["unfold", "motion.force=\"-x + A*cos(omgea*t)\""],
    ] {
        let [command, setting] = arguments;
        let file = (command == "unfold").then_some("o.toml");
        let line: Vec<&str> = [command, "--set", setting].into_iter().chain(file).collect();
        let outcome = grazing(folder.path(), &line);
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{setting}: {}", outcome.messages);
        assert_eq!(listing(folder.path()), before, "{setting}");
        let first = outcome.messages.split("\n\n").next().unwrap_or_default();
        transcript.push_str(&format!("$ grazing {command} --set {setting}\n{}\n", first.trim_end()));
    }
    snapshots().bind(|| insta::assert_snapshot!("messages_for_bad_settings", transcript));
}

#[test]
fn compare_refuses_a_bad_parameter_file_as_well() {
    let folder = project(&edited(INVENTED, "[oscillator]", "zeta", "zeta = 2"));
    let outcome = grazing(folder.path(), &["compare"]);
    assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""));
    assert!(outcome.messages.starts_with("error: figures/parameters.toml:"), "{}", outcome.messages);
}

#[test]
fn the_default_parameters_are_found_from_a_folder_below() {
    let folder = project(&edited(INVENTED, "[oscillator]", "zeta", "zeta = 2"));
    let below = folder.path().join("a/b");
    fs::create_dir_all(&below).expect("the folder is ours");
    let outcome = grazing(&below, &["reproduce"]);
    assert_eq!(outcome.code, Some(2));
    assert!(outcome.messages.starts_with("error: ../../figures/parameters.toml:"), "{}", outcome.messages);
}

#[test]
fn every_bad_command_line_is_refused() {
    let folder = empty_folder();
    fs::write(folder.path().join("file"), "").expect("the folder is ours");
    fs::write(folder.path().join("p.toml"), INVENTED).expect("the folder is ours");
    let oscillator = fs::read_to_string(repository().join("examples/duffing.toml")).expect("it is there");
    fs::create_dir(folder.path().join("below")).expect("the folder is ours");
    for (name, text) in [
        ("o.toml", &oscillator),
        ("below/o.toml", &oscillator),
        ("bad.toml", &oscillator.replace("kappa*x^3", "kapa*x^3")),
    ] {
        fs::write(folder.path().join(name), text).expect("the folder is ours");
    }
    let mut transcript = String::new();
    for line in [
        "",
        "frobnicate",
        "reproduce --only fig7",
        "reproduce --only fig11",
        "reproduce --chek",
        "reproduce --jobs 0",
        "reproduce --jobs many",
        "reproduce --format gif",
        "reproduce --columns three",
        "reproduce --dpi 5000",
        "reproduce",
        "compare --parameters missing.toml",
        "reproduce --parameters missing.toml",
        "reproduce --parameters p.toml",
        "reproduce --parameters p.toml --output file",
        "reproduce --parameters p.toml --output file/below",
        "unfold",
        "unfold missing.toml",
        "unfold p.toml",
        "unfold o.toml bad.toml",
        "unfold o.toml below/o.toml",
        "unfold o.toml --loops 2,2",
        "unfold o.toml --loops 0",
        "unfold o.toml --format jpeg",
        "unfold o.toml --output file",
        "new",
        "new o.toml",
        "new missing/o.toml",
        "new mine.toml --kind wall",
    ] {
        let before = listing(folder.path());
        let outcome = grazing(folder.path(), &line.split_whitespace().collect::<Vec<_>>());
        assert_eq!(outcome.code, Some(2), "{line}: {}", outcome.messages);
        assert_eq!(outcome.output, "", "{line}");
        assert_eq!(listing(folder.path()), before, "{line}");
        let first = outcome.messages.split("\n\n").filter(|part| !part.contains("Usage")).collect::<Vec<_>>();
        transcript.push_str(&format!("$ grazing {line}\n{}\n", first.join("\n").trim_end()));
    }
    snapshots().bind(|| insta::assert_snapshot!("messages_for_bad_command_lines", transcript));
}

#[test]
fn other_formats_and_widths_are_kept_out_of_the_default_folder() {
    for option in ["--format=pdf", "--columns=one"] {
        let folder = project(INVENTED);
        let before = listing(folder.path());
        let outcome = grazing(folder.path(), &["reproduce", option, "--output", "figures/../figures"]);
        assert_eq!(outcome.code, Some(2), "{option}: {}", outcome.messages);
        let beginning = "error: figures holds SVG at the paper's widths only: ";
        assert!(outcome.messages.starts_with(beginning), "{option}: {}", outcome.messages);
        assert_eq!(listing(folder.path()), before, "{option}");
    }
}

/// The path that the message names, and the function that puts an obstacle there.
type Obstacle = (&'static str, fn(&Path));

#[test]
fn a_place_that_cannot_be_written_is_found_before_anything_is_computed() {
    let obstacles: [Obstacle; 2] = [
        ("out", |out| fs::write(out, "").expect("the folder is ours")),
        ("out/data", |out| {
            fs::create_dir(out).expect("the folder is ours");
            fs::write(out.join("data"), "").expect("the folder is ours");
        }),
    ];
    for (named, obstruct) in obstacles {
        let folder = project(INVENTED);
        obstruct(&folder.path().join("out"));
        let before = listing(folder.path());
        let outcome = grazing(folder.path(), &["reproduce", "--output", "out"]);
        assert_eq!(outcome.code, Some(2), "{named}: {}", outcome.messages);
        let beginning = format!("error: {named}: cannot be written: ");
        assert!(outcome.messages.starts_with(&beginning), "{named}: {}", outcome.messages);
        assert_eq!(listing(folder.path()), before, "{named}");
    }
}
