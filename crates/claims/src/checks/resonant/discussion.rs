//! Section 6: discussion.

use super::derivatives::differences;
use crate::checks::main_results::returns::derivatives;
use crate::checks::oscillator::diagram::{Figure7Window, figure_7, is_vertex, theory};
use crate::*;
use grazing_continuation::curve::CurvePoint;
use grazing_continuation::fit::quadratic_coefficient;
use grazing_model::AnyOscillator;
use grazing_unfold::Scope;
use grazing_unfold::generations::{bases, later};
use grazing_unfold::long_time::{Horizon, LongOrbit};
use grazing_unfold::progress::Silent;

/// n ω* is twice the damped natural frequency if p = 1 and the force is linear, but not otherwise.
pub(crate) fn rational_multiples() -> CheckResult {
    let spread = |law: Law| -> Result<f64, CheckError> {
        let products = (2..=4_u32)
            .map(|n| Ok(f64::from(n) * ResonantSpecimen::find(law, 1, n)?.point().grazing.forcing_frequency));
        let products = products.collect::<Result<Vec<f64>, CheckError>>()?;
        let [low, high] = [f64::min, f64::max]
            .map(|choose| products.iter().copied().reduce(choose).expect("there are three"));
        Ok((high - low) / high)
    };
    let damping = damping_for_decay(1, 3, 0.6);
    let (mut linear, mut printed) = (Deviations::default(), Deviations::default());
    linear.see(spread(Law::linear(damping, 0.8))?);
    printed.see(spread(Law::nonlinear(damping))?);
    // Resonances are located to a few roundings.
    let over = "n = 2 to 4 of a linear oscillator; the print of one with a nonlinear force";
    Ok(linear.outcome(1e-14, over).against_print(printed.measure(1e-14)))
}

/// All resonances in the window of Figure 7, with their n: those with p = 1 and n = 3, 4, 5, p = 2 and 3
/// with n = 1, 2, and, which the text does not name, p = 1 with n = 2.
pub(super) fn of_figure_7() -> Result<Vec<(u32, ResonantSpecimen)>, CheckError> {
    let Figure7Window { frequency: [lowest, highest], loops, .. } = Figure7Window::read()?;
    let law = Law::linear(printed("zeta"), printed("epsilon"));
    let listed = theory()?.resonances(&loops, lowest, highest)?;
    let place = |at: &Resonance| Ok((at.index(), ResonantSpecimen::find(law, at.loops(), at.index())?));
    listed.iter().map(place).collect()
}

/// The return to Π of an MPS that grazes between its impacts: from its maximum at the wall to the impact,
/// through the reset law and on to the same maximum, with the grazing itself ignored.
fn return_through_impact(place: &ResonantSpecimen, solution: &PeriodicSolution) -> Option<[Observed; 4]> {
    let equations = place.resonance.equations();
    let point = &solution.unknowns;
    let oscillator = equations.oscillator_at(point);
    let maximum = solution.highest_interior_maximum?;
    let recoil = equations.departure(point);
    let omega = oscillator.forcing_frequency().value;
    let phase = recoil.phase + omega * maximum.time;
    let left = f64::from(place.loops()) * oscillator.forcing_period() - maximum.time;
    let map = |x: f64, z: f64| {
        let motion = oscillator.motion(State::at_rest(x, phase + z));
        let mut time = left;
        for _ in 0..20 {
            let here = motion.at(time);
            time -= here.position / here.velocity;
        }
        let reset =
            oscillator.reset::<1>(OnWall::new(motion.at(time).velocity, phase + z + omega * time)).value;
        Some(
            virtual_map::<_, 1>(&oscillator, OnWall::new(reset[0], reset[1]), Some(maximum.time))
                .ok()?
                .jet
                .value,
        )
    };
    // Positions and phases of order one, multiplied by up to six.
    let component = |i: usize, x: f64, z: f64| seam(1e-14, |h| Some(map(0.1 * x * h, 0.1 * z * h)?[i]));
    // If there is no return, there is no order.
    let returned = map(0.0, 0.0)?;
    if (returned[0] - maximum.position).abs() > 1e-9 {
        return None;
    }
    Some([component(0, 1.0, 0.3), component(1, 1.0, 0.3), component(0, -0.2, 1.0), component(1, -0.2, 1.0)])
}

