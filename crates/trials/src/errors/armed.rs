//! Errors behind switches: the body of a function is repeated once for each of its errors, and once
//! without any.

use core::ops::Range;

use super::listed::DeliberateError;

/// The environment variable with the number of the active error.
pub(super) const VARIABLE: &str = "GRAZING_DELIBERATE_ERROR";

/// The environment variable that names a file for the numbers of the switches that a run reaches.
pub(super) const REACHED: &str = "GRAZING_DELIBERATE_ERRORS_REACHED";

/// The code added to a crate's root: a function that returns whether an error is active.
pub(super) const SWITCH: &str = r#"
/// Whether the deliberate error of this number is in.
#[allow(dead_code)]
pub(crate) fn deliberate_error(number: u32) -> bool {
    use std::io::Write;
    use std::sync::OnceLock;
    use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
    static NUMBER: OnceLock<u32> = OnceLock::new();
    static RECORD: OnceLock<Option<std::fs::File>> = OnceLock::new();
    static REACHED: [AtomicBool; 1000] = [const { AtomicBool::new(false) }; 1000];
    let append = |path| std::fs::OpenOptions::new().create(true).append(true).open(path).expect("its folder is there");
    let record = RECORD.get_or_init(|| std::env::var_os("GRAZING_DELIBERATE_ERRORS_REACHED").map(append));
    if let Some(mut record) = record.as_ref() && !REACHED[number as usize].swap(true, Relaxed) {
        record.write_all(format!("{number}\n").as_bytes()).expect("it can be written");
    }
    let read = || std::env::var("GRAZING_DELIBERATE_ERROR").ok().and_then(|set| set.parse().ok()).unwrap_or(0);
    *NUMBER.get_or_init(read) == number
}
"#;

/// The number of an error, and the text of its site with the error.
type Wrong = (usize, String);

/// The text of a file with its errors behind switches, each with its number: around the body of the
/// function that contains it or, outside functions, around the expression itself. Also returns the
/// numbers of the errors that overlap the site of another error and are left out.
pub fn armed(text: &str, errors: &[(usize, &DeliberateError)]) -> (String, Vec<usize>) {
    let mut sites: Vec<(Range<usize>, Vec<Wrong>)> = Vec::new();
    let mut left = Vec::new();
    for (number, error) in errors {
        let Some(at) = text.find(&error.find) else { continue };
        let found = at..at + error.find.len();
        let site = body(text, &found).unwrap_or_else(|| found.clone());
        let [before, after] = [&text[site.start..found.start], &text[found.end..site.end]];
        let wrong = (*number, format!("{before}{}{after}", error.replace));
        let overlaps =
            |range: &Range<usize>| *range != site && range.start < site.end && site.start < range.end;
        if sites.iter().any(|(range, _)| overlaps(range)) {
            left.push(*number);
            continue;
        }
        match sites.iter_mut().find(|(range, _)| *range == site) {
            Some((_, all)) => all.push(wrong),
            None => sites.push((site, vec![wrong])),
        }
    }
    sites.sort_by_key(|(range, _)| range.start);
    let mut armed = String::with_capacity(2 * text.len());
    let mut done = 0;
    for (range, all) in sites {
        armed.push_str(&text[done..range.start]);
        // The braces around the body are kept.
        armed.push('(');
        for (number, wrong) in all {
            armed.push_str(&format!("if crate::deliberate_error({number}) {{ {wrong} }} else "));
        }
        armed.push_str(&format!("{{ {} }})", &text[range.clone()]));
        done = range.end;
    }
    armed.push_str(&text[done..]);
    (armed, left)
}

/// The text between the braces of the innermost function around a place.
fn body(text: &str, place: &Range<usize>) -> Option<Range<usize>> {
    let code = without_literals(text);
    let starts = code[..place.start].match_indices("fn ").map(|(at, _)| at);
    let is_word = |at: usize| code[..at].chars().next_back().is_none_or(|before| !before.is_alphanumeric());
    for start in starts.filter(|at| is_word(*at)).collect::<Vec<_>>().into_iter().rev() {
        let opening = start + code[start..].find(['{', ';'])?;
        if code[opening..].starts_with(';') {
            continue;
        }
        let mut depth = 0;
        let closing = code[opening..].char_indices().find_map(|(at, character)| {
            match character {
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => {}
            }
            (depth == 0).then_some(opening + at)
        })?;
        if opening < place.start && place.end <= closing {
            return Some(opening + 1..closing);
        }
    }
    None
}

/// The text with strings, characters and comments replaced by blanks, byte for byte.
fn without_literals(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut plain = bytes.to_vec();
    let mut at = 0;
    while at < bytes.len() {
        let end = match &bytes[at..] {
            [b'/', b'/', ..] => bytes[at..].iter().position(|byte| *byte == b'\n').map(|length| at + length),
            [b'"', ..] => string_end(bytes, at),
            // A character literal rather than a lifetime.
            [b'\'', b'\\', ..] => {
                let rest = bytes[at + 2..].iter().skip(1).position(|byte| *byte == b'\'');
                rest.map(|length| at + length + 4)
            }
            [b'\'', _, b'\'', ..] => Some(at + 3),
            _ => {
                at += 1;
                continue;
            }
        };
        let end = end.unwrap_or(bytes.len());
        plain[at..end].fill(b' ');
        at = end;
    }
    String::from_utf8(plain).unwrap_or_default()
}

/// The position after the quotation mark that closes the string that begins here, raw or not.
fn string_end(bytes: &[u8], start: usize) -> Option<usize> {
    let hashes = bytes[..start].iter().rev().take_while(|byte| **byte == b'#').count();
    let raw = bytes[..start - hashes].last() == Some(&b'r');
    let mut at = start + 1;
    while at < bytes.len() {
        match bytes[at] {
            b'\\' if !raw => at += 1,
            b'"' if !raw
                || bytes[at + 1..].iter().take(hashes).filter(|byte| **byte == b'#').count() == hashes =>
            {
                return Some(at + 1);
            }
            _ => {}
        }
        at += 1;
    }
    None
}
