//! Reasons why there is nothing to unfold, in words.

use grazing_input::Description;
use grazing_unfold::UnfoldError;
use grazing_unfold::escape::Escape;
use grazing_unfold::non_impacting::Height;
use grazing_unfold::nothing::Nothing;

/// An oscillator with this force and a wall at x = 0, in r and omega.
fn file(force: &str, restitution: &str) -> Description {
    let text = format!(
        "parameters = {{}}\nprimary = {{ name = \"r\", range = [0.5, 0.9] }}\n\
         secondary = {{ name = \"omega\", range = [0.5, 0.95] }}\n\
         motion = {{ force = \"-0.06*v - x + {force}*cos(omega*t)\", frequency = \"omega\" }}\n\
         wall = {{ position = \"0\", side = \"below\" }}\n\
         impact = {{ restitution = \"{restitution}\", duration = \"0\" }}\n\
         analysis = {{ loops = [1] }}\nname = \"Test\"\n"
    );
    Description::parse(&text, "test.toml").unwrap()
}

fn told(error: &UnfoldError, description: &Description) -> String {
    Nothing::new(error, description).to_string()
}

fn no_grazing([lowest, highest]: [f64; 2]) -> UnfoldError {
    let height = |position| Height { position, parameters: [0.5, 0.75], acceleration: -1.0 };
    UnfoldError::NoGrazing { lowest: height(lowest), highest: height(highest), whole: true }
}

#[test]
fn a_primary_parameter_of_the_impact_alone_is_named_as_the_reason() {
    let error = no_grazing([-0.3, 3.4]);
    let words = told(&error, &file("-1 + 0.5", "r"));
    assert!(words.contains("does not depend on r") && words.contains("let primary.name be"), "{words}");
    let words = told(&error, &file("-1 + r", "0.9"));
    assert!(words.contains("narrow the ranges"), "{words}");
}

#[test]
fn rest_is_said_to_lie_behind_the_wall_only_where_none_lies_in_front() {
    let error = no_grazing([0.3, 3.4]);
    let behind = "rest position lies behind the wall";
    let words = told(&error, &file("1 + r", "0.9"));
    assert!(words.contains(behind), "{words}");
    // Attraction that exceeds the spring at the wall leaves the rest at x = -0.97 in place.
    let words = told(&error, &file("-1 + 3/(1 + ((x - 0.1)/0.1)^2) + r", "0.9"));
    assert!(!words.contains(behind) && words.contains("crosses it everywhere"), "{words}");
}

#[test]
fn motion_that_ends_is_told_with_its_place_and_the_force() {
    let escape =
        |position, velocity, force| Escape { parameters: [0.5, 0.75], time: 1.5, position, velocity, force };
    let paper = Description::parse(include_str!("../../../../examples/paper.toml"), "paper.toml").unwrap();
    let words = |escape| told(&UnfoldError::RunsAway { escape }, &paper);
    let away = words(escape(-2e9, -4e5, 1e3));
    assert!(
        away.contains("diverges") && away.contains("away from the wall within t = 1.5 at A = 0.5"),
        "{away}"
    );
    let pole = words(escape(-0.5, -7437.38, -1.5e8));
    assert!(pole.contains("not beyond x = -0.5") && pole.contains("F = -1.5e8, as at a pole"), "{pole}");
    let edge = words(escape(-0.9, -1.0, f64::NAN));
    assert!(edge.contains("no finite value: it is NaN near x = -0.9, v = -1, t = 1.5 at A = 0.5"), "{edge}");
}

#[test]
fn free_and_forced_frequencies_stand_beside_each_other_with_the_question_whether_units_are_coherent() {
    // Grams for kilograms, and millimetres for metres.
    let rig = |m: &str, gap: &str| {
        let text = format!(
            "name = \"Rig\"\nparameters = {{ m = {m}, k = 3000.0, c = 1.0, gap = {gap} }}\n\
             primary = {{ name = \"F\", range = [0.0, 3.0] }}\nsecondary = {{ name = \"f\", range = [8.0, 22.0] }}\n\
             units = {{ length = \"m\", time = \"s\" }}\n\
             motion = {{ force = \"(-c*v - k*x + F*cos(2*pi*f*t))/m\", frequency = \"2*pi*f\" }}\n\
             wall = {{ position = \"gap\" }}\nimpact = {{ restitution = \"0.85\", duration = \"0\" }}\n\
             analysis = {{ loops = [1] }}\n"
        );
        Description::parse(&text, "rig.toml").unwrap()
    };
    let height = |position| Height { position, parameters: [3.0, 20.0], acceleration: -1.0 };
    let words = |position, [m, gap]: [&str; 2]| {
        let (lowest, highest) = (height(position), height(position));
        told(&UnfoldError::NoGrazing { lowest, highest, whole: true }, &rig(m, gap))
    };
    let question =
        "Hz: is that meant, and is everything in coherent units (kg with N and m, not g or mm)? If so, widen";
    let grams = words(-0.000994, ["200", "0.001"]);
    assert!(grams.contains("has a frequency of 0.616 Hz, and the forcing 8 to 22 Hz"), "{grams}");
    assert!(grams.contains(question) && grams.contains("having come 0.6 % of the way from rest"), "{grams}");
    let millimetres = words(-0.989, ["0.2", "1.0"]);
    assert!(millimetres.contains("has a frequency of 19.5 Hz, and the forcing 8 to 22 Hz"), "{millimetres}");
    assert!(millimetres.contains(question) && millimetres.contains("having come 1.1 % of"), "{millimetres}");
    // Every message without grazing has it, with units or without.
    let plain = file("-1 + r", "0.9");
    let whole = [false, true].map(|whole| {
        let (lowest, highest) = (height(0.3), height(0.4));
        UnfoldError::NoGrazing { lowest, highest, whole }
    });
    let pushed =
        [0.0, -1.0].map(|acceleration| UnfoldError::Pushed { at: Height { acceleration, ..height(0.0) } });
    for error in whole.into_iter().chain(pushed).chain([no_grazing([-0.3, 3.4])]) {
        let words = told(&error, &plain);
        assert!(
            words.contains(
                "has a frequency of 1, and the forcing 0.5 to 0.95, in radians per unit of time: is"
            ),
            "{words}"
        );
    }
    let words = told(&no_grazing([-0.3, 3.4]), &file("2*x + r", "0.9"));
    let question = "Nothing drives the oscillator back to rest there, and the forcing has a frequency of 0.5 to 0.95, in";
    assert!(words.contains(question), "{words}");
}
