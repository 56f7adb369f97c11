//! The limit map at a resonance, which is not in the paper.

use super::Column;

columns! {
    /// a₂₂ for p = 1, −δ^(p/2) for p ≥ 2; for the linear oscillator σ = −E_p, or E₁ for p = 1 and even n
    SIGMA = "sigma", r"\sigma", "1";
    /// M at the saddle-node in the limit map
    M_SN = "m_sn", r"M_{\mathrm{SN}}", "1";
    /// M at the period doubling
    M_PD = "m_pd", r"M_{\mathrm{PD}}", "1";
    /// M at which the orbits with two impacts that begin at the period doubling graze
    M_2GZ = "m_2gz", r"M_{2\mathrm{GZ}}", "1";
    /// M at which these orbits double their period before they graze; empty if they do not
    M_DOUBLED_PD = "m_doubled_pd", r"M_{2\mathrm{PD}}", "1";
    /// limit of (μ − μ_graz)/η² where these orbits graze
    C_2GZ = "c_2gz", r"c_{2\mathrm{GZ}}", "{primary}/{secondary}^2";
    /// the same, measured: grazing orbits with two impacts are computed at two distances from the resonance; empty if none is found
    C_2GZ_FIT = "c_2gz_fit", r"c_{2\mathrm{GZ}}\text{, orbits}", "{primary}/{secondary}^2";
    /// relative error of c_2GZ where the impact velocity at the period doubling is 0.01 to leading order, by computing grazing orbits; empty if none is found
    C_2GZ_ERROR_2 = "c_2gz_error_2", "", "1";
    /// the same for 0.001
    C_2GZ_ERROR_3 = "c_2gz_error_3", "", "1";
    /// the same for 0.0001
    C_2GZ_ERROR_4 = "c_2gz_error_4", "", "1";
    /// onset of orbits with four impacts, in units of μ_PD − μ_graz; empty if they are not stable there
    PERIOD_4 = "period_4", r"M_4/M_{\mathrm{PD}}", "1";
    /// the same for eight impacts
    PERIOD_8 = "period_8", r"M_8/M_{\mathrm{PD}}", "1";
    /// the same for sixteen impacts
    PERIOD_16 = "period_16", r"M_{16}/M_{\mathrm{PD}}", "1";
    /// where the motion, followed downwards from there in steps of 0.001, first misses the wall or, for p ≥ 2, reaches it early; empty if there is no stable motion
    /// to follow
    LEAVES = "leaves", "", "1";
    /// why the cascade is not followed further: `enough`: it has reached sixteen impacts; `subcritical`: so is the last doubling; `grazing`: the last orbits graze
    /// before they double; `saddle-node`, `lost`: how the last orbits end
    CASCADE_STOP = "stop", "", "1";
    /// number of the panel, row by row
    CASCADE_PANEL = "panel", "", "1";
    /// impact velocity at the period doubling to leading order, a measure of the distance from the resonance; 0: the limit map
    CASCADE_SIZE = "size", r"y_{\mathrm{PD}}", "1";
    /// (μ − μ_graz)/(μ_PD − μ_graz), with the leading term of μ_PD
    SCALED_PARAMETER = "scaled_parameter", "", "1";
    /// impact velocity divided by its leading-order value at the period doubling
    SCALED_VELOCITY = "scaled_velocity", "", "1";
    /// `1`, or `2` for all p ≥ 2
    ATLAS_LOOPS = "loops", "", "1";
    /// number of impacts: orbits with as many are stable at their onset for all lower σ, down to −1
    IMPACTS_BEGUN = "impacts", "", "1";
    /// M_SN/M_PD; the saddle-node is on the other side of the resonance
    RATIO_SN = "ratio_sn", r"M_{\mathrm{SN}}/M_{\mathrm{PD}}", "1";
    /// M_2GZ/M_PD
    RATIO_2GZ = "ratio_2gz", r"M_{2\mathrm{GZ}}/M_{\mathrm{PD}}", "1";
    /// impact velocity, in the limit map, of the slowest stable, admissible p-loop MPS near a one-loop resonance; it lies on an SN curve for σ < 0 and on a PD curve
    /// for σ > 0
    Y_SLOWEST = "y_slowest", r"Y_{-}", "1";
    /// the same of the fastest, whose last visit touches the wall
    Y_FASTEST = "y_fastest", r"Y_{+}", "1";
    /// M of the slowest; for an oscillator, as measured
    M_SLOWEST = "m_slowest", r"M_{-}", "1";
    /// M of the fastest; for an oscillator, as measured
    M_FASTEST = "m_fastest", r"M_{+}", "1";
    /// r of the limit map Y'² = r Y² + k V² + 2V + M, V' = d V − Y'
    LIMIT_R = "limit_r", "r", "1";
    /// k of the limit map
    LIMIT_K = "limit_k", "k", "1";
    /// d of the limit map
    LIMIT_D = "limit_d", "d", "1";
    /// log₁₀ M of the slowest; empty where M is negative
    LOG_M_SLOWEST = "log10_m_slowest", r"\log_{10} M_{-}", "1";
    /// log₁₀ of the width in M
    LOG_M_WIDTH = "log10_m_width", r"\log_{10}(M_{+} - M_{-})", "1";
    /// limit of (μ − μ_graz)/η² of the slowest, by closed form
    C_SLOWEST = "c_slowest", r"c_{-}", "{primary}/{secondary}^2";
    /// the same, measured along the curve
    C_SLOWEST_FIT = "c_slowest_fit", r"c_{-}", "{primary}/{secondary}^2";
    /// limit of (μ − μ_graz)/η² of the fastest, by closed form
    C_FASTEST = "c_fastest", r"c_{+}", "{primary}/{secondary}^2";
    /// the same, measured along the curve
    C_FASTEST_FIT = "c_fastest_fit", r"c_{+}", "{primary}/{secondary}^2";
    /// m: the region ends at the rotation x = m/p on δ = 1; m = 1 is the region of Theorem 2.3; a₁₂α > 0 if m ≤ p/2, otherwise a₁₂α < 0
    TURNS = "m", "m", "1";
    /// number of the visit that touches the wall on the boundary of the region
    TOUCHING_VISIT = "visit", "j", "1", "eq:ujwj";
    /// least trace of the region at this determinant
    TAU_LOW = "tau_low", r"\tau", "1", "eq:A";
    /// greatest trace of the region at this determinant
    TAU_HIGH = "tau_high", r"\tau", "1", "eq:A";
    /// least x, where τ = 2√δ cos 2πx and x > ½ if a₁₂α < 0; 0, ½ or 1 if the eigenvalues are real
    ROTATION_LOW = "x_low", "x", "1";
    /// greatest x
    ROTATION_HIGH = "x_high", "x", "1";
    /// primary parameter at the first of a run of adjacent places, at the middle of its cell; the others follow in steps of the map
    FIRST_PLACE = "{primary}", "{primary}", "{primary}";
    /// number of adjacent places in the run, at each of which the same attractors are found
    MAP_PLACES = "places", "", "1";
    /// number of attractors found at each of them from the fixed initial states: a lower bound
    ATTRACTORS_SEEN = "attractors", "", "1";
    /// number of the attractor among these; each has a row
    MAP_ATTRACTOR = "attractor", "", "1";
    /// `non-impacting`, `periodic`: Newton's method converges from the motion to a nearby periodic solution with multipliers inside the unit circle; `chaotic`: it
    /// does not, and the Lyapunov exponent over 512 more forcing periods exceeds 0 by more than four standard errors; `unsettled`: neither, as close to bifurcations;
    /// `resting`: the force holds the motion at the wall for a whole period
    MAP_MOTION = "motion", "", "1";
    /// period, in forcing periods; 0 if the motion is not periodic
    MAP_PERIODS = "periods", "", "1";
    /// impacts per forcing period, empty where infinitely many accumulate at the wall; for motion that is not periodic, the mean over the places
    MAP_IMPACTS = "impacts", "", "1";
    /// least of the largest Lyapunov exponents at these places; empty for periodic motion, where multipliers decide
    LYAPUNOV_LEAST = "lyapunov_least", r"\lambda", "1/time";
    /// greatest of them
    LYAPUNOV_GREATEST = "lyapunov_greatest", r"\lambda", "1/time";
    /// largest of their standard errors, each from eight parts of the simulated time
    LYAPUNOV_LARGEST_ERROR = "lyapunov_error", "", "1/time";
    /// places in regions in which the p-loop solution is stable
    MAP_IN_REGIONS = "in_regions", "", "1";
    /// of these, places at which an initial state converges to it
    MAP_SETTLED = "settled", "", "1";
    /// of these, places at which none does, because all of them miss its basin
    MAP_UNSEEN = "unseen", "", "1";
    /// places at which an initial state converges to the p-loop solution although they lie outside all of its regions, including undecided ones, and farther than
    /// 1e-4 of the ranges from them
    MAP_UNEXPLAINED = "unexplained", "", "1";
    /// `unseen`: in a region of the p-loop solution, but no initial state converges to it; `unexplained`: outside its regions, but one does
    MAP_REMARK = "remark", "", "1";
}

