//! The markup of labels.
//!
//! | written | printed |
//! |---|---|
//! | `text` | upright text, as it stands |
//! | `$x$` | mathematics: letters italic, digits and signs upright, spaces ignored |
//! | `\alpha`, `\omega`, `\Omega`, … | Greek letter (within `$…$`, like all below) |
//! | `\le`, `\ge`, `\approx`, `\times`, `\pm`, `\cdot`, `\ast`, `\sqrt`, `\,` | ≤ ≥ ≈ × ± · ∗ √ and a thin space |
//! | `-`, `=` | minus sign; equals sign with thin spaces around it |
//! | `\mathrm{graz}`, `\mathcal{A}` | upright words; script letters A, P and V |
//! | `\hat{x}`, `'` | one letter with a circumflex; a prime |
//! | `_x`, `^{12}` | subscript, superscript: one character, one command, or a group in braces |
//!
//! Scripts do not nest, and a superscript after a subscript follows it instead of being above it.

use grazing_results::title::without_ties;
use std::str::Chars;

use grazing_results::GREEK;

use crate::error::DrawingError;

/// The embedded font of a run of text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FontFace {
    Upright,
    Italic,
    Signs,
}

/// The vertical position of a run relative to the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Level {
    Line,
    Subscript,
    Superscript,
}

/// The size of subscripts and superscripts relative to the line.
const SCRIPT_SIZE: f64 = 0.72;
/// The lowering of a subscript's baseline and the raising of a superscript's, in units of the font size.
const SUBSCRIPT_DROP: f64 = 0.19;
const SUPERSCRIPT_RISE: f64 = 0.36;

impl Level {
    /// The font size of text at this level in a label of a given size, and the height of its baseline
    /// above that of the line.
    pub(crate) fn size_and_rise(self, size: f64) -> (f64, f64) {
        match self {
            Level::Line => (size, 0.0),
            Level::Subscript => (size * SCRIPT_SIZE, -size * SUBSCRIPT_DROP),
            Level::Superscript => (size * SCRIPT_SIZE, size * SUPERSCRIPT_RISE),
        }
    }
}

/// Text in one face at one level.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) face: FontFace,
    pub(crate) level: Level,
    pub(crate) text: String,
    /// Whether a circumflex is above the run, which is then one letter.
    pub(crate) hat: bool,
}

/// A parsed label.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    pub(crate) source: String,
    pub(crate) runs: Vec<Run>,
}

const SIGNS: [(&str, char, FontFace); 8] = [
    ("le", '≤', FontFace::Signs),
    ("ge", '≥', FontFace::Signs),
    ("approx", '≈', FontFace::Signs),
    ("ast", '∗', FontFace::Signs),
    ("sqrt", '√', FontFace::Signs),
    ("times", '×', FontFace::Upright),
    ("pm", '±', FontFace::Upright),
    ("cdot", '·', FontFace::Upright),
];

struct Parser<'a> {
    source: &'a str,
    rest: Chars<'a>,
    runs: Vec<Run>,
}

/// The text of a label, a title or a description without markup; symbols become their letters.
pub fn unmarked(source: &str) -> String {
    let source = without_ties(source);
    let letters = |label: Label| label.runs.iter().map(|run| run.text.as_str()).collect();
    Label::parse(&source).map_or_else(|_| source.clone(), letters)
}

impl Label {
    /// A label of upright text without markup.
    pub(crate) fn plain(text: &str) -> Self {
        let run = Run { face: FontFace::Upright, level: Level::Line, text: text.to_owned(), hat: false };
        Label { source: text.to_owned(), runs: vec![run] }
    }

    /// Reads a label.
    ///
    /// # Errors
    /// The markup is invalid.
    pub fn parse(source: &str) -> Result<Self, DrawingError> {
        let mut parser = Parser { source, rest: source.chars(), runs: Vec::new() };
        while let Some(character) = parser.rest.next() {
            if character == '$' {
                parser.mathematics('$', Level::Line)?;
            } else {
                // The micro sign becomes the letter mu, which the fonts have.
                let known = if character == '\u{b5}' { '\u{3bc}' } else { character };
                parser.push(FontFace::Upright, Level::Line, known);
            }
        }
        Ok(Label { source: source.to_owned(), runs: parser.runs })
    }
}

