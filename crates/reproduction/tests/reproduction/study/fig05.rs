//! Tests that the shaded region of Figure 5 is where it should be, and of what the figure shows.

use core::f64::consts::TAU;
use std::sync::{Arc, LazyLock};

use grazing_drawing::SheetWidth;
use grazing_model::State;
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_reproduction::StudyFigure;
use grazing_reproduction::figures::fig05::{Figure5, UnfoldingSketch};
use grazing_theorems::Resonance;

use super::{closed_forms, forced, made, numbers, theory, words};
use grazing_trials::closed_form::ClosedFormOrbit;

static SHOWN: LazyLock<Figure5> = LazyLock::new(|| made().parameters.section().expect("it is right"));
static FIGURE: LazyLock<Arc<UnfoldingSketch>> =
    LazyLock::new(|| made().study.shown::<Figure5>().expect("figure 5 can be computed"));
static RESONANCE: LazyLock<Resonance> =
    LazyLock::new(|| theory().resonance(SHOWN.loops, SHOWN.n).expect("a resonance"));

/// Amplitude and frequency at (μ, η).
fn parameters_at(mu: f64, eta: f64) -> (f64, f64) {
    let omega = RESONANCE.forcing_frequency() + eta;
    (RESONANCE.grazing().oscillator().grazing(omega).unwrap().amplitude() + mu, omega)
}

/// The MPSs in closed form at (μ, η), without virtual and inadmissible ones.
fn solutions(mu: f64, eta: f64) -> Vec<ClosedFormOrbit> {
    let (amplitude, omega) = parameters_at(mu, eta);
    let all = closed_forms(amplitude, omega, SHOWN.loops);
    all.into_iter().filter(ClosedFormOrbit::admissible).collect()
}

/// Vertices (μ, η) of the region of a kind.
fn region(figure: &UnfoldingSketch, kind: &str) -> Vec<[f64; 2]> {
    let kinds = words(&figure.regions, "kind");
    let (mu, eta) = (numbers(&figure.regions, "mu"), numbers(&figure.regions, "eta"));
    (0..kinds.len()).filter(|&row| kinds[row] == kind).map(|row| [mu[row], eta[row]]).collect()
}

/// Whether a point is inside a polygon, by the even-odd rule.
fn inside(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let crossed = |(a, b): &(&[f64; 2], &[f64; 2])| {
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    };
    polygon.iter().zip(next).filter(crossed).count() % 2 == 1
}

/// The centres of the cells of a grid over the window.
fn grid(cells: u32) -> Vec<[f64; 2]> {
    let shown = &*SHOWN;
    let at = |[low, high]: [f64; 2], k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(cells);
    (0..cells).flat_map(|i| (0..cells).map(move |j| [at(shown.mu, i), at(shown.eta, j)])).collect()
}

/// Distance in μ, over the width of the window, from the boundary of the shaded region.
fn margin([mu, eta]: [f64; 2]) -> f64 {
    let (sn, pd) = (RESONANCE.saddle_node_coefficient(), RESONANCE.period_doubling_coefficient());
    let boundary = if eta * saddle_node_side() > 0.0 { sn } else { pd } * eta * eta;
    let [low, high] = SHOWN.mu;
    (mu - boundary).abs() / (high - low)
}

/// The sign of η on the saddle-node curve of the frame.
fn saddle_node_side() -> f64 {
    let figure = &*FIGURE;
    let kinds = words(&figure.curves, "kind");
    let last = kinds.iter().rposition(|kind| kind == "SN").expect("there is an SN curve");
    numbers(&figure.curves, "eta")[last].signum()
}

