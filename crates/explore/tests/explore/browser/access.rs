//! The page without a mouse, in the dark, without motion, and with a screen reader; and addresses
//! that hold its whole state.

use std::collections::BTreeSet;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

use super::chromium::{Browser, SHIFT, saved};
use super::overlay::SEEN;
use super::places::CUT;
use super::{DESK, PHONE, PLACE, Running, WHOLE, numbers, plane_key, state};

/// Roles of controls, and of elements that report something.
const NAMED: [&str; 12] = [
    "button",
    "checkbox",
    "combobox",
    "slider",
    "textbox",
    "spinbutton",
    "link",
    "image",
    "img",
    "application",
    "dialog",
    "progressbar",
];

/// Asserts that every visible control has a name, and returns their number.
fn assert_all_named(page: &mut Browser) -> usize {
    let told = page.told();
    let controls: Vec<_> = told.iter().filter(|[role, ..]| NAMED.contains(&role.as_str())).collect();
    for [role, name, value] in &controls {
        assert!(!name.trim().is_empty(), "a {role} of value {value:?} has no name");
    }
    controls.len()
}

#[test]
fn every_control_has_a_name_and_is_reached_by_keys_in_order() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    plane_key(&mut page, "h");
    page.press("k");
    page.press("ArrowLeft");
    // Everything with controls of its own has appeared.
    for rest in [WHOLE, PLACE, CUT] {
        page.wait(rest);
    }
    // Simulation goes on meanwhile.
    plane_key(&mut page, "o");
    page.wait(&format!("{SEEN}.then((seen) => seen >= 100)"));
    let controls = assert_all_named(&mut page);
    assert!(controls > 30, "{controls}");
    // All controls get the focus by tab alone, once each and from top to bottom.
    let controls = "[...document.querySelectorAll('a[href], button, input, select, textarea, summary, [tabindex=\"0\"]')]\
                    .filter((e) => e.checkVisibility({visibilityProperty: true}) && !e.disabled)";
    page.value(&format!("{controls}.forEach((e, k) => {{ e.dataset.count = k; }})"));
    let count = page.value(&format!("{controls}.length")).as_u64().unwrap();
    page.value("(document.activeElement.blur(), document.querySelector('.skip').focus())");
    let mut seen = BTreeSet::from([0]);
    for _ in 0..count + 5 {
        page.press("Tab");
        let here = page.value("(() => { const e = document.activeElement; return [e.dataset.count ?? -1, e.matches(':focus-visible')].map(Number); })()");
        let [at, visible] = numbers(&here)[..] else { panic!("{here}") };
        if at >= 0.0 {
            assert_eq!(visible, 1.0, "the focus is not seen at {at}");
            seen.insert(at as u64);
        }
    }
    let missed: Vec<u64> = (0..count).filter(|at| !seen.contains(at)).collect();
    let names = page.value(&format!(
        "{missed:?}.map((k) => document.querySelector(`[data-count=\"${{k}}\"]`).outerHTML.slice(0, 120))"
    ));
    assert!(missed.is_empty(), "{names}");
    page.press_with("Tab", SHIFT);
    // Dialogs keep the focus inside, and return it when they close.
    plane_key(&mut page, "?");
    page.wait("document.getElementById('help').open");
    assert_all_named(&mut page);
    page.press("Escape");
    page.wait("!document.getElementById('help').open && document.activeElement.id === 'plane'");
    page.press("s");
    page.wait("document.getElementById('share').open");
    assert!(assert_all_named(&mut page) > 4);
    page.press("Escape");
    page.press("x");
    page.wait("document.getElementById('export').open && !document.getElementById('share').open");
    assert!(assert_all_named(&mut page) > 8);
    page.press("Escape");
    page.press("e");
    page.wait("!document.getElementById('editor').hidden");
    assert_all_named(&mut page);
}

