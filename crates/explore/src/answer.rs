//! Answers, independent of their transport.

use grazing_input::Mistake;
use grazing_results::{Cell, Row};
use serde_json::{Map, Value, json};

/// The reason why there is no answer.
#[derive(Debug)]
pub(crate) struct Problem {
    /// The status in HTTP.
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

    /// The message for the page, as JSON.
    pub(crate) fn told(&self) -> Value {
        json!({ "message": self.message })
    }
}

impl From<Mistake> for Problem {
    fn from(Mistake { message, line, .. }: Mistake) -> Self {
        let line = line.map_or(String::new(), |line| format!("line {line}: "));
        Self::wrong(format!("{line}{message}"))
    }
}

/// A row for the page: each cell under its column's name, the parameters as `primary` and `secondary`.
pub(crate) fn told<R: Row>(row: &R) -> Map<String, Value> {
    let value = |cell| match cell {
        Cell::Text(words) => json!(words),
        Cell::Verdict(word, _) => json!(word),
        Cell::Integer(count) => json!(count),
        Cell::Number(number) => json!(number),
        Cell::Flag(yes) => json!(yes),
    };
    let names = R::COLUMNS.iter().map(|column| column.name.replace(['{', '}'], ""));
    names.zip(row.cells().into_iter().map(value)).collect()
}

/// A file that is exported.
pub struct ExportedFile {
    /// The file name.
    pub name: String,
    /// The media type.
    pub kind: &'static str,
    /// The content of the file.
    pub content: Vec<u8>,
}
