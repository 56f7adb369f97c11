//! The parameters of the figures: a TOML file in, checked values out.
//!
//! [`Parameters`] can be made from a file only; every section of it is checked by itself, and what
//! is not right in one keeps nobody from using another. `figures/parameters.toml` is the file of
//! the paper's figures; nothing of science has a hidden default, but places of portraits and panels
//! may be left to the program. All quantities are dimensionless; a range is [lower, upper], finite,
//! with lower < upper.

mod error;
mod fig02;
mod limits;
mod plane;
mod scenes;
mod sketches;

use std::path::Path;
use std::sync::LazyLock;

use grazing_source::kind::number;
use grazing_source::{Keys, Requirements, Section, Setting, Source, SourceError, Text, keys, read_file};
use grazing_theorems::LinearOscillator;

use limits::{EPSILON, FREQUENCIES, ZETA, damping_ratio, restitution};

pub use error::ParameterError;
pub(crate) use fig02::MOST_PORTRAITS;
pub use fig02::{Figure2, Portrait};
pub use limits::{contains, encloses, strictly_contains};
pub use plane::{Figure7, Figure8, Panel};
pub use scenes::{Arrival, Figure1, Figure3, Figure9, View};
pub use sketches::{Figure4, Figure5, Figure6, Figure10};

keys! {
    /// The constants of the paper's oscillator.
    struct Oscillator {
        /// Damping ratio zeta of eq:oscf.
        zeta: f64 = damping_ratio(), ZETA;
        /// Coefficient of restitution epsilon of eq:oscResetLaw.
        epsilon: f64 = restitution(), EPSILON;
    }
}

/// What the keys of a parameter file must hold.
static REQUIREMENTS: LazyLock<Requirements> = LazyLock::new(|| {
    Requirements::new("see figures/parameters.toml for what belongs here")
        .with_table("oscillator", "the table [oscillator] holds zeta and epsilon", Oscillator::list)
        .with_table("fig01", "the table [fig01] says what Figure 1 shows", Figure1::list)
        .with_table("fig02", "the table [fig02] says what Figure 2 shows", fig02::Section2::list)
        .with_table("fig03", "the table [fig03] says what Figure 3 shows", Figure3::list)
        .with_table("fig04", "the table [fig04] says what Figure 4 shows", Figure4::list)
        .with_table("fig05", "the table [fig05] says what Figure 5 shows", Figure5::list)
        .with_table("fig06", "the table [fig06] says what Figure 6 shows", Figure6::list)
        .with_table("fig07", "the table [fig07] says what Figure 7 shows", plane::Section7::list)
        .with_table("fig08", "the table [fig08] holds the panels of Figure 8", plane::Section8::list)
        .with_table("fig09", "the table [fig09] says what Figure 9 shows", Figure9::list)
        .with_table("fig10", "the table [fig10] says what Figure 10 shows", Figure10::list)
});

/// What a section says, if it is right.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked<T>(Result<T, ParameterError>);

impl<T> Checked<T> {
    /// What it says.
    ///
    /// # Errors
    /// The section is not right.
    pub fn get(&self) -> Result<&T, ParameterError> {
        self.0.as_ref().map_err(Clone::clone)
    }

    fn read<E: Into<ParameterError>>(
        source: &Source<'_>,
        name: &str,
        read: impl FnOnce(&Section<'_>) -> Result<T, E>,
    ) -> Self {
        Self(source.section(name, |section| read(&section).map_err(Into::into)))
    }
}

/// Everything that the figures and the tables depend on, section by section.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Parameters {
    /// The oscillator of the paper's example: damping ratio zeta of eq:oscf in (0, 1), coefficient
    /// of restitution epsilon of eq:oscResetLaw in (0, 1].
    pub oscillator: Checked<LinearOscillator>,
    /// What Figure 1 (fig:Bc) shows.
    pub fig01: Checked<Figure1>,
    /// What Figure 2 (fig:Z) shows.
    pub fig02: Checked<Figure2>,
    /// The forcing frequency of Figure 2, which Figure 4 and the printed numbers share, whatever
    /// else its section holds.
    pub fig02_frequency: Checked<f64>,
    /// What Figure 3 (fig:Ba) shows.
    pub fig03: Checked<Figure3>,
    /// What Figure 4 (fig:D) shows.
    pub fig04: Checked<Figure4>,
    /// What Figure 5 (fig:E) shows.
    pub fig05: Checked<Figure5>,
    /// What Figure 6 (fig:F) shows.
    pub fig06: Checked<Figure6>,
    /// What Figure 7 (fig:G) shows.
    pub fig07: Checked<Figure7>,
    /// What Figure 8 (fig:Y) shows.
    pub fig08: Checked<Figure8>,
    /// What Figure 9 (fig:Bb) shows.
    pub fig09: Checked<Figure9>,
    /// What Figure 10 (fig:I) shows.
    pub fig10: Checked<Figure10>,
}

impl Parameters {
    /// Reads and checks a parameter file, with settings that take the place of values in it; its
    /// path appears in messages as it is given here.
    ///
    /// # Errors
    /// As [`parse`](Self::parse), or the file cannot be read.
    pub fn from_file(path: &Path, settings: &[Setting]) -> Result<Parameters, ParameterError> {
        let text = read_file(path)?;
        Parameters::parse(&Text::new(&text, settings), &path.display().to_string())
    }

    /// Checks the text of a parameter file; `file` is the name that messages use.
    ///
    /// # Errors
    /// [`ParameterError`] if the text is no TOML or has sections that nobody reads, and for
    /// settings of keys that are not there. What else is wrong, the first thing in each section, is
    /// told to whoever asks for that section.
    pub fn parse(text: &Text, file: &str) -> Result<Parameters, ParameterError> {
        let source = &Source::new(text, file, &REQUIREMENTS);
        source.check_top_level()?;
        let oscillator = Checked::read(source, "oscillator", oscillator);
        let fig07 = Checked::read(source, "fig07", |section| Figure7::checked(section, oscillator.get()?));
        Ok(Parameters {
            fig01: Checked::read(source, "fig01", Figure1::checked),
            fig02: Checked::read(source, "fig02", |section| Figure2::checked(section, oscillator.get()?)),
            fig02_frequency: Checked::read(source, "fig02", |section| {
                number(FREQUENCIES).read(section, "frequency")
            }),
            fig03: Checked::read(source, "fig03", Figure3::checked),
            fig04: Checked::read(source, "fig04", Figure4::read),
            fig05: Checked::read(source, "fig05", |section| {
                Figure5::checked(section, oscillator.get()?).map_err(ParameterError::from)
            }),
            fig06: Checked::read(source, "fig06", |section| Figure6::checked(section, oscillator.get()?)),
            fig08: Checked::read(source, "fig08", |section| {
                Figure8::checked(section, fig07.get()?, oscillator.get()?)
            }),
            fig09: Checked::read(source, "fig09", Figure9::checked),
            fig10: Checked::read(source, "fig10", |section| Figure10::checked(section, oscillator.get()?)),
            fig07,
            oscillator,
        })
    }
}

fn oscillator(section: &Section<'_>) -> Result<LinearOscillator, SourceError> {
    let Oscillator { zeta, epsilon } = Oscillator::read(section)?;
    LinearOscillator::new(zeta, epsilon).map_err(|error| section.forbid("zeta", error.to_string()))
}
