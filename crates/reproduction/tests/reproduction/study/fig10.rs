//! Compares Figure 10 with the formulas of the proof, and with the visits of MPSs from continuation; what is
//! written beside its vertices.

use std::sync::LazyLock;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Route, SolutionCurve, Window};
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_drawing::geometry::sheet::{Spot, inside};
use grazing_drawing::{Element, SheetWidth};
use grazing_reproduction::StudyFigure;
use grazing_reproduction::figures::fig10::{Figure10, Visit, VisitPath};
use grazing_theorems::auxiliary::{lucas_sequence, scaled_visit_position};
use grazing_theorems::{GenericGrazing, GrazingState};

use super::{forced, integers, made, numbers, theory};

/// The vertices (u, w) in order.
static SECTION: LazyLock<Figure10> = LazyLock::new(|| made().parameters.section().expect("it is right"));

fn vertices() -> Vec<[f64; 2]> {
    let shown = made().study.shown::<Figure10>().expect("figure 10 can be computed");
    let path = &shown.path;
    let (u, w) = (numbers(path, "u"), numbers(path, "w"));
    assert_eq!(integers(path, "visit"), (0..u.len() as u32).collect::<Vec<_>>());
    u.into_iter().zip(w).map(|(u, w)| [u, w]).collect()
}

fn grazing() -> GrazingState {
    theory().grazing(SECTION.frequency).unwrap()
}

/// S_p / β, which scales slopes in μ to (u, w). Paper: eq:ujwj.
fn scale() -> f64 {
    let p = SECTION.loops;
    lucas_sequence(p, grazing().trace(), grazing().determinant()) / grazing().transversality()
}

#[test]
fn vertices_are_scaled_slopes_of_the_visits_and_the_closed_form_of_u() {
    let (point, p) = (grazing().grazing_point(), SECTION.loops);
    let orbit = point.emerging_orbit(p).unwrap();
    let (tau, delta) = (grazing().trace(), grazing().determinant());
    for (j, [u, w]) in (0..).zip(vertices()) {
        let slope = orbit.visit_slope(j) * scale();
        // A dozen roundings of numbers up to 10.
        assert!((slope.x - u).abs() < 1e-13 && (slope.y - w).abs() < 1e-13, "{j}: {slope} ({u}, {w})");
        assert!((scaled_visit_position(j, p, tau, delta) - u).abs() < 1e-13, "{j}");
    }
}

#[test]
fn the_path_starts_and_ends_on_the_w_axis_and_lies_left_of_it_between() {
    let vertices = vertices();
    let last = vertices.len() - 1;
    assert_eq!(last as u32, SECTION.loops);
    assert_eq!(vertices[0][0], 0.0);
    assert!(vertices[last][0].abs() < 1e-13, "{}", vertices[last][0]);
    assert!(vertices[1..last].iter().all(|[u, _]| *u < -0.1), "{vertices:?}");
}

#[test]
fn the_closed_path_is_convex() {
    let vertices = vertices();
    let n = vertices.len();
    let turn = |k: usize| {
        let [a, b, c] = [0, 1, 2].map(|step| vertices[(k + step) % n]);
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
    };
    let turns: Vec<f64> = (0..n).map(turn).collect();
    assert!(turns.iter().all(|turn| turn * turns[0] > 0.0), "{turns:?}");
    // All turns have the same sign and no vertex is passed twice, so the angles add up to exactly one
    // full turn.
    let direction = |k: usize| {
        let (a, b) = (vertices[k % n], vertices[(k + 1) % n]);
        libm::atan2(b[1] - a[1], b[0] - a[0])
    };
    let wrapped = |angle: f64| angle - core::f64::consts::TAU * libm::round(angle / core::f64::consts::TAU);
    let total: f64 = (0..n).map(|k| wrapped(direction(k + 1) - direction(k))).sum();
    assert!((total.abs() - core::f64::consts::TAU).abs() < 1e-12, "{total}");
}

