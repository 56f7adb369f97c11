//! Every figure of the registry as a reader sees it, at every width.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::program::{digest, edition, repository, snapshots};
use crate::reading::{Reading, Shape, Text};
use grazing_cli::outputs;
use grazing_cli::outputs::edition::Edition;
use grazing_drawing::geometry::sheet::{Spot, cross, distance};
use grazing_drawing::{Bounds, SheetWidth};
use grazing_report::Drawing;

/// The thinnest line that offset printing renders reliably, in points, and the smallest text that
/// journals accept.
const THINNEST: f64 = 0.2;
const SMALLEST: f64 = 6.0;
/// The smallest sub- and superscript: smaller than its line, but readable.
const SMALLEST_SCRIPT: f64 = 5.0;
/// Points by which boxes of ink may touch or leave the sheet: coordinates are rounded to 0.01 point
/// in the file, and a stroke's width is counted to its mitred corners.
const HAIR: f64 = 0.15;
/// The least distance between labels of the same text, in points, and the greatest length of a leader.
const TWINS: f64 = 8.0;
const LONGEST_LEADER: f64 = 50.0;
/// The greatest height in points that leaves room for a caption on a page of class article, whose
/// text is 550 points high, at the widths of a journal: a caption of seven lines takes 90.
const HIGHEST: f64 = 460.0;
/// The most bytes of a figure.
const HEAVIEST: u64 = 2_000_000;

/// The figures of the registry: name of the output and of the file.
fn registered() -> Vec<(&'static str, String)> {
    let figures = outputs::ALL.iter().filter(|output| output.is_figure);
    figures.map(|output| (output.name, output.figure_file())).collect()
}

/// The figures in a folder, each with its text.
fn figures(folder: &Path) -> BTreeMap<&'static str, (String, Drawing)> {
    let read = |file: &str| {
        let svg = fs::read_to_string(folder.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        let figure = Drawing::read(&svg).unwrap_or_else(|error| panic!("{file}: {error}"));
        (svg, figure)
    };
    registered().into_iter().map(|(name, file)| (name, read(&file))).collect()
}

/// The faults of a figure for print; empty for a good one.
fn faults(figure: &Drawing) -> Vec<String> {
    let mut faults = Vec::new();
    let (texts, (right, bottom)) = (figure.texts(), figure.size());
    let sheet = Bounds { left: 0.0, top: 0.0, right, bottom }.grown(HAIR);
    for text in &texts {
        let name = &text.text;
        match text.bounds() {
            None => faults.push(format!("`{name}` shows nothing")),
            Some(bounds) if !sheet.holds(&bounds) => faults.push(format!("`{name}` leaves the sheet")),
            Some(_) => {}
        }
        if text.size < SMALLEST || text.smallest < SMALLEST_SCRIPT {
            faults.push(format!("`{name}` is set in {:.2}, scripts {:.2} points", text.size, text.smallest));
        }
    }
    for (index, text) in texts.iter().enumerate() {
        for other in texts[..index].iter().filter(|other| text.overlaps(other, HAIR)) {
            faults.push(format!("`{}` lies over `{}`", text.text, other.text));
        }
    }
    for shape in figure.shapes() {
        // A box that is not finite lies nowhere.
        let Bounds { left, top, right, bottom } = shape.bounds;
        let finite = [left, top, right, bottom].iter().all(|edge| edge.is_finite());
        if !(finite && sheet.holds(&shape.bounds)) {
            faults.push(format!("a shape leaves the sheet: {:?}", shape.bounds));
        }
        if let Some(width) = shape.stroke.filter(|width| *width < THINNEST - 1e-3) {
            faults.push(format!("a line is {width:.3} points wide at {:?}", shape.bounds));
        }
    }
    faults
}

/// The words of a figure: its labels that are not numbers at axes.
fn words(texts: &[Text]) -> BTreeSet<String> {
    let number = |text: &str| text.replace('−', "-").parse::<f64>().is_ok();
    texts.iter().map(|text| text.text.clone()).filter(|text| !number(text)).collect()
}

