//! Files of measurements, and messages about mistakes in them.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_measured::read::{Foreign, curves_of, points_of, record_of};

const NAMES: [&str; 2] = ["A", "omega"];

fn refused(text: &str) -> String {
    points_of(text, "rig.csv", NAMES).unwrap_err().to_string()
}

#[test]
fn places_are_read_as_they_are_written() {
    let text = "\u{feff}# a rig\nomega, A ,A_error,seen,periods,impacts,p\n0.8,0.25,0.01,none,,,\n\n\
                0.8,\"0.3\",,periodic,6,3,\n0.8,0.4,0,SN,,,2\r\n0.8,0.5,,irregular,,,\n";
    let read = points_of(text, "rig.csv", NAMES).unwrap();
    let seen: Vec<String> = read.iter().map(|one| format!("{} {}", one.line, one.seen.words())).collect();
    assert_eq!(seen, ["3 no impacts", "5 3 impacts in 6 periods", "6 SN of p = 2", "7 irregular"]);
    assert_eq!((read[0].at, read[0].errors), ([0.25, 0.8], [0.01, 0.0]));
}

#[test]
fn columns_of_another_program_are_found_by_the_names_that_are_given() {
    let foreign = |columns: &[(&str, &str)]| Foreign {
        columns: columns
            .iter()
            .map(|(name, column)| [name, column].map(|it| (*it).to_owned()).into())
            .collect(),
        curve: Some((Bifurcation::SaddleNode, Some(2))),
    };
    let text = "freq,A,amp,T\n0.8,99,0.25,3\n";
    let read = |columns| curves_of(text, "curve.csv", NAMES, &foreign(columns));
    let found = read(&[("omega", "freq"), ("A", "amp")]).unwrap();
    assert_eq!((found[0].at, found[0].seen.words()), ([0.25, 0.8], "SN of p = 2".to_owned()));
    for (columns, part) in [
        (&[("omga", "freq")][..], "no column can be called omga: did you mean `omega`?"),
        (&[("omega", "frequency")], "curve.csv:1: it has no column frequency, which should hold omega"),
        (&[("A", "amp")], "the column omega is missing"),
    ] {
        let message = read(columns).unwrap_err().to_string();
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn mistakes_are_named_with_file_line_column_value_and_remedy() {
    for (text, parts) in [
        ("", vec!["rig.csv: it is empty"]),
        ("A,omega,seen\n", vec!["no measurement"]),
        ("A;omega;seen\n1;2;none\n", vec!["rig.csv:1", "separated by commas"]),
        ("A,omga,seen\n", vec!["rig.csv:1", "unknown column omga", "omega"]),
        ("A,omega,A,seen\n", vec!["A appears twice"]),
        ("A,seen\n1,none\n", vec!["rig.csv:1", "omega is missing"]),
        ("A,omega,seen\n1,2,none\n0,5,2,none\n", vec!["rig.csv:3", "4 cells", "3 columns", "point"]),
        ("A,omega,seen\n1,inf,none\n", vec!["rig.csv:2", "column omega", "`inf`", "as 0.25"]),
        ("A,omega,seen,A_error\n1,2,none,-1\n", vec!["A_error", "`-1`", "not negative"]),
        ("A,omega,seen\n1,2,chaos\n", vec!["column seen", "`chaos`", "irregular"]),
        ("A,omega,seen,periods\n1,2,periodic,2\n", vec!["column impacts", "nothing"]),
        ("A,omega,seen,periods\n1,2,none,0.5\n", vec!["column periods", "`0.5`", "whole number"]),
        ("A,omega,seen,impacts\n1,2,none,3\n", vec!["column impacts", "`3`"]),
    ] {
        let told = refused(text);
        parts.iter().for_each(|part| assert!(told.contains(part), "{part}: {told}"));
    }
    let rows = |count: usize| format!("A,omega,seen\n{}", "1,2,none\n".repeat(count));
    assert!(refused(&rows(10_001)).contains("at most 10000"));
    assert!(points_of(&rows(10_000), "rig.csv", NAMES).is_ok());
}

#[test]
fn impacts_fall_into_series_in_the_order_of_time() {
    let head = "A,omega,series,time,velocity_before,velocity_after,time_error,velocity_error\n";
    let read = |rows: &str| record_of(&format!("{head}{rows}"), "rig.csv", NAMES);
    let series = read("1,2,a,0,0.5,0.4,1e-3,1e-2\n1,2,a,3,0.6,,1e-3,1e-2\n1,2,b,1,0.5,,1e-3,1e-2\n").unwrap();
    assert_eq!(series.iter().map(|one| one.impacts.len()).collect::<Vec<_>>(), [2, 1]);
    assert!(series[0].impacts[1].values[2].is_nan());
    let error = read("1,2,a,3,0.5,,1e-3,1e-2\n1,2,a,0,0.6,,1e-3,1e-2\n").unwrap_err().to_string();
    assert!(error.contains("rig.csv:3: column time: `0`"), "{error}");
    let error = read("1,2,a,3,-0.5,,1e-3,1e-2\n").unwrap_err().to_string();
    assert!(error.contains("velocity_before: `-0.5`") && error.contains("positive"), "{error}");
}
