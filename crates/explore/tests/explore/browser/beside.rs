//! Straightened curves, measurements, ordinates of the cut, and followed solutions, in the page.

use super::places::CUT;
use super::{DESK, PLACE, QUIET, Running, WHOLE, plane_key, spot, state};

/// Straightened coordinates are shown, and the page is idle.
const STRAIGHT: &str = "!document.documentElement.hasAttribute('data-busy') && !document.getElementById('straightened').hidden && \
                        document.querySelector('[data-command=straighten]').getAttribute('aria-pressed')";
/// Opens a file as by dropping it on the plane.
const DROP: &str = "(text) => { const data = new DataTransfer(); data.items.add(new File([text], 'rig.csv', {type: 'text/csv'})); \
                    document.getElementById('stage').dispatchEvent(new DragEvent('drop', {dataTransfer: data, bubbles: true, cancelable: true})); }";

#[test]
fn straightened_coordinates_come_when_asked_for_and_by_themselves_where_all_curves_lie_on_one_line() {
    let server = Running::new();
    let Some(mut page) = server.open(DESK) else { return };
    assert_eq!(page.value("document.getElementById('straightened').hidden"), true);
    let asked = "(() => { const ask = window.fetch.bind(window); window.asked = []; window.fetch = (path, options) => { if (path === './export') window.asked.push(JSON.parse(options.body).of); return ask(path, options); }; })()";
    page.value(asked);
    page.click("[data-command=straighten]", [0.0, 0.0]);
    page.wait(STRAIGHT);
    // The request is about the resonance that is named.
    let named = "use('diagram').then(([d]) => d.diagram.resonances.some(({p, n, primary, secondary}) => JSON.stringify(asked.at(-1)) === JSON.stringify({straightened: [primary, secondary]}) \
                 && document.getElementById('straightened-what').textContent === `p = ${p}, n = ${n}`))";
    assert_eq!(page.value(named), true);
    page.click("[data-command=straighten]", [0.0, 0.0]);
    page.wait(&format!("{QUIET} && document.getElementById('straightened').hidden"));
    // Now automatic again, so that they are shown at a resonance from near.
    page.value("use('state').then(([s]) => s.update({straight: null}))");
    page.value("use('diagram', 'state').then(([d, s]) => { const bend = (r) => Math.max(Math.abs(r.c_sn), Math.abs(r.c_pd)); \
                const {primary: p, secondary: q} = d.diagram.resonances.filter(({holds}) => holds).sort((a, b) => bend(a) - bend(b))[0]; const w = 1e-6; \
                s.update({view: {primary: [p - w, p + w], secondary: [q - w, q + w]}}); })");
    page.wait(&format!("use('diagram').then(([d]) => !d.diagram.stale && {STRAIGHT})"));
    page.wait(WHOLE);
    plane_key(&mut page, "0");
    page.wait(&format!("{QUIET} && document.getElementById('straightened').hidden"));
}

#[test]
fn a_file_of_measurements_is_dropped_on_the_plane_and_what_disagrees_is_listed() {
    let server = Running::new();
    let Some(mut page) = server.open(DESK) else { return };
    let text = "amplitude,omega,seen,periods,impacts\\n0.05,0.8,none,,\\n0.9,0.8,periodic,1,1\\n0.05,0.8,periodic,1,1\\n";
    page.value(&format!("({DROP})('{text}')"));
    page.wait(&format!("{QUIET} && /Line 4, 1 impact in 1 period: /.test(document.getElementById('measured-against').textContent)"));
    assert_eq!(page.value("document.querySelectorAll('#measured-marks li').length"), 4);
    // The pointer shows what was measured.
    let at = spot(&mut page, [0.9, 0.8]);
    page.hover(at);
    page.wait("/measured \\(line 3\\): 1 impact in 1 period, agrees/.test(document.getElementById('pointer').textContent)");
    // The file is in the address, and the command names it; the paper's oscillator has none.
    assert_eq!(page.value("use('state').then(([s]) => s.decode(s.encode(s.get())).data.name)"), "rig.csv");
    page.value(&format!("({DROP})('amplitude,omega,seen\\n1,1,nothing\\n')"));
    page.wait(&format!(
        "{QUIET} && /^rig.csv:2: /.test(document.getElementById('measured-message').textContent)"
    ));
    page.click("[data-command=unmeasured]", [0.0, 0.0]);
    page.wait(&format!("{QUIET} && document.getElementById('measured').hidden"));
    assert!(state(&mut page, "data").is_null());
}

#[test]
fn a_solution_is_followed_at_its_velocity_and_along_a_parameter() {
    let server = Running::new();
    let Some(mut page) = server.open(DESK) else { return };
    let at = spot(&mut page, [0.9, 0.8]);
    page.click_at(at);
    page.wait(PLACE);
    page.click("#places .place:not(.kept) [data-key='1-1']", [0.0, 0.0]);
    page.click("#places .place:not(.kept) .card-body > .row button:last-child", [0.0, 0.0]);
    let curves = page.wait(&format!("{QUIET} && use('follow').then(([f]) => f.followed().length && f.followed().map(({{points, name}}) => [points.length, name]))"));
    assert!(curves[0][0].as_u64().unwrap() > 10, "{curves}");
    // Its multipliers are shown when the pointer is on it.
    let on = page.point("use('follow', 'plane', 'model', 'state').then(([f, p, m, s]) => { const b = document.getElementById('plane').getBoundingClientRect(), to = p.project(m.viewOf(s.get())); \
                         const inside = f.followed()[0].points.map(to).filter(([x, y]) => x > p.frame.x + 5 && x < p.frame.x + p.frame.w - 5 && y > p.frame.y + 5 && y < p.frame.y + p.frame.h - 5); \
                         const [x, y] = inside[inside.length >> 1]; return [b.left + x, b.top + y]; })");
    page.hover(on);
    page.wait("/impact velocity = .*, multipliers /.test(document.getElementById('pointer').textContent)");
    page.click("#places .place:not(.kept) .card-body > .row button:first-of-type", [0.0, 0.0]);
    page.wait(CUT);
    assert_eq!(page.value("document.getElementById('ordinate').value"), "impact velocity");
    // The paper gives no mass, so there is no force.
    let menu = page.value("[...document.getElementById('ordinate').options].map((option) => option.value)");
    assert_eq!(menu, serde_json::json!(["x", "impact velocity", "peak to peak"]));
}
