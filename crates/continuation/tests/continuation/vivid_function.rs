//! The VIVID function at grazing: its linearisation, and the MPS that a generic grazing bifurcation creates (section 4).

use grazing_continuation::locate::{Condition, locate};
use grazing_continuation::mps::{EventTimes, Formulation, LoopEquations, Unknowns};
use grazing_model::LinearOscillator;
use grazing_theorems::GrazingState;
use nalgebra::Vector2;

use crate::specimens::{EPSILON, OMEGA, ZETA, assert_within, at_grazing, order};

/// (ζ, ε, ω) away from all resonances with p ≤ 5.
const PLACES: [[f64; 3]; 4] =
    [[ZETA, EPSILON, OMEGA], [ZETA, EPSILON, 0.72], [0.07, 0.6, 0.93], [0.01, 1.0, 1.3]];

fn vivid([zeta, epsilon, omega]: [f64; 3], loops: u32) -> (GrazingState, LoopEquations<LinearOscillator>) {
    let (grazing, oscillator) = at_grazing(zeta, epsilon, omega);
    (grazing, LoopEquations::new(oscillator, loops, Formulation::Vivid))
}

/// (y, z, 𝒜, ω) at distances y, z − z_graz and μ from grazing.
fn near(grazing: &GrazingState, [y, z, mu]: [f64; 3]) -> Unknowns {
    Unknowns::new(y, grazing.phase() + z, grazing.amplitude() + mu, grazing.forcing_frequency())
}

#[test]
fn derivatives_at_grazing_are_the_printed_matrices() {
    for place in PLACES {
        for loops in 1..=5 {
            let (grazing, equations) = vivid(place, loops);
            let theory = grazing.grazing_point();
            let linear = theory.vivid_linearisation(loops);
            let point = near(&grazing, [0.0; 3]);
            let (value, derivative) =
                equations.pair::<1>(&point, &mut EventTimes::default()).unwrap().difference();
            // V vanishes at grazing. Here and below: entries below 50, each the sum of some tens of rounded products.
            assert_within(value.norm(), 0.0, 1e-13);
            let j = derivative.fixed_columns::<2>(0).into_owned();
            assert_within((j - linear.by_impact).norm(), 0.0, 1e-12);
            assert_within((derivative.column(2) - linear.by_parameter).norm(), 0.0, 1e-12);
            // Lemma 4.3: the determinants; products of two such entries.
            let k = derivative.fixed_columns::<2>(1).into_owned();
            assert_within(j.determinant(), theory.impact_jacobian_determinant(loops), 1e-11);
            assert_within(k.determinant(), theory.parameter_jacobian_determinant(loops), 1e-11);
            assert_within(k.determinant(), theory.parameter_jacobian_determinant_factored(loops), 1e-11);
        }
    }
}

#[test]
fn the_linearisation_leaves_a_second_order_remainder() {
    // eq:V1, eq:V2 with y, z − z_graz and μ of one size. Slack: the next order at these sizes.
    for place in PLACES {
        for loops in 1..=5 {
            let (grazing, equations) = vivid(place, loops);
            let linear = grazing.grazing_point().vivid_linearisation(loops);
            let remainders = [2e-4, 1e-4].map(|size| {
                let at = [size, -0.7 * size, 0.6 * size];
                let point = near(&grazing, at);
                let value = equations.pair::<1>(&point, &mut EventTimes::default()).unwrap().difference().0;
                value - linear.by_impact * Vector2::new(at[0], at[1]) - linear.by_parameter * at[2]
            });
            let [coarse, fine] = remainders;
            assert_within(order([coarse.norm(), fine.norm()]), 2.0, 0.1);
        }
    }
}

