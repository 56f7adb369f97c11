//! Hypotheses of the theorems: a named quantity, its value, and the condition that the theorem
//! imposes on it.

use core::fmt;

use thiserror::Error;

/// Defines enumerations that are displayed in words: each variant with its own words, and an
/// optional comment.
macro_rules! shown {
    ($($(#[$meta:meta])* $name:ident { $($(#[$doc:meta])* $variant:ident = $words:literal,)+ })+) => {$(
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum $name { $(#[doc = concat!("`", $words, "`")] $(#[$doc])* $variant,)+ }

        impl fmt::Display for $name {
            fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter.write_str(match self { $(Self::$variant => $words,)+ })
            }
        }
    )+};
}

shown! {
    /// A theorem of the paper.
    Theorem {
        /// Paper: `th:codim11`.
        GenericOneLoop = "theorem 2.2 (generic grazing, p = 1)",
        /// Paper: `th:codim1p`.
        GenericMultiLoop = "theorem 2.3 (generic grazing, p >= 2)",
        /// Paper: `th:codim21`.
        ResonantOneLoop = "theorem 2.4 (resonant grazing, p = 1)",
        /// Paper: `th:codim2p`.
        ResonantMultiLoop = "theorem 2.5 (resonant grazing, p >= 2)",
    }

    /// A quantity about which a theorem makes a hypothesis; displayed as its symbol.
    Quantity {
        /// The number of loops.
        Loops = "p",
        /// The forcing frequency.
        ForcingFrequency = "omega",
        /// The deceleration at grazing: the grazing point belongs to the grazing set.
        Deceleration = "gamma",
        /// The coefficient of restitution at zero impact velocity.
        Restitution = "phi",
        /// The determinant: the lower side of the trapesium.
        Determinant = "delta",
        /// The upper side of the trapesium.
        Contraction = "1 - delta",
        /// The slanted sides of the trapesium.
        StabilityMargin = "delta + 1 - |tau|",
        /// The factor of the square-root term.
        SquareRootFactor = "alpha",
        OffDiagonalTimesSquareRootFactor = "a12 alpha",
        AdmissibilityMargin = "tau - h_p(delta)",
        OffDiagonalTimesTransversality = "a12 beta",
        TransversalityTimesDetuning = "beta kappa_p",
        /// The transversality coefficient.
        Transversality = "beta",
        OffDiagonal = "a12",
        OffDiagonalDerivative = "a12'",
        Detuning = "kappa_p",
        DetuningDerivative = "kappa_p'",
        SaddleNodeStability = "s_p^+",
        PeriodDoublingStability = "s_p^-",
    }
}

/// A condition that a theorem imposes on a quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ImposedCondition {
    /// At least this number.
    AtLeast(u32),
    /// Greater than zero and finite.
    Positive,
    /// Finite and not zero.
    NonZero,
    /// Zero to the accuracy of floating-point numbers: the modulus is at most `tolerance`.
    Zero {
        /// The largest modulus that counts as zero.
        tolerance: f64,
    },
}

/// A quantity, its value, and the condition that the theorem imposes on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hypothesis {
    /// The quantity.
    pub quantity: Quantity,
    /// The value of the quantity.
    pub value: f64,
    /// The condition that the theorem imposes.
    pub condition: ImposedCondition,
}

impl Hypothesis {
    pub(crate) fn new(quantity: Quantity, value: f64, condition: ImposedCondition) -> Self {
        Self { quantity, value, condition }
    }

    pub(crate) fn positive(quantity: Quantity, value: f64) -> Self {
        Self::new(quantity, value, ImposedCondition::Positive)
    }

    pub(crate) fn non_zero(quantity: Quantity, value: f64) -> Self {
        Self::new(quantity, value, ImposedCondition::NonZero)
    }

    /// The condition as text, such as "a12 alpha > 0".
    pub fn statement(&self) -> String {
        let quantity = self.quantity;
        match self.condition {
            ImposedCondition::AtLeast(bound) => format!("{quantity} >= {bound}"),
            ImposedCondition::Positive => format!("{quantity} > 0"),
            ImposedCondition::NonZero => format!("{quantity} != 0"),
            ImposedCondition::Zero { .. } => format!("{quantity} = 0"),
        }
    }

    /// Whether the value satisfies the condition; NaN never does.
    pub fn holds(&self) -> bool {
        self.value.is_finite()
            && match self.condition {
                ImposedCondition::AtLeast(bound) => self.value >= f64::from(bound),
                ImposedCondition::Positive => self.value > 0.0,
                ImposedCondition::NonZero => self.value != 0.0,
                ImposedCondition::Zero { tolerance } => self.value.abs() <= tolerance,
            }
    }
}

impl fmt::Display for Hypothesis {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { quantity, value, condition } = self;
        formatter.write_str(&self.statement())?;
        if let ImposedCondition::Zero { tolerance } = condition {
            write!(formatter, " (within {tolerance:e})")?;
        }
        write!(formatter, ", where {quantity} is {value}")
    }
}

/// The reason why a theorem does not apply to a point: the theorem and all of its hypotheses, at
/// least one of which fails.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{theorem} does not apply: it needs {}", list(self.violated()))]
pub struct HypothesesViolated {
    /// The theorem.
    pub theorem: Theorem,
    /// All hypotheses that could be evaluated, in the order in which the theorem states them.
    pub hypotheses: Vec<Hypothesis>,
}

impl HypothesesViolated {
    /// The hypotheses that fail; at least one.
    pub fn violated(&self) -> impl Iterator<Item = &Hypothesis> {
        self.hypotheses.iter().filter(|hypothesis| !hypothesis.holds())
    }
}

fn list<'a>(hypotheses: impl Iterator<Item = &'a Hypothesis>) -> String {
    hypotheses.map(ToString::to_string).collect::<Vec<_>>().join("; ")
}

/// Returns the hypotheses if all of them hold, otherwise an error that names those that fail.
pub(crate) fn check(
    theorem: Theorem,
    hypotheses: Vec<Hypothesis>,
) -> Result<Vec<Hypothesis>, HypothesesViolated> {
    if hypotheses.iter().all(Hypothesis::holds) {
        Ok(hypotheses)
    } else {
        Err(HypothesesViolated { theorem, hypotheses })
    }
}
