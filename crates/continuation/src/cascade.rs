//! Period-doubling cascades in the limit map at a resonance
//! ([`limit_map`](grazing_theorems::limit_map)): the M at which orbits with 2, 4, 8, … impacts
//! begin as M moves away from where the MPS is stable, and the reason why the next one does not
//! begin.
//!
//! Orbits with N impacts are the solutions of N equations of second degree between successive phases,
//! Y' = dV − V' being the velocity:
//!
//! ```text
//! (d Vᵢ − Vᵢ₊₁)² = r (d Vᵢ₋₁ − Vᵢ)² + k Vᵢ² + 2 Vᵢ + M,     i = 1, …, N, cyclic.
//! ```
//!
//! The equations do not include admissibility, so that their solutions continue smoothly where an
//! impact loses its velocity. With the derivative taken to change sign once round, its determinant
//! is zero where a multiplier is −1, and its kernel is the direction in which orbits with 2N
//! impacts leave. These are followed in the gap between the two phases that coincide at the onset.

use grazing_theorems::limit_map::LimitImpact;
use grazing_theorems::{LimitMap, Side};
use nalgebra::{DMatrix, DVector};

use crate::regula_falsi::zero_between;

/// The reason why no further orbit begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CascadeEnd {
    /// The last doubling creates unstable orbits.
    Subcritical,
    /// The last orbits leave the map before they double: an impact loses its velocity, or a visit before an impact is at
    /// the wall.
    Grazing,
    /// The last orbits end at a saddle-node.
    SaddleNode,
    /// The last orbits continue beyond the range of the search.
    Lost,
    /// The requested number of orbits has begun.
    Enough,
}

impl CascadeEnd {
    /// The name used in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Subcritical => "subcritical",
            Self::Grazing => "grazing",
            Self::SaddleNode => "saddle-node",
            Self::Lost => "lost",
            Self::Enough => "enough",
        }
    }
}

/// A sequence of orbits that begin stable, one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Cascade {
    /// M at which orbits with 2, 4, 8, … impacts begin.
    pub onsets: Vec<f64>,
    /// The reason why no more begin.
    pub stop: CascadeEnd,
}

/// An orbit of the limit map.
#[derive(Clone, Debug)]
struct Cycle {
    phases: Vec<f64>,
    parameter: f64,
}

/// Step in the gap, in units of the velocity at the first doubling, and factor by which it is
/// shorter for each further family, about the ratio that one-dimensional maps have in the limit.
const STEP: f64 = 0.05;
const SHORTER: f64 = 0.4;
/// Largest number of steps of a family, and of Newton's method.
const MOST_STEPS: usize = 200;
const MOST_ITERATIONS: usize = 20;
/// The last step of Newton's method, in units of the orbit's phases.
const SOLVED: f64 = 1e-12;
/// Error allowed in the location of a doubling, as a fraction of a step.
const LOCATED: f64 = 1e-11;

impl Cascade {
    /// M at which orbits with 2^(`place` + 1) impacts begin, divided by the M of the first
    /// doubling; NaN if they do not begin.
    pub fn fraction(&self, place: usize) -> f64 {
        self.onsets.get(place).map_or(f64::NAN, |onset| onset / self.onsets[0])
    }

    /// The cascade of a map, up to orbits with 2^`most` impacts.
    pub fn of(map: &LimitMap, most: usize) -> Self {
        let mut onsets = Vec::new();
        let stop = follow(map, most, &mut onsets).err().unwrap_or(CascadeEnd::Enough);
        Self { onsets, stop }
    }
}

fn follow(map: &LimitMap, most: usize, onsets: &mut Vec<f64>) -> Result<(), CascadeEnd> {
    if map.criticality().is_nan() || map.criticality() <= 0.0 {
        return Err(CascadeEnd::Subcritical);
    }
    let [velocity, parameter] = map.period_doubling();
    onsets.push(parameter);
    // Orbits with two impacts are in closed form.
    let parameter = map.doubled_doubling().ok_or(CascadeEnd::Grazing)?;
    let [one, other] = map.doubled_impacts(map.second_doubling().sqrt());
    let mut here = Cycle { phases: vec![one.phase, other.phase], parameter };
    let mut step = STEP * velocity;
    while onsets.len() < most {
        step *= SHORTER;
        here = here.next_doubling(map, step, onsets, most)?;
    }
    Ok(())
}

impl Cycle {
    fn phase(&self, index: usize) -> f64 {
        self.phases[index % self.phases.len()]
    }

    /// The impact with an index, which is at least 1.
    fn impact(&self, map: &LimitMap, index: usize) -> LimitImpact {
        let [_, _, d] = map.numbers();
        let phase = self.phase(index);
        LimitImpact { velocity: d * self.phase(index - 1) - phase, phase }
    }

    /// The equations, and their derivative in the phases, which changes by a factor once round.
    fn equations(&self, map: &LimitMap, turn: f64) -> (DVector<f64>, DMatrix<f64>) {
        let (count, [r, k, d]) = (self.phases.len(), map.numbers());
        let mut residual = DVector::zeros(count);
        let mut derivative = DMatrix::zeros(count, count);
        for row in 0..count {
            let (here, next) = (self.impact(map, row + count), self.impact(map, row + 1));
            residual[row] = next.velocity * next.velocity - map.next_square(self.parameter, here);
            let factor = |wraps: bool| if wraps { turn } else { 1.0 };
            derivative[(row, (row + 1) % count)] -= 2.0 * next.velocity * factor(row + 1 == count);
            derivative[(row, row)] += 2.0 * (d * next.velocity + r * here.velocity - k * here.phase - 1.0);
            derivative[(row, (row + count - 1) % count)] -= 2.0 * r * d * here.velocity * factor(row == 0);
        }
        (residual, derivative)
    }

