//! `grazing explore`: its start and its end.
#![cfg(unix)]

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};

use crate::browser::chromium::{Browser, saved};
use crate::program::{empty_folder, grazing, interruptible, repository, watched};

/// A running server, which ends with the value.
struct Serving(Child);

impl Serving {
    /// Starts the server, and reads its address.
    fn new(folder: &Path) -> (Self, String) {
        let mut server = interruptible()
            .args(["explore", "--no-browser"])
            .current_dir(folder)
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut lines = BufReader::new(server.stdout.take().expect("it is ours")).lines();
        let address = lines.next().expect("a line").expect("it is text");
        (Self(server), address)
    }

    /// The exit code after Ctrl-C.
    fn interrupted(mut self) -> Option<i32> {
        let asked = Command::new("kill").args(["-INT", &self.0.id().to_string()]).status();
        assert!(asked.is_ok_and(|status| status.success()));
        self.0.wait().expect("it is ours").code()
    }
}

impl Drop for Serving {
    fn drop(&mut self) {
        let _ = self.0.kill();
    }
}

/// Asks for a path of the server and reads the answer.
fn ask(host: &str, request: &str) -> String {
    let mut stream = TcpStream::connect(host).expect("it listens");
    stream.write_all(request.as_bytes()).expect("it reads");
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("it answers");
    answer
}

#[test]
fn the_address_is_printed_the_page_is_there_and_ctrl_c_ends_it() {
    let folder = empty_folder();
    let (server, address) = Serving::new(folder.path());
    let (host, path) =
        address.strip_prefix("http://").and_then(|rest| rest.split_once('/')).expect("an address");
    let head = format!("Host: {host}\r\nConnection: close\r\n");
    let page = ask(host, &format!("GET /{path} HTTP/1.1\r\n{head}\r\n"));
    assert!(
        page.starts_with("HTTP/1.1 200 ") && page.contains("<script type=\"module\" src=\"main.js\">"),
        "{page}"
    );
    // The examples are also available outside the repository.
    let menu = ask(host, &format!("GET /{path}examples HTTP/1.1\r\n{head}\r\n"));
    assert!(menu.contains("\"duffing.toml\"") && menu.contains("\"leaf-spring.toml\""), "{menu}");
    // The exported numbers are those that `reproduce` writes.
    let view = "{\"primary\": [0.0, 1.3], \"secondary\": [0.35, 1.02]}";
    let body = format!("{{\"model\": {{\"text\": null}}, \"view\": {view}, \"what\": \"csv:points\"}}");
    let more = format!("Content-Type: application/json\r\nContent-Length: {}\r\n", body.len());
    let taken = ask(host, &format!("POST /{path}export HTTP/1.1\r\n{head}{more}\r\n{body}"));
    let committed = include_str!("../../../../figures/data/fig07_points.csv");
    assert!(taken.ends_with(committed), "{taken}");

    assert_eq!(server.interrupted(), Some(0));
}

#[cfg(target_os = "linux")]
#[test]
fn the_browser_is_started_with_a_page_that_leads_to_the_address_and_nobody_else_reads() {
    use std::os::unix::fs::PermissionsExt;

    let folder = empty_folder();
    let browser = folder.path().join("xdg-open");
    let said = folder.path().join("said");
    // The file appears as a whole, or not at all.
    let script = format!("#!/bin/sh\nprintf %s \"$*\" > '{0}.part'\nmv '{0}.part' '{0}'\n", said.display());
    // By a process of its own: a program that another test starts meanwhile would inherit a file that is open for
    // writing, and Linux executes none such.
    let written = Command::new("sh")
        .args(["-c", "printf %s \"$1\" > \"$2\" && chmod 700 \"$2\"", "sh", &script])
        .arg(&browser)
        .status();
    assert!(written.is_ok_and(|status| status.success()));
    let path = std::env::var("PATH").expect("there is one");
    let mut server = interruptible()
        .arg("explore")
        .current_dir(folder.path())
        .env("PATH", format!("{}:{path}", folder.path().display()))
        .env("DISPLAY", ":0")
        .env("TMPDIR", folder.path())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut lines = BufReader::new(server.stdout.take().expect("it is ours")).lines();
    let address = lines.next().expect("a line").expect("it is text");
    let mut server = Serving(server);
    let seen = watched(&mut server.0, |_| said.exists().then_some(()));
    assert!(seen.is_some(), "the browser was not started");
    let page = fs::read_to_string(&said).expect("it is text");
    assert!(Path::new(&page).is_file() && !address.contains(&page), "{page}");
    let token = address.trim_end_matches('/').rsplit('/').next().expect("it has one");
    assert!(token.len() == 32 && !page.contains(token), "{page}");
    let mode = fs::metadata(&page).expect("it is there").permissions().mode();
    assert_eq!(mode & 0o777, 0o600);
    let content = fs::read_to_string(&page).expect("it is text");
    assert!(content.contains(&format!("content=\"0; url={address}\"")), "{content}");
    assert_eq!(server.interrupted(), Some(0));
    assert!(!Path::new(&page).exists());
}

