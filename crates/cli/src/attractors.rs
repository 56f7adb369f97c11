//! `grazing attractors`: the attractors over the window of Figure 7, as a map that can be computed in parts.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use grazing_beyond::attractors::{Attractors, BeyondAttractors, Map, MapRow, RegionCount};
use grazing_beyond::parameters;
use grazing_input::{Setting, Text};
use grazing_model::smooth::Stop;
use grazing_reproduction::{Study, StudyError};
use serde::{Deserialize, Serialize};

use crate::arguments;
use crate::failure::{Failure, computation};
use crate::folder::Batch;
use crate::layout::Layout;
use crate::outputs::edition::Edition;
use crate::outputs::{Output, accompanying, paper};
use crate::part::{self, Divided, Joined};
use crate::progress::Display;
use crate::runner::{CommandOutcome, Next, Plan, Running};
use crate::{data_page, project, terminal};

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
    fn new(arguments: &arguments::AttractorsArguments) -> Result<Self, Failure> {
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
        let parameters = parameters::parse(&Text::new(&self.parameters, &settings), project::PARAMETERS)?;
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

/// Reads a map, or a part of it.
///
/// # Errors
/// Bad input.
pub(crate) fn read(arguments: &arguments::AttractorsArguments) -> Result<Plan<'_>, Failure> {
    let arguments::AttractorsArguments { part, output, look, .. } = arguments;
    let work = MapWork::new(arguments)?;
    let task = work.task()?;
    let count = MapWork::count(&task);
    let rows = part.map_or(Ok(0..count), |part| part::items::<MapWork>(part, count))?;
    let folder = output.clone().unwrap_or_else(|| PathBuf::from(RESULTS));
    let Some(part) = *part else {
        return Ok(plan(move |task| Ok(task.map()?.rows(rows)), task, folder, look.edition()));
    };
    let compute = move |_: &Running<'_>| Ok(task.map()?.rows(rows).into_iter().map(Some).collect());
    Ok(part::plan(part, work, folder, Path::new(RESULTS), compute))
}

/// Whether the first part is one of a map.
pub(crate) fn has_part(arguments: &arguments::MergeArguments) -> bool {
    arguments.parts.first().is_some_and(|first| part::is_of::<MapWork>(first))
}

/// Reads the parts of a map, of which the same files are written as one run does.
///
/// # Errors
/// A file is not a part or belongs to another map, or a part is missing or given twice.
pub(crate) fn merge(arguments: &arguments::MergeArguments) -> Result<Plan<'_>, Failure> {
    let Joined { task, records, .. } = part::joined::<MapWork>(&arguments.parts)?;
    let folder = arguments.output.clone().unwrap_or_else(|| PathBuf::from(RESULTS));
    Ok(plan(|_| Ok(records), task, folder, arguments.look.edition()))
}

/// The plan of a whole map: its figure and tables, and where regions and motion disagree.
fn plan<'a>(
    rows: impl FnOnce(&MapTask) -> Result<Vec<MapRow>, Failure> + 'a,
    task: MapTask,
    folder: PathBuf,
    edition: Edition,
) -> Plan<'a> {
    let paths = OUTPUT.paths(&edition);
    let compute = move |_: &Running<'_>| {
        let rows = rows(&task)?;
        Ok((task, rows))
    };
    let say = move |(task, rows): (MapTask, _), folder: &Path| {
        let shown = task.map()?.assembled(rows).map_err(failure)?;
        let computed = paper::computed(&OUTPUT, &task.asked, &task.study, &shown, edition.columns);
        let computed = computed.map_err(|error| computation(OUTPUT.name, &*error))?;
        let (mut files, floats) = computed.files(&edition)?;
        let about = data_page::of_the_paper(OUTPUT.tables.iter().copied());
        files.extend(accompanying(&edition, &floats, [], about));
        let (text, batches) = (counted(terminal::layout(), &shown), vec![Batch::run(folder, files)]);
        Ok(CommandOutcome {
            text,
            batches,
            next: Next::Look,
            notes: computed.notes,
            ..CommandOutcome::default()
        })
    };
    Plan::new(compute, say).writing_run(folder, paths)
}

/// The numbers of places at which regions and attractors agree, and at which they do not.
fn counted(layout: Layout, shown: &Attractors) -> String {
    let line = |count: &RegionCount| {
        let RegionCount { loops, in_regions, settled, unseen, unexplained } = *count;
        [loops, in_regions, settled, unseen, unexplained].map(|count| count.to_string()).to_vec()
    };
    layout.aligned(&["p", "in regions", "settled", "unseen", "unexplained"], shown.counts.iter().map(line))
}
