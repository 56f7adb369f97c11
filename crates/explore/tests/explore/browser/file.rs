//! Editing the oscillator's file in the page.

use grazing_input::Description;

use super::chromium::{Browser, CONTROL};
use super::{DESK, PHONE, Running, WHOLE, choose_duffing, plane_key, state};

/// Curves, points and regions are all faded.
const FADED: &str = "use('diagram').then(([d]) => [d.diagram.of.points, d.diagram.of.regions, ...[...d.diagram.curves.values()].map(({of}) => of)]\
                     .every((of) => d.strength(of) < 0.5))";
const NOT_DRAWN: &str =
    "/^Not drawn\\. Line \\d+: /.test(document.getElementById('progress-text').textContent)";
const VERDICT: &str = "document.getElementById('verdict').textContent";

/// Puts the cursor after a text of the file, and types.
fn type_behind(page: &mut Browser, before: &str, text: &str) {
    page.value(&format!(
        "(() => {{ const t = document.getElementById('text'); t.focus(); const at = t.value.indexOf({before:?}) + {before:?}.length; \
         t.setSelectionRange(at, at); }})()"
    ));
    page.write(text);
}

#[test]
fn mistakes_are_marked_under_the_character_in_the_words_of_the_command_line() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    choose_duffing(&mut page);
    plane_key(&mut page, "e");
    page.wait("document.getElementById('text').value.includes('kappa*x^3')");
    type_behind(&mut page, "- x - ka", "z");
    page.wait(&format!("/unknown name kazppa/.test({VERDICT})"));
    assert_eq!(page.value("document.querySelector('#marks mark').textContent"), "kazppa");
    // The message is the one that the command line prints for such a file.
    let text = page.value("document.getElementById('text').value");
    let told = Description::parse(text.as_str().unwrap(), "oscillator.toml").unwrap_err().to_string();
    let (line, message) =
        told.lines().next().unwrap().strip_prefix("oscillator.toml:").unwrap().split_once(": ").unwrap();
    assert_eq!(page.value(VERDICT), format!("Line {line}: {message}"));
    // The mark and the message are at the character.
    let under = "(() => { const [mark, callout] = ['#marks mark', '#callout'].map((s) => document.querySelector(s).getBoundingClientRect()); \
                 return [callout.top - mark.bottom, mark.left - callout.left, callout.right - mark.left]; })()";
    let found = page.value(under);
    let [below, left, right] = [0, 1, 2].map(|index| found[index].as_f64().unwrap());
    assert!((-3.0..20.0).contains(&below) && left > -20.0 && right > 0.0, "{found}");
    let covered = "(() => { const t = document.getElementById('text'), m = document.querySelector('#marks mark').getBoundingClientRect(); \
                   const at = t.value.indexOf('kazppa'), before = t.value.slice(0, at), line = before.split('\\n').length - 1; \
                   const style = getComputedStyle(t), b = t.getBoundingClientRect(); \
                   return Math.abs(b.top + parseFloat(style.paddingTop) + line * parseFloat(style.lineHeight) - t.scrollTop - m.top); })()";
    assert!(page.value(covered).as_f64().unwrap() < 6.0);
    // The diagram of the last correct file stays, faded, with a message why no other is drawn, even
    // after it is complete; a button leads to the mistake.
    assert_eq!(page.value(FADED), true);
    page.wait(NOT_DRAWN);
    page.wait("!document.documentElement.hasAttribute('data-busy')");
    assert_eq!(page.value(FADED), true);
    assert_eq!(page.value(NOT_DRAWN), true);
    // It is not one of a constant, though it names the constants that are known.
    let beside = "document.querySelectorAll('#constants-list .why:not([hidden])').length";
    assert_eq!(page.value(beside), 0);
    page.click("#go-to-mistake", [0.0, 0.0]);
    assert_eq!(page.value("(() => { const t = document.getElementById('text'); return t.value.slice(t.selectionStart, t.selectionEnd); })()"), "kazppa");
    page.write("kappa");
    page.wait(&format!("{VERDICT} === 'The file is valid.'"));
    page.wait(&format!("{FADED}.then((faded) => !faded)"));
    // That of a constant stands beside it, too.
    type_behind(&mut page, "\nzeta = ", "nan # ");
    page.wait(&format!("{beside} === 1"));
    let why = page.value("document.querySelector('#constants-list .why:not([hidden])').textContent");
    assert!(why.as_str().is_some_and(|why| why.starts_with("parameters.zeta = nan: ")), "{why}");
    page.click("#go-to-mistake", [0.0, 0.0]);
    page.write("zeta = 0.02");
    page.wait(&format!("{VERDICT} === 'The file is valid.'"));
    // Nothing is left of the mistakes anywhere.
    page.wait(WHOLE);
    let red = "[...document.querySelectorAll('.bad')].filter((e) => e.checkVisibility() && !e.matches('td')).map((e) => e.textContent)";
    assert_eq!((page.value(beside), page.value(red)), (0.into(), serde_json::json!([])));
    // Another value of a constant gives another diagram, of the user's own file.
    page.value("(() => { const t = document.getElementById('text'); const at = t.value.indexOf('kappa = 0.1') + 8; t.setSelectionRange(at, at + 3); })()");
    page.write("0.2");
    page.wait("use('state').then(([s]) => s.get().text?.includes('kappa = 0.2'))");
    assert_eq!(page.value("document.getElementById('oscillator').value"), "?own");
    page.wait("use('model').then(([m]) => m.description.constants.some(({name, value}) => name === 'kappa' && value === 0.2))");
    // What the command line notes is told here as well, with the file and in the list of notes.
    type_behind(&mut page, "\nzeta = ", "-");
    let note = "Line \\d+: motion\\.force: at the wall the force grows with the velocity.*sign of the damping intended";
    page.wait(&format!("/^The file is valid\\. {note}/.test({VERDICT}) && /{note}/.test(document.getElementById('notes-list').textContent) && document.getElementById('notes').open"));
    // Typing can be undone as everywhere.
    page.value("document.getElementById('text').focus()");
    page.press_with("a", CONTROL);
}

