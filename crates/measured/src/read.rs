//! CSV files of measurements. An error names the file, line, column and value, and a remedy.

use std::path::Path;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_input::read_foreign;
use grazing_results::measured::SeenKind;

use self::cells::{FileRow, Separator};
use self::table::{CsvTable, Request};

mod cells;
mod columns;
mod error;
mod number;
mod table;

pub use columns::{Columns, POINTS, RECORD};
pub use error::MeasurementError;

/// The behaviour measured at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Behaviour {
    /// Periodic motion, with its period and number of impacts.
    Periodic {
        /// The period, in forcing periods.
        periods: u32,
        /// The impacts in one period; 0 for motion that does not reach the wall.
        impacts: u32,
    },
    /// Motion that is not periodic.
    Irregular,
    /// A bifurcation: the place lies on a bifurcation curve.
    Bifurcation {
        /// The kind of bifurcation.
        kind: Bifurcation,
        /// The number of loops of the solution, if that is known.
        loops: Option<u32>,
        /// The walls that the solution hits, as far as they are known.
        walls: MeasuredWalls,
    },
}

/// The walls that motion hits, as far as a measurement says so.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeasuredWalls {
    /// Nothing is said of them, or there is only one.
    #[default]
    Unsaid,
    /// One of two walls alone, with its number.
    One(u32),
    /// Both of two walls.
    Both,
}

/// A measurement at a place of the plane, in the oscillator's own units.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// The line of the file.
    pub line: u32,
    /// Primary and secondary parameter.
    pub at: [f64; 2],
    /// The standard errors of the two parameters; zero where none is stated.
    pub errors: [f64; 2],
    /// The behaviour measured there.
    pub seen: Behaviour,
}

/// One impact of a record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// The line of the file.
    pub line: u32,
    /// The number of the wall that is hit, in the order of the oscillator's file; 1 if there is only one.
    pub wall: u32,
    /// Time, speed before and speed after the impact; the last is NaN if it was not measured.
    pub values: [f64; 3],
    /// The standard errors of time, speed before and speed after; NaN where none is stated.
    pub errors: [f64; 3],
}

/// Consecutive impacts without a gap at one place of the parameter plane, in the oscillator's own units.
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactRecord {
    /// Primary and secondary parameter.
    pub at: [f64; 2],
    /// The impacts in order of time.
    pub impacts: Vec<Impact>,
}

/// The layout of another program's file of curves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Foreign {
    /// The columns that hold names from [`POINTS`]; others are ignored unless they have such a name.
    pub columns: Vec<(String, String)>,
    /// The kind of curve and the number of loops for files without a column for them.
    pub curve: Option<(Bifurcation, Option<u32>)>,
}

/// Pairs of a name from [`POINTS`] or [`RECORD`] and the column that holds it, by its name or its number from 1
/// on.
pub type Renamed = [(String, String)];

/// What is known of an oscillator whose measurements are read.
#[derive(Clone, Copy, Debug)]
pub struct Setup<'a> {
    /// The names of both parameters.
    pub names: [&'a str; 2],
    /// Whether the motion is between two walls.
    pub two_walls: bool,
}

/// The measurements of an oscillator in a file.
///
/// # Errors
/// The file cannot be read; otherwise the first mistake in it.
pub fn points(path: &Path, of: Setup<'_>, renamed: &Renamed) -> Result<Vec<Observation>, MeasurementError> {
    Ok(points_of(&read_foreign(path)?, &path.display().to_string(), of, renamed)?.0)
}

/// The record of an oscillator's impacts in a file.
///
/// # Errors
/// As [`points`].
pub fn record(path: &Path, of: Setup<'_>, renamed: &Renamed) -> Result<Vec<ImpactRecord>, MeasurementError> {
    record_of(&read_foreign(path)?, &path.display().to_string(), of, renamed)
}

/// The points of another program's curves in a file, with the names of both parameters.
///
/// # Errors
/// As [`points`].
pub fn curves(
    path: &Path,
    names: [&str; 2],
    foreign: &Foreign,
) -> Result<Vec<Observation>, MeasurementError> {
    curves_of(&read_foreign(path)?, &path.display().to_string(), names, foreign)
}

/// The measurements in a text, and the columns that hold them, by their names in [`POINTS`]; `file` is the
/// file's name in messages.
///
/// # Errors
/// The first mistake in the text.
pub fn points_of(
    text: &str,
    file: &str,
    Setup { names, two_walls }: Setup<'_>,
    renamed: &Renamed,
) -> Result<(Vec<Observation>, Vec<String>), MeasurementError> {
    let needed = &["{primary}", "{secondary}", "seen"];
    let request = Request { file, names, columns: POINTS, needed, renamed, foreign: false, separated: true };
    let table = CsvTable::read(text, &request)?;
    let point = |row| {
        let mut point = table.observation(row, None)?;
        let said = table.walls(row, two_walls)?;
        if let Behaviour::Bifurcation { walls, .. } = &mut point.seen {
            *walls = said;
        }
        Ok::<_, MeasurementError>(point)
    };
    let points = table.rows.iter().map(point).collect::<Result<_, _>>()?;
    Ok((points, table.names().collect()))
}