    /// A function that is positive before the orbit doubles its period, where velocities are all of
    /// one sign: det(DF + 1) times the product of velocities.
    fn flip(&self, map: &LimitMap) -> f64 {
        self.equations(map, -1.0).1.determinant()
    }

    /// Whether the cycle is an orbit of the map, on the side of the velocity at the first doubling.
    fn is_admissible(&self, map: &LimitMap) -> bool {
        let side = Side::of(map.period_doubling()[0]);
        (1..=self.phases.len()).all(|index| {
            let impact = self.impact(map, index);
            impact.velocity * side.signum() > 0.0 && map.step(side, self.parameter, impact).is_ok()
        })
    }

    /// The orbit near this one whose first phase exceeds the phase half-way round by `gap`.
    fn solved(mut self, map: &LimitMap, gap: f64) -> Option<Self> {
        let count = self.phases.len();
        for _ in 0..MOST_ITERATIONS {
            let (residual, derivative) = self.equations(map, 1.0);
            let mut system = derivative.resize(count + 1, count + 1, 0.0);
            let mut right = residual.resize_vertically(count + 1, 0.0);
            system.column_mut(count).rows_mut(0, count).fill(-1.0);
            (system[(count, 0)], system[(count, count / 2)]) = (1.0, -1.0);
            right[count] = self.phases[0] - self.phases[count / 2] - gap;
            let step = system.lu().solve(&right)?;
            self.phases.iter_mut().zip(step.iter()).for_each(|(phase, step)| *phase -= step);
            self.parameter -= step[count];
            if step.amax() < SOLVED * self.phases[0].abs() {
                return Some(self);
            }
        }
        None
    }

    /// The orbit with twice as many impacts, at a given gap, that leaves this orbit at its period
    /// doubling; the gap is first opened where the kernel is largest.
    fn opened(&self, map: &LimitMap, gap: f64) -> Option<Self> {
        let count = self.phases.len();
        let (_, mut system) = self.equations(map, -1.0);
        // One equation follows from the others.
        system.row_mut(count - 1).fill(0.0);
        system[(count - 1, 0)] = 1.0;
        let mut right = DVector::zeros(count);
        right[count - 1] = 1.0;
        let direction = system.lu().solve(&right)?;
        let most = direction.icamax();
        let round = |index: usize| {
            let turn = if (index / count).is_multiple_of(2) { 1.0 } else { -1.0 };
            self.phase(index) + 0.5 * gap * turn * direction[index % count] / direction[most]
        };
        Some(Self { phases: (most..most + 2 * count).map(round).collect(), parameter: self.parameter })
    }

    /// The next period doubling, of the orbits with twice as many impacts that leave this one at
    /// its own; an onset is added if they begin stable and more are requested.
    fn next_doubling(
        &self,
        map: &LimitMap,
        step: f64,
        onsets: &mut Vec<f64>,
        most: usize,
    ) -> Result<Self, CascadeEnd> {
        let away = |from: &Self, to: &Self| (to.parameter - from.parameter) * map.period_doubling()[1] < 0.0;
        let first =
            self.opened(map, step).ok_or(CascadeEnd::Lost)?.solved(map, step).ok_or(CascadeEnd::Lost)?;
        if !away(self, &first) {
            return Err(CascadeEnd::Subcritical);
        }
        onsets.push(self.parameter);
        if onsets.len() == most {
            return Ok(first);
        }
        let before = first.flip(map).signum();
        let mut last = [self.opened(map, 0.0).ok_or(CascadeEnd::Lost)?, first];
        for count in 2..MOST_STEPS {
            let [before_last, from] = &last;
            let at = |share: f64| {
                let ahead = |one: f64, two: f64| two + share * (two - one);
                let phases = before_last.phases.iter().zip(&from.phases).map(|(&one, &two)| ahead(one, two));
                let parameter = ahead(before_last.parameter, from.parameter);
                let gap = (count as f64 - 1.0 + share) * step;
                let guess = Self { phases: phases.collect(), parameter };
                guess.solved(map, gap).ok_or(CascadeEnd::Lost)
            };
            let to = at(1.0)?;
            let flips = [from.flip(map), to.flip(map)].map(|flip| before * flip);
            if flips[1] < 0.0 {
                let flip = |share: f64| {
                    at(share).map(|found| {
                        let flip = before * found.flip(map);
                        (found, flip)
                    })
                };
                let found = zero_between(flips, flip, |_, value| value.abs() < LOCATED * flips[0].abs())?;
                return if found.is_admissible(map) { Ok(found) } else { Err(CascadeEnd::Grazing) };
            }
            if !to.is_admissible(map) {
                return Err(CascadeEnd::Grazing);
            }
            if !away(from, &to) {
                return Err(CascadeEnd::SaddleNode);
            }
            last = [last[1].clone(), to];
        }
        Err(CascadeEnd::Lost)
    }
}
