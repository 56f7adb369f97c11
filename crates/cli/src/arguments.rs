//! What can be written on the command line.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use grazing_claims::ledger::ClaimKind;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_drawing::SheetWidth;
use grazing_input::{AnalysisLimits, Setting};

mod values;

use self::values::{column, curve, date, place, positive, size};
use crate::failure::Failure;
use crate::outputs::edition::{Edition, Format, TextForm, WIDTHS};
use crate::outputs::{self, edition};
use crate::variation::{PartNumber, Variation};
use crate::{commands, examples};

macro_rules! help {
    ($($name:literal)+) => {
        /// The commands, with what their help says after the options: `{grazing}` stands for the program.
        const HELP: &[(&str, &str)] = &[$(($name, include_str!(concat!("../help/", $name, ".txt")))),+];
    };
}

help! {
    "reproduce" "compare" "claims" "certify" "report" "unfold" "attractors" "explore" "identify" "merge" "new" "schema"
    "export" "archive" "completions" "manual"
}

const EXIT_CODES: &str = include_str!("../help/exit_codes.txt");

/// The command line with all its help, for a program that is started by this command.
pub fn command_line(program: &str) -> clap::Command {
    let whole = Arguments::command().after_long_help(EXIT_CODES.trim_ascii());
    HELP.iter().fold(whole, |whole, (name, help)| {
        let help = commands::filled(&format!("{help}\n{EXIT_CODES}"), program);
        whole.mut_subcommand(name, |command| command.after_long_help(help.trim_ascii().to_owned()))
    })
}

/// Recomputes the numerical results of "Resonant grazing bifurcations revisited" (arXiv 2602.22797)
#[derive(Debug, Parser)]
#[command(name = "grazing", version, subcommand_required = true, arg_required_else_help = true)]
#[command(long_about = include_str!("../help/about.txt").trim_ascii(), max_term_width = 80)]
pub struct Arguments {
    /// The subcommand.
    #[command(subcommand)]
    pub command: Command,
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Compute all figures and tables, or check the existing ones
    Reproduce(ReproduceArguments),
    /// Compare values with the published ones, or curves with another program's
    Compare(CompareArguments),
    /// Test the claims of the paper, label by label
    Claims(ClaimsArguments),
    /// Prove what Figure 7 shows and write a certificate
    Certify(CertifyArguments),
    /// Write all results on one page, to be read in a browser
    Report(ReportArguments),
    /// Find and unfold resonant grazing bifurcations of an oscillator
    Unfold(UnfoldArguments),
    /// Map the attractors over the window of Figure 7
    Attractors(AttractorsArguments),
    /// Explore the diagram of an oscillator in a browser
    Explore(ExploreArguments),
    /// Identify constants of an oscillator from measurements
    Identify(IdentifyArguments),
    /// Join the parts of a family or a map computed with `--part`
    Merge(MergeArguments),
    /// Write the description of an oscillator, to be edited
    New(NewArguments),
    /// Print the JSON schema of an oscillator file, for editors
    Schema(SchemaArguments),
    /// Write a problem for AUTO-07p that starts at a periodic solution
    Export(ExportArguments),
    /// Pack results and their sources for an archive
    Archive(ArchiveArguments),
    /// Print a script that completes commands and options in a shell
    Completions(CompletionsArguments),
    /// Write manual pages, one for each command
    Manual(ManualArguments),
}

/// The arguments of `grazing reproduce`.
#[derive(Debug, Args)]
pub struct ReproduceArguments {
    /// Compute only this output; may be given several times
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(output_names()))]
    pub only: Vec<String>,
    /// Write nothing; fail if files differ from what the code produces, and name them with the remedy
    #[arg(long)]
    pub check: bool,
    #[command(flatten)]
    pub(crate) parameters: ParameterFile,
    #[command(flatten)]
    pub(crate) look: FigureArguments,
    /// Folder for the figures, with data/ for tables [default: figures, or journal beside it]
    #[arg(long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) threads: Threads,
}

/// The form of the figures.
#[derive(Debug, Args)]
pub struct FigureArguments {
    /// Formats, separated by commas; tex: LaTeX tables, PDF, and figures.tex that includes all; parquet: tables in addition to CSV
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "svg")]
    pub format: Vec<Format>,
    /// Width of the figures: as in the paper, one column (86 mm) or two (178 mm) of a journal
    #[arg(long, value_name = "WIDTH", default_value = "paper", value_parser = widths())]
    pub columns: SheetWidth,
    /// Dots per inch of PNG
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u16).range(50..=1200))]
    pub dpi: u16,
    /// Labels as text in embedded fonts, or as paths for programs that ignore embedded fonts
    #[arg(long, value_name = "FORM", value_enum, default_value_t)]
    pub text: TextForm,
}

