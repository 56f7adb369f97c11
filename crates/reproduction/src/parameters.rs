//! The parameters of the figures: a TOML file in, a checked value out.
//!
//! [`Parameters`] can be made from a file only, and only from one that passed every check, so whoever holds it need
//! not ask again. `figures/parameters.toml` is the file of the paper's figures; nothing has a hidden default.
//! All quantities are dimensionless.

mod fig04;
mod fig05;
mod fig06;
mod fig10;
mod range;
mod raw;
mod requirements;
mod space;
mod validate;

use std::path::Path;

pub use fig04::Figure4;
pub use fig05::Figure5;
pub use fig06::Figure6;
pub use fig10::Figure10;
/// The first thing in a parameter file that is not right, and what would be.
pub use grazing_source::SourceError as ParameterError;
pub use range::{Range, Rectangle};
pub use space::{Arrival, Figure1, Figure3, Figure9, Specimen, View};

/// Everything that the figures and the table depend on, checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameters {
    zeta: f64,
    epsilon: f64,
    fig01: Figure1,
    fig02: Figure2,
    fig03: Figure3,
    fig04: Figure4,
    fig05: Figure5,
    fig06: Figure6,
    fig07: Figure7,
    fig08: Figure8,
    fig09: Figure9,
    fig10: Figure10,
}

impl Parameters {
    /// Reads and checks a parameter file; its path appears in messages as it is given here.
    ///
    /// # Errors
    /// [`ParameterError`], the first thing in the file that is not right, with its line.
    pub fn from_file(path: &Path) -> Result<Parameters, ParameterError> {
        let file = path.display().to_string();
        match std::fs::read_to_string(path) {
            Ok(text) => Parameters::parse(&text, &file),
            Err(reason) => Err(ParameterError::Unreadable { file, reason: reason.to_string() }),
        }
    }

    /// Checks the text of a parameter file; `file` is the name that messages use.
    ///
    /// # Errors
    /// [`ParameterError`], the first thing in the text that is not right, with its line.
    pub fn parse(text: &str, file: &str) -> Result<Parameters, ParameterError> {
        let source = grazing_source::Source::new(text, file, requirements::REQUIREMENTS);
        validate::parameters(source.read()?, &source)
    }

    /// The damping ratio zeta of eq:oscf, in (0, 1).
    pub fn zeta(&self) -> f64 {
        self.zeta
    }

    /// The coefficient of restitution epsilon of eq:oscResetLaw, in (0, 1].
    pub fn epsilon(&self) -> f64 {
        self.epsilon
    }

    /// What Figure 1 (fig:Bc) shows.
    pub fn fig01(&self) -> &Figure1 {
        &self.fig01
    }

    /// What Figure 2 (fig:Z) shows.
    pub fn fig02(&self) -> &Figure2 {
        &self.fig02
    }

    /// What Figure 3 (fig:Ba) shows.
    pub fn fig03(&self) -> &Figure3 {
        &self.fig03
    }

    /// What Figure 4 (fig:D) shows.
    pub fn fig04(&self) -> &Figure4 {
        &self.fig04
    }

    /// What Figure 5 (fig:E) shows.
    pub fn fig05(&self) -> &Figure5 {
        &self.fig05
    }

    /// What Figure 6 (fig:F) shows.
    pub fn fig06(&self) -> &Figure6 {
        &self.fig06
    }

    /// What Figure 7 (fig:G) shows.
    pub fn fig07(&self) -> &Figure7 {
        &self.fig07
    }

    /// What Figure 8 (fig:Y) shows.
    pub fn fig08(&self) -> &Figure8 {
        &self.fig08
    }

    /// What Figure 9 (fig:Bb) shows.
    pub fn fig09(&self) -> &Figure9 {
        &self.fig09
    }

    /// What Figure 10 (fig:I) shows.
    pub fn fig10(&self) -> &Figure10 {
        &self.fig10
    }
}

