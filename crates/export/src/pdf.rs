//! PDF: one page of the figure's size, lines as lines, text as text, its objects and dictionary entries in one order.
//!
//! svg2pdf keeps fonts and resources in hash maps, so the numbers of its objects and the order of their entries change
//! from run to run. Neither means anything; here entries are sorted, objects numbered as they are met from the
//! catalogue on, and the table of their places is written anew. The page's transparency group goes: the sheet is opaque,
//! and LaTeX warns of a page that includes two such figures.

use std::collections::BTreeMap;
use std::fmt::Write;

use svg2pdf::{ConversionOptions, PageOptions, to_pdf};

use crate::error::ExportError;
use crate::figure::Drawing;

impl Drawing {
    /// The figure as a PDF of one page.
    ///
    /// The page has the physical size of the SVG. Text can be searched and copied; of the fonts only the glyphs that are
    /// used are embedded. The title is that of the SVG; there is no date, so equal figures give equal bytes.
    ///
    /// # Errors
    /// The PDF could not be written, or is not laid out as expected.
    pub fn pdf(&self) -> Result<Vec<u8>, ExportError> {
        let options = ConversionOptions { compress: true, embed_text: true, ..ConversionOptions::default() };
        let pdf = to_pdf(&self.tree, options, PageOptions::default())
            .map_err(|error| ExportError(format!("no PDF could be written: {error}")))?;
        ordered(&pdf, self.title())
    }
}

/// What the figures use has been in PDF since 1.4; LaTeX warns of a newer version than its own.
const HEADER: &[u8] = b"%PDF-1.4\n%\x80\x80\x80\x80\n";

/// An object: its dictionary as text, and what follows that, the stream.
struct Object {
    dictionary: String,
    rest: Vec<u8>,
}

/// The PDF in order, with this title in the place of its document information.
fn ordered(pdf: &[u8], title: &str) -> Result<Vec<u8>, ExportError> {
    let mut objects = objects(pdf)?;
    let trailer = text_after(pdf, b"trailer")?;
    let root = reference_after(trailer, "/Root ")?;
    let information = reference_after(trailer, "/Info ")?;
    let about = format!("<<\n  /Title {}\n  /Producer (svg2pdf)\n>>\n", text_string(title));
    objects.insert(information, Object { dictionary: about, rest: b"endobj\n\n".to_vec() });

    let mut order = vec![root];
    let mut next = 0;
    while let Some(number) = order.get(next).copied() {
        let object = objects.get(&number).ok_or_else(|| layout("a reference leads nowhere"))?;
        for_each_reference(&object.dictionary, |referred| {
            if !order.contains(&referred) {
                order.push(referred);
            }
            referred
        });
        next += 1;
    }
    order.push(information);
    let numbers: BTreeMap<usize, usize> = order.iter().copied().zip(1..).collect();

    let mut ordered = HEADER.to_vec();
    let mut table = format!("xref\n0 {}\n0000000000 65535 f\r\n", order.len() + 1);
    for (number, object) in order.iter().zip(1..).filter_map(|(old, new)| Some((new, objects.get(old)?))) {
        let number: usize = number;
        // Writing to a string cannot fail.
        let _ = write!(table, "{:010} 00000 n\r\n", ordered.len());
        ordered.extend_from_slice(format!("{number} 0 obj\n").as_bytes());
        let dictionary =
            for_each_reference(&object.dictionary, |old| numbers.get(&old).copied().unwrap_or(0));
        ordered.extend_from_slice(dictionary.as_bytes());
        ordered.extend_from_slice(&object.rest);
    }
    let start = ordered.len();
    let (size, info) = (order.len() + 1, order.len());
    let end = format!(
        "trailer\n<<\n  /Size {size}\n  /Root 1 0 R\n  /Info {info} 0 R\n>>\nstartxref\n{start}\n%%EOF\n"
    );
    ordered.extend_from_slice(table.as_bytes());
    ordered.extend_from_slice(end.as_bytes());
    Ok(ordered)
}

/// The objects by their numbers, found by the table of their places.
fn objects(pdf: &[u8]) -> Result<BTreeMap<usize, Object>, ExportError> {
    let start: usize = text_after(pdf, b"startxref")?
        .split_whitespace()
        .next()
        .and_then(|number| number.parse().ok())
        .ok_or_else(|| layout("no place of the table"))?;
    let table = pdf.get(start..).map(String::from_utf8_lossy).ok_or_else(|| layout("no table"))?;
    let mut places: Vec<usize> = table
        .lines()
        .take_while(|line| !line.starts_with("trailer"))
        .filter(|line| line.trim_end().ends_with('n'))
        .filter_map(|line| line.split_whitespace().next()?.parse().ok())
        .collect();
    places.push(start);
    places.sort_unstable();
    let mut objects = BTreeMap::new();
    for pair in places.windows(2) {
        let bytes = pdf.get(pair[0]..pair[1]).ok_or_else(|| layout("an object beyond the end"))?;
        let body = find(bytes, b" 0 obj\n").ok_or_else(|| layout("an object without its number"))?;
        let number = String::from_utf8_lossy(&bytes[..body]).trim().parse();
        let number = number.map_err(|_| layout("an object without its number"))?;
        let body = &bytes[body + b" 0 obj\n".len()..];
        let end = find(body, b"stream\n")
            .or_else(|| find(body, b"endobj"))
            .ok_or_else(|| layout("an object without its end"))?;
        let dictionary = sorted(&String::from_utf8_lossy(&body[..end]));
        let is_page = dictionary.contains("\n  /Type /Page\n");
        let dictionary = if is_page { without_group(&dictionary) } else { dictionary };
        objects.insert(number, Object { dictionary, rest: body[end..].to_vec() });
    }
    Ok(objects)
}

