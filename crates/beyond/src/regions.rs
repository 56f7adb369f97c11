//! Beyond the paper: regions of the trapesium in which p-loop MPSs are admissible at generic grazing.

mod ink;

use grazing_input::kind::counts;
use grazing_reproduction::parameters::MOST_LOOPS;
use grazing_reproduction::prelude::*;
use grazing_results::{rows, tables};
use grazing_theorems::admissibility_region::{AdmissibilityRegion, rotation};
use rayon::prelude::*;

/// The number of levels of δ in a region, and in one in which eigenvalues become real and x varies like a
/// square root.
const LEVELS: [u32; 2] = [56, 160];
/// The δ at which regions end: so close to 1 that they are at their limits.
const TOP: f64 = 1.0 - 1e-9;

keys! {
    /// The regions in which p-loop MPSs are admissible.
    pub struct BeyondRegions {
        /// The numbers of loops p.
        loops: Vec<u32> = counts(2..=MOST_LOOPS),
            "the numbers of loops must be a list of different whole numbers from {} to {}, as [2, 3, 4]";
    }
}

rows! {
    /// A region at one determinant.
    RegionLevel {
        loops: u32 = LOOPS,
        turns: u32 = TURNS,
        visit: u32 = TOUCHING_VISIT,
        delta: f64 = DELTA,
        low: f64 = TAU_LOW,
        high: f64 = TAU_HIGH,
        left: f64 = ROTATION_LOW,
        right: f64 = ROTATION_HIGH,
    }
}

tables! {
    /// The regions in which p-loop MPSs are admissible.
    Regions {
        /// The levels are ordered by p and m, and for each region from its lowest determinant to 1.
        levels: RegionLevel = "beyond_regions", "a region at one determinant" as Areas,
    }
}

impl FileSection for BeyondRegions {
    const NAME: &'static str = "beyond_regions";
    const REQUIREMENT: &'static str = "the table [beyond_regions] says whose admissibility is shown";
}

impl StudyFigure for BeyondRegions {
    const LABEL: &'static str = "fig:regions";
    const TITLE: Title<&'static str> = Title::beyond("where p-loop solutions are admissible at grazing");
    const TABLES: &'static [TablePlan] = Regions::TABLES;
    const REMEDY: &'static str = "beyond_regions.loops";
    type Shown = Regions;

    fn compute(&self, _: &Study) -> Result<Regions, StudyError> {
        let all: Vec<_> = self.loops.iter().flat_map(|&p| AdmissibilityRegion::all(p)).collect();
        Ok(Regions { levels: all.par_iter().map(levels).collect::<Vec<_>>().concat() })
    }

    fn draw(shown: &Regions, width: SheetWidth) -> Result<Sheet, DrawingError> {
        ink::draw(shown, width)
    }
}

/// The levels of a region. They are closer to each other near the lowest determinant, where the region is
/// a parabola, and for m = 1 also near δ = 1.
fn levels(region: &AdmissibilityRegion) -> Vec<RegionLevel> {
    let (lowest, factor) = (region.lowest_determinant(), region.factor());
    let [left, _] = region.rotations();
    let levels = LEVELS[usize::from(left == 0.5)];
    let row = |k: u32| {
        let share = f64::from(k) / f64::from(levels);
        let above = share * share * if left == 0.0 { 3.0 - 2.0 * share } else { 1.0 };
        let delta = (lowest + (1.0 - lowest) * above).min(TOP);
        let [low, high] = region.traces(delta)?.map(|(tau, _)| tau);
        // Where eigenvalues are real, x is taken at the double eigenvalue.
        let of = |tau: f64| {
            let double = 2.0 * delta.sqrt();
            rotation(tau.clamp(-double, double), delta, factor)
        };
        let [a, b] = [of(low), of(high)];
        let [left, right] = [a.min(b), a.max(b)];
        let (loops, turns) = (region.loops, region.turns);
        let visit = region.touching_visit();
        Some(RegionLevel { loops, turns, visit, delta, low, high, left, right })
    };
    (0..=levels).filter_map(row).collect()
}
