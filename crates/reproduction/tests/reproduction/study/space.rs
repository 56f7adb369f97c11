//! Figures 1, 3 and 9: every drawn point is compared with numerical integration of the equations of
//! motion.
//!
//! The frames come from the closed-form flow and the maps between Σ and Π; here the equations are
//! integrated by the classical Runge–Kutta method, which is independent of them.

use std::f64::consts::TAU;
use std::path::Path;

use grazing_beyond::parameters;
use grazing_input::Text;
use grazing_model::LinearOscillator;
use grazing_reproduction::Study;
use grazing_reproduction::figures::fig01::Figure1;
use grazing_reproduction::figures::fig03::Figure3;
use grazing_reproduction::figures::fig09::Figure9;
use grazing_reproduction::parameters::Parameters;
use grazing_results::Row;

use super::{integers, numbers, words};

/// A point (x, y, z) of phase space.
type Point = [f64; 3];

/// The equation of motion ẍ + 2ζẋ + x + 1 = 𝒜 cos z.
#[derive(Clone, Copy)]
struct Equation {
    zeta: f64,
    amplitude: f64,
    frequency: f64,
}

impl Equation {
    fn of(oscillator: &LinearOscillator) -> Self {
        Self {
            zeta: oscillator.damping_ratio(),
            amplitude: oscillator.amplitude(),
            frequency: oscillator.frequency(),
        }
    }

    fn rate(&self, [x, y, z]: Point) -> Point {
        [y, self.amplitude * libm::cos(z) - 2.0 * self.zeta * y - x - 1.0, self.frequency]
    }

