//! Maximal periodic solutions (MPSs) as zeros of smooth functions.
//!
//! A p-loop MPS has one impact, at velocity y and phase z, and returns to it after p forcing periods. Two maps lead from
//! (y, z) to one surface: one through the recoil and p loops, the other straight from the impact, the wall ignored. The
//! MPS is where they agree; its stability multipliers are the eigenvalues of the one's derivative times the inverse of
//! the other's. The choice of the surface gives the [`Formulation`].

use grazing_model::maps::{self, MapError};
use grazing_model::motion::{Maximum, highest_maximum, local_maxima};
use grazing_model::{ImpactOscillator, MapJet, OnWall, State, Surface};
use nalgebra::{Matrix2, SMatrix, Vector2, Vector4};
use smallvec::SmallVec;

use crate::newton::Linearisation;
use crate::tolerances::{self, STABILITY};

/// The unknowns (y, z, μ, η): impact velocity, impact phase, primary and secondary parameter.
pub type Unknowns = Vector4<f64>;

/// Positions of the unknowns.
pub mod unknown {
    /// Impact velocity y.
    pub const VELOCITY: usize = 0;
    /// Impact phase z.
    pub const PHASE: usize = 1;
    /// Primary parameter μ.
    pub const PRIMARY: usize = 2;
    /// Secondary parameter η.
    pub const SECONDARY: usize = 3;
}

/// The primary and the secondary parameter (μ, η) of a point.
pub fn parameters(point: &Unknowns) -> [f64; 2] {
    [point[unknown::PRIMARY], point[unknown::SECONDARY]]
}

/// The impact of a point.
fn impact(point: &Unknowns) -> OnWall {
    OnWall::new(point[unknown::VELOCITY], point[unknown::PHASE])
}

/// Rough motion, with errors of some 10⁻⁷, does not tell on which side of the wall a maximum lies that is so near it.
const UNSURE: f64 = 1e-5;

/// A maximum within this share of a flight from either of its ends is that end, which is located as all maxima are, to some 10⁻⁸.
const END: f64 = 1e-4;

/// The surface on which the way through recoil and loops is compared with the straight way from the impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formulation {
    /// The Poincaré section Π, y = 0: the VIVID function V = P_global^p ∘ P_virt ∘ R − P_virt (eq:V), the paper's method.
    /// It ends where one of the maxima that it passes through disappears: that of a loop on Π, or the virtual one beyond the
    /// wall, as where the wall is met with ẍ ≥ 0.
    Vivid,
    /// The plane of constant phase through the impact: flow for p forcing periods from the impact phase, less what the
    /// recoil takes. It has no virtual points and is defined everywhere, and one landing serves all loops: curves are followed with it.
    FixedPhase,
}

/// What the equations carry along a curve: event times, so that "the next maximum" is never ambiguous, and the phase of
/// the comparison plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EventTimes {
    /// Evolution times of P_virt from the impact and from the recoil.
    virtual_times: [Option<f64>; 2],
    /// Return times of P_global, loop by loop.
    return_times: SmallVec<[f64; 4]>,
    /// Phase of the plane of [`Formulation::FixedPhase`].
    reference_phase: Option<f64>,
    /// Time from the recoil to the interior maximum that a grazing curve holds at the wall.
    pub(crate) grazing_time: f64,
    /// The same for a second interior maximum, where two touch the wall.
    pub(crate) second_grazing_time: f64,
    /// What the last evaluation along a curve said of stability,
    pub(crate) stability: Option<Stability>,
    /// and whether the next one may say something else.
    pub(crate) unsettled: bool,
}

/// The equations of p-loop MPSs of one oscillator.
#[derive(Clone, Debug)]
pub struct LoopEquations<O> {
    oscillator: O,
    loops: u32,
    formulation: Formulation,
}

/// The two ways from (y, z; μ, η) to the surface of comparison.
#[derive(Clone, Copy, Debug)]
pub struct LoopPair {
    /// Through recoil and loops: (x⁽ᵖ⁾, z⁽ᵖ⁾) = P_global^p ∘ P_virt ∘ R for VIVID.
    pub round_trip: MapJet,
    /// Straight from the impact: (x̂, ẑ) = P_virt for VIVID.
    pub impact: MapJet,
}

