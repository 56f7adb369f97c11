//! Appendix B: the flow of the linear oscillator as it is printed, and what is read off it.

use core::f64::consts::{PI, TAU};

use grazing_model::LinearOscillator;
use grazing_model::maps::{global_iterate, global_map};
use grazing_theorems::{GrazingState, Resonance};

use crate::convergence::order;
use crate::outcome::{CheckResult, Measure, Outcome};
use crate::sampling::Sampler;

/// eq:flow and eq:phip, coded from the print.
#[derive(Clone, Copy)]
struct Printed {
    zeta: f64,
    omega: f64,
}

impl Printed {
    /// φ_p and its derivative in t.
    fn periodic(&self, time: f64, amplitude: f64) -> [f64; 2] {
        let Self { zeta, omega } = *self;
        let stiffness = 1.0 - omega * omega;
        let factor = amplitude / (stiffness * stiffness + 4.0 * zeta * zeta * omega * omega);
        let (sine, cosine) = libm::sincos(omega * time);
        [
            -1.0 + factor * (stiffness * cosine + 2.0 * zeta * omega * sine),
            factor * omega * (-stiffness * sine + 2.0 * zeta * omega * cosine),
        ]
    }

    /// φ(t; x₀, y₀, t₀; 𝒜).
    fn flow(&self, time: f64, [x, y]: [f64; 2], start: f64, amplitude: f64) -> f64 {
        let zeta = self.zeta;
        let natural = (1.0 - zeta * zeta).sqrt();
        let (sine, cosine) = libm::sincos(natural * (time - start));
        let [position, velocity] = self.periodic(start, amplitude);
        libm::exp(-zeta * (time - start))
            * ((cosine + zeta / natural * sine) * (x - position) + sine / natural * (y - velocity))
            + self.periodic(time, amplitude)[0]
    }
}

/// Derivatives of φ at grazing after p periods, by central differences of sixth order in t, x, t₀ and 𝒜.
struct Derivatives {
    printed: Printed,
    end: f64,
    start: f64,
    amplitude: f64,
}

/// Step of the differences in time: 10⁻² of the shorter of the two time scales leaves an error of 10⁻¹³ and, for second and
/// third derivatives, rounding of 10⁻¹⁶ over its square or cube.
const STEP: f64 = 2e-2;

fn first(step: f64, f: impl Fn(f64) -> f64) -> f64 {
    let pair = |k: f64| f(k * step) - f(-k * step);
    (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * step)
}

fn second(step: f64, f: impl Fn(f64) -> f64) -> f64 {
    let pair = |k: f64| f(k * step) + f(-k * step);
    (270.0 * pair(1.0) - 27.0 * pair(2.0) + 2.0 * pair(3.0) - 490.0 * f(0.0)) / (180.0 * step * step)
}

impl Derivatives {
    fn new(state: &GrazingState, loops: u32) -> Self {
        let omega = state.forcing_frequency();
        let start = state.phase() / omega;
        Self {
            printed: Printed { zeta: state.oscillator().damping_ratio(), omega },
            end: start + TAU * f64::from(loops) / omega,
            start,
            amplitude: state.amplitude(),
        }
    }

    /// φ displaced in (t, x, t₀, 𝒜).
    fn at(&self, [time, x, start, amplitude]: [f64; 4]) -> f64 {
        self.printed.flow(self.end + time, [x, 0.0], self.start + start, self.amplitude + amplitude)
    }

    fn step(&self) -> f64 {
        STEP / self.printed.omega.max(1.0)
    }

    /// ∂ⁿφ/∂tⁿ displaced in (x, t₀, 𝒜), n ≤ 3.
    fn in_time(&self, n: u32, [x, start, amplitude]: [f64; 3]) -> f64 {
        let f = |time: f64| self.at([time, x, start, amplitude]);
        let step = self.step();
        match n {
            0 => f(0.0),
            1 => first(step, f),
            2 => second(step, f),
            _ => first(step, |time| second(step, |later| f(time + later))),
        }
    }

