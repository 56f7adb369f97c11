//! Synthetic experiments between two walls. Impacts are found by steps along the closed form of the linear oscillator, which
//! shares nothing with the orbits and the integrated motion to which constants are fitted.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Window;
use grazing_measured::read::Impact;
use grazing_measured::{
    Behaviour, Datum, Fit, FitError, IdentificationTask, IdentifyError, ImpactRecord, Loss, MeasuredWalls,
    Measurements, Missing, Observation, Segment, associate, fit, identify,
};
use grazing_model::motion::Motion;
use grazing_model::smooth::{Integrated, Scalar, SmoothOscillator, Units};
use grazing_model::{AnyOscillator, ImpactOscillator, LinearOscillator, State};
use grazing_results::measured::Identified;
use grazing_unfold::described::from_each_wall;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::progress::Silent;
use grazing_unfold::{Diagram, Scope};

use crate::synthetic::Noise;

/// ẍ + 2ζẋ + x = A cos ωt between walls at `clearances[0]` and −`clearances[1]`, with a restitution for each.
#[derive(Clone, Copy, Debug)]
struct Between {
    zeta: f64,
    restitutions: [f64; 2],
    clearances: [f64; 2],
}

/// An oscillator as one of its walls sees it.
#[derive(Clone)]
struct AtStop {
    of: Between,
    stop: usize,
}

impl SmoothOscillator for AtStop {
    fn force<S: Scalar>(&self, x: S, v: S, t: S, amplitude: S, omega: S) -> S {
        let forced = amplitude * (omega * t).cos();
        let forced = if self.stop == 0 { forced } else { forced.scale(-1.0) };
        forced - v.scale(2.0 * self.of.zeta) - x - S::constant(self.of.clearances[self.stop])
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    fn restitution<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(self.of.restitutions[self.stop])
    }

    fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(0.0)
    }

    fn other_stop(&self) -> Option<Self> {
        Some(Self { stop: 1 - self.stop, ..self.clone() })
    }

    fn gap<S: Scalar>(&self, _: S, _: S, _: S) -> [S; 2] {
        [self.of.clearances.iter().sum(), 0.0].map(S::constant)
    }
}

/// An impact: its stop, time, speed before and speed after.
type Hit = (usize, [f64; 3]);

impl Between {
    /// The constants in the order zeta, restitutions, clearances.
    fn constants(&self) -> [f64; 5] {
        let Self { zeta, restitutions: [r, s], clearances: [up, down] } = *self;
        [zeta, r, s, up, down]
    }

    fn of(constants: &[f64]) -> Self {
        let [zeta, r, s, up, down] = [0, 1, 2, 3, 4].map(|k| constants[k]);
        Self { zeta, restitutions: [r, s], clearances: [up, down] }
    }

    fn oscillator(self) -> AnyOscillator {
        AnyOscillator::new(Integrated::new(AtStop { of: self, stop: 0 }, [0.5, 0.7]))
    }

    /// So many impacts from one on, by steps along the closed form and bisection; fewer where one is slow.
    fn impacts(&self, [amplitude, omega]: [f64; 2], first: Hit, count: usize) -> Vec<Hit> {
        const STEP: f64 = 4e-3;
        const SLOW: f64 = 0.2;
        // The closed form has the first wall at x = 0, and rest at −1.
        let [unit, down] = self.clearances;
        let free =
            LinearOscillator::new(self.zeta, 1.0, amplitude / unit, omega).expect("it is in the domain");
        let floor = -(unit + down) / unit;
        let beyond = |x: f64| [x, floor - x];
        let mut hits = vec![first];
        while let Some(&(stop, [time, _, after])) = hits.last().filter(|_| hits.len() < count) {
            let (position, velocity) = if stop == 0 { (0.0, -after / unit) } else { (floor, after / unit) };
            let motion = free.motion(State { position, velocity, phase: omega * time });
            let at = |t: f64| beyond(motion.at(t).position);
            let mut away = [stop != 0, stop != 1];
            let steps = (0..20_000).map(|step| STEP * f64::from(step));
            let met = steps.into_iter().find_map(|t| {
                let there = at(t + STEP);
                let met = (0..2).find(|k| away[*k] && there[*k] > 0.0);
                (0..2).for_each(|k| away[k] |= there[k] < 0.0);
                met.map(|met| (met, t))
            });
            let Some((met, mut low)) = met else { break };
            let mut high = low + STEP;
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if at(middle)[met] > 0.0 { high = middle } else { low = middle }
            }
            let speed = motion.at(high).velocity.abs() * unit;
            if speed < SLOW {
                break;
            }
            hits.push((met, [time + high, speed, self.restitutions[met] * speed]));
        }
        hits
    }
}

