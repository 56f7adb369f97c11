//! The maps between the impacting surface Σ and the Poincaré section Π, with derivatives.
//!
//! Σ is the plane x = 0 with coordinates (y, z); Π is the part of the plane y = 0 near the grazing
//! point, with coordinates (x, z) (sections 2.1, 2.2 and 4.1 of the paper). All maps ignore the
//! wall. Phases are not reduced modulo 2π except that P_global subtracts one turn, as in the paper,
//! so that grazing is a fixed point.
//!
//! A map that ends on Π has to find the time of a zero of the velocity. That time is returned with
//! the jet, and can be passed as a guess to the next call: "the next maximum" is ambiguous once a
//! loop has grown a second one, a continued time is not.

use core::f64::consts::TAU;

use nalgebra::{Matrix6, Vector2, Vector4};

use crate::jet::{FlowJet, MapJet, ParameterJet};
use crate::motion::Motion;
use crate::oscillator::ImpactOscillator;
use crate::state::{AtPhase, AtRest, OnWall, State, Surface, flow_variable as flow};
use crate::tolerances::{LAST_STEP_TO_SECTION, LAST_STEP_TO_WALL, MOST_ITERATIONS, MOST_PERIODS};

/// The reason why a map is not defined at a point.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MapError {
    /// The orbit does not reach the wall near the expected time.
    #[error("the wall is not reached near t = {near}, where the velocity is {velocity}")]
    NoCrossing {
        /// The time around which the impact was sought.
        near: f64,
        /// The velocity where the search ended.
        velocity: f64,
    },
    /// The orbit does not come to rest near the expected time.
    #[error("the velocity has no zero near t = {near}: Newton's method stopped with velocity {velocity}")]
    NoRest {
        /// The time around which the zero was sought.
        near: f64,
        /// The velocity where the search ended.
        velocity: f64,
    },
    /// The orbit comes to rest at a minimum or an inflection, where Π is not crossed transversally.
    #[error("the orbit comes to rest with acceleration {acceleration}, where only a maximum of x lies on Π")]
    NotAMaximum {
        /// The acceleration there, which is not negative.
        acceleration: f64,
    },
    /// The maximum that was found comes too soon to be the next visit to Π.
    #[error("the maximum that was found comes after a time of {time}, less than half a forcing period")]
    TooSoon {
        /// The time after which it comes.
        time: f64,
    },
    /// The symmetry of an oscillator without symmetry, or of motion with impacts, was requested.
    #[error("motion of this kind has no symmetry")]
    NotSymmetric,
    /// P_virt⁻¹ was requested at x < 0, or did not reach the wall.
    #[error("no orbit from the wall comes to rest at x = {position}")]
    BelowTheWall {
        /// The requested position.
        position: f64,
    },
}

/// The image on Π of a point of the surface `A` together with the evolution time that led there.
#[derive(Clone, Copy, Debug)]
pub struct Landing<A> {
    /// The map and its derivatives.
    pub jet: MapJet<A, AtRest>,
    /// The evolution time, negative if the evolution went backwards.
    pub time: f64,
}

/// Limit on the evolution time of P_virt, in forcing periods: over a hill beyond the wall motion
/// may take longer than one period to turn back; after this many it is carried off.
const LONGEST_VIRTUAL: f64 = 2.0;

/// P_virt: from (y, z) on Σ along the flow to (x', z') on Π, forwards in time for y > 0 and
/// backwards for y < 0.
///
/// Paper: section 4.1, eq:Pvirt2. For y = 0 the evolution time is zero and the image is (0, z).
/// `guess` is the evolution time from which Newton's method starts; without one the zero of the
/// velocity nearest to the wall in the direction of time is isolated first.
///
/// # Errors
/// No maximum of x beyond the wall, as happens where the wall is met with ẍ ≥ 0.
pub fn virtual_map<O: ImpactOscillator, const ORDER: usize>(
    oscillator: &O,
    impact: OnWall,
    guess: Option<f64>,
) -> Result<Landing<OnWall>, MapError> {
    let OnWall { velocity, .. } = impact;
    let time = match guess {
        Some(time) => time,
        None if velocity == 0.0 => 0.0,
        None => {
            let horizon = LONGEST_VIRTUAL * oscillator.forcing_period();
            let forwards = velocity > 0.0;
            oscillator
                .motion(impact.into())
                .first_rest(forwards, horizon)
                .ok_or(MapError::NoRest { near: 0.0, velocity })?
        }
    };
    land_on_section::<O, ORDER, _>(oscillator, impact.into(), time, 0.0)
}

