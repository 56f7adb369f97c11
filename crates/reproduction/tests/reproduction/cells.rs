//! Compares every cell of the tables about an oscillator with its source, computed here, for an
//! oscillator with distinct values of similar quantities, in units other than 1.

use std::sync::OnceLock;

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo, Pair};
use grazing_continuation::fit::{CoefficientError, Estimate, Measurement};
use grazing_model::ImpactOscillator;
use grazing_model::phase::centred;
use grazing_model::smooth::Stop;
use grazing_reproduction::ComparedCoefficients;
use grazing_results::columns::*;
use grazing_results::{Cell, Column, Row, Table, Tables};
use grazing_theorems::auxiliary::resonance_boundary;
use grazing_theorems::hypothesis::ImposedCondition;
use grazing_theorems::unfolding::StabilityCoefficients;
use grazing_theorems::{GrazingPoint, ResonantPoint};
use grazing_unfold::progress::Silent;
use grazing_unfold::simulation::ReturnOutcome;
use grazing_unfold::unfolded::{CurveFinding, Unfolded};
use grazing_unfold::verdict::Coefficient;
use grazing_unfold::verification::{Inconclusive, Sides, Simulated};

use crate::study::{made, theory};
use crate::units::{dimension_of_hypothesis, written};

/// The analysis in units of 1024 lengths and 1/64 times, computed once for all tests.
fn unfolded() -> &'static Unfolded {
    static UNFOLDED: OnceLock<Unfolded> = OnceLock::new();
    UNFOLDED.get_or_init(|| {
        let description = written(1024.0, 1.0 / 64.0);
        Unfolded::described(&description, &Silent, &Stop::default(), &|_| ()).expect("there is grazing")
    })
}

type Expected = Vec<(Column, Cell)>;

/// A list of columns with their expected values.
macro_rules! expected {
    ($($column:ident: $value:expr,)+) => { vec![$(($column, Cell::from($value)),)+] };
}

/// Asserts that these cells are in these columns. Finite nonzero numbers must be distinct, so that no
/// cell can be exchanged with another.
fn assert_row(what: &str, columns: &[Column], cells: &[Cell], expected: &Expected) {
    let names: Vec<&str> = expected.iter().map(|(column, _)| column.name).collect();
    assert_eq!(columns.iter().map(|column| column.name).collect::<Vec<_>>(), names, "{what}");
    for ((column, wanted), found) in expected.iter().zip(cells) {
        let same = match (wanted, found) {
            (Cell::Number(wanted), Cell::Number(found)) => {
                wanted == found || wanted.is_nan() && found.is_nan()
            }
            _ => wanted == found,
        };
        assert!(same, "{what}, {}: {found:?} and not {wanted:?}", column.name);
    }
    for (place, cell) in cells.iter().enumerate() {
        let number = cell.number().filter(|number| *number != 0.0);
        let twin = cells[..place].iter().position(|other| number.is_some() && other.number() == number);
        assert_eq!(twin.map(|twin| columns[twin].name), None, "{what}, {}", columns[place].name);
    }
}

fn assert_table(table: &Table, expected: &[Expected]) {
    assert_eq!(table.rows.len(), expected.len(), "{}", table.name);
    assert!(!expected.is_empty(), "{}", table.name);
    for (number, (row, wanted)) in table.rows.iter().zip(expected).enumerate() {
        assert_row(&format!("{} row {number}", table.name), &table.columns, row, wanted);
    }
}

/// Asserts the cells of curves and regions, in which equal numbers are allowed: p and ring are often 0 or
/// 1.
fn assert_cells(table: &Table, expected: &[Expected]) {
    assert_eq!(table.rows.len(), expected.len(), "{}", table.name);
    for (row, wanted) in table.rows.iter().zip(expected) {
        for ((column, wanted), found) in wanted.iter().zip(row) {
            let nothing = |cell: &Cell| matches!(cell, Cell::Number(number) if number.is_nan());
            let same = found == wanted || nothing(found) && nothing(wanted);
            assert!(same, "{}, {}: {found:?} and not {wanted:?}", table.name, column.name);
        }
    }
}

