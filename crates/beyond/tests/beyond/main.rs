//! Compares the rows beyond the paper with independent computations.

mod attractors;
mod generations;
mod loops;
mod proofs;
mod regions;

use std::sync::LazyLock;

use grazing_beyond::parameters;
use grazing_input::Text;
use grazing_reproduction::Study;
use grazing_theorems::LinearOscillator;

/// The study of the default parameters, which computes each figure once for all tests.
fn study() -> &'static Study {
    static STUDY: LazyLock<Study> = LazyLock::new(|| {
        let text = Text::new(include_str!("../../../../figures/parameters.toml"), &[]);
        Study::new(&parameters::parse(&text, "parameters.toml").expect("the default parameters are valid"))
    });
    &STUDY
}

/// The paper's oscillator, as the theory describes it.
fn theory() -> LinearOscillator {
    // The file is read anew for each section that is asked for.
    static THEORY: LazyLock<LinearOscillator> =
        LazyLock::new(|| study().parameters.oscillator().expect("it is right"));
    *THEORY
}
