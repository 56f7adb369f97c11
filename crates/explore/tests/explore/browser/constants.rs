//! Changing constants.

use grazing_explore::Limits;
use serde_json::Value;

use super::chromium::Browser;
use super::{CURVES, DESK, HOLD, HOUR, PHONE, Running, WHOLE, choose_duffing, plane_key, state};

/// Whether pixels of the plane in the middle of a run of each kind of curve have the ink of that kind.
const INKED: &str = "use('plane', 'palette').then(([p, q]) => { const canvas = document.getElementById('plane'); \
                     const context = canvas.getContext('2d'); const probe = document.createElement('canvas').getContext('2d'); \
                     const inks = new Map(); for (const {curve, points, bounds} of p.runs) { if (curve.source === 'quadratic' || !bounds) continue; \
                     probe.fillStyle = q.penOf(curve).colour; const [, r, g, b] = /#(..)(..)(..)/.exec(probe.fillStyle).map((x) => parseInt(x, 16)); \
                     const near = points.some(([x, y]) => { const d = context.getImageData(Math.round(x) - 1, Math.round(y) - 1, 3, 3).data; \
                     for (let i = 0; i < d.length; i += 4) if (Math.hypot(d[i] - r, d[i + 1] - g, d[i + 2] - b) < 30) return true; return false; }); \
                     inks.set(curve.key, (inks.get(curve.key) ?? false) || near); } return Object.fromEntries(inks); })";

fn grazing(curves: &Value) -> &Value {
    curves.as_array().unwrap().iter().find(|curve| curve["kind"] == "graz").unwrap()
}

/// Asserts that curves of resonances with the same key before and after a small step are the same:
/// most have a counterpart, and each of these runs close to where it was. Curves without a
/// resonance are known by their kind alone.
fn assert_same(before: &Value, after: &Value) {
    let (before, after) = (before.as_array().unwrap(), after.as_array().unwrap());
    let points = |curve: &Value| -> Vec<[f64; 2]> {
        let points = curve["points"].as_array().unwrap().iter();
        points.map(|point| [0, 1].map(|index| point[index].as_f64().unwrap())).collect()
    };
    let of_resonances: Vec<&Value> = before.iter().filter(|curve| curve["n"] != 0).collect();
    let mut same = 0;
    for &old in &of_resonances {
        let Some(new) = after.iter().find(|new| new["key"] == old["key"]) else { continue };
        let (old_points, new_points) = (points(old), points(new));
        let gap = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).abs().max((a[1] - b[1]).abs());
        let middle = new_points[new_points.len() / 2];
        let near = old_points.iter().map(|point| gap(point, &middle)).fold(f64::INFINITY, f64::min);
        assert!(near < 0.06, "{}: {near}", old["key"]);
        same += 1;
    }
    assert!(same * 10 >= 8 * of_resonances.len(), "{same} of {}", of_resonances.len());
}

/// Curves to which no resonance leads, by key.
const NUMBERED: &str = "use('diagram').then(([d]) => [...d.diagram.curves.values()].filter(({n, source}) => n === 0 && source === 'continuation')\
                        .map(({key, points}) => [key, points]).sort())";

#[test]
fn curves_that_no_resonance_leads_to_keep_their_numbers_in_one_drag_as_in_small_steps() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    let at_once = |page: &mut Browser, steps: u32| {
        page.value(&format!(
            "(() => {{ const s = document.getElementById('constant-zeta'); s.value = Number(s.value) + {steps}; \
             for (const name of ['input', 'change']) s.dispatchEvent(new Event(name)); }})()"
        ));
        page.wait(WHOLE);
    };
    at_once(&mut page, BEFORE);
    let start = format!("{}{}", server.address, page.value("location.hash").as_str().unwrap());
    let mut walk = |steps: u32, small: bool| {
        // A new page: no curves are known from before.
        page.go("about:blank");
        page.go(&start);
        page.wait(WHOLE);
        let before = page.value(NUMBERED);
        page.value("document.getElementById('constant-zeta').focus()");
        if small {
            for _ in 0..steps {
                page.press("ArrowRight");
                page.wait(WHOLE);
            }
        } else {
            at_once(&mut page, steps);
        }
        (before, page.value(NUMBERED))
    };
    let names = |curves: &Value| -> Vec<String> {
        curves.as_array().unwrap().iter().map(|curve| curve[0].as_str().unwrap().to_owned()).collect()
    };
    let (before, small) = walk(STEPS, true);
    let (_, large) = walk(STEPS, false);
    assert!(small == large, "{:?} and {:?}", names(&small), names(&large));
    // Some curves have gone, with lower numbers than others: in the order in which they are found
    // these would have moved up.
    let of_kind = |curves: &Value| -> Vec<String> {
        names(curves).into_iter().filter(|name| name.starts_with(NUMEROUS)).collect()
    };
    let (old, new) = (of_kind(&before), of_kind(&small));
    assert!(
        new.len() >= 2 && new.len() < old.len() && new.iter().all(|name| old.contains(name)),
        "{old:?} {new:?}"
    );
    let moved_up: Vec<String> = (0..new.len()).map(|number| format!("{NUMEROUS}#{number}")).collect();
    assert_ne!(new, moved_up);
}

