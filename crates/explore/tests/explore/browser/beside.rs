//! Straightened curves, measurements, ordinates of the cut, and followed solutions, in the page.

use super::places::CUT;
use super::{DESK, HOLD, PLACE, QUIET, Running, WHOLE, plane_key, spot, state};

/// Straightened coordinates are shown, and the page is idle.
const STRAIGHT: &str = "!document.documentElement.hasAttribute('data-busy') && !document.getElementById('straightened').hidden && \
                        document.querySelector('[data-command=straighten]').getAttribute('aria-pressed')";
/// Opens a file as by dropping it on the plane.
const DROP: &str = "(text) => { const data = new DataTransfer(); data.items.add(new File([text], 'rig.csv', {type: 'text/csv'})); \
                    document.getElementById('stage').dispatchEvent(new DragEvent('drop', {dataTransfer: data, bubbles: true, cancelable: true})); }";

#[test]
fn straightened_coordinates_come_when_asked_for_and_by_themselves_where_all_curves_lie_on_one_line() {
    let server = Running::shared();
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
                const {primary: p, secondary: q} = d.diagram.resonances.filter(({theorem_holds}) => theorem_holds).sort((a, b) => bend(a) - bend(b))[0]; const w = 1e-6; \
                s.update({view: {primary: [p - w, p + w], secondary: [q - w, q + w]}}); })");
    page.wait(&format!("use('diagram').then(([d]) => !d.diagram.stale && {STRAIGHT})"));
    page.wait(WHOLE);
    plane_key(&mut page, "0");
    page.wait(&format!("{QUIET} && document.getElementById('straightened').hidden"));
}

#[test]
fn a_file_of_measurements_is_shown_at_once_and_compared_without_new_curves() {
    let server = Running::new();
    let Some(mut page) = server.open(DESK) else { return };
    let text = "amplitude,omega,seen,periods,impacts\\n0.05,0.8,none,,\\n0.9,0.8,periodic,1,1\\n0.05,0.8,periodic,1,1\\n";
    // While the curves are under way, points, columns and mistakes are there already.
    page.value(HOLD);
    plane_key(&mut page, "+");
    page.wait("use('diagram').then(([d]) => d.isBusy() && !d.isWhole())");
    page.value(&format!("({DROP})('{}')", text.replace("omega,seen", "omega,saw")));
    page.wait("/the column seen is missing|unknown column saw/.test(document.getElementById('measured-message').textContent)");
    page.value(&format!("({DROP})('{text}')"));
    let marked =
        "use('measured').then(([m]) => m.points().map(({line, agreement}) => [line, agreement ?? null]))";
    page.wait(&format!("{marked}.then((all) => all.length === 3)"));
    assert_eq!(page.value(marked), serde_json::json!([[2, null], [3, null], [4, null]]));
    assert_eq!(page.value("document.getElementById('measured-message').hidden"), true);
    let read = "3 measurements, from the columns amplitude, omega, seen, periods, impacts.";
    assert_eq!(page.value("document.getElementById('measured-read').textContent"), read);
    assert_eq!(
        page.value("document.getElementById('measured-progress').textContent"),
        "Compared when all curves are there."
    );
    assert_eq!(page.value("use('diagram').then(([d]) => d.isBusy())"), true);
    // Then they are compared as far as they are in view.
    page.value("letGo()");
    page.wait(&format!("{QUIET} && {marked}.then((all) => all.some(([, agreement]) => agreement))"));
    plane_key(&mut page, "0");
    page.wait(&format!("{WHOLE} && {marked}.then((all) => all.every(([, agreement]) => agreement))"));
    // Other measurements are compared, and no curve is computed for them.
    page.value("(() => { const ask = window.fetch.bind(window); window.asked = []; window.fetch = (path, options) => { window.asked.push(path); return ask(path, options); }; })()");
    page.value("document.querySelector('[data-command=unmeasured]').click()");
    page.value(&format!("({DROP})('{text}')"));
    page.wait(&format!("{QUIET} && /Line 4, 1 impact in 1 period: /.test(document.getElementById('measured-against').textContent)"));
    assert_eq!(page.value("asked.filter((path) => path !== './measured')"), serde_json::json!(["./compare"]));
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
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    let at = spot(&mut page, [0.9, 0.8]);
    page.click_at(at);
    page.wait(PLACE);
    page.click("#places .place:not(.kept) [data-key='1-1']", [0.0, 0.0]);
    page.click("#places .place:not(.kept) .card-body > .row button:last-child", [0.0, 0.0]);
    let curves = page.wait(&format!("{QUIET} && use('follow').then(([f]) => f.followed().length && f.followed().map(({{points, name}}) => [points.length, name]))"));
    assert!(curves[0][0].as_u64().is_some_and(|points| points > 10), "{curves}");
    // The address keeps the walls that are hit, where there are two.
    let stops = page.value("use('state').then(([s]) => s.decode(s.encode({ ...s.get(), follow: { at: [1, 1], p: 1, impacts: [[1, 0], [1, 3]], stops: [0, 1] } })).follow.stops)");
    assert_eq!(stops, serde_json::json!([0, 1]));
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
