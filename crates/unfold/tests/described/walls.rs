//! The plane of oscillators between two walls, against simulation and solutions found at places.

use grazing_input::Description;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Stop;
use grazing_unfold::Diagram;
use grazing_unfold::long_time::{Horizon, Patience};
use grazing_unfold::place::{Place, Starts};
use grazing_unfold::progress::Silent;
use grazing_unfold::unfolded::Unfolded;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// A linear oscillator between two walls.
fn between(walls: &str) -> Unfolded {
    let text = format!(
        "name = \"Between\"\nparameters = {{ zeta = 0.04 }}\nprimary = {{ name = \"A\", range = [0.1, 1.6] }}\n\
         secondary = {{ name = \"omega\", range = [0.55, 1.25] }}\n\
         motion = {{ force = \"-2*zeta*v - x + A*cos(omega*t)\", frequency = \"omega\" }}\n\
         impact = {{ restitution = \"0.7\", duration = \"0\" }}\nanalysis = {{ loops = [1, 2] }}\n{walls}"
    );
    let description = Description::parse(&text, "between.toml").unwrap_or_else(|error| panic!("{error}"));
    Unfolded::described(&description, &Silent, &Stop::default(), &|_| ()).expect("it grazes")
}

/// Whether a place lies in a region of the solutions with so many loops in a diagram; `None` where that is
/// undecided, and next to borders.
fn holds(diagram: &Diagram, loops: u32, place: [f64; 2]) -> Option<bool> {
    let at = |place: [f64; 2]| {
        let own = diagram.regions.iter().filter(|region| region.loops == loops && region.contains(place));
        let doubtful: Vec<bool> = own.map(|region| region.doubt.is_some()).collect();
        if doubtful.contains(&false) { Some(true) } else { doubtful.is_empty().then_some(false) }
    };
    let [width, height] = diagram.scope.window.widths();
    let aside = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
    let beside = aside.map(|[x, y]| at([place[0] + 2e-3 * x * width, place[1] + 2e-3 * y * height]));
    at(place).filter(|here| beside.iter().all(|there| *there == Some(*here)))
}

/// The diagram with the regions of solutions that hit each wall once in the place of its own.
fn both(unfolded: &Unfolded) -> Diagram {
    let regions = unfolded.sequences.solutions.iter().flat_map(|found| found.regions.clone());
    Diagram { regions: regions.collect(), ..unfolded.diagram.clone() }
}

#[test]
fn between_two_walls_motion_settles_where_regions_say_so_and_nowhere_else() {
    let like = "[[walls]]\nposition = \"1\"\nrestitution = \"0.75\"\n[[walls]]\nposition = \"-1\"\nrestitution = \"0.75\"\n";
    let unlike = "[[walls]]\nposition = \"0.9\"\nrestitution = \"0.8\"\n[[walls]]\nposition = \"-1.2\"\nrestitution = \"0.6\"\n";
    let mut random = Pcg64::new(472, 1);
    let mut uniform = move || random.next_u64() as f64 / u64::MAX as f64;
    for (name, walls) in [("like", like), ("unlike", unlike)] {
        let unfolded = between(walls);
        let other = unfolded.other.as_ref().expect("there are two walls");
        let diagrams = [&unfolded.diagram, &other.diagram];
        let horizon = Horizon { transient: 120, counted: 24, patience: Patience::Drifting, longest: 0 };
        let starts = Starts { states: 4, horizon, ..Starts::default() };
        // Places at which motion without impacts, and with one impact at either wall, was seen; solutions; and regions.
        let (mut settled, mut solved, mut held, mut at_both) = ([0; 3], 0, 0, 0);
        for _ in 0..60 {
            let place = unfolded.diagram.scope.window.parameters([uniform(), uniform()]);
            let here = unfolded.diagram.oscillator.with_parameters(place);
            let found =
                Place::compute(&here, &unfolded.diagram.scope, &starts, &Silent).expect("nobody stops it");
            for one in &found.attractors {
                let (loops, wall) = match one.fate.numbers() {
                    Some((2, periods)) if periods <= 2 && one.fate.second * f64::from(periods) == 1.0 => {
                        let said = holds(&both(&unfolded), periods, place);
                        assert_ne!(said, Some(false), "{name}: both walls in {periods} periods at {place:?}");
                        at_both += 1;
                        continue;
                    }
                    Some((0, 0)) => (0, 0),
                    Some((1, loops)) if loops <= 2 => (loops, one.stops[0]),
                    _ => continue,
                };
                let said = holds(diagrams[wall], loops, place);
                assert_ne!(said, Some(false), "{name}: p = {loops} at wall {} at {place:?}", wall + 1);
                settled[if loops == 0 { 0 } else { 1 + wall }] += 1;
            }
            let good = |one: &&grazing_unfold::place::Solution| {
                one.impacts.len() < 2 && one.loops <= 2 && one.multipliers.stable() && one.admissible
            };
            let wall = |one: &grazing_unfold::place::Solution| one.stops.first().copied().unwrap_or(0);
            for one in found.solutions.iter().filter(good) {
                let said = holds(diagrams[wall(one)], one.loops, place);
                assert_ne!(said, Some(false), "{name}: {} loops at {place:?}", one.loops);
                solved += 1;
            }
            for (wall, diagram) in diagrams.into_iter().enumerate() {
                for loops in [1, 2] {
                    if holds(diagram, loops, place) == Some(true) {
                        let mut own = found.solutions.iter().filter(good);
                        let there = own.any(|one| (one.loops, one.stops.first()) == (loops, Some(&wall)));
                        assert!(
                            there,
                            "{name}: no solution of p = {loops} at wall {} at {place:?}",
                            wall + 1
                        );
                        held += 1;
                    }
                }
            }
        }
        assert!(settled[0] > 4 && solved > 10 && held > 2, "{name}: {settled:?} {solved} {held}");
        assert!(at_both > 10, "{name}: {at_both}");
    }
}

#[test]
fn a_resonance_at_each_of_two_unlike_walls_is_listed_once_for_each_with_its_own_coefficients() {
    let unlike = "[[walls]]\nposition = \"1\"\nrestitution = \"0.8\"\n[[walls]]\nposition = \"-1\"\nrestitution = \"0.6\"\n";
    let unfolded = between(unlike);
    let listed = unfolded.at_resonances().coefficients;
    let expected: Vec<(u32, u32, u32, f64)> = unfolded
        .from_each_wall()
        .flat_map(|seen| seen.resonances.iter().filter(|at| at.curves.is_some()))
        .map(|at| (at.wall, at.loops, at.n, at.point.saddle_node_coefficient()))
        .collect();
    let rows: Vec<_> = listed.iter().map(|row| (row.wall, row.loops, row.n, row.coefficients.c_sn)).collect();
    assert_eq!(rows, expected);
    // Both walls are as far away, so that motion grazes both at once and only what an impact does differs.
    let at = |wall: u32| rows.iter().filter(move |(own, ..)| *own == wall).collect::<Vec<_>>();
    let (first, second) = (at(1), at(2));
    assert!(!first.is_empty() && first.len() == second.len(), "{rows:?}");
    for (one, other) in first.iter().zip(&second) {
        assert!((one.1, one.2) == (other.1, other.2) && one.3 != other.3, "{one:?} {other:?}");
    }
}
