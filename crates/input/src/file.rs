//! The keys of a file, each with its meaning and its requirement.

use std::sync::LazyLock;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::kinds::Colour;
use grazing_results::readings::Ordinate;

use crate::document::kind::{
    Kind, any_names, choice, choices, count, counts, list, maybe, number, numbers, or, positive, table,
    tables, usual, value,
};
use crate::document::{Keys, Requirements, Section, SourceError};
use crate::keys;

/// The largest number of loops: higher ones do not relate to resonant grazing, and their curves
/// cannot be distinguished.
pub(crate) const MOST_LOOPS: u32 = 12;
/// The most impacts of solutions whose branches are followed in one-parameter diagrams.
const MOST_IMPACTS: u32 = 16;
/// The greatest number of generations.
const MOST_GENERATIONS: u32 = 3;

/// The largest number of one-parameter diagrams.
pub(crate) const MOST_DIAGRAMS: usize = 8;

/// The largest number of own curves: more could not be distinguished.
const MOST_CURVES: usize = 8;

/// The largest number of characters of the name of a curve, which is written beside the curve.
const LONGEST_NAME: usize = 24;

/// The largest number of portraits in one diagram.
const MOST_PORTRAITS: usize = 6;

/// The largest number of characters of a unit, which is written beside a name on an axis.
const LONGEST_UNIT: usize = 20;

/// The keys of a description with their requirements.
pub(crate) static REQUIREMENTS: LazyLock<Requirements> =
    LazyLock::new(|| Requirements::new("see examples/ for the keys of a file").with_keys(File::list));

keys! {
    /// A description as written.
    pub(crate) struct File {
        /// What the oscillator is called.
        name: String = value().map(name),
            "the name of the oscillator must be given before the first table, as non-empty text in quotation marks";
        /// Constants that the expressions use.
        parameters: Vec<(String, f64)> = any_names(number(..), "a constant must be a finite number"),
            "the table [parameters] holds constants by name, such as zeta = 0.02; it may be empty";
        /// The primary parameter.
        primary: Axis = axis(),
            "the table [primary] holds name and range of the parameter whose grazing value is sought";
        /// The secondary parameter.
        secondary: Axis = axis(),
            "the table [secondary] holds name and range of the parameter along the grazing curve";
        /// What the file counts in.
        units: Option<WrittenUnits> = maybe(table()),
            "the table [units] holds the names of the units of length, time and mass, such as length = \"mm\"; it may be left out";
        /// What moves the oscillator.
        motion: WrittenMotion = table(), "the table [motion] holds force and frequency";
        /// The wall.
        wall: Option<WrittenWall> = maybe(table()),
            "the table [wall] holds the position of the wall and the side of the wall on which the motion takes place; without it the wall is at x = 0; two walls are two tables [[walls]]; a wall is rigid here, and a soft stop is a part of motion.force, as -k*(x + sqrt(x^2 + s^2))/2 with a small s for a spring that is pressed where x > 0, with a rigid wall out of reach behind it";
        /// Two walls, with the motion between them.
        walls: Vec<WrittenStop> = tables(0..=2),
            "each [[walls]] is one of two rigid walls between which the motion takes place, and holds its position; it may hold side, and restitution, duration and mass in place of those of [impact]; one wall is a table [wall]";
        /// What an impact does.
        impact: Option<WrittenImpact> = maybe(table()), "the table [impact] holds restitution and duration, and may hold mass; it may be left out if each of two [[walls]] has its own";
        /// What is computed.
        analysis: WrittenAnalysis = table(),
            "the table [analysis] holds loops and may hold generations, start, time_limit, memory_limit and step_limit";
        /// How the two-parameter diagram and its magnifications are drawn.
        figure: FigureStyle = or(table(), toml::Table::new()),
            "the table [figure] may hold swap, shading, names, width, height and colours, and may be left out";
        /// Own curves in the two-parameter diagram.
        curves: Vec<WrittenCurve> = tables(0..=MOST_CURVES),
            "each [[curves]] is a curve on which maximal periodic solutions have a property, and holds name and one of impact_velocity, modulus, and distance with phase; it may hold loops; there are at most 8";
        /// One-parameter diagrams.
        diagrams: Vec<WrittenDiagram> = tables(0..=MOST_DIAGRAMS),
            "each [[diagrams]] is a one-parameter diagram and holds fixed and at, and may hold range, portraits, seed, ordinate, sweeps and impacts; there are at most 8";
    }
}

