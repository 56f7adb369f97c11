//! The limit map at a resonance, compared with the system itself at decreasing distances from the
//! resonance.

use core::f64::consts::TAU;

use grazing_continuation::criticality::period_doubling;
use grazing_continuation::doubled::DoubledEquations;
use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, unknown};
use grazing_continuation::resonance::LocatedResonance;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{ImpactOscillator, State, ThirdOrder};
use grazing_theorems::Side;
use grazing_theorems::limit_map::Departure;

use crate::specimens::{DUFFING, EPSILON, ZETA, assert_vanishes, duffing, located, resonances};

/// Number of impacts in a row.
const IMPACTS: usize = 4;

/// The deviation of simulated impacts from those of the limit map until either departs, which both
/// must do at the same flight. They begin beside its fixed point at `times` times the velocity at
/// the bifurcation of this side and `phase` times its phase; `size` is about that of y.
fn deviation<O: ImpactOscillator>(
    resonance: &LocatedResonance<O>,
    (side, times, phase): (Side, f64, f64),
    size: f64,
) -> Option<f64> {
    let point = resonance.resonant_point();
    let (map, scale) = (point.limit_map(), point.limit_scale());
    let bifurcation = [map.saddle_node(), map.period_doubling()].map(|[velocity, _]| velocity);
    let velocity = bifurcation.into_iter().find(|velocity| Side::of(*velocity) == side)?;
    let eta = size / (scale.velocity * velocity);
    assert_eq!(scale.side(eta), side);
    let (mut here, parameter) = map.fixed_point(times * velocity);
    here.phase *= phase;
    let start = resonance.near(eta, parameter, here).unwrap();
    let oscillator = resonance.equations().oscillator_at(&start);
    let from = State::on_wall(start[unknown::VELOCITY], start[unknown::PHASE]);
    let horizon = f64::from(resonance.loops()) * oscillator.forcing_period();
    let mut worst = 0.0_f64;
    for flight in Orbit::new(&oscillator, from, 2.0 * IMPACTS as f64 * horizon, usize::MAX).take(IMPACTS) {
        // Motion may never return.
        let (FlightEnd::Impact(simulated) | FlightEnd::TimeIsUp(simulated)) = flight.end;
        let late = flight.duration / horizon - 1.0;
        let departed = 0.25 / f64::from(resonance.loops());
        here = match map.step(side, parameter, here) {
            Ok(next) if late.abs() < departed => next,
            Err(Departure::EarlyVisit) if late < -departed => break,
            Err(Departure::Missed) if late > departed => break,
            _ => return None,
        };
        let expected = resonance.near(eta, parameter, here).unwrap();
        let phase = libm::remainder(simulated.phase - expected[unknown::PHASE], TAU);
        worst = worst.max((simulated.velocity - expected[unknown::VELOCITY]).abs()).max(phase.abs());
    }
    Some(worst)
}

fn assert_orbits_tend_to_the_map_s<O: ImpactOscillator>(resonance: &LocatedResonance<O>) {
    let (plus, minus) = (Side::Positive, Side::Negative);
    for start in
        [(plus, 1.3, 1.003), (minus, 1.5, 1.003), (plus, 2.0, 0.9), (plus, 0.7, 1.2), (minus, 1.5, -0.3)]
    {
        // Impacts are of first order, and the difference of second; times are located with an error
        // of 1/y roundings.
        assert_vanishes(3.0, 1e-15, |size| Some(size * deviation(resonance, start, size)?));
        assert!(deviation(resonance, start, 1e-5).is_some(), "{start:?} {:?}", resonance.resonant_point());
    }
}

/// The coefficient μ/η² at which the computed orbit with two impacts grazes, where the period
/// doubling has an impact velocity of about `size`.
fn grazing_coefficient<O: ImpactOscillator>(resonance: &LocatedResonance<O>, size: f64) -> Option<f64> {
    let point = resonance.resonant_point();
    let (map, scale) = (point.limit_map(), point.limit_scale());
    let eta = size / (scale.velocity * map.period_doubling()[0]);
    let equations = DoubledEquations::new(resonance.equations());
    let guess = equations.near_resonance(resonance, eta, map.grazing_gap()).unwrap();
    let (grazing, visit) = equations.grazing(guess)?;
    // For one loop the impact itself grazes.
    assert_eq!(visit, resonance.loops() - 1, "{size}");
    let place = resonance.near(eta, 0.0, map.fixed_point(0.0).0).unwrap();
    Some((grazing[unknown::PRIMARY] - place[unknown::PRIMARY]) / (eta * eta))
}

/// Checks that the error of the grazing coefficient is of first order in η.
fn assert_doubled_orbits_graze_at_the_map_s<O: ImpactOscillator>(resonance: &LocatedResonance<O>) {
    let expected = resonance.resonant_point().doubled_grazing_coefficient();
    let error = |size| Some(grazing_coefficient(resonance, size)? / expected - 1.0);
    assert_vanishes(3.0, 1e-14, |size| Some(size * size * error(size)?));
    assert!(error(1e-4).expect("it grazes").abs() < 0.1);
}

