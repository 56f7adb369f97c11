//! What can be written on the command line.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, Parser, Subcommand};

use crate::outputs;

/// What the exit codes mean, for the end of the help.
const EXIT_CODES: &str = "\
Exit codes:
  0  all went well
  1  a check failed: files are not what the code makes, or a published value is not met
  2  bad input: command line, parameter file, or a folder that cannot be written;
     nothing was written
  3  the computation failed; nothing was written
  4  a file could not be read or written all the same, as on a full disk;
     each file is either old or new";

const ABOUT: &str = "\
Regenerates the numerical results of \"Resonant grazing bifurcations revisited\" by
D. J. W. Simpson and I. Ghosh (arXiv 2602.22797): its figures as SVG, every number drawn as
CSV, and a comparison with the numbers that the paper prints.

In a clone of the repository, `cargo xtask COMMAND` builds this program and runs `grazing COMMAND`.";

const EXAMPLES_OF_REPRODUCE: &str = "\
Examples:
  cargo xtask reproduce                  all figures and data, into figures/
  cargo xtask reproduce --only fig07     Figure 7 and its data
  cargo xtask reproduce --check          write nothing; fail if figures/ is not what the code makes
  cargo xtask reproduce --parameters mine.toml --output mine

Files are replaced whole and only once everything is computed: an interrupted run leaves each of
them old or new. A published value that is not met is reported, but fails `compare` only.

";

const EXAMPLES_OF_COMPARE: &str = "\
Examples:
  cargo xtask compare
  cargo xtask compare --parameters mine.toml

A value is met if, rounded to the digits that the paper prints, it is the print; the printed values
stand in expected/published.toml.

";

const EXAMPLES_OF_REPORT: &str = "\
Examples:
  cargo xtask report                     writes report.html; open it in a browser
  cargo xtask report --output mine.html --parameters mine.toml

One page for all: figures with the values behind them, tables, the published values, every claim
with the computation that tests it, misprints, and the SHA-256 of each output. It needs no network.
What is not met or does not hold is shown as such on the page and in the summary, and does not make
this fail.

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
    Compare(Compare),
    /// Write one page with figures, tables, claims and a manifest, to be read in a browser
    #[command(next_line_help = true, after_help = format!("{EXAMPLES_OF_REPORT}{EXIT_CODES}"))]
    Report(Report),
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
    /// The parameter file.
    #[command(flatten)]
    pub parameters: ParameterFile,
    /// Folder for the figures, with data/ for tables [default: that of the default parameters]
    #[arg(long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Number of threads; the outputs do not depend on it [default: one for each core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
}

/// The arguments of `grazing compare`.
#[derive(Debug, Args)]
pub struct Compare {
    /// The parameter file.
    #[command(flatten)]
    pub parameters: ParameterFile,
}

/// The arguments of `grazing report`.
#[derive(Debug, Args)]
pub struct Report {
    /// File of the page
    #[arg(long, value_name = "FILE", default_value = "report.html")]
    pub output: PathBuf,
    /// The parameter file.
    #[command(flatten)]
    pub parameters: ParameterFile,
    /// Number of threads; the page does not depend on it [default: one for each core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
}

/// The parameter file, which all commands share.
#[derive(Debug, Args)]
pub struct ParameterFile {
    /// File of parameters [default: figures/parameters.toml, in this folder or the nearest above]
    #[arg(long = "parameters", value_name = "FILE")]
    pub file: Option<PathBuf>,
}

fn output_names() -> impl Iterator<Item = PossibleValue> {
    outputs::ALL.iter().map(|output| PossibleValue::new(output.name).help(output.title))
}
