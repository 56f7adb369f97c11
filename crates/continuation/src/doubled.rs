//! Orbits with two impacts in 2p loops, p from each to the next, as they begin at period doublings of
//! MPSs, and where they graze.

use core::f64::consts::TAU;

use grazing_model::ImpactOscillator;
use grazing_model::motion::Maximum;
use grazing_theorems::from_map::GrazingOrbitError;

use crate::locate::{Condition, locate};
use crate::mps::{EventTimes, Formulation, LoopEquations, Multipliers, PeriodicSolution, Unknowns, unknown};
use crate::resonance::LocatedResonance;

/// The first two guesses of the secant method, in units of the gap in the limit map, and the number
/// of iterations.
const BESIDE: [f64; 2] = [0.98, 1.02];
const SECANTS: usize = 8;

/// The equations of orbits with two impacts in 2p loops.
pub struct DoubledEquations<O> {
    /// The equations of the MPSs from which the orbits branch off.
    single: LoopEquations<O>,
    equations: LoopEquations<O>,
}

impl<O: ImpactOscillator> DoubledEquations<O> {
    /// The equations of the orbits that branch off the MPSs of these equations.
    pub fn new(equations: &LoopEquations<O>) -> Self {
        // The form without virtual points: it is defined all along the curves.
        let single = equations.with_formulation(Formulation::FixedPhase);
        Self { equations: single.over(2), single }
    }

    /// The orbit with these two impacts at one η and μ, the phase of the second counted as that of the first.
    fn of(&self, first: &Unknowns, second: &Unknowns) -> Unknowns {
        let mut impacts = [first.impact(0), second.impact(0)];
        impacts[1].phase += f64::from(self.single.loops()) * TAU;
        Unknowns::of_impacts(&impacts, [first[unknown::PRIMARY], first[unknown::SECONDARY]])
    }

    /// The two impacts of an orbit as those of MPSs, with the parameters.
    pub fn impacts(&self, doubled: &Unknowns) -> [Unknowns; 2] {
        [0, 1].map(|index| {
            let impact = doubled.impact(index);
            let phase = impact.phase - index as f64 * f64::from(self.single.loops()) * TAU;
            Unknowns::new(impact.velocity, phase, doubled[unknown::PRIMARY], doubled[unknown::SECONDARY])
        })
    }

    /// The orbit whose phases lie g apart in the limit map of a resonance, to leading order at a
    /// distance η from it; the second impact is the one with the greater phase if g > 0.
    ///
    /// # Errors
    /// There is no grazing orbit at that η.
    pub fn near_resonance(
        &self,
        resonance: &LocatedResonance<O>,
        eta: f64,
        gap: f64,
    ) -> Result<Unknowns, GrazingOrbitError> {
        let map = resonance.resonant_point().limit_map();
        let parameter = map.doubled_parameter(gap * gap);
        let [second, first] = map.doubled_impacts(gap);
        let first = resonance.near(eta, parameter, first)?;
        let second = resonance.near(eta, parameter, second)?;
        Ok(self.of(&first, &second))
    }

    fn solve(&self, start: Unknowns, condition: Condition, mut times: EventTimes) -> Option<Unknowns> {
        let held = Condition::Secondary(start[unknown::SECONDARY]);
        locate(&self.equations, [held, condition], start, &mut times).ok()
    }

    /// The orbit with this difference of velocities, beside a point with a multiplier −1.
    pub fn near(&self, flip: &Unknowns, difference: f64) -> Option<Unknowns> {
        let maps = self.single.maps::<1>(flip, &mut EventTimes::default()).ok()?;
        let direction = maps.direction(-1.0)?;
        let apart = direction * (0.5 * difference / direction[0]);
        let apart = Unknowns::new(apart[0], apart[1], 0.0, 0.0);
        self.solved(self.of(&(flip + &apart), &(flip - &apart)))
    }

    /// The orbit near a guess, with the guess's difference of velocities.
    pub fn solved(&self, guess: Unknowns) -> Option<Unknowns> {
        let [first, second] = [0, 1].map(|impact| guess.impact(impact).velocity);
        self.solve(guess, Condition::Difference(first - second), EventTimes::default())
    }

    /// The highest maximum of x between impacts.
    fn highest(&self, doubled: &Unknowns) -> Option<Maximum> {
        self.equations.solution(doubled).highest_interior_maximum
    }

    /// The member of the family that grazes, near a guess, with the number of the visit of its loop
    /// that touches the wall; 0 if the second impact has no velocity.
    ///
    /// The whole orbit lies in front of the wall: a maximum is brought to the wall, and if another
    /// one is then above it, that one touches first.
    pub fn grazing(&self, guess: Unknowns) -> Option<(Unknowns, u32)> {
        let one_loop = self.single.loops() == 1;
        let stopped = Condition::stopped(1);
        let mut here = if one_loop { self.solve(guess, stopped, EventTimes::default())? } else { guess };
        let mut found = one_loop.then_some(0);
        for _ in 0..=2 * self.single.loops() {
            let highest = self.highest(&here);
            let above = highest.filter(|top| found.is_none() || top.position > PeriodicSolution::TOUCH);
            let Some(top) = above else { break };
            here = self.solve(here, Condition::InteriorGrazing, EventTimes::default().touching(top.time))?;
            let (_, start) = self.equations.flight_at(&here, top.time);
            let period = self.equations.oscillator_at(&here).forcing_period();
            found = Some(libm::round((top.time - start) / period) as u32);
        }
        let inside = |top: Maximum| top.position <= PeriodicSolution::TOUCH;
        found.filter(|_| self.highest(&here).is_none_or(inside)).map(|visit| (here, visit))
    }

    /// The member of the family at a distance η from a resonance that doubles its period, near its
    /// counterpart in the limit map.
    pub fn flip(&self, resonance: &LocatedResonance<O>, eta: f64) -> Option<Unknowns> {
        let at = |gap: f64| {
            let doubled = self.solved(self.near_resonance(resonance, eta, gap).ok()?)?;
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
    pub fn multipliers(&self, doubled: &Unknowns) -> Option<Multipliers> {
        let maps = self.equations.maps::<1>(doubled, &mut EventTimes::default()).ok()?;
        Some(maps.multipliers())
    }
}
