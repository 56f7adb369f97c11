//! Regions of stability, compared with all maximal periodic solutions in closed form, from a
//! quadratic equation.

use grazing_continuation::mps::unknown;
use grazing_input::Description;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Stop;
use grazing_results::Dimensioned;
use grazing_results::plane::RegionKind;
use grazing_trials::closed_form;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::progress::Silent;
use grazing_unfold::regions::Region;
use grazing_unfold::simulation::{ReturnOutcome, Suspect};
use grazing_unfold::{Diagram, Scope};

use crate::specimens::{EPSILON, LAYER, ZETA, constant, example, forced, grazing_at, linear, random, scope};

/// Number of cells of the lattice of points in each direction.
const LATTICE: u32 = 40;

/// The distance of a point from the border of a polygon, in fractions of the ranges.
fn distance(region: &Region, at: [f64; 2], scope: &Scope) -> f64 {
    let [primary, secondary] = [scope.window.primary, scope.window.secondary];
    let place = |p: [f64; 2]| {
        [
            (p[0] - primary[0]) / (primary[1] - primary[0]),
            (p[1] - secondary[0]) / (secondary[1] - secondary[0]),
        ]
    };
    let [x, y] = place(at);
    let mut least = f64::INFINITY;
    for vertices in &region.rings {
        for (k, a) in vertices.iter().enumerate() {
            let [a, b] = [place(*a), place(vertices[(k + 1) % vertices.len()])];
            let [u, v] = [b[0] - a[0], b[1] - a[1]];
            let along = (((x - a[0]) * u + (y - a[1]) * v) / (u * u + v * v)).clamp(0.0, 1.0);
            // Where two vertices coincide there is no edge.
            let along = if along.is_nan() { 0.0 } else { along };
            least = least.min(libm::hypot(a[0] + along * u - x, a[1] + along * v - y));
        }
    }
    least
}

/// Points of the polygon on a lattice over its extent, except those on its border.
fn points_of(region: &Region, scope: &Scope) -> Vec<[f64; 2]> {
    let extent = |axis: usize| {
        let values = region.rings.iter().flatten().map(|vertex| vertex[axis]);
        values
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
    };
    let [across, up] = [extent(0), extent(1)];
    let at = |[low, high]: [f64; 2], k: u32| low + (high - low) * (f64::from(k) + 0.5) / f64::from(LATTICE);
    let lattice = (0..LATTICE).flat_map(|i| (0..LATTICE).map(move |j| [at(across, i), at(up, j)]));
    // The chords of curves whose steps turn by two degrees deviate from them by less than this.
    lattice.filter(|point| region.contains(*point) && distance(region, *point, scope) > 1e-4).collect()
}

/// Checks that in every polygon there is a stable, admissible solution, to which simulation from
/// event to event returns.
///
/// `reduced` gives the amplitude and the frequency at which the linear oscillator is equivalent.
fn assert_stable_inside(
    diagram: &Diagram,
    [zeta, epsilon]: [f64; 2],
    reduced: impl Fn([f64; 2]) -> [f64; 2],
) -> Vec<(u32, u32)> {
    let mut found = Vec::new();
    for polygon in &diagram.regions {
        assert!(polygon.doubt.is_none(), "{:?}", polygon.doubt);
        // Slivers have points only on their border (`slivers`).
        if polygon.is_thin(diagram.scope.window) {
            continue;
        }
        let points = points_of(polygon, &diagram.scope);
        assert!(points.len() > 20, "p = {}, n = {}: {} points", polygon.loops, polygon.n, points.len());
        for point in points {
            let [amplitude, frequency] = reduced(point);
            let stable = if polygon.loops == 0 {
                amplitude < grazing_at(zeta, frequency).amplitude()
            } else {
                let oscillator = linear(zeta, epsilon, [amplitude, frequency]);
                let returns = |orbit: &closed_form::ClosedFormOrbit| {
                    let (velocity, phase) = (orbit.velocity, orbit.phase);
                    let suspect = Suspect { oscillator: &oscillator, loops: polygon.loops, velocity, phase };
                    suspect.follow() == ReturnOutcome::Returns
                };
                closed_form::orbits(zeta, epsilon, amplitude, frequency, polygon.loops)
                    .iter()
                    .any(|orbit| orbit.stable() && orbit.admissible() && returns(orbit))
            };
            assert!(stable, "p = {}, n = {} at {point:?}", polygon.loops, polygon.n);
        }
        found.push((polygon.loops, polygon.n));
    }
    found.sort_unstable();
    found
}

