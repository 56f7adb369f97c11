//! Families: an oscillator from a text file for several values of its constants.
//!
//! Every member is analysed by itself as far as its codimension-two points, and its resonances are
//! followed towards its neighbours in the constant that varies first ([`arcs`](fn@arcs)). The
//! result for one member is a [`Record`], which may be computed on any machine; a [`Family`] is assembled
//! from all records, with the same result wherever they were computed.

mod arcs;
mod assembly;
mod record;

use crate::UnfoldError;
use crate::parallel;
use crate::progress::Progress;
use grazing_input::Description;
use grazing_model::smooth::Stop;
use grazing_results::family::Family;
use grazing_results::{Names, Tables};

use crate::described::{Axes, own_header};
pub use arcs::{Arc, ArcEnd, ArcPoint, Between, arcs};
pub use assembly::assemble;
pub use record::Record;

/// A constant that varies, with its values.
#[derive(Clone, Debug, PartialEq)]
pub struct Varied {
    /// The name of the constant in the file.
    pub name: String,
    /// The values of the constant in the order of the members: at least two, increasing or decreasing.
    pub values: Vec<f64>,
}

/// The members of a family: all combinations of values, the first constant varying fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct FamilyPlan {
    /// One to three constants.
    pub varied: Vec<Varied>,
}

impl FamilyPlan {
    /// The number of members.
    pub fn count(&self) -> usize {
        self.varied.iter().map(|varied| varied.values.len()).product()
    }

    /// The values of the constants of a member.
    pub fn values(&self, mut index: usize) -> Vec<f64> {
        let value = |Varied { values, .. }: &Varied| {
            let place = index % values.len();
            index /= values.len();
            values[place]
        };
        self.varied.iter().map(value).collect()
    }

    /// The number of consecutive members that differ only in the first constant.
    pub(crate) fn line(&self) -> usize {
        self.varied[0].values.len()
    }
}

/// A function that explains in words why a member has nothing to unfold.
pub type Tell<'a> = &'a (dyn Fn(&Description, &UnfoldError) -> String + Sync);

/// The name of the stage in which members are computed.
const MEMBERS: &str = "members of the family";

/// The records of some members, each given with its number; none for members that were not finished when
/// the computation was cancelled.
pub fn records(
    plan: &FamilyPlan,
    members: &[(usize, Description)],
    tell: Tell<'_>,
    stop: &Stop,
    progress: &dyn Progress,
) -> Vec<Option<Record>> {
    progress.begin(MEMBERS, members.len() as u64);
    let compute = |(index, description): &(usize, Description)| {
        // The stages within a member are not reported.
        let record = Record::compute(plan, *index, description, tell, stop);
        progress.step(MEMBERS);
        record
    };
    let records = parallel::map(members, compute);
    progress.end(MEMBERS);
    stop.withdraw();
    records
}

/// The names in the headers of a family's tables.
pub fn names(plan: &FamilyPlan, description: &Description) -> Names {
    let own = |varied: &Varied| own_header(&varied.name, Family::TABLES.iter());
    let varied: Vec<String> = plan.varied.iter().map(own).collect();
    Axes::of(description).names.with_varied(&varied)
}
