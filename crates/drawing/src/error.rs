//! What can be wrong with the frames and windows that are handed in.

/// Why a figure could not be drawn.
#[derive(Debug, thiserror::Error)]
pub enum DrawingError {
    /// A frame lacks a column.
    #[error("frame `{frame}` has no column `{column}`; it has: {present}")]
    MissingColumn {
        /// The frame's name, as the figure calls it.
        frame: &'static str,
        /// The column that is wanted.
        column: String,
        /// The columns that are there, separated by commas.
        present: String,
    },
    /// A column holds values that cannot be read as what the figure needs.
    #[error("column `{column}` of frame `{frame}` should hold {wanted}, but it is of type {found}")]
    ColumnType {
        /// The frame's name.
        frame: &'static str,
        /// The column's name.
        column: String,
        /// What the figure reads from it.
        wanted: &'static str,
        /// The type found.
        found: String,
    },
    /// A column has an empty cell where every row needs a value.
    #[error("column `{column}` of frame `{frame}` is empty in row {row}")]
    EmptyCell {
        /// The frame's name.
        frame: &'static str,
        /// The column's name.
        column: String,
        /// The row, counted from 0.
        row: usize,
    },
    /// A word in a column is none of those the figure knows.
    #[error("column `{column}` of frame `{frame}` has the unknown value `{value}`; known are: {known}")]
    UnknownWord {
        /// The frame's name.
        frame: &'static str,
        /// The column's name.
        column: String,
        /// The value found.
        value: String,
        /// The values allowed, separated by commas.
        known: &'static str,
    },
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
    /// A figure with a fixed number of panels was given another number of them.
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
    /// The drawing surface was borrowed while something was being drawn on it.
    #[error("the drawing surface is in use")]
    SurfaceInUse,
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
