//! A small report with all kinds of content, for the tests.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use grazing_claims::audit::{ClaimVerdict, Finding};
use grazing_claims::ledger::Ledger;
use grazing_claims::outcome::{Measure, Outcome};
use grazing_claims::published::{Published, PublishedComparison};
use grazing_claims::source::Sources;
use grazing_continuation::bifurcation::{CodimensionTwo, Pair};
use grazing_continuation::curve::Window;
use grazing_continuation::fit::{Estimate, Measurement};
use grazing_drawing::{Bounds, Element, PanelMark, Path, Sheet};
use grazing_input::Description;
use grazing_report::{
    FigureEntry, FiguresAndTables, FileDigest, Manifest, OscillatorEntry, Report, TableOutput,
};
use grazing_results::plane::SpecialPoint;
use grazing_results::{Cell, Column, Frame, Names, Table, Title, Tone, UnitNames, columns};
use grazing_theorems::LinearOscillator;
use grazing_theorems::hypothesis::{Hypothesis, ImposedCondition, Quantity, Theorem};
use grazing_unfold::simulation::ReturnOutcome;
use grazing_unfold::unfolded::{AtResonance, CurveFinding, Curves};
use grazing_unfold::verdict::Coefficient;
use grazing_unfold::verification::{Inconclusive, Sides, Simulated};

/// Text that would be markup if it were not escaped.
pub(crate) const HOSTILE: &str = "<img src=\"x\" onerror='alert(1)'>&";

/// The claims: two that hold and have errata, numbers, one with foreign text in every field, and one that is not checked.
static LEDGER: LazyLock<Ledger> = LazyLock::new(|| {
    let claim = |label: &str, kind: &str, place: &str, test: &str| {
        format!(
            "[[claim]]\nlabel = '{label}'\nplace = {place}\nkind = '{kind}'\nsays = 'What {label} says.'\n\
             holds = ['grazing_theorems::auxiliary::resonance_boundary']\nfigures = ['fig98', 'fig05']\n{test}\n"
        )
    };
    let hostile = format!("'''{HOSTILE}'''");
    let (check, place) = ("check = 'main_results::auxiliary::bounds'", "'section 2.4, eq. (15)'");
    let formula = r"formula = 'g_p(\delta) = 2 \sqrt{\delta} \cos \left( \frac{\pi}{p} \right)'";
    let broken = format!("formula = '''\\nosuchcommand{{{HOSTILE}}}'''");
    let misprint = format!(
        "[claim.misprint]\nprinted = '$x = 1$'\ncorrected = '$x = 2$'\nreason = {hostile}\ndecided = 'a count'\n"
    );
    let text = [
        claim("eq:holds", "identity", place, &format!("{check}\n{formula}\n{misprint}kind = 'wording'")),
        claim("eq:misprinted", "theorem", "'appendix B'", &format!("{check}\n{formula}\n{misprint}")),
        claim("fig:number", "number", place, "published = ['a']"),
        claim("sub:2/hostile", "identity", &hostile, &format!("{check}\n{broken}")),
        claim("eq:unchecked", "identity", place, &format!("unchecked = {hostile}")),
    ];
    let text = text.concat().replace("'What sub:2/hostile says.'", &hostile);
    toml::from_str(&text).expect("the sample is right")
});

static PUBLISHED: LazyLock<Published> = LazyLock::new(|| {
    let value = |id: &str| {
        format!(
            "[[value]]\nid = '{id}'\nquantity = 'tau of Figure 98'\nlabel = 'eq:holds'\nwhere = 'caption'\n\
             value = '0.5'\nrounding = 'significant'\n"
        )
    };
    toml::from_str(&(value("a") + &value("b"))).expect("the sample is right")
});

fn findings() -> Vec<Finding<'static>> {
    let held = Measure::Deviation { largest: 2e-15, tolerance: 1e-12 };
    let cases = |agreeing| Measure::Agreement { agreeing, cases: 12 };
    let verdicts = [
        ClaimVerdict::Measured(Outcome::new(held, 400, "points of the trapesium")),
        ClaimVerdict::Measured(Outcome::new(cases(12), 12, "cases").against_print(cases(0))),
        ClaimVerdict::Numbers(vec![PublishedComparison {
            published: &PUBLISHED.values[0],
            computed: Some(0.501),
        }]),
        ClaimVerdict::Broken(HOSTILE.to_owned()),
        ClaimVerdict::Unchecked(HOSTILE.to_owned()),
    ];
    let found = LEDGER.claims.iter().zip(verdicts);
    found.map(|(claim, verdict)| Finding { claim, verdict, time: Default::default() }).collect()
}

