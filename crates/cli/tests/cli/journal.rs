//! Editions for a journal: PDF, PNG and LaTeX in a folder of their own; and the manifest for codecheckers.

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process::{Command, Stdio};

use crate::program::{
    DEFAULT, edited, edition, empty_folder, grazing, listing, narrow_linear, project, quick_parameters,
    repository,
};
use grazing_cli::codecheck;
use grazing_cli::outputs;
use grazing_drawing::SheetWidth;

#[test]
fn an_edition_for_a_journal_goes_to_its_own_folder() {
    let folder = project(DEFAULT);
    let arguments = ["reproduce", "--only", "fig04", "--only", "coefficients", "--format", "png,tex"];
    let arguments = [&arguments[..], &["--columns", "one", "--dpi", "72"]].concat();
    let made = grazing(folder.path(), &arguments);
    assert_eq!(made.code, Some(0), "{}", made.messages);
    assert_eq!(listing(&folder.path().join("figures")), ["parameters.toml"], "figures/ is left alone");
    let journal = folder.path().join("journal");
    assert!(
        journal.join("fig04.png").is_file() && !journal.join("fig04.svg").exists(),
        "SVG was not asked for"
    );
    fs::write(journal.join("coefficients.tex"), "").expect("the folder is ours");
    let checked = grazing(folder.path(), &[&arguments[..], &["--check"]].concat());
    assert_eq!(checked.code, Some(1), "{}", checked.messages);
    let mend = "`cargo xtask reproduce --only fig04 --only coefficients --format pdf,png,tex --columns one --dpi 72`";
    assert!(checked.errors().contains(mend), "{}", checked.messages);
}

#[test]
fn latex_includes_all_of_an_edition() {
    let journal = edition(SheetWidth::OneColumn);
    let journal = journal.path();
    let snippet = fs::read_to_string(journal.join("figures.tex")).expect("there is a snippet");
    for output in outputs::ALL {
        if !output.is_figure {
            for table in output.tables {
                // The other tables of these outputs are too wide for a page.
                let printed = ["coefficients", "beyond_limits"].contains(&table.name);
                let input = format!("\\input{{\\grazingfiles {}.tex}}", table.name);
                assert_eq!(snippet.matches(&input).count(), usize::from(printed), "{input} in {snippet}");
                assert_eq!(journal.join(table.name).with_extension("tex").is_file(), printed, "{input}");
            }
            continue;
        }
        let figure = output.figure_file();
        let pdf = Path::new(&figure).with_extension("pdf");
        let included = format!("\\includegraphics{{\\grazingfiles {}}}", pdf.display());
        assert_eq!(snippet.matches(&included).count(), 1, "{included} in {snippet}");
        assert_eq!(snippet.matches(&format!("\\label{{{}}}", output.label)).count(), 1, "{snippet}");
        let content = fs::read(journal.join(pdf)).expect("the snippet asks for PDF");
        assert!(content.starts_with(b"%PDF-"), "{figure}");
        let content = fs::read(journal.join(&figure).with_extension("png")).expect("PNG was asked for");
        // The width stands in the 17th to 20th byte: 86 mm are 243.8 points, and a point is a pixel at 72
        // dots per inch.
        assert_eq!(content[16..20], 244_u32.to_be_bytes(), "{figure}");
    }
}

#[test]
fn outlines_have_no_text_and_no_fonts() {
    let folder = project(&quick_parameters());
    let made = |place: &str, more: &[&str]| {
        let only = ["reproduce", "--only", "fig01", "--format", "svg,pdf", "--output", place];
        let made = grazing(folder.path(), &[&only[..], more].concat());
        assert_eq!(made.code, Some(0), "{}", made.messages);
        ["fig01.svg", "fig01.pdf"].map(|file| {
            let content = fs::read(folder.path().join(place).join(file)).expect("it was made");
            String::from_utf8_lossy(&content).into_owned()
        })
    };
    let [fonts, text] = made("fonts", &[]);
    let [outlines, paths] = made("outlines", &["--text", "outlines"]);
    assert!(fonts.contains("<text") && fonts.contains("@font-face") && text.contains("/FontFile"));
    assert!(!outlines.contains("<text") && !outlines.contains("@font-face") && !paths.contains("/FontFile"));
    let head = |svg: &str| svg[..svg.find("</title>").expect("it has a title")].to_owned();
    assert_eq!(head(&outlines), head(&fonts), "size and title");
}

