//! The frames of the default parameters: held fixed by snapshots, and against routes that share nothing with them.

mod fig04;
mod fig05;
mod fig06;
mod fig10;
mod independent;
mod snapshots;

use std::path::Path;
use std::sync::OnceLock;

use grazing_reproduction::parameters::Parameters;
use grazing_reproduction::{Figure2, Figure7, Figure8, Study, Table, TheoremsInAction};

/// Everything that is reproduced, computed once for all tests.
struct Made {
    parameters: Parameters,
    coefficients: Table,
    fig02: Figure2,
    fig07: Figure7,
    fig08: Figure8,
    theorems: TheoremsInAction,
}

fn made() -> &'static Made {
    static MADE: OnceLock<Made> = OnceLock::new();
    MADE.get_or_init(|| {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures/parameters.toml");
        let parameters = Parameters::from_file(&file).expect("the default parameters are valid");
        let study = Study::new(&parameters);
        Made {
            coefficients: study.coefficient_table().expect("all coefficients can be computed"),
            fig02: study.fig02().expect("figure 2 can be computed"),
            fig07: study.fig07().expect("figure 7 can be computed"),
            fig08: study.fig08().expect("figure 8 can be computed"),
            theorems: study.theorems_in_action().expect("all cases can be worked out"),
            parameters,
        }
    })
}

/// A column of numbers; empty cells are NaN.
fn numbers(table: &Table, column: &str) -> Vec<f64> {
    let column = table.frame.column(column).expect("the column is there");
    let column = column.f64().expect("it holds numbers");
    column.iter().map(|cell| cell.unwrap_or(f64::NAN)).collect()
}

/// A column of integers.
fn integers(table: &Table, column: &str) -> Vec<u32> {
    let column = table.frame.column(column).expect("the column is there");
    column.u32().expect("it holds integers").iter().flatten().collect()
}

/// A column of words.
fn words(table: &Table, column: &str) -> Vec<String> {
    let column = table.frame.column(column).expect("the column is there");
    column.str().expect("it holds words").iter().flatten().map(str::to_owned).collect()
}

/// A column of flags.
fn flags(table: &Table, column: &str) -> Vec<bool> {
    let column = table.frame.column(column).expect("the column is there");
    column.bool().expect("it holds flags").iter().flatten().collect()
}
