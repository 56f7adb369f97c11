//! The parameter file of all figures: its keys, and how it is read.

use std::path::Path;
use std::sync::LazyLock;

use grazing_input::{Requirements, Setting, Text, read_file};
use grazing_reproduction::parameters::{ParameterError, Parameters, declaration};

use crate::all_figures;

static REQUIREMENTS: LazyLock<Requirements> =
    LazyLock::new(|| grazing_reproduction::parameters::requirements(all_figures!(declaration)));

/// The keys that a parameter file can have, with their meanings and requirements.
pub fn requirements() -> &'static Requirements {
    &REQUIREMENTS
}

/// Reads a parameter file, with settings that replace values in it; its path appears in messages as given
/// here.
///
/// # Errors
/// As [`parse`], or the file cannot be read.
pub fn from_file(path: &Path, settings: &[Setting]) -> Result<Parameters, ParameterError> {
    let text = read_file(path)?;
    parse(&Text::new(&text, settings), &path.display().to_string())
}

/// The parameters in the text of a file; `file` is its name in messages.
///
/// # Errors
/// As [`Parameters::new`]: errors in a section are reported when the section is requested.
pub fn parse(text: &Text, file: &str) -> Result<Parameters, ParameterError> {
    Parameters::new(text, file, &REQUIREMENTS)
}