/// Standard errors of times and speeds.
const ERRORS: [f64; 3] = [2e-3, 2e-3, 2e-3];
const IMPACTS: usize = 8;

/// Impacts at a random place, none slow, at both walls. They depend on the first one with slopes of at most some hundred, so
/// that the errors are small, and no impact comes or goes where the constants are one in a hundred others.
fn run(rig: &Between, noise: &mut Noise) -> ([f64; 2], Vec<Hit>) {
    let mut within = |low: f64, high: f64| low + (high - low) * noise.uniform();
    loop {
        let at = [within(0.6, 1.2), within(0.5, 1.2)];
        let [time, speed] = [within(0.0, 6.0), within(0.4, 1.2)];
        let run = |rig: &Between, speed: f64| {
            rig.impacts(at, (0, [time, speed, rig.restitutions[0] * speed]), IMPACTS)
        };
        let (hits, beside) = (run(rig, speed), run(rig, speed + 1e-6));
        let apart = |(a, b): (&Hit, &Hit)| (0..3).map(|k| (a.1[k] - b.1[k]).abs()).fold(0.0, f64::max);
        let steep = hits.iter().zip(&beside).map(apart).fold(0.0, f64::max) > 1e-4;
        let second = hits.iter().filter(|(stop, _)| *stop == 1).count();
        let stops = |hits: &[Hit]| hits.iter().map(|(stop, _)| *stop).collect::<Vec<_>>();
        let other = |factor: f64| run(&Between::of(&rig.constants().map(|one| factor * one)), speed);
        let is_there = || [0.99, 1.01].into_iter().all(|factor| stops(&other(factor)) == stops(&hits));
        if hits.len() == IMPACTS && !steep && (2..IMPACTS - 1).contains(&second) && is_there() {
            return (at, hits);
        }
    }
}

fn noisy(hits: &[Hit], noise: &mut Noise) -> Vec<Hit> {
    hits.iter().map(|(stop, hit)| (*stop, [0, 1, 2].map(|k| hit[k] + ERRORS[k] * noise.next()))).collect()
}

fn series(at: [f64; 2], hits: &[Hit], first_line: u32) -> ImpactRecord {
    let impact = |(line, (stop, values)): (u32, &Hit)| Impact {
        line,
        wall: *stop as u32 + 1,
        values: *values,
        errors: ERRORS,
    };
    ImpactRecord { at, impacts: (first_line..).zip(hits).map(impact).collect() }
}

