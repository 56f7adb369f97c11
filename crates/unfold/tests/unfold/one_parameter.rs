//! One-parameter diagrams compared with Figure 2, with simulation, and with each other.

use std::fs;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Window;
use grazing_input::Description;
use grazing_model::{AnyOscillator, ImpactOscillator, OnWall, State};
use grazing_results::Stability;
use grazing_results::branches::{BranchPoint, OneParameter, Orbits, PortraitKind, PortraitPoint};
use grazing_results::readings::{MotionReading, Sweep};
use grazing_unfold::Scope;
use grazing_unfold::one_parameter::{Cut, Line, Sampling, Subject, oriented};
use grazing_unfold::progress::Silent;

use crate::paper::PARAMETERS;
use crate::specimens::{example, file};

/// The frequency of Figure 2.
fn frequency() -> f64 {
    PARAMETERS["fig02"]["frequency"].as_float().expect("it is a number")
}

fn sampling(values: u32) -> Sampling {
    let (between, lowest) = (None, None);
    Sampling {
        values,
        between,
        orbits: 3,
        transient: 300,
        recorded: 10,
        lowest,
        seed: 1,
        readings: false,
        impacts: 1,
    }
}

fn line(at: f64, range: [f64; 2]) -> Line {
    Line { diagram: 1, primary_is_fixed: false, at, range }
}

/// The diagram on a line, without the help of known curves.
fn on(
    oscillator: &AnyOscillator,
    scope: &Scope,
    line: Line,
    values: u32,
    subjects: &[Subject],
) -> OneParameter {
    let mut cut = Cut::follow(oscillator, scope, &[], line, &Silent).expect("nobody stops it");
    cut.simulated(&sampling(values), subjects, &Silent)
}

/// An oscillator, its scope and a line, as they are and with the roles of both parameters exchanged:
/// the same diagram.
fn in_both_roles(oscillator: &AnyOscillator, scope: &Scope, line: Line) -> [(AnyOscillator, Scope, Line); 2] {
    let Window { primary, secondary } = scope.window;
    let other = Scope { window: Window { primary: secondary, secondary: primary }, ..scope.clone() };
    let across = Line { primary_is_fixed: !line.primary_is_fixed, ..line };
    [(oscillator.clone(), scope.clone(), line), (oriented(oscillator, true), other, across)]
}

/// The diagram of the paper's oscillator, integrated from its file, at the frequency of Figure 2, in
/// both roles.
fn of_the_paper(range: [f64; 2], values: u32, subjects: &[Subject]) -> [OneParameter; 2] {
    let (oscillator, scope) = example("paper.toml");
    in_both_roles(&oscillator, &scope, line(frequency(), range))
        .map(|(oscillator, scope, line)| on(&oscillator, &scope, line, values, subjects))
}

/// The points of strands of p loops at a value of the parameter across, between their neighbours.
fn at(diagram: &OneParameter, loops: u32, across: f64) -> Vec<BranchPoint> {
    let strands = diagram.branches.chunk_by(|a, b| a.branch == b.branch);
    let own = strands.filter(|strand| strand[0].loops == loops);
    let found = own.flat_map(|strand| {
        strand.windows(2).filter_map(|pair| {
            let [from, to] = [0, 1].map(|k| diagram.across(&pair[k]));
            let share = (across - from) / (to - from);
            let between = |of: fn(&BranchPoint) -> f64| of(&pair[0]) + share * (of(&pair[1]) - of(&pair[0]));
            (0.0..=1.0).contains(&share).then(|| BranchPoint {
                x: between(|point| point.x),
                impact_velocity: between(|point| point.impact_velocity),
                impact_phase: between(|point| point.impact_phase),
                ..pair[0].clone()
            })
        })
    });
    found.collect()
}

