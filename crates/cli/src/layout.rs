//! Tables and paragraphs that fit a terminal.

use std::fmt::Write;

/// The width where there is no terminal.
const USUAL: usize = 80;
/// The least width: a narrower terminal gets lines of this width.
const LEAST: usize = 40;
/// The indent of what continues a row of a table, or a line.
const CONTINUED: usize = 6;

/// A width that lines keep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    width: usize,
}

impl Default for Layout {
    /// 80 columns.
    fn default() -> Self {
        Self { width: USUAL }
    }
}

impl Layout {
    /// Lines of at most this many columns.
    pub fn new(width: usize) -> Self {
        Self { width: width.max(LEAST) }
    }

    /// Columns as wide as they must be, aligned to the right, or to the left under a heading that begins with `<`. Colours take no
    /// room. Columns for which a line has no room stand on a second line under the first, in every row.
    pub(crate) fn aligned(self, header: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
        let words = header.iter().map(|word| word.trim_start_matches('<').to_owned());
        let lines: Vec<Vec<String>> = std::iter::once(words.collect()).chain(rows).collect();
        let width = |column: usize| lines.iter().map(|line| shown(&line[column])).max().unwrap_or(0);
        let widths: Vec<usize> = (0..header.len()).map(width).collect();
        let folds = self.folds(&widths);
        let mut text = String::new();
        for line in &lines {
            for (number, columns) in folds.iter().enumerate() {
                let mut whole = " ".repeat(if number == 0 { 0 } else { CONTINUED });
                for column in columns.clone() {
                    let (cell, room) = (&line[column], " ".repeat(widths[column] - shown(&line[column])));
                    let [before, after] =
                        if header[column].starts_with('<') { ["", &room] } else { [&room, ""] };
                    whole.extend(["  ", before, cell, after]);
                }
                let whole = whole.trim_end();
                if number == 0 || !whole.is_empty() {
                    text.push_str(&self.fitted_line(whole));
                    text.push('\n');
                }
            }
        }
        text
    }

    /// The columns that stand on each line of a row.
    fn folds(self, widths: &[usize]) -> Vec<std::ops::Range<usize>> {
        let mut folds = Vec::new();
        let (mut first, mut taken) = (0, 0);
        for (column, width) in widths.iter().enumerate() {
            if column > first && taken + 2 + width > self.width {
                folds.push(first..column);
                (first, taken) = (column, CONTINUED);
            }
            taken += 2 + width;
        }
        folds.push(first..widths.len());
        folds
    }

    /// Words after a mark, on as many lines as they need, all with the mark's indent. No line ends within a word or a formula, unless
    /// that alone is longer than a line.
    pub(crate) fn wrapped(self, mark: &str, content: &str) -> String {
        let length = shown(mark);
        let own = length - mark.trim_start_matches(' ').chars().count().min(length);
        // Behind a long mark there is no room for a column of its own.
        let indent = if length > self.width / 2 { own + 4 } else { length };
        let mut lines =
            Lines { text: mark.to_owned(), column: length, indent, width: self.width, begun: false };
        for unit in units(content) {
            lines.put(&unit);
        }
        format!("{}\n", lines.text.trim_end().replace(KEPT, " "))
    }

    /// A heading with entries under it, each after its mark; nothing if there are none.
    pub(crate) fn headed(self, heading: &str, entries: impl IntoIterator<Item = (String, String)>) -> String {
        let entries: String =
            entries.into_iter().map(|(mark, content)| self.wrapped(&mark, &content)).collect();
        if entries.is_empty() { entries } else { format!("\n{}{entries}", self.wrapped("", heading)) }
    }

    /// A command, in words, after a mark; where it is longer than a line it goes on with `\`, as a shell reads it.
    pub(crate) fn command(self, mark: &str, words: impl Iterator<Item = String>) -> String {
        let (mut text, mut column) = (mark.to_owned(), shown(mark));
        for (number, word) in words.enumerate() {
            // Room for the mark of a line that goes on.
            if number > 0 && column + 1 + shown(&word) + 2 > self.width {
                let _ = write!(text, " \\\n{:CONTINUED$}{word}", "");
                column = CONTINUED + shown(&word);
                continue;
            }
            if number > 0 {
                text.push(' ');
                column += 1;
            }
            text.push_str(&word);
            column += shown(&word);
        }
        text.push('\n');
        text
    }

    /// The text with its long lines wrapped, each part with the indent of the line.
    pub(crate) fn fitted(self, text: &str) -> String {
        text.split_inclusive('\n')
            .map(|line| match line.strip_suffix('\n') {
                Some(line) => self.fitted_line(line) + "\n",
                None => self.fitted_line(line),
            })
            .collect()
    }

    fn fitted_line(self, line: &str) -> String {
        if shown(line) <= self.width {
            return line.to_owned();
        }
        let content = line.trim_start_matches(' ');
        let own = line.len() - content.len();
        let mut lines =
            Lines { text: " ".repeat(own), column: own, indent: own, width: self.width, begun: false };
        for unit in units(content) {
            lines.put(&unit);
        }
        lines.text
    }
}

/// Lines that are being filled.
struct Lines {
    text: String,
    column: usize,
    indent: usize,
    width: usize,
    /// Whether there is anything after the mark.
    begun: bool,
}

