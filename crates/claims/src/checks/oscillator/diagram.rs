//! Section 3.2: the two-parameter diagram, Figure 7.

use std::sync::LazyLock;

use crate::*;
use grazing_continuation::bifurcation::Bifurcation;
use grazing_model::AnyOscillator;
use grazing_theorems::LinearOscillator;
use grazing_unfold::diagram::DiagramCurve;
use grazing_unfold::progress::Silent;
use grazing_unfold::regions::Region;
use grazing_unfold::{Diagram, Scope};
use serde::Deserialize;

/// The window and the numbers of loops of Figure 7. The paper prints the figure without its numbers; they
/// stand in figures/parameters.toml.
#[derive(Deserialize)]
pub(crate) struct Figure7Window {
    amplitude: [f64; 2],
    pub(crate) frequency: [f64; 2],
    pub(crate) loops: Vec<u32>,
}

impl Figure7Window {
    pub(crate) fn read() -> Result<Self, CheckError> {
        #[derive(Deserialize)]
        struct File {
            fig07: Figure7Window,
        }
        let File { fig07 } = toml::from_str(include_str!("../../../../../figures/parameters.toml"))?;
        Ok(fig07)
    }

    fn window(&self) -> Window {
        Window { primary: self.amplitude, secondary: self.frequency }
    }
}

/// The linear oscillator of the paper's figures.
pub(crate) fn theory() -> Result<LinearOscillator, CheckError> {
    Ok(LinearOscillator::new(printed("zeta"), printed("epsilon"))?)
}

/// The diagram of Figure 7, computed once.
pub(crate) fn figure_7() -> Result<&'static Diagram, CheckError> {
    static DIAGRAM: LazyLock<Result<Diagram, String>> =
        LazyLock::new(|| computed().map_err(|failure| failure.to_string()));
    Ok(DIAGRAM.as_ref().map_err(String::as_str)?)
}

fn computed() -> Result<Diagram, CheckError> {
    let figure = Figure7Window::read()?;
    let grazing = theory()?.grazing(figure.frequency[0])?;
    let scope = Scope { window: figure.window(), loops: figure.loops, start: None };
    let diagram = || Diagram::compute(&AnyOscillator::new(grazing.model()), &scope, &Silent);
    // In threads of its own: a thread of the pool that waits for parts of the diagram takes up other
    // checks, and these may wait for the diagram.
    let pool = rayon::ThreadPoolBuilder::new().build()?;
    let apart = std::thread::scope(|scope| scope.spawn(|| pool.install(diagram)).join());
    Ok(apart.map_err(|_| "the diagram of Figure 7 could not be computed")??)
}

/// Ends of curves and vertices of regions closer than this fraction of the ranges are the same.
const SAME: f64 = 1e-7;
/// Vertices that two curves have in common lie on both, and deviate by less than this fraction of the
/// ranges from the chords of either: 1.7 · 10⁻⁴ was seen.
const DRAWN: f64 = 5e-4;

/// The distance of two points in fractions of the ranges.
fn gap(window: Window, a: [f64; 2], b: [f64; 2]) -> f64 {
    let [a, b] = [a, b].map(|point| Vector2::from(window.shares(point)));
    (a - b).amax()
}

/// The distance of a point from a chord in fractions of the ranges.
fn aside(window: Window, at: [f64; 2], chord: &[[f64; 2]]) -> f64 {
    let [at, from, to] = [at, chord[0], chord[1]].map(|point| Vector2::from(window.shares(point)));
    let along = ((at - from).dot(&(to - from)) / (to - from).norm_squared()).clamp(0.0, 1.0);
    (from + (to - from) * if along.is_nan() { 0.0 } else { along } - at).norm()
}

/// Whether a point (μ, η) is a vertex of a region.
pub(crate) fn is_vertex(diagram: &Diagram, region: &Region, at: [f64; 2]) -> bool {
    region.rings.iter().flatten().any(|vertex| gap(diagram.scope.window, *vertex, at) < SAME)
}

/// The curves on the border of a region, each with its points there.
fn border<'a>(diagram: &'a Diagram, region: &Region) -> Vec<(&'a DiagramCurve, Vec<Unknowns>)> {
    let own = diagram.curves.iter().filter(|curve| curve.loops == region.loops);
    let shared = own.map(|curve| {
        let points = &curve.curve.points;
        let inner = points[1..points.len() - 1].iter().map(|point| &point.solution);
        let shared = inner.filter(|solution| is_vertex(diagram, region, solution.parameters()));
        (curve, shared.map(|solution| solution.unknowns.clone()).collect::<Vec<_>>())
    });
    shared.filter(|(_, points)| !points.is_empty()).collect()
}

