//! Rows, and tables of them.

use std::slice;

use crate::{Cell, Column, Names};

/// A row of a table.
pub trait Row {
    /// The columns, in order.
    const COLUMNS: &'static [Column];

    /// The cells, one for each column.
    fn cells(&self) -> Vec<Cell>;
}

/// What the rows of a table are in a figure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DrawnAs {
    /// Points along curves, or anything that no other word fits.
    #[default]
    Curves,
    /// Points that are marked.
    Points,
    /// Dots of a cloud, too many to tell apart.
    Cloud,
    /// What bounds areas, such as vertices of regions.
    Areas,
}

/// A table's name and columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TablePlan {
    /// The name of the table's CSV file, without extension.
    pub name: &'static str,
    /// A description of a row.
    pub row: &'static str,
    /// The columns, in order.
    pub columns: &'static [Column],
    /// What the rows are in a figure.
    pub drawn: DrawnAs,
}

impl TablePlan {
    /// A table of rows of type `R`.
    pub const fn of<R: Row>(name: &'static str, row: &'static str) -> Self {
        Self { name, row, columns: R::COLUMNS, drawn: DrawnAs::Curves }
    }

    /// The given tables with other names.
    pub const fn renamed<const COUNT: usize>(tables: &[Self], names: [&'static str; COUNT]) -> [Self; COUNT] {
        let mut renamed = [tables[0]; COUNT];
        let mut place = 0;
        while place < COUNT {
            renamed[place] = Self { name: names[place], ..tables[place] };
            place += 1;
        }
        renamed
    }
}

/// A table under the name of its CSV file.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// File name without extension, such as `fig07_curves`.
    pub name: &'static str,
    /// The declarations of the columns.
    pub columns: Vec<Column>,
    /// The headers of the columns, with the names of the parameters inserted.
    pub headers: Vec<String>,
    /// The symbols of the columns, in LaTeX; empty where a column has none.
    pub symbols: Vec<String>,
    /// The units of the columns, if the file names its units; empty where there is none.
    pub units: Vec<String>,
    /// The rows.
    pub rows: Vec<Vec<Cell>>,
    /// What the rows are in a figure.
    pub drawn: DrawnAs,
}

impl Table {
    /// The table of these rows, with these names of the two parameters.
    pub fn new<'a, R: Row + 'a>(
        name: &'static str,
        names: &Names,
        rows: impl IntoIterator<Item = &'a R>,
    ) -> Self {
        Self::of_cells(name, R::COLUMNS, names, rows.into_iter().map(Row::cells).collect())
    }

    /// The table of these cells, which are in the order of the columns. Columns for constants that do not
    /// vary are omitted.
    pub fn of_cells(
        name: &'static str,
        columns: &'static [Column],
        names: &Names,
        mut rows: Vec<Vec<Cell>>,
    ) -> Self {
        let shown: Vec<bool> = columns.iter().map(|column| !column.header(names).is_empty()).collect();
        if shown.contains(&false) {
            let mut places = shown.iter().cycle();
            rows.iter_mut().for_each(|row| row.retain(|_| places.next() == Some(&true)));
        }
        let columns: Vec<Column> =
            columns.iter().zip(shown).filter_map(|(column, shown)| shown.then_some(*column)).collect();
        let headers = columns.iter().map(|column| column.header(names)).collect();
        let symbols = columns.iter().map(|column| column.symbol(names)).collect();
        let units = columns.iter().map(|column| column.unit(names)).collect();
        Self { name, columns, headers, symbols, units, rows, drawn: DrawnAs::default() }
    }

    /// The index of the column with this header.
    pub fn position(&self, header: &str) -> Option<usize> {
        self.headers.iter().position(|found| found == header)
    }

    /// The cells in the column with this header; none if there is no such column.
    pub fn column(&self, header: &str) -> Option<impl Iterator<Item = &Cell>> {
        let place = self.position(header)?;
        Some(self.rows.iter().map(move |row| &row[place]))
    }
}

/// The contents of an output as tables: see [`tables!`](crate::tables).
pub trait Tables: Sized {
    /// The names and columns of the tables.
    const TABLES: &'static [TablePlan];

    /// The tables of several outputs, each with the rows of all of them, named as in `tables`, which has as many entries.
    fn tables_of_all(all: &[Self], tables: &[TablePlan], names: &Names) -> Vec<Table>;

    /// The tables of several outputs, with these names of the parameters.
    fn tables_of(all: &[Self], names: &Names) -> Vec<Table> {
        Self::tables_of_all(all, Self::TABLES, names)
    }

    /// All tables, named as in `tables`, which has as many entries.
    fn tables_as(&self, tables: &[TablePlan], names: &Names) -> Vec<Table> {
        Self::tables_of_all(slice::from_ref(self), tables, names)
    }

    /// All tables, with these names of the parameters.
    fn tables(&self, names: &Names) -> Vec<Table> {
        self.tables_as(Self::TABLES, names)
    }
}