/// What is fitted to noisy runs of a rig, from constants some standard errors away.
fn fitted(rig: &Between, noise: &mut Noise, free: &[usize], tied: fn(&mut [f64; 5])) -> Fit {
    let datum = |_| {
        let (at, hits) = run(rig, noise);
        let hits = noisy(&hits, noise);
        let impacts: Vec<[f64; 3]> = hits.iter().map(|(_, hit)| *hit).collect();
        let struck = (2..).zip(&hits).map(|(line, (stop, _))| (line, *stop)).collect();
        let errors = vec![ERRORS; impacts.len()];
        Datum::Impacts(Segment { at, struck, impacts, errors, assumed: [1.0; 3] })
    };
    let data = (0..2).map(datum).collect();
    let truth = rig.constants();
    let with = |values: &[f64]| {
        let mut all = truth;
        free.iter().zip(values).for_each(|(place, value)| all[*place] = *value);
        tied(&mut all);
        Some(Between::of(&all).oscillator())
    };
    let start: Vec<f64> = free.iter().map(|place| truth[*place] * 1.01).collect();
    let window = Window { primary: [0.4, 1.4], secondary: [0.4, 1.4] };
    fit(&with, &start, window, data, Loss::Full).unwrap_or_else(|error| panic!("{rig:?}: {error}"))
}

/// Asserts of the deviations from the truth of many rigs, in standard errors, that 95 % are within 1.96 and that their
/// squares have the mean 1, as far as their number tells: to three standard deviations.
fn assert_normal(deviations: &[f64], what: &str) {
    let count = deviations.len() as f64;
    let inside = deviations.iter().filter(|deviation| deviation.abs() <= 1.96).count() as f64;
    assert!(
        (inside - 0.95 * count).abs() <= 3.0 * (count * 0.95 * 0.05).sqrt(),
        "{what}: {inside} of {count}"
    );
    let mean = deviations.iter().map(|deviation| deviation * deviation).sum::<f64>() / count;
    assert!((mean - 1.0).abs() < 3.0 * (2.0 / count).sqrt(), "{what}: {mean}");
}

#[test]
fn errors_of_the_constants_of_both_walls_are_true() {
    const RIGS: u32 = 40;
    let (mut deviations, mut squares) = (vec![Vec::new(); 5], Vec::new());
    for number in 0..RIGS {
        let noise = &mut Noise::of(1000 + number);
        let mut within = |low: f64, high: f64| low + (high - low) * noise.uniform();
        let rig = Between {
            zeta: within(0.02, 0.15),
            restitutions: [within(0.5, 0.7), within(0.75, 0.95)],
            clearances: [within(0.4, 0.6), within(0.7, 1.0)],
        };
        let found = fitted(&rig, noise, &[0, 1, 2, 3, 4], |_| ());
        for (k, truth) in rig.constants().into_iter().enumerate() {
            deviations[k].push((found.values[k] - truth) / found.errors()[k]);
        }
        let freedom = found.freedom as f64;
        squares.push((found.chi_squared - freedom) / (2.0 * freedom).sqrt());
    }
    for (deviations, name) in deviations.iter().zip(["zeta", "r", "s", "up", "down"]) {
        assert_normal(deviations, name);
    }
    let mean = squares.iter().sum::<f64>() / f64::from(RIGS);
    assert!(mean.abs() < 3.0 / f64::from(RIGS).sqrt(), "{mean}");
}

#[test]
fn one_restitution_of_walls_that_are_alike_is_found_from_impacts_at_both() {
    let mut deviations = Vec::new();
    for number in 0..12 {
        let noise = &mut Noise::of(2000 + number);
        let rig = Between { zeta: 0.05, restitutions: [0.8; 2], clearances: [0.6; 2] };
        let found = fitted(&rig, noise, &[0, 1], |all| all[2] = all[1]);
        deviations.push((found.values[1] - 0.8) / found.errors()[1]);
        assert!(found.errors()[1] < 2e-3 && !found.is_refuted(), "{found:?}");
    }
    assert_normal(&deviations, "r");
}

const NAMES: [&str; 4] = ["zeta", "r", "s", "gap"];

/// What is identified of a rig with walls at the clearance `gap`.
fn identified(start: &[f64], measured: &Measurements) -> Result<(Fit, Identified), IdentifyError> {
    let names: Vec<String> = NAMES.iter().take(start.len()).map(|name| (*name).to_owned()).collect();
    let rig = |values: &[f64]| {
        let gap = values[3];
        Some(
            Between { zeta: values[0], restitutions: [values[1], values[2]], clearances: [gap; 2] }
                .oscillator(),
        )
    };
    let scope = &scope();
    identify(
        &IdentificationTask { rig: &rig, names: &names, start, scope, units: Units::ONE },
        measured,
        &Silent,
    )
}

