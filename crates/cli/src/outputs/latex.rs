//! LaTeX: tables for booktabs, and a snippet that includes figures and tables.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use grazing_results::{Cell, GREEK, Table};

use super::Output;
use super::edition::Edition;

/// Significant digits of the number of least magnitude in a column; all its numbers have as many decimals.
const DIGITS: i32 = 4;
/// The most decimals; columns with smaller numbers are printed with powers of ten.
const MOST_DECIMALS: i32 = 6;
/// The most rows that fit a page; longer tables are left to the author.
const MOST_ROWS: usize = 45;
/// The snippet's file.
pub(crate) const SNIPPET: &str = "figures.tex";

/// What is printed of a table: its columns, in order. Others are printed whole.
const SELECTED: [(&str, &[&str]); 1] =
    [("coefficients", &["p", "n", "omega_star", "amplitude_graz", "s_plus", "s_minus", "c_sn", "c_pd"])];

/// Where a table lies in the output folder.
pub(crate) fn table_path(name: &str) -> PathBuf {
    Path::new(name).with_extension("tex")
}

/// The table as a tabular of booktabs: numbers rounded and aligned at the decimal point, all quantities dimensionless.
pub(crate) fn table(table: &Table, title: &str) -> String {
    let places = selected(table);
    let columns: Vec<(Vec<String>, bool)> = places.iter().map(|&place| cells(table, place)).collect();
    let alignment: String = columns.iter().map(|(_, numeric)| if *numeric { 'r' } else { 'l' }).collect();
    let heading = |&place: &usize| match table.symbols[place].as_str() {
        "" => escaped(&table.headers[place]),
        symbol => format!("${symbol}$"),
    };
    let headings: Vec<String> = places.iter().map(heading).collect();
    let mut text = format!(
        "% {}\n% Needs \\usepackage{{booktabs}}. All quantities are dimensionless; numbers are rounded, those of data/{}.csv are\n\
         % not.\n\\begin{{tabular}}{{{alignment}}}\n  \\toprule\n  {} \\\\\n  \\midrule\n",
        escaped(title),
        table.name,
        headings.join(" & "),
    );
    for row in 0..table.rows.len() {
        let cells: Vec<&str> = columns.iter().map(|(cells, _)| cells[row].as_str()).collect();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {} \\\\", cells.join(" & "));
    }
    text.push_str("  \\bottomrule\n\\end{tabular}\n");
    text
}

/// The places of the columns that are printed.
fn selected(table: &Table) -> Vec<usize> {
    match SELECTED.iter().find(|(name, _)| *name == table.name) {
        Some((_, columns)) => columns.iter().filter_map(|column| table.position(column)).collect(),
        None => (0..table.columns.len()).collect(),
    }
}

/// The cells of a column, and whether they are numbers.
fn cells(table: &Table, place: usize) -> (Vec<String>, bool) {
    let cells = || table.rows.iter().map(|row| &row[place]);
    match cells().next() {
        Some(Cell::Number(_)) => (aligned(&cells().map(Cell::number).collect::<Vec<_>>()), true),
        first => {
            let written = |cell: &Cell| match cell {
                Cell::Text(words) => escaped(words),
                Cell::Integer(value) => value.to_string(),
                Cell::Flag(value) => value.to_string(),
                Cell::Number(value) => value.to_string(),
            };
            (cells().map(written).collect(), matches!(first, Some(Cell::Integer(_))))
        }
    }
}

/// Numbers with one number of decimals, so that they align, or with powers of ten if they are too small for that.
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
        let places = usize::try_from(DIGITS - 1).unwrap_or(0);
        let printed = format!("{number:.places$e}");
        let (mantissa, power) = printed.split_once('e').unwrap_or((&printed, "0"));
        format!(r"${mantissa}\times10^{{{power}}}$")
    };
    let shown = |number: &Option<f64>| number.filter(|number| number.is_finite()).map(print);
    numbers.iter().map(|number| shown(number).unwrap_or_default()).collect()
}

