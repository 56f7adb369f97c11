//! LaTeX: tables for booktabs, and a snippet that includes figures and tables.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use askama::Template;
use grazing_drawing::Sheet;
use grazing_results::columns::{LOOPS, RESONANCE_INDEX};
use grazing_results::title::{TitlePart, TitleSubject, parts};
use grazing_results::{Cell, Column, GREEK, Scientific, Table, Title, raised, symbol, words};

use crate::folder::{self, OutputFile};
use crate::template::rendered;

/// Significant digits of the smallest number in a column; all its numbers have the same number of decimals.
const DIGITS: i32 = 4;
/// The most decimals; columns with smaller numbers are printed with powers of ten.
const MOST_DECIMALS: i32 = 6;
/// The most rows that fit a page; larger tables are left to the author.
const MOST_ROWS: usize = 45;
/// The width of a column of a journal with two, in points; wider figures span both.
const COLUMN: f64 = 245.0;
/// The most floats in a row: LaTeX keeps no more than 52 in memory until it has a page for them.
pub(crate) const MOST_FLOATS: usize = 40;
/// The file of the snippet, and that of the numbers.
pub(crate) const FILES: [&str; 2] = ["figures.tex", "numbers.tex"];

/// The path of a table in the output folder.
pub(crate) fn table_path(name: &str) -> PathBuf {
    Path::new(name).with_extension("tex")
}

/// A `tabular` with the rules of booktabs.
#[derive(Template)]
#[template(path = "tabular.tex", escape = "none")]
struct Tabular {
    title: String,
    /// The name of the table.
    name: &'static str,
    alignment: String,
    headings: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// The table as a tabular: numbers rounded and aligned at the decimal point, units in the headings.
fn tabular(table: &Table, printed: &[Column], title: &str) -> String {
    let place = |column: &Column| table.columns.iter().position(|found| found.name == column.name);
    let places: Vec<usize> = printed.iter().filter_map(place).collect();
    let columns: Vec<(Vec<String>, bool)> = places.iter().map(|&place| cells(table, place)).collect();
    let heading = |&place: &usize| {
        let name = match table.symbols[place].as_str() {
            "" => escaped(&table.headers[place]),
            symbol => format!("${symbol}$"),
        };
        match table.units[place].as_str() {
            "" => name,
            unit => format!("{name} ({})", outside_formulas(&raised(unit))),
        }
    };
    let row = |row: usize| columns.iter().map(|(cells, _)| cells[row].clone()).collect();
    rendered(&Tabular {
        title: escaped(title),
        name: table.name,
        alignment: columns.iter().map(|(_, numeric)| if *numeric { 'r' } else { 'l' }).collect(),
        headings: places.iter().map(heading).collect(),
        rows: (0..table.rows.len()).map(row).collect(),
    })
}

/// The markup of a label for LaTeX; formulas between dollars stay as they are.
fn outside_formulas(markup: &str) -> String {
    let pieces = markup.split('$').enumerate();
    pieces.map(|(k, piece)| if k % 2 == 0 { escaped(piece) } else { format!("${piece}$") }).collect()
}

/// The cells of a column, and whether they are numbers.
fn cells(table: &Table, place: usize) -> (Vec<String>, bool) {
    let cells = || table.rows.iter().map(|row| &row[place]);
    match cells().next() {
        Some(Cell::Number(_)) => (aligned(&cells().map(Cell::number).collect::<Vec<_>>()), true),
        first => {
            let written = |cell: &Cell| match cell {
                Cell::Text(words) => escaped(words),
                Cell::Verdict(word, _) => escaped(word),
                Cell::Integer(value) => value.to_string(),
                Cell::Flag(value) => value.to_string(),
                Cell::Number(value) => value.to_string(),
            };
            (cells().map(written).collect(), matches!(first, Some(Cell::Integer(_))))
        }
    }
}

/// Numbers with the same number of decimals, so that they align, or with powers of ten if they are
/// too small for that.
fn aligned(numbers: &[Option<f64>]) -> Vec<String> {
    let finite = || numbers.iter().flatten().copied().filter(|number| number.is_finite());
    let least = finite().map(f64::abs).filter(|size| *size > 0.0).fold(f64::INFINITY, f64::min);
    let exponent = if least.is_finite() { libm::floor(libm::log10(least)) as i32 } else { 0 };
    let decimals = (DIGITS - 1 - exponent).max(0);
    let print = |number: f64| {
        if decimals <= MOST_DECIMALS {
            let places = usize::try_from(decimals).unwrap_or(0);
            return format!("${number:.places$}$");
        }
        let Scientific { mantissa, exponent } =
            Scientific::rounded(number, usize::try_from(DIGITS).unwrap_or(1));
        format!(r"${mantissa}\times10^{{{exponent}}}$")
    };
    let shown = |number: &Option<f64>| number.filter(|number| number.is_finite()).map(print);
    numbers.iter().map(|number| shown(number).unwrap_or_default()).collect()
}

/// The caption of a figure or a table in a document.
#[derive(Clone, Debug)]
pub(crate) struct Caption {
    /// The title.
    pub(crate) title: Title,
    /// The label by which the document refers to the figure or table.
    pub(crate) label: String,
    /// A sentence after all others, with a space before it.
    pub(crate) remark: String,
}

impl Caption {
    /// The label of something that is computed from a file, `kind` being `fig` or `tab`.
    pub(crate) fn label(kind: &str, file: &Path, name: &str) -> String {
        // Not every character of a file's name is allowed in a label.
        let plain = |letter: char| if letter.is_ascii_alphanumeric() { letter } else { '-' };
        let of: String = folder::name_for(file).to_string_lossy().chars().map(plain).collect();
        format!("{kind}:{of}-{name}")
    }
}

/// A figure or table of the snippet.
pub(crate) struct Float {
    environment: &'static str,
    body: String,
    caption: Vec<Piece>,
    label: String,
    /// The number of the figure in the paper, by which other captions mention it.
    number: Option<u32>,
    /// The numbers of each resonance, under names such as `c_sn_p2_n1`.
    numbers: Vec<(String, String)>,
}

impl Float {
    /// A figure, by the file of its SVG, with the description of the sheet in the caption.
    pub(crate) fn figure(file: &str, sheet: &Sheet, caption: &Caption) -> Self {
        let pdf = Path::new(file).with_extension("pdf");
        let number = match caption.title.place {
            TitleSubject::Figure(number) => Some(number),
            _ => None,
        };
        let text = [&sentence(&caption.title), &*sheet.description, caption.remark.trim_start()];
        let text = text.into_iter().filter(|text| !text.is_empty());
        Self {
            environment: if sheet.size.0 > COLUMN { "figure*" } else { "figure" },
            body: format!("\\includegraphics{{\\grazingfiles {}}}", pdf.display()),
            caption: prose(&text.collect::<Vec<_>>().join(" ")),
            label: caption.label.clone(),
            number,
            numbers: Vec::new(),
        }
    }

