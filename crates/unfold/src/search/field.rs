//! Cells of a lattice in which functions of two variables may vanish.

use std::collections::HashMap;

use grazing_continuation::mps::Unknowns;
use grazing_results::span;
use nalgebra::Vector3;

/// Number of times that a cell is divided where a function may vanish at all, and the largest number
/// of times after that, where it is bent.
const COARSE: u32 = 2;
const PARTINGS: u32 = 3;
/// Length of the sides of a cell that is divided no further, in the coordinates of a lattice: even,
/// so that its middle has coordinates as well.
const FINEST: u32 = 2;
/// A function may vanish in a large cell if it is this many times as far from zero as it is bent.
const BENT: f64 = 2.0;
/// Deviation of a function from a straight line between corners, as a fraction of its range there,
/// above which a cell is divided (empirical), since the function may vanish twice in between.
const STRAIGHT: f64 = 0.25;
/// Slope of a function above which a cell is not divided, in any window (empirical): the more
/// sensitive motion is, the fewer stable solutions there are, and the more expensive the search.
const VIOLENT: f64 = 100.0;
/// Length of the sides of the cells in which the search begins, in the coordinates of a lattice.
pub(super) const SIZE: u32 = FINEST << (COARSE + PARTINGS);

/// What vanishes at a solution: the distance by which motion misses its beginning, and the energy that is
/// gained on the way, as far as it is known. The energy adds nothing, but fast motion, which turns round
/// in the plane of the first two many times in a cell, gains and loses little.
pub(super) type Missed = Vector3<f64>;

/// Functions on a lattice whose points have integer coordinates, with the values that are known.
pub(super) struct LatticeFunctions<P, V, I> {
    /// The point with these coordinates.
    place: P,
    /// The second coordinate after a turn, where all functions are as they were.
    turn: u32,
    values: V,
    is_idle: I,
    known: HashMap<[u32; 2], Vec<Option<Missed>>>,
    functions: usize,
    /// Cells with zeros.
    found: Vec<(usize, [Unknowns; 2])>,
}

impl<P, V, I> LatticeFunctions<P, V, I>
where
    P: Fn([u32; 2]) -> Unknowns,
    V: Fn(&Unknowns, &[usize]) -> Vec<Missed>,
    I: Fn(&[Unknowns; 2], &[Missed; 4]) -> bool,
{
    /// A field of so many functions, in which nothing is known yet.
    ///
    /// `values` are those of the functions with some indices at a point, and `is_idle` says of the
    /// values at the corners of a cell that no zero in it matters.
    pub(super) fn new(place: P, turn: u32, functions: usize, values: V, is_idle: I) -> Self {
        Self { place, turn, values, is_idle, known: HashMap::new(), functions, found: Vec::new() }
    }

    /// Cells that, as far as the lattice shows, contain a zero of one of the functions, among so many cells
    /// along both sides: the index of the function, the first corner and the sides of each.
    pub(super) fn cells(mut self, [rows, columns]: [u32; 2]) -> Vec<(usize, [Unknowns; 2])> {
        for (i, k) in (0..rows).flat_map(|i| (0..columns).map(move |k| (i, k))) {
            self.search([i * SIZE, k * SIZE], SIZE, &(0..self.functions).collect::<Vec<_>>());
        }
        self.found.sort_by_key(|(index, _)| *index);
        self.found
    }

    /// Computes some of the functions at a point.
    fn know(&mut self, [i, k]: [u32; 2], functions: &[usize]) {
        let at = [i, k % self.turn];
        let known = self.known.entry(at).or_insert_with(|| vec![None; self.functions]);
        let missing: Vec<usize> = functions.iter().copied().filter(|index| known[*index].is_none()).collect();
        if !missing.is_empty() {
            let values = (self.values)(&(self.place)(at), &missing);
            missing.into_iter().zip(values).for_each(|(index, value)| known[index] = Some(value));
        }
    }

    fn value(&self, [i, k]: [u32; 2], index: usize) -> Missed {
        let known = self.known.get(&[i, k % self.turn]).and_then(|known| known[index]);
        known.unwrap_or_else(|| Missed::repeat(f64::NAN))
    }

    /// Adds the cells inside a cell that contain zeros of some of the functions.
    ///
    /// In such a cell both components change sign between the corners. A large cell is divided into
    /// four where a function may vanish, a small one where it may change sign twice between corners.
    fn search(&mut self, at @ [i, k]: [u32; 2], size: u32, functions: &[usize]) {
        let half = size / 2;
        let is_large = size > FINEST << PARTINGS;
        let corners = [[i, k], [i, k + size], [i + size, k], [i + size, k + size]];
        let middle = [i + half, k + half];
        corners.into_iter().for_each(|corner| self.know(corner, functions));
        let changes = |[least, greatest]: [f64; 2], bend: f64| least <= bend && -greatest < bend;
        let values = |field: &Self, index: usize| corners.map(|corner| field.value(corner, index));
        let ranges = |values: &[Missed; 4]| {
            [0, 1, 2].map(|component| span(values.iter().map(|value| value[component])))
        };
        // Functions that may vanish in the cell if they continue as they do along it.
        let near = |field: &Self, index: &usize| {
            let [x, y, _] = ranges(&values(field, *index));
            [x, y].into_iter().all(|range| changes(range, range[1] - range[0]))
        };
        let functions: Vec<usize> =
            functions.iter().copied().filter(|index| is_large || near(self, index)).collect();
        if functions.is_empty() {
            return;
        }
        self.know(middle, &functions);
        let [first, far] = [at, [i + size, k + size]].map(&self.place);
        let cell = far - &first;
        let cell_at = [first, cell];
        let [_, cell] = &cell_at;
        let steepest = VIOLENT * cell.amax();
        let mut bent = Vec::new();
        for index in functions {
            let values = values(self, index);
            let ranges = ranges(&values);
            let mean = values.iter().sum::<Missed>() / 4.0;
            let bends: [f64; 3] = (self.value(middle, index) - mean).abs().into();
            let each = || ranges.into_iter().zip(bends);
            // The energy is no more than a hint where cells are large.
            let both = || each().take(2);
            if is_large {
                let may_vanish = |([least, greatest], bend): ([f64; 2], f64)| {
                    changes([least, greatest], (greatest - least).max(BENT * bend))
                };
                if each().all(may_vanish) {
                    bent.push(index);
                }
                continue;
            }
            if (self.is_idle)(&cell_at, &values) {
                continue;
            }
            let is_straight = both().all(|([least, greatest], bend)| bend <= STRAIGHT * (greatest - least));
            let violent = ranges[..2].iter().any(|[least, greatest]| greatest - least > steepest);
            if size == FINEST || is_straight || violent {
                if ranges[..2].iter().all(|range| changes(*range, 0.0)) {
                    self.found.push((index, cell_at.clone()));
                }
            } else if both().all(|(range, bend)| changes(range, bend)) {
                bent.push(index);
            }
        }
        if !bent.is_empty() {
            for part in [[i, k], [i, k + half], [i + half, k], middle] {
                self.search(part, half, &bent);
            }
        }
    }
}