    /// φ̇.
    fn velocity(&self) -> f64 {
        self.in_time(1, [0.0; 3])
    }

    /// φ̈.
    fn acceleration(&self) -> f64 {
        self.in_time(2, [0.0; 3])
    }

    /// The derivative in x, t₀ or 𝒜 (`variable` 0, 1, 2) of ∂ⁿφ/∂tⁿ.
    fn mixed(&self, n: u32, variable: usize) -> f64 {
        first(self.step(), |h| {
            let mut moved = [0.0; 3];
            moved[variable] = h;
            self.in_time(n, moved)
        })
    }

    /// ∂²/∂t₀² of ∂ⁿφ/∂tⁿ.
    fn twice_in_start(&self, n: u32) -> f64 {
        second(self.step(), |h| self.in_time(n, [0.0, h, 0.0]))
    }
}

/// The oscillator at grazing, ζ, ε and ω at random.
fn states(count: usize) -> Result<Vec<GrazingState>, grazing_theorems::TheoryError> {
    let mut sampler = Sampler::new(11);
    let mut one = || {
        let theory =
            grazing_theorems::LinearOscillator::new(sampler.between(0.01, 0.9), sampler.between(0.1, 1.0))?;
        theory.grazing(sampler.between(0.3, 3.0))
    };
    (0..count).map(|_| one()).collect()
}

/// Resonances with p loops, E_p and ε at random.
fn resonances(loops: &[u32], count: usize) -> Result<Vec<Resonance>, grazing_theorems::TheoryError> {
    let mut sampler = Sampler::new(12);
    let mut one = || {
        let p = sampler.one_of(loops);
        let n = sampler.one_of(&[1, 2, 3, 4]);
        let ratio = if p == 1 { 0.5 * f64::from(n) } else { f64::from(n) + 0.5 / f64::from(p) };
        let skew = -libm::log(sampler.between(0.05, 0.95)) / (TAU * f64::from(p) * ratio);
        let zeta = skew / (1.0 + skew * skew).sqrt();
        grazing_theorems::LinearOscillator::new(zeta, sampler.between(0.1, 1.0))?.resonance(p, n)
    };
    (0..count).map(|_| one()).collect()
}

fn model(state: &GrazingState) -> Result<LinearOscillator, grazing_model::OscillatorError> {
    let theory = state.oscillator();
    let (zeta, epsilon) = (theory.damping_ratio(), theory.coefficient_of_restitution());
    LinearOscillator::new(zeta, epsilon, state.amplitude(), state.forcing_frequency())
}

/// The largest deviation of pairs (found, stated), relative to one plus the size of the stated number.
fn largest(pairs: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    pairs.into_iter().map(|(found, stated)| (found - stated).abs() / (1.0 + stated.abs())).fold(0.0, worse)
}

/// The larger, or what is not a number.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b > a { b } else { a }
}

/// What the differences of sixth order explain: 10⁻¹² for first and second derivatives; nested ones some 10⁻¹⁰.
const DIFFERENCES: f64 = 1e-8;

/// Closed forms with the same rounding: angles of up to 2πp ω₁/ω ≈ 80 are rounded to 10⁻¹⁴.
const CLOSED: f64 = 1e-12;

fn deviation(found: f64, tolerance: f64, samples: usize, over: &str) -> CheckResult {
    Ok(Outcome::new(Measure::Deviation { largest: found, tolerance }, samples, over))
}

const STATES: &str = "grazing states with ζ in (0.01, 0.9) and ω in (0.3, 3)";