impl<O: ImpactOscillator> LoopEquations<O> {
    /// The equations of MPSs with `loops` = p ≥ 1 loops; the oscillator's own parameters do not matter.
    pub fn new(oscillator: O, loops: u32, formulation: Formulation) -> Self {
        assert!(loops >= 1, "an MPS has at least one loop");
        Self { oscillator, loops, formulation }
    }

    /// The number of loops p.
    pub fn loops(&self) -> u32 {
        self.loops
    }

    /// The formulation in use.
    pub fn formulation(&self) -> Formulation {
        self.formulation
    }

    /// The same equations in another formulation.
    pub fn with_formulation(&self, formulation: Formulation) -> Self {
        Self { formulation, ..self.clone() }
    }

    /// The same equations with motion to fewer digits, where that takes less time.
    pub(crate) fn roughly(&self) -> Self {
        Self { oscillator: self.oscillator.roughly(), ..self.clone() }
    }

    /// The same equations with motion integrated in shorter steps, where it is integrated.
    pub(crate) fn finely(&self) -> Option<Self> {
        Some(Self { oscillator: self.oscillator.finely()?, ..self.clone() })
    }

    /// The oscillator at the parameters of a point.
    pub fn oscillator_at(&self, point: &Unknowns) -> O {
        self.oscillator.with_parameters(parameters(point))
    }

    /// The state just after the impact, (0, y_rec, z_rec).
    pub fn recoil(&self, point: &Unknowns) -> State {
        self.oscillator_at(point).reset::<1>(impact(point)).image().into()
    }

    /// The two maps at a point with derivatives up to `ORDER`.
    ///
    /// # Errors
    /// VIVID is not defined there.
    pub fn pair<const ORDER: usize>(
        &self,
        point: &Unknowns,
        times: &mut EventTimes,
    ) -> Result<LoopPair, MapError> {
        match self.formulation {
            Formulation::Vivid => {
                let oscillator = self.oscillator_at(point);
                let reset = oscillator.reset::<ORDER>(impact(point));
                let [from_impact, from_recoil] = times.virtual_times;
                let ahead = maps::virtual_map::<O, ORDER>(&oscillator, impact(point), from_impact)?;
                let back = maps::virtual_map::<O, ORDER>(&oscillator, reset.image(), from_recoil)?;
                times.virtual_times = [Some(ahead.time), Some(back.time)];
                let mut jet = back.jet.after::<ORDER, _>(&reset);
                times.return_times.resize(self.loops as usize, oscillator.forcing_period());
                for time in &mut times.return_times {
                    let next = maps::global_map::<O, ORDER>(&oscillator, jet.image(), Some(*time))?;
                    *time = next.time;
                    jet = next.jet.after::<ORDER, _>(&jet);
                }
                Ok(LoopPair::of(&jet, &ahead.jet))
            }
            Formulation::FixedPhase => {
                let plane = *times.reference_phase.get_or_insert(point[unknown::PHASE]);
                Ok(self.fixed_phase_pair::<ORDER>(point, plane))
            }
        }
    }

    /// The two maps to the plane of constant phase `plane`, which exist at every point.
    pub(crate) fn fixed_phase_pair<const ORDER: usize>(&self, point: &Unknowns, plane: f64) -> LoopPair {
        let oscillator = self.oscillator_at(point);
        self.fixed_phase_pair_along::<ORDER>(point, plane, &oscillator.motion(self.recoil(point)))
    }

    /// The same with the motion from the recoil at hand.
    fn fixed_phase_pair_along<const ORDER: usize>(
        &self,
        point: &Unknowns,
        plane: f64,
        motion: &O::Motion,
    ) -> LoopPair {
        let oscillator = self.oscillator_at(point);
        let reset = oscillator.reset::<ORDER>(impact(point));
        let turns = f64::from(self.loops) * core::f64::consts::TAU;
        let around = maps::to_phase_along::<O, ORDER>(&oscillator, motion, reset.image(), plane + turns);
        let ahead = maps::to_phase::<O, ORDER>(&oscillator, impact(point), plane);
        LoopPair::of(&around.after::<ORDER, _>(&reset), &ahead)
    }

