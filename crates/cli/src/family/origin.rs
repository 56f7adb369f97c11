//! Families as work that can be divided.

use std::path::{Path, PathBuf};

use grazing_input::{Description, Setting, Text};
use grazing_model::smooth::Stop;
use grazing_unfold::family::{FamilyPlan, Record};
use serde::{Deserialize, Serialize};

use super::plan;
use crate::arguments;
use crate::failure::Failure;
use crate::part::Divided;
use crate::variation::Variation;
use crate::{folder, oscillator};

/// The folder of the results, with a folder in it for each file.
const RESULTS: &str = "families";
/// The origin of an oscillator: everything that is needed to read it again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct FamilyOrigin {
    /// The file, as it was named.
    pub(super) file: String,
    text: String,
    /// The settings over the file, with full keys.
    set: Vec<String>,
    /// Numbers of loops that replace those of the file.
    #[serde(skip_serializing_if = "Option::is_none")]
    loops: Option<Vec<u32>>,
}

impl FamilyOrigin {
    /// An oscillator from a text, with settings over it.
    pub(crate) fn new(file: String, text: String, set: Vec<String>, loops: Option<Vec<u32>>) -> Self {
        Self { file, text, set, loops }
    }

    pub(super) fn of_file(file: &Path, arguments: &arguments::UnfoldArguments) -> Result<Self, Failure> {
        let text = oscillator::read_text(file)?;
        let set = oscillator::settings(&arguments.changes.set).iter().map(ToString::to_string).collect();
        Ok(Self::new(file.display().to_string(), text, set, arguments.changes.loops.clone()))
    }

    /// The oscillator with other values of constants, checked, unless `stop` cancels the reading.
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

/// A family as work that can be divided: an oscillator, and the constants that vary.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FamilyWork {
    pub(super) vary: Vec<Variation>,
    pub(super) origin: FamilyOrigin,
}

impl Divided for FamilyWork {
    const IS: &'static str = "family";
    const ITEMS: &'static str = "members";
    const SAME: &'static str = "oscillator, settings, constants";
    const COMMAND: &'static str = "unfold";
    type Task = (Description, FamilyPlan);
    type Record = Record;

    fn task(&self) -> Result<Self::Task, Failure> {
        let description = self.origin.description(&[], &Stop::default())?;
        let plan = plan(&self.vary, &description)?;
        Ok((description, plan))
    }

    fn count((_, plan): &Self::Task) -> usize {
        plan.count()
    }

    fn fits((description, plan): &Self::Task, record: &Record, index: usize) -> bool {
        record.fits(plan, index, description.loops())
    }
}
