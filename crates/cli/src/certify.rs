//! `grazing certify`: proves what Figure 7 shows of the paper's oscillator, and writes the
//! certificate.

use std::fs;
use std::path::{Path, PathBuf};

use grazing_certify::ball::Ball;
use grazing_certify::resonance::{NAMES, Resonance};
use grazing_certify::statement::{Decimal, Statement, WIDTH_PLACES};
use grazing_certify::{certificate, prove, summary};
use grazing_claims::published::Published;
use grazing_reproduction::StudyError;
use grazing_reproduction::figures::beyond_proofs::statement;
use grazing_unfold::progress::Progress as _;

use crate::arguments::Certify;
use crate::commands::CommandLine;
use crate::failure::{Failure, computation};
use crate::folder::{self, OutputFile};
use crate::progress::Display;
use crate::{limits, project, terminal};

/// The default folder of the certificate, from the root of the repository.
const CERTIFICATE: &str = "expected/certificate";
/// The default folder of certificates with settings over the parameter file.
const VARIED: &str = "varied/certificate";

/// Proves statements, prints them, and writes or checks the certificate.
///
/// # Errors
/// Something is undecided, the files differ from what the code produces, or they cannot be written.
pub(crate) fn run(arguments: &Certify) -> Result<(), Failure> {
    limits::listen();
    let failed = |error: StudyError| computation("certify", &error);
    let statement = statement(&project::parameters(&arguments.parameters)?).map_err(failed)?;
    let mut folder = match &arguments.output {
        Some(folder) => folder.clone(),
        None if arguments.parameters.set.is_empty() => project::root_folder()?.join(CERTIFICATE),
        None => project::root_folder()?.join(VARIED),
    };
    let names = ["statement.csv", "resonances.csv", "rows.csv"].map(PathBuf::from);
    if !arguments.check {
        folder::ensure_writable(&folder, &names)?;
    }
    arguments.threads.start()?;

    let frequency = statement.frequency.map(Decimal::ball);
    let resonances = Resonance::in_window(&statement.oscillator, &statement.loops, frequency);
    let (display, what) = (Display::new(), "proofs over the window");
    let rows =
        prove(&statement, |parts| display.begin(what, parts), || display.step(what), limits::is_interrupted);
    let interrupted = limits::is_interrupted();
    display.end(what);
    if interrupted && arguments.check {
        return Err(Failure::incomplete("interrupted: nothing was compared"));
    }

    let published = Published::printed();
    for resonance in &resonances {
        terminal::say(&(summary::resonance(resonance).join("\n") + "\n"));
        printed(&statement, published, resonance).iter().for_each(|line| terminal::say(line));
    }
    for rows in rows.chunk_by(|a, b| a.interval.p == b.interval.p) {
        terminal::say(&format!("\np = {}\n", rows[0].interval.p));
        for stretch in summary::stretches(rows) {
            terminal::say(&format!("  {}\n", summary::sentence(&statement, stretch)));
        }
    }
    let points = summary::points(&statement, &rows).count();
    let share = summary::undecided_share(&rows);
    let others = summary::exceptions(&rows);
    let Statement { frequency: [lowest, highest], amplitude: [low, high], .. } = &statement;
    terminal::say(&format!(
        "\n{} intervals. Tubes around GZ curves are at most 1e-{WIDTH_PLACES} of A wide. Away from resonances, GZ curves that bound stable motion end or meet at {points} points of the window {lowest} <= omega <= {highest}, {low} <= A <= {high}, and at no others{others}. The undecided share of nu is {share:.1e}.\n",
        rows.len(),
    ));

    let (rows, numbers) = (certificate::rows(&rows), certificate::resonances(&resonances));
    let stated = certificate::statement(&statement, points, &numbers, &rows);
    let contents = [stated, numbers, rows];
    let files: Vec<OutputFile> = names
        .into_iter()
        .zip(contents)
        .map(|(path, content)| OutputFile { path, content: content.into_bytes() })
        .collect();
    if arguments.check {
        files.iter().try_for_each(|file| same(&folder, file))?;
    } else {
        folder = folder::place_to_write(&folder, &files, interrupted);
        folder::write(&folder, &files)?;
        terminal::say(&format!("{}: the certificate is written.\n", folder.display()));
    }
    if !arguments.check {
        let check = project::root().unwrap_or_default().join(CERTIFICATE).join("check.py");
        let command = CommandLine::of(&["python3"]).with(check.display()).with(folder.display());
        terminal::say_next(&command);
    }
    let unshown = resonances.iter().filter(|resonance| !resonance.missing.is_empty()).count();
    match (share > 0.0, unshown) {
        _ if interrupted => {
            Err(Failure::incomplete("interrupted: what was not tried yet is undecided in the certificate"))
        }
        (false, 0) => Ok(()),
        _ => Err(Failure::incomplete(
            "not everything could be proved, see above; the rest is in the certificate",
        )),
    }
}

/// A line for each number that the paper prints of a resonance: whether it is within half a unit of
/// its last digit of the proved value. None for constants other than the paper's.
fn printed(statement: &Statement, published: &Published, resonance: &Resonance) -> Vec<String> {
    let find = |id: &str| published.values.iter().find(|value| value.id == id);
    let is = |id: &str, ours: Decimal| find(id).is_some_and(|value| value.printed == ours.to_string());
    if !(is("zeta", statement.zeta) && is("epsilon", statement.epsilon)) {
        return Vec::new();
    }
    let Resonance { p, n, numbers, .. } = resonance;
    let line = |(name, proved): (&str, &Ball)| {
        let value = find(&format!("{}_p{p}_n{n}", name.trim_end_matches("_star")))?;
        let print = Decimal::new(value.printed.parse().ok()?)?.ball();
        let half_a_unit = Ball::ratio(5, 10_i64.pow(value.decimals() as u32 + 1)).size();
        let verdict = if half_a_unit.contains(*proved - print) { "confirmed" } else { "NOT CONFIRMED" };
        Some(format!("  {} = {} in print: {verdict} to the printed digits\n", value.quantity, value.printed))
    };
    NAMES.into_iter().zip(numbers).filter_map(line).collect()
}

/// Checks that the file in the folder has this content.
fn same(folder: &Path, file: &OutputFile) -> Result<(), Failure> {
    let path = folder.join(&file.path);
    let found = fs::read(&path).map_err(|error| Failure::file(&path, &error))?;
    if found == file.content {
        return Ok(());
    }
    let path = path.display();
    Err(Failure::check(format!(
        "{path}: differs from what the code produces: write it again with `{}`",
        CommandLine::own("certify")
    )))
}
