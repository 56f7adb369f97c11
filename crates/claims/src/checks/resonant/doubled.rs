//! Period-doubled MPSs, with two impacts in 2p loops, near the curve of multiplier −1.

use crate::*;
use grazing_continuation::mps::flight_time;
use grazing_continuation::newton::{self, Linearisation};
use grazing_model::MapJet;
use grazing_model::motion::Maximum;
use nalgebra::{SMatrix, SVector, Vector4};

/// (y₁, z₁, y₂, z₂, μ) at fixed η.
type Pair = SVector<f64, 5>;

/// The condition that picks an orbit of the family.
#[derive(Clone, Copy)]
enum Pick {
    /// y₁ − y₂.
    Difference(f64),
    /// y₂.
    Lower(f64),
    /// The maximum of x near a time after an impact, 0 or 1, is at the wall.
    Touch(usize, f64),
}

/// How a period-doubled MPS grazes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Grazes {
    /// One of its two impacts has the velocity 0.
    AtAnImpact,
    /// Another maximum touches the wall.
    Between,
}

/// A period-doubled MPS.
#[derive(Clone, Copy)]
pub(super) struct Doubled {
    point: Pair,
    secondary: f64,
}

impl Doubled {
    /// The two impacts with the parameters.
    pub(super) fn impacts(&self) -> [Unknowns; 2] {
        let [y_1, z_1, y_2, z_2, primary] = self.point.into();
        [Vector4::new(y_1, z_1, primary, self.secondary), Vector4::new(y_2, z_2, primary, self.secondary)]
    }

    /// The primary parameter.
    pub(super) fn primary(&self) -> f64 {
        self.point[4]
    }
}

/// The equations of period-doubled MPSs with 2p loops.
pub(super) struct DoubledEquations(LoopEquations<Specimen>);

impl DoubledEquations {
    /// Those that branch off the MPSs of these equations.
    pub(super) fn new(equations: &LoopEquations<Specimen>) -> Self {
        // The form without virtual points: it is defined all along the curves.
        Self(equations.with_formulation(Formulation::FixedPhase))
    }

    /// The two maps at both impacts, to one plane of constant phase.
    fn pairs(&self, doubled: &Doubled) -> Result<[LoopPair; 2], MapError> {
        let mut times = EventTimes::default();
        let [first, second] = doubled.impacts();
        Ok([self.0.pair::<1>(&first, &mut times)?, self.0.pair::<1>(&second, &mut times)?])
    }

    /// The condition's residual, and its derivatives in the unknowns.
    fn condition(&self, doubled: &Doubled, pick: &mut Pick) -> Result<(f64, Pair), MapError> {
        Ok(match pick {
            Pick::Difference(value) => {
                let gap = doubled.point[0] - doubled.point[2] - *value;
                (gap, Pair::from([1.0, 0.0, -1.0, 0.0, 0.0]))
            }
            Pick::Lower(value) => (doubled.point[2] - *value, Pair::from([0.0, 0.0, 1.0, 0.0, 0.0])),
            Pick::Touch(after, time) => {
                let (height, gradient) = self.0.maximum_near(&doubled.impacts()[*after], time)?;
                let mut row = Pair::zeros();
                row.fixed_rows_mut::<2>(2 * *after).copy_from(&gradient.fixed_rows::<2>(0));
                row[4] = gradient[unknown::PRIMARY];
                (height, row)
            }
        })
    }

    fn solve(&self, start: Doubled, mut pick: Pick) -> Option<Doubled> {
        let evaluate = |point: &Pair| {
            let here = Doubled { point: *point, ..start };
            let [one, other] = self.pairs(&here)?;
            let mut system = Linearisation { residual: Pair::zeros(), jacobian: SMatrix::zeros() };
            // From the first impact to the second, and from the second to the first.
            for (row, from, to, columns) in [(0, one, other, [0, 2]), (2, other, one, [2, 0])] {
                let gap = from.round_trip.value - to.impact.value;
                system.residual.fixed_rows_mut::<2>(row).copy_from(&gap);
                let (ahead, behind) = (from.round_trip.derivative(), -to.impact.derivative());
                system.jacobian.fixed_view_mut::<2, 2>(row, columns[0]).copy_from(&ahead);
                system.jacobian.fixed_view_mut::<2, 2>(row, columns[1]).copy_from(&behind);
                let by_primary = |jet: &MapJet| jet.jacobian.column(unknown::PRIMARY).into_owned();
                let gap = by_primary(&from.round_trip) - by_primary(&to.impact);
                system.jacobian.fixed_view_mut::<2, 1>(row, 4).copy_from(&gap);
            }
            let (residual, gradient) = self.condition(&here, &mut pick)?;
            system.residual[4] = residual;
            system.jacobian.set_row(4, &gradient.transpose());
            Ok::<_, MapError>(system)
        };
        let solution = newton::solve(start.point, 25, evaluate).ok()?;
        Some(Doubled { point: solution.point, ..start })
    }

