//! Running the built program as a user would.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::{LazyLock, OnceLock};
use std::thread;
use std::time::Duration;

use grazing_beyond::parameters;
use grazing_cli::folder::{self, OutputFile};
use grazing_cli::outputs::edition::{Edition, Format, TextForm};
use grazing_cli::reproduce;
use grazing_drawing::SheetWidth;
use grazing_input::Text;
use grazing_reproduction::Study;
use insta::Settings;
use sha2::{Digest, Sha256};

/// The default parameter file.
pub(crate) const DEFAULT: &str = include_str!("../../../../../figures/parameters.toml");

/// Valid parameters with invented numbers.
pub(crate) const INVENTED: &str = include_str!("parameters.toml");

/// The result of a run of the program.
pub(crate) struct Outcome {
    pub(crate) code: Option<i32>,
    pub(crate) output: String,
    pub(crate) messages: String,
}

impl Outcome {
    /// The messages that are not about progress.
    pub(crate) fn errors(&self) -> &str {
        self.messages.find("error: ").map_or("", |start| &self.messages[start..])
    }
}

/// Runs `grazing` with the arguments in the folder.
pub(crate) fn grazing(folder: &Path, arguments: &[&str]) -> Outcome {
    let run = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .args(arguments)
        .current_dir(folder)
        .env_remove("CLICOLOR_FORCE")
        .env("GRAZING_BY_XTASK", "1")
        .output()
        .expect("the program starts");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("the program writes UTF-8");
    Outcome { code: run.status.code(), output: text(run.stdout), messages: text(run.stderr) }
}

/// A command that restores the default signals, some of which the environment of the tests may ignore.
#[cfg(unix)]
pub(crate) const DEFAULT_SIGNALS: [&str; 2] = ["env", "--default-signal=INT,TERM,HUP"];

/// The program with the default signals.
#[cfg(unix)]
pub(crate) fn interruptible() -> Command {
    let [program, option] = DEFAULT_SIGNALS;
    let mut command = Command::new(program);
    command.args([option, env!("CARGO_BIN_EXE_grazing")]);
    command
}

/// Starts a command in the folder, with its messages written to a file.
#[cfg(unix)]
pub(crate) fn started(command: &mut Command, folder: &Path, messages: &Path) -> Child {
    let messages = fs::File::create(messages).expect("the folder is ours");
    let silent = command.current_dir(folder).stdin(Stdio::null()).stdout(Stdio::null());
    silent.stderr(messages).spawn().expect("the program starts")
}

/// Whether all threads of a process sleep, where the system reports it: one that computes does not,
/// however long it waits for a processor or a disk.
fn sleeps(process: u32) -> bool {
    let is_asleep = |stat: String| stat.rsplit_once(')').is_some_and(|(_, rest)| rest.starts_with(" S"));
    let threads = fs::read_dir(format!("/proc/{process}/task"));
    threads.is_ok_and(|mut threads| {
        threads.all(|thread| {
            thread.and_then(|thread| fs::read_to_string(thread.path().join("stat"))).is_ok_and(is_asleep)
        })
    })
}

/// Looks at a run until something is seen. Gives up, and ends the run, if it sleeps at many looks
/// in succession and so waits for something that never comes.
pub(crate) fn watched<T>(run: &mut Child, mut look: impl FnMut(&mut Child) -> Option<T>) -> Option<T> {
    const LOOKS: u32 = 2_000;
    let mut asleep = 0;
    while asleep < LOOKS {
        if let Some(seen) = look(run) {
            return Some(seen);
        }
        asleep = if sleeps(run.id()) { asleep + 1 } else { 0 };
        thread::sleep(Duration::from_millis(5));
    }
    run.kill().expect("it still runs");
    run.wait().expect("it ends");
    None
}

/// Waits until a running program has done something.
pub(crate) fn wait_until(run: &mut Child, what: &str, is_done: impl Fn() -> bool) {
    let ended = |run: &mut Child| run.try_wait().expect("it is ours").is_some();
    let seen = watched(run, |run| if is_done() { Some(true) } else { ended(run).then_some(false) });
    assert_eq!(seen, Some(true), "it ended before, or never did: {what}");
}

/// The exit code of a run, if it ends with one.
pub(crate) fn end(run: &mut Child) -> Option<Option<i32>> {
    watched(run, |run| run.try_wait().expect("it is ours").map(|status| status.code()))
}

/// The root of the repository.
pub(crate) fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// An empty folder that is deleted with the value.
pub(crate) fn empty_folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder can be made")
}

/// A folder with files.
pub(crate) fn folder_with(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = empty_folder();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).expect("the folder is ours");
    }
    folder
}

/// The text of a file in a folder.
pub(crate) fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// A folder like the repository's root, with these default parameters and nothing else.
pub(crate) fn project(parameters: &str) -> tempfile::TempDir {
    let folder = empty_folder();
    fs::create_dir(folder.path().join("figures")).expect("the folder is ours");
    fs::write(folder.path().join("figures/parameters.toml"), parameters).expect("the folder is ours");
    folder
}

