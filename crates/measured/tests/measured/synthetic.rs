//! Synthetic experiments with noise of known size: the identified constants, and whether their errors are
//! right.

use core::f64::consts::TAU;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Window;
use grazing_measured::read::Impact;
use grazing_measured::{
    Behaviour, Datum, Fit, IdentificationTask, ImpactRecord, Loss, MeasuredWalls, Measurements, Observation,
    Segment, associate, fit, identify,
};
use grazing_model::orbit::{FlightEnd, Orbit};
use grazing_model::smooth::Units;
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator, OnWall, State};
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// Damping ratio and restitution of the synthetic oscillator; below, the values with which the search
/// begins.
const TRUTH: [f64; 2] = [0.02, 0.9];
const START: [f64; 2] = [0.021, 0.89];
const WINDOW: Window = Window { primary: [0.0, 1.2], secondary: [0.45, 1.05] };
const RIGS: u32 = 200;

fn rig(constants: &[f64]) -> Option<AnyOscillator> {
    let [zeta, epsilon] = [constants[0], constants[1]];
    LinearOscillator::new(zeta, epsilon, 0.3, 0.8).ok().map(AnyOscillator::new)
}

fn scope() -> Scope {
    Scope { window: WINDOW, loops: vec![1], start: None }
}

/// The diagram without regions.
fn diagram(constants: &[f64]) -> Diagram {
    let located = Diagram::located(&rig(constants).unwrap(), &scope(), &Silent).unwrap();
    let followed = located.follow(&Silent, &|_, _| ());
    located.with_curves(followed)
}

/// Normally distributed numbers.
pub(crate) struct Noise(Pcg64);

impl Noise {
    pub(crate) fn of(rig: u32) -> Self {
        Self(Pcg64::new(20_261_124, u128::from(rig)))
    }

    /// A number between 0 and 1.
    pub(crate) fn uniform(&mut self) -> f64 {
        (f64::from(self.0.next_u32()) + 0.5) / 4_294_967_296.0
    }

    pub(crate) fn next(&mut self) -> f64 {
        (-2.0 * libm::log(self.uniform())).sqrt() * libm::cos(TAU * self.uniform())
    }
}

/// Places on the true oscillator's curves of grazing, SN and PD.
fn places(truth: &Diagram) -> Vec<(Behaviour, [f64; 2])> {
    let mut all = Vec::new();
    let grazing: Vec<[f64; 2]> = truth.grazing.iter().flat_map(|curve| curve.parameters()).collect();
    let kind = Bifurcation::NonImpactingGrazing;
    let seen = |kind, loops| Behaviour::Bifurcation { kind, loops, walls: MeasuredWalls::Unsaid };
    all.extend((1..5).map(|k| (seen(kind, None), grazing[k * grazing.len() / 5])));
    for curve in &truth.curves {
        let seen = seen(curve.kind, Some(curve.loops));
        let bends = matches!(curve.kind, Bifurcation::SaddleNode | Bifurcation::PeriodDoubling);
        let points = curve.curve.parameters();
        all.extend(
            [1, 2]
                .into_iter()
                .filter(|_| bends && points.len() > 9)
                .map(|k| (seen, points[k * points.len() / 3])),
        );
    }
    all
}

/// The places with the noise of one synthetic experiment.
fn measured(places: &[(Behaviour, [f64; 2])], errors: [f64; 2], number: u32) -> Vec<Observation> {
    let mut noise = Noise::of(number);
    let one = |(line, (seen, at)): (u32, &(Behaviour, [f64; 2]))| {
        let at = [0, 1].map(|k| at[k] + errors[k] * noise.next());
        Observation { line, at, errors, seen: *seen }
    };
    (2..).zip(places).map(one).collect()
}

/// Impacts of the true oscillator at a place, from an impact far from the attractor.
fn impacts(at: [f64; 2], first: [f64; 2], count: usize) -> Vec<[f64; 3]> {
    let here = rig(&TRUTH).unwrap().with_parameters(at);
    let start = State::on_wall(first[1], first[0] * here.forcing_frequency().value);
    let orbit = Orbit::new(&here, start, 1e4, count);
    let struck = orbit.filter_map(|flight| match flight.end {
        FlightEnd::Impact(state) => Some((flight.start + flight.duration, state)),
        FlightEnd::TimeIsUp(_) => None,
    });
    let all = [(0.0, start)].into_iter().chain(struck).take(count);
    let one = |(time, state): (f64, State)| {
        let recoil = here.reset::<0>(OnWall::new(state.velocity, state.phase)).image();
        [first[0] + time, state.velocity, -recoil.velocity]
    };
    all.map(one).collect()
}

