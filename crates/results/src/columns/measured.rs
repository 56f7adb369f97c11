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
    /// observed behaviour
    SEEN = "seen", "", "1";
    /// `agrees`; `within error`: it agrees at a place within two standard errors; `disagrees`; `undecided`: the computed behaviour is not known; `silent`: no such
    /// motion is computed. A bifurcation agrees if it lies within two standard errors of a curve of its kind
    AGREEMENT = "agreement", "", "1";
    /// stable motion at the place by the regions: motion without impacts, and p-loop MPSs of the given p
    STABLE_THERE = "theory", "", "1";
    /// numbers of the regions that contain the place
    REGIONS_THERE = "regions", "", "1";
    /// for a bifurcation, its distance from the nearest curve of its kind, in standard errors; empty if no error is stated
    DISTANCE = "distance", "", "1";
    /// number of the region, as in regions.csv; 0 outside all regions, and for bifurcations
    COUNTED_REGION = "region", "", "1";
    /// kind of the region or of the bifurcation
    COUNTED_KIND = "kind", "", "1";
    /// number of measurements
    MEASURED = "points", "", "1";
    /// number that agree
    AGREE = "agree", "", "1";
    /// number that agree within error
    WITHIN_ERROR = "within_error", "", "1";
    /// number that disagree
    DISAGREE = "disagree", "", "1";
    /// number for which the computed behaviour is not known
    NOT_DECIDED = "undecided", "", "1";
    /// number for which no such motion is computed
    SILENT = "silent", "", "1";
    /// constant of the oscillator, by its name in the file
    CONSTANT = "constant", "", "1";
    /// another constant
    OTHER_CONSTANT = "other", "", "1";
    /// value with the least sum of squares
    VALUE = "value", "", "as in the file";
    /// standard error of the value
    STANDARD_ERROR = "standard_error", "", "as in the file";
    /// value in the file, with which the search starts
    START = "start", "", "as in the file";
    /// correlation of their errors
    CORRELATION = "correlation", r"\rho", "1";
    /// file with the measurement: `points` or `record`
    MEASURED_SOURCE = "source", "", "1";
    /// measured quantity: a bifurcation, `time`, `velocity_before` or `velocity_after`
    QUANTITY = "quantity", "", "1";
    /// computed minus measured value, in standard errors; for a bifurcation, its signed distance from the curve
    RESIDUAL = "residual", "", "1";
    /// standard error of the secondary parameter at the resonance, from those of the constants
    RESONANCE_ERROR = "{secondary}_star_error", "", "{secondary}";
    /// standard error of the primary parameter at the resonance, from those of the constants
    GRAZING_ERROR = "{primary}_graz_error", "", "{primary}";
}