/// The zero of the VIVID function at a given μ.
fn zero_at(grazing: &GrazingState, equations: &LoopEquations<LinearOscillator>, mu: f64) -> Unknowns {
    let slopes = grazing.grazing_point().emerging_orbit(equations.loops()).unwrap();
    let start = near(grazing, [slopes.impact_velocity_slope * mu, slopes.impact_phase_slope * mu, mu]);
    let conditions = [Condition::Primary(start[2]), Condition::Secondary(start[3])];
    locate(equations, conditions, start, &mut EventTimes::default()).unwrap()
}

/// A μ at which the emerging p-loop MPS has an impact velocity of this size, positive or negative.
fn small_parameter(grazing: &GrazingState, loops: u32, velocity: f64) -> f64 {
    velocity / grazing.grazing_point().emerging_orbit(loops).unwrap().impact_velocity_slope
}

#[test]
fn impact_velocity_and_phase_of_the_emerging_orbit_have_the_printed_slopes() {
    // eq:yStar1codim1proof to eq:zStarpcodim1proof: errors of second order in μ, on either side of grazing.
    for place in PLACES {
        for loops in 1..=5 {
            let (grazing, equations) = vivid(place, loops);
            let slopes = grazing.grazing_point().emerging_orbit(loops).unwrap();
            for side in [1.0, -1.0] {
                // y = 2·10⁻⁴ is far below the velocity at which the branch nearest to a resonance, p = 3 at ω = 0.854, folds.
                let mu = small_parameter(&grazing, loops, side * 2e-4);
                let [coarse, fine] = [mu, 0.5 * mu].map(|mu| {
                    let zero = zero_at(&grazing, &equations, mu);
                    let phase = zero[1] - grazing.phase();
                    [zero[0] - slopes.impact_velocity_slope * mu, phase - slopes.impact_phase_slope * mu]
                });
                assert_within(order([coarse[0], fine[0]]), 2.0, 0.1);
                assert_within(order([coarse[1], fine[1]]), 2.0, 0.1);
            }
        }
    }
}

#[test]
fn visits_of_the_emerging_orbit_have_the_printed_slopes() {
    // eq:affineMapj with eq:z0codim1proof: (x⁽ʲ⁾, z⁽ʲ⁾) to first order in μ for j = 1, …, p.
    for place in PLACES {
        for loops in 1..=5 {
            let (grazing, equations) = vivid(place, loops);
            let slopes = grazing.grazing_point().emerging_orbit(loops).unwrap();
            let mu = small_parameter(&grazing, loops, 2e-4);
            let visits = [mu, 0.5 * mu].map(|mu| {
                let zero = zero_at(&grazing, &equations, mu);
                equations.visits(&zero, &EventTimes::default()).unwrap()
            });
            assert_eq!(visits[0].len(), loops as usize);
            for j in 1..=loops {
                let remainder = |visit: &Vector2<f64>, mu: f64| {
                    visit - Vector2::new(0.0, grazing.phase()) - slopes.visit_slope(j) * mu
                };
                let index = j as usize - 1;
                let coarse = remainder(&visits[0][index], mu);
                let fine = remainder(&visits[1][index], 0.5 * mu);
                assert_within(order([coarse.norm(), fine.norm()]), 2.0, 0.1);
            }
        }
    }
}

#[test]
fn last_visit_is_the_virtual_point_of_the_impact() {
    // eq:xpcodim1proof: x⁽ᵖ⁾ = y*²/2γ to second order, with an error of third.
    for loops in 1..=5 {
        let (grazing, equations) = vivid(PLACES[0], loops);
        let gamma = grazing.grazing_point().gamma;
        let mu = small_parameter(&grazing, loops, 2e-3);
        let errors = [mu, 0.5 * mu].map(|mu| {
            let zero = zero_at(&grazing, &equations, mu);
            let visits = equations.visits(&zero, &EventTimes::default()).unwrap();
            visits[loops as usize - 1][0] - zero[0] * zero[0] / (2.0 * gamma)
        });
        assert_within(order(errors), 3.0, 0.1);
    }
}
