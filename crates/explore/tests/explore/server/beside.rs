//! Additions to the diagram: straightened curves, measurements, other ordinates, curves through
//! solutions, places as figures.

use grazing_explore::{ExportedFile, Figure, Seen};
use serde_json::{Value, json};

use super::running::{LIMITS, Running, events};
use super::{narrow, whole_view};

/// A server whose exports are a function of the figures.
fn exporting(told: fn(&Figure) -> Value) -> Running {
    let export = move |seen: &Seen, _: &str, _: &str, _: &_| {
        let content = told(&seen.figure).to_string().into_bytes();
        Ok(ExportedFile { name: "taken".to_owned(), kind: "application/json", content })
    };
    Running::with(LIMITS, Box::new(export), || None)
}

fn answered(server: &Running, name: &str, body: &Value) -> Value {
    let (status, answer) = server.post(name, &body.to_string());
    assert_eq!(status, 200, "{answer}");
    answer.parse().unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

#[test]
fn straightened_curves_are_the_same_however_narrow_the_view_and_run_into_their_limits() {
    let server = exporting(|figure| match figure {
        Figure::Straightened(curves) => {
            let rows =
                curves.curves.iter().map(|row| json!([row.kind.name(), row.eta, row.distance, row.limit]));
            rows.collect()
        }
        _ => Value::Null,
    });
    let (text, view) = narrow();
    // The place of a resonance follows from the diagram.
    let model = json!({"text": text, "loops": [3]});
    let diagram = json!({"model": model, "view": view, "coarse": true});
    let (_, stream) = server.post("diagram", &diagram.to_string());
    let found = &events(&stream, "resonances")[0][0];
    let at = [number(&found["primary"]), number(&found["secondary"])];
    let about = |width: f64| json!({"primary": [at[0] - width, at[0] + width], "secondary": [at[1] - width, at[1] + width]});
    let curves = |width: f64| {
        let body = json!({"model": model, "view": about(width), "what": "svg", "of": {"straightened": at}});
        answered(&server, "export", &body)
    };
    let wide = curves(1e-2);
    assert_eq!(wide, curves(1e-8));
    let rows = wide.as_array().unwrap();
    let kinds = ["SN", "PD"].map(|kind| rows.iter().filter(|row| row[0] == kind).collect::<Vec<_>>());
    for rows in kinds {
        assert!(rows.len() > 30, "{rows:?}");
        for row in rows.iter().filter(|row| number(&row[1]).abs() < 1e-6) {
            let (distance, limit) = (number(&row[2]), number(&row[3]));
            assert!((distance - limit).abs() < 1e-4 * limit.abs(), "{row}");
        }
    }
}

#[test]
fn measurements_in_the_view_are_held_against_what_is_computed_and_mistakes_have_their_line() {
    let server = Running::new(LIMITS);
    let model = json!({"text": null, "loops": [1]});
    let body = |text: &str| json!({"model": model, "view": whole_view(), "measured": {"name": "rig.csv", "text": text}});
    let measured = |text: &str| {
        let (status, stream) = server.post("compare", &body(text).to_string());
        assert_eq!((status, events(&stream, "done").len()), (200, 1), "{stream}");
        let begun = |stage: &str| events(&stream, "progress").iter().any(|told| told["stage"] == stage);
        assert!(begun("comparison with measurements"), "{stream}");
        (events(&stream, "measured")[0].clone(), begun("regions"))
    };
    let head = "amplitude,omega,seen,periods,impacts\n";
    let text = format!(
        "{head}0.05,0.8,none,,\n0.9,0.8,periodic,1,1\n0.05,0.8,periodic,1,1\n0.9,0.8,irregular,,\n5,0.8,none,,\n"
    );
    // The diagram is computed where it is not known, and then kept; motion is simulated beside it all the same.
    let (told, is_computed) = measured(&text);
    assert!(is_computed);
    assert_eq!(measured(&text), (told.clone(), false));
    let verdicts: Vec<&Value> =
        told["points"].as_array().unwrap().iter().map(|one| &one["agreement"]).collect();
    assert_eq!(verdicts, ["agrees", "agrees", "disagrees", "undecided"]);
    let simulated = &told["points"][3]["reason"];
    assert!(
        simulated.as_str().unwrap().contains("8 simulated states reach: 1 impacts in 1 periods"),
        "{simulated}"
    );
    assert_eq!(told["outside"], 1);
    let counts = told["counts"].as_array().unwrap();
    let sum = |name: &str| counts.iter().map(|count| number(&count[name])).sum::<f64>();
    // A place in two regions is counted in each.
    let all = sum("points");
    assert!(all >= 4.0 && all == sum("agree") + sum("disagree") + sum("undecided"), "{told}");
    // What is in the file is told without it.
    let read = answered(&server, "measured", &body(&text));
    let lines: Vec<f64> = read["points"].as_array().unwrap().iter().map(|one| number(&one["line"])).collect();
    assert_eq!(lines, [2.0, 3.0, 4.0, 5.0, 6.0]);
    assert_eq!(read["points"][1]["seen"], "1 impact in 1 period");
    assert_eq!(read["columns"], json!(["amplitude", "omega", "seen", "periods", "impacts"]));
    let wrong = body(&format!("{head}0.05,0.8,nothing,,\n")).to_string();
    let (status, told) = server.post("measured", &wrong);
    assert!(status == 422 && told.contains("rig.csv:2: "), "{told}");
    assert!(
        events(&server.post("compare", &wrong).1, "error")[0]["message"]
            .as_str()
            .unwrap()
            .starts_with("rig.csv:2: ")
    );
}

#[test]
fn impact_velocities_in_a_cut_are_those_of_the_solutions_at_a_place() {
    let server = Running::new(LIMITS);
    let place = [0.9, 0.8];
    let cut = |fixed: &str, ordinate: &str| {
        let (at, range) =
            if fixed == "secondary" { (place[1], [0.5, 1.0]) } else { (place[0], [0.76, 0.84]) };
        let body = json!({"model": {"text": null, "loops": [1]}, "fixed": fixed, "at": at, "range": range, "ordinate": ordinate});
        let (status, answer) = server.post("cut", &body.to_string());
        assert_eq!((status, events(&answer, "done").len()), (200, 1), "{answer}");
        [events(&answer, "branches")[0].clone(), events(&answer, "dots")[0].clone()]
    };
    let at = json!({"model": {"text": null, "loops": [1]}, "at": place, "orbits": false});
    let found = answered(&server, "place", &at);
    let solutions = || found["solutions"].as_array().unwrap().iter().filter(|one| one["p"] == 1);
    let roles = [("secondary", place[0]), ("primary", place[1])].map(|(fixed, across)| {
        let [branches, dots] = cut(fixed, "impact velocity");
        (across, branches, dots)
    });
    assert!(solutions().count() > 0);
    for ((across, branches, dots), solution) in
        roles.iter().flat_map(|role| solutions().map(move |solution| (role, solution)))
    {
        let velocity = number(&solution["impact_velocity"]);
        let strands = branches["strands"].as_array().unwrap().iter().filter(|strand| strand["p"] == 1);
        let passes = strands.flat_map(|strand| strand["points"].as_array().unwrap().windows(2)).any(|pair| {
            let [from, to] = [0, 1].map(|k| [number(&pair[k][0]), number(&pair[k][1])]);
            let part = (across - from[0]) / (to[0] - from[0]);
            (0.0..=1.0).contains(&part) && (from[1] + part * (to[1] - from[1]) - velocity).abs() < 1e-3
        });
        assert!(passes, "{solution}");
        if solution["stable"] == true && solution["admissible"] == true {
            let dots =
                dots["dots"].as_array().unwrap().iter().filter(|dot| (number(&dot[0]) - across).abs() < 2e-3);
            assert!(
                dots.clone().count() > 0 && dots.clone().any(|dot| (number(&dot[1]) - velocity).abs() < 2e-2)
            );
        }
    }
    // Any other word stands for x.
    assert_eq!(cut("secondary", "x"), cut("secondary", "weight"));
}

#[test]
fn along_a_followed_solution_the_impact_velocity_stays_and_places_on_it_have_that_solution() {
    let server = Running::new(LIMITS);
    let model = json!({"text": null, "loops": [1]});
    let solutions = |at: [f64; 2]| {
        let place = answered(&server, "place", &json!({"model": model, "at": at, "orbits": false}));
        let all = place["solutions"].as_array().unwrap().clone();
        all.into_iter().filter(|one| one["p"] == 1).collect::<Vec<_>>()
    };
    let solution = &solutions([0.9, 0.8])[0];
    let velocity = number(&solution["impact_velocity"]);
    let asked = json!({"model": model, "view": whole_view(), "at": [0.9, 0.8], "p": 1, "impacts": solution["known"]["impacts"]});
    let curves = answered(&server, "follow", &asked);
    let points = curves[0]["points"].as_array().unwrap();
    assert!(points.len() > 10 && points.len() == curves[0]["multipliers"].as_array().unwrap().len());
    for point in [&points[points.len() / 3], &points[2 * points.len() / 3]] {
        let at = [number(&point[0]), number(&point[1])];
        let same = |one: &Value| (number(&one["impact_velocity"]) - velocity).abs() < 1e-6;
        assert!(solutions(at).iter().any(same), "{at:?}");
    }
    let away =
        json!({"model": model, "view": whole_view(), "at": [9.0, 0.8], "p": 1, "impacts": [[1.0, 0.0]]});
    assert_eq!(server.post("follow", &away.to_string()).0, 422);
}

#[test]
fn basins_have_the_attractors_of_the_place_and_shares_near_those_of_random_states() {
    let server = exporting(|figure| match figure {
        Figure::Place(place) => {
            let attractors = place.attractors.iter().map(|one| json!([one.motion, one.share]));
            let count = |number: u32| place.basins.iter().filter(|state| state.attractor == number).count();
            let cells = place.attractors.iter().map(|one| count(one.attractor));
            json!({"attractors": attractors.collect::<Vec<_>>(), "cells": cells.collect::<Vec<_>>(), "all": place.basins.len()})
        }
        _ => Value::Null,
    });
    let at = [0.62, 0.84];
    let model = json!({ "text": null });
    let place = answered(&server, "place", &json!({"model": model, "at": at, "orbits": false}));
    let wanted = place["attractors"].as_array().unwrap();
    let body = json!({"model": model, "view": whole_view(), "what": "svg", "of": {"place": at}});
    let found = answered(&server, "export", &body);
    let all = number(&found["all"]);
    assert!(all > 1000.0);
    for (k, one) in wanted.iter().enumerate() {
        let share = number(&one["share"]);
        assert_eq!(found["attractors"][k], json!([one["motion"], share]));
        // Four standard deviations of a share of 24 states.
        let cells = number(&found["cells"][k]) / all;
        assert!(
            (cells - share).abs() <= 4.0 * (share * (1.0 - share) / 24.0).sqrt() + 0.05,
            "{k}: {cells} {share}"
        );
    }
}
