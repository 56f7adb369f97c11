//! Each curve, point and region of Figure 7, with the proved statement about it.

use grazing_results::plane::{OnCurve, PlanePoint, RegionVertex, SpecialPoint};
use grazing_unfold::plane;

use super::*;

/// The greatest error that rounding in the continuation may add to a drawn number.
const ROUNDING: f64 = 2e-9;

/// The proved rows, for lookup by frequency.
struct Lookup<'a> {
    statement: &'a Statement,
    rows: &'a [CertificateRow],
}

impl Lookup<'_> {
    fn nu(&self, omega: f64) -> Ball {
        self.statement.oscillator.omega_1_over(Ball::from(omega))
    }

    /// The amplitude at which motion begins, the two sides of the tube in which it ends, and the width of
    /// the tube, which is 0 in the box of a point.
    fn ends(&self, p: u32, omega: f64) -> Option<[f64; 4]> {
        let nu = self.nu(omega);
        let row = summary::row_at(self.rows, p.into(), nu)?;
        let (begins, lower, upper) = ends(self.statement, row, nu)?;
        let [begins, lower] = [begins, lower].map(Ball::to_f64);
        let upper = upper.map_or(f64::INFINITY, Ball::to_f64);
        let in_box = matches!(row.verdict, IntervalVerdict::Point("SN-GZ" | "PD-GZ")) || upper.is_infinite();
        Some([begins, lower, upper, if in_box { 0.0 } else { upper - lower }])
    }

    /// The amplitude of a curve with a closed form; nothing for a GZ curve.
    fn closed_form(&self, kind: Bifurcation, p: u32, omega: f64) -> Option<f64> {
        let family = self.statement.oscillator.family(p.max(1).into(), self.nu(omega));
        let velocity = match kind {
            Bifurcation::NonImpactingGrazing => Ball::ZERO,
            Bifurcation::SaddleNode => family.velocity_at(1),
            Bifurcation::PeriodDoubling => family.velocity_at(-1),
            _ => return None,
        };
        Some(self.statement.oscillator.amplitude_square(&family.motion(velocity)).sqrt().to_f64())
    }
}

/// The items for each curve, point and region of Figure 7.
pub(super) fn items(
    study: &Study,
    statement: &Statement,
    rows: &[CertificateRow],
) -> Result<Vec<ProofItem>, StudyError> {
    let diagram = study.diagram()?;
    let (curves, points) = (plane::curves(diagram), plane::points(diagram));
    let (regions, look) = (plane::regions(&diagram.regions), Lookup { statement, rows });
    let curves = curves.chunk_by(|a, b| a.at.arc == b.at.arc).map(|curve| of_curve(&look, curve));
    let points = (1..).zip(&points).map(|(number, point)| {
        let (from, to, amplitude, statement) = of_point(statement, rows, point);
        let within = (point.secondary - 0.5 * (from + to)).abs() <= 0.5 * (to - from) + ROUNDING
            && (point.primary - amplitude.to_f64()).abs() <= amplitude.radius() + ROUNDING;
        let SpecialPoint { kind, loops, n, .. } = *point;
        let (kind, width) = (kind.name().to_owned(), 2.0 * amplitude.radius());
        let (within, amplitude) = (u32::from(within), amplitude.to_f64());
        ProofItem {
            object: "point",
            kind,
            loops,
            n,
            number,
            from,
            to,
            amplitude,
            width,
            drawn: 1,
            within,
            statement,
        }
    });
    let regions = regions.chunk_by(|a, b| a.region == b.region);
    let regions = regions.map(|region| of_region(&look, region, diagram.scope.window));
    Ok(curves.chain(points).chain(regions).collect())
}

fn of_curve(look: &Lookup<'_>, curve: &[PlanePoint]) -> ProofItem {
    let PlanePoint { kind, loops, n, at: OnCurve { arc, .. }, .. } = curve[0];
    let (mut within, mut width) = (0, 0.0_f64);
    for point in curve {
        let holds = match look.closed_form(kind, loops, point.at.secondary) {
            Some(amplitude) => (amplitude - point.at.primary).abs() < ROUNDING,
            None => look.ends(loops, point.at.secondary).is_some_and(|[_, lower, upper, wide]| {
                width = width.max(wide);
                lower - ROUNDING <= point.at.primary && point.at.primary <= upper + ROUNDING
            }),
        };
        within += u32::from(holds);
    }
    let [from, to] = span(curve.iter().map(|point| point.at.secondary));
    let statement = match kind {
        Bifurcation::NonImpactingGrazing => {
            "closed form at every omega: motion without impacts, always stable, is admissible just up to it"
                .to_owned()
        }
        Bifurcation::Grazing => format!(
            "where it bounds stable {loops}-loop MPSs it is in a tube of this width at every omega; it is not said of the rest"
        ),
        _ => {
            let multiplier = if kind == Bifurcation::SaddleNode { 1 } else { -1 };
            format!(
                "closed form at every omega: on it, and nowhere else, a {loops}-loop solution with one impact has the multiplier {multiplier}"
            )
        }
    };
    let drawn = curve.len() as u32;
    ProofItem {
        object: "curve",
        kind: kind.name().to_owned(),
        loops,
        n,
        number: arc,
        from,
        to,
        amplitude: f64::NAN,
        width,
        drawn,
        within,
        statement,
    }
}

