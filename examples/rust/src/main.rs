//! A beam attracted by a magnet beyond a wall: an oscillator written in Rust, analysed with the
//! crates as a library.
//!
//! `cargo run -p grazing-example` prints its resonances with the coefficients of the
//! curves that leave them.
#![expect(clippy::print_stdout, reason = "a program's output")]

use grazing_continuation::curve::Window;
use grazing_model::smooth::{Integrated, Scalar, SmoothOscillator};
use grazing_model::{AnyOscillator, ImpactOscillator};
use grazing_unfold::{Diagram, Scope, UnfoldError, progress::Silent};

/// A beam bent by a magnet of strength `pull` at a distance of two units beyond the wall, which
/// softens its spring.
#[derive(Clone)]
struct Beam {
    damping: f64,
    pull: f64,
}

impl SmoothOscillator for Beam {
    fn force<S: Scalar>(&self, x: S, v: S, t: S, amplitude: S, omega: S) -> S {
        let to_magnet = x * -1.0 + 2.0;
        let magnet = S::constant(self.pull) / (to_magnet * to_magnet);
        amplitude * (omega * t).cos() - v * self.damping - x - 1.0 + magnet
    }

    fn forcing_frequency<S: Scalar>(&self, _: S, omega: S) -> S {
        omega
    }

    /// Faster impacts lose more.
    fn restitution<S: Scalar>(&self, y: S, _: S, _: S, _: S) -> S {
        S::constant(0.9) / (y * 0.1 + 1.0)
    }

    fn impact_duration<S: Scalar>(&self, _: S, _: S, _: S, _: S) -> S {
        S::constant(0.0)
    }
}

/// The diagram for amplitudes up to 1.2 and frequencies from 0.6 to 0.95.
fn diagram(loops: &[u32]) -> Result<Diagram, UnfoldError> {
    let window = Window { primary: [0.0, 1.2], secondary: [0.6, 0.95] };
    let scope = Scope { window, loops: loops.to_vec(), start: None };
    let beam = Integrated::new(Beam { damping: 0.04, pull: 0.3 }, [0.0, 0.6]);
    Diagram::compute(&AnyOscillator::new(beam), &scope, &Silent)
}

fn main() -> Result<(), UnfoldError> {
    let diagram = diagram(&[1, 2])?;
    println!("p  n  omega     A         c_SN       c_PD");
    for (resonance, point) in diagram.unfolding() {
        let theorem = point.theorem();
        let [amplitude, omega] = resonance.located.orbit().oscillator().parameters();
        println!(
            "{}  {}  {omega:.6}  {amplitude:.6}  {:9.5}  {:9.5}",
            resonance.loops,
            resonance.n,
            theorem.saddle_node().coefficient,
            theorem.period_doubling().coefficient,
        );
    }
    println!("{} curves, {} regions", diagram.curves.len(), diagram.regions.len());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_beam_has_a_resonance_with_all_its_curves() {
        let diagram = diagram(&[1]).expect("it grazes");
        assert_eq!(diagram.unfolding().count(), 1);
        assert!(diagram.not_unfolded.is_empty() && diagram.curves.len() >= 3, "{}", diagram.curves.len());
    }
}
