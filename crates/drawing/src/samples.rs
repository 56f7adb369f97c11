//! Made-up rows with the crowding of the real ones, for the tests of the figures.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_results::branches::{
    AttractorPoint, BranchBifurcation, BranchPoint, PortraitKind, PortraitPoint,
};
use grazing_results::plane::{CurvePoint, MagnifiedPoint, RegionKind, RegionVertex, Source, SpecialPoint};
use grazing_results::space::{CurveKind, Mark, MarkKind, SurfaceKind, Vertex};

use crate::captions::Heading;
use crate::clip::Window;
use crate::diagram::Section;
use crate::magnifications::MagnifiedPanel;
use crate::magnified::Magnified;

pub(crate) const WINDOW: Window = Window { x: [0.0, 1.2], y: [0.3, 1.0] };

pub(crate) fn section() -> Section {
    Section { across: [0.2, 0.4], up: [0.85, 0.85], label: "Fig. 2".to_owned() }
}

pub(crate) fn magnified() -> [Magnified; 3] {
    [(1, 0.55), (2, 0.3), (3, 0.18)].map(|(panel, a)| {
        let omega = graz(a);
        Magnified { panel, window: Window { x: [a - 0.05, a + 0.06], y: [omega - 0.02, omega + 0.02] } }
    })
}

/// The frequency at which the made-up grazing curve has the amplitude.
pub(crate) fn graz(amplitude: f64) -> f64 {
    1.0 - 0.6 * amplitude * amplitude - 0.2 * amplitude
}

fn shares(count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| f64::from(i) / f64::from(count))
}

/// A made-up resonance: p, n, the amplitude at which it lies on the grazing curve, and the size of its loop of curves.
pub(crate) type Resonance = (u32, u32, f64, f64);

const RESONANCES: [Resonance; 3] = [(1, 1, 0.55, 0.5), (2, 1, 0.3, 0.18), (3, 1, 0.18, 0.06)];

/// Kind, p, n, arc and points of a made-up curve.
pub(crate) type SampleCurve = (Bifurcation, u32, u32, u32, Vec<(f64, f64)>);

/// The grazing curve and at each resonance a loop of SN, GZ, PD.
pub(crate) fn curves(resonances: &[Resonance]) -> Vec<SampleCurve> {
    let mut curves = vec![(
        Bifurcation::NonImpactingGrazing,
        0,
        0,
        0,
        shares(200).map(|s| (1.3 * s, graz(1.3 * s))).collect(),
    )];
    for (&(p, n, amplitude, size), number) in resonances.iter().zip(1..) {
        let omega = graz(amplitude);
        let arc = |from: (f64, f64), to: (f64, f64), bulge: f64| {
            let point = |s: f64| {
                let bend = bulge * s * (1.0 - s) * size;
                (from.0 + s * (to.0 - from.0) + bend, from.1 + s * (to.1 - from.1) - bend)
            };
            shares(100).map(point).collect::<Vec<_>>()
        };
        let (low, high) =
            ((amplitude - 0.4 * size, omega - 0.3 * size), (amplitude + 0.5 * size, omega + 0.6 * size));
        curves.push((Bifurcation::SaddleNode, p, n, 3 * number, arc((amplitude, omega), low, 0.2)));
        curves.push((Bifurcation::PeriodDoubling, p, n, 3 * number + 1, arc((amplitude, omega), high, -1.0)));
        curves.push((Bifurcation::Grazing, p, n, 3 * number + 2, arc(low, high, 1.0)));
    }
    curves
}

/// Rows of curves.
pub(crate) fn curve_rows(curves: Vec<SampleCurve>) -> Vec<CurvePoint> {
    let rows = |(kind, loops, n, arc, points): SampleCurve| {
        points.into_iter().map(move |(primary, secondary)| CurvePoint {
            kind,
            loops,
            n,
            secondary,
            primary,
            impact_velocity: 0.1,
            impact_phase: 0.0,
            trace: 0.0,
            determinant: 0.5,
            max_interior_x: -0.1,
            stable: true,
            admissible: true,
            arc,
        })
    };
    curves.into_iter().flat_map(rows).collect()
}

