//! Reading columns out of frames, with errors that name the frame and the column.

use polars::prelude::{Column, DataFrame, DataType};

use crate::DrawingError;

/// A borrowed frame together with its name, by which error messages and the marks in an SVG call it.
#[derive(Debug, Clone, Copy)]
pub struct Table<'a> {
    pub(crate) name: &'static str,
    frame: &'a DataFrame,
}

impl<'a> Table<'a> {
    /// The frame under the name, which is that of its CSV file without the ending.
    pub fn new(name: &'static str, frame: &'a DataFrame) -> Self {
        Table { name, frame }
    }

    fn column(&self, column: &str) -> Result<&'a Column, DrawingError> {
        self.frame.column(column).map_err(|_| DrawingError::MissingColumn {
            frame: self.name,
            column: column.to_owned(),
            present: self.frame.get_column_names().iter().map(|n| n.as_str()).collect::<Vec<_>>().join(", "),
        })
    }

    fn cast(
        &self,
        column: &str,
        wanted: &'static str,
        to: &DataType,
        admits: fn(&DataType) -> bool,
    ) -> Result<Column, DrawingError> {
        let raw = self.column(column)?;
        let wrong = || DrawingError::ColumnType {
            frame: self.name,
            column: column.to_owned(),
            wanted,
            found: raw.dtype().to_string(),
        };
        // A column without a single value has no type of its own.
        let empty = raw.null_count() == raw.len();
        if !empty && !admits(raw.dtype()) {
            return Err(wrong());
        }
        raw.cast(to).map_err(|_| wrong())
    }

    /// A column of numbers; empty cells become NaN, at which lines are split.
    pub(crate) fn numbers(&self, column: &str) -> Result<Vec<f64>, DrawingError> {
        let cast = self.cast(column, "numbers", &DataType::Float64, |t| t.is_primitive_numeric())?;
        let values = cast.f64().map_err(|_| self.unreadable(column, "numbers", &cast))?;
        Ok(values.iter().map(|v| v.unwrap_or(f64::NAN)).collect())
    }

    /// A column of whole numbers.
    pub(crate) fn integers(&self, column: &str) -> Result<Vec<i64>, DrawingError> {
        let cast = self.cast(column, "whole numbers", &DataType::Int64, |t| t.is_integer())?;
        let values = cast.i64().map_err(|_| self.unreadable(column, "whole numbers", &cast))?;
        self.every_row(column, values.iter())
    }

    /// A column of truth values.
    pub(crate) fn flags(&self, column: &str) -> Result<Vec<bool>, DrawingError> {
        let cast = self.cast(column, "true or false", &DataType::Boolean, |t| t.is_bool())?;
        let values = cast.bool().map_err(|_| self.unreadable(column, "true or false", &cast))?;
        self.every_row(column, values.iter())
    }

    /// A column of words, each translated by `translate`; `known` lists what it accepts.
    pub(crate) fn words<T>(
        &self,
        column: &str,
        known: &'static str,
        translate: impl Fn(&str) -> Option<T>,
    ) -> Result<Vec<T>, DrawingError> {
        let cast = self.cast(column, "words", &DataType::String, |t| t.is_string() || t.is_categorical())?;
        let values = cast.str().map_err(|_| self.unreadable(column, "words", &cast))?;
        let words = self.every_row(column, values.iter())?;
        words
            .into_iter()
            .map(|word| {
                translate(word).ok_or_else(|| DrawingError::UnknownWord {
                    frame: self.name,
                    column: column.to_owned(),
                    value: word.to_owned(),
                    known,
                })
            })
            .collect()
    }

    fn every_row<T>(
        &self,
        column: &str,
        values: impl Iterator<Item = Option<T>>,
    ) -> Result<Vec<T>, DrawingError> {
        values
            .enumerate()
            .map(|(row, v)| {
                v.ok_or(DrawingError::EmptyCell { frame: self.name, column: column.to_owned(), row })
            })
            .collect()
    }

    fn unreadable(&self, column: &str, wanted: &'static str, found: &Column) -> DrawingError {
        DrawingError::ColumnType {
            frame: self.name,
            column: column.to_owned(),
            wanted,
            found: found.dtype().to_string(),
        }
    }
}

/// Splits `0..keys.len()` into the longest runs over which the key stays the same.
pub(crate) fn runs<K: PartialEq>(keys: &[K]) -> Vec<std::ops::Range<usize>> {
    let mut found = Vec::new();
    let mut start = 0;
    for end in 1..=keys.len() {
        if end == keys.len() || keys[end] != keys[start] {
            found.push(start..end);
            start = end;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use polars::prelude::df;

    use super::*;

    #[test]
    fn a_missing_column_is_named_together_with_its_frame() {
        let frame = df!("omega" => [0.5], "kind" => ["SN"]).unwrap();
        let error = Table::new("fig07_curves", &frame).numbers("amplitude").unwrap_err();
        assert_eq!(error.to_string(), "frame `fig07_curves` has no column `amplitude`; it has: omega, kind");
    }

    #[test]
    fn a_column_of_another_type_is_refused_rather_than_guessed() {
        let frame = df!("p" => ["one"], "omega" => ["x"], "stable" => [1_i64]).unwrap();
        let table = Table::new("t", &frame);
        for error in [
            table.integers("p").unwrap_err(),
            table.numbers("omega").unwrap_err(),
            table.flags("stable").unwrap_err(),
        ] {
            assert!(matches!(error, DrawingError::ColumnType { frame: "t", .. }), "{error}");
        }
    }

    #[test]
    fn an_empty_number_becomes_nan_and_an_empty_integer_an_error() {
        let frame = df!("x" => [Some(1.5), None], "p" => [Some(1_u32), None]).unwrap();
        let table = Table::new("t", &frame);
        let x = table.numbers("x").unwrap();
        assert!(x[0] == 1.5 && x[1].is_nan());
        let error = table.integers("p").unwrap_err();
        assert!(matches!(error, DrawingError::EmptyCell { column, row: 1, .. } if column == "p"));
    }

    #[test]
    fn whole_numbers_serve_as_numbers() {
        let frame = df!("amplitude" => [1_i64, 2]).unwrap();
        assert_eq!(Table::new("t", &frame).numbers("amplitude").unwrap(), [1.0, 2.0]);
    }

    #[test]
    fn an_unknown_word_is_quoted_with_the_words_allowed() {
        let frame = df!("kind" => ["SN", "HB"]).unwrap();
        let parse = |word: &str| (word == "SN").then_some(());
        let error = Table::new("t", &frame).words("kind", "SN", parse).unwrap_err();
        assert_eq!(error.to_string(), "column `kind` of frame `t` has the unknown value `HB`; known are: SN");
    }

    #[test]
    fn runs_are_split_where_the_key_changes() {
        assert_eq!(runs(&[1, 1, 2, 1]), [0..2, 2..3, 3..4]);
        assert!(runs::<u8>(&[]).is_empty());
    }
}
