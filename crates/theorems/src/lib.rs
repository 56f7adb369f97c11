//! The formulas and theorems of the paper as functions and checked types.
//!
//! "The paper" is D. J. W. Simpson and I. Ghosh, *Resonant grazing bifurcations revisited*, arXiv
//! 2602.22797. Every formula of its sections 2 and 3, and those of section 4, section 5 and the
//! appendices on which they depend, is one public function, named by its meaning; its docs cite the
//! label. Equation numbers restart in each section of the paper, so they are cited with the
//! section. The crate does no I/O and contains no parameter values.
//!
//! A theorem is a type, [`GenericGrazing`] or [`ResonantGrazing`], of which a value exists only if
//! the hypotheses hold; it keeps them, with their values, and gives the conclusion. When a
//! hypothesis fails, the result is a [`HypothesesViolated`] error that names it.
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
//! | section | what | where |
//! |---|---|---|
//! | 2.2, 2.3, 4.2 | the global map to first order, its eigenvalues and iterates, the non-impacting solution | [`spectrum`] |
//! | 2.4, 4.2, A | g_p, kappa_p, H_p, S_p, T_p, u^(j) | [`auxiliary`] |
//! | 2.4, A | h_p | [`admissibility_boundary`] |
//! | ours | where p-loop solutions are admissible over the whole trapesium | [`admissibility_region`] |
//! | 2.5, 4 | the discontinuity map, the VIVID function, what emerges at grazing, to leading order | [`grazing`] |
//! | 2.5 | Theorems 2.2 and 2.3 | [`generic_theorem`] |
//! | 2.6, 5 | s_p^+-, c_SN, c_PD, the branch and the curves at a resonance, to leading order | [`unfolding`] |
//! | 2.6 | Theorems 2.4 and 2.5 | [`resonant_theorem`] |
//! | ours | solutions of more loops at a one-loop resonance | [`iterated`] |
//! | ours | all motion near a resonance with one impact in p periods, to leading order | [`limit_map`] |
//! | 3, B | the linear oscillator, Propositions 3.1 to 3.3 | [`linear_oscillator`] |
//!
//! All quantities of a [`GrazingPoint`] and of a [`ResonantPoint`] can be read off a numerical
//! global map: [`from_map`]. The maps themselves are in crate `grazing_model`, the VIVID function
//! and the stability of its zeros in crate `grazing_continuation`. `expected/claims.toml` names the
//! functions of every label, which tests look up: `cargo xtask claims eq:gp --explain`.
//!
//! # Where the code departs from the paper
//!
//! Misprints are listed in `ERRATA.md`, each with the computation that decides it. Those relevant
//! here are in `s_p^+-` in `eq:impFormulap`; `f_p`, and `a12'` in `eq:yT1`, which are derivatives
//! along the grazing curve ([`ResonantPoint::off_diagonal_slope`]); and the condition of `eq:Sp2`,
//! which the functions here do not need.

pub mod admissibility_boundary;
pub mod admissibility_region;
pub mod auxiliary;
mod error;
pub mod from_map;
pub mod generic_theorem;
pub mod grazing;
pub mod hypothesis;
pub mod iterated;
pub mod limit_map;
pub mod linear_oscillator;
pub mod resonant_theorem;
pub mod spectrum;
pub mod unfolding;

pub use error::TheoryError;
pub use generic_theorem::{GenericGrazing, Side};
pub use grazing::GrazingPoint;
pub use hypothesis::HypothesesViolated;
pub use limit_map::LimitMap;
pub use linear_oscillator::{GrazingState, LinearOscillator, Resonance};
pub use resonant_theorem::ResonantGrazing;
pub use spectrum::LinearisedMap;
pub use unfolding::{ResonantPoint, Unfolding};