impl Parser<'_> {
    fn fail<T>(&self, reason: &'static str) -> Result<T, DrawingError> {
        let position = self.source.chars().count() - self.rest.clone().count();
        Err(DrawingError(format!("label `{}`: {reason} at character {position}", self.source)))
    }

    fn push(&mut self, face: FontFace, level: Level, character: char) {
        match self.runs.last_mut() {
            Some(run) if run.face == face && run.level == level && !run.hat => run.text.push(character),
            _ => self.runs.push(Run { face, level, text: character.to_string(), hat: false }),
        }
    }

    fn mathematics(&mut self, end: char, level: Level) -> Result<(), DrawingError> {
        loop {
            match self.rest.next() {
                Some(character) if character == end => return Ok(()),
                Some(character) => self.token(character, level)?,
                None => {
                    return self.fail(if end == '$' { "`$` is not closed" } else { "`{` is not closed" });
                }
            }
        }
    }

    fn token(&mut self, character: char, level: Level) -> Result<(), DrawingError> {
        match character {
            ' ' => {}
            '\\' => self.command(level)?,
            '_' | '^' if level != Level::Line => return self.fail("scripts do not nest"),
            '_' => self.script(Level::Subscript)?,
            '^' => self.script(Level::Superscript)?,
            '-' => self.push(FontFace::Upright, level, '−'),
            '=' => "\u{2009}=\u{2009}".chars().for_each(|c| self.push(FontFace::Upright, level, c)),
            '\'' => self.push(FontFace::Upright, level, '′'),
            '{' | '}' | '$' => return self.fail("stray bracket or `$`"),
            letter if letter.is_alphabetic() => self.push(FontFace::Italic, level, letter),
            other => self.push(FontFace::Upright, level, other),
        }
        Ok(())
    }

    fn script(&mut self, level: Level) -> Result<(), DrawingError> {
        match self.rest.next() {
            Some('{') => self.mathematics('}', level),
            Some(character) => self.token(character, level),
            None => self.fail("nothing to raise or lower"),
        }
    }

    fn command(&mut self, level: Level) -> Result<(), DrawingError> {
        let text = self.rest.as_str();
        let name = &text[..text.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(text.len())];
        self.rest = text[name.len()..].chars();
        let greek = GREEK.iter().find(|letter| letter.0 == name);
        let greek =
            greek.map(|&(_, c)| (c, if c.is_uppercase() { FontFace::Upright } else { FontFace::Italic }));
        let sign = SIGNS.iter().find(|sign| sign.0 == name).map(|&(_, c, face)| (c, face));
        if let Some((character, face)) = greek.or(sign) {
            self.push(face, level, character);
            return Ok(());
        }
        match name {
            "" if self.rest.next() == Some(',') => self.push(FontFace::Upright, level, '\u{2009}'),
            "hat" => {
                let group = [self.rest.next(), self.rest.next(), self.rest.next()];
                let [Some('{'), Some(letter), Some('}')] = group else {
                    return self.fail("one letter in braces should follow");
                };
                let text = letter.to_string();
                self.runs.push(Run { face: FontFace::Italic, level, text, hat: true });
            }
            "mathrm" | "mathcal" => {
                if self.rest.next() != Some('{') {
                    return self.fail("a group in braces should follow");
                }
                loop {
                    match self.rest.next() {
                        Some('}') => return Ok(()),
                        None => return self.fail("`{` is not closed"),
                        Some(letter) if name == "mathrm" => self.push(FontFace::Upright, level, letter),
                        Some('A') => self.push(FontFace::Signs, level, '𝒜'),
                        Some('P') => self.push(FontFace::Signs, level, '𝒫'),
                        Some('V') => self.push(FontFace::Signs, level, '𝒱'),
                        Some(_) => return self.fail("only A, P and V have script forms"),
                    }
                }
            }
            _ => return self.fail("unknown command"),
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn runs(source: &str) -> Vec<(FontFace, Level, String)> {
        Label::parse(source).unwrap().runs.into_iter().map(|r| (r.face, r.level, r.text)).collect()
    }

    #[test]
    fn words_are_upright_and_variables_italic() {
        assert_eq!(
            runs("loops $p = 12$"),
            [
                (FontFace::Upright, Level::Line, "loops ".to_owned()),
                (FontFace::Italic, Level::Line, "p".to_owned()),
                (FontFace::Upright, Level::Line, "\u{2009}=\u{2009}12".to_owned()),
            ]
        );
    }

    #[test]
    fn scripts_take_one_character_a_command_or_a_group() {
        assert_eq!(
            runs(r"$\mathcal{A}_{\mathrm{graz}}\omega^\ast c_2$"),
            [
                (FontFace::Signs, Level::Line, "𝒜".to_owned()),
                (FontFace::Upright, Level::Subscript, "graz".to_owned()),
                (FontFace::Italic, Level::Line, "ω".to_owned()),
                (FontFace::Signs, Level::Superscript, "∗".to_owned()),
                (FontFace::Italic, Level::Line, "c".to_owned()),
                (FontFace::Upright, Level::Subscript, "2".to_owned()),
            ]
        );
    }

    #[test]
    fn a_hat_stands_over_one_letter_and_a_prime_follows_it() {
        let label = Label::parse(r"$(\hat{x},0,z')$").unwrap();
        let hats: Vec<_> = label.runs.iter().filter(|run| run.hat).map(|run| run.text.as_str()).collect();
        assert_eq!(hats, ["x"]);
        assert_eq!(label.runs.iter().map(|run| run.text.as_str()).collect::<String>(), "(x,0,z′)");
    }

    #[test]
    fn a_hyphen_is_a_minus_only_in_mathematics() {
        assert_eq!(runs("SN-GZ")[0].2, "SN-GZ");
        assert_eq!(runs("$-3$")[0].2, "−3");
    }

    #[test]
    fn mistakes_are_named_with_their_place() {
        for (source, reason) in [
            ("$x", "`$` is not closed"),
            (r"$\nabla$", "unknown command"),
            ("$x_{a_b}$", "scripts do not nest"),
            ("$x_{a$", "stray bracket or `$`"),
            (r"$\hat{xy}$", "one letter in braces should follow"),
            (r"$\mathcal{Q}$", "only A, P and V have script forms"),
            ("$x^", "nothing to raise or lower"),
        ] {
            let error = Label::parse(source).expect_err(source).to_string();
            assert!(error.starts_with(&format!("label `{source}`: {reason} at character ")), "{error}");
        }
    }
}
