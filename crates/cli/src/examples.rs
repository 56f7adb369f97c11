//! Descriptions of oscillators to begin with: plain ones, and the examples of the repository, which are also available
//! outside of it.

use crate::commands;

/// The folder of example oscillators, from the root of the repository.
pub(crate) const EXAMPLES: &str = "examples";
macro_rules! examples {
    ($($name:literal)+) => {
        /// The example oscillators, file and text.
        pub(crate) const EXAMPLE_FILES: &[(&str, &str)] =
            &[$(($name, include_str!(concat!("../../../examples/", $name))),)+];
    };
}

examples! {
    "afm.toml" "base-excitation.toml" "bell.toml" "bouncing-ball.toml" "clearance.toml" "door.toml" "drill.toml"
    "duffing.toml" "gear-backlash.toml" "harvester.toml" "impact-damper.toml" "leaf-spring.toml" "paper.toml"
    "parametric.toml" "pendulum.toml" "quadratic-damping.toml" "relay.toml" "rig-si.toml" "shaking-table.toml"
    "two-harmonics.toml" "two-stops.toml" "varying-impact.toml"
}

/// A description that a user begins with.
pub struct StarterFile {
    /// The name on the command line; of an example, its file name without the ending.
    pub name: &'static str,
    /// A line about the oscillator that it describes.
    pub about: &'static str,
    /// The text of the file, with `{grazing}` for the command that starts the program.
    template: &'static str,
}

impl StarterFile {
    /// The text of the file, for a program that is started by this command.
    pub fn text(&self, program: &str) -> String {
        commands::filled(self.template, program)
    }
}

/// The kinds that are not examples.
const PLAIN: [StarterFile; 3] = [
    StarterFile {
        name: "plain",
        about: "A mass on a spring beside a wall at x = 0, without units",
        template: include_str!("new/plain.toml"),
    },
    StarterFile {
        name: "moving-wall",
        about: "A mass over a table that shakes: the wall moves",
        template: include_str!("new/moving-wall.toml"),
    },
    StarterFile {
        name: "si",
        about: "A rig in metres, kilograms and seconds, its stop at a distance",
        template: include_str!("new/si.toml"),
    },
];

/// All kinds: the plain ones, and the examples.
pub fn kinds() -> impl Iterator<Item = StarterFile> {
    let example = |(file, text): &(&'static str, &'static str)| StarterFile {
        name: file.trim_end_matches(".toml"),
        about: text.lines().find_map(|line| line.strip_prefix("name = \"")?.split('"').next()).unwrap_or(""),
        template: text,
    };
    PLAIN.into_iter().chain(EXAMPLE_FILES.iter().map(example))
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::*;

    #[test]
    fn all_examples_of_the_folder_are_at_hand() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(EXAMPLES);
        let entries =
            fs::read_dir(folder).expect("it is there").map(|entry| entry.expect("it is").file_name());
        let names = entries.map(|name| name.into_string().expect("it is text"));
        let mut names: Vec<String> = names.filter(|name| name.ends_with(".toml")).collect();
        names.sort();
        assert_eq!(names, EXAMPLE_FILES.iter().map(|(name, _)| *name).collect::<Vec<_>>());
    }
}
