//! Tests that the parts of Figure 6 are where the equation of motion puts them, that the mechanism could
//! work, and that it is drawn to scale.

use core::f64::consts::TAU;

use grazing_beyond::parameters;
use grazing_drawing::ink::style::Paint;
use grazing_drawing::ink::svg::fill;
use grazing_drawing::{Element, SheetWidth};
use grazing_input::Text;
use grazing_reproduction::figures::fig06::{Figure6, PartPoint};
use grazing_reproduction::parameters::Parameters;
use grazing_reproduction::{Study, StudyFigure};

use super::{made, numbers, words};

fn figure(parameters: &Parameters) -> Vec<PartPoint> {
    Study::new(parameters).shown::<Figure6>().expect("figure 6 can be computed").parts.clone()
}

/// All points (x, height) of a part.
fn part(figure: &[PartPoint], name: &str) -> Vec<[f64; 2]> {
    let parts = words(figure, "part");
    let (x, height) = (numbers(figure, "x"), numbers(figure, "height"));
    let points: Vec<_> =
        (0..parts.len()).filter(|&row| parts[row] == name).map(|row| [x[row], height[row]]).collect();
    assert!(!points.is_empty(), "there is no {name}");
    points
}

/// Least and greatest x of a part.
fn span(figure: &[PartPoint], name: &str) -> [f64; 2] {
    let points = part(figure, name);
    let least = points.iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
    [least, points.iter().map(|point| point[0]).fold(f64::NEG_INFINITY, f64::max)]
}

/// The default parameters with another value of a key of Figure 6.
fn with(key: &str, value: &str) -> Parameters {
    let text = include_str!("../../../../../figures/parameters.toml");
    let (before, own) = text.split_once("[fig06]").expect("there is a Figure 6");
    let key = format!("{key} = ");
    let line = own.lines().find(|line| line.starts_with(&key)).expect("Figure 6 has the key");
    let own = own.replacen(line, &format!("{key}{value}"), 1);
    parameters::parse(&Text::new(&format!("{before}[fig06]{own}"), &[]), "p.toml").expect("it is valid")
}

fn at_phase(phase: f64) -> Parameters {
    with("phase", &format!("{phase:?}"))
}

