//! The results for one member of a family.

use crate::diagram::CodimensionTwoPoint;
use crate::resonances;
use crate::verdict::coefficients;
use crate::{Diagram, UnfoldError};
use grazing_continuation::mps::unknown;
use grazing_input::Description;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::{Stop, Units};
use grazing_results::family::{
    Degeneracy, Degenerate, FamilyCurvePoint, FamilyPoint, FamilyResonance, FoundBy, Member,
};
use grazing_results::resonance::{Coefficients, Measured};
use grazing_results::{Dimension, Dimensioned, VARIED, dimensioned};
use grazing_theorems::ResonantPoint;
use grazing_theorems::hypothesis::Quantity;
use serde::{Deserialize, Serialize};

use super::{Arc, ArcEnd, ArcPoint, FamilyPlan, Tell, arcs};
use crate::described::{Axes, Prepared};
use crate::unfolded::measured;

/// The results for a member of a family: its own rows, and its resonances followed towards its
/// neighbours. Curves and arcs are numbered when all records are available.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Record {
    /// The number of the member, from 0.
    pub index: usize,
    pub(super) member: Member,
    /// Whether something was detected that could not be located or followed.
    pub(super) incomplete: bool,
    #[serde(default)]
    pub(super) resonances: Vec<FamilyResonance>,
    #[serde(default)]
    pub(super) points: Vec<FamilyPoint>,
    #[serde(default)]
    pub(super) ways: Vec<Way>,
}

/// The path of a resonance to the next member, or between this member and a neighbour.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Way {
    /// The index of the resonance in the member's list.
    pub(super) from: usize,
    pub(super) to: Destination,
    #[serde(default)]
    pub(super) curve: Vec<FamilyCurvePoint>,
    #[serde(default)]
    pub(super) degenerate: Vec<Degenerate>,
}

/// The destination of a path.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) enum Destination {
    /// The next member, at this resonance.
    Next(Box<FamilyResonance>),
    /// The member itself, at the resonance with this index.
    Back(usize),
    /// None: the resonance ceases to exist or is lost between the members.
    Nowhere,
}

impl Record {
    /// Analyses a member; none if the computation is cancelled.
    pub(super) fn compute(
        plan: &FamilyPlan,
        index: usize,
        description: &Description,
        tell: Tell<'_>,
        stop: &Stop,
    ) -> Option<Self> {
        if stop.is_asked() {
            return None;
        }
        let values = plan.values(index);
        let axes = Axes::of(description);
        let prepared = |description: &Description| Prepared {
            requested: Vec::new(),
            ..Prepared::new(description, axes.clone(), stop)
        };
        let (here, units) = (prepared(description), axes.units);
        let varied = padded(&values);
        let member = Member { varied, resonances: 0, points: 0, missing: String::new() };
        let (resonances, points, ways) = (Vec::new(), Vec::new(), Vec::new());
        let mut record = Self { index, member, incomplete: false, resonances, points, ways };
        let (mut missing, mut nothing): (Vec<String>, Option<UnfoldError>) = (Vec::new(), None);
        let mut grazes = false;
        for (order, view) in here.from_each_wall().enumerate() {
            let rows = Rows { units, varied, first: VARIED - values.len(), wall: view.wall };
            let located = match view.located(stop).and_then(Diagram::with_grazing) {
                Ok(located) => located,
                Err(error) => {
                    nothing.get_or_insert(error);
                    continue;
                }
            };
            let followed = located.follow(stop, &|_, _| ());
            let diagram = located.with_curves(followed);
            missing.extend(diagram.lost());
            let (place, along) = (index % plan.line(), &plan.varied[0]);
            let after = along.values.get(place + 1);
            let before = place.checked_sub(1).map(|before| &along.values[before]);
            let first = record.resonances.len();
            for (neighbour, onwards) in [(after, true), (before, false)] {
                let Some(&neighbour) = neighbour else { continue };
                let at = |way: f64| {
                    let value = values[0] + (neighbour - values[0]) * way;
                    let there = prepared(&description.with_constant(&along.name, value).ok()?);
                    there.from_each_wall().nth(order).map(|view| view.oscillator)
                };
                let arcs = arcs(&diagram, &at);
                // The path back to the previous member is stored as that member's path to this one.
                let kept = arcs.iter().filter(|arc| onwards || arc.end != ArcEnd::Across);
                record.ways.extend(kept.map(|arc| rows.way(&diagram, arc, neighbour).after(first)));
            }
            record.resonances.extend(diagram.resonances.iter().map(|resonance| rows.resonance(resonance)));
            record.points.extend(rows.points(&diagram));
            grazes = true;
        }
        // One wall may be out of reach.
        if let Some(error) = nothing.filter(|_| !grazes) {
            record.member.missing = tell(description, &error.with_dimensions(&units));
            return (!stop.is_asked()).then_some(record);
        }
        missing.dedup();
        record.incomplete = !missing.is_empty();
        record.member.missing = missing.join("; ");
        (!stop.is_asked()).then(|| record.with_dimensions(&units))
    }

