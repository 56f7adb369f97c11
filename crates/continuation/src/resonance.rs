//! Resonant grazing points, located numerically, the curves that leave them and the codimension-two
//! points at which these end.

use core::f64::consts::TAU;
use core::ops::Deref;

use grazing_model::maps::MapError;
use grazing_model::{AnyOscillator, ImpactOscillator, OnWall};
use grazing_theorems::from_map::{GrazingOrbit, GrazingOrbitError};
use grazing_theorems::limit_map::LimitImpact;
use grazing_theorems::resonant_theorem::BifurcationCurve;
use grazing_theorems::{HypothesesViolated, ResonantGrazing, ResonantPoint};

use crate::bifurcation::Pair;
use crate::curve::{Curve, CurveEnd, Event, Route, SolutionCurve};
use crate::locate::{Condition, LocateFailure, locate, same_point};
use crate::mps::{EventTimes, Formulation, LoopEquations, PeriodicSolution, Unknowns, unknown};
use crate::newton::NewtonFailure;
use crate::tolerances::{AT_RESONANCE, OFF_RESONANCE};

/// The reason why a resonant grazing point could not be analysed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ResonanceError {
    /// Newton's method for det J = 0 on the grazing curve failed.
    #[error("the resonance was not located: {0}")]
    NotLocated(LocateFailure),
    /// The grazing orbit was not found.
    #[error(transparent)]
    GrazingOrbit(#[from] GrazingOrbitError),
    /// P_global is not smooth there.
    #[error(transparent)]
    Map(#[from] MapError),
    /// A theorem's hypothesis does not hold.
    #[error(transparent)]
    Hypotheses(#[from] HypothesesViolated),
    /// The theory gives a direction in which the numerical equations have no curve.
    #[error("the {curve} curve cannot be started: {reason}")]
    NotStarted {
        /// The curve.
        curve: &'static str,
        /// The reason.
        reason: String,
    },
}

impl ResonanceError {
    /// The error that the curve of a condition cannot be started.
    pub(crate) fn not_started(condition: Condition, reason: String) -> Self {
        let curve = match condition {
            Condition::InteriorGrazing => "interior grazing",
            Condition::Multiplier(multiplier) if multiplier > 0.0 => "saddle-node",
            _ => "period-doubling",
        };
        Self::NotStarted { curve, reason }
    }
}

/// A resonant grazing point that has been located, whether or not a theorem applies there.
///
/// det J = 0 on the curve of grazing bifurcations, through a₁₂ = 0 (p = 1) or κ_p = 0 (p ≥ 2).
#[derive(Clone, Debug)]
pub struct LocatedResonance<O = AnyOscillator> {
    equations: LoopEquations<O>,
    orbit: GrazingOrbit<O>,
    point: ResonantPoint,
}

/// Number of Newton steps from a saddle-node that is nearly the resonance.
const POLISHING: usize = 5;
/// Number of Newton steps from a point of the grazing curve between which and the next there is a resonance.
const POLISHING_FROM_AFAR: usize = 20;

impl<O: ImpactOscillator> LocatedResonance<O> {
    /// Locates the resonance near the parameters of `oscillator` and the phase `near`.
    ///
    /// # Errors
    /// None is found.
    pub fn find(oscillator: &O, loops: u32, near: f64) -> Result<Self, ResonanceError> {
        let equations = LoopEquations::new(oscillator.clone(), loops, Formulation::Vivid);
        let [primary, secondary] = oscillator.parameters();
        let conditions = [Condition::SADDLE_NODE, Condition::ImpactVelocity(0.0)];
        let start = Unknowns::new(0.0, near, primary, secondary);
        // A second solution from the point found adds one step: where damping is strong, E_p and
        // with it the coefficients change so fast with η that the error of the last step would be
        // visible.
        let mut located = start;
        for _ in 0..2 {
            located = locate(&equations, conditions, located, &mut EventTimes::default())
                .map_err(ResonanceError::NotLocated)?;
            // Rounding may leave it slightly off zero, where an impact has another virtual point.
            located[unknown::VELOCITY] = 0.0;
        }
        let mut orbit = GrazingOrbit::find(&equations.oscillator_at(&located), located[unknown::PHASE])?;
        // Where motion is almost forgotten within p periods a saddle-node at y = 0 is hard to
        // distinguish from others: a₁₂ or κ_p itself is then solved for, along the grazing curve.
        for _ in 0..POLISHING {
            let [detuning, slope] = orbit.detuning(loops, &orbit.derivative_of_map());
            let [_, secondary] = orbit.oscillator().parameters();
            let step = detuning / slope;
            if detuning.abs() <= off_resonance(secondary, slope) || !step.is_finite() {
                break;
            }
            let place = orbit.place().moved(orbit.oscillator(), secondary - step)?;
            orbit = GrazingOrbit::at(orbit.oscillator().with_parameters(place.parameters), place.phase)?;
        }
        let point = orbit.resonant_point(loops)?;
        Ok(Self { equations, orbit, point })
    }

    /// Locates the resonance of q loops near a grazing orbit that has impacts elsewhere: of solutions with one
    /// impact more than q rounds of this orbit.
    ///
    /// # Errors
    /// None is found.
    pub fn of_impacting(mut orbit: GrazingOrbit<O>, loops: u32) -> Result<Self, ResonanceError> {
        let mut last = f64::INFINITY;
        for _ in 0..POLISHING_FROM_AFAR {
            let [detuning, slope] = orbit.detuning(loops, &orbit.derivative_of_map());
            let [_, secondary] = orbit.oscillator().parameters();
            let step = detuning / slope;
            // A step no shorter than the last is rounding.
            if !(step.is_finite() && step.abs() < last) {
                break;
            }
            last = step.abs();
            let place = orbit.place().moved(orbit.oscillator(), secondary - step)?;
            orbit = GrazingOrbit::of(orbit.oscillator(), place)?;
        }
        let [detuning, slope] = orbit.detuning(loops, &orbit.derivative_of_map());
        let is_there = detuning.abs() <= off_resonance(orbit.oscillator().parameters()[1], slope);
        if !is_there {
            let (iterations, residual) = (POLISHING_FROM_AFAR, detuning);
            return Err(ResonanceError::NotLocated(
                NewtonFailure::NoConvergence { iterations, residual }.into(),
            ));
        }
        let point = orbit.resonant_point(loops)?;
        let periods = loops * orbit.passage().periods();
        let equations = LoopEquations::new(orbit.oscillator().clone(), periods, Formulation::FixedPhase);
        Ok(Self { equations, orbit, point })
    }

    /// The number of loops p; of rounds of the grazing orbit, if that has impacts elsewhere.
    pub fn loops(&self) -> u32 {
        self.point.loops()
    }

    /// The grazing orbit at the resonance.
    pub fn orbit(&self) -> &GrazingOrbit<O> {
        &self.orbit
    }

    /// The quantities to which the theorem applies.
    pub fn resonant_point(&self) -> &ResonantPoint {
        &self.point
    }

    /// The equations of the p-loop MPSs.
    pub fn equations(&self) -> &LoopEquations<O> {
        &self.equations
    }

    /// The resonance (0, z_graz, μ_graz, η*) as unknowns.
    pub fn unknowns(&self) -> Unknowns {
        let periods = f64::from(self.orbit.passage().periods());
        let first = OnWall::new(0.0, self.orbit.phase());
        let rounds = (0..self.loops()).flat_map(|round| {
            let turned = move |impact: &OnWall| OnWall {
                phase: impact.phase + f64::from(round) * periods * TAU,
                ..*impact
            };
            self.orbit.impacts().iter().map(turned)
        });
        let impacts: Vec<OnWall> = [first].into_iter().chain(rounds).collect();
        Unknowns::of_impacts(&impacts, self.orbit.oscillator().parameters())
    }

    /// The unknowns (y, z, μ, η) of an impact of the limit map, at its parameter M and a distance η
    /// from the resonance.
    ///
    /// # Errors
    /// There is no grazing orbit at that η.
    pub fn near(&self, eta: f64, parameter: f64, impact: LimitImpact) -> Result<Unknowns, GrazingOrbitError> {
        let scale = self.point.limit_scale();
        let secondary = self.unknowns()[unknown::SECONDARY] + eta;
        let place = self.orbit.place().moved(self.orbit.oscillator(), secondary)?;
        let [y, z] = scale.impact(eta, impact);
        let primary = place.parameters[0] + scale.parameter * eta * eta * parameter;
        Ok(Unknowns::new(y, place.phase + z, primary, secondary))
    }

    /// The resonance with the theorem that holds there.
    ///
    /// # Errors
    /// A hypothesis of Theorem 2.4 or 2.5 fails; all are listed with their values.
    pub fn checked(&self) -> Result<ResonantGrazingPoint<O>, HypothesesViolated> {
        let [_, secondary] = self.orbit.oscillator().parameters();
        let tolerance = off_resonance(secondary, self.point.unfolding.derivative);
        Ok(ResonantGrazingPoint {
            theorem: ResonantGrazing::check(&self.point, tolerance)?,
            located: self.clone(),
        })
    }
}

/// Largest |a₁₂| or |κ_p| that is accepted at a located resonance, for this rate of change with η.
fn off_resonance(secondary: f64, slope: f64) -> f64 {
    AT_RESONANCE + OFF_RESONANCE * (secondary * slope).abs()
}

/// A located resonance at which Theorem 2.4 or 2.5 holds.
#[derive(Clone, Debug)]
pub struct ResonantGrazingPoint<O = AnyOscillator> {
    located: LocatedResonance<O>,
    theorem: ResonantGrazing,
}

impl<O> Deref for ResonantGrazingPoint<O> {
    type Target = LocatedResonance<O>;

    fn deref(&self) -> &LocatedResonance<O> {
        &self.located
    }
}

impl<O: ImpactOscillator> ResonantGrazingPoint<O> {
    /// Locates the resonance near the parameters of `oscillator` and the phase `near`, and checks
    /// the theorem's hypotheses.
    ///
    /// # Errors
    /// No resonance is found, or a hypothesis fails there.
    pub fn find(oscillator: &O, loops: u32, near: f64) -> Result<Self, ResonanceError> {
        Ok(LocatedResonance::find(oscillator, loops, near)?.checked()?)
    }

    /// The theorem that holds there, with its coefficients.
    pub fn theorem(&self) -> &ResonantGrazing {
        &self.theorem
    }

    /// The leading terms of the SN and the PD curve, by the theorem.
    pub fn leading(&self) -> Pair<BifurcationCurve> {
        let theorem = &self.theorem;
        Pair { saddle_node: theorem.saddle_node(), period_doubling: theorem.period_doubling() }
    }

    /// The SN (`multiplier` 1) or PD (−1) curve that leaves the resonance, with its leading terms
    /// by theory.
    pub fn leaving(&self, condition: Condition) -> LeavingCurve<'_, O> {
        let leading = match condition {
            Condition::Multiplier(multiplier) if multiplier < 0.0 => self.theorem.period_doubling(),
            _ => self.theorem.saddle_node(),
        };
        let (resonance, equations) = (&self.located, self.equations.clone());
        LeavingCurve { resonance, equations, condition, leading, visit: None }
    }

    /// The direction in which, by theory, the SN or PD curve leaves with y > 0.
    pub fn direction(&self, condition: Condition) -> Unknowns {
        self.leaving(condition).direction()
    }

    /// The SN or PD curve that leaves the resonance.
    pub fn curve(&self, condition: Condition) -> SolutionCurve<O> {
        SolutionCurve { equations: self.equations.with_formulation(Formulation::FixedPhase), condition }
    }

    /// All curves that bound the stable region of the MPS at this resonance: SN and PD from the
    /// resonance, and GZ from the codimension-two points at which these end.
    ///
    /// # Errors
    /// The SN or the PD curve cannot be started.
    pub fn unfold(&self, route: &Route<'_>) -> Result<UnfoldedResonance, ResonanceError> {
        let saddle_node = self.leaving(Condition::SADDLE_NODE).follow(route)?;
        let period_doubling = self.leaving(Condition::PERIOD_DOUBLING).follow(route)?;
        let (mut grazing, mut missing): (Vec<Curve>, Vec<ResonanceError>) = (Vec::new(), Vec::new());
        for curve in [&saddle_node, &period_doubling] {
            let CurveEnd::Event(event) = &curve.end else {
                continue;
            };
            let reached = |other: &Curve| {
                other
                    .points
                    .last()
                    .is_some_and(|last| same_point(&last.solution.unknowns, &event.solution.unknowns))
            };
            if event.condition == Condition::InteriorGrazing && !grazing.iter().any(reached) {
                match self.curve(event.condition).equations.branch_off(event, route) {
                    Ok(curve) => grazing.push(curve),
                    Err(reason) => missing.push(reason),
                }
            }
        }
        Ok(UnfoldedResonance { saddle_node, period_doubling, grazing, missing })
    }
}

impl<O: ImpactOscillator> LoopEquations<O> {
    /// Follows the other curve of a codimension-two point at which one curve ends: GZ in the
    /// direction in which the MPS is stable, SN and PD in that in which it is admissible.
    ///
    /// # Errors
    /// There is no such direction, or the curve cannot be started.
    pub fn branch_off(&self, point: &Event, route: &Route<'_>) -> Result<Curve, ResonanceError> {
        let condition = point.condition;
        let bounds = |solution: &PeriodicSolution| {
            !solution.touches() && (condition != Condition::InteriorGrazing || solution.stable())
        };
        // On the inadmissible side of a point at which two maxima touch the wall a curve ends at
        // once.
        let onwards = |solution: &PeriodicSolution| {
            bounds(solution) && !same_point(&solution.unknowns, &point.solution.unknowns)
        };
        let mut reason = "it bounds no region of stable solutions to either side".to_owned();
        for sign in [1.0, -1.0] {
            let curve = SolutionCurve { equations: self.clone(), condition };
            let direction = point.solution.unknowns.along(unknown::VELOCITY) * sign;
            match curve.follow(point.solution.unknowns.clone(), direction, point.times.clone(), route) {
                Ok(curve) if self.beside_start(&curve).is_some_and(|next| onwards(&next)) => {
                    return Ok(curve);
                }
                Ok(_) => {}
                Err(stall) => reason = stall.to_string(),
            }
        }
        Err(ResonanceError::not_started(condition, reason))
    }

    /// The solution next to the start of a curve: its second point, or the middle if that point is
    /// an event, where a solution does not count as stable.
    fn beside_start(&self, curve: &Curve) -> Option<PeriodicSolution> {
        let (start, next) = (curve.points.first()?, &curve.points.get(1)?.solution);
        if curve.points.len() > 2 || !matches!(curve.end, CurveEnd::Event(_)) {
            return Some(next.clone());
        }
        let middle = (&start.solution.unknowns + &next.unknowns) * 0.5;
        let conditions = [curve.condition, Condition::ImpactVelocity(middle[unknown::VELOCITY])];
        let found = locate(self, conditions, middle, &mut start.times.clone()).ok()?;
        Some(self.solution(&found))
    }
}

/// A curve of MPSs that leaves a resonance, by theory.
#[derive(Clone, Debug)]
pub struct LeavingCurve<'a, O = AnyOscillator> {
    /// The resonance.
    pub resonance: &'a LocatedResonance<O>,
    /// The equations of the MPSs, which may have more loops than those of the resonance.
    pub equations: LoopEquations<O>,
    /// The condition that holds along the curve.
    pub condition: Condition,
    /// The leading terms of the curve, by theory.
    pub leading: BifurcationCurve,
    /// The number of the visit to Π that touches the wall, on a GZ curve.
    pub visit: Option<u32>,
}