    /// Brings what is carried up to an accepted point: the comparison plane moves to its phase.
    pub(crate) fn settle(&self, point: &Unknowns, times: &mut EventTimes) {
        times.reference_phase = Some(point[unknown::PHASE]);
    }

    /// The points (x⁽ʲ⁾, z⁽ʲ⁾), j = 1, …, p, at which the loops of an MPS meet Π; the last is virtual.
    ///
    /// Paper: eq:xjzj. Starts from the event times in `times`.
    ///
    /// # Errors
    /// A loop has no maximum of x near Π, half a forcing period or more after the one before, as where VIVID is not defined.
    pub fn visits(&self, point: &Unknowns, times: &EventTimes) -> Result<Vec<Vector2<f64>>, MapError> {
        let oscillator = self.oscillator_at(point);
        let recoil = oscillator.reset::<1>(impact(point)).image();
        let mut here = maps::virtual_map::<O, 1>(&oscillator, recoil, times.virtual_times[1])?.jet.image();
        (0..self.loops as usize)
            .map(|j| {
                let time = times.return_times.get(j).copied();
                here = maps::next_visit(&oscillator, here, time)?.jet.image();
                Ok(here.coordinates())
            })
            .collect()
    }

    /// The value of x at the maximum near a time after the recoil, with its first derivatives in the unknowns; the time becomes that of
    /// the maximum.
    ///
    /// # Errors
    /// The maximum has disappeared.
    pub(crate) fn maximum_near(
        &self,
        point: &Unknowns,
        time: &mut f64,
    ) -> Result<(f64, Vector4<f64>), MapError> {
        let oscillator = self.oscillator_at(point);
        let reset = oscillator.reset::<1>(impact(point));
        let landing = maps::virtual_map::<O, 1>(&oscillator, reset.image(), Some(*time))?;
        *time = landing.time;
        let jet = landing.jet.after::<1, _>(&reset);
        Ok((jet.value[0], jet.jacobian.row(0).transpose()))
    }

    /// The orbit that a zero of the equations is: multipliers, maxima, stability, admissibility.
    ///
    /// Needs no virtual points, whatever the formulation.
    pub fn solution(&self, point: &Unknowns) -> MaximalPeriodicSolution {
        self.solution_and_stability(point).0
    }

    /// The same with what its multipliers were read off.
    pub(crate) fn solution_and_stability(&self, point: &Unknowns) -> (MaximalPeriodicSolution, Stability) {
        let motion = self.oscillator_at(point).motion(self.recoil(point));
        let stability = self.fixed_phase_pair_along::<1>(point, point[unknown::PHASE], &motion).stability();
        (self.orbit(point, &motion, stability.multipliers), stability)
    }

    /// The same at a point with y = 0 that is approached along a curve with the given tangent, where the multipliers are
    /// limits.
    pub fn limiting_solution(&self, point: &Unknowns, tangent: &Unknowns) -> MaximalPeriodicSolution {
        let motion = self.oscillator_at(point).motion(self.recoil(point));
        let pair = self.fixed_phase_pair_along::<2>(point, point[unknown::PHASE], &motion);
        let flight = self.flight(point);
        // The orbit begins and ends at a maximum; neither is an interior one.
        let ends = END * flight;
        let interior = local_maxima(&motion, flight)
            .into_iter()
            .filter(|maximum| (ends..flight - ends).contains(&maximum.time));
        MaximalPeriodicSolution {
            loops: self.loops,
            unknowns: *point,
            multipliers: pair.limiting_multipliers(tangent),
            highest_interior_maximum: interior.max_by(|a, b| a.position.total_cmp(&b.position)),
        }
    }

    /// The same to fewer digits, with multipliers that are known; its maxima are looked for only where they are asked for.
    pub(crate) fn sketch(
        &self,
        point: &Unknowns,
        multipliers: Multipliers,
        with_maxima: bool,
    ) -> MaximalPeriodicSolution {
        if with_maxima {
            let orbit = |equations: &Self| {
                let motion = equations.oscillator_at(point).motion(self.recoil(point));
                self.orbit(point, &motion, multipliers)
            };
            let rough = orbit(&self.roughly());
            return if rough.ceiling().abs() > UNSURE { rough } else { orbit(self) };
        }
        let loops = self.loops;
        MaximalPeriodicSolution { loops, unknowns: *point, multipliers, highest_interior_maximum: None }
    }