/// The points of another program's curves in a text.
///
/// # Errors
/// The first mistake in the text.
pub fn curves_of(
    text: &str,
    file: &str,
    names: [&str; 2],
    foreign: &Foreign,
) -> Result<Vec<Observation>, MeasurementError> {
    let needed = &["{primary}", "{secondary}", "seen"][..if foreign.curve.is_some() { 2 } else { 3 }];
    let renamed = &foreign.columns;
    let request = Request { file, names, columns: POINTS, needed, renamed, foreign: true, separated: true };
    let table = CsvTable::read(text, &request)?;
    table.rows.iter().map(|row| table.observation(row, foreign.curve)).collect()
}

/// The cells of a line of a table that commas separate, without surrounding blanks and quotation marks; none if a mark has no
/// partner on the line, or stands within a cell.
pub fn cells(line: &str) -> Option<Vec<String>> {
    Separator::Comma.cells(line).ok().flatten()
}

/// The record of impacts in a text; `file` is the file's name in messages.
///
/// # Errors
/// The first mistake in the text.
pub fn record_of(
    text: &str,
    file: &str,
    Setup { names, two_walls }: Setup<'_>,
    renamed: &Renamed,
) -> Result<Vec<ImpactRecord>, MeasurementError> {
    let needed = ["{primary}", "{secondary}", "time", "velocity_before", "wall"];
    let needed = &needed[..if two_walls { 5 } else { 4 }];
    let request = Request { file, names, columns: RECORD, needed, renamed, foreign: false, separated: false };
    let table = CsvTable::read(text, &request)?;
    let mut all: Vec<(&str, ImpactRecord)> = Vec::new();
    for row in &table.rows {
        let (at, series) = (table.place(row)?, row.cell(table.position("series")));
        let positive = |column| table.number(row, column, |value| value > 0.0, "a positive number");
        let known = |column| match table.optional(row, column) {
            "" => Ok(f64::NAN),
            _ => positive(column),
        };
        let (time_error, speed_error) = (known("time_error")?, known("velocity_error")?);
        let time = table.number(row, "time", |_| true, "a number")?;
        let before = positive("velocity_before")?;
        let after = known("velocity_after")?;
        let errors = [time_error, speed_error, speed_error];
        let wall = match table.walls(row, two_walls)? {
            MeasuredWalls::One(wall) => wall,
            MeasuredWalls::Unsaid if !two_walls => 1,
            _ => {
                return Err(table.refusal(
                    row,
                    "wall",
                    "write the wall that is hit, 1 or 2, in the order of the oscillator's file",
                ));
            }
        };
        let impact = Impact { line: row.line, wall, values: [time, before, after], errors };
        match all.last_mut() {
            Some((name, last)) if *name == series && last.at == at => {
                if last.impacts.last().is_some_and(|before| before.values[0] >= time) {
                    let is = "impacts of a series must be in order of time: give other impacts another name in the column series";
                    return Err(table.refusal(row, "time", is));
                }
                last.impacts.push(impact);
            }
            _ => all.push((series, ImpactRecord { at, impacts: vec![impact] })),
        }
    }
    Ok(all.into_iter().map(|(_, series)| series).collect())
}

impl Impact {
    /// The stop that is hit: 0 for the first wall, 1 for the second.
    pub fn stop(&self) -> usize {
        usize::from(self.wall > 1)
    }
}

impl ImpactRecord {
    /// The first impact of which the speed after exceeds that before, if the speeds of the series do so on the
    /// whole, by three standard errors: those that are stated, or else those of the scatter.
    pub fn gaining(&self) -> Option<&Impact> {
        let gain = |impact: &Impact| impact.values[2] - impact.values[1];
        let known: Vec<&Impact> = self.impacts.iter().filter(|impact| !gain(impact).is_nan()).collect();
        let (count, sum) = (known.len() as f64, known.iter().map(|impact| gain(impact)).sum::<f64>());
        let variance = |impact: &Impact| {
            let [_, before, after] = impact.errors;
            let stated = before * before + after * after;
            let scatter = gain(impact) - sum / count;
            if stated.is_nan() { scatter * scatter } else { stated }
        };
        let variance: f64 = known.iter().map(|impact| variance(impact)).sum();
        let gains = sum > 3.0 * variance.sqrt();
        known.into_iter().find(|impact| gains && gain(impact) > 0.0)
    }
}

