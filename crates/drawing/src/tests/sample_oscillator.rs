//! Artificial results for an oscillator of any kind: parameters of any name and magnitude, any number of
//! resonances.

use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo, Pair};
use grazing_results::plane::{
    CurveSource, Magnifications, MagnifiedPanel, MagnifiedPoint, OnCurve, PlaneDiagram, PlanePoint,
    RegionCorner, RegionKind, RegionVertex, SpecialPoint, StraightenedCurves, StraightenedPoint,
};
use grazing_results::{Frame, Names};

use crate::plot::axes::Heading;

/// A map of a sample's parameter: a factor, then a shift.
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
    pub(crate) names: Names,
    pub(crate) diagram: PlaneDiagram,
    pub(crate) magnifications: Magnifications,
    pub(crate) straightened: StraightenedCurves,
}

/// The secondary parameter on the artificial grazing curve at this amplitude.
fn graz(amplitude: f64) -> f64 {
    1.0 - 0.6 * amplitude * amplitude - 0.2 * amplitude
}

fn shares(count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| f64::from(i) / f64::from(count))
}

/// An artificial resonance: p, n, its amplitude on the grazing curve, and the size of its loop of curves.
type Resonance = (u32, u32, f64, f64);

/// Kind, p, n, arc and points of an artificial curve.
type SampleCurve = (Bifurcation, u32, u32, u32, Vec<(f64, f64)>);

/// The grazing curve and, at each resonance, a loop of SN, GZ and PD curves.
fn curves(resonances: &[Resonance]) -> Vec<SampleCurve> {
    let mut curves = vec![(
        Bifurcation::NonImpactingGrazing,
        0,
        0,
        0,
        shares(200).map(|s| (1.3 * s, graz(1.3 * s))).collect(),
    )];
    for (&(p, n, amplitude, size), number) in resonances.iter().zip(1..) {
        let omega = graz(amplitude);
        let arc = |from: (f64, f64), to: (f64, f64), bulge: f64| {
            let point = |s: f64| {
                let bend = bulge * s * (1.0 - s) * size;
                (from.0 + s * (to.0 - from.0) + bend, from.1 + s * (to.1 - from.1) - bend)
            };
            shares(100).map(point).collect::<Vec<_>>()
        };
        let (low, high) =
            ((amplitude - 0.4 * size, omega - 0.3 * size), (amplitude + 0.5 * size, omega + 0.6 * size));
        curves.push((Bifurcation::SaddleNode, p, n, 3 * number, arc((amplitude, omega), low, 0.2)));
        curves.push((Bifurcation::PeriodDoubling, p, n, 3 * number + 1, arc((amplitude, omega), high, -1.0)));
        curves.push((Bifurcation::Grazing, p, n, 3 * number + 2, arc(low, high, 1.0)));
    }
    curves
}

/// Rows of curves.
pub(crate) fn curve_rows(curves: Vec<SampleCurve>) -> Vec<PlanePoint> {
    let rows = |(kind, loops, n, arc, points): SampleCurve| {
        points.into_iter().map(move |(primary, secondary)| PlanePoint {
            kind,
            loops,
            wall: 0,
            n,
            at: OnCurve {
                secondary,
                primary,
                impact_velocity: 0.1,
                impact_phase: 0.0,
                trace: 0.0,
                determinant: 0.5,
                max_interior_x: -0.1,
                stable: true.into(),
                admissible: true,
                arc,
                lost: String::new(),
            },
        })
    };
    curves.into_iter().flat_map(rows).collect()
}

/// The codimension-two points at the ends of such curves.
fn point_rows(curves: &[SampleCurve]) -> Vec<SpecialPoint> {
    let ends = curves.iter().filter_map(|(kind, loops, n, _, points)| {
        let (kind, (primary, secondary)) = match kind {
            Bifurcation::SaddleNode => (CodimensionTwo::Resonance, points[0]),
            Bifurcation::PeriodDoubling => (CodimensionTwo::PeriodDoublingGrazing, points[100]),
            Bifurcation::Grazing => (CodimensionTwo::SaddleNodeGrazing, points[0]),
            _ => return None,
        };
        Some(SpecialPoint { kind, loops: *loops, wall: 0, n: *n, secondary, primary })
    });
    ends.collect()
}

/// The regions bounded by such curves; `corners` are those of the region without impacts, beside its part
/// of the grazing curve.
fn region_rows(curves: &[SampleCurve], corners: [(f64, f64); 2]) -> Vec<RegionVertex> {
    let vertex = |region, kind, loops, (primary, secondary)| {
        let (wall, n, ring, reason) = (0, 0, 0, String::new());
        RegionVertex { region, kind, loops, wall, n, at: RegionCorner { secondary, primary, ring, reason } }
    };
    let below = curves[0].4.iter().copied().chain(corners);
    let mut rows: Vec<_> = below.map(|spot| vertex(0, RegionKind::NonImpacting, 0, spot)).collect();
    for (own, number) in curves[1..].chunks(3).zip(1..) {
        let [sn, pd, gz] = own else { panic!("each resonance has three curves") };
        let outline = sn.4.iter().chain(&gz.4).chain(pd.4.iter().rev());
        rows.extend(outline.map(|&spot| vertex(number, RegionKind::Mps, sn.1, spot)));
    }
    rows
}