/// eq:Abproof1: P_global ends where the printed flow from (x, 0) at z/ω comes to rest.
pub(super) fn return_by_printed_flow() -> CheckResult {
    let mut sampler = Sampler::new(13);
    let (mut found, mut samples) = (0.0, 0);
    for state in states(400)? {
        let mut at = || 0.02 * sampler.between(-1.0, 1.0);
        let (x, z, amplitude) = (at(), state.phase() + at(), state.amplitude() * (1.0 + at()));
        let oscillator = grazing_model::ImpactOscillator::with_parameters(
            &model(&state)?,
            [amplitude, state.forcing_frequency()],
        );
        let Ok(landing) = global_map::<_, 1>(&oscillator, x, z, None) else { continue };
        let printed = Printed { zeta: state.oscillator().damping_ratio(), omega: state.forcing_frequency() };
        let omega = state.forcing_frequency();
        let end = (landing.jet.value[1] + TAU) / omega;
        let flow = |time: f64| printed.flow(time, [x, 0.0], z / omega, amplitude);
        let velocity = first(STEP / omega.max(1.0), |h| flow(end + h));
        found = worse(found, largest([(flow(end), landing.jet.value[0]), (velocity, 0.0)]));
        samples += 1;
    }
    deviation(found, DIFFERENCES, samples, "returns to Π from points within 0.02 of grazing")
}

/// eq:Abproof2: both lines, as the order of what the linear terms leave of φ and φ̇ at the return.
pub(super) fn first_order_terms() -> CheckResult {
    let mut sampler = Sampler::new(14);
    let mut worst = f64::INFINITY;
    let all = states(60)?;
    for state in &all {
        let derivatives = Derivatives::new(state, 1);
        let map = state.linearised_map();
        let omega = state.forcing_frequency();
        let shares: [f64; 3] = core::array::from_fn(|_| sampler.between(-1.0, 1.0));
        let [by_x, by_start, by_amplitude] = [0, 1, 2].map(|k| [0, 1].map(|n| derivatives.mixed(n, k)));
        let rates = [derivatives.velocity(), derivatives.acceleration()];
        for line in 0..2 {
            let observed = order(|size| {
                let [d_1, d_2, d_3] = shares.map(|share| share * size);
                let shift = (map.a.m21 * d_1 + map.a.m22 * d_2 + map.b.y * d_3) / omega;
                let linear = rates[line] * shift
                    + by_x[line] * d_1
                    + by_start[line] * d_2 / omega
                    + by_amplitude[line] * d_3;
                let moved = [d_1, d_2 / omega, d_3];
                // φ or φ̇ where the orbit ends to first order, less what the equation has on its left: x' or zero.
                let actual = if line == 0 {
                    derivatives.at([shift, moved[0], moved[1], moved[2]])
                } else {
                    first(derivatives.step(), |h| derivatives.at([shift + h, moved[0], moved[1], moved[2]]))
                };
                let left = if line == 0 { map.a.m11 * d_1 + map.a.m12 * d_2 + map.b.x * d_3 } else { 0.0 };
                // Both the flow and the left-hand side differ from the linear terms in second order; the linear terms are
                // known to the accuracy of the differences, so that they count for sizes above their hundredfold.
                let gap = (actual - left).abs().max((linear - left).abs());
                Some((gap, 1e-12 * (1.0 + size * 1e2)))
            });
            worst = worst.min(observed);
        }
    }
    // Slack for the third order at the sizes where the second stands clear of the accuracy of differences.
    let measure = Measure::Order { observed: worst, stated: 2.0, slack: 0.3 };
    Ok(Outcome::new(measure, 2 * all.len(), STATES))
}

/// eq:Abproof3 with derivatives of the printed flow by differences, against the derivatives of P_global.
pub(super) fn entries_by_derivatives() -> CheckResult {
    let all = states(300)?;
    let mut found = 0.0;
    for state in &all {
        let derivatives = Derivatives::new(state, 1);
        let omega = state.forcing_frequency();
        let (velocity, acceleration) = (derivatives.velocity(), derivatives.acceleration());
        let jet = global_map::<_, 1>(&model(state)?, 0.0, state.phase(), None)?.jet;
        let entry = |variable: usize| {
            let (position, rate) = (derivatives.mixed(0, variable), derivatives.mixed(1, variable));
            [position - velocity / acceleration * rate, -omega / acceleration * rate]
        };
        for (variable, scale) in [(0, 1.0), (1, 1.0 / omega), (2, 1.0)] {
            let [upper, lower] = entry(variable);
            let stated = [jet.jacobian[(0, variable)], jet.jacobian[(1, variable)]];
            found = worse(found, largest([(upper * scale, stated[0]), (lower * scale, stated[1])]));
        }
    }
    deviation(found, DIFFERENCES, 6 * all.len(), STATES)
}