keys! {
    /// One of the two parameters.
    pub(crate) struct WrittenAxis {
        /// The name that the expressions use.
        name: String = value(), NAME;
        /// The range that is looked at.
        range: [f64; 2] = range(), "the range must be [lower, upper] with finite numbers lower < upper";
        /// The name of its unit.
        unit: Option<String> = unit(), UNIT;
    }
}

keys! {
    /// Names of units.
    pub(crate) struct WrittenUnits {
        /// The unit of length.
        length: Option<String> = unit(), UNIT;
        /// The unit of time.
        time: Option<String> = unit(), UNIT;
        /// The unit of mass, in which impact.mass counts.
        mass: Option<String> = unit(), UNIT;
    }
}

keys! {
    /// The equation of motion between impacts.
    pub(crate) struct WrittenMotion {
        /// The force F per mass.
        force: String = value(),
            "the force must be an expression in x, v, t and the parameters, in quotation marks, such as \"-2*zeta*v - x - 1 + A*cos(omega*t)\"";
        /// The forcing frequency ω.
        frequency: String = value(),
            "the forcing frequency must be an expression in the parameters, in quotation marks, such as \"omega\"";
    }
}

keys! {
    /// The wall.
    pub(crate) struct WrittenWall {
        /// Its position.
        position: String = value(),
            "the position of the wall must be an expression in t and the parameters, in quotation marks, such as \"0.0015\" or \"a*cos(omega*t)\"";
        /// The side on which the motion is.
        side: WallSide = or(side(), "below"),
            "the side of the wall on which the motion takes place must be \"below\" (less than its position) or \"above\" (greater), or else there are two tables [[walls]]; if it is left out, it is \"below\"";
    }
}

keys! {
    /// One of two walls.
    pub(crate) struct WrittenStop {
        /// Its position.
        position: String = value(),
            "the position of the wall must be an expression in t and the parameters, in quotation marks, such as \"0.0015\" or \"a*cos(omega*t)\"";
        /// The side on which the motion is.
        side: Option<WallSide> = maybe(side()),
            "the side of the wall on which the motion takes place must be \"below\" (less than its position) for one of two walls and \"above\" (greater) for the other; if it is left out, the motion is between their positions";
        /// Its restitution Φ.
        restitution: Option<String> = maybe(value()),
            "the restitution must be an expression in y, z and the parameters, in quotation marks, such as \"0.8\"; if it is left out, it is that of [impact]";
        /// The duration Ψ of impacts on it.
        duration: Option<String> = maybe(value()),
            "the impact duration must be an expression in y, z and the parameters, in quotation marks, \"0\" for impacts that take no time; if it is left out, it is that of [impact]";
        /// The mass that hits it.
        mass: Option<String> = maybe(value()),
            "the mass must be an expression in the parameters, positive and in quotation marks, such as \"0.5\" or \"m\"; if it is left out, it is that of [impact], if there is one";
    }
}

keys! {
    /// The reset law, and the mass.
    pub(crate) struct WrittenImpact {
        /// The restitution Φ.
        restitution: Option<String> = maybe(value()),
            "the restitution must be an expression in y, z and the parameters, in quotation marks, such as \"0.8\"";
        /// The impact duration Ψ.
        duration: Option<String> = maybe(value()),
            "the impact duration must be an expression in y, z and the parameters, in quotation marks, \"0\" for impacts that take no time";
        /// The mass that hits the wall, for impulse, force and power.
        mass: Option<String> = maybe(value()),
            "the mass must be an expression in the parameters, positive and in quotation marks, such as \"0.5\" or \"m\"; it may be left out";
    }
}

keys! {
    /// The numbers of loops, the start and the limits of the analysis.
    pub(crate) struct WrittenAnalysis {
        /// The numbers of loops p.
        loops: Vec<u32> = counts(1..=MOST_LOOPS),
            "the numbers of loops must be a list of different whole numbers from {} to {}, such as [1, 2, 3]";
        /// Up to which generation solutions with impacts are sought.
        generations: u32 = or(count(1..=MOST_GENERATIONS), 1),
            "the number of generations must be a whole number from {} to {}: with 2 or 3, solutions with several impacts and their regions are sought as well; if it is left out, it is 1";
        /// Where the search for the non-impacting motion starts.
        start: Option<[f64; 2]> = maybe(numbers()),
            "the start of the search for the non-impacting motion must be position and velocity at time zero, two finite numbers, such as [-1.0, 0.0]; it may be left out";
        /// The time limit, in seconds of CPU time.
        time_limit: f64 = limit(AnalysisLimits::USUAL.time),
            "the time after which the analysis stops with partial results must be a positive number of seconds of CPU time, such as 600; it may be left out";
        /// The memory limit, in megabytes.
        memory_limit: f64 = limit(AnalysisLimits::USUAL.memory),
            "the memory at which the analysis stops with partial results must be a positive number of megabytes, such as 2000; it may be left out";
        /// The limit of steps of integration.
        step_limit: f64 = limit(AnalysisLimits::USUAL.steps),
            "the number of integration steps after which the analysis stops with partial results must be positive, such as 1e10; it may be left out";
    }
}

