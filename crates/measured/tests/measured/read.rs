//! Files of measurements, and messages about mistakes in them.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_measured::read::{Foreign, Setup, curves_of, points_of, record_of};

const NAMES: [&str; 2] = ["A", "omega"];
const ONE: Setup<'_> = Setup { names: NAMES, two_walls: false };
const TWO: Setup<'_> = Setup { names: NAMES, two_walls: true };

fn refused(text: &str) -> String {
    points_of(text, "rig.csv", ONE, &[]).unwrap_err().to_string()
}

#[test]
fn places_are_read_as_they_are_written() {
    let text = "\u{feff}# a rig\nomega, A ,A_error,seen,periods,impacts,p\n0.8,0.25,0.01,none,,,\n\n\
                0.8,\"0.3\",,periodic,6,3,\n0.8,0.4,0,SN,,,2\r\n0.8,0.5,,irregular,,,\n";
    let (read, columns) = points_of(text, "rig.csv", ONE, &[]).unwrap();
    assert_eq!(columns, ["omega", "A", "A_error", "seen", "periods", "impacts", "p"]);
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

/// The places and what was seen there.
fn read(text: &str) -> Vec<(f64, f64, String)> {
    let (read, _) = points_of(text, "rig.csv", ONE, &[]).unwrap_or_else(|error| panic!("{error}"));
    read.iter().map(|one| (one.at[0], one.at[1], one.seen.words())).collect()
}

#[test]
fn files_of_other_programs_say_what_the_same_file_says_in_plain_form() {
    let plain = read("A,omega,seen,p\n0.25,1.5,SN,2\n0.5,1.25,none,\n");
    for text in [
        // Quotation marks, also around separators, marks and the end of a line.
        "\"A\",\"omega\",\"seen\",\"p\",\"note\"\n0.25,1.5,SN,2,\"new belt, \"\"hot\"\"\"\n0.5,1.25,none,,\"two\nlines\"\n",
        // Other separators, decimal commas, and ends of lines.
        "A;omega;seen;p\n0.25;1.5;SN;2\n0.5;1.25;none;\n",
        "A;omega;seen;p\n0,25;1,5;SN;2\n0,5;1,25;none;\n",
        "sep=;\r\nA;omega;seen;p\r\n0,25;1,5;SN;2\r\n0,5;1,25;none;\r\n",
        "A,omega,seen,p\n\"0,25\",\"1,5\",SN,2\n\"0,5\",\"1,25\",none,\n",
        "A\tomega\tseen\tp\n0.25\t1.5\tlimit point\t2\n0.5\t1.25\tnone\t\n",
        "  A   omega seen  p\n0.25  1.5   \"limit point\" 2\n 0.5   1.25 none NaN\n",
        "A,omega,seen,p\r0.25,1.5,SN,2\r0.5,1.25,none,\r",
        "A,omega,seen,p,\n0.25,1.5,SN,2,\n0.5,1.25,none,,\n",
        // Comments, names in one, and what separates curves.
        "% a rig\n  % A;B\nA,omega,seen,p\n0.25,1.5,SN,2\n% more\n0.5,1.25,none,\n",
        "% A,omega,seen,p\n0.25,1.5,SN,2\n0.5,1.25,none,\n",
        "A,omega,seen,p\n0.25,1.5,SN,2\nNaN,nan,SN,2\n,,,\n\n \t\nNA,NA,,\n0.5,1.25,none,\n",
        // Numbers of Fortran and others.
        "A,omega,seen,p\n2.5D-01,0.15d+1,SN,2.0\n+.5,12.5-001,none,\n",
        "A,omega,seen,p\n2.5*^-1,1.5e0,SN,+2\n5.E-1,1.25E+000,none,nan\n",
        // Capitals, other names, other columns.
        "P,Omega,a,Seen,run\n2,1.5,0.25,Fold,7\n,1.25,0.5,None,8\n",
        "A,omega,seen,p\n0.25,1.5,Saddle-Node,2\n0.5,1.25,NONE,\n",
    ] {
        assert_eq!(read(text), plain, "{text}");
    }
    // A minus sign of typography, and an exponent that left no room for its letter.
    assert_eq!(read("A,omega,seen\n\u{2212}1.5,1.23-101,none\n")[0].0, -1.5);
    assert_eq!(read("A,omega,seen\n\u{2212}1.5,1.23-101,none\n")[0].1, 1.23e-101);
}

#[test]
fn words_of_other_programs_are_understood_and_those_with_two_meanings_are_not() {
    let kind = |word: &str| read(&format!("A,omega,seen,p\n1,2,{word},2\n"))[0].2.clone();
    for (words, name) in [
        (&["LP", "lp", "limit point", "Limit_Point", "fold", "LPC", "saddle-node"][..], "SN of p = 2"),
        (&["PD", "period doubling", "Period-Doubling", "flip"], "PD of p = 2"),
        (&["TR", "torus", "Neimark-Sacker"], "NS of p = 2"),
        (&["gz", "interior grazing"], "GZ of p = 2"),
        (&["GRAZ", "non-impacting grazing"], "graz"),
        (&["pitchfork"], "PF of p = 2"),
    ] {
        words.iter().for_each(|word| assert_eq!(kind(word), name, "{word}"));
    }
    let periodic = read("A,omega,seen,periods,impacts\n1,2,Periodic,2,1\n2,2,IRREGULAR,,\n");
    assert_eq!((&*periodic[0].2, &*periodic[1].2), ("1 impact in 2 periods", "irregular"));
}

#[test]
fn columns_without_a_header_are_known_by_their_numbers() {
    let read = |text: &str, columns: &[(&str, &str)]| {
        let columns = columns.iter().map(|(name, column)| [name, column].map(|it| (*it).to_owned()).into());
        let foreign = Foreign { columns: columns.collect(), curve: Some((Bifurcation::SaddleNode, None)) };
        let read = curves_of(text, "curve.csv", NAMES, &foreign).map_err(|error| error.to_string());
        read.map(|read| read.iter().map(|one| (one.line, one.at)).collect::<Vec<_>>())
    };
    let numbers = [("A", "1"), ("omega", "2")];
    let expected = Ok(vec![(1, [0.5, 1.25]), (3, [0.25, 1.5])]);
    for text in [
        "0.5,1.25\nNaN,NaN\n0.25,1.5\n",
        "0.5;1.25\n\n0.25;1.5\n",
        "0,5;1,25\n\n0,25;1,5\n",
        "0,5 1,25\n\n0,25 1,5\n",
        "  5.0D-01  1.25D+00\n\n  2.5D-01  1.50D+00\n",
        "0.5\t1.25\tnear a fold\n\n0.25\t1.5\t\n",
        "0.5, 1.25\r\r0.25, 1.5",
    ] {
        assert_eq!(read(text, &numbers), expected, "{text}");
    }
    // A header is left out, and the other way round is one.
    assert_eq!(read("x,y\n0.5,1.25\n\n", &numbers), Ok(vec![(2, [0.5, 1.25])]));
    assert_eq!(read("1.25,0.5\n", &[("omega", "1"), ("A", "2")]), Ok(vec![(1, [0.5, 1.25])]));
    for (text, columns, parts) in [
        ("0,1;1,0\n0,2;1,0\n", &[("A", "1"), ("omega", "3")][..], vec!["curve.csv:1", "`1;1`", "commas"]),
        ("0.5,1.25\n", &[("A", "0"), ("omega", "2")], vec!["curve.csv:1", "no column 0", "2 cells"]),
        ("0.5,1.25\n", &[("A", "1"), ("omega", "3")], vec!["curve.csv:1", "no column 3", "2 cells"]),
        ("0.5,1.25\n", &[("A", "1"), ("omega", "1")], vec!["column 1", "both A and omega"]),
        ("0.5,1.25\n", &[("A", "1")], vec!["column omega is missing"]),
        ("0.5,1.25\n0.6,x\n", &numbers, vec!["curve.csv:2", "column 2 should hold omega", "`x`"]),
        ("0.5,1.25\n", &[], vec!["curve.csv:1", "holds numbers", "--column NAME=1"]),
    ] {
        let message = read(text, columns).unwrap_err();
        parts.iter().for_each(|part| assert!(message.contains(part), "{part}: {message}"));
    }
}

#[test]
fn mistakes_are_named_with_file_line_column_value_and_remedy() {
    for (text, parts) in [
        ("", vec!["rig.csv: it is empty"]),
        ("A,omega,seen\n", vec!["no measurement"]),
        ("1,2,none\n", vec!["rig.csv:1", "holds numbers", "A,omega,seen"]),
        ("A,omega,seen\n1,2,none\n2,2,\"none\n3,2,none\n", vec!["rig.csv:3", "quotation mark"]),
        ("A,omega,seen,note\n1,2,none,\"hot\n2,2,none,hot\"\n", vec!["rig.csv:2", "quotation mark"]),
        ("A,omega,seen,note\n1,2,none,\"a \"hot\" belt\"\n", vec!["rig.csv:2", "cell 4", "twice"]),
        ("A;omega;seen\n1,250;2;none\n", vec!["rig.csv:2", "column A", "`1,250`", "with a point"]),
        ("A;omega;seen\n1,25;2.5;none\n", vec!["rig.csv:2", "column A", "`1,25`"]),
        ("A omega seen\n1 2 limit point\n", vec!["rig.csv:2", "4 cells", "by blanks"]),
        ("A,omega,seen\nNaN,2,SN\n", vec!["rig.csv:2", "column A", "`NaN`"]),
        ("A,omega,seen\n,,SN\n", vec!["rig.csv:2", "column A", "nothing"]),
        ("A,omega,seen\n1.0E,2,SN\n", vec!["rig.csv:2", "`1.0E`"]),
        ("A,omega,seen\n1,2,grazing\n", vec!["rig.csv:2", "`grazing`", "graz", "GZ"]),
        ("A,omega,seen\n1,2,BP\n", vec!["rig.csv:2", "`BP`"]),
        ("A,omega,Seen,SEEN\n1,2,none,none\n", vec!["rig.csv:1", "Seen", "twice"]),
        ("A,omega,seen,peroids\n1,2,none,1\n", vec!["rig.csv:1", "unknown column peroids", "`periods`"]),
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
    assert!(points_of(&rows(10_000), "rig.csv", ONE, &[]).is_ok());
}

#[test]
fn impacts_fall_into_series_in_the_order_of_time() {
    let head = "A,omega,series,time,velocity_before,velocity_after,time_error,velocity_error\n";
    let read = |rows: &str| record_of(&format!("{head}{rows}"), "rig.csv", ONE, &[]);
    let series = read("1,2,a,0,0.5,0.4,1e-3,1e-2\n1,2,a,3,0.6,,1e-3,1e-2\n1,2,b,1,0.5,,1e-3,1e-2\n").unwrap();
    assert_eq!(series.iter().map(|one| one.impacts.len()).collect::<Vec<_>>(), [2, 1]);
    assert!(series[0].impacts[1].values[2].is_nan());
    let series = read("1,2,a,0,0.5,,,nan\n").unwrap();
    assert!(series[0].impacts[0].errors.iter().all(|error| error.is_nan()));
    let error = read("1,2,a,3,0.5,,1e-3,1e-2\n1,2,a,0,0.6,,1e-3,1e-2\n").unwrap_err().to_string();
    assert!(error.contains("rig.csv:3: column time: `0`"), "{error}");
    let error = read("1,2,a,3,-0.5,,1e-3,1e-2\n").unwrap_err().to_string();
    assert!(error.contains("velocity_before: `-0.5`") && error.contains("positive"), "{error}");
}

#[test]
fn columns_of_measurements_are_named_or_numbered_as_those_of_another_program() {
    let renamed = |pairs: &[(&str, &str)]| -> Vec<(String, String)> {
        pairs.iter().map(|(name, column)| ((*name).to_owned(), (*column).to_owned())).collect()
    };
    let plain = points_of("A,omega,seen,p\n0.5,0.9,SN,2\n", "rig.csv", ONE, &[]).unwrap().0;
    let called = renamed(&[("A", "drive"), ("seen", "what")]);
    let read = points_of("drive,omega,what,p\n0.5,0.9,SN,2\n", "rig.csv", ONE, &called).unwrap().0;
    assert_eq!(read, plain);
    let numbered = renamed(&[("A", "3"), ("omega", "1"), ("seen", "2"), ("p", "4")]);
    let mut read = points_of("0.9,SN,0.5,2\n", "rig.csv", ONE, &numbered).unwrap().0;
    // Without a header the row is one line higher.
    read.iter_mut().for_each(|point| point.line += 1);
    assert_eq!(read, plain);
    let impacts = "A,omega,time,velocity_before\n0.5,0.9,1.0,0.3\n0.5,0.9,8.0,0.4\n";
    let plain = record_of(impacts, "rig.csv", ONE, &[]).unwrap();
    let called = renamed(&[("time", "t"), ("velocity_before", "v")]);
    let text = impacts.replace("time", "t").replace("velocity_before", "v");
    // What was not measured is NaN, which equals nothing.
    let read = record_of(&text, "rig.csv", ONE, &called).unwrap();
    assert_eq!(format!("{read:?}"), format!("{plain:?}"));
    let unknown = points_of("A,omega,seen\n", "rig.csv", ONE, &renamed(&[("weight", "A")])).unwrap_err();
    assert!(unknown.to_string().contains("weight"), "{unknown}");
}

#[test]
fn walls_are_read_as_the_oscillator_has_them() {
    let points = |setup, rows: &str| {
        points_of(&format!("A,omega,seen,p,wall\n{rows}"), "rig.csv", setup, &[])
            .map_err(|error| error.to_string())
    };
    let (read, _) = points(TWO, "1,2,SN,1,1\n1,2,SN,1,2.0\n1,2,PF,,1-2\n1,2,graz,,\n1,2,none,,\n").unwrap();
    let seen: Vec<String> = read.iter().map(|one| one.seen.words()).collect();
    assert_eq!(
        seen,
        ["SN of p = 1 at wall 1", "SN of p = 1 at wall 2", "PF at both walls", "graz", "no impacts"]
    );
    let (read, _) = points(ONE, "1,2,SN,1,1\n").unwrap();
    assert_eq!(read[0].seen.words(), "SN of p = 1");
    let record = |setup, head: &str, rows: &str| {
        let text = format!("A,omega,time,velocity_before{head}\n{rows}");
        record_of(&text, "rig.csv", setup, &[]).map_err(|error| error.to_string())
    };
    let walls = |series: &[grazing_measured::ImpactRecord]| {
        series.iter().flat_map(|one| &one.impacts).map(|impact| impact.wall).collect::<Vec<_>>()
    };
    assert_eq!(walls(&record(TWO, ",wall", "1,2,0,0.5,2\n1,2,3,0.5,1\n").unwrap()), [2, 1]);
    assert_eq!(walls(&record(ONE, ",wall", "1,2,0,0.5,\n1,2,3,0.5,1\n").unwrap()), [1, 1]);
    assert_eq!(walls(&record(ONE, "", "1,2,0,0.5\n").unwrap()), [1]);
    for (refused, parts) in [
        (
            points(ONE, "1,2,SN,1,2\n").map(|_| ()),
            vec!["rig.csv:2: column wall: `2`", "one wall", "leave the column out"],
        ),
        (points(TWO, "1,2,SN,1,3\n").map(|_| ()), vec!["rig.csv:2: column wall: `3`", "1-2"]),
        (record(TWO, "", "1,2,0,0.5\n").map(|_| ()), vec!["rig.csv:1", "wall is missing"]),
        (
            record(TWO, ",wall", "1,2,0,0.5,1\n1,2,3,0.5,\n").map(|_| ()),
            vec!["rig.csv:3: column wall: nothing", "1 or 2"],
        ),
        (
            record(TWO, ",wall", "1,2,0,0.5,1-2\n").map(|_| ()),
            vec!["rig.csv:2: column wall: `1-2`", "1 or 2"],
        ),
        (record(ONE, ",wall", "1,2,0,0.5,2\n").map(|_| ()), vec!["rig.csv:2: column wall: `2`", "one wall"]),
    ] {
        let told = refused.unwrap_err();
        parts.iter().for_each(|part| assert!(told.contains(part), "{part}: {told}"));
    }
}
