//! Parts of a family, as files that are merged.

use std::path::{Path, PathBuf};

use grazing_description::Description;
use grazing_model::smooth::Stop;
use grazing_report::FileDigest;
use grazing_reproduction::family::{Plan, Record};
use grazing_source::{Setting, Text, shortened};
use serde::{Deserialize, Serialize};

use super::plan;
use crate::arguments;
use crate::failure::Failure;
use crate::folder::{self, OutputFile};
use crate::oscillator;
use crate::variation::{Part, Variation};
use crate::versions;

/// The folder of the results, with a folder in it for each file.
const RESULTS: &str = "families";
/// The folder of parts, in that of the family.
const PARTS: &str = "parts";

/// Where an oscillator comes from: all that is needed to read it again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Origin {
    /// The file, as it was named.
    pub(super) file: String,
    text: String,
    /// What was set over it, with the keys in full.
    set: Vec<String>,
    /// Numbers of loops in the place of the file's.
    #[serde(skip_serializing_if = "Option::is_none")]
    loops: Option<Vec<u32>>,
}

impl Origin {
    /// An oscillator from a text, with what is set over it.
    pub(crate) fn new(file: String, text: String, set: Vec<String>, loops: Option<Vec<u32>>) -> Self {
        Self { file, text, set, loops }
    }

    pub(super) fn of_file(file: &Path, arguments: &arguments::Unfold) -> Result<Self, Failure> {
        let text = grazing_source::read_file(file).map_err(grazing_description::DescriptionError::from)?;
        let set = oscillator::settings(&arguments.set).iter().map(ToString::to_string).collect();
        Ok(Self::new(file.display().to_string(), text, set, arguments.loops.clone()))
    }

    /// The oscillator with other values of constants, checked, until an end is asked for.
    pub(super) fn description(&self, values: &[(&str, f64)], stop: &Stop) -> Result<Description, Failure> {
        let given = self.set.iter().map(|setting| Ok(setting.parse::<Setting>()?));
        let varied = values.iter().map(|(name, value)| {
            let set = Setting::new(&format!("parameters.{name}"), *value);
            set.map_err(|error| Failure::input(format!("--vary {name}: {error}")))
        });
        let settings = given.chain(varied).collect::<Result<Vec<_>, Failure>>()?;
        let description = Description::parse_with(&Text::new(&self.text, &settings), &self.file, stop)?;
        oscillator::with_loops(description, self.loops.as_deref())
    }

    /// The folder of the family, unless another one is named.
    pub(super) fn folder(&self) -> PathBuf {
        Path::new(RESULTS).join(folder::name_for(Path::new(&self.file)))
    }
}

/// A part of a family: everything that is needed to make tables and figures once all parts are
/// there.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PartFile {
    /// The program that made it.
    program: String,
    part: Part,
    pub(super) vary: Vec<Variation>,
    pub(super) origin: Origin,
    #[serde(default)]
    pub(super) records: Vec<Record>,
}

/// Where a part lies in the folder of the family.
pub(super) fn path(Part { part, parts }: Part) -> PathBuf {
    let digits = parts.to_string().len();
    Path::new(PARTS).join(format!("{part:0digits$}-of-{parts}.toml"))
}

/// The first line of a part: the digest of all that follows.
const SEAL: &str = "sha256 = ";

/// A text behind its digest.
fn sealed(text: &str) -> String {
    format!("{SEAL}\"{}\"\n{text}", FileDigest::of("", text.as_bytes()).sha256)
}

/// What stands behind its digest, if that is the digest of it, to the last bit.
fn unsealed(content: &str) -> Option<&str> {
    let (_, text) = content.split_once('\n')?;
    (sealed(text) == content).then_some(text)
}

impl PartFile {
    pub(super) fn new(part: Part, vary: Vec<Variation>, origin: Origin, records: Vec<Record>) -> Self {
        Self { program: versions::program(), part, vary, origin, records }
    }

    pub(super) fn made(&self) -> Result<OutputFile, Failure> {
        let text = toml::to_string(self).map_err(|error| Failure::incomplete(error.to_string()))?;
        let content = sealed(&text).into_bytes();
        if content.len() as u64 > folder::MOST_BYTES {
            let most = folder::MOST_BYTES;
            return Err(Failure::incomplete(format!(
                "the part is longer than {most} bytes, which `merge` does not read: compute the family in more parts"
            )));
        }
        Ok(OutputFile { path: path(self.part), content })
    }

