//! Tests of the cases of the sweep, and an independent search; the sweep itself is run by the ledger's
//! checks and by `reproduce`.

use grazing_claims::sweep::closed_form::LoopSolutions;
use grazing_claims::sweep::resonant::CurveRow;
use grazing_claims::sweep::{
    Case, CaseVerdict, Existence, GenericRow, ResonantRow, generic_cases, resonant_cases,
};
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::{ImpactOscillator, LinearOscillator, State};
use grazing_theorems::Side;
use grazing_theorems::auxiliary::detuning;
use grazing_unfold::simulation::{ReturnOutcome, Suspect};

#[test]
fn the_cases_go_to_where_the_theorems_change_their_minds() {
    let generic = generic_cases().unwrap();
    let resonant = resonant_cases().unwrap();
    let point = |case: &Case| {
        let theory = grazing_theorems::LinearOscillator::new(case.zeta, case.epsilon).unwrap();
        theory.grazing(case.omega).unwrap()
    };
    for p in 1..=6 {
        let of_p: Vec<_> = generic.iter().filter(|case| case.loops == p).map(point).collect();
        // Both signs of a₁₂, and both sides of g_p with a₁₂ > 0.
        for sign in [1.0, -1.0] {
            assert!(of_p.iter().any(|state| sign * state.linearised_map().a.m12 > 0.0), "p = {p}");
            let side = |state: &grazing_theorems::GrazingState| {
                let detuning = detuning(p, state.trace(), state.determinant());
                p == 1 || state.linearised_map().a.m12 > 0.0 && sign * detuning > 0.0
            };
            assert!(of_p.iter().any(side), "p = {p}");
        }
    }
    // ε on both sides of 1/E_p, and equal to it.
    let rebound = |case: &Case| {
        let theory = grazing_theorems::LinearOscillator::new(case.zeta, case.epsilon).unwrap();
        case.epsilon * theory.grazing(case.omega).unwrap().decay(case.loops)
    };
    for (lower, upper) in [(0.9, 0.99), (1.0 - 1e-14, 1.0 + 1e-14), (1.01, 1.1)] {
        assert!(resonant.iter().any(|case| (lower..=upper).contains(&rebound(case))), "{lower} {upper}");
    }
    assert!(resonant.iter().any(|case| case.negative));
}

/// The difference between the impact about p forcing periods after one at (y, z) and that one, by
/// simulation.
fn next_velocity(oscillator: &LinearOscillator, loops: u32, velocity: f64, phase: f64) -> Option<[f64; 2]> {
    let period = oscillator.forcing_period();
    let due = f64::from(loops) * period;
    let from = State::on_wall(velocity, phase);
    let flight = Orbit::new(oscillator, from, due + 0.25 * period, 2).next()?;
    let FlightEnd::Impact(impact) = flight.end else { return None };
    let late = (flight.duration - due) * oscillator.frequency();
    (late.abs() < 1.0).then_some([impact.velocity - velocity, late])
}

/// Impacts (y, z) near grazing to which the hybrid system returns, found by Newton's method on simulated
/// orbits alone, from a grid of impacts that is dense enough in z to include orbits of all kinds.
fn found_by_search(oscillator: &LinearOscillator, loops: u32, centre: f64, scale: f64) -> Vec<[f64; 2]> {
    let mut found: Vec<[f64; 2]> = Vec::new();
    let steps = 400;
    for i in 1..=8 {
        let velocity = 0.25 * f64::from(i) * scale;
        for k in -steps..=steps {
            let phase = centre + 8.0 * scale * f64::from(k) / f64::from(steps);
            let mut here = [velocity, phase];
            for _ in 0..20 {
                let value = |y: f64, z: f64| next_velocity(oscillator, loops, y, z);
                let h = 1e-4 * here[0].abs();
                let (Some(f), Some(fy), Some(fz)) = (
                    value(here[0], here[1]),
                    value(here[0] + h, here[1]),
                    value(here[0], here[1] + h * here[0]),
                ) else {
                    break;
                };
                let [[a, c], [b, d]] = [
                    [(fy[0] - f[0]) / h, (fy[1] - f[1]) / h],
                    [(fz[0] - f[0]) / (h * here[0]), (fz[1] - f[1]) / (h * here[0])],
                ];
                let determinant = a * d - b * c;
                let step = [(d * f[0] - b * f[1]) / determinant, (a * f[1] - c * f[0]) / determinant];
                here = [here[0] - step[0], here[1] - step[1]];
                if step[0].abs() + step[1].abs() < 1e-7 * scale {
                    let new = found.iter().all(|other| (other[0] - here[0]).abs() > 1e-3 * scale);
                    if here[0] > 0.0 && new {
                        found.push(here);
                    }
                    break;
                }
                if here[0] <= 0.0 {
                    break;
                }
            }
        }
    }
    found
}

