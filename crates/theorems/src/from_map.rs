//! The quantities of section 2 read off the numerical global map of any oscillator.
//!
//! No closed form is used here: the grazing orbit is found by Newton's method on P_global, and
//! every coefficient is a first or second derivative of P_global. For the linear oscillator the
//! results agree with [`linear_oscillator`](crate::linear_oscillator).

use grazing_model::maps::MapError;
use grazing_model::motion::Motion;
use grazing_model::{AnyOscillator, AtRest, ImpactOscillator, MapJet, OnWall, Passage, Passed, State};
use nalgebra::{Matrix2, Vector2, Vector3};
use smallvec::SmallVec;

use crate::auxiliary::detuning;
use crate::grazing::GrazingPoint;
use crate::spectrum::LinearisedMap;
use crate::unfolding::{ResonantPoint, Unfolding};

/// The grazing periodic orbit could not be found.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum GrazingOrbitError {
    /// P_global is not defined at an iterate.
    #[error("the global map is not defined near the grazing orbit: {0}")]
    Map(#[from] MapError),
    /// Newton's method did not converge.
    #[error("no grazing orbit found at eta = {eta}: Newton's method ended with residual {residual:.1e}")]
    NoConvergence {
        /// The secondary parameter.
        eta: f64,
        /// Norm of the last residual.
        residual: f64,
    },
}

/// Longest step of Newton's method, in radians and units of the primary parameter: all quantities
/// are of order one, so a longer one diverges.
const LONGEST_STEP: f64 = 1e3;

/// A point of the grazing curve at one value of the secondary parameter η, with the direction of
/// the curve.
#[derive(Clone, Debug, PartialEq)]
pub struct GrazingPlace {
    /// The grazing phase z_graz, in radians.
    pub phase: f64,
    /// The parameters primary_graz and η.
    pub parameters: [f64; 2],
    /// The slopes d(z_graz, primary_graz)/dη, right to some seven digits; NaN at a fold of the
    /// grazing curve.
    slopes: Vector2<f64>,
    /// The way of the grazing orbit from Π back to Π.
    passage: Passage,
}

impl GrazingPlace {
    /// The place at the secondary parameter of `oscillator`, by Newton's method for P_global(0, z;
    /// primary) = (0, z) from the oscillator's own primary parameter and the phase `near`.
    ///
    /// # Errors
    /// P_global is not defined at an iterate, or there is no convergence.
    pub fn find<O: ImpactOscillator>(oscillator: &O, near: f64) -> Result<Self, GrazingOrbitError> {
        Self::along(oscillator, near, Passage::direct())
    }

    /// As [`find`](Self::find), of an orbit that may have impacts elsewhere.
    ///
    /// # Errors
    /// As [`find`](Self::find).
    pub fn along<O: ImpactOscillator>(
        oscillator: &O,
        near: f64,
        passage: Passage,
    ) -> Result<Self, GrazingOrbitError> {
        let [mut primary, eta] = oscillator.parameters();
        let mut phase = near;
        let mut residual = f64::INFINITY;
        for _ in 0..30 {
            let here = oscillator.with_parameters([primary, eta]);
            let mut way = passage.clone();
            let map = way.global_map::<O, 1>(&here, AtRest::new(0.0, phase))?.jet;
            let defect = Vector2::new(map.value[0], map.value[1] - phase);
            residual = defect.norm();
            let jacobian = by_phase_and_primary(&map).lu();
            let Some(step) = jacobian.solve(&defect).filter(|step| step.norm() <= LONGEST_STEP) else {
                break;
            };
            phase -= step[0];
            primary -= step[1];
            // Quadratic convergence: the step after one of this size is lost in rounding.
            if step.norm() <= 1e-8 {
                let passage = settled(passage, way);
                return Ok(Self { phase, parameters: [primary, eta], slopes: slopes(&map), passage });
            }
        }
        Err(GrazingOrbitError::NoConvergence { eta, residual })
    }

    /// The place at a nearby value of η.
    ///
    /// # Errors
    /// P_global is not defined at an iterate, or there is no convergence.
    pub fn moved<O: ImpactOscillator>(&self, oscillator: &O, eta: f64) -> Result<Self, GrazingOrbitError> {
        let [primary, from] = self.parameters;
        let step = self.slopes * (eta - from);
        let there = oscillator.with_parameters([primary + step[1], eta]);
        Self::along(&there, self.phase + step[0], self.passage.clone())
    }
}

/// The passage with the times of the way that was found; without impacts the forcing period is a
/// guess that serves everywhere.
fn settled(passage: Passage, way: Passage) -> Passage {
    if passage.impacts() > 0 { way } else { passage }
}

