//! A page in headless Chromium, with checks that run in it.

use std::fs::{self, File};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// What the checks are, in the page's own language.
const CHECKS: &str = include_str!("checks.js");
/// Counts, in `EARLY`, what asks for the layout of the page before all of it is read, which delays its first appearance.
const WATCH: &str = include_str!("watch.js");
/// The names under which systems have the browser.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
/// The files of the page and of what the browser says.
const PAGE: &str = "page.html";
const SAID: &str = "said.txt";
/// Longer than the slowest start of the browser on a busy machine.
const PATIENCE: Duration = Duration::from_secs(120);

/// A spot of a figure's sheet, and what the page has to tell of it.
pub(crate) struct Spot<'a> {
    pub(crate) figure: &'a str,
    pub(crate) sheet: (f64, f64),
    pub(crate) told: Vec<String>,
    /// Whether it is about a point that is not drawn and has to be asked for.
    pub(crate) hidden: bool,
}

/// Opens the page, runs the checks, those of the search with texts and the labels that they find, and returns what they say, one line each; nothing where there is no browser, which is
/// said on the error stream.
pub(crate) fn checked(page: &str, spots: &[Spot<'_>], formulas: &[(&str, &str)]) -> Option<Vec<String>> {
    let browser = browser()?;
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
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
        "<script>const SPOTS = [{spots}];\nconst FORMULAS = [{formulas}];\n{CHECKS}</script>\n</body>"
    );
    let watched = format!("<head>\n<script>{WATCH}</script>");
    let page = page.replacen("<head>", &watched, 1).replace("</body>", &script);
    fs::write(folder.path().join(PAGE), page).expect("the folder is ours");
    open(browser, folder.path(), "--dump-dom");
    let dom = fs::read_to_string(folder.path().join(SAID)).expect("the browser writes UTF-8");
    let result = dom.split("<pre id=\"checks\">").nth(1).and_then(|rest| rest.split("</pre>").next());
    let result =
        result.unwrap_or_else(|| panic!("the checks did not end; the browser wrote {} bytes", dom.len()));
    Some(result.lines().map(str::to_owned).collect())
}

/// How many pages the page has on paper; nothing where there is no browser.
pub(crate) fn sheets_of_paper(page: &str) -> Option<usize> {
    let browser = browser()?;
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    fs::write(folder.path().join(PAGE), page).expect("the folder is ours");
    let pdf = folder.path().join("page.pdf");
    open(browser, folder.path(), &format!("--print-to-pdf={}", pdf.display()));
    let pdf = fs::read(pdf).expect("the browser prints");
    // The object of a page begins with its type on a line of its own.
    Some(pdf.split(|byte| *byte == b'\n').filter(|line| line.ends_with(b"/Type /Page")).count())
}

/// The name of a browser; where there is none, that is said.
fn browser() -> Option<&'static str> {
    let found = NAMES.into_iter().find(|name| is_there(name));
    if found.is_none() {
        // What is printed by a macro is shown for failed tests only; everybody has to see this.
        let tried = NAMES.join(", ");
        let line = format!("\nskipped: no Chromium here, so the page was not opened ({tried} were tried)\n");
        std::io::stderr().write_all(line.as_bytes()).expect("there is an error stream");
    }
    found
}

fn is_there(name: &str) -> bool {
    let version = Command::new(name).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    version.is_ok_and(|status| status.success())
}

/// Opens the page in a folder to do something with it; what the browser says goes to a file there.
fn open(browser: &str, folder: &Path, action: &str) {
    let mut run = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run"])
        .args(["--window-size=1400,1000", "--virtual-time-budget=20000", "--no-pdf-header-footer", action])
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg(format!("file://{}", folder.join(PAGE).display()))
        .stdout(File::create(folder.join(SAID)).expect("the folder is ours"))
        .stderr(Stdio::null())
        .spawn()
        .expect("the browser starts");
    let start = Instant::now();
    while run.try_wait().expect("the browser is ours").is_none() {
        if start.elapsed() > PATIENCE {
            run.kill().expect("the browser is ours");
            run.wait().expect("it ends");
            panic!("the browser did not end within {} s", PATIENCE.as_secs());
        }
        sleep(Duration::from_millis(50));
    }
}

/// Fails with the checks that did not pass; there have to be some that did.
pub(crate) fn assert_all_pass(results: &[String]) {
    let failed: Vec<&String> = results.iter().filter(|line| !line.starts_with("passed: ")).collect();
    assert!(failed.is_empty(), "{failed:#?}");
    assert!(results.len() >= 20, "{results:#?}");
}
