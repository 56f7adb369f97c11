//! Words in messages: suggestions for misspelt names, and shortened texts.

/// The largest number of characters of a value or a name that a message repeats.
pub(crate) const SHOWN: usize = 100;

/// The most letters of a name for which a correction is looked for.
const LONGEST: usize = 64;

/// The known name that is spelt like `name`: the nearest one, the first of equals, if it is a
/// plausible correction.
///
/// Few letters may differ, a third of them at most; or one name begins with the whole of the other. Names of
/// more than 64 letters are not compared, since that takes a time that grows with their product.
pub fn nearest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let is_short = |name: &str| name.chars().nth(LONGEST).is_none();
    let mut best: Option<(usize, &str)> = None;
    for candidate in known.iter().filter(|candidate| is_short(name) && is_short(candidate)) {
        let distance =
            if name.eq_ignore_ascii_case(candidate) { 0 } else { strsim::osa_distance(name, candidate) };
        let letters = [name, candidate].map(|name| name.chars().count());
        let [short, long] = [letters[0].min(letters[1]), letters[0].max(letters[1])];
        let begins = short >= 3 && (name.starts_with(candidate) || candidate.starts_with(name));
        let few = distance <= (long / 3).max(1) && 2 * distance < long;
        if (few || begins) && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, name)| name)
}

/// The end of a message about an unknown name: a question if there is a plausible correction.
pub fn suggestion(nearest: Option<&str>) -> String {
    nearest.map_or(".".to_owned(), |nearest| format!(": did you mean `{nearest}`?"))
}

/// A text shortened to about `most` characters: its beginning and its end.
pub fn shortened(text: &str, most: usize) -> String {
    let count = text.chars().count();
    if count <= most {
        return text.to_owned();
    }
    let start: String = text.chars().take(most / 2).collect();
    let end: String = text.chars().skip(count - most / 4).collect();
    format!("{start} ... {end}")
}

/// The path of a key in a table.
pub(crate) fn joined(table: &str, name: &str) -> String {
    if table.is_empty() { name.to_owned() } else { format!("{table}.{name}") }
}
