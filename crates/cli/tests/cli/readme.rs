//! The commands in the README exist.

use std::fs;
use std::process::Command;

use crate::program::{empty_folder, repository};
use clap::Parser;
use clap::error::ErrorKind;
use grazing_analysis::unfolded::{AlongGrazing, AtResonances};
use grazing_claims::checks::CHECKS;
use grazing_claims::ledger::{Claim, Ledger, Test};
use grazing_cli::arguments::Arguments;
use grazing_cli::outputs::{self, Output};
use grazing_results::Tables;

/// The lines of the README that begin with `cargo xtask`, as in a block of commands.
fn commands() -> Vec<String> {
    let readme = fs::read_to_string(repository().join("README.md")).expect("there is a README.md");
    readme
        .lines()
        .map(|line| line.trim().trim_start_matches("$ ").to_owned())
        .filter(|line| line.starts_with("cargo xtask"))
        .collect()
}

#[test]
fn the_readme_shows_all_commands() {
    let commands = commands();
    for wanted in [
        "cargo xtask reproduce",
        "cargo xtask compare",
        "cargo xtask report",
        "cargo xtask unfold",
        "cargo xtask identify",
        "cargo xtask new",
        "cargo xtask explore",
    ] {
        assert!(
            commands.iter().any(|command| command.starts_with(wanted)),
            "no line `{wanted}` in README.md"
        );
    }
}

#[test]
fn the_oscillator_of_the_readme_is_that_of_the_example() {
    let [readme, example] = ["README.md", "examples/duffing.toml"]
        .map(|file| fs::read_to_string(repository().join(file)).expect("it is there"));
    let (_, rest) = readme.split_once("```toml\n").expect("there is an oscillator");
    let (shown, _) = rest.split_once("```").expect("the block ends");
    let [mut shown, mut example]: [toml::Table; 2] =
        [shown, &example].map(|text| text.parse().expect("it is TOML"));
    // Optional keys, and those that do not matter here.
    shown.remove("wall");
    example.remove("diagrams");
    assert_eq!(shown, example);
}

#[test]
fn every_command_of_the_readme_is_understood() {
    for command in commands() {
        let plain = command.replace('\'', "");
        let words = plain.split('#').next().unwrap_or_default().split_whitespace().skip(2);
        match Arguments::try_parse_from(std::iter::once("grazing").chain(words)) {
            Ok(_) => {}
            Err(error) if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) => {}
            Err(error) => panic!("README.md: `{command}`: {error}"),
        }
    }
}

/// The commands about a file that `new` writes, in the order of the text that shows them; commands
/// that start a server are run with `--help`.
fn about_a_new_file(text: &str) -> String {
    let command = |line: &str| {
        let line = line.trim().split("  ").next()?.split(" #").next()?.trim_end();
        let own = line.starts_with("cargo xtask") && (line.contains("my.toml") || line.contains("merge"));
        let serves = line.contains("explore") || line.contains("report");
        own.then(|| if serves { format!("{line} --help >/dev/null") } else { line.to_owned() })
    };
    text.lines().filter_map(command).collect::<Vec<_>>().join("\n")
}

#[test]
fn commands_work_one_after_the_other_as_they_are_shown() {
    let read = |file: &str| fs::read_to_string(repository().join(file)).expect("it is there");
    let begin = "cargo() { shift; \"$GRAZING\" \"$@\"; }; set -e";
    let new = "cargo xtask new my.toml";
    let shown = [
        about_a_new_file(&read("README.md")),
        about_a_new_file(
            &read("crates/cli/help/new.txt").replace("my.toml --kind", "my-$RANDOM.toml --kind"),
        ),
        format!("{new}\n{}", about_a_new_file(&read("crates/cli/help/unfold.txt"))),
        format!("{new}\n{}", about_a_new_file(&read("crates/cli/help/merge.txt"))),
    ];
    for (shell, commands) in
        ["bash", "zsh"].iter().flat_map(|shell| shown.iter().map(move |text| (shell, text)))
    {
        let folder = empty_folder();
        let run = Command::new(shell)
            .args(["-c", &format!("{begin}\n{commands}")])
            .env("GRAZING", env!("CARGO_BIN_EXE_grazing"))
            .current_dir(folder.path())
            .output();
        let Ok(run) = run else {
            assert_eq!(*shell, "zsh", "bash is wherever this is tested; zsh need not be");
            continue;
        };
        assert!(run.status.success(), "{shell}:\n{commands}\n{}", String::from_utf8_lossy(&run.stderr));
    }
}

#[test]
fn columns_name_equations_that_the_paper_has() {
    let labels = fs::read_to_string(repository().join("expected/labels.txt")).expect("there is a list");
    let labels: Vec<&str> = labels.lines().filter_map(|line| line.split_whitespace().next()).collect();
    let own = outputs::ALL.iter().flat_map(|output| output.tables);
    let mut named = 0;
    let of_oscillators = AlongGrazing::TABLES.iter().chain(AtResonances::TABLES);
    for column in own.chain(of_oscillators).flat_map(|table| table.columns) {
        for label in column.equations.split(", ").filter(|label| !label.is_empty()) {
            assert!(labels.contains(&label), "{}: the paper has no {label}", column.name);
            named += 1;
        }
    }
    assert!(named > 50, "{named}");
}