/// The log of LaTeX for a document of class article, with one column or two, that includes
/// everything in a folder; none without pdflatex.
fn compiled(journal: &Path, options: &str) -> Option<String> {
    let numbers = fs::read_to_string(journal.join("numbers.tex")).expect("there are numbers");
    let named = numbers.lines().filter_map(|line| line.split_once("grazing@")?.1.split_once(r"\endcsname{"));
    let used: String = named.map(|(name, _)| format!("\\grazing{{{name}}}\n\n")).collect();
    assert!(used.contains(r"\grazing{c_sn_p"), "{numbers}");
    let document = format!(
        "\\documentclass[{options}]{{article}}\n\\usepackage{{graphicx,booktabs}}\n\\newcommand{{\\grazingfiles}}{{{}/}}\n\
         \\input{{\\grazingfiles numbers}}\n\\begin{{document}}\n{used}\n\\input{{\\grazingfiles figures}}\n\\end{{document}}\n",
        journal.display()
    );
    log_of(&document)
}

/// The log of LaTeX for a document; none without pdflatex.
fn log_of(document: &str) -> Option<String> {
    let place = empty_folder();
    fs::write(place.path().join("document.tex"), document).expect("the folder is ours");
    let run = || {
        let run = Command::new("pdflatex")
            // Boxes and labels are in the log, and nobody looks at the pages.
            .args(["-draftmode", "-interaction=nonstopmode", "-halt-on-error", "document.tex"])
            .current_dir(place.path())
            .stdin(Stdio::null())
            .output();
        match run {
            Ok(run) => {
                assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stdout));
                true
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => false,
            Err(error) => panic!("pdflatex could not be started: {error}"),
        }
    };
    // The second run knows the labels.
    if !(run() && run()) {
        // Written directly to the stream, which the test harness does not capture.
        writeln!(io::stderr(), "SKIPPED: there is no pdflatex, no document was compiled")
            .expect("a message can be written");
        return None;
    }
    let log = fs::read(place.path().join("document.log")).expect("there is a log");
    Some(String::from_utf8_lossy(&log).into_owned())
}

/// Fails if LaTeX complains of a document.
fn assert_sets_well(journal: &Path) {
    for options in ["onecolumn", "twocolumn"] {
        let Some(log) = compiled(journal, options) else { return };
        let told = complaints(&log);
        assert!(told.is_empty(), "{options}: {told:#?}");
    }
}

/// The lines of a log that tell of a box that is too large, a label that is missing or doubled, or anything else
/// that LaTeX warns of.
fn complaints(log: &str) -> Vec<&str> {
    let told =
        |line: &&str| ["Overfull", "Warning", "multiply", "undefined"].iter().any(|word| line.contains(word));
    log.lines().filter(told).collect()
}

#[test]
fn the_note_is_set_from_the_numbers_and_figures_of_a_run_on_eight_pages_at_most() {
    let edition = edition(SheetWidth::Paper);
    let note = repository().join("docs/paper/note.tex");
    let document = format!(
        "\\newcommand{{\\grazingfiles}}{{{}/}}\n\\AtEndDocument{{\\typeout{{pages: \\thepage}}}}\n\\input{{{}}}\n",
        edition.path().display(),
        note.display()
    );
    let Some(log) = log_of(&document) else { return };
    assert!(complaints(&log).is_empty(), "{:#?}", complaints(&log));
    let pages = log.lines().find_map(|line| line.strip_prefix("pages: ")?.parse::<u32>().ok());
    assert!(pages.is_some_and(|pages| (2..=8).contains(&pages)), "{pages:?}");
}

#[test]
fn latex_sets_all_figures_and_tables_at_every_width_without_an_overfull_box() {
    for columns in [SheetWidth::Paper, SheetWidth::OneColumn, SheetWidth::TwoColumns] {
        assert_sets_well(edition(columns).path());
    }
}

