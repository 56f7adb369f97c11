//! Section 6: the solutions created at the period doublings of Figure 7.

use super::discussion::of_figure_7;
use super::simulation::next_impact;
use crate::checks::oscillator::diagram::{figure_7, theory};
use crate::*;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::cascade::Cascade;
use grazing_continuation::criticality::{changes, period_doubling};
use grazing_continuation::curve::Curve;
use grazing_continuation::doubled::DoubledEquations;
use grazing_theorems::LimitMap;
use grazing_unfold::resonances::FoundResonance;

/// Admissible points of a PD curve, evenly spaced along it.
fn flips(curve: &Curve, count: usize) -> Result<Vec<Unknowns>, CheckError> {
    let solutions = curve.points.iter().map(|point| &point.solution);
    let points: Vec<&PeriodicSolution> =
        solutions.filter(|solution| solution.impact_velocity() > 1e-4 && solution.admissible()).collect();
    let last = points.len().checked_sub(1).ok_or("the PD curve has no points")?;
    Ok((0..count).map(|k| points[k * last / (count - 1).max(1)].unknowns.clone()).collect())
}

/// The period-doubled MPS near a PD point, and whether it has a multiplier above 1.
fn doubled<O: ImpactOscillator>(
    equations: &LoopEquations<O>,
    flip: &Unknowns,
) -> Result<(bool, Unknowns), CheckError> {
    let equations = DoubledEquations::new(equations);
    let beside = 0.1 * flip[unknown::VELOCITY];
    let doubled = equations.near(flip, beside).ok_or("no period-doubled MPS beside a PD point")?;
    let multipliers = equations.multipliers(&doubled).ok_or("no multipliers")?;
    // 1 − T + D is the product of 1 − λ over both multipliers, one of which is near 1 and the other below
    // 1.
    Ok((1.0 - multipliers.trace + multipliers.determinant < 0.0, doubled))
}

/// Whether the simulated orbit that starts beside the MPS ends on the period-doubled one.
fn settles(place: &ResonantSpecimen, doubled: &Unknowns) -> bool {
    let equations = place.resonance.equations();
    let oscillator = equations.oscillator_at(doubled);
    let [first, second] =
        DoubledEquations::new(equations).impacts(doubled).map(|impact| Vector2::new(impact[0], impact[1]));
    // Displaced from the middle of the two impacts, where the MPS is, by a hundredth of their distance.
    let mut here = (first + second) * 0.5 + (first - second) * 0.01;
    for _ in 0..2000 {
        match next_impact(&oscillator, place.loops(), here) {
            Some(next) => here = next,
            None => break,
        }
    }
    (here - first).norm().min((here - second).norm()) < 1e-3 * (first - second).norm()
}

/// The number of impacts after which motion of the limit map that begins near the fixed point recurs, if
/// it does.
fn impacts_of(map: &LimitMap, parameter: f64) -> Option<usize> {
    let [velocity, _] = map.period_doubling();
    let (mut here, _) = map.fixed_point(1.001 * velocity);
    let mut last = Vec::new();
    for _ in 0..20_000 {
        here = map.step(Side::of(velocity), parameter, here).ok()?;
        last.push(here.velocity);
    }
    let last = &last[last.len() - 64..];
    (1..=32).find(|&count| {
        last[count..].iter().zip(last).all(|(later, first)| (later / first - 1.0).abs() < 1e-4)
    })
}

/// The period doublings of Figure 7. According to the paper all create an unstable solution. In fact, close
/// to resonances only those with p = 1 and even n do, and those of solutions of two loops that leave these;
/// the others create one that attracts in simulation.
pub(crate) fn criticality_of_figure_7() -> CheckResult {
    let (mut cases, mut print) = (Votes::default(), Votes::default());
    for (n, place) in of_figure_7()? {
        let subcritical = place.loops() == 1 && n % 2 == 0;
        cases.see((place.point().limit_map().criticality() < 0.0) == subcritical);
        let equations = place.resonance.equations();
        let curve = &place.curves()[1];
        // Close to the resonance the leading terms dominate: both velocities are proportional to y.
        for y in [4e-3, 2e-3, 1e-3, 5e-4] {
            let eta = y / curve.leading.impact_velocity_slope;
            let Some(near) = place.on_curve(curve, eta) else { continue };
            let (unstable, doubled) = doubled(equations, &near.unknowns)?;
            cases.see(unstable == subcritical && settles(&place, &doubled) != subcritical);
            let normal_form = period_doubling(equations, &near.unknowns)?;
            cases.see(normal_form.supercritical() != unstable);
        }
    }
    let (diagram, mut changed) = (figure_7()?, 0);
    for curve in diagram.curves.iter().filter(|curve| curve.kind == Bifurcation::PeriodDoubling) {
        let oscillator = theory()?.grazing(curve.curve.parameters()[0][1])?.model();
        let equations = LoopEquations::new(oscillator, curve.loops, Formulation::FixedPhase);
        changed += changes(&equations, &curve.curve).iter().filter(|solution| solution.admissible()).count();
        let unstable = flips(&curve.curve, 25)?.into_iter().map(|flip| Ok(doubled(&equations, &flip)?.0));
        let unstable = unstable.collect::<Result<Vec<bool>, CheckError>>()?;
        unstable.iter().for_each(|unstable| print.see(*unstable));
        // At either end at a resonance, also those of two loops at resonances of one loop.
        let points = &curve.curve.points;
        for (end, unstable) in [(0, unstable[0]), (points.len() - 1, unstable[24])] {
            let place = points[end].solution.parameters();
            let at = |found: &&FoundResonance| {
                let parameters = found.located.orbit().oscillator().parameters();
                (Vector2::from(parameters) - Vector2::from(place)).amax() < 1e-8
            };
            if let Some(found) = diagram.resonances.iter().find(at) {
                cases.see(unstable == (found.loops == 1 && found.n % 2 == 0));
            }
        }
    }
    // Farther along, criticality changes once on four of the curves.
    cases.see(changed == 4);
    let over = "points of PD curves close to the eight resonances of Figure 7, with simulated orbits; for the print all along its eight PD curves";
    Ok(cases.outcome(over).against_print(print.measure()))
}