#[test]
fn bifurcations_of_the_paper_s_oscillator_are_those_of_figure_2() {
    let expected = fs::read_to_string(file("expected/fig02_bifurcations.snap")).expect("it is there");
    let (_, expected) = expected.split_once("\n---\n").expect("it has a head");
    let diagrams = of_the_paper([0.262, 0.342], 2, &[]);
    let found =
        diagrams.iter().flat_map(|diagram| diagram.bifurcations.iter().map(move |one| (diagram, one)));
    assert_eq!(found.clone().count(), 2 * expected.lines().count());
    for ((diagram, found), expected) in found.zip(expected.lines().cycle()) {
        let words: Vec<&str> = expected.split([' ', ',', ':']).filter(|word| !word.is_empty()).collect();
        let [kind, "p", "=", loops, "amplitude", primary, "impact", "velocity", velocity, "x", x] = words[..]
        else {
            panic!("{expected}")
        };
        assert_eq!((found.kind.name(), found.loops.to_string().as_str()), (kind, loops));
        let across = diagram.across(found);
        for (found, expected) in [(across, primary), (found.impact_velocity, velocity), (found.x, x)] {
            let expected: f64 = expected.parse().expect("it is a number");
            assert!((found - expected).abs() < 1e-9, "{kind} p = {loops}: {found} and not {expected}");
        }
    }
}

#[test]
fn where_only_mps_attract_simulation_stays_on_their_branches() {
    for diagram in of_the_paper([0.338, 0.342], 5, &[]) {
        assert_eq!(diagram.simulated, Some(Orbits { all: 15, ..Orbits::default() }));
        // Both loops of p = 2 are visited everywhere.
        let mut visited = 0;
        for dot in &diagram.attractor {
            // A chord lies between points of a branch.
            let near = at(&diagram, 2, diagram.across(dot))
                .into_iter()
                .find(|point| point.stable.is_stable() && (point.x - dot.x).abs() < 1e-4);
            visited |= 1 << near.unwrap_or_else(|| panic!("{dot:?} lies on no branch")).visit;
        }
        assert_eq!(visited, 0b110);
        assert!(diagram.attractor.len() >= 5 * 3 * 7, "{}", diagram.attractor.len());
    }
}

#[test]
fn branches_that_begin_where_motion_of_twice_the_period_grazes_are_found() {
    let text = grazing_trials::oscillators::description(20_261_122, 2);
    let model = Description::parse(&text, "two wells").expect("what is made at random is right");
    let window = Window { primary: [0.0, 1.9], secondary: [0.5533, 0.5834] };
    let oscillator = model.oscillator([window.primary[0], window.secondary[0]]);
    let scope = Scope { window, loops: vec![2], start: None };
    for (oscillator, scope, line) in in_both_roles(&oscillator, &scope, line(0.580_712_5, window.primary)) {
        let found = on(&oscillator, &scope, line, 2, &[]);
        // Simulation settles on solutions with two loops here.
        for primary in [0.263, 0.419] {
            let here = at(&found, 2, primary);
            assert!(
                here.iter().any(|point| point.stable.is_stable() && point.admissible),
                "{primary}: {here:?}"
            );
        }
    }
}

#[test]
fn a_point_is_on_the_branches_of_either_diagram_that_passes_it() {
    let amplitude = 0.3;
    let [one, _] = of_the_paper([0.29, 0.31], 2, &[]);
    let (oscillator, scope) = example("paper.toml");
    let across = Line { primary_is_fixed: true, ..line(amplitude, [0.84, 0.87]) };
    let other = on(&oscillator, &scope, across, 2, &[]);
    for loops in 1..=2 {
        let [one, other] = [at(&one, loops, amplitude), at(&other, loops, frequency())];
        assert_eq!((one.len(), other.len()), (loops as usize, loops as usize));
        for (a, b) in one.iter().zip(&other) {
            assert_eq!((a.visit, a.stable, a.admissible), (b.visit, b.stable, b.admissible));
            assert_eq!((a.secondary, b.primary), (frequency(), amplitude));
            // Values between points lie on a chord.
            let velocities = (a.impact_velocity, b.impact_velocity);
            for (a, b) in [(a.x, b.x), velocities, (a.impact_phase, b.impact_phase)] {
                let turn = libm::remainder(a - b, core::f64::consts::TAU);
                assert!(turn.abs() < 1e-4, "p = {loops}: {a} and {b}");
            }
        }
    }
}

