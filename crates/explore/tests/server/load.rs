//! Twenty pages that drag at once.

use std::collections::BTreeMap;
use std::io::{Read, Write};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};
use std::{env, fs};

use grazing_explore::Limits;
use grazing_model::LinearOscillator;
use grazing_reproduction::plane::{self, Axes};
use grazing_unfold::Diagram;
use grazing_unfold::Scope;
use grazing_unfold::progress::Silent;
use serde_json::json;

use crate::running::{Running, events};
use crate::whole_view;

/// People, and the values through which each moves a constant.
const PAGES: usize = 20;
const VALUES: usize = 12;
/// Every so many requests one goes away before the answer is there.
const GOES_AWAY: usize = 7;
/// The seconds for which all drag, if the environment does not say it; and megabytes that the process may grow by.
const SECONDS: u64 = 6;
const MEGABYTES: f64 = 200.0;

fn zeta(value: usize) -> f64 {
    0.01 + 0.005 * value as f64
}

/// The curves of the coarse diagram, computed here.
fn computed(value: usize) -> Vec<[f64; 2]> {
    let oscillator = LinearOscillator::new(zeta(value), 0.9, 0.0, 0.35).unwrap();
    let range = |name: &str| [0, 1].map(|end| whole_view()[name][end].as_f64().unwrap());
    let window =
        grazing_continuation::curve::Window { primary: range("primary"), secondary: range("secondary") };
    let scope = Scope { window, loops: vec![1, 2, 3], start: None };
    let located = Diagram::located(&oscillator, &scope, &Silent).unwrap();
    let followed = located.follow(&Silent, &|_, _| ());
    let diagram = located.with_curves(followed);
    plane::curves(&Axes::of_the_paper(), &diagram).iter().map(|row| [row.primary, row.secondary]).collect()
}

/// The same, as it was sent: all curves come last, but for the approximations to them.
fn sent(stream: &str) -> Vec<[f64; 2]> {
    let sent = events(stream, "curves");
    let all = sent[sent.len() - 2].as_array().unwrap();
    let points = all.iter().flat_map(|curve| curve["points"].as_array().unwrap());
    points.map(|point| [0, 1].map(|index| point[index].as_f64().unwrap())).collect()
}

/// Megabytes that this process has held at most; nothing where the system does not tell.
fn held() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.trim().strip_suffix(" kB")?.parse::<f64>().ok()? / 1024.0)
}

#[test]
fn twenty_pages_that_drag_at_once_get_what_unfold_computes() {
    let seconds = env::var("EXPLORE_LOAD_SECONDS").map_or(SECONDS, |told| told.parse().unwrap());
    let wanted: BTreeMap<usize, Vec<[f64; 2]>> = (0..VALUES).map(|value| (value, computed(value))).collect();
    let server = Running::new(Limits { connections: 4 * PAGES, ..Limits::default() });
    let before = held();
    let (answers, gone, slowest) = (AtomicUsize::new(0), AtomicUsize::new(0), Mutex::new(Duration::ZERO));
    let end = Instant::now() + Duration::from_secs(seconds);
    let least = Mutex::new(usize::MAX);
    thread::scope(|scope| {
        for page in 0..PAGES {
            let (server, wanted, answers, gone, slowest, least) =
                (&server, &wanted, &answers, &gone, &slowest, &least);
            scope.spawn(move || {
                let mut own = 0;
                for step in 0.. {
                    if own > 0 && Instant::now() > end {
                        break;
                    }
                    let value = (page + step) % VALUES;
                    let model = json!({"text": null, "set": {"zeta": zeta(value)}, "loops": [1, 2, 3]});
                    let body = json!({"model": model, "view": whole_view(), "coarse": true}).to_string();
                    if (page + step) % GOES_AWAY == GOES_AWAY - 1 {
                        leave(server, &body);
                        gone.fetch_add(1, Ordering::Relaxed);
                        continue;
                    }
                    let began = Instant::now();
                    let (status, stream) = server.post("diagram", &body);
                    let took = began.elapsed();
                    assert_eq!((status, events(&stream, "done").len()), (200, 1), "{stream}");
                    assert!(sent(&stream) == wanted[&value], "zeta = {}: other curves", zeta(value));
                    own += 1;
                    answers.fetch_add(1, Ordering::Relaxed);
                    let mut slowest = slowest.lock().unwrap();
                    *slowest = took.max(*slowest);
                }
                let mut least = least.lock().unwrap();
                *least = own.min(*least);
            });
        }
    });
    let (answers, slowest, least) =
        (answers.into_inner(), slowest.into_inner().unwrap(), least.into_inner().unwrap());
    // The server goes on.
    assert_eq!(server.get(&server.path), 200);
    let grown = before.zip(held()).map(|(before, after)| after - before);
    assert!(grown.is_none_or(|grown| grown < MEGABYTES), "{grown:?} MB");
    let told = format!(
        "{PAGES} pages, {seconds} s: {answers} answers, {:.1} a page and second, {least} at least; {} went away; the slowest after {slowest:?}; \
         {:.0} MB held at most, by server and pages\n",
        answers as f64 / (PAGES as f64 * seconds as f64),
        gone.into_inner(),
        held().unwrap_or(f64::NAN),
    );
    let _ = std::io::stderr().write_all(told.as_bytes());
}

/// Asks, and goes away with the first bytes.
fn leave(server: &Running, body: &str) {
    let more = format!("Content-Type: application/json\r\nContent-Length: {}\r\n", body.len());
    let request = format!("{}{body}", server.head("POST", &format!("{}diagram", server.path), &more));
    let mut stream = server.connect();
    stream.write_all(request.as_bytes()).unwrap();
    let _ = stream.read(&mut [0; 64]);
}