    fn orbit(
        &self,
        point: &Unknowns,
        motion: &O::Motion,
        multipliers: Multipliers,
    ) -> MaximalPeriodicSolution {
        MaximalPeriodicSolution {
            loops: self.loops,
            unknowns: *point,
            multipliers,
            highest_interior_maximum: highest_maximum(motion, self.flight(point)),
        }
    }

    /// The time from the recoil to the next impact.
    fn flight(&self, point: &Unknowns) -> f64 {
        let oscillator = self.oscillator_at(point);
        let lag = (self.recoil(point).phase - point[unknown::PHASE]) / oscillator.forcing_frequency().value;
        f64::from(self.loops) * oscillator.forcing_period() - lag
    }
}

impl LoopPair {
    /// Two maps that lead to one surface.
    pub fn of<A, B>(round_trip: &MapJet<A, B>, impact: &MapJet<A, B>) -> Self {
        Self { round_trip: round_trip.plain(), impact: impact.plain() }
    }

    /// V and its derivatives in (y, z, μ, η): the zeros are MPSs. Paper: eq:V.
    pub fn difference(&self) -> (Vector2<f64>, SMatrix<f64, 2, 4>) {
        (self.round_trip.value - self.impact.value, self.round_trip.jacobian - self.impact.jacobian)
    }

    /// det(D round trip − λ D impact) and its gradient in the unknowns.
    ///
    /// Zero when λ is a stability multiplier: λ = 1 at a saddle-node, λ = −1 at a period-doubling bifurcation. In contrast
    /// to the multipliers it stays smooth through y = 0; up to a smooth factor it is y (1 − λT + D) for λ = ±1, the
    /// paper's y Ψ± (eq:Psi). The gradient needs jets of order 2.
    pub fn characteristic(&self, multiplier: f64) -> (f64, Vector4<f64>) {
        let m = self.round_trip.derivative() - self.impact.derivative() * multiplier;
        let determinant = m[(0, 0)] * m[(1, 1)] - m[(0, 1)] * m[(1, 0)];
        let gradient = Vector4::from_fn(|k, _| {
            let d = |i: usize, j: usize| {
                self.round_trip.hessians[i][(j, k)] - multiplier * self.impact.hessians[i][(j, k)]
            };
            d(0, 0) * m[(1, 1)] + m[(0, 0)] * d(1, 1) - d(0, 1) * m[(1, 0)] - m[(0, 1)] * d(1, 0)
        });
        (determinant, gradient)
    }

    /// What the maps say of stability.
    pub(crate) fn stability(&self) -> Stability {
        let [saddle_node, period_doubling] = [1.0, -1.0].map(|multiplier| {
            (self.round_trip.derivative() - self.impact.derivative() * multiplier).determinant()
        });
        Stability { multipliers: self.multipliers(), saddle_node, period_doubling }
    }

    /// Trace and determinant of U = D(P_global^p ∘ P_disc). Paper: eq:U, eq:TD.
    pub fn multipliers(&self) -> Multipliers {
        let (l, r) = (self.round_trip.derivative(), self.impact.derivative());
        // Both vanish like y.
        let (numerators, denominator) = ([(l * adjugate(r)).trace(), l.determinant()], r.determinant());
        Multipliers { trace: numerators[0] / denominator, determinant: numerators[1] / denominator }
    }

    /// Limits of trace and determinant at a point with y = 0, approached along a curve with the given tangent.
    ///
    /// Numerators and denominator vanish together at a resonance; the limits are the ratios of their derivatives along
    /// the curve. Jets of order 2.
    pub fn limiting_multipliers(&self, tangent: &Unknowns) -> Multipliers {
        let along = |jet: &MapJet| {
            Matrix2::from_fn(|i, j| (0..4).map(|k| jet.hessians[i][(j, k)] * tangent[k]).sum::<f64>())
        };
        let (l, r) = (self.round_trip.derivative(), self.impact.derivative());
        let (dl, dr) = (along(&self.round_trip), along(&self.impact));
        let denominator = (dr * adjugate(r)).trace();
        Multipliers {
            trace: (dl * adjugate(r) + l * adjugate(dr)).trace() / denominator,
            determinant: (dl * adjugate(l)).trace() / denominator,
        }
    }
}