/// P_virt⁻¹, the branch on the incoming set: from (x, z) on Π with x ≥ 0 backwards to (y, z) on Σ
/// with y ≥ 0.
///
/// Paper: the paragraph before eq:Pdisc. At x = 0 the preimage is (0, z), but the map has no
/// derivative there.
///
/// # Errors
/// x < 0, or the orbit through the point does not come from the wall.
pub fn virtual_preimage<O: ImpactOscillator>(oscillator: &O, top: AtRest) -> Result<OnWall, MapError> {
    let AtRest { position, phase } = top;
    let below = MapError::BelowTheWall { position };
    let frequency = oscillator.forcing_frequency().value;
    let from = State::from(top);
    let acceleration = oscillator.acceleration(from);
    if position < 0.0 || acceleration >= 0.0 {
        return Err(below);
    }
    let motion = oscillator.motion(from);
    let mut time = -(2.0 * position / -acceleration).sqrt();
    if time == 0.0 {
        return Ok(OnWall::new(0.0, phase));
    }
    for _ in 0..MOST_ITERATIONS {
        let here = motion.at(time);
        let step = here.position / here.velocity;
        time -= step;
        if time.is_nan() || time >= 0.0 {
            return Err(below);
        }
        // Or x is zero to rounding, which for small x determines the time less accurately.
        if step.abs() <= LAST_STEP_TO_WALL * time.abs() || here.position.abs() <= 4.0 * f64::EPSILON {
            return Ok(OnWall::new(motion.at(time).velocity, phase + frequency * time));
        }
    }
    Err(below)
}

/// P_global: from (x, z) on Π along the flow to the next point (x', z') of Π, one turn later.
///
/// Paper: section 2.2, eq:Pglobal. `guess` is the return time from which Newton's method starts;
/// without one it is the forcing period, since Π is a neighbourhood of the grazing point and the
/// return time is close to the period of Γ.
///
/// # Errors
/// There is no maximum of x near the guessed time.
pub fn global_map<O: ImpactOscillator, const ORDER: usize>(
    oscillator: &O,
    from: AtRest,
    guess: Option<f64>,
) -> Result<Landing<AtRest>, MapError> {
    let time = guess.unwrap_or_else(|| oscillator.forcing_period());
    land_on_section::<O, ORDER, _>(oscillator, from.into(), time, TAU)
}

/// The next point at which motion visits Π: P_global, restricted to maxima that come more than half
/// a forcing period later.
///
/// # Errors
/// There is no such maximum near the guessed time.
pub fn next_visit<O: ImpactOscillator>(
    oscillator: &O,
    from: AtRest,
    guess: Option<f64>,
) -> Result<Landing<AtRest>, MapError> {
    let landing = global_map::<O, 1>(oscillator, from, guess)?;
    let (time, period) = (landing.time, oscillator.forcing_period());
    if time > 0.5 * period { Ok(landing) } else { Err(MapError::TooSoon { time }) }
}

/// The p-th iterate of P_global with its derivatives; return times are found afresh.
///
/// Paper: eq:Pglobalp, eq:xjzj.
///
/// # Errors
/// An iterate is not defined.
pub fn global_iterate<O: ImpactOscillator, const ORDER: usize>(
    oscillator: &O,
    loops: u32,
    from: AtRest,
) -> Result<MapJet<AtRest, AtRest>, MapError> {
    let mut jet = MapJet::identity(from);
    for _ in 0..loops {
        let next = global_map::<O, ORDER>(oscillator, jet.image(), None)?;
        jet = next.jet.after::<ORDER, _>(&jet);
    }
    Ok(jet)
}

