//! Rows in other units.

use grazing_continuation::bifurcation::{Bifurcation, Pair};
use grazing_model::smooth::Units;
use grazing_results::branches::{PortraitKind, PortraitPoint};
use grazing_results::columns::{self, C_PD, C_SN};
use grazing_results::family::{CurvePoint, Degeneracy, Degenerate};
use grazing_results::measured::{Agreement, MeasuredPoint, SeenKind};
use grazing_results::place::PlaceAttractor;
use grazing_results::plane::{
    Magnifications, MagnifiedPanel, OnCurve, PlanePoint, SequenceResonance, StraightenedPoint,
};
use grazing_results::readings::Reading;
use grazing_results::resonance::{Coefficients, Quantities};
use grazing_results::{Column, Dimension, Dimensioned, Frame, Row, Stability};
use grazing_theorems::hypothesis::{Condition, Hypothesis, Quantity};
use grazing_theorems::spectrum::LinearisedMap;
use grazing_theorems::{GrazingPoint, ResonantPoint, Unfolding};
use nalgebra::{Matrix2, Vector2};

/// Units that are powers of four, as those of oscillators are.
const UNITS: Units = Units { length: 1024.0, time: 0.0625, primary: 64.0, secondary: 0.25 };

/// The size of a unit as its words say it: products and quotients of words, one after the other.
fn said(unit: &str) -> f64 {
    let factor = |word: &str| {
        let (word, power) = word.split_once('^').unwrap_or((word, "1"));
        let size = match word {
            "length" => UNITS.length,
            "time" => UNITS.time,
            "{primary}" => UNITS.primary,
            "{secondary}" => UNITS.secondary,
            _ => 1.0,
        };
        libm::pow(size, power.parse().expect("a power is a number"))
    };
    let product = |text: &str| text.split(['*', ' ']).map(factor).product::<f64>();
    let mut parts = unit.split('/').map(|part| part.split_once(['*', ' ']).unwrap_or((part, "1")));
    let (first, rest) = parts.next().expect("a unit has words");
    parts.fold(product(first) * product(rest), |size, (below, above)| size / product(below) * product(above))
}

/// Checks that a row goes to other units by its columns' units, and comes back as it was.
fn assert_converted<R: Row + Dimensioned + Clone + PartialEq + std::fmt::Debug>(row: &R) {
    let converted = row.clone().with_dimensions(&UNITS);
    let numbers = |row: &R| row.cells().iter().map(grazing_results::Cell::number).collect::<Vec<_>>();
    let columns: &[Column] = R::COLUMNS;
    for ((column, before), after) in columns.iter().zip(numbers(row)).zip(numbers(&converted)) {
        assert_eq!(
            after,
            before.map(|before| before * said(column.unit)),
            "{}: {}",
            column.name,
            column.unit
        );
    }
    assert_eq!(&converted.without_dimensions(&UNITS), row);
}

#[test]
fn rows_in_other_units_are_what_the_units_of_their_columns_say_and_come_back_as_they_were() {
    let point = PlanePoint {
        kind: Bifurcation::Grazing,
        loops: 2,
        wall: 1,
        n: 3,
        at: OnCurve {
            secondary: 0.7,
            primary: -1.3,
            impact_velocity: 0.11,
            impact_phase: 2.9,
            trace: 0.3,
            determinant: 0.8,
            max_interior_x: -0.01,
            stable: Stability::Stable,
            admissible: true,
            arc: 5,
            lost: "why".to_owned(),
        },
    };
    assert_converted(&point);
    let mut exchanged = point.clone();
    exchanged.exchange();
    let at = point.at.clone();
    let at = OnCurve { primary: at.secondary, secondary: at.primary, ..at };
    assert_eq!(exchanged, PlanePoint { at, ..point.clone() });
    let straightened = StraightenedPoint {
        panel: 1,
        loops: 1,
        n: 2,
        kind: Bifurcation::SaddleNode,
        arc: 1,
        eta: 1e-3,
        distance: -281.7,
        error: 1e-9,
        limit: -280.9,
    };
    assert_converted(&straightened);
    let portrait = PortraitPoint {
        diagram: 1,
        portrait: 1,
        loops: 1,
        secondary: 0.9,
        primary: 0.3,
        kind: PortraitKind::Attractor,
        time: 1.7,
        x: -0.6,
        y: 0.2,
    };
    assert_converted(&portrait);
    let attractor = PlaceAttractor {
        place: 1,
        secondary: 0.9,
        primary: 0.3,
        attractor: 1,
        states: 24,
        share: 0.7,
        motion: "periodic",
        periods: 3.0,
        impacts: 0.3,
        second: 0.1,
        rests: 0.2,
        exponent: -0.4,
        exponent_error: 0.01,
    };
    assert_converted(&attractor);
    let reading = Reading {
        diagram: 1,
        loops: 1,
        impacts: 1,
        wall: 1,
        secondary: 0.9,
        primary: 0.3,
        impact_velocity: 0.4,
        impact_phase: 1.1,
        peak_to_peak: 0.8,
        impulse: 0.5,
        force: 0.6,
        power: 0.7,
        stable: Stability::Unstable,
        admissible: false,
        branch: 0,
    };
    assert_converted(&reading);
    let resonance = SequenceResonance {
        number: 1,
        base_impacts: 1,
        base_periods: 1,
        rounds: 2,
        impacts: 3,
        periods: 4,
        secondary: 0.48,
        primary: 0.98,
        saddle_node: -228.0,
        period_doubling: 536.6,
        fails: String::new(),
    };
    assert_converted(&resonance);
    let mut measured = MeasuredPoint {
        line: 3,
        secondary: 0.7,
        secondary_error: 0.01,
        primary: 0.3,
        primary_error: 0.02,
        kind: SeenKind::NonImpacting,
        seen: String::new(),
        agreement: Agreement::Agrees,
        theory: String::new(),
        regions: String::new(),
        distance: 1.5,
        reason: String::new(),
    };
    assert_converted(&measured);
    measured.exchange();
    let MeasuredPoint { primary, primary_error, secondary, secondary_error, .. } = measured;
    assert_eq!([primary, primary_error, secondary, secondary_error], [0.7, 0.01, 0.3, 0.02]);
    // Rows within a row are converted, too; the constants that vary have units of their own.
    let on_curve = CurvePoint {
        varied: [1.0, 2.0, 3.0],
        loops: 1,
        wall: 0,
        n: 3,
        curve: 1,
        arc: 2,
        secondary: 0.7,
        primary: 0.3,
        coefficients: Coefficients { s_plus: 0.6, s_minus: 0.5, c_sn: -280.9, c_pd: 610.2 },
        end: String::new(),
    };
    assert_converted(&on_curve);
    let degenerate = Degenerate {
        varied: [f64::NAN, f64::NAN, 0.02],
        loops: 1,
        wall: 0,
        n: 3,
        curve: 1,
        quantity: "s".to_owned(),
        meaning: Degeneracy::Meeting,
        secondary: 0.7,
        primary: 0.3,
    };
    let converted = degenerate.clone().with_dimensions(&UNITS);
    assert_eq!([converted.primary, converted.secondary], [0.3 * UNITS.primary, 0.7 * UNITS.secondary]);
    assert_eq!(converted.varied[2], degenerate.varied[2]);
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
    let zero = Condition::Zero { tolerance: 1e-6 };
    for (value, condition, holds) in [
        (5e-7, zero, true),
        (-2e-6, zero, false),
        (3e-9, Condition::Positive, true),
        (-3e9, Condition::NonZero, true),
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