#[test]
fn quantities_along_the_grazing_curve_are_those_of_its_orbits() {
    let unfolded = unfolded();
    let units = unfolded.axes.units;
    let (length, time, mu) = (units.length, units.time, units.primary);
    assert!([length, time, mu, units.secondary].iter().all(|unit| *unit != 1.0), "{units:?}");
    let tables = unfolded.along_grazing().tables(&unfolded.axes.names);
    let states = || {
        let curves = (0_u32..).zip(&unfolded.diagram.grazing);
        curves.flat_map(|(arc, curve)| curve.states.iter().map(move |state| (arc, state)))
    };
    let grazing = states().map(|(arc, state)| {
        let [primary, secondary] = state.orbit.oscillator().parameters();
        let GrazingPoint { map, forcing_frequency, gamma, phi, psi } = state.orbit.grazing_point();
        let (a, b) = (map.a, map.b);
        expected! {
            ARC: arc,
            SECONDARY: secondary * units.secondary,
            PRIMARY: primary * mu,
            GRAZING_PHASE: state.orbit.phase(),
            FREQUENCY: forcing_frequency / time,
            A11: a.m11,
            A12: a.m12 * length,
            A21: a.m21 / length,
            A22: a.m22,
            B1: b.x * (length / mu),
            B2: b.y / mu,
            TAU: a.m11 + a.m22,
            DELTA: a.m11 * a.m22 - a.m12 * a.m21,
            ALPHA: 1.0 + phi - gamma * psi / forcing_frequency,
            BETA: ((1.0 - a.m22) * b.x + a.m12 * b.y) * (length / mu),
            GAMMA: gamma * (length / (time * time)),
            PHI: phi,
            PSI: psi * (time / length),
            STABLE: state.multipliers.stable(),
            ADMISSIBLE: state.admissible,
        }
    });
    assert_table(&tables[0], &grazing.collect::<Vec<_>>());
    let of_loops = |loops: u32| {
        states().map(move |(arc, state)| {
            let [primary, secondary] = state.orbit.oscillator().parameters();
            let ResonantPoint { grazing, second_phase_derivative, unfolding, .. } =
                state.orbit.resonant_point(loops).expect("the curve is regular");
            let a = grazing.map.a;
            let (tau, delta) = (a.m11 + a.m22, a.m11 * a.m22 - a.m12 * a.m21);
            let slope = |own: bool, unit: f64| if own { unfolding.derivative * unit } else { f64::NAN };
            let kappa = if loops == 1 { f64::NAN } else { tau - resonance_boundary(f64::from(loops), delta) };
            let stability =
                state.orbit.resonant_point(loops).expect("the curve is regular").stability_coefficients();
            expected! {
                LOOPS: loops,
                ARC: arc,
                SECONDARY: secondary * units.secondary,
                PRIMARY: primary * mu,
                A12: a.m12 * length,
                KAPPA: kappa,
                A12_PRIME: slope(loops == 1, length / units.secondary),
                KAPPA_PRIME: slope(loops != 1, 1.0 / units.secondary),
                XI: second_phase_derivative * length,
                S_PLUS: stability.plus,
                S_MINUS: stability.minus,
            }
        })
    };
    assert_table(&tables[1], &[1, 2].into_iter().flat_map(of_loops).collect::<Vec<_>>());
}