impl<O: ImpactOscillator> LeavingCurve<'_, O> {
    /// Follows the curve from the resonance, which is impossible for a GZ curve: its equations are
    /// singular there.
    ///
    /// # Errors
    /// The curve cannot be started.
    pub fn follow(&self, route: &Route<'_>) -> Result<Curve, ResonanceError> {
        let (start, condition) = (self.resonance.unknowns(), self.condition);
        let equations = self.equations.with_formulation(Formulation::FixedPhase);
        SolutionCurve { equations, condition }
            .follow(start, self.direction(), EventTimes::default(), route)
            .map_err(|stall| ResonanceError::not_started(condition, stall.to_string()))
    }

    /// The direction in which, by theory, the curve leaves with y > 0.
    ///
    /// (y, z, primary, η) grow like (Υ', z_graz' + k₁Υ', primary_graz', 1) η, with the sign of η
    /// that makes y positive. Paper: eq:Upsilon1, eq:Upsilonp, eq:ZM.
    pub fn direction(&self) -> Unknowns {
        let (orbit, leading) = (self.resonance.orbit(), &self.leading);
        let [by_velocity, by_phase] = [leading.impact_velocity_slope, leading.impact_phase_slope];
        let first = Unknowns::new(by_velocity, orbit.phase_slope() + by_phase, orbit.primary_slope(), 1.0)
            .normalize();
        let sign = leading.eta_side.signum();
        self.equations.with_others(&self.resonance.unknowns(), first * sign)
    }
}

/// The curves at one resonance.
#[derive(Clone, Debug)]
pub struct UnfoldedResonance {
    /// The curve of saddle-node bifurcations.
    pub saddle_node: Curve,
    /// The curve of period-doubling bifurcations.
    pub period_doubling: Curve,
    /// The curves of grazing bifurcations of the MPS.
    pub grazing: Vec<Curve>,
    /// The reasons why a GZ curve is missing at a codimension-two point where there should be one.
    pub missing: Vec<ResonanceError>,
}

impl UnfoldedResonance {
    /// All curves, the SN curve first and then the PD curve.
    pub fn curves(&self) -> impl Iterator<Item = &Curve> {
        [&self.saddle_node, &self.period_doubling].into_iter().chain(&self.grazing)
    }
}
