//! The ledger of claims: the statements of the paper, label by label, and the checks of each statement.
//!
//! `expected/claims.toml` lists every numbered equation, lemma, proposition and theorem, and every number
//! in text and captions ([`ledger`]). Most entries name a check, a function in this crate that measures
//! how well the statement holds ([`outcome`]): the largest deviation of an identity, the order with which
//! a remainder vanishes, the smallest margin of an inequality in an adversarial search, the number of
//! cases in which a conclusion holds. Where print and mathematics differ, the printed form has to fail.
//!
//! Expansions and theorems are measured on the paper's oscillator and on others ([`specimen`]). Checks draw
//! and search with [`sampling`], measure orders with [`convergence`], and keep the extremes in a [`tally`].
//!
//! This crate neither reads files nor prints; sampling is seeded, so every run measures the same.

pub mod audit;
pub mod checks;
pub mod convergence;
mod differences;
mod eigenvalues;
pub mod errata;
pub mod ledger;
pub mod outcome;
pub mod published;
pub mod sampling;
mod solutions;
pub mod source;
pub mod specimen;
pub mod sweep;
pub mod tally;

// Imports for the checks.
use core::f64::consts::{PI, TAU};
use core::ops::RangeInclusive;

use grazing_continuation::arclength::StepControl;
use grazing_continuation::curve::{Route, Window};
use grazing_continuation::fit::quadratic_coefficient;
use grazing_continuation::locate::Condition;
use grazing_continuation::mps::{
    EventTimes, Formulation, LoopEquations, Multipliers, PeriodicSolution, Round, Unknowns, unknown,
};
use grazing_continuation::resonance::ResonantGrazingPoint;
use grazing_model::maps::{MapError, discontinuity_map, global_iterate, global_map, virtual_map};
use grazing_model::motion::Motion;
use grazing_model::orbit::{FlightEnd, Orbit, OrbitEnd};
use grazing_model::{AtRest, ImpactOscillator, OnWall, State, Surface};
use grazing_theorems::admissibility_boundary::admissibility_boundary;
use grazing_theorems::auxiliary::{
    admissibility_sum, detuning, geometric_sum_determinant, lucas_partial_sum, lucas_sequence, modulus_power,
    resonance_boundary, scaled_visit_position,
};
use grazing_theorems::from_map::GrazingOrbit;
use grazing_theorems::grazing::{VirtualMap, VividLinearisation};
use grazing_theorems::hypothesis::Quantity;
use grazing_theorems::{
    GenericGrazing, GrazingPoint, GrazingState, LinearisedMap, Resonance, ResonantPoint, Side,
};
use grazing_unfold::simulation::ReturnOutcome;
use nalgebra::{Complex, Matrix2, Vector2};

use convergence::{
    Observed, SLACK_AT_GRAZING, lowest, of_orders, order, remembered, seam, together, uniform_order,
};
use differences::{curvature, slope};
use eigenvalues::{EigenvaluePair, power};
use outcome::{CheckError, CheckResult, Measure, Outcome};
use published::{printed, printed_at_resonances};
use sampling::{Sampler, drawn, drawn_over, over, sampled, smallest};
use solutions::{at_parameters, at_velocity, attracts, equations, followed, located, unknowns, vivid, zero};
use specimen::generic::{
    at_specimens, delayed, directions, map_with, sampled_map, sampled_point, smallest_order, specimens,
    specimens_with,
};
use specimen::resonant::{
    ANY, EVERYWHERE, Loops, MANY, Near, ONE, Offset, ResonantSpecimen, Symbols, TheoremCurve, all_orders,
    everywhere, offsets, orders, orders_against_print, scaled,
};
use specimen::{DELAY, Exponential, Grazing, Law, Specimen, at_grazing, damping_for_decay};
use sweep::Existence;
use tally::{Deviations, Smallest, Votes};
