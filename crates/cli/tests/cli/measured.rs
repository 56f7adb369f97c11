//! Measurements: compared, drawn and used to identify constants by the built program.

use std::fs;

use grazing_measured::read::{POINTS, RECORD};

use crate::program::{empty_folder, grazing, repository};

fn example(name: &str) -> String {
    repository().join("examples").join(name).to_str().expect("the repository has a plain name").to_owned()
}

/// The cells of a CSV file under a header.
fn column(text: &str, header: &str) -> Vec<String> {
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let place = lines.next().expect("there is a header").iter().position(|name| name == header);
    lines.map(|cells| cells[place.expect("the column is there")].clone()).collect()
}

#[test]
fn what_a_rig_did_is_compared_counted_and_drawn() {
    let folder = empty_folder();
    let (file, all) = (example("leaf-spring.toml"), example("leaf-spring-seen.csv"));
    let all = fs::read_to_string(all).expect("it is there");
    // Telling chaos from motion that settles takes long.
    let long = ["irregular", "periodic,10,", "periodic,4,6"];
    let seen: Vec<&str> = all.lines().filter(|line| !long.iter().any(|word| line.contains(word))).collect();
    let data = "seen.csv".to_owned();
    fs::write(folder.path().join(&data), seen.join("\n")).expect("it can be written");
    let run = grazing(folder.path(), &["unfold", &file, "--loops", "1", "--data", &data, "--output", "out"]);
    assert_eq!((run.code, run.errors()), (Some(0), ""), "{}", run.messages);
    assert!(run.output.contains("\nMeasurements compared with the computation\n"), "{}", run.output);
    let read = |name: &str| fs::read_to_string(folder.path().join("out").join(name)).expect("it is written");
    let (measured, counts) = (read("data/measured.csv"), read("data/agreement.csv"));
    let written = seen.iter().filter(|line| !line.starts_with(['#', 'a'])).count();
    let verdicts = column(&measured, "agreement");
    assert_eq!(verdicts.len(), written);
    // A bifurcation is counted once, a place in each region that holds it.
    let disagreeing = verdicts.iter().filter(|verdict| *verdict == "disagrees").count();
    let counted: usize =
        column(&counts, "disagree").iter().map(|count| count.parse::<usize>().expect("a count")).sum();
    assert_eq!((disagreeing, disagreeing > 5), (counted, true), "the rig has other damping than the file");
    // Motion without impacts lies where the file has it: damping moves that curve by less than the errors.
    for (kind, verdict) in column(&measured, "kind").iter().zip(&verdicts) {
        assert!(kind != "no impacts" || verdict == "agrees" || verdict == "within error", "{kind} {verdict}");
    }
    let (page, diagram) = (read("report.html"), read("diagram.svg"));
    assert!(page.contains("measured: no impacts, agrees"), "the legend");
    assert!(diagram.matches("stroke=\"#000000\" stroke-width=\"1.1\"").count() >= 2 * disagreeing, "crosses");
    // The rig with the true constants agrees except for errors: 5 in 100 are farther away than two.
    let set = ["--set", "zeta=0.018", "--set", "r=0.72"];
    let run = grazing(
        folder.path(),
        &[&["unfold", &file, "--loops", "1", "--data", &data, "--output", "true"], &set[..]].concat(),
    );
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let measured = fs::read_to_string(folder.path().join("true/data/measured.csv")).expect("it is written");
    let against = column(&measured, "agreement").iter().filter(|verdict| *verdict == "disagrees").count();
    assert!(against <= 4, "{measured}");
}

/// The values and standard errors of identified constants.
fn identified(arguments: &[&str]) -> Vec<(f64, f64)> {
    let folder = empty_folder();
    let run = grazing(folder.path(), &[&["identify", "--output", "out"], arguments].concat());
    assert_eq!((run.code, run.errors()), (Some(0), ""), "{}", run.messages);
    assert!(run.output.contains("\nNext: cargo xtask unfold "), "{}", run.output);
    let text = fs::read_to_string(folder.path().join("out/data/constants.csv")).expect("it is written");
    let numbers =
        |header| column(&text, header).into_iter().map(|cell| cell.parse::<f64>().expect("a number"));
    numbers("value").zip(numbers("standard_error")).collect()
}

#[test]
fn constants_of_the_examples_are_those_with_which_their_data_were_made() {
    let [leaf, seen, door, impacts] =
        ["leaf-spring.toml", "leaf-spring-seen.csv", "door.toml", "door-impacts.csv"].map(example);
    let [gear, flanks] = ["gear-backlash.toml", "gear-impacts.csv"].map(example);
    let from_places = identified(&[&leaf, "--data", &seen, "--free", "zeta,r"]);
    let from_impacts = identified(&[&door, "--record", &impacts, "--free", "c,r"]);
    let from_both_walls = identified(&[&gear, "--record", &flanks, "--free", "c,r,j"]);
    let found = from_places.iter().chain(&from_impacts).chain(&from_both_walls);
    for ((value, error), truth) in found.zip([0.018, 0.72, 1.9, 0.45, 0.23, 0.64, 1.0]) {
        // Each deviates more than this once in 370.
        assert!((value - truth).abs() < 3.0 * error && *error < 0.05 * truth, "{value} {error} {truth}");
    }
}

