//! The results of commands without files and terminal, for programs that present them, such as the
//! package for Python.
//!
//! Each function computes the results of a command, with the code of the command.

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use grazing_beyond::parameters;
use grazing_drawing::SheetWidth;
use grazing_explore::{Figure, Model, Seen, View, Wanted};
use grazing_input::{AnalysisLimits, Description, Setting, Text, nearest, suggestion};
use grazing_model::smooth::Stop;
use grazing_reproduction::Study;
use grazing_results::place::briefly;
use grazing_results::{Names, Table, Tables};
use grazing_unfold::described::Prepared;
use grazing_unfold::place::simulated;

use crate::explore::drawn;
use crate::failure::Failure;
use crate::family::{FamilyMembers, FamilyOrigin};
use crate::layout::Layout;
use crate::limits::{ended, reading};
use crate::oscillator::OscillatorFile;
use crate::outputs::family::FAMILY;
use crate::outputs::{ComputedOutput, paper};
use crate::project::{PARAMETERS, PARAMETERS_TEXT};
use crate::runner::Running;
pub use crate::runner::StartProgress;
use crate::unfold::{self, listing, page, places};
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

/// An oscillator, its file's name in messages, and the receiver of progress.
pub struct LibraryTask<'a> {
    /// The oscillator.
    pub model: &'a Model,
    /// The name of its file.
    pub file: &'a str,
    /// The receiver of progress.
    pub report: StartProgress<'a>,
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

impl LibraryTask<'_> {
    /// Reads and checks the oscillator.
    fn read(&self, view: Option<&View>) -> Result<OscillatorFile, Failure> {
        let read = |stop: &Stop| {
            (self.report)(stop.clone());
            self.model.read(self.file, view, stop)
        };
        let (description, taken) = reading(Path::new(self.file), AnalysisLimits::USUAL, read)?;
        let (text, settings) = (self.model.written().to_owned(), self.model.settings(view)?);
        Ok(OscillatorFile { file: PathBuf::from(self.file), text, settings, description, taken })
    }

    fn running(&self, of: &OscillatorFile) -> Running<'_> {
        Running::begin(Some((of.description.limits(), of.taken)), self.report)
    }

    fn refused(&self, reason: impl Display) -> Failure {
        Failure::input(format!("{}: {reason}", self.file))
    }

    fn prepared(&self, of: &OscillatorFile, stop: &Stop) -> Result<Prepared, Failure> {
        self.model.ready(&of.description, stop).map_err(|error| self.refused(error))
    }

    /// The oscillator, and the listing that precedes all results.
    ///
    /// # Errors
    /// Something in its file is wrong.
    pub fn checked(&self) -> Result<(Description, String), Failure> {
        let of = self.read(None)?;
        self.prepared(&of, &Stop::default())?;
        let listing = listing::oscillator(Layout::default(), &of.description, &of.file);
        Ok((of.description, listing))
    }

    /// All that `unfold` computes, in a view of the plane or in the ranges of the file.
    ///
    /// # Errors
    /// There is nothing to unfold.
    pub fn diagram(&self, view: Option<&View>) -> Result<Results, Failure> {
        let of = self.read(view)?;
        let head = listing::oscillator(Layout::default(), &of.description, &of.file);
        let running = self.running(&of);
        let task = unfold::UnfoldTask { of, measured: None, at: Vec::new() };
        let found = unfold::unfold(task, &|of, stop| self.prepared(of, stop), &running, &|_| ())?;
        let (analysed, description) = (&found.analysed, &found.analysed.oscillator.description);
        let unfolded = &analysed.unfolded;
        let contradictions = listing::contradictions(&unfolded.resonances).into_iter();
        let contradictions =
            contradictions.map(|what| format!("theorem and computation contradict each other: {what}"));
        let lost =
            page::lost(description, unfolded).into_iter().chain(listing::incomplete(&unfolded.diagram));
        Ok(Results {
            listing: head + &found.listing(Layout::default()),
            missing: contradictions.chain(found.met.map(|met| met.to_string())).chain(lost).collect(),
            ..Results::new(analysed.computed(SheetWidth::Paper)?, &unfolded.axes.names)
        })
    }

    /// The figure that `explore` shows, with its tables.
    ///
    /// # Errors
    /// There is nothing to be seen.
    pub fn seen(&self, wanted: &Wanted) -> Result<Results, Failure> {
        let of = self.read(None)?;
        let running = self.running(&of);
        let seen = Seen::of(self.model, None, wanted, &**running.progress(), &running.stop());
        let seen =
            seen.map_err(|reason| running.failure(&of.file, "nothing is shown", || self.refused(reason)))?;
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
        let running = self.running(&of);
        let ready = self.prepared(&of, &running.stop())?;
        let found = simulated(&ready, at, start, periods).map_err(|reason| self.refused(reason))?;
        if let Some(cause) = running.end_cause() {
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
        let origin = FamilyOrigin::new(self.file.to_owned(), text, settings, self.model.loops.clone());
        let file = Path::new(self.file);
        let read = |stop: &Stop| {
            (self.report)(stop.clone());
            FamilyMembers::read(&origin, vary, None, stop)
        };
        let (family, taken) = reading(file, AnalysisLimits::USUAL, read)?;
        let running = Running::begin(Some((family.limits(), taken)), self.report);
        let found = family.records(&running);
        let (missing, all) = (found.iter().filter(|record| record.is_none()).count(), found.len());
        if missing == all {
            return Err(ended(file, running.end_cause(), "no member is finished"));
        }
        let (of, listing) = family.named(Layout::default(), file, found);
        let results = Results::new(FAMILY.compute(&of, SheetWidth::Paper)?, &of.names);
        let lacking = of.family.incomplete;
        let lines = [
            (missing > 0).then(|| format!("{missing} of {all} members are missing")),
            (lacking > 0).then(|| format!("something is missing at {lacking} members")),
        ];
        let missing = results.missing.iter().cloned().chain(lines.into_iter().flatten()).collect();
        Ok(Results { listing, missing, ..results })
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
pub fn paper(name: &str, settings: &[Setting], report: StartProgress<'_>) -> Result<Results, Failure> {
    let Some(output) = paper::ALL.iter().find(|output| output.name == name) else {
        let known: Vec<&str> = paper::ALL.iter().map(|output| output.name).collect();
        let near = suggestion(nearest(name, &known));
        return Err(Failure::input(format!(
            "{name}: there is no such output{near} Known: {}",
            known.join(", ")
        )));
    };
    let text = Text::new(PARAMETERS_TEXT, settings);
    let study = Study::new(&parameters::parse(&text, PARAMETERS)?);
    let study = study.with_progress(Arc::from(report(Stop::default())));
    paper::refuse_malformed([output].into_iter(), &study)?;
    Ok(Results::new(output.compute(&study, SheetWidth::Paper)?, &Names::of_the_paper()))
}