/// Figure 2: one frequency, the amplitude across, x on Pi up.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure2 {
    frequency: f64,
    amplitude: Range,
    x: Range,
    loops: Vec<u32>,
    magnified_amplitude: Range,
    magnified_x: Range,
    attractor: Attractor,
    portraits: Vec<Portrait>,
}

impl Figure2 {
    /// The forcing frequency omega, positive.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// The forcing amplitudes across; A_graz of the frequency lies strictly inside.
    pub fn amplitude(&self) -> Range {
        self.amplitude
    }

    /// The x-values up.
    pub fn x(&self) -> Range {
        self.x
    }

    /// The numbers of loops p that are followed: at least one, each 1 or more, none twice, as ordered in the file.
    pub fn loops(&self) -> &[u32] {
        &self.loops
    }

    /// The amplitudes of the magnification, inside [`Figure2::amplitude`].
    pub fn magnified_amplitude(&self) -> Range {
        self.magnified_amplitude
    }

    /// The x-values of the magnification, inside [`Figure2::x`].
    pub fn magnified_x(&self) -> Range {
        self.magnified_x
    }

    /// How the long-time behaviour between GZ and PD is sampled.
    pub fn attractor(&self) -> &Attractor {
        &self.attractor
    }

    /// The phase portraits from left to right.
    pub fn portraits(&self) -> &[Portrait] {
        &self.portraits
    }
}

/// How many orbits of Figure 2 run for how long between GZ and PD.
#[derive(Debug, Clone, PartialEq)]
pub struct Attractor {
    amplitudes: u32,
    orbits: u32,
    transient: u32,
    recorded: u32,
    seed: u64,
}

impl Attractor {
    /// The number of amplitudes, evenly spaced between GZ and PD, at least 2.
    pub fn amplitudes(&self) -> u32 {
        self.amplitudes
    }

    /// The orbits at each amplitude, from random initial points, at least 1.
    pub fn orbits(&self) -> u32 {
        self.orbits
    }

    /// The forcing periods before an orbit is recorded; may be 0.
    pub fn transient(&self) -> u32 {
        self.transient
    }

    /// The forcing periods for which an orbit is recorded, at least 1.
    pub fn recorded(&self) -> u32 {
        self.recorded
    }

    /// The seed of the random initial points.
    pub fn seed(&self) -> u64 {
        self.seed
    }
}

/// One phase portrait above Figure 2.
#[derive(Debug, Clone, PartialEq)]
pub struct Portrait {
    loops: u32,
    amplitude: f64,
}

impl Portrait {
    /// The loops p of the maximal periodic solution, one of [`Figure2::loops`]; 0 is the non-impacting solution.
    pub fn loops(&self) -> u32 {
        self.loops
    }

    /// The forcing amplitude, inside [`Figure2::amplitude`].
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }
}

/// Figure 7: the forcing amplitude across, the forcing frequency up.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure7 {
    window: Rectangle,
    loops: Vec<u32>,
}

impl Figure7 {
    /// The forcing amplitudes across (from 0 or more) and frequencies up (from above 0).
    pub fn window(&self) -> Rectangle {
        self.window
    }

    /// The numbers of loops p: at least one, none twice, each with a resonance inside the window, as ordered in the file.
    pub fn loops(&self) -> &[u32] {
        &self.loops
    }
}

/// Figure 8: magnifications of Figure 7.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure8 {
    panels: Vec<Panel>,
}

impl Figure8 {
    /// The three panels from left to right.
    pub fn panels(&self) -> &[Panel] {
        &self.panels
    }
}

/// One magnification around a resonance.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    loops: u32,
    n: u32,
    window: Rectangle,
}

impl Panel {
    /// The loops p of the resonance, one of [`Figure7::loops`].
    pub fn loops(&self) -> u32 {
        self.loops
    }

    /// The integer n of the resonance (eq:resonance1 for p = 1, eq:resonancep with the plus sign for p >= 2).
    pub fn n(&self) -> u32 {
        self.n
    }

    /// The amplitudes across and frequencies up: inside the window of Figure 7, with the resonance inside.
    pub fn window(&self) -> Rectangle {
        self.window
    }
}
