//! The formulas and theorems of the paper as functions and checked types.
//!
//! "The paper" is D. J. W. Simpson and I. Ghosh, *Resonant grazing bifurcations revisited*, arXiv 2602.22797.
//! Every formula of its sections 2 and 3, and those of section 4, section 5 and the appendices that they rest
//! on, is one public function, named by its meaning; the table below leads from the paper's label to the
//! function, and the docs of the function lead back. Equation numbers start anew in each section of the
//! paper, so they are cited with the section. The crate reads and writes nothing and holds no parameter
//! values.
//!
//! A theorem is a type, [`GenericGrazing`] or [`ResonantGrazing`], of which a value exists only if the
//! hypotheses hold; it keeps them, with their values, and gives the conclusion. When a hypothesis fails, the
//! answer is a [`HypothesesViolated`] that names it.
//!
//! ```
//! use grazing_theorems::{LinearOscillator, ResonantGrazing};
//!
//! let oscillator = LinearOscillator::new(0.1, 0.8)?;
//! let resonance = oscillator.resonance(2, 1)?;
//! let theorem = ResonantGrazing::check(&resonance.resonant_point(), 1e-12)?;
//! let closed_form = resonance.saddle_node_coefficient();
//! assert!((theorem.saddle_node().coefficient / closed_form - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Where the equations are
//!
//! Section 2, main results:
//!
//! | eq. | label | what | where |
//! |---|---|---|---|
//! | 1-3 | `eq:F`, `eq:z`, `eq:f` | equations of motion | crate `grazing_model` |
//! | 4, 5 | `eq:R`, `eq:resetLaw` | reset law | crate `grazing_model` |
//! | 6-8 | `eq:Pglobal`, `eq:A`, `eq:b` | global map to first order | [`LinearisedMap`] (the map itself: crate `grazing_model`) |
//! | 9 | | tau, delta | [`LinearisedMap::trace`], [`LinearisedMap::determinant`] |
//! | 10 | `eq:xStarzStar` | non-impacting periodic solution | [`LinearisedMap::fixed_point_slope`] |
//! | 11 | `eq:xStarzStarDeriv` | its position | [`LinearisedMap::fixed_point_position_slope`] |
//! | 12 | `eq:beta` | beta | [`LinearisedMap::transversality`] |
//! | 13 | `eq:eigs` | eigenvalues | [`LinearisedMap::eigenvalues`], [`spectrum::Eigenvalues`] |
//! | 14 | `eq:cT` | trapesium | [`spectrum::in_trapesium`] |
//! | 15 | `eq:gp` | g_p, kappa_p | [`auxiliary::resonance_boundary`], [`auxiliary::detuning`] |
//! | 16 | `eq:Hp` | H_p | [`auxiliary::admissibility_sum`] |
//! | | `le:admissibilityBoundary` | h_p | [`admissibility_boundary::admissibility_boundary`] |
//! | 17 | `eq:alpha` | alpha | [`GrazingPoint::alpha`] |
//! | 18 | `eq:phipsigamma` | phi, psi, gamma | fields of [`GrazingPoint`] |
//! | | `th:codim11`, `th:codim1p` | generic grazing | [`GenericGrazing`] |
//! | 19 | `eq:xi` | xi_p | field of [`ResonantPoint`] |
//! | 20, 24 | `eq:c1`, `eq:cp` | s_p^+- | [`ResonantPoint::stability_coefficients`] |
//! | 21, 25 | `eq:coeffs1`, `eq:coeffsp` | c_SN, c_PD | [`ResonantPoint::saddle_node_coefficient`], [`ResonantPoint::period_doubling_coefficient`] |
//! | 22, 23, 26, 27 | `eq:sn1`, `eq:pd1`, `eq:snp`, `eq:pdp` | bifurcation curves | [`resonant_theorem::BifurcationCurve`] (continued: crate `grazing_continuation`) |
//! | | `th:codim21`, `th:codim2p` | resonant grazing | [`ResonantGrazing`] |
//!
//! All quantities of a [`GrazingPoint`] and of a [`ResonantPoint`] can be read off a numerical global map:
//! [`from_map`].
//!
//! Section 3, the linear oscillator:
//!
//! | eq. | label | what | where |
//! |---|---|---|---|
//! | 1, 2 | `eq:oscf`, `eq:oscResetLaw` | oscillator, reset law | crate `grazing_model`; parameters in [`LinearOscillator`] |
//! | | | omega_1 | [`LinearOscillator::damped_natural_frequency`] |
//! | 3, 4 | `eq:flow`, `eq:phip` | flow, periodic solution | crate `grazing_model` |
//! | 5 | `eq:Agraz` | A_graz and its slope | [`GrazingState::amplitude`], [`GrazingState::amplitude_derivative`] |
//! | 6 | (under `le:oscGraz`) | z_graz and its slope | [`GrazingState::phase`], [`GrazingState::phase_derivative`] |
//! | 7, 8 | `eq:oscphipsigamma`, `eq:oscalpha` | phi, psi, gamma, alpha | [`GrazingState::grazing_point`] |
//! | 9, 10 | `eq:oscA`, `eq:oscb`, `pr:oscAb` | A, b | [`GrazingState::linearised_map`] |
//! | 11 | `eq:osctaudelta` | tau, delta | [`GrazingState::trace`], [`GrazingState::determinant`] |
//! | | | beta | [`GrazingState::transversality`] |
//! | 12, 13 | `eq:resonance1`, `eq:resonancep` | resonances | [`LinearOscillator::resonance`], [`LinearOscillator::resonances`], [`LinearOscillator::virtual_resonance_frequency`] |
//! | | | a12 at a resonance | [`Resonance::off_diagonal`] |
//! | 14 | `eq:Ep` | E_p | [`GrazingState::decay`] |
//! | 15-17 | `eq:impFormula1odd`, `eq:impFormula1even`, `eq:impFormulap`, `pr:imp1`, `pr:impp` | a12', kappa_p', s_p^+-, c_SN, c_PD | [`Resonance::unfolding`], [`Resonance::stability_coefficients`], [`Resonance::saddle_node_coefficient`], [`Resonance::period_doubling_coefficient`] |
//!
//! Sections 4 and 5 and the appendices, as far as sections 2 and 3 rest on them (the maps themselves,
//! `eq:Pvirt2`, `eq:xjzj`, are in crate `grazing_model`, the VIVID function `eq:V` and the stability `eq:U`
//! to `eq:yDp` in crate `grazing_continuation`):
//!
//! | eq. | label | what | where |
//! |---|---|---|---|
//! | 4.3, 4.4 | `eq:xHatzHat`, `eq:x0z0` | virtual maxima | [`GrazingPoint::virtual_map`], [`GrazingPoint::virtual_map_after_reset`] |
//! | 4.5, 4.6 | `eq:Pdisc` | discontinuity map | [`GrazingPoint::discontinuity_map`] |
//! | 4.7 | `eq:SpTp`; A.4, A.5, A.10 to A.14 | S_p, T_p | [`auxiliary::lucas_sequence`], [`auxiliary::lucas_partial_sum`] |
//! | 4.8 | `eq:Hp9`; A.2, A.3, A.8, A.9 | H_p | [`auxiliary::admissibility_sum`] |
//! | 4.9-4.11 | `eq:Pglobalp`, `eq:Ap`, `eq:b1pb2p` | iterates | [`LinearisedMap::iterate`] |
//! | | `le:SpTp` | signs of S_p, T_p | tested on [`auxiliary::lucas_sequence`], [`auxiliary::lucas_partial_sum`] |
//! | 4.14, 4.17, 4.18 | `eq:Jac1Jac2`, `eq:V1`, `eq:V2` | J, K | [`GrazingPoint::vivid_linearisation`] |
//! | 4.15 | `eq:detJac1detJac2` | det J, det K | [`GrazingPoint::impact_jacobian_determinant`], [`GrazingPoint::parameter_jacobian_determinant`] |
//! | 4.16 | `eq:detJac2` | det K, factored | [`GrazingPoint::parameter_jacobian_determinant_factored`], [`auxiliary::geometric_sum_determinant`] |
//! | 4.19-4.22 | `eq:yStarpcodim1proof`, `eq:zStarpcodim1proof`, and for p = 1 | y*, z* | [`GrazingPoint::emerging_orbit`] |
//! | 4.23-4.29 | `eq:x0codim1proof` to `eq:affineMapj` | points on `Pi` | [`grazing::EmergingOrbit::visit_slope`] |
//! | 4.30-4.33 | `eq:ujcodim1proof` to `eq:ujeig1` | u^(j) | [`auxiliary::scaled_visit_position`] |
//! | 5.8 | `eq:fp` | f_p | [`ResonantPoint::off_diagonal_slope`] |
//! | 5.15, 5.17, 5.21 | `eq:ZM`, `eq:k1231`, `eq:k123p` | k_1, k_2, k_3 | [`ResonantPoint::branch_expansion`] |
//! | 5.19, 5.22 | `eq:Upsilon1`, `eq:Upsilonp` | Upsilon^+- | [`ResonantPoint::saddle_node_velocity_slope`], [`ResonantPoint::period_doubling_velocity_slope`] |
//! | 5.23 | `eq:admp7` | phase on the curves | [`resonant_theorem::BifurcationCurve`] |
//! | B.6, B.10 | `eq:xi1proof2`, `eq:xipproof2` | xi_p | [`GrazingState::second_phase_derivative`] |
//! | B.7, B.11 | `eq:xi1proof3`, `eq:xipproof3` | xi_p at a resonance | [`Resonance::second_phase_derivative`] |
//! | B.9, B.13 | `eq:xi1proof5`, `eq:xipproof5` | a12', kappa_p' | [`GrazingState::off_diagonal_derivative`], [`GrazingState::detuning_derivative`] |
//!
//! # Where the code departs from the print
//!
//! Misprints stand in `ERRATA.md`, each with the computation that decides it. Here they concern `s_p^+-` in
//! `eq:impFormulap`; `f_p`, and `a12'` in `eq:yT1`, which are derivatives along the grazing curve
//! ([`ResonantPoint::off_diagonal_slope`]); and the condition of `eq:Sp2`, which the functions here do not need.

pub mod admissibility_boundary;
pub mod auxiliary;
mod error;
pub mod from_map;
pub mod generic_theorem;
pub mod grazing;
pub mod hypothesis;
pub mod linear_oscillator;
pub mod resonant_theorem;
pub mod spectrum;
pub mod unfolding;

pub use error::TheoryError;
pub use generic_theorem::{GenericGrazing, Side};
pub use grazing::GrazingPoint;
pub use hypothesis::HypothesesViolated;
pub use linear_oscillator::{GrazingState, LinearOscillator, Resonance};
pub use resonant_theorem::ResonantGrazing;
pub use spectrum::LinearisedMap;
pub use unfolding::{ResonantPoint, Unfolding};
