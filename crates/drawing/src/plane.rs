//! A plane of two parameters: which columns hold them, and how they are written.

use crate::DrawingError;
use crate::frames::Table;
use crate::markup::GREEK;

/// One of the two parameters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Axis<'a> {
    /// The column of the frames that holds it.
    pub column: &'a str,
    /// The axis title, in the markup of labels (`$\omega$` is a Greek letter).
    pub title: String,
}

/// The two parameters over which bifurcation curves are drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Plane<'a> {
    /// The primary parameter, on the horizontal axis.
    pub across: Axis<'a>,
    /// The secondary parameter, on the vertical axis.
    pub up: Axis<'a>,
    /// The name of the grazing curve of the non-impacting solution, in the markup of labels.
    pub grazing: String,
}

impl<'a> Plane<'a> {
    /// The plane of two parameters whose columns bear their names; titles are as [`parameter_title`] makes them, and the
    /// grazing curve is named after the primary parameter.
    ///
    /// `primary` and `secondary` are names such as `A`, `omega_2` or `amplitude`.
    pub fn of_parameters(primary: &'a str, secondary: &'a str) -> Self {
        let axis = |name: &'a str| Axis { column: name, title: parameter_title(name) };
        let grazing = match Symbol::read(primary) {
            Some(symbol) if !symbol.is_word() => symbol.lowered(&["graz"]).markup(),
            _ => "grazing".to_owned(),
        };
        Plane { across: axis(primary), up: axis(secondary), grazing }
    }

    /// The points (across, up) of a table, in the order of its rows.
    pub(crate) fn points(&self, table: Table<'_>) -> Result<Vec<(f64, f64)>, DrawingError> {
        let (up, across) = (table.numbers(self.up.column)?, table.numbers(self.across.column)?);
        Ok(across.into_iter().zip(up).collect())
    }
}

/// A parameter's name as a label.
///
/// Names of Greek letters become these letters, single letters are italic, longer words upright. What follows an
/// underscore, and digits at the end of a part, is a subscript: `F_0` and `F0`, `omega_max`. Words joined by underscores
/// stay words: `forcing_amplitude`.
///
/// `name` is an identifier of ASCII letters, digits and underscores; any other is printed as it stands, without `$`.
pub fn parameter_title(name: &str) -> String {
    match Symbol::read(name) {
        Some(symbol) => symbol.markup(),
        None => name.replace('$', ""),
    }
}

/// A name taken apart.
struct Symbol<'a> {
    /// The letter, or the words.
    base: Vec<&'a str>,
    lowered: Vec<&'a str>,
}

impl<'a> Symbol<'a> {
    fn read(name: &'a str) -> Option<Self> {
        if !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
            return None;
        }
        let mut parts = name.split('_').filter(|part| !part.is_empty());
        let (letters, digits) = without_digits(parts.next().filter(|head| !starts_with_digit(head))?);
        let mut symbol = Symbol { base: vec![letters], lowered: Vec::new() };
        symbol.lowered.extend(digits);
        for part in parts {
            let (letters, digits) = without_digits(part);
            if symbol.is_word() && symbol.lowered.is_empty() && is_word(letters) && !starts_with_digit(part) {
                symbol.base.push(letters);
                symbol.lowered.extend(digits);
            } else {
                symbol.lowered.push(part);
            }
        }
        Some(symbol)
    }

    /// The same with further subscripts.
    fn lowered(mut self, further: &[&'a str]) -> Self {
        self.lowered.extend(further);
        self
    }

    fn is_word(&self) -> bool {
        self.base.iter().all(|part| is_word(part))
    }

    fn markup(&self) -> String {
        let base = if self.is_word() {
            format!(r"\mathrm{{{}}}", self.base.join(" "))
        } else {
            self.base.iter().map(|part| letters(part)).collect()
        };
        if self.lowered.is_empty() {
            return format!("${base}$");
        }
        let lowered: Vec<String> = self
            .lowered
            .iter()
            .map(|part| {
                let (head, digits) = without_digits(part);
                format!("{}{}", letters(head), digits.unwrap_or_default())
            })
            .collect();
        format!("${base}_{{{}}}$", lowered.join(","))
    }
}

/// The part without the digits at its end, and these digits if there are any; a part of digits alone is all digits.
fn without_digits(part: &str) -> (&str, Option<&str>) {
    let letters = part.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &part[letters.len()..];
    (letters, (!digits.is_empty()).then_some(digits))
}

fn starts_with_digit(part: &str) -> bool {
    part.starts_with(|c: char| c.is_ascii_digit())
}

fn is_greek(part: &str) -> bool {
    GREEK.iter().any(|(name, ..)| *name == part)
}

/// Neither a single letter nor the name of a Greek one.
fn is_word(part: &str) -> bool {
    part.len() > 1 && !is_greek(part)
}

/// A part without digits at its end, as markup within `$`.
fn letters(part: &str) -> String {
    match part {
        greek if is_greek(greek) => format!(r"\{greek}"),
        word if is_word(word) => format!(r"\mathrm{{{word}}}"),
        letter => letter.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::markup::Label;

    #[test]
    fn names_become_letters_words_and_subscripts() {
        for (name, title) in [
            ("A", "$A$"),
            ("omega", r"$\omega$"),
            ("Omega", r"$\Omega$"),
            ("F_0", "$F_{0}$"),
            ("F0", "$F_{0}$"),
            ("omega_2", r"$\omega_{2}$"),
            ("omega12", r"$\omega_{12}$"),
            ("kappa_max", r"$\kappa_{\mathrm{max}}$"),
            ("F_0_x", "$F_{0,x}$"),
            ("k_x1", "$k_{x1}$"),
            ("x_omega", r"$x_{\omega}$"),
            ("amplitude", r"$\mathrm{amplitude}$"),
            ("amplitude_2", r"$\mathrm{amplitude}_{2}$"),
            ("forcing_amplitude", r"$\mathrm{forcing amplitude}$"),
            ("mass_ratio2", r"$\mathrm{mass ratio}_{2}$"),
            ("max_F", r"$\mathrm{max}_{F}$"),
            ("_a__b_", "$a_{b}$"),
            ("_", "_"),
            ("_1", "_1"),
        ] {
            assert_eq!(parameter_title(name), title, "{name}");
        }
    }

    #[test]
    fn no_name_makes_a_title_that_is_not_markup() {
        let alphabet = ["a", "omega", "mass", "_", "0", "12", "$", "{", "\\", "ω", " "];
        for first in alphabet {
            for second in alphabet {
                for third in alphabet {
                    let title = parameter_title(&format!("{first}{second}{third}"));
                    assert!(Label::parse(&title).is_ok(), "{title}");
                }
            }
        }
    }

    #[test]
    fn the_grazing_curve_is_named_after_the_primary_parameter_if_that_has_a_symbol() {
        let name = |primary| Plane::of_parameters(primary, "omega").grazing;
        assert_eq!(name("A"), r"$A_{\mathrm{graz}}$");
        assert_eq!(name("F_0"), r"$F_{0,\mathrm{graz}}$");
        assert_eq!(name("amplitude"), "grazing");
    }
}
