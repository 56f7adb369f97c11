//! The rows for the default parameters: compared with snapshots and with independent computations.

mod elsewhere;
mod fig04;
mod fig05;
mod fig06;
mod fig10;
mod independent;
mod legends;
mod scenes;
mod snapshots;
mod space;

use std::path::Path;
use std::sync::{Arc, LazyLock, OnceLock};

use grazing_beyond::parameters;
use grazing_model::LinearOscillator;
use grazing_reproduction::figures::fig02::Figure2;
use grazing_reproduction::figures::fig07::Figure7;
use grazing_reproduction::figures::fig08::Figure8;
use grazing_reproduction::parameters::Parameters;
use grazing_reproduction::{ComparedCoefficients, Study, TheoremsInAction};
use grazing_results::branches::OneParameter;
use grazing_results::plane::{Magnifications, PlaneDiagram};
use grazing_results::{Cell, Names, Row};
use grazing_trials::closed_form::{ClosedFormOrbit, orbits};

/// All results of the reproduction, computed once for all tests.
pub(crate) struct Made {
    /// The study, which computes each figure once.
    pub(crate) study: Study,
    parameters: Parameters,
    pub(crate) coefficients: Vec<ComparedCoefficients>,
    fig02: Arc<OneParameter>,
    fig07: Arc<PlaneDiagram>,
    fig08: Arc<Magnifications>,
    theorems: TheoremsInAction,
}

pub(crate) fn made() -> &'static Made {
    static MADE: OnceLock<Made> = OnceLock::new();
    MADE.get_or_init(|| {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../figures/parameters.toml");
        let parameters = parameters::from_file(&file, &[]).expect("the default parameters are valid");
        let study = Study::new(&parameters);
        Made {
            coefficients: study.coefficients().expect("all coefficients can be computed").rows.clone(),
            fig02: study.shown::<Figure2>().expect("figure 2 can be computed"),
            fig07: study.shown::<Figure7>().expect("figure 7 can be computed"),
            fig08: study.shown::<Figure8>().expect("figure 8 can be computed"),
            theorems: study.theorems_in_action().expect("all cases can be worked out"),
            parameters,
            study,
        }
    })
}

/// The paper's oscillator, as the theory describes it.
pub(crate) fn theory() -> grazing_theorems::LinearOscillator {
    // The file is read anew for each section that is asked for.
    static THEORY: LazyLock<grazing_theorems::LinearOscillator> =
        LazyLock::new(|| made().parameters.oscillator().expect("it is right"));
    *THEORY
}

/// The paper's oscillator with its forcing.
fn forced(amplitude: f64, frequency: f64) -> LinearOscillator {
    grazing_reproduction::forced(&theory(), amplitude, frequency).expect("it is in the domain")
}

/// All MPSs of the paper's oscillator from the quadratic equation.
fn closed_forms(amplitude: f64, frequency: f64, loops: u32) -> Vec<ClosedFormOrbit> {
    let (zeta, epsilon) = (theory().damping_ratio(), theory().coefficient_of_restitution());
    orbits(zeta, epsilon, amplitude, frequency, loops)
}

/// A column, by its name for the paper's oscillator.
fn column<R: Row>(rows: &[R], name: &str) -> Vec<Cell> {
    let names = Names::of_the_paper();
    let place = R::COLUMNS.iter().position(|column| column.header(&names) == name);
    let place = place.expect("the column is there");
    rows.iter().map(|row| row.cells().swap_remove(place)).collect()
}

/// A column of numbers.
fn numbers<R: Row>(rows: &[R], name: &str) -> Vec<f64> {
    column(rows, name).iter().map(|cell| cell.number().unwrap_or(f64::NAN)).collect()
}

/// A column of integers.
fn integers<R: Row>(rows: &[R], name: &str) -> Vec<u32> {
    let integer =
        |cell| if let Cell::Integer(value) = cell { value } else { panic!("{cell:?} is no integer") };
    column(rows, name).into_iter().map(integer).collect()
}

/// A column of words.
fn words<R: Row>(rows: &[R], name: &str) -> Vec<String> {
    let word =
        |cell| if let Cell::Text(word) = cell { word.into_owned() } else { panic!("{cell:?} is no word") };
    column(rows, name).into_iter().map(word).collect()
}

/// A column of flags.
fn flags<R: Row>(rows: &[R], name: &str) -> Vec<bool> {
    let flag = |cell| if let Cell::Flag(value) = cell { value } else { panic!("{cell:?} is no flag") };
    column(rows, name).into_iter().map(flag).collect()
}
