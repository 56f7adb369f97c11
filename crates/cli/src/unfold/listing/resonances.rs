//! Lines about resonances, the coefficients of the curves that leave them, and where theorem and curve contradict each other.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_input::Description;
use grazing_results::{brief, with_unit};
use grazing_unfold::nothing::place;
use grazing_unfold::resonances::STAGE;
use grazing_unfold::unfolded::{AtResonance, CurveFinding, Unfolded, curves};
use grazing_unfold::verdict::Verdict;
use grazing_unfold::verification::Simulated;

use super::gaps::few;
use super::{PARAMETER, QUANTITY, loops, parameter_heads};
use crate::layout::{KEPT, Layout};
use crate::unfold::numbers::{fixed, significant};

/// Digits of coefficients.
const COEFFICIENT: usize = 9;

/// Resonances at which a theorem holds, and the coefficients there.
pub(super) fn resonances(layout: Layout, description: &Description, unfolded: &Unfolded) -> String {
    let (primary, secondary) = (description.primary().name(), description.secondary().name());
    let [secondary_head, primary_head] = parameter_heads(description);
    let all = &unfolded.resonances;
    if all.is_empty() {
        let loops = loops(description);
        let searched = !unfolded.diagram.unfinished.iter().any(|part| part.stage == STAGE);
        let found = if searched { "none on the grazing curve" } else { "the search was not finished" };
        return format!("\nResonant grazing bifurcations\n  {found} for p = {loops}\n");
    }
    let found: Vec<&AtResonance> = all.iter().filter(|at| at.curves.is_some()).collect();
    let heading = format!(
        "Resonant grazing bifurcations: {}; Theorem 2.4 (p = 1) or 2.5 (p >= 2) applies at {} of them",
        all.len(),
        found.len()
    );
    let mut text = format!("\n{}", layout.wrapped("", &heading));
    if found.is_empty() {
        return text;
    }
    let rows = found.iter().map(|at| {
        let ([mu, eta], grazing) = (at.parameters, &at.point.grazing);
        let mut row = vec![at.loops.to_string(), at.n.to_string()];
        row.extend([eta, mu].map(|value| significant(value, PARAMETER)));
        // Where p = 2, tau is zero but for rounding.
        row.extend([grazing.map.trace(), grazing.map.determinant()].map(|value| fixed(value, QUANTITY)));
        row.extend([grazing.alpha(), grazing.map.transversality()].map(|value| significant(value, QUANTITY)));
        row
    });
    let names = &unfolded.axes.names;
    let beta = with_unit("beta", names.named_unit("length/{primary}").as_deref());
    let header = ["p", "n", &secondary_head, &primary_head, "tau", "delta", "alpha", &beta];
    text.push_str(&layout.aligned(&header, rows));
    text.push('\n');
    let formula = format!("{primary} = {primary}_graz({secondary}) + c eta^2 + ...,").replace(' ', KEPT);
    let content = format!(
        "{formula} where eta is {secondary} minus its value at the resonance; digits: how many of both values of c agree; \
         simulation: whether it agrees with the theorem"
    );
    text.push_str(&layout.wrapped("SN and PD curves:  ", &content));
    let unit_of_c = names.named_unit("{primary}/{secondary}^2");
    let [theorem, measured] = ["c (theorem)", "c (measured)"].map(|head| match &unit_of_c {
        Some(unit) => head.replace(')', &format!(", {unit})")),
        None => head.to_owned(),
    });
    let header = ["p", "n", &secondary_head, "curve", &theorem, &measured, "digits", "simulation"];
    text.push_str(&layout.aligned(&header, curves(all).map(coefficient)));
    text.extend(curves(all).map(|curve| reasons(layout, secondary, curve)));
    text
}

/// An SN or PD curve with what is known of it, and the resonance that it leaves.
type CurveAt<'a> = (&'a AtResonance, Bifurcation, &'a CurveFinding);

/// Why a coefficient was not measured or simulation is not as predicted; nothing if all is well.
fn reasons(layout: Layout, secondary: &str, (at, kind, known): CurveAt<'_>) -> String {
    let mark = format!(
        "  p = {}, n = {}, {secondary} = {}, {}:  ",
        at.loops,
        at.n,
        significant(at.parameters[1], QUANTITY),
        kind.name()
    );
    known.doubts().map(|(doubt, reason)| layout.wrapped(&mark, &format!("{doubt}: {reason}"))).collect()
}

/// A sentence for every coefficient and simulation that contradicts the theorem.
pub(crate) fn contradictions(resonances: &[AtResonance]) -> Vec<String> {
    let mut found = Vec::new();
    for (at, kind, CurveFinding { coefficient, simulated }) in curves(resonances) {
        let what = format!("p = {}, n = {}", at.loops, at.n);
        if let (Verdict::Contradict, Ok(fit)) = (coefficient.verdict(), &coefficient.fit) {
            let number = |value: f64| brief(value, COEFFICIENT);
            found.push(format!(
                "{what}: c_{} is {} by the theorem (error {:.0e}) but {} on the continued curve (error {:.0e})",
                kind.name(),
                number(coefficient.theorem.value),
                coefficient.theorem.error,
                number(fit.coefficient.value),
                fit.coefficient.error
            ));
        }
        if let Simulated::Against(sides) = simulated {
            found.push(format!("{what}: beside the {} curve, {sides}", kind.name()));
        }
    }
    found
}

