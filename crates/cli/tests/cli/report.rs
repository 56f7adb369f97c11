//! `grazing report` from end to end: the page of the whole study, its links, and the page in a
//! browser.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::browser::{Spot, assert_all_pass, checked, cut, lost, sheets_of_paper};
use crate::program::{
    coarse_parameters, empty_folder, grazing, listing, narrow_linear, project, quick_parameters, repository,
};
use grazing_claims::ledger::Ledger;
use grazing_cli::outputs;
use grazing_cli::outputs::edition::Edition;

/// The address of the repository in the citation file.
const HOST: &str = "https://example.org/grazing";

/// The largest page that opens at once from any disk, in bytes.
const HEAVIEST: usize = 3_000_000;

/// The most elements: a browser sets the page within a second as long as there are no more (0.74 s
/// on a machine with two busy cores, of which 0.24 s pass before anything is seen, for 39,000).
const MOST_ELEMENTS: usize = 50_000;
/// The most pages of a print.
const MOST_SHEETS: usize = 60;

/// Formulas of the paper as readers may write them, with the labels of their claims.
const FORMULAS: [(&str, &str); 3] =
    [("eq:coeffsp", "eq:coeffsp"), (r"g_p(\delta)", "eq:gp"), ("gp(δ)", "eq:gp")];

/// The values of an attribute in the text.
fn values<'a>(text: &'a str, attribute: &str) -> Vec<&'a str> {
    let start = format!(" {attribute}=\"");
    text.match_indices(&start).filter_map(|(at, _)| text[at + start.len()..].split('"').next()).collect()
}

/// The place of a row of a table on the sheet of Figure 7, whose only panel has its axes as attributes.
fn on_sheet(svg: &str, amplitude: f64, omega: f64) -> (f64, f64) {
    let mark = svg.lines().find(|line| line.contains("class=\"panel\"")).expect("the figure has a panel");
    let numbers = |name: &str| -> Vec<f64> {
        values(mark, name)[0].split(' ').map(|number| number.parse().expect("it is a number")).collect()
    };
    let (x, y) = (numbers("data-x"), numbers("data-y"));
    let across = (amplitude - x[0]) / (x[1] - x[0]);
    let up = (omega - y[0]) / (y[1] - y[0]);
    (numbers("x")[0] + across * numbers("width")[0], numbers("y")[0] + (1.0 - up) * numbers("height")[0])
}

/// Copies the source files, in which the program looks for the places of functions.
fn copy_sources(to: &Path, from: &Path) {
    fs::create_dir_all(to).expect("the folder is ours");
    for entry in fs::read_dir(from).expect("the sources can be read") {
        let entry = entry.expect("the sources can be read");
        let (path, copy) = (entry.path(), to.join(entry.file_name()));
        if path.is_dir() {
            copy_sources(&copy, &path);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            fs::copy(&path, &copy).expect("the folder is ours");
        }
    }
}

