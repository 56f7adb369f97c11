//! `grazing export`: a problem for AUTO-07p. That AUTO follows the curves of the program itself is written in docs/validation.md.

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process::Command;

use crate::program::{empty_folder, grazing, repository};
use grazing_input::Description;
use grazing_model::smooth::SmoothOscillator;

/// The values of the Fortran formulas at some states, velocities and phases; none without a compiler.
fn compiled(folder: &Path, name: &str, states: &[[f64; 7]]) -> Option<Vec<f64>> {
    let calls = |state: &[f64; 7]| {
        let [u, v, t, mu, eta, y, z] = state.map(|value| format!("{value:e}").replace('e', "d"));
        format!(
            "print '(4es26.17e3)', grazing_force([{u}, {v}, {t}, {mu}, {eta}]), &\n grazing_frequency([{mu}, {eta}]), &\n \
             grazing_restitution([{y}, {z}, {mu}, {eta}]), &\n grazing_duration([{y}, {z}, {mu}, {eta}])\n"
        )
    };
    let calls: String = states.iter().map(calls).collect();
    let main = format!("program main\nuse grazing_formulas\n{calls}end program main\n");
    fs::write(folder.join("main.f90"), main).expect("the folder is ours");
    let equations = format!("{name}.f90");
    let built =
        Command::new("gfortran").args([&equations, "main.f90", "-o", "main"]).current_dir(folder).output();
    match built {
        Ok(built) => assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            // Written directly to the stream, which the test harness does not capture.
            writeln!(io::stderr(), "SKIPPED: there is no gfortran, {equations} was not compiled")
                .expect("a message can be written");
            return None;
        }
        Err(error) => panic!("gfortran could not be started: {error}"),
    }
    let run = Command::new(folder.join("main")).output().expect("it was built");
    let text = String::from_utf8(run.stdout).expect("it is text");
    Some(text.split_whitespace().map(|number| number.parse().expect("it is a number")).collect())
}

#[test]
fn exported_equations_are_those_of_the_description_and_begin_at_a_solution() {
    for (name, at) in [
        ("duffing", "0.41,0.9225"),
        ("varying-impact", "0.75,0.8"),
        ("shaking-table", "1,2.5"),
        ("pendulum", "0.35,0.9"),
    ] {
        let folder = empty_folder();
        let file = repository().join(format!("examples/{name}.toml"));
        let made =
            grazing(folder.path(), &["export", &file.display().to_string(), "--at", at, "--output", "."]);
        assert_eq!(made.code, Some(0), "{name}: {}", made.messages);
        let stem = name.replace('-', "_");
        let read = |file: String| fs::read_to_string(folder.path().join(file)).expect("it was written");
        let description = Description::from_file(&file).expect("it is right");
        // The flight meets the boundary conditions.
        let equations = read(format!("{stem}.f90"));
        let start = |k: u32| {
            let line = equations
                .lines()
                .find_map(|line| line.trim().strip_prefix(&format!("PAR({k}) = ")))
                .expect("it is set");
            line.replace('d', "e").parse::<f64>().expect("it is a number")
        };
        let [mu, eta, z, y] = [1, 2, 3, 4].map(start);
        let flight: Vec<Vec<f64>> = read(format!("{stem}.dat"))
            .lines()
            .map(|line| line.split(' ').map(|number| number.parse().expect("it is a number")).collect())
            .collect();
        let (first, last) = (&flight[0], &flight[flight.len() - 1]);
        // The solution is as exact as the integration over several periods.
        let scale = 1e-8 * y.max(1e-3);
        assert_eq!((first[0], first[1], last[0]), (0.0, 0.0, 1.0), "{name}");
        assert!((first[2] + description.restitution(y, z, mu, eta) * y).abs() < scale, "{name}: {first:?}");
        assert!(last[1].abs() < scale && (last[2] - y).abs() < scale, "{name}: {last:?}, y = {y}");
        // The formulas are those of the file.
        let states =
            [[-0.3, 0.2, 0.7, mu, eta, y, z], [-1.1, -0.4, 2.3, 1.1 * mu, 0.9 * eta, 1.3 * y, z + 0.4]];
        let Some(told) = compiled(folder.path(), &stem, &states) else { continue };
        let ours = states.iter().flat_map(|&[u, v, t, mu, eta, y, z]| {
            [
                description.force(u, v, t, mu, eta),
                description.forcing_frequency(mu, eta),
                description.restitution(y, z, mu, eta),
                description.impact_duration(y, z, mu, eta),
            ]
        });
        // Powers and functions of another library differ in the last digits.
        for (told, ours) in told.into_iter().zip(ours) {
            assert!((told - ours).abs() <= 1e-13 * ours.abs().max(1.0), "{name}: {told} {ours}");
        }
    }
}

#[test]
fn without_a_solution_nothing_is_exported() {
    let folder = empty_folder();
    let file = repository().join("examples/duffing.toml").display().to_string();
    let refused = grazing(folder.path(), &["export", &file, "--at", "0.01,0.8"]);
    assert_eq!((refused.code, refused.output.as_str()), (Some(2), ""));
    assert!(refused.errors().contains("--at 0.01,0.8: no admissible solution"), "{}", refused.messages);
    assert!(crate::program::listing(folder.path()).is_empty());
}