/// Declares row types: each field with its type and its column, whose dimension is that of the field's number
/// ([`Dimensioned`](crate::Dimensioned)); a field without a column is a row whose columns stand in its place.
#[macro_export]
macro_rules! rows {
    ($($(#[$meta:meta])* $row:ident { $($field:ident: $type:ty $(= $column:ident)?,)+ })+) => {$(
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $row {
            $(
                #[doc = $crate::rows!(@doc $type $(, $column)?)]
                pub $field: $type,
            )+
        }

        impl $crate::Row for $row {
            const COLUMNS: &'static [$crate::Column] = {
                const PARTS: &[&[$crate::Column]] = &[$($crate::rows!(@columns $type $(, $column)?),)+];
                &$crate::table::joined::<{ $crate::table::count(PARTS) }>(PARTS)
            };

            fn cells(&self) -> Vec<$crate::Cell> {
                let mut cells = Vec::with_capacity(Self::COLUMNS.len());
                $($crate::rows!(@cells cells, self.$field $(, $column)?);)+
                cells
            }
        }

        impl $crate::Dimensioned for $row {
            fn each_number(&mut self, visit: &mut dyn FnMut($crate::Dimension, &mut f64)) {
                $($crate::rows!(@numbers visit, self.$field $(, $column)?);)+
            }
        }
    )+};
    (@doc $type:ty, $column:ident) => {
        concat!("[`", stringify!($column), "`](grazing_results::columns::", stringify!($column), ")")
    };
    (@doc $type:ty) => { concat!("The columns of `", stringify!($type), "`.") };
    (@columns $type:ty, $column:ident) => { &[$crate::columns::$column] };
    (@columns $type:ty) => { <$type as $crate::Row>::COLUMNS };
    (@cells $cells:ident, $field:expr, $column:ident) => { $cells.push($field.clone().into()) };
    (@cells $cells:ident, $field:expr) => { $cells.extend($crate::Row::cells(&$field)) };
    (@numbers $visit:ident, $field:expr, $column:ident) => {
        $crate::Field::number(&mut $field, &mut |number| $visit($crate::columns::$column.dimension, number))
    };
    (@numbers $visit:ident, $field:expr) => { $crate::Dimensioned::each_number(&mut $field, $visit) };
}

/// The number of columns of all parts of a row.
#[doc(hidden)]
pub const fn count(parts: &[&[Column]]) -> usize {
    let (mut count, mut part) = (0, 0);
    while part < parts.len() {
        count += parts[part].len();
        part += 1;
    }
    count
}

/// The columns of all parts of a row, in order.
#[doc(hidden)]
pub const fn joined<const COUNT: usize>(parts: &[&[Column]]) -> [Column; COUNT] {
    let mut columns = [parts[0][0]; COUNT];
    let (mut place, mut part) = (0, 0);
    while part < parts.len() {
        let mut index = 0;
        while index < parts[part].len() {
            columns[place] = parts[part][index];
            (place, index) = (place + 1, index + 1);
        }
        part += 1;
    }
    columns
}

/// Implements [`Row`](crate::Row) for a type with other uses: each column with its value, after
/// definitions that the values share.
///
/// `row! { Point, |p| { let both = p.x + p.y; } [X = p.x, SUM = both] }`
#[macro_export]
macro_rules! row {
    ($type:ty, |$this:ident| { $($common:tt)* } [$($column:ident = $value:expr,)+]) => {
        impl $crate::Row for $type {
            const COLUMNS: &'static [$crate::Column] = &[$($crate::columns::$column,)+];

            fn cells(&self) -> Vec<$crate::Cell> {
                let $this = self;
                $($common)*
                vec![$($value.into(),)+]
            }
        }
    };
}

/// Declares the contents of an output: lists of rows, each with the name of its table, a description of a
/// row, what the rows are in a figure ([`DrawnAs`](crate::DrawnAs)) unless they are points of curves, and optional further
/// documentation; then other fields. One that is declared as `Output: Dimensioned` is
/// [`Dimensioned`](crate::Dimensioned) in all its fields.
#[macro_export]
macro_rules! tables {
    (@ $name:ident [$($field:ident)+]) => {};
    (@ Dimensioned $name:ident [$($field:ident)+]) => {
        impl $crate::Dimensioned for $name {
            fn each_number(&mut self, visit: &mut dyn FnMut($crate::Dimension, &mut f64)) {
                $($crate::Dimensioned::each_number(&mut self.$field, visit);)+
            }
        }
    };
    ($($(#[$meta:meta])* $name:ident $(: $dimensioned:ident)? {
        $($(#[$about:meta])* $rows:ident: $row:ty = $table:literal, $is:literal $(as $drawn:ident)?,)+
        $(; $($(#[$what:meta])* $other:ident: $type:ty,)+)?
    })+) => {$(
        $(#[$meta])*
        #[derive(Clone, Debug)]
        pub struct $name {
            $(#[doc = concat!("Each is ", $is, ".")] $(#[$about])* pub $rows: Vec<$row>,)+
            $($($(#[$what])* pub $other: $type,)+)?
        }

        impl $crate::Tables for $name {
            const TABLES: &'static [$crate::TablePlan] = &[$($crate::TablePlan {
                $(drawn: $crate::DrawnAs::$drawn,)?
                ..$crate::TablePlan::of::<$row>($table, $is)
            },)+];

            fn tables_of_all(
                all: &[Self],
                tables: &[$crate::TablePlan],
                names: &$crate::Names,
            ) -> Vec<$crate::Table> {
                let mut tables = tables.iter();
                let each = [$(tables.next().map(|table| $crate::Table {
                    drawn: table.drawn,
                    ..$crate::Table::new(table.name, names, all.iter().flat_map(|one| &one.$rows))
                }),)+];
                each.into_iter().flatten().collect()
            }
        }

        $crate::tables!(@ $($dimensioned)? $name [$($rows)+ $($($other)*)?]);
    )+};
}
