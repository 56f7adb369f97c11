//! The page and its parts, and the examples in its menu.

use hyper::Response;
use serde::Serialize;

use crate::answer::{self, Body};
use crate::kinds;

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

/// A file: its name, its media type, its content.
type File = (&'static str, &'static str, &'static [u8]);

macro_rules! files {
    ($list:ident in $folder:literal: $($name:literal = $kind:literal,)+) => {
        const $list: &[File] = &[$(($name, $kind, include_bytes!(concat!($folder, $name))),)+];
    };
}

// What the page shares with the report, and the fonts of the figures.
files! {
    STYLES in "../../report/assets/":
    "base.css" = "text/css; charset=utf-8",
    "gestures.js" = "text/javascript; charset=utf-8",
    "scales.js" = "text/javascript; charset=utf-8",
    "theme.js" = "text/javascript; charset=utf-8",
}

files! {
    FONTS in "../../drawing/fonts/":
    "STIXTwoMath-Signs.ttf" = "font/ttf",
    "STIXTwoText-Italic.ttf" = "font/ttf",
    "STIXTwoText-Regular.ttf" = "font/ttf",
}

files! {
    PAGE in "../page/":
    "api.js" = "text/javascript; charset=utf-8",
    "axes.js" = "text/javascript; charset=utf-8",
    "busy.js" = "text/javascript; charset=utf-8",
    "constants.js" = "text/javascript; charset=utf-8",
    "cut.js" = "text/javascript; charset=utf-8",
    "diagram.js" = "text/javascript; charset=utf-8",
    "dom.js" = "text/javascript; charset=utf-8",
    "editor.js" = "text/javascript; charset=utf-8",
    "explore.css" = "text/css; charset=utf-8",
    "hand.js" = "text/javascript; charset=utf-8",
    "index.html" = "text/html; charset=utf-8",
    "labels.js" = "text/javascript; charset=utf-8",
    "lasting.js" = "text/javascript; charset=utf-8",
    "main.js" = "text/javascript; charset=utf-8",
    "markup.js" = "text/javascript; charset=utf-8",
    "model.js" = "text/javascript; charset=utf-8",
    "palette.js" = "text/javascript; charset=utf-8",
    "panels.css" = "text/css; charset=utf-8",
    "pick.js" = "text/javascript; charset=utf-8",
    "place.js" = "text/javascript; charset=utf-8",
    "plane.js" = "text/javascript; charset=utf-8",
    "portraits.js" = "text/javascript; charset=utf-8",
    "share.js" = "text/javascript; charset=utf-8",
    "state.js" = "text/javascript; charset=utf-8",
    "tiles.js" = "text/javascript; charset=utf-8",
}

/// A file of the page; the empty name is the page itself.
pub(crate) fn page(name: &str) -> Option<Response<Body>> {
    let name = match name {
        "" => "index.html",
        "kinds.js" => return Some(answer::of_kind("text/javascript; charset=utf-8", kinds::script())),
        "kinds.css" => return Some(answer::of_kind("text/css; charset=utf-8", kinds::style_sheet())),
        name => name,
    };
    let mut files = [PAGE, STYLES, FONTS].into_iter().flatten();
    let (_, kind, content) = files.find(|(known, _, _)| *known == name)?;
    Some(answer::of_kind(kind, *content))
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::*;

    #[test]
    fn all_files_of_the_page_are_served_and_all_that_these_load_is_there() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("page");
        let mut names: Vec<String> = fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        assert_eq!(names, PAGE.iter().map(|(name, _, _)| *name).collect::<Vec<_>>());
        for (name, _, content) in PAGE {
            let text = str::from_utf8(content).unwrap();
            let quoted = text.split(['"', '\'']).skip(1).step_by(2);
            let loaded = |text: &str| {
                let file = text.strip_prefix("./").unwrap_or(text);
                [".js", ".css", ".ttf"].iter().any(|ending| file.ends_with(ending))
                    && !file.contains([' ', '*'])
            };
            for loaded in quoted.filter(|text| loaded(text)) {
                assert!(page(loaded.strip_prefix("./").unwrap_or(loaded)).is_some(), "{name}: {loaded}");
            }
            // The content policy forbids it anyway.
            for foreign in ["https://", "//cdn", "eval(", "innerHTML"] {
                assert!(!text.contains(foreign), "{name}: {foreign}");
            }
        }
    }
}