    /// Reads a part, which anybody may have written, as far as that can be told without the others.
    fn read(path: &Path) -> Result<Self, String> {
        let content = folder::read(path).map_err(|reason| format!("cannot be read: {reason}"))?;
        let content =
            String::from_utf8(content).map_err(|_| format!("{NO_PART}: it is not a text in UTF-8"))?;
        if !content.starts_with(SEAL) {
            return Err(format!("{NO_PART}: it does not begin with `{SEAL}`"));
        }
        let text = unsealed(&content).ok_or(
            "is damaged: it has not the digest that stands in its first line; copy it again, or compute it again",
        )?;
        let found: Self =
            toml::from_str(text).map_err(|reason| format!("{NO_PART}: {}", reason.message()))?;
        let (program, own) = (&found.program, versions::program());
        if *program != own {
            let program = shortened(program, 100);
            return Err(format!(
                "was made by {program}, and this is {own}: compute all parts with one program"
            ));
        }
        Ok(found)
    }

    /// The family that it says to be of.
    fn family(&self) -> Result<(Description, Plan), Failure> {
        let description = self.origin.description(&[], &Stop::default())?;
        let plan = plan(&self.vary, &description)?;
        Ok((description, plan))
    }

    /// Whether what it holds fits the family.
    fn check(&self, description: &Description, plan: &Plan) -> Result<(), Failure> {
        let which = self.part.of(plan)?;
        let loops = description.loops();
        let fits = |(record, index): (&Record, usize)| record.fits(plan, index, loops);
        if self.records.len() != which.len() || !self.records.iter().zip(which).all(fits) {
            let part = self.part;
            return Err(Failure::input(format!(
                "its records are not those of part {part}: compute it again with --part {part}"
            )));
        }
        Ok(())
    }
}

/// What is said of a file of another kind.
const NO_PART: &str = "is no part of a family as `unfold --part` writes them";

/// A family whose parts are all there.
pub(super) struct Joined {
    pub(super) origin: Origin,
    pub(super) description: Description,
    pub(super) plan: Plan,
    pub(super) records: Vec<Record>,
}

/// All parts as one.
///
/// # Errors
/// One cannot be read, holds what does not fit, is of another family, is there twice, or is
/// missing.
pub(super) fn joined(paths: &[PathBuf]) -> Result<Joined, Failure> {
    let mut found: Vec<(&PathBuf, PartFile)> = Vec::new();
    let mut family = None;
    for path in paths {
        let refuse = |reason: String| Failure::input(format!("{}: {reason}", path.display()));
        let part = PartFile::read(path).map_err(refuse)?;
        let Part { part: number, parts: count } = part.part;
        if let Some((first, other)) = found.first()
            && (&part.origin, &part.vary, count) != (&other.origin, &other.vary, other.part.parts)
        {
            return Err(refuse(format!(
                "is a part of another family than {}: oscillator, settings, constants and number of parts must be the same",
                first.display()
            )));
        }
        if let Some((other, _)) = found.iter().find(|(_, other)| other.part == part.part) {
            return Err(refuse(format!(
                "is part {number} of {count}, as {} is: name each part once",
                other.display()
            )));
        }
        let known = family.take().map_or_else(|| part.family(), Ok);
        let checked = known.and_then(|(description, plan)| {
            part.check(&description, &plan)?;
            Ok((description, plan))
        });
        family = Some(checked.map_err(|failure| refuse(failure.reason))?);
        found.push((path, part));
    }
    let Some((description, plan)) = family else { return Err(Failure::input("no part is named")) };
    found.sort_by_key(|(_, part)| part.part.part);
    let count = found[0].1.part.parts;
    if found.len() < count {
        let is_there = |number: &usize| found.iter().any(|(_, part)| part.part.part == *number);
        let missing = (1..=count).filter(|number| !is_there(number)).take(10);
        let shown = missing.map(|number| number.to_string()).collect::<Vec<_>>().join(", ");
        let missing = count - found.len();
        let more = if missing > 10 { ", ..." } else { "" };
        return Err(Failure::input(format!(
            "{missing} of {count} parts are missing: {shown}{more}: compute them with --part K/{count}, and name them too"
        )));
    }
    let origin = found[0].1.origin.clone();
    let records = found.into_iter().flat_map(|(_, part)| part.records).collect();
    Ok(Joined { origin, description, plan, records })
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
                // What is no UTF-8 any more is refused before.
                if let Ok(changed) = String::from_utf8(bytes) {
                    assert_eq!(unsealed(&changed), None, "bit {bit} of byte {place}");
                }
            }
        }
        assert_eq!(unsealed(&(whole + "\n")), None);
    }
}