impl Lines {
    /// Adds a word or a formula, on the next line if this one has no room for it.
    fn put(&mut self, unit: &str) {
        let length = shown(unit);
        let space = usize::from(self.begun);
        let fits = |column: usize| column + length <= self.width;
        if !fits(self.column + space) {
            if !fits(self.indent) {
                // No line has room: it ends before operators, as in print.
                let pieces = pieces(unit);
                if pieces.len() > 1 {
                    return pieces.iter().for_each(|piece| self.put(piece));
                }
            }
            if self.column > self.indent {
                let indent = self.indent;
                self.text.truncate(self.text.trim_end_matches(' ').len());
                let _ = write!(self.text, "\n{:indent$}", "");
                self.column = indent;
                self.begun = false;
            }
        }
        if self.begun {
            self.text.push(' ');
            self.column += 1;
        }
        self.text.push_str(unit);
        self.column += length;
        self.begun = true;
    }
}

/// Signs between the parts of a formula, at which no line ends.
const OPERATORS: [&str; 13] = ["=", "+", "-", "*", "/", "<", ">", "<=", ">=", "!=", "->", "±", ".."];

/// Whether the word stands between two parts of a formula.
fn joins(word: &str) -> bool {
    OPERATORS.contains(&word)
}

/// Words, and formulas as one word each: a line may end between them.
fn units(content: &str) -> Vec<String> {
    let words = content.split([' ', '\t', '\n', '\r']).filter(|word| !word.is_empty());
    grouped(words, joins)
}

/// The parts of a formula, each after the first with the sign before it.
fn pieces(unit: &str) -> Vec<String> {
    grouped(unit.split([' ', '\u{a0}']), |_| false)
}

/// Words, joined where a sign goes before, or where a word `belongs` to the one before it.
fn grouped<'w>(words: impl Iterator<Item = &'w str>, belongs: fn(&str) -> bool) -> Vec<String> {
    let (mut groups, mut goes_on) = (Vec::<String>::new(), false);
    for word in words {
        match groups.last_mut() {
            Some(last) if goes_on || belongs(word) => last.extend([" ", word]),
            _ => groups.push(word.to_owned()),
        }
        goes_on = joins(word);
    }
    groups
}

/// The number of columns that a text takes.
fn shown(text: &str) -> usize {
    let colours = text.split('\x1b').skip(1).filter_map(|after| Some(after.find('m')? + 2));
    text.chars().count() - colours.sum::<usize>()
}

/// A space at which lines are not broken.
pub(crate) const KEPT: &str = "\u{a0}";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_wide_as_what_is_seen() {
        let row = |cells: [&str; 3]| Vec::from(cells.map(str::to_owned));
        let rows = [row(["\x1b[32mmet\x1b[0m", "1.5", "µm"]), row(["not met", "-0.25", "m"])];
        let text = Layout::default().aligned(&["<verdict", "value", "unit"], rows.into_iter());
        let lines =
            ["  verdict  value  unit", "  \x1b[32mmet\x1b[0m        1.5    µm", "  not met  -0.25     m"];
        assert_eq!(text.lines().collect::<Vec<_>>(), lines);
    }

    #[test]
    fn columns_without_room_stand_on_a_second_line() {
        let row = |cells: [&str; 3]| Vec::from(cells.map(str::to_owned));
        let rows = [row(["a long cell indeed", "1.25", "a second long cell"]), row(["b", "2.5", ""])];
        let text = Layout::new(40).aligned(&["<name", "value", "<remark"], rows.into_iter());
        let lines = [
            "  name                value",
            "        remark",
            "  a long cell indeed   1.25",
            "        a second long cell",
            "  b                     2.5",
        ];
        assert_eq!(text.lines().collect::<Vec<_>>(), lines);
    }

    #[test]
    fn words_are_wrapped_under_the_first() {
        for width in [60, 80] {
            let text = Layout::new(width).wrapped("  mark  ", &"word ".repeat(40));
            assert!(text.lines().count() > 2 && text.lines().all(|line| line.chars().count() <= width));
            assert!(text.lines().skip(1).all(|line| line.starts_with("        word")), "{text}");
        }
    }

    #[test]
    fn no_line_ends_within_a_formula_unless_it_is_longer_than_a_line() {
        let layout = Layout::new(40);
        let text =
            layout.wrapped("  ", "the motion grazes the wall at A = 0.25, omega = 0.5 and nowhere else");
        assert_eq!(text, "  the motion grazes the wall at\n  A = 0.25, omega = 0.5 and nowhere else\n");
        let text = layout.wrapped("  motion  ", "x'' = -2*zeta*v - x - kappa*x^3 - 1 + A*cos(omega*t)");
        assert_eq!(
            text,
            "  motion  x'' = -2*zeta*v - x\n          - kappa*x^3 - 1\n          + A*cos(omega*t)\n"
        );
    }

    #[test]
    fn a_long_command_goes_on_as_a_shell_reads_it() {
        let words = ["grazing", "unfold", "beam.toml", "--set zeta=0.018", "--set r=0.72"];
        let text = Layout::new(40).command("Next: ", words.into_iter().map(str::to_owned));
        assert!(text.lines().all(|line| line.chars().count() <= 40), "{text}");
        assert_eq!(
            text.replace("\\\n", "").split_whitespace().skip(1).collect::<Vec<_>>().join(" "),
            words.join(" ")
        );
    }

    #[test]
    fn joined_lines_are_the_text() {
        let text = "a sentence of many words that goes on and on, with z -> z + y*Psi in it\n    and short\n";
        let fitted = Layout::new(40).fitted(text);
        assert!(fitted.lines().all(|line| line.chars().count() <= 40), "{fitted}");
        assert!(fitted.split_whitespace().eq(text.split_whitespace()));
    }
}
