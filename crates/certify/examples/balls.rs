//! Prints the results of ball operations for random and extreme arguments, for
//! `expected/certificate/test_balls.py` to test: a line for each, with the operation and middles and
//! radii in units of 2⁻⁸⁸, `-` for the ball of all numbers.
//!
//! `cargo run -p grazing-certify --example balls -- 1000000`

use std::io::{BufWriter, Write, stdout};

use grazing_certify::ball::{Ball, Number as _};

/// A pseudorandom sequence, the same on every run.
struct Random(u64);

impl Random {
    fn bits(&mut self, count: u32) -> i128 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i128::from(self.0 >> 11) & ((1 << count) - 1)
    }

    /// A random number of size 2⁻⁸⁸ to about 2²⁸, of either sign, often next to a multiple of 1/8.
    fn number(&mut self) -> Ball {
        let bits = self.bits(7).min(124) as u32;
        let digits = (self.bits(53) << 53 | self.bits(53)) << 18 >> (124 - bits);
        let units = match self.bits(3) {
            0 => (self.bits(9) << 85) + self.bits(2) - 1,
            1 => self.bits(5) << 85,
            _ => digits,
        };
        Ball::dyadic(if self.bits(1) == 0 { units } else { -units }, 88)
    }

    fn ball(&mut self) -> Ball {
        let middle = self.number();
        let radius = Ball::dyadic(self.bits(50) << 40 >> self.bits(7).min(100), 88);
        if self.bits(1) == 0 { middle } else { Ball::between(middle - radius, middle + radius) }
    }
}

fn shown(ball: Ball) -> String {
    ball.units().map_or_else(|| "-".to_owned(), |(middle, radius)| format!("{middle} {radius}"))
}

fn main() -> std::io::Result<()> {
    let count = std::env::args().nth(1).and_then(|count| count.parse().ok()).unwrap_or(1_000);
    let (mut random, mut out) = (Random(1), BufWriter::new(stdout().lock()));
    for k in 0..count {
        let (a, b) = (random.ball(), random.ball());
        let (sine, cosine) = a.turn();
        let (name, result) = match k % 8 {
            0 => ("sin", sine),
            1 => ("cos", cosine),
            2 => ("exp", a.exp()),
            3 => ("inverse", a.inverse()),
            4 => ("sqrt", a.sqrt()),
            5 => ("add", a + b),
            6 => ("sub", a - b),
            _ => ("mul", a * b),
        };
        writeln!(out, "{name};{};{};{}", shown(a), shown(b), shown(result))?;
    }
    out.flush()
}
