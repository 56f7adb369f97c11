//! Parts of a family, as files that are merged.

use std::fs;
use std::path::{Path, PathBuf};

use grazing_description::Description;
use grazing_model::smooth::Stop;
use grazing_reproduction::family::{Plan, Record};
use grazing_source::{Setting, Text};
use serde::{Deserialize, Serialize};

use crate::arguments;
use crate::failure::Failure;
use crate::folder::{self, OutputFile};
use crate::oscillator;
use crate::variation::Part;

/// The folder of the results, with a folder in it for each file.
const RESULTS: &str = "families";
/// The folder of parts, in that of the family.
const PARTS: &str = "parts";

/// Where an oscillator comes from: all that is needed to read it again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Origin {
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
    pub(super) fn new(file: &Path, arguments: &arguments::Unfold) -> Result<Self, Failure> {
        let text = grazing_source::read_file(file).map_err(grazing_description::DescriptionError::from)?;
        let set = oscillator::settings(&arguments.set).iter().map(ToString::to_string).collect();
        Ok(Self { file: file.display().to_string(), text, set, loops: arguments.loops.clone() })
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
pub(super) struct PartFile {
    /// The version of the program that made it.
    version: String,
    part: usize,
    parts: usize,
    pub(super) origin: Origin,
    pub(super) plan: Plan,
    #[serde(default)]
    pub(super) records: Vec<Record>,
}

/// Where a part lies in the folder of the family.
pub(super) fn path(Part { part, parts }: Part) -> PathBuf {
    let digits = parts.to_string().len();
    Path::new(PARTS).join(format!("{part:0digits$}-of-{parts}.toml"))
}

impl PartFile {
    pub(super) fn new(Part { part, parts }: Part, origin: Origin, plan: Plan, records: Vec<Record>) -> Self {
        let version = env!("CARGO_PKG_VERSION").to_owned();
        Self { version, part, parts, origin, plan, records }
    }

    pub(super) fn made(&self) -> Result<OutputFile, Failure> {
        let path = path(Part { part: self.part, parts: self.parts });
        let text = toml::to_string(self).map_err(|error| Failure::incomplete(error.to_string()))?;
        Ok(OutputFile { path, content: text.into_bytes() })
    }

    fn read(path: &Path) -> Result<Self, Failure> {
        let refuse = |reason: String| Failure::input(format!("{}: {reason}", path.display()));
        let text = fs::read_to_string(path).map_err(|reason| refuse(format!("cannot be read: {reason}")))?;
        let found: Self = toml::from_str(&text).map_err(|reason| {
            let reason = reason.message();
            refuse(format!("is no part of a family as `unfold --part` writes them: {reason}"))
        })?;
        let Self { version, part, parts, .. } = &found;
        let own = env!("CARGO_PKG_VERSION");
        if version != own {
            return Err(refuse(format!(
                "was made by version {version} of the program, and this is {own}: compute all parts with one version"
            )));
        }
        let is_one = (1..=*parts).contains(part);
        let expected = if is_one { found.plan.part(*part, *parts) } else { 0..0 };
        if !found.records.iter().map(|record| record.index).eq(expected) {
            return Err(refuse(format!(
                "its members are not those of part {part} of {parts}: compute it again with --part {part}/{parts}"
            )));
        }
        Ok(found)
    }
}

/// All parts as one.
///
/// # Errors
/// One cannot be read, is of another family, is there twice, or is missing.
pub(super) fn joined(paths: &[PathBuf]) -> Result<PartFile, Failure> {
    let mut found: Vec<(&PathBuf, PartFile)> = Vec::new();
    for path in paths {
        let part = PartFile::read(path)?;
        if let Some((first, other)) = found.first()
            && (&part.origin, &part.plan, part.parts) != (&other.origin, &other.plan, other.parts)
        {
            return Err(Failure::input(format!(
                "{}: is a part of another family than {}: oscillator, settings, constants and number of parts must be the same",
                path.display(),
                first.display()
            )));
        }
        if let Some((other, _)) = found.iter().find(|(_, other)| other.part == part.part) {
            return Err(Failure::input(format!(
                "{}: is part {} of {}, as {} is: name each part once",
                path.display(),
                part.part,
                part.parts,
                other.display()
            )));
        }
        found.push((path, part));
    }
    found.sort_by_key(|(_, part)| part.part);
    let count = found.first().map_or(0, |(_, part)| part.parts);
    let missing: Vec<String> = (1..=count)
        .filter(|number| found.iter().all(|(_, part)| part.part != *number))
        .map(|number| number.to_string())
        .collect();
    if !missing.is_empty() {
        let shown = missing[..missing.len().min(10)].join(", ");
        let more = if missing.len() > 10 { ", ..." } else { "" };
        return Err(Failure::input(format!(
            "{} of {count} parts are missing: {shown}{more}: compute them with --part K/{count}, and name them too",
            missing.len()
        )));
    }
    let joined = found.into_iter().map(|(_, part)| part).reduce(|mut joined, mut next| {
        joined.records.append(&mut next.records);
        joined
    });
    joined.ok_or_else(|| Failure::input("no part is named"))
}
