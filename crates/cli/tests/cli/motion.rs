//! Motion and basins of attraction at a place.

use std::fs;

use crate::program::{edited, empty_folder, grazing, narrow_duffing};

#[test]
fn motion_at_a_place_is_drawn_tabulated_and_listed_beside_an_own_curve() {
    let folder = empty_folder();
    // Motion settles fast.
    let damped = edited(&narrow_duffing(), "[parameters]", "zeta", "zeta = 0.05");
    fs::write(folder.path().join("my.toml"), damped).expect("the folder is ours");
    let curve = "curves=[{name=\"hard\",impact_velocity=0.1}]";
    let run =
        grazing(folder.path(), &["unfold", "my.toml", "--at", "0.1,0.97", "--set", curve, "--output", "out"]);
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let words: Vec<&str> = run.output.split_whitespace().collect();
    let listed = words.join(" ");
    assert!(listed.contains("0.1 0.97 no impacts 100 % -0.05"), "{}", run.output);
    let read = |name: &str| fs::read_to_string(folder.path().join("out").join(name)).expect("it is written");
    let basins = read("data/place_basins.csv");
    // Far below grazing, every state of the lattice leads to the one attractor.
    assert!(
        basins.lines().count() > 1000 && basins.lines().skip(1).all(|line| line.ends_with(",1")),
        "{basins}"
    );
    assert_eq!(read("data/place_impacts.csv").lines().count(), 1);
    // A period of motion that keeps clear of the wall, without a jump between its end and its beginning.
    let motion = read("data/place_motion.csv");
    let rows: Vec<Vec<f64>> = motion
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    assert!(rows.len() > 100 && rows.iter().all(|row| row[4] < 0.0), "{motion}");
    let [first, last] = [&rows[0], &rows[rows.len() - 1]];
    assert!((first[4] - last[4]).abs() < 1e-6 && (first[5] - last[5]).abs() < 1e-6, "{first:?} {last:?}");
    assert!(read("place-1.svg").contains("no impacts: 100 %") && read("report.html").contains("place-1"));
    assert!(read("data/README.md").contains("place_basins") && read("diagram.svg").contains(">hard<"));
}

#[test]
fn a_place_that_is_none_is_refused_before_anything_is_computed() {
    let folder = empty_folder();
    fs::write(folder.path().join("my.toml"), narrow_duffing()).expect("the folder is ours");
    for (place, told) in [("0.1", "two numbers"), ("0.1,x", "two numbers"), ("0.1,-1", "must be positive")] {
        let run = grazing(folder.path(), &["unfold", "my.toml", "--at", place]);
        assert_eq!((run.code, run.output.as_str()), (Some(2), ""), "{place}");
        assert!(run.messages.contains(told), "{place}: {}", run.messages);
    }
}

#[test]
fn impacts_that_accumulate_are_said_to_and_neither_called_rest_nor_given_a_share() {
    let folder = empty_folder();
    let text = "name = \"Chatter\"\nparameters = { zeta = 0.05, r = 0.3 }\nprimary = { name = \"A\", range = [0.0, 1.3] }\n\
                secondary = { name = \"omega\", range = [0.34, 0.36] }\n\
                motion = { force = \"-2*zeta*v - x - 1 + A*cos(omega*t)\", frequency = \"omega\" }\n\
                impact = { restitution = \"r\", duration = \"0\" }\nanalysis = { loops = [1] }\n\
                diagrams = [{ fixed = \"omega\", at = 0.35 }]\n";
    fs::write(folder.path().join("my.toml"), text).expect("the folder is ours");
    let run = grazing(folder.path(), &["unfold", "my.toml", "--at", "1.2,0.35", "--output", "out"]);
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let listed = run.output.split_whitespace().collect::<Vec<_>>().join(" ");
    let accumulates = "impacts accumulate at the wall; not followed further";
    let told = format!("Attractors none at A = 1.2, omega = 0.35: {accumulates} (24 of 24 random states)");
    assert!(listed.contains(&told) && !listed.contains("resting"), "{}", run.output);
    let left_out = format!(" of 480 simulated orbits: {accumulates}");
    assert!(listed.contains("left out: ") && listed.contains(&left_out), "{}", run.output);
    let read = |name: &str| fs::read_to_string(folder.path().join("out").join(name)).expect("it is written");
    let attractors = read("data/place_attractors.csv");
    let rows: Vec<Vec<&str>> = attractors.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| rows[0].iter().position(|head| *head == name).expect("it is a column");
    let cells = ["attractor", "states", "share", "motion"].map(|name| rows[1][column(name)]);
    assert_eq!((rows.len(), cells), (2, ["0", "24", "", "accumulating"]), "{attractors}");
    let basins = read("data/place_basins.csv");
    assert!(basins.lines().skip(1).all(|line| line.ends_with(",accumulating,0")), "{basins}");
    assert!(read("data/place_motion.csv").lines().count() > 100);
    assert!(read("place-1.svg").contains("not followed: 24 of 24"));
    assert!(read("report.html").contains(&left_out));
}