#[test]
fn exchanged_parameters_are_those_of_a_file_that_names_them_in_the_other_order() {
    // Everything moves: wall and restitution as well as the force and the frequency depend on both
    // parameters.
    let text = |primary: &str, secondary: &str| {
        format!(
            "name = \"moved\"\n[parameters]\n[primary]\nname = \"{primary}\"\nrange = [0.5, 1.5]\n[secondary]\nname = \"{secondary}\"\nrange = [0.5, 1.5]\n\
             [motion]\nforce = \"-0.1*v - x - a*b*x^2 - 1 + a*cos(b*t)\"\nfrequency = \"b\"\n\
             [impact]\nrestitution = \"0.8 - 0.1*a*b*y\"\nduration = \"0.1*a*b\"\n[analysis]\nloops = [1]\n"
        )
    };
    let described =
        |primary, secondary| Description::parse(&text(primary, secondary), "moved").expect("it is right");
    let oscillator = described("a", "b").oscillator([0.7, 0.9]);
    let exchanged = oriented(&oscillator, true);
    let other = described("b", "a").oscillator([0.9, 0.7]);
    assert_eq!((exchanged.parameters(), other.parameters()), ([0.9, 0.7], [0.9, 0.7]));
    let moved = exchanged.with_parameters([1.1, 0.6]);
    let other = other.with_parameters([1.1, 0.6]);
    assert_eq!(moved.parameters(), [1.1, 0.6]);
    assert_eq!(moved.forcing_frequency(), other.forcing_frequency());
    let (from, impact) = (State { position: -0.4, velocity: 0.3, phase: 1.2 }, OnWall::new(0.5, 0.8));
    let [a, b] = [moved.flow::<2>(from, 1.7), other.flow::<2>(from, 1.7)];
    // The integration is the same, except for the order of sums.
    let near =
        |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-11);
    assert!(
        near(a.value.as_slice(), b.value.as_slice()) && near(a.jacobian.as_slice(), b.jacobian.as_slice())
    );
    assert!(a.hessians.iter().zip(&b.hessians).all(|(a, b)| near(a.as_slice(), b.as_slice())));
    assert!((a.jacobian[(0, 4)] - a.jacobian[(0, 5)]).abs() > 0.01);
    let [a, b] = [moved.reset::<2>(impact), other.reset::<2>(impact)];
    assert!(
        near(a.value.as_slice(), b.value.as_slice()) && near(a.jacobian.as_slice(), b.jacobian.as_slice())
    );
    assert!(a.hessians.iter().zip(&b.hessians).all(|(a, b)| near(a.as_slice(), b.as_slice())));
}

#[test]
fn a_diagram_is_the_same_for_any_number_of_threads() {
    let made = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("there are threads");
        format!("{:?}", pool.install(|| of_the_paper([0.33, 0.34], 3, &[])))
    };
    assert_eq!(made(1), made(2));
}

#[test]
fn portraits_are_of_stable_solutions_and_of_what_simulation_finds_besides() {
    let subjects = [0.266, 0.3, 0.34].map(|across| Subject { across, loops: None });
    of_the_paper([0.262, 0.342], 2, &subjects).iter().for_each(has_portraits);
}

fn has_portraits(diagram: &OneParameter) {
    let portraits: Vec<_> = diagram.portraits.chunk_by(|a, b| a.portrait == b.portrait).collect();
    let at = |across: f64| portraits.iter().filter(move |portrait| diagram.across(&portrait[0]) == across);
    // Each flight ends in an empty row.
    let flights = |portrait: &[PortraitPoint]| portrait.iter().filter(|point| point.x.is_nan()).count();
    // Below grazing the non-impacting solution is stable, and closes.
    let free = at(0.266).next().expect("there is one");
    assert!(free[0].loops == 0 && free[0].kind == PortraitKind::Periodic && flights(free) == 1);
    let (first, last) = (&free[0], &free[free.len() - 2]);
    assert!((first.x - last.x).abs() + (first.y - last.y).abs() < 1e-9);
    // Between GZ and PD no MPS is stable, and there is another attractor.
    assert!(at(0.3).count() > 0 && at(0.3).all(|portrait| portrait[0].kind == PortraitKind::Attractor));
    // Then p = 2 alone is stable, from its recoil to its impact.
    let [double] = at(0.34).collect::<Vec<_>>()[..] else { panic!("one attracts") };
    assert!(double[0].loops == 2 && double[0].kind == PortraitKind::Periodic);
    assert!(double[0].y < 0.0 && double[double.len() - 2].x.abs() < 1e-8);
}

/// The diagram of an oscillator defined by a text.
fn described(text: &str, line: Line) -> OneParameter {
    let (oscillator, scope) = both(text);
    on(&oscillator, &scope, line, 2, &[])
}

