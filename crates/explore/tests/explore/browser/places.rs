//! Places that are selected, and cuts through them.

use serde_json::Value;

use super::chromium::Browser;
use super::{DESK, PHONE, PLACE, QUIET, Running, WHOLE, numbers, plane_key, spot, state};

/// Waits until something is drawn on the canvas besides one colour.
fn is_drawn(page: &mut Browser, selector: &str) {
    page.wait(&format!(
        "(() => {{ const c = document.querySelector({selector:?}); if (!c.width) return false; \
         const d = new Uint32Array(c.getContext('2d').getImageData(0, 0, c.width, c.height).data.buffer); return new Set(d).size > 10; }})()"
    ));
}

#[test]
fn a_place_tells_what_motion_comes_to_and_follows_the_pointer() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    // Far above grazing, at a high frequency, every motion converges to a solution of one loop.
    let busy = spot(&mut page, [0.9, 0.8]);
    page.click_at(busy);
    let place = page.wait(PLACE);
    let place = place.as_str().unwrap();
    assert!(place.contains("MPS, 1 loop") && place.contains("100 %") && place.contains("λ = "), "{place}");
    for picture in ["time", "phase", "strikes"] {
        is_drawn(&mut page, &format!("#places .place:not(.kept) .{picture}"));
    }
    // Every MPS has a line with its multipliers, and is drawn when its button is pressed.
    let rows = page.value("[...document.querySelectorAll('#places .place:not(.kept) tbody tr')].map((row) => [...row.cells].map((cell) => cell.textContent))");
    assert!(rows.as_array().unwrap().len() >= 2, "{rows}");
    assert!(rows.as_array().unwrap().iter().all(|row| !row[2].as_str().unwrap().is_empty()), "{rows}");
    // Below grazing there are no impacts; the ring is dragged there, and answers arrive on the way.
    let quiet = spot(&mut page, [0.05, 0.8]);
    let mut answers = 0;
    page.drag([busy, quiet], 5, 0, |page| {
        let at = state(page, "place");
        page.wait(&format!(
            "use('place').then(([p]) => JSON.stringify(p.shown('place')) === JSON.stringify({at}))"
        ));
        answers += 1;
    });
    assert_eq!(answers, 5);
    page.wait(&format!("{PLACE}.then((told) => /No impacts/.test(told) && !/MPS, 1 loop/.test(told))"));
    let [primary, secondary] = numbers(&state(&mut page, "place"))[..] else { panic!("two numbers") };
    assert!((primary - 0.05).abs() < 0.01 && (secondary - 0.8).abs() < 0.01);
    // A stable solution that no start reaches is named, with the number of starts.
    page.value("use('state').then(([s]) => s.update({place: [0.825, 0.95]}))");
    let here = "use('place').then(([p]) => JSON.stringify(p.shown('place')) === '[0.825,0.95]')";
    let told = page.wait(&format!("{here}.then((there) => there && {PLACE})"));
    for words in [
        "Reached from 24 random starts",
        "MPS, 1 loop100 %",
        "MPS, 2 loops, velocity 2.66: stable, not reached",
        "stable, but none of the 24 random starts reached it",
    ] {
        assert!(told.as_str().unwrap().contains(words), "{words}: {told}");
    }
    // Where there is no motion that is said, and no longer once the place is back.
    let message = "document.querySelector('.place:not(.kept) > .message:not([hidden])')?.textContent";
    page.value("use('state').then(([s]) => s.update({place: [0.825, -0.1], cut: 'secondary'}))");
    page.wait(&format!("/must be positive/.test({message}) && /must be positive/.test(document.getElementById('cut-message').textContent)"));
    page.value("use('state').then(([s]) => s.update({place: [0.825, 0.95]}))");
    page.wait(&format!("{CUT}.then((there) => there && {PLACE})"));
    assert!(page.value(message).is_null());
}

#[test]
fn nothing_moves_but_what_changes() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    // Long after the last step all labels are placed.
    let placed = "use('plane').then(([p]) => p.words().map(({text, at}) => [text.map(([word]) => word).join(''), ...at]))";
    let settled = format!("{QUIET} && {placed}");
    let words = page.wait(&settled);
    let at = spot(&mut page, [0.9, 0.8]);
    page.click_at(at);
    page.wait(PLACE);
    let boxes = "['#stage', '.status', '.legends', '.place .time', '.place .phase', '.place .strikes'].map((s) => document.querySelector(s).getBoundingClientRect())\
                 .map(({left, top, width, height}) => [left, top, width, height])";
    let before = page.value(boxes);
    // To chaos, to several attractors, onto a curve.
    for place in [[0.43, 0.72], [0.7, 0.93], [0.51, 0.7461]] {
        page.value(&format!(
            "use('state').then(([s]) => s.update({{place: [{}, {}]}}, true))",
            place[0], place[1]
        ));
        page.wait(PLACE);
        assert_eq!(page.value(boxes), before, "{place:?}");
    }
    assert_eq!(page.wait(&settled), words, "words move with the place");
    // A step of a slider leaves most labels where they are.
    page.value("document.getElementById('constant-zeta').focus()");
    page.press("ArrowRight");
    page.wait(WHOLE);
    let after = page.wait(&settled);
    let words = words.as_array().unwrap();
    let stay = words.iter().filter(|word| after.as_array().unwrap().contains(word)).count();
    assert!(5 * stay >= 4 * words.len() && words.len() > 8, "{stay} of {}: {after}", words.len());
    assert_eq!(page.value(boxes), before);
}

