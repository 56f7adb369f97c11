//! Beyond the paper: the atlas of the limit map of linear oscillators, over σ and ε, for all p and n at once.

mod ink;

use grazing_continuation::cascade::Cascade;
use grazing_input::kind::count;
use grazing_reproduction::figures::fig07::Figure7;
use grazing_reproduction::prelude::*;
use grazing_results::{row, rows, tables};
use grazing_theorems::LimitMap;
use rayon::prelude::*;

keys! {
    /// The atlas.
    pub struct BeyondAtlas {
        /// Values of ε at which boundaries are located.
        rows: u32 = count(2..=1000), "the number of rows must be a whole number from {} to {}";
    }
}

/// The number of bisections that locate each boundary.
const HALVINGS: u32 = 17;
/// The number of lattice steps in σ from 0 to 1, and in ε.
const LATTICE: i32 = 40;
const LATTICE_ROWS: u32 = 10;
/// The numbers of impacts for which boundaries are computed.
const IMPACTS: [u32; 4] = [2, 4, 8, 16];

rows! {
    /// A point of a boundary.
    AtlasBoundary {
        loops: u32 = ATLAS_LOOPS,
        impacts: u32 = IMPACTS_BEGUN,
        epsilon: f64 = EPSILON,
        sigma: f64 = SIGMA,
    }

    /// A resonance of Figure 7.
    AtlasResonance {
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        sigma: f64 = SIGMA,
        epsilon: f64 = EPSILON,
    }
}

/// The limit map at a place of the lattice.
#[derive(Clone, Debug)]
pub struct AtlasNode {
    loops: u32,
    epsilon: f64,
    sigma: f64,
    map: LimitMap,
    cascade: Cascade,
}

row! { AtlasNode, |this| {
    let map = &this.map;
    let [_, first] = map.period_doubling();
} [
    ATLAS_LOOPS = this.loops,
    EPSILON = this.epsilon,
    SIGMA = this.sigma,
    M_SN = map.saddle_node()[1],
    M_PD = first,
    M_2GZ = map.doubled_grazing(),
    RATIO_SN = (this.in_units(map.saddle_node()[1])),
    RATIO_2GZ = this.grazing(),
    PD_CRITICALITY = map.criticality(),
    PERIOD_4 = this.cascade.fraction(1),
    PERIOD_8 = this.cascade.fraction(2),
    PERIOD_16 = this.cascade.fraction(3),
    CASCADE_STOP = this.cascade.stop.name(),
] }

tables! {
    /// The atlas of the limit map over all (σ, ε).
    Atlas {
        /// Consecutive points with equal p and number of impacts form one curve.
        boundaries: AtlasBoundary = "beyond_atlas", "a point of a boundary",
        places: AtlasResonance = "beyond_atlas_resonances", "a resonance of Figure 7",
        lattice: AtlasNode = "beyond_atlas_lattice", "a node of a lattice in (ε, σ), extended by the ε of Figure 7",
        ;
        /// The ε of Figure 7.
        epsilon: f64,
    }
}

/// The σ below which orbits with 2^`count` impacts begin stable; −1 if there are none.
fn boundary(loops: u32, epsilon: f64, count: usize) -> Result<f64, StudyError> {
    let [mut low, mut high] = [-1.0, 0.0];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        let map = LimitMap::of_linear_oscillator(loops, middle, epsilon)?;
        if Cascade::of(&map, count).onsets.len() == count { low = middle } else { high = middle }
    }
    Ok(low)
}

impl FileSection for BeyondAtlas {
    const NAME: &'static str = "beyond_atlas";
    const REQUIREMENT: &'static str = "the table [beyond_atlas] says how closely boundaries are drawn";
}

impl StudyFigure for BeyondAtlas {
    const LABEL: &'static str = "fig:atlas";
    const TITLE: Title<&'static str> = Title::beyond("atlas of the limit map");
    const TABLES: &'static [TablePlan] = Atlas::TABLES;
    const REMEDY: &'static str = Figure7::REMEDY;
    type Shown = Atlas;

    fn compute(&self, study: &Study) -> Result<Atlas, StudyError> {
        let epsilon = study.parameters.oscillator()?.coefficient_of_restitution();
        let places = study.diagram()?.unfolding().map(|(found, _)| {
            let [_, _, sigma] = found.located.resonant_point().limit_map().numbers();
            AtlasResonance { loops: found.loops, n: found.n, sigma, epsilon }
        });
        let mut asked = Vec::new();
        for loops in [1, 2] {
            for (count, impacts) in (1..).zip(IMPACTS) {
                // The map does not exist at ε = 0: the first row is so close to it that there is no
                // visible difference.
                let rows = (0..=self.rows).map(|row| f64::from(row).max(1e-3) / f64::from(self.rows));
                asked.extend(rows.map(|epsilon| (loops, count, impacts, epsilon)));
            }
        }
        let found = asked.into_par_iter().map(|(loops, count, impacts, epsilon)| {
            Ok(AtlasBoundary { loops, impacts, epsilon, sigma: boundary(loops, epsilon, count)? })
        });
        let boundaries = found.collect::<Result<_, StudyError>>()?;
        let mut nodes = Vec::new();
        let of_lattice = (1..=LATTICE_ROWS).map(|row| f64::from(row) / f64::from(LATTICE_ROWS));
        for epsilon in of_lattice.filter(|&other| other != epsilon).chain([epsilon]) {
            for place in (1 - LATTICE..LATTICE).filter(|&place| place != 0) {
                let sigma = f64::from(place) / f64::from(LATTICE);
                nodes.extend((1..=if place < 0 { 2 } else { 1 }).map(|loops| (loops, epsilon, sigma)));
            }
        }
        nodes.sort_by_key(|(loops, ..)| *loops);
        let node = |(loops, epsilon, sigma)| {
            let map = LimitMap::of_linear_oscillator(loops, sigma, epsilon)?;
            Ok(AtlasNode { loops, epsilon, sigma, map, cascade: Cascade::of(&map, IMPACTS.len()) })
        };
        let lattice = nodes.into_par_iter().map(node).collect::<Result<_, StudyError>>()?;
        Ok(Atlas { boundaries, places: places.collect(), lattice, epsilon })
    }

    fn draw(shown: &Atlas, width: SheetWidth) -> Result<Sheet, DrawingError> {
        shown.draw(width)
    }
}

impl AtlasNode {
    /// M_2GZ/M_PD at the node.
    fn grazing(&self) -> f64 {
        self.in_units(self.map.doubled_grazing())
    }

    /// M in units of M_PD.
    fn in_units(&self, parameter: f64) -> f64 {
        parameter / self.map.period_doubling()[1]
    }
}
