//! A plane of two parameters, and how they are written.

use grazing_results::{symbol, symbol_at_grazing};

/// One of the two parameters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Axis {
    /// The column of the tables that holds it, which the SVG names.
    pub column: String,
    /// The axis title, in the markup of labels (`$\omega$` is a Greek letter).
    pub title: String,
}

/// The two parameters over which bifurcation curves are drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Plane {
    /// The primary parameter, on the horizontal axis.
    pub across: Axis,
    /// The secondary parameter, on the vertical axis.
    pub up: Axis,
    /// The name of the grazing curve of the non-impacting solution, in the markup of labels.
    pub grazing: String,
}

impl Plane {
    /// The plane of the paper's oscillator: forcing amplitude across, forcing frequency up.
    pub fn of_the_paper() -> Self {
        Plane {
            across: Axis { column: "amplitude".to_owned(), title: r"$\mathcal{A}$".to_owned() },
            up: Axis { column: "omega".to_owned(), title: r"$\omega$".to_owned() },
            grazing: r"$\mathcal{A}_{\mathrm{graz}}$".to_owned(),
        }
    }

    /// The plane of two parameters whose columns bear their names; titles are their [`symbol`]s, and the
    /// grazing curve is named after the primary parameter.
    ///
    /// `primary` and `secondary` are names such as `A`, `omega_2` or `amplitude`.
    pub fn of_parameters(primary: &str, secondary: &str) -> Self {
        let axis = |name: &str| {
            let title = symbol(name).map_or_else(|| name.replace('$', ""), |symbol| format!("${symbol}$"));
            Axis { column: name.to_owned(), title }
        };
        let grazing = symbol_at_grazing(primary);
        let grazing = grazing.map_or_else(|| "grazing".to_owned(), |symbol| format!("${symbol}$"));
        Plane { across: axis(primary), up: axis(secondary), grazing }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::markup::Label;

    #[test]
    fn no_name_makes_a_title_that_is_not_markup() {
        let alphabet = ["a", "omega", "mass", "_", "0", "12", "$", "{", "\\", "ω", " "];
        for first in alphabet {
            for second in alphabet {
                for third in alphabet {
                    let title =
                        Plane::of_parameters(&format!("{first}{second}{third}"), "omega").across.title;
                    assert!(Label::parse(&title).is_ok(), "{title}");
                }
            }
        }
    }

    #[test]
    fn the_grazing_curve_is_named_after_the_primary_parameter_if_that_has_a_symbol() {
        let name = |primary| Plane::of_parameters(primary, "omega").grazing;
        assert_eq!(name("A"), r"$A_{\mathrm{graz}}$");
        assert_eq!(name("amplitude"), "grazing");
    }
}
