//! Tables: named data frames, made column by column.

use polars::prelude::{Column, DataFrame, PolarsError};

/// A table under the name of its CSV file.
#[derive(Clone, Debug)]
pub struct Table {
    /// File name without ending, such as `fig07_curves`.
    pub name: &'static str,
    /// The rows.
    pub frame: DataFrame,
}

/// A table in the making, one row at a time, with one type a column.
pub(crate) struct Columns {
    names: Vec<String>,
    cells: Vec<Cells>,
}

enum Cells {
    Text(Vec<String>),
    Integer(Vec<u32>),
    Number(Vec<Option<f64>>),
    Flag(Vec<bool>),
}

/// One cell.
#[derive(Clone)]
pub(crate) enum Cell {
    Text(String),
    Integer(u32),
    Number(f64),
    Flag(bool),
}

impl From<&str> for Cell {
    fn from(value: &str) -> Self {
        Self::Text(value.to_owned())
    }
}

impl From<String> for Cell {
    fn from(value: String) -> Self {
        Self::Text(value)
    }
}

impl From<u32> for Cell {
    fn from(value: u32) -> Self {
        Self::Integer(value)
    }
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<bool> for Cell {
    fn from(value: bool) -> Self {
        Self::Flag(value)
    }
}

impl Columns {
    /// Columns with names and, by way of a sample row, types.
    pub(crate) fn new<const N: usize>(columns: [(String, Cell); N]) -> Self {
        let cells = columns.iter().map(|(_, sample)| match sample {
            Cell::Text(_) => Cells::Text(Vec::new()),
            Cell::Integer(_) => Cells::Integer(Vec::new()),
            Cell::Number(_) => Cells::Number(Vec::new()),
            Cell::Flag(_) => Cells::Flag(Vec::new()),
        });
        let cells = cells.collect();
        Self { names: columns.into_iter().map(|(name, _)| name).collect(), cells }
    }

    /// Adds a row. A number that is not finite becomes an empty cell.
    ///
    /// # Panics
    /// The row's types are not those of the columns: an error in the program.
    pub(crate) fn push<const N: usize>(&mut self, row: [Cell; N]) {
        assert_eq!(N, self.cells.len(), "a row has one cell a column");
        for ((cells, cell), name) in self.cells.iter_mut().zip(row).zip(&self.names) {
            match (cells, cell) {
                (Cells::Text(column), Cell::Text(value)) => column.push(value),
                (Cells::Integer(column), Cell::Integer(value)) => column.push(value),
                // Adding zero turns −0 into 0.
                (Cells::Number(column), Cell::Number(value)) => {
                    column.push(value.is_finite().then_some(value + 0.0));
                }
                (Cells::Flag(column), Cell::Flag(value)) => column.push(value),
                _ => panic!("column {name} got a cell of another type"),
            }
        }
    }

    /// The finished table.
    pub(crate) fn finish(self, name: &'static str) -> Result<Table, PolarsError> {
        let columns = self.names.into_iter().zip(self.cells).map(|(name, cells)| {
            let name = name.into();
            match cells {
                Cells::Text(values) => Column::new(name, values),
                Cells::Integer(values) => Column::new(name, values),
                Cells::Number(values) => Column::new(name, values),
                Cells::Flag(values) => Column::new(name, values),
            }
        });
        Ok(Table { name, frame: DataFrame::new_infer_height(columns.collect())? })
    }
}

/// Names and types of columns: `columns! { "kind": "", "p": 0, axes.secondary: 0.0 }`.
macro_rules! columns {
    ($($name:tt $(. $field:ident)?: $sample:expr),* $(,)?) => {
        $crate::table::Columns::new([$((::std::string::String::from($name $(. $field)?), $crate::table::Cell::from($sample))),*])
    };
}

/// A row: `row![kind, p, omega]`.
macro_rules! row {
    ($($value:expr),* $(,)?) => { [$($crate::table::Cell::from($value)),*] };
}

pub(crate) use {columns, row};
