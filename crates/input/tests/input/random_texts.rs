//! Random texts are read correctly.

use grazing_input::Expression;
use proptest::prelude::*;

const VARIABLES: [&str; 3] = ["x", "v", "t"];

fn leaf() -> impl Strategy<Value = String> {
    prop_oneof![
        prop::sample::select(&VARIABLES[..]).prop_map(str::to_owned),
        prop::sample::select(&["pi", "e", "kappa"][..]).prop_map(str::to_owned),
        (0u32..9).prop_map(|n| n.to_string()),
        (1e-9f64..1e9).prop_map(|x| format!("{x:?}")),
    ]
}

fn expression() -> impl Strategy<Value = String> {
    leaf().prop_recursive(5, 40, 2, |inner| {
        let function = prop::sample::select(
            &["sin", "cos", "tan", "atan", "tanh", "sinh", "cosh", "exp", "ln", "sqrt"][..],
        );
        let operator = prop::sample::select(&["+", "-", "*", "/", " ^ ", " - -", "/-"][..]);
        prop_oneof![
            (inner.clone(), operator, inner.clone()).prop_map(|(a, o, b)| format!("{a}{o}{b}")),
            inner.clone().prop_map(|a| format!("({a})")),
            inner.clone().prop_map(|a| format!("-{a}")),
            (inner.clone(), -4i32..5).prop_map(|(a, n)| format!("({a})^{n}")),
            (function, inner).prop_map(|(name, a)| format!("{name}({a})")),
        ]
    })
}

proptest! {
    #[test]
    fn nothing_but_its_constants_can_be_wrong_with_an_expression(text in expression()) {
        if let Err(error) = Expression::parse(&text, &VARIABLES, &[("kappa", 0.1)]) {
            let outside = ["division by zero", "has no real value", "is too large"];
            prop_assert!(outside.iter().any(|told| error.problem.contains(told)), "{}: {}", text, error);
        }
    }

    #[test]
    fn no_text_at_all_brings_the_reader_down(text in "[-a-z0-9+*/^()., %!<=?:&|é\\n]{0,40}") {
        if let Err(error) = Expression::parse(&text, &VARIABLES, &[]) {
            prop_assert!(text.get(error.span.clone()).is_some(), "{:?} of {:?}", error.span, text);
        }
    }
}

/// A polynomial of two variables; few leaves, so that parts are often equal.
#[derive(Clone, Debug)]
enum Tree {
    Leaf(&'static str),
    Negated(Box<Tree>),
    Both(Box<Tree>, char, Box<Tree>),
}

impl Tree {
    fn text(&self) -> String {
        match self {
            Tree::Leaf(name) => (*name).to_owned(),
            Tree::Negated(a) => format!("(-{})", a.text()),
            Tree::Both(a, operator, b) => format!("({}{operator}{})", a.text(), b.text()),
        }
    }

    /// The value; NaN where a part is too large to be exact.
    fn value(&self, x: f64, v: f64) -> f64 {
        let value = match self {
            Tree::Leaf("x") => x,
            Tree::Leaf("v") => v,
            Tree::Leaf(number) => number.parse().expect("a number"),
            Tree::Negated(a) => -a.value(x, v),
            Tree::Both(a, '+', b) => a.value(x, v) + b.value(x, v),
            Tree::Both(a, '-', b) => a.value(x, v) - b.value(x, v),
            Tree::Both(a, _, b) => a.value(x, v) * b.value(x, v),
        };
        if value.abs() < 1e12 { value } else { f64::NAN }
    }
}

fn tree() -> impl Strategy<Value = Tree> {
    let leaf = prop::sample::select(&["x", "v", "2", "0", "1"][..]).prop_map(Tree::Leaf);
    leaf.prop_recursive(6, 60, 2, |inner| {
        prop_oneof![
            1 => inner.clone().prop_map(|a| Tree::Negated(Box::new(a))),
            6 => (inner.clone(), prop::sample::select(&['+', '-', '*'][..]), inner)
                .prop_map(|(a, operator, b)| Tree::Both(Box::new(a), operator, Box::new(b))),
        ]
    })
}

proptest! {
    #[test]
    fn shared_parts_and_sums_do_not_change_the_value(tree in tree()) {
        let text = tree.text();
        let expression = Expression::parse(&text, &VARIABLES, &[]).expect("a polynomial is right");
        // Sums and products of whole numbers far below 2^53 are exact in any order.
        for (x, v) in [(1.0, -1.0), (2.0, 1.0), (-1.0, 2.0)] {
            let (got, wanted) = (expression.evaluate(&[x, v, 0.0]), tree.value(x, v));
            if !wanted.is_nan() {
                prop_assert_eq!(got, wanted, "{}", text);
            }
        }
    }
}
