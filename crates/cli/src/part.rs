//! Parts of work that is too large for one machine, as files that are merged.
//!
//! A family has members, a map has rows: items, each of which is computed without the others. A
//! part holds the records of some items, and the work that they belong to.

use std::ops::Range;
use std::path::{Path, PathBuf};

use grazing_input::shortened;
use grazing_report::FileDigest;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::commands::CommandLine;
use crate::failure::Failure;
use crate::folder::{self, OutputFile};
use crate::limits::ended;
use crate::runner::{CommandOutcome, Next, Plan, Running};
use crate::variation::PartNumber;
use crate::versions;

/// Work that can be divided: everything that determines the computation.
pub(crate) trait Divided: PartialEq + Serialize + DeserializeOwned {
    /// The kind of work, in a word.
    const IS: &'static str;
    /// A word for the items, in the plural.
    const ITEMS: &'static str;
    /// The inputs that must be the same in all parts, as a list for messages.
    const SAME: &'static str;
    /// The command that writes parts.
    const COMMAND: &'static str;
    /// The data read from the work, with which records are checked and joined.
    type Task;
    /// The result for an item.
    type Record: Serialize + DeserializeOwned;

    /// Reads the work.
    ///
    /// # Errors
    /// The work is not valid.
    fn task(&self) -> Result<Self::Task, Failure>;

    /// The number of items.
    fn count(task: &Self::Task) -> usize;

    /// Whether a record from any source can be that of this item.
    fn fits(task: &Self::Task, record: &Self::Record, index: usize) -> bool;
}

/// The range of items in a part: parts are as equal as possible, and together hold all items.
///
/// # Errors
/// There are more parts than items.
pub(crate) fn items<W: Divided>(part: PartNumber, count: usize) -> Result<Range<usize>, Failure> {
    let end = |number: usize| count * number / part.parts;
    if part.parts > count {
        let (is, items) = (W::IS, W::ITEMS);
        return Err(Failure::input(format!(
            "--part {part}: the {is} has {count} {items}, so it can have at most {count} parts"
        )));
    }
    Ok(end(part.part - 1)..end(part.part))
}

/// The folder of parts, in that of the results.
const PARTS: &str = "parts";

/// A part: everything needed for tables and figures once all parts are there.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, bound = "")]
struct PartFile<W: Divided> {
    /// The program that computed the part.
    program: String,
    /// The kind of work that the part belongs to.
    of: String,
    part: PartNumber,
    work: W,
    #[serde(default = "Vec::new")]
    records: Vec<W::Record>,
}

/// The path of a part in the folder of the results.
fn path(PartNumber { part, parts }: PartNumber) -> PathBuf {
    let digits = parts.to_string().len();
    Path::new(PARTS).join(format!("{part:0digits$}-of-{parts}.toml"))
}

/// The plan of a part of some work: `compute` returns the record of each item, none if it was not finished.
pub(crate) fn plan<'a, W: Divided + 'a>(
    part: PartNumber,
    work: W,
    folder: PathBuf,
    file: &'a Path,
    compute: impl FnOnce(&Running<'_>) -> Result<Vec<Option<W::Record>>, Failure> + 'a,
) -> Plan<'a> {
    let complete = move |running: &Running<'_>| {
        let records = compute(running)?.into_iter().collect::<Option<_>>();
        let outcome = "a part is written only if it is complete; nothing is written";
        records.ok_or_else(|| ended(file, running.end_cause(), outcome))
    };
    let say = move |records, folder: &Path| {
        let first = match part.parts {
            1 => String::new(),
            parts => format!("once all {parts} parts are there, "),
        };
        let merge = CommandLine::own("merge").with_files(folder.join(PARTS).display(), "*.toml");
        let next = Next::Command(first, merge);
        Ok(CommandOutcome { next, ..CommandOutcome::unlisted(vec![made(part, work, records)?], folder)? })
    };
    Plan::new(complete, say).writing(folder, [path(part)])
}

/// The first line of a part: the digest of all that follows.
const SEAL: &str = "sha256 = ";

/// A text after its digest.
fn sealed(text: &str) -> String {
    format!("{SEAL}\"{}\"\n{text}", FileDigest::of("", text.as_bytes()).sha256)
}

/// The text after the digest, if the digest fits to the last bit.
fn unsealed(content: &str) -> Option<&str> {
    let (_, text) = content.split_once('\n')?;
    (sealed(text) == content).then_some(text)
}

/// The file of a part with the records of its items.
///
/// # Errors
/// The file is too long to be read again.
fn made<W: Divided>(part: PartNumber, work: W, records: Vec<W::Record>) -> Result<OutputFile, Failure> {
    let file = PartFile { program: versions::program(), of: W::IS.to_owned(), part, work, records };
    let text = toml::to_string(&file).map_err(|error| Failure::incomplete(error.to_string()))?;
    let content = sealed(&text).into_bytes();
    if content.len() as u64 > folder::MOST_BYTES {
        let (most, is) = (folder::MOST_BYTES, W::IS);
        return Err(Failure::incomplete(format!(
            "the part is longer than the {most} bytes that `merge` reads: compute the {is} in more parts"
        )));
    }
    Ok(OutputFile { path: path(part), content })
}