fn adjugate(m: Matrix2<f64>) -> Matrix2<f64> {
    Matrix2::new(m[(1, 1)], -m[(0, 1)], -m[(1, 0)], m[(0, 0)])
}

/// Trace T and determinant D of the matrix U whose eigenvalues are the stability multipliers (eq:U, eq:TD).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multipliers {
    /// T.
    pub trace: f64,
    /// D.
    pub determinant: f64,
}

impl Multipliers {
    /// Both multipliers lie inside the unit circle: |T| − 1 < D < 1.
    ///
    /// On the boundary the MPS does not count as stable.
    pub fn stable(&self) -> bool {
        self.trace.abs() - 1.0 < self.determinant - STABILITY && self.determinant < 1.0 - STABILITY
    }

    /// The larger of |T| and |D|, which says how violent the motion is.
    pub fn size(&self) -> f64 {
        self.trace.abs().max(self.determinant.abs())
    }
}

/// The stability of a zero of the equations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stability {
    pub(crate) multipliers: Multipliers,
    /// The [`characteristic`](LoopPair::characteristic) of the multiplier 1, and of −1.
    pub(crate) saddle_node: f64,
    pub(crate) period_doubling: f64,
}

/// Multipliers beyond this change so fast that no sign of anything is known for long.
const VIOLENT: f64 = 1e3;

impl Stability {
    /// Whether something has changed by more than itself, so that a correction as large as the last one may change its sign.
    pub(crate) fn is_unsettled_since(&self, before: &Self) -> bool {
        let changed = |of: fn(&Self) -> f64| (of(self) - of(before)).abs() >= of(self).abs();
        self.multipliers.size() < VIOLENT
            && (changed(|stability| stability.saddle_node) || changed(|stability| stability.period_doubling))
    }
}

/// A zero of the equations, seen as an orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaximalPeriodicSolution {
    /// The number of loops p.
    pub loops: u32,
    /// (y, z, μ, η).
    pub unknowns: Unknowns,
    /// Trace and determinant of U; infinite or NaN at y = 0.
    pub multipliers: Multipliers,
    /// The highest local maximum of x between the recoil and the next impact, if there is one.
    pub highest_interior_maximum: Option<Maximum>,
}

impl MaximalPeriodicSolution {
    /// An interior maximum this little above the wall touches it.
    pub const TOUCH: f64 = tolerances::TOUCH;

    /// The impact velocity y.
    pub fn impact_velocity(&self) -> f64 {
        self.unknowns[unknown::VELOCITY]
    }

    /// The primary and the secondary parameter (μ, η).
    pub fn parameters(&self) -> [f64; 2] {
        parameters(&self.unknowns)
    }

    /// The highest interior maximum of x, or −∞ if x has no interior maximum.
    pub fn ceiling(&self) -> f64 {
        self.highest_interior_maximum.map_or(f64::NEG_INFINITY, |maximum| maximum.position)
    }

    /// A valid solution of the hybrid system: y > 0 and no interior maximum of x above the wall, wherever it lies.
    pub fn admissible(&self) -> bool {
        self.impact_velocity() > 0.0 && self.ceiling() <= Self::TOUCH
    }

    /// An interior maximum of x lies above the wall.
    pub(crate) fn touches(&self) -> bool {
        self.ceiling() > Self::TOUCH
    }

    /// Asymptotically stable as a solution of the hybrid system, admissibility aside.
    pub fn stable(&self) -> bool {
        self.multipliers.stable()
    }
}

/// Stacks V and one further scalar equation into the first three rows of a 4 × 4 system.
pub(crate) fn stack(
    (difference, derivative): (Vector2<f64>, SMatrix<f64, 2, 4>),
    (value, gradient): (f64, Vector4<f64>),
) -> Linearisation<4> {
    let mut system = Linearisation { residual: Vector4::zeros(), jacobian: SMatrix::zeros() };
    system.residual.fixed_rows_mut::<2>(0).copy_from(&difference);
    system.jacobian.fixed_rows_mut::<2>(0).copy_from(&derivative);
    system.residual[2] = value;
    system.jacobian.set_row(2, &gradient.transpose());
    system
}
