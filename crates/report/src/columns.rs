//! What the columns of the tables are called on the page.

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
];

/// The heading of a column, as HTML; an unknown one goes by its name.
pub(crate) fn heading(name: &str) -> String {
    match COLUMNS.iter().find(|column| column.0 == name) {
        Some((_, symbol, _)) => (*symbol).to_owned(),
        None => escape(&name.replace('_', " ")),
    }
}

/// What the column is, in words.
pub(crate) fn explanation(name: &str) -> &str {
    COLUMNS.iter().find(|column| column.0 == name).map_or(name, |column| column.2)
}

/// The symbols of all columns, for the scripts.
pub(crate) fn json() -> String {
    let mut json = String::from("{");
    for (index, (name, symbol, _)) in COLUMNS.iter().enumerate() {
        let comma = if index == 0 { "" } else { "," };
        put!(json, "{comma}{}:{}", json_string(name), json_string(symbol));
    }
    json.push('}');
    json
}
