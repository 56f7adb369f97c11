//! Orbits with two impacts in 2p loops, p from each to the next, as they begin at period doublings of
//! MPSs, and where they graze.

use grazing_model::motion::{Maximum, Motion};
use grazing_model::{ImpactOscillator, MapJet, maps::MapError};
use grazing_theorems::from_map::GrazingOrbitError;
use nalgebra::{Matrix2, SMatrix, SVector, Vector4};

use crate::mps::{
    EventTimes, Formulation, LoopEquations, LoopPair, Multipliers, PeriodicSolution, Unknowns, flight_time,
    unknown,
};
use crate::newton::{self, Linearisation};
use crate::resonance::LocatedResonance;

/// The unknowns (y₁, z₁, y₂, z₂, μ) at fixed η.
type Pair = SVector<f64, 5>;

/// The condition that picks an orbit of the family.
#[derive(Clone, Copy)]
enum Pick {
    /// The difference y₁ − y₂ has this value.
    Difference(f64),
    /// The second impact has no velocity: y₂ = 0.
    Stopped,
    /// The maximum of x near a time after an impact, 0 or 1, is at the wall.
    Touch(usize, f64),
}

/// An orbit with two impacts, or a guess at one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Doubled {
    point: Pair,
    secondary: f64,
}

impl Doubled {
    /// The orbit whose phases lie g apart in the limit map of a resonance, to leading order at a
    /// distance η from it; the second impact is the one with the greater phase if g > 0.
    ///
    /// # Errors
    /// There is no grazing orbit at that η.
    pub fn near_resonance<O: ImpactOscillator>(
        resonance: &LocatedResonance<O>,
        eta: f64,
        gap: f64,
    ) -> Result<Self, GrazingOrbitError> {
        let map = resonance.resonant_point().limit_map();
        let parameter = map.doubled_parameter(gap * gap);
        let [second, first] = map.doubled_impacts(gap);
        let first = resonance.near(eta, parameter, first)?;
        let second = resonance.near(eta, parameter, second)?;
        Ok(Self::of(first, second))
    }

    fn of(first: Unknowns, second: Unknowns) -> Self {
        let [y, z, primary, secondary] = first.into();
        Self { point: Pair::from([y, z, second[0], second[1], primary]), secondary }
    }

    /// The two impacts with the parameters.
    pub fn impacts(&self) -> [Unknowns; 2] {
        let [y_1, z_1, y_2, z_2, primary] = self.point.into();
        [Vector4::new(y_1, z_1, primary, self.secondary), Vector4::new(y_2, z_2, primary, self.secondary)]
    }

    /// The primary parameter.
    pub fn primary(&self) -> f64 {
        self.point[4]
    }
}

/// The first two guesses of the secant method, in units of the gap in the limit map, and the number
/// of iterations.
const BESIDE: [f64; 2] = [0.98, 1.02];
const SECANTS: usize = 8;

/// The equations of orbits with two impacts in 2p loops.
pub struct DoubledEquations<O>(LoopEquations<O>);

impl<O: ImpactOscillator> DoubledEquations<O> {
    /// The equations of the orbits that branch off the MPSs of these equations.
    pub fn new(equations: &LoopEquations<O>) -> Self {
        // The form without virtual points: it is defined all along the curves.
        Self(equations.with_formulation(Formulation::FixedPhase))
    }

    /// The two maps at both impacts, to one plane of constant phase.
    fn pairs(&self, doubled: &Doubled) -> Result<[LoopPair; 2], MapError> {
        let mut times = EventTimes::default();
        let [first, second] = doubled.impacts();
        Ok([self.0.pair::<1>(&first, &mut times)?, self.0.pair::<1>(&second, &mut times)?])
    }

