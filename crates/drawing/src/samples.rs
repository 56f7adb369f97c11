//! Made-up frames with the columns and the crowding of the real ones, for the tests of the figures.

use polars::prelude::{CsvReader, DataFrame, SerReader, df};

use crate::clip::Window;
use crate::diagram::Section;
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
pub(crate) type SampleCurve = (&'static str, u32, u32, u32, Vec<(f64, f64)>);

/// The grazing curve and at each resonance a loop of SN, GZ, PD.
pub(crate) fn curves(resonances: &[Resonance]) -> Vec<SampleCurve> {
    let mut curves = vec![("graz", 0, 0, 0, shares(200).map(|s| (1.3 * s, graz(1.3 * s))).collect())];
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
        curves.push(("SN", p, n, 3 * number, arc((amplitude, omega), low, 0.2)));
        curves.push(("PD", p, n, 3 * number + 1, arc((amplitude, omega), high, -1.0)));
        curves.push(("GZ", p, n, 3 * number + 2, arc(low, high, 1.0)));
    }
    curves
}

/// A table of curves with these names of the two parameters.
pub(crate) fn curve_table(curves: Vec<SampleCurve>, [across, up]: [&str; 2]) -> DataFrame {
    let rows: Vec<_> = curves
        .into_iter()
        .flat_map(|(kind, p, n, arc, points)| points.into_iter().map(move |(a, w)| (kind, p, n, arc, a, w)))
        .collect();
    df!(
        "kind" => rows.iter().map(|r| r.0).collect::<Vec<_>>(),
        "p" => rows.iter().map(|r| r.1).collect::<Vec<_>>(),
        "n" => rows.iter().map(|r| r.2).collect::<Vec<_>>(),
        "arc" => rows.iter().map(|r| r.3).collect::<Vec<_>>(),
        across => rows.iter().map(|r| r.4).collect::<Vec<_>>(),
        up => rows.iter().map(|r| r.5).collect::<Vec<_>>(),
        "stable" => vec![true; rows.len()],
        "admissible" => vec![true; rows.len()],
    )
    .unwrap()
}

/// The codimension-two points at the ends of such curves.
pub(crate) fn point_table(curves: &[SampleCurve], [across, up]: [&str; 2]) -> DataFrame {
    let ends: Vec<_> = curves.iter().filter(|curve| curve.0 != "graz").collect();
    let kinds = ends.iter().map(|curve| match curve.0 {
        "SN" => "resonance",
        "PD" => "PD-GZ",
        _ => "SN-GZ",
    });
    let spots = ends.iter().map(|curve| if curve.0 == "PD" { curve.4[100] } else { curve.4[0] });
    let spots: Vec<(f64, f64)> = spots.collect();
    df!(
        "kind" => kinds.collect::<Vec<_>>(),
        "p" => ends.iter().map(|curve| curve.1).collect::<Vec<_>>(),
        across => spots.iter().map(|p| p.0).collect::<Vec<_>>(),
        up => spots.iter().map(|p| p.1).collect::<Vec<_>>(),
    )
    .unwrap()
}

/// The regions that such curves bound; `corners` of the region without impacts lie beside its part of the grazing curve.
pub(crate) fn region_table(
    curves: &[SampleCurve],
    corners: [(f64, f64); 2],
    [across, up]: [&str; 2],
) -> DataFrame {
    let below = curves[0].4.iter().copied().chain(corners);
    let mut rows: Vec<(u32, &str, u32, f64, f64)> =
        below.map(|(a, w)| (0, "non-impacting", 0, a, w)).collect();
    for (own, number) in curves[1..].chunks(3).zip(1..) {
        let [sn, pd, gz] = own else { panic!("each resonance has three curves") };
        let outline = sn.4.iter().chain(&gz.4).chain(pd.4.iter().rev());
        rows.extend(outline.map(|&(a, w)| (number, "mps", sn.1, a, w)));
    }
    df!(
        "region" => rows.iter().map(|r| r.0).collect::<Vec<_>>(),
        "ring" => vec![0_u32; rows.len()],
        "kind" => rows.iter().map(|r| r.1).collect::<Vec<_>>(),
        "p" => rows.iter().map(|r| r.2).collect::<Vec<_>>(),
        across => rows.iter().map(|r| r.3).collect::<Vec<_>>(),
        up => rows.iter().map(|r| r.4).collect::<Vec<_>>(),
    )
    .unwrap()
}

/// The same curves once for each resonance, in its panel, with straight lines for approximations.
pub(crate) fn magnified_table(curves: &[SampleCurve], [across, up]: [&str; 2]) -> DataFrame {
    let mut rows: Vec<(u32, &str, &str, u32, f64, f64)> = Vec::new();
    for (own, panel) in curves[1..].chunks(3).zip(1..) {
        for (kind, _, _, arc, points) in curves[..1].iter().chain(own) {
            rows.extend(points.iter().map(|&(a, w)| (panel, *kind, "continuation", *arc, a, w)));
            if *kind == "SN" || *kind == "PD" {
                let straight = [points[0], points[30]].map(|q| (1.02 * q.0 - 0.02 * points[0].0, q.1));
                rows.extend(straight.iter().map(|&(a, w)| (panel, *kind, "quadratic", *arc, a, w)));
            }
        }
    }
    df!(
        "panel" => rows.iter().map(|r| r.0).collect::<Vec<_>>(),
        "kind" => rows.iter().map(|r| r.1).collect::<Vec<_>>(),
        "source" => rows.iter().map(|r| r.2).collect::<Vec<_>>(),
        "arc" => rows.iter().map(|r| r.3).collect::<Vec<_>>(),
        across => rows.iter().map(|r| r.4).collect::<Vec<_>>(),
        up => rows.iter().map(|r| r.5).collect::<Vec<_>>(),
    )
    .unwrap()
}

