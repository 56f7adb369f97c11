//! Walls at other positions, on the other side, or in motion: the same oscillator written in other
//! coordinates.

use grazing_input::{Description, WallSide};
use grazing_model::smooth::SmoothOscillator;

/// A description with this motion, whose parameters are `B` and `omega` and whose only constants
/// are `zeta` and `d`.
pub(crate) fn described(force: &str, wall: &str) -> Result<Description, String> {
    let text = format!(
        "name = \"Test\"\n[parameters]\nzeta = 0.02\nd = 0.3\n[primary]\nname = \"B\"\nrange = [0.1, 1.5]\n[secondary]\nname = \"omega\"\n\
         range = [0.4, 1.1]\n[motion]\nforce = \"{force}\"\nfrequency = \"omega\"\n{wall}\n[impact]\nrestitution = \"0.9\"\n\
         duration = \"0\"\n[analysis]\nloops = [1]\nstart = [0.5, -0.25]\n"
    );
    Description::parse(&text, "test.toml").map_err(|error| error.to_string())
}

/// The greatest difference of the forces of two descriptions, as seen from their walls.
fn difference(a: &Description, b: &Description) -> f64 {
    let places = [[-1.3, 0.4, 0.9, 0.7, 0.8], [-0.01, -2.0, 5.3, 1.4, 0.45], [-3.0, 0.0, -1.2, 0.2, 1.05]];
    let force = |of: &Description, [u, v, t, mu, eta]: [f64; 5]| of.force(u, v, t, mu, eta);
    places.map(|place| (force(a, place) - force(b, place)).abs()).into_iter().fold(0.0, f64::max)
}

/// The paper's oscillator, its amplitude being B omega^2.
const RESTING: &str = "-2*zeta*v - x - 1 + B*omega^2*cos(omega*t)";

#[test]
fn an_oscillator_whose_base_moves_with_its_wall_is_that_of_the_paper_with_the_force_of_inertia() {
    let paper = described(RESTING, "").unwrap();
    let moving = "[wall]\nposition = \"B*cos(omega*t)\"";
    let base = described("-2*zeta*(v + B*omega*sin(omega*t)) - (x - B*cos(omega*t)) - 1", moving).unwrap();
    assert!(difference(&paper, &base) < 1e-14);
    // The conversions of coordinates are inverse to each other.
    let (from, time, parameters) = ([-0.7, 0.2], 1.7, [0.9, 0.6]);
    let outside = base.wall().outside(from, time, parameters);
    assert!((outside[0] - (-0.7 + 0.9 * libm::cos(0.6 * 1.7))).abs() < 1e-15);
    let back = base.wall().inside(outside, time, parameters);
    assert!((back[0] - from[0]).abs() + (back[1] - from[1]).abs() < 1e-15);
    // The start is seen from the wall in the middle of the ranges.
    let [u, v] = base.start().unwrap();
    assert!((u + 0.3).abs() < 1e-15 && v == -0.25, "{u} {v}");
}

#[test]
fn only_a_wall_that_is_written_may_be_unusual() {
    assert!(described(RESTING, "").unwrap().wall().is_usual());
    assert!(described(RESTING, "[wall]\nposition = \"0\"").unwrap().wall().is_usual());
    assert!(!described(RESTING, "[wall]\nposition = \"d\"").unwrap().wall().is_usual());
}

#[test]
fn above_the_wall_is_below_it_upside_down() {
    let paper = described(RESTING, "").unwrap();
    let above =
        described("-2*zeta*v - x + 1 - B*omega^2*cos(omega*t)", "[wall]\nposition = \"0\"\nside = \"above\"")
            .unwrap();
    assert_eq!(above.wall().side(), WallSide::Above);
    assert_eq!(difference(&paper, &above), 0.0);
    assert_eq!(above.start(), Some([-0.5, 0.25]));
    let shifted =
        described("-2*zeta*v - (x - d) - 1 + B*omega^2*cos(omega*t)", "[wall]\nposition = \"d\"").unwrap();
    assert!(difference(&paper, &shifted) < 1e-15);
}

/// A file with these tables of walls, and this one of impacts.
fn between(walls: &str, impact: &str) -> Result<Description, String> {
    between_with(walls, impact, "")
}

/// A file with these tables of walls, this one of impacts, and what follows the loops.
fn between_with(walls: &str, impact: &str, last: &str) -> Result<Description, String> {
    let text = format!(
        "name = \"two\"\n[parameters]\ngap = 1.0\n[primary]\nname = \"A\"\nrange = [0.1, 1.5]\n[secondary]\nname = \"omega\"\n\
         range = [0.4, 1.1]\n[motion]\nforce = \"-0.1*v - x + A*cos(omega*t)\"\nfrequency = \"omega\"\n{walls}{impact}[analysis]\n\
         loops = [1]\n{last}"
    );
    Description::parse(&text, "two.toml").map_err(|error| error.to_string())
}

