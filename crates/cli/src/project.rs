//! The places of the default parameters and of the default output folder.

use std::env;
use std::path::{Path, PathBuf};

use grazing_beyond::parameters::parse;
use grazing_input::Text;
use grazing_reproduction::parameters::{ParameterError, Parameters};

use crate::arguments::ParameterFile;
use crate::failure::Failure;
use crate::outputs::edition::Edition;

/// The default parameter file, from the root of the repository.
pub(crate) const PARAMETERS: &str = "figures/parameters.toml";
/// The text of the default parameter file, for use outside a clone.
pub(crate) const PARAMETERS_TEXT: &str = include_str!("../../../figures/parameters.toml");
/// The default output folder, from the root of the repository.
pub(crate) const FIGURES: &str = "figures";

/// The default output folder for other formats and widths.
const JOURNAL: &str = "journal";
/// The default output folder for results with settings over the parameter file.
const VARIED: &str = "varied";

/// The nearest folder, from the current one upwards, that holds the default parameter file;
/// relative, as `../..`, so that messages name no folder above it.
pub(crate) fn root() -> Option<PathBuf> {
    let here = env::current_dir().ok()?;
    let above = here.ancestors().count();
    (0..above).map(|steps| PathBuf::from_iter(vec![".."; steps])).find(|root| root.join(PARAMETERS).is_file())
}

/// The parameters of the named file, or of the default one, with the settings over it.
///
/// # Errors
/// The file cannot be read, or its content is wrong.
pub(crate) fn parameters(asked: &ParameterFile) -> Result<Parameters, Failure> {
    let (file, text) = parameter_file(asked.file.as_deref())?;
    Ok(parse(&Text::new(&text, &asked.set), &file)?)
}

impl ParameterFile {
    /// The options that name these parameters.
    pub(crate) fn options(&self) -> impl Iterator<Item = (&'static str, String)> {
        let file = self.file.iter().map(|file| ("--parameters", file.display().to_string()));
        file.chain(self.set.iter().map(|setting| ("--set", setting.to_string())))
    }
}

/// Name and text of the named parameter file, or of the default one, which is built in for use
/// outside a clone.
///
/// # Errors
/// The file cannot be read.
pub(crate) fn parameter_file(named: Option<&Path>) -> Result<(String, String), Failure> {
    let Some(file) = named.map(Path::to_owned).or_else(|| Some(root()?.join(PARAMETERS))) else {
        return Ok((PARAMETERS.to_owned(), PARAMETERS_TEXT.to_owned()));
    };
    let text = grazing_input::read_file(&file).map_err(ParameterError::from)?;
    Ok((file.display().to_string(), text))
}

/// The named folder, or the default one, which is another one if values were set (`varied`).
///
/// # Errors
/// No folder was named and there is no default one, or formats or widths other than the default
/// ones were to go to the default folder.
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
        return Ok(root_folder()?.join(folder));
    };
    let same = |default: &PathBuf| {
        default.canonicalize().is_ok_and(|default| named.canonicalize().is_ok_and(|named| named == default))
    };
    match root().map(|root| root.join(FIGURES)).filter(same) {
        Some(default) if !edition.is_default() => Err(Failure::input(format!(
            "{} holds SVG at the paper's widths only: for other formats and widths leave out --output or choose another folder",
            default.display()
        ))),
        _ => Ok(named.to_owned()),
    }
}

/// The root of the repository, for files that belong there.
///
/// # Errors
/// The current folder is in no clone.
pub(crate) fn root_folder() -> Result<PathBuf, Failure> {
    root().ok_or_else(|| {
        Failure::input(format!(
            "this is not a clone of the repository: no {PARAMETERS} in this folder or one above; choose a folder for the files \
             with --output DIR"
        ))
    })
}
