//! Points of curves in planes that they cross, and where curves leave the ranges, which are counted in shares of them.

use grazing_continuation::arclength::CurveEquations;
use grazing_continuation::newton;
use nalgebra::{Const, DimMin, SVector};

/// The point of a curve near another in the plane across a direction that goes through a third.
pub(crate) fn located<const N: usize, C: CurveEquations<N, Carried: Default>>(
    equations: &C,
    near: SVector<f64, N>,
    across: &SVector<f64, N>,
    through: &SVector<f64, N>,
) -> Option<SVector<f64, N>>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let mut carried = C::Carried::default();
    let located = newton::solve(near, 20, |point| {
        let mut system = equations.evaluate(point, &mut carried)?;
        system.residual[N - 1] = across.dot(&(point - through));
        system.jacobian.set_row(N - 1, &across.transpose());
        Ok::<_, C::Failure>(system)
    });
    Some(located.ok()?.point)
}

/// Where a chord first leaves 0 to 1 in one of these unknowns, if it does: the share of the chord, the unknown, and 0 or 1.
fn leaves<const N: usize>(
    unknowns: impl IntoIterator<Item = usize>,
    [before, after]: [&SVector<f64, N>; 2],
) -> Option<(f64, usize, f64)> {
    let outside = unknowns.into_iter().filter(|&k| after[k] < 0.0 || after[k] > 1.0);
    let crossed = outside.map(|k| {
        let edge = after[k].clamp(0.0, 1.0);
        ((edge - before[k]) / (after[k] - before[k]), k, edge)
    });
    crossed.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The point at which a curve leaves 0 to 1 in one of these unknowns between two of its points, if it does, and the unknown.
pub(crate) fn on_the_edge<const N: usize, C: CurveEquations<N, Carried: Default>>(
    equations: &C,
    unknowns: impl IntoIterator<Item = usize>,
    [before, after]: [&SVector<f64, N>; 2],
) -> Option<(SVector<f64, N>, usize)>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let (way, unknown, edge) = leaves(unknowns, [before, after])?;
    let near = before + (after - before) * way;
    let (mut through, mut across) = (near, SVector::zeros());
    (through[unknown], across[unknown]) = (edge, 1.0);
    let mut point = located(equations, near, &across, &through).unwrap_or(near);
    point[unknown] = edge;
    Some((point, unknown))
}
