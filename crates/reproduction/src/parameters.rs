//! The parameters of the figures: a TOML file in, checked values out.
//!
//! A section is read and checked when it is requested ([`Parameters::section`]), so that an error in one
//! section does not prevent the use of another; each is defined with its figure.
//! `figures/parameters.toml` is the file of the paper's figures. No scientific parameter has a hidden
//! default, but the program may choose the positions of portraits and panels. All quantities are
//! dimensionless; a range is [lower, upper], finite, with lower < upper.

mod error;
pub(crate) mod limits;

use grazing_input::{Key, Keys, Requirements, Section, Source, Text, keys};
use grazing_theorems::LinearOscillator;

use limits::{EPSILON, ZETA, damping_ratio, restitution};

pub use error::ParameterError;
pub use limits::{MOST_LOOPS, contains, encloses, strictly_contains};

/// A section of the parameter file.
pub trait FileSection: Keys {
    /// The name of the section in the file.
    const NAME: &'static str;
    /// The message if the section is missing.
    const REQUIREMENT: &'static str;

    /// The checked section, once its keys are read: checks that involve several keys, or other sections.
    ///
    /// # Errors
    /// [`ParameterError`]: the first error.
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

/// The declaration of a section: its name, the message if it is missing, and its keys.
pub type Declaration = (&'static str, &'static str, fn(&str, &mut Vec<Key>));

/// The declaration of a section.
pub fn declaration<S: FileSection>() -> Declaration {
    (S::NAME, S::REQUIREMENT, S::list)
}

/// The requirements on the keys of a parameter file with these sections and that of the oscillator.
pub fn requirements(sections: impl IntoIterator<Item = Declaration>) -> Requirements {
    let none = Requirements::new("see figures/parameters.toml for what belongs here");
    let all = std::iter::once(declaration::<Oscillator>()).chain(sections);
    all.fold(none, |known, (name, requirement, list)| known.with_table(name, requirement, list))
}

/// All parameters of the figures and tables, section by section.
#[derive(Debug, Clone)]
pub struct Parameters {
    text: Text,
    file: String,
    requirements: &'static Requirements,
}

impl Parameters {
    /// The parameters in the text of a file that can have the keys of `requirements` ([`requirements`]);
    /// `file` is its name in messages.
    ///
    /// # Errors
    /// [`ParameterError`] if the text is not valid TOML or has unknown sections, and for settings of
    /// missing keys. Other errors in a section are reported when the section is requested.
    pub fn new(text: &Text, file: &str, requirements: &'static Requirements) -> Result<Self, ParameterError> {
        Source::new(text, file, requirements).check_top_level()?;
        Ok(Self { text: text.clone(), file: file.to_owned(), requirements })
    }

    /// Reads and checks a section.
    ///
    /// # Errors
    /// [`ParameterError`]: the first error in the section.
    pub fn section<S: FileSection>(&self) -> Result<S, ParameterError> {
        self.read(S::NAME, |section| S::read(section)?.checked(section, self))
    }

    /// The oscillator of the paper's example.
    ///
    /// # Errors
    /// [`ParameterError`]: its section is invalid.
    pub fn oscillator(&self) -> Result<LinearOscillator, ParameterError> {
        self.read(Oscillator::NAME, |section| {
            let Oscillator { zeta, epsilon } = Oscillator::read(section)?;
            LinearOscillator::new(zeta, epsilon)
                .map_err(|error| section.forbid("zeta", error.to_string()).into())
        })
    }

    /// Reads part of a section with a function, regardless of the rest of the section.
    pub(crate) fn read<T>(
        &self,
        name: &str,
        read: impl FnOnce(&Section<'_>) -> Result<T, ParameterError>,
    ) -> Result<T, ParameterError> {
        Source::new(&self.text, &self.file, self.requirements).section(name, |section| read(&section))
    }
}
