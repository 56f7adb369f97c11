//! README and the book in docs/: their commands, links, counts and tables are those of the program.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::program::{empty_folder, repository};
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser};
use grazing_claims::checks::CHECKS;
use grazing_claims::errata;
use grazing_claims::ledger::{Claim, Ledger, Test};
use grazing_claims::published::{Published, Rounding};
use grazing_cli::arguments::Arguments;
use grazing_cli::outputs::{self, Output};
use grazing_results::Tables;
use grazing_results::grazing::AlongGrazing;
use grazing_results::resonance::AtResonances;

/// The most bytes of the README, which is to be one page.
const README_BYTES: usize = 6_000;
/// The list of the book's pages.
const SUMMARY: &str = "docs/SUMMARY.md";
/// Pages outside the book.
const OTHERS: [&str; 7] = [
    "README.md",
    "ARCHITECTURE.md",
    "examples/README.md",
    "examples/workflow/README.md",
    "expected/certificate/README.md",
    "figures/data/README.md",
    "packaging/python/README.md",
];

fn read(file: &str) -> String {
    fs::read_to_string(repository().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// The pages of the book.
fn book() -> Vec<String> {
    let entries = fs::read_dir(repository().join("docs")).expect("there is a folder docs/");
    let names =
        entries.map(|entry| entry.expect("it can be read").file_name().to_string_lossy().into_owned());
    let mut pages: Vec<String> =
        names.filter(|name| name.ends_with(".md")).map(|name| format!("docs/{name}")).collect();
    pages.sort();
    assert!(pages.len() > 20, "{pages:?}");
    pages
}

/// All pages, each with its path from the root.
fn pages() -> Vec<(String, String)> {
    let others = OTHERS.map(str::to_owned);
    book().into_iter().chain(others).map(|file| (file.clone(), read(&file))).collect()
}

/// A page in two: what is outside of blocks between fences, and the lines of blocks of commands, of which
/// those that go on after a backslash are one.
fn parted(file: &str, text: &str) -> (String, Vec<String>) {
    let (mut prose, mut commands, mut block) = (String::new(), String::new(), None);
    for line in text.lines() {
        match (line.strip_prefix("```"), block) {
            (Some(language), None) => block = Some(language),
            (Some(_), Some(_)) => block = None,
            (None, Some("sh")) => commands.push_str(&format!("{line}\n")),
            (None, Some(_)) => {}
            (None, None) => prose.push_str(&format!("{line}\n")),
        }
    }
    assert!(block.is_none(), "{file}: a block has no end");
    (prose, commands.replace("\\\n", " ").lines().map(|line| line.trim().to_owned()).collect())
}

/// What stands between backticks in a page, and what does not.
fn spans(file: &str, prose: &str) -> [Vec<String>; 2] {
    let pieces: Vec<String> = prose.split('`').map(|piece| piece.replace('\n', " ")).collect();
    assert!(pieces.len() % 2 == 1, "{file}: a backtick has no other");
    let every = |from: usize| pieces.iter().skip(from).step_by(2).cloned().collect();
    [every(1), every(0)]
}

fn is_command(text: &str) -> bool {
    ["cargo xtask ", "grazing "].iter().any(|begin| text.starts_with(begin))
}

/// What clap says of a command line of the program.
fn parse(command: &str) -> Result<(), clap::Error> {
    let plain = command.replace('\'', "");
    // Without a remark, and without the file that a shell writes.
    let words = [" #", " >"].iter().fold(&*plain, |line, end| line.split(end).next().unwrap_or_default());
    let words = words.split_whitespace();
    let words = words.skip(if command.starts_with("cargo") { 2 } else { 1 });
    Arguments::try_parse_from(std::iter::once("grazing").chain(words)).map(|_| ())
}

#[test]
fn the_readme_shows_all_commands() {
    let (_, commands) = parted("README.md", &read("README.md"));
    for wanted in [
        "cargo xtask reproduce",
        "cargo test --workspace",
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
    let page = read("docs/command-line.md");
    for command in Arguments::command().get_subcommands() {
        let row = format!("| `{}` | ", command.get_name());
        assert!(page.contains(&row), "docs/command-line.md has no row {row}");
    }
}

#[test]
fn the_readme_is_one_page() {
    let bytes = read("README.md").len();
    assert!(bytes <= README_BYTES, "README.md has {bytes} bytes, more than {README_BYTES}");
}

#[test]
fn the_summary_lists_every_page_of_the_book() {
    let summary = read(SUMMARY);
    let listed: Vec<String> =
        links(SUMMARY, &summary).into_iter().map(|target| format!("docs/{target}")).collect();
    let once: BTreeSet<&String> = listed.iter().collect();
    assert_eq!(once.len(), listed.len(), "a page stands twice in {SUMMARY}");
    let pages = book();
    for page in pages.iter().filter(|page| *page != SUMMARY) {
        assert!(once.contains(page), "{page} is not in {SUMMARY}");
    }
    assert!(listed.iter().all(|page| pages.contains(page)), "{SUMMARY} lists what is no page");
}

/// The targets of the links and pictures of a page, without those in code.
fn links(file: &str, text: &str) -> Vec<String> {
    let [_, prose] = spans(file, &parted(file, text).0);
    // Code is part of the text of a link, never of its target.
    let prose = prose.concat();
    let targets = prose.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    targets.map(str::to_owned).collect()
}

/// The anchors of a page: its headings as forges and mdBook name them.
fn anchors(file: &str, text: &str) -> Vec<String> {
    let (prose, _) = parted(file, text);
    let headings = prose.lines().filter(|line| line.starts_with('#'));
    let named = headings.map(|line| line.trim_start_matches('#').trim().to_lowercase());
    named
        .map(|heading| {
            heading
                .chars()
                .filter(|letter| letter.is_alphanumeric() || " -_".contains(*letter))
                .map(|letter| if letter == ' ' { '-' } else { letter })
                .collect()
        })
        .collect()
}

#[test]
fn every_link_leads_somewhere() {
    let mut followed = 0;
    for (file, text) in pages() {
        for target in links(&file, &text) {
            if target.starts_with("https://") || target.starts_with("http://") {
                continue;
            }
            let (path, anchor) = target.split_once('#').unwrap_or((&target, ""));
            let folder = Path::new(&file).parent().expect("it is a file");
            let to =
                if path.is_empty() { repository().join(&file) } else { repository().join(folder).join(path) };
            assert!(to.is_file(), "{file}: there is no {target}");
            if !anchor.is_empty() {
                let there = fs::read_to_string(&to).expect("it is a page");
                assert!(
                    anchors(&target, &there).iter().any(|it| it == anchor),
                    "{file}: there is no {target}"
                );
            }
            followed += 1;
        }
    }
    assert!(followed > 200, "{followed}");
}

#[test]
fn the_oscillator_of_the_book_is_that_of_the_example() {
    let [page, example] = ["docs/oscillator.md", "examples/duffing.toml"].map(read);
    let (_, rest) = page.split_once("```toml\n").expect("there is an oscillator");
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
    let (mut shown, mut named) = (0, 0);
    for (file, text) in pages() {
        let (prose, commands) = parted(&file, &text);
        for command in commands.iter().filter(|command| is_command(command)) {
            parse(command).unwrap_or_else(|error| panic!("{file}: `{command}`: {error}"));
            shown += 1;
        }
        // In the text a command may be named without its arguments, or as a pattern.
        let [spans, _] = spans(&file, &prose);
        for command in spans.iter().filter(|span| is_command(span)) {
            if command.contains("COMMAND") || command.contains("...") {
                continue;
            }
            match parse(command) {
                Err(error) if error.kind() != ErrorKind::MissingRequiredArgument => {
                    panic!("{file}: `{command}`: {error}")
                }
                _ => named += 1,
            }
        }
    }
    assert!(shown > 50 && named > 20, "{shown}, {named}");
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

/// The commands of README, the book and the help texts about a new file, each set from an empty folder.
fn sets_of_commands() -> [String; 4] {
    let new = "cargo xtask new my.toml";
    // Some of the README's are those of the book.
    let own = [read("README.md"), read("docs/oscillator.md")].concat();
    let mut once = BTreeSet::new();
    let own: Vec<&str> = own.lines().filter(|line| once.insert(about_a_new_file(line))).collect();
    [
        about_a_new_file(&own.join("\n")),
        about_a_new_file(
            &read("crates/cli/help/new.txt").replace("my.toml --kind", "my-$RANDOM.toml --kind"),
        ),
        format!("{new}\n{}", about_a_new_file(&read("crates/cli/help/unfold.txt"))),
        format!("{new}\n{}", about_a_new_file(&read("crates/cli/help/merge.txt"))),
    ]
}

/// What a shell prints that runs commands in an empty folder, after a definition of `cargo`; nothing if there is no such
/// shell.
fn shell(name: &str, cargo: &str, commands: &str) -> Option<String> {
    let folder = empty_folder();
    let run = Command::new(name)
        .args(["-c", &format!("{cargo}; set -e\n{commands}")])
        .env("GRAZING", env!("CARGO_BIN_EXE_grazing"))
        .current_dir(folder.path())
        .output();
    let Ok(run) = run else {
        assert_eq!(name, "zsh", "bash is wherever this is tested; zsh need not be");
        return None;
    };
    assert!(run.status.success(), "{name}:\n{commands}\n{}", String::from_utf8_lossy(&run.stderr));
    Some(String::from_utf8(run.stdout).expect("it is text"))
}

/// One loop is enough for a command that says nothing else, and so is a part of the range.
#[test]
fn commands_work_one_after_the_other_as_they_are_shown() {
    let cargo = r#"cargo() {
        shift
        case "$*" in
            unfold*--loops* | *--help*) "$GRAZING" "$@" ;;
            unfold*) "$GRAZING" "$@" --loops 1 ;;
            *) "$GRAZING" "$@" ;;
        esac
        if [ "$1" = new ] && [ "$2" = my.toml ]; then
            sed -i.old '/^\[secondary\]/,/^\[/s/^range = .*/range = [0.7, 1.0]/' my.toml
            ! cmp -s my.toml my.toml.old
            rm my.toml.old
        fi
    }"#;
    for commands in sets_of_commands() {
        shell("bash", cargo, &commands);
    }
}