    /// Columns of a table, and its file; none if the table is empty or does not fit a page.
    pub(crate) fn table(table: &Table, printed: &[Column], caption: &Caption) -> Option<(Self, OutputFile)> {
        if table.rows.is_empty() || table.rows.len() > MOST_ROWS {
            return None;
        }
        let path = table_path(table.name);
        let float = Self {
            environment: "table*",
            body: format!("\\input{{\\grazingfiles {}}}", path.display()),
            caption: prose(&sentence(&caption.title)),
            label: caption.label.clone(),
            number: None,
            numbers: numbers(table, printed),
        };
        let content = tabular(table, printed, &caption.title.to_string()).into_bytes();
        Some((float, OutputFile { path, content }))
    }
}

/// The cells of a table with a row for each resonance, by column, p and n; the names of a second
/// resonance with the same p and n end with `_2`, and so on.
fn numbers(table: &Table, printed: &[Column]) -> Vec<(String, String)> {
    let place = |column: &Column| table.columns.iter().position(|found| found.name == column.name);
    let (Some(p), Some(n)) = (place(&LOOPS), place(&RESONANCE_INDEX)) else { return Vec::new() };
    let keys: Vec<(String, String)> = cells(table, p).0.into_iter().zip(cells(table, n).0).collect();
    let of = |place: usize| {
        let header = &table.headers[place];
        let named = |(row, text): (usize, String)| {
            let (p, n) = &keys[row];
            let known = keys[..row].iter().filter(|key| **key == keys[row]).count();
            let again = if known > 0 { format!("_{}", known + 1) } else { String::new() };
            (format!("{header}_p{p}_n{n}{again}"), text)
        };
        cells(table, place).0.into_iter().enumerate().map(named).collect::<Vec<_>>()
    };
    printed.iter().filter_map(place).filter(|place| ![p, n].contains(place)).flat_map(of).collect()
}

/// The numbers of a run, for use in a text.
#[derive(Template)]
#[template(path = "numbers.tex", escape = "none")]
struct Numbers {
    /// The numbers, each with its name.
    numbers: Vec<(String, String)>,
}

/// The snippet that includes figures and tables.
#[derive(Template)]
#[template(path = "figures.tex", escape = "none")]
struct Snippet<'a> {
    floats: &'a [Float],
}