/// e^{−2πpζ/ω}, cos and sin of 2πp ω₁/ω, ζ/ω₁, ω₁.
struct Turn {
    decay: f64,
    cosine: f64,
    sine: f64,
    skew: f64,
    natural: f64,
}

impl Turn {
    fn new(state: &GrazingState, loops: u32) -> Self {
        let zeta = state.oscillator().damping_ratio();
        let natural = (1.0 - zeta * zeta).sqrt();
        let turns = TAU * f64::from(loops) / state.forcing_frequency();
        let (sine, cosine) = libm::sincos(turns * natural);
        Self { decay: libm::exp(-turns * zeta), cosine, sine, skew: zeta / natural, natural }
    }

    /// a₂₂ of the p-th iterate.
    fn entry(&self) -> f64 {
        self.decay * (self.cosine - self.skew * self.sine)
    }

    /// The printed ξ_p, eq:xi1proof2 and eq:xipproof2.
    fn xi(&self) -> f64 {
        self.entry() * self.entry() - self.decay * (self.cosine - 3.0 * self.skew * self.sine)
    }
}

/// eq:Abproof4: all eight derivatives of φ at grazing.
pub(super) fn derivatives_at_grazing() -> CheckResult {
    let all = states(300)?;
    let mut found = 0.0;
    for state in &all {
        let derivatives = Derivatives::new(state, 1);
        let turn = Turn::new(state, 1);
        let (omega, amplitude) = (state.forcing_frequency(), state.amplitude());
        let upper = turn.decay * (turn.cosine + turn.skew * turn.sine);
        let lower = turn.decay * turn.sine / turn.natural;
        found = worse(
            found,
            largest([
                (derivatives.velocity(), 0.0),
                (derivatives.acceleration(), -omega * omega),
                (derivatives.mixed(0, 0), upper),
                (derivatives.mixed(1, 0), -lower),
                (derivatives.mixed(0, 1), omega * omega * lower),
                (derivatives.mixed(1, 1), omega * omega * turn.entry()),
                (derivatives.mixed(0, 2), (1.0 - upper) / amplitude),
                (derivatives.mixed(1, 2), lower / amplitude),
            ]),
        );
    }
    deviation(found, DIFFERENCES, 8 * all.len(), STATES)
}

/// The display of a₁₁ to b₂ at the end of the proof, against the derivatives of P_global.
pub(super) fn matrix_and_vector() -> CheckResult {
    let all = states(500)?;
    let mut found = 0.0;
    for state in &all {
        let turn = Turn::new(state, 1);
        let (omega, amplitude) = (state.forcing_frequency(), state.amplitude());
        let upper = turn.decay * (turn.cosine + turn.skew * turn.sine);
        let lower = turn.decay * turn.sine / turn.natural;
        let stated = [
            [upper, omega * lower, (1.0 - upper) / amplitude],
            [-lower / omega, turn.entry(), lower / (omega * amplitude)],
        ];
        let jet = global_map::<_, 1>(&model(state)?, 0.0, state.phase(), None)?.jet;
        for (i, row) in stated.iter().enumerate() {
            found = worse(
                found,
                largest(row.iter().enumerate().map(|(k, entry)| (jet.jacobian[(i, k)], *entry))),
            );
        }
    }
    deviation(found, CLOSED, 6 * all.len(), STATES)
}

