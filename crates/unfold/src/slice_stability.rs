//! The good solutions and doubts that slices show in the regions that they cross.

use crate::region::Doubt;
use crate::slices::{MOST_BRANCHES, Slice};

/// The good solutions and doubts on a slice of constant η.
#[derive(Clone, Debug)]
pub(crate) struct SliceStability {
    pub(crate) secondary: f64,
    /// Intervals of μ with a stable, admissible solution.
    pub(crate) good: Vec<[f64; 2]>,
    pub(crate) doubts: Vec<(f64, Doubt)>,
    pub(crate) everywhere: Option<Doubt>,
}

impl SliceStability {
    /// Nothing yet of a slice, with a doubt if it has more branches than can be distinguished.
    pub(crate) fn of(slice: &Slice) -> Self {
        let everywhere = (slice.branches.len() >= MOST_BRANCHES).then_some(Doubt::ManyBranches);
        Self { secondary: slice.secondary, good: Vec::new(), doubts: Vec::new(), everywhere }
    }

    /// Adds an interval of μ, its ends in any order, in which there are good solutions.
    pub(crate) fn see(&mut self, [a, b]: [f64; 2]) {
        let mut joined = [a.min(b), a.max(b)];
        self.good.retain(|[from, to]| {
            let apart = *to < joined[0] || joined[1] < *from;
            if !apart {
                joined = [joined[0].min(*from), joined[1].max(*to)];
            }
            apart
        });
        self.good.push(joined);
    }

    /// Adds a doubt, with the μ near which it was met.
    pub(crate) fn doubt(&mut self, primary: f64, doubt: Doubt) {
        self.doubts.push((primary, doubt));
    }

    /// The fraction of an interval in which there are good solutions.
    pub(crate) fn share(&self, [from, to]: [f64; 2]) -> f64 {
        let common = self.good.iter().map(|[low, high]| (high.min(to) - low.max(from)).max(0.0));
        common.sum::<f64>() / (to - from)
    }
}
