//! `grazing unfold` from end to end, in temporary folders.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use crate::program::{folder_with, grazing, listing, narrow_duffing, read, repository, snapshots};

const TABLES: [&str; 9] = [
    "coefficients",
    "curves",
    "grazing",
    "grazing_loops",
    "hypotheses",
    "magnifications",
    "points",
    "regions",
    "straightened",
];

/// The paths in a folder of results.
pub(crate) fn results() -> Vec<String> {
    let tables = TABLES.map(|table| format!("data/{table}.csv"));
    let others = [
        "data",
        "data/README.md",
        "diagram.svg",
        "magnifications.svg",
        "manifest.sha256",
        "report.html",
        "straightened.svg",
    ];
    let mut all = others.map(str::to_owned).to_vec();
    all.extend(tables);
    all.sort();
    all
}

#[test]
fn an_example_is_unfolded_into_the_same_files_whatever_the_number_of_threads() {
    let folder = folder_with(&[("duffing.toml", &narrow_duffing())]);
    let made = grazing(folder.path(), &["unfold", "duffing.toml", "--jobs", "1", "--explain"]);
    assert_eq!((made.code, made.errors()), (Some(0), ""), "{}", made.messages);
    let first = folder.path().join("unfolded/duffing");
    assert_eq!(listing(&first), results());

    let again =
        ["unfold", "duffing.toml", "--jobs", "2", "--output", "again", "--format", "svg,png", "--dpi", "72"];
    let again = grazing(folder.path(), &again);
    assert_eq!(again.code, Some(0), "{}", again.messages);
    for file in results().iter().filter(|file| *file != "data") {
        // The page also lists the pictures, each on its own line.
        let again = read(&folder.path().join("again"), file);
        let again: Vec<&str> = again.lines().filter(|line| !line.contains(".png")).collect();
        if file == "manifest.sha256" {
            // The digests of the page differ, so only the files are counted.
            assert_eq!(read(&first, file).lines().count(), again.len());
            continue;
        }
        assert!(read(&first, file).lines().eq(again), "{file}");
    }
    let picture = fs::read(folder.path().join("again/diagram.png")).expect("PNG was asked for");
    assert!(picture.starts_with(b"\x89PNG"));

    told(&made.output, &read(&first, "data/coefficients.csv"));
    explained(&first);
}

/// Asserts that the terminal shows equation, resonance, coefficients and every hypothesis, and that
/// no line is too wide.
fn told(output: &str, coefficients: &str) {
    let mut rows = coefficients.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let (header, row) = (rows.next().expect("a header"), rows.next().expect("a resonance"));
    assert!(rows.next().is_none(), "there is one resonance in these ranges");
    let cell = |name: &str| row[header.iter().position(|column| *column == name).expect("a column")];
    assert_eq!((cell("p"), cell("n")), ("3", "1"));
    for simulated in ["sn_as_simulated", "pd_as_simulated"] {
        assert_eq!(cell(simulated), "yes");
    }
    for verdict in ["sn_verdict", "pd_verdict"] {
        assert_eq!(cell(verdict), "agree");
    }
    for wanted in [
        "Duffing oscillator with a wall (duffing.toml)",
        "x'' = -2*zeta*v - x - kappa*x^3 - 1 + A*cos(omega*t)",
        "kappa = 0.1, zeta = 0.02",
        "stable throughout",
        "Resonant grazing bifurcations: 1; Theorem 2.4 (p = 1)",
        "theorem 2.5 (resonant grazing, p >= 2) applies",
        "  holds  a12 alpha > 0 ",
        "kappa_p' = ",
        "unfolded/duffing/data/  ",
    ] {
        let joined = output.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(output.contains(wanted) || joined.contains(wanted), "`{wanted}` is missing in\n{output}");
    }
    for (curve, column) in [("SN", "c_sn"), ("PD", "c_pd")] {
        let beginning = format!("  3  1  0.97811     {curve}  ");
        let line = output.lines().find(|line| line.starts_with(&beginning));
        let words: Vec<&str> =
            line.unwrap_or_else(|| panic!("no {curve} in\n{output}")).split_whitespace().collect();
        let [_, _, _, _, theorem, _, digits, simulated] = words[..] else { panic!("{words:?}") };
        let (shown, exact): (f64, f64) = (theorem.parse().unwrap(), cell(column).parse().unwrap());
        // Nine digits are shown.
        assert!((shown / exact - 1.0).abs() < 1e-8, "{shown} {exact}");
        // Every example promises five.
        assert!(digits.parse::<u32>().unwrap() >= 5 && simulated == "yes", "{words:?}");
    }
    for line in output.lines() {
        assert!(line.chars().count() <= 80, "{} characters: {line}", line.chars().count());
    }
}