keys! {
    /// How the two-parameter diagram and its magnifications are drawn.
    pub struct FigureStyle {
        /// The secondary parameter is across and the primary one up.
        swap: bool = or(value(), false),
            "swap must be true, for the secondary parameter across and the primary one up, or false; if it is left out, it is false";
        /// Regions of stability are grey.
        shading: bool = or(value(), true),
            "shading must be true, for regions of stability in grey, or false; if it is left out, it is true";
        /// What has its name written beside it.
        names: Vec<LabelKind> = or(choices(LabelKind::ALL.map(|named| (named.word(), named))), LabelKind::ALL.map(LabelKind::word).to_vec()),
            "names must list what is labelled in the figure, from \"curves\", \"regions\", \"magnifications\" and \"diagrams\", such as [\"curves\"]; if it is left out, all have their names";
        /// The width of the diagram, in millimetres.
        width: Option<f64> = maybe(number(60.0..=400.0)),
            "the width of the diagram must be from 60 to 400, in millimetres; if it is left out, it is 120";
        /// The height of the diagram, in millimetres.
        height: Option<f64> = maybe(number(40.0..=400.0)),
            "the height of the diagram must be from 40 to 400, in millimetres; if it is left out, it follows from the width";
        /// The colours of kinds of curves.
        colours: Vec<(Bifurcation, Colour)> = or(colours(), toml::Table::new()),
            "the table [figure.colours] holds colours of curves by their kinds, {}, such as SN = \"#1946be\"; it may be left out";
    }
}

keys! {
    /// A curve on which MPSs have a property.
    pub(crate) struct WrittenCurve {
        /// What the curve is called in figures and tables.
        name: String = value().such(|name: &String| curve_name(name)),
            "the name of a curve must be up to 24 letters, digits, blanks or = . , - + ( ) /, in quotation marks, such as \"hard hits\"";
        /// The impact velocity along it.
        impact_velocity: Option<f64> = maybe(positive()), POSITIVE;
        /// The larger modulus of the two stability multipliers along it.
        modulus: Option<f64> = maybe(positive()), POSITIVE;
        /// The distance from the wall along it, where the forcing is at the phase.
        distance: Option<f64> = maybe(positive()), POSITIVE;
        /// That phase, in forcing periods.
        phase: Option<f64> = maybe(number(0.0..1.0)),
            "the phase, in forcing periods, must be at least 0 and less than 1; it is given together with distance";
        /// The numbers of loops p of the solutions.
        loops: Option<Vec<u32>> = maybe(counts(1..=MOST_LOOPS)),
            "the numbers of loops must be a list of different whole numbers from analysis.loops, such as [1, 2]; if it is left out, all of these are used";
    }
}

keys! {
    /// A one-parameter diagram.
    pub(crate) struct WrittenDiagram {
        /// The name of the parameter that is held.
        fixed: String = value(),
            "the fixed parameter must be one of the two, under its name in [primary] or [secondary], in quotation marks";
        /// Its value.
        at: f64 = number(..), "the value of the fixed parameter must be a number inside its range";
        /// The range of the other parameter.
        range: Option<[f64; 2]> = maybe(range()),
            "the range of the other parameter must be [lower, upper] with finite numbers lower < upper inside its range; if it is left out, it is the whole range";
        /// Values of the other parameter at which phase portraits are drawn.
        portraits: Vec<f64> = or(list(MOST_PORTRAITS).map(portraits), Vec::<f64>::new()),
            "the values of the other parameter at which phase portraits are drawn must be a list of at most 6 different numbers inside the range of the diagram, such as [0.5, 0.75]; it may be left out";
        /// The seed of the random initial states.
        seed: u64 = or(value(), 1),
            "the seed of the random initial states must be a whole number that is not negative; if it is left out, it is 1";
        /// What stands on the vertical axis.
        ordinate: Ordinate = or(ordinate(), Ordinate::X.name()),
            "the ordinate must be {}, of which {} need impact.mass; if it is left out, it is \"x\"";
        /// Motion is followed as the parameter goes up and down.
        sweeps: bool = or(value(), false),
            "sweeps must be true or false; if it is left out, it is false";
        /// Branches of solutions with several impacts, up to so many, are followed from where simulated motion settles on them.
        impacts: u32 = or(count(1..=MOST_IMPACTS), 1),
            "the most impacts of solutions whose branches are followed must be a whole number from {} to {}; if it is left out, it is 1";
    }
}

