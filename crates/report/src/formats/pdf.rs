//! PDF: one page of the figure's size, lines as lines, text as text, its objects and dictionary
//! entries in one order.
//!
//! svg2pdf keeps fonts and resources in hash maps, so the numbers of its objects and the order of
//! their entries change from run to run. Neither has a meaning; here entries are sorted, and
//! objects numbered in the order in which references from the drawing lead to them.

use std::collections::BTreeMap;

use pdf_writer::{Chunk, Content, Finish, Name, Pdf, Primitive, Rect, Ref, TextStr};
use svg2pdf::{ConversionOptions, to_chunk};

use super::error::FormatError;
use super::figure::Drawing;

/// The objects around those of the drawing.
const CATALOGUE: Ref = Ref::new(1);
const PAGES: Ref = Ref::new(2);
const PAGE: Ref = Ref::new(3);
const CONTENT: Ref = Ref::new(4);
const INFORMATION: Ref = Ref::new(5);
/// The number of the drawing, after which its parts are numbered.
const FIRST: i32 = 6;

impl Drawing {
    /// The figure as a PDF of one page under a title.
    ///
    /// The page has the physical size of the SVG. Text can be searched and copied; only the glyphs
    /// that are used are embedded. There is no date, so equal figures give equal bytes.
    ///
    /// # Errors
    /// The PDF could not be written, or is not laid out as expected.
    pub fn pdf(&self, title: &str) -> Result<Vec<u8>, FormatError> {
        let options = ConversionOptions { compress: true, embed_text: true, ..ConversionOptions::default() };
        let (chunk, drawing) = to_chunk(&self.tree, options)
            .map_err(|error| FormatError(format!("no PDF could be written: {error}")))?;
        let (width, height) = (self.tree.size().width(), self.tree.size().height());
        let name = Name(b"figure");
        let mut pdf = Pdf::new();
        // The features of the figures have been in PDF since 1.4; LaTeX warns of a version newer
        // than its own.
        pdf.set_version(1, 4);
        pdf.catalog(CATALOGUE).pages(PAGES);
        pdf.pages(PAGES).kids([PAGE]).count(1);
        let mut page = pdf.page(PAGE);
        page.parent(PAGES).media_box(Rect::new(0.0, 0.0, width, height)).contents(CONTENT);
        page.resources().x_objects().pair(name, Ref::new(FIRST));
        page.finish();
        let mut content = Content::new();
        // The drawing is a unit square.
        content.transform([width, 0.0, 0.0, height, 0.0, 0.0]).x_object(name);
        pdf.stream(CONTENT, &content.finish());
        pdf.document_info(INFORMATION).title(TextStr(title)).producer(TextStr("svg2pdf"));
        for (object, number) in ordered(&chunk, drawing)?.into_iter().zip(FIRST..) {
            pdf.indirect(Ref::new(number)).primitive(object);
        }
        Ok(pdf.finish())
    }
}

/// An object: its dictionary as text, and the stream after it.
struct Object {
    dictionary: String,
    stream: Vec<u8>,
}

impl Primitive for Object {
    fn write(self, buffer: &mut Vec<u8>) {
        buffer.extend(self.dictionary.into_bytes());
        buffer.extend(self.stream);
    }
}

/// The objects in the order in which references from the drawing lead to them, numbered in this order.
fn ordered(chunk: &Chunk, drawing: Ref) -> Result<Vec<Object>, FormatError> {
    let mut objects = objects(chunk)?;
    let (mut order, mut next) = (vec![drawing.get()], 0);
    while let Some(number) = order.get(next) {
        let object = objects.get(number).ok_or_else(|| layout("a reference leads nowhere"))?;
        for_each_reference(&object.dictionary, |referred| {
            if !order.contains(&referred) {
                order.push(referred);
            }
            referred
        });
        next += 1;
    }
    let numbers: BTreeMap<i32, i32> = order.iter().copied().zip(FIRST..).collect();
    let mut sorted: Vec<Object> = order.iter().filter_map(|number| objects.remove(number)).collect();
    for object in &mut sorted {
        object.dictionary = for_each_reference(&object.dictionary, |old| numbers[&old]);
    }
    Ok(sorted)
}

/// The objects by their numbers.
fn objects(chunk: &Chunk) -> Result<BTreeMap<i32, Object>, FormatError> {
    const END: &str = "\nendobj\n\n";
    let header = |number: Ref| format!("{} 0 obj\n", number.get());
    let (mut rest, mut objects) = (chunk.as_bytes(), BTreeMap::new());
    let mut numbers = chunk.refs().peekable();
    while let Some(number) = numbers.next() {
        let start = header(number).len();
        let end = END.to_owned() + &numbers.peek().map_or_else(String::new, |next| header(*next));
        let length = find(rest, end.as_bytes()).ok_or_else(|| layout("an object without its end"))?;
        let object = rest.get(start..length).ok_or_else(|| layout("an object without its number"))?;
        let (dictionary, stream) = object.split_at(find(object, b"\nstream\n").unwrap_or(object.len()));
        let dictionary = sorted(&String::from_utf8_lossy(dictionary));
        objects.insert(number.get(), Object { dictionary, stream: stream.to_vec() });
        rest = &rest[length + END.len()..];
    }
    Ok(objects)
}

/// The dictionary with each run of entries of one line sorted; pdf-writer gives each entry a line.
fn sorted(dictionary: &str) -> String {
    let indent = |line: &str| line.len() - line.trim_start().len();
    let simple = |line: &str| line.trim_start().starts_with('/') && !line.ends_with("<<");
    let mut lines: Vec<&str> = dictionary.lines().collect();
    for run in lines.chunk_by_mut(|a, b| simple(a) && simple(b) && indent(a) == indent(b)) {
        run.sort_unstable();
    }
    lines.join("\n")
}

/// Replaces the number of each reference, as `12 0 R`, by the result of the closure.
fn for_each_reference(text: &str, mut renumber: impl FnMut(i32) -> i32) -> String {
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

fn layout(wrong: &str) -> FormatError {
    FormatError(format!("the PDF cannot be put in order: {wrong}"))
}

fn find(bytes: &[u8], wanted: &[u8]) -> Option<usize> {
    bytes.windows(wanted.len()).position(|window| window == wanted)
}