fn scope() -> Scope {
    let window = Window { primary: [0.4, 0.8], secondary: [0.62, 0.72] };
    Scope { window, loops: vec![1], start: None }
}

/// Noisy runs of a rig, of which one is longer than a segment.
fn record(rig: &Between, number: u32) -> Vec<ImpactRecord> {
    let noise = &mut Noise::of(number);
    let runs = [
        ([0.9, 0.7], (0, [0.3, 0.9, 0.9 * rig.restitutions[0]]), 14),
        ([1.0, 1.0], (1, [1.0, 0.8, 0.8 * rig.restitutions[1]]), 10),
    ];
    let mut line = 2;
    let one = |(at, first, count)| {
        let hits = noisy(&rig.impacts(at, first, count), noise);
        assert_eq!(hits.len(), count, "{hits:?}");
        line += count as u32;
        series(at, &hits, line - count as u32)
    };
    runs.into_iter().map(one).collect()
}

#[test]
fn constants_of_walls_are_found_from_afar_and_tell_the_resonances_of_each() {
    let rig = Between { zeta: 0.05, restitutions: [0.7, 0.85], clearances: [1.0; 2] };
    let measured = Measurements { points: Vec::new(), record: record(&rig, 3) };
    let (found, tables) = identified(&[0.08, 0.6, 0.9, 1.1], &measured).unwrap();
    for (k, truth) in [0.05, 0.7, 0.85, 1.0].into_iter().enumerate() {
        assert!((found.values[k] - truth).abs() < 3.0 * found.errors()[k], "{} {found:?}", NAMES[k]);
        assert!(found.errors()[k] < 5e-3, "{} {found:?}", NAMES[k]);
    }
    // At either wall the linear oscillator has omega = 2 omega_1/n, as beside one wall, and grazes with the amplitude of the
    // clearance.
    let [zeta, gap] = [found.values[0], found.values[3]];
    let omega = 2.0 / 3.0 * (1.0 - zeta * zeta).sqrt();
    let amplitude = gap * libm::hypot(1.0 - omega * omega, 2.0 * zeta * omega);
    let known: Vec<(u32, u32, u32)> = tables.resonances.iter().map(|at| (at.wall, at.loops, at.n)).collect();
    assert_eq!(known, [(1, 1, 3), (2, 1, 3)]);
    for at in &tables.resonances {
        assert!((at.secondary - omega).abs() < 1e-8 && (at.primary - amplitude).abs() < 1e-8, "{at:?}");
        // The grazing amplitude is the clearance times a number, so its relative error is at least near that of the clearance.
        assert!(
            at.secondary_error > 0.0
                && (at.primary_error / found.errors()[3] / amplitude * gap - 1.0).abs() < 0.5,
            "{at:?}"
        );
    }
}

#[test]
fn a_wrong_wall_in_one_line_is_named() {
    let rig = Between { zeta: 0.05, restitutions: [0.7, 0.85], clearances: [1.0; 2] };
    let record = record(&rig, 3);
    let start = [0.055, 0.68, 0.87, 1.02];
    for wrong in [0, 6, 11, 12] {
        let mut record = record.clone();
        let impact = &mut record[0].impacts[wrong];
        impact.wall = 3 - impact.wall;
        let line = impact.line;
        let measured = Measurements { points: Vec::new(), record };
        match identified(&start, &measured) {
            Err(IdentifyError::Fit(FitError::Start { line: told, missing: Missing::AtWall(_), .. })) => {
                assert!(told == line || told == line + 1, "{told} for {line}");
            }
            other => panic!("line {line}: {other:?}"),
        }
    }
}

