//! What is told of a place: solutions, and what random states come to.

use std::f64::consts::TAU;

use serde_json::{Value, json};

use super::narrow;
use super::running::{LIMITS, Running};

#[test]
fn places_tell_solutions_and_what_random_states_come_to() {
    let server = Running::new(LIMITS);
    let at = |place: [f64; 2]| -> Value {
        let (status, answer) =
            server.post("place", &json!({"model": {"text": null}, "at": place}).to_string());
        assert_eq!(status, 200, "{answer}");
        answer.parse().unwrap()
    };
    // Below grazing every motion converges to the non-impacting solution; displacements from it
    // shrink with the damping ratio.
    let quiet = at([0.05, 0.8]);
    let attractors = quiet["attractors"].as_array().unwrap();
    assert_eq!((attractors.len(), attractors[0]["motion"].as_str()), (1, Some("non-impacting")));
    assert!((attractors[0]["lyapunov_exponent"].as_f64().unwrap() + 0.02).abs() < 1e-9, "{}", attractors[0]);
    // Solutions that are stable and admissible attract some states, with the impacts of the solutions.
    let busy = at([0.9, 0.8]);
    let solutions = busy["solutions"].as_array().unwrap();
    let good = |solution: &&Value| {
        solution["p"] != 0 && solution["stable"] == true && solution["admissible"] == true
    };
    let found: Vec<&Value> = solutions.iter().filter(good).collect();
    assert!(!found.is_empty(), "{busy}");
    let strikes: Vec<[f64; 2]> = busy["attractors"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(|attractor| attractor["strikes"].as_array().unwrap())
        .map(|strike| [0, 1].map(|index| strike[index].as_f64().unwrap()))
        .collect();
    for solution in found {
        assert_eq!(solution["reached"], true);
        let [velocity, phase] = [0, 1].map(|index| solution["known"]["impacts"][0][index].as_f64().unwrap());
        let close = |strike: &[f64; 2]| {
            let turns = (strike[1] - phase) / TAU;
            (strike[0] - velocity).abs() < 1e-3 && (turns - turns.round()).abs() < 1e-3
        };
        assert!(strikes.iter().any(close), "{solution}");
    }
}

#[test]
fn of_stable_solutions_those_that_no_start_reaches_are_marked() {
    let server = Running::new(LIMITS);
    let reached = |at: [f64; 2]| {
        let (_, answer) =
            server.post("place", &json!({"model": {"text": null}, "at": at, "orbits": false}).to_string());
        let told: Value = answer.parse().unwrap();
        let stable = told["solutions"].as_array().unwrap().clone().into_iter();
        let stable = stable.filter(|one| one["stable"] == true && one["admissible"] == true);
        stable.map(|one| json!([one["p"], one["reached"]])).collect::<Vec<_>>()
    };
    assert_eq!(reached([0.825, 0.95]), [json!([1, true]), json!([2, false])]);
    assert_eq!(reached([0.05, 0.8]), [json!([0, true])]);
}

#[test]
fn what_was_found_at_a_place_is_followed_to_the_next_one() {
    let server = Running::new(LIMITS);
    let (text, _) = narrow();
    let at = |place: [f64; 2], nearby: &Value| -> Value {
        let model = json!({"text": text, "loops": [1, 2]});
        let body = json!({"model": model, "at": place, "states": 6, "nearby": nearby, "orbits": false});
        let (status, answer) = server.post("place", &body.to_string());
        assert_eq!(status, 200, "{answer}");
        assert_eq!(answer, server.post("place", &body.to_string()).1);
        answer.parse().unwrap()
    };
    let list = |value: &Value, name: &str| value[name].as_array().unwrap().clone();
    let before = at([0.9, 0.9], &Value::Null);
    let mps = |solution: &&Value| solution["p"] != 0;
    let told = list(&before, "solutions");
    let told = told.iter().filter(mps).map(|one| &one["known"]);
    let attractors = list(&before, "attractors");
    let attractors = attractors.iter().map(|one| json!([one["states"], one["state"]]));
    let nearby = json!({"solutions": told.collect::<Vec<_>>(), "attractors": attractors.collect::<Vec<_>>()});
    let place = [0.91, 0.905];
    let (followed, looked_for) = (at(place, &nearby), at(place, &Value::Null));
    assert_eq!((&followed["followed"], &looked_for["followed"]), (&json!(true), &json!(false)));
    // All followed motion is found, to the digits to which solutions are located; and here there is
    // nothing new.
    let velocities = |answer: &Value| -> Vec<f64> {
        list(answer, "solutions")
            .iter()
            .filter(mps)
            .map(|one| one["impact_velocity"].as_f64().unwrap())
            .collect()
    };
    let (own, all) = (velocities(&followed), velocities(&looked_for));
    assert_eq!(own.len(), all.len(), "{own:?} {all:?}");
    assert!(
        all.iter().all(|velocity| own.iter().any(|other| (velocity - other).abs() < 1e-9)),
        "{own:?} {all:?}"
    );
    let kinds = |answer: &Value| -> Vec<Value> {
        list(answer, "attractors").iter().map(|one| json!([one["motion"], one["periods"]])).collect()
    };
    assert_eq!(kinds(&followed), kinds(&looked_for));
    let many = json!({"solutions": [], "attractors": vec![json!([1, [0, 0, 0]]); 300]});
    let body = json!({"model": {"text": text}, "at": place, "nearby": many});
    assert_eq!(server.post("place", &body.to_string()).0, 422);
}