checks! {
    /// Period-doubled solutions graze at μ = c_2GZ η² + O(η³): for p = 1 the velocity of one impact
    /// vanishes, for p ≥ 2 the last loop before an impact touches the wall before that.
    doubled_solutions_graze: orders(ANY, "μ and y where orbits with two impacts graze, towards resonances with p up to 5", |place| {
        let point = place.point();
        let (map, scale) = (point.limit_map(), point.limit_scale());
        let equations = DoubledEquations::new(place.resonance.equations());
        let (gap, [velocity, _]) = (map.grazing_gap(), map.period_doubling());
        let [_, fastest] = map.doubled_impacts(gap);
        // Located amplitudes and velocities lose digits in proportion to 1/y.
        Ok(together([(1e-14, 3.0), (1e-14, 3.0)], |size| {
            let eta = size / (scale.velocity * velocity);
            let guess = equations.near_resonance(&place.resonance, eta, gap).ok()?;
            let (grazing, visit) = equations.grazing(guess)?;
            // The last visit before an impact; for one loop, the impact itself.
            if visit != place.loops() - 1 {
                return None;
            }
            Some([
                grazing[unknown::PRIMARY] - place.grazing(eta)?.primary() - point.doubled_grazing_coefficient() * eta * eta,
                size * (grazing[unknown::VELOCITY] - scale.velocity * eta * fastest.velocity),
            ])
        }))
    });
    /// Orbits with two impacts double their period as in the limit map, to first order in η; with 4 and 8
    /// impacts they do so in turn, as simulation of the map shows half-way in between.
    cascades: {
        let (mut found, mut as_simulated, mut as_stated) = (Vec::new(), true, true);
        for (n, place) in of_figure_7()? {
            let (map, scale) = (place.point().limit_map(), place.point().limit_scale());
            let onsets = Cascade::of(&map, 4).onsets;
            as_stated &= (onsets.len() == 4) != [(1, 2), (1, 4), (3, 2)].contains(&(place.loops(), n));
            for (pair, impacts) in onsets.windows(2).zip([2, 4, 8]) {
                as_simulated &= impacts_of(&map, 0.5 * (pair[0] + pair[1])) == Some(impacts);
            }
            if onsets.len() < 2 {
                continue;
            }
            let onset = map.doubled_parameter(map.second_doubling());
            let equations = DoubledEquations::new(place.resonance.equations());
            let [velocity, _] = map.period_doubling();
            found.extend(together([(1e-14, 3.0)], |size| {
                let eta = size / (scale.velocity * velocity);
                let flip = equations.flip(&place.resonance, eta)?;
                Some([flip[unknown::PRIMARY] - place.grazing(eta)?.primary() - scale.parameter * onset * eta * eta])
            }));
        }
        if !as_stated {
            return Err("orbits with 2, 4, 8 and 16 impacts begin at other resonances than is stated".into());
        }
        if !as_simulated {
            return Err("simulated motion of the limit map does not double where it is solved for".into());
        }
        Ok(of_orders(&found, "μ where orbits with two impacts double their period, towards the resonances of Figure 7"))
    };
    /// The criterion that section 6 asks for, derived at the resonance: y² c, with the coefficient c of
    /// the normal form in terms of the impact velocity, tends to it to first order in y along the PD
    /// curve.
    criterion_at_resonance: orders(ANY, "PD curves running into resonances with p up to 5", |place| {
        let limit = place.point().limit_map().criticality();
        let curve = &place.curves()[1];
        let observed = order(|y| {
            // c loses digits in proportion to 1/y, and increases like 1/y².
            if y < 1e-4 {
                return Some((0.0, 1.0));
            }
            let near = place.on_curve(curve, y / curve.leading.impact_velocity_slope)?;
            let flip = period_doubling(place.resonance.equations(), &near.unknowns).ok()?;
            let scaled = near.unknowns[unknown::VELOCITY] / flip.direction[0];
            Some((scaled * scaled * flip.coefficient - limit, 1e-11 / y))
        });
        Ok(vec![(observed, 1.0)])
    });
}