// Resonances of motion with impacts.
columns! {
    /// number of the resonance, its row in beyond_generations.csv
    LATER_NUMBER = "resonance", "", "1";
    /// p of the MPSs that graze: the grazing motion recurs after as many forcing periods
    LATER_BASE_LOOPS = "base_p", "p", "1";
    /// n of the resonance from which the regions of these MPSs leave; 0 without one
    LATER_BASE_INDEX = "base_n", "n", "1";
    /// impacts of the grazing motion
    LATER_BASE_IMPACTS = "base_impacts", "", "1";
    /// forcing periods after which the grazing motion recurs
    LATER_BASE_PERIODS = "base_periods", "", "1";
    /// q: solutions leave that hit the wall once more than in q rounds of the grazing motion; a₁₂ = 0 for q = 1, κ_q = 0 for q ≥ 2, of the map through its impact
    LATER_ROUNDS = "q", "q", "1";
    /// impacts of these solutions
    LATER_IMPACTS = "impacts", "K", "1";
    /// forcing periods after which they recur
    LATER_PERIODS = "periods", "", "1";
    /// the walls that these impacts hit, from 1 in the order of the file, one after the other: `1-2`. Only with two walls
    LATER_WALLS = "{wall}s", "", "1";
    /// the hypotheses of Theorem 2.4 or 2.5 that fail; empty if the theorem applies
    LATER_FAILS = "fails", "", "1";
    /// least impact velocity of the solution
    LATER_VELOCITY = "impact_velocity", r"\min y_{\mathrm{imp}}", "length/time";
}

