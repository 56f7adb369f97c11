//! The limit map at a resonance, which is not in the paper.

use super::Column;

columns! {
    /// σ: −E_p; E₁ for p = 1 and even n
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
    /// relative error of c_2GZ where the period doubling has the impact velocity 0.01 to leading order: orbits that graze are solved for; empty where none is found
    C_2GZ_ERROR_2 = "c_2gz_error_2", "", "1";
    /// likewise 0.001
    C_2GZ_ERROR_3 = "c_2gz_error_3", "", "1";
    /// likewise 0.0001
    C_2GZ_ERROR_4 = "c_2gz_error_4", "", "1";
    /// impact velocity, in the limit map, of the slowest stable, admissible MPS of p loops beside a one-loop resonance; it is at an SN curve for σ < 0, at a PD curve for σ > 0
    Y_SLOWEST = "y_slowest", r"Y_{-}", "1";
    /// likewise of the fastest: its last visit touches the wall
    Y_FASTEST = "y_fastest", r"Y_{+}", "1";
    /// M of the slowest; of an oscillator as measured
    M_SLOWEST = "m_slowest", r"M_{-}", "1";
    /// M of the fastest, likewise
    M_FASTEST = "m_fastest", r"M_{+}", "1";
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
}
