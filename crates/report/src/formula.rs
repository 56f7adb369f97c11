//! Formulas: LaTeX in, MathML out.

use grazing_results::title::without_ties;
use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

use askama::filters::Safe;
use grazing_results::GREEK;

use crate::html::{Html, escape};

/// A formula that could not be understood.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{latex}: {reason}")]
pub struct FormulaError {
    /// The LaTeX.
    pub latex: String,
    /// The fault in it, as the converter reports it.
    pub reason: String,
}

/// The formula as MathML: displayed on lines of its own, or in a line of text.
///
/// # Errors
/// [`FormulaError`] for commands that are not standard and for unbalanced braces.
pub fn mathml(latex: &str, displayed: bool) -> Result<String, FormulaError> {
    let prepared = prepared(latex);
    let storage = Storage::new();
    let mut events = Vec::new();
    for event in Parser::new(&prepared, &storage) {
        match event {
            Ok(event) => events.push(Ok::<_, std::convert::Infallible>(event)),
            Err(error) => {
                let message = error.to_string();
                let reason = message.lines().next().unwrap_or_default().to_owned();
                return Err(FormulaError { latex: latex.to_owned(), reason });
            }
        }
    }
    let display_mode = if displayed { DisplayMode::Block } else { DisplayMode::Inline };
    let mut text = String::new();
    push_mathml(&mut text, events.into_iter(), RenderConfig { display_mode, ..RenderConfig::default() })
        .map_err(|error| FormulaError { latex: latex.to_owned(), reason: error.to_string() })?;
    // The converter escapes its own entities, leaves relations unescaped, and writes the micro sign
    // for the letter mu.
    let tidied = text.replace("&amp;nbsp;", "\u{a0}").replace('\u{b5}', "\u{3bc}");
    let tidied = spaced_outside(tidied);
    Ok(tidied.replace("><</mo>", ">&lt;</mo>").replace(">></mo>", ">&gt;</mo>"))
}

/// The MathML with the space before an operator in front of its scripts, and not among them as the converter
/// puts it for `2 \sin^2`, where it would be the operator that is raised to a power.
fn spaced_outside(mut text: String) -> String {
    for scripts in ["<msup>", "<msub>", "<msubsup>", "<mover>", "<munder>", "<munderover>"] {
        let wrong = format!("{scripts}<mspace");
        while let Some(start) = text.find(&wrong) {
            let space = start + scripts.len();
            let Some(length) = text[space..].find('>') else { break };
            let moved = format!("{}{scripts}", &text[space..=space + length]);
            text.replace_range(start..=space + length, &moved);
        }
    }
    text
}

/// Words with formulas between dollars, as HTML; a formula that cannot be parsed is shown as its
/// source. In the words, `_` after a single letter lowers what follows, and `^` raises it.
pub(crate) fn prose(text: &str) -> Html {
    let mut html = String::new();
    for (index, piece) in without_ties(text).split('$').enumerate() {
        if index % 2 == 0 {
            html.push_str(&with_code(piece));
        } else {
            html.push_str(&shown(piece, false).0);
        }
    }
    Safe(html)
}

/// Words with code between backticks.
fn with_code(words: &str) -> String {
    let pieces = words.split('`').enumerate();
    let shown = |(index, piece): (usize, &str)| match index % 2 {
        0 => scripts(&escape(piece)),
        _ => format!("<code>{}</code>", escape(piece)),
    };
    pieces.map(shown).collect()
}

/// Words without formulas, as HTML, with sub- and superscripts as in [`prose`].
pub(crate) fn words(text: &str) -> Html {
    Safe(scripts(&escape(text)))
}

/// The Greek letter with a name; epsilon is written as in the paper.
pub(crate) fn greek(name: &str) -> Option<char> {
    let name = if name == "epsilon" { "varepsilon" } else { name };
    GREEK.iter().find(|(known, _)| *known == name).map(|(_, letter)| *letter)
}

/// Words with names of quantities, as HTML: `tau = g_p(delta)`, `a12 alpha > 0`. Names of Greek
/// letters become letters, digits after a letter and anything after `_` are lowered; words stay.
pub(crate) fn named(text: &str) -> Html {
    words(&signs(text))
}

