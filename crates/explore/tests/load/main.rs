//! Twenty pages in a real browser that drag at once.

// Parts of both serve here.
#[allow(dead_code)]
#[path = "../browser/chromium.rs"]
mod chromium;
#[allow(dead_code)]
#[path = "../server/running.rs"]
mod running;

use std::collections::BTreeMap;
use std::io::Write;
use std::thread::{self, sleep};
use std::time::{Duration, Instant};
use std::{env, fs};

use chromium::Browser;
use grazing_continuation::curve::Window;
use grazing_explore::Limits;
use grazing_model::LinearOscillator;
use grazing_reproduction::plane::{self, Axes};
use grazing_results::plane::{PlanePoint, RegionVertex};
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};
use running::Running;
use serde_json::Value;

const PAGES: usize = 20;
const WINDOW: [u32; 2] = [800, 600];
/// The seconds for which all drag, if the environment does not say it; and megabytes that the process may grow by.
const SECONDS: u64 = 5;
const MEGABYTES: f64 = 200.0;
/// Longer than it takes anywhere to see something move.
const PATIENCE: Duration = Duration::from_secs(120);
/// Places of a slider through which it goes to and fro, and between them a hand's pause.
const PLACES: u32 = 8;
const PAUSE: Duration = Duration::from_millis(60);

/// Counts what the page does from now on.
const WATCH: &str = include_str!("watch.js");
/// The picture is that of a whole diagram at constants at rest.
const AT_REST: &str = "use('diagram').then(([d]) => !d.isBusy() && !d.diagram.stale && d.diagram.regions.length > 0 && \
                       /curves? and \\d+ points? in/.test(document.getElementById('progress-text').textContent) && \
                       (!window.watched || watched.drawn === d.diagram.version))";
/// The curves and regions that are drawn, and of which constants.
const PICTURE: &str = "use('diagram', 'state').then(([d, s]) => ({set: s.get().set, curves: [...d.diagram.curves.values()]\
                       .filter(({source}) => source !== 'quadratic').map(({points}) => points), rings: d.diagram.regions.flatMap(({rings}) => rings)}))";

/// What one page tells.
struct Told {
    watched: Value,
    picture: Value,
    /// From the last movement to the whole picture.
    completed: Duration,
}

/// Drags the slider of a constant to and fro by pointer or by keys, lets it rest at a place of its own, and waits for the picture.
fn drag(page: &mut Browser, number: usize, seconds: u64) -> Told {
    let constant = ["zeta", "epsilon"][number % 2];
    let slider = format!("document.getElementById('constant-{constant}')");
    page.value(WATCH);
    let began = Instant::now();
    // Where all is slow, until something was seen to move.
    let goes_on = |page: &mut Browser| {
        let passed = began.elapsed();
        passed < Duration::from_secs(seconds) || (passed < PATIENCE && page.value("watched.frames") == 0)
    };
    if number % 4 < 2 {
        let bounds =
            format!("(() => {{ const b = {slider}.getBoundingClientRect(); return [b.left, b.width]; }})()");
        let [_, y] = page.middle(&format!("#constant-{constant}"));
        let [left, width] = page.point(&bounds);
        let place = |share: f64| [left + (0.2 + 0.6 * share) * width, y];
        let sweeps = [[0.0, 1.0], [1.0, 0.0]].map(|sweep| sweep.map(place));
        let mut to_and_fro = sweeps.iter().cycle();
        while goes_on(page) {
            let sweep = *to_and_fro.next().unwrap();
            page.drag(sweep, PLACES, 0, |_| sleep(PAUSE));
        }
        page.drag([0.0, number as f64 / PAGES as f64].map(place), PLACES, 0, |_| sleep(PAUSE));
    } else {
        page.value(&format!("{slider}.focus()"));
        let press = |page: &mut Browser, key: &str, times: usize| {
            for _ in 0..times {
                page.press(key);
                sleep(PAUSE);
            }
        };
        while goes_on(page) {
            press(page, "ArrowRight", PLACES as usize);
            press(page, "ArrowLeft", PLACES as usize);
        }
        press(page, "ArrowRight", 1 + number);
    }
    let watched = page.value("({...watched})");
    let rested = Instant::now();
    page.wait(AT_REST);
    let completed = rested.elapsed();
    Told { watched, picture: page.value(PICTURE), completed }
}

/// What `unfold` computes at a page's constants, whole or coarse.
fn computed(window: Window, set: &Value, coarse: bool) -> Diagram<LinearOscillator> {
    let constant = |name: &str, own: f64| set[name].as_f64().unwrap_or(own);
    let oscillator =
        LinearOscillator::new(constant("zeta", 0.02), constant("epsilon", 0.9), 0.0, window.secondary[0])
            .unwrap();
    let scope = Scope { window, loops: vec![1, 2, 3], start: None };
    let located = Diagram::located(&oscillator, &scope, &Silent).unwrap();
    let followed = located.follow(&Silent, &|_, _| ());
    if coarse { located.with_curves(followed) } else { located.with(followed, &Silent) }
}

