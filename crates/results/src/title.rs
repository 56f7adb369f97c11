//! Titles, and mentions of the paper's figures in titles and descriptions.

use std::borrow::Cow;
use std::fmt::{self, Display, Formatter};

/// What a title stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TitleSubject {
    /// The figure of the paper with this number.
    Figure(u32),
    /// A figure or table that goes beyond the paper.
    Beyond,
    /// Anything else.
    Elsewhere,
}

/// A title in one line, whose words may mention figures of the paper as `Figure~7`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Title<Words = String> {
    /// What it stands for.
    pub place: TitleSubject,
    /// The words, which begin with a small letter after a number.
    pub words: Words,
}

impl Title<&'static str> {
    /// The title of a figure of the paper.
    pub const fn figure(number: u32, words: &'static str) -> Self {
        Self { place: TitleSubject::Figure(number), words }
    }

    /// The title of a figure or table beyond the paper.
    pub const fn beyond(words: &'static str) -> Self {
        Self { place: TitleSubject::Beyond, words }
    }

    /// A title of words alone.
    pub const fn plain(words: &'static str) -> Self {
        Self { place: TitleSubject::Elsewhere, words }
    }

    /// The title with words of its own.
    pub fn owned(self) -> Title {
        Title { place: self.place, words: self.words.to_owned() }
    }
}

impl<Words> Title<Words> {
    /// What stands before the words: `Figure 7`.
    pub fn before(&self) -> Option<String> {
        match self.place {
            TitleSubject::Figure(number) => Some(format!("Figure {number}")),
            TitleSubject::Beyond => Some("Beyond the paper".to_owned()),
            TitleSubject::Elsewhere => None,
        }
    }
}

impl From<String> for Title {
    fn from(words: String) -> Self {
        Self { place: TitleSubject::Elsewhere, words }
    }
}

impl From<Title<&'static str>> for Title {
    fn from(title: Title<&'static str>) -> Self {
        title.owned()
    }
}

impl<Words: AsRef<str>> Display for Title<Words> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        if let Some(before) = self.before() {
            write!(formatter, "{before}: ")?;
        }
        formatter.write_str(&without_ties(self.words.as_ref()))
    }
}

/// A part of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TitlePart<'a> {
    /// Words.
    Words(&'a str),
    /// The mention of the paper's figure with this number.
    Figure(u32),
}

/// What mentions of figures begin with.
const TIED: &str = "Figure~";

/// The parts of a text that mentions figures of the paper as `Figure~7`.
pub fn parts(text: &str) -> impl Iterator<Item = TitlePart<'_>> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let number = |after: &str| {
            let end = after.find(|character: char| !character.is_ascii_digit()).unwrap_or(after.len());
            Some((after[..end].parse().ok()?, end))
        };
        if let Some((figure, end)) = rest.strip_prefix(TIED).and_then(number) {
            rest = &rest[TIED.len() + end..];
            return Some(TitlePart::Figure(figure));
        }
        let first = rest.chars().next()?.len_utf8();
        let mut mentions = rest.match_indices(TIED).map(|(at, _)| at).filter(|at| *at >= first);
        let words;
        (words, rest) = rest.split_at(mentions.next().unwrap_or(rest.len()));
        Some(TitlePart::Words(words))
    })
}

/// The text with its mentions of figures in words: `Figure 7`.
pub fn without_ties(text: &str) -> String {
    let word = |part| match part {
        TitlePart::Words(words) => Cow::Borrowed(words),
        TitlePart::Figure(number) => Cow::Owned(format!("Figure {number}")),
    };
    parts(text).map(word).collect()
}
