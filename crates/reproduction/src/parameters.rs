//! The parameters of the figures: a TOML file in, checked values out.
//!
//! A section is read and checked when it is asked for ([`Parameters::section`]), so that what is
//! not right in one keeps nobody from using another; each stands with the figure that it is for.
//! `figures/parameters.toml` is the file of the paper's figures; nothing of science has a hidden
//! default, but places of portraits and panels may be left to the program. All quantities are
//! dimensionless; a range is [lower, upper], finite, with lower < upper.

mod error;
pub(crate) mod limits;

use grazing_source::{Key, Keys, Requirements, Section, Source, Text, keys};
use grazing_theorems::LinearOscillator;

use limits::{EPSILON, ZETA, damping_ratio, restitution};

pub use error::ParameterError;
pub use limits::{contains, encloses, strictly_contains};

/// A section of the parameter file.
pub trait FileSection: Keys {
    /// Its name in the file.
    const NAME: &'static str;
    /// What is said of it where it is missing.
    const REQUIREMENT: &'static str;

    /// The section as it is used, once its keys are read: checks that tie several keys together, or
    /// to other sections.
    ///
    /// # Errors
    /// [`ParameterError`]: the first thing that is not right.
    fn checked(self, _section: &Section<'_>, _parameters: &Parameters) -> Result<Self, ParameterError> {
        Ok(self)
    }
}

keys! {
    /// The constants of the paper's oscillator.
    struct Oscillator {
        /// Damping ratio zeta of eq:oscf.
        zeta: f64 = damping_ratio(), ZETA;
        /// Coefficient of restitution epsilon of eq:oscResetLaw.
        epsilon: f64 = restitution(), EPSILON;
    }
}

impl FileSection for Oscillator {
    const NAME: &'static str = "oscillator";
    const REQUIREMENT: &'static str = "the table [oscillator] holds zeta and epsilon";
}

/// A section as it is declared: its name, what is said of it where it is missing, and its keys.
pub(crate) type Declaration = (&'static str, &'static str, fn(&str, &mut Vec<Key>));

/// The declaration of a section.
pub(crate) fn declaration<S: FileSection>() -> Declaration {
    (S::NAME, S::REQUIREMENT, S::list)
}

/// What the keys of a parameter file with these sections must hold, beside those of the oscillator.
pub(crate) fn requirements(sections: impl IntoIterator<Item = Declaration>) -> Requirements {
    let none = Requirements::new("see figures/parameters.toml for what belongs here");
    let all = std::iter::once(declaration::<Oscillator>()).chain(sections);
    all.fold(none, |known, (name, requirement, list)| known.with_table(name, requirement, list))
}

/// Everything that the figures and the tables depend on, section by section.
#[derive(Debug, Clone)]
pub struct Parameters {
    text: Text,
    file: String,
    requirements: &'static Requirements,
}

impl Parameters {
    /// The text of a parameter file; `file` is the name that messages use.
    pub(crate) fn new(
        text: &Text,
        file: &str,
        requirements: &'static Requirements,
    ) -> Result<Self, ParameterError> {
        Source::new(text, file, requirements).check_top_level()?;
        Ok(Self { text: text.clone(), file: file.to_owned(), requirements })
    }

    /// What a section says.
    ///
    /// # Errors
    /// [`ParameterError`]: the first thing in it that is not right.
    pub fn section<S: FileSection>(&self) -> Result<S, ParameterError> {
        self.read(S::NAME, |section| S::read(section)?.checked(section, self))
    }

    /// The oscillator of the paper's example.
    ///
    /// # Errors
    /// [`ParameterError`]: its section is not right.
    pub fn oscillator(&self) -> Result<LinearOscillator, ParameterError> {
        self.read(Oscillator::NAME, |section| {
            let Oscillator { zeta, epsilon } = Oscillator::read(section)?;
            LinearOscillator::new(zeta, epsilon)
                .map_err(|error| section.forbid("zeta", error.to_string()).into())
        })
    }

    /// What a function reads from a section, whatever else it holds.
    pub(crate) fn read<T>(
        &self,
        name: &str,
        read: impl FnOnce(&Section<'_>) -> Result<T, ParameterError>,
    ) -> Result<T, ParameterError> {
        Source::new(&self.text, &self.file, self.requirements).section(name, |section| read(&section))
    }
}