/// FNV-1a of the bits of all points of curves.
fn sum(curves: &[PlanePoint]) -> u32 {
    let numbers = curves.iter().flat_map(|row| [row.primary, row.secondary]);
    let bytes = numbers.flat_map(f64::to_le_bytes);
    bytes.fold(0x811c_9dc5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

/// Polylines as lists of the bits of their points.
fn bits(lines: &Value) -> Vec<Vec<u64>> {
    let numbers = |line: &Value| -> Vec<u64> {
        let points = line.as_array().unwrap().iter().flat_map(|point| point.as_array().unwrap());
        points.map(|number| number.as_f64().unwrap().to_bits()).collect()
    };
    lines.as_array().unwrap().iter().map(numbers).collect()
}

/// The same of rows in chunks.
fn bits_of<'r, T: 'r>(chunks: impl Iterator<Item = &'r [T]>, point: fn(&T) -> [f64; 2]) -> Vec<Vec<u64>> {
    chunks.map(|rows| rows.iter().flat_map(point).map(f64::to_bits).collect()).collect()
}

fn assert_picture(window: Window, picture: &Value) {
    let (axes, diagram) = (Axes::of_the_paper(), computed(window, &picture["set"], false));
    let curves = plane::curves(&axes, &diagram);
    let mut curves = bits_of(curves.chunk_by(|a, b| a.arc == b.arc), |row| [row.primary, row.secondary]);
    let regions = plane::regions(&axes, &diagram.regions);
    let together = |a: &RegionVertex, b: &RegionVertex| (a.region, a.ring) == (b.region, b.ring);
    let rings = bits_of(regions.chunk_by(together), |row| [row.primary, row.secondary]);
    let mut found = bits(&picture["curves"]);
    curves.sort();
    found.sort();
    assert!(found == curves, "other curves at {}", picture["set"]);
    assert!(bits(&picture["rings"]) == rings, "other regions at {}", picture["set"]);
}

/// Megabytes that this process, the server, holds and has held at most; nothing where the system does not tell.
fn held(what: &str) -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(what))?;
    Some(line.trim().strip_suffix(" kB")?.parse::<f64>().ok()? / 1024.0)
}

/// Seconds of CPU that this process has used; nothing where the system does not tell in hundredths.
fn cpu() -> Option<f64> {
    let stat = fs::read_to_string("/proc/self/stat").ok()?;
    let (_, fields) = stat.rsplit_once(')')?;
    Some(
        fields.split_whitespace().skip(11).take(2).filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>()
            / 100.0,
    )
}

#[test]
fn twenty_pages_that_drag_at_once_see_what_unfold_computes() {
    let seconds = env::var("EXPLORE_LOAD_SECONDS").map_or(SECONDS, |told| told.parse().unwrap());
    let server = Running::new(Limits::default());
    let address = format!("http://{}{}", server.address, server.path);
    let mut pages = Vec::new();
    for _ in 0..PAGES {
        let Some(mut page) = Browser::open(&address, WINDOW) else { return };
        page.wait(AT_REST);
        pages.push(page);
    }
    let view = pages[0].value("use('model').then(([m]) => m.wholeView())");
    let range = |name: &str| [0, 1].map(|end| view[name][end].as_f64().unwrap());
    let window = Window { primary: range("primary"), secondary: range("secondary") };
    let (before, cpu_before) = (held("VmRSS:"), cpu());
    let told: Vec<Told> = thread::scope(|scope| {
        let all = pages.iter_mut().enumerate();
        let all: Vec<_> =
            all.map(|(number, page)| scope.spawn(move || drag(page, number, seconds))).collect();
        all.into_iter().map(|page| page.join().unwrap()).collect()
    });
    let (most, computed_for) = (held("VmHWM:"), cpu().zip(cpu_before).map(|(after, before)| after - before));
    let mut sums = BTreeMap::new();
    for (number, Told { watched, picture, .. }) in told.iter().enumerate() {
        assert_eq!(watched["wrong"], serde_json::json!([]), "page {number}");
        for (set, sent) in watched["sums"].as_object().unwrap() {
            let own = sums.entry(set.clone()).or_insert_with(|| {
                let diagram = computed(window, &set.parse().unwrap(), true);
                sum(&plane::curves(&Axes::of_the_paper(), &diagram))
            });
            assert_eq!(sent.as_u64(), Some(u64::from(*own)), "page {number}: other curves at {set}");
        }
        assert_picture(window, picture);
    }
    let all =
        |name: &str| -> Vec<f64> { told.iter().map(|page| page.watched[name].as_f64().unwrap()).collect() };
    let [frames, longest, answers, gone, slowest] =
        ["frames", "longest", "answers", "gone", "slowest"].map(all);
    let greatest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max) / 1000.0;
    let least = frames.iter().copied().fold(f64::INFINITY, f64::min);
    let line = format!(
        "{PAGES} pages, {seconds} s: {:.1} frames a page and second, {:.1} the least; {:.2} s the longest without one; {} answers at {} constants, {} given up, \
         the slowest after {:.2} s; {:.2} s from rest to the last whole picture; the server and what moves the pages: {:.0} s of CPU, {:.0} MB before, {:.0} MB at most\n",
        frames.iter().sum::<f64>() / (PAGES as u64 * seconds) as f64,
        least / seconds as f64,
        greatest(&longest),
        answers.iter().sum::<f64>(),
        sums.len(),
        gone.iter().sum::<f64>(),
        greatest(&slowest),
        told.iter().map(|page| page.completed).max().unwrap().as_secs_f64(),
        computed_for.unwrap_or(f64::NAN),
        before.unwrap_or(f64::NAN),
        most.unwrap_or(f64::NAN),
    );
    let _ = std::io::stderr().write_all(line.as_bytes());
    assert!(least > 0.0, "a page saw nothing move: {frames:?}");
    let grown = before.zip(most).map(|(before, most)| most - before);
    assert!(grown.is_none_or(|grown| grown < MEGABYTES), "{grown:?} MB");
}