#[test]
fn solutions_are_stable_and_admissible_inside_the_polygons_of_the_linear_oscillator() {
    // This is the type of the window and the loops of Figure 7.
    let scope = scope([0.0, 1.3], [0.35, 1.02], &[1, 2, 3]);
    let diagram = Diagram::compute(&crate::specimens::closed_form(), &scope, &Silent).unwrap();
    let found = assert_stable_inside(&diagram, [ZETA, EPSILON], |at| at);
    assert_eq!(found[0], (0, 0));
    // The one at low frequencies belongs to a resonance outside of the window.
    let of_one_loop: Vec<u32> = found.iter().filter(|(loops, _)| *loops == 1).map(|(_, n)| *n).collect();
    assert_eq!(of_one_loop, [3, 4, 5, 6]);
    // Every resonance at which a theorem holds is a corner of a polygon of its MPSs; two may share
    // one.
    let polygons = &diagram.regions;
    for (resonance, point) in diagram.unfolding() {
        let [primary, secondary] = point.orbit().oscillator().parameters();
        let corners = polygons.iter().filter(|polygon| {
            let near = |at: &[f64; 2]| libm::hypot(at[0] - primary, at[1] - secondary) < 1e-9;
            polygon.loops == resonance.loops && polygon.rings.iter().flatten().any(near)
        });
        assert_eq!(corners.count(), 1, "p = {}, n = {}", resonance.loops, resonance.n);
    }
}

#[test]
fn the_number_of_a_region_is_that_of_the_resonance_that_its_curves_leave_in_every_window() {
    // With the resonance, with neither it nor the other end of the curves, with that end, and with the
    // curves of n = 5, which lead there.
    let windows = [
        ([0.6, 0.95], [0.32, 0.36]),
        ([0.6, 0.8], [0.352, 0.36]),
        ([0.6, 0.8], [0.355, 0.375]),
        ([0.6, 0.9], [0.355, 0.41]),
    ];
    for (amplitudes, frequencies) in windows {
        let scope = scope(amplitudes, frequencies, &[1]);
        let diagram = Diagram::compute(&crate::specimens::closed_form(), &scope, &Silent).unwrap();
        let here = [0.6748, 0.358];
        let own: Vec<u32> = diagram
            .regions
            .iter()
            .filter(|region| region.loops == 1 && region.contains(here))
            .map(|region| region.n)
            .collect();
        assert_eq!(own, [6], "{frequencies:?}");
        let low = |curve: &&DiagramCurve| curve.curve.parameters().iter().all(|[_, omega]| *omega < 0.37);
        let numbers: Vec<u32> =
            diagram.curves.iter().filter(|curve| curve.loops == 1).filter(low).map(|curve| curve.n).collect();
        assert!(!numbers.is_empty() && numbers.iter().all(|n| *n == 6), "{frequencies:?}: {numbers:?}");
        let corners =
            diagram.codimension_two.iter().filter(|point| point.unknowns()[unknown::SECONDARY] < 0.37);
        assert!(corners.clone().all(|point| point.n == 6), "{frequencies:?}");
    }
}