/// P_disc = P_virt ∘ R ∘ P_virt⁻¹, the discontinuity map from (x̂, ẑ) to (x⁽⁰⁾, z⁽⁰⁾).
///
/// Paper: eq:Pdisc. Its derivative is singular at x̂ = 0, where it is the identity.
///
/// # Errors
/// x̂ ≤ 0, or one of the three maps is not defined.
pub fn discontinuity_map<O: ImpactOscillator, const ORDER: usize>(
    oscillator: &O,
    top: AtRest,
) -> Result<MapJet<AtRest, AtRest>, MapError> {
    let preimage = virtual_preimage(oscillator, top)?;
    let impact = virtual_map::<O, ORDER>(oscillator, preimage, None)?;
    let below = MapError::BelowTheWall { position: top.position };
    let inverse = impact.jet.inverse::<ORDER>(preimage).ok_or(below)?;
    let reset = oscillator.reset::<ORDER>(preimage);
    let recoil = virtual_map::<O, ORDER>(oscillator, reset.image(), None)?;
    Ok(recoil.jet.after::<ORDER, _>(&reset).after::<ORDER, _>(&inverse))
}

/// The flow from a state, whose motion is available, to the plane of constant phase `target`, with
/// coordinates (x, y).
///
/// The state is given by a point of Σ, (y, z), or of the plane of phase zero, (x, y). Defined
/// everywhere, in contrast to [`virtual_map`]; the target phase is held in all derivatives. Fixed
/// points of the map from phase zero to phase 2π are the periodic solutions without impacts.
pub fn to_phase<O: ImpactOscillator, const ORDER: usize, A: Surface>(
    oscillator: &O,
    motion: &O::Motion,
    from: State,
    target: f64,
) -> MapJet<A, AtPhase> {
    let frequency = oscillator.forcing_frequency();
    let time = (target - from.phase) / frequency.value;
    let jet = oscillator.flow_along::<ORDER>(motion, from, time);
    at_constant_phase::<ORDER, _>(&jet, &frequency, time)
}

/// From (x, y) at phase zero along the flow to the maximum of x near a time.
///
/// # Errors
/// There is no maximum of x near that time.
pub fn maximum_from_phase_zero<O: ImpactOscillator, const ORDER: usize>(
    oscillator: &O,
    from: AtPhase,
    near: f64,
) -> Result<Landing<AtPhase>, MapError> {
    land_on_section::<O, ORDER, _>(oscillator, from.at_phase_zero(), near, 0.0)
}

/// A map to a plane of constant phase, with its image as the oscillator's other stop sees it.
pub fn across<A: Surface>(
    oscillator: &impl ImpactOscillator,
    jet: &MapJet<A, AtPhase>,
    phase: f64,
) -> MapJet<A, AtPhase> {
    let mut seen = *jet;
    seen.value.neg_mut();
    seen.jacobian.neg_mut();
    seen.hessians.iter_mut().for_each(|hessian| hessian.neg_mut());
    for (component, gap) in oscillator.gap(phase).iter().enumerate() {
        seen.value[component] -= gap.value;
        for a in 0..2 {
            seen.jacobian[(component, 2 + a)] -= gap.gradient[a];
            (0..2).for_each(|b| seen.hessians[component][(2 + a, 2 + b)] -= gap.hessian[(a, b)]);
        }
    }
    seen
}

/// The maximum of x near a time after a state.
///
/// # Errors
/// There is no maximum of x near that time.
pub fn maximum_near<O: ImpactOscillator>(oscillator: &O, from: State, near: f64) -> Result<f64, MapError> {
    Ok(land_on_section::<O, 1, OnWall>(oscillator, from, near, 0.0)?.time)
}

