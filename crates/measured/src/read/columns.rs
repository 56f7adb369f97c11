//! The columns that files of measurements have.

/// Columns with their meanings; `{primary}` and `{secondary}` stand for the parameters' names in the
/// oscillator's file.
pub type Columns = &'static [(&'static str, &'static str)];

/// The columns of a file of places.
pub const POINTS: Columns = &[
    ("{primary}", "the primary parameter, under its name in the oscillator's file"),
    ("{secondary}", "the secondary parameter, likewise"),
    ("{primary}_error", "its standard error; empty or left out if unknown"),
    ("{secondary}_error", "its standard error; likewise"),
    ("seen", "`none` (no impacts), `periodic`, `irregular`, or a bifurcation, such as `SN`"),
    ("periods", "forcing periods after which periodic motion repeats; for `none`, 1 if empty"),
    ("impacts", "impacts in these periods"),
    ("p", "for a bifurcation, the number of loops; empty if unknown"),
    (
        "wall",
        "for a bifurcation between two walls, `1`, `2`, or `1-2` for motion that hits both; empty or left out if unknown",
    ),
];

/// The columns of a file of impacts.
pub const RECORD: Columns = &[
    ("{primary}", "the primary parameter, under its name in the oscillator's file"),
    ("{secondary}", "the secondary parameter, likewise"),
    ("series", "a name for a series of consecutive impacts; may be left out if all impacts are consecutive"),
    (
        "wall",
        "the wall that is hit, `1` or `2` in the order of the oscillator's file; may be left out if there is only one",
    ),
    ("time", "time of the impact, measured like t in the oscillator's file"),
    ("velocity_before", "speed before the impact, relative to the wall"),
    ("velocity_after", "speed after it, relative to the wall; empty or left out if it was not measured"),
    ("time_error", "standard error of the time; empty or left out if unknown"),
    ("velocity_error", "standard error of the speeds; likewise"),
];