fn figure(name: &str, title: Title<&'static str>) -> FigureEntry {
    let markup = |text: &str| Element::Markup(text.to_owned());
    let line = Path {
        pieces: vec![(vec![(2000, 9000), (10_000, 5000), (18_000, 1000)], false)],
        attributes: " clip-path=\"url(#frame)\" stroke=\"#1946be\"".to_owned(),
    };
    let panel = PanelMark {
        bounds: Bounds { left: 20.0, top: 10.0, right: 180.0, bottom: 90.0 },
        frame: Frame { x: [0.0, 4.0], y: [-1.0, 1.0] },
        titles: [r"$\mathcal{A}$", r"$\omega$"].map(str::to_owned),
        tables: Vec::new(),
        only: None,
        linear: true,
        columns: None,
    };
    let sheet = Sheet {
        title: title.to_string(),
        description: "A line through three points.".to_owned(),
        size: (200.0, 120.0),
        elements: vec![
            markup("<clipPath id=\"frame\"><rect x=\"20\" y=\"10\" width=\"160\" height=\"80\"/></clipPath>"),
            Element::Path(line),
            markup(
                "<path transform=\"translate(20 10) scale(0.5)\" d=\"M100,60.5h3m5,20h1\" stroke=\"#2d4669\" stroke-width=\"1\"/>",
            ),
            Element::Panel(panel),
        ],
        ..Sheet::default()
    };
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
    FigureEntry { name: name.to_owned(), title: title.owned(), sheet, tables }
}

fn sweep() -> Table {
    const COLUMNS: &[Column] = &[columns::LOOPS, columns::C_SN_CLOSED_FORM, columns::VERDICT];
    let [agreement, unexplained] =
        [Cell::Verdict("agreement", Tone::Passed), Cell::Verdict("unexplained", Tone::Failed)];
    let mut rows = vec![
        (1_u32, -5.679_445_287_380_571e2, agreement.clone()),
        (2, 3.0, unexplained),
        (3, 1e-7, agreement.clone()),
    ];
    // Enough rows to be kept for the scripts.
    rows.extend((4..60).map(|p| (p, 0.5 * f64::from(p), agreement.clone())));
    let rows = rows.into_iter().map(|(p, c_sn, verdict)| vec![p.into(), c_sn.into(), verdict]);
    Table::of_cells("sweep", COLUMNS, &Names::of_the_paper(), rows.collect())
}

/// A coefficient that is measured with a value and an error.
pub(crate) const fn coefficient(value: f64, error: f64) -> Coefficient {
    let coefficient = Estimate { value, error };
    let fit = Measurement { coefficient, eta: [1.0, 0.0], mu: [1.0, 0.0], velocity: 0.1 };
    Coefficient { stability: 1.0, theorem: Estimate { value: -12.5, error: 1e-9 }, fit: Ok(fit) }
}

/// A measurement that agrees to seven digits.
pub(crate) const MEASURED: (f64, f64) = (-12.500_001, 1e-5);
/// A measurement whose error is too large for a comparison.
pub(crate) const NOT_MEASURED: (f64, f64) = (-12.5, 1.0);

/// The simulation beside the curves.
pub(crate) const SIDES: Sides = Sides {
    velocity: 0.1,
    predicted: [true, false],
    seen: [ReturnOutcome::Returns; 2],
    attracts: [Some(true), Some(false)],
    gone_beyond: None,
};