#[test]
fn light_and_dark_follow_the_system_and_the_button() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    let brightness = "(() => { const c = document.getElementById('plane'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; \
                      let [sum, n] = [0, 0]; for (let i = 0; i < d.length; i += 4) if (d[i + 3] === 255) { sum += d[i] + d[i + 1] + d[i + 2]; n += 3; } return sum / n; })()";
    let background = "getComputedStyle(document.body).backgroundColor";
    let (light, paper) = (page.value(brightness).as_f64().unwrap(), page.value(background));
    page.prefer("prefers-color-scheme", "dark");
    page.wait(&format!("document.documentElement.dataset.theme === 'dark' && {brightness} < 100"));
    assert!(light > 150.0);
    assert_ne!(page.value(background), paper);
    // The inks of the curves contrast with the paper.
    let contrast = "use('palette').then(([q]) => { const l = (hex) => { const c = /#(..)(..)(..)/.exec(hex).slice(1).map((x) => parseInt(x, 16) / 255)\
                    .map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)); return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }; \
                    const ink = q.inks(), on = l(ink.paper); const ratio = (hex) => { const a = l(hex); return (Math.max(a, on) + 0.05) / (Math.min(a, on) + 0.05); }; \
                    return [ink.ink, ink.muted, ...['SN', 'PD', 'GZ'].map(q.curveInk), ink.place].map(ratio); })";
    assert!(numbers(&page.value(contrast)).iter().all(|ratio| *ratio > 4.0), "{}", page.value(contrast));
    // A number of loops, and a curve that a file asks for, have one hue in both.
    let turned = "use('kinds').then(([k]) => { const hue = (hex) => { const [r, g, b] = /#(..)(..)(..)/.exec(hex).slice(1).map((x) => parseInt(x, 16)); \
                  return Math.atan2(Math.sqrt(3) * (g - b), 2 * r - g - b) * 180 / Math.PI; }; \
                  const pairs = [...k.INKS.light.loops.slice(1).map((ink, p) => [ink, k.INKS.dark.loops[p + 1]]), ...Object.values(k.LOOKS).map(({light, dark}) => [light.curve, dark.curve])]; \
                  return pairs.map((pair) => { const [a, b] = pair.map(hue); return Math.abs(((a - b + 540) % 360) - 180); }); })";
    let turned = numbers(&page.value(turned));
    assert!(turned.len() > 8 && turned.iter().all(|turn| *turn < 25.0), "{turned:?}");
    page.click("#theme", [0.0, 0.0]);
    page.wait(&format!("document.documentElement.dataset.theme === 'light' && {brightness} > 150"));
    assert!(numbers(&page.value(contrast)).iter().all(|ratio| *ratio > 4.0), "{}", page.value(contrast));
}

#[test]
fn all_that_is_seen_is_exported_as_picture_and_numbers() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    let at = super::spot(&mut page, [0.9, 0.8]);
    page.click_at(at);
    page.wait(PLACE);
    plane_key(&mut page, "h");
    page.wait(CUT);
    let home = tempfile::tempdir().unwrap();
    page.permit(home.path());
    page.click("[data-command=export]", [0.0, 0.0]);
    assert_eq!(
        page.value("['share', 'export'].map((id) => document.getElementById(id).open)"),
        json!([false, true])
    );
    let stem = page.value("use('model').then(([m]) => m.description.name)");
    let stem = stem.as_str().unwrap().to_lowercase().replace(|c: char| !c.is_ascii_alphanumeric(), "-");
    for (name, header) in [
        ("plane", "curve,p,n,"),
        ("cut", "what,branch,p,"),
        ("series", "attractor,what,t"),
        ("portrait", "attractor,what,t"),
        ("impacts", "attractor,what,phase"),
    ] {
        let mut taken = |kind: &str| {
            // Browsers block pages that save many files at once.
            if name == "plane" {
                page.click(&format!("[data-seen='{name}:{kind}']"), [0.0, 0.0]);
                return saved(home.path(), &format!("{stem}-{name}.{kind}"));
            }
            let content = page.value(&format!(
                "use('seen').then(([s]) => s.fileOf('{name}', '{kind}')).then((blob) => new Promise((done) => {{ \
                 const reader = new FileReader(); reader.onload = () => done(reader.result.split(',')[1]); reader.readAsDataURL(blob); }}))"
            ));
            STANDARD.decode(content.as_str().unwrap()).unwrap()
        };
        let [svg, png, csv] = ["svg", "png", "csv"].map(&mut taken);
        assert!(png.starts_with(b"\x89PNG") && png.len() > 5000, "{name}");
        let csv = String::from_utf8(csv).unwrap();
        assert!(csv.starts_with(header) && csv.lines().count() > 1, "{name}: {}", &csv[..80]);
        let columns = |line: &str| line.split(',').count();
        assert!(csv.lines().all(|line| columns(line) == columns(csv.lines().next().unwrap())), "{name}");
        let svg = String::from_utf8(svg).unwrap();
        let parsed = format!(
            "(() => {{ const d = new DOMParser().parseFromString({svg:?}, 'image/svg+xml'); return d.querySelector('parsererror') ? 0 : d.querySelectorAll('path, text').length; }})()"
        );
        assert!(page.value(&parsed).as_u64() > Some(10), "{name}: {}", &svg[..200]);
        assert!(!svg.contains("NaN") && !svg.contains("undefined"), "{name}");
    }
}