/// The rows of the curves in the panel of each resonance, with straight lines as approximations.
fn magnified_rows(curves: &[SampleCurve]) -> Vec<MagnifiedPoint> {
    let mut rows = Vec::new();
    for (own, panel) in curves[1..].chunks(3).zip(1..) {
        let (loops, n) = (own[0].1, own[0].2);
        for (kind, _, _, arc, points) in curves[..1].iter().chain(own) {
            let row = |source, (primary, secondary)| MagnifiedPoint {
                panel,
                loops,
                n,
                kind: *kind,
                source,
                arc: *arc,
                secondary,
                primary,
            };
            rows.extend(points.iter().map(|&spot| row(CurveSource::Continuation, spot)));
            if matches!(kind, Bifurcation::SaddleNode | Bifurcation::PeriodDoubling) {
                let straight = [points[0], points[30]].map(|q| (1.02 * q.0 - 0.02 * points[0].0, q.1));
                rows.extend(straight.map(|spot| row(CurveSource::Quadratic, spot)));
            }
        }
    }
    rows
}

/// Curves that leave the limits of the panels' resonances: an SN curve for negative η, and a PD and a GZ
/// curve for positive η.
fn straightened(panels: &[MagnifiedPanel], up: Affine) -> StraightenedCurves {
    let mut curves = Vec::new();
    let mut shown = Vec::new();
    for panel in panels {
        let Pair { saddle_node, period_doubling } = panel.coefficients;
        let limits = [saddle_node, if period_doubling.is_nan() { -saddle_node } else { period_doubling }];
        let all = [
            (Bifurcation::SaddleNode, panel.loops, -1.0, limits[0]),
            (Bifurcation::PeriodDoubling, panel.loops, 1.0, limits[1]),
            (Bifurcation::Grazing, panel.loops + 1, 1.0, 0.5 * limits[0]),
        ];
        for (arc, (kind, loops, side, limit)) in (1..).zip(all) {
            curves.extend((0..=80).map(|step| {
                let eta = side * libm::pow(10.0, 0.1 * f64::from(step) - 9.0);
                let distance = limit * (1.0 - 4.0 * eta.abs());
                let (panel, n, eta) = (panel.panel, panel.n.unwrap_or(0), eta * up.0);
                StraightenedPoint { panel, loops, n, kind, arc, eta, distance, error: 1e-11, limit }
            }));
        }
        let size = limits[0].abs().max(limits[1].abs());
        let frame = Frame { x: [-1.4 * size, 1.4 * size], y: [-0.1 * up.0, 0.1 * up.0] };
        shown.push(MagnifiedPanel { frame, ..*panel });
    }
    StraightenedCurves { curves, panels: shown }
}

/// A number of resonances along the grazing curve, with recurring p from 1 to 12.
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
                let frame = Frame { x: across.range(x), y: up.range(y) };
                let curvature = across.0 / (up.0 * up.0);
                let period_doubling = if panel == 2 { f64::NAN } else { 12.153 * curvature };
                let coefficients = Pair { saddle_node: -282.437 * curvature, period_doubling };
                MagnifiedPanel { panel, frame, loops: p, wall: 0, n: Some(n), coefficients }
            })
            .collect();
        let (points, regions) = (point_rows(&all), region_rows(&all, corners));
        let magnifications = Magnifications {
            curves: magnified_rows(&all),
            points: points.clone(),
            regions: regions.clone(),
            panels: panels.clone(),
        };
        let diagram = PlaneDiagram {
            curves: curve_rows(all),
            points,
            regions,
            frame: Frame { x: across.range([0.0, 1.2]), y: up.range([0.3, 1.0]) },
            magnified: panels,
            sections: Vec::new(),
            own: Vec::new(),
            measured: Vec::new(),
            several: Vec::new(),
            at_both_walls: Vec::new(),
        };
        let straightened = straightened(&diagram.magnified, up);
        SampleOscillator { names: Names::new(names[0], names[1]), diagram, magnifications, straightened }
    }

    /// The heading of the diagram.
    pub(crate) fn heading(&self) -> Heading<'_> {
        Heading {
            name: "diagram",
            title: "Two-parameter bifurcation diagram",
            description: "A made-up oscillator.",
            names: &self.names,
            tables: &["points", "curves"],
        }
    }

    /// The heading of the magnifications.
    pub(crate) fn magnified(&self) -> Heading<'_> {
        let tables = &["magnified_curves"];
        Heading { name: "magnifications", title: "Magnifications", tables, ..self.heading() }
    }
}

/// The identity map of a parameter.
pub(crate) const UNIT: Affine = Affine(1.0, 0.0);

/// An oscillator like that of the paper with `count` resonances.
pub(crate) fn sample(count: u32) -> SampleOscillator {
    SampleOscillator::new(["A", "omega"], UNIT, UNIT, count)
}

/// Oscillators of different names, magnitudes and numbers of resonances.
pub(crate) fn oscillators() -> Vec<SampleOscillator> {
    vec![
        sample(1),
        SampleOscillator::new(["F_0", "omega_2"], Affine(1e-9, 0.0), Affine(2.0e6, 1.0e5), 5),
        SampleOscillator::new(["forcing_amplitude", "kappa"], Affine(1e-3, 0.3), Affine(1e-4, 12.5), 8),
        SampleOscillator::new(["x0", "stiffness_ratio"], Affine(30.0, -20.0), Affine(0.01, 0.0), 20),
        SampleOscillator::new(["gamma", "Omega"], Affine(1e-7, 4321.0), Affine(1e-6, -77.0), 2),
        SampleOscillator::new(["A", "eta"], Affine(4e4, 0.0), UNIT, 4),
    ]
}