/// An oscillator, with foreign text wherever there can be any.
pub(crate) fn oscillator(id: &str, name: &str) -> OscillatorEntry {
    let hostile = || HOSTILE.to_owned();
    let description = format!(
        "name = '''{name}'''\n[parameters]\nkappa = -0.1\nzeta = 0.02\n[primary]\nname = 'F_0'\nrange = [0.0, 4.0]\nunit = 'N'\n\
         [secondary]\nname = 'A'\nrange = [-1.0, 1.0]\n[motion]\nforce = 'F_0*cos(t) + A - x - kappa*x^3 - zeta*v - 1'\n\
         frequency = '1'\n[impact]\nrestitution = '0.9'\nduration = '0'\n[analysis]\nloops = [1, 2]\n"
    );
    let mut drawn = figure("diagram", Title::plain("two-parameter bifurcation diagram"));
    // The panel names the columns that it shows, as titles of parameters do not.
    if let Some(Element::Panel(panel)) = drawn.sheet.elements.last_mut() {
        (panel.columns, panel.tables) = (Some(["F_0", "A"].map(str::to_owned)), vec!["points"]);
    }
    let units = UnitNames { primary: Some("N".to_owned()), ..UnitNames::default() };
    let names = Names::new("F_0", "A").with_units(units);
    let point = |kind, primary, secondary| SpecialPoint { kind, loops: 1, wall: 0, n: 1, secondary, primary };
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
    let point = LinearOscillator::new(0.05, 0.8).and_then(|oscillator| oscillator.resonance(2, 1));
    let point = point.expect("they are in the domain").resonant_point();
    let resonance = |n, curves, value| AtResonance {
        loops: 2,
        wall: 0,
        n,
        parameters: [0.5, 0.75],
        point,
        theorem: Theorem::ResonantMultiLoop,
        hypotheses: vec![Hypothesis {
            quantity: Quantity::OffDiagonalTimesSquareRootFactor,
            value,
            condition: ImposedCondition::Positive,
        }],
        curves,
    };
    let finding =
        |(value, error), simulated| CurveFinding { coefficient: coefficient(value, error), simulated };
    let unfolded = Curves {
        findings: Pair {
            saddle_node: finding(MEASURED, Simulated::AsPredicted(SIDES)),
            period_doubling: finding(NOT_MEASURED, Simulated::Undecided(Inconclusive::NotMeasured)),
        },
        doubled_grazing: f64::NAN,
        window: Window { primary: [0.0, 1.0], secondary: [0.0, 1.0] },
        straightened: Vec::new(),
        magnified: Vec::new(),
    };
    OscillatorEntry {
        id: id.to_owned(),
        file: hostile(),
        link: Some("https://example.org/a/blob/HEAD/examples/sample.toml".to_owned()),
        about: vec![hostile(), "x + kappa x^3 of $\\nobody$".to_owned()],
        description: Description::parse(&description, "sample.toml").expect("the sample is right"),
        figures: vec![drawn],
        tables: vec![Table::of_cells("coefficients", COLUMNS, &names, coefficients)],
        resonances: vec![resonance(1, Some(unfolded), 0.25), resonance(2, None, -0.25)],
        lost: vec![hostile()],
        undecided: vec![(2, hostile())],
    }
}

/// A report about an oscillator alone, with its files beside the page.
pub(crate) fn oscillators_alone() -> Report<'static> {
    let files = ["diagram.svg", "data/points.csv"];
    Report {
        oscillators: vec![oscillator("one", "Sample oscillator")],
        manifest: Manifest {
            outputs: files.map(|path| FileDigest::of(path, path.as_bytes())).to_vec(),
            folder: None,
            ..report().manifest
        },
        ..Report::default()
    }
}

/// The report with all kinds of content.
pub(crate) fn report() -> Report<'static> {
    let source = ("crates/theorems/src/auxiliary.rs", "pub fn resonance_boundary() {}\n");
    let file = |path: &str| FileDigest::of(path, path.as_bytes());
    Report {
        missing: vec![HOSTILE.to_owned()],
        figures: vec![
            figure("fig98", Title::figure(98, "a line")),
            figure("fig99", Title::figure(99, "another line")),
        ],
        tables: vec![TableOutput {
            name: "sweep".to_owned(),
            title: HOSTILE.to_owned().into(),
            tables: vec![sweep()],
        }],
        beyond: FiguresAndTables {
            tables: vec![TableOutput {
                name: "open".to_owned(),
                title: HOSTILE.to_owned().into(),
                tables: Vec::new(),
            }],
            ..FiguresAndTables::default()
        },
        published: PUBLISHED.compare(&BTreeMap::from([("a".to_owned(), 0.501)])),
        claims: findings(),
        sources: Sources::new([(source.0.to_owned(), source.1.to_owned())]),
        oscillators: vec![oscillator("one", "Sample oscillator"), oscillator("two", HOSTILE)],
        manifest: Manifest {
            program: "grazing 0.1.0".to_owned(),
            rust: "1.95.0".to_owned(),
            libraries: vec![("libm".to_owned(), "0.2.16".to_owned())],
            parameter_file: "figures/parameters.toml".to_owned(),
            parameters: format!("# {HOSTILE}\n[oscillator]\n"),
            outputs: ["fig98.svg", "data/fig98_points.csv", "data/sweep.csv"].map(file).to_vec(),
            folder: Some("https://example.org/a/blob/HEAD/figures/".to_owned()),
        },
        root: Some("https://example.org/a/blob/HEAD/".to_owned()),
    }
}
