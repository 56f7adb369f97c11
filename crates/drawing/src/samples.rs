//! Rows as `figures/data/` has them, for the tests of figures whose labels have to find room in one particular picture.

use grazing_results::space::{CurveKind, Mark, MarkKind, SurfaceKind, Vertex};

use crate::scene::SpaceFigure;

/// The cells of a table.
pub(crate) fn written(name: &str) -> Vec<Vec<String>> {
    let path = format!("{}/../../figures/data/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

/// The number in a cell.
pub(crate) fn number(cell: &str) -> f64 {
    cell.parse().expect("it is a number")
}

/// The integer in a cell.
pub(crate) fn integer(cell: &str) -> u32 {
    cell.parse().expect("it is an integer")
}

/// The one of these whose word is in a cell.
pub(crate) fn known<K: Copy>(cell: &str, all: &[K], word: fn(K) -> &'static str) -> K {
    *all.iter().find(|known| word(**known) == cell).expect("the word is known")
}

/// The rows of a figure in phase space.
pub(crate) struct Scene {
    pub(crate) curves: Vec<Vertex<CurveKind>>,
    points: Vec<Mark>,
    surfaces: Vec<Vertex<SurfaceKind>>,
}

fn vertices<K: Copy>(name: &str, kinds: &[K], word: fn(K) -> &'static str) -> Vec<Vertex<K>> {
    let vertex = |row: &Vec<String>| Vertex {
        kind: known(&row[0], kinds, word),
        number: integer(&row[1]),
        piece: integer(&row[2]),
        layer: integer(&row[3]),
        state: std::array::from_fn(|k| number(&row[4 + k])),
        place: std::array::from_fn(|k| number(&row[7 + k])),
    };
    written(name).iter().map(vertex).collect()
}

impl Scene {
    pub(crate) fn of(figure: &str) -> Self {
        let mark = |row: &Vec<String>| {
            let kind = known(&row[0], MarkKind::ALL, MarkKind::name);
            let [x, y, z, across, up, depth] = std::array::from_fn(|place| number(&row[3 + place]));
            Mark { kind, number: integer(&row[1]), layer: integer(&row[2]), x, y, z, across, up, depth }
        };
        Scene {
            curves: vertices(&format!("{figure}_curves"), CurveKind::ALL, CurveKind::name),
            points: written(&format!("{figure}_points")).iter().map(mark).collect(),
            surfaces: vertices(&format!("{figure}_surfaces"), SurfaceKind::ALL, SurfaceKind::name),
        }
    }

    pub(crate) fn figure(&self) -> SpaceFigure<'_> {
        SpaceFigure { curves: &self.curves, points: &self.points, surfaces: &self.surfaces }
    }
}
