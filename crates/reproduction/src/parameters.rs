//! The parameters of the figures: a TOML file in, checked values out.
//!
//! [`Parameters`] can be made from a file only; every section of it is checked by itself, and what is not right in one keeps
//! nobody from using another. `figures/parameters.toml` is the file of the paper's figures; nothing of science has a hidden
//! default, but places of portraits and panels may be left to the program. All quantities are dimensionless.

mod error;
mod fig02;
mod fig04;
mod fig05;
mod fig06;
mod fig07;
mod fig08;
mod fig10;
mod range;
mod raw;
mod requirements;
mod scenes;
mod space;
mod validate;

use std::path::Path;

use grazing_source::{Setting, Source, Text, read_file};
use grazing_theorems::LinearOscillator;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use toml::Spanned;

pub use error::ParameterError;
pub use fig02::{Attractor, Figure2, Place, Portrait};
pub use fig04::Figure4;
pub use fig05::Figure5;
pub use fig06::Figure6;
pub use fig07::Figure7;
pub use fig08::{Figure8, Panel};
pub use fig10::Figure10;
pub use range::{Range, Rectangle};
pub(crate) use requirements::MOST_PORTRAITS;
pub use space::{Arrival, Figure1, Figure3, Figure9, Specimen, View};
use validate::{Checked, demand};

/// Everything that the figures and the tables depend on, section by section.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameters {
    oscillator: Checked<LinearOscillator>,
    fig01: Checked<Figure1>,
    fig02: Checked<Figure2>,
    fig02_frequency: Checked<f64>,
    fig03: Checked<Figure3>,
    fig04: Checked<Figure4>,
    fig05: Checked<Figure5>,
    fig06: Checked<Figure6>,
    fig07: Checked<Figure7>,
    fig08: Checked<Figure8>,
    fig09: Checked<Figure9>,
    fig10: Checked<Figure10>,
}

impl Parameters {
    /// Reads and checks a parameter file; its path appears in messages as it is given here.
    ///
    /// # Errors
    /// As [`parse`](Self::parse), or the file cannot be read.
    pub fn from_file(path: &Path) -> Result<Parameters, ParameterError> {
        Parameters::from_file_with(path, &[])
    }

    /// As [`from_file`](Self::from_file), with settings that take the place of values in the file.
    ///
    /// # Errors
    /// As [`parse_with`](Self::parse_with), or the file cannot be read.
    pub fn from_file_with(path: &Path, settings: &[Setting]) -> Result<Parameters, ParameterError> {
        let text = read_file(path)?;
        Parameters::parse_with(&Text::new(&text, settings), &path.display().to_string())
    }

    /// Checks the text of a parameter file; `file` is the name that messages use.
    ///
    /// # Errors
    /// [`ParameterError`] if the text is no TOML or has sections that nobody reads. What else is wrong, the first thing in each
    /// section, is told to whoever asks for that section.
    pub fn parse(text: &str, file: &str) -> Result<Parameters, ParameterError> {
        Parameters::parse_with(&Text::new(text, &[]), file)
    }

    /// As [`parse`](Self::parse), with settings that take the place of values in the text.
    ///
    /// # Errors
    /// As [`parse`](Self::parse), and for settings of keys that are not there.
    pub fn parse_with(text: &Text, file: &str) -> Result<Parameters, ParameterError> {
        let source = &Source::new(text, file, requirements::REQUIREMENTS);
        source.check_top_level()?;
        let oscillator = read(source, "oscillator", |raw| check(raw, source));
        let of = || oscillator.as_ref().map_err(Clone::clone);
        let fig07 = read(source, "fig07", |raw| fig07::check(raw, of()?, source));
        let whole = || fig07.as_ref().map_err(Clone::clone);
        Ok(Parameters {
            fig01: read(source, "fig01", |raw| scenes::figure1(raw, source)),
            fig02: read(source, "fig02", |raw| fig02::check(raw, of()?, source)),
            fig02_frequency: read(source, "fig02", |raw| fig02::frequency(raw, source)),
            fig03: read(source, "fig03", |raw| scenes::figure3(raw, source)),
            fig04: read(source, "fig04", |raw| fig04::check(raw, source)),
            fig05: read(source, "fig05", |raw| fig05::check(raw, of()?, source)),
            fig06: read(source, "fig06", |raw| fig06::check(raw, of()?, source)),
            fig08: read(source, "fig08", |raw| fig08::check(raw, whole()?, of()?, source)),
            fig09: read(source, "fig09", |raw| scenes::figure9(raw, source)),
            fig10: read(source, "fig10", |raw| fig10::check(raw, of()?, source)),
            fig07,
            oscillator,
        })
    }