/// The codimension-two points at the ends of such curves.
pub(crate) fn point_rows(curves: &[SampleCurve]) -> Vec<SpecialPoint> {
    let ends = curves.iter().filter_map(|(kind, loops, n, _, points)| {
        let (kind, (primary, secondary)) = match kind {
            Bifurcation::NonImpactingGrazing => return None,
            Bifurcation::SaddleNode => (CodimensionTwo::Resonance, points[0]),
            Bifurcation::PeriodDoubling => (CodimensionTwo::PeriodDoublingGrazing, points[100]),
            Bifurcation::Grazing => (CodimensionTwo::SaddleNodeGrazing, points[0]),
        };
        Some(SpecialPoint { kind, loops: *loops, n: *n, secondary, primary })
    });
    ends.collect()
}

/// The regions that such curves bound; `corners` of the region without impacts lie beside its part of the grazing curve.
pub(crate) fn region_rows(curves: &[SampleCurve], corners: [(f64, f64); 2]) -> Vec<RegionVertex> {
    let vertex = |region, kind, loops, (primary, secondary)| {
        let (n, ring, reason) = (0, 0, String::new());
        RegionVertex { region, kind, loops, n, secondary, primary, ring, reason }
    };
    let below = curves[0].4.iter().copied().chain(corners);
    let mut rows: Vec<_> = below.map(|spot| vertex(0, RegionKind::NonImpacting, 0, spot)).collect();
    for (own, number) in curves[1..].chunks(3).zip(1..) {
        let [sn, pd, gz] = own else { panic!("each resonance has three curves") };
        let outline = sn.4.iter().chain(&gz.4).chain(pd.4.iter().rev());
        rows.extend(outline.map(|&spot| vertex(number, RegionKind::Mps, sn.1, spot)));
    }
    rows
}

/// The same curves once for each resonance, in its panel, with straight lines for approximations.
pub(crate) fn magnified_rows(curves: &[SampleCurve]) -> Vec<MagnifiedPoint> {
    let mut rows = Vec::new();
    for (own, panel) in curves[1..].chunks(3).zip(1..) {
        let (loops, n) = (own[0].1, own[0].2);
        for (kind, _, _, arc, points) in curves[..1].iter().chain(own) {
            let row = |source, (primary, secondary)| MagnifiedPoint {
                panel,
                loops,
                n,
                kind: *kind,
                source,
                arc: *arc,
                secondary,
                primary,
            };
            rows.extend(points.iter().map(|&spot| row(Source::Continuation, spot)));
            if matches!(kind, Bifurcation::SaddleNode | Bifurcation::PeriodDoubling) {
                let straight = [points[0], points[30]].map(|q| (1.02 * q.0 - 0.02 * points[0].0, q.1));
                rows.extend(straight.map(|spot| row(Source::Quadratic, spot)));
            }
        }
    }
    rows
}

pub(crate) fn fig07_curves() -> Vec<CurvePoint> {
    curve_rows(curves(&RESONANCES))
}

pub(crate) fn fig07_points() -> Vec<SpecialPoint> {
    point_rows(&curves(&RESONANCES))
}

pub(crate) fn fig07_regions() -> Vec<RegionVertex> {
    region_rows(&curves(&RESONANCES), [(-0.1, graz(1.3)), (-0.1, 1.0)])
}

pub(crate) fn fig08_curves() -> Vec<MagnifiedPoint> {
    magnified_rows(&curves(&RESONANCES))
}

pub(crate) fn fig08_panels() -> Vec<MagnifiedPanel> {
    let coefficients = [(-123.456, 98.765), (-9876.5, 1234.5), (-1.0, 0.5)];
    let panel = |(shown, (c_sn, c_pd)): (Magnified, (f64, f64))| MagnifiedPanel {
        shown,
        heading: Some(Heading { p: shown.panel, n: None, c_sn, c_pd }),
    };
    magnified().into_iter().zip(coefficients).map(panel).collect()
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

/// Curves, points and surfaces of a figure, as written.
pub(crate) fn scene(figure: &str) -> (Vec<Vertex<CurveKind>>, Vec<Mark>, Vec<Vertex<SurfaceKind>>) {
    let mark = |(kind, numbers): (String, Vec<f64>)| {
        let kind = *MarkKind::ALL.iter().find(|known| known.name() == kind).expect("the kind is known");
        let [x, y, z, across, up, depth] = std::array::from_fn(|place| numbers[2 + place]);
        Mark { kind, number: numbers[0] as u32, layer: numbers[1] as u32, x, y, z, across, up, depth }
    };
    let points = written(&format!("{figure}_points")).into_iter().map(mark).collect();
    let curves = vertices(&format!("{figure}_curves"), CurveKind::ALL, CurveKind::name);
    (curves, points, vertices(&format!("{figure}_surfaces"), SurfaceKind::ALL, SurfaceKind::name))
}
