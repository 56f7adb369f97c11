//! Reading oscillators from text files.

use std::path::{Path, PathBuf};
use std::time::Duration;

use grazing_input::{AnalysisLimits, Description, DescriptionError, Setting, Text, nearest, suggestion};
use grazing_measured::Setup;
use grazing_model::smooth::Stop;
use grazing_unfold::described::Prepared;

use crate::failure::Failure;
use crate::limits::reading;

/// A file that describes an oscillator.
#[derive(Clone)]
pub(crate) struct OscillatorFile {
    pub(crate) file: PathBuf,
    /// The text of the file.
    pub(crate) text: String,
    /// What replaces values in it.
    pub(crate) settings: Vec<Setting>,
    pub(crate) description: Description,
    /// The time that reading took.
    pub(crate) taken: Duration,
}

impl OscillatorFile {
    /// Reads a file within limits, with settings that replace values in it.
    ///
    /// # Errors
    /// The file cannot be read, something in it is wrong, or a limit was reached.
    pub(crate) fn read(file: &Path, set: &[Setting], limits: AnalysisLimits) -> Result<Self, Failure> {
        let (text, settings) = (read_text(file)?, settings(set));
        let (named, set) = (file.display().to_string(), Text::new(&text, &settings));
        let read = |stop: &Stop| Ok(Description::parse_with(&set, &named, stop)?);
        let (description, taken) = reading(file, limits, read)?;
        Ok(Self { file: file.to_owned(), text, settings, description, taken })
    }

    /// The oscillator with other numbers of loops, if there are any.
    pub(crate) fn looped(self, loops: Option<&[u32]>) -> Result<Self, Failure> {
        Ok(Self { description: with_loops(self.description, loops)?, ..self })
    }

    /// The oscillator, ready for an analysis that the mark cancels.
    pub(crate) fn prepared(&self, stop: &Stop) -> Prepared {
        Prepared::of(&self.description, stop)
    }
}

/// The text of a file that describes an oscillator.
pub(crate) fn read_text(file: &Path) -> Result<String, Failure> {
    Ok(grazing_input::read_file(file).map_err(DescriptionError::from)?)
}

/// The text of a file with the settings over it as comments at the top.
pub(crate) fn noted(text: &str, settings: &[Setting]) -> String {
    let set = settings.iter().map(|setting| format!("# --set {setting}\n"));
    set.chain([text.to_owned()]).collect()
}

/// The names of both parameters in the file.
pub(crate) fn parameter_names(description: &Description) -> [&str; 2] {
    [description.primary().name(), description.secondary().name()]
}

/// What the reader of measurements knows of an oscillator.
pub(crate) fn setup(description: &Description) -> Setup<'_> {
    Setup { names: parameter_names(description), two_walls: description.has_two_walls() }
}

/// The values of the constants that an option names, as the file has them.
///
/// # Errors
/// There is no such constant, or one is named twice.
pub(crate) fn constants<'n>(
    option: &str,
    names: impl IntoIterator<Item = &'n str>,
    description: &Description,
) -> Result<Vec<f64>, Failure> {
    let (known, values): (Vec<&str>, Vec<f64>) = description.constants().unzip();
    let mut found: Vec<usize> = Vec::new();
    for name in names {
        let Some(place) = known.iter().position(|known| *known == name) else {
            let (near, list) = (suggestion(nearest(name, &known)), known.join(", "));
            return Err(Failure::input(format!(
                "{option} {name}: no constant in [parameters] has this name{near} Known: {list}"
            )));
        };
        if found.contains(&place) {
            return Err(Failure::input(format!("{option} {name}: named twice: name every constant once")));
        }
        found.push(place);
    }
    Ok(found.into_iter().map(|place| values[place]).collect())
}

/// The last part of a path, as text.
pub(crate) fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The oscillator with the given numbers of loops, if there are any.
pub(crate) fn with_loops(description: Description, loops: Option<&[u32]>) -> Result<Description, Failure> {
    let Some(loops) = loops else { return Ok(description) };
    description.with_loops(loops).map_err(|reason| Failure::input(format!("--{reason}")))
}

/// The settings with full keys: `kappa` alone is the constant `parameters.kappa`.
pub(crate) fn settings(set: &[Setting]) -> Vec<Setting> {
    let full = |setting: &Setting| {
        let named = setting.key().contains('.') || ["name", "diagrams", "curves"].contains(&setting.key());
        if named { setting.clone() } else { setting.within("parameters") }
    };
    set.iter().map(full).collect()
}
