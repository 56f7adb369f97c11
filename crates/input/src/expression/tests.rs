//! Comparison of the tape with its expression, node by node, over several number types.

use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::Arc;

use grazing_model::smooth::{Function, Partials, Scalar, Stop, Taylor, partial};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use super::graph::{Graph, Node};
use super::partials::ForceDerivatives;
use super::{Expression, parse};

/// The interval of all numbers from the first to the second.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Range(f64, f64);

impl Range {
    fn around(values: [f64; 4]) -> Self {
        Self(
            values.into_iter().fold(f64::INFINITY, f64::min),
            values.into_iter().fold(-f64::INFINITY, f64::max),
        )
    }
}

macro_rules! operations {
    ($($trait:ident, $name:ident, |$a:ident, $b:ident| $result:expr;)*) => {$(
        impl $trait for Range {
            type Output = Self;

            fn $name(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                $result
            }
        }

        impl $trait<f64> for Range {
            type Output = Self;

            fn $name(self, other: f64) -> Self {
                $trait::$name(self, Self::constant(other))
            }
        }
    )*};
}

operations! {
    Add, add, |a, b| Range(a.0 + b.0, a.1 + b.1);
    Sub, sub, |a, b| Range(a.0 - b.1, a.1 - b.0);
    Mul, mul, |a, b| Range::around([a.0 * b.0, a.0 * b.1, a.1 * b.0, a.1 * b.1]);
    Div, div, |a, b| Range::around([a.0 / b.0, a.0 / b.1, a.1 / b.0, a.1 / b.1]);
}

impl Neg for Range {
    type Output = Self;

    fn neg(self) -> Self {
        Range(-self.1, -self.0)
    }
}

impl Scalar for Range {
    fn constant(value: f64) -> Self {
        Range(value, value)
    }

    fn apply(self, function: Function) -> Self {
        Range(self.0.apply(function), self.1.apply(function))
    }
}

/// A polynomial of x, v and t with small whole numbers; parts are often equal.
fn polynomial() -> impl Strategy<Value = String> {
    let leaf = prop::sample::select(&["x", "v", "t", "2", "3"][..]).prop_map(str::to_owned);
    leaf.prop_recursive(5, 40, 2, |inner| {
        let operator = prop::sample::select(&["+", "-", "*"][..]);
        prop_oneof![
            1 => inner.clone().prop_map(|a| format!("(-{a})")),
            1 => inner.clone().prop_map(|a| format!("{a}^3")),
            6 => (inner.clone(), operator, inner).prop_map(|(a, o, b)| format!("({a}{o}{b})")),
        ]
    })
}

/// A polynomial expression with functions and quotients.
fn formula() -> impl Strategy<Value = String> {
    (
        polynomial(),
        polynomial(),
        prop::sample::select(&["sin", "cos", "tan", "tanh", "exp", "atan", "ln", "sqrt"][..]),
    )
        .prop_map(|(a, b, name)| format!("({a})*{name}({b}) - ({b})/(1 + t^2) + {name}(2*t)*x - {name}(v)"))
}

const NAMES: [&str; 3] = ["x", "v", "t"];

/// The expression; `None` where the text applies a function to a constant outside its domain.
fn read(text: &str, moving: usize) -> Option<Expression> {
    parse::expression(text, &NAMES, moving, &[], &Stop::default()).ok().map(|(expression, _)| expression)
}

/// The value computed node by node.
fn plain<S: Scalar>(text: &str, variables: &[S]) -> S {
    let graph = Graph::default();
    let (term, _) = parse::term(text, &parse::numbered(&graph, &NAMES), &[], &Stop::default())
        .expect("the expression was read");
    let (nodes, _) = graph.parts(&[term]);
    let mut values: Vec<S> = Vec::new();
    for node in &nodes {
        values.push(match node {
            Node::Variable(number) => variables[*number],
            Node::Operation(operation) => {
                let mut value = S::constant(0.0);
                operation.compute(&mut value, |place| &values[place]);
                value
            }
        });
    }
    *values.last().expect("an expression has a part")
}

