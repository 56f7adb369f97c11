//! Theorems 2.2 to 2.5 in action: predictions compared with continuation and simulation, case by case.
//!
//! The theorems predict the behaviour at the grazing bifurcations of many linear oscillators, which is
//! computed in two ways. *Continuation* follows the branch of MPSs, or the saddle-node and
//! period-doubling curves, from the grazing point and decides admissibility over the whole orbit.
//! *Simulation* takes all solutions that can be MPSs from a quadratic equation ([`closed_form`]) and
//! starts the hybrid system there ([`grazing_unfold::simulation`]). [`generic`] is for theorems 2.2 and
//! 2.3, [`resonant`] for 2.4 and 2.5; [`cases`] lists the cases, and [`CaseVerdict`] is the result of
//! each.
//!
//! Where a hypothesis fails the theorem is silent. The observed behaviour must then have an explanation,
//! which is checked as well: to first order (section 4) a loop meets the wall, or none does.

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

/// The results for all cases, in the order of the list; `step` is called after each.
///
/// # Errors
/// The first case that could not be computed.
pub fn rows<R: Send>(
    cases: &[Case],
    work: impl Fn(Case) -> Result<R, CheckError> + Sync,
    step: impl Fn() + Sync,
) -> Result<Vec<R>, CheckError> {
    cases.par_iter().map(|case| work(*case).inspect(|_| step())).collect()
}

/// The sign of a parameter for which something exists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Existence {
    /// Existence for this sign only.
    On(Side),
    /// Existence for neither sign.
    Nowhere,
    /// Existence for both signs, or not equally at all values tested.
    Unclear,
}

impl Existence {
    /// The existence from observations for positive and for negative values of the parameter.
    pub(crate) fn of([positive, negative]: [bool; 2]) -> Self {
        match (positive, negative) {
            (true, false) => Self::On(Side::Positive),
            (false, true) => Self::On(Side::Negative),
            (false, false) => Self::Nowhere,
            (true, true) => Self::Unclear,
        }
    }

    /// The existence of admissible solutions along a curve, by the side of a parameter relative to its
    /// value at the start; clear if there are more than `points` points and all those after the start
    /// agree.
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

/// The route for the first points of a curve in an unbounded window, with steps of one length.
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

/// The number of points of a curve that are tested.
const POINTS: usize = 5;

/// The verdict on a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum CaseVerdict {
    /// The hypotheses hold, and everything that the theorem concludes is observed.
    Agreement,
    /// A hypothesis fails, and the observed behaviour is as expected for this reason.
    Explained(&'static str),
    /// The observed behaviour is neither concluded nor explained.
    Unexplained,
}

/// The reason if a₁₂ α < 0 and there is no MPS: whenever y > 0 an interior loop meets the wall.
const VIRTUAL_ORBIT: &str = "virtual orbit, a12 alpha < 0";
/// The reason if τ < h_p and there is no MPS: whenever y > 0 an interior loop meets the wall.
const INTERIOR_LOOP: &str = "interior loop meets the wall, tau < h_p";
/// The reason if τ < h_p and there is an MPS nevertheless, since no interior loop meets the wall. The
/// theorem is silent.
const ORBIT_BELOW_THE_BOUNDARY: &str = "orbit exists, tau < h_p";
/// The reason if a₁₂ α < 0 and τ < h_p and there is an MPS nevertheless: no interior loop meets the wall.
const ORBIT_WITH_NEGATIVE_FACTOR: &str = "orbit exists, a12 alpha < 0 and tau < h_p";
/// The reason if s_p⁺ or s_p⁻ vanishes (ε = 1/E_p): its curve does not emerge from the resonance.
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