/// Whether a file claims to be a part of such work.
pub(crate) fn is_of<W: Divided>(path: &Path) -> bool {
    #[derive(Deserialize)]
    struct Claim {
        of: String,
    }
    let content = folder::read(path).unwrap_or_default();
    toml::from_slice::<Claim>(&content).is_ok_and(|claim| claim.of == W::IS)
}

impl<W: Divided> PartFile<W> {
    /// Reads a part, which may come from any source, and checks it as far as possible without the others.
    fn read(path: &Path) -> Result<Self, String> {
        let content = folder::read(path).map_err(|reason| format!("cannot be read: {reason}"))?;
        let no_part = || format!("is not a part of a {} as `{} --part` writes it", W::IS, W::COMMAND);
        let content =
            String::from_utf8(content).map_err(|_| format!("{}: it is not UTF-8 text", no_part()))?;
        if !content.starts_with(SEAL) {
            return Err(format!("{}: it does not begin with `{SEAL}`", no_part()));
        }
        let text = unsealed(&content).ok_or(
            "is damaged: its digest is not the one in its first line; copy it again or compute it again",
        )?;
        let found: Self =
            toml::from_str(text).map_err(|reason| format!("{}: {}", no_part(), reason.message()))?;
        let (program, own) = (&found.program, versions::program());
        if *program != own {
            let program = shortened(program, 100);
            return Err(format!(
                "was computed by {program}, but this is {own}: compute all parts with one program"
            ));
        }
        Ok(found)
    }

    /// Checks that the records fit the work.
    fn check(&self, task: &W::Task) -> Result<(), Failure> {
        let which = items::<W>(self.part, W::count(task))?;
        let fits = |(record, index): (&W::Record, usize)| W::fits(task, record, index);
        if self.records.len() != which.len() || !self.records.iter().zip(which).all(fits) {
            let part = self.part;
            return Err(Failure::input(format!(
                "its records do not belong to part {part}: compute it again with --part {part}"
            )));
        }
        Ok(())
    }
}

/// Work with the records of all its parts.
pub(crate) struct Joined<W: Divided> {
    pub(crate) work: W,
    pub(crate) task: W::Task,
    pub(crate) records: Vec<W::Record>,
}

/// Joins all parts.
///
/// # Errors
/// A part cannot be read, does not fit, belongs to other work, is given twice, or is missing.
pub(crate) fn joined<W: Divided>(paths: &[PathBuf]) -> Result<Joined<W>, Failure> {
    let mut found: Vec<(&PathBuf, PartFile<W>)> = Vec::new();
    let mut task = None;
    for path in paths {
        let refuse = |reason: String| Failure::input(format!("{}: {reason}", path.display()));
        let part = PartFile::read(path).map_err(refuse)?;
        let PartNumber { part: number, parts: count } = part.part;
        if let Some((first, other)) = found.first()
            && (&part.work, count) != (&other.work, other.part.parts)
        {
            let (is, same) = (W::IS, W::SAME);
            return Err(refuse(format!(
                "belongs to another {is} than {}: {same} and number of parts must be the same",
                first.display()
            )));
        }
        if let Some((other, _)) = found.iter().find(|(_, other)| other.part == part.part) {
            return Err(refuse(format!(
                "is part {number} of {count}, and so is {}: name each part once",
                other.display()
            )));
        }
        let known = task.take().map_or_else(|| part.work.task(), Ok);
        let checked = known.and_then(|task| part.check(&task).map(|()| task));
        task = Some(checked.map_err(|failure| refuse(failure.reason))?);
        found.push((path, part));
    }
    let Some(task) = task else {
        return Err(Failure::input("no parts are named: name all parts of a family or a map"));
    };
    found.sort_by_key(|(_, part)| part.part.part);
    let count = found[0].1.part.parts;
    if found.len() < count {
        let is_there = |number: &usize| found.iter().any(|(_, part)| part.part.part == *number);
        let missing = (1..=count).filter(|number| !is_there(number)).take(10);
        let shown = missing.map(|number| number.to_string()).collect::<Vec<_>>().join(", ");
        let missing = count - found.len();
        let more = if missing > 10 { ", ..." } else { "" };
        return Err(Failure::input(format!(
            "{missing} of {count} parts are missing: {shown}{more}: compute them with --part K/{count} and name them too"
        )));
    }
    let first = found.remove(0).1;
    let more = found.into_iter().flat_map(|(_, part)| part.records);
    Ok(Joined { work: first.work, task, records: first.records.into_iter().chain(more).collect() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_flipped_bit_and_no_missing_end_of_a_part_goes_unnoticed() {
        let text = "part = \"1/2\"\n[[records]]\nindex = 0\nomega = 0.97811\n";
        let whole = sealed(text);
        assert_eq!(unsealed(&whole), Some(text));
        for place in 0..whole.len() {
            assert_eq!(unsealed(&whole[..place]), None, "cut off at {place}");
            for bit in 0..8 {
                let mut bytes = whole.clone().into_bytes();
                bytes[place] ^= 1 << bit;
                // Content that is no longer UTF-8 is rejected before.
                if let Ok(changed) = String::from_utf8(bytes) {
                    assert_eq!(unsealed(&changed), None, "bit {bit} of byte {place}");
                }
            }
        }
        assert_eq!(unsealed(&(whole + "\n")), None);
    }
}