#[test]
fn a_blind_search_by_simulation_finds_the_orbit_on_its_side_and_none_on_the_other() {
    // Below and above g_p the MPS is to the left and to the right of grazing, respectively.
    for (loops, fraction) in [(1, 0.05), (1, -0.05), (2, 0.2), (2, 0.3), (3, 0.2)] {
        let (zeta, epsilon) = (0.03, 0.8);
        let from = if loops == 1 { 1.5 } else { 1.0 };
        let omega = (1.0_f64 - zeta * zeta).sqrt() / (from + fraction);
        let solutions = LoopSolutions::new(zeta, epsilon, omega, loops);
        let (stiffness, loss) = (1.0 - omega * omega, 2.0 * zeta * omega);
        let centre = libm::atan2(loss, stiffness);
        let scale = 0.01;
        let mu = scale / solutions.slopes()[0];
        let search = |mu: f64| {
            let amplitude = solutions.grazing_amplitude() + mu;
            let oscillator = LinearOscillator::new(zeta, epsilon, amplitude, omega).unwrap();
            (found_by_search(&oscillator, loops, centre, scale), oscillator)
        };
        let (there, oscillator) = search(mu);
        assert_eq!(there.len(), 1, "p = {loops}, {fraction}: {there:?}");
        let suspect = Suspect { oscillator: &oscillator, loops, velocity: there[0][0], phase: there[0][1] };
        assert_eq!(suspect.follow(), ReturnOutcome::Returns);
        let exact = solutions.at(mu)[0];
        // Newton's method stops at steps of 1e-7 of the scale.
        assert!((there[0][0] / exact.velocity - 1.0).abs() < 1e-5, "{there:?} {exact:?}");
        let (other, _) = search(-mu);
        assert!(other.is_empty(), "p = {loops}, {fraction}: {other:?}");
    }
}

#[test]
fn each_thing_seen_of_an_orbit_is_needed_for_an_agreement() {
    let case = Case { zeta: 0.03, epsilon: 0.8, loops: 2, n: 1, negative: false, omega: 0.83 };
    let good = GenericRow::of(case).expect("the case can be worked out");
    assert_eq!(good.verdict(), CaseVerdict::Agreement);
    let Some(side) = good.predicted else { panic!("the theorem applies") };
    let other = if side == Side::Positive { Side::Negative } else { Side::Positive };
    let spoiled = [
        GenericRow { predicted: Some(other), ..good.clone() },
        GenericRow { continued: Existence::On(other), ..good.clone() },
        GenericRow { simulated: Existence::Nowhere, ..good.clone() },
        GenericRow { first_order: Existence::On(other), ..good.clone() },
        GenericRow { unstable: [true, false], ..good.clone() },
        GenericRow { unstable: [false, true], ..good.clone() },
        GenericRow { slopes: [[1.0, 1.0], [1.0, 1.0], [1.0, 1.001]], ..good.clone() },
        GenericRow { slopes: [[1.0, 1.0], [f64::NAN, 1.0], [1.0, 1.0]], ..good },
    ];
    for row in spoiled {
        assert_eq!(row.verdict(), CaseVerdict::Unexplained, "{row:?}");
    }
}

#[test]
fn each_thing_seen_of_a_curve_is_needed_for_an_agreement() {
    let theory = grazing_theorems::LinearOscillator::new(0.03, 0.8).expect("valid");
    let omega = theory.resonance(2, 1).expect("there is one").forcing_frequency();
    let case = Case { zeta: 0.03, epsilon: 0.8, loops: 2, n: 1, negative: false, omega };
    let row = ResonantRow::of(case).expect("the case can be worked out");
    assert_eq!(row.verdict(), CaseVerdict::Agreement);
    for good in row.curves {
        assert!(good.agrees());
        let Some(side) = good.predicted else { panic!("the theorem applies") };
        let other = if side == Side::Positive { Side::Negative } else { Side::Positive };
        let spoiled = [
            CurveRow { predicted: Some(other), ..good },
            CurveRow { continued: Some(Existence::On(other)), ..good },
            CurveRow { simulated: Existence::Nowhere, ..good },
            CurveRow { crossed: false, ..good },
            CurveRow { stability_changes: Some(false), ..good },
            CurveRow { theorem: 1.001 * good.theorem, ..good },
            CurveRow { proposition: 1.001 * good.proposition, ..good },
            CurveRow { quadratic_equation: f64::NAN, ..good },
            CurveRow { fit: None, ..good },
        ];
        for curve in spoiled {
            assert!(!curve.agrees(), "{curve:?}");
        }
    }
}