impl Default for FigureStyle {
    /// The style of the paper.
    fn default() -> Self {
        usual()
    }
}

/// A kind of object whose name may be written in a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LabelKind {
    /// Curves, by their kinds.
    Curves,
    /// Regions, by their numbers of loops.
    Regions,
    /// Magnifications, by letters.
    Magnifications,
    /// The lines along which one-parameter diagrams run.
    Diagrams,
}

impl LabelKind {
    /// All kinds of objects.
    pub const ALL: [Self; 4] = [Self::Curves, Self::Regions, Self::Magnifications, Self::Diagrams];

    /// The word for them in a file.
    const fn word(self) -> &'static str {
        match self {
            Self::Curves => "curves",
            Self::Regions => "regions",
            Self::Magnifications => "magnifications",
            Self::Diagrams => "diagrams",
        }
    }
}

/// One of the two parameters with its range.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    pub(crate) name: String,
    pub(crate) range: [f64; 2],
    pub(crate) unit: Option<String>,
}

impl Axis {
    /// The name that the expressions use.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The lower and the upper end of the range: finite, lower < upper.
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// The name of the parameter's unit, if the file has one.
    pub fn unit(&self) -> Option<&str> {
        self.unit.as_deref()
    }
}

/// The side of the wall on which the motion is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WallSide {
    /// Less than the position of the wall, as in the paper.
    Below,
    /// Greater than the position of the wall.
    Above,
}

impl WallSide {
    /// The name, `below` or `above`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Below => "below",
            Self::Above => "above",
        }
    }

    /// The other side.
    pub(crate) const fn opposite(self) -> Self {
        match self {
            Self::Below => Self::Above,
            Self::Above => Self::Below,
        }
    }

    /// The sign s = ±1 in u = s(x − W).
    pub(crate) const fn sign(self) -> f64 {
        match self {
            Self::Below => 1.0,
            Self::Above => -1.0,
        }
    }
}

/// The limits at which an analysis ends with the results that it has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnalysisLimits {
    /// Seconds of CPU time, of all threads together.
    pub time: f64,
    /// Megabytes that the process holds.
    pub memory: f64,
    /// Steps of integration.
    pub steps: f64,
}

impl AnalysisLimits {
    /// The default limits: the examples take seconds and 50 MB, and a user who has waited for ten
    /// minutes wants to see a result. The steps are more than two cores make in that time.
    pub const USUAL: Self = Self { time: 600.0, memory: 2000.0, steps: 1e10 };
}

const POSITIVE: &str =
    "a curve has one of impact_velocity, modulus and distance: a positive number, in the units of the file";
const NAME: &str = "a name is made of the letters a to z and A to Z, digits and _, and does not begin with a digit, such as \"omega\"";
const UNIT: &str = "the name of a unit must be up to 20 Latin or Greek letters, digits, blanks or / ^ * - . ( ) %, in quotation marks, such as \"rad/s\"; it may be left out and does not change any number";

/// The name of the oscillator without surrounding blanks.
fn name(written: String, section: &Section<'_>, key: &str) -> Result<String, SourceError> {
    let name = written.trim();
    if name.is_empty() { Err(section.refusal(key)) } else { Ok(name.to_owned()) }
}

/// Whether a name can be written beside a curve in a figure.
fn curve_name(name: &str) -> bool {
    let shown = |character: char| character.is_ascii_alphanumeric() || " =.,-+()/".contains(character);
    !name.trim().is_empty() && name.chars().count() <= LONGEST_NAME && name.chars().all(shown)
}

fn axis() -> Kind<Axis> {
    table().map(|WrittenAxis { name, range, unit }, _, _| Ok(Axis { name, range, unit }))
}

fn limit(usual: f64) -> Kind<f64> {
    or(positive(), usual)
}

