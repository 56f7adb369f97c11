//! Compares the frames with the closed-form MPSs and with each other.

use grazing_reproduction::figures::fig02::Figure2;
use grazing_reproduction::figures::fig07::Figure7;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

use super::{closed_forms, flags, integers, made, numbers, words};
use grazing_trials::closed_form::ClosedFormOrbit;

/// The closed-form MPS with the impact velocity nearest to the given one.
fn nearest(amplitude: f64, omega: f64, loops: u32, velocity: f64) -> ClosedFormOrbit {
    let all = closed_forms(amplitude, omega, loops);
    let distance = |orbit: &ClosedFormOrbit| (orbit.velocity - velocity).abs();
    all.into_iter()
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
        .unwrap_or_else(|| panic!("no {loops}-loop MPS at ({omega}, {amplitude})"))
}

#[test]
fn coefficients_come_out_the_same_in_three_ways() {
    let table = &made().coefficients;
    for curve in ["c_sn", "c_pd"] {
        let closed_form = numbers(table, &format!("{curve}_closed_form"));
        let theorem = numbers(table, curve);
        let fit = numbers(table, &format!("{curve}_fit"));
        let error = numbers(table, &format!("{curve}_fit_error"));
        for k in 0..closed_form.len() {
            let c = closed_form[k];
            // Derivatives of the numerical map are exact to rounding, which the small denominators
            // amplify.
            assert!((theorem[k] - c).abs() < 1e-11 * c.abs(), "{curve}: {} {c}", theorem[k]);
            // The error estimate is not a bound; the extrapolation is accurate to seven digits
            // everywhere.
            assert!((fit[k] - c).abs() < 3.0 * error[k], "{curve}: {} ± {} is not {c}", fit[k], error[k]);
            assert!(error[k] < 1e-6 * c.abs(), "{curve}: {} ± {}", fit[k], error[k]);
        }
    }
}

#[test]
fn every_point_of_every_curve_of_figure_7_is_a_closed_form_mps_with_its_property() {
    let table = &made().fig07.curves;
    let (kinds, loops) = (words(table, "kind"), integers(table, "p"));
    let columns = ["omega", "amplitude", "impact_velocity", "trace", "determinant", "max_interior_x"];
    let [omega, amplitude, velocity, trace, determinant, ceiling] = columns.map(|name| numbers(table, name));
    let (stable, admissible) = (flags(table, "stable"), flags(table, "admissible"));
    let mut compared = 0;
    for row in 0..kinds.len() {
        let (kind, y) = (kinds[row].as_str(), velocity[row]);
        if kind == "graz" || y == 0.0 {
            continue;
        }
        compared += 1;
        let place = format!("{kind} p = {} at ({}, {})", loops[row], omega[row], amplitude[row]);
        let mut orbit = nearest(amplitude[row], omega[row], loops[row], y);
        let fold = (trace[row] - 1.0 - determinant[row]).abs() < 1e-3;
        if fold {
            // The two MPSs merge: rounding of the discriminant, a few 1e-16, shifts them by its square
            // root.
            assert!((orbit.velocity - y).abs() < 1e-6, "{place}: {} {y}", orbit.velocity);
            let shifted = |shift: f64| closed_forms(amplitude[row] + shift, omega[row], loops[row]).len();
            if kind != "SN" {
                continue;
            }
            // To the left of the fold there is no MPS, to the right there are two: the amplitude is
            // accurate to 1e-11.
            assert_eq!((shifted(-1e-11), shifted(1e-11)), (0, 2), "{place}");
            orbit.velocity = y;
        }
        assert!((orbit.determinant - determinant[row]).abs() < 1e-9, "{place}");
        if !fold {
            assert!((orbit.velocity - y).abs() < 1e-9 + 1e-13 / y, "{place}: {} {y}", orbit.velocity);
            assert!(
                (orbit.trace - trace[row]).abs() < 1e-8 * (1.0 + 1.0 / y),
                "{place}: {} {}",
                orbit.trace,
                trace[row]
            );
        }
        match kind {
            "SN" => assert!((trace[row] - 1.0 - determinant[row]).abs() < 1e-8, "{place}"),
            "PD" => assert!((trace[row] + 1.0 + determinant[row]).abs() < 1e-8, "{place}"),
            _ => assert!(ceiling[row].abs() < 1e-11, "{place}"),
        }
        if !fold && !ceiling[row].is_nan() {
            assert!(
                (orbit.ceiling - ceiling[row]).abs() < 1e-8,
                "{place}: {} {}",
                orbit.ceiling,
                ceiling[row]
            );
        }
        assert!(admissible[row], "{place}");
        assert!(kind == "GZ" || !stable[row], "{place}");
    }
    assert!(compared > 1500, "{compared} points were compared");
}