/// Compares the traces of the derivative over both impacts of computed orbits with those of the
/// map.
fn assert_doubled_orbits_are_as_stable_as_the_map_s<O: ImpactOscillator>(resonance: &LocatedResonance<O>) {
    let point = resonance.resonant_point();
    let (map, scale) = (point.limit_map(), point.limit_scale());
    let equations = DoubledEquations::new(resonance.equations());
    for part in [0.2, 0.7] {
        let gap = part * map.grazing_gap();
        let trace = |size: f64| {
            let eta = size / (scale.velocity * map.period_doubling()[0]);
            let guess = equations.near_resonance(resonance, eta, gap).unwrap();
            Some(equations.multipliers(&equations.solved(guess)?)?.trace)
        };
        let expected = map.doubled_trace(gap);
        // Digits are lost in proportion to 1/y².
        assert_vanishes(3.0, 1e-13, |size| Some(size * size * (trace(size)? - expected)));
        assert!((trace(1e-4).expect("it is there") - expected).abs() < 0.1 * (1.0 + expected.abs()));
    }
}

/// Checks that y² c of the normal form, from third derivatives of the flow, tends to that of the
/// map.
fn assert_criticality_tends_to_the_map_s<O: ThirdOrder>(resonance: &LocatedResonance<O>) {
    let map = resonance.resonant_point().limit_map();
    let scale = resonance.resonant_point().limit_scale();
    let [velocity, parameter] = map.period_doubling();
    let fixed = map.fixed_point(velocity).0;
    // Digits of c are lost in proportion to 1/y.
    assert_vanishes(2.0, 1e-12, |size| {
        let start = resonance.near(size / (scale.velocity * velocity), parameter, fixed).unwrap();
        let conditions = [Condition::PERIOD_DOUBLING, Condition::Secondary(start[unknown::SECONDARY])];
        let flip = locate(resonance.equations(), conditions, start, &mut EventTimes::default()).ok()?;
        let form = period_doubling(resonance.equations(), &flip).ok()?;
        let scaled = flip[unknown::VELOCITY] / form.direction[0];
        Some(size * (scaled * scaled * form.coefficient - map.criticality()))
    });
}

#[test]
fn near_resonances_of_the_linear_oscillator_all_is_as_in_the_limit_map() {
    let paper = resonances(ZETA, EPSILON, &[1, 2, 3], [0.35, 1.02]);
    assert!(paper.len() >= 7);
    let damped = resonances(0.07, 0.6, &[1, 2, 3, 4, 5], [0.6, 2.1]);
    for closed_form in paper.iter().chain(&damped) {
        let resonance = located(closed_form);
        assert_orbits_tend_to_the_map_s(&resonance);
        assert_doubled_orbits_graze_at_the_map_s(&resonance);
        assert_doubled_orbits_are_as_stable_as_the_map_s(&resonance);
        assert_criticality_tends_to_the_map_s(&resonance);
    }
}

/// On either side of the line E (3 + 3ε − Eε) = 1 two-impact orbits begin stable or unstable; for p = 1 and
/// even n they are unstable.
#[test]
fn two_impact_orbits_begin_stable_beyond_a_line() {
    let epsilon: f64 = 0.7;
    let root = (3.0 + 3.0 * epsilon) / (2.0 * epsilon);
    let line = root - (root * root - 1.0 / epsilon).sqrt();
    let places = [(1, 1, 0.5), (1, 2, 1.0), (1, 3, 1.5), (2, 1, 1.25), (3, 1, 7.0 / 6.0), (4, 2, 2.125)];
    for (loops, index, ratio) in places {
        for part in [0.9, 1.1] {
            // E = exp(−2πpζ/ω) with ω₁/ω = ratio.
            let skew = -libm::log(part * line) / (TAU * f64::from(loops) * ratio);
            let zeta = skew / (1.0 + skew * skew).sqrt();
            let theory = grazing_theorems::LinearOscillator::new(zeta, epsilon).unwrap();
            let resonance = located(&theory.resonance(loops, index).unwrap());
            let (map, scale) =
                (resonance.resonant_point().limit_map(), resonance.resonant_point().limit_scale());
            let eta = 1e-3 / (scale.velocity * map.period_doubling()[0]);
            let equations = DoubledEquations::new(resonance.equations());
            let guess = equations.near_resonance(&resonance, eta, 0.3 * map.grazing_gap()).unwrap();
            let multipliers = equations.multipliers(&equations.solved(guess).unwrap()).unwrap();
            // One multiplier passes 1 where the other is below it.
            let stable = 1.0 - multipliers.trace + multipliers.determinant > 0.0;
            let supercritical = part > 1.0 && !(loops == 1 && index == 2);
            assert_eq!(stable, supercritical, "p = {loops}, n = {index}, {part}");
            assert_eq!(map.criticality() > 0.0, supercritical);
        }
    }
}

#[test]
fn near_resonances_of_a_duffing_oscillator_all_is_as_in_the_limit_map() {
    for (loops, place) in DUFFING {
        let resonance = duffing(loops, place);
        assert_orbits_tend_to_the_map_s(&resonance);
        assert_doubled_orbits_graze_at_the_map_s(&resonance);
        assert_doubled_orbits_are_as_stable_as_the_map_s(&resonance);
        assert_criticality_tends_to_the_map_s(&resonance);
    }
}
