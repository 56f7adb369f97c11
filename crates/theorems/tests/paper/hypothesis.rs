//! Hypotheses in other units.

use grazing_theorems::hypothesis::{Condition, Hypothesis, Quantity};

#[test]
fn a_hypothesis_holds_or_not_in_any_units() {
    let zero = Condition::Zero { tolerance: 1e-6 };
    for (value, condition, holds) in [
        (5e-7, zero, true),
        (-2e-6, zero, false),
        (3e-9, Condition::Positive, true),
        (-3e9, Condition::NonZero, true),
    ] {
        let hypothesis = Hypothesis { quantity: Quantity::OffDiagonal, value, condition };
        for unit in [1e-6, 1.0, 1e6] {
            assert_eq!(hypothesis.in_units_of(unit).holds(), holds, "{hypothesis:?} in {unit}");
        }
    }
}
