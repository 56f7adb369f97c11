//! Made-up frames with the columns and the crowding of the real ones, for the tests of the figures.

use polars::prelude::{CsvReader, DataFrame, SerReader, df};

use crate::clip::Window;
use crate::fig07::{Magnified, Section};

pub(crate) const WINDOW: Window = Window { x: [0.0, 1.2], y: [0.3, 1.0] };
pub(crate) const SECTION: Section = Section { omega: 0.85, amplitude: [0.2, 0.4] };

pub(crate) fn magnified() -> [Magnified; 3] {
    [(1, 0.55), (2, 0.3), (3, 0.18)].map(|(panel, a)| {
        let omega = graz(a);
        Magnified { panel, window: Window { x: [a - 0.05, a + 0.06], y: [omega - 0.02, omega + 0.02] } }
    })
}

/// The frequency at which the made-up grazing curve has the amplitude.
fn graz(amplitude: f64) -> f64 {
    1.0 - 0.6 * amplitude * amplitude - 0.2 * amplitude
}

fn shares(count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| f64::from(i) / f64::from(count))
}

type SampleCurve = (&'static str, u32, u32, u32, Vec<(f64, f64)>);

/// Kind, p, n, arc and (amplitude, omega) of the made-up curves: at each of three resonances a loop of SN, GZ, PD.
fn curves() -> Vec<SampleCurve> {
    let mut curves = vec![("graz", 0, 0, 0, shares(200).map(|s| (1.3 * s, graz(1.3 * s))).collect())];
    for (p, amplitude, size) in [(1, 0.55, 0.5), (2, 0.3, 0.18), (3, 0.18, 0.06)] {
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
        curves.push(("SN", p, 1, 3 * p, arc((amplitude, omega), low, 0.2)));
        curves.push(("PD", p, 1, 3 * p + 1, arc((amplitude, omega), high, -1.0)));
        curves.push(("GZ", p, 1, 3 * p + 2, arc(low, high, 1.0)));
    }
    curves
}

pub(crate) fn fig07_curves() -> DataFrame {
    let rows: Vec<_> = curves()
        .into_iter()
        .flat_map(|(kind, p, n, arc, points)| points.into_iter().map(move |(a, w)| (kind, p, n, arc, a, w)))
        .collect();
    df!(
        "kind" => rows.iter().map(|r| r.0).collect::<Vec<_>>(),
        "p" => rows.iter().map(|r| r.1).collect::<Vec<_>>(),
        "n" => rows.iter().map(|r| r.2).collect::<Vec<_>>(),
        "arc" => rows.iter().map(|r| r.3).collect::<Vec<_>>(),
        "amplitude" => rows.iter().map(|r| r.4).collect::<Vec<_>>(),
        "omega" => rows.iter().map(|r| r.5).collect::<Vec<_>>(),
        "stable" => vec![true; rows.len()],
        "admissible" => vec![true; rows.len()],
    )
    .unwrap()
}

pub(crate) fn fig07_points() -> DataFrame {
    let ends: Vec<_> = curves().into_iter().filter(|c| c.0 != "graz").map(|c| (c.0, c.4)).collect();
    let kinds = ends.iter().map(|(kind, _)| match *kind {
        "SN" => "resonance",
        "PD" => "PD-GZ",
        _ => "SN-GZ",
    });
    let firsts: Vec<(f64, f64)> =
        ends.iter().map(|(kind, points)| if *kind == "PD" { points[100] } else { points[0] }).collect();
    df!(
        "kind" => kinds.collect::<Vec<_>>(),
        "amplitude" => firsts.iter().map(|p| p.0).collect::<Vec<_>>(),
        "omega" => firsts.iter().map(|p| p.1).collect::<Vec<_>>(),
    )
    .unwrap()
}

pub(crate) fn fig07_regions() -> DataFrame {
    let curves = curves();
    let mut rows: Vec<(u32, &str, u32, f64, f64)> = Vec::new();
    let mut below = curves[0].4.clone();
    below.extend([(-0.1, graz(1.3)), (-0.1, 1.0)]);
    rows.extend(below.into_iter().map(|(a, w)| (0, "non-impacting", 0, a, w)));
    for p in 1..=3 {
        let of = |kind| curves.iter().find(|c| c.0 == kind && c.1 == p).unwrap().4.clone();
        let outline = of("SN").into_iter().chain(of("GZ")).chain(of("PD").into_iter().rev());
        rows.extend(outline.map(|(a, w)| (p, "mps", p, a, w)));
    }
    df!(
        "region" => rows.iter().map(|r| r.0).collect::<Vec<_>>(),
        "kind" => rows.iter().map(|r| r.1).collect::<Vec<_>>(),
        "p" => rows.iter().map(|r| r.2).collect::<Vec<_>>(),
        "amplitude" => rows.iter().map(|r| r.3).collect::<Vec<_>>(),
        "omega" => rows.iter().map(|r| r.4).collect::<Vec<_>>(),
    )
    .unwrap()
}

pub(crate) fn fig08_curves() -> DataFrame {
    let mut rows: Vec<(u32, &str, &str, u32, f64, f64)> = Vec::new();
    for panel in 1..=3 {
        for (kind, p, _, arc, points) in curves() {
            if kind == "graz" || p == panel {
                rows.extend(points.iter().map(|&(a, w)| (panel, kind, "continuation", arc, a, w)));
            }
            if p == panel && kind != "GZ" {
                let straight = [points[0], points[1]].map(|q| (2.0 * q.0 - points[0].0, q.1));
                rows.extend(straight.iter().map(|&(a, w)| (panel, kind, "quadratic", arc, a, w)));
            }
        }
    }
    df!(
        "panel" => rows.iter().map(|r| r.0).collect::<Vec<_>>(),
        "kind" => rows.iter().map(|r| r.1).collect::<Vec<_>>(),
        "source" => rows.iter().map(|r| r.2).collect::<Vec<_>>(),
        "arc" => rows.iter().map(|r| r.3).collect::<Vec<_>>(),
        "amplitude" => rows.iter().map(|r| r.4).collect::<Vec<_>>(),
        "omega" => rows.iter().map(|r| r.5).collect::<Vec<_>>(),
    )
    .unwrap()
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