impl FigureArguments {
    /// Formats and width as an edition.
    pub fn edition(&self) -> Edition {
        Edition::new(self.format.clone(), self.columns, self.dpi, self.text)
    }
}

/// The number of threads.
#[derive(Debug, Args)]
pub struct Threads {
    /// Number of threads; it does not change the outputs [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
}

/// Changes to values in the description of an oscillator.
#[derive(Debug, Args)]
pub struct Changes {
    /// Numbers of loops p, separated by commas [default: those of the file]
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub loops: Option<Vec<u32>>,
    /// Replace the value of a key of the file; a name alone is a constant; may be given several times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<Setting>,
}

/// The arguments of `grazing claims`.
#[derive(Debug, Args)]
pub struct ClaimsArguments {
    /// Labels of the paper, such as eq:gp; * matches anything, as in 'th:*' [default: all]
    #[arg(value_name = "LABEL")]
    pub labels: Vec<String>,
    /// Only claims of this kind
    #[arg(long, value_name = "KIND", value_parser = PossibleValuesParser::new(claim_kinds()))]
    pub kind: Option<String>,
    /// Only claims where the printed text and the mathematics differ
    #[arg(long)]
    pub misprints: bool,
    /// Print statement, samples, functions, check and figures of each claim
    #[arg(long)]
    pub explain: bool,
    /// Test all claims and write docs/ERRATA.md, the list of errata, instead of checking it
    #[arg(long, conflicts_with_all = ["labels", "kind", "misprints"])]
    pub write_errata: bool,
    #[command(flatten)]
    pub(crate) parameters: ParameterFile,
}

/// The columns of a CSV that have other names than those that are read.
#[derive(Debug, Args)]
pub struct NamedColumns {
    /// The column of the CSV that holds NAME (a parameter, seen, p, ...), by its name or number; may be given several times
    #[arg(id = "column", long, value_name = "NAME=COLUMN", value_parser = column)]
    columns: Vec<(String, String)>,
}

impl NamedColumns {
    /// Pairs of a name and a column.
    ///
    /// # Errors
    /// There are some, and no CSV.
    pub(crate) fn of(&self, csv: Option<&Path>) -> Result<&[(String, String)], Failure> {
        if csv.is_none() && !self.columns.is_empty() {
            return Err(Failure::input("--column names columns of a CSV, and none is given"));
        }
        Ok(&self.columns)
    }
}

/// The arguments of `grazing compare`.
#[derive(Debug, Args)]
pub struct CompareArguments {
    /// CSV of bifurcation curves from another program [default: compare the published values]
    #[arg(value_name = "CSV", requires = "oscillator")]
    pub curves: Option<PathBuf>,
    /// The oscillator that these curves belong to, as a text file
    #[arg(long, value_name = "FILE", requires = "curves", conflicts_with = "file")]
    pub oscillator: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) named: NamedColumns,
    /// Kind and number of loops of all curves, such as SN:2, if no column has them
    #[arg(long, value_name = "KIND:P", requires = "curves", value_parser = curve)]
    pub curve: Option<(Bifurcation, Option<u32>)>,
    /// The largest distance accepted, as a share of the ranges
    #[arg(long, value_name = "SHARE", requires = "curves", default_value_t = 1e-3, value_parser = positive)]
    pub within: f64,
    #[command(flatten)]
    pub(crate) parameters: ParameterFile,
    #[command(flatten)]
    pub(crate) threads: Threads,
}

/// The arguments of `grazing certify`.
#[derive(Debug, Args)]
pub struct CertifyArguments {
    /// Write nothing; fail if the certificate differs from what the code produces
    #[arg(long)]
    pub check: bool,
    /// Folder for the certificate [default: expected/certificate, or varied/certificate with --set]
    #[arg(long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) parameters: ParameterFile,
    #[command(flatten)]
    pub(crate) threads: Threads,
}

/// The arguments of `grazing report`.
#[derive(Debug, Args)]
pub struct ReportArguments {
    /// File of the page
    #[arg(long, value_name = "FILE", default_value = "report.html")]
    pub output: PathBuf,
    /// Another oscillator to show, as a text file; may be given several times
    #[arg(long = "oscillator", value_name = "FILE")]
    pub oscillators: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) parameters: ParameterFile,
    #[command(flatten)]
    pub(crate) threads: Threads,
}

