//! Third derivatives of oscillators from files: the expressions over Taylor polynomials.

use std::path::Path;

use grazing_input::Description;
use grazing_model::smooth::{Integrated, Scalar, Taylor};
use grazing_model::{ImpactOscillator, LinearOscillator, OnWall, ThirdOrder};

fn example(name: &str) -> Description {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    Description::from_file(&path).unwrap_or_else(|error| panic!("{error}"))
}

/// Curves of (x₀, y₀, z₀) and of the duration, with generic coefficients of all orders.
fn curve() -> ([Taylor; 3], Taylor) {
    let state = [
        Taylor::new([-0.4, 0.3, 0.1, -0.2]),
        Taylor::new([0.7, -0.5, 0.4, 0.3]),
        Taylor::new([1.1, 0.7, -0.3, 0.1]),
    ];
    (state, Taylor::new([6.0, 0.4, 0.2, -0.5]))
}

#[test]
fn third_derivatives_of_the_papers_oscillator_are_those_of_the_closed_form() {
    let description = example("paper.toml");
    let constant = |name: &str| description.constants().find(|(known, _)| *known == name).unwrap().1;
    let parameters = [0.31, 0.83];
    let [zeta, epsilon] = ["zeta", "epsilon"].map(constant);
    let closed = LinearOscillator::new(zeta, epsilon, parameters[0], parameters[1]).unwrap();
    let written = Integrated::new(description.clone(), parameters);
    let (from, duration) = curve();
    let [a, b] = [written.flow_series(from, duration), closed.flow_series(from, duration)];
    for (a, b) in a.iter().zip(&b) {
        for (a, b) in a.coefficients().into_iter().zip(b.coefficients()) {
            // Same tolerance as for derivatives of the first two orders.
            assert!((a - b).abs() < 1e-12 * (1.0 + b.abs()), "{a} {b}");
        }
    }
    assert_eq!(
        written.reset_series(from[1], from[2]).map(|image| image.value()),
        closed.reset_series(from[1], from[2]).map(|image| image.value())
    );
}

/// An example in the middle of its parameters.
fn in_the_middle(name: &str) -> Integrated<Description> {
    let description = example(name);
    let parameters = [description.primary(), description.secondary()].map(|axis| {
        let [lower, upper] = axis.range();
        0.5 * (lower + upper)
    });
    Integrated::new(description, parameters)
}

#[test]
fn third_derivatives_of_the_flow_are_those_of_many_short_flights() {
    for name in ["duffing.toml", "quadratic-damping.toml", "varying-impact.toml"] {
        let oscillator = in_the_middle(name);
        let (from, duration) = curve();
        let whole = oscillator.flow_series(from, duration);
        let [mut x, mut y, mut z] = from;
        let part = duration.scale(0.01);
        for _ in 0..100 {
            [x, y] = oscillator.flow_series([x, y, z], part);
            z = z + part.scale(oscillator.forcing_frequency().value);
        }
        for (whole, parts) in whole.iter().zip([x, y]) {
            for (a, b) in whole.coefficients().into_iter().zip(parts.coefficients()) {
                // The drag bends within a velocity of 0.05: each order of derivatives is less
                // accurate than the one before.
                assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{name}: {a} {b}");
            }
        }
    }
}

#[test]
fn reset_law_along_a_curve_has_the_derivatives_that_it_has_in_all_directions() {
    let oscillator = in_the_middle("varying-impact.toml");
    let (point, q) = ([0.7, 1.1], [0.6, -0.8]);
    let along = |s: f64| oscillator.reset::<2>(OnWall::new(point[0] + s * q[0], point[1] + s * q[1]));
    let bend = |s: f64, i: usize| {
        let second = along(s).hessians[i];
        0.5 * (q[0] * q[0] * second[(0, 0)] + q[1] * q[1] * second[(1, 1)]) + q[0] * q[1] * second[(0, 1)]
    };
    let [y, z] = [0, 1].map(|i| Taylor::new([point[i], q[i], 0.0, 0.0]));
    let jet = along(0.0);
    for (i, image) in oscillator.reset_series(y, z).iter().enumerate() {
        let [value, first, second, third] = image.coefficients();
        // Roundings; for the third a central difference with h² = 1e-8 times derivatives of order
        // one.
        assert!((value - jet.value[i]).abs() < 1e-15);
        assert!((first - q[0] * jet.jacobian[(i, 0)] - q[1] * jet.jacobian[(i, 1)]).abs() < 1e-15);
        assert!((second - bend(0.0, i)).abs() < 1e-15);
        let h = 1e-4;
        assert!((third - (bend(h, i) - bend(-h, i)) / (6.0 * h)).abs() < 1e-8);
    }
}
