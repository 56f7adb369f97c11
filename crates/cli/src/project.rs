//! Where the default parameters and the default output folder are.

use std::env;
use std::path::{Path, PathBuf};

use grazing_reproduction::parameters::Parameters;

use crate::arguments::ParameterFile;
use crate::failure::Failure;
use crate::outputs::edition::Edition;

/// The default parameter file, from the root of the repository.
pub(crate) const PARAMETERS: &str = "figures/parameters.toml";
/// The default output folder, from the root of the repository.
pub(crate) const FIGURES: &str = "figures";
/// The folder of example oscillators, from the root of the repository.
pub(crate) const EXAMPLES: &str = "examples";
/// The default output folder of other formats and widths.
const JOURNAL: &str = "journal";
/// The default output folder of what is made with settings over the parameter file.
const VARIED: &str = "varied";

/// The nearest folder, from the current one upwards, that holds the default parameter file; relative, as `../..`, so that
/// messages name no folder above it.
pub(crate) fn root() -> Option<PathBuf> {
    let here = env::current_dir().ok()?;
    let above = here.ancestors().count();
    (0..above).map(|steps| PathBuf::from_iter(vec![".."; steps])).find(|root| root.join(PARAMETERS).is_file())
}

/// The parameters of the file that was named, or of the default one, with what was set.
///
/// # Errors
/// [`Failure::NoProject`] if none was named and there is no default one; [`Failure::Parameters`].
pub(crate) fn parameters(asked: &ParameterFile) -> Result<Parameters, Failure> {
    Ok(Parameters::from_file(&parameter_file(asked.file.as_deref())?, &asked.set)?)
}

/// The parameter file that was named, or the default one.
///
/// # Errors
/// [`Failure::NoProject`] if none was named and there is no default one.
pub(crate) fn parameter_file(named: Option<&Path>) -> Result<PathBuf, Failure> {
    match named {
        Some(file) => Ok(file.to_owned()),
        None => Ok(root().ok_or(Failure::NoProject)?.join(PARAMETERS)),
    }
}

/// The folder that was named, or the default one, which is another for values that were set (`varied`).
///
/// # Errors
/// [`Failure::NoProject`] if none was named and there is no default one; [`Failure::DefaultFolder`] if other formats or
/// widths than the default ones were to go to the folder of the default ones.
pub(crate) fn output_folder(
    named: Option<&Path>,
    edition: &Edition,
    varied: bool,
) -> Result<PathBuf, Failure> {
    let Some(named) = named else {
        let folder = match (varied, edition.is_default()) {
            (true, _) => VARIED,
            (false, true) => FIGURES,
            (false, false) => JOURNAL,
        };
        return Ok(root().ok_or(Failure::NoProject)?.join(folder));
    };
    let same = |default: &PathBuf| match (default.canonicalize(), named.canonicalize()) {
        (Ok(default), Ok(named)) => default == named,
        _ => false,
    };
    match root().map(|root| root.join(FIGURES)).filter(same) {
        Some(default) if !edition.is_default() => {
            Err(Failure::DefaultFolder { folder: default.display().to_string() })
        }
        _ => Ok(named.to_owned()),
    }
}

/// The root of the repository, for what belongs there.
///
/// # Errors
/// [`Failure::NoProject`].
pub(crate) fn root_folder() -> Result<PathBuf, Failure> {
    root().ok_or(Failure::NoProject)
}