#[test]
fn the_page_of_the_whole_study_is_complete_and_answers() {
    let folder = project(&coarse_parameters());
    copy_sources(&folder.path().join("crates"), &repository().join("crates"));
    fs::write(folder.path().join("CITATION.cff"), format!("repository-code: \"{HOST}\"\n"))
        .expect("the folder is ours");
    // One example, and a file of the same name elsewhere; the example of the paper's oscillator is
    // not shown again.
    fs::create_dir(folder.path().join("examples")).expect("the folder is ours");
    for file in ["examples/duffing.toml", "examples/paper.toml", "duffing.toml"] {
        fs::write(folder.path().join(file), narrow_linear()).expect("the folder is ours");
    }
    let arguments = ["report", "--output", "pages/report.html", "--oscillator", "duffing.toml"];
    let made = grazing(folder.path(), &arguments);
    assert_eq!(made.code, Some(0), "{}", made.messages);
    assert!(made.output.contains("pages/report.html: "), "{}", made.output);
    assert!(
        made.output.contains(" published values are met; 3 more are parameters.\nClaims: "),
        "{}",
        made.output
    );
    let pages = folder.path().join("pages");
    assert_eq!(listing(&pages), ["report.html"]);
    let page = fs::read_to_string(pages.join("report.html")).expect("it was written");
    assert!(page.len() < HEAVIEST, "{} bytes", page.len());
    let elements = page.split('<').filter(|tag| tag.starts_with(|c: char| c.is_ascii_lowercase())).count();
    assert!((10_000..MOST_ELEMENTS).contains(&elements), "{elements} elements");

    // Every output, every file and every claim is on the page.
    for output in outputs::ALL {
        assert!(page.contains(&format!("id=\"{}\"", output.name)), "{} is missing", output.name);
        for path in output.paths(&Edition::default()) {
            let link = format!("href=\"{HOST}/blob/HEAD/figures/{}\"", path.display());
            assert!(page.contains(&link), "{link} is missing");
        }
    }
    let claims = Ledger::of_the_paper().claims;
    for claim in &claims {
        assert!(page.contains(&format!("id=\"claim-{}\"", claim.label)), "{} is missing", claim.label);
    }
    // No link leads to files beside the page: it can be passed on alone.
    let links = || values(&page, "href").into_iter().filter(|href| !href.starts_with('#'));
    for link in links() {
        assert!(link.starts_with("https://"), "{link}");
    }
    let prefix = format!("{HOST}/blob/HEAD/");
    let lines = links().filter_map(|link| link.strip_prefix(&prefix)?.split_once("#L"));
    let sources: BTreeSet<(&str, &str)> = lines.collect();
    for (file, line) in &sources {
        let text =
            fs::read_to_string(folder.path().join(file)).unwrap_or_else(|_| panic!("{file} leads nowhere"));
        let line: usize = line.parse().expect("it is a number");
        let told = text.lines().nth(line - 1).unwrap_or_default().trim();
        assert!(!told.is_empty() && !told.starts_with("//"), "{file}, line {line}: {told}");
    }
    let held = claims.iter().any(|claim| !claim.holds.is_empty());
    assert_eq!(sources.is_empty(), !held, "claims lead to the functions that hold them");
    for wanted in [
        "id=\"oscillator-duffing\"",
        "id=\"oscillator-duffing-2\"",
        "href=\"https://example.org/grazing/blob/HEAD/examples/duffing.toml\"",
        "id=\"oscillator-duffing-2-magnifications\"",
        "that of Duffing&#39;s equation",
        "simulation as predicted at 2 of 2",
    ] {
        assert!(page.contains(wanted), "{wanted} is missing");
    }
    assert!(!page.contains("id=\"oscillator-paper\""));
    let here = folder.path().display().to_string();
    assert!(!page.contains(&here), "the page names a folder of this machine");

    // The pointer at a codimension-two point shows its description; the place on the sheet is
    // computed here, not by the page.
    let read = |path: &str| fs::read_to_string(repository().join(path)).expect("it is there");
    let (svg, points) = (read("figures/fig07.svg"), read("figures/data/fig07_points.csv"));
    let rows: Vec<Vec<&str>> = points.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let resonances = rows.iter().filter(|row| row[0] == "resonance");
    let spots: Vec<Spot<'_>> = resonances
        .map(|row| {
            let (omega, amplitude): (f64, f64) =
                (row[3].parse().expect("it is a number"), row[4].parse().expect("it is a number"));
            let told = vec!["Resonant grazing".to_owned(), format!("p{}n{}", row[1], row[2])];
            Spot { figure: "fig07", sheet: on_sheet(&svg, amplitude, omega), told, hidden: false }
        })
        .collect();
    assert!(spots.len() > 3, "{}", spots.len());
    if let Some(results) = checked(&page, &spots, &FORMULAS) {
        assert_all_pass(&results);
    }
    if let Some(cut) = cut(&page, 390) {
        assert!(cut.is_empty(), "{cut:#?}");
    }
    assert_eq!(missing(&page), BTreeSet::new(), "the font of formulas needs these characters");
    assert_eq!(misset(&page), [""; 0]);
    if let Some((lost, followed)) = lost(&page, &[390], 2) {
        assert!(followed >= 16 && lost.is_empty(), "{followed}: {lost:#?}");
    }
    if let Some(sheets) = sheets_of_paper(&page) {
        assert!((10..MOST_SHEETS).contains(&sheets), "{sheets} pages on paper");
    }
}

/// The list of the characters of the font of formulas, from the command that made it.
const FONTS: &str = include_str!("../../../drawing/fonts/README.md");

/// The characters in the page's formulas that the font of formulas does not have. Browsers set single
/// letters in italics, which are characters of their own.
fn missing(page: &str) -> BTreeSet<char> {
    let lists = FONTS.lines().skip_while(|line| !line.trim_start().starts_with("LETTERS="));
    let ranges = lists.filter_map(|line| line.trim_start().split_once("='U+"));
    let number = |text: &str| u32::from_str_radix(text.trim_start_matches("U+"), 16).expect("a character");
    let ranges: Vec<[u32; 2]> = ranges
        .flat_map(|(_, list)| list.trim_end_matches('\'').split(','))
        .map(|range| range.split_once('-').unwrap_or((range, range)))
        .map(|(first, last)| [number(first), number(last)])
        .collect();
    assert!(ranges.len() > 50, "{ranges:?}");
    let shown = |text: &str| match text {
        "&lt;" => "<".to_owned(),
        "&gt;" => ">".to_owned(),
        "&amp;" => "&".to_owned(),
        other => other.to_owned(),
    };
    let italic = |letter: char| match letter {
        'h' => 'ℎ',
        'A'..='Z' => char::from_u32(0x1D434 + u32::from(letter) - u32::from('A')).expect("a letter"),
        'a'..='z' => char::from_u32(0x1D44E + u32::from(letter) - u32::from('a')).expect("a letter"),
        'Α'..='Ω' => char::from_u32(0x1D6E2 + u32::from(letter) - u32::from('Α')).expect("a letter"),
        'α'..='ω' => char::from_u32(0x1D6FC + u32::from(letter) - u32::from('α')).expect("a letter"),
        other => other,
    };
    let formulas = page.split("<math").skip(1).filter_map(|rest| rest.split("</math>").next());
    let pieces =
        formulas.flat_map(|formula| formula.split('<').skip(1)).filter_map(|tag| tag.split_once('>'));
    let used = pieces.flat_map(|(tag, text)| {
        let text = shown(text);
        let is_italic = tag == "mi" && text.chars().count() == 1;
        text.chars().map(|letter| if is_italic { italic(letter) } else { letter }).collect::<Vec<_>>()
    });
    let has =
        |letter: &char| ranges.iter().any(|[first, last]| (*first..=*last).contains(&u32::from(*letter)));
    used.filter(|letter| *letter != '\n' && !has(letter)).collect()
}