#[test]
fn every_figure_is_fit_for_print_at_every_width_and_says_the_same() {
    let here = figures(&repository().join("figures"));
    let mut all: Vec<String> = Vec::new();
    let mut collect = |width: &str, name: &str, faults: Vec<String>| {
        all.extend(faults.into_iter().map(|fault| format!("{name} at {width}: {fault}")));
    };
    for (name, (svg, figure)) in &here {
        collect("the paper's width", name, faults(figure));
        collect("the paper's width", name, misnamings(svg, figure));
        assert!(svg.contains("<title>") && !svg.contains("<title></title>"), "{name} has no title");
    }
    collect("the paper's width", "fig07", crossings(&here["fig07"], &repository().join("figures")));
    assert!(here.values().any(|(svg, _)| !leaders(svg).is_empty()), "no figure has a leader");
    for (columns, millimetres) in [(SheetWidth::OneColumn, 86.0), (SheetWidth::TwoColumns, 178.0)] {
        let folder = edition(columns);
        let width = &format!("{millimetres} mm");
        let there = figures(folder.path());
        for (name, (svg, figure)) in &there {
            collect(width, name, faults(figure));
            collect(width, name, misnamings(svg, figure));
            let (wide, high) = figure.size();
            // The file has the width in millimetres to two decimals.
            assert!((wide * 25.4 / 72.0 - millimetres).abs() < 0.01, "{name} at {width}: {wide} points");
            assert!(high <= HIGHEST, "{name} at {width} is {high} points high");
            assert_eq!(words(&here[name].1.texts()), words(&figure.texts()), "{name} at {width}");
        }
        collect(width, "fig07", crossings(&there["fig07"], folder.path()));
    }
    assert_eq!(all, [""; 0]);
}

/// Further faults of Figure 7: shapes that cross the frame of its panel, open rectangles; the folder has the
/// tables.
fn crossings((svg, figure): &(String, Drawing), folder: &Path) -> Vec<String> {
    let (shapes, panel) = (figure.shapes(), panel(svg));
    let mut faults = Vec::new();
    for shape in &shapes {
        // The frame is drawn with a line of which half lies outside.
        let (inside, outside) =
            (panel.grown(-HAIR).overlaps(&shape.bounds), !panel.grown(0.3 + HAIR).holds(&shape.bounds));
        let sheet = shape.stroke.is_none() && shape.bounds.holds(&panel);
        if inside && outside && !sheet {
            faults.push(format!("a shape crosses the frame: {:?}", shape.bounds));
        }
    }
    let rectangles: Vec<&str> = svg
        .lines()
        .filter(|line| line.starts_with("<path") && line.contains(" stroke=\"#f08200\""))
        .collect();
    let data = fs::read_to_string(folder.join("data/fig08_curves.csv")).expect("the table is there");
    let panels: BTreeSet<&str> = data.lines().skip(1).filter_map(|line| line.split(',').next()).collect();
    if rectangles.len() != panels.len() || panels.is_empty() {
        faults.push(format!("{} rectangles for {panels:?}", rectangles.len()));
    }
    faults.extend(rectangles.iter().filter(|line| !line.contains("Z\"")).map(|line| format!("open: {line}")));
    faults
}

/// Whether ink of a label touches a line.
fn touches(text: &Text, shape: &Shape) -> bool {
    let reach = 0.5 * shape.stroke.unwrap_or_default() - HAIR;
    let touched = |glyph: &Bounds| {
        let glyph = glyph.grown(reach);
        shape.pieces.iter().any(|piece| piece.windows(2).any(|pair| glyph.meets(pair[0], pair[1])))
    };
    shape.stroke.is_some() && text.glyphs.iter().any(touched)
}

/// The leaders of a figure, each from its label to what is named.
fn leaders(svg: &str) -> Vec<(Spot, Spot)> {
    let number = |text: &str| text.parse::<f64>().expect("a number");
    let spot = |text: &str| text.split_once(',').map(|(x, y)| (number(x), number(y)));
    let ends = |line: &str| {
        let data = line.split("d=\"M").nth(1)?.split('"').next()?;
        let (from, to) = data.split_once('L')?;
        spot(from).zip(spot(to))
    };
    let all = svg.lines().filter(|line| line.contains(" class=\"leader\""));
    all.map(|line| ends(line).expect("a leader is one straight line")).collect()
}