#[test]
fn curves_points_regions_and_hypotheses_are_those_of_the_diagram() {
    let unfolded = unfolded();
    let (units, diagram) = (unfolded.axes.units, &unfolded.diagram);
    let own = |[primary, secondary]: [f64; 2]| [primary * units.primary, secondary * units.secondary];
    let tables = unfolded.plane_diagram().tables(&unfolded.axes.names);
    let mut curves = Vec::new();
    for (arc, curve) in (0_u32..).zip(&diagram.grazing) {
        for state in &curve.states {
            let [primary, secondary] = own(state.orbit.oscillator().parameters());
            let a = state.orbit.grazing_point().map.a;
            curves.push(expected! {
                BIFURCATION: Bifurcation::NonImpactingGrazing,
                LOOPS: 0,
                RESONANCE_INDEX: 0,
                SECONDARY: secondary,
                PRIMARY: primary,
                IMPACT_VELOCITY: 0.0,
                IMPACT_PHASE: 0.0,
                TRACE: a.trace(),
                DETERMINANT: a.determinant(),
                MAX_INTERIOR_X: f64::NAN,
                STABLE: state.multipliers.stable(),
                ADMISSIBLE: state.admissible,
                ARC: arc,
            });
        }
    }
    assert!(diagram.curves.iter().all(|curve| curve.loops > 0));
    for (arc, curve) in (diagram.grazing.len() as u32..).zip(&diagram.curves) {
        for point in &curve.curve.points {
            let solution = &point.solution;
            let [y, z, mu, eta] = solution.unknowns.first().into();
            let [primary, secondary] = own([mu, eta]);
            let phase = z - diagram.grazing_phase(eta).expect("the grazing curve crosses the window");
            let highest = solution.highest_interior_maximum.map_or(f64::NEG_INFINITY, |top| top.position);
            curves.push(expected! {
                BIFURCATION: curve.kind,
                LOOPS: curve.loops,
                RESONANCE_INDEX: curve.n,
                SECONDARY: secondary,
                PRIMARY: primary,
                IMPACT_VELOCITY: y * (units.length / units.time),
                IMPACT_PHASE: centred(phase),
                TRACE: solution.multipliers.trace,
                DETERMINANT: solution.multipliers.determinant,
                MAX_INTERIOR_X: highest * units.length,
                STABLE: solution.multipliers.stable(),
                // Interior maxima at the wall are located to 1e-11.
                ADMISSIBLE: highest <= 1e-11,
                ARC: arc,
            });
        }
    }
    assert_cells(&tables[0], &curves);
    let resonances = diagram.resonances.iter().filter(|resonance| resonance.theorem.is_ok());
    let resonances = resonances.map(|resonance| {
        let at = resonance.located.orbit().oscillator().parameters();
        (CodimensionTwo::Resonance, resonance.loops, resonance.n, at)
    });
    let others = diagram.codimension_two.iter().map(|point| {
        let [_, _, primary, secondary] = point.event.solution.unknowns.first().into();
        (point.kind, point.loops, point.n, [primary, secondary])
    });
    let points = resonances.chain(others).map(|(kind, loops, n, at)| {
        let [primary, secondary] = own(at);
        expected! {
            CODIMENSION_TWO: kind,
            LOOPS: loops,
            RESONANCE_INDEX: n,
            SECONDARY: secondary,
            PRIMARY: primary,
        }
    });
    assert_table(&tables[1], &points.collect::<Vec<_>>());
    let mut regions = Vec::new();
    for (number, region) in (1_u32..).zip(&diagram.regions) {
        for (ring, vertices) in (0_u32..).zip(&region.rings) {
            for vertex in vertices {
                let [primary, secondary] = own(*vertex);
                regions.push(expected! {
                    REGION: number,
                    REGION_KIND: region.kind(),
                    LOOPS: region.loops,
                    RESONANCE_INDEX: region.n,
                    SECONDARY: secondary,
                    PRIMARY: primary,
                    RING: ring,
                    REASON: region.doubt.as_ref().map_or(String::new(), ToString::to_string),
                });
            }
        }
    }
    assert!(regions.len() > 100);
    assert_cells(&tables[2], &regions);
    let mut hypotheses = Vec::new();
    for resonance in &diagram.resonances {
        let asked = match &resonance.theorem {
            Ok(point) => point.theorem().hypotheses(),
            Err(violated) => &violated.hypotheses,
        };
        let [primary, secondary] = own(resonance.located.orbit().oscillator().parameters());
        for hypothesis in asked {
            let value = hypothesis.value;
            let holds = match hypothesis.condition {
                ImposedCondition::AtLeast(least) => value >= f64::from(least),
                ImposedCondition::Positive => value > 0.0,
                ImposedCondition::NonZero => value != 0.0,
                ImposedCondition::Zero { tolerance } => value.abs() <= tolerance,
            };
            let statement = hypothesis.statement().to_string();
            let [l, t] = dimension_of_hypothesis(&Cell::from(statement.clone()));
            // The primary parameter is a force per mass, the secondary one a frequency.
            let unit = libm::pow(units.length, f64::from(l)) * libm::pow(units.time, f64::from(t));
            hypotheses.push(expected! {
                LOOPS: resonance.loops,
                RESONANCE_INDEX: resonance.n,
                SECONDARY: secondary,
                PRIMARY: primary,
                THEOREM: ["2.4", "2.5"][resonance.loops as usize - 1],
                HYPOTHESIS: statement,
                HYPOTHESIS_VALUE: value * unit,
                HOLDS: holds,
            });
        }
    }
    // The theorem holds at some of the resonances, and fails at others.
    let of_all = diagram.resonances.iter().map(|resonance| resonance.theorem.is_ok());
    assert!(of_all.clone().any(|holds| holds) && of_all.clone().any(|holds| !holds));
    let tables = unfolded.at_resonances().tables(&unfolded.axes.names);
    assert_cells(&tables[1], &hypotheses);
}