const IMPACT_ERRORS: [f64; 3] = [0.02, 0.01, 0.01];

fn noisy(impacts: &[[f64; 3]], noise: &mut Noise) -> Vec<[f64; 3]> {
    impacts.iter().map(|impact| [0, 1, 2].map(|k| impact[k] + IMPACT_ERRORS[k] * noise.next())).collect()
}

/// Asserts that the interval of 95 % contains the true value in the right fraction of the fits: the count
/// is binomial, and even for correct errors it lies beyond three standard deviations in one of 370 tests.
fn assert_errors_are_true(fits: &[Fit]) {
    let count = fits.len() as f64;
    let deviation = (count * 0.95 * 0.05).sqrt();
    for (k, truth) in TRUTH.into_iter().enumerate() {
        let inside =
            fits.iter().filter(|fit| (fit.values[k] - truth).abs() <= 1.96 * fit.errors()[k]).count();
        assert!((inside as f64 - 0.95 * count).abs() <= 3.0 * deviation, "constant {k}: {inside} of {count}");
        // The errors must also equal the scatter of the values, as far as this number of fits determines
        // it: to 5 %, of which 15 % are three standard deviations.
        let squares: f64 = fits.iter().map(|fit| (fit.values[k] - truth) * (fit.values[k] - truth)).sum();
        let mean: f64 = fits.iter().map(|fit| fit.errors()[k]).sum::<f64>() / count;
        assert!(((squares / count).sqrt() / mean - 1.0).abs() < 0.15, "constant {k}: {mean}");
    }
    // The mean of the sum of squares is the number of degrees of freedom.
    let freedom = fits[0].freedom as f64;
    let mean = fits.iter().map(|fit| fit.chi_squared).sum::<f64>() / count;
    assert!((mean - freedom).abs() < 3.0 * (2.0 * freedom / count).sqrt(), "{mean} for {freedom}");
}

#[test]
fn errors_of_constants_from_bifurcations_are_true() {
    let begin = diagram(&TRUTH);
    let places = places(&begin);
    let one = |number| {
        let points = measured(&places, [2e-3, 1e-3], number);
        let located = associate(&points, (&begin, None, &[]), &Units::ONE).unwrap();
        let data = located.into_iter().map(|located| Datum::Bifurcation(Box::new(located))).collect();
        fit(&rig, &START, WINDOW, data, Loss::Full).unwrap()
    };
    assert_errors_are_true(&(0..RIGS).map(one).collect::<Vec<_>>());
}

#[test]
fn errors_of_constants_from_impacts_are_true() {
    let runs = [([0.4, 0.8], [0.3, 0.9]), ([0.6, 0.7], [1.0, 0.4])];
    let truth = runs.map(|(at, first)| (at, impacts(at, first, 8)));
    let one = |number| {
        let mut noise = Noise::of(number);
        let segment = |(at, impacts): &([f64; 2], Vec<[f64; 3]>)| {
            let impacts = noisy(impacts, &mut noise);
            let errors = vec![IMPACT_ERRORS; impacts.len()];
            let struck = (2..10).map(|line| (line, 0)).collect();
            Datum::Impacts(Segment { at: *at, struck, impacts, errors, assumed: [1.0; 3] })
        };
        let data = truth.iter().map(segment).collect();
        fit(&rig, &START, WINDOW, data, Loss::Full).unwrap()
    };
    assert_errors_are_true(&(0..RIGS).map(one).collect::<Vec<_>>());
}