/// The display of ξ₁ by derivatives of φ, differences against the second derivative of P_global.
pub(super) fn second_derivative_by_flow() -> CheckResult {
    let all = states(200)?;
    let mut found = 0.0;
    for state in &all {
        let derivatives = Derivatives::new(state, 1);
        let omega = state.forcing_frequency();
        let (velocity, acceleration) = (derivatives.velocity(), derivatives.acceleration());
        let slip = velocity / acceleration;
        let entry = state.linearised_map().a.m22;
        let xi = (entry * entry * (acceleration - slip * derivatives.in_time(3, [0.0; 3]))
            + 2.0 * entry * (derivatives.mixed(1, 1) - slip * derivatives.mixed(2, 1))
            + derivatives.twice_in_start(0)
            - slip * derivatives.twice_in_start(1))
            / (omega * omega);
        let jet = global_map::<_, 2>(&model(state)?, 0.0, state.phase(), None)?.jet;
        found = worse(found, largest([(xi, jet.hessians[0][(1, 1)])]));
    }
    deviation(found, DIFFERENCES, all.len(), STATES)
}

/// eq:d2phidt02.
pub(super) fn second_derivative_in_start() -> CheckResult {
    let all = states(300)?;
    let mut found = 0.0;
    for state in &all {
        let turn = Turn::new(state, 1);
        let omega = state.forcing_frequency();
        let stated = -omega * omega * turn.decay * (turn.cosine - 3.0 * turn.skew * turn.sine);
        found = worse(found, largest([(Derivatives::new(state, 1).twice_in_start(0), stated)]));
    }
    deviation(found, DIFFERENCES, all.len(), STATES)
}

/// The printed ξ_p against the second derivative of P_global^p.
fn xi(loops: core::ops::RangeInclusive<u32>) -> CheckResult {
    let all = states(200)?;
    let (mut found, mut samples) = (0.0, 0);
    for state in &all {
        for p in loops.clone() {
            let jet = global_iterate::<_, 2>(&model(state)?, p, 0.0, state.phase())?;
            found = worse(found, largest([(jet.hessians[0][(1, 1)], Turn::new(state, p).xi())]));
            samples += 1;
        }
    }
    // Second derivatives of up to five composed maps.
    deviation(found, 1e-11, samples, STATES)
}

/// eq:xi1proof2.
pub(super) fn second_derivative_of_one_loop() -> CheckResult {
    xi(1..=1)
}

/// eq:xipproof2, off resonance too.
pub(super) fn second_derivative_of_many_loops() -> CheckResult {
    xi(2..=5)
}

/// Resonances at which closed forms are compared.
fn at_resonances(
    loops: &[u32],
    over: &str,
    tolerance: f64,
    pairs: impl Fn(&Resonance) -> Result<Vec<(f64, f64)>, Box<dyn std::error::Error + Send + Sync>>,
) -> CheckResult {
    let all = resonances(loops, 300)?;
    let (mut found, mut samples) = (0.0, 0);
    for resonance in &all {
        let pairs = pairs(resonance)?;
        samples += pairs.len();
        found = worse(found, largest(pairs));
    }
    deviation(found, tolerance, samples, over)
}

const ONE: &str = "resonances with p = 1, n = 1 to 4, E and ε at random";
const MANY: &str = "resonances with p = 2 to 6, n = 1 to 4, E and ε at random";
const MORE_LOOPS: &[u32] = &[2, 3, 4, 5, 6];

