//! Resonances, coefficients and codimension-two points as constants of an oscillator vary.

use grazing_continuation::bifurcation::CodimensionTwo;
use serde::{Deserialize, Serialize};

use crate::resonance::{Coefficients, Measured, Quantities};
use crate::{Cell, Column, Dimension, Dimensioned, Frame, Row, VARIED, columns, rows, tables, words};

words! {
    /// How a resonance of a member was found.
    #[derive(Serialize, Deserialize)]
    FoundBy {
        /// By searching along the grazing curve of the member.
        Search = "search",
        /// By continuation from the previous member.
        Continuation = "continuation",
    }

    /// The consequences of a zero of a quantity in the hypotheses of Theorem 2.4 or 2.5.
    #[derive(Serialize, Deserialize)]
    Degeneracy {
        /// s_p⁺ is zero.
        InfiniteSaddleNode = "c_SN is infinite",
        /// s_p⁻ is zero.
        InfinitePeriodDoubling = "c_PD is infinite",
        /// β is zero.
        Infinite = "c_SN and c_PD are infinite",
        /// a₁₂' or κ_p' is zero: beyond this point the resonance does not exist.
        Meeting = "two resonances meet: c_SN and c_PD are zero",
        /// Another quantity is zero.
        NoTheorem = "the theorem ceases to hold",
    }
}

/// The values of the constants that vary, in the file's units; with fewer than three constants the first are NaN.
impl Row for [f64; VARIED] {
    const COLUMNS: &'static [Column] = &[columns::VARIED_1, columns::VARIED_2, columns::VARIED_3];

    fn cells(&self) -> Vec<Cell> {
        self.map(Cell::from).into()
    }
}

impl Dimensioned for [f64; VARIED] {
    fn each_number(&mut self, _: &mut dyn FnMut(Dimension, &mut f64)) {}
}

rows! {
    /// A member of a family.
    #[derive(Serialize, Deserialize)]
    Member {
        varied: [f64; VARIED],
        resonances: u32 = RESONANCES,
        points: u32 = POINTS,
        missing: String = MEMBER_REASON,
    }

    /// A resonance of a member.
    #[derive(Serialize, Deserialize)]
    FamilyResonance {
        varied: [f64; VARIED],
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        curve: u32 = FAMILY_CURVE,
        found_by: FoundBy = FOUND_BY,
        secondary: f64 = SECONDARY_AT_RESONANCE,
        primary: f64 = PRIMARY_AT_GRAZING,
        phase: f64 = GRAZING_PHASE,
        coefficients: Coefficients,
        measured: Measured,
        sn_verdict: String = SN_VERDICT,
        pd_verdict: String = PD_VERDICT,
        quantities: Quantities,
        pd_criticality: f64 = PD_CRITICALITY,
        holds: bool = THEOREM_HOLDS,
        failing: String = FAILING,
    }

    /// A codimension-two point of a member other than a resonance.
    #[derive(Serialize, Deserialize)]
    FamilyPoint {
        varied: [f64; VARIED],
        kind: CodimensionTwo = CODIMENSION_TWO,
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        impact_velocity: f64 = IMPACT_VELOCITY,
    }

    /// A resonance on its curve between one member and the next.
    #[derive(Serialize, Deserialize)]
    FamilyCurvePoint {
        varied: [f64; VARIED],
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        curve: u32 = FAMILY_CURVE,
        arc: u32 = ARC,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        coefficients: Coefficients,
        end: String = FAMILY_END,
    }

    /// A degenerate resonance between two members.
    #[derive(Serialize, Deserialize)]
    Degenerate {
        varied: [f64; VARIED],
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        curve: u32 = FAMILY_CURVE,
        quantity: String = DEGENERATE_QUANTITY,
        meaning: Degeneracy = DEGENERATE_MEANING,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
    }
}

/// A panel of the figure of a family, over the constant that varies first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FamilyPanel {
    /// Number of loops p.
    pub loops: u32,
    /// The quantity on the vertical axis.
    pub shows: Shows,
    /// The part of the plane.
    pub frame: Frame,
}

/// The quantity that a panel shows for resonances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shows {
    /// The secondary parameter at resonances and at other codimension-two points.
    Secondary,
    /// c_SN.
    SaddleNode,
    /// c_PD.
    PeriodDoubling,
}

tables! {
    /// All results for a family.
    Family {
        members: Member = "family_members", "a member of the family, with values of the constants that vary",
        resonances: FamilyResonance = "family_resonances", "a resonance of a member",
        points: FamilyPoint = "family_points", "a codimension-two point of a member that is not a resonance" as Points,
        curves: FamilyCurvePoint = "family_curves", "a resonance between one member and the next",
        degenerate: Degenerate = "family_degenerate", "a degenerate resonance between two members",
        ;
        /// The panels of the figure.
        panels: Vec<FamilyPanel>,
        /// The number of members with an object that was detected but could not be located or followed.
        incomplete: u32,
    }
}
