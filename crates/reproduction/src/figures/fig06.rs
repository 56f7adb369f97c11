//! Figure 6 (fig:F): the oscillator as a mechanical schematic, to scale along x.
//!
//! Along x the drawing follows eq:oscf: the wall is at x = 0, the equilibrium of the block's face at x =
//! −1, the face itself at x = φ_p(t), the non-impacting solution at the chosen phase; the force arrow is
//! proportional to 𝒜 cos(ωt). Lengths across x, in the same unit, are arbitrary.

mod ink;
mod shapes;

use core::f64::consts::TAU;

use grazing_input::kind::{count, number, positive};
use grazing_results::{rows, tables, words};

use crate::figure::prelude::*;
use crate::parameters::limits::{FREQUENCIES, FREQUENCY, grazing};
use crate::study::forced;

/// A polyline of points (x, height).
type Polyline = Vec<[f64; 2]>;

/// The arbitrary lengths of the drawing, in units of the distance between equilibrium and wall.
mod lengths {
    pub(super) const BLOCK_WIDTH: f64 = 0.9;
    pub(super) const BLOCK_BOTTOM: f64 = 0.14;
    pub(super) const BLOCK_TOP: f64 = 1.2;
    pub(super) const SPRING_HEIGHT: f64 = 0.92;
    pub(super) const SPRING_RADIUS: f64 = 0.15;
    pub(super) const DASHPOT_HEIGHT: f64 = 0.42;
    pub(super) const DASHPOT_RADIUS: f64 = 0.12;
    /// The length of straight wire at either end of the spring, and of the rod between anchor and
    /// cylinder.
    pub(super) const LEAD: f64 = 0.3;
    /// The distance between the piston at the ends of its stroke and the ends of the cylinder.
    pub(super) const CLEARANCE: f64 = 0.15;
    pub(super) const FORCE_HEIGHT: f64 = 0.92;
    /// The length of the arrow of the force 𝒜.
    pub(super) const FULL_FORCE: f64 = 0.85;
    pub(super) const DIMENSION_HEIGHT: f64 = 0.32;
    pub(super) const EQUILIBRIUM_TOP: f64 = 0.56;
    pub(super) const WALL_TOP: f64 = 1.45;
    pub(super) const STRIP: f64 = 0.2;
    pub(super) const AXIS_HEIGHT: f64 = -0.34;
    pub(super) const TICK: f64 = 0.07;
    pub(super) const AXIS_BEYOND_WALL: f64 = 0.42;
}

/// The greatest number of coils of Figure 6's spring that can be distinguished in print.
const MOST_COILS: u32 = 30;

keys! {
    /// Figure 6: the oscillator in its non-impacting motion at one phase.
    pub struct Figure6 {
        /// The forcing frequency omega.
        frequency: f64 = number(FREQUENCIES), FREQUENCY;
        /// The forcing amplitude, below grazing: the motion does not reach the wall.
        amplitude: f64 = positive(),
            "the forcing amplitude must lie above 0 and below the grazing amplitude of fig06.frequency";
        /// The forcing phase z in radians.
        phase: f64 = number(0.0..TAU), "the phase must be a number from 0 to below 2 pi";
        /// The coils of the spring.
        coils: u32 = count(1..=MOST_COILS), "the number of coils must be a whole number from {} to {}";
    }
}

words! {
    /// The parts of the drawing of the oscillator.
    Part {
        /// The hatching behind the anchor.
        AnchorHatching = "anchor hatching",
        /// The line to which spring and dashpot are attached.
        Anchor = "anchor",
        /// The hatching behind the wall.
        WallHatching = "wall hatching",
        Wall = "wall",
        Floor = "floor",
        /// Lines from the block, the equilibrium and the wall to the axis of x.
        Guide = "guide",
        Axis = "axis",
        Tick = "tick",
        Spring = "spring",
        /// The cylinder of the dashpot, to which rods and piston belong as well.
        Cylinder = "cylinder",
        Rod = "rod",
        Piston = "piston",
        Wheel = "wheel",
        Block = "block",
        /// The arrow of the force.
        Force = "force",
        /// The distance between equilibrium and wall.
        Dimension = "dimension",
    }
}

rows! {
    /// A point of the drawing of the oscillator.
    PartPoint {
        part: Part = PART,
        piece: u32 = PIECE,
        x: f64 = X,
        height: f64 = HEIGHT,
    }
}

tables! {
    /// The contents of Figure 6.
    Schematic {
        /// The parts of the drawing are polylines of (x, height); outlines end where they begin. The
        /// ticks are those of the face, the equilibrium and the wall.
        parts: PartPoint = "fig06_parts", "a point of the drawing",
    }
}

impl FileSection for Figure6 {
    const NAME: &'static str = "fig06";
    const REQUIREMENT: &'static str = "the table [fig06] says what Figure 6 shows";

    fn checked(self, section: &Section<'_>, parameters: &Parameters) -> Result<Self, ParameterError> {
        let frequency = self.frequency;
        let grazing = grazing(section, &parameters.oscillator()?, frequency)?.amplitude();
        if self.amplitude < grazing {
            return Ok(self);
        }
        let allowed = format!(
            "the amplitude must lie above 0 and below the grazing amplitude {grazing:.5} of the frequency {frequency}"
        );
        Err(ParameterError::Unfit(section.forbid("amplitude", allowed)))
    }
}