/// The columns of a row.
fn columns_of<R: Row>(_: &R) -> &'static [Column] {
    R::COLUMNS
}

/// Coefficients with distinct numbers, and with verdicts for two reasons.
fn coefficients() -> Pair<Coefficient> {
    let coefficient = |theorem, measured| Coefficient {
        stability: 1.0,
        theorem,
        fit: Ok(Measurement { coefficient: measured, eta: [1.0, 0.5], mu: [2.0, 0.25], velocity: 0.125 }),
    };
    let estimate = |value, error| Estimate { value, error };
    Pair {
        saddle_node: coefficient(estimate(2.5, 1e-9), estimate(2.75, 2e-9)),
        period_doubling: coefficient(estimate(-3.5, 3e-9), estimate(-3.75, 1.0)),
    }
}

#[test]
fn coefficients_and_simulations_stand_in_their_own_cells() {
    let unfolded = unfolded();
    let sides = Sides {
        velocity: 0.01,
        predicted: [false, true],
        seen: [ReturnOutcome::Returns; 2],
        attracts: [Some(false), Some(false)],
        gone_beyond: Some(true),
    };
    let undecided = Inconclusive::OnlyHere { velocity: 0.5 };
    let Pair { saddle_node: sn, period_doubling: pd } = coefficients();
    assert_eq!([sn.verdict().name(), pd.verdict().name()], ["contradict", "not measurable"]);
    let mut known = unfolded.clone();
    let mut unfolding = Vec::new();
    for at in &mut known.resonances {
        if let Some(curves) = &mut at.curves {
            let saddle_node = CurveFinding { coefficient: sn, simulated: Simulated::Against(sides) };
            let period_doubling =
                CurveFinding { coefficient: pd, simulated: Simulated::Undecided(undecided) };
            curves.findings = Pair { saddle_node, period_doubling };
            unfolding.push(at.clone());
        }
    }
    assert!(unfolding.len() > 1);
    for (at, row) in unfolding.iter().zip(known.at_resonances().coefficients) {
        let GrazingPoint { map, forcing_frequency, gamma, phi, psi } = at.point.grazing;
        let stability = at.point.stability_coefficients();
        let slope = |own: bool| if own { at.point.unfolding.derivative } else { f64::NAN };
        let wanted = expected! {
            LOOPS: at.loops,
            WALL: 0,
            RESONANCE_INDEX: at.n,
            SECONDARY_AT_RESONANCE: at.parameters[1],
            PRIMARY_AT_GRAZING: at.parameters[0],
            S_PLUS: stability.plus,
            S_MINUS: stability.minus,
            C_SN: 2.5,
            C_PD: -3.5,
            C_SN_ERROR: 1e-9,
            C_PD_ERROR: 3e-9,
            C_SN_FIT: 2.75,
            C_PD_FIT: -3.75,
            C_SN_FIT_ERROR: 2e-9,
            C_PD_FIT_ERROR: 1.0,
            SN_VERDICT: "contradict",
            SN_REASON: sn.verdict().reason(),
            PD_VERDICT: "not measurable",
            PD_REASON: pd.verdict().reason(),
            TAU: map.a.m11 + map.a.m22,
            DELTA: map.a.m11 * map.a.m22 - map.a.m12 * map.a.m21,
            ALPHA: 1.0 + phi - gamma * psi / forcing_frequency,
            BETA: (1.0 - map.a.m22) * map.b.x + map.a.m12 * map.b.y,
            GAMMA: gamma,
            XI: at.point.second_phase_derivative,
            A12_PRIME: slope(at.loops == 1),
            KAPPA_PRIME: slope(at.loops != 1),
            SIGMA: if at.loops == 1 { map.a.m22 } else { -libm::pow(map.determinant(), 0.5 * f64::from(at.loops)) },
            PD_CRITICALITY: at.point.limit_map().criticality(),
            C_2GZ: at.point.doubled_grazing_coefficient(),
            C_2GZ_FIT: at.curves.as_ref().map_or(f64::NAN, |curves| curves.doubled_grazing),
            SN_AS_SIMULATED: "no",
            SN_SIMULATION_REASON: sides.to_string(),
            PD_AS_SIMULATED: "undecided",
            PD_SIMULATION_REASON: undecided.to_string(),
        };
        assert_row("coefficients", columns_of(&row), &row.cells(), &wanted);
        let measured = at.curves.as_ref().map_or(f64::NAN, |curves| curves.doubled_grazing);
        let error = measured / at.point.doubled_grazing_coefficient() - 1.0;
        assert!(error.abs() < 1e-3, "p = {}, n = {}: {error}", at.loops, at.n);
    }
    // The quantities at the resonances are those of the diagram's resonances, in the same order.
    let units = unfolded.axes.units;
    for ((resonance, point), at) in unfolded.diagram.unfolding().zip(&unfolding) {
        let [primary, secondary] = point.orbit().oscillator().parameters();
        assert_eq!((at.loops, at.n), (resonance.loops, resonance.n));
        assert_eq!(at.parameters, [primary * units.primary, secondary * units.secondary]);
        assert_eq!(at.point.grazing.gamma, point.orbit().grazing_point().gamma * units.acceleration());
    }
}

