//! Colours of different meanings can be distinguished.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_results::kinds::{Colour, CurveLook, IRREGULAR, LOOPS, OWN, PERIODIC, PLACE, SEVERAL};

/// Linear maps of red, green and blue that simulate missing one kind of cones, at full severity
/// (Machado, Oliveira and Fernandes 2009); the first is normal vision.
const EYES: [[[f64; 3]; 3]; 4] = [
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
    [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
];

/// The colour in CIE L*a*b*, after one of these maps of vision.
fn seen(colour: Colour, eyes: &[[f64; 3]; 3]) -> [f64; 3] {
    let linear = colour.map(|channel| {
        let share = f64::from(channel) / 255.0;
        if share <= 0.04045 { share / 12.92 } else { libm::pow((share + 0.055) / 1.055, 2.4) }
    });
    let product = |row: &[f64; 3], vector: [f64; 3]| -> f64 { (0..3).map(|k| row[k] * vector[k]).sum() };
    let [r, g, b] = [0, 1, 2].map(|k| product(&eyes[k], linear).clamp(0.0, 1.0));
    let white = [0.9505, 1.0, 1.089];
    let rows = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]];
    let [x, y, z] = [0, 1, 2].map(|k| {
        let share = product(&rows[k], [r, g, b]) / white[k];
        if share > 0.008856 { libm::cbrt(share) } else { 7.787 * share + 16.0 / 116.0 }
    });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// The least admitted difference: below about 2, colours are hardly distinguishable side by side, and
/// thin lines need more.
const APART: f64 = 14.0;

#[test]
fn no_two_meanings_look_alike_to_eyes_of_any_kind() {
    let curves = Bifurcation::ALL.map(|kind| (kind.name(), CurveLook::of(kind).colours));
    let loops = ["no impacts", "p = 1", "p = 2", "p = 3", "p = 4 and more"].into_iter().zip(LOOPS);
    let others = [
        ("several impacts", SEVERAL),
        ("other periodic", PERIODIC),
        ("irregular", IRREGULAR),
        ("place", PLACE),
        ("own", OWN),
    ];
    let all: Vec<_> = curves.into_iter().chain(loops).chain(others).collect();
    for (ground, eyes) in [0, 1].into_iter().flat_map(|ground| EYES.iter().map(move |eyes| (ground, eyes))) {
        for (k, (one, colours)) in all.iter().enumerate() {
            let here = seen(colours[ground], eyes);
            for (other, theirs) in &all[..k] {
                let there = seen(theirs[ground], eyes);
                let square: f64 = (0..3).map(|k| (here[k] - there[k]) * (here[k] - there[k])).sum();
                assert!(square.sqrt() >= APART, "{one} and {other} on ground {ground}: {}", square.sqrt());
            }
        }
    }
}
