//! Beyond the paper: the attractors over the window of Figure 7, place by place.
//!
//! The rows of the map are independent, so they can be computed separately ([`Map::rows`]) and assembled
//! ([`Map::assembled`]), with the same result.

mod ink;

use core::f64::consts::TAU;
use core::ops::Range;

use grazing_continuation::curve::Window;
use grazing_input::kind::count;
use grazing_model::{AnyOscillator, ImpactOscillator, State};
use grazing_reproduction::figures::fig07::Figure7;
use grazing_reproduction::forced;
use grazing_reproduction::prelude::*;
use grazing_results::plane::PlaneDiagram;
use grazing_results::{place, row, rows, tables};
use grazing_unfold::long_time::{Horizon, MotionKind, Patience};
use grazing_unfold::place::{AttractorSummary, seen};
use grazing_unfold::plane;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// The greatest number of places in either direction: the memory of a large machine holds the rows of
/// such a map.
const MOST: u32 = 10_000;

keys! {
    /// The attractors over the window of Figure 7.
    pub struct BeyondAttractors {
        /// Places across.
        columns: u32 = count(2..=MOST), "the number of places across must be a whole number from {} to {}";
        /// Places up.
        rows: u32 = count(2..=MOST), "the number of places up must be a whole number from {} to {}";
    }
}

/// The initial states, all at rest: x, and the phase in turns.
pub const STARTS: [(f64, f64); 4] = [(-0.5, 0.0), (-0.5, 0.5), (-1.5, 0.0), (-1.5, 0.5)];
/// The time for which motion is followed: nearly all motion settles in the short time; other motion is
/// followed for longer.
const HORIZON: Horizon = Horizon { transient: 32, counted: 16, patience: Patience::Unsettled, longest: 400 };

/// The accuracy of the borders of regions, which are polygons, as a fraction of the ranges.
const BORDER: f64 = 1e-4;

/// An attractor at consecutive places of a row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stretch {
    /// The forcing frequency.
    pub secondary: f64,
    /// The amplitude at the first place.
    pub first: f64,
    /// The number of places.
    pub places: u32,
    /// The number of attractors seen at each place.
    pub attractors: u32,
    /// The number of this attractor among them.
    pub attractor: u32,
    /// The name of its [`MotionKind`].
    pub motion: String,
    /// The period in forcing periods, or 0 for motion that is not periodic.
    pub periods: u32,
    /// Impacts in a forcing period.
    pub impacts: f64,
    /// The least of the largest Lyapunov exponents at the places; NaN for periodic motion.
    pub least: f64,
    /// The greatest of the largest Lyapunov exponents at the places; NaN for periodic motion.
    pub greatest: f64,
    /// The largest standard error of the exponents.
    pub error: f64,
}

row! { Stretch, |this| {} [
    SECONDARY = this.secondary,
    FIRST_PLACE = this.first,
    MAP_PLACES = this.places,
    ATTRACTORS_SEEN = this.attractors,
    MAP_ATTRACTOR = this.attractor,
    MAP_MOTION = this.motion.clone(),
    MAP_PERIODS = this.periods,
    MAP_IMPACTS = this.impacts,
    LYAPUNOV_LEAST = this.least,
    LYAPUNOV_GREATEST = this.greatest,
    LYAPUNOV_LARGEST_ERROR = this.error,
] }

rows! {
    /// A comparison of the map with the regions of Figure 7 for p-loop solutions.
    RegionCount {
        loops: u32 = LOOPS,
        in_regions: u32 = MAP_IN_REGIONS,
        settled: u32 = MAP_SETTLED,
        unseen: u32 = MAP_UNSEEN,
        unexplained: u32 = MAP_UNEXPLAINED,
    }

    /// Consecutive places at which regions and map differ.
    Remark {
        remark: &'static str = MAP_REMARK,
        loops: u32 = LOOPS,
        secondary: f64 = SECONDARY,
        first: f64 = FIRST_PLACE,
        places: u32 = MAP_PLACES,
    }
}

tables! {
    /// The map of attractors over the window of Figure 7.
    Attractors {
        /// Row by row, the lowest first, from left to right.
        stretches: Stretch = "beyond_attractors", "an attractor on a run of adjacent places",
        counts: RegionCount = "beyond_attractors_regions", "a number of loops p",
        remarks: Remark = "beyond_attractors_remarks", "a run of adjacent places at which regions and simulated motion differ",
        ;
        /// Figure 7, which is drawn on top.
        diagram: PlaneDiagram,
        /// The numbers of places across and up.
        size: [u32; 2],
    }
}

/// A row of the map.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MapRow {
    /// The number of the row, from the lowest frequency up.
    pub row: u32,
    /// The attractors in the row, from left to right; those at the same places follow each other.
    pub stretches: Vec<Stretch>,
}

/// The map of a study.
pub struct Map<'a> {
    study: &'a Study,
    oscillator: AnyOscillator,
    window: Window,
    loops: Vec<u32>,
    size: [u32; 2],
}

