//! Reads coordinates and paths from a finished SVG, for tests.

/// All coordinates of paths and discs, in points from the top left corner; NaN where one cannot be
/// parsed.
pub(crate) fn coordinates(svg: &str) -> Vec<(f64, f64)> {
    let number = |text: &str| text.parse::<f64>().unwrap_or(f64::NAN);
    let mut found = Vec::new();
    for data in attribute(svg, "d") {
        // Except in fonts and bins, path data is M, L and Z with absolute coordinates.
        for pair in data.split(['M', 'L', 'Z']).filter(|pair| !pair.is_empty()) {
            let (x, y) = pair.split_once(',').unwrap_or(("", ""));
            found.push((number(x), number(y)));
        }
    }
    found.extend(attribute(svg, "cx").zip(attribute(svg, "cy")).map(|(x, y)| (number(x), number(y))));
    found
}

/// The spots of each path drawn in this colour.
pub(crate) fn paths(svg: &str, colour: &str) -> Vec<Vec<(f64, f64)>> {
    let stroke = format!("stroke=\"{colour}\"");
    svg.lines().filter(|line| line.starts_with("<path") && line.contains(&stroke)).map(coordinates).collect()
}

/// The values of an attribute, in order.
fn attribute<'a>(svg: &'a str, name: &str) -> impl Iterator<Item = &'a str> {
    let start = format!(" {name}=\"");
    svg.match_indices(&start)
        .map(|(at, found)| &svg[at + found.len()..])
        .filter_map(|rest| rest.split('"').next())
        .collect::<Vec<_>>()
        .into_iter()
}