#[test]
fn a_place_goes_exactly_onto_a_curve_and_a_point_where_its_multipliers_are_told() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    let told = "document.querySelector('.on').textContent";
    for (kind, multiplier) in [("PD", "−1"), ("SN", "1"), ("GZ", ""), ("graz", "")] {
        // Far from points, which take precedence over curves.
        let beside = page.point(&format!(
            "use('diagram', 'plane', 'model', 'state').then(([d, p, m, s]) => {{ const to = p.project(m.viewOf(s.get())), marks = d.diagram.points.map((q) => to([q.primary, q.secondary])); \
             const clear = ([x, y]) => p.frame.x < x && x < p.frame.x + p.frame.w && p.frame.y < y && y < p.frame.y + p.frame.h && marks.every(([a, b]) => Math.hypot(a - x, b - y) > 25); \
             const free = [...d.diagram.curves.values()].filter((c) => c.kind === '{kind}' && c.starts).flatMap(({{points}}) => points.map(to).filter(clear)); \
             const [x, y] = free[free.length >> 1], b = document.getElementById('plane').getBoundingClientRect(); return [b.left + x + 2, b.top + y + 2]; }})"
        ));
        page.click_at(beside);
        page.wait(PLACE);
        page.wait(&format!("/^Go exactly onto/.test({told})"));
        page.click(".on button", [0.0, 0.0]);
        let words = page.wait(&format!("/^Exactly on/.test({told}) && {told}"));
        let words = words.as_str().unwrap().to_owned();
        assert_eq!(words.contains("multipliers"), kind != "graz", "{words}");
        let first = words.split("multipliers ").nth(1).unwrap_or_default().replace(',', " ");
        assert!(
            multiplier.is_empty() || first.split(' ').any(|number| number == multiplier),
            "{kind}: {words}"
        );
        page.wait(PLACE);
    }
    // A point is known to its last digit.
    let point =
        page.value("use('diagram').then(([d]) => d.diagram.points.find(({kind}) => kind === 'PD-GZ'))");
    let [x, y] = spot(&mut page, ["primary", "secondary"].map(|axis| point[axis].as_f64().unwrap()));
    page.click_at([x + 2.0, y]);
    page.wait(&format!("/^Go exactly onto PD-GZ/.test({told})"));
    page.click(".on button", [0.0, 0.0]);
    page.wait(&format!("/^Exactly on PD-GZ.*: multipliers .*−1\\b/.test({told})"));
    assert_eq!(state(&mut page, "place"), serde_json::json!([point["primary"], point["secondary"]]));
}

#[test]
fn two_places_stand_side_by_side_by_keys_alone() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    plane_key(&mut page, "ArrowRight");
    page.wait(PLACE);
    let first = state(&mut page, "place");
    page.press("k");
    for _ in 0..20 {
        page.press("ArrowLeft");
    }
    page.wait(&format!("document.querySelectorAll('#places .place:not([hidden])').length === 2 && {PLACE}"));
    assert_eq!(state(&mut page, "kept"), first);
    assert_ne!(state(&mut page, "place"), first);
    // Side by side if there is room.
    let boxes = page.value("[...document.querySelectorAll('#places .place')].map((e) => e.getBoundingClientRect()).map(({left, top}) => [left, top])");
    assert!(boxes[0] != boxes[1], "{boxes}");
    is_drawn(&mut page, "#places .kept .phase");
    // A screen reader announces what was found.
    page.wait("/^At /.test(document.getElementById('announce').textContent)");
    page.value("document.querySelector('.kept header button').focus()");
    page.press("Enter");
    assert_eq!(state(&mut page, "kept"), Value::Null);
}