#[test]
fn visits_of_followed_solutions_tend_to_the_vertices() {
    let shown = &*SECTION;
    let (omega, graz) = (shown.frequency, grazing().amplitude());
    let oscillator = forced(graz, omega);
    let equations = LoopEquations::new(oscillator, shown.loops, Formulation::Vivid);
    let side = GenericGrazing::check(&grazing().grazing_point(), shown.loops).unwrap().side().signum();
    let reach = 1e-3;
    let route = Route {
        window: Window { primary: [graz - reach, graz + reach], secondary: [0.0, f64::INFINITY] },
        control: StepControl { first: 1e-5, longest: 1e-4, ..StepControl::DRAWING },
        step_limit: 1000,
        stop_at_events: false,
        pace: None,
    };
    let curve = SolutionCurve { equations: equations.clone(), condition: Condition::Secondary(omega) };
    let start = Unknowns::new(0.0, grazing().phase(), graz, omega);
    let curve = curve
        .follow(start, Unknowns::new(1.0, 0.0, 0.0, 0.0), EventTimes::default(), &route)
        .expect("a branch");
    // Greatest distance of visits / μ from the vertices j = 1, …, p, by |μ|.
    let mut errors: Vec<(f64, f64)> = Vec::new();
    for point in &curve.points[1..] {
        let mu = point.solution.parameters()[0] - graz;
        assert!(mu * side > 0.0, "the MPS emanates to the side of Theorem 2.3");
        assert!(point.solution.admissible());
        let visits = equations.visits(&point.solution.unknowns, &point.times).expect("visits near Π");
        let mut error = 0.0_f64;
        for (visit, [u, w]) in visits.iter().zip(&vertices()[1..]) {
            let turns = core::f64::consts::TAU;
            let phase = visit[1] - grazing().phase();
            let phase = phase - turns * libm::round(phase / turns);
            error = error.max((scale() * visit[0] / mu - u).abs());
            error = error.max((scale() * phase / mu - w).abs());
        }
        errors.push((mu.abs(), error));
    }
    // Visits are slope · μ + O(μ²): the error over |μ| stays bounded.
    let near: Vec<_> = errors.iter().filter(|(mu, _)| (1e-5..1e-4).contains(mu)).collect();
    assert!(near.len() > 3, "{errors:?}");
    let ratios = near.iter().map(|(mu, error)| error / mu);
    let (least, most) = ratios.fold((f64::INFINITY, 0.0_f64), |(l, m), r| (l.min(r), m.max(r)));
    assert!(most < 1.3 * least, "not of first order: {least} {most}");
    assert!(near[0].1 < 0.1, "{near:?}");
}

/// A path through these places.
fn path(places: &[(f64, f64)]) -> VisitPath {
    let path = (0..).zip(places).map(|(visit, &(u, w))| Visit { visit, u, w }).collect();
    VisitPath { path }
}

/// A path of seven vertices.
fn sample() -> VisitPath {
    path(&[(0.0, -3.7), (-2.5, -3.2), (-3.8, -1.2), (-3.5, 1.0), (-2.2, 2.1), (-0.8, 1.9), (0.0, 0.7)])
}

#[test]
fn every_vertex_is_marked_and_named() {
    let path = sample();
    let svg = Figure10::draw(&path, SheetWidth::Paper).unwrap().svg();
    assert_eq!(svg.matches("<circle").count(), 7);
    for visit in 0..=6 {
        assert_eq!(svg.matches(&format!(">({visit})</tspan>")).count(), 2, "{visit}");
    }
    assert!(svg.contains('𝒫'));
}

#[test]
fn vertices_are_named_outside_the_path() {
    let path = sample();
    let sheet = Figure10::draw(&path, SheetWidth::Paper).unwrap();
    let area = sheet.elements.iter().find_map(|element| match element {
        Element::Path(area) if area.attributes.contains("fill-opacity=\"0.1\"") => Some(area),
        _ => None,
    });
    let outline = area.expect("the area is filled").pieces[0].0.iter();
    let outline: Vec<Spot> = outline.map(|&(x, y)| (f64::from(x) / 100.0, f64::from(y) / 100.0)).collect();
    let names: Vec<_> = sheet.texts.iter().filter(|(text, _)| text.contains("w^{(")).collect();
    assert_eq!(names.len(), 7);
    for (text, bounds) in names {
        assert!(!inside(&outline, bounds.centre()), "{text}");
    }
}

#[test]
fn a_path_without_width_is_an_error() {
    let path = path(&[(0.0, 0.0), (0.0, 1.0)]);
    let error = Figure10::draw(&path, SheetWidth::Paper).unwrap_err();
    assert!(error.to_string().contains("range of fig10"), "{error}");
}
