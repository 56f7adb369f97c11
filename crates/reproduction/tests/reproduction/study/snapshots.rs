//! Snapshots of the numbers, to the digits to which they are known.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use grazing_reproduction::figures::fig04::Figure4;
use grazing_reproduction::figures::fig05::Figure5;
use grazing_reproduction::figures::fig06::Figure6;
use grazing_results::{Cell, Row};
use insta::{Settings, assert_snapshot};

use super::{column, integers, made, numbers, words};

fn snapshots() -> Settings {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../expected"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings
}

/// A number with a given number of significant digits.
fn significant(value: f64, digits: usize) -> String {
    format!("{value:.*e}", digits - 1)
}

#[test]
fn coefficients_hold() {
    let table = &made().coefficients;
    let (loops, n) = (integers(table, "p"), integers(table, "n"));
    let mut text = String::new();
    for row in 0..loops.len() {
        writeln!(text, "p = {}, n = {}", loops[row], n[row]).expect("writing to a string");
        let exact = [
            "omega_star",
            "amplitude_graz",
            "s_plus",
            "s_minus",
            "c_sn_closed_form",
            "c_pd_closed_form",
            "c_sn",
            "c_pd",
        ];
        for name in exact {
            writeln!(text, "  {name} {}", significant(numbers(table, name)[row], 11))
                .expect("writing to a string");
        }
        // The extrapolation is accurate to at least seven digits.
        for name in ["c_sn_fit", "c_pd_fit"] {
            writeln!(text, "  {name} {}", significant(numbers(table, name)[row], 7))
                .expect("writing to a string");
        }
    }
    snapshots().bind(|| assert_snapshot!("coefficients", text));
}

#[test]
fn bifurcations_of_figure_2_hold() {
    let table = &made().fig02.bifurcations;
    let (kind, loops) = (words(table, "kind"), integers(table, "p"));
    let values = ["amplitude", "impact_velocity", "x"].map(|name| numbers(table, name));
    let mut text = String::new();
    for row in 0..kind.len() {
        let [amplitude, velocity, x] = [0, 1, 2].map(|k| significant(values[k][row], 11));
        writeln!(
            text,
            "{} p = {}: amplitude {amplitude}, impact velocity {velocity}, x {x}",
            kind[row], loops[row]
        )
        .expect("writing to a string");
    }
    snapshots().bind(|| assert_snapshot!("fig02_bifurcations", text));
}

#[test]
fn codimension_two_points_hold() {
    let table = &made().fig07.points;
    let (kind, loops, n) = (words(table, "kind"), integers(table, "p"), integers(table, "n"));
    let (omega, amplitude) = (numbers(table, "omega"), numbers(table, "amplitude"));
    let mut text = String::new();
    for row in 0..kind.len() {
        let (omega, amplitude) = (significant(omega[row], 11), significant(amplitude[row], 11));
        writeln!(
            text,
            "{} p = {}, n = {}: omega {omega}, amplitude {amplitude}",
            kind[row], loops[row], n[row]
        )
        .expect("writing to a string");
    }
    snapshots().bind(|| assert_snapshot!("codimension_two_points", text));
}

/// First and last point, number of points and extent of each polyline of a table; the columns `keys`
/// distinguish the polylines.
fn summary<R: Row>(table: &[R], keys: &[&str], x: &str, y: &str) -> String {
    let (xs, ys) = (numbers(table, x), numbers(table, y));
    let keys: Vec<Vec<Cell>> = keys.iter().map(|name| column(table, name)).collect();
    let key = |row: usize| {
        let cells = keys.iter().map(|cells| match &cells[row] {
            Cell::Text(word) => word.to_string(),
            Cell::Integer(value) => value.to_string(),
            other => panic!("{other:?} is no key"),
        });
        cells.collect::<Vec<_>>().join(" ")
    };
    let mut text = String::new();
    let mut start = 0;
    while start < xs.len() {
        let end = (start..xs.len()).find(|row| key(*row) != key(start)).unwrap_or(xs.len());
        let place = |row: usize| format!("({}, {})", significant(xs[row], 8), significant(ys[row], 8));
        writeln!(text, "{}: {} points from {} to {}", key(start), end - start, place(start), place(end - 1))
            .expect("writing to a string");
        start = end;
    }
    text
}

#[test]
fn branches_and_curves_hold() {
    let made = made();
    let text = [
        summary(&made.fig02.branches, &["p", "loop", "branch"], "amplitude", "x"),
        summary(&made.fig07.curves, &["kind", "p", "n", "arc"], "omega", "amplitude"),
        summary(&made.fig07.regions, &["kind", "p", "n", "region"], "omega", "amplitude"),
        summary(&made.fig08.curves, &["panel", "kind", "source", "arc"], "omega", "amplitude"),
    ]
    .join("\n");
    snapshots().bind(|| assert_snapshot!("branches_and_curves", text));
}

#[test]
fn curves_regions_and_parts_of_the_planar_sketches_hold() {
    let study = &made().study;
    let (fig04, fig05) =
        (study.shown::<Figure4>().expect("figure 4"), study.shown::<Figure5>().expect("figure 5"));
    let fig06 = &study.shown::<Figure6>().expect("figure 6").parts;
    let text = [
        summary(&fig04.curves, &["kind", "p"], "tau", "delta"),
        summary(&fig04.points, &["kind"], "tau", "delta"),
        summary(&fig05.curves, &["kind"], "mu", "eta"),
        summary(&fig05.regions, &["region", "kind"], "mu", "eta"),
        summary(fig06, &["part"], "x", "height"),
    ]
    .join("\n");
    snapshots().bind(|| assert_snapshot!("planar_sketches", text));
}

#[test]
fn theorems_in_action_hold() {
    let mut counts = BTreeMap::new();
    let generic = made()
        .theorems
        .generic
        .iter()
        .map(|row| (["2.2", "2.3"][usize::from(row.0.case.loops > 1)], row.0.verdict()));
    let resonant = made()
        .theorems
        .resonant
        .iter()
        .map(|row| (["2.4", "2.5"][usize::from(row.0.case.loops > 1)], row.0.verdict()));
    for (theorem, verdict) in generic.chain(resonant) {
        *counts.entry((theorem, verdict.name(), verdict.reason())).or_insert(0) += 1;
    }
    let mut text = String::new();
    for ((theorem, verdict, reason), count) in counts {
        assert_ne!(verdict, "unexplained");
        writeln!(text, "{}", format!("{theorem} {verdict} {count} {reason}").trim_end())
            .expect("writing to a string");
    }
    snapshots().bind(|| assert_snapshot!("theorems_in_action", text));
}

#[test]
fn attractor_keeps_its_extent() {
    // Single points of chaotic orbits are not reproducible across methods; their number and extent in
    // each tenth of the range are.
    let table = &made().fig02.attractor;
    let (amplitude, x) = (numbers(table, "amplitude"), numbers(table, "x"));
    let (low, high) = (amplitude[0], amplitude[amplitude.len() - 1]);
    let mut text = String::new();
    for tenth in 0..10 {
        let inside = |a: f64| (10.0 * (a - low) / (high - low)).clamp(0.0, 9.999) as u32 == tenth;
        let values: Vec<f64> = (0..x.len()).filter(|k| inside(amplitude[*k])).map(|k| x[k]).collect();
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        writeln!(text, "{tenth}: {} points, x from {least:.2} to {most:.2}", values.len())
            .expect("writing to a string");
    }
    snapshots().bind(|| assert_snapshot!("attractor_extent", text));
}
