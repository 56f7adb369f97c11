//! Commands for a user to type, of this program as it was started: values that become text where they are shown.

use std::borrow::Cow;
use std::env;
use std::fmt::{self, Display, Formatter};

use grazing_continuation::bifurcation::Bifurcation;

/// The command that starts the installed program.
pub(crate) const INSTALLED: &str = "grazing";
/// The command that starts the program in a clone.
const IN_A_CLONE: &str = "cargo xtask";
/// What stands for the command that starts the program in texts of ours, such as help.
const MARK: &str = "{grazing}";

/// The command that started this program: `cargo xtask`, which sets an environment variable, or `grazing`.
pub fn program() -> &'static str {
    env::var_os("GRAZING_BY_XTASK").map_or(INSTALLED, |_| IN_A_CLONE)
}

/// A text of ours, with the command that starts the program where `{grazing}` stands, and the kinds of bifurcations where
/// `{kinds}` does.
pub(crate) fn filled(template: &str, program: &str) -> String {
    template.replace(MARK, program).replace("{kinds}", Bifurcation::NAMES)
}

/// A command to be typed in a shell.
#[derive(Clone, Debug)]
pub struct CommandLine {
    /// Words, between which a long line may be broken; an option and its value are one.
    words: Vec<String>,
}

impl CommandLine {
    /// A command of this program.
    pub(crate) fn own(subcommand: &str) -> Self {
        Self { words: program().split(' ').chain([subcommand]).map(str::to_owned).collect() }
    }

    /// A command of another program.
    pub fn of(words: &[&str]) -> Self {
        Self { words: words.iter().map(|word| (*word).to_owned()).collect() }
    }

    /// The command with an argument.
    #[must_use]
    pub(crate) fn with(mut self, argument: impl Display) -> Self {
        self.words.push(quoted(&argument.to_string()).into_owned());
        self
    }

    /// The command with all files that match a pattern in a folder.
    #[must_use]
    pub(crate) fn with_files(mut self, folder: impl Display, pattern: &str) -> Self {
        self.words.push(format!("{}/{pattern}", quoted(&folder.to_string())));
        self
    }

    /// The command with options and their values.
    #[must_use]
    pub fn options<V: Display>(mut self, options: impl IntoIterator<Item = (&'static str, V)>) -> Self {
        let option = |(name, value): (_, V)| format!("{name} {}", quoted(&value.to_string()));
        self.words.extend(options.into_iter().map(option));
        self
    }

    /// The words, between which a long line may be broken.
    pub(crate) fn words(&self) -> &[String] {
        &self.words
    }
}

impl Display for CommandLine {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.words.join(" "))
    }
}

/// A word as a shell reads it: in quotation marks if it has characters that mean something else there.
fn quoted(word: &str) -> Cow<'_, str> {
    let is_plain = |character: char| character.is_alphanumeric() || "_-./,:=+@%^".contains(character);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => Cow::Borrowed(word),
        false => Cow::Owned(format!("'{}'", word.replace('\'', r"'\''"))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_written_as_a_shell_reads_them() {
        let command = CommandLine::of(&["grazing", "unfold"]).with("my rig's.toml");
        let command = command
            .options([("--set", "zeta=0.05"), ("--set", "a=[0, 2]")])
            .with_files("a b/parts", "*.toml");
        let text = r"grazing unfold 'my rig'\''s.toml' --set zeta=0.05 --set 'a=[0, 2]' 'a b/parts'/*.toml";
        assert_eq!(command.to_string(), text);
    }
}
