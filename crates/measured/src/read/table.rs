//! A CSV file whose columns are found by name or number.

use grazing_input::{nearest, shortened, suggestion};

use super::cells::{FileRow, LineMistake, Rows, Separator};
use super::columns::Columns;
use super::error::MeasurementError;
use super::number::{self, DecimalMark};

/// The greatest number of rows: more than are measured by hand or needed for curves.
const MOST_ROWS: usize = 10_000;
/// The greatest number of characters of a value that a message repeats.
const SHOWN: usize = 60;
/// The greatest number of forcing periods, or of impacts in them, that a cell may state.
const MOST_PERIODS: u32 = 1_000;

/// A CSV file, split into cells.
pub(super) struct CsvTable<'t> {
    pub(super) file: &'t str,
    pub(super) names: [&'t str; 2],
    /// The name of each column that is known, and its place.
    columns: Vec<(String, usize)>,
    decimal: DecimalMark,
    pub(super) rows: Vec<FileRow>,
}

/// What is asked of a file.
pub(super) struct Request<'t> {
    pub(super) file: &'t str,
    /// The names of the parameters.
    pub(super) names: [&'t str; 2],
    pub(super) columns: Columns,
    pub(super) needed: &'t [&'t str],
    /// Pairs of a known name and the column that holds it, by its name or number.
    pub(super) renamed: &'t [(String, String)],
    /// Whether names of columns that look like misspelt ones are left alone.
    pub(super) foreign: bool,
    /// Whether rows without a place are left out: they separate curves.
    pub(super) separated: bool,
}

/// The name of a column with the names of the parameters inserted.
pub(super) fn named(column: &str, [primary, secondary]: [&str; 2]) -> String {
    column.replace("{primary}", primary).replace("{secondary}", secondary)
}

/// The columns that hold words.
const WORDS: [&str; 3] = ["seen", "series", "wall"];
const FIRST: &str = "the first line names the columns";

impl<'t> CsvTable<'t> {
    /// Reads a text in the one way in which its cells can be separated.
    ///
    /// # Errors
    /// The first mistake; or there are several ways.
    pub(super) fn read(text: &str, request: &Request<'t>) -> Result<Self, MeasurementError> {
        let wrong = |(line, reason): LineMistake| {
            let file = request.file;
            let place = if line == 0 { file.to_owned() } else { format!("{file}:{line}") };
            MeasurementError::Wrong { place, reason }
        };
        let mut text =
            text.strip_prefix('\u{feff}').unwrap_or(text).replace("\r\n", "\n").replace('\r', "\n");
        let mut ways = Separator::ALL.to_vec();
        // Spreadsheets may say in the first line what separates cells.
        if let Some((first, rest)) = text.split_once('\n')
            && let Some(said) = first.trim().trim_matches('"').strip_prefix("sep=")
        {
            ways.retain(|way| way.is(said));
            text = format!("\n{rest}");
        }
        let read = ways.iter().map(|way| (*way, request.table(&text, *way)));
        let (found, mistakes): (Vec<_>, Vec<_>) = read.partition(|(_, table)| table.is_ok());
        let mut found = found.into_iter().filter_map(|(way, table)| Some((way, table.ok()?)));
        if let Some((way, table)) = found.next() {
            return match found.find(|(_, other)| !table.agrees_with(other)) {
                None => Ok(table),
                Some((other, _)) => {
                    let [way, other] = [way, other].map(Separator::name);
                    Err(wrong((
                        0,
                        format!("its cells may be separated by {way} or by {other}: use one of them alone"),
                    )))
                }
            };
        }
        // The message is about the separator that the first line has most of.
        let is_row = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with(['#', '%']);
        let first = text.lines().find(is_row).unwrap_or_default();
        let cells = |way: Separator| {
            way.rows(first).map_or(0, |rows| rows.rows.first().map_or(0, |row| row.cells.len()))
        };
        let mistakes = mistakes.into_iter().filter_map(|(way, table)| Some((way, table.err()?))).rev();
        let most = mistakes.max_by_key(|(way, _)| cells(*way));
        Err(wrong(
            most.map_or_else(|| (1, "after sep= stands , or ; or a tab".to_owned()), |(_, mistake)| mistake),
        ))
    }