fn range() -> Kind<[f64; 2]> {
    numbers().map(|[lower, upper]: [f64; 2], section, name| {
        if lower == upper {
            return Err(section.refusal(name));
        }
        if lower > upper {
            let allowed = format!("the range is reversed: write [{upper:?}, {lower:?}]");
            return Err(section.forbid(name, allowed));
        }
        if (upper - lower).is_infinite() {
            let allowed = "the range is too wide to compute with: upper - lower must be a finite number";
            return Err(section.forbid(name, allowed.to_owned()));
        }
        Ok([lower, upper])
    })
}

/// The values in increasing order.
fn portraits(mut values: Vec<f64>, section: &Section<'_>, name: &str) -> Result<Vec<f64>, SourceError> {
    values.sort_by(f64::total_cmp);
    let twice = values.windows(2).any(|pair| pair[0] == pair[1]);
    if twice { Err(section.refusal(name)) } else { Ok(values) }
}

/// A side of the wall.
fn side() -> Kind<WallSide> {
    choice([WallSide::Below, WallSide::Above].map(|side| (side.name(), side)))
}

/// Words in quotation marks, as a list with this word before the last.
fn listed(words: impl Iterator<Item = &'static str>, last: &str) -> String {
    let quoted: Vec<String> = words.map(|word| format!("\"{word}\"")).collect();
    let (end, others) = quoted.split_last().expect("there are some");
    format!("{} {last} {end}", others.join(", "))
}

/// One of the quantities that results know.
fn ordinate() -> Kind<Ordinate> {
    let names =
        |which: fn(&Ordinate) -> bool| Ordinate::ALL.iter().copied().filter(which).map(Ordinate::name);
    let named = choice(Ordinate::ALL.iter().map(|ordinate| (ordinate.name(), *ordinate)));
    named.saying([listed(names(|_| true), "or"), listed(names(|ordinate| ordinate.needs_mass()), "and")])
}

/// Colours by kinds of curves.
fn colours() -> Kind<Vec<(Bifurcation, Colour)>> {
    let kinds = Bifurcation::NAMES;
    let requirement = format!(
        "a colour is given under the kind of curve, {kinds}, as # with six hexadecimal digits in quotation marks, such as SN = \"#1946be\""
    );
    let colours = any_names(value().map(colour), requirement);
    let kind = |(_, coloured): (String, (Bifurcation, Colour))| coloured;
    let colours =
        colours.map(move |all, _, _| Ok(all.into_iter().map(kind).collect())).saying([kinds.to_owned()]);
    let names = Bifurcation::ALL.map(Bifurcation::name).to_vec();
    colours.with("propertyNames", toml::Table::from_iter([("enum".to_owned(), names.into())]))
}

/// A colour as `#1946be`, red, green and blue by two hexadecimal digits each, for the kind of curve that is the key.
fn colour(written: String, section: &Section<'_>, kind: &str) -> Result<(Bifurcation, Colour), SourceError> {
    let digits = written.strip_prefix('#').filter(|digits| digits.len() == 6 && digits.is_ascii());
    let channel = |place: usize| u8::from_str_radix(digits?.get(place..place + 2)?, 16).ok();
    match ([channel(0), channel(2), channel(4)], Bifurcation::named(kind)) {
        ([Some(red), Some(green), Some(blue)], Some(kind)) => Ok((kind, [red, green, blue])),
        _ => Err(section.refusal(kind)),
    }
}

/// A key that may hold the name of a unit.
fn unit() -> Kind<Option<String>> {
    // Greek letters in the fonts of the figures.
    let greek = |character: char| ('α'..='ω').contains(&character) || ('Α'..='Ω').contains(&character);
    let shown = move |character: char| {
        character.is_ascii_alphanumeric() || greek(character) || " /^*-.()°µ%·²³⁻¹".contains(character)
    };
    let named = value().such(move |unit: &String| {
        !unit.trim().is_empty() && unit.chars().count() <= LONGEST_UNIT && unit.chars().all(shown)
    });
    maybe(named.map(|unit, _, _| Ok(unit.trim().to_owned())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_said_as_they_are_checked() {
        assert!(REQUIREMENTS.of("diagrams").ends_with(&format!(" at most {MOST_DIAGRAMS}")));
        assert!(REQUIREMENTS.of("curves").ends_with(&format!(" at most {MOST_CURVES}")));
        assert!(REQUIREMENTS.of("curves.name").contains(&format!(" up to {LONGEST_NAME} ")));
        assert!(REQUIREMENTS.of("diagrams.portraits").contains(&format!(" at most {MOST_PORTRAITS} ")));
        assert!(REQUIREMENTS.of("primary.unit").contains(&format!(" up to {LONGEST_UNIT} ")));
    }
}
