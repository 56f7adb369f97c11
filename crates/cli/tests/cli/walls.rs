//! Oscillators between two walls: what the commands do with both, and what they refuse.

use crate::program::{folder_with, grazing, read};

/// A linear oscillator between walls with unlike restitutions, in a narrow window.
const BETWEEN: &str = "name = \"Between\"\nparameters = { zeta = 0.05, r = 0.7, gap = 1.0 }\nprimary = { name = \"A\", range = [0.4, 1.1] }\n\
    secondary = { name = \"omega\", range = [0.66, 0.72] }\n\
    motion = { force = \"-2*zeta*v - x + A*cos(omega*t)\", frequency = \"omega\" }\n\
    impact = { restitution = \"r\", duration = \"0\" }\nanalysis = { loops = [1] }\n\
    [[walls]]\nposition = \"1\"\n[[walls]]\nposition = \"-gap\"\nrestitution = \"0.8\"\n";

fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The column of a table with a name.
fn column<'a>(table: &'a str, name: &str) -> Vec<&'a str> {
    let place = table.lines().next().and_then(|head| head.split(',').position(|column| column == name));
    let place = place.unwrap_or_else(|| panic!("{name}: {table}"));
    table.lines().skip(1).filter_map(|line| line.split(',').nth(place)).collect()
}

#[test]
fn measurements_between_walls_are_compared_with_what_hits_either_or_both() {
    let data = "A,A_error,omega,omega_error,seen,periods,impacts\n0.45,0.001,0.7,0.001,none,,\n0.95,0.001,0.7,0.001,periodic,1,2\n";
    let folder = folder_with(&[("my.toml", BETWEEN), ("seen.csv", data)]);
    let run = grazing(folder.path(), &["unfold", "my.toml", "--data", "seen.csv", "--output", "out"]);
    assert_eq!(run.code, Some(0), "{} {}", run.output, run.messages);
    let (regions, curves) = (
        read(folder.path(), "out/data/sequence_regions.csv"),
        read(folder.path(), "out/data/sequence_curves.csv"),
    );
    assert!(column(&regions, "walls").iter().all(|walls| *walls == "1-2"), "{regions}");
    // Unlike walls have no symmetry that could be lost.
    assert!(!column(&curves, "kind").contains(&"PF"), "{curves}");
    assert!(read(folder.path(), "out/diagram.svg").contains("1+1/1"));
    let measured = read(folder.path(), "out/data/measured.csv");
    assert_eq!(column(&measured, "agreement"), ["agrees", "agrees"], "{measured}");
    let page = read(folder.path(), "out/report.html");
    assert!(
        page.contains("wall 2: ") && page.contains("with the motion above it") && page.contains("at wall 2")
    );
}

#[test]
fn a_family_between_walls_has_the_resonances_of_each() {
    let folder = folder_with(&[("my.toml", BETWEEN)]);
    let run = grazing(folder.path(), &["unfold", "my.toml", "--vary", "r=0.7:0.75:2", "--output", "out"]);
    assert_eq!(run.code, Some(0), "{} {}", run.output, run.messages);
    let resonances = read(folder.path(), "out/data/family_resonances.csv");
    for wall in ["1", "2"] {
        let own = column(&resonances, "wall").iter().filter(|found| **found == wall).count();
        assert!(own >= 2, "wall {wall}: {resonances}");
    }
    // Curves from member to member lead from a wall to itself.
    let curves = column(&resonances, "curve").into_iter().zip(column(&resonances, "wall"));
    let mut all: Vec<_> = curves.collect();
    all.sort_unstable();
    all.dedup();
    let numbers: Vec<&str> = all.iter().map(|(curve, _)| *curve).collect();
    assert!(numbers.windows(2).all(|pair| pair[0] != pair[1]), "{all:?}");
}

#[test]
fn an_export_between_walls_says_at_which_the_motion_begins() {
    let folder = folder_with(&[("my.toml", BETWEEN)]);
    let run = grazing(folder.path(), &["export", "my.toml", "--at", "0.6,0.7", "--output", "out"]);
    assert_eq!(run.code, Some(0), "{} {}", run.output, run.messages);
    assert!(words(&run.output).contains("p = 1, at wall "), "{}", run.output);
}

