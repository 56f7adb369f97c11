//! The properties of a periodic solution: multipliers, stability, highest maximum, admissibility.

use grazing_model::motion::Maximum;
use grazing_theorems::spectrum::Eigenvalues;

use crate::tolerances::{self, FORGOTTEN, STABILITY, UNSETTLED_MULTIPLIERS};
use crate::unknowns::{Unknowns, parameters};

/// Trace T and determinant D of the matrix U whose eigenvalues are the stability multipliers (eq:U,
/// eq:TD).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multipliers {
    /// The trace T.
    pub trace: f64,
    /// The determinant D.
    pub determinant: f64,
}

impl Multipliers {
    /// Whether both multipliers lie inside the unit circle: |T| − 1 < D < 1.
    ///
    /// On the boundary the MPS does not count as stable.
    pub fn stable(&self) -> bool {
        self.trace.abs() - 1.0 < self.determinant - STABILITY && self.determinant < 1.0 - STABILITY
    }

    /// Whether both multipliers lie on the unit circle and are not real, as without damping: nearby
    /// motion neither approaches nor leaves.
    pub fn neutral(&self) -> bool {
        self.trace.abs() < 2.0 - STABILITY && (self.determinant - 1.0).abs() <= STABILITY
    }

    /// The larger modulus of the multipliers.
    pub fn radius(&self) -> f64 {
        Eigenvalues::from_trace_and_determinant(self.trace, self.determinant).spectral_radius()
    }

    /// Whether so many periods leave nothing of a small difference but rounding.
    pub fn forget(&self, periods: u32) -> bool {
        libm::pow(self.radius(), f64::from(periods)) < FORGOTTEN
    }

    /// Whether the multipliers are a pair of complex numbers that are not real.
    pub fn complex(&self) -> bool {
        self.trace * self.trace < 4.0 * self.determinant
    }

    /// The larger of |T| and |D|, a measure of how violent the motion is.
    pub fn size(&self) -> f64 {
        self.trace.abs().max(self.determinant.abs())
    }
}

/// The stability of a zero of the equations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StabilityFunctions {
    pub(crate) multipliers: Multipliers,
    /// The [`characteristic`](crate::mps::LoopPair::characteristic) for the multiplier 1; the next
    /// field is for −1.
    pub(crate) saddle_node: f64,
    pub(crate) period_doubling: f64,
    /// The characteristic for the multiplier −1 over half a period, for symmetric motion; the other
    /// fields then also belong to half a period, where they can vanish.
    pub(crate) pitchfork: Option<f64>,
    /// The [`product_less`](crate::mps::LoopPair::product_less).
    pub(crate) torus: f64,
    /// The size of D round trip · adj D impact, whose ratio to det D impact is the matrix with the
    /// multipliers: how sensitive motion is, also where the multipliers themselves are small. It stays
    /// finite at y = 0.
    pub(crate) violence: f64,
}

impl StabilityFunctions {
    /// The stability of motion that goes far away.
    pub(crate) const UNKNOWN: Self = Self {
        multipliers: Multipliers { trace: f64::NAN, determinant: f64::NAN },
        saddle_node: f64::NAN,
        period_doubling: f64::NAN,
        pitchfork: None,
        torus: f64::NAN,
        violence: f64::NAN,
    };

    /// The stability over a whole period from that over half a period: multipliers are squared.
    pub(crate) fn of_the_square(self) -> Self {
        let Multipliers { trace, determinant } = self.multipliers;
        let multipliers =
            Multipliers { trace: trace * trace - 2.0 * determinant, determinant: determinant * determinant };
        // A sum of squares: T² + (1 − D)² over half a period.
        let period_doubling = 1.0 + multipliers.trace + multipliers.determinant;
        let violence = self.violence * self.violence;
        Self { multipliers, period_doubling, pitchfork: Some(self.period_doubling), violence, ..self }
    }

    /// Whether some function has changed by more than its own size, so that a correction as large
    /// as the last one may change its sign.
    pub(crate) fn is_unsettled_since(&self, before: &Self) -> bool {
        let changed = |of: fn(&Self) -> f64| (of(self) - of(before)).abs() >= of(self).abs();
        self.multipliers.size() < UNSETTLED_MULTIPLIERS
            && (changed(|stability| stability.saddle_node) || changed(|stability| stability.period_doubling))
    }
}

/// A periodic solution, which is a zero of the equations: a maximal periodic solution (MPS) of the
/// paper for p ≥ 1, motion without impacts for p = 0.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicSolution {
    /// The number of loops p, or of forcing periods with more than one impact; 0 without impacts.
    pub loops: u32,
    /// The unknowns (y, z, μ, η), (y, z, μ, η, y₂, …), or (x, y, μ, η) without impacts.
    pub unknowns: Unknowns,
    /// Trace and determinant of U; infinite or NaN at y = 0. Without impacts these belong to the
    /// flow over a forcing period.
    pub multipliers: Multipliers,
    /// The highest local maximum of x between the recoil and the next impact, if there is one;
    /// without impacts the highest point.
    pub highest_interior_maximum: Option<Maximum>,
}

impl PeriodicSolution {
    /// Height above the wall up to which an interior maximum counts as touching it.
    pub const TOUCH: f64 = tolerances::TOUCH;

    /// The impact velocity y, the lowest of all impacts; 0 without impacts.
    pub fn impact_velocity(&self) -> f64 {
        if self.has_impacts() { self.unknowns.lowest_velocity().1 } else { 0.0 }
    }

    /// The number of impacts, 0 without any.
    pub fn impacts(&self) -> usize {
        if self.has_impacts() { self.unknowns.impacts() } else { 0 }
    }

    /// Whether there is an impact in p forcing periods.
    pub fn has_impacts(&self) -> bool {
        self.loops > 0
    }

    /// The primary and the secondary parameter (μ, η).
    pub fn parameters(&self) -> [f64; 2] {
        parameters(&self.unknowns)
    }

    /// The highest interior maximum of x, or −∞ if x has no interior maximum.
    pub fn ceiling(&self) -> f64 {
        self.highest_interior_maximum.map_or(f64::NEG_INFINITY, |maximum| maximum.position)
    }

    /// Whether this is a valid solution of the hybrid system: y > 0 if there are impacts, and no
    /// interior maximum of x above the wall at any time.
    pub fn admissible(&self) -> bool {
        (!self.has_impacts() || self.impact_velocity() > 0.0) && self.ceiling() <= Self::TOUCH
    }

    /// Whether an interior maximum of x lies above the wall.
    pub(crate) fn touches(&self) -> bool {
        self.ceiling() > Self::TOUCH
    }

    /// Whether the solution is stable and admissible: motion may settle on it.
    pub fn attracts(&self) -> bool {
        self.stable() && self.admissible()
    }

    /// Whether the solution is asymptotically stable in the hybrid system, regardless of
    /// admissibility.
    pub fn stable(&self) -> bool {
        self.multipliers.stable()
    }
}
