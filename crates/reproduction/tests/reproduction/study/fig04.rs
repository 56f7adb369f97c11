//! Compares Figure 4 with the sums over eigenvalues that vanish on its curves, and with the global map of
//! the model; what is written beside its curves.

use std::collections::BTreeSet;
use std::sync::Arc;

use grazing_drawing::SheetWidth;
use grazing_model::AtRest;
use grazing_model::maps::global_map;
use grazing_reproduction::StudyFigure;
use grazing_reproduction::figures::fig02::Figure2;
use grazing_reproduction::figures::fig04::{Boundaries, Boundary, Figure4};
use grazing_theorems::auxiliary::{admissibility_sum, resonance_boundary};
use grazing_theorems::spectrum::in_trapesium;

use super::{forced, integers, made, numbers, theory, words};

fn figure() -> Arc<Boundaries> {
    made().study.shown::<Figure4>().expect("figure 4 can be computed")
}

/// The rows (τ, δ) of one curve.
fn curve(figure: &Boundaries, kind: &str, p: u32) -> Vec<[f64; 2]> {
    let (kinds, loops) = (words(&figure.curves, "kind"), integers(&figure.curves, "p"));
    let (tau, delta) = (numbers(&figure.curves, "tau"), numbers(&figure.curves, "delta"));
    let rows = (0..kinds.len()).filter(|&row| kinds[row] == kind && loops[row] == p);
    rows.map(|row| [tau[row], delta[row]]).collect()
}

fn all_loops() -> Vec<u32> {
    made().parameters.section::<Figure4>().expect("it is right").loops
}

/// Modulus and argument of the eigenvalues, which are complex below τ = 2√δ.
fn polar(tau: f64, delta: f64) -> (f64, f64) {
    (delta.sqrt(), libm::acos(0.5 * tau / delta.sqrt()))
}

/// S_p = Σ λ₁^{p−k} λ₂^{k−1}, k = 1, …, p, from the eigenvalues, and the sum of the moduli of its
/// terms. Paper: eq:SpTp.
fn sum_of_powers(p: u32, tau: f64, delta: f64) -> (f64, f64) {
    let (modulus, angle) = polar(tau, delta);
    let size = libm::pow(modulus, f64::from(p) - 1.0);
    let terms = (1..=p).map(|k| size * libm::cos(angle * (f64::from(p) + 1.0 - 2.0 * f64::from(k))));
    (terms.sum(), size * f64::from(p))
}

/// H_p = Σ Σ λ₁^{k−j} λ₂^{1−k}, k ≤ j < p, from the eigenvalues, and the sum of the moduli of its
/// terms. Paper: eq:Hp.
fn double_sum(p: u32, tau: f64, delta: f64) -> (f64, f64) {
    let (modulus, angle) = polar(tau, delta);
    let (mut sum, mut size) = (0.0, 0.0);
    for (j, k) in (1..p).flat_map(|j| (1..=j).map(move |k| (f64::from(j), f64::from(k)))) {
        let term = libm::pow(modulus, 1.0 - j);
        sum += term * libm::cos(angle * (2.0 * k - j - 1.0));
        size += term;
    }
    (sum, size)
}

#[test]
fn the_sum_of_powers_of_the_eigenvalues_vanishes_on_g() {
    for p in all_loops() {
        let points = curve(&figure(), "g", p);
        assert!(points.len() > 100);
        for &[tau, delta] in points.iter().filter(|point| point[1] > 0.0) {
            let (sum, size) = sum_of_powers(p, tau, delta);
            // A few roundings of each term, and of the angle times p.
            assert!(sum.abs() < 1e-14 * size, "S_{p} = {sum} at ({tau}, {delta})");
        }
    }
}

#[test]
fn the_double_sum_over_the_eigenvalues_vanishes_on_h_and_is_positive_beyond() {
    for p in all_loops() {
        for &[tau, delta] in curve(&figure(), "h", p).iter().filter(|point| point[1] > 0.0) {
            if p == 2 {
                // H_2 = 1 has no zero: h_2 is where the eigenvalues become real and negative, by
                // definition.
                assert!((tau * tau - 4.0 * delta).abs() < 4.0 * f64::EPSILON && tau < 0.0, "{tau} {delta}");
                continue;
            }
            let (sum, size) = double_sum(p, tau, delta);
            // The tolerance is the same; δ = 1 is included, where the frame contains the limit.
            assert!(sum.abs() < 1e-14 * size, "H_{p} = {sum} at ({tau}, {delta})");
            for step in 1..=50 {
                let beyond = tau + (delta + 1.0 - tau) * f64::from(step) / 50.0;
                assert!(admissibility_sum(p, beyond, delta) > 0.0, "H_{p} at ({beyond}, {delta})");
            }
        }
    }
}