/// (−1)ⁿ.
fn parity(resonance: &Resonance) -> f64 {
    if resonance.index().is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// ξ_p of the iterated map at a resonance.
fn iterated(resonance: &Resonance) -> Result<f64, Box<dyn std::error::Error + Send + Sync>> {
    let grazing = resonance.grazing();
    let jet = global_iterate::<_, 2>(&model(&grazing)?, resonance.loops(), 0.0, grazing.phase())?;
    Ok(jet.hessians[0][(1, 1)])
}

/// eq:xi1proof3.
pub(super) fn resonant_second_derivative_of_one_loop() -> CheckResult {
    at_resonances(&[1], ONE, 1e-11, |resonance| {
        let decay = resonance.grazing().decay(1);
        Ok(vec![(iterated(resonance)?, decay * (decay - parity(resonance)))])
    })
}

/// eq:xipproof3.
pub(super) fn resonant_second_derivative_of_many_loops() -> CheckResult {
    at_resonances(MORE_LOOPS, MANY, 1e-11, |resonance| {
        let decay = resonance.grazing().decay(resonance.loops());
        Ok(vec![(iterated(resonance)?, decay * (decay + 1.0))])
    })
}

/// a₁₁ = a₂₂ = (−1)ⁿ E₁ and the values of sine and cosine at resonance.
pub(super) fn diagonal_at_resonance() -> CheckResult {
    at_resonances(&[1], ONE, CLOSED, |resonance| {
        let grazing = resonance.grazing();
        let jet = global_map::<_, 1>(&model(&grazing)?, 0.0, grazing.phase(), None)?.jet;
        let stated = parity(resonance) * grazing.decay(1);
        let turn = Turn::new(&grazing, 1);
        let angles = [(turn.sine, 0.0), (turn.cosine, parity(resonance))];
        Ok([(jet.jacobian[(0, 0)], stated), (jet.jacobian[(1, 1)], stated)]
            .into_iter()
            .chain(angles)
            .collect())
    })
}

/// sin and cos of 2πp ω₁/ω and of 2πω₁/ω at a resonance with p ≥ 2.
pub(super) fn angles_at_resonance() -> CheckResult {
    at_resonances(MORE_LOOPS, MANY, CLOSED, |resonance| {
        let (once, whole) =
            (Turn::new(&resonance.grazing(), 1), Turn::new(&resonance.grazing(), resonance.loops()));
        let (sine, cosine) = libm::sincos(PI / f64::from(resonance.loops()));
        Ok(vec![(whole.sine, 0.0), (whole.cosine, -1.0), (once.sine, sine), (once.cosine, cosine)])
    })
}

/// eq:xi1proof4: both lines against eq:c1 at the numerical A and ξ₁.
pub(super) fn stability_of_one_loop() -> CheckResult {
    at_resonances(&[1], ONE, 1e-10, |resonance| {
        let grazing = resonance.grazing();
        let (decay, sign) = (grazing.decay(1), parity(resonance));
        let epsilon = grazing.oscillator().coefficient_of_restitution();
        let jet = global_map::<_, 2>(&model(&grazing)?, 0.0, grazing.phase(), None)?.jet;
        let (a, c, xi) = (jet.jacobian[(0, 0)], jet.jacobian[(1, 1)], jet.hessians[0][(1, 1)]);
        let alpha = 1.0 + epsilon;
        let mut pairs = Vec::new();
        for side in [1.0, -1.0] {
            // γ = ω², so that ω²/γ = 1.
            let general = (1.0 - side * c) * (a * epsilon * epsilon - side) + alpha * alpha * xi / (1.0 - c);
            let longer = (1.0 - side * sign * decay) * (sign * epsilon * epsilon * decay - side)
                + alpha * alpha * decay * (decay - sign) / (1.0 - sign * decay);
            let rebound = epsilon * decay;
            let shorter = -side * (1.0 + side * 2.0 * sign * rebound + rebound * rebound);
            pairs.extend([(longer, shorter), (general, shorter)]);
        }
        Ok(pairs)
    })
}

/// eq:xipproof4: both lines against eq:cp at the numerical ξ_p.
pub(super) fn stability_of_many_loops() -> CheckResult {
    at_resonances(MORE_LOOPS, MANY, 1e-10, |resonance| {
        let grazing = resonance.grazing();
        let decay = grazing.decay(resonance.loops());
        let epsilon = grazing.oscillator().coefficient_of_restitution();
        let alpha = 1.0 + epsilon;
        let xi = iterated(resonance)?;
        let mut pairs = Vec::new();
        for side in [1.0, -1.0] {
            let loops = (1.0 + side * decay) * (-epsilon * epsilon * decay - side);
            let shorter = -side * (1.0 - side * epsilon * decay) * (1.0 - side * epsilon * decay);
            pairs.push((loops + alpha * alpha * decay, shorter));
            pairs.push((loops + alpha * alpha * xi / (1.0 + decay), shorter));
        }
        Ok(pairs)
    })
}

/// The derivative in ω of an entry or combination of entries of A along the grazing curve, by differences of P_global.
fn along_grazing(
    resonance: &Resonance,
    of: impl Fn(&nalgebra::Matrix2<f64>) -> f64,
) -> Result<f64, Box<dyn std::error::Error + Send + Sync>> {
    let theory = resonance.grazing().oscillator();
    let at = |h: f64| -> Result<f64, Box<dyn std::error::Error + Send + Sync>> {
        let state = theory.grazing(resonance.forcing_frequency() + h)?;
        Ok(of(&global_map::<_, 1>(&model(&state)?, 0.0, state.phase(), None)?.jet.derivative()))
    };
    // Angles 2πω₁/ω change fast at low ω: the step shrinks with ω².
    let step = 2e-3 * resonance.forcing_frequency() * resonance.forcing_frequency();
    let mut sum = 0.0;
    for (k, weight) in [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)] {
        sum += weight * (at(k * step)? - at(-k * step)?);
    }
    Ok(sum / (60.0 * step))
}

