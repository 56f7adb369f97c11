//! Numerical continuation of maximal periodic solutions (MPSs) and of their bifurcations.
//!
//! An MPS is a zero of two smooth equations in (y, z, μ, η), impact velocity, impact phase and the
//! two parameters ([`mps`]): the VIVID function of the paper (section 4.3), or a form without
//! virtual points, in which curves are followed. A further [`Condition`](locate::Condition) defines
//! a curve: a fixed η a one-parameter branch, a multiplier ±1 a curve of saddle-node or
//! period-doubling bifurcations, a product 1 of complex multipliers one of torus bifurcations, an
//! interior maximum at the wall a curve of grazing bifurcations. A second condition defines a
//! point: a bifurcation on a branch, a codimension-two point on a curve, a resonance.
//!
//! ```text
//! tolerances                 what counts as zero, as equal and as lost
//! newton, arclength          small systems, curves of zeros; know nothing of impacts
//!   └─ mps                   the equations, with impacts or without; what is known of a solution
//!        └─ locate, curve    conditions, points, curves with events and named ends
//!             └─ resonance   resonant grazing points and the curves that leave them in the direction of the theory
//!                  └─ fit    quadratic coefficients measured on these curves
//!   mps ─ flights            the motion of a solution, its maxima, what is known of it
//!   mps ─ criticality        normal form of period doublings, from third derivatives
//!   mps ─ doubled            orbits with two impacts that leave period doublings, and where they graze
//! cascade                    period doubling after period doubling in the limit map
//! ```
//!
//! ```
//! use grazing_continuation::arclength::StepControl;
//! use grazing_continuation::bifurcation::Bifurcation;
//! use grazing_continuation::curve::{SolutionCurve, Route, Window};
//! use grazing_continuation::locate::Condition;
//! use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
//! use grazing_model::LinearOscillator;
//!
//! // The branch of one-loop solutions that begins where a linear oscillator grazes at omega = 0.85.
//! let grazing = grazing_theorems::LinearOscillator::new(0.021, 0.9)?.grazing(0.85)?;
//! let oscillator = LinearOscillator::new(0.021, 0.9, grazing.amplitude(), 0.85)?;
//! let equations = LoopEquations::new(oscillator, 1, Formulation::FixedPhase);
//! let branch = SolutionCurve { equations, condition: Condition::Secondary(0.85) };
//! let window = Window { primary: [0.2, 1.0], secondary: [0.8, 0.9] };
//! let control = StepControl::DRAWING;
//! let route = Route { window, control, step_limit: 5000, stop_at_events: false, pace: None };
//! let start = Unknowns::new(0.0, grazing.phase(), grazing.amplitude(), 0.85);
//! let curve = branch.follow(start.clone(), start.along(0), EventTimes::default(), &route)?;
//! let kinds: Vec<_> = curve.events.iter().filter_map(|event| Bifurcation::of(event.condition, 1)).collect();
//! assert!(kinds.contains(&Bifurcation::PeriodDoubling), "{kinds:?}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod arclength;
pub mod bifurcation;
pub mod cascade;
pub mod criticality;
pub mod curve;
pub mod cusp;
pub mod doubled;
mod emerging;
pub mod fit;
pub mod flights;
mod follow;
pub mod locate;
pub mod mps;
pub mod newton;
pub mod regula_falsi;
pub mod resonance;
mod solution;
pub mod tolerances;
pub mod unknowns;
