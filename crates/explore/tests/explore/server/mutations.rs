//! Requests with mistakes, produced from correct ones by a seeded generator: every one is answered,
//! and the server goes on.
//!
//! The test tries some. The following tries many:
//!
//! ```text
//! GRAZING_MUTATIONS=10000 cargo test -p grazing-explore --test explore mutations
//! ```
//!
//! where GRAZING_MUTATIONS_FROM is the number of the first (0).

use std::env;
use std::time::Duration;

use grazing_explore::Limits;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng;
use serde_json::{Value, json};

use super::running::{LIMITS, Running};

/// The number of mutations that are tried by default.
const SOME: u64 = 100;

struct Dice(Pcg64Mcg);

impl Dice {
    fn below(&mut self, count: usize) -> usize {
        usize::try_from(self.0.next_u64() % count as u64).unwrap()
    }
}

/// Values at the edges of what can be computed, and values of wrong types.
fn extremes() -> Vec<Value> {
    vec![
        json!(null),
        json!(true),
        json!(0),
        json!(-1),
        json!(1e-6),
        json!(1e-308),
        json!(1e308),
        json!(-1e308),
        json!(4_294_967_296_u64),
        json!(""),
        json!("a"),
        json!("\u{0}\u{1b}[2J\u{202e}"),
        json!("../../etc/passwd"),
        json!([]),
        json!({}),
        json!([1e308, -1e308]),
        json!([2, 1]),
        json!([[[[]]]]),
        json!({"text": null}),
        json!([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]),
    ]
}

/// A correct request that takes a moment.
fn right(dice: &mut Dice) -> (&'static str, Value) {
    let text = include_str!("../../../../../examples/duffing.toml");
    let model = match dice.below(3) {
        0 => json!({"text": text, "set": {"kappa": 0.12}, "loops": [1]}),
        _ => json!({"text": null, "set": {"zeta": 0.03}, "loops": [1]}),
    };
    let view = json!({"primary": [0.2, 0.3], "secondary": [0.95, 0.97]});
    let nearby =
        json!({"solutions": [{"p": 1, "impacts": [[0.2, 0.1]]}], "attractors": [[1, [-1.0, 0.0, 0.0]]]});
    let exact = json!({"model": model, "view": view, "kind": "graz", "p": 0, "start": [0.0, 0.1], "at": [0.25, 0.96]});
    let measured = json!({"name": "rig.csv", "text": "amplitude,omega,seen\n0.25,0.96,none\n"});
    match dice.below(9) {
        5 => ("exact", exact),
        0 => ("check", model),
        1 => ("place", json!({"model": model, "at": [0.3, 0.8], "states": 1})),
        2 => ("place", json!({"model": model, "at": [0.3, 0.8], "orbits": false, "nearby": nearby})),
        3 => ("tiles", json!({"model": model, "view": view, "columns": 2, "rows": 2, "periods": 6})),
        4 => ("cut", json!({"model": model, "fixed": "secondary", "at": 0.9, "range": [0.2, 0.25]})),
        6 => ("export", json!({"model": model, "view": view, "what": "csv:a"})),
        7 => ("measured", json!({"model": model, "measured": measured})),
        _ => ("compare", json!({"model": model, "view": view, "measured": measured})),
    }
}

/// A random one of all values within a value, itself included.
fn somewhere<'v>(value: &'v mut Value, dice: &mut Dice) -> &'v mut Value {
    let children: Vec<&mut Value> = match value {
        Value::Array(_) | Value::Object(_) if dice.below(5) == 0 => return value,
        Value::Array(list) => list.iter_mut().collect(),
        Value::Object(members) => members.values_mut().collect(),
        _ => return value,
    };
    let count = children.len();
    match children.into_iter().nth(dice.below(count.max(1))) {
        Some(child) => somewhere(child, dice),
        None => unreachable!("nothing that is right is empty"),
    }
}

/// The bytes of a request with a mistake.
fn mutated(server: &Running, dice: &mut Dice) -> Vec<u8> {
    let (name, mut body) = right(dice);
    let extremes = extremes();
    match dice.below(4) {
        // A value of the body.
        0 | 1 => {
            *somewhere(&mut body, dice) = extremes[dice.below(extremes.len())].clone();
            server.request(name, &body.to_string()).into_bytes()
        }
        // A byte of the text, whose length stays correct.
        2 => {
            let mut text = body.to_string().into_bytes();
            let at = dice.below(text.len());
            match dice.below(3) {
                0 => text[at] = b" \"{}[],:0e-"[dice.below(11)],
                1 => drop(text.remove(at)),
                _ => text.truncate(at),
            }
            server.request(name, &String::from_utf8_lossy(&text)).into_bytes()
        }
        // Any byte of the head: method, address, names, lengths.
        _ => {
            let whole = server.request(name, &body.to_string());
            let end = whole.find("\r\n\r\n").unwrap();
            let mut bytes = whole.into_bytes();
            let at = dice.below(end);
            match dice.below(4) {
                0 => bytes[at] = u8::try_from(dice.below(256)).unwrap(),
                1 => drop(bytes.remove(at)),
                2 => bytes.insert(at, b"/%.:\0\n#?"[dice.below(8)]),
                _ => drop(bytes.splice(at..at, b"%2e%2e/".iter().copied())),
            }
            bytes
        }
    }
}

#[test]
fn whatever_is_asked_is_answered_and_the_server_goes_on() {
    let asked = |name: &str| env::var(name).ok().and_then(|text| text.parse().ok());
    let first = asked("GRAZING_MUTATIONS_FROM").unwrap_or(0);
    let count = asked("GRAZING_MUTATIONS").unwrap_or(SOME);
    // Limits of steps and time end computations, and patience ends requests that are shorter than
    // announced; which of them does makes no difference.
    let [time, patience] = [2, 1].map(Duration::from_secs);
    let server = Running::new(Limits { steps: 20_000, time, patience, ..LIMITS });
    for number in first..first + count {
        let mut dice = Dice(Pcg64Mcg::new(0x9e37_79b9_7f4a_7c15 ^ (u128::from(number) << 32)));
        // Seeds that differ by one bit begin with similar numbers.
        for _ in 0..8 {
            dice.0.next_u64();
        }
        let request = mutated(&server, &mut dice);
        let (status, _, answer) = server.ask(&request);
        let shown = String::from_utf8_lossy(&request);
        // Status 0 stands for no answer, as to what is not HTTP.
        let known = [0, 200, 400, 403, 404, 405, 408, 413, 415, 422, 431, 501, 503, 505];
        assert!(known.contains(&status), "{number}: {status}\n{shown}\n{answer}");
    }
    assert!((0..100).any(|_| server.get(&server.path) == 200));
    let body = json!({"text": null}).to_string();
    assert!((0..100).any(|_| server.post("check", &body).0 == 200));
}
