//! Assembly of the records of the members into the tables of a family.

use core::f64::consts::TAU;

use grazing_input::Description;
use grazing_results::family::{Family, FamilyPanel, FamilyResonance, Shows};
use grazing_results::{Frame, span};

use super::record::{Destination, Way};
use super::{FamilyPlan, Record};

/// Tolerance, in radians and fractions of the ranges, within which a resonance reached by continuation is
/// one that the search has found: both are located to 1e-9 or better.
const SAME: f64 = 1e-6;

/// The family with these records, in the order of the members; members without a record are omitted.
pub fn assemble(plan: &FamilyPlan, description: &Description, mut records: Vec<Option<Record>>) -> Family {
    let widths = [description.primary(), description.secondary()].map(|axis| {
        let [low, high] = axis.range();
        high - low
    });
    let joins = joins(plan, widths, &mut records);
    let starts = starts(&records);
    let mut joined = Joined::new(&records);
    for [a, b] in joins {
        joined.join(starts[a.0] + a.1, starts[b.0] + b.1);
    }
    let numbers = joined.numbers();
    let incomplete = records.iter().flatten().filter(|record| record.incomplete).count() as u32;
    let (mut members, mut resonances, mut points) = (Vec::new(), Vec::new(), Vec::new());
    let (mut curves, mut degenerate, mut arc) = (Vec::new(), Vec::new(), 0);
    for (record, start) in records.into_iter().zip(starts) {
        let Some(mut record) = record else { continue };
        record.count();
        members.push(record.member);
        points.extend(record.points);
        for Way { from, mut curve, degenerate: mut found, .. } in record.ways {
            let number = numbers[start + from];
            curve.iter_mut().for_each(|point| (point.curve, point.arc) = (number, arc));
            found.iter_mut().for_each(|point| point.curve = number);
            arc += 1;
            curves.extend(curve);
            degenerate.extend(found);
        }
        let numbered = (start..).zip(record.resonances);
        resonances.extend(numbered.map(|(node, row)| FamilyResonance { curve: numbers[node], ..row }));
    }
    let panels = Vec::new();
    let family = Family { members, resonances, points, curves, degenerate, panels, incomplete };
    Family { panels: self::panels(plan, description, &family), ..family }
}

/// A resonance, by the number of its member and its index in the member's list.
type Node = (usize, usize);

/// The pairs of resonances that continuation joins. A resonance found only by continuation is added to
/// its member.
fn joins(plan: &FamilyPlan, widths: [f64; 2], records: &mut [Option<Record>]) -> Vec<[Node; 2]> {
    let mut joins = Vec::new();
    for index in 0..records.len() {
        let Some(record) = &records[index] else { continue };
        let ways: Vec<(usize, Destination)> =
            record.ways.iter().map(|way| (way.from, way.to.clone())).collect();
        for (from, to) in ways {
            match to {
                Destination::Back(to) => joins.push([(index, from), (index, to)]),
                Destination::Next(found) if (index + 1) % plan.line() != 0 => {
                    let Some(next) = records.get_mut(index + 1).and_then(Option::as_mut) else { continue };
                    let known = next.resonances.iter().position(|known| same(known, &found, widths));
                    let place = known.unwrap_or(next.resonances.len());
                    if known.is_none() {
                        next.resonances.push(*found);
                    }
                    joins.push([(index, from), (index + 1, place)]);
                }
                _ => {}
            }
        }
    }
    joins
}

fn same(known: &FamilyResonance, found: &FamilyResonance, [primary, secondary]: [f64; 2]) -> bool {
    (known.loops, known.wall) == (found.loops, found.wall)
        && (known.primary - found.primary).abs() < SAME * primary
        && (known.secondary - found.secondary).abs() < SAME * secondary
        && libm::remainder(known.phase - found.phase, TAU).abs() < SAME
}

/// The number of resonances before each member's first.
fn starts(records: &[Option<Record>]) -> Vec<usize> {
    let counts = records.iter().map(|record| record.as_ref().map_or(0, |record| record.resonances.len()));
    let next = |before: &mut usize, count: usize| {
        let start = *before;
        *before += count;
        Some(start)
    };
    counts.scan(0, next).collect()
}

/// Sets of joined resonances: each entry points to an earlier resonance of its curve, or to itself.
struct Joined(Vec<usize>);

impl Joined {
    fn new(records: &[Option<Record>]) -> Self {
        Self((0..records.iter().flatten().map(|record| record.resonances.len()).sum()).collect())
    }

    fn first(&self, mut node: usize) -> usize {
        while self.0[node] != node {
            node = self.0[node];
        }
        node
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.first(a), self.first(b));
        self.0[a.max(b)] = a.min(b);
    }

    /// The number of each resonance's curve, from 1, in the order in which curves appear.
    fn numbers(&self) -> Vec<u32> {
        let mut numbers: Vec<u32> = Vec::with_capacity(self.0.len());
        let mut count = 0;
        for node in 0..self.0.len() {
            let first = self.first(node);
            count += u32::from(first == node);
            numbers.push(if first == node { count } else { numbers[first] });
        }
        numbers
    }
}

/// The panels for each p that has resonances, over the constant that varies first.
fn panels(plan: &FamilyPlan, description: &Description, family: &Family) -> Vec<FamilyPanel> {
    let values = &plan.varied[0].values;
    let Some(x) = padded(values.iter().copied(), 0.0) else { return Vec::new() };
    let of = |loops: u32| {
        let resonances = family.resonances.iter().filter(move |row| row.loops == loops);
        let curves = family.curves.iter().filter(move |row| row.loops == loops);
        let points = family.points.iter().filter(move |row| row.loops == loops);
        let secondary = resonances.clone().map(|row| row.secondary).chain(curves.map(|row| row.secondary));
        let secondary = padded(secondary.chain(points.map(|row| row.secondary)), MARGIN);
        let sn = typical(resonances.clone().map(|row| row.coefficients.c_sn));
        let pd = typical(resonances.map(|row| row.coefficients.c_pd));
        [(Shows::Secondary, secondary), (Shows::SaddleNode, sn), (Shows::PeriodDoubling, pd)]
            .into_iter()
            .filter_map(move |(shows, y)| Some(FamilyPanel { loops, shows, frame: Frame { x, y: y? } }))
    };
    description.loops().iter().flat_map(|&loops| of(loops)).collect()
}

/// Free space above and below, as a fraction of the extent.
const MARGIN: f64 = 0.06;

/// The range of the numbers with some margin; none unless two numbers differ.
fn padded(values: impl Iterator<Item = f64>, margin: f64) -> Option<[f64; 2]> {
    let [low, high] = span(values.filter(|value| value.is_finite()));
    let room = (high - low) * margin;
    (low < high).then_some([low - room, high + room])
}

/// The range of the middle four fifths of the numbers, extended by half its length to either side but not
/// beyond the numbers: coefficients become infinite where a resonance is degenerate.
fn typical(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    let [whole_low, whole_high] = padded(values.iter().copied(), MARGIN)?;
    let at = |tenths: usize| values[(values.len() - 1) * tenths / 10];
    let (low, high) = (at(1), at(9));
    let beyond = 0.5 * (high - low);
    let range = [(low - beyond).max(whole_low), (high + beyond).min(whole_high)];
    Some(if range[0] < range[1] { range } else { [whole_low, whole_high] })
}
