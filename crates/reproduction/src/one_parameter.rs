//! One-parameter diagrams as rows: those of an oscillator from a text file, and what Figure 2 shares with them.

use grazing_description::{Description, OneParameter};
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Units;
use grazing_results::Frame;
use grazing_results::branches::{
    self, AttractorPoint, BranchBifurcation, BranchPoint, PortraitKind, PortraitPoint,
};
use grazing_unfold::Scope;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::one_parameter::{self, Exchanged, Plan, Portrait, Strand, Wanted, exchanged};
use grazing_unfold::progress::Progress;
use grazing_unfold::stop::{Stop, Unfinished};

use crate::plane::centred;
use crate::unfolded::prepared;

/// How long-time behaviour is sampled: at as many values as columns of dots can be told apart in a figure, after a transient that is longer where
/// damping is weak.
pub const PLAN: Plan = Plan { values: 240, orbits: 2, transient: 150, recorded: 24, seed: 1 };

/// The one-parameter diagrams that a file asks for, in the oscillator's own units, and what is missing.
pub(crate) fn diagrams(
    description: &Description,
    curves: &[DiagramCurve],
    stop: &Stop,
    progress: &dyn Progress,
) -> (Vec<branches::OneParameter>, Vec<Unfinished>) {
    let (mut diagrams, mut unfinished) = (Vec::new(), Vec::new());
    let units = description.units();
    let (oscillator, scope) = prepared(description, &units, stop);
    let from_the_wall = !description.wall().is_usual();
    for (number, asked) in (1..).zip(description.diagrams()) {
        let found = of(&oscillator, &scope, &units, (asked, &PLAN), curves, progress, &mut |_| ());
        let missing = match &found {
            None => Some(format!("one-parameter diagram {number}")),
            Some(found) if found.resting.is_none() => {
                Some(format!("long-time behaviour and phase portraits of one-parameter diagram {number}"))
            }
            Some(_) => None,
        };
        unfinished.extend(missing.map(Unfinished::stage));
        diagrams.extend(found.map(|found| branches::OneParameter {
            diagram: number,
            from_the_wall,
            ..found
        }));
    }
    (diagrams, unfinished)
}

/// The one-parameter diagram that is asked for, in the oscillator's own units, of an oscillator that is counted with its scope in these;
/// curves of the two-parameter diagram lead to branches as far as they are known. The seed is that of what is asked for. `begun` gets the
/// branches before the simulation, which takes longer.
///
/// `None` if an end was asked for before the branches were known.
pub fn of<O: ImpactOscillator>(
    oscillator: &O,
    scope: &Scope,
    units: &Units,
    (asked, plan): (&OneParameter, &Plan),
    curves: &[DiagramCurve],
    progress: &dyn Progress,
    begun: &mut dyn FnMut(branches::OneParameter),
) -> Option<branches::OneParameter> {
    if asked.primary_is_fixed {
        let (oscillator, scope, curves) =
            (Exchanged(oscillator.clone()), scope.exchanged(), exchanged(curves));
        let units = Units { primary: units.secondary, secondary: units.primary, ..*units };
        return across(&oscillator, &scope, &units, (asked, plan), &curves, progress, begun);
    }
    across(oscillator, scope, units, (asked, plan), curves, progress, begun)
}

/// The same, where the parameter across is the primary one.
fn across<O: ImpactOscillator>(
    oscillator: &O,
    scope: &Scope,
    units: &Units,
    (asked, plan): (&OneParameter, &Plan),
    curves: &[DiagramCurve],
    progress: &dyn Progress,
    begun: &mut dyn FnMut(branches::OneParameter),
) -> Option<branches::OneParameter> {
    let wanted = Wanted {
        secondary: asked.at / units.secondary,
        range: asked.range.map(|value| value / units.primary),
        portraits: asked.portraits.iter().map(|value| value / units.primary).collect(),
        plan: Plan { seed: asked.seed, ..plan.clone() },
    };
    let mut begun = |found: &one_parameter::OneParameter| begun(rows(asked, found, units));
    let found =
        one_parameter::OneParameter::compute(oscillator, scope, curves, &wanted, progress, &mut begun)?;
    Some(rows(asked, &found, units))
}