#[test]
fn it_is_the_case_of_the_caption_with_the_curves_on_opposite_sides() {
    let (figure, resonance) = (&*FIGURE, &*RESONANCE);
    assert!(resonance.saddle_node_coefficient() < 0.0 && resonance.period_doubling_coefficient() > 0.0);
    assert!(resonance.grazing().transversality() > 0.0);
    let kinds = words(&figure.curves, "kind");
    let (mu, eta) = (numbers(&figure.curves, "mu"), numbers(&figure.curves, "eta"));
    let mut seen = [0, 0];
    for row in 0..kinds.len() {
        let (which, c, side) = match kinds[row].as_str() {
            "SN" => (0, resonance.saddle_node_coefficient(), saddle_node_side()),
            "PD" => (1, resonance.period_doubling_coefficient(), -saddle_node_side()),
            _ => {
                assert_eq!(mu[row], 0.0);
                continue;
            }
        };
        seen[which] += 1;
        // General theorem and closed form agree to about 1e-12; see
        // `coefficients_come_out_the_same_in_three_ways`.
        assert!((mu[row] - c * eta[row] * eta[row]).abs() <= 1e-11 * mu[row].abs(), "{mu:?}");
        assert!(eta[row] * side >= 0.0);
    }
    assert!(seen.iter().all(|&rows| rows > 50), "{seen:?}");
}

#[test]
fn every_resonance_of_the_linear_oscillator_is_of_that_case() {
    for zeta in [0.005, 0.02, 0.2, 0.9] {
        for epsilon in [0.01, 0.5, 0.9, 1.0] {
            let theory = grazing_theorems::LinearOscillator::new(zeta, epsilon).unwrap();
            for (p, n) in (1..=6).flat_map(|p| (1..=5).map(move |n| (p, n))) {
                let resonance = theory.resonance(p, n).unwrap();
                // Computed with the theorem's definition, independently of the closed form.
                let s = resonance.resonant_point().stability_coefficients();
                assert!(s.plus < 0.0 && 0.0 < s.minus, "zeta {zeta}, epsilon {epsilon}, p {p}, n {n}: {s:?}");
                assert!(resonance.grazing().transversality() > 0.0);
            }
        }
    }
}

#[test]
fn an_mps_is_stable_in_the_shaded_region_and_nowhere_else() {
    // The region is right to leading order: mismatches lie in a band about its boundary whose width,
    // relative to a window that shrinks like (η, μ) → (sη, s²μ), decreases like s.
    let shaded = region(&FIGURE, "mps");
    let band = |s: f64| {
        let mut widest = 0.0_f64;
        let mut stable = 0;
        for [mu, eta] in grid(60) {
            let found = solutions(s * s * mu, s * eta).iter().filter(|orbit| orbit.stable()).count();
            assert!(found <= 1);
            stable += found;
            if (found == 1) != inside(&shaded, [mu, eta]) {
                widest = widest.max(margin([mu, eta]));
            }
        }
        assert!(stable > 500, "{stable}");
        widest
    };
    // In the drawn window the band is thinner than the green line.
    assert!(band(1.0) < 0.03, "{}", band(1.0));
    // A tenth of it is less than the pitch of the grid, so there may be no mismatch left.
    assert!(band(0.1) < 0.003, "{}", band(0.1));
}

#[test]
fn both_solutions_are_stable_in_the_overlap_of_the_two_regions() {
    let figure = &*FIGURE;
    let [light, dark, both] = ["non-impacting", "mps", "both"].map(|kind| region(figure, kind));
    let mut overlap = 0;
    for point in grid(60) {
        let in_both = inside(&light, point) && inside(&dark, point);
        assert_eq!(inside(&both, point), in_both, "{point:?}");
        overlap += usize::from(in_both);
    }
    assert!(overlap > 100, "{overlap}");
}

/// The impacts (velocity, phase) of an orbit that starts close to an MPS, in the last of many periods.
fn last_impacts(mu: f64, eta: f64, from: &ClosedFormOrbit, closeness: f64) -> Vec<[f64; 2]> {
    let (amplitude, omega) = parameters_at(mu, eta);
    let oscillator = forced(amplitude, omega);
    let period = f64::from(SHOWN.loops) * TAU / omega;
    let start = State::on_wall(from.velocity * (1.0 + closeness), from.phase);
    let periods = 400.0;
    // Half a period more, so that no impact coincides with the end.
    let horizon = (periods + 0.5) * period;
    let flights = Orbit::new(&oscillator, start, horizon, 100_000);
    let mut impacts = Vec::new();
    for flight in flights {
        if let FlightEnd::Impact(state) = flight.end
            && flight.start + flight.duration > horizon - 4.0 * period
        {
            impacts.push([state.velocity, state.phase]);
        }
    }
    impacts
}