impl FileSection for BeyondAttractors {
    const NAME: &'static str = "beyond_attractors";
    const REQUIREMENT: &'static str = "the table [beyond_attractors] says how many places are looked at";
}

impl StudyFigure for BeyondAttractors {
    const LABEL: &'static str = "fig:attractors";
    const TITLE: Title<&'static str> = Title::beyond("long-term behaviour in the window of Figure~7");
    const TABLES: &'static [TablePlan] = Attractors::TABLES;
    const REMEDY: &'static str = Figure7::REMEDY;
    type Shown = Attractors;

    fn compute(&self, study: &Study) -> Result<Attractors, StudyError> {
        let map = Map::of(self, study)?;
        map.assembled(map.rows(0..map.count()))
    }

    fn draw(shown: &Attractors, width: SheetWidth) -> Result<Sheet, DrawingError> {
        ink::draw(shown, width)
    }

    /// Remarks on motion that regions do not explain.
    fn remarks(&self, _: &Study, shown: &Attractors) -> Result<Remarks, StudyError> {
        let unexplained = shown.counts.iter().filter(|count| count.unexplained > 0).map(|count| {
            let RegionCount { loops, unexplained, .. } = count;
            format!("p = {loops}: motion settles on the p-loop solution at {unexplained} places outside its regions")
        });
        Ok(Remarks { notes: unexplained.collect(), gaps: Vec::new() })
    }

    fn constants(study: &Study) -> Result<Vec<(&'static str, f64)>, ParameterError> {
        study.oscillator_constants()
    }
}

/// The properties that distinguish and order attractors.
fn identity(one: &AttractorSummary) -> (MotionKind, u32, u64) {
    match one.fate.periods {
        Some(periods) => (one.fate.kind, periods, one.fate.impacts.to_bits()),
        None => (one.fate.kind, 0, 0),
    }
}

impl<'a> Map<'a> {
    /// A map with these numbers of places, for a study.
    ///
    /// # Errors
    /// The oscillator or the window is invalid.
    pub fn of(asked: &BeyondAttractors, study: &'a Study) -> Result<Self, StudyError> {
        let figure: Figure7 = study.parameters.section()?;
        let window = figure.window();
        let oscillator = forced(&study.parameters.oscillator()?, window.primary[0], window.secondary[0])?;
        let size = [asked.columns, asked.rows];
        Ok(Self { study, oscillator: AnyOscillator::new(oscillator), window, loops: figure.loops, size })
    }

    /// The number of rows.
    pub fn count(&self) -> usize {
        self.size[1] as usize
    }

    /// The parameters (μ, η) in the middle of a cell.
    pub fn place(&self, column: u32, row: u32) -> [f64; 2] {
        let share = |number: u32, count: u32| (f64::from(number) + 0.5) / f64::from(count);
        self.window.parameters([share(column, self.size[0]), share(row, self.size[1])])
    }

    /// Computes a range of rows, from the lowest frequency up.
    pub fn rows(&self, which: Range<usize>) -> Vec<MapRow> {
        const ROWS: &str = "rows of the map";
        let progress = &*self.study.progress;
        progress.begin(ROWS, which.len() as u64);
        let row = |row: usize| {
            let row = self.row(row as u32);
            progress.step(ROWS);
            row
        };
        // Each row is a task of its own: neighbouring rows take similar times.
        let rows = which.into_par_iter().with_max_len(1).map(row).collect();
        progress.end(ROWS);
        rows
    }

    fn row(&self, row: u32) -> MapRow {
        let states = STARTS.map(|(position, turns)| State::at_rest(position, TAU * turns));
        let at = |column: u32| {
            let here = self.oscillator.with_parameters(self.place(column, row));
            let mut found = seen(&here, &states, HORIZON);
            found.sort_by_key(identity);
            (column, found)
        };
        let places: Vec<(u32, Vec<AttractorSummary>)> = (0..self.size[0]).map(at).collect();
        let alike = |a: &(u32, Vec<AttractorSummary>), b: &(u32, Vec<AttractorSummary>)| {
            a.1.iter().map(identity).eq(b.1.iter().map(identity))
        };
        let mut stretches = Vec::new();
        for stretch in places.chunk_by(alike) {
            let (column, found) = &stretch[0];
            let [first, secondary] = self.place(*column, row);
            let (places, attractors) = (stretch.len() as u32, found.len() as u32);
            for (k, attractor) in (0..found.len()).zip(1..) {
                let all = || stretch.iter().map(|(_, found)| &found[k]);
                let fate = found[k].fate;
                let mean = all().map(|one| one.fate.impacts).sum::<f64>() / f64::from(places);
                let irregular =
                    |of: &dyn Fn(&AttractorSummary) -> f64, choose: fn(f64, f64) -> f64| match fate.periods {
                        Some(_) => f64::NAN,
                        None => all().map(of).fold(f64::NAN, choose),
                    };
                stretches.push(Stretch {
                    secondary,
                    first,
                    places,
                    attractors,
                    attractor,
                    motion: fate.kind.name().to_owned(),
                    periods: fate.periods.unwrap_or(0),
                    impacts: if fate.periods.is_some() { fate.impacts } else { mean },
                    least: irregular(&|one| one.exponent.mean, f64::min),
                    greatest: irregular(&|one| one.exponent.mean, f64::max),
                    error: irregular(&|one| one.exponent.error, f64::max),
                });
            }
        }
        MapRow { row, stretches }
    }

