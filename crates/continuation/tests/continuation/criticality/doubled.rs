//! Orbits of double period beside an MPS with the multiplier −1, solved for without normal forms.

use grazing_continuation::mps::{
    EventTimes, Formulation, LoopEquations, LoopPair, Multipliers, Unknowns, unknown,
};
use grazing_continuation::newton::{self, Linearisation};
use grazing_model::ImpactOscillator;
use grazing_model::maps::MapError;
use nalgebra::{Matrix2, SMatrix, SVector, Vector2, Vector4};

/// (y₁, z₁, y₂, z₂, μ) at fixed η.
type Five = SVector<f64, 5>;

fn impacts(point: &Five, secondary: f64) -> [Unknowns; 2] {
    [0, 2].map(|i| Vector4::new(point[i], point[i + 1], point[4], secondary))
}

fn pairs<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    impacts: [Unknowns; 2],
) -> Result<[LoopPair; 2], MapError> {
    let mut times = EventTimes::default();
    let mut pair = |impact: &Unknowns| equations.pair::<1>(impact, &mut times);
    Ok([pair(&impacts[0])?, pair(&impacts[1])?])
}

/// Trace and determinant of the derivative of the return to the first impact, which takes both, of
/// the doubled orbit at the η of a period doubling whose impacts lie 2s apart in the direction q.
pub(super) fn doubled<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    flip: &Unknowns,
    q: Vector2<f64>,
    s: f64,
) -> Option<Multipliers> {
    let equations = equations.with_formulation(Formulation::FixedPhase);
    let [y, z, primary, secondary] = (*flip).into();
    let start = Five::from([y + s * q[0], z + s * q[1], y - s * q[0], z - s * q[1], primary]);
    let solution = newton::solve(start, 25, |point| {
        let [first, second] = pairs(&equations, impacts(point, secondary))?;
        let mut system = Linearisation { residual: Five::zeros(), jacobian: SMatrix::zeros() };
        for (row, from, to, columns) in [(0, first, second, [0, 2]), (2, second, first, [2, 0])] {
            let gap = from.round_trip.value - to.impact.value;
            system.residual.fixed_rows_mut::<2>(row).copy_from(&gap);
            let (ahead, behind) = (from.round_trip.derivative(), -to.impact.derivative());
            system.jacobian.fixed_view_mut::<2, 2>(row, columns[0]).copy_from(&ahead);
            system.jacobian.fixed_view_mut::<2, 2>(row, columns[1]).copy_from(&behind);
            for i in 0..2 {
                system.jacobian[(row + i, 4)] = from.round_trip.jacobian[(i, unknown::PRIMARY)]
                    - to.impact.jacobian[(i, unknown::PRIMARY)];
            }
        }
        let apart = Vector2::new(point[0] - point[2], point[1] - point[3]);
        system.residual[4] = 0.5 * q.dot(&apart) - s;
        for i in 0..2 {
            system.jacobian[(4, i)] = 0.5 * q[i];
            system.jacobian[(4, 2 + i)] = -0.5 * q[i];
        }
        Ok::<_, MapError>(system)
    })
    .ok()?;
    let [first, second] = pairs(&equations, impacts(&solution.point, secondary)).ok()?;
    let step = |from: &LoopPair, to: &LoopPair| -> Option<Matrix2<f64>> {
        Some(to.impact.derivative().try_inverse()? * from.round_trip.derivative())
    };
    let u = step(&second, &first)? * step(&first, &second)?;
    Some(Multipliers { trace: u.trace(), determinant: u.determinant() })
}