#[test]
fn simulated_orbits_settle_on_the_mps_in_the_shaded_region_and_leave_it_outside() {
    let shaded = region(&FIGURE, "mps");
    let (mut settled, mut left) = (0, 0);
    for [mu, eta] in grid(14) {
        if margin([mu, eta]) < 0.05 {
            continue;
        }
        for orbit in solutions(mu, eta) {
            let impacts = last_impacts(mu, eta, &orbit, 1e-4);
            // Whether four successive impacts repeat that of the MPS, up to the remaining perturbation.
            let stays = impacts.len() == 4
                && impacts.iter().all(|[velocity, _]| (velocity / orbit.velocity - 1.0).abs() < 1e-6);
            if inside(&shaded, [mu, eta]) && orbit.stable() {
                assert!(stays, "({mu}, {eta}): {impacts:?} for {}", orbit.velocity);
                settled += 1;
            } else {
                assert!(!stays, "({mu}, {eta})");
                left += 1;
            }
        }
    }
    assert!(settled >= 80 && left >= 8, "{settled} {left}");
}

#[test]
fn the_non_impacting_solution_attracts_where_it_is_said_to() {
    let light = region(&FIGURE, "non-impacting");
    for [mu, eta] in grid(8) {
        let (amplitude, omega) = parameters_at(mu, eta);
        let oscillator = forced(amplitude, omega);
        let top = RESONANCE.grazing().oscillator().grazing(omega).unwrap().phase();
        let State { position, velocity, phase } = oscillator.non_impacting_solution(top);
        assert_eq!(position < 0.0, inside(&light, [mu, eta]));
        if position < 0.0 {
            // Motion that starts slightly lower returns without reaching the wall: the free motion only
            // decays.
            let from = State { position: 1.001 * position, velocity, phase };
            let mut orbit = Orbit::new(&oscillator, from, 50.0 * TAU / omega, 1000);
            assert_eq!(orbit.by_ref().count(), 1);
            assert_eq!(orbit.impacts(), 0);
        }
    }
}

#[test]
fn closed_form_solutions_are_those_of_the_branch_expansion() {
    // μ = k₂y² + k₃ηy of eq:ZM, on which the argument for the region rests: at the turning point
    // y = Υ⁺η the two MPSs merge.
    let (shown, resonance) = (&*SHOWN, &*RESONANCE);
    let branch = resonance.resonant_point().branch_expansion();
    assert!(branch.k_2 > 0.0);
    let edge = if saddle_node_side() < 0.0 { shown.eta[0] } else { shown.eta[1] };
    let worst = |s: f64| {
        let eta = s * edge;
        let mu = 0.25 * resonance.saddle_node_coefficient() * eta * eta;
        let found: Vec<ClosedFormOrbit> = solutions(mu, eta);
        assert_eq!(found.len(), 2, "both MPSs between SN and grazing");
        found.iter().map(|o| (branch.parameter(o.velocity, eta) / mu - 1.0).abs()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (worst(0.1), worst(0.01));
    // The next order is smaller by a factor of η.
    assert!(coarse < 0.03 && (7.0..13.0).contains(&(coarse / fine)), "{coarse} {fine}");
}

#[test]
fn curves_and_regions_are_named_and_the_overlap_is_shaded_by_its_two_regions_alone() {
    let svg = Figure5::draw(&FIGURE, SheetWidth::Paper).unwrap().svg();
    let svg = svg.split("<defs").next().unwrap();
    for label in [">SN<", ">PD<", ">grazing<", ">non-impacting<", ">both<", ">μ<", ">η<", "-loop MPS<"] {
        assert!(svg.contains(label), "{label}");
    }
    assert_eq!(svg.matches("fill=\"#e9e9e9\"").count(), 1);
    assert_eq!(svg.matches("fill-opacity=\"0.3\"").count(), 1);
}
