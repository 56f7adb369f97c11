//! The example files load, and are the oscillators that they describe.

use std::f64::consts::TAU;
use std::fs;
use std::path::{Path, PathBuf};

use grazing_input::{Description, MOST_VALUES_ON_STACK, WallSide};
use grazing_model::smooth::{Integrated, SmoothOscillator};
use grazing_model::{ImpactOscillator, LinearOscillator, OnWall, State};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

pub(crate) fn files() -> Vec<PathBuf> {
    let entries = fs::read_dir(folder()).expect("examples/ can be read");
    let paths = entries.map(|entry| entry.expect("examples/ can be read").path());
    paths.filter(|path| path.extension().is_some_and(|extension| extension == "toml")).collect()
}

fn example(name: &str) -> Description {
    Description::from_file(&folder().join(name)).unwrap_or_else(|error| panic!("{error}"))
}

fn constant(description: &Description, name: &str) -> f64 {
    description.constants().find(|(known, _)| *known == name).unwrap_or_else(|| panic!("{name}")).1
}

#[test]
fn every_example_loads_and_is_evaluated_without_allocation() {
    let mut examples = 0;
    for path in files() {
        let text = fs::read_to_string(&path).expect("an example is text");
        assert!(text.starts_with("# "), "{}: says where it comes from", path.display());
        let description = Description::from_file(&path).unwrap_or_else(|error| panic!("{error}"));
        assert!(description.notes().is_empty(), "{}: {:?}", path.display(), description.notes());
        for expression in description.formulas() {
            assert!(
                expression.instructions() <= MOST_VALUES_ON_STACK,
                "{}: {}",
                path.display(),
                expression.instructions()
            );
        }
        examples += 1;
    }
    assert!(examples >= 14);
}

#[test]
fn the_force_at_one_time_is_the_force() {
    for path in files() {
        let description = Description::from_file(&path).unwrap_or_else(|error| panic!("{error}"));
        let units = description.units();
        let [mu, eta] = [description.primary(), description.secondary()].map(|axis| {
            let [lower, upper] = axis.range();
            0.5 * (lower + upper)
        });
        for t in [0.0, 0.7, 5.1].map(|t| t * units.time) {
            let mut force = description.force_at(t, mu, eta);
            for [x, v] in [[-0.4, 0.7], [0.0, 0.0], [-1.1, -0.3]] {
                let [x, v] = [x * units.length, v * units.velocity()];
                // The instructions are the same in another order.
                assert_eq!(force(x, v), description.force(x, v, t, mu, eta), "{}", path.display());
            }
        }
    }
}

#[test]
fn the_flow_of_the_papers_oscillator_and_its_derivatives_are_those_of_the_closed_form() {
    let description = example("paper.toml");
    let parameters = [0.31, 0.83];
    let [zeta, epsilon] = ["zeta", "epsilon"].map(|name| constant(&description, name));
    let closed =
        LinearOscillator::new(zeta, epsilon, parameters[0], parameters[1]).expect("valid parameters");
    let written = Integrated::new(description, parameters);
    let from = State { position: -0.4, velocity: 0.7, phase: 1.1 };
    for duration in [0.3, 2.9, 7.8] {
        let [a, b] = [written.flow::<2>(from, duration), closed.flow::<2>(from, duration)];
        // The integrator's tolerance, magnified by differentiating along a period.
        assert!((a.value - b.value).amax() < 1e-11);
        assert!((a.jacobian - b.jacobian).amax() < 1e-10);
        for i in 0..2 {
            assert!((a.hessians[i] - b.hessians[i]).amax() < 1e-9 * (1.0 + b.hessians[i].amax()));
        }
    }
    let [a, b] = [written.reset::<2>(OnWall::new(0.7, 1.1)), closed.reset::<2>(OnWall::new(0.7, 1.1))];
    // Both are one product.
    assert!((a.value - b.value).amax() < 1e-15);
    assert!((a.jacobian - b.jacobian).amax() < 1e-15);
}

#[test]
fn the_forces_of_the_examples_are_those_of_their_comments() {
    let [duffing, fluid] = ["duffing.toml", "quadratic-damping.toml"].map(example);
    let [kappa, stiff] = ["kappa", "zeta"].map(|name| constant(&duffing, name));
    let [delta, s, zeta] = ["delta", "s", "zeta"].map(|name| constant(&fluid, name));
    for i in 0..50 {
        let i = f64::from(i);
        let [x, v, t] = [-(i * 0.618) % 1.5, (i * 0.414) % 2.0 - 1.0, i * 0.73];
        let linear = -x - 1.0 + 0.6 * libm::cos(0.8 * t);
        let wanted = linear - 2.0 * stiff * v - kappa * x * x * x;
        // A few roundings of numbers of the order of one; the same below.
        assert!((duffing.force(x, v, t, 0.6, 0.8) - wanted).abs() < 1e-14);
        let wanted = linear - 2.0 * zeta * v - delta * v * (v * v + s * s).sqrt();
        assert!((fluid.force(x, v, t, 0.6, 0.8) - wanted).abs() < 1e-14);
    }
}