/// The file of the snippet, and that of the numbers, which include constants.
pub(crate) fn files<'a>(
    floats: &[Float],
    constants: impl IntoIterator<Item = (&'a str, f64)>,
) -> [OutputFile; 2] {
    let constants = constants.into_iter().map(|(name, value)| (name.to_owned(), format!("${value}$")));
    let numbers = constants.chain(floats.iter().flat_map(|float| float.numbers.clone())).collect();
    let [snippet, names] = FILES.map(PathBuf::from);
    [
        OutputFile { path: snippet, content: rendered(&Snippet { floats }).into_bytes() },
        OutputFile { path: names, content: rendered(&Numbers { numbers }).into_bytes() },
    ]
}

/// A title as a sentence, without its number: LaTeX numbers captions itself.
fn sentence<Words: AsRef<str>>(title: &Title<Words>) -> String {
    let words = match (title.place, title.before()) {
        (TitleSubject::Beyond, Some(before)) => Cow::Owned(format!("{before}: {}", title.words.as_ref())),
        _ => Cow::Borrowed(title.words.as_ref()),
    };
    let mut letters = words.chars();
    let first = letters.next().map(|letter| letter.to_uppercase().to_string()).unwrap_or_default();
    format!("{first}{}.", letters.as_str())
}

/// A piece of a caption.
#[derive(Debug, PartialEq)]
enum Piece {
    /// LaTeX.
    Text(String),
    /// The mention of a figure of the paper.
    Figure(u32),
}

/// Text for LaTeX, with names of quantities as symbols: x, tau, g_p. Formulas between dollars stay.
fn prose(text: &str) -> Vec<Piece> {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let piece = |part| match part {
        TitlePart::Words(words) => Piece::Text(with_symbols(words)),
        TitlePart::Figure(number) => Piece::Figure(number),
    };
    let mut pieces = Vec::new();
    for (index, between) in text.split('$').enumerate() {
        match index % 2 {
            0 => pieces.extend(parts(between).map(piece)),
            _ => pieces.push(Piece::Text(format!("${between}$"))),
        }
    }
    pieces
}

fn with_symbols(text: &str) -> String {
    let is_name = |name: &str| {
        let letter = |part: &str| part.len() == 1 || GREEK.iter().any(|(greek, _)| *greek == part);
        match name.split_once('_') {
            Some((stem, _)) => letter(stem),
            // Only the single letters that the figures use; others may be words.
            None => letter(name) && (name.len() > 1 || "npwxyz".contains(name)),
        }
    };
    let set = |word: &str| match symbol(word).filter(|_| is_name(word)) {
        Some(symbol) => format!("${symbol}$"),
        None => escaped(word),
    };
    words(text, &['_']).map(set).collect()
}

impl Float {
    /// The caption, which refers to the figures of the paper that are among the floats by their labels.
    pub(crate) fn caption_among(&self, floats: &[Self]) -> String {
        let piece = |piece: &Piece| match piece {
            Piece::Text(text) => text.clone(),
            Piece::Figure(number) => match floats.iter().find(|float| float.number == Some(*number)) {
                Some(float) => format!("Figure~\\ref{{{}}}", float.label),
                None => format!("Figure {number}"),
            },
        };
        self.caption.iter().map(piece).collect()
    }
}