const IMPACT: &str = "[impact]\nrestitution = \"0.7\"\nduration = \"0\"\n";

#[test]
fn two_walls_have_the_motion_between_them_and_their_own_reset_laws() {
    let walls = "[[walls]]\nposition = \"gap\"\n[[walls]]\nposition = \"-gap + 0.1*cos(omega*t)\"\nrestitution = \"0.5\"\n";
    let first = between(walls, IMPACT).expect("it is right");
    assert!(first.has_two_walls());
    let [upper, lower] = [0, 1].map(|k| first.from_each_wall().nth(k).expect("there are two"));
    assert_eq!([upper.wall().side(), lower.wall().side()], [WallSide::Below, WallSide::Above]);
    assert_eq!([&upper, &lower].map(|seen| seen.restitution(0.3, 0.0, 1.0, 0.8)), [0.7, 0.5]);
    // One place of the file, seen from both, a distance D and a rate of it apart.
    let (at, time) = ([1.0, 0.8], 0.7);
    let [gap, rate] = upper.gap(time, at[0], at[1]);
    assert!((gap - (2.0 - 0.1 * libm::cos(0.8 * time))).abs() < 1e-15);
    assert!((rate - 0.08 * libm::sin(0.8 * time)).abs() < 1e-15);
    let [from_upper, from_lower] = [&upper, &lower].map(|seen| seen.wall().inside([0.2, -0.4], time, at));
    assert!((from_lower[0] - (-gap - from_upper[0])).abs() < 1e-15);
    assert!((from_lower[1] - (-rate - from_upper[1])).abs() < 1e-15);
    assert!(upper.other_stop().is_some_and(|other| other == lower));
    assert!(between("", IMPACT).expect("it is right").other_stop().is_none());
}

#[test]
fn walls_that_meet_or_contradict_each_other_are_refused_with_the_place() {
    let wall = |position: &str, rest: &str| format!("[[walls]]\nposition = \"{position}\"\n{rest}");
    let own = "restitution = \"0.5\"\nduration = \"0\"\n";
    let refused = |walls: [String; 2], impact: &str, words: &[&str]| {
        let error = between(&walls.concat(), impact).expect_err("it is wrong");
        assert!(words.iter().all(|word| error.contains(word)), "{error}");
    };
    refused([wall("gap", ""), wall("A - 0.5", "")], IMPACT, &["walls[1].position", "the walls meet", "A = "]);
    let above = "side = \"above\"\n";
    refused([wall("gap", above), wall("-gap", above)], IMPACT, &["walls[2].side", "below one of them"]);
    refused([wall("gap", above), wall("-gap", "")], IMPACT, &["the walls meet"]);
    refused([wall("gap", own), wall("-gap", "")], "", &["impact is missing"]);
    refused(
        [wall("gap", ""), "[wall]\nposition = \"0\"\n".to_owned()],
        IMPACT,
        &["both [wall] and [[walls]]"],
    );
    refused(
        [wall("gap", "stiffness = 3\n"), String::new()],
        IMPACT,
        &["unknown key walls[1].stiffness", "rigid"],
    );
    assert!(between(&[wall("gap", own), wall("-gap", own)].concat(), "").is_ok());
    let error = between("[wall]\nposition = \"0\"\nstiffness = 30.0\n", IMPACT).expect_err("a wall is rigid");
    assert!(error.contains("unknown key wall.stiffness") && error.contains("sqrt(x^2 + s^2)"), "{error}");
}

#[test]
fn between_two_walls_own_curves_and_further_generations_are_refused_with_what_to_do() {
    let two = "[[walls]]\nposition = \"gap\"\n[[walls]]\nposition = \"-gap\"\n";
    let one = "[wall]\nposition = \"gap\"\n";
    let curve = "[[curves]]\nname = \"fast\"\nimpact_velocity = 0.5\n";
    for (last, words) in [
        (
            "generations = 2\n",
            ["analysis.generations", "at one wall alone", "leave generations out", "--at, [[diagrams]]"],
        ),
        (curve, ["curves", "own curves are for one wall", "with two [[walls]]", "leave them out"]),
    ] {
        let error = between_with(two, IMPACT, last).expect_err("it is refused");
        assert!(words.iter().all(|word| error.contains(word)), "{error}");
        assert!(between_with(one, IMPACT, last).is_ok(), "{last}");
    }
    assert!(between_with(two, IMPACT, "generations = 1\n").is_ok());
}