/// What is exported of the page as it is: the figure in three formats, and the curves, which are
/// those that the copied command writes.
fn exported(page: &mut Browser, stem: &str, figure: &str, curves: &str) {
    let home = empty_folder();
    page.permit(home.path());
    page.value("document.getElementById('plane').focus()");
    page.press("s");
    page.wait("document.getElementById('share').open");
    page.note_words("copy-command");
    page.click("#copy-command", [0.0, 0.0]);
    page.wait("noted.includes('Copied')");
    let command = page.value("navigator.clipboard.readText()");
    let command = command.as_str().expect("it is text").strip_prefix("grazing ").expect("as people type it");
    page.press("Escape");
    page.press("x");
    page.wait("document.getElementById('export').open");
    for what in ["svg", "pdf", "png", "csv:curves"] {
        page.value("document.getElementById('export-status').textContent = ''");
        page.click(&format!("[data-take='{what}']"), [0.0, 0.0]);
        page.wait("/Saved/.test(document.getElementById('export-status').textContent)");
    }
    // A shell reads the command, since it contains quotes.
    let made = empty_folder();
    let program = env!("CARGO_BIN_EXE_grazing");
    let line = format!("{program:?} {command} --format svg,pdf,png --output {:?}", made.path());
    let run =
        Command::new("sh").args(["-c", &line]).current_dir(repository()).output().expect("there is a shell");
    assert!(run.status.success(), "{line}: {}", String::from_utf8_lossy(&run.stderr));
    // The figure has no frames of magnifications, and no line of another diagram.
    for (ending, start) in [("svg", &b"<?xml"[..]), ("pdf", b"%PDF"), ("png", b"\x89PNG")] {
        let taken = saved(home.path(), &format!("{stem}.{ending}"));
        assert!(taken.starts_with(start) && taken.len() > 10_000, "{line}: {ending}");
    }
    let [taken, written] =
        [home.path().join(format!("{stem}.svg")), made.path().join(format!("{figure}.svg"))]
            .map(|file| fs::read_to_string(file).expect("it is text"));
    for frame in ["#f08200", ">Fig. 2<", ">diagram 1<"] {
        assert!(!taken.contains(frame), "{line}: {frame}");
    }
    let inks = ["#78c86e", "#1946be", "#d62f20", "#005838"];
    let curves_of = |svg: &str| inks.map(|ink| svg.matches(&format!("stroke=\"{ink}\"")).count());
    assert_eq!(curves_of(&taken), curves_of(&written), "{line}");
    assert_ne!(curves_of(&taken)[0], 0, "{line}");
    let written = fs::read(made.path().join(format!("data/{curves}.csv"))).expect("it was written");
    assert!(saved(home.path(), &format!("{stem}-curves.csv")) == written, "{line}: the curves differ");
    page.press("Escape");
}

#[test]
fn what_is_exported_from_the_page_is_what_the_copied_command_writes() {
    let (server, address) = Serving::new(&repository());
    if let Some(mut page) = Browser::open(&address, [1200, 850]) {
        let whole =
            "/curves? and \\d+ points? in/.test(document.getElementById('progress-text').textContent)";
        page.wait(whole);
        page.value("use('state').then(([s]) => s.update({set: {zeta: 0.03}, view: {primary: [0.2, 0.9], secondary: [0.5, 0.95]}}))");
        let named = page.wait("use('model').then(([m]) => m.description.name)");
        exported(&mut page, &stem(&named), "fig07", "fig07_curves");
        // An example, with one number of loops so that it is soon there.
        page.value(
            "use('model', 'state').then(([m, s]) => { m.choose('duffing.toml'); s.update({set: {kappa: 0.12}, loops: [1], \
             view: {primary: [0.2, 0.5], secondary: [0.9, 1.05]}}); })",
        );
        let named =
            page.wait("use('model').then(([m]) => /Duffing/.test(m.description.name) && m.description.name)");
        exported(&mut page, &stem(&named), "diagram", "curves");
    }
    assert_eq!(server.interrupted(), Some(0));
}

/// The name of an oscillator as the stem of a file name.
fn stem(name: &serde_json::Value) -> String {
    let name = name.as_str().expect("it is text").to_lowercase();
    let words: Vec<&str> =
        name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()).collect();
    words.join("-")
}

#[test]
fn what_cannot_be_served_is_told_before_anything_is() {
    let folder = empty_folder();
    let refused = |arguments: &[&str]| {
        let outcome = grazing(folder.path(), arguments);
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{}", outcome.messages);
        outcome.messages
    };
    assert!(refused(&["explore", "--no-browser", "missing.toml"]).contains("missing.toml: cannot be read"));
    let taken = std::net::TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let port = taken.local_addr().expect("it has an address").port().to_string();
    let told = refused(&["explore", "--no-browser", "--port", &port]);
    assert!(
        told.contains(&format!("port {port} of this machine is not available")) && told.contains("--port"),
        "{told}"
    );
}

#[test]
fn the_page_is_written_as_files_with_a_program_beside_them() {
    let folder = empty_folder();
    let place = |name: &str| folder.path().join(name);
    let write =
        |program: &str| grazing(folder.path(), &["explore", "--static-files", "page", "--program", program]);
    // A file that is not a program is rejected, and nothing is written.
    fs::write(place("text.wasm"), "(module)").expect("it can be written");
    let refused = write("text.wasm");
    let told = "text.wasm: not a WebAssembly program";
    assert!(refused.code == Some(2) && refused.messages.contains(told), "{}", refused.messages);
    assert!(!place("page").exists());
    fs::write(place("grazing.wasm"), b"\0asm\x01\0\0\0").expect("it can be written");
    assert_eq!(write("grazing.wasm").code, Some(0));
    let written = |name: &str| fs::read(place("page").join(name)).expect("it is there");
    assert_eq!(written("grazing.wasm"), b"\0asm\x01\0\0\0");
    assert!(String::from_utf8_lossy(&written("index.html")).contains("src=\"main.js\""));
    assert!(String::from_utf8_lossy(&written("examples")).contains("duffing.toml"));
    // The page reaches the program without a server.
    assert!(String::from_utf8_lossy(&written("reach.js")).contains("./worker.js"));
}