#[test]
fn latex_sets_what_is_unfolded_whatever_it_is_called_and_counted_in() {
    let oscillator = edited(&narrow_linear(), "", "name", "name = 'R&D: 50 % of a_b {雪} ~ $x$ \\ #1^2'");
    let folder = project("");
    let oscillator = edited(&oscillator, "[primary]", "range", "range = [0.2, 0.4]\nunit = 'µN^2/m %'");
    let units = "[units]\nlength = 'mm'\ntime = 's'\n";
    fs::write(folder.path().join("a #1%.toml"), format!("{oscillator}\n{units}"))
        .expect("the folder is ours");
    let arguments = ["unfold", "a #1%.toml", "--format", "tex", "--columns", "one", "--output", "results"];
    let made = grazing(folder.path(), &arguments);
    assert_eq!(made.code, Some(0), "{}", made.messages);
    let results = folder.path().join("results");
    let table = fs::read_to_string(results.join("coefficients.tex")).expect("it was asked for");
    assert!(table.contains(r"$A_{\mathrm{graz}}$ ($\mu$N$^{2}$/m \%)"), "{table}");
    assert_sets_well(&results);
}

#[test]
fn a_figure_that_changes_is_drawn_before_and_after() {
    let folder = project(DEFAULT);
    let temporary = folder.path().join("temporary");
    fs::create_dir(&temporary).expect("the folder is ours");
    let figure = folder.path().join("figures/fig08.svg");
    let svg = fs::read_to_string(repository().join("figures/fig08.svg")).expect("the figure is there");
    fs::write(&figure, svg.replace(">PD<", ">pd<")).expect("the folder is ours");
    for arguments in [&["reproduce", "--only", "fig08", "--check"][..], &["reproduce", "--only", "fig08"]] {
        let run = Command::new(env!("CARGO_BIN_EXE_grazing"))
            .args(arguments)
            .current_dir(folder.path())
            .envs(["TMPDIR", "TMP", "TEMP"].map(|name| (name, &temporary)))
            .output()
            .expect("the program starts");
        let messages = String::from_utf8(run.stderr).expect("the program writes UTF-8");
        let told = messages.split_once("fig08.svg: before, after and difference: ");
        let path = told.unwrap_or_else(|| panic!("no picture is named in {messages}")).1;
        let picture = fs::read(path.lines().next().expect("a line")).expect("the picture is there");
        assert!(picture.starts_with(b"\x89PNG"), "{arguments:?}");
        assert!(Path::new(path).starts_with(&temporary), "{path}");
    }
    // The figure is now as the code produces it, and nothing changes.
    assert_eq!(fs::read_to_string(&figure).expect("it was written"), svg);
    let unchanged = grazing(folder.path(), &["reproduce", "--only", "fig08"]);
    assert!(!unchanged.messages.contains("difference"), "{}", unchanged.messages);
}

#[test]
fn a_figure_that_cannot_be_drawn_is_replaced_all_the_same() {
    let folder = project(&quick_parameters());
    let figure = folder.path().join("figures/fig08.svg");
    fs::write(&figure, "old").expect("the folder is ours");
    let made = grazing(folder.path(), &["reproduce", "--only", "fig08"]);
    assert_eq!(made.code, Some(0), "{}", made.messages);
    assert!(made.messages.contains("fig08.svg: the change could not be drawn: the figure before:"));
    assert!(fs::read_to_string(&figure).expect("it was written").starts_with("<?xml"));
}

#[test]
fn the_manifest_for_codecheck_lists_every_output_and_every_file_is_there() {
    let manifest = fs::read_to_string(repository().join(codecheck::FILE)).expect("there is a manifest");
    assert_eq!(manifest, codecheck::manifest(), "mend it with `cargo xtask reproduce`");
    let files: Vec<&str> = manifest.lines().filter_map(|line| line.trim().strip_prefix("- file: ")).collect();
    assert!(files.len() >= outputs::ALL.len(), "{files:?}");
    for file in files {
        assert!(repository().join(file).is_file(), "{file}");
    }
}

#[test]
fn the_manifest_names_the_paper_as_the_citation_does() {
    let citation = fs::read_to_string(repository().join("CITATION.cff")).expect("there is a CITATION.cff");
    let paper = citation.split("references:").nth(1).expect("it cites the paper");
    assert!(paper.contains(&format!("title: \"{}\"", codecheck::TITLE)));
    assert!(paper.contains(&format!("url: \"{}\"", codecheck::REFERENCE)));
    for author in codecheck::AUTHORS {
        let (given, family) = author.rsplit_once(' ').expect("two names");
        assert!(paper.contains(given) && paper.contains(&format!("family-names: {family}")), "{author}");
    }
}