#[test]
fn solutions_are_stable_and_admissible_inside_the_polygons_where_the_clearance_is_the_parameter() {
    let (oscillator, _) = example("clearance.toml");
    let [alpha, r] = ["alpha", "r"].map(|name| constant("clearance.toml", name));
    let scope = scope([0.05, 1.0], [1.7, 2.3], &[1]);
    let diagram = Diagram::compute(&oscillator, &scope, &Silent).unwrap();
    // A greater clearance increases the distance from the wall.
    for state in &diagram.grazing[0].states {
        assert!(state.orbit.grazing_point().map.transversality() < 0.0);
    }
    // In units of the clearance the distance of the wall is 1 and the forcing is 1/σ.
    let found = assert_stable_inside(&diagram, [alpha, r], |[sigma, omega]| [1.0 / sigma, omega]);
    assert_eq!(found, [(0, 0), (1, 1)]);
    // The corner of great clearance belongs to the motion without impacts.
    let polygons = &diagram.regions;
    assert!(polygons.iter().any(|polygon| polygon.loops == 0 && polygon.contains([0.99, 2.29])));
}

#[test]
fn every_curve_is_found_in_windows_about_it_however_narrow() {
    let oscillator = crate::specimens::closed_form();
    let loops = [1, 2];
    let diagram = Diagram::compute(&oscillator, &scope([0.0, 1.2], [0.3, 1.1], &loops), &Silent).unwrap();
    assert!(diagram.curves.len() > 20, "{}", diagram.curves.len());
    for (known, width) in diagram.curves.iter().zip([1e-3, 1e-9].into_iter().cycle()) {
        let places = known.curve.parameters();
        let at = places[places.len() / 2];
        let [primary, secondary] = at.map(|value| [value - 0.5 * width, value + 0.5 * width]);
        let narrow = scope(primary, secondary, &loops);
        let found = Diagram::compute(&oscillator, &narrow, &Silent).unwrap();
        let same = found.curves.iter().find(|curve| (curve.kind, curve.loops) == (known.kind, known.loops));
        let places = same.map(|curve| curve.curve.parameters()).unwrap_or_default();
        let [first, last] = [places.first(), places.last()];
        let reaches = first.zip(last).is_some_and(|(a, b)| (0..2).any(|k| (a[k] - b[k]).abs() > 0.2 * width));
        assert!(reaches, "{:?} of {} loops at {at:?} in {width}: {places:?}", known.kind, known.loops);
    }
}

/// Whether stable motion without impacts is shaded at a pair of parameters.
fn stays_off(diagram: &Diagram, at: [f64; 2]) -> bool {
    diagram.regions.iter().any(|region| region.kind() == RegionKind::NonImpacting && region.contains(at))
}

/// The diagram of an oscillator without the curves of its MPSs, in some ranges.
fn located(model: Description, [primary, secondary]: [[f64; 2]; 2]) -> Diagram {
    let oscillator = model.oscillator([primary[1], secondary[1]]);
    Diagram::located(&oscillator, &scope(primary, secondary, &[1]), &Silent).expect("there is grazing")
}

/// Between grazing and a fold that touches it there is a sliver, one and a half percent of the
/// ranges wide.
#[test]
fn motion_without_impacts_is_stable_up_to_the_fold_that_bounds_it() {
    let diagram = located(random(3, 20_261_122), [[0.0, 0.5475], [0.6423, 1.0650]]);
    let stable = |at| stays_off(&diagram, at);
    // The fold is at 0.0796 there, grazing at 0.0712.
    assert!(stable([0.0785, 0.911_771_25]) && !stable([0.0805, 0.911_771_25]));
}

/// A spring that stiffens as an exponential, under a load and two harmonics.
#[test]
fn a_region_on_the_edge_to_which_only_inadmissible_solutions_lead_is_found_and_nothing_is_left_undecided() {
    let force = "-0.08*v - (exp(0.6*x) - 1)/0.6 - 0.1 + mu*cos(eta*t) + 0.15*sin(2*eta*t + 0.7)";
    let ranges = [[0.0, 1.2], [0.5, 1.3]];
    let scope = scope(ranges[0], ranges[1], &[1]);
    let oscillator = forced(force, "0.8", 0.8, ranges).oscillator([0.6, 0.9]);
    let diagram = Diagram::compute(&oscillator, &scope, &Silent).unwrap();
    // The region lies at omega < 0.5204 between 0.09 < A < 0.47: at both ends of the range of A
    // solutions are stable there, and go through the wall.
    let here = [0.2562, 0.5131];
    let simulated = oscillator.with_parameters(here);
    let suspect = Suspect { oscillator: &simulated, loops: 1, velocity: 0.711, phase: 0.922 };
    assert_eq!(suspect.follow(), ReturnOutcome::Returns);
    assert!(diagram.regions.iter().any(|region| region.kind() == RegionKind::Mps && region.contains(here)));
    // Slices meet other branches on known saddle-node curves: these begin at bifurcations.
    let undecided = diagram.regions.iter().filter(|region| region.doubt.is_some());
    assert_eq!(undecided.count(), 0);
}

