//! `grazing unfold --vary` and `grazing merge`: the resonances of an oscillator as constants of its
//! file vary.

mod listing;
mod origin;

use std::ops::Range;
use std::path::{Path, PathBuf};

use grazing_input::{AnalysisLimits, Description};
use grazing_model::smooth::Stop;
use grazing_results::brief;
use grazing_unfold::family::{FamilyPlan, Record, assemble, names, records};
use grazing_unfold::nothing::Nothing;

use crate::arguments;
use crate::failure::Failure;
use crate::folder::Batch;
use crate::layout::Layout;
use crate::limits::{EndCause, ended, reading};
use crate::oscillator::constants;
use crate::outputs::accompanying;
use crate::outputs::edition::Edition;
use crate::outputs::family::{FAMILY, NamedFamily};
use crate::part::{self, Joined};
use crate::runner::{self, CommandOutcome, Next, Running};
use crate::variation::{MOST_MEMBERS, PartNumber, Variation};
use crate::{data_page, terminal};
pub(crate) use origin::FamilyOrigin;
use origin::FamilyWork;

/// A family, and all its members or those in a part of it, each with its number.
pub(crate) struct FamilyMembers {
    description: Description,
    plan: FamilyPlan,
    members: Vec<(usize, Description)>,
}

/// Reads a family, or a part of it; of a computation that is cancelled the finished part is written.
///
/// # Errors
/// Bad input.
pub(crate) fn read(arguments: &arguments::UnfoldArguments) -> Result<runner::Plan<'_>, Failure> {
    let arguments::UnfoldArguments { files, vary, part, output, look, limits, .. } = arguments;
    let [file] = files.as_slice() else {
        return Err(Failure::input(
            "--vary takes one file at a time: name one file, and run the command again for the next",
        ));
    };
    arguments.named.of(None)?;
    let origin = FamilyOrigin::of_file(file, arguments)?;
    // Members have more time together, but their number is not known yet.
    let read = |stop: &Stop| FamilyMembers::read(&origin, vary, *part, stop);
    let (family, taken) = reading(file, limits.over(AnalysisLimits::USUAL), read)?;
    let folder = output.clone().unwrap_or_else(|| origin.folder());
    let (heading, limits) = (family.heading(terminal::layout(), file, *part), limits.over(family.limits()));
    let plan = if let Some(part) = *part {
        let work = FamilyWork { vary: vary.clone(), origin };
        part::plan(part, work, folder, file, move |running| Ok(family.records(running)))
    } else {
        let compute = move |running: &Running<'_>| {
            let records = family.records(running);
            match records.iter().all(Option::is_none) {
                true => Err(ended(file, running.end_cause(), "no member is finished; nothing is written")),
                false => Ok((family, records, running.end_cause())),
            }
        };
        let edition = look.edition();
        let paths = FAMILY.paths(&edition);
        let say = move |(family, records, cause): (FamilyMembers, _, _), folder: &Path| {
            family.outcome(file, records, cause, folder, &edition)
        };
        runner::Plan::new(compute, say).writing_run(folder, paths)
    };
    Ok(plan.within(file, (limits, taken)).headed(heading))
}

/// Reads the parts of a family, of which the same files are written as one run does.
///
/// # Errors
/// A file is not a part or belongs to another family, or a part is missing or given twice.
pub(crate) fn merge(arguments: &arguments::MergeArguments) -> Result<runner::Plan<'_>, Failure> {
    let Joined { work, task, records } = part::joined::<FamilyWork>(&arguments.parts)?;
    let (FamilyWork { origin, .. }, (description, plan)) = (work, task);
    let (file, edition) = (PathBuf::from(&origin.file), arguments.look.edition());
    let folder = arguments.output.clone().unwrap_or_else(|| origin.folder());
    let family = FamilyMembers { description, plan, members: Vec::new() };
    let records = records.into_iter().map(Some).collect();
    let paths = FAMILY.paths(&edition);
    let say = move |records, folder: &Path| family.outcome(&file, records, None, folder, &edition);
    Ok(runner::Plan::new(|_| Ok(records), say).writing_run(folder, paths))
}

impl FamilyMembers {
    /// Reads and checks all that a family, or a part of it, is computed from.
    pub(crate) fn read(
        origin: &FamilyOrigin,
        vary: &[Variation],
        part: Option<PartNumber>,
        stop: &Stop,
    ) -> Result<Self, Failure> {
        let description = origin.description(&[], stop)?;
        let plan = plan(vary, &description)?;
        let which = part.map_or(Ok(0..plan.count()), |part| part::items::<FamilyWork>(part, plan.count()))?;
        let members = members(origin, &plan, which, stop)?;
        Ok(Self { description, plan, members })
    }