/// The snippet that includes the outputs; `rows` tells how many rows a table has.
pub(crate) fn snippet(outputs: &[&Output], edition: &Edition, rows: impl Fn(&str) -> usize) -> String {
    let mut text = "\
% The figures and tables, to be read by \\input. The preamble needs \\usepackage{graphicx,booktabs}. If the files do not lie
% beside the main document, say where they lie before, with a slash at the end: \\newcommand{\\grazingfiles}{journal/}.
\\providecommand{\\grazingfiles}{}
"
    .to_owned();
    let star = if edition.spans_columns() { "*" } else { "" };
    let mut add = |float: &str, body: &str, caption: &str, label: &str| {
        let _ = write!(
            text,
            "\n\\begin{{{float}}}\n  \\centering\n{body}  \\caption{{{caption}}}\n  \\label{{{label}}}\n\\end{{{float}}}\n"
        );
    };
    for output in outputs {
        let caption = referring(caption(output.title), outputs);
        if let Some(figure) = output.figure {
            let pdf = Path::new(figure).with_extension("pdf");
            let body = format!("  \\includegraphics{{\\grazingfiles {}}}\n", pdf.display());
            add(&format!("figure{star}"), &body, &caption, &format!("fig:{}", output.name));
            continue;
        }
        for table in output.latex_tables(edition) {
            let body = format!("  \\input{{\\grazingfiles {}}}\n", table_path(table).display());
            if rows(table) > MOST_ROWS {
                let body = format!("  % More rows than a page holds; set it with longtable.\n  %{body}");
                add("table*", &body, &caption, &format!("tab:{table}"));
            } else {
                add("table*", &body, &caption, &format!("tab:{table}"));
            }
        }
    }
    text
}

/// A title as a caption: without the number, which LaTeX gives, as a sentence.
fn caption(title: &str) -> String {
    let text = match title.split_once(": ") {
        Some((number, text)) if number.starts_with("Figure ") => text,
        _ => title,
    };
    let mut letters = text.chars();
    let first = letters.next().map(|letter| letter.to_uppercase().to_string()).unwrap_or_default();
    format!("{}.", escaped(&format!("{first}{}", letters.as_str())))
}

/// The caption with references in the place of the numbers of figures that are included.
fn referring(caption: String, outputs: &[&Output]) -> String {
    let mut figures: Vec<(&str, &str)> = outputs
        .iter()
        .filter(|output| output.figure.is_some())
        .filter_map(|output| Some((output.title.split_once(": ")?.0, output.name)))
        .collect();
    // The longest first, so that Figure 10 is not taken for Figure 1.
    figures.sort_by_key(|(figure, _)| std::cmp::Reverse(figure.len()));
    figures.into_iter().fold(caption, |caption, (figure, name)| {
        caption.replace(figure, &format!("Figure~\\ref{{fig:{name}}}"))
    })
}

/// Text with the characters that LaTeX reserves escaped, and mathematical signs as commands.
pub fn escaped(text: &str) -> String {
    /// Signs, and the Greek letters whose form is not that of their name.
    const SIGNS: [(char, &str); 15] = [
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
    ];
    let mut escaped = String::new();
    for character in text.chars() {
        if let Some((_, command)) = SIGNS.iter().find(|(sign, _)| *sign == character) {
            escaped.push_str(command);
        } else if let Some((name, _)) = GREEK.iter().find(|(_, letter)| *letter == character) {
            escaped.push_str(&format!("$\\{name}$"));
        } else {
            escaped.extend("#$%&_{}".contains(character).then_some('\\'));
            escaped.push(character);
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use grazing_results::columns::{BIFURCATION, LOOPS, SECONDARY, SN_AS_SIMULATED as AS_SIMULATED};
    use grazing_results::{Column, Names};

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
        let made = vec![row("a_b", 1, 0.5, true), row("c", 2, -2.25, false)];
        let text =
            table(&Table::of_cells("sample", COLUMNS, &Names::of_the_paper(), made), "A title with 50 %");
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
        assert_eq!(caption("Figure 7: two-parameter diagram"), "Two-parameter diagram.");
        assert_eq!(caption("Coefficients: all of them"), "Coefficients: all of them.");
    }

    #[test]
    fn captions_refer_to_figures_by_their_labels() {
        let outputs: Vec<&Output> = ALL.iter().collect();
        let caption = referring("Three magnifications of Figure 7.".to_owned(), &outputs);
        assert_eq!(caption, r"Three magnifications of Figure~\ref{fig:fig07}.");
    }

    #[test]
    fn every_title_of_the_registry_can_be_set_by_any_latex() {
        for output in ALL {
            assert!(caption(output.title).is_ascii(), "a sign of `{}` has no command yet", output.title);
        }
    }
}