/// The elements of formulas that do not have as many children as they need, without which browsers set
/// what should be a script or a fraction in line.
fn misset(page: &str) -> Vec<String> {
    let needed = |element: &str| match element {
        "msup" | "msub" | "mfrac" | "mover" | "munder" | "mroot" => Some(2),
        "msubsup" | "munderover" => Some(3),
        _ => None,
    };
    let mut faults = Vec::new();
    for formula in page.split("<math").skip(1).filter_map(|rest| rest.split("</math>").next()) {
        // Open elements, each with the number of its children so far.
        let mut open: Vec<(&str, usize)> = vec![("math", 0)];
        for tag in formula.split('<').skip(1).filter_map(|rest| rest.split('>').next()) {
            let element = tag.split(' ').next().unwrap_or_default();
            if let Some(closed) = element.strip_prefix('/') {
                let (_, children) = open.pop().expect("it was opened");
                if needed(closed).is_some_and(|needed| children != needed) {
                    faults.push(format!("{closed} has {children} children: {formula}"));
                }
            } else {
                open.last_mut().expect("the formula is open").1 += 1;
                if !tag.ends_with('/') {
                    open.push((element, 0));
                }
            }
        }
    }
    faults
}

#[test]
fn every_formula_of_the_ledger_can_be_set() {
    for claim in &Ledger::of_the_paper().claims {
        if let Some(formula) = &claim.formula {
            let set = grazing_report::mathml(formula, true);
            assert!(set.is_ok(), "{}: {}", claim.label, set.unwrap_err());
        }
        let misprint = claim.misprint.iter();
        for text in misprint.flat_map(|m| [&m.printed, &m.corrected, &m.reason, &m.decided]) {
            assert_eq!(text.matches('$').count() % 2, 0, "{}: {text}", claim.label);
            for formula in text.split('$').skip(1).step_by(2) {
                let set = grazing_report::mathml(formula, false);
                assert!(set.is_ok(), "{}: {}", claim.label, set.unwrap_err());
            }
        }
    }
}

#[test]
fn a_place_that_cannot_be_written_is_found_before_anything_is_computed() {
    let folder = project(&quick_parameters());
    fs::write(folder.path().join("file"), "").expect("the folder is ours");
    for (output, named) in [("figures", "figures"), ("file/report.html", "file")] {
        let before = listing(folder.path());
        let outcome = grazing(folder.path(), &["report", "--output", output]);
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{output}");
        let told = format!("error: {named}: cannot be written: ");
        assert!(
            outcome.messages.starts_with(&told) && outcome.messages.contains("--output FILE"),
            "{}",
            outcome.messages
        );
        assert_eq!(listing(folder.path()), before, "{output}");
    }
}

#[test]
fn an_oscillator_that_is_not_right_is_found_before_anything_is_computed() {
    let folder = project(&quick_parameters());
    let wrong = narrow_linear().replace("kappa)*x", "kapa)*x");
    fs::write(folder.path().join("wrong.toml"), wrong).expect("the folder is ours");
    for (file, told) in [("wrong.toml", "kapa"), ("missing.toml", "missing.toml")] {
        let outcome = grazing(folder.path(), &["report", "--oscillator", file]);
        assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""), "{}", outcome.messages);
        assert!(
            outcome.messages.starts_with("error: ") && outcome.messages.contains(told),
            "{}",
            outcome.messages
        );
        assert!(!folder.path().join("report.html").exists());
    }
}

#[test]
fn without_the_parameters_that_were_named_there_is_no_page() {
    let folder = empty_folder();
    let outcome = grazing(folder.path(), &["report", "--parameters", "mine.toml"]);
    assert_eq!((outcome.code, outcome.output.as_str()), (Some(2), ""));
    assert!(outcome.messages.starts_with("error: mine.toml: cannot be read"), "{}", outcome.messages);
    assert_eq!(listing(folder.path()), [""; 0]);
}