/// The amplitude at which motion of a mass on a spring of period T that hits walls at ±1 once each loses its symmetry.
///
/// From an impact at wall 1, at speed y, to that at wall 2 half a period later the free part of the motion, 1 − X at the wall with the
/// velocity −r y − X' and then its opposite with −y + X', is carried by the matrix m of free motion: X = 1 − αy and X' = βy, and A
/// follows from X² + (X'/ω)². In the mirror the derivative of one impact in the other has the determinant (r d)², d being the decay, and the trace
/// r (m₁₁ + m₂₂) + m₁₂ (1 + r) (1 − A cos z)/y, and a multiplier is −1.
fn loss_of_symmetry(zeta: f64, r: f64, omega: f64) -> f64 {
    let w = (1.0 - zeta * zeta).sqrt();
    let t = core::f64::consts::PI / omega;
    let (d, [cos, sin]) = (libm::exp(-zeta * t), [libm::cos(w * t), libm::sin(w * t) / w]);
    let [m11, m12, m21, m22] = [d * (cos + zeta * sin), d * sin, -d * sin, d * (cos - zeta * sin)];
    let determinant = (1.0 + m11) * (1.0 + m22) - m12 * m21;
    let alpha = m12 * (1.0 + r) / determinant;
    let beta = ((1.0 + m11) * (1.0 - m22 * r) + m21 * m12 * r) / determinant;
    let stiff = 1.0 - omega * omega;
    let flight = m12 * (1.0 + r);
    let rest = 1.0 + r * r * d * d + r * (m11 + m22) + flight * (stiff * alpha - 2.0 * zeta * beta);
    let y = -flight * omega * omega / rest;
    libm::hypot(1.0 - alpha * y, beta * y / omega) * libm::hypot(stiff, 2.0 * zeta * omega)
}

#[test]
fn restitution_is_identified_from_where_motion_that_hits_both_walls_loses_its_symmetry() {
    let row = |omega: &f64| format!("{},0.01,{omega},0.001,PF,1,1-2\n", loss_of_symmetry(0.05, 0.8, *omega));
    let rows: String = [0.66, 0.68, 0.7, 0.72].iter().map(row).collect();
    let data = format!("A,A_error,omega,omega_error,seen,p,wall\n{rows}");
    let text = include_str!("../../../../examples/two-stops.toml");
    let folder = folder_with(&[("my.toml", text), ("seen.csv", &data)]);
    let run = grazing(
        folder.path(),
        &["identify", "my.toml", "--set", "r=0.79", "--data", "seen.csv", "--free", "r", "--output", "out"],
    );
    assert_eq!(run.code, Some(0), "{} {}", run.output, run.messages);
    let constants = read(folder.path(), "out/data/constants.csv");
    let found: f64 = column(&constants, "value")[0].parse().expect("a number");
    assert!((found - 0.8).abs() < 1e-6, "{constants}");
    let residuals = read(folder.path(), "out/data/residuals.csv");
    assert!(
        column(&residuals, "quantity").iter().all(|what| *what == "PF of p = 1 at both walls"),
        "{residuals}"
    );
    // Both walls are alike, and their resonance is listed once.
    assert_eq!(column(&read(folder.path(), "out/data/resonances.csv"), "wall"), ["1"]);
    assert!(words(&run.output).contains("p wall n omega A"), "{}", run.output);
}

#[test]
fn a_mass_between_walls_without_a_spring_is_unfolded_where_it_hits_both() {
    let pair = "name = \"Impact pair\"\nparameters = { r = 0.6 }\nprimary = { name = \"a\", range = [0.5, 1.0] }\n\
        secondary = { name = \"omega\", range = [1.0, 1.1] }\n\
        motion = { force = \"a*omega^2*cos(omega*t)\", frequency = \"omega\" }\n\
        impact = { restitution = \"r\", duration = \"0\" }\nanalysis = { loops = [1] }\n\
        [[walls]]\nposition = \"1\"\n[[walls]]\nposition = \"-1\"\n";
    let folder = folder_with(&[("my.toml", pair)]);
    let run = grazing(folder.path(), &["unfold", "my.toml", "--output", "out"]);
    assert_eq!(run.code, Some(0), "{} {}", run.output, run.messages);
    let curves = read(folder.path(), "out/data/sequence_curves.csv");
    let of_kind = column(&curves, "kind").into_iter().zip(column(&curves, "a"));
    let pitchforks: Vec<f64> =
        of_kind.filter(|(kind, _)| *kind == "PF").map(|(_, a)| a.parse().expect("a number")).collect();
    // Between walls the mass flies straight; with half the room and 1/omega as units its position without the forced part is phi y at an
    // impact of velocity y, and the forced velocity psi y. Over half a period the derivative in the mirror has the determinant r^2 and the
    // trace 2r + pi (1 + r) (1 - phi y)/y, which is -(1 + r^2) at the pitchfork.
    let r = 0.6_f64;
    let [phi, psi] = [0.25 * core::f64::consts::PI * (1.0 + r), 0.5 * (1.0 - r)];
    let flight = core::f64::consts::PI * (1.0 + r);
    let y = flight / (flight * phi - (1.0 + r) * (1.0 + r));
    let known = libm::hypot(1.0 - phi * y, psi * y);
    assert!(pitchforks.len() > 5, "{curves}");
    for a in pitchforks {
        assert!((a / known - 1.0).abs() < 1e-9, "{a} for {known}");
    }
}