/// The range of frequencies in which a point is proved to lie, a range of amplitudes, and the statement.
fn of_point(
    statement: &Statement,
    rows: &[CertificateRow],
    point: &SpecialPoint,
) -> (f64, f64, Ball, String) {
    let nothing = (f64::NAN, f64::NAN, Ball::ANY, "nothing".to_owned());
    let window = statement.frequency.map(Decimal::ball);
    let resonances = EnclosedResonance::in_window(&statement.oscillator, &[point.loops], window);
    if let Some(found) =
        resonances.iter().find(|found| point.kind.name() == "resonance" && found.n == point.n)
    {
        let [omega, amplitude, ..] = found.numbers;
        let (omega, radius) = (omega.to_f64(), omega.radius());
        return (omega - radius, omega + radius, amplitude, summary::resonance(found).join("; "));
    }
    let found = summary::points(statement, rows).find_map(|(name, row)| {
        let [low, high] = summary::frequencies(statement, slice::from_ref(row)).map(Ball::to_f64);
        let here = low - ROUNDING <= point.secondary && point.secondary <= high + ROUNDING;
        let found = here && name == point.kind.name() && row.interval.p == i64::from(point.loops);
        found.then(|| (low, high, summary::amplitudes(statement, row)))
    });
    found.map_or(nothing, |(low, high, amplitudes)| {
        (low, high, amplitudes, "exactly one such point in this interval, none beside it".to_owned())
    })
}

fn of_region(
    look: &Lookup<'_>,
    region: &[RegionVertex],
    window: grazing_continuation::curve::Window,
) -> ProofItem {
    let RegionVertex { region: number, kind, loops, n, .. } = region[0];
    let [from, to] = span(region.iter().map(|vertex| vertex.at.secondary));
    let (mut within, mut width) = (0, 0.0_f64);
    for vertex in region {
        let (omega, amplitude) = (vertex.at.secondary, vertex.at.primary);
        let edge = window.secondary.contains(&omega) || window.primary.contains(&amplitude);
        let ends = if loops == 0 {
            let grazing = look.closed_form(Bifurcation::NonImpactingGrazing, 0, omega);
            grazing.map(|grazing| [0.0, grazing, grazing, 0.0])
        } else {
            look.ends(loops, omega)
        };
        let holds = ends.is_some_and(|[begins, lower, upper, wide]| {
            width = width.max(wide);
            let near = amplitude >= lower - ROUNDING || (amplitude - begins).abs() < ROUNDING;
            amplitude <= upper + ROUNDING && (near || (edge && amplitude >= begins))
        });
        within += u32::from(holds);
    }
    let open = look.rows.iter().any(|row| {
        let [low, high] = summary::frequencies(look.statement, slice::from_ref(row)).map(Ball::to_f64);
        let beside = high <= from || to <= low;
        matches!(row.verdict, IntervalVerdict::Undecided(_) | IntervalVerdict::Thin)
            && row.interval.p == i64::from(loops)
            && !beside
    });
    let statement = match (loops, open) {
        (0, _) => {
            "motion without impacts is stable, and admissible just below the grazing curve, a closed form"
                .to_owned()
        }
        (_, false) => format!(
            "at every omega one stable admissible {loops}-loop MPS at each amplitude inside, none at others: its edge is in tubes of this width, and in the boxes of its corners"
        ),
        (_, true) => format!("the same of {loops}-loop MPSs, but a part of these frequencies is undecided"),
    };
    let drawn = region.len() as u32;
    let kind = kind.name().to_owned();
    ProofItem {
        object: "region",
        kind,
        loops,
        n,
        number,
        from,
        to,
        amplitude: f64::NAN,
        width,
        drawn,
        within,
        statement,
    }
}