/// Solves for the zero of the velocity and differentiates the landing point implicitly.
#[inline]
pub(crate) fn land_on_section<O: ImpactOscillator, const ORDER: usize, A: Surface>(
    oscillator: &O,
    from: State,
    guess: f64,
    turn: f64,
) -> Result<Landing<A>, MapError> {
    let motion = oscillator.motion(from);
    let farthest = MOST_PERIODS * oscillator.forcing_period();
    let mut time = guess;
    let mut here = motion.at(time);
    for _ in 0..MOST_ITERATIONS {
        // Halley's step for y = 0, of third order: y, ẏ and ÿ all come with one evaluation.
        let newton = here.velocity / here.acceleration;
        let step = newton / (1.0 - 0.5 * newton * here.jerk / here.acceleration);
        time -= step;
        // NaN counts as far away as well.
        let near = (time - guess).abs() <= farthest;
        if !near {
            break;
        }
        if step.abs() <= LAST_STEP_TO_SECTION {
            return finish_landing::<O, ORDER, A>(oscillator, &motion, from, time, turn);
        }
        here = motion.at(time);
    }
    Err(MapError::NoRest { near: guess, velocity: here.velocity })
}

/// The landing at a time that is known to be a zero of the velocity.
#[inline]
fn finish_landing<O: ImpactOscillator, const ORDER: usize, A: Surface>(
    oscillator: &O,
    motion: &O::Motion,
    from: State,
    time: f64,
    turn: f64,
) -> Result<Landing<A>, MapError> {
    let jet = oscillator.flow_along::<ORDER>(motion, from, time);
    let acceleration = jet.jacobian[(1, flow::DURATION)];
    if acceleration.is_nan() || acceleration >= 0.0 {
        return Err(MapError::NotAMaximum { acceleration });
    }
    Ok(Landing { jet: implicit_landing::<ORDER, A, AtRest>(oscillator, &jet, from.phase, time, turn), time })
}

/// Solves for the crossing of the wall upwards near a time, and differentiates the landing point
/// (y, z) implicitly; returns the time as well.
pub(crate) fn land_on_wall<O: ImpactOscillator, const ORDER: usize, A: Surface>(
    oscillator: &O,
    from: State,
    guess: f64,
) -> Result<(MapJet<A, OnWall>, f64), MapError> {
    let motion = oscillator.motion(from);
    let mut time = guess;
    for _ in 0..MOST_ITERATIONS {
        let here = motion.at(time);
        let step = here.position / here.velocity;
        time -= step;
        // NaN counts as far away as well.
        let near = (time - guess).abs() <= oscillator.forcing_period();
        if !near {
            break;
        }
        if step.abs() <= LAST_STEP_TO_SECTION {
            // One more step, of second order, leaves rounding only.
            let here = motion.at(time);
            time -= here.position / here.velocity;
            let jet = oscillator.flow_along::<ORDER>(&motion, from, time);
            let velocity = jet.value[1];
            if velocity.is_nan() || velocity <= 0.0 {
                return Err(MapError::NoCrossing { near: guess, velocity });
            }
            return Ok((implicit_landing::<ORDER, A, OnWall>(oscillator, &jet, from.phase, time, 0.0), time));
        }
    }
    Err(MapError::NoCrossing { near: guess, velocity: motion.at(guess).velocity })
}

/// A surface that the flow crosses: where a component of (x, y) vanishes.
trait Landed: Surface {
    /// The component that vanishes, which defines the duration of the flow.
    const VANISHING: usize;
}

impl Landed for AtRest {
    const VANISHING: usize = 1;
}

impl Landed for OnWall {
    const VANISHING: usize = 0;
}

