//! The page and its parts, and the examples in its menu.

use std::borrow::Cow;
use std::iter;

use serde::Serialize;

use crate::answer::{answers, written};
use crate::kinds;

/// An oscillator in the menu.
#[derive(Clone, Debug, Serialize)]
pub struct Example {
    /// The name of the oscillator.
    pub name: String,
    /// The name of its file.
    pub file: String,
    /// The text of the file; none for the paper's oscillator.
    pub text: Option<String>,
}

/// A file: its name and its content.
type File = (&'static str, &'static [u8]);

macro_rules! files {
    ($list:ident in $folder:literal: $($name:literal)+) => {
        const $list: &[File] = &[$(($name, include_bytes!(concat!($folder, $name))),)+];
    };
}

// The files that the page shares with the report, and the fonts of the figures.
files! { STYLES in "../../report/assets/": "base.css" "gestures.js" "scales.js" "theme.js" }
files! {
    FONTS in "../../drawing/fonts/":
    "STIXTwoMath-Signs.ttf" "STIXTwoText-Italic.ttf" "STIXTwoText-Regular.ttf"
}
files! {
    PAGE in "../page/":
    "api.js" "axes.js" "busy.js" "constants.js" "cut.js" "diagram.js" "dom.js" "editor.js" "explore.css"
    "follow.js" "hand.js" "index.html" "labels.js" "lasting.js" "main.js" "markup.js" "measured.js" "model.js" "palette.js" "panels.css"
    "pick.js" "place.js" "plane.js" "portraits.js" "reach.js" "seen.js" "share.js" "state.js" "straightened.js" "svg.js" "tiles.js"
}

// The files of a page without a server, in addition to these or instead of them.
files! { ALONE in "../alone/": "reach.js" "worker.js" }

/// Media types by the endings of names.
const KINDS: [(&str, &str); 4] = [
    ("css", "text/css; charset=utf-8"),
    ("html", "text/html; charset=utf-8"),
    ("js", "text/javascript; charset=utf-8"),
    ("ttf", "font/ttf"),
];

/// The path at which the page requests its menu.
pub(crate) const EXAMPLES: &str = "examples";

answers! {
    /// The command that starts the program, and the menu.
    Menu<'a> { program: &'a str, examples: &'a [Example], }
}

/// The menu as JSON.
pub(crate) fn examples(program: &str, examples: &[Example]) -> String {
    written(&Menu { program, examples })
}

/// A file of the page with its media type; the empty name is the page itself.
pub(crate) fn page(name: &str) -> Option<(&'static str, Vec<u8>)> {
    let name = if name.is_empty() { "index.html" } else { name };
    let (_, ending) = name.rsplit_once('.')?;
    let (_, kind) = KINDS.iter().find(|(known, _)| *known == ending)?;
    let (_, content) = files().find(|(known, _)| *known == name)?;
    Some((kind, content.into_owned()))
}

/// All files of the page.
fn files() -> impl Iterator<Item = (&'static str, Cow<'static, [u8]>)> {
    let fixed = [PAGE, STYLES, FONTS].into_iter().flatten();
    let fixed = fixed.map(|(name, content)| (*name, Cow::Borrowed(*content)));
    fixed.chain(iter::once_with(|| ("kinds.js", kinds::script().into_bytes().into())))
}

/// The files of a page that needs no server, with their names; the program compiled to WebAssembly
/// belongs beside them, as `grazing.wasm`.
pub fn alone(program: &str, menu: &[Example]) -> Vec<(&'static str, Vec<u8>)> {
    let own = || ALONE.iter().map(|(name, content)| (*name, content.to_vec()));
    let rest = files().filter(|(name, _)| ALONE.iter().all(|(own, _)| own != name));
    let rest = rest.map(|(name, content)| (name, content.into_owned()));
    own().chain(rest).chain([(EXAMPLES, examples(program, menu).into_bytes())]).collect()
}
