//! `grazing attractors`: the attractors over the window of Figure 7, as a map that can be computed in parts.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use grazing_model::smooth::Stop;
use grazing_reproduction::figures::beyond_attractors::{
    Attractors, BeyondAttractors, Map, MapRow, RegionCount,
};
use grazing_reproduction::parameters::Parameters;
use grazing_reproduction::{Study, StudyError};
use grazing_source::{Setting, Text};
use serde::{Deserialize, Serialize};

use crate::arguments;
use crate::commands::CommandLine;
use crate::failure::{Failure, computation};
use crate::folder::{self, summary};
use crate::layout::Layout;
use crate::outputs::edition::{Edition, Format};
use crate::outputs::{Output, latex, paper};
use crate::part::{self, Divided, Joined};
use crate::progress::Display;
use crate::{data_page, limits, project, terminal};

/// The folder of the results, unless another one is named.
const RESULTS: &str = "attractors";

const OUTPUT: Output<Study> = paper::figure::<BeyondAttractors>();

/// A map as work that can be divided: everything that its records depend on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MapWork {
    /// The text of the parameter file.
    parameters: String,
    /// The settings over the parameter file, and the size of the map.
    set: Vec<String>,
}

/// The section and the study that are read from a [`MapWork`].
pub(crate) struct MapTask {
    asked: BeyondAttractors,
    study: Study,
}

impl MapTask {
    fn map(&self) -> Result<Map<'_>, Failure> {
        Map::of(&self.asked, &self.study).map_err(failure)
    }
}

fn failure(error: StudyError) -> Failure {
    computation(OUTPUT.name, &error)
}

impl MapWork {
    fn new(arguments: &arguments::Attractors) -> Result<Self, Failure> {
        let (_, parameters) = project::parameter_file(arguments.parameters.file.as_deref())?;
        let [columns, rows] = arguments.size;
        let size = [("columns", columns), ("rows", rows)]
            .map(|(key, count)| format!("{}.{key}={count}", OUTPUT.name));
        let set = arguments.parameters.set.iter().map(ToString::to_string).chain(size).collect();
        Ok(Self { parameters, set })
    }
}

impl Divided for MapWork {
    const IS: &'static str = "map";
    const ITEMS: &'static str = "rows";
    const SAME: &'static str = "parameters, settings, size";
    const COMMAND: &'static str = "attractors";
    type Task = MapTask;
    type Record = MapRow;

    fn task(&self) -> Result<MapTask, Failure> {
        let settings = self.set.iter().map(|setting| Ok(setting.parse::<Setting>()?));
        let settings = settings.collect::<Result<Vec<_>, Failure>>()?;
        let parameters = Parameters::parse(&Text::new(&self.parameters, &settings), project::PARAMETERS)?;
        let study = Study::new(&parameters).with_progress(Arc::new(Display::counting(Stop::default())));
        let task = MapTask { asked: parameters.section()?, study };
        task.map()?;
        Ok(task)
    }

    fn count(task: &MapTask) -> usize {
        task.asked.rows as usize
    }

    fn fits(task: &MapTask, record: &MapRow, index: usize) -> bool {
        task.map().is_ok_and(|map| map.fits(record, index))
    }
}

/// Computes a map, or a part of it.
///
/// # Errors
/// Bad input, before anything is computed.
pub(crate) fn run(arguments: &arguments::Attractors) -> Result<(), Failure> {
    limits::leave_nothing_behind();
    let began = Instant::now();
    let work = MapWork::new(arguments)?;
    let task = work.task()?;
    let count = MapWork::count(&task);
    let folder = arguments.output.clone().unwrap_or_else(|| PathBuf::from(RESULTS));
    let edition = arguments.look.edition();
    let rows = arguments.part.map_or(Ok(0..count), |part| part::items::<MapWork>(part, count))?;
    let written = arguments.part.map_or_else(|| paths(&edition), |part| vec![part::path(part)]);
    folder::ensure_writable(&folder, &written)?;
    arguments.threads.start()?;
    let records = task.map()?.rows(rows);
    match arguments.part {
        Some(part) => {
            let made = part::made(part, work, records)?;
            terminal::say(&summary(&folder::written(&folder, &[made])?));
            part::say_next(part, &folder);
            Ok(())
        }
        None => finish(&task, records, &folder, &edition, began),
    }
}

/// Joins the parts of a map, and writes the same files as one run does.
///
/// # Errors
/// A file is not a part or belongs to another map, or a part is missing or given twice.
pub(crate) fn merge(arguments: &arguments::Merge) -> Result<(), Failure> {
    let began = Instant::now();
    let Joined { task, records, .. } = part::joined::<MapWork>(&arguments.parts)?;
    let folder = arguments.output.clone().unwrap_or_else(|| PathBuf::from(RESULTS));
    let edition = arguments.look.edition();
    folder::ensure_writable(&folder, &paths(&edition))?;
    finish(&task, records, &folder, &edition, began)
}

/// Writes the figure and tables of all rows, and prints where regions and motion disagree.
fn finish(
    task: &MapTask,
    rows: Vec<MapRow>,
    folder: &Path,
    edition: &Edition,
    began: Instant,
) -> Result<(), Failure> {
    let shown = task.map()?.assembled(rows).map_err(failure)?;
    let counts = counted(terminal::layout(), &shown);
    let computed = paper::computed(&OUTPUT, &task.asked, &task.study, &shown, edition.columns);
    let computed = computed.map_err(|error| computation(OUTPUT.name, &*error))?;
    let (mut files, floats) = computed.files(edition)?;
    if edition.has(Format::Tex) {
        files.extend(latex::files(&floats, []));
    }
    files.push(data_page::of_the_paper(OUTPUT.tables.iter().copied()));
    let written = folder::write_run(folder, &files, false)?;
    computed.notes.iter().for_each(|note| terminal::note(note));
    terminal::say(&format!("{counts}\n{}", summary(&written)));
    terminal::say(&format!("{:.1} s\n", began.elapsed().as_secs_f64()));
    terminal::say_next(&CommandLine::of(&["open"]).with(folder::first(&written)));
    Ok(())
}

/// The numbers of places at which regions and attractors agree, and at which they do not.
fn counted(layout: Layout, shown: &Attractors) -> String {
    let line = |count: &RegionCount| {
        let RegionCount { loops, in_regions, settled, unseen, unexplained } = *count;
        [loops, in_regions, settled, unseen, unexplained].map(|count| count.to_string()).to_vec()
    };
    layout.aligned(&["p", "in regions", "settled", "unseen", "unexplained"], shown.counts.iter().map(line))
}

/// The paths of all files of a map.
fn paths(edition: &Edition) -> Vec<PathBuf> {
    let mut paths = OUTPUT.paths(edition);
    paths.extend([data_page::path(), PathBuf::from(folder::MANIFEST)]);
    paths
}
