//! Section 4.3: the VIVID function and its derivatives at grazing.

use super::maps::{impact_and_recoil, integrated, virtual_point};
use crate::*;

/// A size of μ at which the zero of V is as close to grazing as in the figures: at most a tenth.
pub(super) fn scale(grazing: &Grazing, p: u32) -> Option<f64> {
    let emerging = grazing.grazing_point().emerging_orbit(p).ok()?;
    Some(0.1 / (1.0 + emerging.impact_velocity_slope.abs() + emerging.impact_phase_slope.abs()))
}

/// The admissible MPSs of the specimens with up to four loops, on the side of theorems 2.2 and 2.3.
fn admissible() -> Result<Vec<(Grazing, u32, Unknowns)>, CheckError> {
    let mut found = Vec::new();
    for grazing in specimens()?.into_iter().chain(delayed()?) {
        for p in 1..=4 {
            let Ok(theorem) = GenericGrazing::check(&grazing.grazing_point(), p) else { continue };
            // So close to grazing that the expansion decides on which side the visits lie.
            let size = scale(&grazing, p).ok_or("no emerging orbit")? * 0.01;
            let point = zero(&grazing, p, theorem.side().signum() * size).ok_or("no MPS")?;
            found.push((grazing.clone(), p, point));
        }
    }
    Ok(found)
}

/// The derivatives of V at grazing in (y, z, μ), from the derivatives of the maps.
pub(super) fn derivatives(grazing: &Grazing, p: u32) -> Result<VividLinearisation, MapError> {
    let point = unknowns(grazing, [0.0; 3]);
    let (_, derivative) =
        equations(grazing, p).maps::<1>(&point, &mut EventTimes::default())?.first().difference();
    Ok(VividLinearisation {
        by_impact: derivative.fixed_columns::<2>(0).into_owned(),
        by_parameter: derivative.column(2).into_owned(),
    })
}

/// The order of an expansion of V, for one component.
fn expansion(seed: u64, component: usize) -> CheckResult {
    let orders = drawn_over(seed, specimens_with(1..=4)?, |sampler, (grazing, p), orders: &mut Smallest| {
        let stated = grazing.grazing_point().vivid_linearisation(p);
        let equations = equations(&grazing, p);
        orders.see(uniform_order(&directions::<3>(sampler, 4), |direction, h| {
            let [dy, dz, dmu] = direction.map(|share| share * h);
            let vivid = vivid(&equations, &unknowns(&grazing, [dy, dz, dmu]))?;
            let linear = stated.by_impact * Vector2::new(dy, dz) + stated.by_parameter * dmu;
            // The rounding of a phase for each return.
            Some((vivid[component] - linear[component], 2e-15 * f64::from(p + 1)))
        }));
        Ok(())
    })?;
    // The next term is of relative size h < 10⁻⁴ at the last resolved sizes.
    Ok(orders.order(2.0, 0.1, "twelve oscillators, p = 1 to 4, seven directions in (y, z, μ) at once"))
}