/// An oscillator with a one-parameter diagram along either parameter, unfolded once for all tests: what the program
/// said, and the files.
static DIAGRAMS: LazyLock<(String, BTreeMap<String, Vec<u8>>)> = LazyLock::new(|| {
    let diagrams = "[[diagrams]]\nfixed = \"omega\"\nat = 0.98\nportraits = [0.29]\n[[diagrams]]\nfixed = \"A\"\nat = 0.3\n";
    let folder = folder_with(&[("duffing.toml", &(narrow_duffing() + diagrams))]);
    let made = grazing(folder.path(), &["unfold", "duffing.toml"]);
    assert_eq!((made.code, made.errors()), (Some(0), ""), "{}", made.messages);
    let results = folder.path().join("unfolded/duffing");
    let files = listing(&results).into_iter().filter(|path| results.join(path).is_file());
    let read = |path: String| (path.clone(), fs::read(results.join(path)).expect("it is there"));
    (made.output, files.map(read).collect())
});

/// A file of these results as text.
fn of_diagrams(path: &str) -> &'static str {
    let content = DIAGRAMS.1.get(path).unwrap_or_else(|| panic!("there is no {path}"));
    core::str::from_utf8(content).expect("it is text")
}

#[test]
fn a_one_parameter_diagram_has_a_figure_and_tables_as_long_as_it_is_asked_for() {
    let (output, files) = &*DIAGRAMS;
    assert!(output.contains("\nOne-parameter diagram 1: A from 0.2 to 0.4 at omega = 0.98\n"));
    let folder = folder_with(&[("duffing.toml", &narrow_duffing())]);
    let results_folder = folder.path().join("unfolded/duffing");
    fs::create_dir_all(results_folder.join("data")).expect("the folder is ours");
    for (path, content) in files {
        fs::write(results_folder.join(path), content).expect("the folder is ours");
    }
    let tables = ["attractor", "bifurcations", "branches", "portraits"];
    let more = tables.map(|table| format!("data/diagram_{table}.csv"));
    let figures = ["diagram-1.svg", "diagram-2.svg"].map(str::to_owned);
    let mut all = [results(), more.to_vec(), figures.to_vec()].concat();
    all.sort();
    assert_eq!(listing(&results_folder), all);
    let explanations = of_diagrams("data/README.md");
    let page = read(&repository(), "docs/unfold.md");
    for table in tables {
        assert!(page.contains(&format!("| `diagram_{table}` |")), "{table} is not named");
        let content = of_diagrams(&format!("data/diagram_{table}.csv"));
        for column in content.lines().next().expect("a header").split(',') {
            assert!(explanations.contains(&format!("| `{column}` |")), "{table}: {column} is not explained");
        }
    }
    assert!(of_diagrams("report.html").contains("id=\"oscillator-duffing-diagram-1\""));
    assert_eq!(grazing(folder.path(), &["unfold", "duffing.toml"]).code, Some(0));
    assert_eq!(listing(&results_folder), results());
}

#[test]
fn a_one_parameter_diagram_lists_and_draws_what_its_tables_hold_whichever_parameter_is_held() {
    let table = of_diagrams("data/diagram_bifurcations.csv");
    let mut rows = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    assert_eq!(
        rows.next().expect("a header"),
        ["diagram", "kind", "p", "impacts", "omega", "A", "impact_velocity", "x"]
    );
    let rows: Vec<Vec<&str>> = rows.collect();
    for (number, across, column) in [("1", "A", 5), ("2", "omega", 4)] {
        let head = format!("\nOne-parameter diagram {number}: {across} from ");
        let (_, listed) = DIAGRAMS.0.split_once(&head).unwrap_or_else(|| panic!("{head}: {}", DIAGRAMS.0));
        let words: Vec<Vec<&str>> =
            listed.lines().skip(1).map(|line| line.split_whitespace().collect()).collect();
        assert_eq!(words[0], ["kind", "p", across, "impact", "velocity", "x"]);
        let own: Vec<_> = rows.iter().filter(|row| row[0] == number).collect();
        assert!(own.len() > 1, "{table}");
        for (row, words) in own.iter().zip(&words[1..]) {
            assert_eq!(row[1..3], words[..2]);
            let [shown, exact] = [words[2], row[column]].map(|cell| cell.parse::<f64>().expect("a number"));
            assert!((shown / exact - 1.0).abs() < 1e-7, "{shown} and not {exact}");
        }
        let figure = of_diagrams(&format!("diagram-{number}.svg"));
        assert!(figure.contains(&format!("data-columns=\"{across} x\"")), "{across}");
    }
}

/// The page beside the tables explains their columns, that of the book names the tables, and those of
/// the examples name the examples.
fn explained(results: &Path) {
    let explanations = read(results, "data/README.md");
    let page = read(&repository(), "docs/unfold.md");
    for table in TABLES {
        assert!(page.contains(&format!("| `{table}` |")), "{table} is not named");
        let content = read(results, &format!("data/{table}.csv"));
        for column in content.lines().next().expect("a header").split(',') {
            assert!(explanations.contains(&format!("| `{column}` |")), "{table}: {column} is not explained");
        }
    }
    let pages = ["docs/examples.md", "examples/README.md"].map(|file| (file, read(&repository(), file)));
    for entry in fs::read_dir(repository().join("examples")).expect("there are examples") {
        let name = entry.expect("they can be read").file_name().to_string_lossy().into_owned();
        for (file, page) in pages.iter().filter(|_| name.ends_with(".toml")) {
            assert!(page.contains(&format!("| `{name}` |")), "{name} is not in {file}");
        }
    }
}