/// The faults of labels and leaders: labels on lines or clouds of points, or beside another one of the same
/// text; leaders that cross each other or a label, or are long.
fn misnamings(svg: &str, figure: &Drawing) -> Vec<String> {
    let (texts, shapes, leaders) = (figure.texts(), figure.shapes(), leaders(svg));
    let mut faults = Vec::new();
    for text in &texts {
        for shape in shapes.iter().filter(|shape| touches(text, shape)) {
            faults.push(format!("`{}` touches a line at {:?}", text.text, shape.bounds));
        }
    }
    let named: Vec<&Text> = texts.iter().filter(|text| text.text.chars().any(char::is_alphabetic)).collect();
    for (index, text) in named.iter().enumerate() {
        let twins = named[..index].iter().filter(|other| other.text == text.text);
        for other in twins.filter(|other| text.overlaps(other, -TWINS)) {
            faults.push(format!("`{}` stands beside another one: {:?}", text.text, other.bounds()));
        }
    }
    for (index, &(from, to)) in leaders.iter().enumerate() {
        faults.extend(leaders[..index].iter().filter(|other| cross(**other, (from, to))).map(|other| {
            format!("the leaders from {from:?} to {to:?} and from {:?} to {:?} cross", other.0, other.1)
        }));
        let covered = texts.iter().filter(|text| text.glyphs.iter().any(|glyph| glyph.meets(from, to)));
        faults.extend(covered.map(|text| format!("the leader to {to:?} crosses `{}`", text.text)));
        if distance(from, to) > LONGEST_LEADER {
            faults.push(format!("the leader to {to:?} is {:.0} points long", distance(from, to)));
        }
    }
    faults
}

/// The panel of a figure that has one.
fn panel(svg: &str) -> Bounds {
    let mark = svg.split("<rect class=\"panel\"").nth(1).expect("it says where its panel is");
    let number = |name: &str| -> f64 {
        let value = mark.split(&format!(" {name}=\"")).nth(1).and_then(|rest| rest.split('"').next());
        value.and_then(|value| value.parse().ok()).expect("a number")
    };
    let (left, top) = (number("x"), number("y"));
    Bounds { left, top, right: left + number("width"), bottom: top + number("height") }
}

#[test]
fn every_element_of_a_figure_can_be_drawn_and_no_coordinate_is_infinite() {
    for (name, file) in registered() {
        let svg = fs::read_to_string(repository().join("figures").join(file)).expect("the figure is there");
        let body = svg.split_once("</style>").expect("a style sheet").1;
        // The legend is for programs that show the figure, and not drawn.
        let body = body.split("<defs class=\"legend\">").next().expect("there is something before");
        for sign in ["NaN", "nan,", "inf", "Infinity"] {
            assert!(
                !body.contains(&format!("\"{sign}")) && !body.contains(&format!(",{sign}")),
                "{name}: {sign}"
            );
        }
        // Elements that the reader drops because it does not understand them are missing from what
        // it has read. Clip paths hold shapes that are not drawn themselves.
        let drawn = body.split("<clipPath").map(|part| part.rsplit("</clipPath>").next().unwrap_or(part));
        let count = |element: &str| drawn.clone().map(|part| part.matches(element).count()).sum::<usize>();
        let figure = Drawing::read(&svg).expect("the figure can be read");
        let written: usize =
            ["<path ", "<circle ", "<rect ", "<line ", "<polyline ", "<polygon ", "<ellipse "]
                .into_iter()
                .map(count)
                .sum();
        assert_eq!(figure.shapes().len(), written, "{name}: shapes");
        assert_eq!(figure.texts().len(), count("<text "), "{name}: labels");
        let size = svg.len() as u64;
        assert!(size < HEAVIEST, "{name} has {size} bytes");
    }
}