/// Grazing often induces chaos: more than half of the orbits just beyond it, at frequencies of
/// Figure 7, have a positive Lyapunov exponent.
pub(crate) fn chaos() -> CheckResult {
    let theory = theory()?;
    let mut chaotic = Votes::default();
    let mut sampler = Sampler::new(231);
    let samples = 60;
    for _ in 0..samples {
        let grazing = theory.grazing(sampler.between(0.4, 0.9))?;
        let beyond = (1.0 + sampler.between(0.002, 0.02)) * grazing.amplitude();
        let oscillator =
            AnyOscillator::new(grazing.model()).with_parameters([beyond, grazing.forcing_frequency()]);
        // Transients near grazing are long, and exponents over 300 periods are accurate to about 0.01.
        let orbit = LongOrbit::follow(&oscillator, sampler.state(), Horizon::drifting(500, 300));
        chaotic.see(orbit.exponent(&oscillator).mean * oscillator.forcing_period() > 0.02);
    }
    let Measure::Agreement { agreeing, cases } = chaotic.measure() else {
        unreachable!("votes agree or not")
    };
    let margin = Measure::Margin { smallest: agreeing as f64 / cases as f64 - 0.5 };
    Ok(Outcome::new(
        margin,
        samples,
        "the share of orbits with a positive exponent just beyond grazing, less a half",
    ))
}

/// A window wide enough for the curves to end in it, at codimension-two points.
pub(super) const ROUTE: Route = Route {
    window: Window { primary: [0.0, 3.0], secondary: [0.2, 1.2] },
    control: StepControl::DRAWING,
    step_limit: 3_000,
    stop_at_events: true,
    pace: None,
};

/// Whether the SN curve leaves a resonance to higher frequencies and the PD curve to lower ones, or the
/// other way round; each MPS on them is admissible on one side alone.
fn leaves_upwards(place: &ResonantSpecimen) -> Result<bool, CheckError> {
    let mut upwards = Vec::new();
    for curve in place.curves() {
        for side in [1.0, -1.0] {
            let eta = side * 1e-4 / curve.leading.impact_velocity_slope.abs();
            let near = place.on_curve(&curve, eta).ok_or("no point on a curve")?;
            if place.solution(&near).admissible() {
                upwards.push(side > 0.0);
            }
        }
    }
    match upwards[..] {
        [saddle_node, period_doubling] if saddle_node != period_doubling => Ok(saddle_node),
        _ => Err("SN and PD curves do not leave to one side each".into()),
    }
}

/// The one-loop regions of Figure 7 and the resonances that their curves leave: those with even n, 4 and 6,
/// differ from those with odd n, 3 and 5, in the sides to which the curves leave, and so does n = 2. The
/// paper knows n = 3, 4, 5, and that the region at ω ≈ 0.5 is unlike all others.
pub(crate) fn one_loop_regions() -> CheckResult {
    let (diagram, natural) = (figure_7()?, theory()?.damped_natural_frequency());
    let (mut cases, mut print) = (Votes::default(), Votes::default());
    let frequency = |place: &ResonantSpecimen| place.point().grazing.forcing_frequency;
    let is_other = |place: &ResonantSpecimen| (frequency(place) - 0.5).abs() < 0.005;
    for region in diagram.regions.iter().filter(|region| region.loops == 1) {
        let law = Law::linear(printed("zeta"), printed("epsilon"));
        let place = ResonantSpecimen::find(law, 1, region.n)?;
        // Resonances are located to a few roundings.
        cases.see((2.0 * natural / frequency(&place) - f64::from(region.n)).abs() < 1e-12);
        // The SN curve ends on the border of the region, if followed from the resonance.
        let fold = place.resonance.unfold(&ROUTE)?.saddle_node;
        let end = fold.points.last().ok_or("the SN curve has no points")?.solution.parameters();
        cases.see(is_vertex(diagram, region, end));
        let upwards = leaves_upwards(&place)?;
        cases.see(upwards == (region.n % 2 == 0));
        print.see(
            matches!(region.n, 3..=5) && (region.n == 4) == is_other(&place) && upwards == is_other(&place),
        );
    }
    for (n, place) in of_figure_7()? {
        let upwards = leaves_upwards(&place)?;
        cases.see(upwards == (place.loops() == 1 && n % 2 == 0));
        print.see(upwards == is_other(&place));
    }
    let over = "one-loop regions of Figure 7 and all resonances in its window: where curves begin, and to which side they leave";
    Ok(cases.outcome(over).against_print(print.measure()))
}

