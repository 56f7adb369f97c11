//! The results of commands without files and terminal, for programs that present them, such as the
//! package for Python.
//!
//! Each function computes the results of a command, with the code of the command.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use grazing_analysis::family::records;
use grazing_analysis::nothing::Nothing;
use grazing_analysis::place::simulated;
use grazing_description::{Description, Limits};
use grazing_drawing::SheetWidth;
use grazing_explore::{Figure, Model, Seen, View, Wanted};
use grazing_model::smooth::Stop;
use grazing_reproduction::Study;
use grazing_reproduction::parameters::Parameters;
use grazing_results::place::briefly;
use grazing_results::{Names, Table, Tables};
use grazing_source::{Setting, Text, nearest, suggestion};
use grazing_unfold::progress::Progress;

use crate::explore::drawn;
use crate::failure::Failure;
use crate::family::{self, Origin};
use crate::layout::Layout;
use crate::limits::{Watch, ended, reading};
use crate::oscillator::OscillatorFile;
use crate::outputs::family::FAMILY;
use crate::outputs::oscillator::AnalysedOscillator;
use crate::outputs::{ComputedOutput, paper};
use crate::project::{PARAMETERS, PARAMETERS_TEXT};
use crate::unfold::analysis::analyse_prepared;
use crate::unfold::{listing, page, places};
use crate::variation::Variation;

/// The results of a computation.
pub struct Results {
    /// The names of the primary and the secondary parameter in the tables.
    pub names: [String; 2],
    /// The text that the command prints.
    pub listing: String,
    /// Sentences about what is missing, or contradicts the theorems.
    pub missing: Vec<String>,
    /// The tables.
    pub tables: Vec<Table>,
    /// The figures as SVG, each under its name.
    pub figures: Vec<(String, String)>,
}

/// Receives the mark that cancels the computation that begins, and returns the receiver of its progress.
pub type Report<'a> = &'a dyn Fn(Stop) -> Box<dyn Progress + Send>;

/// An oscillator, its file's name in messages, and the receiver of progress.
pub struct Task<'a> {
    /// The oscillator.
    pub model: &'a Model,
    /// The name of its file.
    pub file: &'a str,
    /// The receiver of progress.
    pub report: Report<'a>,
}

impl Results {
    fn new(computed: ComputedOutput, names: &Names) -> Self {
        let named = |file: &str| file.trim_end_matches(".svg").to_owned();
        let figures = computed.figures.iter().map(|figure| (named(&figure.file), figure.sheet.svg()));
        Self {
            names: [names.primary.clone(), names.secondary.clone()],
            listing: computed.notes.join("\n"),
            figures: figures.collect(),
            missing: computed.gaps,
            tables: computed.tables,
        }
    }
}

