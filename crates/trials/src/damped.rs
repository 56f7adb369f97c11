//! Random oscillators from hardly damped to overdamped, forced far more slowly than they swing or far
//! faster: whether each is unfolded in a minute, and what is left undecided.

use core::f64::consts::TAU;
use core::fmt;
use core::sync::atomic::{AtomicBool, Ordering};
use core::time::Duration;
use std::thread;

use grazing_input::Description;
use grazing_model::smooth::Stop;
use grazing_unfold::Diagram;
use grazing_unfold::progress::Progress;
use grazing_unfold::unfolded::Unfolded;

use crate::random::Random;
use crate::regions::doubts;

/// The ranges of the damping ratio, and of the forcing frequency over the natural one.
pub const DAMPING: [f64; 2] = [0.001, 3.0];
/// See [`DAMPING`].
pub const FREQUENCY: [f64; 2] = [0.05, 20.0];
/// The secondary parameter goes from the frequency divided by this to the frequency times this.
const ABOUT: f64 = 1.15;
/// The range of the primary parameter ends at this multiple of grazing of the linear oscillator.
const BEYOND_GRAZING: f64 = 2.0;
/// CPU seconds in which an oscillator is to be unfolded.
pub const LONGEST: f64 = 60.0;
/// Time between two looks at the clock.
const LOOK: Duration = Duration::from_millis(50);

/// The greatest number of random numbers that an oscillator uses.
const MOST_NUMBERS: u64 = 16;
/// Harmonics of the forcing, and instants of a period, from which its range follows: the narrowest pulse
/// has some hundred harmonics.
const HARMONICS: u32 = 200;
const INSTANTS: u32 = 1000;

/// A random oscillator.
#[derive(Clone, Debug)]
pub struct Damped {
    /// The damping ratio ζ.
    pub damping: f64,
    /// The forcing frequency over the natural one, in the middle of the range.
    pub frequency: f64,
    natural: f64,
    /// Coefficient of (x + 1)³ over that of x + 1.
    cubic: f64,
    restitution: f64,
    /// Sharpness k of pulses exp(k (cos ωt − 1)); 0 for a cosine.
    sharpness: f64,
}

impl Damped {
    /// The random oscillator of a seed and a number: a quarter is forced by pulses, another has a
    /// hardening spring, and the natural frequency is random.
    pub fn new(seed: u64, number: u64) -> Self {
        let mut random = Random::from(seed, number * MOST_NUMBERS);
        let mut between = |[low, high]: [f64; 2]| random.logarithmic(low, high);
        Self {
            damping: between(DAMPING),
            frequency: between(FREQUENCY),
            natural: between([0.1, 100.0]),
            cubic: between([0.01, 0.5]) * f64::from(u8::from(number % 4 == 2)),
            restitution: between([0.3, 0.95]),
            sharpness: between([5.0, 500.0]) * f64::from(u8::from(number % 4 == 3)),
        }
    }

    /// The forcing of unit size as a function of the phase.
    fn forcing(&self, phase: f64) -> f64 {
        let cosine = libm::cos(phase);
        if self.sharpness > 0.0 { libm::exp(self.sharpness * (cosine - 1.0)) } else { cosine }
    }

    /// The highest point of the linear oscillator's response to forcing of unit size at a frequency over
    /// the natural one.
    fn response(&self, ratio: f64) -> f64 {
        let phase = |k: u32| TAU * f64::from(k) / f64::from(INSTANTS);
        let forcing: Vec<f64> = (0..INSTANTS).map(|k| self.forcing(phase(k))).collect();
        // The forcing is even in the phase: a_m cos mz, with the response a_m Re(H(mω) exp(imz)).
        let harmonics: Vec<[f64; 2]> = (0..=HARMONICS)
            .map(|m| {
                let share = (0..INSTANTS).map(|k| forcing[k as usize] * libm::cos(f64::from(m) * phase(k)));
                let size = share.sum::<f64>() * if m == 0 { 1.0 } else { 2.0 } / f64::from(INSTANTS);
                let frequency = f64::from(m) * ratio;
                let [real, imaginary] = [1.0 - frequency * frequency, 2.0 * self.damping * frequency];
                [real, imaginary].map(|part| size * part / (real * real + imaginary * imaginary))
            })
            .collect();
        let at = |z: f64| {
            let of = |(m, [real, imaginary]): (usize, &[f64; 2])| {
                let (sine, cosine) = libm::sincos(m as f64 * z);
                real * cosine + imaginary * sine
            };
            harmonics.iter().enumerate().map(of).sum::<f64>()
        };
        (0..INSTANTS).map(|k| at(phase(k))).fold(0.0, f64::max)
    }

