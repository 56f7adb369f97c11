//! Any row in any units.

use std::collections::BTreeSet;
use std::fmt::Debug;
use std::fs;
use std::path::Path;

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_model::smooth::Units;
use grazing_results::branches::*;
use grazing_results::family::*;
use grazing_results::grazing::*;
use grazing_results::measured::*;
use grazing_results::place::*;
use grazing_results::plane::*;
use grazing_results::readings::*;
use grazing_results::resonance::*;
use grazing_results::space::{Mark, MarkKind};
use grazing_results::{Cell, Dimensioned, Row, Stability, VARIED};
use grazing_theorems::hypothesis::{Hypothesis, ImposedCondition, Quantity};
use grazing_theorems::{GrazingPoint, LinearisedMap, ResonantPoint, Unfolding};
use nalgebra::{Matrix2, Vector2};
use proptest::array::uniform4;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// What a field of a row may hold.
pub(crate) trait Sample {
    /// Any such value.
    fn sample() -> Self;
}

macro_rules! samples {
    ($($type:ty = $value:expr,)+) => {$(
        impl Sample for $type {
            fn sample() -> Self {
                $value
            }
        }
    )+};
}

samples! {
    f64 = 1.0,
    [f64; VARIED] = [2.0; VARIED],
    u32 = 1,
    bool = true,
    String = "why".to_owned(),
    &'static str = "periodic",
    Agreement = Agreement::Agrees,
    Bifurcation = Bifurcation::Grazing,
    CodimensionTwo = CodimensionTwo::Cusp,
    CurveSource = CurveSource::Quadratic,
    Degeneracy = Degeneracy::Meeting,
    FoundBy = FoundBy::Search,
    GrazingPoint = GrazingPoint {
        map: LinearisedMap { a: Matrix2::new(1.0, 1.0, 1.0, 1.0), b: Vector2::new(1.0, 1.0) },
        forcing_frequency: 1.0, gamma: 1.0, phi: 1.0, psi: 1.0,
    },
    ResonantPoint = ResonantPoint {
        grazing: Sample::sample(), second_phase_derivative: 1.0, unfolding: Unfolding { loops: 1, derivative: 1.0 },
    },
    Hypothesis = Hypothesis { quantity: Quantity::Detuning, value: 1.0, condition: ImposedCondition::Positive },
    MarkKind = MarkKind::Impact,
    PortraitKind = PortraitKind::Attractor,
    Property = Property::ImpactVelocity(1.0),
    RegionKind = RegionKind::Mps,
    SeenKind = SeenKind::NonImpacting,
    Stability = Stability::Stable,
    Sweep = Sweep::Random,
    WallSequence = WallSequence(vec![1, 2]),
}

/// Declares the list of all rows, each with its fields.
macro_rules! all_rows {
    ($($row:ident { $($field:ident),+ $(,)? })+) => {
        const ROWS: &[&str] = &[$(stringify!($row)),+];

        $(impl Sample for $row {
            fn sample() -> Self {
                Self { $($field: Sample::sample()),+ }
            }
        })+

        /// Checks each row with these numbers in these units.
        fn assert_all_converted(numbers: &[f64], units: &Units) {
            $(assert_converted::<$row>(numbers, units);)+
        }
    };
}

all_rows! {
    BranchPoint {
        diagram, loops, impacts, wall, secondary, primary, x, visit, impact_velocity, impact_phase,
        stable, admissible, branch,
    }
    BranchBifurcation { diagram, kind, loops, impacts, wall, secondary, primary, impact_velocity, x }
    AttractorPoint { diagram, secondary, primary, x }
    PortraitPoint { diagram, portrait, loops, secondary, primary, kind, time, x, y }
    Member { varied, resonances, points, missing }
    FamilyResonance {
        varied, loops, wall, n, curve, found_by, secondary, primary, phase, coefficients, measured,
        sn_verdict, pd_verdict, quantities, pd_criticality, holds, failing,
    }
    FamilyPoint { varied, kind, loops, wall, n, secondary, primary, impact_velocity }
    FamilyCurvePoint { varied, loops, wall, n, curve, arc, secondary, primary, coefficients, end }
    Degenerate { varied, loops, wall, n, curve, quantity, meaning, secondary, primary }
    MeasuredPoint {
        line, secondary, secondary_error, primary, primary_error, kind, seen, agreement, theory,
        regions, distance, reason,
    }
    MeasuredCount { region, kind, loops, points, agree, within_error, disagree, undecided, silent }
    IdentifiedConstant { constant, value, error, start }
    Correlation { constant, other, correlation }
    Residual { source, line, quantity, residual }
    IdentifiedResonance { loops, wall, n, secondary, secondary_error, primary, primary_error, reason }
    PlaceAttractor {
        place, secondary, primary, attractor, states, share, motion, periods, impacts, second,
        rests, exponent, exponent_error,
    }
    PlaceSolution {
        place, loops, impacts, wall, impact_velocity, impact_phase, trace, determinant, stable,
        admissible,
    }
    PlaceMotion { place, attractor, flight, time, x, y }
    PlaceImpact { place, attractor, wall, impact_phase, impact_velocity }
    BasinState { place, start_phase, start_x, motion, attractor }
    SimulatedMotion { flight, time, x, y }
    SimulatedImpact { time, wall, impact_phase, impact_velocity }
    OnCurve {
        secondary, primary, impact_velocity, impact_phase, trace, determinant, max_interior_x,
        stable, admissible, arc, lost,
    }
    RegionCorner { secondary, primary, ring, reason }
    PlanePoint { kind, loops, wall, n, at }
    OwnPoint { name, property, loops, at }
    SpecialPoint { kind, loops, wall, n, secondary, primary }
    RegionVertex { region, kind, loops, wall, n, at }
    MagnifiedPoint { panel, loops, n, kind, source, arc, secondary, primary }
    SequenceResonance {
        number, base_impacts, base_periods, rounds, impacts, periods, secondary, primary,
        saddle_node, period_doubling, fails,
    }
    SequencePoint {
        impacts, periods, walls, kind, secondary, primary, impact_velocity, trace, determinant,
        max_interior_x, stable, admissible, arc, lost,
    }
    SequenceVertex { region, kind, impacts, periods, walls, at }
    StraightenedPoint { panel, loops, n, kind, arc, eta, distance, error, limit }
    Reading {
        diagram, loops, impacts, wall, secondary, primary, impact_velocity, impact_phase,
        peak_to_peak, impulse, force, power, stable, admissible, branch,
    }
    MotionReading {
        diagram, sweep, orbit, secondary, primary, motion, periods, impacts, rests, wall, x,
        impact_velocity, impact_phase, peak_to_peak, impulse, force, power,
    }
    Coefficients { s_plus, s_minus, c_sn, c_pd }
    Measured { c_sn_error, c_pd_error, c_sn_fit, c_pd_fit }
    CoefficientRow {
        loops, wall, n, secondary, primary, coefficients, measured, c_sn_fit_error, c_pd_fit_error,
        sn_verdict, sn_reason, pd_verdict, pd_reason, quantities, sigma, pd_criticality, c_2gz,
        c_2gz_fit, sn_as_simulated, sn_simulation_reason, pd_as_simulated, pd_simulation_reason,
    }
    CheckedResonance { at, coefficients, holds, failing }
    CheckedHypothesis { loops, wall, n, secondary, primary, theorem, hypothesis }
    GrazingRow { arc, wall, secondary, primary, phase, point, stable, admissible }
    GrazingLoopRow { loops, arc, wall, secondary, primary, point }
    Quantities { tau, delta, alpha, beta, gamma, xi, a12_prime, kappa_prime }
    Mark { kind, number, layer, x, y, z, across, up, depth }
}