/// eq:xi1proof5.
pub(super) fn slope_of_one_loop() -> CheckResult {
    at_resonances(&[1], ONE, DIFFERENCES, |resonance| {
        let omega = resonance.forcing_frequency();
        let stated = -TAU * parity(resonance) * resonance.grazing().decay(1) / omega;
        Ok(vec![(along_grazing(resonance, |a| a.m12)?, stated)])
    })
}

/// The general κ_p' of the proof: the display before eq:xipproof5.
fn detuning_slope(state: &GrazingState, loops: u32) -> f64 {
    let turn = Turn::new(state, 1);
    let (zeta, omega) = (state.oscillator().damping_ratio(), state.forcing_frequency());
    let bracket = zeta * turn.cosine + turn.natural * turn.sine - zeta * libm::cos(PI / f64::from(loops));
    2.0 * TAU / (omega * omega) * turn.decay * bracket
}

fn detuning(loops: u32) -> impl Fn(&nalgebra::Matrix2<f64>) -> f64 {
    move |a| a.trace() - 2.0 * a.determinant().sqrt() * libm::cos(PI / f64::from(loops))
}

/// The display of κ_p', at resonances of other numbers of loops than p too.
pub(super) fn detuning_derivative() -> CheckResult {
    at_resonances(&[1, 2, 3, 4, 5, 6], "grazing states, p = 2 to 5", DIFFERENCES, |resonance| {
        let pair =
            |p: u32| Ok((along_grazing(resonance, detuning(p))?, detuning_slope(&resonance.grazing(), p)));
        (2..=5).map(pair).collect()
    })
}

/// eq:xipproof5.
pub(super) fn slope_of_many_loops() -> CheckResult {
    at_resonances(MORE_LOOPS, MANY, DIFFERENCES, |resonance| {
        let p = resonance.loops();
        let turn = Turn::new(&resonance.grazing(), 1);
        let omega = resonance.forcing_frequency();
        let stated = 2.0 * TAU * turn.natural / (omega * omega) * turn.decay * libm::sin(PI / f64::from(p));
        Ok(vec![(along_grazing(resonance, detuning(p))?, stated)])
    })
}

/// The last steps of both proofs: the general coefficients at resonance are those of Propositions 3.2 and 3.3.
pub(super) fn coefficients() -> CheckResult {
    at_resonances(&[1, 2, 3, 4, 5, 6], "resonances with p = 1 to 6, E and ε at random", 1e-8, |resonance| {
        let point = resonance.resonant_point();
        // Divided by the stated number: the coefficients have sizes of all orders, and c_PD loses digits where s⁻ is small.
        Ok(vec![
            (point.saddle_node_coefficient() / resonance.saddle_node_coefficient(), 1.0),
            (point.period_doubling_coefficient() / resonance.period_doubling_coefficient(), 1.0),
        ])
    })
}
