//! The time from a request to the last byte of its answer, through a server and the loopback interface.

// Only a part of the module is used here.
#[allow(dead_code)]
#[path = "../tests/explore/server/running.rs"]
mod running;

use std::io::{BufRead, BufReader, Write};

use divan::{Bencher, black_box};
use grazing_explore::Limits;
use running::Running;
use serde_json::{Value, json};

fn main() {
    divan::main();
}

/// The paper's oscillator in closed form, and one whose motion is integrated.
const OSCILLATORS: [&str; 2] = ["paper", "duffing"];

fn model(oscillator: &str) -> Value {
    let text = (oscillator == "duffing").then_some(include_str!("../../../examples/duffing.toml"));
    json!({ "text": text })
}

fn view(oscillator: &str) -> Value {
    match oscillator {
        "duffing" => json!({"primary": [0.0, 1.5], "secondary": [0.4, 1.1]}),
        _ => json!({"primary": [0.0, 1.3], "secondary": [0.35, 1.02]}),
    }
}

/// Sends the same request again and again.
fn ask(bencher: Bencher<'_, '_>, name: &str, body: &Value) {
    let server = Running::new(Limits::default());
    let body = body.to_string();
    bencher.bench(|| {
        let (status, answer) = server.post(name, black_box(&body));
        assert!(status == 200 && !answer.contains("event: error"), "{answer}");
        answer
    });
}

/// Sends the same request again and again, and closes the connection at the first event of a name.
fn first(bencher: Bencher<'_, '_>, name: &str, event: &str, body: &Value) {
    let server = Running::new(Limits::default());
    let body = body.to_string();
    let more = format!("Content-Type: application/json\r\nContent-Length: {}\r\n", body.len());
    let request = format!("{}{body}", server.head("POST", &format!("{}{name}", server.path), &more));
    bencher.bench(|| {
        let mut stream = server.connect();
        stream.write_all(black_box(&request).as_bytes()).unwrap();
        let mut lines = BufReader::new(stream).lines().map_while(Result::ok);
        assert!(lines.any(|line| line == format!("event: {event}")));
    });
}

/// The whole diagram.
#[divan::bench(args = OSCILLATORS, sample_count = 5)]
fn ability_1_plane(bencher: Bencher<'_, '_>, oscillator: &str) {
    ask(bencher, "diagram", &json!({"model": model(oscillator), "view": view(oscillator)}));
}

/// The first curve of the diagram.
#[divan::bench(args = OSCILLATORS, sample_count = 10)]
fn ability_1_first_curve(bencher: Bencher<'_, '_>, oscillator: &str) {
    first(bencher, "diagram", "curves", &json!({"model": model(oscillator), "view": view(oscillator)}));
}

/// A coarse diagram, as while a constant is dragged.
#[divan::bench(args = OSCILLATORS, sample_count = 10)]
fn ability_2_coarse(bencher: Bencher<'_, '_>, oscillator: &str) {
    ask(bencher, "diagram", &json!({"model": model(oscillator), "view": view(oscillator), "coarse": true}));
}

/// A place with 24 initial states, as when it is at rest.
#[divan::bench(args = OSCILLATORS, sample_count = 10)]
fn ability_3_place(bencher: Bencher<'_, '_>, oscillator: &str) {
    ask(bencher, "place", &json!({"model": model(oscillator), "at": [0.6, 0.8], "states": 24}));
}

/// A place with 24 initial states while it is dragged there from nearby, where a complete search
/// takes too long.
#[divan::bench(sample_count = 10)]
fn ability_3_place_dragged(bencher: Bencher<'_, '_>) {
    let server = Running::new(Limits::default());
    let place = |at: [f64; 2]| json!({"model": model("duffing"), "at": at, "states": 24});
    let (_, beside) = server.post("place", &place([0.598, 0.8]).to_string());
    let beside: Value = beside.parse().unwrap();
    let list = |name: &str| beside[name].as_array().unwrap().iter();
    let solutions = list("solutions").filter(|one| one["p"] != 0);
    let solutions = solutions.map(|one| &one["known"]);
    let attractors = list("attractors").map(|one| json!([one["states"], one["state"]]));
    let mut asked = place([0.6, 0.8]);
    asked["nearby"] =
        json!({"solutions": solutions.collect::<Vec<_>>(), "attractors": attractors.collect::<Vec<_>>()});
    ask(bencher, "place", &asked);
}

/// The branches of a cut along either axis.
#[divan::bench(args = CUTS, sample_count = 5)]
fn ability_4_cut_branches(bencher: Bencher<'_, '_>, cut: (&str, &str)) {
    first(bencher, "cut", "branches", &along(cut));
}

/// A whole cut along either axis.
#[divan::bench(args = CUTS, sample_count = 5)]
fn ability_4_cut(bencher: Bencher<'_, '_>, cut: (&str, &str)) {
    ask(bencher, "cut", &along(cut));
}

const CUTS: [(&str, &str); 4] =
    [("paper", "secondary"), ("paper", "primary"), ("duffing", "secondary"), ("duffing", "primary")];

/// A cut through the middle of the view, with the parameter of that name held.
fn along((oscillator, fixed): (&str, &str)) -> Value {
    let range = |name: &str| view(oscillator)[name].clone();
    let [low, high] = [0, 1].map(|end| range(fixed)[end].as_f64().unwrap_or_default());
    let across = if fixed == "primary" { "secondary" } else { "primary" };
    json!({"model": model(oscillator), "fixed": fixed, "at": (low + high) / 2.0, "range": range(across)})
}

/// Simulation at 400 x 300 places over 300 forcing periods.
#[divan::bench(sample_count = 2)]
fn ability_6_overlay(bencher: Bencher<'_, '_>) {
    let asked =
        json!({"model": model("paper"), "view": view("paper"), "columns": 400, "rows": 300, "periods": 300});
    ask(bencher, "tiles", &asked);
}
