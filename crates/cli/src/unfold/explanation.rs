//! All that the theorems ask and use at every resonance.

use std::fmt::Write;

use grazing_description::Description;
use grazing_model::ImpactOscillator;
use grazing_model::smooth::Units;
use grazing_results::brief;
use grazing_theorems::Unfolding;
use grazing_theorems::hypothesis::Hypothesis;
use grazing_unfold::resonances::Resonance;
use grazing_unfold::units::InUnits;

use super::analysis::Analysis;
use super::layout::{KEPT, wrapped};
use super::reason::place;

const DIGITS: usize = 9;

/// Hypotheses with their values and quantities, resonance by resonance.
pub(super) fn all(description: &Description, unfolded: &Analysis) -> String {
    let resonances = unfolded.diagram.resonances.iter();
    resonances.map(|resonance| explained(description, resonance, &unfolded.axes.units)).collect()
}

fn explained(description: &Description, resonance: &Resonance, units: &Units) -> String {
    let at = place(description, units.parameters(resonance.located.orbit().oscillator().parameters()));
    let (theorem, hypotheses): (_, &[Hypothesis]) = match &resonance.theorem {
        Ok(point) => (point.theorem().theorem(), point.theorem().hypotheses()),
        Err(violated) => (violated.theorem, &violated.hypotheses),
    };
    let answer = if resonance.theorem.is_ok() { "applies" } else { "does not apply" };
    let mut text = format!("\np = {}, n = {} at {at}: {theorem} {answer}\n", resonance.loops, resonance.n);
    for hypothesis in hypotheses {
        let word = if hypothesis.holds() { "holds" } else { "FAILS" };
        let (statement, value) = (hypothesis.statement(), brief(hypothesis.in_units(units).value, DIGITS));
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {word}  {statement:24} {value:>16}");
    }
    text.push_str(&wrapped("  where ", &quantities(resonance, units)));
    text
}

/// The quantities of section 2, as `tau = -0.5, delta = 0.8`.
fn quantities(resonance: &Resonance, units: &Units) -> String {
    let point = resonance.located.resonant_point().in_units(units);
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
