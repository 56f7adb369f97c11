//! Beyond the paper: proofs for each curve, point and region of Figure 7.

mod ink;
mod items;

use core::slice;

use grazing_certify::ball::Ball;
use grazing_certify::prove;
use grazing_certify::resonance::EnclosedResonance;
use grazing_certify::row::{CertificateRow, IntervalVerdict};
use grazing_certify::statement::{Decimal, Statement};
use grazing_certify::summary::{self, ends, sentence, stretches};
use grazing_continuation::bifurcation::{Bifurcation, CodimensionTwo};
use grazing_input::kind::count;
use grazing_reproduction::figures::fig07::Figure7;
use grazing_reproduction::prelude::*;
use grazing_results::{Frame, rows, span, tables, words};

/// The number of frequencies at which the grazing curve, a closed form, is shown.
const SAMPLES: u32 = 200;
/// The extent of a panel from its middle, in units of that of the box of its point and the tubes at the
/// box.
const REACH: f64 = 2.0;

keys! {
    /// The proofs for Figure 7.
    pub struct BeyondProofs {
        /// How many points are magnified.
        panels: u32 = count(0..=3), "the number of points that are magnified must be from {} to {}";
    }
}

words! {
    /// A part of a magnification.
    ProofPart {
        /// The tube that contains the GZ curve.
        Tube = "tube",
        /// The box that contains exactly one point.
        Box = "box",
    }
}

rows! {
    /// An object of Figure 7, and the proved statement about it.
    ProofItem {
        object: &'static str = PROOF_OBJECT,
        kind: String = PROOF_KIND,
        loops: u32 = LOOPS,
        n: u32 = RESONANCE_INDEX,
        number: u32 = PROOF_NUMBER,
        from: f64 = PROOF_FROM,
        to: f64 = PROOF_TO,
        amplitude: f64 = PROOF_AMPLITUDE,
        width: f64 = PROOF_WIDTH,
        drawn: u32 = PROOF_DRAWN,
        within: u32 = PROOF_WITHIN,
        statement: String = PROOF_STATEMENT,
    }

    /// The amplitudes at which stable admissible motion is proved to begin and to end, at one frequency.
    ProofEnds {
        loops: u32 = LOOPS,
        arc: u32 = ARC,
        omega: f64 = SECONDARY,
        at: Bifurcation = PROOF_BEGINS_AT,
        begins: f64 = PROOF_BEGINS,
        lower: f64 = PROOF_LOWER,
        upper: f64 = PROOF_UPPER,
        log_width: f64 = PROOF_LOG_WIDTH,
    }

    /// The proved ends of motion near a point, magnified.
    ProofMagnified {
        panel: u32 = PANEL,
        kind: CodimensionTwo = CODIMENSION_TWO,
        loops: u32 = LOOPS,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        part: ProofPart = PROOF_PART,
        arc: u32 = ARC,
        omega: f64 = PROOF_SECONDARY_OFFSET,
        begins: f64 = PROOF_BEGINS_OFFSET,
        lower: f64 = PROOF_LOWER_OFFSET,
        upper: f64 = PROOF_UPPER_OFFSET,
    }
}

tables! {
    /// The proofs for Figure 7.
    Proofs {
        /// Of each curve, point and region.
        items: ProofItem = "beyond_proofs", "a curve, point or region of Figure 7",
        /// Over the window.
        ends: ProofEnds = "beyond_proofs_ends", "an interval of frequencies, represented by its midpoint",
        /// About points.
        magnified: ProofMagnified = "beyond_proofs_magnified", "an endpoint of an interval of frequencies near a point",
        ;
        /// The window of Figure 7.
        frame: Frame,
        /// Sentences about undecided parts.
        undecided: Vec<String>,
    }
}

impl FileSection for BeyondProofs {
    const NAME: &'static str = "beyond_proofs";
    const REQUIREMENT: &'static str = "the table [beyond_proofs] says how many points are magnified";
}

impl StudyFigure for BeyondProofs {
    const LABEL: &'static str = "fig:proofs";
    const TITLE: Title<&'static str> = Title::beyond("what is proved about Figure~7");
    const TABLES: &'static [TablePlan] = Proofs::TABLES;
    const REMEDY: &'static str = "oscillator.zeta or oscillator.epsilon";
    type Shown = Proofs;