/// The jet of the landing point, (x', z') on Π and (y', z') on Σ, from the flow's jet, where the
/// component that vanishes there defines the duration s as a function of (u, z; μ, η).
#[inline]
fn implicit_landing<const ORDER: usize, A: Surface, B: Landed>(
    oscillator: &impl ImpactOscillator,
    jet: &FlowJet,
    phase: f64,
    time: f64,
    turn: f64,
) -> MapJet<A, B> {
    let (vanishing, other) = (B::VANISHING, 1 - B::VANISHING);
    let columns = map_columns::<A>();
    let frequency = oscillator.forcing_frequency();
    let omega = [0.0, 0.0, frequency.gradient[0], frequency.gradient[1]];
    let rate = jet.jacobian[(vanishing, flow::DURATION)];
    // On Π the rate of x is the velocity, which is zero there but for rounding.
    let along_the_surface = if other == 0 { 0.0 } else { jet.jacobian[(other, flow::DURATION)] };
    let ds = Vector4::from_fn(|a, _| -jet.jacobian[(vanishing, columns[a])] / rate);

    let end = phase + frequency.value * time - turn;
    let mut map = MapJet::constant(Vector2::new(jet.value[other], end));
    for a in 0..4 {
        map.jacobian[(0, a)] = jet.jacobian[(other, columns[a])] + along_the_surface * ds[a];
        map.jacobian[(1, a)] = frequency.value * ds[a] + omega[a] * time;
    }
    if A::VARIABLES[1] == flow::PHASE {
        map.jacobian[(1, 1)] += 1.0;
    }
    if ORDER >= 2 {
        for a in 0..4 {
            for b in 0..=a {
                let along = |component: usize| second_along(&jet.hessians[component], &columns, &ds, a, b);
                let dds = -along(vanishing) / rate;
                let curvature = if b >= 2 { frequency.hessian[(a - 2, b - 2)] } else { 0.0 };
                let phase_entry =
                    frequency.value * dds + omega[a] * ds[b] + omega[b] * ds[a] + curvature * time;
                map.set_second(0, [a, b], along(other) + along_the_surface * dds);
                map.set_second(1, [a, b], phase_entry);
            }
        }
    }
    map
}

/// The columns of the flow that are the variables of a map from a surface.
const fn map_columns<A: Surface>() -> [usize; 4] {
    let [first, second] = A::VARIABLES;
    [first, second, flow::PRIMARY, flow::SECONDARY]
}

/// Second derivative of one component of the flow in the directions a and b, the duration moving
/// with them.
#[inline]
fn second_along(hessian: &Matrix6<f64>, columns: &[usize; 4], ds: &Vector4<f64>, a: usize, b: usize) -> f64 {
    hessian[(columns[a], columns[b])]
        + hessian[(columns[a], flow::DURATION)] * ds[b]
        + hessian[(columns[b], flow::DURATION)] * ds[a]
        + hessian[(flow::DURATION, flow::DURATION)] * ds[a] * ds[b]
}

/// The jet of the flow from a surface to a plane of constant phase, after the time s = (target −
/// z)/ω(μ, η) with z held where it is no coordinate of the surface.
fn at_constant_phase<const ORDER: usize, A: Surface>(
    jet: &FlowJet,
    frequency: &ParameterJet,
    time: f64,
) -> MapJet<A, AtPhase> {
    let columns = &map_columns::<A>();
    let omega = Vector4::new(0.0, 0.0, frequency.gradient[0], frequency.gradient[1]);
    let mut ds = -omega * (time / frequency.value);
    if A::VARIABLES[1] == flow::PHASE {
        ds[1] -= 1.0 / frequency.value;
    }
    let dds = |a: usize, b: usize| {
        let curvature = if a >= 2 && b >= 2 { frequency.hessian[(a - 2, b - 2)] } else { 0.0 };
        -(omega[a] * ds[b] + omega[b] * ds[a] + time * curvature) / frequency.value
    };
    let mut map = MapJet::constant(jet.value);
    for component in 0..2 {
        let rate = jet.jacobian[(component, flow::DURATION)];
        for a in 0..4 {
            map.jacobian[(component, a)] = jet.jacobian[(component, columns[a])] + rate * ds[a];
        }
        if ORDER >= 2 {
            for a in 0..4 {
                for b in 0..=a {
                    let entry = second_along(&jet.hessians[component], columns, &ds, a, b) + rate * dds(a, b);
                    map.set_second(component, [a, b], entry);
                }
            }
        }
    }
    map
}