/// Words with names of quantities as in [`named`], and formulas between dollars.
pub(crate) fn described(text: &str) -> Html {
    let text = without_ties(text);
    let pieces = text.split('$').enumerate();
    Safe(
        pieces
            .map(|(index, piece)| if index % 2 == 0 { named(piece).0 } else { shown(piece, false).0 })
            .collect(),
    )
}

/// Words with names of quantities as in [`named`], without markup.
pub(crate) fn signs(text: &str) -> String {
    let low = |digit: char| {
        digit.to_digit(10).and_then(|digit| char::from_u32(u32::from('₀') + digit)).unwrap_or(digit)
    };
    let mut signs = String::new();
    for word in grazing_results::words(&text.replace("->", "→"), &[]) {
        let (letters, digits) = word.split_at(word.find(|c: char| c.is_ascii_digit()).unwrap_or(word.len()));
        let known = greek(letters);
        match known {
            Some(letter) => signs.push(letter),
            // A minus sign between quantities or before one, not a hyphen.
            None if word == "-" && signs.ends_with([' ', '(', '|']) => signs.push('−'),
            None => signs.push_str(letters),
        }
        let letter = known.is_some() || letters.len() == 1;
        if !digits.is_empty() {
            let lowered = letter && letters.chars().all(char::is_alphabetic);
            signs.extend(digits.chars().map(|digit| if lowered { low(digit) } else { digit }));
        }
    }
    signs
}

/// The escaped text with sub- and superscripts: `h_p`, `c_{SN,1}`, `s_p^+`. Names of several
/// letters, such as those of functions, stay.
fn scripts(text: &str) -> String {
    let mut html = String::new();
    let (mut last, mut before_last) = (' ', ' ');
    let mut rest = text;
    while let Some(character) = rest.chars().next() {
        rest = &rest[character.len_utf8()..];
        let single = last.is_alphabetic() && !before_last.is_alphanumeric() && before_last != '_';
        let (element, possible) = match character {
            '_' => ("sub", single),
            '^' => ("sup", last.is_alphanumeric() || last == ')'),
            _ => ("", false),
        };
        let (script, after) = if possible { script(rest) } else { ("", rest) };
        if script.is_empty() {
            html.push(character);
            (before_last, last) = (last, character);
        } else {
            html.push_str(&format!("<{element}>{script}</{element}>"));
            // A superscript may follow a subscript, on the same letter.
            rest = after;
        }
    }
    html
}

/// The text that a script mark applies to, in braces, or as far as letters and digits reach, or one
/// sign; and the text after it.
fn script(text: &str) -> (&str, &str) {
    if let Some((script, after)) = text.strip_prefix('{').and_then(|inner| inner.split_once('}')) {
        return (script, after);
    }
    let end = match text.chars().next() {
        Some(sign @ ('+' | '−' | '±' | '∓' | '*')) => sign.len_utf8(),
        _ => text.find(|character: char| !character.is_alphanumeric()).unwrap_or(text.len()),
    };
    text.split_at(end)
}

/// The formula, or its source if it cannot be parsed.
pub(crate) fn shown(latex: &str, displayed: bool) -> Html {
    Safe(mathml(latex, displayed).unwrap_or_else(|_| format!("<code>{}</code>", escape(latex))))
}