    /// The oscillator as the text of a file for `grazing unfold`.
    pub fn description(&self) -> String {
        let Self { damping, frequency, natural, cubic, restitution, sharpness } = self;
        let ratios = [frequency / ABOUT, *frequency, frequency * ABOUT];
        let grazing = ratios.map(|ratio| 1.0 / self.response(ratio)).into_iter().fold(0.0, f64::max);
        let most = BEYOND_GRAZING * (1.0 + cubic) * grazing;
        let [low, _, high] = ratios.map(|ratio| ratio * natural);
        let forcing = match *sharpness > 0.0 {
            true => "exp(k*(cos(omega*t) - 1))",
            false => "cos(omega*t)",
        };
        format!(
            "name = \"damping ratio {damping:.3}, frequency ratio {frequency:.3}\"\n\
             parameters = {{ w0 = {natural:.4e}, zeta = {damping:.4e}, c = {cubic:.4}, k = {sharpness:.2} }}\n\
             primary = {{ name = \"B\", range = [0.0, {most:.4e}] }}\n\
             secondary = {{ name = \"omega\", range = [{low:.4e}, {high:.4e}] }}\n\
             motion = {{ force = \"w0^2*(-(x + 1) - c*(x + 1)^3 - 2*zeta*v/w0 + B*{forcing})\", frequency = \"omega\" }}\n\
             impact = {{ restitution = \"{restitution:.3}\", duration = \"0\" }}\n\
             analysis = {{ loops = [1] }}\n"
        )
    }
}

/// What became of an oscillator.
#[derive(Clone, Debug, Default)]
pub struct UnfoldTrial {
    /// The oscillator's name.
    pub name: String,
    /// CPU seconds, or seconds of the clock on the wall where the system does not count these.
    pub seconds: f64,
    /// Whether the analysis was stopped, as it took too long.
    pub stopped: bool,
    /// The number of resonances.
    pub resonances: usize,
    /// The number of points of all curves.
    pub points: usize,
    /// The fraction of the window that is hatched for some p.
    pub hatched: f64,
    /// The reasons why something is undecided, missing, or not shown.
    pub reasons: Vec<String>,
}

impl UnfoldTrial {
    /// Whether the oscillator was unfolded in time, and what is hatched has its reason.
    pub fn passes(&self) -> bool {
        !self.stopped && (self.hatched == 0.0 || !self.reasons.is_empty())
    }
}

impl fmt::Display for UnfoldTrial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, seconds, stopped, resonances, points, hatched, reasons } = self;
        let end = if *stopped { "STOPPED after" } else { "unfolded in" };
        write!(
            f,
            "{name}: {end} {seconds:.1} s, {resonances} resonances, {points} points, {hatched:.4} hatched"
        )?;
        reasons.iter().try_for_each(|reason| write!(f, "\n    {reason}"))
    }
}

/// Unfolds an oscillator as `grazing unfold` does, and stops after a number of CPU seconds.
///
/// # Panics
/// The text that was made is no description of an oscillator.
pub fn unfold(text: &str, longest: f64) -> UnfoldTrial {
    let description = Description::parse(text, "random").unwrap_or_else(|error| panic!("{error}\n{text}"));
    let (stop, done, start) = (Stop::default(), AtomicBool::new(false), clock());
    let unfolded = thread::scope(|scope| {
        scope.spawn(|| {
            while !done.load(Ordering::Relaxed) {
                thread::sleep(LOOK);
                if clock() - start > longest && !stop.is_asked() {
                    return stop.ask();
                }
            }
        });
        let progress = &stop as &dyn Progress;
        let unfolded = Unfolded::described(&description, progress, &stop, &|_| ());
        done.store(true, Ordering::Relaxed);
        unfolded
    });
    let seconds = clock() - start;
    let name = description.name().to_owned();
    let mut outcome = UnfoldTrial { name, seconds, stopped: seconds > longest, ..UnfoldTrial::default() };
    match unfolded {
        Err(error) => outcome.reasons.push(error.to_string()),
        Ok(Unfolded { diagram, .. }) => {
            outcome.resonances = diagram.resonances.len();
            let grazing = diagram.grazing.iter().map(|curve| curve.states.len()).sum::<usize>();
            outcome.points =
                grazing + diagram.curves.iter().map(|curve| curve.curve.points.len()).sum::<usize>();
            outcome.hatched = hatched(&diagram);
            outcome.reasons = doubts(&diagram);
            outcome.reasons.sort();
            outcome.reasons.dedup();
            let lost = diagram.unlocated.iter().map(|lost| format!("p = {}: {}", lost.loops, lost.reason));
            let kept = diagram.not_unfolded.iter().map(|lost| format!("{}: {}", lost.name(), lost.reason));
            outcome.reasons.extend(lost.chain(kept));
            outcome
                .reasons
                .extend(diagram.unfinished.iter().map(|part| format!("not finished: {}", part.stage)));
        }
    }
    outcome
}

/// The fraction of a lattice of points that lie in an undecided region.
fn hatched(diagram: &Diagram) -> f64 {
    const LATTICE: u32 = 100;
    let shares = (0..LATTICE).map(|k| (f64::from(k) + 0.5) / f64::from(LATTICE));
    let undecided: Vec<_> = diagram.regions.iter().filter(|region| region.doubt.is_some()).collect();
    let points = shares.clone().flat_map(|across| shares.clone().map(move |up| [across, up]));
    let of = |point: [f64; 2]| undecided.iter().any(|region| region.contains(point));
    let count = points.filter(|shares| of(diagram.scope.window.parameters(*shares))).count();
    count as f64 / f64::from(LATTICE * LATTICE)
}

/// The CPU seconds that the process has taken.
#[cfg(unix)]
fn clock() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// Seconds since the first call, where the system has no clock of CPU time.
#[cfg(not(unix))]
fn clock() -> f64 {
    static FIRST: std::sync::OnceLock<std::time::Instant> = std::sync::OnceLock::new();
    FIRST.get_or_init(std::time::Instant::now).elapsed().as_secs_f64()
}
