//! Answers, independent of their transport.

use grazing_input::Mistake;
use grazing_results::{Cell, Row};
use serde::Serialize;
use serde_json::{Map, Value};

/// The reason why there is no answer; the page gets the message.
#[derive(Debug, Serialize)]
pub(crate) struct Problem {
    /// The status in HTTP.
    #[serde(skip)]
    pub(crate) status: u16,
    pub(crate) message: String,
}

impl Problem {
    pub(crate) fn new(status: u16, message: impl Into<String>) -> Self {
        Self { status, message: message.into() }
    }

    /// A request that cannot be fulfilled: the model is wrong, or there is nothing to show.
    pub(crate) fn wrong(message: impl Into<String>) -> Self {
        Self::new(422, message)
    }

    /// A request that cannot be read.
    pub(crate) fn unread(error: &serde_json::Error) -> Self {
        Self::new(400, format!("the request is invalid: {error}"))
    }

    /// A computation that was ended because its time or its steps are used up.
    pub(crate) fn ended() -> Self {
        Self::new(503, "the computation was cancelled because it took too long")
    }

    /// A computation that was ended because it took too much memory.
    #[cfg(feature = "server")]
    pub(crate) fn too_large() -> Self {
        Self::new(503, "the computation was cancelled because it took too much memory")
    }
}

impl From<Mistake> for Problem {
    fn from(Mistake { message, line, .. }: Mistake) -> Self {
        let line = line.map_or(String::new(), |line| format!("line {line}: "));
        Self::wrong(format!("{line}{message}"))
    }
}

/// The cells of a row by the names of their columns.
pub(crate) type Cells = Map<String, Value>;

/// A row for the page: each cell under its column's name, the parameters as `primary` and `secondary`.
pub(crate) fn told<R: Row>(row: &R) -> Cells {
    let value = |cell| match cell {
        Cell::Text(words) => words.into(),
        Cell::Verdict(word, _) => word.into(),
        Cell::Integer(count) => count.into(),
        Cell::Number(number) => number.into(),
        Cell::Flag(yes) => yes.into(),
    };
    let names = R::COLUMNS.iter().map(|column| column.name.replace(['{', '}'], ""));
    names.zip(row.cells().into_iter().map(value)).collect()
}

/// An answer as JSON; numbers that are not finite are null.
pub(crate) fn written(answer: &impl Serialize) -> String {
    // Nothing fails: all answers are numbers and words.
    serde_json::to_string(answer).unwrap_or_default()
}

/// Declares answers that are no rows: the page gets each field under its name.
macro_rules! answers {
    ($($(#[$meta:meta])* $answer:ident $(<$life:lifetime>)? { $($(#[$about:meta])* $field:ident: $type:ty,)+ })+) => {$(
        $(#[$meta])*
        #[derive(serde::Serialize)]
        pub(crate) struct $answer $(<$life>)? {
            $($(#[$about])* pub(crate) $field: $type,)+
        }
    )+};
}

pub(crate) use answers;

/// A file that is exported.
pub struct ExportedFile {
    /// The file name.
    pub name: String,
    /// The media type.
    pub kind: &'static str,
    /// The content of the file.
    pub content: Vec<u8>,
}
