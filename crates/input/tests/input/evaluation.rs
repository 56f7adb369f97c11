//! Values of expressions, compared with the same formulas in Rust.

use grazing_input::{Expression, MOST_VALUES_ON_STACK};

/// Points that are not related by any symmetry; positive, for roots and logarithms.
fn points() -> impl Iterator<Item = [f64; 3]> {
    (0..200).map(|i| {
        let i = f64::from(i);
        [0.1 + (i * 0.618_034) % 1.7, 0.2 + (i * 0.414_214) % 2.3, 0.05 + (i * 0.732_051) % 1.1]
    })
}

fn parse(text: &str) -> Expression {
    Expression::parse(text, &["x", "v", "t"], &[("kappa", 0.1), ("zeta", 0.03)])
        .unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn value(text: &str) -> f64 {
    parse(text).evaluate(&[0.0, 0.0, 0.0])
}

/// Tolerance: folding and sharing reorder a few rounded operations, and powers of series are not
/// those of `pow`; each operation costs half a unit in the last place, and these formulas have less
/// than twenty.
const ROUNDING: f64 = 20.0 * f64::EPSILON;

#[test]
fn expressions_evaluate_as_the_same_formulas_in_rust() {
    type Formula = fn(f64, f64, f64) -> f64;
    let formulas: &[(&str, Formula)] = &[
        ("-2*zeta*v - x - kappa*x^3 - 1 + 0.7*cos(1.3*t)", |x, v, t| {
            -0.06 * v - x - 0.1 * x * x * x - 1.0 + 0.7 * libm::cos(1.3 * t)
        }),
        ("v*sqrt(v^2 + 0.05^2)", |_, v, _| v * (v * v + 0.0025).sqrt()),
        ("sin(x) + cos(x)*tan(v/3)", |x, v, _| libm::sin(x) + libm::cos(x) * libm::tan(v / 3.0)),
        ("tanh(x)*atan(v) - exp(-t)", |x, v, t| libm::tanh(x) * libm::atan(v) - libm::exp(-t)),
        ("sinh(x) - cosh(x)", |x, _, _| libm::sinh(x) - libm::cosh(x)),
        ("sinh(1e-9*x)", |x, _, _| libm::sinh(1e-9 * x)),
        ("ln(x)/v + v/x", |x, v, _| libm::log(x) / v + v / x),
        ("x^2.5 + v^x + 2^t + e^t", |x, v, t| {
            libm::pow(x, 2.5) + libm::pow(v, x) + libm::pow(2.0, t) + libm::exp(t)
        }),
        ("x^-2 + v^0.5 + t^7", |x, v, t| 1.0 / (x * x) + v.sqrt() + libm::pow(t, 7.0)),
        ("2*pi*x/(1 - 3*v)", |x, v, _| 2.0 * std::f64::consts::PI * x / (1.0 - 3.0 * v)),
        ("5 - x - (v - t)", |x, v, t| 5.0 - x - (v - t)),
        ("(x + v) + (x + v) - ((t - 1) - (t - 1))", |x, v, _| 2.0 * (x + v)),
        ("2*x - 2*x + (-v) - (-v) + 3*t", |_, _, t| 3.0 * t),
        ("(x - v)*(x - v + t)/(1 + (x - v)^2)", |x, v, t| (x - v) * (x - v + t) / (1.0 + (x - v) * (x - v))),
    ];
    for (text, formula) in formulas {
        let expression = parse(text);
        for [x, v, t] in points() {
            let (got, wanted) = (expression.evaluate(&[x, v, t]), formula(x, v, t));
            // Sums may cancel, but nothing in these formulas is much larger than ten.
            let scale = if text.contains("1e-9") { wanted.abs() } else { 10.0 + wanted.abs() };
            assert!((got - wanted).abs() <= ROUNDING * scale, "{text} at {x}, {v}, {t}: {got} != {wanted}");
        }
    }
}

#[test]
fn operators_bind_as_in_mathematics() {
    for (text, wanted) in [
        ("-3^2", -9.0),
        ("(-3)^2", 9.0),
        ("2^-1", 0.5),
        ("2^3^2", 512.0),
        ("24/4/2", 3.0),
        ("10 - 4 - 3", 3.0),
        ("2 - -3", 5.0),
        ("2*-3", -6.0),
        ("6/2*3", 9.0),
        ("1 + 2*3^2", 19.0),
        ("-2*3 + 1", -5.0),
        ("2**3", 8.0),
        ("1.5e1 + .5 + 2.", 17.5),
    ] {
        assert_eq!(value(text), wanted, "{text}");
    }
}

#[test]
fn signs_and_powers_of_variables_bind_as_those_of_numbers() {
    for (text, wanted) in [
        ("-x^2", -9.0),
        ("(-x)^2", 9.0),
        ("v^-1", 0.5),
        ("v^x^v", 512.0),
        ("t/v/v", 6.0),
        ("t - x - v", 19.0),
    ] {
        let got = parse(text).evaluate(&[3.0, 2.0, 24.0]);
        assert!((got - wanted).abs() <= ROUNDING * wanted.abs(), "{text}: {got}");
    }
}

#[test]
fn constants_are_folded_and_equal_parts_computed_once() {
    for (text, instructions) in [
        ("2*pi/3 + kappa^2", 1),
        ("x", 0),
        ("x + 0*v", 0),
        ("-2*zeta*v", 1),
        ("x^2", 1),
        ("x*x", 1),
        ("sin(x)*sin(x)", 2),
        ("sin(2*x + v) + sin(2*x + v)^2", 4),
        ("1 - 2*x + v/4 - (t + 3)", 2),
        ("5 - x", 1),
        ("2*x + 3*(2*x)", 2),
        ("(x + v)/(x + v + 1)", 3),
        ("x/4", 1),
    ] {
        assert_eq!(parse(text).instructions(), instructions, "{text}");
    }
}

#[test]
fn powers_beyond_the_third_are_right_for_negative_bases() {
    for exponent in [-5, -2, 3, 4, 9, 16, 31] {
        let expression = parse(&format!("x^{exponent}"));
        for x in [-1.7, -0.6, 0.9, 1.3] {
            let wanted = libm::pow(x, f64::from(exponent));
            let got = expression.evaluate(&[x, 0.0, 0.0]);
            // Squaring doubles the relative error, so that it grows with the exponent.
            assert!(
                (got - wanted).abs() <= 40.0 * f64::EPSILON * wanted.abs(),
                "{x}^{exponent}: {got} != {wanted}"
            );
        }
    }
}

#[test]
fn long_and_deep_expressions_are_right_as_well() {
    fn tree(depth: u32, leaf: &mut u32) -> String {
        if depth == 0 {
            *leaf += 1;
            return format!("sin({leaf}*x)");
        }
        format!("({} - {})", tree(depth - 1, leaf), tree(depth - 1, leaf))
    }
    for depth in [2, 4, 9] {
        let expression = parse(&tree(depth, &mut 0));
        let wanted: f64 = (0..1_u32 << depth)
            .map(|leaf| {
                let sign = if leaf.count_ones() % 2 == 0 { 1.0 } else { -1.0 };
                sign * libm::sin(f64::from(leaf + 1) * 0.3)
            })
            .sum();
        let got = expression.evaluate(&[0.3, 0.0, 0.0]);
        // At most 512 terms below one.
        assert!((got - wanted).abs() <= 512.0 * f64::EPSILON, "{depth}: {got} != {wanted}");
    }
    let long = (1..=200).map(|i| format!("{i}*sin({i}*x)")).collect::<Vec<_>>().join(" + ");
    let expression = parse(&long);
    assert!(expression.instructions() > MOST_VALUES_ON_STACK);
    let wanted: f64 = (1..=200).map(|i| f64::from(i) * libm::sin(f64::from(i) * 0.3)).sum();
    let got = expression.evaluate(&[0.3, 0.0, 0.0]);
    // 200 terms of up to 200, whose sum is smaller than ten thousand.
    assert!((got - wanted).abs() <= 1e4 * 200.0 * f64::EPSILON, "{got} != {wanted}");
    let count = 37;
    let sum = |sign: &str| (1..=count).map(|i| format!("sin({i}*x)")).collect::<Vec<_>>().join(sign);
    let expression = parse(&format!("({})*({})", sum(" + "), sum(" - ")));
    let terms: Vec<f64> = (1..=count).map(|i| libm::sin(i as f64 * 0.3)).collect();
    let plus: f64 = terms.iter().sum();
    let minus = 2.0 * terms[0] - plus;
    let got = expression.evaluate(&[0.3, 0.0, 0.0]);
    // Products of sums of 37 terms below one.
    assert!((got - plus * minus).abs() <= 1e3 * f64::EPSILON, "{got}");
}
