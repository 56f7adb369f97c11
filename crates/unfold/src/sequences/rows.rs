//! Rows of solutions with several impacts, dimensionless.

use grazing_continuation::mps::PeriodicSolution;
use grazing_model::ImpactOscillator;
use grazing_results::plane::{
    OnCurve, PlanePoint, RegionKind, SequenceDiagram, SequencePoint, SequenceResonance, SequenceVertex,
    WallSequence,
};

use super::{Sequence, Sequences};
use crate::curves::DiagramCurve;
use crate::generations::{BaseName, LaterResonance};
use crate::plane::{on_curve, with_ends};

impl Sequences {
    /// The rows, as the wall with this number sees the solutions, if there are two.
    pub fn rows(&self, wall: u32) -> SequenceDiagram {
        let resonances = (1..).zip(&self.resonances).map(|(number, at)| resonance(number, at));
        let curves = numbered(self).flat_map(|(arc, of, curve)| {
            points(arc, of, curve).into_iter().map(move |point| own_point(of, wall, point))
        });
        SequenceDiagram {
            resonances: resonances.collect(),
            curves: curves.collect(),
            regions: regions(self.solutions.iter(), wall),
        }
    }

    /// The curves of solutions that hit both of two walls, with the numbers that they have among all of
    /// [`rows`](Self::rows), but without phases of impacts.
    pub fn at_both_walls(&self) -> Vec<PlanePoint> {
        let both = numbered(self).filter(|(_, of, _)| of.hits_both());
        both.flat_map(|(arc, of, curve)| points(arc, of, curve)).collect()
    }
}

impl Sequence {
    /// The walls that impacts hit, one after the other, as the wall with this number sees them; none with one wall.
    pub fn walls(&self, wall: u32) -> WallSequence {
        let stop =
            |impact: usize| if self.stops.is_empty() { 0 } else { self.stops[impact % self.stops.len()] };
        // To the second wall the first one is the other.
        let number = |stop: usize| if wall == 2 { 2 - stop } else { 1 + stop };
        WallSequence((0..self.impacts).filter(|_| wall > 0).map(|impact| number(stop(impact))).collect())
    }

    /// Whether these solutions hit both of two walls.
    pub fn hits_both(&self) -> bool {
        [0, 1].iter().all(|stop| self.stops.contains(stop))
    }
}

/// A curve with this number, point by point, without phases of impacts.
fn points(arc: u32, of: &Sequence, DiagramCurve { kind, curve, .. }: &DiagramCurve) -> Vec<PlanePoint> {
    let point = |solution: &PeriodicSolution| {
        let at = on_curve(*kind, solution, [solution.impact_velocity(), f64::NAN]);
        PlanePoint { kind: *kind, loops: of.periods, wall: 0, n: 0, at: OnCurve { arc, ..at } }
    };
    with_ends(curve.points.iter().map(|one| point(&one.solution)), curve.lost())
}

/// All curves, numbered from 0, each with the solutions that it is of.
fn numbered(found: &Sequences) -> impl Iterator<Item = (u32, &Sequence, &DiagramCurve)> {
    let all = found.solutions.iter();
    let curves = all.flat_map(|of| of.curves.iter().map(move |curve| (of, curve)));
    (0..).zip(curves).map(|(arc, (of, curve))| (arc, of, curve))
}

fn resonance(number: u32, at: &LaterResonance) -> SequenceResonance {
    let BaseName { impacts: base_impacts, periods: base_periods, .. } = at.base;
    let [primary, secondary] = at.resonance.located.orbit().oscillator().parameters();
    let (coefficients, fails) = match &at.resonance.theorem {
        Ok(point) => (point.leading().into_array().map(|curve| curve.coefficient), String::new()),
        Err(violated) => ([f64::NAN; 2], violated.to_string()),
    };
    SequenceResonance {
        number,
        base_impacts: base_impacts as u32,
        base_periods,
        rounds: at.resonance.loops,
        impacts: at.impacts() as u32,
        periods: at.periods(),
        secondary,
        primary,
        saddle_node: coefficients[0],
        period_doubling: coefficients[1],
        fails,
    }
}

/// A point of a curve of these solutions, in its own table.
fn own_point(of: &Sequence, wall: u32, PlanePoint { kind, at, .. }: PlanePoint) -> SequencePoint {
    SequencePoint {
        impacts: of.impacts as u32,
        periods: of.periods,
        walls: of.walls(wall),
        kind,
        secondary: at.secondary,
        primary: at.primary,
        impact_velocity: at.impact_velocity,
        trace: at.trace,
        determinant: at.determinant,
        max_interior_x: at.max_interior_x,
        stable: at.stable,
        admissible: at.admissible,
        arc: at.arc,
        lost: at.lost,
    }
}

/// The regions of solutions with several impacts, vertex by vertex.
fn regions<'a>(all: impl Iterator<Item = &'a Sequence>, wall: u32) -> Vec<SequenceVertex> {
    let regions = all.flat_map(|solutions| solutions.regions.iter().map(move |region| (solutions, region)));
    let rows = (1..).zip(regions).flat_map(|(number, (of, region))| {
        let kind = if region.doubt.is_some() { RegionKind::Undecided } else { RegionKind::SeveralImpacts };
        region.vertices().map(move |at| SequenceVertex {
            region: number,
            kind,
            impacts: of.impacts as u32,
            periods: of.periods,
            walls: of.walls(wall),
            at,
        })
    });
    rows.collect()
}
