//! Measurements, and the constants identified from them.

use super::Column;

columns! {
    /// line in the file of measurements
    LINE = "line", "", "1";
    /// standard error of the secondary parameter, as measured
    SECONDARY_ERROR = "{secondary}_error", "", "{secondary}";
    /// standard error of the primary parameter, as measured
    PRIMARY_ERROR = "{primary}_error", "", "{primary}";
    /// `no impacts`, `one impact in p periods`, `other motion`, or `bifurcation`
    SEEN_KIND = "kind", "", "1";
    /// what the rig was seen to do
    SEEN = "seen", "", "1";
    /// `agrees`; `within error`, where it does at a place within two standard errors; `disagrees`; `undecided`, where it is not known what there is;
    /// `silent`, where nothing is computed of such motion. A bifurcation agrees up to two standard errors from a curve of its kind
    AGREEMENT = "agreement", "", "1";
    /// what is stable at the place by the regions: motion without impacts, and p-loop MPSs of the p asked for
    STABLE_THERE = "theory", "", "1";
    /// the numbers of the regions that hold the place
    REGIONS_THERE = "regions", "", "1";
    /// of a bifurcation, how far it is from the nearest curve of its kind, in standard errors; empty where none is stated
    DISTANCE = "distance", "", "1";
    /// number of the region, as in regions.csv; 0 for what lies in none, and for bifurcations
    COUNTED_REGION = "region", "", "1";
    /// kind of the region, or of the bifurcation
    COUNTED_KIND = "kind", "", "1";
    /// measurements there
    MEASURED = "points", "", "1";
    /// those that agree
    AGREE = "agree", "", "1";
    /// those that agree within error
    WITHIN_ERROR = "within_error", "", "1";
    /// those that disagree
    DISAGREE = "disagree", "", "1";
    /// those where it is not known what there is
    NOT_DECIDED = "undecided", "", "1";
    /// those of which nothing is computed
    SILENT = "silent", "", "1";
    /// a constant of the oscillator, by its name in the file
    CONSTANT = "constant", "", "1";
    /// another one
    OTHER_CONSTANT = "other", "", "1";
    /// its value with the least sum of squares
    VALUE = "value", "", "as in the file";
    /// its standard error
    STANDARD_ERROR = "standard_error", "", "as in the file";
    /// its value in the file, with which the search begins
    START = "start", "", "as in the file";
    /// correlation of their errors
    CORRELATION = "correlation", r"\rho", "1";
    /// `points` or `record`: the file in which the number was measured
    MEASURED_SOURCE = "source", "", "1";
    /// what was measured: a bifurcation, `time`, `velocity_before` or `velocity_after`
    QUANTITY = "quantity", "", "1";
    /// computed less measured, in standard errors; of a bifurcation its distance from the curve, with a sign that tells the side
    RESIDUAL = "residual", "", "1";
    /// standard error of the secondary parameter at the resonance, as it follows from the constants
    RESONANCE_ERROR = "{secondary}_star_error", "", "{secondary}";
    /// standard error of the primary parameter at the resonance, as it follows from the constants
    GRAZING_ERROR = "{primary}_graz_error", "", "{primary}";
}
