//! Theorems 2.2 and 2.3 against simulation: on which side of grazing the p-loop MPS exists.

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_theorems::{GenericGrazing, ResonantGrazing};
use proptest::prelude::*;

use crate::hybrid::assert_returns;
use crate::specimens::{at_grazing, deterministic};

proptest! {
    #![proptest_config(deterministic(256))]

    #[test]
    fn the_emerging_orbit_is_admissible_on_the_side_of_the_theorem_and_virtual_on_the_other(
        zeta in 0.005..0.1,
        epsilon in 0.5..1.0,
        loops in 1u32..=4,
        index in 0u32..=2,
        detuning in prop_oneof![-0.01..-0.001, 0.001..0.01],
    ) {
        let theory = grazing_theorems::LinearOscillator::new(zeta, epsilon).unwrap();
        // n = 0 is only for p ≥ 2, where it means ω > 2; for p = 1 count from 2 on.
        let resonance = theory.resonance(loops, if loops == 1 { index + 2 } else { index + 1 }).unwrap();
        let omega = resonance.forcing_frequency() * (1.0 + detuning);
        let (grazing, oscillator) = at_grazing(zeta, epsilon, omega);
        let point = grazing.grazing_point();
        let theorem = GenericGrazing::check(&point, loops).unwrap();
        let emerging = point.emerging_orbit(loops).unwrap();

        // The expansion is good up to the impact velocities at which the nearby resonance bends the branch, Υ^±.
        let resonant = ResonantGrazing::check(&resonance.resonant_point(), 1e-12).unwrap();
        let eta = omega - resonance.forcing_frequency();
        let [plus, minus] = [resonant.saddle_node(), resonant.period_doubling()].map(|curve| curve.impact_velocity_slope * eta);
        let velocity = 0.02 * plus.abs().min(minus.abs()).min(0.1);
        let size = velocity / emerging.impact_velocity_slope.abs();

        let equations = LoopEquations::new(oscillator, loops, Formulation::Vivid);
        for side in [theorem.side().signum(), -theorem.side().signum()] {
            let mu = side * size;
            let start = Unknowns::new(
                emerging.impact_velocity_slope * mu,
                grazing.phase() + emerging.impact_phase_slope * mu,
                grazing.amplitude() + mu,
                omega,
            );
            let conditions = [Condition::Primary(start[2]), Condition::Secondary(omega)];
            let zero = locate(&equations, conditions, start, &mut EventTimes::default()).unwrap();
            // The same solution as the expansion's, whose terms of second order are some percent.
            prop_assert!((zero[0] / start[0] - 1.0).abs() < 0.2, "{zero:?} from {start:?}");
            let solution = equations.solution(&zero).0;
            if side == theorem.side().signum() {
                prop_assert!(solution.admissible(), "{solution:?}");
                prop_assert!(!solution.stable(), "{solution:?}");
                assert_returns(&equations.oscillator_at(&zero), &solution);
            } else {
                prop_assert!(zero[0] < 0.0 && !solution.admissible(), "{solution:?}");
            }
        }
    }
}