    /// The period-doubled MPS with this difference of velocities, beside a multiplier −1.
    pub(super) fn near(&self, flip: &Unknowns, difference: f64) -> Option<Doubled> {
        let pair = self.0.pair::<1>(flip, &mut EventTimes::default()).ok()?;
        // The eigenvector to −1: the kernel of the sum of the two derivatives.
        let sum = pair.round_trip.derivative() + pair.impact.derivative();
        let row = if sum.row(0).norm() > sum.row(1).norm() { 0 } else { 1 };
        let vector = Vector2::new(1.0, -sum[(row, 0)] / sum[(row, 1)]) * (0.5 * difference);
        let [y, z, primary, secondary] = (*flip).into();
        let point = Pair::from([y + vector[0], z + vector[1], y - vector[0], z - vector[1], primary]);
        self.solve(Doubled { point, secondary }, Pick::Difference(difference))
    }

    /// The highest maximum of x between impacts, with the impact after which it comes.
    fn highest(&self, doubled: &Doubled) -> Option<(usize, Maximum)> {
        let impacts = doubled.impacts();
        let oscillator = self.0.oscillator_at(&impacts[0]);
        let highest = |after: usize| {
            let recoil = self.0.departure(&impacts[after]);
            let next = impacts[1 - after][unknown::PHASE];
            let flight = flight_time(&oscillator, self.0.loops(), next, recoil.phase);
            Some((after, oscillator.motion(recoil).highest_maximum(flight)?))
        };
        let both = (0..2).filter_map(highest);
        both.max_by(|(_, one), (_, other)| one.position.total_cmp(&other.position))
    }

    /// The first member of the family that grazes, and how: all its other maxima lie in front of
    /// the wall, and both impacts have y ≥ 0.
    pub(super) fn grazing(&self, flip: &Unknowns) -> Option<(Doubled, Grazes)> {
        // The family in 40 steps, each from the two before by extrapolation.
        let steps = 40;
        let y = flip[unknown::VELOCITY];
        let mut here = self.near(flip, 0.1 * y)?;
        let start = here.point[2];
        let mut before = here;
        for k in 1..=steps {
            let lower = start * (1.0 - f64::from(k) / f64::from(steps));
            let guess = Doubled { point: here.point * 2.0 - before.point, ..here };
            before = here;
            here = self.solve(guess, Pick::Lower(lower))?;
            let inside = |doubled: &Doubled| {
                self.highest(doubled).is_none_or(|(_, top)| top.position <= PeriodicSolution::TOUCH)
            };
            if !inside(&here) {
                // One maximum is brought to the wall; if another is above it then, that one was
                // first.
                for _ in 0..2 * self.0.loops() {
                    let (after, top) = self.highest(&here)?;
                    here = self.solve(here, Pick::Touch(after, top.time))?;
                    if inside(&here) {
                        return Some((here, Grazes::Between));
                    }
                }
                return None;
            }
        }
        Some((here, Grazes::AtAnImpact))
    }

    /// Trace and determinant of the derivative of the return after two impacts.
    pub(super) fn multipliers(&self, doubled: &Doubled) -> Option<Multipliers> {
        let [first, second] = self.pairs(doubled).ok()?;
        let step = |from: &LoopPair, to: &LoopPair| -> Option<Matrix2<f64>> {
            Some(to.impact.derivative().try_inverse()? * from.round_trip.derivative())
        };
        let u = step(&second, &first)? * step(&first, &second)?;
        Some(Multipliers { trace: u.trace(), determinant: u.determinant() })
    }
}
