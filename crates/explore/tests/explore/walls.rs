//! Oscillators between two walls in the page: what both walls see, in one plane, is what `unfold` draws.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use grazing_explore::{Export, Figure, Seen, Wanted, answer};
use grazing_input::Mistake;
use grazing_model::smooth::Stop;
use grazing_results::plane::PlaneDiagram;
use grazing_unfold::progress::Silent;
use grazing_unfold::unfolded::Unfolded;
use serde_json::{Value, json};

use crate::model::model;

/// A window about the resonance of an example with two stops.
const VIEW: [[f64; 2]; 2] = [[0.45, 0.62], [0.65, 0.69]];

fn body(of: &Value) -> Vec<u8> {
    serde_json::to_vec(of).expect("it is JSON")
}

fn export() -> Export {
    Box::new(|_, what, _, _| panic!("{what} is not asked for"))
}

/// The answer with one value.
fn one(name: &str, asked: &Value) -> Value {
    let found = answer(name, &body(asked), (&|_| true, || Duration::ZERO), &export(), &Stop::default());
    let (_, found) = found.unwrap_or_else(|(status, message)| panic!("{name}: {status} {message}"));
    serde_json::from_slice(&found).expect("it is JSON")
}

/// Values by name.
type Named = BTreeMap<String, Value>;

/// The last event of each name; of curves all, by their names.
fn events(name: &str, asked: &Value) -> (Named, Named) {
    let seen: Arc<Mutex<(Named, Named)>> = Arc::default();
    let told = seen.clone();
    let listener = move |text: String| {
        let (name, data) = text.trim_start_matches("event: ").split_once("\ndata: ").expect("an event");
        let data: Value = serde_json::from_str(data.trim()).expect("it is JSON");
        let (last, curves) = &mut *told.lock().expect("nobody panics");
        for curve in data.as_array().into_iter().flatten().filter(|_| name == "curves") {
            curves.insert(curve["key"].as_str().expect("a name").to_owned(), curve.clone());
        }
        last.insert(name.to_owned(), data);
        true
    };
    answer(name, &body(asked), (&listener, || Duration::ZERO), &export(), &Stop::default())
        .expect("it is told");
    let seen = seen.lock().expect("nobody panics");
    seen.clone()
}

fn count<'a>(found: impl Iterator<Item = &'a u32>) -> usize {
    found.collect::<BTreeSet<_>>().len()
}

#[test]
fn both_walls_are_in_one_plane_as_unfold_draws_it() {
    let text = include_str!("../../../../examples/two-stops.toml");
    let model = model(text.to_owned());
    let [primary, secondary] = VIEW;
    let view = json!({"primary": primary, "secondary": secondary});
    let (last, curves) = events("diagram", &json!({"model": model, "view": view}));
    assert!(last.contains_key("done"), "{last:?}");
    let seen = grazing_explore::View { primary, secondary };
    let description =
        model.read::<Mistake>("two-stops.toml", Some(&seen), &Stop::default()).expect("it is right");
    let unfolded = Unfolded::described(&description, &Silent, &Stop::default(), &|_| ()).expect("it grazes");
    let drawn: PlaneDiagram = unfolded.plane_diagram();
    let kept: BTreeSet<&str> =
        last["keys"].as_array().expect("a list").iter().filter_map(Value::as_str).collect();
    let followed = kept.iter().filter(|key| !key.ends_with("quadratic")).count();
    assert_eq!(followed, count(drawn.curves.iter().map(|row| &row.at.arc)), "{kept:?}");
    for wall in [1, 2] {
        let own = |kind: &str| {
            let of = |curve: &&Value| {
                curve["wall"] == wall && curve["kind"] == kind && curve["source"] == "continuation"
            };
            kept.iter().filter_map(|key| curves.get(*key)).filter(of).count()
        };
        assert_eq!([own("graz"), own("SN"), own("PD")], [1, 1, 1], "wall {wall}: {kept:?}");
    }
    let regions = last["regions"].as_array().expect("a list");
    let [at_one, at_both] = [
        count(drawn.regions.iter().map(|row| &row.region)),
        count(drawn.several.iter().map(|row| &row.region)),
    ];
    assert_eq!(regions.len(), at_one + at_both);
    // Motion that strikes both, and its curves.
    let is_at_both = |region: &&Value| region["name"].as_str().is_some_and(|name| name.starts_with("1+1/"));
    let both = regions.iter().filter(is_at_both).filter(|region| region["kind"] == "several-impacts");
    assert!(at_both > 0 && both.count() == at_both);
    let followed = curves.keys().filter(|key| key.contains("both walls")).count();
    assert_eq!(followed, count(drawn.at_both_walls.iter().map(|row| &row.at.arc)));
    // What is taken home has them, too.
    let taken = Seen::of(&model, Some(&seen), &Wanted::Plane, &Silent, &Stop::default()).expect("it grazes");
    let Figure::Plane(taken, _) = taken.figure else { panic!("it is the plane") };
    let both = |diagram: &PlaneDiagram| format!("{:?} {:?}", diagram.several, diagram.at_both_walls);
    assert_eq!(both(&taken), both(&drawn));
    assert_eq!(last["points"].as_array().expect("a list").len(), drawn.points.len());
    assert_eq!(last["resonances"].as_array().expect("a list").len(), 2);
    // Places exactly on the curves of the second wall are found from there; by symmetry they are those of the first.
    let [first, second] = ["SN 1 3 #0", "SN 1 3 wall 2 #0"].map(|key| {
        let curve = &curves[key];
        let middle = curve["points"].as_array().expect("a list").len() / 2;
        let asked = json!({
            "model": model, "view": view, "kind": "SN", "p": 1, "wall": curve["wall"],
            "start": curve["starts"][middle], "at": curve["points"][middle],
        });
        let found = one("exact", &asked);
        let far: f64 = (0..2)
            .map(|k| (found["at"][k].as_f64().unwrap() - curve["points"][middle][k].as_f64().unwrap()).abs())
            .sum();
        assert!(far < 1e-6, "{key}: {far}");
        found["multipliers"].clone()
    });
    let is_one = |multiplier: &Value| (multiplier[0].as_f64().unwrap() - 1.0).abs() < 1e-6;
    for multipliers in [first, second] {
        assert!(multipliers.as_array().expect("two").iter().any(is_one), "{multipliers}");
    }
}

