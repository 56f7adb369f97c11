//! What the page reads in the SVG of a figure, and how it shortens it.

/// The panels that a figure says it has.
pub(crate) struct Marks<'a>(Vec<&'a str>);

impl<'a> Marks<'a> {
    pub(crate) fn of(svg: &'a str) -> Self {
        let marks = svg.match_indices("<rect class=\"panel\"");
        Marks(marks.map(|(at, _)| svg[at..].split('>').next().unwrap_or_default()).collect())
    }

    /// Whether a panel shows rows of the table; one that names none may show any but regions, which are areas, not points.
    pub(crate) fn show(&self, table: &str) -> bool {
        self.0.iter().any(|mark| match attribute(mark, "data-tables") {
            Some(named) => named.split(' ').any(|name| name == table),
            None => !table.ends_with("_regions"),
        })
    }

    /// The values at the ends of all axes.
    pub(crate) fn ranges(&self) -> impl Iterator<Item = [f64; 2]> {
        let range = |mark: &&str, name| {
            let (low, high) = attribute(mark, name)?.split_once(' ')?;
            Some([low.parse().ok()?, high.parse().ok()?])
        };
        self.0.iter().flat_map(move |mark| ["data-x", "data-y"].map(|name| range(mark, name))).flatten()
    }
}

/// The value of an attribute in a start tag.
pub(crate) fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let start = tag.find(&format!(" {name}=\""))? + name.len() + 3;
    tag[start..].split('"').next()
}

/// The same drawing with paths from point to point, each as far from the one before: half as long, and the same to a hundredth.
pub(crate) fn with_short_paths(body: &str) -> String {
    const START: &str = " d=\"";
    let mut short = String::with_capacity(body.len());
    let mut rest = body;
    while let Some(start) = rest.find(START) {
        let (before, path) = rest.split_at(start + START.len());
        let (path, after) = path.split_at(path.find('"').unwrap_or(path.len()));
        short.push_str(before);
        match short_path(path) {
            Some(shorter) => short.push_str(&shorter),
            None => short.push_str(path),
        }
        rest = after;
    }
    short + rest
}

/// The path if it is one of moves, lines and returns to points in hundredths.
fn short_path(path: &str) -> Option<String> {
    let mut short = String::new();
    let (mut last, mut before) = ((0, 0), ' ');
    let mut rest = path;
    while let Some(command) = rest.chars().next() {
        rest = &rest[1..];
        let end = rest.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let (point, after) = rest.split_at(end);
        rest = after;
        if command == 'Z' && point.is_empty() {
            short.push('Z');
            before = 'Z';
            continue;
        }
        let (x, y) = point.split_once(',')?;
        let spot = (hundredths(x)?, hundredths(y)?);
        match command {
            'M' => {
                short.push('M');
                push_pair(&mut short, spot);
            }
            'L' => {
                // Commands that follow themselves need not be said again.
                if before != 'L' {
                    short.push('l');
                }
                push_pair(&mut short, (spot.0 - last.0, spot.1 - last.1));
            }
            _ => return None,
        }
        (last, before) = (spot, command);
    }
    Some(short)
}

/// A number with at most two decimals, in hundredths.
fn hundredths(number: &str) -> Option<i64> {
    let (sign, digits) = number.strip_prefix('-').map_or((1, number), |digits| (-1, digits));
    let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
    let number = |digits: &str| digits.parse::<i64>().ok().filter(|_| digits.len() < 9);
    let parts = match decimals.len() {
        0 => 0,
        1 => 10 * number(decimals)?,
        2 => number(decimals)?,
        _ => return None,
    };
    Some(sign * (100 * number(whole)? + parts))
}

/// Two numbers; a sign or a leading point tells one from the next where it can.
fn push_pair(text: &mut String, (x, y): (i64, i64)) {
    for number in [x, y] {
        let written = written(number);
        let after_number = text.ends_with(|c: char| c.is_ascii_digit());
        if after_number && !written.starts_with('-') {
            text.push(' ');
        }
        text.push_str(&written);
    }
}

/// Hundredths as a number without idle zeros.
fn written(hundredths: i64) -> String {
    let sign = if hundredths < 0 { "-" } else { "" };
    let (whole, parts) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
    match (whole, parts) {
        (whole, 0) => format!("{sign}{whole}"),
        (0, parts) => format!("{sign}.{parts:02}").trim_end_matches('0').to_owned(),
        (whole, parts) => format!("{sign}{whole}.{parts:02}").trim_end_matches('0').to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_become_shorter_and_stay_the_same() {
        for (long, short) in [
            ("M24.4,83.84L24.4,82.89L23.4,83L30,-5Z", "M24.4 83.84l0-.95-1 .11 6.6-88Z"),
            ("M0.5,-0.25L0.5,0.25M1,1L2,2", "M.5-.25l0 .5M1 1l1 1"),
        ] {
            assert_eq!(short_path(long).as_deref(), Some(short));
        }
        for other in ["M1,2h0m3,4h0", "M1,2L3", "M1.234,5L2,3", "M1,2C1,2 3,4 5,6"] {
            assert_eq!(short_path(other), None, "{other}");
        }
    }

    #[test]
    fn only_paths_are_touched() {
        let body = "<path d=\"M1,1L2,2\" stroke=\"#fff\"/><text id=\"M1,1L2,2\">a</text><path d=\"M1,1h0\"/>";
        let short =
            "<path d=\"M1 1l1 1\" stroke=\"#fff\"/><text id=\"M1,1L2,2\">a</text><path d=\"M1,1h0\"/>";
        assert_eq!(with_short_paths(body), short);
    }
}