/// A linear oscillator with a little of the second harmonic, damping across: at half its own
/// frequency it resonates, within a hundredth of the distance between slices.
#[test]
fn a_resonance_of_motion_without_impacts_that_is_narrower_than_slices_are_apart_is_found() {
    let ranges = [[0.001, 0.6], [0.4, 1.3]];
    let force = "-2*mu*v - x - 1 + 0.6*cos(eta*t) + 0.02*cos(2*eta*t)";
    let diagram = located(forced(force, "0", 0.9, ranges), ranges);
    // By the closed form of the motion, whose highest point is found by golden sections.
    let known = [0.029_921_257_2, 0.499_776_129];
    let near = |at: [f64; 2]| (at[0] - known[0]).abs().max((at[1] - known[1]).abs()) < 1e-8;
    assert!(
        diagram
            .resonances
            .iter()
            .any(|found| { found.n == 4 && near(found.located.orbit().oscillator().parameters()) })
    );
    let stays_off = |at| stays_off(&diagram, at);
    // There motion passes the wall by 1.59; beside the tongue it does not reach it.
    assert!(!stays_off([0.005, 0.5]) && stays_off([0.05, 0.5]) && stays_off([0.005, 0.55]));
}

/// A pendulum whose length changes, the wall's position across, on which motion without impacts
/// does not depend.
#[test]
fn a_fold_along_a_slice_and_motion_that_no_slice_shows_bound_regions() {
    let ranges = [[-0.4, 1.6], [0.5, 2.4]];
    let force = "-0.1*v - (1 + 0.35*cos(2*eta*t))*sin(x) + 0.3*cos(eta*t + 0.4)";
    let diagram = located(forced(force, "mu", 0.8, ranges), ranges);
    let stays_off = |at| stays_off(&diagram, at);
    // Small motion, highest at 0.8, is stable up to a fold at omega = 0.7957, for any b; other
    // motion, highest at 1.24 there, from 0.794 to 0.877.
    assert!([0.9, 1.3, 1.5, 1.58].into_iter().all(|b| stays_off([b, 0.78])));
    assert!(stays_off([1.4, 0.86]) && !stays_off([1.2, 0.86]));
}

/// A spring with such a layer, in which motion is doubled: along one slice the tip of that region
/// is less than a step wide, and its border is a known curve.
#[test]
fn a_slice_does_not_step_over_both_sides_of_the_tip_of_a_region() {
    let ranges = [[0.0, 1.2], [0.6, 1.075]];
    let model = forced(&format!("-0.06*v - (x + 1) + {LAYER} + mu*cos(eta*t)"), "0", 0.7, ranges);
    let units = model.units();
    let own = scope(ranges[0], ranges[1], &[1]).without_dimensions(&units);
    let oscillator = model.counted([1.2, 1.075], &units, &Stop::default());
    let diagram = Diagram::located(&oscillator, &own, &Silent).expect("there is grazing");
    let stays_off = |place: [f64; 2]| stays_off(&diagram, units.without_dimensions(place));
    // By integration with another method: multipliers -1.008 and -0.631 at the third place. At
    // omega = 0.832 motion is doubled for A from 0.36886 to 0.43449.
    assert!(stays_off([0.36, 0.832]) && stays_off([0.375, 0.85]));
    assert!([0.375, 0.39, 0.42].into_iter().all(|a| !stays_off([a, 0.832])));
}