const NAMES: [&str; 2] = ["amplitude", "omega"];

pub(crate) fn fig07_curves() -> DataFrame {
    curve_table(curves(&RESONANCES), NAMES)
}

pub(crate) fn fig07_points() -> DataFrame {
    point_table(&curves(&RESONANCES), NAMES)
}

pub(crate) fn fig07_regions() -> DataFrame {
    region_table(&curves(&RESONANCES), [(-0.1, graz(1.3)), (-0.1, 1.0)], NAMES)
}

pub(crate) fn fig08_curves() -> DataFrame {
    magnified_table(&curves(&RESONANCES), NAMES)
}

pub(crate) fn fig08_coefficients() -> DataFrame {
    df!(
        "panel" => [1_u32, 2, 3],
        "p" => [1_u32, 2, 3],
        "c_sn" => [-123.456, -9876.5, -1.0],
        "c_pd" => [98.765, 1234.5, 0.5],
    )
    .unwrap()
}

pub(crate) fn fig02_branches() -> DataFrame {
    let mut rows: Vec<(u32, u32, f64, f64, bool)> = Vec::new();
    rows.extend(shares(20).map(|s| (0, 0, 0.5 + 0.5 * s, -0.5 * (1.0 - s), true)));
    for (p, slope) in [(1, 0.1), (2, 0.4), (2, -0.5), (3, 0.9)] {
        let branch = rows.last().map_or(0, |r| r.1 + 1);
        rows.extend(shares(60).map(|s| (p, branch, 1.0 + 0.5 * s, slope * s, p > 1 && s > 0.4)));
    }
    df!(
        "p" => rows.iter().map(|r| r.0).collect::<Vec<_>>(),
        "branch" => rows.iter().map(|r| r.1).collect::<Vec<_>>(),
        "amplitude" => rows.iter().map(|r| r.2).collect::<Vec<_>>(),
        "x" => rows.iter().map(|r| r.3).collect::<Vec<_>>(),
        "stable" => rows.iter().map(|r| r.4).collect::<Vec<_>>(),
        "admissible" => vec![true; rows.len()],
    )
    .unwrap()
}

pub(crate) fn fig02_bifurcations() -> DataFrame {
    df!(
        "kind" => ["graz", "PD", "PD", "SN", "GZ"],
        "p" => [0_u32, 2, 2, 3, 3],
        "amplitude" => [1.0, 1.2, 1.2, 1.2, 1.5],
        "x" => [0.0, 0.16, -0.2, 0.36, 0.9],
    )
    .unwrap()
}

/// So many points scattered over the diagram, without a generator of random numbers.
pub(crate) fn fig02_attractor(count: u32) -> DataFrame {
    // Weyl sequences: multiples of two irrational numbers, modulo one, fill the square evenly.
    let fill = |i: u32, step: f64| (f64::from(i) * step).fract();
    df!(
        "amplitude" => (0..count).map(|i| 1.2 + 0.3 * fill(i, 0.618_033_988_749_894_9)).collect::<Vec<_>>(),
        "x" => (0..count).map(|i| 0.6 * fill(i, 0.414_213_562_373_095) - 0.5).collect::<Vec<_>>(),
    )
    .unwrap()
}

pub(crate) fn fig02_portraits() -> DataFrame {
    let mut rows: Vec<(u32, u32, f64, &str, f64, f64)> = Vec::new();
    for (number, p, amplitude, kind) in
        [(1, 0, 0.8, "periodic"), (2, 2, 1.3, "periodic"), (3, 0, 1.31, "attractor"), (4, 3, 1.4, "periodic")]
    {
        let reach = if p == 0 { 0.9 } else { 1.0 };
        // A polygon of orbit from recoil to impact, the jump left to the figure.
        for (x, y) in [(0.0, -0.5), (-1.0, -1.0), (-2.0, 0.0), (-1.0, 1.0), (0.0, 0.6), (f64::NAN, f64::NAN)]
        {
            rows.push((number, p, amplitude, kind, reach * x, y));
        }
    }
    df!(
        "portrait" => rows.iter().map(|r| r.0).collect::<Vec<_>>(),
        "p" => rows.iter().map(|r| r.1).collect::<Vec<_>>(),
        "amplitude" => rows.iter().map(|r| r.2).collect::<Vec<_>>(),
        "kind" => rows.iter().map(|r| r.3).collect::<Vec<_>>(),
        "x" => rows.iter().map(|r| r.4).collect::<Vec<_>>(),
        "y" => rows.iter().map(|r| r.5).collect::<Vec<_>>(),
    )
    .unwrap()
}

/// A table as `figures/data/` has it, for figures whose labels have to find room in one particular scene.
pub(crate) fn written(name: &str) -> DataFrame {
    let path = format!("{}/../../figures/data/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let file = std::fs::File::open(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    CsvReader::new(file).finish().unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Curves, points and surfaces of a figure, as written.
pub(crate) fn scene(figure: &str) -> [DataFrame; 3] {
    ["curves", "points", "surfaces"].map(|table| written(&format!("{figure}_{table}")))
}