/// The oscillator of a text, and its scope.
fn both(text: &str) -> (AnyOscillator, Scope) {
    let model = Description::parse(text, "described").expect("it is right");
    let [primary, secondary] = [model.primary(), model.secondary()].map(|axis| axis.range());
    let window = Window { primary, secondary };
    let scope = Scope { window, loops: model.loops().to_vec(), start: None };
    (model.oscillator([primary[0], secondary[0]]), scope)
}

#[test]
fn x_of_a_loop_is_not_that_of_the_impact() {
    let text = "name = \"linear\"\n[parameters]\n[primary]\nname = \"A\"\nrange = [0.0, 2.5]\n[secondary]\nname = \"w\"\nrange = [0.7, 3.3]\n\
                [motion]\nforce = \"-0.04*v - x - 1 + A*cos(w*t)\"\nfrequency = \"w\"\n\
                [impact]\nrestitution = \"0.9\"\nduration = \"0\"\n[analysis]\nloops = [2]\n";
    let found = described(text, Line { primary_is_fixed: true, ..line(1.6, [2.0, 3.3]) });
    let here = at(&found, 2, 2.089_526_71);
    let heights = |visit: u32, fast: bool| {
        let own =
            here.iter().filter(move |point| point.visit == visit && (point.impact_velocity > 0.15) == fast);
        own.map(|point| point.x).collect::<Vec<_>>()
    };
    // On the fast solution the only maximum between the impacts comes 0.35 periods before one of
    // them, and the maximum of the impact is a different one; on the slow one it comes 1.11 periods
    // after one, by simulation at -1.003688.
    let near = |heights: Vec<f64>, height: f64| {
        !heights.is_empty() && heights.iter().all(|x| (x - height).abs() < 1e-5)
    };
    assert!(!heights(1, true).is_empty() && heights(1, true).iter().all(|x| x.is_nan()), "{here:?}");
    assert!(near(heights(1, false), -1.003_688) && near(heights(2, false), 0.001_695_787_9), "{here:?}");
    // Between impacts nothing admissible lies beyond the wall.
    for point in found.branches.iter().filter(|point| point.visit == 1 && point.loops == 2) {
        assert!(!point.admissible || point.x.is_nan() || point.x <= 1e-9, "{point:?}");
    }
}

#[test]
fn motion_in_the_other_well_is_on_a_branch() {
    let text = "name = \"two wells\"\n[parameters]\n[primary]\nname = \"A\"\nrange = [0.0, 0.75]\n[secondary]\nname = \"w\"\nrange = [0.6, 1.9]\n\
                [motion]\nforce = \"-0.12*v + x - x^3 + 0.05 + A*cos(w*t)\"\nfrequency = \"w\"\n[wall]\nposition = \"1.45\"\n\
                [impact]\nrestitution = \"0.7\"\nduration = \"0\"\n[analysis]\nloops = [1]\n";
    let found = described(text, line(1.13, [0.0, 0.1]));
    // The highest points of stable motion with the forcing's period, by Newton's method on another
    // program's period map.
    for (primary, x) in [(0.01, -0.414_539), (0.01, -2.406_777), (0.05, -0.369_268), (0.05, -2.332_661)] {
        let here = at(&found, 0, primary);
        let there = |point: &&BranchPoint| point.stable.is_stable() && (point.x - x).abs() < 1e-3;
        assert!(here.iter().any(|point| there(&point)), "{primary}, {x}: {here:?}");
    }
}

#[test]
fn sweeps_leave_motion_without_impacts_at_grazing_and_come_back_to_it_elsewhere() {
    let (oscillator, scope) = example("paper.toml");
    let roles = in_both_roles(&oscillator, &scope, line(frequency(), [0.262, 0.342]));
    roles.iter().for_each(|(oscillator, scope, line)| sweeps(oscillator, scope, *line));
}

