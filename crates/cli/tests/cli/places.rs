//! Obstacles in the places of files, stale files, and a full disk.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::program::{DEFAULT, empty_folder, end, grazing, listing, narrow_linear, project, started};

/// A command that takes no time.
const QUICK: [&str; 3] = ["reproduce", "--only", "fig04"];

/// Asserts that Figure 4 is not written to the folder `out` because of an obstacle there.
fn refused(folder: &Path, what: &str) {
    let before = listing(folder);
    for options in [vec![], vec!["--check"]] {
        let line: Vec<&str> = QUICK.into_iter().chain(["--output", "out"]).chain(options).collect();
        let outcome = grazing(folder, &line);
        assert_eq!(outcome.code, Some(4), "{what}: {}", outcome.messages);
        assert!(outcome.messages.contains("not a regular file"), "{what}: {}", outcome.messages);
        assert_eq!(outcome.messages.lines().count(), 1, "{what}: {}", outcome.messages);
        assert_eq!(listing(folder), before, "{what}");
    }
}

#[test]
fn a_folder_in_the_place_of_a_file_is_not_replaced() {
    let folder = project(DEFAULT);
    fs::create_dir_all(folder.path().join("out/fig04.svg")).expect("the folder is ours");
    refused(folder.path(), "is a folder");
}

#[cfg(unix)]
#[expect(clippy::print_stderr, reason = "what is not tried is told")]
#[test]
fn pipes_sockets_devices_and_links_to_nothing_are_not_replaced() {
    use std::os::unix::fs::{FileTypeExt, symlink};
    use std::os::unix::net::UnixListener;
    let folder = project(DEFAULT);
    let place = folder.path().join("out/fig04.svg");
    fs::create_dir(folder.path().join("out")).expect("the folder is ours");

    let socket = UnixListener::bind(&place).expect("the folder is ours");
    refused(folder.path(), "is a socket");
    drop(socket);
    fs::remove_file(&place).expect("the folder is ours");

    symlink("/dev/null", &place).expect("the folder is ours");
    refused(folder.path(), "is a symbolic link");
    fs::remove_file(&place).expect("the folder is ours");

    // Neither a link to nothing nor one to a file is followed: the content could go to any file of the user.
    let outside = folder.path().join("outside");
    let not_followed = || {
        let outcome = grazing(folder.path(), &[&QUICK[..], &["--output", "out"]].concat());
        assert_eq!(outcome.code, Some(4), "{}", outcome.messages);
        assert!(outcome.messages.contains("is a symbolic link"), "{}", outcome.messages);
    };
    symlink(&outside, &place).expect("the folder is ours");
    not_followed();
    assert!(!outside.exists());
    fs::write(&outside, "old").expect("the folder is ours");
    not_followed();
    assert_eq!(fs::read_to_string(&outside).expect("it is there"), "old");
    fs::remove_file(&place).expect("the folder is ours");

    match Command::new("mkfifo").arg(&place).status() {
        Ok(status) if status.success() => {
            refused(folder.path(), "is a named pipe");
            let kind = place.symlink_metadata().expect("it is there").file_type();
            assert!(kind.is_fifo());
        }
        _ => eprintln!("there is no mkfifo here: named pipes are not tried"),
    }
}

#[test]
fn a_file_named_with_dots_does_not_lead_out_of_the_folder() {
    let folder = empty_folder();
    for (name, made) in [("...toml", "oscillator"), (".toml", "toml")] {
        let text = narrow_linear().replace("range = [0.2, 0.4]", "range = [5.0, 5.1]");
        fs::write(folder.path().join(name), text).expect("the folder is ours");
        fs::create_dir_all(folder.path().join("unfolded").join(made)).expect("the folder is ours");
        // An obstacle shows which folder is meant, before anything is computed.
        fs::create_dir_all(folder.path().join("unfolded").join(made).join("diagram.svg"))
            .expect("it is ours");
        let outcome = grazing(folder.path(), &["unfold", name]);
        assert_eq!(outcome.code, Some(4), "{name}: {}", outcome.messages);
        let path = format!("error: unfolded/{made}/diagram.svg: is a folder");
        assert!(outcome.messages.starts_with(&path), "{name}: {}", outcome.messages);
    }
    assert_eq!(
        fs::read_dir(folder.path()).expect("it is ours").count(),
        3,
        "nothing stands beside `unfolded`"
    );
}