/// Crosses a curve in the middle of the border: across SN and PD the MPS is stable on one side alone, also
/// in simulation, and across GZ it is admissible on one side alone.
fn crossed(
    diagram: &Diagram,
    (curve, points): &(&DiagramCurve, Vec<Unknowns>),
    cases: &mut Votes,
) -> Result<(), CheckError> {
    let middle = points[points.len() / 2].clone();
    let equations = diagram.equations(curve.loops);
    let beside = |factor: f64| {
        let point = at_velocity(&equations, &middle, factor * middle[unknown::VELOCITY])?;
        Some(equations.solution(&point))
    };
    let (lower, upper) = beside(0.98).zip(beside(1.02)).ok_or("no MPS beside the curve")?;
    if curve.kind == Bifurcation::Grazing {
        cases.see(points.iter().all(|point| equations.solution(point).ceiling().abs() < 1e-11));
        cases.see(lower.admissible() != upper.admissible());
        return Ok(());
    }
    cases.see(lower.stable() != upper.stable());
    for solution in [lower, upper].into_iter().filter(PeriodicSolution::admissible) {
        cases.see((attracts(&equations, &solution.unknowns) == Some(true)) == solution.stable());
    }
    Ok(())
}

/// The borders of the regions of Figure 7: SN, PD and GZ curves and nothing else; all three, except for
/// solutions of two loops that leave a resonance of one loop, which have SN and GZ if n is odd, and PD and
/// GZ if it is even.
pub(crate) fn boundaries() -> CheckResult {
    let diagram = figure_7()?;
    let window = diagram.scope.window;
    let (mut cases, mut printed) = (Votes::default(), Votes::default());
    for region in diagram.regions.iter().filter(|region| region.loops > 0) {
        cases.see(region.doubt.is_none());
        let border = border(diagram, region);
        let kinds = [Bifurcation::SaddleNode, Bifurcation::PeriodDoubling, Bifurcation::Grazing];
        cases.see(border.iter().all(|(curve, _)| kinds.contains(&curve.kind)));
        let on_edge = |at: [f64; 2]| window.shares(at).iter().any(|share| share.min(1.0 - share) < SAME);
        let on_curve = |at: [f64; 2]| {
            let mut chords = border.iter().map(|(curve, _)| curve.curve.parameters());
            chords.any(|points| points.windows(2).any(|chord| aside(window, at, chord) < DRAWN))
        };
        cases.see(region.rings.iter().flatten().all(|at| on_edge(*at) || on_curve(*at)));
        for shared in &border {
            crossed(diagram, shared, &mut cases)?;
        }
        let leaves = |loops: u32| {
            let mut places = diagram.resonances.iter().filter(move |found| found.loops == loops);
            places.find(|found| is_vertex(diagram, region, found.located.orbit().oscillator().parameters()))
        };
        let stated = match leaves(region.loops).or_else(|| leaves(1)) {
            Some(found) if found.loops != region.loops => [found.n % 2 == 1, found.n % 2 == 0, true],
            _ => [true; 3],
        };
        let seen = kinds.map(|kind| border.iter().any(|(curve, _)| curve.kind == kind));
        // What the edge of the window cuts off cannot be seen.
        if seen != stated && region.rings.iter().flatten().any(|at| on_edge(*at)) {
            cases.silent();
            continue;
        }
        cases.see(seen == stated);
        printed.see(seen == [true; 3]);
    }
    let over = "regions of stable MPSs of Figure 7: their borders, crossed in simulation";
    Ok(cases.outcome(over).against_print(printed.measure()))
}

checks! {
    /// To the left of the grazing curve simulated orbits approach φ_p; to the right φ_p is not a
    /// solution.
    non_impacting_region: drawn(151, 60) |sampler; cases: Votes| {
        let theory = theory()?;
        let [lowest, highest] = Figure7Window::read()?.frequency;
        let omega = sampler.between(lowest, highest);
        let grazing = theory.grazing(omega)?;
        let share = sampler.between(0.1, 0.999);
        let oscillator = grazing.model().with_parameters([share * grazing.amplitude(), omega]);
        let phase = sampler.between(0.0, TAU);
        let start = oscillator.non_impacting_solution(phase);
        // The displacement is up to a tenth of the distance to the wall, in a norm that never grows.
        let off = 0.1 * (1.0 - share) * sampler.between(-1.0, 1.0);
        let from = State { position: start.position + off, ..start };
        let periods = libm::ceil(5.0 / theory.damping_ratio() / oscillator.forcing_period());
        let end = Orbit::new(&oscillator, from, periods * oscillator.forcing_period(), 5).finish();
        cases.see(match end {
            OrbitEnd::TimeIsUp(end) => {
                libm::hypot(end.position - start.position, end.velocity - start.velocity) < 0.05 * off.abs()
            }
            _ => false,
        });
        let beyond = oscillator.with_parameters([grazing.amplitude() / share, omega]);
        cases.see(beyond.non_impacting_solution(grazing.phase()).position > 0.0);
    } => cases.outcome("points left and right of the grazing curve, simulated");
}
