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
}
