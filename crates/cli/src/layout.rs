//! Tables and paragraphs that fit a terminal.

use std::fmt::Write;

/// The width of the widest line.
const WIDTH: usize = 100;

/// A table whose columns are as wide as their cells, aligned right, or left under a heading that
/// begins with `<`. Colours take no width.
pub(crate) fn aligned(header: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let words = header.iter().map(|word| word.trim_start_matches('<').to_owned());
    let lines: Vec<Vec<String>> = std::iter::once(words.collect()).chain(rows).collect();
    let width = |column: usize| lines.iter().map(|line| shown(&line[column])).max().unwrap_or(0);
    let widths: Vec<usize> = (0..header.len()).map(width).collect();
    let mut text = String::new();
    for line in &lines {
        let mut whole = String::new();
        for ((cell, width), heading) in line.iter().zip(&widths).zip(header) {
            let room = " ".repeat(width - shown(cell));
            let [before, after] = if heading.starts_with('<') { ["", &room] } else { [&room, ""] };
            whole.extend(["  ", before, cell, after]);
        }
        text.push_str(whole.trim_end());
        text.push('\n');
    }
    text
}

/// The width of a cell on the terminal.
fn shown(cell: &str) -> usize {
    let colours = cell.split('\x1b').skip(1).filter_map(|after| Some(after.find('m')? + 2));
    cell.chars().count() - colours.sum::<usize>()
}

/// A space at which lines are not broken.
pub(crate) const KEPT: &str = "\u{a0}";

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
    fn columns_are_as_wide_as_what_is_seen() {
        let row = |cells: [&str; 3]| Vec::from(cells.map(str::to_owned));
        let rows = [row(["\x1b[32mmet\x1b[0m", "1.5", "µm"]), row(["not met", "-0.25", "m"])];
        let text = aligned(&["<verdict", "value", "unit"], rows.into_iter());
        let lines =
            ["  verdict  value  unit", "  \x1b[32mmet\x1b[0m        1.5    µm", "  not met  -0.25     m"];
        assert_eq!(text.lines().collect::<Vec<_>>(), lines);
    }

    #[test]
    fn words_are_wrapped_under_the_first() {
        let text = wrapped("  mark  ", &"word ".repeat(40));
        assert!(text.lines().count() > 2 && text.lines().all(|line| line.chars().count() <= WIDTH));
        assert!(text.lines().skip(1).all(|line| line.starts_with("        word")), "{text}");
    }
}
