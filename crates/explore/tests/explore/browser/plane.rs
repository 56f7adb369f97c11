//! The plane while it grows, while it is zoomed, and when it is stopped.

use serde_json::Value;

use super::chromium::{Browser, SHIFT};
use super::{
    CURVES, DESK, HOLD, PHONE, QUIET, Running, WHOLE, choose_duffing, keys, numbers, plane_key, spot, state,
};

/// Curves are shown, and the computation goes on.
const GROWS: &str = "use('diagram').then(([d]) => d.isBusy() && d.diagram.curves.size > 0 && d.diagram.regions.length === 0 && \
                     !document.getElementById('stop').hidden && !document.getElementById('progress').hidden && \
                     / \\d+ of \\d+$/.test(document.getElementById('progress-text').textContent))";
const STOPPED: &str = "use('diagram').then(([d]) => /^Stopped/.test(document.getElementById('progress-text').textContent) && !d.isBusy())";

#[test]
fn curves_come_before_the_end_and_the_end_can_be_had_by_button_and_key() {
    let server = Running::new();
    let Some(mut page) = server.open(DESK) else { return };
    page.value(HOLD);
    choose_duffing(&mut page);
    page.wait(GROWS);
    page.click("#stop", [0.0, 0.0]);
    page.wait(STOPPED);
    // The curves found stay; nothing is added.
    let found = page.value(CURVES);
    assert!(!keys(&found).is_empty());
    page.value("letGo()");
    page.wait(QUIET);
    let regions = page.value("use('diagram').then(([d]) => d.diagram.regions.length)");
    assert_eq!((page.value(CURVES), regions), (found, Value::from(0)));
    page.value(HOLD);
    plane_key(&mut page, "+");
    page.wait("use('diagram').then(([d]) => d.isBusy() && !document.getElementById('stop').hidden)");
    plane_key(&mut page, "Escape");
    page.wait(STOPPED);
}

/// The parameters at a spot of the screen.
fn under(page: &mut Browser, [x, y]: [f64; 2]) -> [f64; 2] {
    page.point(&format!(
        "use('plane').then(([p]) => {{ const b = document.getElementById('plane').getBoundingClientRect(); return p.toParameters({x} - b.left, {y} - b.top); }})"
    ))
}

#[test]
fn views_without_grazing_show_what_is_there_and_so_do_their_addresses() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    // Around the middle of the first PD curve and of the first GZ curve.
    let middles = page.value(
        "use('diagram').then(([d]) => ['PD', 'GZ'].map((kind) => { const {points} = [...d.diagram.curves.values()]\
         .find((curve) => curve.kind === kind && curve.n > 0 && curve.source === 'continuation'); return points[points.length >> 1]; }))",
    );
    for (kind, middle) in ["PD", "GZ"].into_iter().zip(middles.as_array().unwrap()) {
        for width in [1e-3, 1e-9] {
            let [primary, secondary] = [0, 1].map(|k| {
                let middle = middle[k].as_f64().unwrap();
                [middle - width, middle + width]
            });
            let view = serde_json::json!({"primary": primary, "secondary": secondary});
            page.value(&format!("use('state').then(([s]) => s.update({{view: {view}}}))"));
            let seen = format!(
                "use('plane').then(([p]) => p.runs.some(({{curve}}) => curve.kind === '{kind}')).then((there) => there && {WHOLE})"
            );
            page.wait(&seen);
            let address =
                page.wait("use('state').then(([s]) => s.encode(s.get()) === location.hash && location.href)");
            let Some(mut other) = Browser::open(address.as_str().unwrap(), DESK) else { return };
            other.wait(&seen);
            assert!(other.value("use('diagram').then(([d]) => d.diagram.regions.length)").as_u64() > Some(0));
        }
    }
    // In a view without curves, stable regions are shown, with a message that no curve crosses.
    page.value(
        "use('state').then(([s]) => s.update({view: {primary: [0.1, 0.11], secondary: [0.6, 0.61]}}))",
    );
    let told = page.wait(&format!("{QUIET} && /^No grazing/.test(document.getElementById('progress-text').textContent) && document.getElementById('progress-text').textContent"));
    assert!(
        told.as_str()
            .unwrap()
            .contains("stays clear of it everywhere in A = [0.1, 0.11], omega = [0.6, 0.61]"),
        "{told}"
    );
    let notes = "document.getElementById('notes-list').textContent";
    let question = page.value(notes);
    assert!(
        question.as_str().unwrap().contains("has a frequency of 1, and the forcing 0.6 to 0.61, in radians"),
        "{question}"
    );
    assert_eq!(
        page.value("use('diagram').then(([d]) => d.diagram.regions.map(({kind}) => kind))"),
        serde_json::json!(["non-impacting"])
    );
    assert_eq!(page.value("document.getElementById('progress-text').classList.contains('bad')"), false);
    // Where nothing is stable all motion reaches beyond the wall.
    page.value("use('state').then(([s]) => s.update({view: {primary: [2, 2.1], secondary: [0.3, 0.31]}}))");
    page.wait(&format!("{QUIET} && /crosses it everywhere in A = .2, 2\\.1., .*, where it goes 1\\.\\d+ beyond it/.test(document.getElementById('progress-text').textContent)"));
    // Of a view that reaches beyond what the oscillator allows the rest is drawn, and the command is about it.
    page.value(
        "use('state').then(([s]) => s.update({view: {primary: [-0.4, 1.2], secondary: [-0.4, 1.1]}}))",
    );
    page.wait(&format!("{WHOLE}.includes('Drawn for ω from 0.0')"));
    assert!(
        page.value(notes).as_str().unwrap().contains("motion.frequency: the frequency is -0.4 at A = -0.4")
    );
    let drawn = page.value("use('diagram', 'state', 'share').then(([d, s, h]) => [d.drawnView(s.get()).secondary, h.command(s.get())])");
    let low = drawn[0][0].as_f64().unwrap();
    assert!((0.06..0.1).contains(&low) && drawn[0][1] == 1.1, "{drawn}");
    assert!(drawn[1].as_str().unwrap().contains(&format!("'fig07.frequency=[{low},1.1]'")), "{drawn}");
    // Grey below, white above.
    let ink = |page: &mut Browser, at: [f64; 2]| {
        page.value(&format!("use('plane', 'model', 'state').then(([p, m, s]) => {{ const [x, y] = p.project(m.viewOf(s.get()))([{}, {}]).map(Math.round); \
             return [...document.getElementById('plane').getContext('2d').getImageData(x, y, 1, 1).data].join(); }})", at[0], at[1]))
    };
    let [below, calm] = [[0.1, -0.2], [0.1, 0.7]].map(|at| ink(&mut page, at));
    assert!(
        below == ink(&mut page, [1.1, -0.35]) && below != calm && below != "255,255,255,255",
        "{below} {calm}"
    );
    plane_key(&mut page, "0");
    page.wait(&format!("use('diagram').then(([d]) => d.diagram.part === null && {WHOLE})"));
}

