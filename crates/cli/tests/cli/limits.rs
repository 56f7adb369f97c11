//! Runs of `grazing unfold` that end early: limits, interruptions, and what stands in the way.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
#[cfg(unix)]
use std::{thread, time::Duration};

use crate::program::{folder_with, grazing, listing, narrow_duffing, read, repository, wait_until};
#[cfg(unix)]
use crate::program::{interruptible, watched};
use crate::unfold::results;
use grazing_input::Description;

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
    // On a busy machine there is a picture, too.
    let mut left = listing(&folder.path().join("unfolded/duffing"));
    left.retain(|name| name != "diagram.unfinished.svg");
    assert_eq!(left, ["data", "data/curves.unfinished.csv"]);
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
    // Whatever the address space, no signal ends the program. On a busy machine an allocation may fail before
    // the limit is seen to be near, and Rust says so.
    for kilobytes in [150_000, 250_000, 400_000] {
        let (limit, output) = (format!("-v {kilobytes}"), format!("of-{kilobytes}"));
        let line = ["--jobs", "1", "--step-limit", "3e5", "--output", &output];
        let (code, told) = limited(folder.path(), &limit, &line);
        let is_said = ["error: ", "memory allocation of "].iter().any(|words| told.contains(words));
        assert!(code == Some(3) && is_said, "{kilobytes}: {code:?} {told}");
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

/// A pixel takes ten bytes, and these pictures some 300 megabytes each.
#[test]
fn a_picture_for_which_memory_leaves_no_room_is_not_drawn_and_tables_are_written() {
    let folder = folder_with(&[("duffing.toml", &narrow_duffing())]);
    let arguments =
        ["unfold", "duffing.toml", "--format", "svg,png", "--dpi", "1200", "--memory-limit", "150"];
    let run = grazing(folder.path(), &arguments);
    if cfg!(target_os = "linux") {
        assert_eq!(run.code, Some(3), "{}", run.messages);
        let told = run.errors().split_whitespace().collect::<Vec<_>>().join(" ");
        let reason = "diagram.png, magnifications.png, straightened.png would take more than the memory limit of 150 MB and are not drawn";
        assert!(told.contains(reason) && told.contains("--dpi"), "{told}");
        assert_eq!(listing(&folder.path().join("unfolded/duffing")), results());
    }
}