/// The formula without constructs that the converter does not know: third derivatives as dots, and
/// dollars in `\text`.
fn prepared(latex: &str) -> String {
    let plain = latex.replace("\\dddot", "\\overset{\\dots}");
    let mut prepared = String::new();
    let mut rest = plain.as_str();
    while let Some(start) = rest.find("\\text{") {
        let inner = start + "\\text{".len();
        let Some(length) = rest[inner..].find('}') else {
            break;
        };
        // The first dollar ends the text, the second begins the next one, and so on.
        prepared.push_str(&rest[..inner]);
        for (index, piece) in rest[inner..inner + length].split('$').enumerate() {
            prepared.push_str(match index % 2 {
                _ if index == 0 => "",
                1 => "}",
                _ => "\\text{",
            });
            prepared.push_str(piece);
        }
        rest = &rest[inner + length..];
    }
    prepared.push_str(rest);
    prepared
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_become_elements_and_signs_are_escaped() {
        let formula = mathml(r"\tau < 2\sqrt{\delta}", true).unwrap();
        assert!(
            formula.starts_with("<math") && formula.contains("<msqrt>") && formula.contains("&lt;"),
            "{formula}"
        );
    }

    #[test]
    fn a_power_of_an_operator_raises_the_operator() {
        for (latex, displayed, scripts) in [
            (r"2\sin^2(x)", false, "<msup><mi>sin</mi><mn>2</mn></msup>"),
            (r"2\log_2 x", false, "<msub><mi>log</mi><mn>2</mn></msub>"),
            (r"2\max_x y", false, "<msub><mi>max</mi><mi>x</mi></msub>"),
            (r"2\max_x y", true, "<munder><mi>max</mi><mi>x</mi></munder>"),
            (r"2\max_x^2 y", true, "<munderover><mi>max</mi><mi>x</mi><mn>2</mn></munderover>"),
        ] {
            let formula = mathml(latex, displayed).unwrap();
            assert!(formula.contains(&format!("<mspace width=\"0.1667em\" />{scripts}")), "{formula}");
        }
    }

    #[test]
    fn what_cannot_be_understood_is_an_error_and_is_shown_as_it_stands() {
        let error = mathml(r"\nosuchcommand{x}", false).unwrap_err();
        assert!(error.to_string().contains("nosuchcommand"), "{error}");
        assert_eq!(prose(r"a < $\nosuchcommand$").0, r"a &lt; <code>\nosuchcommand</code>");
    }

    #[test]
    fn words_have_sub_and_superscripts_and_names_of_functions_stay() {
        assert_eq!(
            prose("h_p < g_{p,1} and s_p^+ = η^2").0,
            "h<sub>p</sub> &lt; g<sub>p,1</sub> and s<sub>p</sub><sup>+</sup> = η<sup>2</sup>"
        );
        for text in ["grazing_theorems::from_map", "a _ b", "f_", "2^"] {
            assert_eq!(prose(text).0, text);
        }
    }

    #[test]
    fn quantities_have_their_letters_and_words_stay() {
        for (text, html) in [
            (
                "tau = g_p(delta), the p-loop solution of Figure 2 at x = -1.",
                "τ = g<sub>p</sub>(δ), the p-loop solution of Figure 2 at x = −1.",
            ),
            (
                "period-one, pages 475-502: x' -> -r x' + omega",
                "period-one, pages 475-502: x&#39; → −r x&#39; + ω",
            ),
            ("a12 alpha > 0 of e12", "a₁₂ α &gt; 0 of e₁₂"),
            ("delta + 1 - |tau| > 0", "δ + 1 − |τ| &gt; 0"),
            ("period-doubling beta1", "period-doubling β₁"),
        ] {
            assert_eq!(named(text).0, html);
        }
    }

    #[test]
    fn the_paper_s_habits_are_understood() {
        for latex in [
            r"z = \omega(\mu) t ~{\rm mod}~ 2\pi",
            r"\frac{\dot{\phi} \dddot{\phi}}{\ddot{\phi}}",
            r"y \mapsto -\epsilon y \qquad \text{when $x = 0$ with $y > 0$}",
            r"\begin{aligned} a &= b, \\ c &= \begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} \end{aligned}",
            r"\left\{ (\tau,\delta) \in \mathbb{R}^2 \,\middle|\, 0 < \delta < 1 \right\}",
            r"\frac{\partial \xi}{\partial z} \bigg|_{(x,z)=(0,z_{{\rm graz},0})} + \mathcal{O} \big( y^2 \big)",
        ] {
            let formula = mathml(latex, true).unwrap();
            assert!(!["$", "&amp;", "\u{b5}"].iter().any(|wrong| formula.contains(wrong)), "{formula}");
        }
    }
}
