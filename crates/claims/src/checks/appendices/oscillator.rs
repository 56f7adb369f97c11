//! Appendix B: A, b and ξ_p from the printed flow.

use super::printed_flow::{DIFFERENCES, Derivatives, Printed, STATES, STEP, Turn, first, states};
use crate::*;

/// Compares computed with stated numbers at random states.
fn over_states(
    count: usize,
    tolerance: f64,
    pairs: impl Fn(&GrazingState) -> Result<Vec<(f64, f64)>, CheckError>,
) -> CheckResult {
    let mut largest = Deviations::default();
    for state in states(count)? {
        largest.pairs(pairs(&state)?);
    }
    Ok(largest.outcome(tolerance, STATES))
}

/// Compares ξ_p in closed form with the second derivative of P_global^p.
fn xi(loops: RangeInclusive<u32>) -> CheckResult {
    // Second derivatives of up to five composed maps.
    over_states(200, 1e-13, |state| {
        let one = |p: u32| {
            let jet = global_iterate::<_, 2>(&state.model(), p, AtRest::new(0.0, state.phase()))?;
            Ok((jet.hessians[0][(1, 1)], state.second_phase_derivative(p)))
        };
        loops.clone().map(one).collect()
    })
}

checks! {
    /// eq:Abproof1: P_global ends where the printed flow from (x, 0) at z/ω comes to rest.
    // Rounding over the step: the velocity is a first derivative.
    return_by_printed_flow: drawn_over(13, states(400)?) |sampler, state; largest: Deviations| {
        let mut at = || 0.02 * sampler.between(-1.0, 1.0);
        let (x, z, amplitude) = (at(), state.phase() + at(), state.amplitude() * (1.0 + at()));
        let oscillator = grazing_model::ImpactOscillator::with_parameters(
            &state.model(),
            [amplitude, state.forcing_frequency()],
        );
        let Ok(landing) = global_map::<_, 1>(&oscillator, AtRest::new(x, z), None) else { return Ok(()) };
        let printed = Printed { zeta: state.oscillator().damping_ratio(), omega: state.forcing_frequency() };
        let omega = state.forcing_frequency();
        let end = (landing.jet.value[1] + TAU) / omega;
        let flow = |time: f64| printed.flow(time, [x, 0.0], z / omega, amplitude);
        let velocity = first(STEP / omega.max(1.0), |h| flow(end + h));
        largest.pairs([(flow(end), landing.jet.value[0]), (velocity, 0.0)]);
    } => largest.outcome(1e-12, "returns to Π from points within 0.02 of grazing");
    /// eq:Abproof2: both lines, as the order of the remainder of φ and φ̇ after the linear terms.
    // The slack is for the third order where the second exceeds the accuracy of the differences.
    first_order_terms: drawn_over(14, states(60)?) |sampler, state; least: Smallest| {
        let derivatives = Derivatives::new(&state, 1);
        let map = state.linearised_map();
        let omega = state.forcing_frequency();
        let shares: [f64; 3] = core::array::from_fn(|_| sampler.between(-1.0, 1.0));
        let [by_x, by_start, by_amplitude] = [0, 1, 2].map(|k| [0, 1].map(|n| derivatives.mixed(n, k)));
        let rates = [derivatives.velocity(), derivatives.acceleration()];
        for line in 0..2 {
            least.see(order(|size| {
                let [d_1, d_2, d_3] = shares.map(|share| share * size);
                let shift = (map.a.m21 * d_1 + map.a.m22 * d_2 + map.b.y * d_3) / omega;
                let linear = rates[line] * shift
                    + by_x[line] * d_1
                    + by_start[line] * d_2 / omega
                    + by_amplitude[line] * d_3;
                let moved = [d_1, d_2 / omega, d_3];
                // φ or φ̇ at the end to first order, minus the equation's left side: x' or zero.
                let actual = if line == 0 {
                    derivatives.at([shift, moved[0], moved[1], moved[2]])
                } else {
                    first(derivatives.step(), |h| derivatives.at([shift + h, moved[0], moved[1], moved[2]]))
                };
                let left = if line == 0 { map.a.m11 * d_1 + map.a.m12 * d_2 + map.b.x * d_3 } else { 0.0 };
                // Flow and left-hand side differ from the linear terms in second order; these are known
                // to the accuracy of differences, and count only if more than a hundred times larger.
                let gap = (actual - left).abs().max((linear - left).abs());
                Some((gap, 1e-12 * (1.0 + size * 1e2)))
            }));
        }
    } => least.order(2.0, 0.3, STATES);
    /// eq:Abproof4: all eight derivatives of φ at grazing.
    derivatives_at_grazing: over_states(300, DIFFERENCES, |state| {
        let derivatives = Derivatives::new(state, 1);
        let turn = Turn::new(state, 1);
        let (omega, amplitude) = (state.forcing_frequency(), state.amplitude());
        let upper = turn.decay * (turn.cosine + turn.skew * turn.sine);
        let lower = turn.decay * turn.sine / turn.natural;
        Ok(vec![
            (derivatives.velocity(), 0.0),
            (derivatives.acceleration(), -omega * omega),
            (derivatives.mixed(0, 0), upper),
            (derivatives.mixed(1, 0), -lower),
            (derivatives.mixed(0, 1), omega * omega * lower),
            (derivatives.mixed(1, 1), omega * omega * turn.entry()),
            (derivatives.mixed(0, 2), (1.0 - upper) / amplitude),
            (derivatives.mixed(1, 2), lower / amplitude),
        ])
    });
    /// eq:Abproof3 with differences of the printed flow, against the derivatives of P_global.
    entries_by_derivatives: over_states(300, DIFFERENCES, |state| {
        let derivatives = Derivatives::new(state, 1);
        let omega = state.forcing_frequency();
        let (velocity, acceleration) = (derivatives.velocity(), derivatives.acceleration());
        let jet = global_map::<_, 1>(&state.model(), AtRest::new(0.0, state.phase()), None)?.jet;
        let entries = |(variable, scale): (usize, f64)| {
            let (position, rate) = (derivatives.mixed(0, variable), derivatives.mixed(1, variable));
            let found = [position - velocity / acceleration * rate, -omega / acceleration * rate];
            [0, 1].map(|row| (found[row] * scale, jet.jacobian[(row, variable)]))
        };
        Ok([(0, 1.0), (1, 1.0 / omega), (2, 1.0)].into_iter().flat_map(entries).collect())
    });
    /// The display of ξ₁ by differences of φ, against the second derivative of P_global.
    second_derivative_by_flow: over_states(200, DIFFERENCES, |state| {
        let derivatives = Derivatives::new(state, 1);
        let omega = state.forcing_frequency();
        let (velocity, acceleration) = (derivatives.velocity(), derivatives.acceleration());
        let slip = velocity / acceleration;
        let entry = state.linearised_map().a.m22;
        let xi = (entry * entry * (acceleration - slip * derivatives.in_time(3, [0.0; 3]))
            + 2.0 * entry * (derivatives.mixed(1, 1) - slip * derivatives.mixed(2, 1))
            + derivatives.twice_in_start(0)
            - slip * derivatives.twice_in_start(1))
            / (omega * omega);
        let jet = global_map::<_, 2>(&state.model(), AtRest::new(0.0, state.phase()), None)?.jet;
        Ok(vec![(xi, jet.hessians[0][(1, 1)])])
    });
    /// eq:d2phidt02.
    second_derivative_in_start: over_states(300, DIFFERENCES, |state| {
        let turn = Turn::new(state, 1);
        let omega = state.forcing_frequency();
        let stated = -omega * omega * turn.decay * (turn.cosine - 3.0 * turn.skew * turn.sine);
        Ok(vec![(Derivatives::new(state, 1).twice_in_start(0), stated)])
    });
    /// eq:xi1proof2.
    second_derivative_of_one_loop: xi(1..=1);
    /// eq:xipproof2, off resonance too.
    second_derivative_of_many_loops: xi(2..=5);
}
