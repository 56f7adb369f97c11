//! Descriptions from texts, and others made from these.

use std::path::Path;
use std::sync::Arc;

use grazing_source::{Source, Text};

use crate::description::Description;
use crate::error::DescriptionError;
use crate::expression::ExpressionError;
use crate::file::{MOST_LOOPS, REQUIREMENTS};
use crate::{checks, validate};

impl Description {
    /// Reads and checks a description; its path appears in messages as it is given here.
    ///
    /// # Errors
    /// [`DescriptionError`], the first thing in the file that is not right, with its line.
    pub fn from_file(path: &Path) -> Result<Description, DescriptionError> {
        Description::parse(&grazing_source::read_file(path)?, &path.display().to_string())
    }

    /// Checks the text of a description; `file` is the name that messages use.
    ///
    /// Φ > 0, ω > 0 and the periods of F, Φ and Ψ are checked at samples of the ranges.
    ///
    /// # Errors
    /// [`DescriptionError`], the first thing in the text that is not right, with its line.
    pub fn parse(text: &str, file: &str) -> Result<Description, DescriptionError> {
        Description::parse_with(&Text::new(text, &[]), file)
    }

    /// As [`parse`](Self::parse), with settings that take the place of values in the text.
    ///
    /// # Errors
    /// As [`parse`](Self::parse), and for settings of keys that mean nothing or are not there.
    pub fn parse_with(text: &Text, file: &str) -> Result<Description, DescriptionError> {
        let source = Source::new(text, file, &REQUIREMENTS);
        let (description, places) = source.whole(|file| validate::description(&file))?;
        let notes = checks::samples(&description, &places)?;
        let mut content = (*description.0).clone();
        content.notes = notes;
        Ok(Description(Arc::new(content)))
    }

    /// The same oscillator with another value of a constant; a name that is no constant's changes
    /// nothing. What the theorems assume is not checked again.
    ///
    /// # Errors
    /// An expression has no value with it, as 1/kappa for kappa = 0.
    pub fn with_constant(&self, name: &str, value: f64) -> Result<Description, ExpressionError> {
        let mut content = (*self.0).clone();
        let constants = content.file.parameters.iter_mut();
        constants.filter(|(known, _)| known == name).for_each(|(_, old)| *old = value);
        content.formulas = validate::formulas(&content.texts, self.wall().side, &content.file)?;
        Ok(Description(Arc::new(content)))
    }

    /// The same oscillator with other numbers of loops p to analyse.
    ///
    /// # Errors
    /// [`DescriptionError::Loops`] unless there is at least one number, all lie between 1 and 12,
    /// and none stands twice.
    pub fn with_loops(&self, loops: &[u32]) -> Result<Description, DescriptionError> {
        let twice = (1..loops.len()).any(|index| loops[..index].contains(&loops[index]));
        if loops.is_empty() || twice || !loops.iter().all(|number| (1..=MOST_LOOPS).contains(number)) {
            return Err(DescriptionError::Loops { loops: loops.to_vec() });
        }
        let mut content = (*self.0).clone();
        content.file.analysis.loops = loops.to_vec();
        Ok(Description(Arc::new(content)))
    }
}
