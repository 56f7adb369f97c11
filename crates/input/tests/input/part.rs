//! The part of a plane in which a description is valid.

use grazing_input::Description;
use grazing_model::smooth::Stop;

/// An oscillator with these forcing frequency and restitution, in A and omega.
fn file(frequency: &str, restitution: &str) -> Description {
    let text = format!(
        "name = \"Test\"\nparameters = {{}}\nprimary = {{ name = \"A\", range = [0.2, 1.2] }}\n\
         secondary = {{ name = \"omega\", range = [0.3, 1.1] }}\n\
         motion = {{ force = \"-0.1*v - x - 1 + A*cos({frequency}*t)\", frequency = \"{frequency}\" }}\n\
         impact = {{ restitution = \"{restitution}\", duration = \"0\" }}\nanalysis = {{ loops = [1] }}\n"
    );
    Description::parse(&text, "test.toml").unwrap()
}

#[test]
fn of_a_view_that_reaches_beyond_what_is_allowed_the_largest_rectangle_inside_remains() {
    let part = |of: &Description, ranges| of.valid_part(ranges, &Stop::default());
    let plain = file("omega", "0.8");
    let whole = [[-2.0, 3.0], [0.4, 2.0]];
    assert_eq!(part(&plain, whole), Some(whole));
    // Below zero there is no frequency, and just above it the periods are too long.
    let [across, [low, high]] = part(&plain, [[-2.0, 3.0], [-1.0, 2.0]]).unwrap();
    assert_eq!((across, high), ([-2.0, 3.0], 2.0));
    assert!((0.068..0.08).contains(&low), "{low}");
    assert_eq!(part(&plain, [[0.0, 1.0], [-2.0, -1.0]]), None);
    // A strip that is thinner than a cell.
    let [_, [low, high]] = part(&plain, [[0.0, 1.0], [-10.0, 0.2]]).unwrap();
    assert!((0.068..0.1).contains(&low) && high == 0.2, "{low}");
    assert_eq!(part(&plain, [[1.0, 0.0], [0.4, f64::NAN]]), None);
    // A frequency that falls, and a restitution that is positive on one side only.
    let [[left, right], [_, high]] = part(&file("(2 - omega)", "A"), [[-1.0, 3.0], [0.5, 4.0]]).unwrap();
    assert!((0.0..0.02).contains(&left) && right == 3.0 && (1.88..2.0).contains(&high), "{left} {high}");
    let stop = Stop::default();
    stop.ask();
    assert_eq!(plain.valid_part(whole, &stop), None);
}