/// The arguments of `grazing unfold`.
#[derive(Debug, Args)]
pub struct UnfoldArguments {
    /// Descriptions of oscillators, such as examples/duffing.toml
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// Folder for the results; with several files, each gets a subfolder [default: unfolded/NAME]
    #[arg(long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) look: FigureArguments,
    #[command(flatten)]
    pub(crate) changes: Changes,
    /// Resonances and coefficients for COUNT values of a constant; may be given up to three times
    #[arg(long, value_name = "NAME=FROM:TO:COUNT")]
    pub vary: Vec<Variation>,
    /// Compute only part K of N of the family; `merge` joins the parts
    #[arg(long, value_name = "K/N", requires = "vary")]
    pub part: Option<PartNumber>,
    /// CSV of measurements, to be compared and drawn
    #[arg(long, value_name = "CSV", conflicts_with = "vary")]
    pub data: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) named: NamedColumns,
    /// Attractors and basins of attraction at these parameters; may be given several times
    #[arg(long, value_name = "PRIMARY,SECONDARY", conflicts_with = "vary", value_parser = place, allow_hyphen_values = true)]
    pub at: Vec<[f64; 2]>,
    #[command(flatten)]
    pub(crate) threads: Threads,
    /// Print every hypothesis and every quantity of every resonance
    #[arg(long)]
    pub explain: bool,
    #[command(flatten)]
    pub(crate) limits: LimitArguments,
}

/// Limits of the analysis. Drawing and writing come after it and are not ended by them.
#[derive(Debug, Args)]
pub struct LimitArguments {
    /// CPU seconds after which the analysis stops; drawing and writing what it has come after [default: the file's, or 600]
    #[arg(long, value_name = "SECONDS", value_parser = positive)]
    pub time_limit: Option<f64>,
    /// Memory in megabytes at which the analysis stops; a PNG for which it leaves no room is not drawn [default: the file's, or 2000]
    #[arg(long, value_name = "MB", value_parser = positive)]
    pub memory_limit: Option<f64>,
    /// Integration steps after which the analysis stops [default: the file's, or 1e10]
    #[arg(long, value_name = "N", value_parser = positive)]
    pub step_limit: Option<f64>,
}

impl LimitArguments {
    /// The limits given on the command line, or else those of a file.
    pub(crate) fn over(&self, file: AnalysisLimits) -> AnalysisLimits {
        AnalysisLimits {
            time: self.time_limit.unwrap_or(file.time),
            memory: self.memory_limit.unwrap_or(file.memory),
            steps: self.step_limit.unwrap_or(file.steps),
        }
    }
}

/// The arguments of `grazing attractors`.
#[derive(Debug, Args)]
pub struct AttractorsArguments {
    /// Numbers of columns and rows of the map
    #[arg(long, value_name = "COLUMNSxROWS", default_value = "1000x1000", value_parser = size)]
    pub size: [u32; 2],
    /// Compute only part K of N of the rows; `merge` joins the parts
    #[arg(long, value_name = "K/N")]
    pub part: Option<PartNumber>,
    /// Folder for the results [default: attractors]
    #[arg(long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) parameters: ParameterFile,
    #[command(flatten)]
    pub(crate) look: FigureArguments,
    #[command(flatten)]
    pub(crate) threads: Threads,
}

/// The arguments of `grazing explore`.
#[derive(Debug, Args)]
pub struct ExploreArguments {
    /// Description of the oscillator to show first [default: the paper's]
    #[arg(value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Port of the loopback interface; 0 chooses a free one
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub port: u16,
    /// Do not open a browser
    #[arg(long)]
    pub no_browser: bool,
    /// Write the page as a folder of static files for any web server
    #[arg(long, value_name = "DIR", requires = "program", conflicts_with_all = ["port", "no_browser"])]
    pub static_files: Option<PathBuf>,
    /// The program compiled to WebAssembly by `packaging/web/run`, for --static-files
    #[arg(long, value_name = "WASM", requires = "static_files")]
    pub program: Option<PathBuf>,
}

