//! Scenes in phase space, with the projected coordinates and the order of painting.

use crate::columns::{self, Column};
use crate::{Cell, Row, rows, tables, words};

words! {
    /// The kinds of curves in phase space.
    CurveKind {
        Orbit = "orbit",
        /// An orbit continued beyond the wall.
        Virtual = "virtual",
        /// The grazing periodic solution Γ.
        Periodic = "periodic",
        /// The reset law R, from impact to recoil.
        Reset = "reset",
        /// P_global: a line that joins a point and its image.
        Global = "global",
    }

    /// The kinds of surfaces in phase space, and of lines on them.
    SurfaceKind {
        /// The part of Σ where orbits arrive.
        Incoming = "incoming",
        /// The part of Σ where orbits leave.
        Outgoing = "outgoing",
        /// The Poincaré section Π.
        Section = "section",
        /// The line y = 0 of Σ.
        Tangency = "tangency",
        /// The circle x = y = 0 where the phase is an angle.
        Circle = "circle",
        AxisX = "x_axis",
        AxisY = "y_axis",
        AxisZ = "z_axis",
    }

    /// The kinds of points in phase space.
    MarkKind {
        /// An arrival at Σ.
        Impact = "impact",
        /// The image of an impact under the reset law.
        Recoil = "recoil",
        Graze = "graze",
        /// The virtual turning point (x̂, 0, ẑ).
        Virtual = "virtual",
        /// A visit to Π.
        Section = "section",
    }
}

/// The kinds of objects that consist of polylines.
pub trait PolylineKind: Copy + Into<Cell> {
    /// The column that holds the kind.
    const COLUMN: Column;
}

impl PolylineKind for CurveKind {
    const COLUMN: Column = columns::SPACE_CURVE;
}

impl PolylineKind for SurfaceKind {
    const COLUMN: Column = columns::SPACE_SURFACE;
}

/// A vertex of a curve, or of the outline of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Vertex<K> {
    /// The kind of the curve or surface.
    pub kind: K,
    /// [`NUMBER`](columns::NUMBER)
    pub number: u32,
    /// [`PIECE`](columns::PIECE)
    pub piece: u32,
    /// [`LAYER`](columns::LAYER)
    pub layer: u32,
    /// The state (x, y, z).
    pub state: [f64; 3],
    /// The projected coordinates: to the right, upwards, away from the viewer.
    pub place: [f64; 3],
}

impl<K: PolylineKind> Row for Vertex<K> {
    const COLUMNS: &'static [Column] = &[
        K::COLUMN,
        columns::NUMBER,
        columns::PIECE,
        columns::LAYER,
        columns::X,
        columns::Y,
        columns::Z,
        columns::ACROSS,
        columns::UP,
        columns::DEPTH,
    ];

    fn cells(&self) -> Vec<Cell> {
        let indices = [self.number, self.piece, self.layer].map(Cell::from);
        let numbers = self.state.into_iter().chain(self.place).map(Cell::from);
        std::iter::once(self.kind.into()).chain(indices).chain(numbers).collect()
    }
}

rows! {
    /// A named point.
    Mark {
        kind: MarkKind = SPACE_MARK,
        number: u32 = NUMBER,
        layer: u32 = LAYER,
        x: f64 = X,
        y: f64 = Y,
        z: f64 = Z,
        across: f64 = ACROSS,
        up: f64 = UP,
        depth: f64 = DEPTH,
    }
}

tables! {
    /// The contents of a figure in phase space: Figures 1, 3 and 9.
    Scene {
        /// The curves are orbits, and lines that join points. Consecutive vertices with equal number and
        /// piece form one polyline.
        curves: Vertex<CurveKind> = "curves", "a vertex of a curve",
        /// The points have names in the figure.
        points: Mark = "points", "a point that is marked" as Points,
        /// The polylines are closed outlines of surfaces, lines on them, and the axes.
        surfaces: Vertex<SurfaceKind> = "surfaces", "a vertex of the outline of a surface, or of a line on one",
    }
}
