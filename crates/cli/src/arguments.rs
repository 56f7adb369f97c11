//! What can be written on the command line.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};

use grazing_claims::ledger::ClaimKind;
use grazing_description::Limits;
use grazing_drawing::SheetWidth;
use grazing_source::Setting;

use crate::failure::Failure;
use crate::outputs::edition::{Edition, Format, WIDTHS};
use crate::outputs::{self, edition};
use crate::variation::{Part, Variation};

/// What the exit codes mean, for the end of the help.
const EXIT_CODES: &str = "\
Exit codes:
  0  all went well
  1  a check failed: files are not what the code makes, a published value is not met, or
     theorem and computation contradict each other
  2  bad input: command line, parameter file, or a folder that cannot be written;
     nothing was written
  3  a computation failed, was ended by a limit or Ctrl-C, or parameters do not fit each
     other; everything but what is named was written
  4  an I/O error occurred, as on a full disk;
     each file is either old or new";

const ABOUT: &str = "\
Regenerates the numerical results of \"Resonant grazing bifurcations revisited\" by
D. J. W. Simpson and I. Ghosh (arXiv 2602.22797): its figures as SVG, every number drawn as
CSV, and a comparison with the numbers that the paper prints. Does the same analysis for any
oscillator with a wall that a text file describes.

In a clone of the repository, `cargo xtask COMMAND` builds this program and runs `grazing COMMAND`.";

const EXAMPLES_OF_REPRODUCE: &str = "\
Examples:
  cargo xtask reproduce                  all figures and data, into figures/
  cargo xtask reproduce --only fig07     Figure 7 and its data
  cargo xtask reproduce --check          write nothing; fail if figures/ is not what the code makes
  cargo xtask reproduce --parameters mine.toml --output mine
  cargo xtask reproduce --set oscillator.zeta=0.05 --set fig07.amplitude=[0,2]
                                         other values for keys of the parameter file, into varied/
  cargo xtask reproduce --format pdf,tex --columns one
                                         for a journal of two columns, into journal/

Each output fails or succeeds by itself: those that can be made with the parameters are written, the
others are named with the key to change, and the exit code is 3. Only the sections of the parameter
file that an output reads must be right for it. With --set files go to varied/ beside figures/
unless --output says otherwise, with settings.txt, which has what was set.

figures/ holds SVG at the paper's widths. Other formats and widths go to journal/ beside it, or to
the folder that --output names; runs with --only may mix widths there. Data come along as CSV.
When a figure that is already there changes, a picture of before, after and the difference is drawn
in the system's folder for temporary files, and named.

Files are replaced whole and only once everything is computed: an interrupted run leaves each of
them old or new. Only regular files are replaced, through symbolic links to them. A published value
that is not met is reported, but fails `compare` only.

";

const EXAMPLES_OF_COMPARE: &str = "\
Examples:
  cargo xtask compare
  cargo xtask compare --parameters mine.toml

A value is met if, rounded to the digits that the paper prints, it is the print; the printed values
stand in expected/published.toml.

";

const EXAMPLES_OF_CLAIMS: &str = "\
Examples:
  cargo xtask claims                     all claims; also holds ERRATA.md against the ledger
  cargo xtask claims eq:gp le:SpTp       two labels
  cargo xtask claims 'th:*' --explain    the theorems, with all that is known of them
  cargo xtask claims --misprints         where print and mathematics differ

The ledger stands in expected/claims.toml. A misprint passes if the printed form fails and the
corrected one holds.

";

const EXAMPLES_OF_REPORT: &str = "\
Examples:
  cargo xtask report                     writes report.html; open it in a browser
  cargo xtask report --output mine.html --parameters mine.toml
  cargo xtask report --oscillator my.toml
                                         with an oscillator of one's own beside those of examples/

One page for all: figures with the values behind them, tables, the published values, every claim
with the computation that tests it, misprints, other oscillators from text files, and the SHA-256
of each output. It needs no network.
What is not met or does not hold is shown as such on the page and in the summary, and does not make
this fail.

";