impl Behaviour {
    /// The kind of behaviour, by which figures choose its mark.
    pub fn kind(&self) -> SeenKind {
        match self {
            Self::Periodic { periods: 1, impacts: 0 } => SeenKind::NonImpacting,
            Self::Periodic { impacts: 1, .. } => SeenKind::Loops,
            Self::Periodic { .. } | Self::Irregular => SeenKind::Other,
            Self::Bifurcation { .. } => SeenKind::Bifurcation,
        }
    }

    /// A description in words.
    pub fn words(&self) -> String {
        let several = |count: u32, what: &str| {
            if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
        };
        match self {
            Self::Periodic { periods: 1, impacts: 0 } => "no impacts".to_owned(),
            Self::Periodic { periods, impacts: 0 } => format!("no impacts, {periods} periods"),
            Self::Periodic { periods, impacts } => {
                format!("{} in {}", several(*impacts, "impact"), several(*periods, "period"))
            }
            Self::Irregular => "irregular".to_owned(),
            Self::Bifurcation { kind, loops: Some(p), walls }
                if *kind != Bifurcation::NonImpactingGrazing =>
            {
                format!("{} of p = {p}{}", kind.name(), walls.words())
            }
            Self::Bifurcation { kind, walls, .. } => format!("{}{}", kind.name(), walls.words()),
        }
    }
}

impl MeasuredWalls {
    /// Whether solutions may be those that hit one wall alone, with its number.
    pub(crate) fn may_be(self, wall: u32) -> bool {
        self == Self::Unsaid || self == Self::One(wall)
    }

    /// Whether solutions may be those that hit both walls.
    pub(crate) fn may_be_both(self) -> bool {
        self == Self::Unsaid || self == Self::Both
    }

    /// The words that follow those about motion.
    fn words(self) -> String {
        match self {
            Self::Unsaid => String::new(),
            Self::One(wall) => format!(" at wall {wall}"),
            Self::Both => " at both walls".to_owned(),
        }
    }
}

impl CsvTable<'_> {
    fn observation(
        &self,
        row: &FileRow,
        otherwise: Option<(Bifurcation, Option<u32>)>,
    ) -> Result<Observation, MeasurementError> {
        let error = |column| match self.optional(row, column) {
            "" => Ok(0.0),
            _ => self.number(row, column, |value| value >= 0.0, "the standard error, which is not negative,"),
        };
        let errors = [error("{primary}_error")?, error("{secondary}_error")?];
        let seen = match otherwise {
            Some((kind, loops)) => Behaviour::Bifurcation { kind, loops, walls: MeasuredWalls::Unsaid },
            None => self.seen(row)?,
        };
        Ok(Observation { line: row.line, at: self.place(row)?, errors, seen })
    }

    fn seen(&self, row: &FileRow) -> Result<Behaviour, MeasurementError> {
        let needed = |column, least| {
            let count = self.count(row, column, least, None)?;
            count.ok_or_else(|| self.refusal(row, column, "periodic motion needs periods and impacts"))
        };
        let word = row.cell(self.position("seen"));
        match word.to_ascii_lowercase().as_str() {
            "none" => {
                let periods = self.count(row, "periods", 1, Some(1))?.unwrap_or(1);
                match self.count(row, "impacts", 0, Some(0))? {
                    Some(0) | None => Ok(Behaviour::Periodic { periods, impacts: 0 }),
                    Some(_) => Err(self.refusal(row, "impacts", "motion `none` has no impacts")),
                }
            }
            "periodic" => {
                Ok(Behaviour::Periodic { periods: needed("periods", 1)?, impacts: needed("impacts", 1)? })
            }
            "irregular" => Ok(Behaviour::Irregular),
            _ => match Bifurcation::understood(word) {
                Some(kind) => {
                    let loops = self.count(row, "p", 0, None)?;
                    Ok(Behaviour::Bifurcation { kind, loops, walls: MeasuredWalls::Unsaid })
                }
                None => {
                    let what = "write none, periodic, irregular, or a bifurcation";
                    Err(self.refusal(row, "seen", &format!("{what}: {}", Bifurcation::NAMES)))
                }
            },
        }
    }

    /// The walls in a cell, which may be empty.
    fn walls(&self, row: &FileRow, two_walls: bool) -> Result<MeasuredWalls, MeasurementError> {
        match (self.optional(row, "wall"), two_walls) {
            ("", _) | ("1" | "1.0", false) => Ok(MeasuredWalls::Unsaid),
            ("1" | "1.0", true) => Ok(MeasuredWalls::One(1)),
            ("2" | "2.0", true) => Ok(MeasuredWalls::One(2)),
            ("1-2" | "2-1", true) => Ok(MeasuredWalls::Both),
            (_, true) => Err(self.refusal(
                row,
                "wall",
                "write 1 or 2, in the order of the oscillator's file, or 1-2 for motion that hits both",
            )),
            (_, false) => Err(self.refusal(
                row,
                "wall",
                "the oscillator has one wall: write 1, or leave the column out",
            )),
        }
    }
}
