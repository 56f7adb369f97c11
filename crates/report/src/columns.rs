//! What the columns of the tables are called on the page.

use std::collections::BTreeMap;

use crate::html::{escape, json_string, put};

/// A column: its name in the CSV, the symbol as HTML, and what it is in words.
type Column = (&'static str, &'static str, &'static str);

const COLUMNS: &[Column] = &[
    ("amplitude", "𝒜", "forcing amplitude"),
    ("omega", "ω", "forcing frequency"),
    ("p", "<i>p</i>", "number of loops"),
    ("n", "<i>n</i>", "integer of the resonance"),
    ("x", "<i>x</i>", "position"),
    ("y", "<i>y</i>", "velocity"),
    ("z", "<i>z</i>", "phase of the forcing"),
    ("time", "<i>t</i>", "time"),
    ("loop", "loop", "number of the loop"),
    ("tau", "τ", "trace of A"),
    ("delta", "δ", "determinant of A"),
    ("mu", "μ", "primary parameter"),
    ("eta", "η", "secondary parameter"),
    ("zeta", "ζ", "damping ratio"),
    ("epsilon", "ε", "coefficient of restitution"),
    ("impact_velocity", "<i>y</i><sub>imp</sub>", "impact velocity"),
    ("impact_phase", "<i>z</i><sub>imp</sub> − <i>z</i><sub>graz</sub>", "impact phase"),
    ("trace", "T", "trace"),
    ("determinant", "D", "determinant"),
    ("max_interior_x", "max <i>x</i>", "highest interior maximum of x"),
    ("omega_star", "ω*", "frequency of the resonance"),
    ("amplitude_graz", "𝒜<sub>graz</sub>", "grazing amplitude"),
    ("s_plus", "<i>s</i><sub><i>p</i></sub><sup>+</sup>", "s_p⁺"),
    ("s_minus", "<i>s</i><sub><i>p</i></sub><sup>−</sup>", "s_p⁻"),
    ("c_sn", "<i>c</i><sub>SN</sub>", "saddle-node coefficient, closed form"),
    ("c_pd", "<i>c</i><sub>PD</sub>", "period-doubling coefficient, closed form"),
    (
        "c_sn_theorem",
        "<i>c</i><sub>SN</sub>, theorem",
        "the same from the general theorem and the numerical map",
    ),
    (
        "c_pd_theorem",
        "<i>c</i><sub>PD</sub>, theorem",
        "the same from the general theorem and the numerical map",
    ),
    ("c_sn_fit", "<i>c</i><sub>SN</sub>, curve", "the same measured on the continued curve"),
    ("c_pd_fit", "<i>c</i><sub>PD</sub>, curve", "the same measured on the continued curve"),
    ("c_sn_fit_error", "error", "estimated error of the measured saddle-node coefficient"),
    ("c_pd_fit_error", "error", "estimated error of the measured period-doubling coefficient"),
    ("alpha", "α", "factor of the square-root term"),
    ("beta", "β", "transversality coefficient"),
    ("gamma", "γ", "deceleration at grazing"),
    ("kappa", "<i>κ</i><sub><i>p</i></sub>", "detuning"),
    ("xi", "<i>ξ</i><sub><i>p</i></sub>", "second derivative with respect to the phase"),
    ("a12_prime", "<i>a</i><sub>12</sub>′", "derivative of a₁₂ along the grazing curve, p = 1"),
    (
        "kappa_prime",
        "<i>κ</i><sub><i>p</i></sub>′",
        "derivative of the detuning along the grazing curve, p ≥ 2",
    ),
    ("c_sn_error", "error of <i>c</i><sub>SN</sub>", "error of the saddle-node coefficient by the theorem"),
    (
        "c_pd_error",
        "error of <i>c</i><sub>PD</sub>",
        "error of the period-doubling coefficient by the theorem",
    ),
    ("sn_verdict", "SN verdict", "whether theorem and saddle-node curve agree within their errors"),
    ("sn_reason", "SN reason", "why they do not, or why that cannot be told"),
    ("pd_verdict", "PD verdict", "whether theorem and period-doubling curve agree within their errors"),
    ("pd_reason", "PD reason", "why they do not, or why that cannot be told"),
    ("sn_as_simulated", "SN as simulated", "whether simulation beside the saddle-node curve is as predicted"),
    ("sn_simulation_reason", "SN simulation, reason", "why it is not, or why that is undecided"),
    ("pd_simulation_reason", "PD simulation, reason", "why it is not, or why that is undecided"),
    (
        "pd_as_simulated",
        "PD as simulated",
        "whether simulation beside the period-doubling curve is as predicted",
    ),
];

/// Greek letters by their names.
const GREEK: &[(&str, &str)] = &[
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("phi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Sigma", "Σ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
];

/// The name of a parameter as a symbol, as HTML: letters and what is lowered after them, `F_0` or `omega_star`; words stay.
pub(crate) fn symbol(name: &str) -> String {
    let letter = |text: &str| match GREEK.iter().find(|(known, _)| *known == text) {
        Some((_, letter)) => Some((*letter).to_owned()),
        None if text.len() == 1 && text.chars().all(char::is_alphabetic) => Some(format!("<i>{text}</i>")),
        None => None,
    };
    let (base, lowered) = name.split_once('_').unwrap_or((name, ""));
    let digits = base.trim_end_matches(|character: char| character.is_ascii_digit()).len();
    let (base, lowered) =
        if lowered.is_empty() && digits < base.len() { base.split_at(digits) } else { (base, lowered) };
    match (letter(base), lowered) {
        (None, _) => escape(&name.replace('_', " ")),
        (Some(symbol), "") => symbol,
        (Some(symbol), "star") => format!("{symbol}*"),
        (Some(symbol), lowered) => {
            format!(
                "{symbol}<sub>{}</sub>",
                letter(lowered).unwrap_or_else(|| escape(&lowered.replace('_', ",")))
            )
        }
    }
}

/// The heading of a column, as HTML; an unknown one goes by its name.
pub(crate) fn heading(name: &str) -> String {
    match COLUMNS.iter().find(|column| column.0 == name) {
        Some((_, symbol, _)) => (*symbol).to_owned(),
        None => symbol(name),
    }
}

/// What the column is, in words.
pub(crate) fn explanation(name: &str) -> &str {
    COLUMNS.iter().find(|column| column.0 == name).map_or(name, |column| column.2)
}

/// The symbols of all columns, for the scripts: the known ones, and those of further names.
pub(crate) fn json<'a>(further: impl Iterator<Item = &'a str>) -> String {
    let mut symbols: BTreeMap<&str, String> = further.map(|name| (name, heading(name))).collect();
    symbols.extend(COLUMNS.iter().map(|(name, symbol, _)| (*name, (*symbol).to_owned())));
    let mut json = String::from("{");
    for (index, (name, symbol)) in symbols.iter().enumerate() {
        let comma = if index == 0 { "" } else { "," };
        put!(json, "{comma}{}:{}", json_string(name), json_string(symbol));
    }
    json.push('}');
    json
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_parameters_become_symbols_and_words_stay() {
        for (name, shown) in [
            ("A", "<i>A</i>"),
            ("omega", "ω"),
            ("F_0", "<i>F</i><sub>0</sub>"),
            ("F0", "<i>F</i><sub>0</sub>"),
            ("omega_star", "ω*"),
            ("A_graz", "<i>A</i><sub>graz</sub>"),
            ("forcing_amplitude", "forcing amplitude"),
            ("stiffness", "stiffness"),
        ] {
            assert_eq!(symbol(name), shown);
        }
    }
}
