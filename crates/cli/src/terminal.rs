//! Text for the user: results on the output stream, messages on the error stream.

use std::borrow::Cow;
use std::convert::Infallible;
use std::env;
use std::io::{self, IsTerminal, Write};
use std::sync::{Mutex, PoisonError};

use grazing_input::shortened;
use grazing_results::directs;
use terminal_size::{Width, terminal_size_of};

use crate::commands::CommandLine;
use crate::failure::Failure;
use crate::layout::Layout;

/// The first error in writing the output stream.
static OUTPUT_ERROR: Mutex<Option<io::Error>> = Mutex::new(None);

/// Writes to the output stream. A closed pipe, as after `| head`, is ignored; the exit code still
/// counts. Any other error in writing, such as a full disk, makes the program fail: see
/// [`output_failure`].
///
/// Lines that are longer than the terminal is wide are wrapped between words.
pub(crate) fn say(text: &str) {
    say_coloured(&layout().fitted(&shown(text)));
}

/// Writes what to do next, as the last line: a command, after something else unless that is empty.
pub(crate) fn say_next(first: &str, command: &CommandLine) {
    let words = command.words().iter().map(|word| shown(word).into_owned());
    say_coloured(&layout().command(&format!("Next: {first}"), words));
}

/// The width of the output stream: that of the terminal, or else COLUMNS, or else 80 columns.
pub(crate) fn layout() -> Layout {
    let terminal = terminal_size_of(io::stdout()).map(|(Width(width), _)| width.into());
    let stated = || env::var("COLUMNS").ok()?.parse().ok();
    terminal.or_else(stated).filter(|width| *width > 0).map_or(Layout::default(), Layout::new)
}

/// As [`say`], for a text that is laid out, with colours and without names that a user has given.
pub(crate) fn say_coloured(text: &str) {
    let mut stream = io::stdout().lock();
    if let Err(error) = stream.write_all(text.as_bytes()).and_then(|()| stream.flush())
        && error.kind() != io::ErrorKind::BrokenPipe
    {
        OUTPUT_ERROR.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
    }
}

/// The failure to write to the output stream, if there was one.
pub fn output_failure() -> Option<Failure> {
    let reason = OUTPUT_ERROR.lock().unwrap_or_else(PoisonError::into_inner).take()?;
    Some(Failure::unwritten(format!("standard output cannot be written: {reason}")))
}

/// Writes a message to the error stream: on one line, which is wrapped between words if the stream is a terminal.
pub(crate) fn note(line: &str) {
    let line = cut(&shown(line));
    let line = match terminal_size_of(io::stderr()) {
        Some((Width(width), _)) => Layout::new(width.into()).fitted(&line),
        None => line,
    };
    let _ = writeln!(io::stderr().lock(), "{line}");
}

/// Writes a message and ends the program, while other threads that report their progress wait, and so print nothing more.
pub(crate) fn last_note(line: &str, end: impl FnOnce() -> Infallible) -> ! {
    let _silence = io::stderr().lock();
    note(line);
    match end() {}
}

/// Whether the error stream is a terminal.
pub(crate) fn is_watched() -> bool {
    io::stderr().is_terminal()
}

/// The most characters of a word in a message: names of files and of constants can be of any length.
const LONGEST: usize = 200;

/// The text with long words cut.
fn cut(text: &str) -> String {
    text.split_inclusive(char::is_whitespace).map(|word| shortened(word, LONGEST)).collect()
}

/// The text made safe for a terminal: control characters other than line ends and tabs, which could
/// move the cursor or worse, and marks that change the direction of writing are written as escapes,
/// `\u{1b}`.
pub fn shown(text: &str) -> Cow<'_, str> {
    let hidden =
        |character: char| (character.is_control() && !matches!(character, '\n' | '\t')) || directs(character);
    if !text.contains(hidden) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::new();
    for character in text.chars() {
        if hidden(character) {
            shown.extend(character.escape_unicode());
        } else {
            shown.push(character);
        }
    }
    Cow::Owned(shown)
}

/// Writes help, or the error in the command line; returns the exit code.
pub fn answer(answer: &clap::Error) -> u8 {
    let plain = answer.render().to_string();
    if !answer.use_stderr() {
        say_coloured(&if is_coloured() { answer.render().ansi().to_string() } else { plain });
    } else if cut(&shown(&plain)) == plain && !is_too_wide(&plain) {
        // A closed error stream is ignored.
        let _ = answer.print();
    } else {
        note(plain.trim_end());
    }
    u8::try_from(answer.exit_code()).unwrap_or(2)
}

/// Whether the error stream is a terminal that is narrower than a line.
fn is_too_wide(text: &str) -> bool {
    let width = terminal_size_of(io::stderr()).map(|(Width(width), _)| usize::from(width));
    width.is_some_and(|width| text.lines().any(|line| line.chars().count() > width))
}

/// Writes the one line that says why the program ends.
pub fn report(failure: &Failure) {
    note(&format!("error: {failure}"));
}

/// Whether results may be coloured: on a terminal that supports colours, unless NO_COLOR is set
/// (<https://no-color.org>).
pub(crate) fn is_coloured() -> bool {
    io::stdout().is_terminal()
        && env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && env::var_os("TERM").is_none_or(|terminal| terminal != "dumb")
}