/// Curves of which the paper's oscillator has several, the number of steps of its damping ratio after which all of them
/// are still there, and the number of further steps after which some are gone.
const NUMEROUS: &str = "GZ 2 0 ";
const BEFORE: u32 = 14;
const STEPS: u32 = 6;

#[test]
fn a_curve_that_goes_leaves_the_others_their_numbers_and_one_that_comes_gets_a_new_one() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    let mut names = |before: &str, list: &str| {
        page.value(&format!(
            "use('lasting').then(([l]) => {{ const curve = ([key, y, from = 0]) => ({{key, group: key.split('#')[0], n: key.split(' ')[2] * 1, source: 'continuation', \
             points: [[from, y], [0.5, y], [1, y]]}}); return l.lasting({list}.map(curve), {before}.map(curve), {{primary: [0, 1], secondary: [0, 1]}})\
             .entries().toArray().map((pair) => pair.join(' is ')).sort(); }})"
        ))
    };
    let two = "[['GZ 2 0 #0', 0.2], ['GZ 2 0 #1', 0.6]]";
    // The first one goes, and the other one is found first.
    assert_eq!(names(two, "[['GZ 2 0 #0', 0.62]]"), serde_json::json!(["GZ 2 0 #0 is GZ 2 0 #1"]));
    // Both are found in the other order, and one is cut off by the view.
    let other = names(two, "[['GZ 2 0 #0', 0.58, 0.4], ['GZ 2 0 #1', 0.22]]");
    assert_eq!(other, serde_json::json!(["GZ 2 0 #0 is GZ 2 0 #1", "GZ 2 0 #1 is GZ 2 0 #0"]));
    // A new one appears far from both, and first; other kinds and curves of resonances are left alone.
    let more = names(
        two,
        "[['GZ 2 0 #0', 0.95], ['GZ 2 0 #1', 0.2], ['GZ 2 0 #2', 0.6], ['SN 2 0 #0', 0.6], ['GZ 2 3 #0', 0.6]]",
    );
    assert_eq!(
        more,
        serde_json::json!([
            "GZ 2 0 #0 is GZ 2 0 #2",
            "GZ 2 0 #1 is GZ 2 0 #0",
            "GZ 2 0 #2 is GZ 2 0 #1",
            "SN 2 0 #0 is SN 2 0 #0"
        ])
    );
    // The number of a curve that goes as another appears is not reused.
    let new = names(two, "[['GZ 2 0 #0', 0.95], ['GZ 2 0 #1', 0.6]]");
    assert_eq!(new, serde_json::json!(["GZ 2 0 #0 is GZ 2 0 #2", "GZ 2 0 #1 is GZ 2 0 #1"]));
}

/// Counts requests for coarse diagrams, which are curves without regions.
const COUNT_COARSE: &str = "(() => { window.coarse = 0; const ask = window.fetch.bind(window); window.fetch = (path, options) => { \
                            if (path === './diagram' && JSON.parse(options.body).coarse) window.coarse += 1; return ask(path, options); }; })()";

#[test]
fn a_slider_moves_the_diagram_while_it_is_dragged_and_completes_it_when_it_rests() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    let before = page.value(CURVES);
    let [x, y] = page.middle("#constant-zeta");
    // The place of the thumb, computed from the slider's value.
    let thumb = page.point(
        "(() => { const s = document.getElementById('constant-zeta'), b = s.getBoundingClientRect(); \
         return [b.left + 8 + (b.width - 16) * s.value / s.max, b.top + b.height / 2]; })()",
    );
    assert!((thumb[1] - y).abs() < 2.0 && thumb[0] < x);
    page.value(COUNT_COARSE);
    let mut seen = vec![grazing(&before)["points"].clone()];
    page.drag([thumb, [thumb[0] + 40.0, thumb[1]]], 4, 0, |page| {
        // The pointer is still down: coarse diagrams come first.
        let last = seen.last().unwrap();
        page.wait(&format!(
            "{CURVES}.then((all) => JSON.stringify(all.find(({{kind}}) => kind === 'graz').points) !== JSON.stringify({last}))"
        ));
        let now = page.value(CURVES);
        assert_same(&before, &now);
        seen.push(grazing(&now)["points"].clone());
    });
    assert_eq!(seen.len(), 5);
    assert!(page.value("coarse").as_u64() >= Some(1), "nothing was asked for while the pointer moved");
    page.wait(WHOLE);
    assert_eq!(page.value("use('diagram').then(([d]) => d.diagram.stale)"), false);
    let after = page.value(CURVES);
    assert_same(&before, &after);
    assert_ne!(grazing(&after)["points"], grazing(&before)["points"]);
    assert!(page.value("use('diagram').then(([d]) => d.diagram.regions.length)").as_u64() > Some(0));
    let inks = page.value(INKED);
    let (inked, all) = (
        inks.as_object().unwrap().values().filter(|ink| **ink == true).count(),
        inks.as_object().unwrap().len(),
    );
    assert!(inked * 10 >= all * 9 && all >= 10, "{inks}");
}

