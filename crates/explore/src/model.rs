//! The oscillator of a request.

use std::collections::BTreeMap;

use grazing_input::{Axis, Description, DescriptionError, Mistake, Note, Setting, SettingError, Text};
use grazing_model::smooth::{Stop, Stoppable};
use grazing_model::{AnyOscillator, LinearOscillator, OscillatorError};
use grazing_results::readings::Ordinate;
use grazing_unfold::Scope;
use grazing_unfold::described::{Axes, Prepared};
use serde::{Deserialize, Serialize};

use crate::answer::{Problem, answers};

/// The oscillator that a request is about, as the page sends it.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Model {
    /// The text of the file; none for the paper's oscillator, whose flow is known in closed form.
    pub text: Option<String>,
    /// Values that replace those of constants in the file.
    #[serde(default)]
    pub set: BTreeMap<String, f64>,
    /// Numbers of loops that replace those of the file.
    pub loops: Option<Vec<u32>>,
}

/// A view of the plane, in the oscillator's own units.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
pub struct View {
    /// The range of the primary parameter.
    pub primary: [f64; 2],
    /// The range of the secondary parameter.
    pub secondary: [f64; 2],
}

answers! {
    /// What is said of a file: what it describes, or its mistake.
    Checked { ok: bool, #[serde(flatten)] described: Option<Described>, #[serde(flatten)] mistake: Option<Mistake>, }

    /// The description of an oscillator, before anything is computed.
    Described {
        name: String, primary: Parameter, secondary: Parameter, units: UnitsOfFile,
        constants: Vec<Constant>, loops: Vec<u32>, notes: Vec<Mistake>,
        /// Whether x is measured from the wall: unless this is at x = 0 with the motion below it.
        from_the_wall: bool,
        /// The number of walls.
        walls: usize,
        /// The quantities on the vertical axis of a one-parameter diagram.
        ordinates: Vec<NamedQuantity>,
    }

    /// A parameter of the plane, with its title in label markup.
    Parameter { name: String, title: String, range: [f64; 2], unit: Option<String>, }

    /// A constant of the file.
    Constant { name: String, value: f64, }

    /// A quantity with the name of its unit.
    NamedQuantity { name: &'static str, unit: Option<String>, }

    /// The names of units.
    UnitsOfFile { length: Option<String>, time: Option<String>, }
}

/// What a model describes, or the mistake in it, which is an answer, too.
pub(crate) fn check(model: &Model, stop: &Stop) -> Result<Checked, Problem> {
    match model.described(stop) {
        _ if stop.is_asked() => Err(Problem::ended()),
        Ok(described) => Ok(Checked { ok: true, described: Some(described), mistake: None }),
        Err(mistake) => Ok(Checked { ok: false, described: None, mistake: Some(mistake) }),
    }
}

/// The name of the file in messages.
const FILE: &str = "oscillator.toml";
/// The text that describes the paper's oscillator: its constants, ranges and loops, and its motion
/// where it has to be integrated.
pub(crate) const PAPER: &str = include_str!("../../../examples/paper.toml");

impl View {
    /// The ranges of a description.
    pub(crate) fn of(description: &Description) -> Self {
        Self { primary: description.primary().range(), secondary: description.secondary().range() }
    }
}

impl Model {
    /// The text of the file, or of the one that describes the paper's oscillator.
    pub fn written(&self) -> &str {
        self.text.as_deref().unwrap_or(PAPER)
    }

    /// The settings over the text of the file, for a view of the plane or for the file's own.
    ///
    /// # Errors
    /// A constant has an impossible name, or too many are set.
    pub fn settings(&self, view: Option<&View>) -> Result<Vec<Setting>, SettingError> {
        if self.set.len() > Setting::MOST {
            return Err(SettingError::too_many(self.set.len()));
        }
        let constants =
            self.set.iter().map(|(name, value)| Setting::new(&format!("parameters.{name}"), *value));
        // One-parameter diagrams need not lie in the view, and are not requested.
        let ranges = view.into_iter().flat_map(|View { primary, secondary }| {
            let range = |key: &str, range: &[f64; 2]| Setting::new(key, range.to_vec());
            let none = Setting::new("diagrams", Vec::<f64>::new());
            [range("primary.range", primary), range("secondary.range", secondary), none]
        });
        constants.chain(ranges).collect()
    }

    /// The oscillator as its file describes it, in the ranges of a view or in its own, unless
    /// `stop` cancels the reading; messages use this name of the file.
    ///
    /// # Errors
    /// Something in the text, or in the settings over it, is wrong.
    pub fn read<E>(&self, file: &str, view: Option<&View>, stop: &Stop) -> Result<Description, E>
    where
        E: From<SettingError> + From<DescriptionError>,
    {
        let settings = self.settings(view)?;
        let description = Description::parse_with(&Text::new(self.written(), &settings), file, stop)?;
        Ok(match &self.loops {
            Some(loops) => description.with_loops(loops)?,
            None => description,
        })
    }

    pub(crate) fn description(&self, view: Option<&View>, stop: &Stop) -> Result<Description, Mistake> {
        self.read(FILE, view, stop)
    }

    /// The oscillator in the part of a view in which it is valid, or in the ranges of its file; and what is wrong
    /// in the rest of the view.
    ///
    /// # Errors
    /// The file is wrong, or nothing in the view is valid.
    pub(crate) fn viewed(
        &self,
        view: Option<&View>,
        stop: &Stop,
    ) -> Result<(Description, Option<Mistake>), Mistake> {
        let (view, mistake) = match (view, self.description(view, stop)) {
            (_, Ok(description)) => return Ok((description, None)),
            (None, Err(mistake)) => return Err(mistake),
            (Some(view), Err(mistake)) => (view, mistake),
        };
        let own = self.description(None, stop)?;
        let Some([primary, secondary]) = own.valid_part([view.primary, view.secondary], stop) else {
            return Err(mistake);
        };
        Ok((self.description(Some(&View { primary, secondary }), stop)?, Some(mistake)))
    }

    /// The oscillator in the part of a view in which it is valid, or in the ranges of its file; `stop` cancels
    /// its computations.
    pub(crate) fn prepared(&self, view: Option<&View>, stop: &Stop) -> Result<Prepared, Mistake> {
        self.prepare(&self.viewed(view, stop)?.0, stop)
    }

    /// An oscillator from its description, with a mistake instead of an error.
    pub(crate) fn prepare(&self, description: &Description, stop: &Stop) -> Result<Prepared, Mistake> {
        self.ready(description, stop).map_err(|error| Mistake::new(error.to_string()))
    }

    /// An oscillator from its description, ready for an analysis.
    ///
    /// # Errors
    /// The constants of the paper's oscillator are wrong.
    pub fn ready(&self, description: &Description, stop: &Stop) -> Result<Prepared, OscillatorError> {
        match self.text {
            Some(_) => Ok(Prepared::of(description, stop)),
            None => closed_form(description, stop),
        }
    }

    /// What the file describes.
    fn described(&self, stop: &Stop) -> Result<Described, Mistake> {
        let description = self.description(None, stop)?;
        let names = self.prepared(None, stop)?.axes.names;
        let parameter = |name: &str, title: String, axis: &Axis| Parameter {
            name: name.to_owned(),
            title,
            range: axis.range(),
            unit: axis.unit().map(str::to_owned),
        };
        let [primary, secondary] = names.titles();
        let [length, time, _] = description.unit_names().map(|name| name.map(str::to_owned));
        let units = Axes::of(&description).names;
        let quantity = |ordinate: &Ordinate| {
            let (name, (_, unit)) = (ordinate.name(), ordinate.column());
            let is_known = description.has_mass() || !ordinate.needs_mass();
            is_known.then(|| NamedQuantity { name, unit: units.named_unit(unit) })
        };
        let constants =
            description.constants().map(|(name, value)| Constant { name: name.to_owned(), value });
        Ok(Described {
            name: description.name().to_owned(),
            primary: parameter(&names.primary, primary, description.primary()),
            secondary: parameter(&names.secondary, secondary, description.secondary()),
            constants: constants.collect(),
            loops: description.loops().to_vec(),
            notes: description.notes().iter().map(Note::mistake).collect(),
            from_the_wall: !description.wall().is_usual(),
            walls: description.from_each_wall().count(),
            ordinates: Ordinate::ALL.iter().filter_map(quantity).collect(),
            units: UnitsOfFile { length, time },
        })
    }
}

/// The paper's oscillator, whose flow is known in closed form, with the constants, ranges and loops of the text that describes it.
///
/// # Errors
/// ζ, ε, a frequency or an amplitude is out of its domain.
fn closed_form(description: &Description, stop: &Stop) -> Result<Prepared, OscillatorError> {
    let [zeta, epsilon] = ["zeta", "epsilon"].map(|wanted| {
        let mut constants = description.constants();
        constants.find(|(name, _)| *name == wanted).map_or(f64::NAN, |(_, value)| value)
    });
    let written = Prepared::new(description, Axes::of_the_paper(), stop);
    let window = written.scope.window;
    let oscillator = LinearOscillator::new(zeta, epsilon, window.primary[0], window.secondary[0])?;
    let oscillator = AnyOscillator::new(Stoppable::new(oscillator, stop.clone()));
    Ok(Prepared { oscillator, scope: Scope { start: None, ..written.scope }, ..written })
}