const EXAMPLES_OF_UNFOLD: &str = "\
Examples:
  cargo xtask unfold examples/duffing.toml
                                         into unfolded/duffing/: diagram.svg, magnifications.svg,
                                         every number as CSV in data/, all on one page: report.html
  cargo xtask unfold mine.toml --loops 1,2 --explain
                                         other p than the file's; every hypothesis with its value
  cargo xtask unfold mine.toml --set kappa=0.2 --set secondary.range=[0.4,1.1]
                                         other values for keys of the file; text in quotation marks:
                                         --set 'impact.restitution=\"0.8\"'
  cargo xtask unfold examples/*.toml     all examples, each into a folder of its own
  cargo xtask unfold mine.toml --format pdf --columns one --output figures-of-mine
  cargo xtask unfold mine.toml --vary zeta=0.01:0.1:10 --vary kappa=0:0.5:6
                                         resonances, coefficients and codimension-two points for 60
                                         oscillators, into families/mine/: family.svg, and data/

The file names the parameters, their ranges, and gives force, forcing frequency, restitution and
impact duration as expressions; `cargo xtask new` writes one to begin with, and examples/ has
fourteen with comments, and a page that explains the columns. The terminal shows the grazing curve,
every resonant grazing bifurcation on it, and there the coefficients of Theorem 2.4 or 2.5 beside
measured ones, or the hypothesis that fails; and better ranges where the diagram fills little of
the file's.

Files are written whole, and only when everything is computed, a limit of time, memory or steps is
met, or Ctrl-C is pressed; what is missing then is named, and the exit code is 3. Pressed again,
Ctrl-C ends the program at once. Until then the curves that are finished stand in
data/curves.unfinished.csv.

";

const EXAMPLES_OF_EXPLORE: &str = "\
Examples:
  cargo xtask explore                    the paper's oscillator; the examples are in a menu
  cargo xtask explore my.toml
  cargo xtask explore --no-browser --port 8700

Starts a server that only this machine can reach, prints its address and opens the page in a
browser. The page loads nothing from elsewhere. Whatever is seen can be exported: figure, numbers, and
the command that writes the same.

";

const EXAMPLES_OF_MERGE: &str = "\
Examples:
  cargo xtask unfold mine.toml --vary zeta=0.01:0.1:40 --part 1/2
  cargo xtask unfold mine.toml --vary zeta=0.01:0.1:40 --part 2/2
  cargo xtask merge families/mine/parts/*.toml

The parts may be computed anywhere and in any order. Merged, they give the same files, byte by byte,
as one run without --part. workflows/ has a Snakemake workflow that computes and merges parts on one
machine, a cluster or a cloud.

";

const EXAMPLES_OF_NEW: &str = "\
Examples:
  cargo xtask new my.toml                a mass on a spring beside a wall, without units
  cargo xtask new my.toml --kind moving-wall
  cargo xtask new my.toml --kind si      metres, kilograms, seconds

The file has a comment for every key and can be unfolded as it is, with
`cargo xtask unfold my.toml`. A file that is there already is not replaced.

";

/// Regenerates the numerical results of "Resonant grazing bifurcations revisited" (arXiv 2602.22797)
#[derive(Debug, Parser)]
#[command(name = "grazing", version, subcommand_required = true, arg_required_else_help = true)]
#[command(after_help = EXIT_CODES)]
#[command(long_about = ABOUT)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Compute the figures and tables and write them, or check the ones that are there
    #[command(next_line_help = true, after_help = format!("{EXAMPLES_OF_REPRODUCE}{EXIT_CODES}"))]
    Reproduce(Reproduce),
    /// Hold the computed values against the ones that the paper prints
    #[command(next_line_help = true, after_help = format!("{EXAMPLES_OF_COMPARE}{EXIT_CODES}"))]
    Compare(ParameterFile),
    /// Test what the paper states, label by label, and print what each check measures
    #[command(next_line_help = true, after_help = format!("{EXAMPLES_OF_CLAIMS}{EXIT_CODES}"))]
    Claims(Claims),
    /// Write one page with figures, tables, claims and a manifest, to be read in a browser
    #[command(next_line_help = true, after_help = format!("{EXAMPLES_OF_REPORT}{EXIT_CODES}"))]
    Report(Report),
    /// Find and unfold the resonant grazing bifurcations of an oscillator from a text file
    #[command(next_line_help = true, after_help = format!("{EXAMPLES_OF_UNFOLD}{EXIT_CODES}"))]
    Unfold(Unfold),
    /// Explore the diagram in a browser: move constants, point at places, zoom
    #[command(next_line_help = true, after_help = format!("{EXAMPLES_OF_EXPLORE}{EXIT_CODES}"))]
    Explore(Explore),
    /// Join the parts of a family that `unfold --part` computed
    #[command(next_line_help = true, after_help = format!("{EXAMPLES_OF_MERGE}{EXIT_CODES}"))]
    Merge(Merge),
    /// Write a description of an oscillator to begin with, to be changed and unfolded
    #[command(next_line_help = true, after_help = format!("{EXAMPLES_OF_NEW}{EXIT_CODES}"))]
    New(New),
}

/// The arguments of `grazing reproduce`.
#[derive(Debug, Args)]
pub struct Reproduce {
    /// Make this output only; may be given several times
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(output_names()))]
    pub only: Vec<String>,
    /// Write nothing; fail if files are not what the code makes, naming them and what mends them
    #[arg(long)]
    pub check: bool,
    #[command(flatten)]
    pub(crate) parameters: ParameterFile,
    #[command(flatten)]
    pub(crate) look: Look,
    /// Folder for the figures, with data/ for tables [default: figures, or journal beside it]
    #[arg(long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) threads: Threads,
}

/// What figures are made as.
#[derive(Debug, Args)]
pub struct Look {
    /// Formats, separated by commas; tex: LaTeX tables, and figures.tex to include all, with PDF
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "svg")]
    pub format: Vec<Format>,
    /// Width of the figures: as in the paper, one column (86 mm) or two (178 mm) of a journal
    #[arg(long, value_name = "WIDTH", default_value = "paper", value_parser = widths())]
    pub columns: SheetWidth,
    /// Dots per inch of PNG
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u16).range(50..=1200))]
    pub dpi: u16,
}

impl Look {
    /// Formats and width as an edition.
    pub fn edition(&self) -> Edition {
        Edition::new(self.format.clone(), self.columns, self.dpi)
    }
}

/// How many threads compute.
#[derive(Debug, Args)]
pub struct Threads {
    /// Number of threads; the outputs do not depend on it [default: one for each core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
}

impl Threads {
    /// Sets their number.
    pub(crate) fn start(&self) -> Result<(), Failure> {
        let Some(jobs) = self.jobs else { return Ok(()) };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(usize::from(jobs));
        pool.build_global()
            .map_err(|error| Failure::input(format!("{jobs} threads could not be started: {error}")))
    }
}

/// The arguments of `grazing claims`.
#[derive(Debug, Args)]
pub struct Claims {
    /// Labels of the paper, as eq:gp; * stands for anything, as in 'th:*' [default: all]
    #[arg(value_name = "LABEL")]
    pub labels: Vec<String>,
    /// Only claims of this kind
    #[arg(long, value_name = "KIND", value_parser = PossibleValuesParser::new(claim_kinds()))]
    pub kind: Option<String>,
    /// Only where print and mathematics differ
    #[arg(long)]
    pub misprints: bool,
    /// Print all that is known of each claim: statement, samples, functions, check, figures
    #[arg(long)]
    pub explain: bool,
    /// Test all claims and write ERRATA.md, the page of misprints, instead of checking it
    #[arg(long, conflicts_with_all = ["labels", "kind", "misprints"])]
    pub write_errata: bool,
    #[command(flatten)]
    pub(crate) parameters: ParameterFile,
}

/// The arguments of `grazing report`.
#[derive(Debug, Args)]
pub struct Report {
    /// File of the page
    #[arg(long, value_name = "FILE", default_value = "report.html")]
    pub output: PathBuf,
    /// Oscillator to show beside those of examples/, as a text file; may be given several times
    #[arg(long = "oscillator", value_name = "FILE")]
    pub oscillators: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) parameters: ParameterFile,
    #[command(flatten)]
    pub(crate) threads: Threads,
}

/// The arguments of `grazing unfold`.
#[derive(Debug, Args)]
pub struct Unfold {
    /// Description of an oscillator, as examples/duffing.toml; there may be several
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// Folder for the results, of several files with one for each in it [default: unfolded/NAME]
    #[arg(long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) look: Look,
    /// Numbers of loops p, separated by commas [default: those of the file]
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub loops: Option<Vec<u32>>,
    /// Value for a key of the files, in its place; a name alone is that of a constant
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<Setting>,
    /// Resonances and coefficients for COUNT values of a constant; up to three times
    #[arg(long, value_name = "NAME=FROM:TO:COUNT")]
    pub vary: Vec<Variation>,
    /// Compute only this part of the family, to be joined with the others by `merge`
    #[arg(long, value_name = "K/N", requires = "vary")]
    pub part: Option<Part>,
    #[command(flatten)]
    pub(crate) threads: Threads,
    /// Print every hypothesis and every quantity of every resonance
    #[arg(long)]
    pub explain: bool,
    /// Seconds after which a file's analysis ends with what it has [default: the file's, or 600]
    #[arg(long, value_name = "SECONDS", value_parser = positive)]
    pub time_limit: Option<f64>,
    /// Memory at which it ends likewise, in megabytes [default: the file's, or 2000]
    #[arg(long, value_name = "MB", value_parser = positive)]
    pub memory_limit: Option<f64>,
    /// Steps of integration after which it ends likewise [default: the file's, or 1e10]
    #[arg(long, value_name = "N", value_parser = positive)]
    pub step_limit: Option<f64>,
}

impl Unfold {
    /// The limits that are given, and those of a file where none is.
    pub(crate) fn limits(&self, file: Limits) -> Limits {
        Limits {
            time: self.time_limit.unwrap_or(file.time),
            memory: self.memory_limit.unwrap_or(file.memory),
            steps: self.step_limit.unwrap_or(file.steps),
        }
    }
}

/// The arguments of `grazing explore`.
#[derive(Debug, Args)]
pub struct Explore {
    /// Description of an oscillator to begin with [default: the paper's]
    #[arg(value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Port of the loopback interface; 0: any that is free
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub port: u16,
    /// Do not open a browser
    #[arg(long)]
    pub no_browser: bool,
}

/// The arguments of `grazing merge`.
#[derive(Debug, Args)]
pub struct Merge {
    /// All parts of a family, as `unfold --part` writes them
    #[arg(value_name = "PART", required = true)]
    pub parts: Vec<PathBuf>,
    /// Folder for the results [default: families/NAME]
    #[arg(long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) look: Look,
}

/// The arguments of `grazing new`.
#[derive(Debug, Args)]
pub struct New {
    /// The file to be written, which must not be there yet
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// What it begins with
    #[arg(long, value_name = "KIND", default_value = "plain")]
    pub kind: Template,
}

/// What a description of one's own begins with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Template {
    /// A mass on a spring beside a wall at x = 0, without units
    Plain,
    /// A mass over a table that shakes: the wall moves
    MovingWall,
    /// A rig in metres, kilograms and seconds, its stop at a distance
    Si,
}

/// The parameter file, which all commands share.
#[derive(Debug, Args)]
pub struct ParameterFile {
    /// File of parameters [default: figures/parameters.toml, in this folder or the nearest above]
    #[arg(long = "parameters", value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Value for a key of the parameter file, in its place; may be given several times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<Setting>,
}

/// A limit.
fn positive(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(value) if f64::is_finite(value) && value > 0.0 => Ok(value),
        _ => Err("it must be a positive number".to_owned()),
    }
}

/// How wide figures are made.
fn widths() -> impl TypedValueParser<Value = SheetWidth> {
    let words = WIDTHS.map(|(word, _, help)| PossibleValue::new(word).help(help));
    PossibleValuesParser::new(words).map(|word| edition::width(&word))
}

/// Formats of figures: all but LaTeX.
fn output_names() -> impl Iterator<Item = PossibleValue> {
    outputs::ALL.iter().map(|output| PossibleValue::new(output.name).help(output.title))
}

fn claim_kinds() -> impl Iterator<Item = PossibleValue> {
    ClaimKind::ALL.into_iter().map(|kind| PossibleValue::new(kind.name()).help(kind.meaning()))
}
