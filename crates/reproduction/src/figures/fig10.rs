//! Figure 10 (fig:I): the path of the proof of Theorem 2.3, Step 3.

mod ink;

use grazing_input::kind::{count, number};
use grazing_results::{rows, tables};
use grazing_theorems::auxiliary::lucas_sequence;
use grazing_theorems::{GenericGrazing, LinearOscillator};
use nalgebra::Vector2;

use crate::figure::prelude::*;
use crate::parameters::limits::{FREQUENCIES, FREQUENCY, MOST_LOOPS, grazing};

keys! {
    /// Figure 10: a generic grazing bifurcation to which Theorem 2.3 applies.
    pub struct Figure10 {
        /// The forcing frequency omega; the hypotheses of Theorem 2.3 hold at its grazing
        /// bifurcation.
        frequency: f64 = number(FREQUENCIES), FREQUENCY;
        /// The number of loops p.
        loops: u32 = count(3..=MOST_LOOPS), "the number of loops must be a whole number from {} to {}";
    }
}

rows! {
    /// A vertex of the path of Figure 10.
    Visit {
        visit: u32 = VISIT,
        u: f64 = U,
        w: f64 = W,
    }
}

tables! {
    /// The contents of Figure 10.
    VisitPath {
        /// The vertices are (u⁽ʲ⁾, w⁽ʲ⁾), j = 0, …, p.
        path: Visit = "fig10_path", "a vertex of the path",
    }
}

impl FileSection for Figure10 {
    const NAME: &'static str = "fig10";
    const REQUIREMENT: &'static str = "the table [fig10] says what Figure 10 shows";

    fn checked(self, section: &Section<'_>, parameters: &Parameters) -> Result<Self, ParameterError> {
        let (oscillator, &Self { frequency, loops }) = (parameters.oscillator()?, &self);
        let grazing = grazing(section, &oscillator, frequency)?;
        GenericGrazing::check(&grazing.grazing_point(), loops).map_err(|violated| {
            let remedy = remedy(&oscillator, frequency, loops);
            let allowed = format!("the path belongs to Theorem 2.3; {violated}; {remedy}");
            ParameterError::Unfit(section.forbid("frequency", allowed))
        })?;
        Ok(self)
    }
}

/// The ratio of consecutive frequencies at which the hypotheses of Theorem 2.3 are tried for a remedy.
const RATIO: f64 = 1.001;
/// The number of frequencies tried on either side: up to three times the frequency and down to a third of
/// it.
const TRIED: u32 = 1100;

/// A sentence about the nearest frequencies at which the hypotheses hold.
fn remedy(oscillator: &LinearOscillator, frequency: f64, loops: u32) -> String {
    let holds = |frequency: f64| {
        FREQUENCIES.contains(&frequency)
            && oscillator
                .grazing(frequency)
                .is_ok_and(|grazing| GenericGrazing::check(&grazing.grazing_point(), loops).is_ok())
    };
    let mut sides = [(RATIO, frequency), (1.0 / RATIO, frequency)];
    for _ in 0..TRIED {
        for (ratio, tried) in &mut sides {
            *tried *= *ratio;
            if holds(*tried) {
                let mut last = *tried;
                while holds(last * *ratio) && last < 3.0 * frequency && last > frequency / 3.0 {
                    last *= *ratio;
                }
                let [low, high] = [tried.min(last), tried.max(last)];
                return format!("they hold from {low:.5} to {high:.5}");
            }
        }
    }
    format!(
        "no frequency within a factor of three will do for fig10.loops = {loops}, choose another number there"
    )
}

impl StudyFigure for Figure10 {
    const LABEL: &'static str = "fig:I";
    const TITLE: Title<&'static str> = Title::figure(10, "the path of visits in the proof of Theorem 2.3");
    const TABLES: &'static [TablePlan] = VisitPath::TABLES;
    const REMEDY: &'static str = "fig10.frequency or fig10.loops";
    type Shown = VisitPath;

    /// The vertices as iterates of (0, −b₁ₚ / (a₁₂ β)) under the affine map Q(u, w) = A (u, w) +
    /// (S_p / β) b.
    ///
    /// Paper: eq:affineMap and the line after eq:affineMapj. The scaling S_p / β of eq:ujwj makes
    /// u⁽ʲ⁾ free of μ.
    fn compute(&self, study: &Study) -> Result<VisitPath, StudyError> {
        let map = study.parameters.oscillator()?.grazing(self.frequency)?.linearised_map();
        let (p, beta) = (self.loops, map.transversality());
        let drift = map.b * (lucas_sequence(p, map.trace(), map.determinant()) / beta);
        let mut vertex = Vector2::new(0.0, -map.iterate(p).b.x / (map.a.m12 * beta));
        let mut path = Vec::new();
        for visit in 0..=p {
            path.push(Visit { visit, u: vertex.x, w: vertex.y });
            vertex = map.a * vertex + drift;
        }
        Ok(VisitPath { path })
    }

    fn draw(shown: &VisitPath, width: SheetWidth) -> Result<Sheet, DrawingError> {
        ink::draw(shown, width)
    }
}