    /// Whether a row from any origin is plausible as this row of the map: its places are consecutive and
    /// complete, and all its values are known.
    pub fn fits(&self, row: &MapRow, index: usize) -> bool {
        let mut column = 0;
        let known = |stretch: &Stretch| MotionKind::ALL.iter().any(|kind| kind.name() == stretch.motion);
        let fit = row.groups().all(|group| {
            let Stretch { places, .. } = group[0];
            let [first, secondary] = self.place(column, row.row);
            let numbered = group.iter().zip(1..).all(|(one, number)| {
                let counts = (one.places, one.attractors, one.attractor);
                counts == (places, group.len() as u32, number)
                    && (one.first, one.secondary) == (first, secondary)
                    && !one.impacts.is_nan()
                    && known(one)
            });
            column = places.saturating_add(column);
            numbered && places > 0 && column <= self.size[0]
        });
        fit && row.row as usize == index && column == self.size[0]
    }

    /// The map assembled from all its rows.
    ///
    /// # Errors
    /// There is no grazing in the window.
    pub fn assembled(&self, rows: Vec<MapRow>) -> Result<Attractors, StudyError> {
        let regions = &self.study.diagram()?.regions;
        let (mut counts, mut remarks) = (Vec::new(), Vec::new());
        let [across, up] =
            [self.window.primary, self.window.secondary].map(|[from, to]| BORDER * (to - from));
        for &loops in [0].iter().chain(&self.loops) {
            let mut count = RegionCount { loops, in_regions: 0, settled: 0, unseen: 0, unexplained: 0 };
            for row in &rows {
                let (secondary, settled) = (self.place(0, row.row)[1], row.settled(loops));
                let intervals = |secondary: f64, decided: bool| {
                    let own =
                        regions.iter().filter(move |it| it.loops == loops && it.doubt.is_none() == decided);
                    own.flat_map(|region| region.chords(secondary)).collect::<Vec<_>>()
                };
                let sure = intervals(secondary, true);
                let beside =
                    [-up, 0.0, up].map(|by| [true, false].map(|decided| intervals(secondary + by, decided)));
                let possible = beside.concat().concat();
                let says = |column: u32| {
                    let at = self.place(column, row.row)[0];
                    let within = |all: &[[f64; 2]], room: f64| {
                        all.iter().any(|[from, to]| from - room <= at && at <= to + room)
                    };
                    match (within(&sure, 0.0), settled[column as usize]) {
                        (true, true) => count.settled += 1,
                        (true, false) => return Some("unseen"),
                        (false, true) if !within(&possible, across) => return Some("unexplained"),
                        (false, _) => {}
                    }
                    None
                };
                let said: Vec<(u32, Option<&str>)> = (0..).zip((0..self.size[0]).map(says)).collect();
                for stretch in said.chunk_by(|a, b| a.1 == b.1) {
                    let (column, Some(remark)) = stretch[0] else { continue };
                    let (first, places) = (self.place(column, row.row)[0], stretch.len() as u32);
                    *(if remark == "unseen" { &mut count.unseen } else { &mut count.unexplained }) += places;
                    remarks.push(Remark { remark, loops, secondary, first, places });
                }
            }
            count.in_regions = count.settled + count.unseen;
            counts.push(count);
        }
        let stretches = rows.into_iter().flat_map(|row| row.stretches).collect();
        let diagram = plane::rows(self.study.diagram()?, None);
        Ok(Attractors { stretches, counts, remarks, diagram, size: self.size })
    }
}

/// Groups the attractors at the same places, from left to right.
fn groups(stretches: &[Stretch]) -> impl Iterator<Item = &[Stretch]> {
    stretches.chunk_by(|a, b| a.attractor < b.attractor)
}

impl MapRow {
    /// The attractors at the same places, group by group from left to right.
    pub fn groups(&self) -> impl Iterator<Item = &[Stretch]> {
        groups(&self.stretches)
    }

    /// Whether some motion settles on a p-loop solution, place by place.
    fn settled(&self, loops: u32) -> Vec<bool> {
        let settled = self.groups().flat_map(|group| {
            let settled = group.iter().any(|one| one.loops() == Some(loops));
            std::iter::repeat_n(settled, group[0].places as usize)
        });
        settled.collect()
    }
}

impl Stretch {
    /// The number of loops p of an MPS, or 0 for motion without impacts of one period; nothing for other
    /// motion.
    pub fn loops(&self) -> Option<u32> {
        // With rests at the wall there are infinitely many impacts: none of its impacts is plastic.
        place::loops(f64::from(self.periods), [self.impacts, 0.0])
    }
}