/// Derivative of P_global(0, z; primary) − (0, z).
fn by_phase_and_primary(map: &MapJet<AtRest, AtRest>) -> Matrix2<f64> {
    let mut jacobian: Matrix2<f64> = map.jacobian.fixed_columns::<2>(1).into_owned();
    jacobian[(1, 0)] -= 1.0;
    jacobian
}

/// The slopes d(z_graz, primary_graz)/dη.
fn slopes(map: &MapJet<AtRest, AtRest>) -> Vector2<f64> {
    let by_eta = map.jacobian.column(3).into_owned();
    -by_phase_and_primary(map).lu().solve(&by_eta).unwrap_or(Vector2::repeat(f64::NAN))
}

/// The grazing periodic orbit of an oscillator at one value of the secondary parameter.
///
/// Paper: Assumption 2.2 with μ = primary − primary_graz(η): the change of parameter that puts
/// grazing at μ = 0.
#[derive(Clone, Debug)]
pub struct GrazingOrbit<O = AnyOscillator> {
    oscillator: O,
    phase: f64,
    map: MapJet<AtRest, AtRest>,
    /// The slopes d(z_graz, primary_graz)/dη.
    slopes: Vector2<f64>,
    passage: Passage,
    impacts: SmallVec<[OnWall; 2]>,
}

impl<O: ImpactOscillator> GrazingOrbit<O> {
    /// The grazing orbit at the secondary parameter of `oscillator`, near its own primary parameter
    /// and the phase `near`.
    ///
    /// # Errors
    /// P_global is not defined at an iterate, or there is no convergence.
    pub fn find(oscillator: &O, near: f64) -> Result<Self, GrazingOrbitError> {
        Self::of(oscillator, GrazingPlace::find(oscillator, near)?)
    }

    /// As [`find`](Self::find), of an orbit that may have impacts elsewhere.
    ///
    /// # Errors
    /// As [`find`](Self::find).
    pub fn along(oscillator: &O, near: f64, passage: Passage) -> Result<Self, GrazingOrbitError> {
        Self::of(oscillator, GrazingPlace::along(oscillator, near, passage)?)
    }

    /// The grazing orbit at a place.
    ///
    /// # Errors
    /// P_global is not defined there.
    pub fn of(oscillator: &O, place: GrazingPlace) -> Result<Self, GrazingOrbitError> {
        Self::through(oscillator.with_parameters(place.parameters), place.phase, place.passage)
    }

    /// The grazing orbit known to pass through (0, 0, phase) at the oscillator's parameters.
    ///
    /// At a fold of the grazing curve, where μ_graz has no derivative in η, the slopes are not
    /// numbers.
    ///
    /// # Errors
    /// P_global is not defined there.
    pub fn at(oscillator: O, phase: f64) -> Result<Self, GrazingOrbitError> {
        Self::through(oscillator, phase, Passage::direct())
    }

    /// As [`at`](Self::at), of an orbit that may have impacts elsewhere.
    ///
    /// # Errors
    /// As [`at`](Self::at).
    pub fn through(oscillator: O, phase: f64, passage: Passage) -> Result<Self, GrazingOrbitError> {
        let mut way = passage.clone();
        let Passed { jet: map, impacts } = way.global_map::<O, 2>(&oscillator, AtRest::new(0.0, phase))?;
        let passage = settled(passage, way);
        Ok(Self { oscillator, phase, slopes: slopes(&map), map, passage, impacts })
    }

    /// The place of the orbit on the grazing curve.
    pub fn place(&self) -> GrazingPlace {
        let parameters = self.oscillator.parameters();
        let passage = self.passage.clone();
        GrazingPlace { phase: self.phase, parameters, slopes: self.slopes, passage }
    }

    /// The way of the orbit from Π back to Π.
    pub fn passage(&self) -> &Passage {
        &self.passage
    }

    /// The impacts of the orbit elsewhere, in the order of time.
    pub fn impacts(&self) -> &[OnWall] {
        &self.impacts
    }

