//! The oscillators of requests: mistakes in their files, their units, views and constants.

use std::collections::BTreeMap;
use std::time::Duration;

use grazing_explore::{Export, Model, View, answer};
use grazing_input::Mistake;
use grazing_model::smooth::Stop;
use serde_json::{Value, json};

/// The answer to a request to check an oscillator.
fn checked(model: &Model) -> Value {
    let export: Export = Box::new(|_, what, _, _| panic!("{what} is not asked for"));
    let body = serde_json::to_vec(model).unwrap();
    let answer = answer("check", &body, (&|_| true, || Duration::ZERO), &export, &Stop::default());
    serde_json::from_slice(&answer.unwrap().1).unwrap()
}

fn example() -> String {
    include_str!("../../../../examples/duffing.toml").to_owned()
}

pub(crate) fn model(text: String) -> Model {
    Model { text: Some(text), set: BTreeMap::new(), loops: None }
}

#[test]
fn mistakes_are_marked_where_they_are() {
    let wrong = |text: String| -> Mistake {
        let answer = checked(&model(text));
        assert_eq!(answer["ok"], false, "{answer}");
        let [message, key, line, span] =
            ["message", "key", "line", "span"].map(|field| answer[field].clone());
        Mistake {
            message: serde_json::from_value(message).unwrap(),
            key: serde_json::from_value(key).unwrap(),
            line: serde_json::from_value(line).unwrap(),
            span: serde_json::from_value(span).unwrap(),
        }
    };
    let marked = |text: &str, wrong: &Mistake| {
        let line = text.lines().nth(wrong.line.unwrap() - 1).unwrap();
        let [from, to] = wrong.span.unwrap();
        line.chars().skip(from).take(to - from).collect::<String>()
    };
    let text = example().replace("kappa*x^3", "kapa*x^3");
    let found = wrong(text.clone());
    assert_eq!(marked(&text, &found), "kapa");
    assert!(found.message.starts_with("motion.force: unknown name kapa"), "{}", found.message);
    let text = example().replace("[motion]", "[motion");
    let found = wrong(text.clone());
    assert!(found.line.is_some() && found.span.is_some(), "{found:?}");
    let found = wrong(example().replace("zeta = 0.02", "zeta = \"a\""));
    assert!(found.line.is_some() && found.span.is_none() && found.message.starts_with("parameters.zeta"));
    assert_eq!(found.key.as_deref(), Some("parameters.zeta"));
}

#[test]
fn units_and_what_x_is_counted_from_are_told() {
    let told = |text: &str| checked(&model(text.to_owned()));
    let rig = told(include_str!("../../../../examples/rig-si.toml"));
    assert!(rig["units"]["length"].is_string() && rig["units"]["time"].is_string(), "{rig}");
    let plain = told(&example());
    assert_eq!((&plain["units"]["length"], &plain["from_the_wall"]), (&Value::Null, &json!(false)));
    assert_eq!(told(include_str!("../../../../examples/afm.toml"))["from_the_wall"], true);
}

#[test]
fn the_notes_of_the_command_line_are_told_also_on_constants_that_are_set() {
    let mut model = model(example());
    assert_eq!(checked(&model)["notes"], json!([]));
    model.set.insert("zeta".to_owned(), -0.02);
    let told = checked(&model);
    let description = model.read::<Mistake>("oscillator.toml", None, &Stop::default()).unwrap();
    let Mistake { message, key, line, .. } = description.notes()[0].mistake();
    assert_eq!(told["notes"], json!([{"message": message, "key": key, "line": line, "span": null}]));
    assert!(line.is_some() && message.contains("the sign of the damping"), "{told}");
}

#[test]
fn views_and_constants_are_put_in_the_place_of_the_files() {
    let mut model = model(example());
    model.set.insert("kappa".to_owned(), 0.3);
    let view = View { primary: [0.25, 0.5], secondary: [0.9, 1.0] };
    let read = model.read::<Mistake>("duffing.toml", Some(&view), &Stop::default());
    let description = read.unwrap();
    assert_eq!(description.primary().range(), [0.25, 0.5]);
    assert!(description.constants().any(|constant| constant == ("kappa", 0.3)));
    model.set.insert("unknown".to_owned(), 1.0);
    for name in ["unknown", "bad name", "kappa=0\nzeta"] {
        let mut wrong = model.clone();
        wrong.set.insert(name.to_owned(), 1.0);
        assert_eq!(checked(&wrong)["ok"], false, "{name}");
    }
    let paper = Model { text: None, set: BTreeMap::from([("zeta".to_owned(), 2.0)]), loops: None };
    assert_eq!(checked(&paper)["ok"], false);
}