/// Damping that large motion overcomes: beside small motion there is a closed branch of large
/// motion, less than a hundredth of the range of ω wide.
#[test]
fn grazing_of_a_closed_branch_between_two_slices_is_found() {
    let ranges = [[0.05, 1.6], [0.63, 1.63]];
    let force = "-(0.14 - 0.3*v^2 + 0.15*v^4)*v - x + 0.01*cos(eta*t)";
    let diagram = located(forced(force, "mu", 0.8, ranges), ranges);
    // By integration with another method (Runge-Kutta of order eight) and shooting.
    for known in [[1.180_427_91, 0.999_503_67], [0.982_820_35, 0.999_699_88]] {
        let near = |at: [f64; 2]| (at[0] - known[0]).abs().max((at[1] - known[1]).abs()) < 1e-8;
        let places = diagram.resonances.iter().map(|found| found.located.orbit().oscillator().parameters());
        assert!(places.into_iter().any(near), "{known:?}");
    }
}

/// A force that saturates, and a wall near rest, whose distance is the unit of length.
#[test]
fn solutions_that_are_faster_than_any_that_is_known_are_found() {
    let ranges = [[0.0, 0.6], [0.5, 2.0]];
    let description = forced("-0.1*v - tanh(3*x) + mu*cos(eta*t)", "0.15", 0.85, ranges);
    let units = description.units();
    let own = scope(ranges[0], ranges[1], &[1]);
    let oscillator = description.counted([0.3, 1.0], &units, &Stop::default());
    let diagram = Diagram::compute(&oscillator, &own.without_dimensions(&units), &Silent).unwrap();
    // Simulation returns to solutions with impact velocities from 2.7 to 3.4 there; the other known
    // ones have 1 at most.
    for here in [[0.57, 1.07], [0.575, 1.05], [0.575, 1.15]] {
        let here = units.without_dimensions(here);
        let shaded = |region: &Region| region.kind() == RegionKind::Mps && region.contains(here);
        assert!(diagram.regions.iter().any(shaded), "{here:?}");
    }
}

/// Damping strong enough to prevent oscillation.
#[test]
fn motion_that_is_forgotten_within_a_period_is_stable() {
    let ranges = [[0.0, 8.0], [0.1, 2.0]];
    let diagram = located(forced("-3*v - x - 1 + mu*cos(eta*t)", "0", 0.5, ranges), ranges);
    // Multipliers are exp((−1.5 ± 1.12) 2π/ω), one of them less than rounding for small ω.
    assert!(diagram.grazing.iter().flat_map(|curve| &curve.states).all(|state| state.multipliers.stable()));
    assert!([[0.11, 0.2], [1.17, 0.3035], [0.2, 0.11]].into_iter().all(|at| stays_off(&diagram, at)));
}

#[test]
fn every_small_region_of_slow_forcing_is_shaded() {
    let oscillator = linear(0.005, 0.9, [1.0, 0.1]);
    let diagram = Diagram::compute(&oscillator, &scope([0.0, 1.5], [0.04, 0.4], &[1]), &Silent).unwrap();
    let shaded =
        |at| diagram.regions.iter().any(|region| region.kind() == RegionKind::Mps && region.contains(at));
    let stable = |[amplitude, eta]: [f64; 2]| {
        let orbits = closed_form::orbits(0.005, 0.9, amplitude, eta, 1);
        orbits.iter().any(|orbit| orbit.stable() && orbit.admissible())
    };
    let mut seen = [0, 0];
    for k in 0..400 {
        // The regions of n = 34 to 49 lie here, two thousandths of the window high.
        let eta = 0.0405 + 0.0195 * f64::from(k) / 400.0;
        let at = [grazing_at(0.005, eta).amplitude() + 1.5e-3, eta];
        let beside = [[-1e-4, 0.0], [1e-4, 0.0], [0.0, -1e-5], [0.0, 1e-5]];
        // Curves are drawn by chords.
        if beside.iter().all(|by| stable([at[0] + by[0], at[1] + by[1]]) == stable(at)) {
            assert_eq!(shaded(at), stable(at), "{at:?}");
            seen[usize::from(stable(at))] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
}
