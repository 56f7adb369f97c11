//! Where the default parameters and the default output folder are.

use std::env;
use std::path::{Path, PathBuf};

use grazing_reproduction::parameters::{ParameterError, Parameters};
use grazing_source::Text;

use crate::arguments::ParameterFile;
use crate::failure::Failure;
use crate::outputs::edition::Edition;

/// The default parameter file, from the root of the repository.
pub(crate) const PARAMETERS: &str = "figures/parameters.toml";
/// Its text, for where there is no repository.
pub(crate) const PARAMETERS_TEXT: &str = include_str!("../../../figures/parameters.toml");
/// The default output folder, from the root of the repository.
pub(crate) const FIGURES: &str = "figures";
/// The folder of example oscillators, from the root of the repository.
pub(crate) const EXAMPLES: &str = "examples";
macro_rules! examples {
    ($($name:literal)+) => {
        /// The example oscillators, which are at hand outside the repository as well: file and text.
        pub(crate) const EXAMPLE_FILES: &[(&str, &str)] =
            &[$(($name, include_str!(concat!("../../../examples/", $name))),)+];
    };
}

examples! {
    "afm.toml" "base-excitation.toml" "clearance.toml" "door.toml" "drill.toml" "duffing.toml"
    "harvester.toml" "leaf-spring.toml" "paper.toml" "parametric.toml" "pendulum.toml" "quadratic-damping.toml"
    "relay.toml" "rig-si.toml" "shaking-table.toml" "two-harmonics.toml" "varying-impact.toml"
}

/// The default output folder of other formats and widths.
const JOURNAL: &str = "journal";
/// The default output folder of what is made with settings over the parameter file.
const VARIED: &str = "varied";

/// The nearest folder, from the current one upwards, that holds the default parameter file;
/// relative, as `../..`, so that messages name no folder above it.
pub(crate) fn root() -> Option<PathBuf> {
    let here = env::current_dir().ok()?;
    let above = here.ancestors().count();
    (0..above).map(|steps| PathBuf::from_iter(vec![".."; steps])).find(|root| root.join(PARAMETERS).is_file())
}

/// The parameters of the file that was named, or of the default one, with what was set.
///
/// # Errors
/// It cannot be read, or what it holds is not right.
pub(crate) fn parameters(asked: &ParameterFile) -> Result<Parameters, Failure> {
    let (file, text) = parameter_file(asked.file.as_deref())?;
    Ok(Parameters::parse(&Text::new(&text, &asked.set), &file)?)
}

/// Name and text of the parameter file that was named, or of the default one, which is built in for
/// where there is no repository.
///
/// # Errors
/// It cannot be read.
pub(crate) fn parameter_file(named: Option<&Path>) -> Result<(String, String), Failure> {
    let Some(file) = named.map(Path::to_owned).or_else(|| Some(root()?.join(PARAMETERS))) else {
        return Ok((PARAMETERS.to_owned(), PARAMETERS_TEXT.to_owned()));
    };
    let text = grazing_source::read_file(&file).map_err(ParameterError::from)?;
    Ok((file.display().to_string(), text))
}

/// The folder that was named, or the default one, which is another for values that were set
/// (`varied`).
///
/// # Errors
/// None was named and there is no default one, or other formats or widths than the default ones
/// were to go to the folder of the default ones.
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
            "{} holds SVG at the paper's widths only: leave --output out, or name another folder, for other formats and widths",
            default.display()
        ))),
        _ => Ok(named.to_owned()),
    }
}

/// The root of the repository, for what belongs there.
///
/// # Errors
/// There is none.
pub(crate) fn root_folder() -> Result<PathBuf, Failure> {
    root().ok_or_else(|| {
        Failure::input(format!(
            "no {PARAMETERS} in this folder or in one above, so this is no clone of the repository: name a folder for the files \
             with --output DIR"
        ))
    })
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::*;

    #[test]
    fn all_examples_of_the_folder_are_at_hand() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(EXAMPLES);
        let entries =
            fs::read_dir(folder).expect("it is there").map(|entry| entry.expect("it is").file_name());
        let names = entries.map(|name| name.into_string().expect("it is text"));
        let mut names: Vec<String> = names.filter(|name| name.ends_with(".toml")).collect();
        names.sort();
        assert_eq!(names, EXAMPLE_FILES.iter().map(|(name, _)| *name).collect::<Vec<_>>());
    }
}