#[expect(clippy::print_stderr, reason = "what is not tried is told")]
#[test]
fn what_dead_runs_have_left_goes_with_the_next_run() {
    if !Path::new("/proc/self").exists() {
        return eprintln!("the processes that run are not known here: nothing is removed");
    }
    let folder = project(DEFAULT);
    let mut ended = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .arg("--version")
        .stdout(Stdio::null())
        .spawn()
        .expect("the program starts");
    let dead = format!(".grazing-{}-abc", ended.id());
    ended.wait().expect("it ends");
    let alive = format!(".grazing-{}-abc", std::process::id());
    fs::create_dir_all(folder.path().join("out/data")).expect("the folder is ours");
    for name in [&dead, &alive, &format!("data/{dead}"), &".grazing-mine".to_owned()] {
        fs::write(folder.path().join("out").join(name), "half").expect("the folder is ours");
    }
    let outcome = grazing(folder.path(), &["reproduce", "--only", "fig04", "--output", "out"]);
    assert_eq!(outcome.code, Some(0), "{}", outcome.messages);
    let left: Vec<String> =
        listing(&folder.path().join("out")).into_iter().filter(|path| path.contains(".grazing")).collect();
    assert_eq!(left, [alive, ".grazing-mine".to_owned()]);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_on_the_output_stream_is_told_and_a_closed_pipe_is_not() {
    let folder = project(DEFAULT);
    let full = || fs::OpenOptions::new().write(true).open("/dev/full").expect("linux has it");
    for line in
        [vec!["compare"], vec!["--help"], vec!["reproduce", "--only", "fig04"], vec!["claims", "eq:gp"]]
    {
        let run = Command::new(env!("CARGO_BIN_EXE_grazing"))
            .args(&line)
            .current_dir(folder.path())
            .stdout(full())
            .output()
            .expect("the program starts");
        let messages = String::from_utf8_lossy(&run.stderr);
        assert_eq!(run.status.code(), Some(4), "{line:?}: {messages}");
        assert!(messages.contains("error: standard output cannot be written: "), "{line:?}: {messages}");
    }
    let mut run = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .arg("compare")
        .current_dir(folder.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(run.stdout.take());
    let run = run.wait_with_output().expect("it ends");
    assert_eq!((run.status.code(), run.stderr.as_slice()), (Some(0), b"".as_slice()));
}

#[test]
fn control_characters_and_direction_marks_reach_no_terminal() {
    let folder = empty_folder();
    let name = "evil\u{1b}[31m\u{202e}.toml";
    let outcome = grazing(folder.path(), &["unfold", name]);
    assert_eq!(outcome.code, Some(2));
    assert!(outcome.messages.contains(r"evil\u{1b}[31m\u{202e}.toml"), "{:?}", outcome.messages);
    assert!(!outcome.messages.contains(['\u{1b}', '\u{202e}']), "{:?}", outcome.messages);
    let outcome = grazing(folder.path(), &["frob\u{1b}[31mnicate"]);
    assert_eq!(outcome.code, Some(2));
    assert!(!outcome.messages.contains('\u{1b}'), "{:?}", outcome.messages);
}

#[test]
fn a_name_with_direction_marks_is_shown_as_escapes_on_page_and_figures() {
    let folder = empty_folder();
    let text = narrow_linear().replacen("name = \"", "name = \"\\u202E\\u001B[31m<b>", 1);
    fs::write(folder.path().join("o.toml"), text).expect("the folder is ours");
    let outcome = grazing(folder.path(), &["unfold", "o.toml", "--output", "out"]);
    assert!(outcome.code.is_some_and(|code| code != 2), "{}", outcome.messages);
    assert!(!outcome.output.contains(['\u{1b}', '\u{202e}']), "{:?}", outcome.output);
    let mut looked = 0;
    for path in listing(&folder.path().join("out")) {
        if path.ends_with(".svg") || path.ends_with(".html") {
            let text = fs::read_to_string(folder.path().join("out").join(&path)).expect("it is text");
            assert!(!text.contains(['\u{1b}', '\u{202e}']), "{path}");
            looked += 1;
        }
    }
    assert!(looked > 1, "a figure and the page were written");
}

/// A name that no file system accepts.
fn too_long() -> String {
    "long".repeat(100)
}

#[cfg(unix)]
#[test]
fn a_name_that_is_too_long_is_bad_input_and_is_told_in_few_words() {
    let folder = project(DEFAULT);
    fs::write(folder.path().join("my.toml"), narrow_linear()).expect("the folder is ours");
    let before = listing(folder.path());
    let (name, below) = (too_long(), format!("new/{}/folder", too_long()));
    let path = "a/".repeat(3000);
    for line in [
        vec!["unfold", &name],
        vec!["unfold", "my.toml", "--output", &name],
        vec!["unfold", "my.toml", "--output", &below],
        vec!["unfold", "my.toml", "--output", &path],
        vec!["unfold", "my.toml", "--vary", "zeta=0.1:0.2:2", "--output", &below],
        vec!["unfold", "my.toml", "--set", &format!("{name}=1")],
        vec!["reproduce", "--only", "fig04", "--output", &below],
        vec!["reproduce", "--parameters", &name],
        vec!["report", "--output", &name],
        vec!["merge", &name],
        vec!["explore", "--no-browser", &name],
        vec!["new", &name],
        vec![&name],
    ] {
        let outcome = grazing(folder.path(), &line);
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{}", outcome.messages);
        assert!(outcome.messages.contains("ong"), "{}", outcome.messages);
        assert!(outcome.messages.len() < 700 && !outcome.messages.contains(&name), "{}", outcome.messages);
        assert_eq!(listing(folder.path()), before);
    }
}

/// The end of the program, killed if it waits for something that never comes.
#[cfg(target_os = "linux")]
fn ending(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let place = empty_folder();
    let messages = place.path().join("messages");
    let mut program = Command::new(env!("CARGO_BIN_EXE_grazing"));
    let mut run = started(program.args(arguments), folder, &messages);
    let code = end(&mut run).flatten();
    (code, fs::read_to_string(&messages).expect("the program writes UTF-8"))
}

#[cfg(target_os = "linux")]
#[test]
fn pipes_and_devices_are_no_input_of_any_command() {
    let folder = project(DEFAULT);
    let made = Command::new("mkfifo").arg(folder.path().join("pipe")).status().expect("there is `mkfifo`");
    assert!(made.success());
    std::os::unix::fs::symlink("pipe", folder.path().join("link")).expect("the folder is ours");
    for (file, what) in [("pipe", "a named pipe"), ("link", "a named pipe"), ("/dev/zero", "a device")] {
        for before in [
            &["unfold"] as &[&str],
            &["unfold", "--vary", "zeta=0.1:0.2:2"],
            &["reproduce", "--parameters"],
            &["compare", "--parameters"],
            &["claims", "--parameters"],
            &["report", "--parameters"],
            &["report", "--output", "page.html", "--oscillator"],
            &["explore", "--no-browser"],
            &["merge"],
        ] {
            let (code, told) = ending(folder.path(), &[before, &[file]].concat());
            assert_eq!(code, Some(2), "{before:?} {file}: {told}");
            let wanted = format!("error: {file}: cannot be read: it is {what}, not a regular file");
            assert!(told.starts_with(&wanted), "{before:?}: {told}");
        }
        let (code, told) = ending(folder.path(), &["new", file]);
        assert_eq!(code, Some(2), "{told}");
        assert!(told.starts_with(&format!("error: {file}: already exists")), "{told}");
    }
}