/// The arguments of `grazing identify`.
#[derive(Debug, Args)]
pub struct IdentifyArguments {
    /// Description of an oscillator, such as examples/leaf-spring.toml
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// CSV of measured bifurcations
    #[arg(long, value_name = "CSV", required_unless_present = "record")]
    pub data: Option<PathBuf>,
    /// CSV of impacts: times, and velocities before and after
    #[arg(long, value_name = "CSV")]
    pub record: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) named: NamedColumns,
    /// Constants to identify, separated by commas; the others keep the values in the file
    #[arg(long, value_name = "LIST", value_delimiter = ',', required = true)]
    pub free: Vec<String>,
    #[command(flatten)]
    pub(crate) changes: Changes,
    /// Folder for the results [default: identified/NAME]
    #[arg(long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) threads: Threads,
    #[command(flatten)]
    pub(crate) limits: LimitArguments,
}

/// The arguments of `grazing merge`.
#[derive(Debug, Args)]
pub struct MergeArguments {
    /// All parts of a family or a map, as written with `--part`
    #[arg(value_name = "PART", required = true)]
    pub parts: Vec<PathBuf>,
    /// Folder for the results [default: families/NAME, or attractors]
    #[arg(long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) look: FigureArguments,
}

/// The arguments of `grazing new`.
#[derive(Debug, Args)]
pub struct NewArguments {
    /// The file to write; it must not exist yet
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// One of three simple oscillators, or an example
    #[arg(long, value_name = "KIND", default_value = "plain", value_parser = PossibleValuesParser::new(kinds()))]
    pub kind: String,
}

/// The arguments of `grazing schema`.
#[derive(Debug, Args)]
pub struct SchemaArguments {
    /// The files to describe
    #[arg(long, value_name = "FILES", value_enum, default_value_t)]
    pub of: Written,
}

/// A kind of file that people write.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub enum Written {
    /// An oscillator, as for `unfold`
    #[default]
    Oscillator,
    /// The parameters of the figures, as for `reproduce`
    Parameters,
}

/// The arguments of `grazing export`.
#[derive(Debug, Args)]
pub struct ExportArguments {
    /// Description of an oscillator, such as examples/duffing.toml
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Parameters of the solution; a stable one is preferred
    #[arg(long, value_name = "PRIMARY,SECONDARY", value_parser = place, allow_hyphen_values = true)]
    pub at: [f64; 2],
    #[command(flatten)]
    pub(crate) changes: Changes,
    /// Folder for the files [default: exported/NAME]
    #[arg(long, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

/// The arguments of `grazing archive`.
#[derive(Debug, Args)]
pub struct ArchiveArguments {
    /// Folders of results, and files [default: in a clone, those of the paper]
    #[arg(value_name = "PATH")]
    pub paths: Vec<PathBuf>,
    /// File to write [default: grazing-VERSION.tar]
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Date of publication, which archives require
    #[arg(long, value_name = "YYYY-MM-DD", value_parser = date)]
    pub date: String,
    /// Licence as an SPDX expression [default: for the paper's results, that of this program]
    #[arg(long, value_name = "LICENCE")]
    pub licence: Option<String>,
}

/// The arguments of `grazing completions`.
#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell that is to complete commands and options
    pub shell: Shell,
}

/// The arguments of `grazing manual`.
#[derive(Debug, Args)]
pub struct ManualArguments {
    /// Folder for the pages (grazing.1 and others)
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}

/// The parameter file, common to several commands.
#[derive(Debug, Args)]
pub struct ParameterFile {
    /// Parameter file [default: figures/parameters.toml in this folder or the nearest one above]
    #[arg(long = "parameters", value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Replace the value of a key of the parameter file; may be given several times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<Setting>,
}

/// The widths of figures.
fn widths() -> impl TypedValueParser<Value = SheetWidth> {
    let words = WIDTHS.map(|(word, _, help)| PossibleValue::new(word).help(help));
    PossibleValuesParser::new(words).map(|word| edition::width(&word))
}

/// The oscillators that a new description can start from.
fn kinds() -> impl Iterator<Item = PossibleValue> {
    examples::kinds().map(|kind| PossibleValue::new(kind.name).help(kind.about))
}

/// The names of outputs, with their titles.
fn output_names() -> impl Iterator<Item = PossibleValue> {
    outputs::ALL.iter().map(|output| PossibleValue::new(output.name).help(output.title.to_string()))
}

fn claim_kinds() -> impl Iterator<Item = PossibleValue> {
    ClaimKind::ALL.into_iter().map(|kind| PossibleValue::new(kind.name()).help(kind.meaning()))
}
