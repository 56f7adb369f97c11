//! Cells of tables.

use std::borrow::Cow;

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_continuation::mps::Multipliers;

use crate::Field;

/// One cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Text.
    Text(Cow<'static, str>),
    /// A count or an index.
    Integer(u32),
    /// A number; NaN and infinities are written as empty cells.
    Number(f64),
    /// Yes or no.
    Flag(bool),
    /// The verdict on a case, a word, with what it means.
    Verdict(&'static str, Tone),
}

impl Cell {
    /// The text, if the cell is a text or a verdict.
    pub fn text(&self) -> Option<&str> {
        match self {
            Self::Text(words) => Some(words),
            Self::Verdict(word, _) => Some(word),
            Self::Integer(_) | Self::Number(_) | Self::Flag(_) => None,
        }
    }

    /// The number, if the cell is a finite number. Negative zero becomes zero.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(value) => value.is_finite().then_some(value + 0.0),
            _ => None,
        }
    }
}

/// What a verdict means for what was tested.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// It holds.
    Passed,
    /// It does not hold.
    Failed,
    /// It is left open.
    Unchecked,
}

impl Tone {
    /// The word for it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::Unchecked => "unchecked",
        }
    }
}

/// Conversions of values into cells.
macro_rules! cells {
    ($($type:ty: |$value:ident| $cell:expr,)+) => {$(
        impl From<$type> for Cell {
            fn from($value: $type) -> Self {
                $cell
            }
        }
    )+};
}

cells! {
    &'static str: |words| Self::Text(words.into()),
    String: |words| Self::Text(words.into()),
    u32: |count| Self::Integer(count),
    f64: |number| Self::Number(number),
    bool: |yes| Self::Flag(yes),
    Bifurcation: |kind| kind.name().into(),
    CodimensionTwo: |kind| kind.name().into(),
}

impl Field for &'static str {}
impl Field for String {}
impl Field for u32 {}
impl Field for bool {}
impl Field for Bifurcation {}
impl Field for CodimensionTwo {}
impl Field for Stability {}

/// Whether nearby motion approaches a solution: in tables `true`, `false` or, where it neither approaches nor
/// leaves, `neutral`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// Nearby motion approaches.
    Stable,
    /// It leaves, at least in some direction.
    Unstable,
    /// It does neither, as without damping.
    Neutral,
}

impl Stability {
    /// The stability of a solution with these multipliers.
    pub fn of(multipliers: Multipliers) -> Self {
        match multipliers.neutral() {
            true => Self::Neutral,
            false => multipliers.stable().into(),
        }
    }

    /// The stability in a word.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Unstable => "unstable",
            Self::Neutral => "neutral",
        }
    }

    /// Whether nearby motion approaches.
    pub fn is_stable(self) -> bool {
        self == Self::Stable
    }
}

impl From<bool> for Stability {
    fn from(stable: bool) -> Self {
        if stable { Self::Stable } else { Self::Unstable }
    }
}

impl From<Stability> for Cell {
    fn from(stability: Stability) -> Self {
        match stability {
            Stability::Neutral => stability.name().into(),
            other => other.is_stable().into(),
        }
    }
}

/// Enumerations whose variants appear in tables as words. The word documents the variant; further
/// documentation is optional.
#[macro_export]
macro_rules! words {
    ($($(#[$meta:meta])* $name:ident { $($(#[$about:meta])* $variant:ident = $word:literal,)+ })+) => {$(
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $name { $(#[doc = concat!("`", $word, "`")] $(#[$about])* $variant,)+ }

        impl $name {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$variant,)+];

            /// The word in tables.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $word,)+ }
            }
        }

        impl $crate::Field for $name {}

        impl From<$name> for $crate::Cell {
            fn from(value: $name) -> Self {
                value.name().into()
            }
        }
    )+};
}

/// The value with at most this many significant digits and no trailing zeros, as `0.5` or `-1.25e-9`.
pub fn brief(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits - 1).parse().unwrap_or(value);
    // Adding zero turns -0 into 0.
    let rounded = rounded + 0.0;
    if rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs()) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}