    /// The oscillator of the paper's example: damping ratio zeta of eq:oscf in (0, 1), coefficient of restitution epsilon of
    /// eq:oscResetLaw in (0, 1].
    ///
    /// # Errors
    /// Its section is not right.
    pub fn oscillator(&self) -> Result<&LinearOscillator, ParameterError> {
        self.oscillator.as_ref().map_err(Clone::clone)
    }

    /// What Figure 1 (fig:Bc) shows.
    ///
    /// # Errors
    /// Its section is not right.
    pub fn fig01(&self) -> Result<&Figure1, ParameterError> {
        self.fig01.as_ref().map_err(Clone::clone)
    }

    /// What Figure 2 (fig:Z) shows.
    ///
    /// # Errors
    /// Its section is not right.
    pub fn fig02(&self) -> Result<&Figure2, ParameterError> {
        self.fig02.as_ref().map_err(Clone::clone)
    }

    /// The forcing frequency of Figure 2, which Figure 4 and the printed numbers share, whatever else its section holds.
    ///
    /// # Errors
    /// It is not right.
    pub fn fig02_frequency(&self) -> Result<f64, ParameterError> {
        self.fig02_frequency.clone()
    }

    /// What Figure 3 (fig:Ba) shows.
    ///
    /// # Errors
    /// Its section is not right.
    pub fn fig03(&self) -> Result<&Figure3, ParameterError> {
        self.fig03.as_ref().map_err(Clone::clone)
    }

    /// What Figure 4 (fig:D) shows.
    ///
    /// # Errors
    /// Its section is not right.
    pub fn fig04(&self) -> Result<&Figure4, ParameterError> {
        self.fig04.as_ref().map_err(Clone::clone)
    }

    /// What Figure 5 (fig:E) shows.
    ///
    /// # Errors
    /// Its section is not right.
    pub fn fig05(&self) -> Result<&Figure5, ParameterError> {
        self.fig05.as_ref().map_err(Clone::clone)
    }

    /// What Figure 6 (fig:F) shows.
    ///
    /// # Errors
    /// Its section is not right.
    pub fn fig06(&self) -> Result<&Figure6, ParameterError> {
        self.fig06.as_ref().map_err(Clone::clone)
    }

    /// What Figure 7 (fig:G) shows.
    ///
    /// # Errors
    /// Its section is not right.
    pub fn fig07(&self) -> Result<&Figure7, ParameterError> {
        self.fig07.as_ref().map_err(Clone::clone)
    }

    /// What Figure 8 (fig:Y) shows.
    ///
    /// # Errors
    /// Its section is not right.
    pub fn fig08(&self) -> Result<&Figure8, ParameterError> {
        self.fig08.as_ref().map_err(Clone::clone)
    }

    /// What Figure 9 (fig:Bb) shows.
    ///
    /// # Errors
    /// Its section is not right.
    pub fn fig09(&self) -> Result<&Figure9, ParameterError> {
        self.fig09.as_ref().map_err(Clone::clone)
    }

    /// What Figure 10 (fig:I) shows.
    ///
    /// # Errors
    /// Its section is not right.
    pub fn fig10(&self) -> Result<&Figure10, ParameterError> {
        self.fig10.as_ref().map_err(Clone::clone)
    }
}

/// A section, checked.
fn read<Raw: DeserializeOwned, T>(
    source: &Source<'_>,
    name: &str,
    check: impl FnOnce(&Raw) -> Checked<T>,
) -> Checked<T> {
    check(&source.read_table(name)?)
}

/// `[oscillator]` as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
struct Oscillator {
    zeta: Spanned<f64>,
    epsilon: Spanned<f64>,
}

fn check(raw: &Oscillator, source: &Source<'_>) -> Checked<LinearOscillator> {
    let zeta = demand(source, "oscillator.zeta", &raw.zeta, |zeta| 0.0 < zeta && zeta < 1.0)?;
    let epsilon =
        demand(source, "oscillator.epsilon", &raw.epsilon, |epsilon| 0.0 < epsilon && epsilon <= 1.0)?;
    let refuse = |error: grazing_theorems::TheoryError| {
        validate::refused(source, "oscillator.zeta", &raw.zeta, error.to_string())
    };
    LinearOscillator::new(zeta, epsilon).map_err(refuse)
}