#[test]
fn zooming_by_wheel_box_and_drag_computes_anew_and_going_back_undoes_each() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    let middle = page.middle("#plane");
    let view = |page: &mut Browser| {
        let view = state(page, "view");
        [numbers(&view["primary"]), numbers(&view["secondary"])].concat()
    };
    // The number of steps in the history, once the address has followed the view to rest.
    let step =
        "use('state').then(([s]) => s.encode(s.get()) === location.hash && (history.state?.step ?? 0))";
    page.wheel(middle, -300.0);
    page.wait(&format!("location.hash !== '' && {WHOLE}"));
    let wheeled = view(&mut page);
    let [from, to] = [[0.3, 0.6], [0.9, 0.9]].map(|place| spot(&mut page, place));
    page.drag([from, to], 4, SHIFT, |_| ());
    let boxed = view(&mut page);
    for (edge, wanted) in boxed.iter().zip([0.3, 0.9, 0.6, 0.9]) {
        assert!((edge - wanted).abs() < 0.01, "{boxed:?}");
    }
    page.wait(step);
    // As on a map: the point under the pointer moves with it, and no place is selected.
    let under = under(&mut page, middle);
    page.drag([middle, [middle[0] + 80.0, middle[1]]], 4, 0, |_| ());
    let moved = view(&mut page);
    assert!(moved[0] < boxed[0] && (moved[2] - boxed[2]).abs() < 1e-9, "{moved:?}");
    let here = self::under(&mut page, [middle[0] + 80.0, middle[1]]);
    assert!((0..2).all(|k| (under[k] - here[k]).abs() < 0.01), "{under:?} {here:?}");
    assert_eq!(state(&mut page, "place"), Value::Null);
    page.wait(step);
    page.click("[data-command=back]", [0.0, 0.0]);
    page.wait(&format!("use('state').then(([s]) => s.get().view.primary[0] === {:?})", boxed[0]));
    plane_key(&mut page, "[");
    page.wait(&format!("use('state').then(([s]) => s.get().view.primary[0] === {:?})", wheeled[0]));
    plane_key(&mut page, "]");
    page.wait(&format!("use('state').then(([s]) => s.get().view.primary[0] === {:?})", boxed[0]));
    page.wait(WHOLE);
    page.click("[data-command=whole]", [0.0, 0.0]);
    assert_eq!(state(&mut page, "view"), Value::Null);
}