impl Task<'_> {
    /// Reads and checks the oscillator.
    fn read(&self, view: Option<&View>) -> Result<OscillatorFile, Failure> {
        let read = |stop: &Stop| {
            (self.report)(stop.clone());
            self.model.read(self.file, view, stop)
        };
        let (description, taken) = reading(Path::new(self.file), Limits::USUAL, read)?;
        let text = self.model.written().to_owned();
        Ok(OscillatorFile { file: PathBuf::from(self.file), text, description, taken })
    }

    fn begin(&self, of: &OscillatorFile) -> (Watch, Box<dyn Progress + Send>) {
        let watch = Watch::begin(of.description.limits(), of.taken);
        let progress = (self.report)(watch.stop());
        (watch, progress)
    }

    /// The oscillator, and the listing that precedes all results.
    ///
    /// # Errors
    /// Something in its file is wrong.
    pub fn checked(&self) -> Result<(Description, String), Failure> {
        let of = self.read(None)?;
        let ready = self.model.ready(&of.description, &Stop::default());
        ready.map_err(|error| Failure::input(format!("{}: {error}", self.file)))?;
        let listing = listing::oscillator(Layout::default(), &of.description, &of.file);
        Ok((of.description, listing))
    }

    /// All that `unfold` computes, in a view of the plane or in the ranges of the file.
    ///
    /// # Errors
    /// There is nothing to unfold.
    pub fn diagram(&self, view: Option<&View>) -> Result<Results, Failure> {
        let of = self.read(view)?;
        let (watch, progress) = self.begin(&of);
        let prepared = self.model.ready(&of.description, &watch.stop());
        let prepared = prepared.map_err(|error| Failure::input(format!("{}: {error}", self.file)))?;
        let (unfolded, met) = analyse_prepared(&of, prepared, &watch, &*progress, &|_| ())?;
        let analysed = AnalysedOscillator::new(&of.file, &of.description, unfolded);
        let (description, unfolded) = (&of.description, &analysed.unfolded);
        let contradictions = listing::contradictions(&unfolded.resonances).into_iter();
        let contradictions =
            contradictions.map(|what| format!("theorem and computation contradict each other: {what}"));
        let lost =
            page::lost(description, unfolded).into_iter().chain(listing::incomplete(&unfolded.diagram));
        let layout = Layout::default();
        Ok(Results {
            listing: listing::oscillator(layout, description, &of.file)
                + &listing::results(layout, description, unfolded),
            missing: contradictions.chain(met.map(|met| met.to_string())).chain(lost).collect(),
            ..Results::new(analysed.computed(SheetWidth::Paper)?, &unfolded.axes.names)
        })
    }

    /// The figure that `explore` shows, with its tables.
    ///
    /// # Errors
    /// There is nothing to be seen.
    pub fn seen(&self, wanted: &Wanted) -> Result<Results, Failure> {
        let of = self.read(None)?;
        let (watch, progress) = self.begin(&of);
        let seen = Seen::of(self.model, None, wanted, &*progress, &watch.stop());
        let seen = seen.map_err(|reason| match watch.end_cause() {
            Some(cause) => ended(&of.file, Some(cause), "nothing is shown"),
            None => Failure::input(format!("{}: {reason}", self.file)),
        })?;
        let (listing, missing) = match &seen.figure {
            Figure::OneParameter(found) => {
                let broken = found.broken.iter().map(|(numbers, across, reason)| {
                    let of = briefly(*numbers);
                    format!("a branch of {of} could not be followed beyond {across}: {reason}")
                });
                (
                    listing::one_parameter(Layout::default(), &of.description, &seen.names, found),
                    broken.collect(),
                )
            }
            Figure::Place(place) => (
                places::listing(Layout::default(), std::slice::from_ref(place), &[], &seen.names),
                Vec::new(),
            ),
            Figure::Plane(..) | Figure::Straightened(_) => Default::default(),
        };
        Ok(Results { listing, missing, ..Results::new(drawn(&seen, SheetWidth::Paper)?, &seen.names) })
    }

    /// Motion at a place from a position and velocity at a time, over a number of forcing periods.
    ///
    /// # Errors
    /// There is no such motion.
    pub fn simulated(&self, at: [f64; 2], start: [f64; 3], periods: f64) -> Result<Results, Failure> {
        let of = self.read(None)?;
        let (watch, _) = self.begin(&of);
        let refused = |reason: String| Failure::input(format!("{}: {reason}", self.file));
        let ready = self.model.ready(&of.description, &watch.stop());
        let ready = ready.map_err(|error| refused(error.to_string()))?;
        let found = simulated(&ready, at, start, periods).map_err(refused)?;
        if let Some(cause) = watch.end_cause() {
            return Err(ended(&of.file, Some(cause), "nothing is shown"));
        }
        let names = &ready.axes.names;
        let computed = ComputedOutput::new(Vec::new(), found.tables(names));
        Ok(Results { listing: format!("{}\n", found.end), ..Results::new(computed, names) })
    }

    /// The family that `unfold --vary` computes.
    ///
    /// # Errors
    /// A constant cannot vary so, or no member was finished.
    pub fn family(&self, vary: &[Variation]) -> Result<Results, Failure> {
        let settings = self.model.settings(None)?.iter().map(ToString::to_string).collect();
        let text = self.model.written().to_owned();
        let origin = Origin::new(self.file.to_owned(), text, settings, self.model.loops.clone());
        let file = Path::new(self.file);
        let read = |stop: &Stop| {
            (self.report)(stop.clone());
            family::read(&origin, vary, None, stop)
        };
        let ((description, plan, members), taken) = reading(file, Limits::USUAL, read)?;
        let watch = Watch::begin(family::limits(&description, members.len()), taken);
        let progress = (self.report)(watch.stop());
        let tell = |description: &_, error: &_| Nothing::new(error, description).to_string();
        let found = records(&plan, &members, &tell, &watch.stop(), &*progress);
        let missing = found.iter().filter(|record| record.is_none()).count();
        if missing == plan.count() {
            return Err(ended(file, watch.end_cause(), "no member is finished"));
        }
        let of = family::named(file, &plan, &description, found);
        let mut results = Results::new(FAMILY.compute(&of, SheetWidth::Paper)?, &of.names);
        results.listing = family::listed(Layout::default(), &of, &plan);
        let lacking = of.family.incomplete;
        let lines = [
            (missing > 0).then(|| format!("{missing} of {} members are missing", plan.count())),
            (lacking > 0).then(|| format!("something is missing at {lacking} members")),
        ];
        results.missing.extend(lines.into_iter().flatten());
        Ok(results)
    }
}

/// The names of the outputs that [`paper()`] computes, each with its title.
pub fn outputs_of_the_paper() -> impl Iterator<Item = (&'static str, String)> {
    paper::ALL.iter().map(|output| (output.name, output.title.to_string()))
}

/// A figure or table of the paper, or beyond it, computed like `reproduce` from the default
/// parameters, with settings over them.
///
/// # Errors
/// There is no such output, or it cannot be computed with these values.
pub fn paper(name: &str, settings: &[Setting], report: Report<'_>) -> Result<Results, Failure> {
    let Some(output) = paper::ALL.iter().find(|output| output.name == name) else {
        let known: Vec<&str> = paper::ALL.iter().map(|output| output.name).collect();
        let near = suggestion(nearest(name, &known));
        return Err(Failure::input(format!(
            "{name}: there is no such output{near} Known: {}",
            known.join(", ")
        )));
    };
    let text = Text::new(PARAMETERS_TEXT, settings);
    let study = Study::new(&Parameters::parse(&text, PARAMETERS)?);
    let study = study.with_progress(Arc::from(report(Stop::default())));
    paper::refuse_malformed([output].into_iter(), &study)?;
    Ok(Results::new(output.compute(&study, SheetWidth::Paper)?, &Names::of_the_paper()))
}