    /// Whether the record is plausible as that of this member of a family with these numbers of loops,
    /// regardless of its origin: constants, indices and numbers of loops must fit, and the coordinates of
    /// resonances must be finite.
    pub fn fits(&self, plan: &FamilyPlan, index: usize, loops: &[u32]) -> bool {
        let expected = padded(&plan.values(index));
        let same = |a: f64, b: f64| a == b || (a.is_nan() && b.is_nan());
        let of_member = |varied: &[f64; VARIED]| varied.iter().zip(expected).all(|(a, b)| same(*a, b));
        let at_resonance = |row: &FamilyResonance| {
            let numbers = [row.primary, row.secondary, row.phase];
            loops.contains(&row.loops) && numbers.iter().all(|number| number.is_finite())
        };
        let found = |row: &FamilyResonance| at_resonance(row) && of_member(&row.varied);
        let leads = |way: &Way| {
            let is_there = match &way.to {
                Destination::Next(next) => at_resonance(next),
                Destination::Back(to) => *to < self.resonances.len(),
                Destination::Nowhere => true,
            };
            let curve = way.curve.iter().map(|row| row.loops);
            let degenerate = way.degenerate.iter().map(|row| row.loops);
            let known = curve.chain(degenerate).all(|number| loops.contains(&number));
            is_there && known && way.from < self.resonances.len()
        };
        let points = |row: &FamilyPoint| loops.contains(&row.loops) && of_member(&row.varied);
        self.index == index
            && of_member(&self.member.varied)
            && self.resonances.iter().all(found)
            && self.points.iter().all(points)
            && self.ways.iter().all(leads)
    }

    /// Updates the numbers of resonances and points.
    pub(super) fn count(&mut self) {
        self.member.resonances = self.resonances.len() as u32;
        self.member.points = self.points.len() as u32;
    }
}

/// The values in the last columns, preceded by NaN.
fn padded(values: &[f64]) -> [f64; VARIED] {
    let mut padded = [f64::NAN; VARIED];
    padded[VARIED - values.len()..].copy_from_slice(values);
    padded
}

impl Way {
    /// The path in a list of resonances in which so many others come first.
    fn after(self, others: usize) -> Self {
        let to = match self.to {
            Destination::Back(to) => Destination::Back(others + to),
            to => to,
        };
        Self { from: others + self.from, to, ..self }
    }
}

dimensioned! {
    Record, |own| { own.resonances, own.points, own.ways, }

    Way, |own| { own.to, own.curve, own.degenerate, }
}

impl Dimensioned for Destination {
    fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
        if let Self::Next(resonance) = self {
            resonance.each_number(visit);
        }
    }
}

/// Makes rows of the results for a member, dimensionless.
struct Rows {
    /// The units in which numbers stand in words.
    units: Units,
    /// The wall that sees them, if there are two.
    wall: u32,
    varied: [f64; VARIED],
    /// The column of the constant that varies first.
    first: usize,
}

impl Rows {
    fn resonance(&self, resonance: &resonances::FoundResonance) -> FamilyResonance {
        let located = &resonance.located;
        let found = (resonance.n, FoundBy::Search);
        let orbit = located.orbit();
        let parameters = orbit.oscillator().parameters();
        let mut row = self.row(parameters, orbit.phase(), located.resonant_point(), self.varied, found);
        match &resonance.theorem {
            Ok(theorem) => {
                let known = coefficients(theorem);
                (row.coefficients.c_sn, row.coefficients.c_pd) =
                    (known.saddle_node.theorem.value, known.period_doubling.theorem.value);
                row.measured = measured(&known);
                [row.sn_verdict, row.pd_verdict] =
                    known.map(|coefficient| coefficient.verdict().name().to_owned()).into_array();
            }
            Err(violated) => {
                (row.coefficients.c_sn, row.coefficients.c_pd, row.holds) = (f64::NAN, f64::NAN, false);
                let failing =
                    violated.violated().map(|failing| failing.with_dimensions(&self.units).to_string());
                row.failing = failing.collect::<Vec<_>>().join("; ");
            }
        }
        row
    }

