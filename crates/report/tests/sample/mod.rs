//! A small report with everything in it, for the tests.

use grazing_continuation::bifurcation::CodimensionTwo;
use grazing_report::{
    ClaimEntry, CoefficientEntry, Figure, Finding, Judgement, Manifest, Measured, MisprintEntry,
    OscillatorEntry, OutputFile, PublishedEntry, Report, ResonanceEntry, Source, TableOutput, Verdict,
};
use grazing_results::plane::SpecialPoint;
use grazing_results::{Column, Names, Table, columns};

/// Text that would be markup if it were not escaped.
pub(crate) const HOSTILE: &str = "<img src=\"x\" onerror='alert(1)'>&";

/// A claim that passed its check.
fn claim(label: &str) -> ClaimEntry {
    ClaimEntry {
        label: label.to_owned(),
        place: "section 2.4, eq. (15)".to_owned(),
        kind: "identity".to_owned(),
        says: format!("What {label} says."),
        formula: Some(r"g_p(\delta) = 2 \sqrt{\delta} \cos \left( \frac{\pi}{p} \right)".to_owned()),
        holds: vec![Source {
            name: "grazing_theorems::auxiliary::resonance_boundary".to_owned(),
            file: Some(("crates/theorems/src/auxiliary.rs".to_owned(), 12)),
        }],
        check: Some(Source { name: "main_results::auxiliary::boundary".to_owned(), file: None }),
        figures: vec!["fig98".to_owned(), "fig05".to_owned()],
        verdict: Verdict::Checked {
            passed: true,
            measured: Measured::Deviation { largest: 2e-15, tolerance: 1e-12 },
            print: None,
            samples: 400,
            over: "points of the trapesium".to_owned(),
        },
        misprint: None,
    }
}

fn figure(name: &str, title: &str) -> Figure {
    let svg = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"70mm\" height=\"40mm\" \
         viewBox=\"0 0 200 120\" font-family=\"'STIX Two Text',serif\" fill=\"none\" role=\"img\">\n<title>{title}</title>\n\
         <desc>A line through three points.</desc>\n<style>\n@font-face{{font-family:'STIX Two Text';src:url(data:font/ttf;base64,AAAA)}}\n</style>\n\
         <rect width=\"200\" height=\"120\" fill=\"#ffffff\"/>\n<clipPath id=\"frame\"><rect x=\"20\" y=\"10\" width=\"160\" height=\"80\"/></clipPath>\n\
         <path clip-path=\"url(#frame)\" d=\"M20,90L100,50L180,10\" stroke=\"#1946be\"/>\n\
         <rect class=\"panel\" x=\"20\" y=\"10\" width=\"160\" height=\"80\" data-x=\"0 4\" data-y=\"-1 1\" data-x-title=\"$\\mathcal{{A}}$\" \
         data-y-title=\"$\\omega$\"/>\n</svg>\n"
    );
    const COLUMNS: &[Column] = &[
        columns::BIFURCATION,
        columns::LOOPS,
        columns::PRIMARY,
        columns::SECONDARY,
        columns::STABLE,
        columns::ADMISSIBLE,
    ];
    let row = |kind: &'static str, p: u32, amplitude: f64, omega: f64, stable: bool, admissible: bool| {
        vec![kind.into(), p.into(), amplitude.into(), omega.into(), stable.into(), admissible.into()]
    };
    let rows = vec![
        row("SN", 1, 0.0, -1.0, true, true),
        row("SN", 1, 2.0, 0.0, false, true),
        row("PD", 2, 4.0, 1.0, true, false),
    ];
    let name_of_table = if name == "fig98" { "fig98_points" } else { "fig99_points" };
    let tables = vec![Table::of_cells(name_of_table, COLUMNS, &Names::of_the_paper(), rows)];
    Figure { name: name.to_owned(), title: title.to_owned(), svg, tables }
}

fn sweep() -> Table {
    const COLUMNS: &[Column] = &[columns::LOOPS, columns::C_SN_CLOSED_FORM, columns::VERDICT];
    let rows =
        [(1_u32, -5.679_445_287_380_571e2, "agreement"), (2, 3.0, "unexplained"), (3, 1e-7, "agreement")];
    let rows = rows.map(|(p, c_sn, verdict)| vec![p.into(), c_sn.into(), verdict.into()]);
    Table::of_cells("sweep", COLUMNS, &Names::of_the_paper(), rows.into())
}

fn published(id: &str, met: bool) -> PublishedEntry {
    PublishedEntry {
        id: id.to_owned(),
        quantity: "tau of Figure 98".to_owned(),
        printed: "0.5".to_owned(),
        computed: met.then_some(0.501),
        met,
        label: "eq:holds".to_owned(),
        place: "caption".to_owned(),
    }
}