/// Places on the curves of the oscillator beside one wall, near its resonance, where motion does not reach as far as another.
fn places(restitution: f64, wall: u32) -> Vec<(Behaviour, [f64; 2])> {
    let beside = LinearOscillator::new(0.05, restitution, 0.5, 0.7).expect("it is in the domain");
    let located = Diagram::located(&AnyOscillator::new(beside), &scope(), &Silent).expect("nothing stops it");
    let followed = located.follow(&Silent, &|_, _| ());
    let diagram = located.with_curves(followed);
    let bends = |kind| matches!(kind, Bifurcation::SaddleNode | Bifurcation::PeriodDoubling);
    let curves = diagram.curves.iter().filter(|curve| bends(curve.kind));
    let of = |curve: &DiagramCurve| {
        let seen =
            Behaviour::Bifurcation { kind: curve.kind, loops: Some(1), walls: MeasuredWalls::One(wall) };
        let low = curve
            .curve
            .points
            .iter()
            .filter(|point| (0.02..0.15).contains(&point.solution.impact_velocity()));
        let low: Vec<[f64; 2]> = low.map(|point| point.solution.parameters()).collect();
        [1, 2].map(|k| (seen, low[k * low.len() / 3]))
    };
    curves.flat_map(of).collect()
}

#[test]
fn bifurcations_at_each_wall_tell_its_restitution() {
    let [r, s] = [0.7, 0.8];
    let errors = [2e-5, 1e-5];
    let measured = |walls: [u32; 2]| {
        let noise = &mut Noise::of(5);
        let places = places(r, walls[0]).into_iter().chain(places(s, walls[1]));
        let grazing = Behaviour::Bifurcation {
            kind: Bifurcation::NonImpactingGrazing,
            loops: None,
            walls: MeasuredWalls::Unsaid,
        };
        let amplitude = |omega: f64| libm::hypot(1.0 - omega * omega, 2.0 * 0.05 * omega);
        let places = places.chain([0.63, 0.7].map(|omega| (grazing, [amplitude(omega), omega])));
        let one = |(line, (seen, at)): (u32, (Behaviour, [f64; 2]))| {
            let at = [0, 1].map(|k| at[k] + errors[k] * noise.next());
            Observation { line, at, errors, seen }
        };
        (2..).zip(places).map(one).collect::<Vec<_>>()
    };
    let start = [0.053, 0.74, 0.76];
    let rig = |values: &[f64]| {
        let [zeta, r, s] = [values[0], values[1], values[2]];
        Some(Between { zeta, restitutions: [r, s], clearances: [1.0; 2] }.oscillator())
    };
    let oscillator = rig(&start).expect("it exists");
    let seen = from_each_wall(&oscillator, &scope(), &[]).map(|view| {
        let located = view.located(&Silent).expect("nothing stops it");
        let followed = located.follow(&Silent, &|_, _| ());
        located.with_curves(followed)
    });
    let seen: Vec<Diagram> = seen.collect();
    // Where the walls are exchanged, so are the restitutions.
    for (walls, truth) in [([1, 2], [0.05, r, s]), ([2, 1], [0.05, s, r])] {
        let located = associate(&measured(walls), (&seen[0], Some(&seen[1]), &[]), &Units::ONE).unwrap();
        assert!(located.iter().any(|one| one.quantity == "SN of p = 1 at wall 2"));
        let data = located.into_iter().map(|one| Datum::Bifurcation(Box::new(one))).collect();
        let found = fit(&rig, &start, scope().window, data, Loss::Full).unwrap();
        for (k, truth) in truth.into_iter().enumerate() {
            assert!((found.values[k] - truth).abs() < 3.0 * found.errors()[k], "{} {found:?}", NAMES[k]);
            assert!(found.errors()[k] < 0.02, "{} {found:?}", NAMES[k]);
        }
        assert!(!found.is_refuted(), "{found:?}");
    }
}