impl StudyFigure for Figure6 {
    const LABEL: &'static str = "fig:F";
    const TITLE: Title<&'static str> = Title::figure(6, "the impact oscillator");
    const TABLES: &'static [TablePlan] = Schematic::TABLES;
    const REMEDY: &'static str = "fig06.frequency or fig06.amplitude";
    type Shown = Schematic;

    fn compute(&self, study: &Study) -> Result<Schematic, StudyError> {
        let theory = study.parameters.oscillator()?;
        let oscillator = forced(&theory, self.amplitude, self.frequency)?;
        let face = oscillator.non_impacting_solution(self.phase).position;
        // φ_p is harmonic about −1 and reaches 0 at the grazing amplitude.
        let stroke = self.amplitude / theory.grazing(self.frequency)?.amplitude();
        let mut parts = Vec::new();
        for (part, pieces) in pieces(face, stroke, libm::cos(self.phase), self.coils) {
            for (piece, points) in (1..).zip(&pieces) {
                parts.extend(points.iter().map(|&[x, height]| PartPoint { part, piece, x, height }));
            }
        }
        Ok(Schematic { parts })
    }

    fn draw(shown: &Schematic, width: SheetWidth) -> Result<Sheet, DrawingError> {
        ink::draw(shown, width)
    }
}

/// All parts as polylines, from the position of the block's face, the largest displacement of the motion
/// from x = −1, and the force relative to its amplitude. Later parts cover earlier ones.
fn pieces(face: f64, stroke: f64, force: f64, coils: u32) -> Vec<(Part, Vec<Polyline>)> {
    use lengths::*;
    const EQUILIBRIUM: f64 = -1.0;
    const WALL: f64 = 0.0;
    let back = face - BLOCK_WIDTH;
    // The rod is just long enough for the block to clear the cylinder during its whole stroke.
    let rod = 2.0 * (stroke + CLEARANCE);
    let piston = back - rod;
    let middle = EQUILIBRIUM - BLOCK_WIDTH - rod;
    let (bottom_of_cylinder, mouth) = (middle - stroke - CLEARANCE, middle + stroke + CLEARANCE);
    let anchor = bottom_of_cylinder - LEAD;
    let vertical = |x: f64, from: f64, to: f64| vec![[x, from], [x, to]];
    let horizontal = |height: f64, from: f64, to: f64| vec![[from, height], [to, height]];
    let tick = |x: f64| vertical(x, AXIS_HEIGHT, AXIS_HEIGHT + TICK);
    let wheels = [0.22, 0.78]
        .map(|share| shapes::circle([back + share * BLOCK_WIDTH, 0.5 * BLOCK_BOTTOM], 0.5 * BLOCK_BOTTOM));
    vec![
        (Part::AnchorHatching, shapes::hatching([anchor - STRIP, anchor], [0.0, WALL_TOP])),
        (Part::Anchor, vec![vertical(anchor, 0.0, WALL_TOP)]),
        (Part::WallHatching, shapes::hatching([WALL, WALL + STRIP], [0.0, WALL_TOP])),
        (Part::Wall, vec![vertical(WALL, 0.0, WALL_TOP)]),
        (Part::Floor, vec![horizontal(0.0, anchor, WALL)]),
        (
            Part::Guide,
            vec![
                vertical(face, BLOCK_BOTTOM, AXIS_HEIGHT),
                vertical(WALL, 0.0, AXIS_HEIGHT),
                vertical(EQUILIBRIUM, EQUILIBRIUM_TOP, AXIS_HEIGHT),
            ],
        ),
        (Part::Axis, vec![horizontal(AXIS_HEIGHT, back, WALL + AXIS_BEYOND_WALL)]),
        (Part::Tick, vec![tick(face), tick(EQUILIBRIUM), tick(WALL)]),
        (Part::Spring, vec![shapes::spring([anchor, back], SPRING_HEIGHT, SPRING_RADIUS, LEAD, coils)]),
        (
            Part::Cylinder,
            vec![vec![
                [mouth, DASHPOT_HEIGHT + DASHPOT_RADIUS],
                [bottom_of_cylinder, DASHPOT_HEIGHT + DASHPOT_RADIUS],
                [bottom_of_cylinder, DASHPOT_HEIGHT - DASHPOT_RADIUS],
                [mouth, DASHPOT_HEIGHT - DASHPOT_RADIUS],
            ]],
        ),
        (
            Part::Rod,
            vec![
                horizontal(DASHPOT_HEIGHT, anchor, bottom_of_cylinder),
                horizontal(DASHPOT_HEIGHT, piston, back),
            ],
        ),
        (
            Part::Piston,
            vec![vertical(
                piston,
                DASHPOT_HEIGHT - 0.8 * DASHPOT_RADIUS,
                DASHPOT_HEIGHT + 0.8 * DASHPOT_RADIUS,
            )],
        ),
        (Part::Wheel, wheels.into()),
        (Part::Block, vec![shapes::rectangle([back, face], [BLOCK_BOTTOM, BLOCK_TOP])]),
        (Part::Force, vec![horizontal(FORCE_HEIGHT, face, face + FULL_FORCE * force)]),
        (Part::Dimension, vec![horizontal(DIMENSION_HEIGHT, EQUILIBRIUM, WALL)]),
    ]
}
