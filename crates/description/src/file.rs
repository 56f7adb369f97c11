//! What the keys of a file must hold.

use grazing_source::Requirements;

/// The largest number of loops: higher ones do not relate to resonant grazing, and their curves are not told apart.
pub(crate) const MOST_LOOPS: u32 = 12;

/// What each key must hold, in words for whoever has to mend one.
pub(crate) const REQUIREMENTS: Requirements = Requirements::new(KEYS, "see examples/ for what belongs here");

const KEYS: &[(&str, &str)] = &[
    (
        "name",
        "the name of the oscillator must be given before the first table, as text in quotation marks that is not empty",
    ),
    ("parameters", "the table [parameters] holds constants by name, as zeta = 0.02; it may be empty"),
    ("parameters.*", "a constant must be a finite number"),
    ("primary", "the table [primary] holds name and range of the parameter whose grazing value is sought"),
    ("primary.name", NAME),
    ("primary.range", RANGE),
    ("primary.unit", UNIT),
    ("secondary", "the table [secondary] holds name and range of the parameter along the grazing curve"),
    ("secondary.name", NAME),
    ("secondary.range", RANGE),
    ("secondary.unit", UNIT),
    (
        "units",
        "the table [units] holds the names of the units of length and time, as length = \"mm\"; it may be left out",
    ),
    ("units.length", UNIT),
    ("units.time", UNIT),
    ("motion", "the table [motion] holds force and frequency"),
    (
        "motion.force",
        "the force must be an expression in x, v, t and the parameters, written in quotation marks, \
         as \"-2*zeta*v - x - 1 + A*cos(omega*t)\"",
    ),
    (
        "motion.frequency",
        "the forcing frequency must be an expression in the parameters, written in quotation marks, as \"omega\"",
    ),
    (
        "wall",
        "the table [wall] holds the position of the wall and the side on which the motion is; without it the wall is at x = 0",
    ),
    (
        "wall.position",
        "the position of the wall must be an expression in t and the parameters, written in quotation marks, as \"0.0015\" or \"a*cos(omega*t)\"",
    ),
    (
        "wall.side",
        "the side of the wall on which the motion is must be \"below\" (less than its position) or \"above\" (greater); it may be left out and is \"below\" then",
    ),
    ("impact", "the table [impact] holds restitution and duration"),
    (
        "impact.restitution",
        "the restitution must be an expression in y, z and the parameters, written in quotation marks, as \"0.8\"",
    ),
    (
        "impact.duration",
        "the impact duration must be an expression in y, z and the parameters, written in quotation marks, \
         \"0\" for impacts that take no time",
    ),
    (
        "analysis",
        "the table [analysis] holds loops and may hold start, time_limit, memory_limit and step_limit",
    ),
    (
        "analysis.loops",
        "the numbers of loops must be a list of different whole numbers from 1 to 12, as [1, 2, 3]",
    ),
    (
        "analysis.start",
        "the start of the search for the non-impacting motion must be position and velocity at time zero, \
         two finite numbers, as [-1.0, 0.0]; it may be left out",
    ),
    (
        "analysis.time_limit",
        "the time after which the analysis ends with what it has must be a positive number of seconds, as 600; \
         it may be left out",
    ),
    (
        "analysis.memory_limit",
        "the memory at which the analysis ends with what it has must be a positive number of megabytes, as 2000; \
         it may be left out",
    ),
    (
        "analysis.step_limit",
        "the number of steps of integration after which the analysis ends with what it has must be positive, as 1e10; \
         it may be left out",
    ),
];

const NAME: &str = "a name is made of the letters a to z and A to Z, digits and _, and does not begin with a digit, as \"omega\"";
const UNIT: &str = "the name of a unit must be up to 20 letters, digits, blanks or / ^ * - . ( ) %, in quotation marks, as \"rad/s\"; it may be left out \
                    and changes no number";
const RANGE: &str = "the range must be [lower, upper] with finite numbers lower < upper";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_of_loops_is_told_as_it_is_checked() {
        assert!(REQUIREMENTS.of("analysis.loops").contains(&format!(" to {MOST_LOOPS},")));
    }
}