/// Position and velocity after a time, from rest at the equilibrium, by the classical Runge–Kutta
/// method on eq:oscf.
fn integrated(zeta: f64, amplitude: f64, omega: f64, time: f64, steps: u32) -> [f64; 2] {
    let slope = |t: f64, [x, y]: [f64; 2]| [y, amplitude * libm::cos(omega * t) - 1.0 - x - 2.0 * zeta * y];
    let h = time / f64::from(steps);
    let mut state = [-1.0, 0.0];
    for step in 0..steps {
        let t = h * f64::from(step);
        let ahead = |by: f64, k: [f64; 2]| [state[0] + by * k[0], state[1] + by * k[1]];
        let k1 = slope(t, state);
        let k2 = slope(t + 0.5 * h, ahead(0.5 * h, k1));
        let k3 = slope(t + 0.5 * h, ahead(0.5 * h, k2));
        let k4 = slope(t + h, ahead(h, k3));
        state = [0, 1].map(|i| state[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
    }
    state
}

#[test]
fn the_face_is_where_the_equation_of_motion_takes_it_in_the_long_run() {
    let (parameters, shown) =
        (&made().parameters, made().parameters.section::<Figure6>().expect("it is right"));
    // With the wall ignored, until the free motion has decayed by exp(−ζt), about 1e-9.
    let time = (200.0 * TAU + shown.phase) / shown.frequency;
    let [x, _] = integrated(
        parameters.oscillator().expect("it is right").damping_ratio(),
        shown.amplitude,
        shown.frequency,
        time,
        100_000,
    );
    let face = span(&figure(parameters), "block")[1];
    // Steps of 0.01 leave an error of at most 1e-8 times the amplitude.
    assert!((x - face).abs() < 1e-8, "{x} {face}");
}

#[test]
fn wall_equilibrium_and_dimension_are_at_their_coordinates() {
    let figure = figure(&made().parameters);
    assert_eq!(span(&figure, "wall"), [0.0, 0.0]);
    assert_eq!(span(&figure, "dimension"), [-1.0, 0.0]);
    let face = span(&figure, "block")[1];
    let ticks: Vec<f64> = part(&figure, "tick").iter().map(|point| point[0]).collect();
    assert_eq!(ticks, [face, face, -1.0, -1.0, 0.0, 0.0]);
}

#[test]
fn parts_join_at_every_phase_and_nothing_runs_into_anything() {
    for step in 0..24 {
        let phase = TAU * f64::from(step) / 24.0;
        let parameters = at_phase(phase);
        let figure = figure(&parameters);
        let [anchor, block] = ["anchor", "block"].map(|name| span(&figure, name));
        for joined in ["spring", "rod"] {
            assert_eq!(span(&figure, joined), [anchor[0], block[0]], "{joined} at {phase}");
        }
        let [cylinder, piston] = ["cylinder", "piston"].map(|name| span(&figure, name));
        assert!(cylinder[0] < piston[0] && piston[1] < cylinder[1], "the piston leaves at {phase}");
        assert!(cylinder[1] < block[0], "the block runs into the cylinder at {phase}");
        assert!(anchor[1] < cylinder[0] && block[1] < 0.0);
        // The arrow is the force at this instant: its sign, and its length in units of that at phase 0.
        let force = part(&figure, "force");
        let full = part(&self::figure(&at_phase(0.0)), "force");
        let length = |arrow: &[[f64; 2]]| arrow[1][0] - arrow[0][0];
        assert!((length(&force) - libm::cos(phase) * length(&full)).abs() < 1e-15);
        assert!((force[0][0] - block[1]).abs() == 0.0, "the force acts on the block");
    }
}

#[test]
fn the_spring_has_as_many_coils_as_asked_for() {
    let points = part(&figure(&made().parameters), "spring");
    let tops = points.windows(3).filter(|w| w[0][1] < w[1][1] && w[1][1] > w[2][1]).count();
    assert_eq!(tops, made().parameters.section::<Figure6>().expect("it is right").coils as usize);
}

#[test]
fn the_spring_has_its_coils_between_its_ends_and_is_its_own_mirror_image() {
    for coils in [1, 9, 30] {
        let figure = figure(&with("coils", &coils.to_string()));
        let points = part(&figure, "spring");
        let ([anchor, _], [block, _]) = (span(&figure, "anchor"), span(&figure, "block"));
        let [first, last] = [points[0], points[points.len() - 1]];
        let height = first[1];
        assert_eq!((first, last), ([anchor, height], [block, height]));
        for ([x, h], [x_mirrored, h_mirrored]) in points.iter().zip(points.iter().rev()) {
            // Rounding of numbers of order 1.
            assert!((x + x_mirrored - anchor - block).abs() < 1e-14 && (h - h_mirrored).abs() < 1e-14);
        }
        let tops = points.windows(3).filter(|w| w[0][1] < w[1][1] && w[1][1] > w[2][1]).count();
        assert_eq!(tops, coils as usize);
        // The radius of the coils; the height is rounded once.
        assert!(points.iter().all(|[_, h]| (h - height).abs() <= 0.15 + 1e-15));
    }
}

#[test]
fn hatching_stays_in_its_strip_at_45_degrees() {
    let figure = figure(&made().parameters);
    let [anchor, _] = span(&figure, "anchor");
    // The strip behind the wall, and that behind the anchor, whose coordinates are larger by 4.
    for (name, [left, right], rounding) in
        [("wall hatching", [0.0, 0.2], 1e-15), ("anchor hatching", [anchor - 0.2, anchor], 4e-15)]
    {
        let points: Vec<&PartPoint> = figure.iter().filter(|point| point.part.name() == name).collect();
        let strokes: Vec<_> = points.chunk_by(|a, b| a.piece == b.piece).collect();
        assert!(strokes.len() > 15, "{}", strokes.len());
        for stroke in strokes {
            let [from, to] = stroke else { panic!("a stroke has two ends") };
            assert!(((to.x - from.x) - (to.height - from.height)).abs() < rounding);
            for PartPoint { x, height, .. } in [from, to] {
                let inside = (left - rounding..=right + rounding).contains(x);
                assert!(inside && (0.0..=1.45).contains(height), "{x} {height}");
            }
        }
    }
}

#[test]
fn everything_is_named_and_lengths_keep_their_ratio_across_and_up() {
    let shown = made().study.shown::<Figure6>().expect("figure 6 can be computed");
    let sheet = Figure6::draw(&shown, SheetWidth::Paper).unwrap();
    let svg = sheet.svg();
    for label in
        [">unit stiffness<", ">unit<", ">mass<", ">equilibrium<", "restitution ", "damping 2", ">−1<"]
    {
        assert!(svg.contains(label), "{label}");
    }
    const BODY: Paint = Paint::opaque([222, 228, 236]);
    let block = part(&shown.parts, "block");
    let body = sheet.elements.iter().find_map(|element| match element {
        Element::Path(path) if path.attributes.contains(&fill(BODY)) => Some(&path.pieces[0].0),
        _ => None,
    });
    let drawn: Vec<[f64; 2]> =
        body.expect("the block is drawn").iter().map(|&(x, y)| [x, y].map(f64::from)).collect();
    let extent = |points: &[[f64; 2]], axis: usize| {
        let along = || points.iter().map(|point| point[axis]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    let [across, up] = [0, 1].map(|axis| extent(&drawn, axis));
    let [wide, high] = [0, 1].map(|axis| extent(&block, axis));
    assert!(across > 3000.0 && up > 4000.0, "{across} {up}");
    // Coordinates are rounded to hundredths of a point, and extents are wrong by one at most.
    assert!((across * high - up * wide).abs() <= high + wide, "{across} {up}");
}
