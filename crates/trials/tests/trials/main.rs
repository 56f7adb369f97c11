//! Short runs of the trials, in which they also have to notice what is wrong, and tests of what the mutation tests need.

mod armed;
mod damped;
mod errors;
mod nonlinear;
mod regions;
mod windows;

use std::sync::LazyLock;

use grazing_input::Description;
use grazing_trials::nonlinear::unfolded;
use grazing_trials::oscillators;
use grazing_unfold::Diagram;

/// The diagram of a random oscillator of seed 1 with a hardening spring.
static DIAGRAM: LazyLock<Diagram> = LazyLock::new(|| {
    let text = oscillators::description(1, 10);
    let description = Description::parse(&text, "random").expect("what is made at random is right");
    unfolded(&description.with_loops(&[1, 2]).expect("they are right")).expect("it grazes")
});