#[test]
fn codimension_two_points_meet_both_their_conditions() {
    let table = &made().fig07.points;
    let (kinds, loops) = (words(table, "kind"), integers(table, "p"));
    let (omega, amplitude) = (numbers(table, "omega"), numbers(table, "amplitude"));
    let curves = &made().fig07.curves;
    let (arcs, places) = (integers(curves, "arc"), [numbers(curves, "omega"), numbers(curves, "amplitude")]);
    for k in 0..kinds.len() {
        // Every point is an end of at least two curves.
        let mut ends = 0;
        for row in 0..arcs.len() {
            let is_end =
                row == 0 || row + 1 == arcs.len() || arcs[row - 1] != arcs[row] || arcs[row + 1] != arcs[row];
            let here =
                (places[0][row] - omega[k]).abs() < 1e-9 && (places[1][row] - amplitude[k]).abs() < 1e-9;
            ends += usize::from(is_end && here);
        }
        assert!(ends >= 2, "{} p = {}: {ends} curves end there", kinds[k], loops[k]);
        if kinds[k] != "PD-GZ" {
            continue;
        }
        let all = closed_forms(amplitude[k], omega[k], loops[k]);
        let doubly = |orbit: &ClosedFormOrbit| {
            (orbit.trace + 1.0 + orbit.determinant).abs() < 1e-7 && orbit.ceiling.abs() < 1e-9
        };
        assert!(all.iter().any(doubly), "{all:?}");
    }
}

/// The distance of a point from the polygon's boundary, and whether it lies inside.
fn position(polygon: &[[f64; 2]], point: [f64; 2]) -> (f64, bool) {
    let (mut distance, mut inside) = (f64::INFINITY, false);
    for k in 0..polygon.len() {
        let (a, b) = (polygon[k], polygon[(k + 1) % polygon.len()]);
        let (edge, gap) = ([b[0] - a[0], b[1] - a[1]], [point[0] - a[0], point[1] - a[1]]);
        let length = edge[0] * edge[0] + edge[1] * edge[1];
        let along = if length > 0.0 { (gap[0] * edge[0] + gap[1] * edge[1]) / length } else { 0.0 };
        let along = along.clamp(0.0, 1.0);
        distance = distance.min(libm::hypot(gap[0] - along * edge[0], gap[1] - along * edge[1]));
        if (a[1] > point[1]) != (b[1] > point[1]) && point[0] < a[0] + edge[0] * gap[1] / edge[1] {
            inside = !inside;
        }
    }
    (distance, inside)
}

