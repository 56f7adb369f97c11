//! Where the default parameters and the default output folder are.

use std::env;
use std::path::{Path, PathBuf};

use grazing_reproduction::parameters::Parameters;

use crate::failure::Failure;

/// The default parameter file, from the root of the repository.
pub(crate) const PARAMETERS: &str = "figures/parameters.toml";
/// The default output folder, from the root of the repository.
pub(crate) const FIGURES: &str = "figures";

/// The nearest folder, from the current one upwards, that holds the default parameter file; relative, as `../..`, so that
/// messages name no folder above it.
pub(crate) fn root() -> Option<PathBuf> {
    let here = env::current_dir().ok()?;
    let above = here.ancestors().count();
    (0..above).map(|steps| PathBuf::from_iter(vec![".."; steps])).find(|root| root.join(PARAMETERS).is_file())
}

/// The parameters of the file that was named, or of the default one.
///
/// # Errors
/// [`Failure::NoProject`] if none was named and there is no default one; [`Failure::Parameters`].
pub(crate) fn parameters(named: Option<&Path>) -> Result<Parameters, Failure> {
    Ok(Parameters::from_file(&parameter_file(named)?)?)
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

/// The folder that was named, or the default one.
///
/// # Errors
/// [`Failure::NoProject`] if none was named and there is no default one.
pub(crate) fn output_folder(named: Option<&Path>) -> Result<PathBuf, Failure> {
    match named {
        Some(folder) => Ok(folder.to_owned()),
        None => Ok(root().ok_or(Failure::NoProject)?.join(FIGURES)),
    }
}