/// Room below the lowest and above the highest point that is shown, as a part of the height between.
const MARGIN: f64 = 0.06;

/// As the first diagram of its file.
fn rows(asked: &OneParameter, found: &one_parameter::OneParameter, units: &Units) -> branches::OneParameter {
    let strands = (1..).zip(&found.strands).flat_map(|(polyline, strand)| strand_rows(polyline, strand));
    let branches = strands.map(|row| BranchPoint {
        primary: row.primary * units.primary,
        x: row.x * units.length,
        impact_velocity: row.impact_velocity * units.velocity(),
        impact_phase: centred(row.impact_phase),
        ..row
    });
    let branches: Vec<BranchPoint> = branches.collect();
    let bifurcations = found.bifurcations.iter().map(bifurcation_row).map(|row| BranchBifurcation {
        primary: row.primary * units.primary,
        impact_velocity: row.impact_velocity * units.velocity(),
        x: row.x * units.length,
        ..row
    });
    let visit =
        |&[primary, x]: &[f64; 2]| AttractorPoint { primary: primary * units.primary, x: x * units.length };
    let attractor: Vec<AttractorPoint> = found.visits.iter().map(visit).collect();
    let [low, high] = asked.range;
    let inside = |primary: f64| low <= primary && primary <= high;
    let on_branches = branches.iter().filter(|point| point.admissible && inside(point.primary));
    let shown = on_branches.map(|point| point.x).chain(attractor.iter().map(|point| point.x));
    // The wall is always there.
    let [lowest, highest] = shown.fold([0.0, 0.0], |[least, most]: [f64; 2], x| [least.min(x), most.max(x)]);
    let margin = MARGIN * if highest > lowest { highest - lowest } else { units.length };
    branches::OneParameter {
        diagram: 1,
        primary_is_fixed: asked.primary_is_fixed,
        at: asked.at,
        frame: Frame { x: asked.range, y: [lowest - margin, highest + margin] },
        from_the_wall: false,
        branches,
        bifurcations: bifurcations.collect(),
        attractor,
        portraits: (1..).zip(&found.portraits).flat_map(|(k, portrait)| orbit(k, portrait, units)).collect(),
        resting: (!found.unfinished).then_some(found.resting),
        broken: found
            .broken
            .iter()
            .map(|(loops, primary, reason)| (*loops, primary * units.primary, reason.clone()))
            .collect(),
    }
}

/// A portrait in order of time, an empty row after each flight.
pub(crate) fn orbit(number: u32, portrait: &Portrait, units: &Units) -> Vec<PortraitPoint> {
    let kind = if portrait.attractor { PortraitKind::Attractor } else { PortraitKind::Periodic };
    let row = |[time, x, y]: [f64; 3]| PortraitPoint {
        portrait: number,
        loops: portrait.loops,
        primary: portrait.primary * units.primary,
        kind,
        time: time * units.time,
        x: x * units.length,
        y: y * units.velocity(),
    };
    let flights = portrait.flights.iter().map(|flight| flight.iter().copied().chain([[f64::NAN; 3]]));
    flights.flatten().map(row).collect()
}

/// The points of a strand, which has a number; the phase of the impact is z.
pub(crate) fn strand_rows(polyline: u32, strand: &Strand) -> impl Iterator<Item = BranchPoint> {
    let Strand { loops, visit, points } = strand;
    points.iter().map(move |point| BranchPoint {
        loops: *loops,
        primary: point.primary,
        x: point.x,
        visit: *visit,
        impact_velocity: point.impact[0],
        impact_phase: point.impact[1],
        stable: point.stable,
        admissible: point.admissible,
        branch: polyline,
    })
}

pub(crate) fn bifurcation_row(found: &one_parameter::BranchBifurcation) -> BranchBifurcation {
    let one_parameter::BranchBifurcation { kind, loops, primary, impact_velocity, x } = *found;
    BranchBifurcation { kind, loops, primary, impact_velocity, x }
}
