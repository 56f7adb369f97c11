//! A page in headless Chromium, with checks that run in it.

use std::fs;

#[allow(dead_code)]
#[path = "../../../explore/tests/explore/browser/chromium.rs"]
pub(crate) mod chromium;

use self::chromium::Browser;
use tempfile::TempDir;

/// The checks, in JavaScript.
const CHECKS: &str = include_str!("checks.js");
/// Counts, in `EARLY`, requests for the layout of the page before all of it is read, which delay
/// its first appearance.
const WATCH: &str = include_str!("watch.js");
/// The window of a desktop computer.
const WINDOW: [u32; 2] = [1400, 1000];
/// A time limit in milliseconds, far longer than anything in a page takes on a busy machine.
const PATIENCE: u32 = 300_000;

/// A spot of a figure's sheet, and the text that the page has to show for it.
pub(crate) struct Spot<'a> {
    pub(crate) figure: &'a str,
    pub(crate) sheet: (f64, f64),
    pub(crate) told: Vec<String>,
    /// Whether it is a point that is not drawn and has to be switched on.
    pub(crate) hidden: bool,
}

/// Opens the page, runs the checks, with those of the search for formulas and the labels that they
/// find, and returns their results, one line each; none without a browser, with a message on the
/// error stream.
pub(crate) fn checked(page: &str, spots: &[Spot<'_>], formulas: &[(&str, &str)]) -> Option<Vec<String>> {
    let told =
        |spot: &Spot<'_>| spot.told.iter().map(|text| format!("{text:?}")).collect::<Vec<_>>().join(",");
    let spots: Vec<String> = spots
        .iter()
        .map(|spot| {
            let (figure, (x, y), hidden) = (spot.figure, spot.sheet, spot.hidden);
            format!("{{figure:{figure:?},x:{x},y:{y},told:[{}],hidden:{hidden}}}", told(spot))
        })
        .collect();
    let formulas: Vec<String> =
        formulas.iter().map(|(text, label)| format!("{{text:{text:?},label:{label:?}}}")).collect();
    let (spots, formulas) = (spots.join(","), formulas.join(","));
    let script = format!(
        "<script>const SPOTS = [{spots}];\nconst FORMULAS = [{formulas}];\nconst PATIENCE = {PATIENCE};\n{CHECKS}</script>\n</body>"
    );
    let watched = format!("<head>\n<script>{WATCH}</script>");
    let page = page.replacen("<head>", &watched, 1).replace("</body>", &script);
    let (_folder, mut browser) = open(&page, WINDOW[0])?;
    let results = browser.wait("document.getElementById('checks')?.textContent");
    Some(results.as_str().expect("it is text").lines().map(str::to_owned).collect())
}

/// Follows every link of the list of sections, and those to figures, in windows of these widths,
/// and opens the addresses of some; returns the links that did not land in the right place, and the
/// number of links; none without a browser.
pub(crate) fn lost(page: &str, widths: &[u32], loads: usize) -> Option<(Vec<String>, usize)> {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let file = folder.path().join("page.html");
    fs::write(&file, page).expect("the folder is ours");
    let address = format!("file://{}", file.display());
    let (mut lost, mut followed) = (Vec::new(), 0);
    for width in widths {
        let mut browser = Browser::open(&address, [*width, WINDOW[1]])?;
        browser.wait(LOADED);
        let found = browser.value(&format!("({LINKS})()"));
        let links: Vec<&str> = found.as_array()?.iter().filter_map(|link| link.as_str()).collect();
        followed += links.len();
        let spread = links.iter().step_by(links.len().div_ceil(loads));
        let ways = links.iter().map(|link| (*link, true)).chain(spread.map(|link| (*link, false)));
        for (link, click) in ways {
            if !click {
                browser.go(&format!("{address}{link}"));
                browser.wait(LOADED);
            }
            let landed = browser.value(&format!("({LANDED})({link:?}, {click}, {PATIENCE})"));
            if landed != true {
                lost.push(format!("{link} at {width}, clicked: {click}: {landed}"));
            }
        }
    }
    Some((lost, followed))
}

const LOADED: &str = "document.readyState === 'complete' && document.fonts.status === 'loaded'";
/// The addresses of sections and of figures, each once.
const LINKS: &str = "() => [...new Set([...document.querySelectorAll('.bar nav a, main a[href^=\"#fig\"]')]
    .map((link) => link.getAttribute('href')))]";
