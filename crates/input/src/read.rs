//! Descriptions read from texts, and variants of them.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use grazing_model::smooth::Stop;

use crate::description::Description;
use crate::document::{Requirements, Source, Text, read_file};
use crate::error::DescriptionError;
use crate::expression::ExpressionError;
use crate::file::{MOST_LOOPS, REQUIREMENTS};
use crate::{checks, validate};

impl Description {
    /// The keys that a file can have, with their meanings and requirements.
    pub fn requirements() -> &'static Requirements {
        &REQUIREMENTS
    }

    /// Reads and checks a description; messages show its path as given here.
    ///
    /// # Errors
    /// [`DescriptionError`], the first error in the file, with its line.
    pub fn from_file(path: &Path) -> Result<Description, DescriptionError> {
        Description::parse(&read_file(path)?, &path.display().to_string())
    }

    /// Checks the text of a description; `file` is the name that messages use.
    ///
    /// Φ ≥ 0, ω > 0 and the periods of F, Φ and Ψ are checked at samples of the ranges.
    ///
    /// # Errors
    /// [`DescriptionError`], the first error in the text, with its line.
    pub fn parse(text: &str, file: &str) -> Result<Description, DescriptionError> {
        Description::parse_with(&Text::new(text, &[]), file, &Stop::default())
    }

    /// Reads a description like [`parse`](Self::parse), with settings that replace values in the
    /// text; stops once the computation is cancelled.
    ///
    /// # Errors
    /// As for [`parse`](Self::parse), and for settings of unknown or missing keys;
    /// [`DescriptionError::Ended`] once the computation is cancelled.
    pub fn parse_with(text: &Text, file: &str, stop: &Stop) -> Result<Description, DescriptionError> {
        let source = Source::new(text, file, &REQUIREMENTS);
        let mut description = source
            .whole(|file| validate::description(&file, stop))
            .map_err(|error| if stop.is_asked() { DescriptionError::Ended } else { error })?;
        let content = Arc::make_mut(&mut description.0);
        content.units = OnceLock::from(Description(Arc::new(content.clone()), 0).units_until(stop));
        let notes = checks::samples(&description, stop)?;
        Arc::make_mut(&mut description.0).notes = notes;
        Ok(description)
    }

    /// The oscillator with another value of a constant; any other name changes nothing. The
    /// assumptions of the theorems are not checked again.
    ///
    /// # Errors
    /// An expression has no value with it, such as 1/kappa for kappa = 0.
    pub fn with_constant(&self, name: &str, value: f64) -> Result<Description, ExpressionError> {
        let mut content = (*self.0).clone();
        let constants = content.file.parameters.iter_mut();
        constants.filter(|(known, _)| known == name).for_each(|(_, old)| *old = value);
        for seen in &mut content.stops {
            let stop = Stop::default();
            (seen.formulas, seen.harmonics) =
                validate::formulas(&seen.texts, seen.side, &content.file, &stop)?;
            seen.mass = validate::mass(seen.mass_text.as_ref(), &content.file, &stop)?;
        }
        content.units = OnceLock::new();
        Ok(Description(Arc::new(content), self.1))
    }

    /// The oscillator with other numbers of loops p to analyse.
    ///
    /// # Errors
    /// [`DescriptionError::Loops`] unless there is at least one number, all lie between 1 and 12,
    /// and none is repeated.
    pub fn with_loops(&self, loops: &[u32]) -> Result<Description, DescriptionError> {
        let twice = (1..loops.len()).any(|index| loops[..index].contains(&loops[index]));
        if loops.is_empty() || twice || !loops.iter().all(|number| (1..=MOST_LOOPS).contains(number)) {
            return Err(DescriptionError::Loops { loops: loops.to_vec() });
        }
        let mut content = (*self.0).clone();
        content.file.analysis.loops = loops.to_vec();
        Ok(Description(Arc::new(content), self.1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_checked_and_no_unit_looked_for_once_an_end_is_asked_for() {
        let text = Text::new(include_str!("../../../examples/shaking-table.toml"), &[]);
        let stop = Stop::default();
        let source = Source::new(&text, "shaking-table.toml", &REQUIREMENTS);
        let description = source.whole(|file| validate::description(&file, &stop)).expect("it is right");
        assert!(checks::samples(&description, &stop).is_ok());
        let sizes = || {
            let units = description.units_until(&stop);
            [units.length, units.time]
        };
        assert_ne!(sizes(), [1.0; 2]);
        stop.ask();
        assert_eq!(checks::samples(&description, &stop), Err(DescriptionError::Ended));
        // The units are the default ones of an oscillator about which nothing is known.
        assert_eq!(sizes(), [1.0; 2]);
        let read = Description::parse_with(&text, "shaking-table.toml", &stop);
        assert_eq!(read, Err(DescriptionError::Ended));
    }
}
