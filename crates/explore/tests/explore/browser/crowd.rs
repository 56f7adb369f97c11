//! Pages that drag at once: each shows what `unfold` computes.

use std::collections::BTreeMap;
use std::thread::{self, sleep};
use std::time::Duration;

use grazing_continuation::curve::Window;
use grazing_model::{AnyOscillator, LinearOscillator};
use grazing_results::plane::{PlanePoint, RegionVertex};
use grazing_unfold::plane;
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};
use serde_json::Value;

use super::chromium::Browser;

const WINDOW: [u32; 2] = [800, 600];
/// The number of places of a slider through which it moves to and fro.
const PLACES: u32 = 8;

/// Counts what the page does from now on.
const WATCH: &str = include_str!("watch.js");
/// The picture shows a complete diagram at constants at rest, and the page is idle.
const AT_REST: &str = "!document.documentElement.hasAttribute('data-busy') && use('diagram').then(([d]) => !d.diagram.stale && d.diagram.regions.length > 0 && \
                       /curves? and \\d+ points? in/.test(document.getElementById('progress-text').textContent))";
/// The curves and regions that are drawn, and the constants that they belong to.
const PICTURE: &str = "use('diagram', 'state').then(([d, s]) => ({set: s.get().set, curves: [...d.diagram.curves.values()]\
                       .filter(({source}) => source !== 'quadratic').map(({points}) => points), rings: d.diagram.regions.flatMap(({rings}) => rings)}))";

/// The counts of one page while it was dragged, and its picture at rest.
pub(crate) struct Page {
    pub(crate) watched: Value,
    pub(crate) picture: Value,
}

/// Idle pages of an address; none without a browser.
pub(crate) fn open(address: &str, count: usize) -> Option<Vec<Browser>> {
    let page = |_| {
        let mut page = Browser::open(address, WINDOW)?;
        page.wait(AT_REST);
        page.value(WATCH);
        Some(page)
    };
    (0..count).map(page).collect()
}

/// The view of a page that shows everything.
pub(crate) fn window(page: &mut Browser) -> Window {
    let view = page.value("use('model').then(([m]) => m.wholeView())");
    let range = |name: &str| [0, 1].map(|end| view[name][end].as_f64().unwrap());
    Window { primary: range("primary"), secondary: range("secondary") }
}

/// Drags in all pages at once, as long as `goes_on` is true and until each has drawn a frame, and
/// waits for the pictures at rest.
pub(crate) fn drag_all(
    pages: &mut [Browser],
    pause: Duration,
    goes_on: impl Fn() -> bool + Sync,
) -> Vec<Page> {
    let drag_one = |(number, page): (usize, &mut Browser)| {
        drag(page, number, pause, &goes_on);
        let watched = page.value("({...watched})");
        page.wait(AT_REST);
        Page { watched, picture: page.value(PICTURE) }
    };
    thread::scope(|scope| {
        let drag_one = &drag_one;
        let all: Vec<_> =
            pages.iter_mut().enumerate().map(|page| scope.spawn(move || drag_one(page))).collect();
        all.into_iter().map(|page| page.join().unwrap()).collect()
    })
}

/// Drags the slider of a constant to and fro by pointer or by keys, and lets it rest at a place
/// that differs from page to page.
fn drag(page: &mut Browser, number: usize, pause: Duration, goes_on: &impl Fn() -> bool) {
    let constant = ["zeta", "epsilon"][number % 2];
    let slider = format!("document.getElementById('constant-{constant}')");
    // After a drag without a frame the next one takes twice as long, so that at last one is drawn.
    let goes_on = |page: &mut Browser| goes_on() || page.value("watched.frames") == 0;
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
            page.drag(sweep, PLACES, 0, |_| sleep(pause));
        }
        page.drag([0.0, (number % 20) as f64 / 20.0].map(place), PLACES, 0, |_| sleep(pause));
    } else {
        page.value(&format!("{slider}.focus()"));
        let press = |page: &mut Browser, key: &str, times: usize| {
            for _ in 0..times {
                page.press(key);
                sleep(pause);
            }
        };
        while goes_on(page) {
            press(page, "ArrowRight", PLACES as usize);
            press(page, "ArrowLeft", PLACES as usize);
        }
        press(page, "ArrowRight", 1 + number);
    }
}

/// Asserts that every diagram that was sent and every picture at rest is what `unfold` computes, to
/// the last bit; returns the number of constants.
pub(crate) fn assert_right(pages: &[Page], window: Window) -> usize {
    let mut sums = BTreeMap::new();
    for (number, Page { watched, picture }) in pages.iter().enumerate() {
        assert_eq!(watched["wrong"], serde_json::json!([]), "page {number}");
        for (set, sent) in watched["sums"].as_object().unwrap() {
            let own = sums.entry(set.clone()).or_insert_with(|| {
                let diagram = computed(window, &set.parse().unwrap(), true);
                sum(&plane::curves(&diagram))
            });
            assert_eq!(sent.as_u64(), Some(u64::from(*own)), "page {number}: other curves at {set}");
        }
        assert_picture(window, picture);
    }
    sums.len()
}

/// The diagram that `unfold` computes at a page's constants, whole or coarse.
fn computed(window: Window, set: &Value, coarse: bool) -> Diagram {
    let constant = |name: &str, own: f64| set[name].as_f64().unwrap_or(own);
    let oscillator =
        LinearOscillator::new(constant("zeta", 0.02), constant("epsilon", 0.9), 0.0, window.secondary[0])
            .unwrap();
    let scope = Scope { window, loops: vec![1, 2, 3], start: None };
    let located = Diagram::located(&AnyOscillator::new(oscillator), &scope, &Silent).unwrap();
    let followed = located.follow(&Silent, &|_, _| ());
    if coarse { located.with_curves(followed) } else { located.with(followed, &Silent) }
}

/// FNV-1a of the bits of all points of curves.
fn sum(curves: &[PlanePoint]) -> u32 {
    let numbers = curves.iter().flat_map(|row| [row.at.primary, row.at.secondary]);
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

/// Chunks of rows as lists of the bits of their points.
fn bits_of<'r, T: 'r>(chunks: impl Iterator<Item = &'r [T]>, point: fn(&T) -> [f64; 2]) -> Vec<Vec<u64>> {
    chunks.map(|rows| rows.iter().flat_map(point).map(f64::to_bits).collect()).collect()
}

fn assert_picture(window: Window, picture: &Value) {
    let diagram = computed(window, &picture["set"], false);
    let curves = plane::curves(&diagram);
    let mut curves =
        bits_of(curves.chunk_by(|a, b| a.at.arc == b.at.arc), |row| [row.at.primary, row.at.secondary]);
    let regions = plane::regions(&diagram.regions);
    let together = |a: &RegionVertex, b: &RegionVertex| (a.region, a.at.ring) == (b.region, b.at.ring);
    let rings = bits_of(regions.chunk_by(together), |row| [row.at.primary, row.at.secondary]);
    let mut found = bits(&picture["curves"]);
    curves.sort();
    found.sort();
    assert!(found == curves, "other curves at {}", picture["set"]);
    assert!(bits(&picture["rings"]) == rings, "other regions at {}", picture["set"]);
}
