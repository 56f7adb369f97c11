//! Tables and paragraphs that fit a terminal.

use std::fmt::Write;

/// The widest line.
const WIDTH: usize = 100;

/// Columns as wide as they must be, numbers and words to the right.
pub(crate) fn aligned(header: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let lines: Vec<Vec<String>> =
        std::iter::once(header.iter().map(|&word| word.to_owned()).collect()).chain(rows).collect();
    let width = |column: usize| lines.iter().map(|line| line[column].len()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..header.len()).map(width).collect();
    let mut text = String::new();
    for line in &lines {
        for (cell, width) in line.iter().zip(&widths) {
            // Writing to a string cannot fail.
            let _ = write!(text, "  {cell:>width$}");
        }
        text.push('\n');
    }
    text
}

/// A space at which no line ends.
pub(super) const KEPT: &str = "\u{a0}";

/// Words after a mark, on as many lines as they need, all with the mark's indent.
pub(crate) fn wrapped(mark: &str, content: &str) -> String {
    let indent = mark.chars().count();
    let mut text = mark.to_owned();
    let mut column = indent;
    for word in content.split([' ', '\t', '\n', '\r']).filter(|word| !word.is_empty()) {
        let length = word.chars().count();
        if column > indent && column + 1 + length > WIDTH {
            let _ = write!(text, "\n{:indent$}", "");
            column = indent;
        }
        if column > indent {
            text.push(' ');
            column += 1;
        }
        text.push_str(word);
        column += length;
    }
    format!("{}\n", text.trim_end().replace(KEPT, " "))
}

/// A heading with entries under it, each after its mark; nothing if there are none.
pub(crate) fn headed(heading: &str, entries: impl IntoIterator<Item = (String, String)>) -> String {
    let entries: String = entries.into_iter().map(|(mark, content)| wrapped(&mark, &content)).collect();
    if entries.is_empty() { entries } else { format!("\n{heading}\n{entries}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_wrapped_under_the_first() {
        let text = wrapped("  mark  ", &"word ".repeat(40));
        assert!(text.lines().count() > 2 && text.lines().all(|line| line.chars().count() <= WIDTH));
        assert!(text.lines().skip(1).all(|line| line.starts_with("        word")), "{text}");
    }
}
