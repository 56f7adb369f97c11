//! What is seen of any oscillator of the class at grazing, without closed forms.

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_model::ImpactOscillator;
use grazing_theorems::Side;
use grazing_theorems::from_map::GrazingOrbit;

use crate::Failure;
use crate::sweep::Existence;
use crate::sweep::generic::small_velocity;
use grazing_unfold::simulation::{Seen, Suspect};

fn follow<O: ImpactOscillator>(oscillator: &O, loops: u32, point: &Unknowns) -> Seen {
    Suspect { oscillator, loops, velocity: point[0], phase: point[1] }.follow()
}

/// On which side of a generic grazing bifurcation simulation sees the MPS that the VIVID function has a zero for.
pub(crate) fn side_of_orbit<O: ImpactOscillator>(
    orbit: &GrazingOrbit<O>,
    loops: u32,
) -> Result<Existence, Failure> {
    let point = orbit.grazing_point();
    let emerging = point.emerging_orbit(loops)?;
    let equations = LoopEquations::new(orbit.oscillator().clone(), loops, Formulation::Vivid);
    let [primary, secondary] = orbit.oscillator().parameters();
    // So small that the expansion decides on which side of the wall the loops lie: close to h_p one is shallow.
    let depth = (1..loops).map(|j| emerging.visit_slope(j).x.abs()).fold(f64::INFINITY, f64::min);
    let slope = emerging.impact_velocity_slope.abs();
    let size = small_velocity(&point, loops).min(0.01 * depth / slope) / slope;
    let mut found = [false; 2];
    for (found, sign) in found.iter_mut().zip([1.0, -1.0]) {
        let mu = sign * size;
        let start = Unknowns::new(
            emerging.impact_velocity_slope * mu,
            orbit.phase() + emerging.impact_phase_slope * mu,
            primary + mu,
            secondary,
        );
        let conditions = [Condition::Primary(start[2]), Condition::Secondary(secondary)];
        let zero = locate(&equations, conditions, start, &mut EventTimes::default())?;
        *found = follow(&equations.oscillator_at(&zero), loops, &zero) == Seen::Returns;
    }
    Ok(Existence::of(found))
}

/// The sign of η for which simulation sees the bifurcation near a resonance: an MPS to either side of it, at the same η, with the
/// multiplier crossed in between.
pub(super) fn side_of_curve<O: ImpactOscillator>(
    orbit: &GrazingOrbit<O>,
    loops: u32,
    multiplier: f64,
) -> Result<Existence, Failure> {
    let point = orbit.resonant_point(loops)?;
    let slope = if multiplier > 0.0 {
        point.saddle_node_velocity_slope()
    } else {
        point.period_doubling_velocity_slope()
    };
    let equations = LoopEquations::new(orbit.oscillator().clone(), loops, Formulation::Vivid);
    let [primary, secondary] = orbit.oscillator().parameters();
    let origin = Unknowns::new(0.0, orbit.phase(), primary, secondary);
    let phase_slope = orbit.phase_slope() + slope * point.branch_expansion().k_1;
    let tangent = Unknowns::new(slope, phase_slope, orbit.primary_slope(), 1.0) / slope;
    const VELOCITY: f64 = 0.005;
    let mut found = [None; 2];
    for (found, sign) in found.iter_mut().zip([1.0, -1.0]) {
        let velocity = sign * VELOCITY;
        let conditions = [Condition::Multiplier(multiplier), Condition::ImpactVelocity(velocity)];
        let start = origin + tangent * velocity;
        let zero = locate(&equations, conditions, start, &mut EventTimes::default())?;
        let mut beside = [None; 2];
        for (beside, share) in beside.iter_mut().zip([0.7, 1.3]) {
            let conditions = [Condition::ImpactVelocity(share * velocity), Condition::Secondary(zero[3])];
            let mps = locate(&equations, conditions, zero, &mut EventTimes::default())?;
            let oscillator = equations.oscillator_at(&mps);
            if follow(&oscillator, loops, &mps) == Seen::Returns {
                let suspect = Suspect { oscillator: &oscillator, loops, velocity: mps[0], phase: mps[1] };
                *beside = suspect.multipliers().map(|[t, d]| 1.0 - multiplier * t + d > 0.0);
            }
        }
        let crossed = matches!(beside, [Some(a), Some(b)] if a != b);
        let side = if zero[3] > secondary { Side::Positive } else { Side::Negative };
        *found = crossed.then_some(side);
    }
    Ok(match found {
        [Some(side), None] | [None, Some(side)] => Existence::On(side),
        [None, None] => Existence::Nowhere,
        [Some(_), Some(_)] => Existence::Unclear,
    })
}
