//! Made-up results for an oscillator of any kind: parameters of any name and magnitude, any number of resonances.

use grazing_results::plane::{CurvePoint, MagnifiedPoint, RegionVertex, SpecialPoint};

use crate::captions::Heading;
use crate::clip::Window;
use crate::diagram::{Diagram, Section};
use crate::magnifications::{Magnifications, MagnifiedPanel};
use crate::magnified::Magnified;
use crate::plane::Plane;
use crate::samples::{Resonance, curve_rows, curves, graz, magnified_rows, point_rows, region_rows};

/// Where a parameter of the samples goes: multiplied, then shifted.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Affine(pub(crate) f64, pub(crate) f64);

impl Affine {
    fn at(self, value: f64) -> f64 {
        self.1 + self.0 * value
    }

    fn range(self, [low, high]: [f64; 2]) -> [f64; 2] {
        [self.at(low), self.at(high)]
    }
}

pub(crate) struct SampleOscillator {
    pub(crate) plane: Plane,
    pub(crate) curves: Vec<CurvePoint>,
    pub(crate) points: Vec<SpecialPoint>,
    pub(crate) regions: Vec<RegionVertex>,
    pub(crate) magnified_curves: Vec<MagnifiedPoint>,
    pub(crate) window: Window,
    pub(crate) panels: Vec<MagnifiedPanel>,
    pub(crate) magnified: Vec<Magnified>,
    pub(crate) sections: Vec<Section>,
}

/// So many resonances along the grazing curve, with p of 1 to 12 that recur.
fn resonances(count: u32) -> Vec<Resonance> {
    let share = |i: u32| (f64::from(i) + 0.5) / f64::from(count);
    let one = |i: u32| (1 + (i * 5) % 12, 1 + i / 3, 0.95 - 0.87 * share(i), 0.7 / f64::from(count + 2));
    (0..count).map(one).collect()
}

impl SampleOscillator {
    pub(crate) fn new(names: [&str; 2], across: Affine, up: Affine, count: u32) -> Self {
        let resonances = resonances(count);
        let mut all = curves(&resonances);
        for (.., points) in &mut all {
            points.iter_mut().for_each(|point| *point = (across.at(point.0), up.at(point.1)));
        }
        let corners = [graz(1.3), 1.0].map(|omega| (across.at(-0.1), up.at(omega)));
        let panels: Vec<MagnifiedPanel> = resonances
            .iter()
            .zip(1..)
            .map(|(&(p, n, a, size), panel)| {
                let (x, y) = ([a - 0.3 * size, a + 0.4 * size], [-0.2, 0.25].map(|d| graz(a) + d * size));
                let window = Window { x: across.range(x), y: up.range(y) };
                let curvature = across.0 / (up.0 * up.0);
                let heading = Heading {
                    p,
                    n: Some(n),
                    c_sn: -282.437 * curvature,
                    c_pd: if panel == 2 { f64::NAN } else { 12.153 * curvature },
                };
                MagnifiedPanel { shown: Magnified { panel, window }, heading: Some(heading) }
            })
            .collect();
        SampleOscillator {
            plane: Plane::of_parameters(names[0], names[1]),
            points: point_rows(&all),
            regions: region_rows(&all, corners),
            magnified_curves: magnified_rows(&all),
            curves: curve_rows(all),
            window: Window { x: across.range([0.0, 1.2]), y: up.range([0.3, 1.0]) },
            magnified: panels.iter().map(|panel| panel.shown).collect(),
            panels,
            sections: Vec::new(),
        }
    }

    pub(crate) fn diagram(&self) -> Diagram<'_> {
        Diagram {
            name: "diagram",
            title: "Two-parameter bifurcation diagram",
            description: "A made-up oscillator.",
            plane: &self.plane,
            tables: ["points", "curves"],
            curves: &self.curves,
            points: &self.points,
            regions: &self.regions,
            window: self.window,
            magnified: &self.magnified,
            sections: &self.sections,
        }
    }

    pub(crate) fn magnifications(&self) -> Magnifications<'_> {
        Magnifications {
            name: "magnifications",
            title: "Magnifications",
            description: "A made-up oscillator.",
            plane: &self.plane,
            table: "magnified_curves",
            curves: &self.magnified_curves,
            points: &self.points,
            regions: &self.regions,
            panels: &self.panels,
        }
    }
}

/// Oscillators of different names, magnitudes and numbers of resonances.
pub(crate) fn oscillators() -> Vec<SampleOscillator> {
    let unit = Affine(1.0, 0.0);
    vec![
        SampleOscillator::new(["A", "omega"], unit, unit, 1),
        SampleOscillator::new(["F_0", "omega_2"], Affine(1e-9, 0.0), Affine(2.0e6, 1.0e5), 5),
        SampleOscillator::new(["forcing_amplitude", "kappa"], Affine(1e-3, 0.3), Affine(1e-4, 12.5), 8),
        SampleOscillator::new(["x0", "stiffness_ratio"], Affine(30.0, -20.0), Affine(0.01, 0.0), 20),
        SampleOscillator::new(["gamma", "Omega"], Affine(1e-7, 4321.0), Affine(1e-6, -77.0), 2),
        SampleOscillator::new(["A", "eta"], Affine(4e4, 0.0), unit, 4),
    ]
}