/// A description of an oscillator with this force.
fn described(force: &str, primary: &str, secondary: &str) -> String {
    format!(
        "name = \"Oscillator\"\n[parameters]\n[primary]\nname = \"F0\"\nrange = {primary}\n[secondary]\nname = \"omega\"\n\
         range = {secondary}\n[motion]\nforce = \"{force}\"\nfrequency = \"omega\"\n[impact]\nrestitution = \"0.8\"\n\
         duration = \"0\"\n[analysis]\nloops = [1]\n"
    )
}

const LINEAR: &str = "-0.2*v - x - 1 + F0*cos(omega*t)";

/// Oscillators that cannot be unfolded: the reason, the force and the ranges.
const NOTHING: [(&str, &str, &str, &str); 8] = [
    ("never reaches the wall", LINEAR, "[0.0, 0.1]", "[0.5, 0.7]"),
    ("always passes the wall", LINEAR, "[5.0, 6.0]", "[0.5, 0.7]"),
    ("rests beyond the wall", "-0.2*v - x + 1 + F0*cos(omega*t)", "[0.0, 0.5]", "[1.5, 2.0]"),
    ("runs away", "-0.2*v + x + 10 + F0*cos(omega*t)", "[0.0, 0.5]", "[0.5, 0.7]"),
    ("leaves the domain", "-0.2*v - sqrt(x + 0.9) - 1 + F0*cos(omega*t)", "[0.0, 0.5]", "[0.5, 0.7]"),
    ("drifts for ever", "-0.2*v - 0.1 + 0.01*sin(x) + F0*cos(omega*t)", "[0.0, 0.5]", "[0.5, 0.7]"),
    ("bounces", "-0.2*v - 1 + F0*cos(omega*t)", "[0.0, 0.5]", "[0.5, 0.7]"),
    ("is not turned back", "-0.2*v - x + F0 + 0*cos(omega*t)", "[-0.5, 0.6]", "[0.5, 0.7]"),
];

#[test]
fn an_oscillator_without_grazing_is_told_what_was_seen_and_what_can_be_done() {
    let mut transcript = String::new();
    for (what, force, primary, secondary) in NOTHING {
        let folder = folder_with(&[("o.toml", &described(force, primary, secondary))]);
        let outcome = grazing(folder.path(), &["unfold", "o.toml"]);
        assert_eq!(outcome.code, Some(3), "{what}: {}", outcome.messages);
        assert_eq!(listing(folder.path()), ["o.toml"], "{what}: nothing is written");
        transcript.push_str(&format!("{what}: {force}\n{}\n", outcome.errors()));
    }
    snapshots().bind(|| insta::assert_snapshot!("messages_for_nothing_to_unfold", transcript));
}

#[test]
fn a_window_that_is_much_too_wide_is_told_with_one_that_is_not() {
    let folder = folder_with(&[("o.toml", &described(LINEAR, "[0.0, 50.0]", "[0.5, 1.3]"))]);
    let wide = grazing(folder.path(), &["unfold", "o.toml"]);
    assert_eq!(wide.code, Some(0), "{}", wide.messages);
    let (_, told) = wide.output.split_once("\nRanges\n").expect("it is far too wide");
    let settings: Vec<&str> = told.split_whitespace().filter(|word| word.contains(".range=")).collect();
    let [primary, secondary] = settings[..] else { panic!("{told}") };
    assert_eq!(secondary, "secondary.range=[0.5,1.3]");
    let run = grazing(folder.path(), &["unfold", "o.toml", "--set", primary, "--set", secondary]);
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert!(!run.output.contains("\nRanges\n"), "{}", run.output);
}

#[test]
fn of_several_files_those_that_can_be_are_unfolded() {
    let without = described(LINEAR, "[0.0, 0.1]", "[0.5, 0.7]");
    let without_resonance = described(LINEAR, "[0.5, 1.0]", "[0.7, 0.75]");
    let folder = folder_with(&[("a.toml", &without), ("b.toml", &without_resonance)]);
    let outcome = grazing(folder.path(), &["unfold", "a.toml", "b.toml", "--output", "out"]);
    assert_eq!(outcome.code, Some(3), "{}", outcome.messages);
    assert!(outcome.messages.contains("error: a.toml: no grazing: "), "{}", outcome.messages);
    assert!(outcome.messages.ends_with("error: 1 of 2 files failed, see above\n"), "{}", outcome.messages);
    assert!(outcome.output.contains("none on the grazing curve for p = 1\n"), "{}", outcome.output);
    assert!(folder.path().join("out/b/diagram.svg").is_file());
    assert!(!folder.path().join("out/a").exists());
    let points = read(folder.path(), "out/b/data/points.csv");
    assert_eq!(points, "kind,p,n,omega,F0\n", "no resonance, no point");
}
