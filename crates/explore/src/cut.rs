//! The one-parameter diagram along a line of the plane: its branches first, then the simulated
//! long-term behaviour.

use grazing_input::Description;
use grazing_model::smooth::Stop;
use grazing_results::Dimensioned;
use grazing_results::branches::{BranchPoint, OneParameter};
use grazing_results::readings::{Ordinate, Reading};
use grazing_unfold::one_parameter::requested::{SAMPLING, in_own_units};
use grazing_unfold::one_parameter::{Cut, Line, Sampling};
use grazing_unfold::progress::Progress;
use serde::Deserialize;

use crate::answer::{Cells, Problem, answers, told};
use crate::events::Events;
use crate::model::{Model, View};

/// The request for a one-parameter diagram.
#[derive(Deserialize)]
pub(crate) struct CutRequest {
    model: Model,
    #[serde(flatten)]
    line: CutLine,
}

/// The line of the diagram, and its vertical axis.
#[derive(Deserialize)]
pub struct CutLine {
    fixed: Fixed,
    at: f64,
    range: [f64; 2],
    /// The quantity on the vertical axis; x if it is missing.
    ordinate: Option<String>,
}

/// The parameter that is held.
#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Fixed {
    Primary,
    Secondary,
}

/// The most impacts of solutions whose branches are followed from where motion settles on them.
const MOST_IMPACTS: u32 = 4;
/// The range of the parameter that is held, as a share of the file's: only its lower end is used.
const HELD: f64 = 0.01;

impl CutLine {
    /// The branches along the line, ready for simulation.
    fn follow(&self, model: &Model, progress: &dyn Progress, stop: &Stop) -> Result<Followed, Problem> {
        let &Self { fixed, at, range, .. } = self;
        // The parameter that is held needs a range, too: a small part of the file's.
        let description = model.description(None, stop)?;
        let primary_is_fixed = fixed == Fixed::Primary;
        let axis = if primary_is_fixed { description.primary() } else { description.secondary() };
        let [low, high] = axis.range();
        let held = [at, at + HELD * (high - low)];
        let [primary, secondary] = if primary_is_fixed { [held, range] } else { [range, held] };
        let (valid, _) = model.viewed(Some(&View { primary, secondary }), stop)?;
        let of = model.prepare(&valid, stop)?;
        let range = if primary_is_fixed { valid.secondary() } else { valid.primary() }.range();
        let line = Line { diagram: 1, primary_is_fixed, at, range };
        let line = line.without_dimensions(&of.axes.units);
        let cut = Cut::follow(&of.oscillator, &of.scope, &[], line, progress).ok_or_else(Problem::ended)?;
        let wanted = |ordinate: &&Ordinate| Some(ordinate.name()) == self.ordinate.as_deref();
        let ordinate = Ordinate::ALL.iter().find(wanted).copied().unwrap_or(Ordinate::X);
        let readings = if ordinate == Ordinate::X { Vec::new() } else { cut.readings() };
        Ok(Followed { description, cut, ordinate, readings })
    }

    /// The whole diagram, with simulation.
    pub(crate) fn diagram(
        &self,
        model: &Model,
        progress: &dyn Progress,
        stop: &Stop,
    ) -> Result<OneParameter, Problem> {
        let mut followed = self.follow(model, progress, stop)?;
        Ok(followed.simulated(SAMPLING, progress))
    }
}

/// The branches of a diagram with the readings of their solutions.
struct Followed {
    description: Description,
    cut: Cut,
    ordinate: Ordinate,
    readings: Vec<Reading>,
}

impl Followed {
    fn simulated(&mut self, sampling: Sampling, progress: &dyn Progress) -> OneParameter {
        let read = self.ordinate != Ordinate::X;
        let sampling = Sampling { readings: read, impacts: MOST_IMPACTS, ..sampling };
        let found = self.cut.simulated(&sampling, &[], progress);
        if read {
            self.readings = self.cut.readings();
        }
        self.read(found)
    }

    /// A diagram as it is shown.
    fn read(&self, found: OneParameter) -> OneParameter {
        let found = OneParameter { readings: self.readings.clone(), ..found };
        in_own_units(found, self.ordinate, &self.description)
    }
}

pub(crate) fn compute(request: &CutRequest, events: &Events, stop: &Stop) -> Result<(), Problem> {
    let mut followed = request.line.follow(&request.model, events, stop)?;
    events.send("branches", &Branches::of(&followed.read(followed.cut.diagram()).seen()));
    // As in the diagrams that a file asks for, but with fewer dots, to be quick.
    let found = followed.simulated(Sampling { recorded: 16, ..SAMPLING }, events).seen();
    let dots: Vec<[f64; 2]> = found.attractor.iter().map(|dot| [found.across(dot), dot.x]).collect();
    if found.branches.iter().any(|point| point.impacts > 1) {
        events.send("branches", &Branches::of(&found));
    }
    let left_out = found.simulated.map(|orbits| orbits.left_out());
    events.send("dots", &Dots { frame: found.frame.y, dots, values: SAMPLING.values, left_out });
    Ok(())
}

answers! {
    /// The branches, and the bifurcations on them, with the range of the ordinate.
    Branches { frame: [f64; 2], strands: Vec<Strand>, bifurcations: Vec<Cells>, }

    /// A piece of a branch; its points are parameter, ordinate, stability, and 1 if they are admissible or else 0.
    Strand { p: u32, impacts: u32, points: Vec<(f64, f64, &'static str, u8)>, }

    /// Simulated motion: parameters and ordinates at so many values of the parameter, and what is left out, in words.
    Dots { frame: [f64; 2], dots: Vec<[f64; 2]>, values: u32, left_out: Option<Vec<String>>, }
}

impl Branches {
    fn of(found: &OneParameter) -> Self {
        let point =
            |row: &BranchPoint| (found.across(row), row.x, row.stable.name(), u8::from(row.admissible));
        let strand = |rows: &[BranchPoint]| Strand {
            p: rows[0].loops,
            impacts: rows[0].impacts,
            points: rows.iter().map(point).collect(),
        };
        // A strand is broken where a visit is unknown.
        let pieces = found.branches.chunk_by(|a, b| a.branch == b.branch && a.x.is_nan() == b.x.is_nan());
        let strands = pieces.filter(|rows| !rows[0].x.is_nan()).map(strand).collect();
        Self { frame: found.frame.y, strands, bifurcations: found.bifurcations.iter().map(told).collect() }
    }
}