#[test]
fn on_a_phones_side_plane_and_answer_stand_side_by_side() {
    let server = Running::shared();
    let Some(mut page) = server.open([844, 390]) else { return };
    page.value("use('state').then(([s]) => s.update({place: [0.9, 0.8]}))");
    page.wait(PLACE);
    let boxes = page.value("['stage', 'place-section'].map((id) => document.getElementById(id).getBoundingClientRect()).map(({left, right, height}) => [left, right, height])");
    assert!(boxes[0][1].as_f64() <= boxes[1][0].as_f64().map(|left| left + 20.0), "{boxes}");
    assert!(boxes[0][2].as_f64() > Some(200.0), "{boxes}");
    assert_eq!(page.value("document.documentElement.scrollWidth"), 844);
}

#[test]
fn who_wants_no_motion_sees_none() {
    let server = Running::shared();
    let Some(mut page) = server.open(PHONE) else { return };
    page.prefer("prefers-reduced-motion", "reduce");
    page.wait("matchMedia('(prefers-reduced-motion: reduce)').matches");
    let moving = "[...document.querySelectorAll('*')].filter((e) => { const s = getComputedStyle(e); \
                  return s.scrollBehavior === 'smooth' || s.animationName !== 'none' || parseFloat(s.transitionDuration) > 0; }).map((e) => e.outerHTML.slice(0, 80))";
    assert_eq!(page.value(moving), json!([]));
    plane_key(&mut page, "+");
    page.wait(WHOLE);
    assert_eq!(page.value("document.getAnimations().length"), 0);
}

#[test]
fn an_address_brings_back_everything_that_was_seen() {
    let server = Running::shared();
    let Some(mut page) = server.open(PHONE) else { return };
    page.value("document.querySelector('#loops-list input[value=\"3\"]').click()");
    page.value("document.getElementById('constant-zeta').focus()");
    page.press("ArrowRight");
    plane_key(&mut page, "+");
    page.press("ArrowRight");
    page.press("k");
    for _ in 0..10 {
        page.press("ArrowUp");
    }
    page.press("h");
    page.press("o");
    page.press("e");
    let rests = "use('state', 'diagram', 'cut').then(([s, d, c]) => s.encode(s.get()) === location.hash && !d.isBusy() && !c.shown()?.old && \
                 /places simulated;/.test(document.getElementById('tiles-status').textContent) && location.hash)";
    let seen = page.wait(&format!("{PLACE}.then((told) => told && {rests})"));
    let all = page.value("use('state').then(([s]) => s.get())");
    for (name, empty) in [
        ("set", json!({})),
        ("loops", Value::Null),
        ("view", Value::Null),
        ("kept", Value::Null),
        ("cut", Value::Null),
    ] {
        assert_ne!(all[name], empty, "{name}");
    }
    let pictures = "['plane', 'cut'].map((id) => document.getElementById(id).toDataURL())";
    let words = "document.getElementById('places').innerText";
    let (drawn, told) = (page.value(pictures), page.value(words));
    drop(page);
    let address = format!("{}{}", server.address, seen.as_str().unwrap());
    let Some(mut other) = Browser::open(&address, PHONE) else { return };
    other.wait(&format!("{PLACE}.then((told) => told && {rests})"));
    assert_eq!(other.value("use('state').then(([s]) => s.get())"), all);
    assert_eq!(other.value(words), told);
    other.wait(&format!("JSON.stringify({pictures}) === JSON.stringify({drawn})"));
    // A truncated address is reported, not guessed.
    other.go(&address[..address.len() - 7]);
    other.wait("!document.getElementById('warning').hidden");
    assert_eq!(state(&mut other, "set"), json!({}));
}

