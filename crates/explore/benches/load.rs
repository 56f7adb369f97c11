//! Twenty pages in a real browser that drag at once: the motion that they show, the time that they
//! wait, and the resources that the server needs.
//!
//! ```sh
//! EXPLORE_LOAD_SECONDS=60 cargo bench -p grazing-explore --bench load
//! ```

// Only parts of these modules are used here.
#[allow(dead_code)]
#[path = "../tests/explore/browser/chromium.rs"]
mod chromium;
#[path = "../tests/explore/browser/crowd.rs"]
mod crowd;
#[allow(dead_code)]
#[path = "../tests/explore/server/running.rs"]
mod running;

use std::io::Write;
use std::time::{Duration, Instant};
use std::{env, fs};

use grazing_explore::Limits;
use running::Running;

const PAGES: usize = 20;
/// The seconds for which all pages drag, unless the environment sets them; and the megabytes by
/// which the process may grow.
const SECONDS: u64 = 5;
const MEGABYTES: f64 = 200.0;
/// The pause of a hand between two places of a slider.
const PAUSE: Duration = Duration::from_millis(60);

/// The megabytes that this process, the server, holds or has held at most; none where the system
/// does not report them.
fn held(what: &str) -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix(what))?;
    Some(line.trim().strip_suffix(" kB")?.parse::<f64>().ok()? / 1024.0)
}

/// The seconds of CPU time that this process has used; none where the system does not report them
/// in hundredths.
fn cpu() -> Option<f64> {
    let stat = fs::read_to_string("/proc/self/stat").ok()?;
    let (_, fields) = stat.rsplit_once(')')?;
    Some(
        fields.split_whitespace().skip(11).take(2).filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>()
            / 100.0,
    )
}

fn main() {
    let seconds = env::var("EXPLORE_LOAD_SECONDS").map_or(SECONDS, |seconds| seconds.parse().unwrap());
    let server = Running::new(Limits::default());
    let address = format!("http://{}{}", server.address, server.path);
    let Some(mut pages) = crowd::open(&address, PAGES) else { return };
    let window = crowd::window(&mut pages[0]);
    let (before, cpu_before, began) = (held("VmRSS:"), cpu(), Instant::now());
    let dragged = crowd::drag_all(&mut pages, PAUSE, || began.elapsed() < Duration::from_secs(seconds));
    let all_at_rest = began.elapsed().as_secs_f64() - seconds as f64;
    let (most, computed_for) = (held("VmHWM:"), cpu().zip(cpu_before).map(|(after, before)| after - before));
    let constants = crowd::assert_right(&dragged, window);
    let all = |name: &str| -> Vec<f64> {
        dragged.iter().map(|page| page.watched[name].as_f64().unwrap()).collect()
    };
    let [frames, longest, answers, gone, slowest] =
        ["frames", "longest", "answers", "gone", "slowest"].map(all);
    let greatest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max) / 1000.0;
    let least = frames.iter().copied().fold(f64::INFINITY, f64::min);
    let line = format!(
        "{PAGES} pages, {seconds} s: {:.1} frames a page and second, {:.1} the least; {:.2} s the longest without one; {} answers at {constants} constants, {} given up, \
         the slowest after {:.2} s; {all_at_rest:.2} s more until all pictures were whole; the server and what moves the pages: {:.0} s of CPU, {:.0} MB before, {:.0} MB at most\n",
        frames.iter().sum::<f64>() / (PAGES as u64 * seconds) as f64,
        least / seconds as f64,
        greatest(&longest),
        answers.iter().sum::<f64>(),
        gone.iter().sum::<f64>(),
        greatest(&slowest),
        computed_for.unwrap_or(f64::NAN),
        before.unwrap_or(f64::NAN),
        most.unwrap_or(f64::NAN),
    );
    let _ = std::io::stderr().write_all(line.as_bytes());
    let grown = before.zip(most).map(|(before, most)| most - before);
    assert!(grown.is_none_or(|grown| grown < MEGABYTES), "{grown:?} MB");
}
