//! Points at which curves leave the ranges, in unknowns that are fractions of the ranges.

use grazing_continuation::arclength::{self, CurveEquations};
use grazing_continuation::newton::Space;

/// The point at which a chord first leaves the interval from 0 to 1 in one of these unknowns, if it
/// does: the fraction of the chord, the unknown, and 0 or 1.
fn leaves(
    unknowns: impl IntoIterator<Item = usize>,
    [before, after]: [&impl Space; 2],
) -> Option<(f64, usize, f64)> {
    let outside = unknowns.into_iter().filter(|&k| after[k] < 0.0 || after[k] > 1.0);
    let crossed = outside.map(|k| {
        let edge = after[k].clamp(0.0, 1.0);
        ((edge - before[k]) / (after[k] - before[k]), k, edge)
    });
    crossed.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The point at which a curve leaves the interval from 0 to 1 in one of these unknowns between two
/// of its points, if it does, and the unknown.
pub(crate) fn on_the_edge<C: CurveEquations<Carried: Default>>(
    equations: &C,
    unknowns: impl IntoIterator<Item = usize>,
    [before, after]: [&C::Point; 2],
) -> Option<(C::Point, usize)> {
    let (way, unknown, edge) = leaves(unknowns, [before, after])?;
    let near = before.clone() + (after.clone() - before.clone()) * way;
    let (mut through, mut across) = (near.clone(), near.filled(0.0));
    (through[unknown], across[unknown]) = (edge, 1.0);
    let mut point =
        arclength::across(equations, near.clone(), &across, &through).map_or(near, |found| found.point);
    point[unknown] = edge;
    Some((point, unknown))
}
