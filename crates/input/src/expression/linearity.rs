//! Whether an expression is linear in position and velocity, and otherwise a sum of harmonics in time.

use core::f64::consts::TAU;

use grazing_model::smooth::Function;

use super::{Expression, Instruction, Operation, Slot};

/// The numbers of the variables x, v and t; the others are parameters.
const TIME: Slot = 2;
const MOVING: Slot = 3;
/// The greatest multiple of the forcing frequency for which motion is computed in closed form.
const MOST_HARMONICS: u32 = 6;
/// Deviation of a number of turns from a whole one that is rounding.
const ROUNDING: f64 = 1e-9;

/// How a value depends on position, velocity and time.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Dependence {
    /// On neither of them.
    Fixed,
    /// Linearly on time alone.
    Time,
    /// By sines and cosines of up to a multiple of the phase, and linearly on position and velocity if it
    /// `moves`.
    Waves { multiple: u32, moves: bool },
    /// In another way.
    Other,
}

use Dependence::{Fixed, Other, Time, Waves};

impl Dependence {
    fn plus(self, other: Self) -> Self {
        match (self, other) {
            (Fixed, both) | (both, Fixed) => both,
            (Time, Time) => Time,
            (Waves { multiple: m, moves: a }, Waves { multiple: n, moves: b }) => {
                Waves { multiple: m.max(n), moves: a || b }
            }
            _ => Other,
        }
    }

    fn times(self, other: Self) -> Self {
        match (self, other) {
            (Fixed, both) | (both, Fixed) => both,
            (Waves { multiple: m, moves: false }, Waves { multiple: n, moves: false }) => {
                Waves { multiple: m + n, moves: false }
            }
            _ => Other,
        }
    }
}

impl Expression {
    /// The number of harmonics of the forcing, if this force in x, v, t and two parameters is linear in x and v with
    /// coefficients that depend on the parameters alone, and otherwise a sum of harmonics; `frequency` is that of the
    /// forcing, and `places` are some pairs of parameters.
    pub(crate) fn harmonics(&self, frequency: &Self, places: &[[f64; 2]]) -> Option<u32> {
        let count = |[mu, eta]: &[f64; 2]| {
            let period = TAU / frequency.evaluate(&[*mu, *eta]);
            let [before, after] = [0.0, period].map(|time| self.values(&[0.0, 0.0, time, *mu, *eta]));
            let turns = |slot: Slot| (after[slot] - before[slot]) / TAU;
            match self.dependence(turns) {
                Fixed => Some(0),
                Waves { multiple, .. } if multiple <= MOST_HARMONICS => Some(multiple),
                _ => None,
            }
        };
        let counts = places.iter().map(count).collect::<Option<Vec<u32>>>()?;
        counts.into_iter().max()
    }

    /// The values in all slots.
    fn values(&self, variables: &[f64]) -> Vec<f64> {
        let code = &self.0.whole;
        let count = code.instructions.len();
        let mut results = vec![0.0; count];
        code.run(0..count, variables, variables.len(), (&mut results, 0));
        [variables, &results].concat()
    }

    /// How the whole depends on x, v and t; in a forcing period the value in a slot that depends on time
    /// alone makes `turns`.
    fn dependence(&self, turns: impl Fn(Slot) -> f64) -> Dependence {
        let wave = |slot: Slot| {
            let turns = turns(slot).abs();
            let whole = libm::round(turns);
            let is_whole = (turns - whole).abs() < ROUNDING && whole <= f64::from(MOST_HARMONICS);
            if is_whole { Waves { multiple: whole as u32, moves: false } } else { Other }
        };
        let code = &self.0.whole;
        let variable = |slot: Slot| match slot {
            TIME => Time,
            slot if slot < MOVING => Waves { multiple: 0, moves: true },
            _ => Fixed,
        };
        let mut known: Vec<Dependence> = (0..self.0.variables.len()).map(variable).collect();
        for instruction in &code.instructions {
            let of = |slot: &Slot| known[*slot];
            known.push(match instruction {
                Instruction::Sum { start, end, .. } => {
                    code.terms[*start..*end].iter().fold(Fixed, |sum, (_, slot)| sum.plus(of(slot)))
                }
                Instruction::Plain(operation) => match operation {
                    Operation::Constant(_) => Fixed,
                    Operation::Add(a, b) | Operation::Subtract(a, b) => of(a).plus(of(b)),
                    Operation::Shift(a, _) | Operation::Negate(a) | Operation::Scale(a, _) => of(a),
                    Operation::Multiply(a, b) => of(a).times(of(b)),
                    Operation::Divide(a, b) if of(b) == Fixed => of(a),
                    Operation::Square(a) => of(a).times(of(a)),
                    Operation::Power(a, exponent @ 1..) => {
                        (1..*exponent).fold(of(a), |power, _| power.times(of(a)))
                    }
                    Operation::Apply(Function::Sin | Function::Cos, a) if of(a) == Time => wave(*a),
                    other if other.operands().iter().all(|slot| of(slot) == Fixed) => Fixed,
                    _ => Other,
                },
            });
        }
        known[code.results[0]]
    }
}
