//! Compares shaded regions of the linear oscillator with its MPSs in closed form.

use core::f64::consts::TAU;

use grazing_continuation::curve::Window;
use grazing_model::{AnyOscillator, LinearOscillator};
use grazing_unfold::progress::Silent;
use grazing_unfold::regions::Region;
use grazing_unfold::{Diagram, Scope};

use crate::closed_form::orbits;
use crate::random::Random;

/// The result of comparing one oscillator at random points.
#[derive(Clone, Debug, Default)]
pub struct RegionComparison {
    /// The number of points with a stable, admissible MPS of some p that is shaded.
    pub shaded: usize,
    /// (p, amplitude, frequency) of points with a stable, admissible MPS where nothing is shaded or
    /// hatched.
    pub missed: Vec<(u32, [f64; 2])>,
    /// (p, amplitude, frequency) of shaded points without a stable, admissible MPS.
    pub false_shading: Vec<(u32, [f64; 2])>,
    /// The fraction of the points that is hatched, for any p.
    pub hatched: f64,
    /// The reasons why regions are hatched.
    pub doubts: Vec<String>,
}

/// The distance from a border within which points are not compared.
pub const BORDER: f64 = 0.002;

/// The distance of a point from the border of a region.
pub fn distance(region: &Region, [x, y]: [f64; 2]) -> f64 {
    let mut least = f64::INFINITY;
    for ring in &region.rings {
        for (k, a) in ring.iter().enumerate() {
            let b = ring[(k + 1) % ring.len()];
            let [u, v] = [b[0] - a[0], b[1] - a[1]];
            let along = (((x - a[0]) * u + (y - a[1]) * v) / (u * u + v * v)).clamp(0.0, 1.0);
            let along = if along.is_nan() { 0.0 } else { along };
            least = least.min(libm::hypot(a[0] + along * u - x, a[1] + along * v - y));
        }
    }
    least
}

/// The reasons why regions of a diagram are hatched.
pub fn doubts(diagram: &Diagram) -> Vec<String> {
    let doubt = |region: &Region| Some(format!("p = {}: {}", region.loops, region.doubt.as_ref()?));
    diagram.regions.iter().filter_map(doubt).collect()
}

/// The content of a diagram at a point, for p-loop solutions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// A stable, admissible solution.
    Shaded,
    /// No stable, admissible solution.
    White,
    /// An undecided region.
    Hatched,
    /// A place too close to a border.
    Border,
}

/// The content of a diagram at a point, for p-loop solutions.
pub fn shown(diagram: &Diagram, loops: u32, point: [f64; 2]) -> Shown {
    let mut of_p = diagram.regions.iter().filter(|region| region.loops == loops);
    let inside: Vec<_> = of_p.clone().filter(|region| region.contains(point)).collect();
    if inside.iter().any(|region| region.doubt.is_some()) {
        Shown::Hatched
    } else if of_p.any(|region| distance(region, point) < BORDER) {
        Shown::Border
    } else if inside.is_empty() {
        Shown::White
    } else {
        Shown::Shaded
    }
}

/// Whether a stable, admissible MPS exists at a point; `None` if the answer differs nearby, at a border.
fn exact(zeta: f64, epsilon: f64, [amplitude, omega]: [f64; 2], loops: u32) -> Option<bool> {
    let at = |a: f64, w: f64| {
        orbits(zeta, epsilon, a, w, loops).iter().any(|orbit| orbit.stable() && orbit.admissible())
    };
    let here = at(amplitude, omega);
    let around = (0..16).all(|k| {
        let (sine, cosine) = libm::sincos(f64::from(k) * TAU / 16.0);
        at(amplitude + BORDER * cosine, omega + BORDER * sine) == here
    });
    around.then_some(here)
}

/// Compares the regions of one oscillator with the closed form at random points.
pub fn compare(
    zeta: f64,
    epsilon: f64,
    window: Window,
    loops: &[u32],
    points: usize,
    random: &mut Random,
) -> RegionComparison {
    let scope = Scope { window, loops: loops.to_vec(), start: None };
    let oscillator = LinearOscillator::new(zeta, epsilon, window.primary[0], window.secondary[0])
        .unwrap_or_else(|error| panic!("zeta {zeta}, epsilon {epsilon}: {error}"));
    let mut outcome = RegionComparison::default();
    let diagram = match Diagram::compute(&AnyOscillator::new(oscillator), &scope, &Silent) {
        Ok(diagram) => diagram,
        Err(error) => {
            outcome.doubts.push(error.to_string());
            return outcome;
        }
    };
    outcome.doubts = doubts(&diagram);
    let mut hatched = 0;
    for _ in 0..points {
        let [primary, secondary] = [window.primary, window.secondary];
        let point = [random.uniform(primary[0], primary[1]), random.uniform(secondary[0], secondary[1])];
        let mut doubtful = false;
        for &p in loops {
            let shown = shown(&diagram, p, point);
            doubtful |= shown == Shown::Hatched;
            match (shown, exact(zeta, epsilon, point, p)) {
                (Shown::Shaded, Some(true)) => outcome.shaded += 1,
                (Shown::Shaded, Some(false)) => outcome.false_shading.push((p, point)),
                (Shown::White, Some(true)) => outcome.missed.push((p, point)),
                _ => {}
            }
        }
        hatched += usize::from(doubtful);
    }
    outcome.hatched = hatched as f64 / points as f64;
    outcome
}