#[test]
fn zooming_goes_down_to_a_billionth_about_a_resonance() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    let stage = "(({left, top, width, height}) => [left, top, width, height])(document.getElementById('stage').getBoundingClientRect())";
    let before = page.value(stage);
    page.click("#resonances summary", [0.0, 0.0]);
    assert_eq!(page.value(stage), before, "the list squeezes the plane");
    page.click("#resonances tbody button", [0.0, 0.0]);
    page.wait(&format!("location.hash !== '' && {WHOLE}"));
    // In a part of the plane the approximations are drawn beside the curves that they approximate, dashed.
    assert_eq!(page.value("document.getElementById('quadratic').hidden"), false);
    let near = "use('diagram', 'model', 'state').then(([d, m, s]) => { const {primary: [a, b], secondary: [c, e]} = m.viewOf(s.get()); \
                const centre = [(a + b) / 2, (c + e) / 2]; const all = [...d.diagram.curves.values()]; \
                const gap = (curve) => Math.min(...curve.points.map(([p, q]) => Math.hypot((p - centre[0]) / (b - a), (q - centre[1]) / (e - c)))); \
                return all.filter(({source}) => source === 'quadratic').map((one) => [one.kind, gap(one), \
                gap(all.find(({key}) => `${key} quadratic` === one.key) ?? {points: []})]); })";
    let found = page.value(near);
    let close =
        |pair: &&Value| pair[1].as_f64().unwrap() < 0.02 && pair[2].as_f64().is_some_and(|gap| gap < 0.05);
    let kinds: Vec<&str> =
        found.as_array().unwrap().iter().filter(close).map(|pair| pair[0].as_str().unwrap()).collect();
    assert!(kinds.contains(&"SN") && kinds.contains(&"PD"), "{found}");
    // The curve on which period-doubled solutions graze also has one, a parabola like the others.
    let doubled = "use('diagram').then(([d]) => [...d.diagram.curves.values()].filter(({tells}) => /^2GZ/.test(tells)) \
                   .map(({points}) => points.length))";
    let doubled = page.value(doubled);
    assert!(
        doubled.as_array().is_some_and(|all| !all.is_empty())
            && numbers(&doubled).iter().all(|count| *count > 2.0),
        "{doubled}"
    );
    for _ in 0..45 {
        plane_key(&mut page, "+");
    }
    page.wait(&format!("use('diagram').then(([d]) => !d.isBusy()).then((rests) => rests && {WHOLE})"));
    let ranges = "use('model', 'state').then(([m, s]) => ['primary', 'secondary'].map((axis) => m.viewOf(s.get())[axis]))";
    let width = page.value(&format!("{ranges}.then((both) => both.map(([low, high]) => high - low))"));
    assert!(numbers(&width).iter().all(|width| (1e-10..1e-9).contains(width)), "{width}");
    // Ticks distinguish places: an offset in the title, and short numbers that differ.
    let labels = page.value(&format!(
        "use('axes').then(([a]) => {ranges}.then((both) => both.map((range) => {{ const {{found, offset}} = a.ticks(range, 8); \
         return [offset !== null, ...found.map(({{label}}) => label).filter((label) => label !== null)]; }})))"
    ));
    for axis in labels.as_array().unwrap() {
        let [offset, labels @ ..] = axis.as_array().unwrap().as_slice() else { panic!("{axis}") };
        assert!(offset == true && labels.len() >= 3, "{axis}");
        assert!(labels.iter().all(|label| label.as_str().unwrap().len() <= 6), "{axis}");
        assert!(labels.windows(2).all(|pair| pair[0] != pair[1]), "{axis}");
    }
    // The resonance is still there, and the grazing curve passes through it.
    let graz = "use('diagram', 'plane').then(([d, p]) => [d.diagram.points.filter(({kind}) => kind === 'resonance').length, \
                p.runs.filter(({curve}) => curve.kind === 'graz').length])";
    assert!(numbers(&page.value(graz)).iter().all(|count| *count >= 1.0));
}

#[test]
fn on_a_phone_the_plane_is_pinched_and_nothing_is_wider_than_the_screen() {
    let server = Running::shared();
    let Some(mut page) = server.open(PHONE) else { return };
    assert_eq!(page.value("document.documentElement.scrollWidth"), 360);
    let small = "[...document.querySelectorAll('button')].filter(b => b.offsetParent && Math.min(b.offsetWidth, \
                 b.offsetHeight) < 40).length";
    assert_eq!(page.value(small), 0);
    let [x, y] = page.middle("#plane");
    let fingers = |apart: f64| [[x - apart, y], [x + apart, y]];
    page.fingers(&[&fingers(40.0), &fingers(60.0), &fingers(80.0)]);
    let view = state(&mut page, "view");
    let [low, high] = [0, 1].map(|end| view["primary"][end].as_f64().unwrap());
    // Fingers twice as far apart show half as much.
    assert!((high - low - 0.65).abs() < 0.07, "{view}");
    page.wait(&format!("location.hash !== '' && {WHOLE}"));
    // A box is drawn with a finger after its button is pressed.
    page.click("[data-command=box]", [0.0, 0.0]);
    let [x, y] = page.middle("#plane");
    page.touch([[x - 60.0, y - 60.0], [x + 60.0, y + 60.0]], 4);
    assert_ne!(state(&mut page, "view"), view);
    assert_eq!(page.value("document.documentElement.scrollWidth"), 360);
}