#[test]
fn a_rig_that_does_not_fit_is_said_not_to_and_one_without_stated_errors_is_identified() {
    let (door, impacts) =
        (example("door.toml"), fs::read_to_string(example("door-impacts.csv")).expect("it is there"));
    let folder = empty_folder();
    let edited = |name: &str, edit: &dyn Fn(&str, &str) -> String| {
        let mut header: Vec<String> = Vec::new();
        let line = |line: &str| {
            let cells = line.split(',').map(str::to_owned).collect::<Vec<_>>();
            if line.starts_with('#') || header.is_empty() {
                if !line.starts_with('#') {
                    header = cells;
                }
                return line.to_owned();
            }
            header.iter().zip(cells).map(|(head, cell)| edit(head, &cell)).collect::<Vec<_>>().join(",")
        };
        let text = impacts.lines().map(line).collect::<Vec<_>>().join("\n");
        fs::write(folder.path().join(name), text).expect("the folder is ours");
    };
    let number = |cell: &str| cell.parse::<f64>().expect("a number");
    edited("small.csv", &|head, cell| {
        if head.ends_with("_error") { (number(cell) / 50.0).to_string() } else { cell.to_owned() }
    });
    edited("unstated.csv", &|head, cell| {
        if head.ends_with("_error") { String::new() } else { cell.to_owned() }
    });
    let exchanged = impacts.replace("velocity_before", "x").replace("velocity_after", "velocity_before");
    fs::write(folder.path().join("exchanged.csv"), exchanged.replace(",x,", ",velocity_after,"))
        .expect("it is ours");
    let run = |record: &str, more: &[&str]| {
        let line = ["identify", &door, "--free", "c,r", "--output", record, "--record"];
        grazing(folder.path(), &[&line[..], &[format!("{record}.csv").as_str()], more].concat())
    };
    let errors = |record: &str| {
        let text =
            fs::read_to_string(folder.path().join(record).join("data/constants.csv")).expect("it is written");
        column(&text, "standard_error").iter().map(|cell| number(cell)).collect::<Vec<_>>()
    };
    let small = run("small", &[]);
    assert_eq!(small.code, Some(1), "{}", small.messages);
    assert!(small.errors().contains("does not fit the measurements"), "{}", small.messages);
    assert!(small.output.contains("The oscillator does not fit"), "{}", small.output);
    let unstated = run("unstated", &[]);
    assert_eq!(unstated.code, Some(0), "{}", unstated.messages);
    assert!(unstated.output.contains("state no errors"), "{}", unstated.output);
    for (one, other) in errors("small").iter().zip(errors("unstated")) {
        assert!((one / other - 1.0).abs() < 0.5, "{one} {other}");
    }
    let exchanged = run("exchanged", &[]);
    assert_eq!(exchanged.code, Some(2), "{}", exchanged.messages);
    assert!(exchanged.errors().contains("exchanged?"), "{}", exchanged.messages);
    let limited = run("unstated", &["--step-limit", "10"]);
    assert_eq!(limited.code, Some(3), "{}", limited.messages);
    assert!(limited.errors().contains("--step-limit"), "{}", limited.messages);
}

#[test]
fn mistakes_in_measurements_end_the_run_before_anything_is_computed() {
    let folder = empty_folder();
    let write =
        |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("it can be written");
    write("bad.csv", "a,f,seen\n0.1,8,graze\n");
    write("motion.csv", "a,f,seen\n0.1,8,none\n");
    write("few.csv", "a,f,a_error,f_error,seen\n0.3,8.1,0.01,0.01,graz\n");
    let file = example("leaf-spring.toml");
    for (arguments, code, parts) in [
        (vec!["unfold", "--data", "bad.csv"], 2, vec!["bad.csv:2: column seen: `graze`", "graz, SN"]),
        (vec!["unfold", "--data", "none.csv"], 2, vec!["none.csv: cannot be read"]),
        (vec!["identify", "--data", "motion.csv", "--free", "zeta"], 2, vec!["no bifurcation", "--record"]),
        (
            vec!["identify", "--data", "few.csv", "--free", "zeto"],
            2,
            vec!["--free zeto", "`zeta`", "Known: f0"],
        ),
        (vec!["identify", "--data", "few.csv", "--free", "r,r"], 2, vec!["named twice"]),
        (vec!["identify", "--data", "few.csv", "--free", "zeta,r"], 3, vec!["1 measured", "2 unknowns"]),
        (vec!["identify", "--data", "few.csv", "--free", "r"], 3, vec!["do not determine r,", "--free"]),
    ] {
        let run = grazing(folder.path(), &[&arguments[..], &[file.as_str()]].concat());
        assert_eq!(run.code, Some(code), "{arguments:?}: {}", run.messages);
        parts.iter().for_each(|part| assert!(run.messages.contains(part), "{part}: {}", run.messages));
    }
}

#[test]
fn every_column_of_measurements_is_explained() {
    let page = fs::read_to_string(repository().join("docs/measurements.md")).expect("it is there");
    for (name, meaning) in POINTS.iter().chain(RECORD) {
        let name = name.replace("{primary}", "a").replace("{secondary}", "f");
        let row = format!("| `{name}` | {meaning} |");
        assert!(page.contains(&row), "docs/measurements.md has no row {row}");
    }
}
