//! The limit map at a resonance, which is not in the paper.

use super::Column;

columns! {
    /// a₂₂ for p = 1, −δ^(p/2) for p ≥ 2: of the linear oscillator σ = −E_p, or E₁ for p = 1 and even n
    SIGMA = "sigma", r"\sigma", "1";
    /// M of the saddle-node in the limit map
    M_SN = "m_sn", r"M_{\mathrm{SN}}", "1";
    /// M of the period doubling
    M_PD = "m_pd", r"M_{\mathrm{PD}}", "1";
    /// M at which orbits with two impacts, which begin at the period doubling, graze
    M_2GZ = "m_2gz", r"M_{2\mathrm{GZ}}", "1";
    /// M at which they double their period before that; empty if they do not
    M_DOUBLED_PD = "m_doubled_pd", r"M_{2\mathrm{PD}}", "1";
    /// limit of (μ − μ_graz)/η² where these orbits graze
    C_2GZ = "c_2gz", r"c_{2\mathrm{GZ}}", "{primary}/{secondary}^2";
    /// the same, measured: orbits with two impacts that graze are solved for at two distances from the resonance; empty where none are found
    C_2GZ_FIT = "c_2gz_fit", r"c_{2\mathrm{GZ}}\text{, orbits}", "{primary}/{secondary}^2";
    /// relative error of c_2GZ where the period doubling has the impact velocity 0.01 to leading order: orbits that graze are solved for; empty where none is found
    C_2GZ_ERROR_2 = "c_2gz_error_2", "", "1";
    /// likewise 0.001
    C_2GZ_ERROR_3 = "c_2gz_error_3", "", "1";
    /// likewise 0.0001
    C_2GZ_ERROR_4 = "c_2gz_error_4", "", "1";
    /// where orbits with four impacts begin, in units of μ_PD − μ_graz; empty if they do not begin stable
    PERIOD_4 = "period_4", r"M_4/M_{\mathrm{PD}}", "1";
    /// likewise with eight
    PERIOD_8 = "period_8", r"M_8/M_{\mathrm{PD}}", "1";
    /// likewise with sixteen
    PERIOD_16 = "period_16", r"M_{16}/M_{\mathrm{PD}}", "1";
    /// where motion that is followed down from there is first seen to miss the wall or, for p ≥ 2, to reach it early, in steps of 0.001; empty where there is nothing
    /// stable to follow
    LEAVES = "leaves", "", "1";
    /// why no more orbits begin: `enough` have as far as sixteen impacts; `subcritical` is the last doubling; `grazing` are the last orbits before they double;
    /// `saddle-node` or `lost` is how they end
    CASCADE_STOP = "stop", "", "1";
    /// number of the panel, row by row
    CASCADE_PANEL = "panel", "", "1";
    /// impact velocity at the period doubling to leading order, which says how far from the resonance it is; 0: the limit map
    CASCADE_SIZE = "size", r"y_{\mathrm{PD}}", "1";
    /// (μ − μ_graz)/(μ_PD − μ_graz), with the leading term of μ_PD
    SCALED_PARAMETER = "scaled_parameter", "", "1";
    /// impact velocity over that at the period doubling, to leading order
    SCALED_VELOCITY = "scaled_velocity", "", "1";
    /// `1`, or `2` for all p ≥ 2
    ATLAS_LOOPS = "loops", "", "1";
    /// orbits with so many impacts begin stable for all σ below, down to −1
    IMPACTS_BEGUN = "impacts", "", "1";
    /// M_SN/M_PD; the saddle-node is on the other side of the resonance
    RATIO_SN = "ratio_sn", r"M_{\mathrm{SN}}/M_{\mathrm{PD}}", "1";
    /// M_2GZ/M_PD
    RATIO_2GZ = "ratio_2gz", r"M_{2\mathrm{GZ}}/M_{\mathrm{PD}}", "1";
    /// impact velocity, in the limit map, of the slowest stable, admissible MPS of p loops beside a one-loop resonance; it is at an SN curve for σ < 0, at a PD curve for σ > 0
    Y_SLOWEST = "y_slowest", r"Y_{-}", "1";
    /// likewise of the fastest: its last visit touches the wall
    Y_FASTEST = "y_fastest", r"Y_{+}", "1";
    /// M of the slowest; of an oscillator as measured
    M_SLOWEST = "m_slowest", r"M_{-}", "1";
    /// M of the fastest, likewise
    M_FASTEST = "m_fastest", r"M_{+}", "1";
    /// log₁₀ M of the slowest; empty where that is negative
    LOG_M_SLOWEST = "log10_m_slowest", r"\log_{10} M_{-}", "1";
    /// log₁₀ of the width in M
    LOG_M_WIDTH = "log10_m_width", r"\log_{10}(M_{+} - M_{-})", "1";
    /// limit of (μ − μ_graz)/η² of the slowest, by closed form
    C_SLOWEST = "c_slowest", r"c_{-}", "{primary}/{secondary}^2";
    /// the same as measured on the curve
    C_SLOWEST_FIT = "c_slowest_fit", r"c_{-}", "{primary}/{secondary}^2";
    /// limit of (μ − μ_graz)/η² of the fastest, by closed form
    C_FASTEST = "c_fastest", r"c_{+}", "{primary}/{secondary}^2";
    /// the same as measured on the curve
    C_FASTEST_FIT = "c_fastest_fit", r"c_{+}", "{primary}/{secondary}^2";
    /// m: the region ends at the rotation x = m/p on δ = 1; m = 1 is that of Theorem 2.3; a₁₂α > 0 if m ≤ p/2, < 0 if not
    TURNS = "m", "m", "1";
    /// number of the visit that touches the wall on the region's boundary
    TOUCHING_VISIT = "visit", "j", "1", "eq:ujwj";
    /// least trace of the region at this determinant
    TAU_LOW = "tau_low", r"\tau", "1", "eq:A";
    /// greatest trace
    TAU_HIGH = "tau_high", r"\tau", "1", "eq:A";
    /// least x, τ = 2√δ cos 2πx, x > ½ where a₁₂α < 0; 0, ½ or 1 if eigenvalues are real
    ROTATION_LOW = "x_low", "x", "1";
    /// greatest x
    ROTATION_HIGH = "x_high", "x", "1";
    /// primary parameter at the first of places beside each other, the middle of its cell; the others follow in steps of the map
    FIRST_PLACE = "{primary}", "{primary}", "{primary}";
    /// so many places beside each other, at each of which the same attractors are seen
    MAP_PLACES = "places", "", "1";
    /// attractors seen at each of them from the fixed initial states: a lower bound of how many there are
    ATTRACTORS_SEEN = "attractors", "", "1";
    /// number of the attractor among these: a row for each
    MAP_ATTRACTOR = "attractor", "", "1";
    /// `non-impacting`, `periodic`: Newton's method leads from the motion to a periodic solution beside it whose multipliers lie inside the unit circle; `chaotic`: it
    /// does not, and the exponent over 512 more forcing periods is more than four of its standard errors above 0; `unsettled`: nor is that so, as close to bifurcations;
    /// `resting`: motion comes to rest at the wall, and is not followed on
    MAP_MOTION = "motion", "", "1";
    /// forcing periods after which it comes again; 0 if it does not
    MAP_PERIODS = "periods", "", "1";
    /// impacts in a forcing period; of motion that does not come again the mean over the places
    MAP_IMPACTS = "impacts", "", "1";
    /// least of the places' largest Lyapunov exponents; empty for periodic motion, where multipliers decide
    LYAPUNOV_LEAST = "lyapunov_least", r"\lambda", "1/time";
    /// greatest of them
    LYAPUNOV_GREATEST = "lyapunov_greatest", r"\lambda", "1/time";
    /// largest of their standard errors, each from eight parts of the time
    LYAPUNOV_LARGEST_ERROR = "lyapunov_error", "", "1/time";
    /// places in regions in which the p-loop solution is stable
    MAP_IN_REGIONS = "in_regions", "", "1";
    /// of these, places at which an initial state comes to it
    MAP_SETTLED = "settled", "", "1";
    /// of these, places at which none does: it has a basin there that all miss
    MAP_UNSEEN = "unseen", "", "1";
    /// places outside of all regions of the p-loop solution, of undecided ones too, and not within 1e-4 of the ranges of one, at which an initial state comes to it
    MAP_UNEXPLAINED = "unexplained", "", "1";
    /// `unseen`: in a region of the p-loop solution, and no initial state comes to it; `unexplained`: in none, and one does
    MAP_REMARK = "remark", "", "1";
}