/// The size of a unit as its words say it: products and quotients of words, one after the other.
fn said(unit: &str, units: &Units) -> f64 {
    let factor = |word: &str| {
        let (word, power) = word.split_once('^').unwrap_or((word, "1"));
        let size = match word {
            "length" => units.length,
            "time" => units.time,
            "{primary}" => units.primary,
            "{secondary}" => units.secondary,
            _ => 1.0,
        };
        libm::pow(size, power.parse().expect("a power is a number"))
    };
    let product = |text: &str| text.split(['*', ' ']).map(factor).product::<f64>();
    let mut parts = unit.split('/').map(|part| part.split_once(['*', ' ']).unwrap_or((part, "1")));
    let (first, rest) = parts.next().expect("a unit has words");
    parts.fold(product(first) * product(rest), |size, (below, above)| size / product(below) * product(above))
}

/// Checks that a row with these numbers goes to other units by its columns' units, and comes back as it was; and that its
/// parameters, exchanged twice, are themselves.
fn assert_converted<R: Row + Dimensioned + Sample + Clone + PartialEq + Debug>(
    numbers: &[f64],
    units: &Units,
) {
    let mut row = R::sample();
    let mut drawn = numbers.iter().cycle();
    row.each_number(&mut |_, number| *number = *drawn.next().expect("there are numbers"));
    let own = row.clone().with_dimensions(units);
    let cells = |row: &R| row.cells().iter().map(Cell::number).collect::<Vec<_>>();
    for ((column, before), after) in R::COLUMNS.iter().zip(cells(&row)).zip(cells(&own)) {
        let wanted = before.map(|before| before * said(column.unit, units));
        // What a number of loops does not have is not a number, in any units.
        let absent = [after, wanted].iter().all(|number| number.is_some_and(f64::is_nan));
        assert!(absent || after == wanted, "{}: {after:?} and not {wanted:?} {}", column.name, column.unit);
    }
    assert_eq!(own.without_dimensions(units), row);
    let mut exchanged = row.clone();
    exchanged.exchange();
    exchanged.exchange();
    assert_eq!(exchanged, row);
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 64,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(5),
        ..ProptestConfig::default()
    })]
    #[test]
    fn any_row_in_any_units_is_what_the_units_of_its_columns_say_and_comes_back_as_it_was(
        powers in uniform4(-6..=6_i32),
        numbers in vec(-1e3..1e3_f64, 16),
    ) {
        // Powers of four, as the units of oscillators are.
        let [length, time, primary, secondary] = powers.map(|power| libm::ldexp(1.0, 2 * power));
        assert_all_converted(&numbers, &Units { length, time, primary, secondary });
    }
}

/// The texts of the files in a folder and in those below.
fn texts(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("it can be listed").path());
    let text = |path: &Path| fs::read_to_string(path).expect("a source is text");
    paths.flat_map(|path| if path.is_dir() { texts(&path) } else { vec![text(&path)] }).collect()
}

#[test]
fn the_list_of_rows_is_that_of_the_sources() {
    let sources = texts(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"));
    let declarations = sources.iter().flat_map(|text| text.split("\nrows! {\n").skip(1));
    let lines = declarations.flat_map(|text| text.lines().take_while(|line| *line != "}"));
    let declared: BTreeSet<&str> =
        lines.filter_map(|line| line.strip_prefix("    ")?.strip_suffix(" {")).collect();
    assert_eq!(declared, ROWS.iter().copied().collect());
}