fn sweeps(oscillator: &AnyOscillator, scope: &Scope, line: Line) {
    let cut = Cut::follow(oscillator, scope, &[], line, &Silent).expect("nobody stops it");
    let diagram = cut.diagram();
    let values = 81;
    let step = (line.range[1] - line.range[0]) / f64::from(values - 1);
    let (found, orbits) = cut.sweeps(&sampling(values), &Silent);
    assert_eq!(orbits, Orbits { all: 2 * values, ..Orbits::default() });
    let grazing = grazing_theorems::LinearOscillator::new(0.02, 0.9)
        .and_then(|it| it.grazing(frequency()))
        .expect("it is in the domain");
    let free = |sweep: Sweep| {
        let rows = found.iter().filter(move |row| row.sweep == sweep && row.motion == "non-impacting");
        rows.map(|row| diagram.across(row)).fold(f64::NEG_INFINITY, f64::max)
    };
    // Upwards it continues to grazing.
    let last = free(Sweep::Up);
    assert!(last <= grazing.amplitude() && grazing.amplitude() - last <= step, "{last}");
    // Downwards it is reached again where the three-loop solution, to which motion had jumped,
    // ends.
    let folds = diagram.bifurcations.iter();
    let fold = folds.filter(|found| found.kind == Bifurcation::SaddleNode && found.loops == 3);
    let fold = fold.map(|found| diagram.across(found)).next().expect("Figure 2 has one");
    let down = found.iter().filter(|row| row.sweep == Sweep::Down);
    let periodic = down.filter(|row| row.motion == "periodic").map(|row| diagram.across(row));
    let last = periodic.fold(f64::INFINITY, f64::min);
    assert!(last >= fold && last - fold <= step, "{last} {fold}");
    // Next to the fold motion takes long to leave the remains of the solution.
    let back = free(Sweep::Down);
    assert!(back < fold && fold - back <= 2.0 * step, "{back} {fold}");
    let between = |row: &&MotionReading| (fold..grazing.amplitude()).contains(&diagram.across(*row));
    for row in found.iter().filter(between) {
        let (motion, periods) =
            if row.sweep == Sweep::Up { ("non-impacting", 1.0) } else { ("periodic", 3.0) };
        assert_eq!((row.motion, row.periods), (motion, periods), "{row:?}");
    }
}

/// The dots of a diagram at A = 5 of an oscillator that chatters, and its portrait there.
#[test]
fn motion_that_rests_at_the_wall_has_dots_readings_and_a_portrait_and_nothing_is_left_out() {
    let text = "name = \"chatter\"\nparameters = {}\nprimary = { name = \"A\", range = [0, 6] }\nsecondary = { name = \"w\", range = [0.3, 1] }\n\
                motion = { force = \"-0.1*v - x - 1 + A*cos(w*t)\", frequency = \"w\" }\n\
                impact = { restitution = \"0.3\", duration = \"0\" }\nanalysis = { loops = [1] }";
    let model = Description::parse(text, "chatter").expect("it is right");
    let [primary, secondary] = [model.primary(), model.secondary()].map(|axis| axis.range());
    let scope = Scope { window: Window { primary, secondary }, loops: vec![1], start: None };
    let oscillator = model.oscillator([primary[0], secondary[0]]);
    for (oscillator, scope, line) in in_both_roles(&oscillator, &scope, line(0.5, [4.5, 5.5])) {
        let found = on(&oscillator, &scope, line, 5, &[Subject { across: 5.0, loops: None }]);
        let orbits = found.simulated.expect("nobody stops it");
        assert_eq!((orbits.all, orbits.resting, orbits.escaping), (15, 0, 0));
        assert!(orbits.left_out().is_empty());
        // Each of the 15 orbits rests at the wall, once a period, and flies off by more than 10.
        assert!(found.attractor.iter().filter(|point| point.x == 0.0).count() >= 15);
        let portraits: Vec<_> = found.portraits.iter().filter(|point| !point.x.is_nan()).collect();
        assert!(portraits.iter().all(|point| point.portrait == 1) && portraits.len() > 100);
        let lowest = portraits.iter().map(|point| point.x).fold(0.0, f64::min);
        assert!(lowest < -5.0, "{lowest}");
        assert!(portraits.windows(2).any(|pair| pair.iter().all(|point| point.x == 0.0 && point.y == 0.0)));
    }
}