/// At resonances on the curves along which MPSs of Figure 7 graze, whose motion has impacts elsewhere, the
/// coefficients of Theorems 2.4 and 2.5 are those of the curves of the hybrid system.
pub(crate) fn theorems_elsewhere() -> CheckResult {
    let diagram = figure_7()?;
    let scope = Scope { loops: vec![1, 2, 3, 4], ..diagram.scope.clone() };
    let (mut largest, mut compared) = (Deviations::default(), 0);
    for found in later(diagram, &bases(diagram), &scope, &Silent).resonances {
        let Ok(point) = &found.resonance.theorem else { continue };
        let conditions = [Condition::SADDLE_NODE, Condition::PERIOD_DOUBLING];
        for (condition, leading) in conditions.into_iter().zip(point.leading().into_array()) {
            let fit = quadratic_coefficient(point, condition)?;
            // Where two resonances nearly coincide, as beside ω = 1/2, the curves hardly leave.
            if fit.error < 1e-7 * fit.value.abs() {
                largest.compare(fit.value, leading.coefficient, fit.value.abs());
                compared += 1;
            }
        }
    }
    largest.require(compared >= 16);
    // Measured to seven digits or more.
    Ok(largest
        .outcome(1e-7, "SN and PD curves of solutions with two to five impacts, compared with the theorems"))
}

