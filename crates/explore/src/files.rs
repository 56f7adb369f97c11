//! The page and its parts, and the examples in its menu.

use hyper::Response;
use serde::Serialize;

use crate::answer::{self, Body};

/// An oscillator in the menu.
#[derive(Clone, Debug, Serialize)]
pub struct Example {
    /// What it is called.
    pub name: String,
    /// The name of its file.
    pub file: String,
    /// What stands in it; none for the paper's oscillator.
    pub text: Option<String>,
}

macro_rules! page {
    ($($name:literal = $kind:literal,)+) => {
        const FILES: &[(&str, &str, &str)] = &[$(($name, $kind, include_str!(concat!("../page/", $name))),)+];
    };
}

page! {
    "index.html" = "text/html; charset=utf-8",
}

/// A file of the page; the empty name is the page itself.
pub(crate) fn page(name: &str) -> Option<Response<Body>> {
    let name = if name.is_empty() { "index.html" } else { name };
    let (_, kind, text) = FILES.iter().find(|(known, _, _)| *known == name)?;
    Some(answer::of_kind(kind, text.as_bytes().to_vec()))
}
