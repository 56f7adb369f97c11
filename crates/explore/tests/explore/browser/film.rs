//! The pictures of docs/explorer.md: a walk in four of them.

use std::env;
use std::fs;
use std::path::PathBuf;

use super::chromium::Browser;
use super::places::CUT;
use super::{PLACE, Running, WHOLE, plane_key, spot};

/// The variable with the folder for the pictures; without it there are none.
const FOLDER: &str = "EXPLORE_PICTURES";
const WINDOW: [u32; 2] = [1400, 860];

#[test]
fn a_walk_in_four_pictures_for_whoever_asks_for_them() {
    let Some(folder) = env::var_os(FOLDER).map(PathBuf::from) else { return };
    let server = Running::new();
    let Some(mut page) = server.open(WINDOW) else { return };
    fs::create_dir_all(&folder).unwrap();
    let mut count = 0;
    let mut take = |page: &mut Browser| {
        count += 1;
        page.hover([5.0, 300.0]);
        page.value("document.activeElement.blur()");
        // Labels are placed a moment after the curves.
        page.value(
            "document.fonts.ready.then(() => new Promise((told) => setTimeout(told, 700))).then(() => true)",
        );
        fs::write(folder.join(format!("explore-{count}.webp")), page.picture()).unwrap();
    };
    // A constant is changed, and a place is selected.
    let set = |page: &mut Browser, patch: &str| {
        page.value(&format!("use('state').then(([s]) => s.update({patch}))"));
    };
    set(&mut page, "{set: {zeta: 0.035, epsilon: 0.85}}");
    page.wait("use('diagram').then(([d]) => !d.isBusy() && !d.diagram.stale)");
    page.wait(WHOLE);
    let at = spot(&mut page, [0.62, 0.84]);
    page.click_at(at);
    page.wait(PLACE);
    take(&mut page);
    // Two places side by side, and a cut through one.
    set(&mut page, "{set: {}, kept: [0.9, 0.63], place: [0.36, 0.83], cut: 'secondary'}");
    page.wait(&format!("{PLACE}.then((told) => told && {CUT})"));
    page.wait(WHOLE);
    take(&mut page);
    // The overlay of simulation.
    set(&mut page, "{kept: null, cut: null, overlay: true, place: [0.9, 0.7]}");
    page.wait("/places simulated; /.test(document.getElementById('tiles-status').textContent)");
    page.wait(PLACE);
    take(&mut page);
    // A resonance from near, with the quadratic approximations.
    set(&mut page, "{overlay: false, place: null}");
    page.value("(document.getElementById('resonances').open = true, document.querySelectorAll('#resonances tbody button')[1].click())");
    page.wait("use('state').then(([s]) => s.get().view !== null)");
    for _ in 0..2 {
        plane_key(&mut page, "+");
    }
    page.wait("use('diagram').then(([d]) => !d.isBusy())");
    page.wait(WHOLE);
    page.value("document.getElementById('resonances').open = false");
    // A place where both motion with and motion without impacts is stable.
    set(&mut page, "{place: [0.834, 0.3943]}");
    page.wait(PLACE);
    take(&mut page);
}