/// An oscillator, with text of others in every place.
pub(crate) fn oscillator(id: &str, name: &str) -> OscillatorEntry {
    let hostile = || HOSTILE.to_owned();
    let coefficient = |measured, judgement: Judgement| CoefficientEntry {
        theorem: -12.5,
        measured,
        agreement: judgement.clone(),
        simulation: judgement,
    };
    let resonance = |n, finding| ResonanceEntry { loops: 2, n, primary: 0.5, secondary: 0.75, finding };
    let unfolded =
        [coefficient(Some((-12.500_001, 7)), Judgement::For), coefficient(None, Judgement::Open(hostile()))];
    let mut drawn = figure("diagram", "two-parameter bifurcation diagram");
    // The panel says which columns it shows, as titles of parameters do not.
    drawn.svg = drawn.svg.replace("data-x=", "data-columns=\"F_0 A\" data-tables=\"points\" data-x=");
    let names = Names::new("F_0", "A");
    let point = |kind, primary, secondary| SpecialPoint { kind, loops: 1, n: 1, secondary, primary };
    let points =
        [point(CodimensionTwo::Resonance, 2.0, 0.0), point(CodimensionTwo::SaddleNodeGrazing, 4.0, 1.0)];
    drawn.tables = vec![Table::new("points", &names, &points)];
    const COLUMNS: &[Column] = &[
        columns::LOOPS,
        columns::RESONANCE_INDEX,
        columns::SECONDARY_AT_RESONANCE,
        columns::PRIMARY_AT_GRAZING,
        columns::C_SN,
    ];
    let row = |p: u32, secondary: f64, primary: f64, c_sn: f64| {
        vec![p.into(), 1_u32.into(), secondary.into(), primary.into(), c_sn.into()]
    };
    let coefficients = vec![row(2, 0.75, 0.5, -12.5), row(3, 0.7, 0.6, 25.0)];
    OscillatorEntry {
        id: id.to_owned(),
        name: name.to_owned(),
        file: hostile(),
        link: Some("../examples/sample.toml".to_owned()),
        about: vec![hostile(), "x + kappa x^3 of $\\nobody$".to_owned()],
        force: hostile(),
        frequency: hostile(),
        restitution: hostile(),
        duration: hostile(),
        constants: vec![("zeta".to_owned(), 0.02), ("kappa".to_owned(), -0.1)],
        primary: ("F_0".to_owned(), [0.0, 4.0]),
        secondary: ("A".to_owned(), [-1.0, 1.0]),
        loops: vec![1, 2],
        figures: vec![drawn],
        tables: vec![Table::of_cells("coefficients", COLUMNS, &names, coefficients)],
        resonances: vec![
            resonance(1, Finding::Unfolded(Box::new(unfolded))),
            resonance(2, Finding::Silent(vec![("a12 alpha > 0".to_owned(), -0.25)])),
        ],
        lost: vec![hostile()],
        undecided: vec![(2, hostile())],
        files: Vec::new(),
    }
}

/// A report about an oscillator alone, with its files beside the page.
pub(crate) fn oscillators_alone() -> Report {
    let files = ["diagram.svg", "data/points.csv"];
    let mut entry = oscillator("one", "Sample oscillator");
    entry.files = files.map(str::to_owned).to_vec();
    let report = report();
    Report {
        missing: Vec::new(),
        figures: Vec::new(),
        tables: Vec::new(),
        published: Vec::new(),
        claims: Vec::new(),
        oscillators: vec![entry],
        manifest: Manifest {
            outputs: files.map(|path| OutputFile::of(path, path.as_bytes())).to_vec(),
            folder: Some(String::new()),
            ..report.manifest
        },
        root: None,
    }
}

/// The report.
pub(crate) fn report() -> Report {
    let hostile = || HOSTILE.to_owned();
    let misprint = MisprintEntry {
        printed: "$x = 1$".to_owned(),
        corrected: "$x = 2$".to_owned(),
        reason: hostile(),
        decided: "a count".to_owned(),
        typographic: false,
    };
    let claims = vec![
        claim("eq:holds"),
        ClaimEntry {
            kind: "theorem".to_owned(),
            place: "appendix B".to_owned(),
            verdict: Verdict::Checked {
                passed: true,
                measured: Measured::Agreement { agreeing: 12, cases: 12 },
                print: Some(Measured::Agreement { agreeing: 0, cases: 12 }),
                samples: 12,
                over: "cases".to_owned(),
            },
            misprint: Some(misprint),
            ..claim("eq:misprinted")
        },
        ClaimEntry {
            kind: "number".to_owned(),
            formula: None,
            verdict: Verdict::Published { values: vec![published("a", true)] },
            ..claim("fig:number")
        },
        ClaimEntry {
            says: hostile(),
            place: hostile(),
            formula: Some(format!(r"\nosuchcommand{{{HOSTILE}}}")),
            holds: vec![Source { name: hostile(), file: Some((hostile(), 1)) }],
            verdict: Verdict::Failed { error: hostile() },
            ..claim("sub:2/hostile")
        },
        ClaimEntry { verdict: Verdict::Unchecked { reason: hostile() }, ..claim("eq:unchecked") },
    ];
    let file = |path: &str| OutputFile::of(path, path.as_bytes());
    Report {
        missing: vec![hostile()],
        figures: vec![figure("fig98", "Figure 98: a line"), figure("fig99", "Figure 99: another line")],
        tables: vec![TableOutput { name: "sweep".to_owned(), title: hostile(), tables: vec![sweep()] }],
        published: vec![published("a", true), published("b", false)],
        claims,
        oscillators: vec![oscillator("one", "Sample oscillator"), oscillator("two", HOSTILE)],
        manifest: Manifest {
            program: "grazing 0.1.0".to_owned(),
            rust: "1.95.0".to_owned(),
            libraries: vec![("libm".to_owned(), "0.2.16".to_owned())],
            parameter_file: "figures/parameters.toml".to_owned(),
            parameters: format!("# {HOSTILE}\n[oscillator]\n"),
            outputs: ["fig98.svg", "data/fig98_points.csv", "data/sweep.csv"].map(file).to_vec(),
            folder: Some("../figures/".to_owned()),
        },
        root: Some("../".to_owned()),
    }
}
