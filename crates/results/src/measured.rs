//! Measurements beside a two-parameter diagram, and what was identified from them.

use crate::{rows, tables, words};

words! {
    /// Whether what a rig did is what is computed.
    Agreement {
        /// It is, at the very place.
        Agrees = "agrees",
        /// It is at a place within two standard errors.
        WithinError = "within error",
        Disagrees = "disagrees",
        /// It is not decided what there is.
        Undecided = "undecided",
        /// Nothing is computed of such motion, or at such a place.
        Silent = "silent",
    }

    /// What a rig was seen to do, as far as marks tell it.
    SeenKind {
        /// It did not reach the wall.
        NonImpacting = "no impacts",
        /// It hit the wall once in p forcing periods.
        Loops = "one impact in p periods",
        /// Several impacts in its period, or none.
        Other = "other motion",
        /// It changed there.
        Bifurcation = "bifurcation",
    }
}

rows! {
    /// What a rig was seen to do, beside what is computed there.
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

    /// How many measurements in a region, or of bifurcations of a kind, agree.
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

    /// The correlation of two of them.
    Correlation {
        constant: String = CONSTANT,
        other: String = OTHER_CONSTANT,
        correlation: f64 = CORRELATION,
    }

    /// What is left of a measured number.
    Residual {
        source: String = MEASURED_SOURCE,
        line: u32 = LINE,
        quantity: String = QUANTITY,
        residual: f64 = RESIDUAL,
    }

    /// A resonance with the uncertainty that follows from that of the constants.
    IdentifiedResonance {
        loops: u32 = LOOPS,
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
        points: MeasuredPoint = "measured", "what the rig was seen to do at a place, beside what is computed there",
        counts: MeasuredCount = "agreement",
            "a region of the diagram in which something was measured, or a kind of bifurcation that was, with how many agree",
    }

    /// What was identified.
    Identified {
        constants: IdentifiedConstant = "constants", "a constant that was identified",
        correlations: Correlation = "correlations", "two of them, with their correlation",
        residuals: Residual = "residuals", "a measured number, with what the identified oscillator leaves of it",
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
