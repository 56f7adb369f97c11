//! Motion and basins of attraction at a place.

use std::fs;

use crate::program::{edited, empty_folder, grazing, narrow_linear};

#[test]
fn motion_at_a_place_is_drawn_tabulated_and_listed_beside_an_own_curve() {
    let folder = empty_folder();
    // Motion settles fast.
    let damped = edited(&narrow_linear(), "[parameters]", "zeta", "zeta = 0.05");
    fs::write(folder.path().join("my.toml"), damped).expect("the folder is ours");
    let curve = "curves=[{name=\"hard\",impact_velocity=0.1}]";
    let run =
        grazing(folder.path(), &["unfold", "my.toml", "--at", "0.1,0.9", "--set", curve, "--output", "out"]);
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let words: Vec<&str> = run.output.split_whitespace().collect();
    let listed = words.join(" ");
    assert!(listed.contains("0.1 0.9 no impacts 100 % -0.05"), "{}", run.output);
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
    let page = read("report.html");
    assert!(read("place-1.svg").contains("no impacts: 100 %") && page.contains("place-1"));
    // What was set stands above the file's text, and is no part of what the file says of itself.
    assert!(page.contains("# --set curves=") && !page.contains("class=\"about\">--set"));
    assert!(read("data/README.md").contains("place_basins") && read("diagram.svg").contains(">hard<"));
}

#[test]
fn a_place_that_is_none_is_refused_before_anything_is_computed() {
    let folder = empty_folder();
    fs::write(folder.path().join("my.toml"), narrow_linear()).expect("the folder is ours");
    for (place, told) in [("0.1", "two numbers"), ("0.1,x", "two numbers"), ("0.1,-1", "must be positive")] {
        let run = grazing(folder.path(), &["unfold", "my.toml", "--at", place]);
        assert_eq!((run.code, run.output.as_str()), (Some(2), ""), "{place}");
        assert!(run.messages.contains(told), "{place}: {}", run.messages);
    }
}

#[test]
fn motion_that_rests_at_the_wall_is_named_tabulated_drawn_and_swept_with_nothing_left_out() {
    let folder = empty_folder();
    let text = "name = \"Chatter\"\nparameters = { zeta = 0.05, r = 0.3 }\nprimary = { name = \"A\", range = [0.0, 1.3] }\n\
                secondary = { name = \"omega\", range = [0.34, 0.36] }\n\
                motion = { force = \"-2*zeta*v - x - 1 + A*cos(omega*t)\", frequency = \"omega\" }\n\
                impact = { restitution = \"r\", duration = \"0\" }\nanalysis = { loops = [1] }\n\
                diagrams = [{ fixed = \"omega\", at = 0.35, sweeps = true }]\n";
    fs::write(folder.path().join("my.toml"), text).expect("the folder is ours");
    let run = grazing(folder.path(), &["unfold", "my.toml", "--at", "1.2,0.35", "--output", "out"]);
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let listed = run.output.split_whitespace().collect::<Vec<_>>().join(" ");
    let words = "chatter and a rest in 1 period";
    let told = "motion that rests at the wall forgets its state: its multipliers are 0";
    assert!(listed.contains(words) && listed.contains("100 %") && listed.contains(told), "{}", run.output);
    assert!(!listed.contains("left out: "), "{}", run.output);
    let read = |name: &str| fs::read_to_string(folder.path().join("out").join(name)).expect("it is written");
    let attractors = read("data/place_attractors.csv");
    let rows: Vec<Vec<&str>> = attractors.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| rows[0].iter().position(|head| *head == name).expect("it is a column");
    let names = ["attractor", "states", "motion", "periods", "impacts", "rests", "lyapunov_exponent"];
    let cells = names.map(|name| rows[1][column(name)]);
    let one = "1.0000000000000000e0";
    assert_eq!((rows.len(), cells), (2, ["1", "24", "periodic", one, "", one, ""]), "{attractors}");
    let basins = read("data/place_basins.csv");
    assert!(basins.lines().skip(1).all(|line| line.ends_with(",periodic,1")), "{basins}");
    // Along the wall up to the release, at rest.
    let motion = read("data/place_motion.csv");
    let rest = motion.lines().filter(|line| line.ends_with(",0.0000000000000000e0,0.0000000000000000e0"));
    assert!(rest.count() >= 1 && motion.lines().count() > 100, "{motion}");
    assert!(read("place-1.svg").contains("chatter and a rest in 1 period"));
    assert!(read("report.html").contains("chatter and a rest in 1 period"));
    // Sweeps pass through such motion; at rest the wall bears more than impulses.
    let swept = read("data/diagram_motion.csv");
    let heads: Vec<&str> = swept.lines().next().unwrap_or_default().split(',').collect();
    let at = |name: &str| heads.iter().position(|head| *head == name).expect("it is a column");
    let resting = swept.lines().skip(1).filter(|line| line.split(',').nth(at("rests")) == Some(one));
    assert!(resting.filter(|line| line.starts_with("1,up,")).count() > 100, "{}", swept.len());
}
