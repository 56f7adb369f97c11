//! Curves that a file asks for, in a parameter plane.

use grazing_results::plane::OwnPoint;

use crate::error::DrawingError;
use crate::geometry::sheet::{Spot, length};
use crate::ink::labels::Labels;
use crate::ink::legend::Sample;
use crate::ink::style::{OWN, OWN_TEXT, SMALL_LABEL_SIZE};
use crate::plot::axes::Panel;

/// Draws the curves as far as their solutions are admissible, thin where these are not stable;
/// returns the longest piece of each name and number of loops, with its label.
pub(crate) fn draw_own(
    panel: &Panel<'_>,
    labels: &mut Labels<'_>,
    rows: &[OwnPoint],
) -> Vec<(String, Vec<Spot>)> {
    let mut drawn: Vec<(String, Vec<Spot>)> = Vec::new();
    for curve in rows.chunk_by(|a, b| a.arc == b.arc) {
        let (name, loops) = (&curve[0].name, curve[0].loops);
        let alone = rows.iter().all(|row| row.name != *name || row.loops == loops);
        let label = if alone { name.clone() } else { format!("{name}, $p={loops}$") };
        // Between a bifurcation and the solutions beside it the chord is theirs.
        let look = |pair: &[OwnPoint]| {
            let admissible = pair.iter().all(|point| point.admissible);
            admissible.then(|| usize::from(pair.iter().all(|point| !point.stable)))
        };
        let looks: Vec<Option<usize>> = curve.windows(2).map(look).collect();
        let mut from = 0;
        for run in looks.chunk_by(|a, b| a == b) {
            let places = curve[from..=from + run.len()].iter().map(|point| (point.primary, point.secondary));
            from += run.len();
            let Some(unstable) = run[0] else { continue };
            for piece in panel.line(&places.collect::<Vec<_>>(), OWN[unstable]) {
                panel.canvas.explain(&format!("{name}: {}", curve[0].property), Sample::Line(OWN[0]));
                labels.placer.keep_off(&piece);
                match drawn.iter_mut().find(|(known, _)| *known == label) {
                    Some((_, longest)) if length(longest) < length(&piece) => *longest = piece,
                    Some(_) => {}
                    None => drawn.push((label.clone(), piece)),
                }
            }
        }
    }
    drawn
}

/// Writes their labels beside them.
pub(crate) fn name_own(labels: &mut Labels<'_>, drawn: &[(String, Vec<Spot>)]) -> Result<(), DrawingError> {
    drawn.iter().try_for_each(|(label, piece)| labels.name_curve(label, SMALL_LABEL_SIZE, OWN_TEXT, piece))
}
