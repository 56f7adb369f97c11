//! `grazing explore`: the diagram in a browser.

use std::env;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::slice;

use grazing_drawing::SheetWidth;
use grazing_explore::{Example, Export, ExportedFile, Figure, Limits, Seen, Server};
use grazing_input::{Description, FigureStyle};
use grazing_results::Tables;
use grazing_results::branches::OneParameter;
use tempfile::NamedTempFile;

use crate::arguments;
use crate::commands::{CommandLine, program};
use crate::failure::{Failure, computation};
use crate::folder::OutputFile;
use crate::oscillator::OscillatorFile;
use crate::outputs::ComputedOutput;
use crate::outputs::edition::{self, Edition, Format};
use crate::outputs::oscillator::NamedOscillator;
use crate::runner::{self, CommandOutcome, Plan};
use crate::{examples, limits, system, tables, terminal};

/// Serves the page until Ctrl-C is pressed, or writes it as files.
///
/// # Errors
/// A file cannot be read or written, or the port is not available.
pub(crate) fn run(arguments: &arguments::ExploreArguments) -> Result<(), Failure> {
    let examples = examples(arguments.file.as_deref())?;
    if let (Some(folder), Some(program)) = (&arguments.static_files, &arguments.program) {
        return runner::run(|| page(folder, program, &examples), None);
    }
    let export: Export = Box::new(|seen, what, columns, _| {
        figure_file(seen, what, columns).map_err(|failure| failure.to_string())
    });
    let server =
        Server::bind(arguments.port, Limits::default(), program(), examples, export).map_err(|reason| {
            let port = arguments.port;
            Failure::input(format!(
                "port {port} of this machine is not available: {reason}; choose another with --port"
            ))
        })?;
    let address = server.address();
    terminal::say(&format!(
        "{address}\nOnly this machine can open the address, and its token keeps other pages out. Ctrl-C stops the server.\n"
    ));
    limits::end_when_interrupted();
    // The redirecting page exists as long as the server runs.
    let _redirect = if arguments.no_browser { None } else { open(&address) };
    server.run(limits::is_interrupted, system::held).map_err(|reason| Failure::unwritten(reason.to_string()))
}

/// Reads the WebAssembly program, which is written with the page as files for any web server.
fn page<'a>(folder: &Path, program: &Path, examples: &[Example]) -> Result<Plan<'a>, Failure> {
    let content = grazing_input::read_bytes(program, LARGEST_PROGRAM)
        .map_err(|reason| Failure::file(program, &reason))?;
    if !content.starts_with(WASM) {
        return Err(Failure::input(format!(
            "{}: not a WebAssembly program; packaging/web/run builds one",
            program.display()
        )));
    }
    let page = grazing_explore::alone("grazing", examples).into_iter().chain([("grazing.wasm", content)]);
    let files: Vec<OutputFile> =
        page.map(|(name, content)| OutputFile { path: name.into(), content }).collect();
    let paths: Vec<_> = files.iter().map(|file| file.path.clone()).collect();
    let say = |files, folder: &Path| {
        let next = CommandLine::of(&["python3", "-m", "http.server", "-d"]).with(folder.display()).into();
        Ok(CommandOutcome { next, ..CommandOutcome::unlisted(files, folder)? })
    };
    Ok(Plan::new(|_| Ok(files), say).writing(folder.to_owned(), paths))
}

/// The first bytes of a program in WebAssembly, and the largest size of one in bytes.
const WASM: &[u8] = b"\0asm";
const LARGEST_PROGRAM: u64 = 100_000_000;