#[test]
fn constants_are_moved_by_keys_typed_and_taken_back() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    page.value("document.getElementById('constant-epsilon').focus()");
    page.press("ArrowLeft");
    page.press("ArrowLeft");
    let moved = state(&mut page, "set.epsilon").as_f64().unwrap();
    page.wait(WHOLE);
    assert!(moved < 0.9, "{moved}");
    let field = "document.querySelector('#constants-list input[aria-label=\"zeta, value\"]')";
    page.value(&format!("({field}.focus(), {field}.select())"));
    page.write("0.05");
    page.press("Enter");
    assert_eq!(state(&mut page, "set.zeta"), 0.05);
    page.wait(WHOLE);
    // A text that is not a number changes nothing and is marked; a value that the program rejects
    // is reported. Both beside the field.
    let why = "document.querySelector('#constants-list .why:not([hidden])')?.textContent";
    page.value(&format!("({field}.focus(), {field}.select())"));
    page.write("many");
    page.press("Enter");
    assert_eq!(
        (state(&mut page, "set.zeta"), page.value(&format!("{field}.className"))),
        (0.05.into(), "bad".into())
    );
    page.wait(&format!("/^“many” is not a number; zeta is still 0.05/.test({why})"));
    page.value(&format!("({field}.focus(), {field}.select())"));
    page.write("2");
    page.press("Enter");
    page.wait("document.getElementById('progress-text').classList.contains('bad') && document.getElementById('progress-text').textContent");
    page.wait(&format!("/damping ratio is 2/.test({why})"));
    for _ in 0..2 {
        page.value("document.querySelector('#constants-list .reset:not([hidden])').focus()");
        page.press("Enter");
    }
    assert_eq!(state(&mut page, "set"), serde_json::json!({}));
    page.wait(WHOLE);
}

#[test]
fn what_is_not_of_the_constants_that_were_typed_fades_at_once() {
    let server = Running::new();
    let Some(mut page) = server.open(DESK) else { return };
    let at = super::spot(&mut page, [0.9, 0.8]);
    page.click_at(at);
    page.wait(super::PLACE);
    let inked = |page: &mut super::Browser| {
        let inks = page.value(INKED);
        let inks = inks.as_object().unwrap();
        (inks.values().filter(|ink| **ink == true).count(), inks.len())
    };
    let (strong, all) = inked(&mut page);
    assert!(strong * 10 >= all * 8 && all >= 10, "{strong} of {all}");
    // No answer arrives: the old curves stay in view.
    page.value("(() => { window.fetch = () => new Promise(() => {}); })()");
    let field = "document.querySelector('#constants-list input[aria-label=\"zeta, value\"]')";
    page.value(&format!("({field}.focus(), {field}.select())"));
    page.write("0.05");
    page.press("Enter");
    page.wait(
        "new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(() => drawn(true))))",
    );
    assert_eq!(inked(&mut page), (0, all));
    assert_eq!(page.value("document.querySelector('.place').classList.contains('stale')"), true);
}

#[test]
fn on_a_phone_a_slider_follows_the_finger() {
    let server = Running::shared();
    let Some(mut page) = server.open(PHONE) else { return };
    let [x, y] = page.middle("#constant-zeta");
    page.touch([[x - 20.0, y], [x + 20.0, y]], 3);
    page.wait("use('state').then(([s]) => s.get().set.zeta > 0)");
    page.wait(WHOLE);
}

#[test]
fn computations_that_are_out_of_date_end_on_the_server() {
    // If only one computation runs at once, any that went on would block the others.
    let server = Running::with(Limits { computations: 1, time: HOUR, ..Limits::default() });
    let Some(mut page) = server.open(DESK) else { return };
    page.value(HOLD);
    choose_duffing(&mut page);
    page.wait("use('diagram').then(([d]) => d.isBusy())");
    page.value("document.getElementById('oscillator').focus()");
    page.press("ArrowUp");
    page.value("letGo()");
    page.wait(&format!("/Paper|[Ll]inear/.test(document.title) && {WHOLE}"));
    // Simulation of this many places over this many periods would take hours; later requests take
    // their usual time.
    page.value(
        "(() => { const ask = window.fetch.bind(window); window.fetch = (path, options) => { if (path !== './tiles') return ask(path, options); \
         const more = {...JSON.parse(options.body), columns: 1000, rows: 1000, periods: 5000}; return ask(path, {...options, body: JSON.stringify(more)}); }; \
         window.askAsEver = () => { window.fetch = ask; }; })()",
    );
    plane_key(&mut page, "o");
    page.wait("/^Simulating: 0 % of/.test(document.getElementById('tiles-status').textContent)");
    page.value("askAsEver()");
    page.value("document.getElementById('constant-zeta').focus()");
    page.press("ArrowRight");
    page.wait(
        "use('diagram').then(([d]) => !d.diagram.stale && !d.isBusy() && d.diagram.regions.length > 0)",
    );
}
