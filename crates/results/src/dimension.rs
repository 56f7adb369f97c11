//! The dimensions of numbers, and rows and other results in other units.

mod theory;

use grazing_model::smooth::Units;

/// What the numbers of a column are made of: the exponents of length, time, mass and the two parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    exponents: [i8; WORDS.len()],
}

/// The words of units, in the order of the exponents.
const WORDS: [&str; 5] = ["length", "time", "mass", "{primary}", "{secondary}"];
/// Words that have no dimension. Numbers in a unit of their own, which rows say or the file does, are not converted with the others.
const WITHOUT: [&str; 4] = ["1", "rad", "as in the file", "that of the quantity"];

impl Dimension {
    /// The dimension of a unit, such as `mass*length^2/time^3`.
    ///
    /// # Panics
    /// A word is not known; for a column this is an error of the compiler.
    #[must_use]
    pub const fn of(unit: &str) -> Self {
        let mut exponents = [0; WORDS.len()];
        if place(unit.as_bytes(), 0, unit.len(), &WITHOUT).is_some() {
            return Self { exponents };
        }
        let text = unit.as_bytes();
        let (mut begin, mut sign) = (0, 1);
        while begin < text.len() {
            let mut end = begin;
            while end < text.len() && !matches!(text[end], b'*' | b'/' | b' ' | b'^') {
                end += 1;
            }
            let mut power = 1;
            let mut next = end;
            if end < text.len() && text[end] == b'^' {
                assert!(end + 1 < text.len() && text[end + 1].is_ascii_digit(), "a digit follows ^");
                power = (text[end + 1] - b'0') as i8;
                next = end + 2;
            }
            match place(text, begin, end, &WORDS) {
                Some(word) => exponents[word] += sign * power,
                None => assert!(place(text, begin, end, &WITHOUT).is_some(), "this word is no unit"),
            }
            if next < text.len() {
                sign = if text[next] == b'/' { -1 } else { 1 };
                next += 1;
            }
            begin = next;
        }
        Self { exponents }
    }

    /// Whether the mass enters.
    #[must_use]
    pub fn has_mass(self) -> bool {
        self.exponents.iter().zip(WORDS).any(|(exponent, word)| word == "mass" && *exponent != 0)
    }

    /// Which of the two parameters numbers of this dimension are values of: 0 for the primary one, 1 for the secondary.
    fn parameter(self) -> Option<usize> {
        [Self::of("{primary}"), Self::of("{secondary}")].iter().position(|parameter| *parameter == self)
    }

    /// The size of the unit of such numbers. The mass is counted in a unit of its own.
    #[must_use]
    pub fn size(self, units: &Units) -> f64 {
        let sizes = [units.length, units.time, 1.0, units.primary, units.secondary];
        let powers = sizes.into_iter().zip(self.exponents);
        powers.fold(1.0, |size, (unit, exponent)| {
            let power = (0..exponent.unsigned_abs()).fold(1.0, |power, _| power * unit);
            if exponent < 0 { size / power } else { size * power }
        })
    }
}

/// The place of a part of a text in a list of words.
const fn place(text: &[u8], begin: usize, end: usize, words: &[&str]) -> Option<usize> {
    let mut which = 0;
    while which < words.len() {
        let word = words[which].as_bytes();
        let mut same = 0;
        while begin + same < end && same < word.len() && text[begin + same] == word[same] {
            same += 1;
        }
        if begin + same == end && same == word.len() {
            return Some(which);
        }
        which += 1;
    }
    None
}

/// A result that knows the dimensions of its numbers: a row from their columns ([`rows!`](crate::rows)), any other as
/// it is declared ([`dimensioned!`](crate::dimensioned)).
pub trait Dimensioned {
    /// Visits every number with its dimension.
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64));

    /// Exchanges the values of the two parameters, with their errors: a result has as many numbers of one as of the
    /// other.
    fn exchange(&mut self) {
        let mut values = [const { Vec::new() }; 2];
        self.each_number(&mut |dimension, number| {
            if let Some(which) = dimension.parameter() {
                values[which].push(*number);
            }
        });
        let mut others = values.map(Vec::into_iter);
        others.reverse();
        self.each_number(&mut |dimension, number| {
            if let Some(value) = dimension.parameter().and_then(|which| others[which].next()) {
                *number = value;
            }
        });
    }

    /// A dimensionless result in these units.
    #[must_use]
    fn with_dimensions(mut self, units: &Units) -> Self
    where
        Self: Sized,
    {
        self.each_number(&mut |dimension, number| *number *= dimension.size(units));
        self
    }

    /// A result in these units without dimensions.
    #[must_use]
    fn without_dimensions(mut self, units: &Units) -> Self
    where
        Self: Sized,
    {
        self.each_number(&mut |dimension, number| *number /= dimension.size(units));
        self
    }
}

impl<T: Dimensioned> Dimensioned for Option<T> {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        self.iter_mut().for_each(|one| one.each_number(visit));
    }
}

impl<T: Dimensioned> Dimensioned for Vec<T> {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        self.iter_mut().for_each(|one| one.each_number(visit));
    }
}

/// Declares the units of the numbers of results that are no rows: each number that has one, with it, and without one each
/// part that is itself [`Dimensioned`].
///
/// `dimensioned! { Escape, |own| { own.time => "time", own.position => "length", } }`
#[macro_export]
macro_rules! dimensioned {
    (@ $visit:ident, $number:expr, $unit:literal) => {
        $visit(const { $crate::Dimension::of($unit) }, &mut $number)
    };
    (@ $visit:ident, $part:expr) => { $crate::Dimensioned::each_number(&mut $part, $visit) };
    ($($type:ty, |$own:ident| { $($number:expr $(=> $unit:literal)?,)+ })+) => {$(
        impl $crate::Dimensioned for $type {
            fn each_number(&mut self, visit: &mut dyn FnMut($crate::Dimension, &mut f64)) {
                let $own = self;
                $($crate::dimensioned!(@ visit, $number $(, $unit)?);)+
            }
        }
    )+};
}

/// What a field of a row holds: a number, or something without dimension.
pub trait Field {
    /// Visits the number, if it is one.
    fn number(&mut self, visit: &mut dyn FnMut(&mut f64)) {
        let _ = visit;
    }
}

impl Field for f64 {
    fn number(&mut self, visit: &mut dyn FnMut(&mut f64)) {
        visit(self);
    }
}
