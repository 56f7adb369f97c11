//! The numbers that the paper prints.

use askama::filters::Safe;

use crate::formula::greek;
use crate::html::{Html, escape, number, plain};

/// Digits of a computed number beside a printed one, which has four or five.
const COMPUTED_DIGITS: usize = 8;

/// A computed number beside a printed one; one with few digits, such as a parameter, keeps them.
pub(crate) fn computed(value: &f64) -> Html {
    let whole = plain(value);
    if value.to_string().len() <= COMPUTED_DIGITS { Safe(whole) } else { number(value, COMPUTED_DIGITS) }
}

/// A quantity written in ASCII, as HTML: Greek names become letters and `_` lowers what follows.
pub(crate) fn symbols(quantity: &str) -> Html {
    let words: Vec<String> = quantity
        .split(' ')
        .map(|word| {
            let (bare, comma) = word.strip_suffix(',').map_or((word, ""), |bare| (bare, ","));
            let italic = |text: &str| {
                if text.len() == 1 && text.chars().all(char::is_alphabetic) {
                    format!("<i>{}</i>", escape(text))
                } else {
                    escape(text)
                }
            };
            match (greek(bare), bare.split_once('_')) {
                (Some(letter), _) => format!("{letter}{comma}"),
                (None, Some(("A", low))) => format!("𝒜<sub>{}</sub>{comma}", escape(low)),
                (None, Some((base, low))) => format!("{}<sub>{}</sub>{comma}", italic(base), escape(low)),
                (None, None) => format!("{}{comma}", italic(bare)),
            }
        })
        .collect();
    Safe(words.join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_read_as_in_print() {
        assert_eq!(symbols("c_SN,1, n = 3").0, "<i>c</i><sub>SN,1</sub>, <i>n</i> = 3");
        assert_eq!(symbols("A_graz of Figure 2").0, "𝒜<sub>graz</sub> of Figure 2");
        assert_eq!(symbols("omega, p < 1").0, "ω, <i>p</i> &lt; 1");
    }
}
