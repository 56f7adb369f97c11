//! `grazing unfold` from end to end, in temporary folders.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
#[cfg(unix)]
use std::{thread, time::Duration};

use crate::program::{
    empty_folder, grazing, interruptible, listing, narrow_duffing, repository, snapshots, watched,
};
use grazing_description::Description;
use tempfile::TempDir;

/// A folder with files.
fn folder_with(files: &[(&str, &str)]) -> TempDir {
    let folder = empty_folder();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).expect("the folder is ours");
    }
    folder
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

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
fn results() -> Vec<String> {
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

#[test]
fn a_one_parameter_diagram_has_a_figure_and_tables_as_long_as_it_is_asked_for() {
    let diagram = "[[diagrams]]\nfixed = \"omega\"\nat = 0.98\nportraits = [0.29]\n";
    let folder = folder_with(&[("duffing.toml", &(narrow_duffing() + diagram))]);
    let made = grazing(folder.path(), &["unfold", "duffing.toml"]);
    assert_eq!((made.code, made.errors()), (Some(0), ""), "{}", made.messages);
    assert!(made.output.contains("\nOne-parameter diagram 1: A from 0.2 to 0.4 at omega = 0.98\n"));
    let results_folder = folder.path().join("unfolded/duffing");
    let tables = ["attractor", "bifurcations", "branches", "portraits"];
    let more = tables.map(|table| format!("data/diagram_{table}.csv"));
    let mut all = [results(), more.to_vec(), vec!["diagram-1.svg".to_owned()]].concat();
    all.sort();
    assert_eq!(listing(&results_folder), all);
    let explanations = read(&results_folder, "data/README.md");
    let page = read(&repository(), "docs/unfold.md");
    for table in tables {
        assert!(page.contains(&format!("| `diagram_{table}` |")), "{table} is not named");
        let content = read(&results_folder, &format!("data/diagram_{table}.csv"));
        for column in content.lines().next().expect("a header").split(',') {
            assert!(explanations.contains(&format!("| `{column}` |")), "{table}: {column} is not explained");
        }
    }
    assert!(read(&results_folder, "report.html").contains("id=\"oscillator-duffing-diagram-1\""));
    fs::write(folder.path().join("duffing.toml"), narrow_duffing()).expect("the folder is ours");
    assert_eq!(grazing(folder.path(), &["unfold", "duffing.toml"]).code, Some(0));
    assert_eq!(listing(&results_folder), results());
}

#[test]
fn a_one_parameter_diagram_lists_and_draws_what_its_tables_hold_whichever_parameter_is_held() {
    let diagrams = "[[diagrams]]\nfixed = \"omega\"\nat = 0.98\n[[diagrams]]\nfixed = \"A\"\nat = 0.3\n";
    let folder = folder_with(&[("duffing.toml", &(narrow_duffing() + diagrams))]);
    let made = grazing(folder.path(), &["unfold", "duffing.toml"]);
    assert_eq!((made.code, made.errors()), (Some(0), ""), "{}", made.messages);
    let results_folder = folder.path().join("unfolded/duffing");
    let table = read(&results_folder, "data/diagram_bifurcations.csv");
    let mut rows = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    assert_eq!(
        rows.next().expect("a header"),
        ["diagram", "kind", "p", "omega", "A", "impact_velocity", "x"]
    );
    let rows: Vec<Vec<&str>> = rows.collect();
    for (number, across, column) in [("1", "A", 4), ("2", "omega", 3)] {
        let head = format!("\nOne-parameter diagram {number}: {across} from ");
        let (_, listed) = made.output.split_once(&head).unwrap_or_else(|| panic!("{head}: {}", made.output));
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
        let figure = read(&results_folder, &format!("diagram-{number}.svg"));
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

/// Waits until a running program has done something.
pub(crate) fn wait_until(run: &mut Child, what: &str, is_done: impl Fn() -> bool) {
    let ended = |run: &mut Child| run.try_wait().expect("it is ours").is_some();
    let seen = watched(run, |run| if is_done() { Some(true) } else { ended(run).then_some(false) });
    assert_eq!(seen, Some(true), "it ended before, or never did: {what}");
}

/// One-parameter diagrams that take so long that a run is interrupted before their end, however
/// late the signal arrives.
fn many_diagrams(values: [f64; 2]) -> String {
    let [from, to] = values;
    let last = Description::MOST_DIAGRAMS as u32 - 1;
    let at = |index: u32| from + f64::from(index) / f64::from(last) * (to - from);
    let diagram = |index| format!("[[diagrams]]\nfixed = \"omega\"\nat = {}\n", at(index));
    (0..=last).map(diagram).collect()
}

#[test]
fn an_interrupted_run_keeps_the_curves_that_were_finished_and_the_next_says_so() {
    let long = narrow_duffing() + &many_diagrams([0.96, 0.99]);
    let folder = folder_with(&[("duffing.toml", &long)]);
    let kept = folder.path().join("unfolded/duffing/data/curves.unfinished.csv");
    let mut run = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .args(["unfold", "duffing.toml"])
        .current_dir(folder.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let kinds = ["\ngraz,", "\nSN,3,1,", "\nPD,3,1,"];
    wait_until(&mut run, "curves are finished", || {
        let curves = fs::read_to_string(&kept).unwrap_or_default();
        kinds.iter().all(|kind| curves.contains(kind))
    });
    run.kill().expect("it still runs");
    run.wait().expect("it ends");
    assert_eq!(listing(&folder.path().join("unfolded/duffing")), ["data", "data/curves.unfinished.csv"]);
    let finished = fs::read_to_string(&kept).expect("it is whole");

    fs::write(folder.path().join("duffing.toml"), narrow_duffing()).expect("the folder is ours");
    let next = grazing(folder.path(), &["unfold", "duffing.toml"]);
    assert_eq!(next.code, Some(0), "{}", next.messages);
    let said = "unfolded/duffing/data/curves.unfinished.csv: finished curves of an interrupted run;";
    assert!(next.messages.starts_with(said), "{}", next.messages);
    assert_eq!(listing(&folder.path().join("unfolded/duffing")), results());
    let whole = read(folder.path(), "unfolded/duffing/data/curves.csv");
    assert!(
        whole.starts_with(&finished),
        "curves that were kept come first, with the same columns and numbers"
    );
}

#[test]
fn what_is_finished_when_a_limit_is_met_is_written_and_the_rest_is_named() {
    let folder = folder_with(&[("duffing.toml", &narrow_duffing())]);
    let steps = |limit: &str, output: &str| {
        grazing(folder.path(), &["unfold", "duffing.toml", "--step-limit", limit, "--output", output])
    };
    // A one-parameter diagram comes last.
    let diagram = "[[diagrams]]\nfixed = \"A\"\nat = 0.3\n";
    fs::write(folder.path().join("more.toml"), narrow_duffing() + diagram).expect("the folder is ours");
    let more = ["unfold", "more.toml", "--step-limit", "2e6", "--output", "more"];
    let more = grazing(folder.path(), &more);
    assert_eq!(more.code, Some(3), "{}", more.messages);
    assert!(more.output.contains("one-parameter diagram 1\n"), "{}", more.output);
    // So few that no grazing is found, and so many that nothing is cut off.
    let none = steps("1000", "none");
    assert_eq!(none.code, Some(3), "{}", none.messages);
    let told = "error: duffing.toml: the limit of 1000 integration steps was reached (";
    assert!(none.errors().starts_with(told), "{}", none.errors());
    assert!(none.errors().contains("in the stage `motion without impacts`"), "{}", none.errors());
    assert!(!folder.path().join("none").exists());
    let whole = steps("1e10", "whole");
    assert_eq!((whole.code, whole.errors()), (Some(0), ""));
    let of_whole = || {
        results()
            .into_iter()
            .filter(|file| file != "data")
            .map(|file| {
                let content = read(&folder.path().join("whole"), &file);
                (file, content)
            })
            .collect::<Vec<_>>()
    };
    let before = of_whole();

    // In between there are limits at which there are curves and something is missing.
    let mut limit = 10_000.0;
    let part = loop {
        limit *= 1.1;
        assert!(limit < 1e10, "nothing is ever written in part");
        let part = steps(&format!("{limit}"), "part");
        if folder.path().join("part").exists() {
            break part;
        }
    };
    assert_eq!(part.code, Some(3), "{}", part.messages);
    // In a folder that holds complete results, the output goes into a subfolder.
    let beside = steps(&format!("{limit}"), "whole");
    assert_eq!(beside.code, Some(3), "{}", beside.messages);
    let told = "whole: the results there are kept; the finished part of this run goes to whole/unfinished\n";
    assert!(beside.messages.contains(told), "{}", beside.messages);
    assert!(of_whole() == before && folder.path().join("whole/unfinished/diagram.svg").is_file());
    assert!(part.errors().contains("; the unfinished parts are named above; everything else is written\n"));
    let (_, missing) = part.output.split_once("\nNot finished\n").expect("something is missing");
    assert!(missing.lines().next().is_some_and(|line| !line.trim().is_empty()), "{missing}");
    // What was not looked for to the end is not said to be missing.
    assert!(part.output.contains("the search was not finished for p = "), "{}", part.output);
    assert!(listing(&folder.path().join("part")).contains(&"diagram.svg".to_owned()));
    let [written, all] = ["part", "whole"].map(|run| read(&folder.path().join(run), "data/grazing.csv"));
    // The curve itself may be cut off.
    assert!(written.lines().count() > 1);
    for row in written.lines() {
        assert!(all.lines().any(|other| other == row), "a whole run does not write {row}");
    }
    let page = read(&folder.path().join("part"), "report.html");
    assert!(page.contains("not finished: "), "the page says so");
    // Regions that were not decided in time are not left white.
    let regions = read(&folder.path().join("part"), "data/regions.csv");
    assert!(missing.contains("regions") && regions.contains(",undecided,3,"), "{regions}");
}

#[cfg(unix)]
/// A wall whose position is a product of this many cosines: a page of text, and hours of work.
fn heavy_wall(factors: u32) -> String {
    let product: Vec<String> = (1..=factors).map(|k| format!("cos({k}*omega*t)")).collect();
    let text = fs::read_to_string(repository().join("examples/duffing.toml")).expect("it is there");
    text.replace("[impact]", &format!("[wall]\nposition = \"1e-3*{}\"\n[impact]", product.join("*")))
}

#[cfg(unix)]
#[test]
fn a_limit_of_time_binds_reading_checking_and_analysis_whatever_the_file() {
    let folder = folder_with(&[("some.toml", &heavy_wall(300)), ("many.toml", &heavy_wall(3000))]);
    for (file, limit) in [("some.toml", "0.5"), ("many.toml", "0.5"), ("many.toml", "4")] {
        // The system ends a process that takes more CPU time; the time of starting, and of noticing
        // the limit, is a small part of it.
        let command = "ulimit -t 12; exec \"$0\" \"$@\"";
        let run = Command::new("sh")
            .args(["-c", command, env!("CARGO_BIN_EXE_grazing"), "unfold", file, "--time-limit", limit])
            .current_dir(folder.path())
            .output()
            .expect("there is a shell");
        let told = String::from_utf8_lossy(&run.stderr);
        assert_eq!(run.status.code(), Some(3), "{file} {limit}: {told}");
        assert!(told.contains(&format!("the time limit of {limit} s of CPU time was reached")), "{told}");
    }
}

#[test]
fn an_analysis_that_is_asked_to_end_ends_with_what_it_has() {
    let paper = fs::read_to_string(repository().join("examples/paper.toml")).expect("it is there");
    let paper = paper + &many_diagrams([0.7, 0.9]);
    let folder = folder_with(&[("paper.toml", &paper)]);
    let messages = folder.path().join("messages");
    let mut run = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .args(["unfold", "paper.toml"])
        .current_dir(folder.path())
        .stdout(Stdio::null())
        .stderr(fs::File::create(&messages).expect("the folder is ours"))
        .spawn()
        .expect("the program starts");
    let begun = || read(folder.path(), "messages").contains("bifurcation curves: started");
    wait_until(&mut run, "curves are begun", begun);
    // Schedulers signal twice, to the process and to its group, and a closed terminal does so as well; SIGINT, of
    // Ctrl-C, has the same effect.
    for signal in ["-TERM", "-HUP"] {
        let process = run.id().to_string();
        let sent = Command::new("kill").args([signal, &process, &process]).status().expect("there is kill");
        assert!(sent.success());
        wait_until(&mut run, "it is heard", || read(folder.path(), "messages").contains("interrupted"));
    }
    let status = run.wait().expect("it ends");
    let told = read(folder.path(), "messages");
    assert_eq!(status.code(), Some(3), "{told}");
    assert!(told.contains("\ninterrupted: writing the finished results; "), "{told}");
    assert!(told.ends_with("everything else is written\n"), "{told}");
    let results = listing(&folder.path().join("unfolded/paper"));
    assert!(
        results.contains(&"data/grazing.csv".to_owned()) && results.contains(&"report.html".to_owned()),
        "{results:?}"
    );
    assert!(!results.contains(&"data/curves.unfinished.csv".to_owned()), "{results:?}");
}

/// The exit code and the messages of a run that is interrupted twice; none if it ends before.
#[cfg(unix)]
fn interrupted_twice(folder: &Path) -> Option<(Option<i32>, String)> {
    // Pictures of many dots take a while to write, usually long enough for the second interrupt.
    let mut run = interruptible()
        .args(["unfold", "paper.toml", "--format", "svg,png", "--dpi", "1200"])
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(fs::File::create(folder.join("messages")).expect("the folder is ours"))
        .spawn()
        .expect("the program starts");
    for (awaited, signal) in
        [("bifurcation curves: started", "-INT"), ("interrupted: writing the finished results", "-TERM")]
    {
        let is_there = || read(folder, "messages").contains(awaited);
        watched(&mut run, |run| {
            let ended = run.try_wait().expect("it is ours").is_some();
            if is_there() { Some(true) } else { ended.then_some(false) }
        })
        .filter(|is_there| *is_there)?;
        if signal == "-TERM" {
            // Within two seconds it would be the same request.
            thread::sleep(Duration::from_millis(2100));
        }
        let sent =
            Command::new("kill").args([signal, &run.id().to_string()]).status().expect("there is kill");
        assert!(sent.success());
    }
    Some((run.wait().expect("it ends").code(), read(folder, "messages")))
}

#[cfg(unix)]
#[test]
fn a_second_ctrl_c_ends_the_program_at_once_and_leaves_no_temporary_files() {
    let paper = fs::read_to_string(repository().join("examples/paper.toml")).expect("it is there");
    let folder = folder_with(&[("paper.toml", &paper)]);
    let end = "error: interrupted twice: cancelled at once; nothing more is written\n";
    let mut trials = (0..20).filter_map(|_| interrupted_twice(folder.path()));
    let in_time = trials.find(|(_, told)| told.ends_with(end));
    assert_eq!(in_time.expect("it is heard in one trial of many").0, Some(3));
    let left = listing(folder.path());
    assert!(!left.iter().any(|path| path.contains(".grazing-")), "{left:?}");
}

/// Runs `unfold duffing.toml` in a folder under limits of the shell.
#[cfg(unix)]
fn limited(folder: &Path, limits: &str, arguments: &[&str]) -> (Option<i32>, String) {
    let command = format!("ulimit {limits}; exec \"$0\" \"$@\"");
    let run = Command::new("sh")
        .args(["-c", &command, env!("CARGO_BIN_EXE_grazing"), "unfold", "duffing.toml"])
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("there is a shell");
    (run.status.code(), String::from_utf8_lossy(&run.stderr).into_owned())
}

#[cfg(target_os = "linux")]
#[test]
fn limits_of_the_shell_end_a_run_with_a_message_and_what_can_be_written() {
    let folder = folder_with(&[("duffing.toml", &narrow_duffing())]);
    // Whatever the address space, no signal ends the program.
    for kilobytes in [150_000, 250_000, 400_000] {
        let (limit, output) = (format!("-v {kilobytes}"), format!("of-{kilobytes}"));
        let line = ["--jobs", "1", "--step-limit", "3e5", "--output", &output];
        let (code, told) = limited(folder.path(), &limit, &line);
        assert!(code == Some(3) && told.contains("error: "), "{kilobytes}: {code:?} {told}");
    }
    // Of files that are too long the others are kept.
    let (code, told) = limited(folder.path(), "-f 40", &["--output", "short"]);
    assert_eq!(code, Some(3), "{told}");
    assert!(told.contains("(ulimit -f); ") && told.contains(" files are in short/unfinished"), "{told}");
    let kept = listing(&folder.path().join("short/unfinished"));
    for (file, is_kept) in
        [("data/coefficients.csv", true), ("manifest.sha256", true), ("report.html", false)]
    {
        assert_eq!(kept.contains(&file.to_owned()), is_kept, "{file}: {kept:?}");
    }
}

#[cfg(unix)]
#[test]
fn what_stands_in_the_way_is_noticed_before_anything_is_computed() {
    let folder = folder_with(&[("duffing.toml", &narrow_duffing()), ("mine", "precious")]);
    let data = folder.path().join("unfolded/duffing/data");
    fs::create_dir_all(&data).expect("the folder is ours");
    let refused = |what: &str| {
        let run = grazing(folder.path(), &["unfold", "duffing.toml"]);
        assert_eq!(run.code, Some(4), "{}", run.messages);
        assert!(run.messages.contains(what) && !run.messages.contains("started"), "{}", run.messages);
    };
    let unfinished = data.join("curves.unfinished.csv");
    std::os::unix::fs::symlink(folder.path().join("mine"), &unfinished).expect("the folder is ours");
    refused("data/curves.unfinished.csv: is a symbolic link");
    assert_eq!(read(folder.path(), "mine"), "precious");
    fs::remove_file(unfinished).expect("the folder is ours");
    // A file that cannot be read, for whoever runs the tests: it is too long.
    let long = fs::File::create(data.join("curves.csv")).expect("the folder is ours");
    long.set_len(2_000_000_000).expect("it has holes");
    refused("data/curves.csv: cannot be read: it is longer");
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