#[test]
fn constants_are_found_from_afar_and_tell_the_resonances() {
    let names = ["zeta", "epsilon"].map(str::to_owned);
    let task = IdentificationTask {
        rig: &rig,
        names: &names,
        start: &[0.03, 0.8],
        scope: &scope(),
        units: Units::ONE,
    };
    let at = [0.4, 0.8];
    let mut noise = Noise::of(1);
    let impacts = noisy(&impacts(at, [0.3, 0.9], 20), &mut noise);
    let impacts =
        (2..).zip(impacts).map(|(line, values)| Impact { line, wall: 1, values, errors: IMPACT_ERRORS });
    let record = vec![ImpactRecord { at, impacts: impacts.collect() }];
    let points = measured(&places(&diagram(&TRUTH)), [2e-3, 1e-3], 1);
    let (found, identified) = identify(&task, &Measurements { points, record }, &Silent).unwrap();
    for k in 0..2 {
        assert!((found.values[k] - TRUTH[k]).abs() < 3.0 * found.errors()[k], "{found:?}");
        assert!(found.errors()[k] < [1e-3, 5e-3][k], "{found:?}");
    }
    // Closed form of section 3: for p = 1 and n = 3 of the linear oscillator omega = 2 omega_1/n,
    // omega_1^2 = 1 - zeta^2.
    let resonance = identified.resonances.iter().find(|at| (at.loops, at.n) == (1, 3)).unwrap();
    let omega = |zeta: f64| 2.0 / 3.0 * (1.0 - zeta * zeta).sqrt();
    assert!((resonance.secondary - omega(found.values[0])).abs() < 1e-9, "{resonance:?}");
    let slope = (omega(found.values[0] + 1e-6) - omega(found.values[0] - 1e-6)) / 2e-6;
    let error = (slope * found.errors()[0]).abs();
    assert!((resonance.secondary_error - error).abs() < 1e-2 * error, "{error} {resonance:?}");
}

/// What is identified from a noisy record whose impacts state these errors.
fn from_record(errors: [f64; 3]) -> (Fit, Measurements) {
    let names = ["zeta", "epsilon"].map(str::to_owned);
    let task =
        IdentificationTask { rig: &rig, names: &names, start: &START, scope: &scope(), units: Units::ONE };
    let mut noise = Noise::of(2);
    let series = |(at, first, count): &([f64; 2], [f64; 2], usize)| {
        let impacts = noisy(&impacts(*at, *first, *count), &mut noise);
        let impacts = (2..).zip(impacts).map(|(line, values)| Impact { line, wall: 1, values, errors });
        ImpactRecord { at: *at, impacts: impacts.collect() }
    };
    let record = [([0.6, 0.7], [1.0, 0.4], 8), ([0.9, 0.8], [0.5, 0.6], 16)].iter().map(series).collect();
    let measured = Measurements { points: Vec::new(), record };
    (identify(&task, &measured, &Silent).unwrap().0, measured)
}

#[test]
fn errors_that_are_not_stated_or_are_too_small_come_from_the_scatter() {
    let (stated, _) = from_record(IMPACT_ERRORS);
    let (unstated, _) = from_record([f64::NAN; 3]);
    let (timed, _) = from_record([IMPACT_ERRORS[0], f64::NAN, f64::NAN]);
    let (too_small, _) = from_record(IMPACT_ERRORS.map(|error| error / 50.0));
    assert!(!stated.is_refuted() && !unstated.is_refuted() && !timed.is_refuted());
    assert!(unstated.scattered && !timed.scattered);
    assert!(too_small.is_refuted(), "{} for {}", too_small.chi_squared, too_small.freedom);
    for found in [&unstated, &timed, &too_small] {
        for (k, truth) in TRUTH.into_iter().enumerate() {
            assert!((found.values[k] - truth).abs() < 3.0 * found.errors()[k], "{found:?}");
            // A standard error from some hundred numbers is known to a tenth or so.
            assert!((found.errors()[k] / stated.errors()[k] - 1.0).abs() < 0.3, "{found:?}");
        }
    }
}

#[test]
fn speeds_that_are_exchanged_are_noticed_and_noise_is_not() {
    for errors in [IMPACT_ERRORS, [f64::NAN; 3]] {
        let (_, Measurements { record, .. }) = from_record(errors);
        for mut series in record {
            assert!(series.gaining().is_none());
            series.impacts.iter_mut().for_each(|impact| impact.values.swap(1, 2));
            assert!(series.gaining().is_some());
        }
    }
}