/// The parameters with another line for the first key of this name after `section`, or without it
/// if the line is empty. The old value does not matter, so that the default file can change without
/// its tests.
pub(crate) fn edited(parameters: &str, section: &str, key: &str, line: &str) -> String {
    let section_start = parameters.find(section).expect("the section stands in the file");
    let assignment = format!("\n{key}");
    let start = 1 + section_start + parameters[section_start..].find(&assignment).expect("the key follows");
    let end = start + parameters[start..].find('\n').expect("the file ends with a line end");
    let end = if line.is_empty() { end + 1 } else { end };
    format!("{}{line}{}", &parameters[..start], &parameters[end..])
}

/// The default parameters with a coarse map of attractors, and solutions with several impacts that leave few resonances: two
/// figures that take longer than all others together.
pub(crate) fn coarse_parameters() -> String {
    let coarse =
        [("attractors", "columns", "16"), ("attractors", "rows", "16"), ("generations", "rounds", "[1]")];
    coarse.into_iter().fold(DEFAULT.to_owned(), |parameters, (section, key, value)| {
        edited(&parameters, &format!("[beyond_{section}]"), key, &format!("{key} = {value}"))
    })
}

/// The default parameters with little work for every output: a part of Figure 7's window with a resonance of each p,
/// coarse maps and short attractors.
pub(crate) fn quick_parameters() -> String {
    let mut parameters = coarse_parameters();
    for (section, key, value) in [
        ("[fig02.attractor]", "amplitudes", "5"),
        ("[fig07]", "frequency", "[0.62, 0.86]"),
        ("[beyond_cascade]", "values", "40"),
        ("[beyond_atlas]", "rows", "12"),
        ("[beyond_proofs]", "panels", "1"),
    ] {
        parameters = edited(&parameters, section, key, &format!("{key} = {value}"));
    }
    // The last panel of Figure 8 lies elsewhere.
    let panel = parameters.rfind("[[fig08.panels]]").expect("the figure has panels");
    let end = parameters.find("[fig09]").expect("the section follows");
    parameters.replace_range(panel..end, "");
    parameters
}

/// The Duffing oscillator of examples/ in ranges with a single resonance of p = 3 and without its
/// one-parameter diagram, to save time.
pub(crate) fn narrow_duffing() -> String {
    narrow(&duffing(), "range = [0.95, 1.0]")
}

/// That oscillator with a linear spring in place of the cubic one, likewise: its motion has a closed form, which saves
/// more time.
pub(crate) fn narrow_linear() -> String {
    let force = "force = \"-2*zeta*v - (1 + kappa)*x - 1 + A*cos(omega*t)\"";
    narrow(&edited(&duffing(), "[motion]", "force", force), "range = [0.85, 0.95]")
}

fn duffing() -> String {
    fs::read_to_string(repository().join("examples/duffing.toml")).expect("it is among the examples")
}

fn narrow(whole: &str, secondary: &str) -> String {
    let whole = whole.split("[[diagrams]]").next().expect("there is something before");
    let narrow = edited(whole, "[primary]", "range", "range = [0.2, 0.4]");
    let narrow = edited(&narrow, "[secondary]", "range", secondary);
    edited(&narrow, "[analysis]", "loops", "loops = [3]")
}

/// The study of the default parameters: the contents of its figures are computed once for all tests.
static STUDY: LazyLock<Study> = LazyLock::new(|| {
    let parameters = parameters::parse(&Text::new(DEFAULT, &[]), "parameters.toml");
    Study::new(&parameters.expect("the default parameters are valid"))
});

/// A folder with all figures and tables of the default parameters at a width, as `reproduce` writes them: SVG, LaTeX
/// with PDF, and at one column PNG with a pixel a point. They are made once for all tests.
pub(crate) fn edition(columns: SheetWidth) -> tempfile::TempDir {
    static MADE: [OnceLock<Vec<OutputFile>>; 3] = [const { OnceLock::new() }; 3];
    let made = MADE[columns as usize].get_or_init(|| {
        let png = (columns == SheetWidth::OneColumn).then_some(Format::Png);
        let formats = [Format::Svg, Format::Tex].into_iter().chain(png).collect();
        let edition = Edition::new(formats, columns, 72, TextForm::Fonts);
        reproduce::files(&STUDY, &edition).expect("the default parameters give all outputs")
    });
    let place = empty_folder();
    folder::write(place.path(), made).expect("the folder is ours");
    place
}

/// The paths of everything in the folder.
pub(crate) fn listing(folder: &Path) -> Vec<String> {
    let mut paths = Vec::new();
    let mut places = vec![folder.to_owned()];
    while let Some(place) = places.pop() {
        for entry in fs::read_dir(&place).expect("the folder can be read") {
            let path = entry.expect("the folder can be read").path();
            if path.is_dir() {
                places.push(path.clone());
            }
            paths.push(path.strip_prefix(folder).expect("it lies in the folder").display().to_string());
        }
    }
    paths.sort();
    paths
}

/// The SHA-256 of a content, in hexadecimal digits.
pub(crate) fn digest(content: &[u8]) -> String {
    Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Settings by which snapshots go to `expected/`, under the name that the test gives.
pub(crate) fn snapshots() -> Settings {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(repository().join("expected"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings
}
