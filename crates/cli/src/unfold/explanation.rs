//! All hypotheses and quantities of the theorems at every resonance.

use std::fmt::Write;

use grazing_input::Description;
use grazing_model::smooth::Purpose;
use grazing_results::brief;
use grazing_theorems::{ResonantPoint, Unfolding};
use grazing_unfold::nothing::place;
use grazing_unfold::unfolded::{AtResonance, Unfolded};

use crate::layout::{KEPT, Layout};

const DIGITS: usize = 9;

/// Hypotheses with their values and quantities, resonance by resonance.
pub(crate) fn all(layout: Layout, description: &Description, unfolded: &Unfolded) -> String {
    unfolded.resonances.iter().map(|at| explained(layout, description, at)).collect()
}

/// The steps of integration by their purpose, in thousands.
pub(crate) fn steps(layout: Layout, counts: impl Iterator<Item = (Purpose, u64)>) -> String {
    let counts: Vec<(Purpose, u64)> = counts.filter(|(_, count)| *count > 0).collect();
    let all: u64 = counts.iter().map(|(_, count)| count).sum();
    let row = |(purpose, count): &(Purpose, u64)| {
        let share = 100.0 * *count as f64 / all as f64;
        vec![purpose.name().to_owned(), format!("{}", count / 1000), format!("{share:.1}")]
    };
    let table = layout.aligned(&["<evaluations of motion for", "thousands", "%"], counts.iter().map(row));
    format!("\n{table}")
}

fn explained(layout: Layout, description: &Description, at: &AtResonance) -> String {
    let AtResonance { loops, n, theorem, .. } = at;
    let answer = if at.curves.is_some() { "applies" } else { "does not apply" };
    let at_place = place(description, at.parameters);
    let heading = format!("p = {loops}, n = {n} at {at_place}: {theorem} {answer}");
    let mut text = format!("\n{}", layout.wrapped("", &heading));
    for hypothesis in &at.hypotheses {
        let word = if hypothesis.holds() { "holds" } else { "FAILS" };
        let (statement, value) = (hypothesis.statement(), brief(hypothesis.value, DIGITS));
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {word}  {statement:24} {value:>16}");
    }
    text.push_str(&layout.wrapped("  where ", &quantities(&at.point)));
    text
}

/// The quantities of section 2, as `tau = -0.5, delta = 0.8`.
fn quantities(point: &ResonantPoint) -> String {
    let grazing = &point.grazing;
    let (a, b) = (grazing.map.a, grazing.map.b);
    let number = |value| brief(value, DIGITS);
    let stability = point.stability_coefficients();
    let Unfolding { loops, derivative } = point.unfolding;
    let slope = if loops == 1 { "a12'" } else { "kappa_p'" };
    let listed: Vec<String> = [
        ("tau", grazing.map.trace()),
        ("delta", grazing.map.determinant()),
        ("alpha", grazing.alpha()),
        ("beta", grazing.map.transversality()),
        ("gamma", grazing.gamma),
        ("phi", grazing.phi),
        ("psi", grazing.psi),
        ("xi_p", point.second_phase_derivative),
        (slope, derivative),
        ("s_p^+", stability.plus),
        ("s_p^-", stability.minus),
    ]
    .into_iter()
    .map(|(name, value)| format!("{name}{KEPT}={KEPT}{}", number(value)))
    .collect();
    let matrix = format!("A = [{}, {}; {}, {}],", number(a.m11), number(a.m12), number(a.m21), number(a.m22));
    let vector = format!("b = [{}; {}],", number(b.x), number(b.y));
    format!("{} {} {}", matrix.replace(' ', KEPT), vector.replace(' ', KEPT), listed.join(", "))
}