    /// The highest maximum of x between the impacts elsewhere, or −∞ if there is none; the one that
    /// touches the wall is one of them.
    pub fn ceiling(&self) -> f64 {
        let recoils = self.impacts.iter().map(|&impact| self.oscillator.reset::<1>(impact).image().into());
        let starts = [State::on_wall(0.0, self.phase)].into_iter().chain(recoils);
        let flights = starts.zip(self.passage.times(&self.oscillator));
        let tops = flights.filter_map(|(from, time)| self.oscillator.motion(from).highest_maximum(time));
        tops.map(|top| top.position).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The oscillator at grazing.
    pub fn oscillator(&self) -> &O {
        &self.oscillator
    }

    /// The grazing phase z_graz, in radians.
    pub fn phase(&self) -> f64 {
        self.phase
    }

    /// The primary parameter at grazing.
    pub fn primary(&self) -> f64 {
        self.oscillator.parameters()[0]
    }

    /// The slope d z_graz/dη.
    pub fn phase_slope(&self) -> f64 {
        self.slopes[0]
    }

    /// The slope d primary_graz/dη.
    pub fn primary_slope(&self) -> f64 {
        self.slopes[1]
    }

    /// P_global to second order at the grazing point; (0, z_graz) is its fixed point.
    pub fn map(&self) -> &MapJet<AtRest, AtRest> {
        &self.map
    }

    /// A, b, ω, γ, φ, ψ at grazing. Paper: eq:A, eq:b, eq:phipsigamma.
    pub fn grazing_point(&self) -> GrazingPoint {
        let reset = self.oscillator.reset::<1>(OnWall::new(0.0, self.phase));
        GrazingPoint {
            map: LinearisedMap { a: self.map.derivative(), b: self.map.jacobian.column(2).into_owned() },
            forcing_frequency: self.oscillator.forcing_frequency().value,
            gamma: -self.oscillator.acceleration(State::on_wall(0.0, self.phase)),
            phi: -reset.jacobian[(0, 0)],
            psi: reset.jacobian[(1, 0)],
        }
    }

    /// The derivative dA/dη along the grazing curve: z_graz and the primary parameter move with η.
    pub fn derivative_of_map(&self) -> Matrix2<f64> {
        self.derivative_along(&Vector3::new(self.slopes[0], self.slopes[1], 1.0))
    }

    /// The derivative of A along a tangent (z, μ, η) of the grazing curve, which exists at folds as
    /// well.
    pub fn derivative_along(&self, tangent: &Vector3<f64>) -> Matrix2<f64> {
        Matrix2::from_fn(|i, j| {
            let hessian = &self.map.hessians[i];
            hessian[(j, 1)] * tangent[0] + hessian[(j, 2)] * tangent[1] + hessian[(j, 3)] * tangent[2]
        })
    }

    /// The function that vanishes at a resonance, with its derivative along a direction in which A
    /// changes at the rate `rate`.
    ///
    /// a₁₂ for p = 1; κ_p = τ − g_p(δ) for p ≥ 2, which is NaN where δ ≤ 0. Paper: eq:gp, section
    /// 2.6.
    pub fn detuning(&self, loops: u32, rate: &Matrix2<f64>) -> [f64; 2] {
        let a = self.map.derivative();
        if loops == 1 {
            return [a[(0, 1)], rate[(0, 1)]];
        }
        let determinant_rate = rate[(0, 0)] * a[(1, 1)] + a[(0, 0)] * rate[(1, 1)]
            - rate[(0, 1)] * a[(1, 0)]
            - a[(0, 1)] * rate[(1, 0)];
        let cosine = libm::cos(core::f64::consts::PI / f64::from(loops));
        let determinant = a.determinant();
        [
            detuning(loops, a.trace(), determinant),
            rate.trace() - cosine * determinant_rate / determinant.sqrt(),
        ]
    }

    /// ξ_p = ∂²P_global,1^p/∂z² at grazing. Paper: eq:xi.
    ///
    /// # Errors
    /// An iterate of P_global is not defined.
    pub fn second_phase_derivative(&self, loops: u32) -> Result<f64, MapError> {
        let mut jet = MapJet::identity(AtRest::new(0.0, self.phase));
        let mut passage = self.passage.clone();
        for _ in 0..loops {
            let next = passage.global_map::<O, 2>(&self.oscillator, jet.image())?.jet;
            jet = next.after::<2, _>(&jet);
        }
        Ok(jet.hessians[0][(1, 1)])
    }

    /// All quantities in the formulas for c_SN,p and c_PD,p. Paper: section 2.6.
    ///
    /// a₁₂' for p = 1; for p ≥ 2 κ_p' = τ' − cos(π/p) δ'/√δ.
    ///
    /// # Errors
    /// An iterate of P_global is not defined.
    pub fn resonant_point(&self, loops: u32) -> Result<ResonantPoint, MapError> {
        let [_, derivative] = self.detuning(loops, &self.derivative_of_map());
        Ok(ResonantPoint {
            grazing: self.grazing_point(),
            second_phase_derivative: self.second_phase_derivative(loops)?,
            unfolding: Unfolding { loops, derivative },
        })
    }
}
