//! Requests that would never end, and that do not affect others.

use std::io::Read;
use std::net::TcpStream;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, mpsc};
use std::thread;
use std::time::Duration;

use grazing_explore::{ExportedFile, Limits};
use grazing_model::motion::Motion;
use grazing_model::smooth::{Stop, Stoppable};
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator, State};
use grazing_unfold::long_time::{Horizon, LongOrbit, Patience};
use serde_json::{Value, json};

use super::running::{BACKSTOP, LIMITS, Running};
use super::whole_view;

/// The paper's oscillator at a place.
fn place(at: [f64; 2]) -> String {
    json!({"model": {"text": null}, "at": at, "states": 2}).to_string()
}

/// A simulation of the paper's oscillator that takes hours.
fn hours() -> String {
    json!({"model": {"text": null}, "view": whole_view(), "columns": 1000, "rows": 1000, "periods": 5000})
        .to_string()
}

/// A simulation that sends far more than buffers hold, and soon.
fn flood() -> String {
    let view = json!({"primary": [0.0, 0.1], "secondary": [0.7, 0.8]});
    json!({"model": {"text": null}, "view": view, "columns": 1000, "rows": 1000, "periods": 6}).to_string()
}

/// Whether a quick request is answered; it may have to wait on a busy machine.
fn served(server: &Running, name: &str, body: &str) -> bool {
    (0..100).any(|_| server.post(name, body).0 == 200)
}

/// Fills the turns of a server, each with a computation that has begun.
fn filled(server: &Running, limits: Limits) -> Vec<TcpStream> {
    let begin = |_| {
        let mut stream = server.begin("tiles", &hours());
        assert!(stream.read(&mut [0; 64]).unwrap() > 0);
        stream
    };
    (0..limits.computations).map(begin).collect()
}

#[test]
fn what_makes_no_oscillator_is_refused() {
    let server = Running::new(LIMITS);
    let text = include_str!("../../../../../examples/duffing.toml");
    for model in [json!({"text": null}), json!({"text": text})] {
        for frequency in [0.0, -0.0, -0.8, -1e-300] {
            let body = json!({"model": model, "at": [0.3, frequency], "states": 2}).to_string();
            let (status, answer) = server.post("place", &body);
            assert!(status == 422 && answer.contains("must be positive"), "{frequency}: {status} {answer}");
        }
        for far in [1e7, 1e308, -1e308] {
            let slow = json!({"solutions": [[1, [[0.1, 0.0]]]], "attractors": [[1, [-1.0, 0.0, 0.0]]]});
            for (list, key) in [("solutions", 1), ("attractors", 1)] {
                let mut nearby = slow.clone();
                match list {
                    "solutions" => nearby[list][0][key][0][0] = json!(far),
                    _ => nearby[list][0][key][1] = json!(far),
                }
                let body = json!({"model": model, "at": [0.3, 0.8], "nearby": nearby}).to_string();
                let (status, answer) = server.post("place", &body);
                assert!(status == 422 && answer.contains("nearby"), "{far}: {status} {answer}");
            }
        }
        for range in [[-0.9, -0.1], [-0.1, 0.0]] {
            let cut = json!({"model": model, "fixed": "primary", "at": 0.3, "range": range}).to_string();
            assert!(server.post("cut", &cut).1.contains("must be positive"), "{range:?}");
            let view = json!({"primary": [0.1, 0.2], "secondary": range});
            let diagram = json!({"model": model, "view": view}).to_string();
            assert!(server.post("diagram", &diagram).1.contains("must be positive"), "{range:?}");
        }
    }
}

#[test]
fn whoever_hangs_up_ends_motion_that_hardly_moves() {
    let ((begins, begun), (ends, ended)) = (mpsc::channel(), mpsc::channel());
    let endless = move |_: &_, _: &str, _: &str, stop: &Stop| {
        let linear = LinearOscillator::new(0.1, 0.9, 0.9, 1e-6).unwrap();
        let still = AnyOscillator::new(Stoppable::new(linear, stop.clone()));
        let horizon = Horizon { transient: 1, counted: 1, patience: Patience::Drifting, longest: 0 };
        begins.send(()).unwrap();
        // The computation ends only once the motion is cancelled.
        let from = State::at_rest(-1.0, 0.0);
        while still.motion(from).at(0.0).position.is_finite() {
            drop(LongOrbit::follow(&still, from, horizon));
        }
        ends.send(()).unwrap();
        Err(String::new())
    };
    let limits = Limits { steps: u64::MAX, ..LIMITS };
    let server = Running::with(limits, Box::new(endless), || None);
    let body = json!({"model": {"text": null}, "view": whole_view(), "what": "csv:a"}).to_string();
    let asked: Vec<TcpStream> = (0..limits.computations).map(|_| server.begin("export", &body)).collect();
    asked.iter().for_each(|_| begun.recv().unwrap());
    for stream in asked {
        drop(stream);
        ended.recv_timeout(BACKSTOP).unwrap();
    }
    assert_eq!(server.post("place", &place([0.3, 0.8])).0, 200);
}