    /// The line about the family that is about to be computed.
    fn heading(&self, layout: Layout, file: &Path, part: Option<PartNumber>) -> String {
        listing::plan(layout, &self.description, file, &self.plan, part, self.members.len())
    }

    /// The limits of a family: those of time and steps in the file apply to a member on average.
    pub(crate) fn limits(&self) -> AnalysisLimits {
        let AnalysisLimits { time, memory, steps } = self.description.limits();
        let members = self.members.len().max(1) as f64;
        AnalysisLimits { time: time * members, memory, steps: steps * members }
    }

    /// The records of the members; none for those that were not finished.
    pub(crate) fn records(&self, running: &Running<'_>) -> Vec<Option<Record>> {
        let tell = |description: &Description, error: &_| Nothing::new(error, description).to_string();
        records(&self.plan, &self.members, &tell, &running.stop(), &**running.progress())
    }

    /// A family of all records, with its names, and its contents as lines.
    pub(crate) fn named(
        &self,
        layout: Layout,
        file: &Path,
        records: Vec<Option<Record>>,
    ) -> (NamedFamily, String) {
        let Self { description, plan, .. } = self;
        let (names, family) = (names(plan, description), assemble(plan, description, records));
        let text = listing::results(layout, &family, &names, plan);
        (NamedFamily { file: file.to_owned(), name: description.name().to_owned(), names, family }, text)
    }

    /// The figure and the tables of all records.
    fn outcome(
        &self,
        file: &Path,
        records: Vec<Option<Record>>,
        cause: Option<EndCause>,
        folder: &Path,
        edition: &Edition,
    ) -> Result<CommandOutcome, Failure> {
        let (all, missing) = (records.len(), records.iter().filter(|record| record.is_none()).count());
        let (of, text) = self.named(terminal::layout(), file, records);
        let (_, mut files, floats) = FAMILY.made(&of, edition)?;
        let about = data_page::of_an_oscillator(FAMILY.tables.iter().copied(), &of.names);
        files.extend(accompanying(edition, &floats, [], about));
        let failure = match (of.family.incomplete, missing) {
            (0, 0) => None,
            (0, _) => {
                let outcome = format!("{missing} of {all} members are missing; the others are written");
                Some(ended(file, cause, &outcome))
            }
            (incomplete, _) => Some(Failure::incomplete(format!(
                "{}: results are missing for {incomplete} members, see above; everything else is written",
                file.display()
            ))),
        };
        let batches = vec![Batch { incomplete: missing > 0, ..Batch::run(folder, files) }];
        Ok(CommandOutcome { text, batches, next: Next::Look, failure, ..CommandOutcome::default() })
    }
}

/// The constants that vary, checked.
fn plan(vary: &[Variation], description: &Description) -> Result<FamilyPlan, Failure> {
    const MOST: usize = grazing_results::VARIED;
    if !(1..=MOST).contains(&vary.len()) {
        let count = vary.len();
        return Err(Failure::input(format!(
            "--vary: given for {count} constants; at most {MOST} can vary, because the tables have {MOST} columns for them"
        )));
    }
    constants("--vary", vary.iter().map(|Variation(varied)| varied.name.as_str()), description)?;
    let plan = FamilyPlan { varied: vary.iter().map(|Variation(varied)| varied.clone()).collect() };
    let count = plan.varied.iter().try_fold(1_usize, |count, varied| count.checked_mul(varied.values.len()));
    match count {
        Some(count) if count <= MOST_MEMBERS => Ok(plan),
        _ => Err(Failure::input(format!("--vary: the family has more than {MOST_MEMBERS} members"))),
    }
}

/// Some members, each with its number; all are read and checked before anything is computed.
fn members(
    origin: &FamilyOrigin,
    plan: &FamilyPlan,
    which: Range<usize>,
    stop: &Stop,
) -> Result<Vec<(usize, Description)>, Failure> {
    let member = |index: usize| {
        let names = plan.varied.iter().map(|varied| varied.name.as_str());
        let values: Vec<(&str, f64)> = names.zip(plan.values(index)).collect();
        match origin.description(&values, stop) {
            Ok(description) => Ok((index, description)),
            Err(mut failure) => {
                let set = values.iter().map(|(name, value)| format!("{name} = {}", brief(*value, 6)));
                let set = set.collect::<Vec<_>>().join(", ");
                failure.reason = format!("--vary: with {set}: {}", failure.reason);
                Err(failure)
            }
        }
    };
    which.map(member).collect()
}
