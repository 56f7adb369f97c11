//! The cells of a CSV file, accessed by column name.

use grazing_source::{nearest, shortened, suggestion};

use super::{Columns, MOST_PERIODS, MOST_ROWS, MeasurementError, SHOWN};

/// A row of the file, with its line number.
pub(super) struct Row<'t> {
    pub(super) line: u32,
    pub(super) cells: Vec<&'t str>,
}

impl<'t> Row<'t> {
    /// The cell in a column; empty if there is no such cell.
    pub(super) fn cell(&self, position: Option<usize>) -> &'t str {
        position.and_then(|place| self.cells.get(place)).copied().unwrap_or_default()
    }
}

/// A CSV file, split into cells.
pub(super) struct Table<'t> {
    pub(super) file: &'t str,
    pub(super) names: [&'t str; 2],
    pub(super) header: Vec<&'t str>,
    pub(super) rows: Vec<Row<'t>>,
}

/// The name of a column with the names of the parameters inserted.
pub(super) fn named(column: &str, [primary, secondary]: [&str; 2]) -> String {
    column.replace("{primary}", primary).replace("{secondary}", secondary)
}

/// The cells of a line, without surrounding blanks and quotation marks.
fn cells(line: &str) -> Vec<&str> {
    line.split(',').map(|cell| cell.trim().trim_matches('"').trim()).collect()
}

impl<'t> Table<'t> {
    pub(super) fn read(
        text: &'t str,
        file: &'t str,
        names: [&'t str; 2],
        columns: Columns,
        needed: &[&str],
        foreign: Option<&'t [(String, String)]>,
    ) -> Result<Self, MeasurementError> {
        let at = |line: u32, reason: String| {
            let place = if line == 0 { file.to_owned() } else { format!("{file}:{line}") };
            MeasurementError::Wrong { place, reason }
        };
        let known: Vec<String> = columns.iter().map(|(column, _)| named(column, names)).collect();
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let lines = (1..).zip(text.lines());
        let mut lines = lines.filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
        let first = "the first line names the columns";
        let (line, header) = lines.next().ok_or_else(|| at(0, format!("it is empty: {first}")))?;
        if !header.contains(',') && header.contains([';', '\t']) {
            let is = "cells are separated by commas here, and decimals are written with a point";
            return Err(at(line, is.to_owned()));
        }
        let mut header = cells(header);
        let list: Vec<&str> = known.iter().map(String::as_str).collect();
        for (name, column) in foreign.unwrap_or_default() {
            if !list.contains(&name.as_str()) {
                let near = suggestion(nearest(name, &list));
                return Err(at(
                    0,
                    format!("no column can be called {name}{near} The names are {}", list.join(", ")),
                ));
            }
            let is = format!("it has no column {column}, which should hold {name}");
            let place = header.iter().position(|known| known == column).ok_or_else(|| at(line, is))?;
            // Another column with this name has a different meaning in the other program, and is ignored.
            header.iter_mut().filter(|known| *known == name).for_each(|known| *known = "");
            header[place] = name;
        }
        for (place, name) in header.iter().enumerate() {
            if !list.contains(name) {
                if foreign.is_some() {
                    continue;
                }
                let near = suggestion(nearest(name, &list));
                let name = shortened(name, SHOWN);
                return Err(at(
                    line,
                    format!("unknown column {name}{near} The columns are {}", list.join(", ")),
                ));
            }
            if header[..place].contains(name) {
                return Err(at(line, format!("the column {name} appears twice: remove one of them")));
            }
        }
        for name in needed.iter().map(|name| named(name, names)) {
            if !header.contains(&name.as_str()) {
                return Err(at(line, format!("the column {name} is missing; {first}")));
            }
        }
        let rows: Vec<Row<'_>> = lines.map(|(line, text)| Row { line, cells: cells(text) }).collect();
        if let Some(row) = rows.iter().find(|row| row.cells.len() != header.len()) {
            let counts = format!("{} cells, and there are {} columns", row.cells.len(), header.len());
            let remedy =
                "separate cells by commas, write decimals with a point, and leave unknown cells empty";
            return Err(at(row.line, format!("this line has {counts}: {remedy}")));
        }
        match rows.len() {
            0 => Err(at(0, "it has no measurement, only the names of columns".to_owned())),
            count if count > MOST_ROWS => Err(at(
                0,
                format!("it has {count} measurements: at most {MOST_ROWS} can be compared at a time"),
            )),
            _ => Ok(Self { file, names, header, rows }),
        }
    }

    pub(super) fn position(&self, column: &str) -> Option<usize> {
        let name = named(column, self.names);
        self.header.iter().position(|known| *known == name)
    }

    /// The error for a cell, with how to correct it.
    pub(super) fn refusal(&self, row: &Row<'_>, column: &str, right: &str) -> MeasurementError {
        let (value, name) = (shortened(row.cell(self.position(column)), SHOWN), named(column, self.names));
        let value = if value.is_empty() { "nothing".to_owned() } else { format!("`{value}`") };
        MeasurementError::Wrong {
            place: format!("{}:{}", self.file, row.line),
            reason: format!("column {name}: {value} is not valid: {right}"),
        }
    }

    /// A finite number that satisfies a requirement.
    pub(super) fn number(
        &self,
        row: &Row<'_>,
        column: &str,
        right: impl Fn(f64) -> bool,
        what: &str,
    ) -> Result<f64, MeasurementError> {
        let cell = row.cell(self.position(column));
        let number = cell.parse().ok().filter(|value: &f64| value.is_finite() && right(*value));
        number.ok_or_else(|| self.refusal(row, column, &format!("write {what}, as 0.25 or 2.5e-3")))
    }

    /// A whole number of at least `least`, or `none` for an empty cell.
    pub(super) fn count(
        &self,
        row: &Row<'_>,
        column: &str,
        least: u32,
        none: Option<u32>,
    ) -> Result<Option<u32>, MeasurementError> {
        match row.cell(self.position(column)) {
            "" if none.is_some() => Ok(none),
            "" => Ok(None),
            cell => match cell.parse() {
                Ok(count) if (least..=MOST_PERIODS).contains(&count) => Ok(Some(count)),
                _ => Err(self.refusal(
                    row,
                    column,
                    &format!("write a whole number from {least} to {MOST_PERIODS}"),
                )),
            },
        }
    }

    pub(super) fn place(&self, row: &Row<'_>) -> Result<[f64; 2], MeasurementError> {
        let number = |column| self.number(row, column, |_| true, "a number");
        Ok([number("{primary}")?, number("{secondary}")?])
    }
}
