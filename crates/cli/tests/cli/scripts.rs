//! `examples/scripts/figure7.m`, run in Octave. (`figure7.jl` is not run, which it states.)

use std::fs;
use std::io::{self, Write};
use std::process::Command;

use crate::program::{empty_folder, repository};

#[test]
fn octave_draws_figure_7_and_finds_the_coefficients_on_its_curves() {
    let folder = empty_folder();
    let picture = folder.path().join("fig07.svg");
    let run = Command::new("octave-cli")
        .args(["--norc", "--path"])
        .arg(repository().join("examples/scripts").canonicalize().expect("it is there"))
        .args(["--eval", &format!("figure7('{}')", picture.display())])
        .output();
    let run = match run {
        Ok(run) => run,
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            // Written directly to the stream, which the test harness does not capture.
            writeln!(io::stderr(), "SKIPPED: there is no Octave, examples/scripts/figure7.m was not run")
                .expect("a message can be written");
            return;
        }
        Err(error) => panic!("Octave could not be started: {error}"),
    };
    let text = String::from_utf8(run.stdout).expect("it is text");
    assert!(run.status.success(), "{text}{}", String::from_utf8_lossy(&run.stderr));

    let data = repository().join("figures/data");
    let rows = |name: &str| {
        let text = fs::read_to_string(data.join(name)).expect("it is there");
        text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect::<Vec<Vec<_>>>()
    };
    // The columns are p, n, omega*, c_SN, its value from the curve, c_PD, its value from the curve.
    let mut lines = text.lines();
    let grazing = lines.next().expect("there is a first line");
    let distance = grazing.split_whitespace().rev().nth(2).expect("it says how far");
    assert!(distance.parse::<f64>().expect("it is a number") < 1e-14, "{grazing}");
    let shown: Vec<Vec<f64>> = lines
        .skip(1)
        .map(|line| line.split_whitespace().map(|number| number.parse().expect("a number")).collect())
        .collect();
    let coefficients = rows("coefficients.csv");
    assert_eq!(shown.len(), coefficients.len(), "{text}");
    for (shown, row) in shown.iter().zip(coefficients) {
        // As many digits as are printed; a cubic through points of the figure gives fewer.
        for (column, cell, digits) in
            [(0, 0, 1e-15), (1, 1, 1e-15), (3, 8, 1e-6), (4, 8, 1e-5), (5, 9, 1e-6), (6, 9, 1e-5)]
        {
            let told: f64 = row[cell].parse().expect("a number");
            assert!((shown[column] - told).abs() <= digits * told.abs(), "{told}, but: {shown:?}");
        }
    }
    // Every region is filled, and so is the background.
    let svg = fs::read_to_string(picture).expect("it was drawn");
    let mut regions: Vec<_> =
        rows("fig07_regions.csv").into_iter().map(|row| (row[0].clone(), row[6].clone())).collect();
    regions.dedup();
    assert!(svg.matches("<polygon").count() >= regions.len(), "{} regions", regions.len());
}