// Proofs for Figure 7.
columns! {
    /// what is drawn in Figure 7: `curve`, `point` or `region`
    PROOF_OBJECT = "object", "", "1";
    /// its kind, as in the tables of Figure 7
    PROOF_KIND = "kind", "", "1";
    /// the `arc` of a curve, the `region`, or the place of a point, 1 for the first, in the tables of Figure 7
    PROOF_NUMBER = "number", "", "1";
    /// least secondary parameter of a curve or region; of a point the end of an interval in which it is proved to lie
    PROOF_FROM = "{secondary}_from", r"{secondary}_{\mathrm{from}}", "{secondary}";
    /// greatest, or the other end
    PROOF_TO = "{secondary}_to", r"{secondary}_{\mathrm{to}}", "{secondary}";
    /// primary parameter of a point, the middle of its bounds; empty for others
    PROOF_AMPLITUDE = "{primary}_at", "{primary}", "{primary}";
    /// how far apart the bounds of the primary parameter are that are proved, at most; 0: a closed form
    PROOF_WIDTH = "width", "", "{primary}";
    /// how many points of it are drawn
    PROOF_DRAWN = "drawn", "", "1";
    /// how many of these lie where it is proved to be, within 2·10⁻⁹ for rounding
    PROOF_WITHIN = "within", "", "1";
    /// what is proved of it
    PROOF_STATEMENT = "statement", "", "1";
    /// `SN`, `PD` or, for p = 0, `graz`: the curve at `begins`
    PROOF_BEGINS_AT = "at", "", "1";
    /// primary parameter at which motion begins to be stable; for p = 0 at which it grazes
    PROOF_BEGINS = "begins", "", "{primary}";
    /// primary parameter up to which it is proved to be admissible
    PROOF_LOWER = "lower", "", "{primary}";
    /// primary parameter from which on it is proved not to be; empty beyond the window
    PROOF_UPPER = "upper", "", "{primary}";
    /// log₁₀ of the width of the tube in which the GZ curve lies
    PROOF_LOG_WIDTH = "log10_width", r"\log_{10}\text{ width}", "1";
    /// `tube`, in which the GZ curve lies; `box`, in which exactly one point does
    PROOF_PART = "part", "", "1";
    /// secondary parameter less that at the middle of the panel, in units of 10⁻⁹
    PROOF_SECONDARY_OFFSET = "{secondary}_offset", "", "{secondary}";
    /// `begins` less the primary parameter at the middle of the panel, in units of 10⁻⁶
    PROOF_BEGINS_OFFSET = "begins_offset", "", "{primary}";
    /// `lower`, likewise
    PROOF_LOWER_OFFSET = "lower_offset", "", "{primary}";
    /// `upper`, likewise
    PROOF_UPPER_OFFSET = "upper_offset", "", "{primary}";
}