#[test]
fn steps_in_closed_form_are_counted_and_limited() {
    let server = Running::new(Limits { steps: 1000, ..LIMITS });
    let (status, answer) = server.post("place", &place([0.9, 0.8]));
    assert!(status == 503 && answer.contains("cancelled"), "{status} {answer}");
}

#[test]
fn light_requests_do_not_wait_for_heavy_ones() {
    let server = Running::new(LIMITS);
    let _heavy = filled(&server, LIMITS);
    let (status, answer) = server.post("check", &json!({"text": null}).to_string());
    assert!(status == 200 && answer.contains("\"ok\":true"), "{answer}");
    let nearby = json!({"solutions": [], "attractors": [[1, [-1.0, 0.0, 0.0]]]});
    let body = json!({"model": {"text": null}, "at": [0.1, 0.8], "nearby": nearby}).to_string();
    assert_eq!(server.post("place", &body).0, 200);
}

#[test]
fn a_check_ends_with_its_limit() {
    // Reading this file takes a second or two on a fast machine.
    let server = Running::new(Limits { time: Duration::from_millis(1), ..LIMITS });
    let product: Vec<String> = (1..3000).map(|k| format!("cos({k}*omega*t)")).collect();
    let text = include_str!("../../../../../examples/duffing.toml");
    let text =
        text.replace("[impact]", &format!("[wall]\nposition = \"1e-3*{}\"\n[impact]", product.join("*")));
    let (status, answer) = server.post("check", &json!({"text": text}).to_string());
    assert!(status == 503 && answer.contains("cancelled"), "{status} {answer}");
}

#[test]
fn who_never_reads_loses_turn_and_connection() {
    let limits = Limits { patience: Duration::from_secs(2), connections: 16, ..LIMITS };
    let server = Running::new(limits);
    let floods: Vec<TcpStream> = (0..limits.computations).map(|_| server.begin("tiles", &flood())).collect();
    assert!(served(&server, "place", &place([0.3, 0.8])));
    // Answers in one piece do not hold connections for ever either.
    let large = |_: &_, _: &str, _: &str, _: &_| {
        Ok(ExportedFile { name: "a.csv".to_owned(), kind: "text/csv", content: vec![b' '; 50_000_000] })
    };
    let server = Running::with(limits, Box::new(large), || None);
    let view = json!({"primary": [0.0, 0.01], "secondary": [0.7, 0.71]});
    let body = json!({"model": {"text": null}, "view": view, "what": "csv:a"}).to_string();
    let sheets: Vec<TcpStream> = (0..limits.connections).map(|_| server.begin("export", &body)).collect();
    assert!((0..1000).any(|_| {
        thread::sleep(Duration::from_millis(20));
        server.get(&server.path) == 200
    }));
    drop((floods, sheets));
}

#[test]
fn a_computation_that_does_not_hear_loses_its_turn() {
    let released = Arc::new(AtomicBool::new(false));
    let until = released.clone();
    let deaf = move |_: &_, _: &str, _: &str, _: &_| -> Result<ExportedFile, String> {
        while !until.load(Ordering::Relaxed) {
            thread::sleep(Duration::from_millis(10));
        }
        Err("it was let go".to_owned())
    };
    let time = Duration::from_secs(2);
    let limits = Limits { computations: 1, time, grace: Duration::from_millis(10), ..LIMITS };
    let server = Running::with(limits, Box::new(deaf), || None);
    let view = json!({"primary": [0.0, 0.01], "secondary": [0.7, 0.71]});
    let body = json!({"model": {"text": null}, "view": view, "what": "csv:a"}).to_string();
    for _ in 0..2 {
        let (status, answer) = server.post("export", &body);
        let message: Value = answer.parse().unwrap();
        assert!(status == 503 && message["message"].is_string(), "{status} {answer}");
    }
    assert!(served(&server, "place", &place([0.3, 0.8])));
    released.store(true, Ordering::Relaxed);
}
