//! The whole two-parameter diagram of `examples/duffing.toml`, an oscillator whose motion is
//! integrated, on one core.

use core::hint::black_box;
use std::path::Path;

use divan::Bencher;
use grazing_continuation::curve::Window;
use grazing_input::Description;
use grazing_unfold::{Diagram, Scope, progress::Silent};
use rayon::ThreadPoolBuilder;

fn main() {
    divan::main();
}

/// Grazing curve, resonances, bifurcation curves and regions, for the loops in the file.
#[divan::bench(sample_count = 10)]
fn diagram_from_the_text_file(bencher: Bencher<'_, '_>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/duffing.toml");
    let file = Description::from_file(&path).unwrap();
    let window = Window { primary: file.primary().range(), secondary: file.secondary().range() };
    let scope = Scope { window, loops: file.loops().to_vec(), start: None };
    let oscillator = file.oscillator(window.parameters([0.5; 2]));
    let pool = ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    bencher.bench(|| pool.install(|| Diagram::compute(black_box(&oscillator), &scope, &Silent).unwrap()));
}