/// Text with the characters that LaTeX reserves escaped, and mathematical signs as commands.
pub fn escaped(text: &str) -> String {
    /// Signs, and the Greek letters whose form is not that of their name.
    const SIGNS: [(char, &str); 21] = [
        ('<', "$<$"),
        ('>', "$>$"),
        ('|', "$|$"),
        ('\\', r"\textbackslash{}"),
        ('~', r"\textasciitilde{}"),
        ('^', r"\textasciicircum{}"),
        ('–', "--"),
        ('—', "---"),
        ('’', "'"),
        ('𝒜', r"$\mathcal{A}$"),
        ('ε', r"$\epsilon$"),
        ('φ', r"$\varphi$"),
        ('≤', r"$\le$"),
        ('≥', r"$\ge$"),
        ('≈', r"$\approx$"),
        ('×', r"$\times$"),
        ('−', "$-$"),
        ('±', r"$\pm$"),
        ('·', r"$\cdot$"),
        ('⋅', r"$\cdot$"),
        ('µ', r"$\mu$"),
    ];
    /// The last character that every recent LaTeX can set in text.
    const LAST: char = '\u{17f}';
    let mut escaped = String::new();
    for character in text.chars() {
        if let Some((_, command)) = SIGNS.iter().find(|(sign, _)| *sign == character) {
            escaped.push_str(command);
        } else if let Some((name, _)) = GREEK.iter().find(|(_, letter)| *letter == character) {
            escaped.push_str(&format!("$\\{name}$"));
        } else if character.is_control() || character > LAST {
            escaped.push('?');
        } else {
            escaped.extend("#$%&_{}".contains(character).then_some('\\'));
            escaped.push(character);
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use grazing_results::columns::{BIFURCATION, LOOPS, SECONDARY, SN_AS_SIMULATED as AS_SIMULATED, X};
    use grazing_results::{Names, UnitNames};

    use super::*;
    use crate::outputs::ALL;

    #[test]
    fn the_smallest_number_of_a_column_has_four_digits_and_the_others_its_decimals() {
        let numbers = [Some(-1234.5678), Some(0.98765), None, Some(f64::NAN), Some(0.0)];
        assert_eq!(aligned(&numbers), ["$-1234.5678$", "$0.9877$", "", "", "$0.0000$"]);
    }

    #[test]
    fn numbers_too_small_for_decimals_get_powers_of_ten() {
        assert_eq!(
            aligned(&[Some(1.23456e-9), Some(2.0)]),
            [r"$1.235\times10^{-9}$", r"$2.000\times10^{0}$"]
        );
    }

    #[test]
    fn a_table_has_headings_alignment_and_escaped_words() {
        const COLUMNS: &[Column] = &[BIFURCATION, LOOPS, SECONDARY, AS_SIMULATED];
        let row = |kind: &'static str, p: u32, omega: f64, flag: bool| {
            vec![kind.into(), p.into(), omega.into(), flag.into()]
        };
        let rows = vec![row("a_b", 1, 0.5, true), row("c", 2, -2.25, false)];
        let text = tabular(
            &Table::of_cells("sample", COLUMNS, &Names::of_the_paper(), rows),
            COLUMNS,
            "A title with 50 %",
        );
        assert!(text.starts_with("% A title with 50 \\%\n"), "{text}");
        for line in [
            r"\begin{tabular}{lrrl}",
            r"  kind & $p$ & $\omega$ & sn\_as\_simulated \\",
            r"  a\_b & 1 & $0.5000$ & true \\",
            r"  c & 2 & $-2.2500$ & false \\",
        ] {
            assert!(text.lines().any(|found| found == line), "{line} is missing in\n{text}");
        }
    }

    #[test]
    fn captions_are_sentences_without_the_number() {
        let caption = |title: Title| match &*prose(&sentence(&title)) {
            [Piece::Text(text)] => text.clone(),
            other => panic!("{other:?}"),
        };
        assert_eq!(caption(Title::figure(7, "the diagram of g_p").owned()), "The diagram of $g_{p}$.");
        assert_eq!(caption(Title::plain("rows: ab_c (tau < x)").owned()), r"Rows: ab\_c ($\tau$ $<$ $x$).");
        assert_eq!(caption(Title::beyond("the rest").owned()), "Beyond the paper: the rest.");
        // What a user writes is no number.
        assert_eq!(caption("Figure 3: my rig".to_owned().into()), "Figure 3: my rig.");
    }

    #[test]
    fn captions_refer_to_figures_by_their_labels() {
        let float = |number: u32, label: &str, caption: &str| Float {
            environment: "figure",
            body: String::new(),
            caption: prose(caption),
            label: label.to_owned(),
            number: Some(number),
            numbers: Vec::new(),
        };
        let text = "Figure~10, not Figure~1. With Figure~3, which is elsewhere, and a user's Figure 1";
        let floats = [float(1, "fig:one", text), float(10, "fig:ten", "")];
        assert_eq!(
            floats[0].caption_among(&floats),
            r"Figure~\ref{fig:ten}, not Figure~\ref{fig:one}. With Figure 3, which is elsewhere, and a user's Figure 1"
        );
    }

    #[test]
    fn units_stand_in_the_headings_and_signs_that_no_latex_knows_are_left_out() {
        let units = UnitNames {
            length: Some("µm".to_owned()),
            secondary: Some("rad/s".to_owned()),
            ..UnitNames::default()
        };
        let names = Names::new("A", "omega").with_units(units);
        let table = Table::of_cells("sample", &[LOOPS, SECONDARY, X], &names, Vec::new());
        let text = tabular(&table, &[LOOPS, SECONDARY, X], "雪");
        assert!(
            text.contains(r"  $p$ & $\omega$ (rad/s) & $x$ ($\mu$m) \\") && text.starts_with("% ?\n"),
            "{text}"
        );
    }

    #[test]
    fn every_title_of_the_registry_can_be_set_by_any_latex() {
        for output in ALL {
            let is_set = |piece: &Piece| !matches!(piece, Piece::Text(text) if !text.is_ascii());
            let sentence = prose(&sentence(&output.title));
            assert!(sentence.iter().all(is_set), "a sign of `{}` has no command yet", output.title);
        }
    }
}