/// The quotes in the commands mean the same to every shell.
#[test]
fn every_shell_reads_the_same_arguments() {
    let cargo = r#"cargo() { for argument in "$@"; do printf '[%s]' "$argument"; done; echo; }; RANDOM=1; setopt nonomatch 2>/dev/null || true"#;
    for commands in sets_of_commands() {
        let commands = commands.replace("$RANDOM", "1").replace(" >/dev/null", "");
        let [bash, zsh] = ["bash", "zsh"].map(|name| shell(name, cargo, &commands));
        assert!(zsh.is_none() || zsh == bash, "{bash:?}\n{zsh:?}");
        assert!(bash.is_some_and(|text| text.lines().count() == commands.lines().count()));
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
fn the_book_counts_the_claims() {
    let ledger = Ledger::of_the_paper();
    let [paper, speed] = ["docs/paper.md", "docs/speed.md"].map(|file| read(file).replace('\n', " "));
    let count = |is: fn(&Claim) -> bool| ledger.claims.iter().filter(|claim| is(claim)).count();
    for words in [
        format!("{} claims.", ledger.claims.len()),
        format!("{} are tested by a check", count(|claim| matches!(claim.test(), Test::Check(_)))),
        format!("{} by comparison with printed", count(|claim| matches!(claim.test(), Test::Published(_)))),
        format!("{} give parameters", count(|claim| matches!(claim.test(), Test::Given(_)))),
        format!("The {} [errata]", errata::count(&ledger.claims)),
        format!("{} name the functions", count(|claim| !claim.holds.is_empty())),
        format!("{} cannot be tested", count(|claim| matches!(claim.test(), Test::Unchecked(_)))),
    ] {
        assert!(paper.contains(&words), "docs/paper.md does not say `{words}`");
    }
    let checks = format!("`claims` with its {} checks", CHECKS.len());
    assert!(speed.contains(&checks), "docs/speed.md does not say `{checks}`");
    let [validation, errors] = ["docs/validation.md", "expected/deliberate_errors.toml"].map(read);
    let errors = format!("| mutation tests: {} errors introduced", errors.matches("\n[[error]]\n").count());
    assert!(validation.contains(&errors), "docs/validation.md does not say `{errors}`");
}

/// README.md and docs/ERRATA.md are written by commands, which need not have been run.
#[test]
fn written_pages_count_as_the_ledger_does() {
    let ledger = Ledger::of_the_paper();
    let errata = errata::count(&ledger.claims);
    let (readme, page) = (read("README.md").replace('\n', " "), read("docs/ERRATA.md"));
    let count = |is: fn(&Claim) -> bool| ledger.claims.iter().filter(|claim| is(claim)).count();
    for words in [
        format!("makes {} claims", ledger.claims.len()),
        format!("{} are tested by a check", count(|claim| matches!(claim.test(), Test::Check(_)))),
        format!("{} by comparison with printed", count(|claim| matches!(claim.test(), Test::Published(_)))),
        format!("{} give parameters", count(|claim| matches!(claim.test(), Test::Given(_)))),
        format!("{} cannot be tested", count(|claim| matches!(claim.test(), Test::Unchecked(_)))),
        format!("[{errata} errata](docs/ERRATA.md)"),
    ] {
        assert!(readme.contains(&words), "README.md does not say `{words}`: run `cargo xtask reproduce`");
    }
    assert_eq!(page.matches("\n### ").count(), errata, "run `cargo xtask claims --write-errata`");
}

#[test]
fn pages_count_examples_and_published_values() {
    let examples = fs::read_dir(repository().join("examples")).expect("there are examples");
    let files = examples.filter_map(|entry| Some(entry.ok()?.path()));
    let examples = files.filter(|path| path.extension().is_some_and(|kind| kind == "toml")).count();
    let words = ["sixteen", "seventeen", "eighteen", "nineteen", "twenty", "twenty-one", "twenty-two"];
    let word = examples.checked_sub(16).and_then(|k| words.get(k)).expect("a word for the number");
    assert!(read("README.md").contains(&format!("[{word} examples]")), "README.md does not say `{word}`");
    let values = &Published::printed().values;
    let parameters = values.iter().filter(|value| value.rounding == Rounding::Exact).count();
    let [all, computed] = [values.len(), values.len() - parameters];
    let words =
        [format!("the {all} numbers"), format!("{computed} are computed, {parameters} are parameters")];
    let paper = read("docs/paper.md").replace('\n', " ");
    for words in words {
        assert!(paper.contains(&words), "docs/paper.md does not say `{words}`");
    }
}

#[test]
fn the_book_shows_every_figure() {
    let book: Vec<String> = book().iter().map(|page| read(page)).collect();
    for figure in outputs::ALL.iter().filter(|output| output.is_figure).map(Output::figure_file) {
        let picture = format!("](../figures/{figure})");
        assert!(book.iter().any(|page| page.contains(&picture)), "no page of docs/ shows {figure}");
    }
    assert!(read("README.md").contains("](figures/fig07.svg)"), "README.md does not show Figure 7");
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
    let (page, mut held) = (read("docs/beyond.md"), 0);
    // Only some rows of the last two tables, and these columns.
    let tables: [(&str, &str, &[&str]); 5] = [
        ("| p, n of Figure 7 |", "beyond_limits", &[]),
        ("| p, n | σ | 4 impacts |", "beyond_cascade", &[]),
        ("| p | in regions |", "beyond_attractors_regions", &[]),
        (
            "| n | σ | M at SN or PD |",
            "beyond_loops_measured",
            &["n", "sigma", "m_slowest", "m_fastest", "c_slowest", "c_fastest"],
        ),
        (
            "| p, n of the MPS |",
            "beyond_generations",
            &["base_p", "base_n", "q", "omega", "amplitude", "impacts", "periods", "c_sn", "c_pd"],
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