/// Fails unless the force of the example, seen from its wall, is this acceleration of x at fifty
/// states near rest; `wanted` receives x, v, t and both parameters.
fn assert_force(name: &str, wanted: impl Fn(&dyn Fn(&str) -> f64, [f64; 5]) -> f64) {
    let description = example(name);
    let (units, sign) =
        (description.units(), if description.wall().side() == WallSide::Above { -1.0 } else { 1.0 });
    let axes = [description.primary(), description.secondary()];
    for i in 0..50 {
        let i = f64::from(i);
        let [mu, eta] = axes.map(|axis| {
            let [lower, upper] = axis.range();
            lower + (upper - lower) * (0.1 + (i * 0.377) % 0.8)
        });
        let [u, velocity, t] = [-(i * 0.618) % 1.0, (i * 0.414) % 2.0 - 1.0, i * 0.73];
        let [u, velocity, t] = [u * units.length, velocity * units.velocity(), t * units.time];
        let [x, v] = description.wall().outside([u, velocity], t, [mu, eta]);
        let wanted = sign * wanted(&|name| constant(&description, name), [x, v, t, mu, eta]);
        let difference = (description.force(u, velocity, t, mu, eta) - wanted).abs();
        // A few roundings of numbers of this order.
        assert!(
            difference < 1e-13 * (units.acceleration() + wanted.abs()),
            "{name}: {difference:e} of {wanted:e}"
        );
    }
}

#[test]
fn the_forces_of_the_rigs_are_those_of_their_comments() {
    assert_force("pendulum.toml", |c, [x, v, t, torque, omega]| {
        -2.0 * c("zeta") * v - libm::sin(x) + torque * libm::cos(omega * t)
    });
    assert_force("harvester.toml", |c, [x, v, t, base, f]| {
        let away = x / c("d");
        let coupling = c("theta") / (1.0 + away * away);
        let damping = c("c") + coupling * coupling / c("R");
        -(damping * v + c("k") * x) / c("m") + base * libm::cos(TAU * f * t)
    });
    assert_force("drill.toml", |c, [x, v, t, crank, f]| {
        let column = c("L") + x - crank * libm::cos(TAU * f * t);
        let pressure = c("p") * (libm::pow(c("L") / column, 1.4) - 1.0);
        (pressure * c("S") - c("c") * v) / c("m")
    });
    assert_force("afm.toml", |c, [x, v, t, drive, f]| {
        let natural = TAU * c("f0");
        let mass = c("k") / (natural * natural);
        let attraction = c("H") * c("R") / (6.0 * x * x);
        let spring = c("k") * (c("Z") - x) - mass * natural / c("Q") * v;
        (spring - attraction + drive * libm::cos(TAU * f * t)) / mass
    });
    assert_force("parametric.toml", |c, [x, v, t, change, omega]| {
        -2.0 * c("zeta") * v - x - change * x * libm::cos(omega * t) - 1.0
    });
}

#[test]
fn derivatives_of_a_varying_reset_law_are_its_difference_quotients() {
    let description = example("varying-impact.toml");
    let [mu, eta] = [0.4, 0.7];
    let oscillator = Integrated::new(description.clone(), [mu, eta]);
    let (y, z) = (0.6, 2.1);
    let jet = oscillator.reset::<2>(OnWall::new(y, z));
    let h = 1e-5;
    let at = |y, eta| oscillator.with_parameters([mu, eta]).reset::<1>(OnWall::new(y, z));
    let by_velocity = (at(y + h, eta).value - at(y - h, eta).value) / (2.0 * h);
    let by_frequency = (at(y, eta + h).value - at(y, eta - h).value) / (2.0 * h);
    let twice = (at(y + h, eta).jacobian - at(y - h, eta).jacobian) / (2.0 * h);
    // Central differences: h^2 for the truncation, 1e-16/h for the rounding.
    for i in 0..2 {
        assert!((jet.jacobian[(i, 0)] - by_velocity[i]).abs() < 1e-9);
        assert!((jet.jacobian[(i, 3)] - by_frequency[i]).abs() < 1e-9);
        assert!((jet.hessians[i][(0, 0)] - twice[(i, 0)]).abs() < 1e-9);
        assert!((jet.hessians[i][(0, 3)] - twice[(i, 3)]).abs() < 1e-9);
    }
    let [epsilon, softening, contact] =
        ["epsilon", "softening", "contact"].map(|name| constant(&description, name));
    // One exponential, one quotient.
    assert!((jet.value[0] + y * epsilon * libm::exp(-softening * y)).abs() < 1e-15);
    assert!((jet.value[1] - (z + y * eta * contact / (1.0 + y))).abs() < 1e-15);
}

#[test]
fn the_page_about_the_file_lists_all_keys() {
    let page = folder().join("../docs/oscillator-file.md");
    let page = fs::read_to_string(page).expect("docs/oscillator-file.md can be read");
    for key in Description::requirements().keys() {
        let line = format!("| `{}` | {} | {} |\n", key.path, key.meaning, key.requirement);
        assert!(page.contains(&line), "{line}");
    }
}
