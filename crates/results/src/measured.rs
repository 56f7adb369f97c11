//! Measurements beside a two-parameter diagram, and the constants identified from them.

use crate::{rows, tables, words};

words! {
    /// The result of comparing measured with computed behaviour.
    Agreement {
        /// The computed behaviour at the measured place agrees.
        Agrees = "agrees",
        /// The computed behaviour agrees at some place within two standard errors.
        WithinError = "within error",
        Disagrees = "disagrees",
        /// The computed behaviour there is not decided.
        Undecided = "undecided",
        /// Nothing is computed for such motion, or for such a place.
        Silent = "silent",
    }

    /// The kinds of measured behaviour that measurements distinguish.
    SeenKind {
        /// The oscillator did not reach the wall.
        NonImpacting = "no impacts",
        /// The oscillator hit the wall once in p forcing periods.
        Loops = "one impact in p periods",
        /// Any other motion: several impacts in a period, or none.
        Other = "other motion",
        /// The behaviour changed at the measured place.
        Bifurcation = "bifurcation",
    }
}

rows! {
    /// A measurement at a place of the parameter plane, with the computed behaviour there.
    MeasuredPoint {
        line: u32 = LINE,
        secondary: f64 = SECONDARY,
        secondary_error: f64 = SECONDARY_ERROR,
        primary: f64 = PRIMARY,
        primary_error: f64 = PRIMARY_ERROR,
        kind: SeenKind = SEEN_KIND,
        seen: String = SEEN,
        agreement: Agreement = AGREEMENT,
        theory: String = STABLE_THERE,
        regions: String = REGIONS_THERE,
        distance: f64 = DISTANCE,
        reason: String = REASON,
    }

    /// The numbers of measurements in a region, or of bifurcations of a kind, that agree, disagree or are
    /// undecided.
    MeasuredCount {
        region: u32 = COUNTED_REGION,
        kind: String = COUNTED_KIND,
        loops: u32 = LOOPS,
        points: u32 = MEASURED,
        agree: u32 = AGREE,
        within_error: u32 = WITHIN_ERROR,
        disagree: u32 = DISAGREE,
        undecided: u32 = NOT_DECIDED,
        silent: u32 = SILENT,
    }

    /// A constant that was identified.
    IdentifiedConstant {
        constant: String = CONSTANT,
        value: f64 = VALUE,
        error: f64 = STANDARD_ERROR,
        start: f64 = START,
    }

    /// The correlation of two identified constants.
    Correlation {
        constant: String = CONSTANT,
        other: String = OTHER_CONSTANT,
        correlation: f64 = CORRELATION,
    }

    /// The residual of a measured number.
    Residual {
        source: String = MEASURED_SOURCE,
        line: u32 = LINE,
        quantity: String = QUANTITY,
        residual: f64 = RESIDUAL,
    }

    /// A resonance with the uncertainty that follows from the uncertainties of the constants.
    IdentifiedResonance {
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY_AT_RESONANCE,
        secondary_error: f64 = RESONANCE_ERROR,
        primary: f64 = PRIMARY_AT_GRAZING,
        primary_error: f64 = GRAZING_ERROR,
        reason: String = REASON,
    }
}

tables! {
    /// Measurements beside a diagram.
    Comparison {
        points: MeasuredPoint = "measured", "a measurement at a place, with the computed behaviour there",
        counts: MeasuredCount = "agreement",
            "a region of the diagram or a kind of bifurcation with measurements, and how many of them agree",
    }

    /// The results of an identification.
    Identified {
        constants: IdentifiedConstant = "constants", "a constant that was identified",
        correlations: Correlation = "correlations", "a pair of identified constants, with their correlation",
        residuals: Residual = "residuals", "a measured number, with its residual for the identified oscillator",
        resonances: IdentifiedResonance = "resonances", "a resonance of the identified oscillator",
    }
}

impl MeasuredCount {
    /// Counts one more.
    pub fn count(&mut self, agreement: Agreement) {
        self.points += 1;
        *match agreement {
            Agreement::Agrees => &mut self.agree,
            Agreement::WithinError => &mut self.within_error,
            Agreement::Disagrees => &mut self.disagree,
            Agreement::Undecided => &mut self.undecided,
            Agreement::Silent => &mut self.silent,
        } += 1;
    }
}