#[test]
fn whatever_an_address_says_is_read_as_a_state_or_refused() {
    let server = Running::shared();
    let Some(mut page) = server.open(PHONE) else { return };
    // Values of all kinds under every name, and changed bytes and letters, all of them seeded.
    let wrong = page.value(
        "use('state').then(([s]) => { \
           let seed = 1; const below = (n) => { seed = (seed * 1103515245 + 12345) % 2147483648; return Math.floor((seed / 2147483648) * n); }; \
           const one = (list) => list[below(list.length)]; \
           const values = [null, true, 0, -1, 1.5, 1e308, '', 'a', '\\u0000\\n;rm', '__proto__', [], {}, [1, 2], [2, 1], [1, 2, 3, 4], [1e308, 2, null, 'a'], \
                           {zeta: 0.1}, {zeta: 'a'}, {'a\\u001b': 1}, JSON.parse('{\"__proto__\": 1}'), [[]], [1.5], [4294967296], 'primary', Array(1000).fill(1)]; \
           const right = s.encode({...s.get(), set: {zeta: 0.1}, loops: [1, 2], view: {primary: [0, 1], secondary: [2, 3]}, place: [0.1, 0.9]}); \
           const wrong = []; let read = 0; \
           for (let k = 0; k < 3000; k += 1) { \
             let address = right; \
             if (k % 3 === 0) { const short = {}; for (const key of 'etslvpkcowx') if (below(2)) short[key] = one(values); address = '#' + btoa(unescape(encodeURIComponent(JSON.stringify(short)))); } \
             else if (k % 3 === 1) { const at = 1 + below(right.length - 1); address = right.slice(0, at) + String.fromCharCode(below(256)) + right.slice(at + below(3)); } \
             else address = right.slice(0, below(right.length)); \
             try { \
               const value = s.decode(address); if (value === null) continue; read += 1; \
               const again = s.decode(s.encode(value)); \
               const {set, loops, view, place} = value; const number = (x) => typeof x === 'number' && Number.isFinite(x); \
               const fit = JSON.stringify(again) === JSON.stringify(value) && Object.values(set).every(number) && (loops === null || loops.every(Number.isInteger)) \
                 && (view === null || [...view.primary, ...view.secondary].every(number)) && (place === null || place.every(number)) && Object.getPrototypeOf(set) === Object.prototype; \
               if (!fit) wrong.push(address); \
             } catch (error) { wrong.push(`${address}: ${error}`); } \
           } \
           return [read > 500, wrong.slice(0, 3)]; })",
    );
    assert_eq!(wrong, json!([true, []]));
}

#[test]
fn no_command_is_offered_that_carries_more_than_text_into_a_shell() {
    let server = Running::shared();
    let Some(mut page) = server.open(PHONE) else { return };
    let of = |page: &mut Browser, name: &str| {
        page.value(&format!(
            "use('share', 'state').then(([h, s]) => h.command({{...s.get(), set: {{{name}: 0.5}}}}))"
        ))
    };
    let plain = of(&mut page, "zeta");
    assert!(plain.as_str().is_some_and(|line| line.contains("oscillator.zeta=0.5")), "{plain}");
    // Characters that a shell would interpret are quoted, and those that no quotes protect on every
    // terminal are rejected.
    let quoted = of(&mut page, "\"a;touch 'b\"");
    assert!(quoted.as_str().is_some_and(|line| line.contains(r"'oscillator.a;touch '\''b=0.5'")), "{quoted}");
    for name in [
        "\"a\\ntouch b\\n\"",
        "\"a\\u0015touch b\\r\"",
        "\"a\\u001b[201~\"",
        "\"a\\u0085b\"",
        "\"a\\u202eb\"",
    ] {
        assert_eq!(of(&mut page, name), Value::Null, "{name}");
    }
}

#[test]
fn on_a_phone_the_view_is_shared_and_numbers_are_exported() {
    let server = Running::shared();
    let Some(mut page) = server.open(PHONE) else { return };
    let home = tempfile::tempdir().unwrap();
    page.permit(home.path());
    plane_key(&mut page, "+");
    page.wait("use('state').then(([s]) => location.hash !== '' && s.encode(s.get()) === location.hash)");
    page.click("[data-command=share]", [0.0, 0.0]);
    page.note_words("copy-address");
    page.click("#copy-address", [0.0, 0.0]);
    page.wait("noted.includes('Copied')");
    assert_eq!(page.value("navigator.clipboard.readText()"), page.value("location.href"));
    page.press("Escape");
    page.click(".toolbar [data-command=export]", [0.0, 0.0]);
    page.click("[data-take='csv:points']", [0.0, 0.0]);
    let stem = page.wait("use('model').then(([m]) => m.description.name)");
    let stem = stem.as_str().unwrap().to_lowercase().replace(|c: char| !c.is_ascii_alphanumeric(), "-");
    // The server of these tests returns the name that was requested.
    assert_eq!(saved(home.path(), &format!("{stem}-points.csv")), b"csv:points");
    assert_eq!(page.value("document.documentElement.scrollWidth"), 360);
}
