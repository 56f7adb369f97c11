//! Tables as other programs write them, to the byte: each says what the same table says in plain form, or is refused with its line.

use std::fs;
use std::path::PathBuf;

use grazing_continuation::bifurcation::Bifurcation;
use grazing_measured::read::{Foreign, Setup, curves, points};

const NAMES: [&str; 2] = ["A", "omega"];

/// A file with this content, in a folder of its own.
fn file(content: &[u8]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let path = folder.path().join("table.csv");
    fs::write(&path, content).expect("the folder is ours");
    (folder, path)
}

/// The places in a file and what was seen there, or the message.
fn read(content: &[u8]) -> Result<Vec<String>, String> {
    let (_folder, path) = file(content);
    let read =
        points(&path, Setup { names: NAMES, two_walls: false }, &[]).map_err(|error| error.to_string());
    read.map(|read| read.iter().map(|one| format!("{:?} {}", one.at, one.seen.words())).collect())
}

/// The lines and places of numbers in a file, with columns by name or number, or the message.
fn numbers(content: &[u8], columns: [&str; 2]) -> Result<Vec<(u32, [f64; 2])>, String> {
    let (_folder, path) = file(content);
    let columns = NAMES.into_iter().zip(columns).map(|(name, column)| (name.to_owned(), column.to_owned()));
    let foreign = Foreign { columns: columns.collect(), curve: Some((Bifurcation::SaddleNode, None)) };
    let read = curves(&path, NAMES, &foreign).map_err(|error| error.to_string());
    read.map(|read| read.iter().map(|one| (one.line, one.at)).collect())
}

/// A text in UTF-16 with its mark.
fn wide(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    format!("\u{feff}{text}").encode_utf16().flat_map(bytes).collect()
}

#[test]
fn tables_of_words_and_numbers_are_read() {
    let plain = read(b"A,omega,seen,p\n0.25,1.5,SN,2\n-0.5,0.00125,none,\n");
    assert_eq!(plain.as_ref().map(Vec::len), Ok(2));
    let excel = "A\tomega\tseen\tp\tBemerkung\r\n0,25\t1,5\tSN\t2\tgrößer\r\n-0,5\t0,00125\tnone\t\t\r\n";
    let semicolons = "A;omega;seen;p;Bemerkung\r\n0,25;1,5;SN;2;\"größer; \"\"heiß\"\"\"\r\n-0,5;1,25E-03;none;;\r\n;;;;\r\n";
    let latin =
        |text: &str| text.chars().map(|letter| u8::try_from(u32::from(letter)).expect("Latin-1")).collect();
    let tables: Vec<(&str, Vec<u8>)> = vec![
        ("Excel, CSV UTF-8 in German", format!("\u{feff}{semicolons}").into()),
        ("Excel, CSV in German", latin(semicolons)),
        ("Excel, Unicode text", wide(excel, u16::to_le_bytes)),
        ("the other order of bytes", wide(excel, u16::to_be_bytes)),
        ("Excel for Macintosh", b"A,omega,seen,p\r0.25,1.5,SN,2\r-0.5,0.00125,none,".to_vec()),
        (
            "a cell of two lines",
            b"A,omega,seen,p,note\n0.25,1.5,SN,2,\"hot,\nthen cold\"\n-0.5,0.00125,none,,\n".to_vec(),
        ),
        ("MATLAB, writetable", b"A,omega,seen,p\n0.25,1.5,SN,2\n-0.5,0.00125,none,NaN\n".to_vec()),
        (
            "R, write.csv",
            b"\"\",\"A\",\"omega\",\"seen\",\"p\"\n\"1\",0.25,1.5,\"SN\",2\n\"2\",-0.5,0.00125,\"none\",NA\n"
                .to_vec(),
        ),
        (
            "R, write.csv2",
            b"\"\";\"A\";\"omega\";\"seen\";\"p\"\n\"1\";0,25;1,5;\"SN\";2\n\"2\";-0,5;0,00125;\"none\";NA\n"
                .to_vec(),
        ),
        (
            "R, write.table",
            b"\"A\" \"omega\" \"seen\" \"p\"\n\"1\" 0.25 1.5 \"SN\" 2\n\"2\" -0.5 0.00125 \"none\" NA\n"
                .to_vec(),
        ),
        ("pandas", b",A,omega,seen,p\n0,0.25,1.5,SN,2.0\n1,-0.5,0.00125,none,\n".to_vec()),
        ("Julia, CSV.jl", b"A,omega,seen,p\n0.25,1.5,SN,2\n-0.5,0.00125,none,missing\n".to_vec()),
        (
            "Mathematica",
            b"\"A\",\"omega\",\"seen\",\"p\"\n0.25,1.5,\"SN\",2\n-0.5,1.25*^-3,\"none\",\"\"\n".to_vec(),
        ),
        (
            "a spreadsheet that says its separator",
            b"sep=;\r\nA;omega;seen;p\r\n0,25;1,5;SN;2\r\n-0,5;0,00125;none;\r\n".to_vec(),
        ),
    ];
    for (program, content) in tables {
        assert_eq!(read(&content), plain, "{program}");
    }
}