/// The values at the first point with none, some and all of the variables held, computed after
/// those at the second.
fn all_ways<S: Scalar>(text: &str, [first, second]: [[S; 3]; 2]) -> Vec<S> {
    let held = (0..=3).filter_map(|moving| {
        let expression = read(text, moving)?;
        let mut function = expression.hold(&first[moving..]);
        let [first, second] = [&first, &second].map(|values| values.each_ref());
        // Results for other values must be discarded.
        function(&second[..moving]);
        Some(function(&first[..moving]))
    });
    held.collect()
}

fn bits<const N: usize>(values: [f64; N]) -> [u64; N] {
    // All NaNs count as equal.
    values.map(|value| if value.is_nan() { 0 } else { value.to_bits() })
}

/// Whether all values are whole numbers far below 2^53, which are exact in any order.
fn exact(values: &[f64]) -> bool {
    values.iter().all(|value| value.abs() < 1e12)
}

proptest! {
    #[test]
    fn variables_that_are_held_change_no_bit(text in formula()) {
        let Some(whole) = read(&text, 3) else { return Ok(()) };
        let numbers = [0.7, -0.4, 1.9];
        for value in all_ways(&text, [numbers, [1.1, 0.2, 0.3]]) {
            prop_assert_eq!(bits([value]), bits([whole.evaluate(&numbers)]), "{}", text);
        }
        let series = [[0.7, 1.0, 0.2, 0.0], [-0.4, 0.3, 0.0, -0.1], [1.9, -2.0, 0.5, 0.3]].map(Taylor::new);
        for value in all_ways(&text, [series, [Taylor::constant(1.1); 3]]) {
            let wanted = whole.evaluate(&series).coefficients();
            prop_assert_eq!(bits(value.coefficients()), bits(wanted), "{}", text);
        }
        let ranges = [Range(0.7, 0.9), Range(-0.4, 0.3), Range(1.9, 2.0)];
        for Range(a, b) in all_ways(&text, [ranges, [Range(1.1, 1.2); 3]]) {
            let wanted = whole.evaluate(&ranges);
            prop_assert_eq!(bits([a, b]), bits([wanted.0, wanted.1]), "{}", text);
        }
    }

    #[test]
    fn the_tape_gives_what_its_nodes_give(text in polynomial()) {
        let Some(expression) = read(&text, 3) else { return Ok(()) };
        let numbers = [1.0, -2.0, 3.0];
        let series = [[1.0, 2.0, -1.0, 0.0], [-2.0, 1.0, 1.0, 3.0], [3.0, -1.0, 0.0, 1.0]].map(Taylor::new);
        let ranges = [Range(1.0, 2.0), Range(-2.0, 1.0), Range(3.0, 3.0)];
        let (a, b, c) = (plain(&text, &numbers), plain(&text, &series), plain(&text, &ranges));
        if exact(&[a]) {
            prop_assert_eq!(expression.evaluate(&numbers), a, "{}", text);
        }
        if exact(&b.coefficients()) {
            prop_assert_eq!(expression.evaluate(&series), b, "{}", text);
        }
        if exact(&[c.0, c.1]) {
            prop_assert_eq!(expression.evaluate(&ranges), c, "{}", text);
        }
    }

    #[test]
    fn derivatives_are_those_of_automatic_differentiation(text in formula()) {
        let graph = Graph::default();
        let Ok((term, _)) = parse::term(&text, &parse::numbered(&graph, &NAMES), &[], &Stop::default()) else { return Ok(()) };
        for variable in 0..3 {
            let Ok(slope) = graph.derivative(term, variable, &Stop::default()) else { return Ok(()) };
            let [value, slope] = [term, slope].map(|term| parse::assembled(&graph, term, &NAMES, 3));
            let at = [0.7, 0.4, 1.9];
            let mut moving = at.map(Taylor::constant);
            moving[variable] = Taylor::new([at[variable], 1.0, 0.0, 0.0]);
            let [size, wanted, ..] = value.evaluate(&moving).coefficients();
            let found = slope.evaluate(&at);
            let gap = (found - wanted).abs();
            prop_assert!(!(size + wanted).is_finite() || gap <= 1e-9 * (1.0 + size.abs() + wanted.abs()), "{}: {} {}", text, found, wanted);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, rng_seed: RngSeed::Fixed(5), ..ProptestConfig::default() })]

    #[test]
    fn formulas_of_derivatives_are_those_of_automatic_differentiation(text in formula()) {
        let at = [0.7, 0.4, 1.9, -0.6, 1.2];
        for names in [["x", "v", "t", "a", "b"], ["a", "t", "b", "x", "v"]] {
            let graph = Graph::default();
            let variables = parse::numbered(&graph, &names);
            let Ok((term, _)) = parse::term(&text, &variables, &[], &Stop::default()) else { return Ok(()) };
            let mut force = parse::assembled(&graph, term, &names, 2);
            let Some(formulas) = ForceDerivatives::of(&graph, term, &force, &names, &Stop::default()) else { return Ok(()) };
            force.1 = Some(Arc::new(formulas));
            let close = |found: f64, wanted: f64, size: f64| {
                !(size + wanted).is_finite() || (found - wanted).abs() <= 1e-9 * (1.0 + size.abs() + wanted.abs())
            };
            let mut known = Partials::zero();
            prop_assert!(force.partials(&at, true, &mut known));
            let mut slopes = force.hold_slopes(&at[2..]).expect("there are formulas");
            let [value, ..] = slopes(&[&at[0], &at[1]], false);
            prop_assert!(close(value, known.0[partial(&[])], 0.0), "{}: {}", text, value);
            let slopes = slopes(&[&at[0], &at[1]], true);
            for (slope, of) in slopes.into_iter().zip([&[][..], &[0], &[1]]) {
                prop_assert!(close(slope, known.0[partial(of)], 0.0), "{}: {:?} {}", text, of, slope);
            }
            for a in 0..5 {
                for b in a..5 {
                    let mut moving = at.map(Taylor::constant);
                    moving[a] = Taylor::new([at[a], 1.0, 0.0, 0.0]);
                    moving[b] = Taylor::new([at[b], 1.0, 0.0, 0.0]);
                    let [size, first, second, _] = force.evaluate(&moving).coefficients();
                    let of = |arguments: &[usize]| known.0[partial(arguments)];
                    // Parts of a sum may cancel each other.
                    let (slopes, bends) = match a == b {
                        true => ([of(&[a]), 0.0], [0.5 * of(&[a, a]), 0.0, 0.0]),
                        false => ([of(&[a]), of(&[b])], [0.5 * of(&[a, a]), 0.5 * of(&[b, b]), of(&[a, b])]),
                    };
                    let largest = |parts: &[f64]| parts.iter().fold(size.abs(), |most, part| most.max(part.abs()));
                    let (slope, bend) = (slopes.iter().sum(), bends.iter().sum());
                    prop_assert!(close(slope, first, largest(&slopes)), "{}: {} {} {}", text, a, slope, first);
                    prop_assert!(close(bend, second, largest(&bends)), "{}: {} {} {} {}", text, a, b, bend, second);
                }
            }
        }
    }
}

#[test]
fn neither_texts_nor_derivatives_are_gone_through_once_an_end_is_asked_for() {
    let (graph, asked) = (Graph::default(), Stop::default());
    let variables = parse::numbered(&graph, &NAMES);
    let read = |stop: &Stop| parse::term("x + x*cos(t)", &variables, &[], stop);
    let (term, _) = read(&asked).expect("it is right");
    assert!(graph.derivative(term, 2, &asked).is_ok());
    asked.ask();
    assert!(read(&asked).is_err() && graph.derivative(term, 2, &asked).is_err());
}