// Proofs for Figure 7.
columns! {
    /// object in Figure 7: `curve`, `point` or `region`
    PROOF_OBJECT = "object", "", "1";
    /// its kind, as in the tables of Figure 7
    PROOF_KIND = "kind", "", "1";
    /// the `arc` of a curve, the `region`, or the row of a point (1 is the first), in the tables of Figure 7
    PROOF_NUMBER = "number", "", "1";
    /// least secondary parameter of a curve or region; for a point, the lower end of the interval in which it is proved to lie
    PROOF_FROM = "{secondary}_from", r"{secondary}_{\mathrm{from}}", "{secondary}";
    /// greatest secondary parameter, or the upper end
    PROOF_TO = "{secondary}_to", r"{secondary}_{\mathrm{to}}", "{secondary}";
    /// primary parameter of a point, the midpoint of its bounds; otherwise empty
    PROOF_AMPLITUDE = "{primary}_at", "{primary}", "{primary}";
    /// greatest distance between the proved bounds of the primary parameter; 0: a closed form
    PROOF_WIDTH = "width", "", "{primary}";
    /// number of its points that are drawn
    PROOF_DRAWN = "drawn", "", "1";
    /// number of these that lie where it is proved to be, up to 2·10⁻⁹ for rounding
    PROOF_WITHIN = "within", "", "1";
    /// statement that is proved
    PROOF_STATEMENT = "statement", "", "1";
    /// kind of the curve at `begins`: `SN`, `PD` or, for p = 0, `graz`
    PROOF_BEGINS_AT = "at", "", "1";
    /// primary parameter at which the motion becomes stable; for p = 0, at which it grazes
    PROOF_BEGINS = "begins", "", "{primary}";
    /// primary parameter up to which the motion is proved to be admissible
    PROOF_LOWER = "lower", "", "{primary}";
    /// primary parameter from which on it is proved not to be; empty beyond the window
    PROOF_UPPER = "upper", "", "{primary}";
    /// log₁₀ of the width of the tube in which the GZ curve lies
    PROOF_LOG_WIDTH = "log10_width", r"\log_{10}\text{ width}", "1";
    /// `tube`: contains the GZ curve; `box`: contains exactly one point
    PROOF_PART = "part", "", "1";
    /// secondary parameter minus its value at the middle of the panel, in units of 10⁻⁹
    PROOF_SECONDARY_OFFSET = "{secondary}_offset", "", "{secondary}";
    /// `begins` minus the primary parameter at the middle of the panel, in units of 10⁻⁶
    PROOF_BEGINS_OFFSET = "begins_offset", "", "{primary}";
    /// `lower`, with the same offset and unit
    PROOF_LOWER_OFFSET = "lower_offset", "", "{primary}";
    /// `upper`, with the same offset and unit
    PROOF_UPPER_OFFSET = "upper_offset", "", "{primary}";
}