#[test]
fn examples_and_the_paper_are_in_the_menu() {
    let server = Running::shared();
    let Some(mut page) = server.open(DESK) else { return };
    let menu = page.value("[...document.getElementById('oscillator').options].filter((o) => !o.hidden).map((o) => o.textContent)");
    assert_eq!(menu, serde_json::json!(["Paper", "Duffing"]));
    page.click("[data-command=edit]", [0.0, 0.0]);
    // The paper's oscillator is built in, and the same oscillator as a file is one click away.
    page.wait("!document.getElementById('built-in').hidden");
    page.click("#edit-copy", [0.0, 0.0]);
    page.wait("document.getElementById('text').value.includes('kappa*x^3')");
    assert_eq!(state(&mut page, "example"), "duffing.toml");
    page.value("document.getElementById('oscillator').focus()");
    page.press("ArrowUp");
    page.wait(&format!("use('state').then(([s]) => s.get().example === null && {WHOLE})"));
}

#[test]
fn on_a_phone_the_file_is_edited_as_well() {
    let server = Running::shared();
    let Some(mut page) = server.open(PHONE) else { return };
    choose_duffing(&mut page);
    page.click("[data-command=edit]", [0.0, 0.0]);
    page.wait("document.getElementById('text').value.includes('kappa*x^3')");
    type_behind(&mut page, "zeta = 0.02", "q");
    page.wait(&format!("/^Line \\d+: /.test({VERDICT}) && !document.getElementById('callout').hidden"));
    assert_eq!(page.value("document.documentElement.scrollWidth"), 360);
    let seen = "['#plane', '#code'].every((s) => { const b = document.querySelector(s).getBoundingClientRect(); return b.top >= 0 && b.bottom <= innerHeight; })";
    page.value("document.getElementById('stage').scrollIntoView({block: 'start', behavior: 'instant'})");
    assert_eq!(page.value(seen), true);
    let within = "(() => { const b = document.getElementById('callout').getBoundingClientRect(); return b.left >= 0 && b.right <= 360; })()";
    assert_eq!(page.value(within), true);
}