/// The oscillators in the menu: the named file, the paper's, and the repository's examples.
fn examples(named: Option<&Path>) -> Result<Vec<Example>, Failure> {
    let mut all = Vec::new();
    if let Some(named) = named {
        let OscillatorFile { text, description, .. } =
            OscillatorFile::read(named, &[], grazing_input::AnalysisLimits::USUAL)?;
        let file = named.file_name().unwrap_or_default().to_string_lossy().into_owned();
        all.push(Example { name: description.name().to_owned(), file, text: Some(text) });
    }
    all.push(Example { name: "The paper's oscillator".to_owned(), file: String::new(), text: None });
    all.extend(examples::EXAMPLE_FILES.iter().filter_map(|(file, text)| {
        let name = Description::parse(text, file).ok()?.name().to_owned();
        Some(Example { name, file: (*file).to_owned(), text: Some((*text).to_owned()) })
    }));
    Ok(all)
}

/// Opens the address in the system's browser, if one can be opened, through a redirecting page that
/// only this user can read: the arguments of a process are visible to all users.
fn open(address: &str) -> Option<NamedTempFile> {
    let seen = env::consts::OS != "linux"
        || env::var_os("DISPLAY").or_else(|| env::var_os("WAYLAND_DISPLAY")).is_some();
    let (program, first): (&str, &[&str]) = match env::consts::OS {
        "macos" => ("open", &[]),
        "windows" => ("cmd", &["/C", "start", ""]),
        _ => ("xdg-open", &[]),
    };
    if !seen {
        return None;
    }
    // If the browser does not open, the address is on the terminal.
    let mut page = tempfile::Builder::new().prefix("grazing-").suffix(".html").tempfile().ok()?;
    let lead = format!("<meta http-equiv=\"refresh\" content=\"0; url={address}\">");
    writeln!(page, "<!doctype html>{lead}<a href=\"{address}\">{address}</a>").ok()?;
    page.flush().ok()?;
    let started = Command::new(program)
        .args(first)
        .arg(page.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    started.ok().map(|_| page)
}

/// A file of what the page shows, produced as `unfold` produces it.
fn figure_file(seen: &Seen, what: &str, columns: &str) -> Result<ExportedFile, Failure> {
    let format = match what {
        "svg" => Some((Format::Svg, "image/svg+xml")),
        "pdf" => Some((Format::Pdf, "application/pdf")),
        "png" => Some((Format::Png, "image/png")),
        _ => None,
    };
    let formats = vec![format.map_or(Format::Svg, |(format, _)| format)];
    let edition = Edition { formats, columns: edition::width(columns), ..Edition::default() };
    let (files, _) = drawn(seen, edition.columns)?.files(&edition)?;
    let wanted = |file: &OutputFile| match (format, what.strip_prefix("csv:")) {
        (Some((format, _)), _) => file.path.extension().is_some_and(|found| found == format.name().as_str()),
        (None, Some(table)) => file.path == tables::path(table),
        (None, None) => false,
    };
    let Some(OutputFile { path, content }) = files.into_iter().find(wanted) else {
        return Err(Failure::input(format!(
            "{what}: unknown format: svg, pdf, png and csv:TABLE are available"
        )));
    };
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    Ok(ExportedFile { name, kind: format.map_or("text/csv; charset=utf-8", |(_, kind)| kind), content })
}

/// The figures and tables of what the page shows.
pub(crate) fn drawn(seen: &Seen, width: SheetWidth) -> Result<ComputedOutput, Failure> {
    let Seen { name, names, figure } = seen;
    let named = NamedOscillator { of: Path::new("oscillator.toml"), name, names, width };
    let output = match figure {
        Figure::Plane(diagram, compared) => named.plane(diagram, FigureStyle::default()).map(|mut made| {
            made.tables.extend(compared.iter().flat_map(|compared| compared.tables(names)));
            made
        }),
        Figure::OneParameter(diagram) => named
            .one_parameter(diagram)
            .map(|figure| {
                ComputedOutput::new(vec![figure], OneParameter::tables_of(slice::from_ref(diagram), names))
            })
            .map_err(Into::into),
        Figure::Place(place) => named.places(slice::from_ref(place)),
        Figure::Straightened(curves) => named.straightened(curves),
    };
    output.map_err(|error| computation("figure", &*error))
}
