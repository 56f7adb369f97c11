//! Resonances, coefficients and codimension-two points as constants of an oscillator vary.

use grazing_continuation::bifurcation::CodimensionTwo;
use serde::{Deserialize, Serialize};

use crate::table::Row;
use crate::{Cell, Column, Dimension, Dimensioned, Field, Frame, VARIED, columns, tables, words};

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

/// Row types of members, which begin with the values of the constants that vary.
macro_rules! of_members {
    ($($(#[$meta:meta])* $row:ident { $($field:ident: $type:ty = $column:ident,)* })+) => {$(
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        pub struct $row {
            /// The values of the constants that vary; with fewer than three constants the first entries
            /// are NaN.
            pub varied: [f64; VARIED],
            $(
                #[doc = concat!("[`", stringify!($column), "`](columns::", stringify!($column), ")")]
                pub $field: $type,
            )*
        }

        impl Row for $row {
            const COLUMNS: &'static [Column] =
                &[columns::VARIED_1, columns::VARIED_2, columns::VARIED_3, $(columns::$column,)*];

            fn cells(&self) -> Vec<Cell> {
                let mut cells = Vec::from(self.varied.map(Cell::from));
                cells.extend([$(Cell::from(self.$field.clone()),)*]);
                cells
            }
        }

        /// The constants that vary are in the file's units.
        impl Dimensioned for $row {
            fn each_number(&mut self, visit: &mut dyn FnMut(Dimension, &mut f64)) {
                $(self.$field.number(&mut |number| visit(columns::$column.dimension, number));)*
            }
        }
    )+};
}

of_members! {
    /// A member of a family.
    Member {
        resonances: u32 = RESONANCES,
        points: u32 = POINTS,
        missing: String = MEMBER_REASON,
    }

    /// A resonance of a member.
    Resonance {
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        curve: u32 = FAMILY_CURVE,
        found_by: FoundBy = FOUND_BY,
        secondary: f64 = SECONDARY_AT_RESONANCE,
        primary: f64 = PRIMARY_AT_GRAZING,
        phase: f64 = GRAZING_PHASE,
        s_plus: f64 = S_PLUS,
        s_minus: f64 = S_MINUS,
        c_sn: f64 = C_SN,
        c_pd: f64 = C_PD,
        c_sn_error: f64 = C_SN_ERROR,
        c_pd_error: f64 = C_PD_ERROR,
        c_sn_fit: f64 = C_SN_FIT,
        c_pd_fit: f64 = C_PD_FIT,
        sn_verdict: String = SN_VERDICT,
        pd_verdict: String = PD_VERDICT,
        tau: f64 = TAU,
        delta: f64 = DELTA,
        alpha: f64 = ALPHA,
        beta: f64 = BETA,
        gamma: f64 = GAMMA,
        xi: f64 = XI,
        a12_prime: f64 = A12_PRIME,
        kappa_prime: f64 = KAPPA_PRIME,
        pd_criticality: f64 = PD_CRITICALITY,
        holds: bool = THEOREM_HOLDS,
        failing: String = FAILING,
    }

    /// A codimension-two point of a member other than a resonance.
    Point {
        kind: CodimensionTwo = CODIMENSION_TWO,
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        impact_velocity: f64 = IMPACT_VELOCITY,
    }

    /// A resonance on its curve between one member and the next.
    CurvePoint {
        loops: u32 = LOOPS,
        wall: u32 = WALL,
        n: u32 = RESONANCE_INDEX,
        curve: u32 = FAMILY_CURVE,
        arc: u32 = ARC,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        s_plus: f64 = S_PLUS,
        s_minus: f64 = S_MINUS,
        c_sn: f64 = C_SN,
        c_pd: f64 = C_PD,
        end: String = FAMILY_END,
    }

    /// A degenerate resonance between two members.
    Degenerate {
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
pub struct Panel {
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
        resonances: Resonance = "family_resonances", "a resonance of a member",
        points: Point = "family_points", "a codimension-two point of a member that is not a resonance",
        curves: CurvePoint = "family_curves", "a resonance between one member and the next",
        degenerate: Degenerate = "family_degenerate", "a degenerate resonance between two members",
        ;
        /// The panels of the figure.
        panels: Vec<Panel>,
        /// The number of members with an object that was detected but could not be located or followed.
        incomplete: u32,
    }
}
