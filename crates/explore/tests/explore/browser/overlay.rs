//! Simulation drawn under the curves.

use super::{DESK, PHONE, Running, WHOLE, plane_key, state};

const STATUS: &str = "document.getElementById('tiles-status').textContent";
/// The number of places that were simulated in the view.
pub(crate) const SEEN: &str = "use('tiles').then(([t]) => t.seen())";
/// The text about the simulation, once all places are simulated and the page is idle.
const DONE: &str = "!document.documentElement.hasAttribute('data-busy') && /^[\\d,]+ places simulated; /.test(document.getElementById('tiles-status').textContent) && \
                    document.getElementById('tiles-status').textContent";

#[test]
fn simulation_agrees_with_the_shading_and_marks_what_does_not() {
    let server = Running::shared();
    let Some(mut page) = server.open(PHONE) else { return };
    page.click("[data-command=overlay]", [0.0, 0.0]);
    let told = page.wait(DONE);
    assert!(told.as_str().unwrap().contains("none disagrees"), "{told}");
    // Without the shading of the MPSs of one loop, all simulated places with these disagree, and
    // have a cross.
    let crossed = "use('diagram', 'tiles').then(([d, t]) => { const loops = t.cells().filter(([, , loops]) => loops === 1).length; \
                   d.diagram.regions = d.diagram.regions.filter(({p}) => p !== 1); t.shaded(); return loops; })";
    let loops = page.value(crossed).as_u64().unwrap();
    let told = page.wait(&format!("/[1-9][\\d,]* disagree/.test({STATUS}) && {STATUS}"));
    assert!(loops > 100 && told.as_str().unwrap().contains(&format!(" {loops} disagree")), "{told} {loops}");
    let red = "use('palette').then(([q]) => { const c = document.getElementById('plane'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; \
               const [, r, g, b] = /#(..)(..)(..)/.exec(q.inks().place).map((x) => parseInt(x, 16)); let n = 0; \
               for (let i = 0; i < d.length; i += 4) n += Math.hypot(d[i] - r, d[i + 1] - g, d[i + 2] - b) < 60; return n; })";
    page.wait(&format!("{red}.then((n) => n > 100)"));
    page.click("[data-command=overlay]", [0.0, 0.0]);
    assert_eq!(state(&mut page, "overlay"), false);
    assert_eq!(page.value("document.getElementById('tiles-legend').hidden"), true);
}

#[test]
fn an_unfinished_view_goes_on_where_it_was_after_zooming_back() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    plane_key(&mut page, "o");
    page.wait(&format!("{SEEN}.then((seen) => seen >= 500)"));
    page.press("+");
    page.wait("use('state', 'tiles').then(([s, t]) => s.encode(s.get()) === location.hash && JSON.stringify(t.view()) === JSON.stringify(s.get().view) && t.seen() > 0)");
    let before = page.value("use('tiles').then(([t]) => t.sizes())");
    page.press("[");
    page.wait("use('state', 'tiles').then(([s, t]) => s.get().view === null && t.view().primary[0] === 0)");
    // All earlier places are shown at once, the rest follows, and no place comes twice.
    let seen = page.value(SEEN).as_u64().unwrap();
    assert!(seen >= before[0].as_u64().unwrap() && seen >= 500, "{seen} {before}");
    page.wait(&format!("{SEEN}.then((now) => now > {seen})"));
    let twice = "use('tiles').then(([t]) => t.cells().length - new Set(t.cells().map(([column, row]) => `${column} ${row}`)).size)";
    assert_eq!(page.value(twice), 0);
    page.press("o");
    page.wait(&format!("{STATUS} === ''"));
}

#[test]
fn a_part_of_the_plane_is_simulated_anew() {
    let server = Running::shared();
    let Some(mut page) = server.open(PHONE) else { return };
    plane_key(&mut page, "o");
    page.wait(&format!("{SEEN}.then((seen) => seen >= 100)"));
    for _ in 0..3 {
        plane_key(&mut page, "+");
    }
    page.wait(&format!("use('tiles', 'state').then(([t, s]) => JSON.stringify(t.view()) === JSON.stringify(s.get().view)).then((here) => here && {DONE})"));
    page.wait(WHOLE);
}