    /// A resonance with the quantities that follow from its derivatives alone.
    fn row(
        &self,
        parameters: [f64; 2],
        phase: f64,
        point: &ResonantPoint,
        varied: [f64; VARIED],
        (n, found_by): (u32, FoundBy),
    ) -> FamilyResonance {
        let [primary, secondary] = parameters;
        let coefficients = Coefficients::from(point);
        FamilyResonance {
            varied,
            loops: point.loops(),
            wall: self.wall,
            n,
            curve: 0,
            found_by,
            secondary,
            primary,
            phase,
            holds: coefficients.c_sn.is_finite(),
            coefficients,
            measured: Measured::NOT,
            sn_verdict: String::new(),
            pd_verdict: String::new(),
            quantities: point.into(),
            pd_criticality: point.limit_map().criticality(),
            failing: String::new(),
        }
    }

    fn points(&self, diagram: &Diagram) -> Vec<FamilyPoint> {
        let Self { varied, wall, .. } = *self;
        let point = |point: &CodimensionTwoPoint| {
            let at = point.unknowns();
            let [primary, secondary] = [at[unknown::PRIMARY], at[unknown::SECONDARY]];
            let impact_velocity = at[unknown::VELOCITY];
            let (kind, loops, n) = (point.kind, point.loops, point.n);
            FamilyPoint { varied, kind, loops, wall, n, secondary, primary, impact_velocity }
        };
        diagram.codimension_two.iter().map(point).collect()
    }

    /// The path along an arc towards a neighbour, at which the first constant has this value.
    fn way(&self, diagram: &Diagram, arc: &Arc, neighbour: f64) -> Way {
        let resonance = &diagram.resonances[arc.resonance];
        let (loops, n) = (resonance.loops, resonance.n);
        let varied = |way: f64| {
            let mut varied = self.varied;
            let value = &mut varied[self.first];
            *value = if way == 1.0 { neighbour } else { *value + (neighbour - *value) * way };
            varied
        };
        let parameters = |at: &ArcPoint| at.orbit.oscillator().parameters();
        let curve = |at: &ArcPoint| {
            let [primary, secondary] = parameters(at);
            let varied = varied(at.way);
            let mut coefficients = Coefficients::from(&at.point);
            // An infinite coefficient is written as NaN.
            let meaning = at.zero.map(meaning);
            if matches!(meaning, Some(Degeneracy::InfiniteSaddleNode | Degeneracy::Infinite)) {
                coefficients.c_sn = f64::NAN;
            }
            if matches!(meaning, Some(Degeneracy::InfinitePeriodDoubling | Degeneracy::Infinite)) {
                coefficients.c_pd = f64::NAN;
            }
            FamilyCurvePoint {
                varied,
                loops,
                wall: self.wall,
                n,
                curve: 0,
                arc: 0,
                secondary,
                primary,
                coefficients,
                end: String::new(),
            }
        };
        let mut curve: Vec<FamilyCurvePoint> = arc.points.iter().map(curve).collect();
        if let Some(last) = curve.last_mut() {
            last.end = match &arc.end {
                ArcEnd::Across | ArcEnd::Back(_) => String::new(),
                ArcEnd::LeftWindow => "it leaves the ranges".to_owned(),
                ArcEnd::Inadmissible => "another maximum of the grazing orbit touches the wall".to_owned(),
                ArcEnd::Lost(reason) => format!("it could not be followed: {reason}"),
            };
        }
        let degenerate = arc.points.iter().filter_map(|at| {
            let zero = at.zero?;
            let [primary, secondary] = parameters(at);
            let varied = varied(at.way);
            let (quantity, meaning, curve, wall) = (zero.to_string(), meaning(zero), 0, self.wall);
            Some(Degenerate { varied, loops, wall, n, curve, quantity, meaning, secondary, primary })
        });
        let to = match (&arc.end, arc.points.last()) {
            (ArcEnd::Across, Some(last)) => {
                let found = (n, FoundBy::Continuation);
                let row = self.row(parameters(last), last.orbit.phase(), &last.point, varied(1.0), found);
                Destination::Next(Box::new(row))
            }
            (ArcEnd::Back(Some(to)), _) => Destination::Back(*to),
            _ => Destination::Nowhere,
        };
        Way { from: arc.resonance, to, curve, degenerate: degenerate.collect() }
    }
}

/// The consequence of a zero of this quantity of the hypotheses.
fn meaning(quantity: Quantity) -> Degeneracy {
    match quantity {
        Quantity::SaddleNodeStability => Degeneracy::InfiniteSaddleNode,
        Quantity::PeriodDoublingStability => Degeneracy::InfinitePeriodDoubling,
        Quantity::Transversality => Degeneracy::Infinite,
        Quantity::OffDiagonalDerivative | Quantity::DetuningDerivative => Degeneracy::Meeting,
        _ => Degeneracy::NoTheorem,
    }
}