checks! {
    /// eq:V: V compared with integration of both paths, from impact and recoil, return by return.
    // The error of integration, of fourth order in steps of 0.01, after four returns.
    composition: drawn_over(1, specimens_with(1..=4)?) |sampler, (grazing, p); deviations: Deviations| {
        // About a hundred steps per unit of time.
        const STEPS: u32 = 800;
        for _ in 0..2 {
            let distance = [(); 3].map(|()| sampler.between(-0.02, 0.02));
            let point = unknowns(&grazing, distance);
            let equations = equations(&grazing, p);
            let oscillator = equations.oscillator_at(&point);
            let vivid = vivid(&equations, &point).ok_or("V is not defined near grazing")?;
            let mut ends = Vec::new();
            for from in impact_and_recoil(&oscillator, point[0], point[1]) {
                let [y, z] = from.coordinates().into();
                let time = virtual_map::<_, 1>(&oscillator, from, None)?.time;
                ends.push(integrated(&oscillator, State::on_wall(y, z), time, 64));
            }
            let (hat, mut visit) = (ends[0], ends[1]);
            deviations.see(hat[1].abs().max(visit[1].abs()));
            for _ in 0..p {
                // Only the return time is taken from the map; the integration confirms that it ends on Π,
                // y = 0.
                let time = global_map::<_, 1>(&oscillator, AtRest::new(visit[0], visit[2]), None)?.time;
                visit = integrated(&oscillator, State::at_rest(visit[0], visit[2]), time, STEPS);
                deviations.see(visit[1]);
                visit[2] -= TAU;
            }
            deviations.see((vivid - Vector2::new(visit[0] - hat[0], visit[2] - hat[2])).amax());
        }
    } => deviations.outcome(1e-8, "points near grazing, y of either sign, twelve oscillators, p = 1 to 4");
    /// eq:xjzj: the points of an MPS on Π are the maxima of its motion from the recoil on.
    // Times of maxima are known to within the rounding of the velocity.
    visits: over(admissible()?) |(grazing, p, point); deviations: Deviations| {
        let equations = equations(&grazing, p);
        let oscillator = equations.oscillator_at(&point);
        let recoil = equations.departure(&point);
        let visits = equations.visits(&point, &EventTimes::default())?;
        let maxima = oscillator.motion(recoil).local_maxima(f64::from(p) * oscillator.forcing_period());
        for (j, visit) in visits.iter().enumerate().take(p as usize - 1) {
            let phase = |time: f64| {
                recoil.phase + oscillator.forcing_frequency().value * time - TAU * (j as f64 + 1.0)
            };
            let nearest = maxima
                .iter()
                .map(|maximum| Vector2::new(maximum.position, phase(maximum.time)))
                .min_by(|a, b| (a - visit).norm().total_cmp(&(b - visit).norm()))
                .ok_or("no maximum")?;
            deviations.see((nearest - visit).amax());
            if visit[0] >= 0.0 {
                return Err(format!("the visit {j} of p = {p} lies beyond the wall").into());
            }
        }
    } => deviations.outcome(1e-13, "visits of the admissible MPSs of fifteen oscillators, p = 2 to 4");
    /// Figure 9: from the recoil back to (x⁽⁰⁾, z⁽⁰⁾) beyond the wall, two loops, the first in front of
    /// the wall, and on to (x̂, ẑ), beyond the wall and after the impact.
    // Positions of order one and phases up to 2π, with a few roundings for each map.
    points_of_two_loops: over(admissible()?.into_iter().filter(|(_, p, _)| *p == 2)) |(grazing, p, point); deviations: Deviations| {
        let oscillator = equations(&grazing, p).oscillator_at(&point);
        let [impact, recoil] = impact_and_recoil(&oscillator, point[0], point[1]);
        let [hat, start] = [impact, recoil].map(|from| virtual_map::<_, 1>(&oscillator, from, None));
        let (hat, start) = (hat?, start?);
        deviations.require(impact.coordinates()[0] > 0.0 && recoil.coordinates()[0] < 0.0);
        deviations.require(hat.time > 0.0 && start.time < 0.0);
        deviations.require(hat.jet.value[0] > 0.0 && start.jet.value[0] > 0.0);
        let between = global_map::<_, 1>(&oscillator, start.jet.image(), None)?.jet;
        deviations.require(between.value[0] < 0.0);
        let end = global_map::<_, 1>(&oscillator, between.image(), None)?.jet;
        deviations.see((end.value - hat.jet.value).amax());
    } => deviations.outcome(1e-13, "the points of two-loop MPSs near grazing of fifteen oscillators");
    /// Zeros of V are MPSs: simulated orbits return to them, but not from points beside them or beyond
    /// grazing.
    zeros_are_orbits: over(admissible()?) |(grazing, p, point); (votes, printed): (Votes, Votes)| {
        let equations = equations(&grazing, p);
        let comes_back = |at: &Unknowns| followed(&equations, at) == ReturnOutcome::Returns;
        let mut beside = point.clone();
        beside[0] *= 1.01;
        let found = comes_back(&point);
        votes.see(point[0] > 0.0 && found);
        votes.see(!comes_back(&beside));
        let mu = point[2] - grazing.oscillator().parameters()[0];
        let other = zero(&grazing, p, -mu).ok_or("no zero on the other side")?;
        votes.see(other[0] < 0.0 && !comes_back(&other));
        printed.see(found);
        printed.see(comes_back(&other));
    } =>
        votes.outcome("MPSs near grazing of fifteen oscillators, p = 1 to 4, points beside them and on the other side")
            .against_print(printed.measure());
    /// (x̂, ẑ) of an MPS is a fixed point of P_global^p ∘ P_disc.
    // Newton's method for V, and that of P_disc for y, each with p roundings of phases.
    fixed_points: over(admissible()?) |(grazing, p, point); deviations: Deviations| {
        let oscillator = equations(&grazing, p).oscillator_at(&point);
        let hat = virtual_point(&oscillator, OnWall::new(point[0], point[1]))?;
        let start = discontinuity_map::<_, 1>(&oscillator, AtRest::new(hat[0], hat[1]))?.value;
        let end = global_iterate::<_, 1>(&oscillator, p, AtRest::new(start[0], start[1]))?.value;
        // The square root amplifies the rounding of x̂ by 1/y.
        deviations.see((end - hat).amax() * point[0]);
    } => deviations.outcome(1e-14, "MPSs near grazing of fifteen oscillators, p = 1 to 4: the deviation times y");
    /// V is twice differentiable across y = 0.
    // The next term is of relative size h² < 10⁻³.
    smooth_across_tangency: over(specimens_with(1..=3)?) |(grazing, p); orders: Smallest| {
        let equations = equations(&grazing, p);
        let second = |y: f64| {
            let point = unknowns(&grazing, [y, 0.0, 0.0]);
            let maps = equations.maps::<2>(&point, &mut EventTimes::default()).ok()?;
            Some([0, 1].map(|i| maps.first().round_trip.hessians[i] - maps.first().impact.hessians[i]))
        };
        orders.see(uniform_order(&[[0.0], [1.0]], |[component], h| {
            let i = component as usize;
            // Second derivatives reach several hundred.
            Some(((second(h)?[i] - second(-h)?[i]).norm(), 1e-12))
        }));
    } => orders.order(1.0, 0.1, "twelve oscillators, p = 1 to 3");
    /// V(0, z_graz; 0) = 0.
    // Six returns, each with the rounding of a phase.
    vanishes_at_grazing: over(specimens_with(1..=6)?) |(grazing, p); deviations: Deviations| {
        let value = vivid(&equations(&grazing, p), &unknowns(&grazing, [0.0; 3]));
        deviations.see(value.ok_or("V is not defined at grazing")?.amax());
    } => deviations.outcome(1e-13, "twelve oscillators, p = 1 to 6");
    /// eq:Jac1Jac2: the derivatives in J and K, compared with differences of V.
    // Rounding over the step, and derivatives of seventh order times its sixth power.
    jacobians: over(specimens_with(1..=4)?) |(grazing, p); deviations: Deviations| {
        let stated = grazing.grazing_point().vivid_linearisation(p);
        let VividLinearisation { by_impact, by_parameter } = derivatives(&grazing, p)?;
        let gap = (stated.by_impact - by_impact).amax().max((stated.by_parameter - by_parameter).amax());
        deviations.see(gap / (1.0 + by_impact.amax() + by_parameter.amax()));
        let equations = equations(&grazing, p);
        let columns = [by_impact.column(0).into_owned(), by_impact.column(1).into_owned(), by_parameter];
        for (axis, expected) in columns.into_iter().enumerate() {
            let slope = slope(1e-3, |h| {
                let mut step = [0.0; 3];
                step[axis] = h;
                vivid(&equations, &unknowns(&grazing, step))
            });
            let slope = slope.ok_or("V is not defined near grazing")?;
            deviations.see((slope - expected).amax() / (1.0 + expected.amax()));
        }
    } => deviations.outcome(1e-9, "three derivatives at grazing of twelve oscillators, p = 1 to 4");
    /// eq:V1.
    first_component: expansion(2, 0);
    /// eq:V2.
    second_component: expansion(3, 1);
}
