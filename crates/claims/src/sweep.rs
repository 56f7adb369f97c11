//! Theorems 2.2 to 2.5 in action: predictions against continuation and simulation, case by case.
//!
//! Theorems say what happens at the grazing bifurcations of many linear oscillators; two routes see
//! it. *Continuation* follows the branch of MPSs, or the saddle-node and period-doubling curves,
//! from the grazing point and decides admissibility over the whole orbit. *Simulation* takes all
//! solutions that can be MPSs from a quadratic equation ([`closed_form`]) and starts the hybrid
//! system there ([`grazing_unfold::simulation`]). [`generic`] is for theorems 2.2 and 2.3,
//! [`resonant`] for 2.4 and 2.5; [`cases`] lists the cases, and [`CaseVerdict`] is what each comes
//! to.
//!
//! Where a hypothesis fails the theorem is silent. What is seen there has to have a reason, which
//! is checked as well: to first order (section 4) a loop meets the wall, or none does.

pub mod cases;
pub mod closed_form;
pub mod generic;
pub mod resonant;

use crate::*;
use grazing_continuation::curve::Curve;
use rayon::prelude::*;

pub use cases::{Case, generic_cases, resonant_cases};
pub use generic::GenericRow;
pub use resonant::ResonantRow;

/// What comes of all cases, in the order of the list; `step` is called after each.
///
/// # Errors
/// The first case that could not be worked out.
pub fn rows<R: Send>(
    cases: &[Case],
    work: impl Fn(Case) -> Result<R, Failure> + Sync,
    step: impl Fn() + Sync,
) -> Result<Vec<R>, Failure> {
    cases.par_iter().map(|case| work(*case).inspect(|_| step())).collect()
}

/// For which sign of a parameter something exists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Existence {
    /// For this sign only.
    On(Side),
    /// For none.
    Nowhere,
    /// For both signs, or not the same at all values that were looked at.
    Unclear,
}

impl Existence {
    /// Of what is seen where the parameter is positive, and where it is negative.
    pub(crate) fn of([positive, negative]: [bool; 2]) -> Self {
        match (positive, negative) {
            (true, false) => Self::On(Side::Positive),
            (false, true) => Self::On(Side::Negative),
            (false, false) => Self::Nowhere,
            (true, true) => Self::Unclear,
        }
    }

    /// Of admissible solutions along a curve on which one of the parameters is on one side of its
    /// value at the start; clear if there are so many points after the start and all are alike.
    fn along(curve: &Curve, parameter: usize, start: f64, points: usize) -> Self {
        let mut seen = curve.points.iter().skip(1).map(|point| {
            let ahead = point.solution.parameters()[parameter] - start;
            (Side::of(ahead), point.solution.admissible())
        });
        match seen.next() {
            Some(first) if curve.points.len() > points && seen.all(|point| point == first) => match first {
                (side, true) => Self::On(side),
                (_, false) => Self::Nowhere,
            },
            _ => Self::Unclear,
        }
    }
}

/// The first points of a curve, wherever it goes, in steps of one length.
fn first_points(length: f64, shortest: f64, turn: f64) -> Route<'static> {
    let everywhere = [f64::NEG_INFINITY, f64::INFINITY];
    let steps = StepControl { first: length, longest: length, shortest, turn, ..StepControl::DRAWING };
    Route {
        window: Window { primary: everywhere, secondary: everywhere },
        control: steps,
        step_limit: POINTS,
        stop_at_events: false,
        pace: None,
    }
}

/// Points of a curve that are looked at.
const POINTS: usize = 5;

/// What a case comes to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum CaseVerdict {
    /// The hypotheses hold, and all that the theorem concludes is seen.
    Agreement,
    /// A hypothesis fails, and what is seen is what this reason lets one expect.
    Explained(&'static str),
    /// What is seen is neither concluded nor explained.
    Unexplained,
}

/// a₁₂ α < 0, and no MPS: whenever y > 0 an interior loop meets the wall.
const VIRTUAL_ORBIT: &str = "virtual orbit, a12 alpha < 0";
/// τ < h_p, and no MPS: whenever y > 0 an interior loop meets the wall.
const INTERIOR_LOOP: &str = "interior loop meets the wall, tau < h_p";
/// τ < h_p, and an MPS all the same, as no interior loop meets the wall. The theorem is silent.
const ORBIT_BELOW_THE_BOUNDARY: &str = "orbit exists, tau < h_p";
/// a₁₂ α < 0 and τ < h_p, and an MPS all the same: no interior loop meets the wall.
const ORBIT_WITH_NEGATIVE_FACTOR: &str = "orbit exists, a12 alpha < 0 and tau < h_p";
/// s_p⁺ or s_p⁻ vanishes (ε = 1/E_p): its curve does not come out of the resonance.
const NO_CURVE: &str = "no curve, s_p^+ or s_p^- is zero";

impl CaseVerdict {
    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Agreement => "agreement",
            Self::Explained(_) => "explained",
            Self::Unexplained => "unexplained",
        }
    }

    /// The reason in tables, empty for an agreement.
    pub fn reason(self) -> &'static str {
        if let Self::Explained(reason) = self { reason } else { "" }
    }
}
