//! Numbers, as many programs write them.

/// How the numbers of a file are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DecimalMark {
    Point,
    Comma,
}

impl DecimalMark {
    /// The way in which all these numbers are written: with a comma if at least one of them can only be
    /// meant so, and none has a point.
    pub(super) fn of<'c>(cells: impl Iterator<Item = &'c str> + Clone) -> Self {
        let is_decimal = |cell: &str| {
            let parts = cell.split_once(',').filter(|(_, after)| !after.contains(','));
            parts.is_some_and(|(before, after)| {
                let digits = after.chars().take_while(char::is_ascii_digit).count();
                // 1,234 may be a thousand and more.
                let is_part =
                    digits != 3 || matches!(before.trim_start_matches(['+', '-', '\u{2212}']), "" | "0");
                is_part && Self::Comma.number(cell).is_some()
            })
        };
        let has_comma = cells.clone().any(is_decimal);
        if has_comma && !cells.into_iter().any(|cell| cell.contains('.')) { Self::Comma } else { Self::Point }
    }

    /// The number in a cell, also with the exponents of Fortran (1.0D-01, 1.0-101) and of Mathematica
    /// (1.0*^-1), and with a minus sign of typography. It may be NaN or infinite.
    pub(super) fn number(self, cell: &str) -> Option<f64> {
        let plain = match self {
            Self::Point => cell.to_owned(),
            Self::Comma => cell.replace(',', "."),
        };
        let plain = plain.replace('\u{2212}', "-").replace("*^", "e");
        let exponent = || plain.replace(['D', 'd'], "e").parse().ok();
        plain.parse().ok().or_else(exponent).or_else(|| without_letter(&plain))
    }
}

/// A number whose exponent of three digits left no room for its letter, as Fortran writes it.
fn without_letter(cell: &str) -> Option<f64> {
    let sign = cell.rfind(['+', '-'])?;
    let (mantissa, exponent) = cell.split_at(sign);
    let is_exponent = exponent.len() == 4 && exponent[1..].bytes().all(|digit| digit.is_ascii_digit());
    let is_plain = mantissa.contains('.') && !mantissa.contains(['e', 'E']);
    if is_exponent && is_plain { format!("{mantissa}e{exponent}").parse().ok() } else { None }
}

/// Whether a cell says that there is no number, as programs write it between curves.
pub(super) fn is_none(cell: &str) -> bool {
    matches!(cell, "NA" | "N/A" | "n/a" | "missing") || cell.parse().is_ok_and(f64::is_nan)
}
