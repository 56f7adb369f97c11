//! What can be wrong with the rows and windows that are handed in.

/// Why a figure could not be drawn.
#[derive(Debug, thiserror::Error)]
pub enum DrawingError {
    /// A window is empty, reversed or not finite.
    #[error("{axis} range of {window} must be finite and increasing, but it is {low} to {high}")]
    Window {
        /// Which window.
        window: String,
        /// Which axis of it.
        axis: &'static str,
        /// Its lower end.
        low: f64,
        /// Its upper end.
        high: f64,
    },
    /// A figure was given more panels than it has room for, or none.
    #[error("{figure} has {wanted}, but {found} were given")]
    PanelCount {
        /// The figure's name.
        figure: &'static str,
        /// What it can hold.
        wanted: &'static str,
        /// How many were given.
        found: usize,
    },
    /// A label is not valid markup.
    #[error("label `{label}`: {reason} at character {position}")]
    Markup {
        /// The label as written.
        label: String,
        /// What is wrong.
        reason: &'static str,
        /// Where, counted from 0.
        position: usize,
    },
    /// A label has a character that the embedded fonts lack.
    #[error("label `{label}` needs the character `{character}`, which the embedded fonts do not have")]
    Glyph {
        /// The label as written.
        label: String,
        /// The character.
        character: char,
    },
    /// An embedded font could not be read.
    #[error("embedded font {font}: {reason}")]
    Font {
        /// The font's file name.
        font: &'static str,
        /// What the font reader said.
        reason: ttf_parser::FaceParsingError,
    },
    /// The finished figure is too heavy to open comfortably.
    #[error("{figure} came to {bytes} bytes; the limit is {limit}")]
    TooLarge {
        /// The figure's name.
        figure: &'static str,
        /// Its size in bytes.
        bytes: usize,
        /// The limit in bytes.
        limit: usize,
    },
}
