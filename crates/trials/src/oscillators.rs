//! Oscillators with random constants and windows, as the text files that `grazing unfold` reads.

use core::fmt::Write;

use crate::random::Random;

/// A kind of oscillator: expressions, and ranges for what is random in them.
struct Family {
    name: &'static str,
    force: &'static str,
    restitution: &'static str,
    duration: &'static str,
    /// Constants with their ranges, besides ζ and ε.
    constants: &'static [(&'static str, [f64; 2])],
    /// Name and lower end of the primary parameter, and the range of its upper end.
    primary: (&'static str, f64, [f64; 2]),
    /// Name of the secondary parameter, and the ranges of its two ends.
    secondary: (&'static str, [f64; 2], [f64; 2]),
}

const AMPLITUDE: (&str, f64, [f64; 2]) = ("A", 0.0, [1.0, 2.5]);
const FREQUENCY: (&str, [f64; 2], [f64; 2]) = ("omega", [0.35, 0.7], [0.9, 1.3]);

/// A spring that stiffens; each of the others differs from it in a few lines.
const STIFFENING: Family = Family {
    name: "spring that stiffens",
    force: "-2*zeta*v - x - kappa*x^3 - 1 + A*cos(omega*t)",
    restitution: "epsilon",
    duration: "0",
    constants: &[("kappa", [0.05, 1.0])],
    primary: AMPLITUDE,
    secondary: FREQUENCY,
};

const FAMILIES: [Family; 10] = [
    STIFFENING,
    Family {
        name: "spring that softens",
        // Beyond 1/sqrt(kappa) from rest it pushes away.
        force: "-2*zeta*v - (x + 1) + kappa*(x + 1)^3 + A*cos(omega*t)",
        constants: &[("kappa", [0.02, 0.15])],
        ..STIFFENING
    },
    Family {
        name: "two wells",
        // At g - 1 and g + 1 from the wall, with the natural frequency sqrt(2 k).
        force: "-2*zeta*v + k*((x + g) - (x + g)^3) + A*cos(omega*t)",
        constants: &[("g", [1.7, 2.2]), ("k", [0.3, 0.7])],
        primary: ("A", 0.0, [0.4, 0.8]),
        ..STIFFENING
    },
    Family {
        name: "pendulum",
        force: "-2*zeta*v - sin(x + g) + A*cos(omega*t)",
        constants: &[("g", [0.5, 1.2])],
        primary: ("A", 0.0, [0.3, 0.7]),
        ..STIFFENING
    },
    Family {
        name: "drag, and a wall that gives way to fast impacts",
        force: "-2*zeta*v - delta*v*sqrt(v^2 + 0.01) - x - 1 + A*cos(omega*t)",
        restitution: "epsilon*exp(-softening*y)",
        duration: "omega*contact/(1 + y)",
        constants: &[("delta", [0.01, 0.1]), ("softening", [0.05, 0.5]), ("contact", [0.02, 0.2])],
        ..STIFFENING
    },
    Family {
        name: "clearance, and a spring that stiffens",
        force: "-2*zeta*v - (x + sigma)*(1 + kappa*sqrt(1 + (x + sigma)^2)) + cos(omega*t)",
        constants: &[("kappa", [0.02, 0.5])],
        primary: ("sigma", 0.0, [0.6, 1.5]),
        secondary: ("omega", [1.5, 2.0], [3.0, 4.5]),
        ..STIFFENING
    },
    Family {
        name: "parametric excitation",
        force: "-2*zeta*v - (1 + h*cos(2*omega*t + chi))*(x + 1) + A*cos(omega*t)",
        constants: &[("h", [0.02, 0.3]), ("chi", [0.1, 6.0])],
        ..STIFFENING
    },
    Family {
        name: "two harmonics",
        force: "-2*zeta*v - x - 1 + A*(cos(omega*t) + h*cos(2*omega*t + chi))",
        constants: &[("h", [0.05, 0.6]), ("chi", [0.1, 6.0])],
        ..STIFFENING
    },
    Family {
        name: "restitution that depends on velocity and phase",
        force: "-2*zeta*v - x - q*x^2 - 1 + A*cos(omega*t)",
        restitution: "epsilon*(1 - h*sin(z)^2)/(1 + softening*y)",
        constants: &[("q", [0.01, 0.1]), ("h", [0.02, 0.2]), ("softening", [0.05, 0.5])],
        primary: ("A", 0.0, [0.8, 1.5]),
        ..STIFFENING
    },
    Family {
        name: "stiffness as secondary parameter",
        force: "-2*zeta*v - k*x - kappa*x^3 - 1 + A*cos(omega*t)",
        constants: &[("kappa", [0.01, 0.2]), ("omega", [0.8, 1.2])],
        secondary: ("k", [0.7, 1.2], [2.5, 4.0]),
        ..STIFFENING
    },
];

/// No oscillator takes more random numbers than this.
const MOST_NUMBERS: u64 = 16;

/// An oscillator of a seed, as text; with the number go round all kinds of oscillators.
pub fn description(seed: u64, number: u64) -> String {
    let family = &FAMILIES[number as usize % FAMILIES.len()];
    let mut random = Random::from(seed, number * MOST_NUMBERS);
    let always = [("zeta", [0.01, 0.1]), ("epsilon", [0.5, 0.95])];
    let mut constants = String::new();
    for (name, [low, high]) in always.iter().chain(family.constants) {
        writeln!(constants, "{name} = {:.5}", random.logarithmic(*low, *high)).expect("a string takes all");
    }
    let (primary, from, [least, most]) = family.primary;
    let to = random.uniform(least, most);
    let (secondary, below, above) = family.secondary;
    let [low, high] = [below, above].map(|[least, most]| random.uniform(least, most));
    let Family { name, force, restitution, duration, .. } = family;
    format!(
        "name = \"{name}\"\n\n[parameters]\n{constants}\n\
         [primary]\nname = \"{primary}\"\nrange = [{from:.1}, {to:.4}]\n\n\
         [secondary]\nname = \"{secondary}\"\nrange = [{low:.4}, {high:.4}]\n\n\
         [motion]\nforce = \"{force}\"\nfrequency = \"omega\"\n\n\
         [impact]\nrestitution = \"{restitution}\"\nduration = \"{duration}\"\n\n\
         [analysis]\nloops = [1, 2, 3]\n"
    )
}