/// The product of the multipliers of every solution is 1, but for rounding.
#[test]
fn without_damping_solutions_are_neutral_and_nothing_bifurcates_by_their_product() {
    for spring in ["-(x + 1)", "-(x + 1) - 0.01*(x + 1)^3"] {
        let text = format!(
            "name = \"elastic\"\n[parameters]\n[primary]\nname = \"A\"\nrange = [0.0, 0.6]\n[secondary]\nname = \"w\"\nrange = [0.7, 0.9]\n\
             [motion]\nforce = \"{spring} + A*cos(w*t)\"\nfrequency = \"w\"\n[impact]\nrestitution = \"1\"\nduration = \"0\"\n\
             [analysis]\nloops = [1]\n"
        );
        let (oscillator, scope) = both(&text);
        let line = line(0.8, [0.0, 0.6]);
        let found = Cut::follow(&oscillator, &scope, &[], line, &Silent).expect("nobody stops it").diagram();
        for loops in [0, 1] {
            let own = || found.branches.iter().filter(|point| point.loops == loops);
            assert!(own().any(|point| point.stable == Stability::Neutral), "{spring}, p = {loops}");
            assert!(own().all(|point| !point.stable.is_stable()), "{spring}, p = {loops}");
        }
        let kinds: Vec<Bifurcation> = found.bifurcations.iter().map(|one| one.kind).collect();
        assert!(!kinds.contains(&Bifurcation::Torus), "{spring}: {kinds:?}");
    }
}

/// The x-values of the admissible points with several impacts that a diagram has at a value of μ, each with its
/// stability, between the points of its strands.
fn several_at(diagram: &OneParameter, across: f64) -> Vec<(f64, Stability)> {
    let strands = diagram.branches.chunk_by(|a, b| a.branch == b.branch).filter(|run| run[0].impacts > 1);
    let at = |pair: &[BranchPoint]| {
        let [from, to] = [&pair[0], &pair[1]];
        let part = (across - from.primary) / (to.primary - from.primary);
        let shown = from.admissible && to.admissible && (0.0..=1.0).contains(&part);
        shown.then_some((from.x + part * (to.x - from.x), from.stable))
    };
    strands.flat_map(|run| run.windows(2)).filter_map(at).collect()
}

#[test]
fn branches_of_solutions_with_several_impacts_pass_the_dots_and_say_where_there_are_none() {
    let (oscillator, at) = (crate::specimens::closed_form(), frequency());
    let range = [0.262, 0.342];
    let scope = Scope {
        window: Window { primary: range, secondary: [at, 2.0 * at] },
        loops: vec![1, 2, 3],
        start: None,
    };
    let mut cut = Cut::follow(&oscillator, &scope, &[], line(at, range), &Silent).expect("nobody stops it");
    let without = cut.branches().len();
    let found = cut.simulated(&Sampling { impacts: 8, recorded: 24, ..sampling(321) }, &[], &Silent);
    let several = &cut.branches()[without..];
    assert!(several.len() > 5 && several.iter().all(|branch| (2..=8).contains(&branch.impacts())));
    // What simulation settles on with so few impacts lies on a stable branch.
    let readings = |primary: f64| {
        let here = oscillator.with_parameters([primary, at]);
        let starts: Vec<State> =
            (1..=6).map(|k| State::at_rest(-0.1 * f64::from(k), 1.1 * f64::from(k))).collect();
        let horizon = grazing_unfold::long_time::Horizon {
            patience: grazing_unfold::long_time::Patience::Unsettled,
            ..grazing_unfold::long_time::Horizon::drifting(400, 24)
        };
        grazing_unfold::place::seen(&here, &starts, horizon)
    };
    let mut seen = 0;
    for k in 0..40 {
        // Between the values that were sampled.
        let primary = 0.2632 + 0.00157 * f64::from(k);
        let branches: Vec<(usize, u32)> = several
            .iter()
            .filter(|branch| !branch.stable_at(primary).is_empty())
            .map(|branch| (branch.impacts() as usize, branch.equations.loops()))
            .collect();
        for one in readings(primary) {
            if let Some(numbers @ (2..=8, _)) = one.fate.numbers() {
                assert!(branches.contains(&numbers), "{numbers:?} at {primary}: {branches:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > 10, "{seen}");
    // Dots at such values lie on strands.
    let periodic = found.attractor.iter().filter(|dot| (0.304..0.309).contains(&dot.primary));
    let mut near = 0;
    for dot in periodic {
        let gaps = several_at(&found, dot.primary).into_iter().map(|(x, _)| (x - dot.x).abs());
        assert!(gaps.fold(f64::INFINITY, f64::min) < 2e-3, "{} at {}", dot.x, dot.primary);
        near += 1;
    }
    assert!(near > 20, "{near}");
    // A solution of two impacts leaves the period doubling of the MPS with p = 2 and stays beside it at first.
    let doubled = several.iter().find(|branch| (branch.impacts(), branch.equations.loops()) == (2, 4));
    assert!(doubled.is_some_and(|branch| !branch.stable_at(0.3235).is_empty()));
}