#[test]
fn motion_at_a_place_strikes_both_walls_and_its_solution_is_followed() {
    let text = include_str!("../../../../examples/two-stops.toml");
    let model = model(text.to_owned());
    let at = [0.69, 0.7];
    let found = one("place", &json!({"model": model, "at": at, "states": 6}));
    assert_eq!(found["beyond"].as_array().map(Vec::len), Some(64));
    assert!(found["beyond"].as_array().unwrap().iter().all(|x| (x.as_f64().unwrap() + 2.0).abs() < 1e-12));
    let attractor = &found["attractors"][0];
    assert_eq!([&attractor["impacts"], &attractor["impacts_at_wall_2"]], [&json!(2.0), &json!(1.0)]);
    let solutions = found["solutions"].as_array().expect("a list");
    let both = solutions.iter().find(|one| {
        [json!([0, 1]), json!([1, 0])].contains(&one["known"]["stops"]) && one["reached"] == true
    });
    let both = both.expect("the motion's own solution is among them");
    // Followed on from there, nothing else comes of it.
    let nearby = json!({
        "solutions": [both["known"]],
        "attractors": [[attractor["states"], attractor["state"]]],
    });
    let next = one("place", &json!({"model": model, "at": [0.691, 0.7], "nearby": nearby}));
    let followed = next["solutions"].as_array().expect("a list");
    assert!(followed.iter().any(|one| one["known"]["stops"] == both["known"]["stops"]));
    assert_eq!(next["attractors"][0]["impacts_at_wall_2"], json!(1.0));
    let asked = json!({
        "model": model, "view": {"primary": [0.6, 0.75], "secondary": [0.68, 0.72]}, "at": at,
        "p": both["p"], "impacts": both["known"]["impacts"], "stops": both["known"]["stops"],
    });
    let curve = one("follow", &asked);
    assert!(curve[0]["points"].as_array().is_some_and(|points| points.len() > 5));
    // With one wall there is no second to hit.
    let paper = json!({"text": null, "set": {}, "loops": null});
    let wrong = json!({"model": paper, "view": {"primary": [0.1, 0.9], "secondary": [0.6, 0.9]}, "at": [0.5, 0.8], "p": 1, "impacts": [[0.1, 0.0]], "stops": [1]});
    assert!(
        answer("follow", &body(&wrong), (&|_| true, || Duration::ZERO), &export(), &Stop::default()).is_err()
    );
}