#[test]
fn h_lies_between_the_two_curves_of_lemma_2_1() {
    for p in all_loops().into_iter().filter(|&p| p >= 3) {
        let inner = |point: &&[f64; 2]| 0.0 < point[1] && point[1] < 1.0;
        for &[tau, delta] in curve(&figure(), "h", p).iter().filter(inner) {
            let p = f64::from(p);
            assert!(resonance_boundary(0.5 * p, delta) < tau && tau < resonance_boundary(p - 1.0, delta));
        }
    }
}

#[test]
fn every_curve_runs_through_the_trapesium_from_its_lower_to_its_upper_side() {
    let figure = figure();
    let outline = curve(&figure, "trapesium", 0);
    assert_eq!(outline.first(), outline.last());
    for (kind, p) in
        all_loops().into_iter().flat_map(|p| [("g", p), ("h", p)]).chain(std::iter::once(("limit", 0)))
    {
        let points = curve(&figure, kind, p);
        for &[tau, delta] in &points[1..points.len() - 1] {
            assert!(in_trapesium(tau, delta), "{kind}_{p} at ({tau}, {delta})");
        }
        assert_eq!((points[0], points[points.len() - 1][1]), ([0.0, 0.0], 1.0));
    }
}

#[test]
fn the_corners_of_the_trapesium_bound_stable_matrices() {
    for &[tau, delta] in &curve(&figure(), "trapesium", 0)[..4] {
        let towards_the_middle = |by: f64| (tau * (1.0 - by), delta + by * (0.5 - delta));
        let (inside, outside) = (towards_the_middle(1e-6), towards_the_middle(-1e-6));
        assert!(in_trapesium(inside.0, inside.1) && !in_trapesium(outside.0, outside.1), "{tau} {delta}");
    }
}

#[test]
fn the_star_is_read_off_the_global_map_and_lies_where_section_2_4_says() {
    let (figure, parameters) = (figure(), &made().parameters);
    let (tau, delta) = (numbers(&figure.points, "tau")[0], numbers(&figure.points, "delta")[0]);
    let frequency = parameters.section::<Figure2>().expect("it is right").frequency;
    let grazing = theory().grazing(frequency).unwrap();
    let oscillator = forced(grazing.amplitude(), frequency);
    let map =
        global_map::<_, 1>(&oscillator, AtRest::new(0.0, grazing.phase()), None).unwrap().jet.derivative();
    // Rounding over one period of flow.
    assert!((map.trace() - tau).abs() < 1e-13 && (map.determinant() - delta).abs() < 1e-13);

    // "To the right of g_2", and between h_p and g_p for p = 3, 4, 5.
    let at = |kind: &str, p: u32| {
        let points = curve(&figure, kind, p);
        let above = points.iter().position(|point| point[1] > delta).expect("the curve passes the star");
        let ([t0, d0], [t1, d1]) = (points[above - 1], points[above]);
        t0 + (t1 - t0) * (delta - d0) / (d1 - d0)
    };
    assert!(at("g", 2) < tau);
    for p in 3..=5 {
        assert!(at("h", p) < tau && tau < at("g", p), "p = {p}");
    }
}

#[test]
fn every_curve_is_named_and_families_differ_without_colour() {
    let figure = figure();
    let svg = Figure4::draw(&figure, SheetWidth::Paper).unwrap().svg();
    let svg = svg.split("<defs").next().unwrap();
    for (kind, family) in [(Boundary::Resonance, "g"), (Boundary::Admissibility, "h")] {
        let own = figure.curves.iter().filter(|point| point.kind == kind);
        let own: BTreeSet<u32> = own.map(|point| point.loops).collect();
        assert_eq!(svg.matches(&format!(">{family}</tspan>")).count(), own.len());
        for p in own {
            assert!(svg.contains(&format!(">{p}</tspan>")), "{p}");
        }
    }
    assert!(svg.contains(">Fig. 2<") && svg.contains('√'));
    // Two slanted sides, δ + 1 and −δ − 1, in addition to the axis title and the limit.
    assert_eq!(svg.matches(">δ</tspan>").count(), 4);
    let families = svg.matches("stroke-width=\"1.1\"").count();
    assert_eq!(2 * svg.matches("stroke-width=\"1.1\" stroke-dasharray").count(), families);
}