/// Follows a link, by a click if `click` is set, until its target is in the right place and stays
/// there; returns true, or by how many pixels it is off.
const LANDED: &str = "async (link, click, patience) => {
    const target = document.querySelector(link);
    if (click) [...document.querySelectorAll(`a[href=\"${link}\"]`)].at(-1).click();
    const px = (element, name) => parseFloat(getComputedStyle(element)[name]) || 0;
    const off = () => {
        const wanted = px(document.documentElement, 'scrollPaddingTop') + px(target, 'scrollMarginTop');
        const end = document.documentElement.scrollHeight - innerHeight;
        const top = target.getBoundingClientRect().top;
        return Math.max(-scrollY, Math.min(end - scrollY, top - wanted));
    };
    // A browser may paint no more where nothing changes.
    const frame = () => new Promise((done) => { requestAnimationFrame(done); setTimeout(done, 100); });
    let still = 0;
    for (const began = performance.now(); still < 10 && performance.now() - began < patience; ) {
        still = Math.abs(off()) < 5 ? still + 1 : 0;
        await frame();
    }
    return still === 10 || off();
}";

/// The captions and lines of text that a window of this width cuts off; none without a browser.
pub(crate) fn cut(page: &str, width: u32) -> Option<Vec<String>> {
    let (_folder, mut browser) = open(page, width)?;
    browser.wait(LOADED);
    let cut = browser.value(&format!("({CUT})()"));
    Some(cut.as_array()?.iter().filter_map(|text| text.as_str()).map(str::to_owned).collect())
}

/// The captions and text outside of what scrolls by itself that leave the window, with where they end.
const CUT: &str = "() => [...document.querySelectorAll('caption, h1, h2, h3, h4, p, dt, dd, li, summary')]
    .filter((text) => text.matches('caption') || !text.closest('.scroll, .formula, .bar nav'))
    .filter((text) => !text.querySelector('.formula'))
    .map((text) => {
        const range = document.createRange();
        range.selectNodeContents(text);
        return [text, Math.max(...[...range.getClientRects()].map((box) => box.right))];
    })
    .filter(([, end]) => end > document.documentElement.clientWidth + 1)
    .map(([text, end]) => `${text.tagName} to ${end}: ${text.textContent.slice(0, 60)}`)";

/// The number of pages in print; none without a browser.
pub(crate) fn sheets_of_paper(page: &str) -> Option<usize> {
    let (_folder, mut browser) = open(page, WINDOW[0])?;
    browser.wait(LOADED);
    let pdf = browser.printed();
    // The object of a page begins with its type on its own line.
    Some(pdf.split(|byte| *byte == b'\n').filter(|line| line.ends_with(b"/Type /Page")).count())
}

/// Opens the page in a window of this width from a folder, which is deleted with the first value; none
/// without a browser.
fn open(page: &str, width: u32) -> Option<(TempDir, Browser)> {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let file = folder.path().join("page.html");
    fs::write(&file, page).expect("the folder is ours");
    let browser = Browser::open(&format!("file://{}", file.display()), [width, WINDOW[1]])?;
    Some((folder, browser))
}

/// Fails with the checks that did not pass, or if there are too few.
pub(crate) fn assert_all_pass(results: &[String]) {
    let failed: Vec<&String> = results.iter().filter(|line| !line.starts_with("passed: ")).collect();
    assert!(failed.is_empty(), "{failed:#?}");
    assert!(results.len() >= 20, "{results:#?}");
}