#[test]
fn the_papers_coefficients_stand_in_their_own_cells() {
    let row = ComparedCoefficients {
        loops: 2,
        n: 5,
        frequency: 0.75,
        amplitude: 0.25,
        stability: StabilityCoefficients { plus: 1.25, minus: -1.5 },
        closed_form: Pair { saddle_node: 4.5, period_doubling: -5.5 },
        measured: coefficients(),
    };
    let Pair { saddle_node: sn, period_doubling: pd } = row.measured;
    let wanted = expected! {
        LOOPS: 2,
        RESONANCE_INDEX: 5,
        SECONDARY_AT_RESONANCE: 0.75,
        PRIMARY_AT_GRAZING: 0.25,
        S_PLUS: 1.25,
        S_MINUS: -1.5,
        C_SN_CLOSED_FORM: 4.5,
        C_PD_CLOSED_FORM: -5.5,
        C_SN: 2.5,
        C_PD: -3.5,
        C_SN_FIT: 2.75,
        C_PD_FIT: -3.75,
        C_SN_FIT_ERROR: 2e-9,
        C_PD_FIT_ERROR: 1.0,
        SN_VERDICT: "contradict",
        SN_REASON: sn.verdict().reason(),
        PD_VERDICT: "not measurable",
        PD_REASON: pd.verdict().reason(),
    };
    assert_row("coefficients", ComparedCoefficients::COLUMNS, &row.cells(), &wanted);
    assert!(row.contradict());
    let agreeing = Coefficient { fit: Err(CoefficientError::NotFinished), ..sn };
    assert!(
        !ComparedCoefficients { measured: Pair { saddle_node: agreeing, period_doubling: pd }, ..row }
            .contradict()
    );
    // The study's own contribution: closed forms beside the resonance of the same p and n.
    let rows = &made().coefficients;
    assert!(rows.len() >= 7);
    for row in rows {
        let closed = theory().resonance(row.loops, row.n).expect("there is one");
        assert_eq!(row.frequency, closed.forcing_frequency());
        assert_eq!(row.amplitude, closed.grazing().amplitude());
        assert_eq!(row.stability, closed.stability_coefficients());
        assert_eq!(row.closed_form.saddle_node, closed.saddle_node_coefficient());
        assert_eq!(row.closed_form.period_doubling, closed.period_doubling_coefficient());
        let stated = row.measured.map(|measured| measured.theorem.value);
        // Derivatives of the numerical map are accurate to eleven digits.
        assert!((stated.saddle_node / row.closed_form.saddle_node - 1.0).abs() < 1e-10);
        assert!((stated.period_doubling / row.closed_form.period_doubling - 1.0).abs() < 1e-10);
    }
}
