//! Results in other units, and with their parameters exchanged.

use grazing_continuation::bifurcation::Pair;
use grazing_model::smooth::Units;
use grazing_results::columns::{self, C_PD, C_SN};
use grazing_results::measured::MeasuredPoint;
use grazing_results::plane::{Magnifications, MagnifiedPanel, OnCurve, PlanePoint};
use grazing_results::resonance::Quantities;
use grazing_results::{Dimension, Dimensioned, Frame, Row};
use grazing_theorems::hypothesis::{Hypothesis, ImposedCondition, Quantity};
use grazing_theorems::spectrum::LinearisedMap;
use grazing_theorems::{GrazingPoint, ResonantPoint, Unfolding};
use nalgebra::{Matrix2, Vector2};

use crate::rows::Sample;

/// Units that are powers of four, as those of oscillators are.
const UNITS: Units = Units { length: 1024.0, time: 0.0625, primary: 64.0, secondary: 0.25 };

#[test]
fn the_two_parameters_are_exchanged_with_their_errors() {
    let point =
        PlanePoint { at: OnCurve { primary: 0.3, secondary: 0.7, ..Sample::sample() }, ..Sample::sample() };
    let mut exchanged = point.clone();
    exchanged.exchange();
    let at = OnCurve { primary: 0.7, secondary: 0.3, ..point.at.clone() };
    assert_eq!(exchanged, PlanePoint { at, ..point });
    let mut measured = MeasuredPoint {
        secondary: 0.7,
        secondary_error: 0.01,
        primary: 0.3,
        primary_error: 0.02,
        ..Sample::sample()
    };
    measured.exchange();
    let MeasuredPoint { primary, primary_error, secondary, secondary_error, .. } = measured;
    assert_eq!([primary, primary_error, secondary, secondary_error], [0.7, 0.01, 0.3, 0.02]);
}

#[test]
fn panels_are_converted_with_what_they_show_and_axes_are_exchanged_in_their_frames_alone() {
    let frame = Frame { x: [1.0, 2.0], y: [3.0, 4.0] };
    let coefficients = Pair { saddle_node: -280.9, period_doubling: 610.2 };
    let panel = MagnifiedPanel { panel: 1, frame, loops: 1, wall: 0, n: Some(2), coefficients };
    let of =
        Magnifications { curves: Vec::new(), points: Vec::new(), regions: Vec::new(), panels: vec![panel] };
    let own = of.clone().with_dimensions(&UNITS).panels[0];
    assert_eq!(own.frame, Frame { x: [64.0, 128.0], y: [0.75, 1.0] });
    assert_eq!(own.coefficients, coefficients.map(|coefficient| coefficient * C_SN.dimension.size(&UNITS)));
    let mut exchanged = of;
    exchanged.exchange();
    let turned = Frame { x: frame.y, y: frame.x };
    assert_eq!(exchanged.panels[0], MagnifiedPanel { frame: turned, ..panel });
}

#[test]
fn a_dimension_is_the_same_however_its_unit_is_written() {
    assert_eq!(Dimension::of("mass*length^2/time^3"), Dimension::of("length^2*mass/time/time/time"));
    assert_eq!(Dimension::of("1/length"), Dimension::of("rad/length"));
    assert_ne!(Dimension::of("length/{primary}"), Dimension::of("length/{secondary}"));
    assert_eq!(columns::C_SN.dimension, Dimension::of("{primary}/{secondary}^2"));
    assert_eq!(columns::C_SN.dimension.size(&UNITS), 64.0 / 0.25 / 0.25);
}

#[test]
#[should_panic(expected = "no unit")]
fn a_word_that_is_no_unit_is_refused() {
    let _ = Dimension::of("length/tme");
}

#[test]
fn a_hypothesis_holds_or_not_in_any_units() {
    let zero = ImposedCondition::Zero { tolerance: 1e-6 };
    for (value, condition, holds) in [
        (5e-7, zero, true),
        (-2e-6, zero, false),
        (3e-9, ImposedCondition::Positive, true),
        (-3e9, ImposedCondition::NonZero, true),
    ] {
        let hypothesis = Hypothesis { quantity: Quantity::OffDiagonal, value, condition };
        for length in [1e-6, 1.0, 1e6] {
            let own = hypothesis.with_dimensions(&Units { length, ..Units::ONE });
            assert_eq!((own.holds(), own.value), (holds, value * length), "{hypothesis:?} in {length}");
        }
    }
}

#[test]
fn what_follows_from_a_resonance_in_other_units_has_the_units_of_its_columns() {
    let grazing = GrazingPoint {
        map: LinearisedMap { a: Matrix2::new(0.26, -0.57, 0.48, 0.35), b: Vector2::new(1.6, -0.9) },
        forcing_frequency: 0.8,
        gamma: 1.3,
        phi: 0.9,
        psi: 0.1,
    };
    for loops in [1, 2] {
        let unfolding = Unfolding { loops, derivative: -4.8 };
        let point = ResonantPoint { grazing, second_phase_derivative: 0.13, unfolding };
        let own = point.with_dimensions(&UNITS);
        assert_eq!(own.without_dimensions(&UNITS), point);
        // The quantities, and the coefficients, are computed from the point in either units.
        let numbers =
            |row: Quantities| row.cells().iter().map(grazing_results::Cell::number).collect::<Vec<_>>();
        assert_eq!(numbers((&own).into()), numbers(Quantities::from(&point).with_dimensions(&UNITS)));
        assert_eq!(
            own.saddle_node_coefficient(),
            point.saddle_node_coefficient() * C_SN.dimension.size(&UNITS)
        );
        assert_eq!(
            own.period_doubling_coefficient(),
            point.period_doubling_coefficient() * C_PD.dimension.size(&UNITS)
        );
    }
}