    /// Whether another reading of the same file has the same cells in the same columns.
    fn agrees_with(&self, other: &Self) -> bool {
        let cells = |table: &Self| -> Vec<(String, Vec<String>)> {
            let column = |(name, place): &(String, usize)| {
                (name.clone(), table.rows.iter().map(|row| row.cell(Some(*place)).to_owned()).collect())
            };
            table.columns.iter().map(column).collect()
        };
        cells(self) == cells(other)
    }

    /// The names of the columns that are read, in the order of the file.
    pub(super) fn names(&self) -> impl Iterator<Item = String> {
        let mut columns = self.columns.clone();
        columns.sort_by_key(|(_, place)| *place);
        columns.into_iter().map(|(name, _)| name)
    }

    pub(super) fn position(&self, column: &str) -> Option<usize> {
        let name = named(column, self.names);
        self.columns.iter().find(|(known, _)| *known == name).map(|(_, place)| *place)
    }

    /// The cell of a column that may be left out; empty if it says that there is no number.
    pub(super) fn optional<'r>(&self, row: &'r FileRow, column: &str) -> &'r str {
        let cell = row.cell(self.position(column));
        if number::is_none(cell) { "" } else { cell }
    }

    /// The error for a cell, with how to correct it.
    pub(super) fn refusal(&self, row: &FileRow, column: &str, right: &str) -> MeasurementError {
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
        row: &FileRow,
        column: &str,
        right: impl Fn(f64) -> bool,
        what: &str,
    ) -> Result<f64, MeasurementError> {
        let cell = row.cell(self.position(column));
        let number = self.decimal.number(cell).filter(|value| value.is_finite() && right(*value));
        let point = if cell.contains(',') { " (with a point: a comma may part thousands)" } else { "" };
        number.ok_or_else(|| self.refusal(row, column, &format!("write {what}, as 0.25 or 2.5e-3{point}")))
    }

    /// A whole number of at least `least`, or `none` for an empty cell.
    pub(super) fn count(
        &self,
        row: &FileRow,
        column: &str,
        least: u32,
        none: Option<u32>,
    ) -> Result<Option<u32>, MeasurementError> {
        let cell = self.optional(row, column);
        if cell.is_empty() {
            return Ok(none);
        }
        // Programs that know no whole numbers write 2.0.
        let number = self.decimal.number(cell).filter(|number| number.fract() == 0.0);
        match number {
            Some(number) if (f64::from(least)..=f64::from(MOST_PERIODS)).contains(&number) => {
                Ok(Some(number as u32))
            }
            _ => Err(self.refusal(
                row,
                column,
                &format!("write a whole number from {least} to {MOST_PERIODS}"),
            )),
        }
    }

    pub(super) fn place(&self, row: &FileRow) -> Result<[f64; 2], MeasurementError> {
        let number = |column| self.number(row, column, |_| true, "a number");
        Ok([number("{primary}")?, number("{secondary}")?])
    }
}