checks! {
    /// The sign of a₁₂' by the parity of n, and the side on which the SN curve leaves.
    direction_by_parity: over(1..=12_u32) |n; cases: Votes| {
        for decay in [0.2, 0.5, 0.8] {
            let place = ResonantSpecimen::find(Law::linear(damping_for_decay(1, n, decay), 0.8), 1, n)?;
            let rate = place.along_grazing(1e-3, |_, map| map.a.m12)?;
            let odd = n % 2 == 1;
            cases.see((rate > 0.0) == odd);
            // s₁⁺ < 0: the SN curve leaves to the side of −sgn a₁₂', the PD curve to the other.
            for (curve, side) in place.curves().iter().zip([-1.0, 1.0]) {
                let eta = libm::copysign(1e-4, if odd { side } else { -side })
                    / curve.leading.impact_velocity_slope.abs();
                let near = place.on_curve(curve, eta).ok_or("no point on a curve")?;
                cases.see(near.unknowns[unknown::VELOCITY] > 0.0);
            }
        }
    } => cases.outcome("the sign of a₁₂' and the sides of SN and PD curves, n = 1 to 12");
    /// Impacts elsewhere leave P_global smooth, as shown by MPSs that graze between their impacts.
    impacts_elsewhere: over(of_figure_7()?) |(_, place); orders: Vec<Observed>| {
        for curve in place.resonance.unfold(&ROUTE)?.grazing {
            // Impacts that are clearly not grazing.
            let fast = |at: &&CurvePoint| at.solution.impact_velocity() > 0.05;
            for point in curve.points.iter().step_by(10).filter(fast) {
                orders.extend(return_through_impact(&place, &point.solution).into_iter().flatten());
            }
        }
    } => of_orders(&orders, "returns through an impact of MPSs on the grazing curves of Figure 7, extrapolated from both sides of the wall");
    /// Between the curves an MPS is stable if φ²δᵖ < 1, and its determinant exceeds 1 if φ²δᵖ > 1.
    stabilisation: over([(1, 2), (1, 3), (2, 1), (3, 1)]) |(loops, n); (votes, printed): (Votes, Votes)| {
        for decay in [0.4, 0.6, 0.8] {
            // φ²δᵖ = (ε E_p)², well below or above 1.
            for size in [0.3, 0.8, 1.2, 1.6] {
                let law = Law::linear(damping_for_decay(loops, n, decay), size / decay);
                let place = ResonantSpecimen::find(law, loops, n)?;
                let point = place.point();
                let stability = point.stability_coefficients();
                let by_eta =
                    point.grazing.alpha() * point.grazing.forcing_frequency * point.off_diagonal_slope();
                // Between the lines y Ψ^± = 0, where the next terms are a few per cent.
                let y = 1e-4;
                let eta = 0.5 * (stability.plus + stability.minus) * y / by_eta;
                let near = place.on_branch(y, eta).ok_or("no MPS between the curves")?;
                let solution = place.solution(&near);
                votes.see(solution.stable() == (size < 1.0));
                votes.see((solution.multipliers.determinant > 1.0) == (size > 1.0));
                printed.see(solution.stable());
            }
        }
    } =>
        votes.outcome("MPSs between SN and PD at resonances with p up to 3, restitutions to both sides of 1/E_p")
            .against_print(printed.measure());
    /// The data of the theorems from differences of values of P_global, compared with `from_map`.
    // Nested differences: rounding 10⁻¹⁵ over both steps is 10⁻⁹; sixth derivatives reach 10¹².
    finite_differences: everywhere(ANY) |place; largest: Deviations| {
        let point = place.point();
        let map = point.grazing.map;
        let found = differences(place).ok_or("P_global is not defined around a resonance")?;
        largest.pairs([
            (found.xi, point.second_phase_derivative),
            (found.f_followed, point.off_diagonal_slope()),
        ]);
        let columns = [map.a.column(0).into_owned(), map.a.column(1).into_owned(), map.b];
        for (found, stated) in derivatives(place.resonance.orbit(), 1.0)?.iter().zip(&columns) {
            largest.pairs(found.iter().copied().zip(stated.iter().copied()));
        }
    } => largest.outcome(1e-8, "A, b, ξ and a₁₂' or f at resonances, by values of P_global alone");
    /// Near a resonance an MPS is stable between the lines y Ψ⁺ = 0 and y Ψ⁻ = 0, and nowhere else.
    periodicity_regions: everywhere(ANY) |place; cases: Votes| {
        let stability = place.point().stability_coefficients();
        let by_eta = place.point().grazing.alpha()
            * place.point().grazing.forcing_frequency
            * place.point().off_diagonal_slope();
        let radius = 3e-4;
        // Angles in the half-plane y > 0, with η in units in which the lines have slopes of order one.
        for k in 1..40 {
            let (sine, cosine) = libm::sincos(core::f64::consts::PI * f64::from(k) / 40.0);
            let (y, eta) = (radius * sine, radius * cosine / by_eta);
            let [plus, minus] = [stability.plus * y - by_eta * eta, stability.minus * y - by_eta * eta];
            // The next terms move the lines by a few per cent at this radius.
            if plus.abs().min(minus.abs()) < 0.05 * radius {
                continue;
            }
            let Some(near) = place.on_branch(y, eta) else { continue };
            let solution = place.solution(&near);
            cases.see(solution.stable() == (plus < 0.0 && minus > 0.0));
        }
    } => cases.outcome("MPSs around resonances, stable between SN and PD curves alone");
    /// The response can be periodic near resonant grazing: stable MPSs attract.
    periodic_response: everywhere(ANY) |place; cases: Votes| {
        for near in super::simulation::admissible(place).iter().step_by(3) {
            let Multipliers { trace, determinant } = place.solution(near).multipliers;
            // Well inside the triangle of stability, so that convergence is fast.
            if trace.abs() <= 0.9 * (1.0 + determinant) && determinant <= 0.9 {
                cases.see(attracts(place.resonance.equations(), &near.unknowns) == Some(true));
            }
        }
    } => cases.outcome("perturbed stable MPSs near resonances, simulated until they are ten times nearer");
}
