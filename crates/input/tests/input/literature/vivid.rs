//! Bifurcations of the paper's oscillator as Ghosh and Simpson computed them with their own
//! program.
//!
//! They are located here without virtual points, rather than by VIVID as there.

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns, unknown};
use grazing_input::Description;
use grazing_model::smooth::Integrated;

use super::published::{Bifurcation, Kind, Published, assert_within, description, number};

/// Distance between the start of Newton's method and the printed orbit; it converges from farther
/// away.
const OFF: f64 = 1e-4;

/// The equations of a printed orbit, and the orbit as a slightly displaced start.
fn printed(row: &Bifurcation) -> (LoopEquations<Integrated<Description>>, Unknowns) {
    let [velocity, time, primary, secondary] =
        [&row.impact_velocity, &row.impact_time, &row.primary, &row.secondary].map(|text| number(text));
    let oscillator = Integrated::new(description(&row.example), [primary, secondary]);
    let equations = LoopEquations::new(oscillator, row.loops, Formulation::FixedPhase);
    let phase = time * secondary % core::f64::consts::TAU;
    (equations, Unknowns::new(velocity + OFF, phase + OFF, primary - OFF, secondary))
}

#[test]
fn printed_orbits_have_the_printed_amplitudes_phases_and_multipliers() {
    for row in &Published::read().bifurcation {
        let (equations, start) = printed(row);
        let [velocity, secondary] = [&row.impact_velocity, &row.secondary].map(|text| number(text));
        let conditions = [Condition::Secondary(secondary), Condition::ImpactVelocity(velocity)];
        let found = locate(&equations, conditions, start.clone(), &mut EventTimes::default())
            .unwrap_or_else(|failure| panic!("{}: {failure}", row.id));
        // The residual that the authors allow, 1e-10, magnified by the inverse of their derivative.
        assert_within(found[unknown::PRIMARY], number(&row.primary), 1e-10);
        assert_within(found[unknown::PHASE], start[unknown::PHASE] - OFF, 1e-9);
        // The derivatives of the multipliers are divided by the impact velocity, of 0.06 and more.
        let multipliers = equations.solution(&found).multipliers;
        let [a, b] = [&row.multipliers[0], &row.multipliers[1]].map(|text| number(text));
        assert_within(multipliers.trace, a + b, 1e-8);
        assert_within(multipliers.determinant, a * b, 1e-8);
    }
}

#[test]
fn printed_bifurcations_are_found_where_they_are_printed() {
    for row in &Published::read().bifurcation {
        let (equations, start) = printed(row);
        let kind = match row.kind {
            Kind::SaddleNode => Condition::SADDLE_NODE,
            Kind::PeriodDoubling => Condition::PERIOD_DOUBLING,
        };
        let conditions = [Condition::Secondary(number(&row.secondary)), kind];
        let found = locate(&equations, conditions, start, &mut EventTimes::default())
            .unwrap_or_else(|failure| panic!("{}: {failure}", row.id));
        // The authors allow a multiplier to be off by 1e-5. At a saddle-node bifurcation the
        // amplitude is an extremum and feels it to second order; at a period doubling it moves by a
        // tenth of that or less.
        let bound = match row.kind {
            Kind::SaddleNode => 1e-10,
            Kind::PeriodDoubling => 1e-6,
        };
        assert_within(found[unknown::PRIMARY], number(&row.primary), bound);
        assert_within(found[unknown::VELOCITY], number(&row.impact_velocity), 1e-4);
    }
}