    /// The residual of the condition, and its derivatives in the unknowns.
    fn condition(&self, doubled: &Doubled, pick: &mut Pick) -> Result<(f64, Pair), MapError> {
        Ok(match pick {
            Pick::Difference(value) => {
                let gap = doubled.point[0] - doubled.point[2] - *value;
                (gap, Pair::from([1.0, 0.0, -1.0, 0.0, 0.0]))
            }
            Pick::Stopped => (doubled.point[2], Pair::from([0.0, 0.0, 1.0, 0.0, 0.0])),
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
            Ok::<_, MapError>(system.bordered(residual, &gradient))
        };
        let solution = newton::solve(start.point, 25, evaluate).ok()?;
        Some(Doubled { point: solution.point, ..start })
    }

    /// The orbit with this difference of velocities, beside a point with a multiplier −1.
    pub fn near(&self, flip: &Unknowns, difference: f64) -> Option<Doubled> {
        let pair = self.0.pair::<1>(flip, &mut EventTimes::default()).ok()?;
        let direction = pair.direction(-1.0)?;
        let apart = direction * (0.5 * difference / direction[0]);
        let apart = Unknowns::new(apart[0], apart[1], 0.0, 0.0);
        self.solved(Doubled::of(flip + apart, flip - apart))
    }

    /// The orbit near a guess, with the guess's difference of velocities.
    pub fn solved(&self, guess: Doubled) -> Option<Doubled> {
        self.solve(guess, Pick::Difference(guess.point[0] - guess.point[2]))
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

    /// The member of the family that grazes, near a guess, with the number of the visit of its loop
    /// that touches the wall; 0 if the second impact has no velocity.
    ///
    /// The whole orbit lies in front of the wall: a maximum is brought to the wall, and if another
    /// one is then above it, that one touches first.
    pub fn grazing(&self, guess: Doubled) -> Option<(Doubled, u32)> {
        let one_loop = self.0.loops() == 1;
        let mut here = if one_loop { self.solve(guess, Pick::Stopped)? } else { guess };
        let mut found = one_loop.then_some(0);
        for _ in 0..=2 * self.0.loops() {
            let highest = self.highest(&here);
            let above = highest.filter(|(_, top)| found.is_none() || top.position > PeriodicSolution::TOUCH);
            let Some((after, top)) = above else { break };
            here = self.solve(here, Pick::Touch(after, top.time))?;
            let period = self.0.oscillator_at(&here.impacts()[0]).forcing_period();
            found = Some(libm::round(top.time / period) as u32);
        }
        let inside = |(_, top): (usize, Maximum)| top.position <= PeriodicSolution::TOUCH;
        found.filter(|_| self.highest(&here).is_none_or(inside)).map(|visit| (here, visit))
    }

    /// The member of the family at a distance η from a resonance that doubles its period, near its
    /// counterpart in the limit map.
    pub fn flip(&self, resonance: &LocatedResonance<O>, eta: f64) -> Option<Doubled> {
        let at = |gap: f64| {
            let doubled = self.solved(Doubled::near_resonance(resonance, eta, gap).ok()?)?;
            let Multipliers { trace, determinant } = self.multipliers(&doubled)?;
            Some((doubled, 1.0 + trace + determinant))
        };
        let expected = resonance.resonant_point().limit_map().second_doubling();
        let mut gaps = BESIDE.map(|part| part * expected.sqrt());
        let (_, mut before) = at(gaps[0])?;
        for _ in 0..SECANTS {
            let (found, value) = at(gaps[1])?;
            let slope = (value - before) / (gaps[1] - gaps[0]);
            let step = value / slope;
            if step.is_nan() || step.abs() <= f64::EPSILON * gaps[1].abs() {
                return Some(found);
            }
            (gaps, before) = ([gaps[1], gaps[1] - step], value);
        }
        Some(at(gaps[1])?.0)
    }

    /// Trace and determinant of the derivative of the return after two impacts.
    pub fn multipliers(&self, doubled: &Doubled) -> Option<Multipliers> {
        let [first, second] = self.pairs(doubled).ok()?;
        let step = |from: &LoopPair, to: &LoopPair| -> Option<Matrix2<f64>> {
            Some(to.impact.derivative().try_inverse()? * from.round_trip.derivative())
        };
        let u = step(&second, &first)? * step(&first, &second)?;
        Some(Multipliers { trace: u.trace(), determinant: u.determinant() })
    }
}
