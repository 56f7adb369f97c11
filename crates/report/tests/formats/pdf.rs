//! The order of the objects of a PDF and of their entries, read with a parser that shares nothing with the program.

use std::collections::BTreeMap;

use crate::{TITLE, sample};

/// The number of the drawing, after which its parts are numbered.
const DRAWING: u32 = 6;

/// The dictionaries of a PDF by the numbers of their objects.
fn dictionaries() -> BTreeMap<u32, String> {
    let pdf = sample().pdf(TITLE).expect("a PDF");
    let text = String::from_utf8_lossy(&pdf);
    let object = |part: &str| {
        let (before, object) = part.split_once(" 0 obj\n")?;
        let dictionary = object.split("\nstream\n").next()?;
        Some((before.lines().last()?.parse().expect("a number"), dictionary.trim_end().to_owned()))
    };
    text.split("endobj\n").filter_map(object).collect()
}

/// The numbers of the objects to which a dictionary refers.
fn references(dictionary: &str) -> Vec<u32> {
    let words: Vec<&str> = dictionary.split(|c: char| c.is_whitespace() || "[]".contains(c)).collect();
    let reference = |words: &[&str]| match words {
        [number, "0", "R"] => Some(number.parse().expect("a number")),
        _ => None,
    };
    words.windows(3).filter_map(reference).collect()
}

#[test]
fn references_are_renumbered_and_other_numbers_left_alone() {
    let dictionaries = dictionaries();
    // From the drawing on, references lead to all of its parts, and to them in the order of their numbers.
    let (mut order, mut next) = (vec![DRAWING], 0);
    while let Some(number) = order.get(next) {
        for referred in references(&dictionaries[number]) {
            if !order.contains(&referred) {
                order.push(referred);
            }
        }
        next += 1;
    }
    let numbers: Vec<u32> = dictionaries.keys().copied().filter(|number| *number >= DRAWING).collect();
    assert_eq!(order, numbers);
    assert_eq!(numbers, (DRAWING..DRAWING + 18).collect::<Vec<_>>());
    // Each reference is to what it should be, whatever else stands in its line.
    for (key, wanted) in [
        ("/gs0 ", "/Type /ExtGState"),
        ("/fo0 ", "/Type /Font"),
        ("/fo1 ", "/Type /Font"),
        ("/fo2 ", "/Type /Font"),
        ("/cs0 [/ICCBased ", "/N 3"),
        ("/DescendantFonts [", "/Subtype /CIDFontType2"),
        ("/ToUnicode ", "/Type /CMap"),
        ("/FontDescriptor ", "/Type /FontDescriptor"),
        ("/FontFile2 ", "/Filter /FlateDecode"),
    ] {
        let lines = dictionaries.values().flat_map(|dictionary| dictionary.lines());
        let referred: Vec<u32> =
            lines.filter(|line| line.trim_start().starts_with(key)).flat_map(references).collect();
        assert!(!referred.is_empty(), "{key}");
        assert!(referred.iter().all(|number| dictionaries[number].contains(wanted)), "{key}: {referred:?}");
    }
    let all: String = dictionaries.values().map(|dictionary| format!("{dictionary}\n")).collect();
    assert_eq!(all.matches("Box [0 0 170.07874 85.03937]\n").count(), 2, "the page and the drawing");
    for numbers in ["/Matrix [0.00587963 0 0 0.01175926 0 0]\n", "/Range [0 1 0 1 0 1]\n", "/ca 0.3\n"] {
        assert!(all.contains(numbers), "{numbers}");
    }
}

#[test]
fn entries_are_sorted_within_their_own_dictionary_only() {
    let dictionaries = dictionaries();
    for (number, dictionary) in dictionaries.range(DRAWING..) {
        let indent = |line: &str| line.len() - line.trim_start().len();
        let lines: Vec<&str> = dictionary.lines().collect();
        let mut depth = 0;
        for line in &lines {
            depth -= usize::from(line.ends_with(">>"));
            assert_eq!(indent(line), 2 * depth, "object {number}: an entry of another dictionary: {line}");
            depth += usize::from(line.ends_with("<<"));
        }
        assert_eq!(depth, 0);
        let simple = |line: &str| line.trim_start().starts_with('/') && !line.ends_with("<<");
        for pair in lines.windows(2).filter(|pair| indent(pair[0]) == indent(pair[1])) {
            assert!(!pair.iter().all(|line| simple(line)) || pair[0] < pair[1], "object {number}: {pair:?}");
        }
    }
    // Entries before an inner dictionary stay before it, those after it behind it.
    let inner = "  /Type /Font\n  /CIDSystemInfo <<\n    /Ordering (Identity)\n    /Registry (Adobe)\n    \
                 /Supplement 0\n  >>\n  /CIDToGIDMap /Identity\n  /DW 0\n  /FontDescriptor ";
    let fonts = dictionaries.values().filter(|dictionary| dictionary.contains("/CIDSystemInfo"));
    assert!(fonts.clone().count() == 3 && fonts.clone().all(|font| font.contains(inner)));
    let outer = "  /Type /XObject\n  /Resources <<\n    /ExtGState <<\n      /gs0 ";
    assert!(dictionaries[&DRAWING].contains(outer), "{}", dictionaries[&DRAWING]);
}
