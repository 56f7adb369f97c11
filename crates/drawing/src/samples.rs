//! Rows for the tests of figures: made-up ones with the crowding of the real ones, and scenes as they are written.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::branches::{
    AttractorPoint, BranchBifurcation, BranchPoint, PortraitKind, PortraitPoint,
};
use grazing_results::space::{CurveKind, Mark, MarkKind, SurfaceKind, Vertex};

use crate::scene::SpaceFigure;

/// Numbers from 0 to 1 at equal distances.
pub(crate) fn shares(count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| f64::from(i) / f64::from(count))
}

pub(crate) fn fig02_branches() -> Vec<BranchPoint> {
    let row = |loops, branch, primary, x, stable| BranchPoint {
        loops,
        primary,
        x,
        visit: 1,
        impact_velocity: 0.1,
        impact_phase: 0.0,
        stable,
        admissible: true,
        branch,
    };
    let mut rows: Vec<_> = shares(20).map(|s| row(0, 0, 0.5 + 0.5 * s, -0.5 * (1.0 - s), true)).collect();
    for (branch, (p, slope)) in (1..).zip([(1, 0.1), (2, 0.4), (2, -0.5), (3, 0.9)]) {
        rows.extend(shares(60).map(|s| row(p, branch, 1.0 + 0.5 * s, slope * s, p > 1 && s > 0.4)));
    }
    rows
}

pub(crate) fn fig02_bifurcations() -> Vec<BranchBifurcation> {
    [
        (Bifurcation::NonImpactingGrazing, 0, 1.0, 0.0),
        (Bifurcation::PeriodDoubling, 2, 1.2, 0.16),
        (Bifurcation::PeriodDoubling, 2, 1.2, -0.2),
        (Bifurcation::SaddleNode, 3, 1.2, 0.36),
        (Bifurcation::Grazing, 3, 1.5, 0.9),
    ]
    .map(|(kind, loops, primary, x)| BranchBifurcation { kind, loops, primary, impact_velocity: 0.1, x })
    .to_vec()
}

/// So many points scattered over the diagram, without a generator of random numbers.
pub(crate) fn fig02_attractor(count: u32) -> Vec<AttractorPoint> {
    // Weyl sequences: multiples of two irrational numbers, modulo one, fill the square evenly.
    let fill = |i: u32, step: f64| (f64::from(i) * step).fract();
    let point = |i| AttractorPoint {
        primary: 1.2 + 0.3 * fill(i, 0.618_033_988_749_894_9),
        x: 0.6 * fill(i, 0.414_213_562_373_095) - 0.5,
    };
    (0..count).map(point).collect()
}

pub(crate) fn fig02_portraits() -> Vec<PortraitPoint> {
    let mut rows = Vec::new();
    for (portrait, loops, primary, kind) in [
        (1, 0, 0.8, PortraitKind::Periodic),
        (2, 2, 1.3, PortraitKind::Periodic),
        (3, 0, 1.31, PortraitKind::Attractor),
        (4, 3, 1.4, PortraitKind::Periodic),
    ] {
        let reach = if loops == 0 { 0.9 } else { 1.0 };
        // A polygon of orbit from recoil to impact, the jump left to the figure.
        let orbit = [(0.0, -0.5), (-1.0, -1.0), (-2.0, 0.0), (-1.0, 1.0), (0.0, 0.6), (f64::NAN, f64::NAN)];
        rows.extend(orbit.map(|(x, y)| {
            let (time, x) = (f64::NAN, reach * x);
            PortraitPoint { portrait, loops, primary, kind, time, x, y }
        }));
    }
    rows
}

/// The cells of a table as `figures/data/` has it, for figures whose labels have to find room in one particular scene: the word of its kind, and numbers.
fn written(name: &str) -> Vec<(String, Vec<f64>)> {
    let path = format!("{}/../../figures/data/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let row = |line: &str| {
        let (kind, numbers) = line.split_once(',').expect("the kind comes first");
        let numbers = numbers.split(',').map(|cell| cell.parse().expect("all others are numbers"));
        (kind.to_owned(), numbers.collect())
    };
    text.lines().skip(1).map(row).collect()
}

fn vertices<K: Copy>(name: &str, kinds: &[K], word: fn(K) -> &'static str) -> Vec<Vertex<K>> {
    let vertex = |(kind, numbers): (String, Vec<f64>)| {
        let kind = *kinds.iter().find(|known| word(**known) == kind).expect("the kind is known");
        let [number, piece, layer] = [0, 1, 2].map(|place| numbers[place] as u32);
        let [state, place] = [3, 6].map(|first| std::array::from_fn(|k| numbers[first + k]));
        Vertex { kind, number, piece, layer, state, place }
    };
    written(name).into_iter().map(vertex).collect()
}

/// The rows of a figure in phase space, as written.
pub(crate) struct Scene {
    pub(crate) curves: Vec<Vertex<CurveKind>>,
    points: Vec<Mark>,
    surfaces: Vec<Vertex<SurfaceKind>>,
}

impl Scene {
    pub(crate) fn of(figure: &str) -> Self {
        let mark = |(kind, numbers): (String, Vec<f64>)| {
            let kind = *MarkKind::ALL.iter().find(|known| known.name() == kind).expect("the kind is known");
            let [x, y, z, across, up, depth] = std::array::from_fn(|place| numbers[2 + place]);
            Mark { kind, number: numbers[0] as u32, layer: numbers[1] as u32, x, y, z, across, up, depth }
        };
        Scene {
            curves: vertices(&format!("{figure}_curves"), CurveKind::ALL, CurveKind::name),
            points: written(&format!("{figure}_points")).into_iter().map(mark).collect(),
            surfaces: vertices(&format!("{figure}_surfaces"), SurfaceKind::ALL, SurfaceKind::name),
        }
    }

    pub(crate) fn figure(&self) -> SpaceFigure<'_> {
        SpaceFigure { curves: &self.curves, points: &self.points, surfaces: &self.surfaces }
    }
}