/// The row of a coefficient: by the theorem, measured, and whether simulation agrees.
fn coefficient((at, kind, CurveFinding { coefficient, simulated }): CurveAt<'_>) -> Vec<String> {
    let theorem = coefficient.theorem.value;
    let (measured, digits) = match coefficient.compared() {
        Some((value, digits)) => (significant(value, COEFFICIENT), digits.to_string()),
        None => (coefficient.verdict().name().to_owned(), "-".to_owned()),
    };
    vec![
        at.loops.to_string(),
        at.n.to_string(),
        // Enough to tell resonances with the same p and n apart.
        significant(at.parameters[1], QUANTITY),
        kind.name().to_owned(),
        significant(theorem, COEFFICIENT),
        measured,
        digits,
        simulated.name().to_owned(),
    ]
}

/// Resonances at which no theorem applies, with the hypotheses that fail and their values.
pub(super) fn failing_theorems(layout: Layout, description: &Description, unfolded: &Unfolded) -> String {
    let failing = unfolded.resonances.iter().filter(|at| at.curves.is_none());
    let entries = failing.map(|at| {
        let failing: Vec<String> = at.failing().collect();
        let content = format!("{}: {}", place(description, at.parameters), failing.join(", "));
        (format!("  p = {}, n = {}  ", at.loops, at.n), content)
    });
    let entries = few(entries.collect(), "resonances", "data/hypotheses.csv");
    layout.headed("Resonances at which the theorem does not apply (no curves are followed there)", entries)
}

#[cfg(test)]
mod tests {
    use super::*;
    use grazing_continuation::bifurcation::Pair;
    use grazing_continuation::curve::Window;
    use grazing_continuation::fit::{Estimate, Measurement};
    use grazing_theorems::LinearOscillator;
    use grazing_theorems::hypothesis::Theorem;
    use grazing_unfold::simulation::ReturnOutcome;
    use grazing_unfold::unfolded::Curves;
    use grazing_unfold::verdict::{Coefficient, Obstacle};
    use grazing_unfold::verification::{Inconclusive, Sides};

    /// A resonance whose saddle-node coefficient is measured with an error, and what simulation
    /// shows beside that curve.
    fn resonance(error: f64, simulated: Simulated) -> AtResonance {
        let finding = |error, simulated| CurveFinding {
            coefficient: Coefficient {
                stability: 1.0,
                theorem: Estimate { value: -2.5, error: 1e-9 },
                fit: Ok(Measurement {
                    coefficient: Estimate { value: -2.25, error },
                    eta: [1.0, 0.0],
                    mu: [-2.25, 0.0],
                    velocity: 0.01,
                }),
            },
            simulated,
        };
        let undecided = Simulated::Undecided(Inconclusive::NotMeasured);
        let findings =
            Pair { saddle_node: finding(error, simulated), period_doubling: finding(1.0, undecided) };
        let window = Window { primary: [0.0, 1.0], secondary: [0.0, 1.0] };
        let point = LinearOscillator::new(0.05, 0.8).and_then(|oscillator| oscillator.resonance(2, 3));
        AtResonance {
            loops: 2,
            wall: 0,
            n: 3,
            parameters: [0.5, 0.75],
            point: point.expect("they are in the domain").resonant_point(),
            theorem: Theorem::ResonantMultiLoop,
            hypotheses: Vec::new(),
            curves: Some(Curves {
                findings,
                doubled_grazing: f64::NAN,
                window,
                magnified: Vec::new(),
                straightened: Vec::new(),
            }),
        }
    }

    #[test]
    fn contradictions_are_told_with_both_values_and_errors_and_doubts_with_their_reasons() {
        let sides = Sides {
            velocity: 0.001,
            predicted: [false, true],
            seen: [ReturnOutcome::Returns; 2],
            attracts: [Some(false); 2],
            gone_beyond: Some(true),
        };
        let bad = resonance(1e-7, Simulated::Against(sides));
        let words = contradictions(std::slice::from_ref(&bad));
        let file = std::path::Path::new("test.toml");
        for missing in [None, Some("something is missing".to_owned())] {
            let failure = crate::unfold::verdict(file, std::slice::from_ref(&bad), missing);
            assert_eq!(failure.expect_err("it is contradicted").exit_code(), 1);
        }
        assert_eq!(
            words,
            [
                "p = 2, n = 3: c_SN is -2.5 by the theorem (error 1e-9) but -2.25 on the continued curve (error 1e-7)",
                "p = 2, n = 3: beside the SN curve, at impact velocity 1e-3 the faster solution is predicted to be stable \
                 but repels",
            ]
        );
        let doubtful =
            resonance(1.0, Simulated::Undecided(Inconclusive::TooSlow { leading: 1e-9, least: 1e-6 }));
        assert!(contradictions(std::slice::from_ref(&doubtful)).is_empty());
        assert!(crate::unfold::verdict(file, std::slice::from_ref(&doubtful), None).is_ok());
        let doubtful = [doubtful];
        let curve = curves(&doubtful).next().expect("the theorem applies");
        assert!(matches!(curve.2.coefficient.verdict(), Verdict::NotMeasurable(Obstacle::Rounding { .. })));
        let words = reasons(Layout::default(), "omega", curve);
        for wanted in
            ["p = 2, n = 3, omega = 0.75000, SN:  not measurable: where", "simulation undecided: the leading"]
        {
            assert!(words.contains(wanted), "{words}");
        }
    }
}