    fn compute(&self, study: &Study) -> Result<Proofs, StudyError> {
        let figure: Figure7 = study.parameters.section()?;
        let statement = statement(&study.parameters)?;
        let (progress, what) = (&study.progress, "proofs over the window");
        let rows = prove(
            &statement,
            |parts| progress.begin(what, parts),
            || progress.step(what),
            || progress.stopped(),
        );
        progress.end(what);
        let window = figure.window();
        let undecided =
            stretches(&rows).filter(|rows| matches!(rows[0].verdict, IntervalVerdict::Undecided(_)));
        Ok(Proofs {
            items: items::items(study, &statement, &rows)?,
            ends: all_ends(&statement, &rows, window.secondary),
            magnified: magnified(&statement, &rows, self.panels),
            frame: window.into(),
            undecided: undecided.map(|rows| sentence(&statement, rows)).collect(),
        })
    }

    fn draw(shown: &Proofs, width: SheetWidth) -> Result<Sheet, DrawingError> {
        ink::draw(shown, width)
    }

    fn remarks(&self, _: &Study, shown: &Proofs) -> Result<Remarks, StudyError> {
        Ok(Remarks { notes: shown.undecided.clone(), gaps: Vec::new() })
    }

    fn constants(study: &Study) -> Result<Vec<(&'static str, f64)>, ParameterError> {
        study.oscillator_constants()
    }
}

/// The statement to be proved: Figure 7's window and the constants, as decimal numbers.
///
/// # Errors
/// A section is invalid, one of the numbers has too many digits, or balls cannot represent the constants.
pub fn statement(parameters: &Parameters) -> Result<Statement, StudyError> {
    let (figure, oscillator) = (parameters.section::<Figure7>()?, parameters.oscillator()?);
    let decimal = |key: &str, x: f64| {
        Decimal::new(x)
            .ok_or_else(|| StudyError::Failed(format!("{key} = {x}: a proof needs at most 18 digits")))
    };
    let window = figure.window();
    let ([lowest, highest], [low, high]) = (window.secondary, window.primary);
    let least = 100.0 * Statement::width().to_f64();
    if high - low < least {
        let what = format!(
            "fig07.amplitude = [{low}, {high}]: a proof needs a range of {least} at least, a hundred times the width of its tubes"
        );
        return Err(StudyError::Failed(what));
    }
    Statement::new(
        [
            decimal("oscillator.zeta", oscillator.damping_ratio())?,
            decimal("oscillator.epsilon", oscillator.coefficient_of_restitution())?,
        ],
        [decimal("fig07.frequency", lowest)?, decimal("fig07.frequency", highest)?],
        [decimal("fig07.amplitude", low)?, decimal("fig07.amplitude", high)?],
        figure.loops,
    )
    .ok_or_else(|| {
        let what = "oscillator.zeta must be large enough for integers of 128 bits, and below 1, oscillator.epsilon at most 1";
        StudyError::Failed(what.to_owned())
    })
}

/// The runs of consecutive rows with stable admissible motion.
fn runs(rows: &[CertificateRow]) -> impl Iterator<Item = &[CertificateRow]> {
    let moves = |row: &CertificateRow| {
        matches!(row.verdict, IntervalVerdict::Stable | IntervalVerdict::Point("GZ-GZ" | "GZ-PD"))
    };
    let together =
        move |a: &CertificateRow, b: &CertificateRow| a.interval.p == b.interval.p && moves(a) && moves(b);
    rows.chunk_by(together).filter(move |run| moves(&run[0]))
}

/// The kind of curve at which stable motion begins.
fn begins_at(statement: &Statement, p: i64, nu: Ball) -> Bifurcation {
    let saddle_node = statement.oscillator.family(p, nu).b.to_f64() > 0.0;
    if saddle_node { Bifurcation::SaddleNode } else { Bifurcation::PeriodDoubling }
}