#[test]
fn regions_are_where_a_closed_form_mps_is_stable_and_admissible() {
    let table = &made().fig07.regions;
    let (region, kind, loops) = (integers(table, "region"), words(table, "kind"), integers(table, "p"));
    let (omega, amplitude) = (numbers(table, "omega"), numbers(table, "amplitude"));
    let mut polygons: Vec<(u32, Vec<[f64; 2]>)> = Vec::new();
    for row in 0..region.len() {
        if kind[row] == "mps" {
            if row == 0 || region[row - 1] != region[row] {
                polygons.push((loops[row], Vec::new()));
            }
            polygons.last_mut().expect("a polygon has begun").1.push([amplitude[row], omega[row]]);
        }
    }
    // p = 1 at n = 2 and 3 (one region), 4, 5, and a part of that of n = 6, which lies below the window;
    // p = 2 and p = 3 at n = 1, 2, and narrow regions of p = 2 that begin at the resonances p = 1, n = 3,
    // 4 and 5.
    let count = |p: u32| polygons.iter().filter(|(loops, _)| *loops == p).count();
    assert_eq!([count(1), count(2), count(3)], [4, 5, 2]);

    let parameters = &made().parameters;
    let window = parameters.section::<Figure7>().expect("it is right").window();
    let mut random = Pcg64::new(11, 0);
    let mut uniform =
        |low: f64, high: f64| low + (high - low) * (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
    let mut hits = [0; 4];
    for _ in 0..3000 {
        let frequency = uniform(window.secondary[0], window.secondary[1]);
        let point = [uniform(window.primary[0], window.primary[1]), frequency];
        for p in 1..=3 {
            let of_p = polygons.iter().filter(|(loops, _)| *loops == p);
            let places: Vec<_> = of_p.map(|(_, polygon)| position(polygon, point)).collect();
            // Chords between the points of a curve stay within 1e-3 of it.
            if places.iter().any(|(distance, _)| *distance < 1e-3) {
                continue;
            }
            let inside = places.iter().any(|(_, inside)| *inside);
            let all = closed_forms(point[0], point[1], p);
            let stable = all.iter().any(|orbit| orbit.stable() && orbit.admissible());
            assert_eq!(inside, stable, "p = {p} at {point:?}: {all:?}");
            hits[p as usize] += usize::from(inside);
        }
    }
    // Points inside must be frequent enough for every p, so that the comparison is meaningful.
    assert!(hits[1] > 500 && hits[2] > 100 && hits[3] > 5, "{hits:?}");
}

#[test]
fn branches_of_figure_2_are_closed_form_mpss_with_their_stability() {
    let table = &made().fig02.branches;
    let (loops, visit) = (integers(table, "p"), integers(table, "loop"));
    let [amplitude, velocity, phase] = ["amplitude", "impact_velocity", "z"].map(|name| numbers(table, name));
    let (stable, admissible) = (flags(table, "stable"), flags(table, "admissible"));
    let omega = made().parameters.section::<Figure2>().expect("it is right").frequency;
    for row in 0..loops.len() {
        if loops[row] == 0 || visit[row] > 1 || velocity[row] == 0.0 {
            continue;
        }
        let y = velocity[row];
        let orbit = nearest(amplitude[row], omega, loops[row], y);
        let fold = (orbit.trace - 1.0 - orbit.determinant).abs() < 1e-3;
        let tolerance = if fold { 1e-6 } else { 1e-9 + 1e-13 / y };
        assert!((orbit.velocity - y).abs() < tolerance, "{} {y}", orbit.velocity);
        let turns = libm::remainder(orbit.phase - phase[row], core::f64::consts::TAU);
        assert!(turns.abs() < tolerance + 1e-12);
        if !fold && (orbit.trace.abs() - 1.0 - orbit.determinant).abs() > 1e-6 {
            assert_eq!(orbit.stable(), stable[row], "p = {} at {}", loops[row], amplitude[row]);
        }
        if orbit.ceiling.abs() > 1e-9 {
            assert_eq!(orbit.admissible(), admissible[row], "p = {} at {}", loops[row], amplitude[row]);
        }
    }
}

#[test]
fn attractor_lies_between_its_bifurcations_and_shows_no_point_in_the_wall() {
    let bifurcations = &made().fig02.bifurcations;
    let (kinds, at) = (words(bifurcations, "kind"), numbers(bifurcations, "amplitude"));
    let of = |kind: &str| at[kinds.iter().position(|k| k == kind).expect("the bifurcation is there")];
    let (graz, gz, pd, sn) = (of("graz"), of("GZ"), of("PD"), of("SN"));
    // The three-loop MPS is born to the left of grazing, and the two-loop MPS gains stability to the
    // right of it.
    assert!(sn < graz && graz < gz && gz < pd);
    let attractor = &made().fig02.attractor;
    let (amplitude, x) = (numbers(attractor, "amplitude"), numbers(attractor, "x"));
    assert!(amplitude.iter().all(|a| (gz..=pd).contains(a)));
    // Impact velocities are at most of order one, so virtual points lie less than 1/(2γ) beyond the wall.
    assert!(x.iter().all(|x| (-2.0..1.0).contains(x)));
    assert!(x.iter().any(|x| *x > 0.0) && x.iter().any(|x| *x < -0.1));
    // At the right end the two-loop MPS takes over: every value is near one of its two loops, and both
    // occur. Its multiplier is −1 there, so orbits approach it only slowly, like one over the square root
    // of the number of periods.
    let branches = &made().fig02.branches;
    let (loops, at, x_of) = (integers(branches, "p"), numbers(branches, "amplitude"), numbers(branches, "x"));
    let visit = integers(branches, "loop");
    let of_loop = |number: u32| {
        let rows = (0..loops.len()).filter(|row| loops[*row] == 2 && visit[*row] == number);
        let row = rows.min_by(|a, b| (at[*a] - pd).abs().total_cmp(&(at[*b] - pd).abs()));
        x_of[row.expect("the branch of two-loop MPSs is there")]
    };
    let expected = [of_loop(1), of_loop(2)];
    let last: Vec<f64> = (0..x.len()).filter(|k| amplitude[*k] == pd).map(|k| x[k]).collect();
    let near = |value: f64, loop_value: f64| (value - loop_value).abs() < 0.05;
    assert!(
        !last.is_empty() && last.iter().all(|x| expected.iter().any(|e| near(*x, *e))),
        "{last:?} {expected:?}"
    );
    assert!(expected.iter().all(|e| last.iter().any(|x| near(*x, *e))), "{last:?} {expected:?}");
}

#[test]
fn quadratic_approximations_touch_the_curves_at_the_resonance() {
    let table = &made().fig08.curves;
    let (panel, kind, source) = (integers(table, "panel"), words(table, "kind"), words(table, "source"));
    let (omega, amplitude) = (numbers(table, "omega"), numbers(table, "amplitude"));
    for wanted in 1..=3 {
        for curve in ["SN", "PD"] {
            let first = |from: &str| {
                let row = (0..panel.len())
                    .find(|row| panel[*row] == wanted && kind[*row] == curve && source[*row] == from)
                    .expect("the curve is in the panel");
                [omega[row], amplitude[row]]
            };
            let (continued, quadratic) = (first("continuation"), first("quadratic"));
            assert!(
                (continued[0] - quadratic[0]).abs() < 1e-13 && (continued[1] - quadratic[1]).abs() < 1e-13
            );
        }
    }
}