#[test]
fn on_a_phone_a_finger_points_and_drags_the_ring() {
    let server = Running::shared();
    let Some(mut page) = server.open(PHONE) else { return };
    let at = spot(&mut page, [0.5, 0.8]);
    page.touch([at, at], 0);
    page.wait(PLACE);
    // The answer is beside the finger, on the same screen.
    let within = |page: &mut Browser, selector: &str| {
        let inside = "(({top, bottom}, height) => top >= 0 && bottom <= height)";
        page.value(&format!(
            "{inside}(document.querySelector('{selector}').getBoundingClientRect(), innerHeight)"
        ))
    };
    assert_eq!((within(&mut page, "#stage"), within(&mut page, ".place .time")), (true.into(), true.into()));
    let first = numbers(&state(&mut page, "place"));
    let [x, y] = page.middle("#handle");
    page.touch([[x, y], [x + 60.0, y - 20.0]], 4);
    let second = numbers(&state(&mut page, "place"));
    assert!(second[0] > first[0] && second[1] > first[1], "{first:?} {second:?}");
    page.wait(PLACE);
    assert_eq!(page.value("document.documentElement.scrollWidth"), 360);
    // A pinch that begins at the ring leaves the place where it was.
    let place = state(&mut page, "place");
    let [x, y] = page.middle("#handle");
    page.fingers(&[&[[x + 4.0, y]], &[[x + 4.0, y], [x - 60.0, y]], &[[x + 14.0, y], [x - 80.0, y]]]);
    assert_eq!(state(&mut page, "place"), place);
    assert!(!state(&mut page, "view").is_null());
    page.value("document.querySelector('[data-command=horizontal]').click()");
    page.wait(CUT);
    // The plane, the cut and what is said of the place share the screen.
    let edges = page.value("['stage', 'cut', 'place-section'].map((id) => document.getElementById(id).getBoundingClientRect()).map(({top, bottom}) => [top, bottom])");
    let edge = |at: usize, end: usize| edges[at][end].as_f64().unwrap();
    assert!(
        edge(0, 0) >= 0.0 && edge(0, 1) <= edge(1, 0) && edge(1, 1) <= edge(2, 0) && edge(2, 1) <= 741.0,
        "{edges}"
    );
    assert!(edge(1, 1) - edge(1, 0) > 120.0, "{edges}");
    assert_eq!(page.value("document.documentElement.scrollWidth"), 360);
}

/// The cut and its simulation are shown, and the page is idle.
pub(crate) const CUT: &str = "!document.documentElement.hasAttribute('data-busy') && !document.getElementById('cut-panel').hidden && document.getElementById('cut-message').hidden && \
                   !document.getElementById('cut').hasAttribute('aria-busy') && \
                   use('cut').then(([c]) => c.shown()?.dots.length > 0 && c.shown().strands.length > 0 && !c.shown().old)";

/// The place in the cut of a value of its parameter.
fn across(page: &mut Browser, share: f64) -> [f64; 2] {
    let [_, y] = page.middle("#cut");
    let [left, right] = page.point(
        "use('plane').then(([p]) => { const b = document.getElementById('cut').getBoundingClientRect(), m = p.margins(b.width); \
         return [b.left + m.left, b.right - m.right]; })",
    );
    [left + share * (right - left), y]
}

#[test]
fn a_cut_and_the_plane_point_at_each_other() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    let at = spot(&mut page, [0.4, 0.8]);
    page.click_at(at);
    page.click("[data-command=horizontal]", [0.0, 0.0]);
    page.wait(CUT);
    is_drawn(&mut page, "#cut");
    // The pointer in the cut is shown in the plane, and a click moves the place along the line.
    let half = across(&mut page, 0.5);
    page.hover(half);
    let pointer = page.wait("use('plane').then(([p]) => p.shown.pointer)").as_f64().unwrap();
    assert!((pointer - 0.6).abs() < 0.01, "{pointer}");
    page.click_at(half);
    let moved = numbers(&state(&mut page, "place"));
    assert!((moved[0] - 0.6).abs() < 0.01 && (moved[1] - 0.8).abs() < 0.01, "{moved:?}");
    // The place in the plane moves the line of the cut.
    let asked = "use('cut').then(([c]) => c.shown().at)";
    assert_eq!(page.value(asked).as_f64(), Some(moved[1]));
    let [x, y] = spot(&mut page, [moved[0], moved[1]]);
    page.drag([[x, y], [x, y + 40.0]], 3, 0, |_| ());
    page.wait(&format!("{CUT}.then((there) => there && use('cut', 'state')).then((both) => both && both[0].shown().at === both[1].get().place[1])"));
    assert!(page.value(asked).as_f64() < Some(moved[1]));
}

#[test]
fn cuts_are_made_and_walked_along_by_keys() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    // Along the frequency motion is integrated: one number of loops is enough here.
    for loops in [2, 3] {
        page.value(&format!("document.querySelector('#loops-list input[value=\"{loops}\"]').click()"));
    }
    plane_key(&mut page, "v");
    page.wait(CUT);
    assert_eq!(
        page.value("document.querySelector('[data-command=vertical]').getAttribute('aria-pressed')"),
        "true"
    );
    let before = numbers(&state(&mut page, "place"));
    page.value("document.getElementById('cut').focus()");
    let said = page.value("document.getElementById('cut').getAttribute('aria-valuetext')");
    page.press("ArrowRight");
    let after = numbers(&state(&mut page, "place"));
    assert!(after[0] == before[0] && after[1] > before[1], "{before:?} {after:?}");
    page.wait(&format!("document.getElementById('cut').getAttribute('aria-valuetext') !== {said}"));
    plane_key(&mut page, "h");
    page.wait(CUT);
    assert_eq!(state(&mut page, "cut"), "secondary");
    plane_key(&mut page, "h");
    assert_eq!(page.value("document.getElementById('cut-panel').hidden"), true);
    page.wait(WHOLE);
}