#[test]
fn every_kind_of_curve_in_the_data_is_named_in_its_figure() {
    // Bifurcations of solutions with several impacts are discs in the colours of their kinds, without names.
    let figures = outputs::ALL.iter().filter(|output| output.is_figure);
    for output in figures.filter(|output| output.name != "beyond_branches") {
        let file = repository().join("figures").join(output.figure_file());
        let svg = fs::read_to_string(file).expect("the figure is there");
        let texts = Drawing::read(&svg).expect("the figure can be read").texts();
        let labels: Vec<&str> = texts.iter().map(|text| text.text.as_str()).collect();
        for table in output
            .paths(&Edition::default())
            .iter()
            .filter(|path| path.extension().is_some_and(|ending| ending == "csv"))
        {
            let content =
                fs::read_to_string(repository().join("figures").join(table)).expect("the table is there");
            for kind in bifurcations(&content) {
                let named = labels.iter().any(|label| label.split(' ').any(|word| word == kind));
                assert!(named, "{}: `{kind}` of {} is not named: {labels:?}", output.name, table.display());
            }
        }
    }
}

/// The kinds of bifurcation in a table's column `kind` that figures name by the same letters.
fn bifurcations(table: &str) -> BTreeSet<&str> {
    let mut lines = table.lines();
    let column = lines.next().and_then(|header| header.split(',').position(|name| name == "kind"));
    let kinds = lines.filter_map(|line| line.split(',').nth(column?));
    kinds.filter(|kind| ["SN", "PD", "GZ"].contains(kind)).collect()
}

#[test]
fn no_figure_changes_unnoticed() {
    let mut digests = String::new();
    for (_, file) in registered() {
        let svg = fs::read(repository().join("figures").join(&file)).expect("the figure is there");
        digests.push_str(&format!("{file} {}\n", digest(&svg)));
    }
    snapshots().bind(|| insta::assert_snapshot!("figure_digests", digests));
}

#[test]
fn every_fault_of_a_figure_is_found_out() {
    let document = |body: &str| {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"50\" font-family=\"STIX Two Text\">{body}</svg>"
        )
    };
    let svg = |body: &str| faults(&Drawing::read(&document(body)).expect("it can be read"));
    let good = "<text x=\"10\" y=\"20\" font-size=\"8\">PD</text><path d=\"M1,1L9,9\" stroke=\"#000\"/>";
    assert_eq!(svg(good), [""; 0]);
    for (body, fault) in [
        ("<text x=\"95\" y=\"20\" font-size=\"8\">PD</text>", "leaves the sheet"),
        ("<text x=\"40\" y=\"20\" font-size=\"5\">PD</text>", "set in 5.00"),
        ("<text x=\"12\" y=\"21\" font-size=\"8\">SN</text>", "`SN` lies over `PD`"),
        ("<path d=\"M50,60L60,40\" stroke=\"#000\"/>", "a shape leaves"),
        ("<g transform=\"scale(0.1)\"><path d=\"M50,60L60,40\" stroke=\"#000\"/></g>", "0.100 points wide"),
    ] {
        let found = svg(&format!("{good}{body}"));
        assert!(found.len() == 1 && found[0].contains(fault), "{fault}: {found:?}");
    }
    for (body, fault) in [
        ("<path d=\"M8,17L30,18\" stroke=\"#000\"/>", "`PD` touches a line"),
        ("<text x=\"10\" y=\"30\" font-size=\"8\">PD</text>", "beside another one"),
        ("<path d=\"M60,10L60,30\" class=\"leader\"/><path d=\"M50,20L70,21\" class=\"leader\"/>", "cross"),
        ("<path d=\"M50,17L12,17\" class=\"leader\"/>", "crosses `PD`"),
        ("<path d=\"M40,40L95,40\" class=\"leader\"/>", "55 points long"),
    ] {
        let svg = document(&format!("{good}{body}").replace("><", ">\n<"));
        let found = misnamings(&svg, &Drawing::read(&svg).expect("it can be read"));
        assert!(found.len() == 1 && found[0].contains(fault), "{fault}: {found:?}");
    }
    let turned = "<text transform=\"rotate(45 10 20)\" x=\"10\" y=\"20\" font-size=\"8\">PD</text>";
    let beside = "<text x=\"10\" y=\"38\" font-size=\"8\">PD</text>";
    assert_eq!(
        svg(&format!("{turned}{beside}")),
        [""; 0],
        "boxes of turned labels are those of their characters"
    );
}