#[test]
fn tables_of_numbers_alone_are_read() {
    // Written by the programs themselves; the last row is to show exponents.
    for (program, content, lines) in [
        (
            "numpy.savetxt",
            "2.500000000000000000e-01 1.500000000000000000e+00\nnan nan\n1.000000000000000000e-105 -1.250000000000000000e+10\n",
            [1, 3],
        ),
        (
            "MATLAB and Octave, save -ascii",
            " 2.50000000e-01 1.50000000e+00\n NaN NaN\n 1.00000000e-105 -1.25000000e+10\n",
            [1, 3],
        ),
        (
            "Octave, save -text",
            "# Created by Octave 7.3.0, Sat Nov 28 22:23:03 2026 UTC <a@b>\n# name: x\n# type: matrix\n# rows: 2\n# columns: 2\n 0.25 1.5\n 1e-105 -12500000000\n\n\n",
            [6, 7],
        ),
        ("dlmwrite", "0.25\t1.5\nNaN\tNaN\n1e-105\t-12500000000\n", [1, 3]),
        (
            "Fortran, list-directed",
            "  0.25000000000000000        1.5000000000000000     \n   1.0000000000000000E-105  -12500000000.000000     \n",
            [1, 2],
        ),
        (
            "Fortran, list-directed, decimal='comma'",
            "  0,25000000000000000        1,5000000000000000     \n   1,0000000000000000E-105  -12500000000,000000     \n",
            [1, 2],
        ),
        ("Fortran, 2D16.8", "  0.25000000D+00  0.15000000D+01\n  0.10000000-104 -0.12500000D+11\n", [1, 2]),
        (
            "Fortran, ES16.8 and commas",
            "  2.50000000E-01,  1.50000000E+00\n  1.00000000-105, -1.25000000E+10\n",
            [1, 2],
        ),
        (
            "gnuplot, set table",
            "\n# Curve 0 of 1, 2 points\n# Curve title: \"'a' using 1:2\"\n# x y type\n 0.25  1.5  i\n\n 1e-105 -1.25e+10  i\n",
            [5, 7],
        ),
    ] {
        let expected = Ok(vec![(lines[0], [0.25, 1.5]), (lines[1], [1e-105, -1.25e10])]);
        assert_eq!(numbers(content.as_bytes(), ["1", "2"]), expected, "{program}");
    }
    let named = b"# A omega\n2.500000000000000000e-01 1.500000000000000000e+00\n";
    assert_eq!(numbers(named, NAMES), Ok(vec![(2, [0.25, 1.5])]), "numpy.savetxt with a header");
}

/// A diagram of AUTO-07p with two branches.
const AUTO: &str = "\
   0   0.00000000E+00   1.00000000E+00   0.00000000E+00   1.00000000E+02
   0     EPSL=   0.1000E-06  EPSU =   0.1000E-06  EPSS =   0.1000E-04
   0     DS  =   0.1000E-01  DSMIN=   0.1000E-02  DSMAX=   0.1000E+00
   0   User-specified parameter:       'A'
   0   Active continuation parameter:  'A'
   0
   0    PT  TY  LAB        A              L2-NORM          omega
   1     1   9    1   2.50000000E-01   3.27265000E+00   1.50000000E+00
   1    -2   0    0   5.00000000E-01   3.27000000E+00   1.25000000E+00
   0
   0    PT  TY  LAB        A              L2-NORM          omega
   2     1   5    3   1.00000000-105   1.00000000E+00  -1.25000000E+10
";

#[test]
fn the_heads_of_auto_are_no_rows() {
    let expected = Ok(vec![(8, [0.25, 1.5]), (9, [0.5, 1.25]), (12, [1e-105, -1.25e10])]);
    assert_eq!(numbers(AUTO.as_bytes(), NAMES), expected);
    assert_eq!(numbers(AUTO.as_bytes(), ["5", "7"]), expected);
    // In other files a row may begin with zero.
    assert_eq!(
        numbers(b"0 0.25 1.5\n1 0.5 1.25\n", ["2", "3"]),
        Ok(vec![(1, [0.25, 1.5]), (2, [0.5, 1.25])])
    );
}

#[test]
fn what_could_mean_two_things_is_refused_with_its_line() {
    for (why, content, parts) in [
        ("thousands", "A,omega,seen\n\"1,250\",2,none\n", vec!["table.csv:2", "column A", "`1,250`"]),
        (
            "thousands and a decimal comma",
            "A;omega;seen\n1.250,5;2;none\n",
            vec!["table.csv:2", "column A", "`1.250,5`"],
        ),
        (
            "numbers that run together",
            "A omega seen\n-0.5E+00-0.25E+01 none\n",
            vec!["table.csv:2", "2 cells", "3 columns"],
        ),
        ("a repeat count of Fortran", "A omega seen\n2*0.25 none\n", vec!["table.csv:2", "2 cells"]),
        (
            "stars where a number had no room",
            "A omega seen\n****** 1.5 none\n",
            vec!["table.csv:2", "column A", "`******`"],
        ),
        ("names of rows without marks", "A omega seen\n1 0.25 1.5 none\n", vec!["table.csv:2", "4 cells"]),
        ("a missing cell", "A,omega,seen\n0.25,none\n", vec!["table.csv:2", "2 cells"]),
        (
            "a mark that is not closed",
            "A,omega,seen,note\n1,2,none,\"hot\n2,2,none,cold\n",
            vec!["table.csv:2", "quotation mark"],
        ),
        (
            "a number with its unit",
            "A,omega,seen\n0.25 N,1.5,none\n",
            vec!["table.csv:2", "column A", "`0.25 N`"],
        ),
    ] {
        let message = read(content.as_bytes()).expect_err(why);
        parts.iter().for_each(|part| assert!(message.contains(part), "{why}: {part}: {message}"));
    }
    for (why, content) in [
        ("a workbook", &b"PK\x03\x04\x14\0\x06\0\x08\0\0\0!\0\xa4\x9d"[..]),
        ("half a letter in UTF-16", b"\xff\xfeA\0,"),
        ("half a pair in UTF-16", b"\xff\xfe\0\xd8"),
    ] {
        let message = read(content).expect_err(why);
        assert!(
            message.contains("table.csv: cannot be read: it is not text: save its table as CSV"),
            "{message}"
        );
    }
}
