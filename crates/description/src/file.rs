//! What the keys of a file must hold.

use grazing_source::{Requirements, requirements};

/// The largest number of loops: higher ones do not relate to resonant grazing, and their curves are not told apart.
pub(crate) const MOST_LOOPS: u32 = 12;

/// More diagrams, or more portraits in one of them, nobody looks at.
pub(crate) const MOST_DIAGRAMS: usize = 8;
pub(crate) const MOST_PORTRAITS: usize = 6;

/// What each key must hold, in words for whoever has to mend one.
pub(crate) const REQUIREMENTS: Requirements = requirements! {
    otherwise "see examples/ for what belongs here";
    "name":
        "the name of the oscillator must be given before the first table, as text in quotation marks that is not empty";
    "parameters": "the table [parameters] holds constants by name, as zeta = 0.02; it may be empty";
    "parameters.*": "a constant must be a finite number";
    "primary": "the table [primary] holds name and range of the parameter whose grazing value is sought";
    "primary.name": NAME;
    "primary.range": RANGE;
    "primary.unit": UNIT;
    "secondary": "the table [secondary] holds name and range of the parameter along the grazing curve";
    "secondary.name": NAME;
    "secondary.range": RANGE;
    "secondary.unit": UNIT;
    "units":
        "the table [units] holds the names of the units of length and time, as length = \"mm\"; it may be left out";
    "units.length": UNIT;
    "units.time": UNIT;
    "motion": "the table [motion] holds force and frequency";
    "motion.force":
        "the force must be an expression in x, v, t and the parameters, written in quotation marks, \
         as \"-2*zeta*v - x - 1 + A*cos(omega*t)\"";
    "motion.frequency":
        "the forcing frequency must be an expression in the parameters, written in quotation marks, as \"omega\"";
    "wall":
        "the table [wall] holds the position of the wall and the side on which the motion is; without it the wall is at x = 0";
    "wall.position":
        "the position of the wall must be an expression in t and the parameters, written in quotation marks, as \"0.0015\" or \"a*cos(omega*t)\"";
    "wall.side":
        "the side of the wall on which the motion is must be \"below\" (less than its position) or \"above\" (greater); it may be left out and is \"below\" then";
    "impact": "the table [impact] holds restitution and duration";
    "impact.restitution":
        "the restitution must be an expression in y, z and the parameters, written in quotation marks, as \"0.8\"";
    "impact.duration":
        "the impact duration must be an expression in y, z and the parameters, written in quotation marks, \
         \"0\" for impacts that take no time";
    "analysis": "the table [analysis] holds loops and may hold start, time_limit, memory_limit and step_limit";
    "analysis.loops": "the numbers of loops must be a list of different whole numbers from 1 to 12, as [1, 2, 3]";
    "analysis.start":
        "the start of the search for the non-impacting motion must be position and velocity at time zero, \
         two finite numbers, as [-1.0, 0.0]; it may be left out";
    "analysis.time_limit":
        "the time after which the analysis ends with what it has must be a positive number of seconds, as 600; \
         it may be left out";
    "analysis.memory_limit":
        "the memory at which the analysis ends with what it has must be a positive number of megabytes, as 2000; \
         it may be left out";
    "analysis.step_limit":
        "the number of steps of integration after which the analysis ends with what it has must be positive, as 1e10; \
         it may be left out";
    "diagrams":
        "each [[diagrams]] is a one-parameter diagram and holds fixed and at, and may hold range, portraits and seed; there are at most 8";
    "diagrams.fixed":
        "the parameter that is held must be one of the two, by the name that it has in [primary] or [secondary], written in quotation marks";
    "diagrams.at": "the value of the parameter that is held must be a number inside its range";
    "diagrams.range":
        "the range of the other parameter must be [lower, upper] with finite numbers lower < upper inside its range; it may be left \
         out and is that range then";
    "diagrams.portraits":
        "the values of the other parameter at which phase portraits are drawn must be a list of at most 6 different numbers inside the \
         range of the diagram, as [0.5, 0.75]; it may be left out";
    "diagrams.seed":
        "the seed of the random initial states must be a whole number from 0 on; it may be left out and is 1 then";
};

const NAME: &str = "a name is made of the letters a to z and A to Z, digits and _, and does not begin with a digit, as \"omega\"";
const UNIT: &str = "the name of a unit must be up to 20 Latin or Greek letters, digits, blanks or / ^ * - . ( ) %, in quotation marks, as \"rad/s\"; it may be left out \
                    and changes no number";
const RANGE: &str = "the range must be [lower, upper] with finite numbers lower < upper";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_told_as_they_are_checked() {
        assert!(REQUIREMENTS.of("analysis.loops").contains(&format!(" to {MOST_LOOPS},")));
        assert!(REQUIREMENTS.of("diagrams").ends_with(&format!(" at most {MOST_DIAGRAMS}")));
        assert!(REQUIREMENTS.of("diagrams.portraits").contains(&format!(" at most {MOST_PORTRAITS} ")));
    }
}