/// The dictionary of a page without its group.
fn without_group(dictionary: &str) -> String {
    const START: &str = "\n  /Group <<\n";
    const END: &str = "\n  >>";
    let cut = dictionary.split_once(START).and_then(|(before, rest)| Some((before, rest.split_once(END)?.1)));
    cut.map_or_else(|| dictionary.to_owned(), |(before, after)| format!("{before}{after}"))
}

/// The dictionary with its entries of one line sorted, in each run of them; pdf-writer gives each entry a line.
fn sorted(dictionary: &str) -> String {
    let indent = |line: &str| line.len() - line.trim_start().len();
    let simple = |line: &str| line.trim_start().starts_with('/') && !line.ends_with("<<");
    let mut lines: Vec<&str> = dictionary.lines().collect();
    for run in lines.chunk_by_mut(|a, b| simple(a) && simple(b) && indent(a) == indent(b)) {
        run.sort_unstable();
    }
    let mut text = lines.join("\n");
    text.push('\n');
    text
}

/// Replaces the number of each reference, as `12 0 R`, by what the closure makes of it.
fn for_each_reference(text: &str, mut renumber: impl FnMut(usize) -> usize) -> String {
    let mut replaced = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(end) = rest.find(" 0 R") {
        let start = rest[..end].rfind(|c: char| !c.is_ascii_digit()).map_or(0, |before| before + 1);
        replaced.push_str(&rest[..start]);
        match rest[start..end].parse() {
            Ok(number) => replaced.push_str(&renumber(number).to_string()),
            Err(_) => replaced.push_str(&rest[start..end]),
        }
        replaced.push_str(" 0 R");
        rest = &rest[end + " 0 R".len()..];
    }
    replaced.push_str(rest);
    replaced
}

/// The text as a string of PDF: UTF-16 in hexadecimal digits, which needs no escapes.
fn text_string(text: &str) -> String {
    let mut string = "<FEFF".to_owned();
    for unit in text.encode_utf16() {
        let _ = write!(string, "{unit:04X}");
    }
    string.push('>');
    string
}

fn layout(wrong: &str) -> ExportError {
    ExportError(format!("the PDF cannot be put in order: {wrong}"))
}

fn find(bytes: &[u8], wanted: &[u8]) -> Option<usize> {
    bytes.windows(wanted.len()).position(|window| window == wanted)
}

/// What stands after the last appearance of a word, as text.
fn text_after<'a>(pdf: &'a [u8], word: &[u8]) -> Result<&'a str, ExportError> {
    let start = pdf.windows(word.len()).rposition(|window| window == word);
    start
        .and_then(|start| std::str::from_utf8(&pdf[start + word.len()..]).ok())
        .ok_or_else(|| layout("no trailer"))
}

fn reference_after(text: &str, key: &str) -> Result<usize, ExportError> {
    text.split_once(key)
        .and_then(|(_, rest)| rest.split_whitespace().next()?.parse().ok())
        .ok_or_else(|| layout("no catalogue or no information"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_are_renumbered_and_other_numbers_left_alone() {
        let text = "/A 12 0 R\n/B [/ICCBased 3 0 R]\n/C [0 0 12.5 3]\n/D [4 0 R 5 0 R]";
        let renumbered = for_each_reference(text, |number| number + 100);
        assert_eq!(renumbered, "/A 112 0 R\n/B [/ICCBased 103 0 R]\n/C [0 0 12.5 3]\n/D [104 0 R 105 0 R]");
    }

    #[test]
    fn entries_are_sorted_within_their_own_dictionary_only() {
        let text = "<<\n  /Z 1\n  /Font <<\n    /f1 2 0 R\n    /f0 1 0 R\n  >>\n  /B 1\n  /A 1\n>>";
        assert_eq!(
            sorted(text),
            "<<\n  /Z 1\n  /Font <<\n    /f0 1 0 R\n    /f1 2 0 R\n  >>\n  /A 1\n  /B 1\n>>\n"
        );
    }

    #[test]
    fn a_page_loses_its_group_and_nothing_else() {
        let page = "<<\n  /Contents 7 0 R\n  /Group <<\n    /I true\n    /S /Transparency\n  >>\n  /Type /Page\n>>\n";
        assert_eq!(without_group(page), "<<\n  /Contents 7 0 R\n  /Type /Page\n>>\n");
        assert_eq!(without_group("<<\n>>\n"), "<<\n>>\n");
    }

    #[test]
    fn titles_are_utf_16() {
        assert_eq!(text_string("aω"), "<FEFF006103C9>");
    }
}