/// The amplitudes at which motion begins and ends, at the middle of each interval and at the ends of each
/// run.
fn all_ends(statement: &Statement, rows: &[CertificateRow], [lowest, highest]: [f64; 2]) -> Vec<ProofEnds> {
    let mut all: Vec<ProofEnds> = (0..=SAMPLES)
        .map(|k| {
            let omega = lowest + f64::from(k) / f64::from(SAMPLES) * (highest - lowest);
            let nu = statement.oscillator.omega_1_over(Ball::from(omega));
            let begins = statement.oscillator.grazing_square(nu).sqrt().to_f64();
            let (at, log_width) = (Bifurcation::NonImpactingGrazing, f64::NAN);
            ProofEnds { loops: 0, arc: 0, omega, at, begins, lower: begins, upper: begins, log_width }
        })
        .collect();
    for (arc, run) in (1..).zip(runs(rows)) {
        let (first, last, p) = (&run[0], &run[run.len() - 1], run[0].interval.p);
        let places = run.iter().map(|row| (row, row.interval.middle()));
        let places = [(first, first.interval.ends()[0])]
            .into_iter()
            .chain(places)
            .chain([(last, last.interval.ends()[1])]);
        all.extend(places.filter_map(|(row, nu)| {
            let (begins, lower, upper) = ends(statement, row, nu)?;
            let [begins, lower] = [begins, lower].map(Ball::to_f64);
            let upper = upper.map_or(f64::NAN, Ball::to_f64);
            let omega = statement.oscillator.omega_1_over(nu).to_f64();
            let at = begins_at(statement, p, nu);
            let log_width = libm::log10(upper - lower);
            Some(ProofEnds { loops: p as u32, arc, omega, at, begins, lower, upper, log_width })
        }));
    }
    all
}

/// The tubes near the first point of each kind, and the box of the point.
fn magnified(statement: &Statement, rows: &[CertificateRow], panels: u32) -> Vec<ProofMagnified> {
    use CodimensionTwo::{GrazingGrazing, PeriodDoublingGrazing, SaddleNodeGrazing};
    let of = |kind: CodimensionTwo| {
        let mut points = summary::points(statement, rows);
        points.find_map(|(name, point)| (name == kind.name()).then_some((kind, point)))
    };
    let kinds = [SaddleNodeGrazing, PeriodDoublingGrazing, GrazingGrazing].into_iter().filter_map(of);
    let mut all = Vec::new();
    for (panel, (kind, point)) in (1..=panels).zip(kinds) {
        let (p, amplitudes) = (point.interval.p, summary::amplitudes(statement, point));
        let [low, high] = summary::frequencies(statement, slice::from_ref(point)).map(Ball::to_f64);
        let (secondary, primary) = (0.5 * (low + high), amplitudes.to_f64());
        let offset = |amplitude: f64| (amplitude - primary) * 1e6;
        let row = |part, arc, omega: f64, [begins, lower, upper]: [f64; 3]| ProofMagnified {
            panel,
            kind,
            loops: p as u32,
            secondary,
            primary,
            part,
            arc,
            omega: (omega - secondary) * 1e9,
            begins: offset(begins),
            lower: offset(lower),
            upper: offset(upper),
        };
        let radius = amplitudes.radius();
        let sides = [f64::NAN, primary - radius, primary + radius];
        all.extend([low, high].map(|omega| row(ProofPart::Box, 0, omega, sides)));
        let of_p: Vec<_> = runs(rows).filter(|run| run[0].interval.p == p).collect();
        for (arc, run) in (1..).zip(of_p) {
            let reach = 8.0 * (high - low);
            let clamped = |(one, nu): (&CertificateRow, Ball)| {
                let omega = statement.oscillator.omega_1_over(nu).to_f64();
                let shown = omega.clamp(secondary - reach, secondary + reach);
                let nu =
                    if omega == shown { nu } else { statement.oscillator.omega_1_over(Ball::from(shown)) };
                let (begins, lower, upper) = ends(statement, one, nu)?;
                let sides = [begins, lower, upper.unwrap_or(lower)].map(Ball::to_f64);
                Some(row(ProofPart::Tube, arc, shown, sides))
            };
            let beside = run.iter().filter(|one| {
                let [last, first] =
                    one.interval.ends().map(|nu| statement.oscillator.omega_1_over(nu).to_f64());
                first <= secondary + reach && secondary - reach <= last
            });
            all.extend(beside.flat_map(|one| one.interval.ends().map(|nu| (one, nu))).filter_map(clamped));
        }
    }
    all
}