impl<'t> Request<'t> {
    /// The text as a table whose cells are separated in a given way.
    ///
    /// # Errors
    /// The first mistake.
    fn table(&self, text: &str, separator: Separator) -> Result<CsvTable<'t>, LineMistake> {
        let Rows { comment, mut rows } = separator.rows(text)?;
        let first = rows.first().cloned().ok_or_else(|| (0, format!("it is empty: {FIRST}")))?;
        let by_number: Vec<(&str, usize)> = self.by_number(&first)?;
        let is_number = |cell: &str| {
            [DecimalMark::Point, DecimalMark::Comma].iter().any(|way| way.number(cell).is_some())
        };
        // A column of a parameter that is given by its number and holds no number.
        let other = |row: &FileRow| {
            let mut places = by_number.iter().filter(|(name, _)| self.names.contains(name));
            places.find(|(_, place)| !is_number(row.cell(Some(*place)))).copied()
        };
        let is_headless =
            by_number.iter().any(|(name, _)| self.names.contains(name)) && other(&first).is_none();
        let (columns, width) = if is_headless {
            // 0,1;1,0 is two numbers with decimal commas, whatever columns are asked for.
            let are_several = |cell: &String| {
                let parts: Vec<&str> = cell.split([';', '\t', ' ']).filter(|part| !part.is_empty()).collect();
                parts.len() > 1 && parts.into_iter().all(is_number)
            };
            if let Some(cell) = first.cells.iter().find(|cell| are_several(cell)) {
                let cell = shortened(cell, SHOWN);
                let reason = format!("`{cell}` would be one cell if {} separate cells", separator.name());
                return Err((
                    first.line,
                    format!("{reason}: separate all cells in one way, and write decimals with a point"),
                ));
            }
            let nameless = FileRow { cells: vec![String::new(); first.cells.len()], ..first };
            (self.columns(&nameless, &by_number)?, first.cells.len())
        } else {
            match self.columns(&first, &by_number) {
                Ok(columns) => {
                    rows.remove(0);
                    let width =
                        first.cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1);
                    (columns, width)
                }
                Err(mistake) => {
                    let numbers = first.cells.iter().filter(|cell| is_number(cell)).count();
                    if numbers < self.names.len() {
                        return Err(mistake);
                    }
                    // Names may stand in a comment above the numbers.
                    let above = comment.filter(|comment| comment.cells.len() == first.cells.len());
                    let columns = above.and_then(|above| self.columns(&above, &by_number).ok());
                    (columns.ok_or_else(|| (first.line, self.headless()))?, first.cells.len())
                }
            }
        };
        // Spreadsheets write rows without content, and some programs end each line with a separator.
        rows.retain(|row| row.cells.iter().any(|cell| !cell.is_empty()));
        // R writes the name of a row before its cells, and none for this column.
        if rows.iter().all(|row| row.quoted && row.cells.len() == width + 1) {
            rows.iter_mut().for_each(|row| drop(row.cells.remove(0)));
        }
        for row in &mut rows {
            if row.cells.len() > width && row.cells[width..].iter().all(String::is_empty) {
                row.cells.truncate(width);
            }
            if row.cells.len() != width {
                let counts = format!("{} cells, and there are {width} columns", row.cells.len());
                let remedy = format!(
                    "separate cells by {}, write decimals with a point, and leave unknown cells empty",
                    separator.name()
                );
                return Err((row.line, format!("this line has {counts}: {remedy}")));
            }
        }
        let place = |name: &str| columns.iter().find(|(known, _)| known == name).map(|(_, place)| *place);
        if self.separated {
            let places = self.names.map(place);
            rows.retain(|row| !places.iter().all(|place| number::is_none(row.cell(*place))));
        }
        for row in &rows {
            if let Some((name, place)) = other(row) {
                let cell = shortened(row.cell(Some(place)), SHOWN);
                let reason = format!("column {} should hold {name}: `{cell}` is not a number", place + 1);
                return Err((row.line, reason));
            }
        }
        match rows.len() {
            0 => Err((0, "it has no measurement, only the names of columns".to_owned())),
            count if count > MOST_ROWS => Err((
                0,
                format!("it has {count} measurements: at most {MOST_ROWS} can be compared at a time"),
            )),
            _ => {
                let measured = columns.iter().filter(|(name, _)| !WORDS.contains(&name.as_str()));
                let measured: Vec<usize> = measured.map(|(_, place)| *place).collect();
                let cells = rows.iter().flat_map(|row| measured.iter().map(|place| row.cell(Some(*place))));
                let decimal = DecimalMark::of(cells);
                Ok(CsvTable { file: self.file, names: self.names, columns, decimal, rows })
            }
        }
    }

    /// The remedy for a file without names of columns.
    fn headless(&self) -> String {
        let needed: Vec<String> = self.needed.iter().map(|name| named(name, self.names)).collect();
        let way = if self.foreign { ", or give their numbers, as in --column NAME=1" } else { "" };
        format!(
            "the first line holds numbers: name the columns in a line above it ({}){way}",
            needed.join(",")
        )
    }

    /// The places of the columns that are given by their numbers.
    fn by_number(&self, first: &FileRow) -> Result<Vec<(&'t str, usize)>, LineMistake> {
        let numbered =
            self.renamed.iter().filter(|(_, column)| column.bytes().all(|digit| digit.is_ascii_digit()));
        let place = |(name, column): &'t (String, String)| match column.parse::<usize>() {
            Ok(number) if (1..=first.cells.len()).contains(&number) => Ok((name.as_str(), number - 1)),
            _ => {
                let count = first.cells.len();
                Err((
                    first.line,
                    format!(
                        "it has no column {column}, which should hold {name}: the line has {count} cells"
                    ),
                ))
            }
        };
        numbered.map(place).collect()
    }

    /// The name of each known column, and its place.
    fn columns(
        &self,
        header: &FileRow,
        by_number: &[(&str, usize)],
    ) -> Result<Vec<(String, usize)>, LineMistake> {
        let known: Vec<String> = self.columns.iter().map(|(column, _)| named(column, self.names)).collect();
        let list = || known.join(", ");
        let at = |reason: String| (header.line, reason);
        let only = |is: &dyn Fn(&str) -> bool| {
            let mut places = (0..header.cells.len()).filter(|place| is(&header.cells[*place]));
            match (places.next(), places.next()) {
                (Some(place), Some(_)) => {
                    let name = shortened(&header.cells[place], SHOWN);
                    Err(at(format!("the column {name} appears twice: remove one of them")))
                }
                (place, _) => Ok(place),
            }
        };
        if let Some((name, _)) = self.renamed.iter().find(|(name, _)| !known.contains(name)) {
            let names: Vec<&str> = known.iter().map(String::as_str).collect();
            let near = suggestion(nearest(name, &names));
            return Err((0, format!("no column can be called {name}{near} The names are {}", list())));
        }
        let mut columns: Vec<(String, usize)> = Vec::new();
        for name in &known {
            let place = if let Some((_, place)) = by_number.iter().find(|(numbered, _)| numbered == name) {
                Some(*place)
            } else if let Some((_, column)) = self.renamed.iter().find(|(renamed, _)| renamed == name) {
                // Another column with this name has a different meaning in the other program, and is ignored.
                let missing = || at(format!("it has no column {column}, which should hold {name}"));
                Some(only(&|cell| cell == column)?.ok_or_else(missing)?)
            } else if let Some(place) = only(&|cell| cell == name)? {
                Some(place)
            } else {
                let is_alike = |cell: &str| cell.to_lowercase() == name.to_lowercase();
                only(&|cell| is_alike(cell) && !known.iter().any(|known| known == cell))?
            };
            let Some(place) = place else { continue };
            if let Some((other, _)) = columns.iter().find(|(_, taken)| *taken == place) {
                return Err(at(format!("column {} should hold both {other} and {name}", place + 1)));
            }
            columns.push((name.clone(), place));
        }
        let absent: Vec<&str> = known
            .iter()
            .map(String::as_str)
            .filter(|name| columns.iter().all(|(found, _)| found != name))
            .collect();
        // A column that is not known is ignored, unless its name looks like that of one that is not there.
        let strange =
            header.cells.iter().enumerate().filter(|(place, _)| columns.iter().all(|(_, at)| at != place));
        for (_, name) in strange.filter(|_| !self.foreign) {
            if let Some(near) = nearest(name, &absent) {
                let name = shortened(name, SHOWN);
                let near = suggestion(Some(near));
                return Err(at(format!("unknown column {name}{near} The columns are {}", list())));
            }
        }
        match self
            .needed
            .iter()
            .map(|name| named(name, self.names))
            .find(|name| absent.contains(&name.as_str()))
        {
            Some(name) => Err(at(format!("the column {name} is missing; {FIRST}"))),
            None => Ok(columns),
        }
    }
}