    /// The state after a time of either sign. Steps of about a thousandth leave an error of 10⁻¹³ per
    /// unit of time.
    fn follow(&self, from: Point, time: f64) -> Point {
        let steps = (time.abs() * 1000.0).ceil().max(1.0);
        let h = time / steps;
        let mut at = from;
        let plus = |a: Point, b: Point, h: f64| [a[0] + h * b[0], a[1] + h * b[1], a[2] + h * b[2]];
        for _ in 0..steps as u64 {
            let k1 = self.rate(at);
            let k2 = self.rate(plus(at, k1, 0.5 * h));
            let k3 = self.rate(plus(at, k2, 0.5 * h));
            let k4 = self.rate(plus(at, k3, h));
            at = std::array::from_fn(|i| at[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        }
        at
    }

    /// The maximum of x nearest to the state after a time, by Newton's method for y = 0.
    fn rest(&self, from: Point, guess: f64) -> Point {
        let mut at = self.follow(from, guess);
        for _ in 0..20 {
            at = self.follow(at, -at[1] / self.rate(at)[1]);
        }
        assert!(at[1].abs() < 1e-13 && self.rate(at)[1] < 0.0, "a maximum of x: {at:?}");
        at
    }
}

fn study() -> (Parameters, Study) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures/parameters.toml");
    let parameters = parameters::from_file(&file, &[]).expect("the default parameters are valid");
    let study = Study::new(&parameters);
    (parameters, study)
}

fn places<R: Row>(table: &[R], columns: [&str; 3]) -> Vec<Point> {
    let [a, b, c] = columns.map(|column| numbers(table, column));
    assert!([&a, &b, &c].into_iter().flatten().all(|number| number.is_finite()), "no cell is empty");
    (0..a.len()).map(|i| [a[i], b[i], c[i]]).collect()
}

fn states<R: Row>(table: &[R]) -> Vec<Point> {
    places(table, ["x", "y", "z"])
}

fn sights<R: Row>(table: &[R]) -> Vec<Point> {
    places(table, ["across", "up", "depth"])
}

/// The complete curves of a kind.
fn curves<R: Row>(table: &[R], kind: &str) -> Vec<Vec<Point>> {
    let (kinds, number, all) = (words(table, "kind"), integers(table, "number"), states(table));
    let mut found: Vec<(u32, Vec<Point>)> = Vec::new();
    for row in (0..all.len()).filter(|&row| kinds[row] == kind) {
        match found.last_mut().filter(|(last, _)| *last == number[row]) {
            Some((_, curve)) => curve.push(all[row]),
            None => found.push((number[row], vec![all[row]])),
        }
    }
    found.into_iter().map(|(_, curve)| curve).collect()
}

/// The points of a kind, in order.
fn points<R: Row>(table: &[R], kind: &str) -> Vec<Point> {
    let kinds = words(table, "kind");
    states(table).into_iter().zip(kinds).filter(|(_, k)| k == kind).map(|(point, _)| point).collect()
}

fn distance(a: Point, b: Point) -> f64 {
    (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt()
}

/// The tolerance: the error of integration is below 10⁻¹², including the amplification of rounding by the
/// flow.
const INTEGRATED: f64 = 1e-11;

fn assert_follows(equation: Equation, curve: &[Point]) {
    for pair in curve.windows(2) {
        let time = (pair[1][2] - pair[0][2]) / equation.frequency;
        assert!(time >= 0.0, "time runs forwards along a curve");
        let there = equation.follow(pair[0], time);
        assert!(distance(there, pair[1]) < INTEGRATED, "{there:?} is not {:?}", pair[1]);
    }
}

#[test]
fn orbits_of_figure_1_obey_the_equation_up_to_the_wall_and_leave_it_as_the_reset_law_says() {
    let (parameters, study) = study();
    let made = study.shown::<Figure1>().expect("figure 1 can be computed");
    let shown = parameters.section::<Figure1>().expect("it is right");
    let flights = curves(&made.curves, "orbit");
    for flight in &flights {
        assert_follows(Equation::of(&shown.oscillator), flight);
        // The grazing flight touches the wall, the others end at it; both to rounding.
        assert!(flight.iter().all(|state| state[0] < 1e-12), "in front of the wall");
    }
    let (impacts, recoils) = (points(&made.points, "impact"), points(&made.points, "recoil"));
    assert!(!impacts.is_empty() && impacts.len() == recoils.len());
    for (impact, recoil) in impacts.iter().zip(&recoils) {
        assert!(impact[0] == 0.0 && impact[1] > 0.0, "on the incoming set");
        let reset = [0.0, -shown.oscillator.restitution() * impact[1], impact[2]];
        assert!(distance(*recoil, reset) < 1e-15, "{recoil:?} is not {reset:?}");
        // Crossings are located to a few rounding errors.
        let ends_there = |flight: &&Vec<Point>| distance(flight[flight.len() - 1], *impact) < 1e-12;
        assert_eq!(flights.iter().filter(ends_there).count(), 1);
        assert_eq!(flights.iter().filter(|flight| flight[0] == *recoil).count(), 1);
    }
    for graze in points(&made.points, "graze") {
        assert_eq!(graze[..2], [0.0, 0.0]);
        assert!(Equation::of(&shown.oscillator).rate(graze)[1] < 0.0, "in the grazing set");
    }
}

#[test]
fn the_image_in_figure_3_is_where_the_orbit_returns_and_gamma_closes_at_its_only_touch_of_the_wall() {
    let (parameters, study) = study();
    let made = study.shown::<Figure3>().expect("figure 3 can be computed");
    let shown = parameters.section::<Figure3>().expect("it is right");
    let theory = grazing_theorems::LinearOscillator::new(shown.zeta, 1.0).expect("a damping ratio");
    let grazing = theory.grazing(shown.frequency).expect("a frequency");
    let equation = Equation { zeta: shown.zeta, amplitude: grazing.amplitude(), frequency: shown.frequency };
    let section = points(&made.points, "section");
    let [start, image] = section[..] else { panic!("a point and its image") };
    let returned = equation.rest(start, TAU / shown.frequency);
    assert!(distance([returned[0], returned[1], returned[2] - TAU], image) < INTEGRATED);

    let periodic = &curves(&made.curves, "periodic")[0];
    assert_follows(equation, periodic);
    assert_follows(equation, &curves(&made.curves, "orbit")[0]);
    let (first, last) = (periodic[0], periodic[periodic.len() - 1]);
    assert!(distance([first[0], first[1], first[2] + TAU], last) < 1e-13);
    let inner = &periodic[1..periodic.len() - 1];
    assert!(inner.iter().all(|state| state[0] < 0.0), "Γ meets Σ at one point");
    // On the ring both ends are at the same place on the page: the sine and cosine of a phase and of the
    // phase one turn later.
    let (kinds, seen) = (words(&made.curves, "kind"), sights(&made.curves));
    let on_page: Vec<Point> =
        seen.into_iter().zip(kinds).filter(|(_, kind)| kind == "periodic").map(|(place, _)| place).collect();
    assert!(distance(on_page[0], on_page[on_page.len() - 1]) < 1e-13);
}

#[test]
fn points_of_figure_9_are_where_the_orbits_come_to_rest() {
    let (parameters, study) = study();
    let made = study.shown::<Figure9>().expect("figure 9 can be computed");
    let shown = parameters.section::<Figure9>().expect("it is right");
    let equation = Equation::of(&shown.oscillator);
    let one = |kind: &str| points(&made.points, kind)[0];
    let (impact, recoil, ahead) = (one("impact"), one("recoil"), one("virtual"));
    assert_eq!((impact[0], impact[1]), (0.0, shown.impact[0]));
    assert_eq!(recoil, [0.0, -shown.oscillator.restitution() * impact[1], impact[2]]);
    // To leading order y/|ẍ| is the time to the maximum of x.
    let time = |state: Point| -state[1] / equation.rate(state)[1];
    assert!(time(impact) > 0.0 && time(recoil) < 0.0);
    assert!(distance(equation.rest(impact, time(impact)), ahead) < INTEGRATED);
    let section = points(&made.points, "section");
    assert_eq!(section.len(), 1 + shown.loops as usize);
    assert!(distance(equation.rest(recoil, time(recoil)), section[0]) < INTEGRATED);
    for pair in section.windows(2) {
        let next = equation.rest(pair[0], TAU / equation.frequency);
        assert!(distance([next[0], next[1], next[2] - TAU], pair[1]) < INTEGRATED);
    }
    assert!(ahead[0] > 0.0 && section[0][0] > 0.0, "virtual points lie beyond the wall");
}

#[test]
fn curves_of_figure_9_join_the_points_and_are_virtual_exactly_beyond_the_wall() {
    let (parameters, study) = study();
    let made = study.shown::<Figure9>().expect("figure 9 can be computed");
    let shown = parameters.section::<Figure9>().expect("it is right");
    let (real, unreal) = (curves(&made.curves, "orbit"), curves(&made.curves, "virtual"));
    for curve in real.iter().chain(&unreal) {
        assert_follows(Equation::of(&shown.oscillator), curve);
    }
    // Ends on the wall or at the edge are located to rounding.
    let low = shown.position[0];
    assert!(real.iter().flatten().all(|state| low - 1e-12 < state[0] && state[0] < 1e-12));
    assert!(unreal.iter().flatten().all(|state| state[0] > -1e-12));
    let ends: Vec<Point> =
        real.iter().chain(&unreal).flat_map(|curve| [curve[0], curve[curve.len() - 1]]).collect();
    for point in states(&made.points) {
        assert!(ends.iter().any(|end| distance(*end, point) < 1e-12), "no curve ends in {point:?}");
    }
}

#[test]
fn points_lie_on_the_shown_part_of_their_surface() {
    let (_, study) = study();
    let (one, three, nine) = (study.shown::<Figure1>(), study.shown::<Figure3>(), study.shown::<Figure9>());
    for scene in [one.expect("figure 1"), three.expect("figure 3"), nine.expect("figure 9")] {
        let (points, surfaces) = (&scene.points, &scene.surfaces);
        let faces: Vec<Vec<Point>> =
            ["incoming", "outgoing", "section"].iter().flat_map(|kind| curves(surfaces, kind)).collect();
        let within = |point: &Point, face: &Vec<Point>| {
            (0..3).all(|i| {
                let values = || face.iter().map(|corner| corner[i]);
                let (low, high) =
                    (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
                low <= point[i] && point[i] <= high
            })
        };
        for point in states(points) {
            assert!(faces.iter().any(|face| within(&point, face)), "{point:?} lies on no face");
        }
    }
}

#[test]
fn the_projection_turns_space_and_leaves_lengths_alone() {
    let (parameters, study) = study();
    let straight = |stretch: [f64; 3]| move |p: Point| [0, 1, 2].map(|i| stretch[i] * p[i]);
    let nine = study.shown::<Figure9>().expect("figure 9");
    let view = parameters.section::<Figure9>().expect("it is right").view;
    check_lengths(&nine.curves, straight(view.stretch));
    check_lengths(&nine.surfaces, straight(view.stretch));
    let three = study.shown::<Figure3>().expect("figure 3");
    let (radius, stretch) = (
        parameters.section::<Figure3>().expect("it is right").radius,
        parameters.section::<Figure3>().expect("it is right").view.stretch,
    );
    let ring = |[x, y, z]: Point| {
        let (sin, cos) = libm::sincos(z);
        straight(stretch)([(radius + x) * cos, y, (radius + x) * sin])
    };
    // The ring begins at z_graz rather than 0, which only turns it: equal stretches of the first and
    // third axis preserve lengths.
    assert_eq!(stretch[0], stretch[2]);
    check_lengths(&three.curves, ring);
    // Upwards on the page is upwards in velocity: the viewer is upright.
    let (seen, at) = (sights(&nine.surfaces), states(&nine.surfaces));
    let kinds = words(&nine.surfaces, "kind");
    let axis: Vec<usize> = (0..kinds.len()).filter(|&i| kinds[i] == "y_axis").collect();
    let (low, high) = (axis[0], axis[axis.len() - 1]);
    assert!(at[high][1] > at[low][1] && seen[high][1] > seen[low][1]);
    assert!((seen[high][0] - seen[low][0]).abs() < 1e-12);
}

/// Asserts that distances on the page, including depth, equal distances in stretched space, between each
/// row and the first.
fn check_lengths<R: Row>(table: &[R], place: impl Fn(Point) -> Point) {
    let (at, seen) = (states(table), sights(table));
    for row in 1..at.len() {
        let (true_length, length) = (distance(place(at[0]), place(at[row])), distance(seen[0], seen[row]));
        // A dozen roundings of numbers below ten.
        assert!((true_length - length).abs() < 1e-13, "{true_length} {length}");
    }
}

#[test]
fn pieces_of_a_curve_join_and_each_lies_on_one_side_of_both_planes() {
    let (_, study) = study();
    let made = study.shown::<Figure9>().expect("figure 9");
    let table = &made.curves;
    let (number, piece, layer) =
        (integers(table, "number"), integers(table, "piece"), integers(table, "layer"));
    let (kinds, at) = (words(table, "kind"), states(table));
    let mut changes = 0;
    for row in 1..at.len() {
        if number[row] == number[row - 1] && piece[row] != piece[row - 1] {
            assert_eq!(at[row], at[row - 1], "pieces join");
            assert_ne!(layer[row], layer[row - 1]);
            changes += 1;
        }
    }
    assert!(changes > 0, "a curve passes through a surface");
    for row in (0..at.len()).filter(|&row| kinds[row] != "global" && kinds[row] != "reset") {
        let [x, y, _] = at[row];
        // Seen from x < 0 and y > 0, layers 0 to 2 are beyond the wall, and layer 0 of them below Π.
        assert!(x.abs() < 1e-12 || (layer[row] < 3) == (x > 0.0), "row {row}");
        assert!(y.abs() < 1e-12 || (layer[row] % 4 == 0) == (y < 0.0), "row {row}");
    }
}

#[test]
fn an_orbit_that_would_meet_the_wall_earlier_and_a_point_that_is_no_maximum_are_refused() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures/parameters.toml");
    let text = std::fs::read_to_string(file).expect("the default parameters are there");
    let edited = |text: &str, section: &str, key: &str, value: &str| {
        let table = text.find(&format!("\n{section}\n")).expect("the table is there");
        let start = table + text[table..].find(&format!("\n{key} = ")).expect("the key is there") + 1;
        let end = start + text[start..].find('\n').expect("the line ends");
        format!("{}{key} = {value}{}", &text[..start], &text[end..])
    };
    let parsed =
        |text: &str| parameters::parse(&Text::new(text, &[]), "edited").expect("the values are valid");
    // Followed back for this long, the orbit has been beyond the wall.
    let early = parsed(&edited(&text, "[[fig01.orbits]]", "before", "2.5"));
    let error = Study::new(&early).shown::<Figure1>().expect_err("the wall is met before");
    assert!(error.to_string().starts_with("figure 1: the orbit through"), "{error}");
    // This far from the wall the spring pulls the oscillator back: x has a minimum.
    let wide = edited(&text, "[fig03]", "position", "[-3.0, 0.4]");
    assert!(Study::new(&parsed(&wide)).shown::<Figure3>().is_ok());
    let low = parsed(&edited(&wide, "[fig03]", "start", "[-1.9, 0.0]"));
    let error = Study::new(&low).shown::<Figure3>().expect_err("a minimum of x");
    assert!(error.to_string().contains("only a maximum"), "{error}");
}
