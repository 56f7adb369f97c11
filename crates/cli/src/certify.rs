//! `grazing certify`: proves what Figure 7 shows of the paper's oscillator, and writes the
//! certificate.

use std::path::{Path, PathBuf};

use grazing_beyond::proofs::statement;
use grazing_certify::ball::Ball;
use grazing_certify::resonance::{EnclosedResonance, NAMES};
use grazing_certify::row::CertificateRow;
use grazing_certify::statement::{Decimal, Statement, WIDTH_PLACES};
use grazing_certify::{certificate, prove, summary};
use grazing_claims::published::Published;
use grazing_reproduction::StudyError;
use grazing_unfold::progress::Progress;

use crate::arguments::CertifyArguments;
use crate::commands::CommandLine;
use crate::failure::{Failure, computation};
use crate::folder::{Batch, OutputFile};
use crate::runner::{CommandOutcome, Plan, Running};
use crate::{limits, project};

/// The default folder of the certificate, from the root of the repository.
const CERTIFICATE: &str = "expected/certificate";
/// The default folder of certificates with settings over the parameter file.
const VARIED: &str = "varied/certificate";
/// The files of the certificate.
const FILES: [&str; 3] = ["statement.csv", "resonances.csv", "rows.csv"];

/// What is proved of a statement.
struct Proof {
    statement: Statement,
    resonances: Vec<EnclosedResonance>,
    rows: Vec<CertificateRow>,
    interrupted: bool,
}

/// Reads the statements that are to be proved.
///
/// # Errors
/// Bad input.
pub(crate) fn read(arguments: &CertifyArguments) -> Result<Plan<'_>, Failure> {
    let CertifyArguments { check, output, parameters, .. } = arguments;
    let failed = |error: StudyError| computation("certify", &error);
    let statement = statement(&project::parameters(parameters)?).map_err(failed)?;
    let folder = match output {
        Some(folder) => folder.clone(),
        None if parameters.set.is_empty() => project::root_folder()?.join(CERTIFICATE),
        None => project::root_folder()?.join(VARIED),
    };
    let compute = |running: &Running<'_>| {
        let proof = Proof::of(statement, &**running.progress());
        match proof.interrupted && *check {
            true => Err(Failure::incomplete("interrupted: nothing was compared")),
            false => Ok(proof),
        }
    };
    let say = |proof: Proof, folder: &Path| {
        let (points, share) = (proof.points(), summary::undecided_share(&proof.rows));
        let batch = Batch { incomplete: proof.interrupted, ..Batch::unlisted(folder, proof.files(points)) };
        let checker = project::root().unwrap_or_default().join(CERTIFICATE).join("check.py");
        let next = CommandLine::of(&["python3"]).with(checker.display()).with(batch.place().display());
        let mend = || {
            let folder = output.iter().map(|folder| ("--output", folder.display().to_string()));
            CommandLine::own("certify").options(parameters.options().chain(folder))
        };
        let unshown = proof.resonances.iter().any(|resonance| !resonance.missing.is_empty());
        let failure = match (proof.interrupted, share > 0.0 || unshown) {
            (true, _) => Some("interrupted: what was not tried yet is undecided in the certificate"),
            (_, true) => Some("not everything could be proved, see above; the rest is in the certificate"),
            _ => None,
        };
        Ok(CommandOutcome {
            text: proof.listing(points, share),
            batches: vec![batch],
            check: check.then(mend),
            next: next.into(),
            failure: failure.map(Failure::incomplete),
            ..CommandOutcome::default()
        })
    };
    let plan = Plan::new(compute, say).finishing();
    Ok(plan.writing(folder, FILES.map(PathBuf::from)).checking(*check))
}

impl Proof {
    /// Proves what can be proved until it is interrupted.
    fn of(statement: Statement, progress: &dyn Progress) -> Self {
        let frequency = statement.frequency.map(Decimal::ball);
        let resonances = EnclosedResonance::in_window(&statement.oscillator, &statement.loops, frequency);
        let what = "proofs over the window";
        let (begin, step) = (|parts| progress.begin(what, parts), || progress.step(what));
        let rows = prove(&statement, begin, step, limits::is_interrupted);
        let interrupted = limits::is_interrupted();
        progress.end(what);
        Self { statement, resonances, rows, interrupted }
    }

    /// The number of points at which GZ curves end or meet.
    fn points(&self) -> usize {
        summary::points(&self.statement, &self.rows).count()
    }

    /// The certificate.
    fn files(&self, points: usize) -> Vec<OutputFile> {
        let (numbers, rows) = (certificate::resonances(&self.resonances), certificate::rows(&self.rows));
        let stated = certificate::statement(&self.statement, points, &numbers, &rows);
        let contents = FILES.into_iter().zip([stated, numbers, rows]);
        contents
            .map(|(path, content)| OutputFile { path: path.into(), content: content.into_bytes() })
            .collect()
    }

    /// What is proved, as lines.
    fn listing(&self, points: usize, share: f64) -> String {
        let Self { statement, resonances, rows, .. } = self;
        let (mut text, published) = (String::new(), Published::printed());
        for resonance in resonances {
            text.push_str(&(summary::resonance(resonance).join("\n") + "\n"));
            text.extend(printed(statement, published, resonance));
        }
        for rows in rows.chunk_by(|a, b| a.interval.p == b.interval.p) {
            text.push_str(&format!("\np = {}\n", rows[0].interval.p));
            for stretch in summary::stretches(rows) {
                text.push_str(&format!("  {}\n", summary::sentence(statement, stretch)));
            }
        }
        let Statement { frequency: [lowest, highest], amplitude: [low, high], .. } = statement;
        text + &format!(
            "\n{} intervals. Tubes around GZ curves are at most 1e-{WIDTH_PLACES} of A wide. Away from resonances, GZ curves that bound stable motion end or meet at {points} points of the window {lowest} <= omega <= {highest}, {low} <= A <= {high}, and at no others{others}. The undecided share of nu is {share:.1e}.\n",
            rows.len(),
            others = summary::exceptions(rows),
        )
    }
}

/// A line for each number that the paper prints of a resonance: whether it is within half a unit of
/// its last digit of the proved value. None for constants other than the paper's.
fn printed(statement: &Statement, published: &Published, resonance: &EnclosedResonance) -> Vec<String> {
    let find = |id: &str| published.values.iter().find(|value| value.id == id);
    let is = |id: &str, ours: Decimal| find(id).is_some_and(|value| value.printed == ours.to_string());
    if !(is("zeta", statement.zeta) && is("epsilon", statement.epsilon)) {
        return Vec::new();
    }
    let EnclosedResonance { p, n, numbers, .. } = resonance;
    let line = |(name, proved): (&str, &Ball)| {
        let value = find(&format!("{}_p{p}_n{n}", name.trim_end_matches("_star")))?;
        let print = Decimal::new(value.printed.parse().ok()?)?.ball();
        let half_a_unit = Ball::ratio(5, 10_i64.pow(value.decimals() as u32 + 1)).size();
        let verdict = if half_a_unit.contains(*proved - print) { "confirmed" } else { "NOT CONFIRMED" };
        Some(format!("  {} = {} in print: {verdict} to the printed digits\n", value.quantity, value.printed))
    };
    NAMES.into_iter().zip(numbers).filter_map(line).collect()
}