#[test]
fn the_readme_counts_the_claims() {
    let ledger = Ledger::of_the_paper();
    let [readme, speed] = ["README.md", "docs/speed.md"]
        .map(|file| fs::read_to_string(repository().join(file)).expect("it is there").replace('\n', " "));
    let count = |is: fn(&Claim) -> bool| ledger.claims.iter().filter(|claim| is(claim)).count();
    for words in [
        format!("{} claims.", ledger.claims.len()),
        format!("{} are tested by a check", count(|claim| matches!(claim.test(), Test::Check(_)))),
        format!("{} by comparison with printed", count(|claim| matches!(claim.test(), Test::Published(_)))),
        format!("{} name the functions", count(|claim| !claim.holds.is_empty())),
        format!("{} cannot be tested", count(|claim| matches!(claim.test(), Test::Unchecked(_)))),
    ] {
        assert!(readme.contains(&words), "README.md does not say `{words}`");
    }
    let checks = format!("`claims` with its {} checks", CHECKS.len());
    assert!(speed.contains(&checks), "docs/speed.md does not say `{checks}`");
    let [trust, errors] = ["docs/trust.md", "expected/deliberate_errors.toml"]
        .map(|file| fs::read_to_string(repository().join(file)).expect("it is there"));
    let errors = format!("| {} errors introduced", errors.matches("\n[[error]]\n").count());
    assert!(trust.contains(&errors), "docs/trust.md does not say `{errors}`");
}

#[test]
fn the_readme_shows_every_figure() {
    let readme = fs::read_to_string(repository().join("README.md")).expect("there is a README.md");
    for figure in outputs::ALL.iter().filter(|output| output.is_figure).map(Output::figure_file) {
        assert!(readme.contains(&format!("](figures/{figure})")), "README.md does not show {figure}");
    }
}

/// A number as a text prints it, as `−19.4`, `2.6·10⁻²` or `none`, and half a unit of its last digit.
fn printed(text: &str) -> Option<[f64; 2]> {
    let plain: String = text
        .trim()
        .chars()
        .map(|letter| match "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|raised| raised == letter) {
            Some(digit) => char::from(b'0' + digit as u8),
            None if "−⁻".contains(letter) => '-',
            None => letter,
        })
        .collect();
    if plain == "none" {
        return Some([f64::NAN; 2]);
    }
    let (digits, power) = plain.split_once("·10").unwrap_or((&plain, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let [value, half] = [digits.to_owned(), format!("{}5", "0.".to_owned() + &"0".repeat(decimals))];
    let number = |text: &str| format!("{text}e{power}").parse().ok();
    Some([number(&value)?, number(&half)?])
}

#[test]
fn tables_beyond_the_paper_are_those_that_are_made() {
    let read = |file: &str| fs::read_to_string(repository().join(file)).expect("it is there");
    let (page, mut held) = (read("docs/beyond.md"), 0);
    // Only some rows of the last table, and these columns.
    let tables: [(&str, &str, &[&str]); 4] = [
        ("| p, n of Figure 7 |", "beyond_limits", &[]),
        ("| p, n | σ | 4 impacts |", "beyond_cascade", &[]),
        ("| p | in regions |", "beyond_attractors_regions", &[]),
        (
            "| n | σ | M at SN or PD |",
            "beyond_loops_measured",
            &["n", "sigma", "m_slowest", "m_fastest", "c_slowest", "c_fastest"],
        ),
    ];
    for (heading, file, columns) in tables {
        let made = read(&format!("figures/data/{file}.csv"));
        let (_, table) = page.split_once(heading).unwrap_or_else(|| panic!("there is a table {heading}"));
        let rows: Vec<&str> = table.lines().skip(2).take_while(|line| line.starts_with('|')).collect();
        assert!(!columns.is_empty() || rows.len() == made.lines().count() - 1, "{heading}");
        let places: Vec<usize> = columns
            .iter()
            .map(|name| made.lines().next().and_then(|head| head.split(',').position(|it| it == *name)))
            .map(|place| place.expect("there is such a column"))
            .collect();
        for row in rows {
            let cells: Vec<[f64; 2]> = row.split(['|', ',']).filter_map(printed).collect();
            let number = |cell: &str| if cell.is_empty() { Some(f64::NAN) } else { cell.parse().ok() };
            let is_it = |line: &&str| {
                let all: Vec<&str> = line.split(',').collect();
                let shown = if columns.is_empty() { all } else { places.iter().map(|k| all[*k]).collect() };
                let found: Vec<f64> = shown.into_iter().filter_map(number).collect();
                found.len() == cells.len()
                    && found.iter().zip(&cells).all(|(found, [shown, half])| {
                        (found - shown).abs() <= *half || (found.is_nan() && shown.is_nan())
                    })
            };
            assert_eq!(made.lines().filter(is_it).count(), 1, "{file}.csv does not have the row {row}");
            held += cells.len();
        }
    }
    assert!(held >= 160, "{held}");
}
