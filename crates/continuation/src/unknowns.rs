//! The unknowns of periodic solutions with any number of impacts.

use core::f64::consts::{PI, TAU};
use core::ops::{Add, AddAssign, Div, Index, IndexMut, Mul, Neg, Sub, SubAssign};

use grazing_model::OnWall;
use nalgebra::{Const, DMatrix, DVector, Dyn, LU, Matrix4, Vector4};
use smallvec::{SmallVec, smallvec};

use crate::newton::Space;

/// The unknowns: (y, z, μ, η), impact velocity, impact phase, primary and secondary parameter, and
/// with more than one impact (y, z, μ, η, y₂, z₂, y₃, …), in the order of time and phases not
/// reduced; without impacts (x, y, μ, η), position and velocity at phase zero.
#[derive(Debug, PartialEq)]
pub struct Unknowns(SmallVec<[f64; 4]>);

impl Clone for Unknowns {
    /// As one block: `SmallVec` clones one by one.
    fn clone(&self) -> Self {
        Self(SmallVec::from_slice(&self.0))
    }
}

/// Indices of the unknowns.
pub mod unknown {
    /// Impact velocity y; without impacts x at phase zero.
    pub const VELOCITY: usize = 0;
    /// Impact phase z; without impacts ẋ at phase zero.
    pub const PHASE: usize = 1;
    /// Primary parameter μ.
    pub const PRIMARY: usize = 2;
    /// Secondary parameter η.
    pub const SECONDARY: usize = 3;

    /// The impact velocity of the impact with an index.
    pub const fn velocity(impact: usize) -> usize {
        if impact == 0 { VELOCITY } else { 2 + 2 * impact }
    }

    /// The impact phase of the impact with an index.
    pub const fn phase(impact: usize) -> usize {
        velocity(impact) + 1
    }

    /// The unknowns on which what leaves the impact with an index depends: its velocity and phase,
    /// and both parameters.
    pub(crate) const fn of_impact(impact: usize) -> [usize; 4] {
        [velocity(impact), phase(impact), PRIMARY, SECONDARY]
    }
}

/// The primary and the secondary parameter (μ, η) of a point.
pub fn parameters(point: &Unknowns) -> [f64; 2] {
    [point[unknown::PRIMARY], point[unknown::SECONDARY]]
}

impl Unknowns {
    /// The unknowns of a solution with one impact, or without impacts.
    pub fn new(velocity: f64, phase: f64, primary: f64, secondary: f64) -> Self {
        Self(SmallVec::from_buf([velocity, phase, primary, secondary]))
    }

    /// The unknowns of a solution with these impacts, at least one.
    pub fn of_impacts(impacts: &[OnWall], [primary, secondary]: [f64; 2]) -> Self {
        let mut all: SmallVec<[f64; 4]> = SmallVec::with_capacity(2 * impacts.len() + 2);
        for (index, impact) in impacts.iter().enumerate() {
            all.extend([impact.velocity, impact.phase]);
            if index == 0 {
                all.extend([primary, secondary]);
            }
        }
        Self(all)
    }

    /// Zeros for a number of impacts.
    pub(crate) fn zeros(impacts: usize) -> Self {
        Self(smallvec![0.0; 2 * impacts + 2])
    }

    /// The unit vector in the direction of an unknown, of the size of these unknowns.
    pub fn along(&self, unknown: usize) -> Self {
        let mut along = self.filled(0.0);
        along[unknown] = 1.0;
        along
    }

    /// Exchanges two components.
    pub fn swap(&mut self, one: usize, other: usize) {
        self.0.swap(one, other);
    }

    /// The number of impacts, which is 1 also without impacts, when position and velocity at phase
    /// zero take the place of an impact.
    pub fn impacts(&self) -> usize {
        (self.0.len() - 2) / 2
    }

    /// The impact with the lowest velocity, and that velocity.
    pub fn lowest_velocity(&self) -> (usize, f64) {
        let others = (1..self.impacts()).map(|impact| (impact, self[unknown::velocity(impact)]));
        others.fold((0, self[unknown::VELOCITY]), |low, next| if next.1 < low.1 { next } else { low })
    }

    /// The impact with an index.
    pub fn impact(&self, index: usize) -> OnWall {
        OnWall::new(self[unknown::velocity(index)], self[unknown::phase(index)])
    }

    /// The unknowns of the same solution, which recurs after so many forcing periods, with the impact with an
    /// index as its first.
    #[must_use]
    pub fn beginning_with(&self, first: usize, periods: u32) -> Self {
        let mut impacts: SmallVec<[OnWall; 4]> =
            (0..self.impacts()).map(|index| self.impact(index)).collect();
        impacts[..first].iter_mut().for_each(|impact| impact.phase += f64::from(periods) * TAU);
        impacts.rotate_left(first);
        Self::of_impacts(&impacts, parameters(self))
    }

    /// The unknowns with these impacts and, so many forcing periods later, those of another solution.
    #[must_use]
    pub fn followed_by(&self, next: &Self, periods: u32) -> Self {
        let later = |mut impact: OnWall| {
            impact.phase += f64::from(periods) * TAU;
            impact
        };
        let own = (0..self.impacts()).map(|index| self.impact(index));
        let others = (0..next.impacts()).map(|index| later(next.impact(index)));
        Self::of_impacts(&own.chain(others).collect::<SmallVec<[OnWall; 4]>>(), parameters(self))
    }

    /// The unknowns with the first impacts alone, so many of them.
    #[must_use]
    pub fn first_impacts(&self, count: usize) -> Self {
        let impacts: SmallVec<[OnWall; 4]> = (0..count).map(|index| self.impact(index)).collect();
        Self::of_impacts(&impacts, parameters(self))
    }

    /// All components.
    pub fn iter(&self) -> impl Iterator<Item = &f64> {
        self.0.iter()
    }

    /// The first four components, (y, z, μ, η).
    pub fn first(&self) -> Vector4<f64> {
        Vector4::from_column_slice(&self.0[..4])
    }

    /// Unknowns of the same size with equal components.
    #[must_use]
    pub fn filled(&self, value: f64) -> Self {
        Self(smallvec![value; self.0.len()])
    }

    /// The products of the components.
    #[must_use]
    pub fn component_mul(&self, other: &Self) -> Self {
        self.clone().combined(other, |a, b| a * b)
    }

    /// The quotients of the components.
    #[must_use]
    pub fn component_div(&self, other: &Self) -> Self {
        self.clone().combined(other, |a, b| a / b)
    }

    /// The Euclidean norm.
    pub fn norm(&self) -> f64 {
        Space::norm(self)
    }

    /// The largest absolute value of a component.
    pub fn amax(&self) -> f64 {
        self.0.iter().fold(0.0, |most, entry| most.max(entry.abs()))
    }

    /// The square of the Euclidean norm.
    pub fn norm_squared(&self) -> f64 {
        Space::dot(self, self)
    }

    /// The scalar product.
    pub fn dot(&self, other: &Self) -> f64 {
        Space::dot(self, other)
    }

    /// The vector of length one in the same direction.
    #[must_use]
    pub fn normalize(&self) -> Self {
        self / self.norm()
    }

    /// The difference with its phases less the whole turns by which the first of them differs.
    pub(crate) fn less_turns(mut self) -> Self {
        let gap = self[unknown::PHASE];
        // Most gaps are small, and the remainder takes long.
        if gap.abs() <= PI {
            return self;
        }
        self[unknown::PHASE] = libm::remainder(gap, TAU);
        let turns = gap - self[unknown::PHASE];
        (1..self.impacts()).for_each(|impact| self[unknown::phase(impact)] -= turns);
        self
    }

    fn combined(mut self, other: &Self, with: impl Fn(f64, f64) -> f64) -> Self {
        self.0.iter_mut().zip(&other.0).for_each(|(own, other)| *own = with(*own, *other));
        self
    }

    fn changed(mut self, change: impl Fn(f64) -> f64) -> Self {
        self.0.iter_mut().for_each(|entry| *entry = change(*entry));
        self
    }
}

impl From<Unknowns> for [f64; 4] {
    /// (y, z, μ, η).
    fn from(unknowns: Unknowns) -> Self {
        unknowns.first().into()
    }
}

impl From<[f64; 4]> for Unknowns {
    fn from([velocity, phase, primary, secondary]: [f64; 4]) -> Self {
        Self::new(velocity, phase, primary, secondary)
    }
}

impl From<Vector4<f64>> for Unknowns {
    fn from(first: Vector4<f64>) -> Self {
        <[f64; 4]>::from(first).into()
    }
}

impl Index<usize> for Unknowns {
    type Output = f64;

    fn index(&self, index: usize) -> &f64 {
        &self.0[index]
    }
}

impl IndexMut<usize> for Unknowns {
    fn index_mut(&mut self, index: usize) -> &mut f64 {
        &mut self.0[index]
    }
}

macro_rules! sums {
    ($($operation:ident $apply:ident $assign:ident $apply_to:ident $operator:tt;)*) => {$(
        impl $operation for Unknowns {
            type Output = Self;
            fn $apply(self, other: Self) -> Self {
                self.combined(&other, |a, b| a $operator b)
            }
        }

        impl $operation<&Self> for Unknowns {
            type Output = Self;
            fn $apply(self, other: &Self) -> Self {
                self.combined(other, |a, b| a $operator b)
            }
        }

        impl $operation<Unknowns> for &Unknowns {
            type Output = Unknowns;
            fn $apply(self, other: Unknowns) -> Unknowns {
                self.clone().combined(&other, |a, b| a $operator b)
            }
        }

        impl $operation for &Unknowns {
            type Output = Unknowns;
            fn $apply(self, other: Self) -> Unknowns {
                self.clone().combined(other, |a, b| a $operator b)
            }
        }

        impl $assign for Unknowns {
            fn $apply_to(&mut self, other: Self) {
                self.0.iter_mut().zip(&other.0).for_each(|(own, other)| *own = *own $operator *other);
            }
        }
    )*};
}

sums! {
    Add add AddAssign add_assign +;
    Sub sub SubAssign sub_assign -;
}

impl Mul<f64> for Unknowns {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self.changed(|entry| entry * factor)
    }
}

impl Mul<f64> for &Unknowns {
    type Output = Unknowns;
    fn mul(self, factor: f64) -> Unknowns {
        self.clone() * factor
    }
}

impl Div<f64> for Unknowns {
    type Output = Self;
    fn div(self, divisor: f64) -> Self {
        self.changed(|entry| entry / divisor)
    }
}

impl Div<f64> for &Unknowns {
    type Output = Unknowns;
    fn div(self, divisor: f64) -> Unknowns {
        self.clone() / divisor
    }
}

impl Neg for Unknowns {
    type Output = Self;
    fn neg(self) -> Self {
        self.changed(|entry| -entry)
    }
}

impl Neg for &Unknowns {
    type Output = Unknowns;
    fn neg(self) -> Unknowns {
        -self.clone()
    }
}

/// A square matrix with as many rows as there are unknowns.
#[derive(Clone, Debug, PartialEq)]
pub struct Square {
    size: usize,
    /// The entries, column by column.
    entries: SmallVec<[f64; 16]>,
}

impl Square {
    /// A matrix of zeros.
    pub fn zeros(size: usize) -> Self {
        Self { size, entries: smallvec![0.0; size * size] }
    }
}

impl Index<[usize; 2]> for Square {
    type Output = f64;

    fn index(&self, [row, column]: [usize; 2]) -> &f64 {
        &self.entries[row + column * self.size]
    }
}

impl IndexMut<[usize; 2]> for Square {
    fn index_mut(&mut self, [row, column]: [usize; 2]) -> &mut f64 {
        &mut self.entries[row + column * self.size]
    }
}

/// The factors of a [`Square`].
#[derive(Clone, Debug)]
pub enum Factors {
    /// Those of a matrix for one impact, on the stack.
    Four(LU<f64, Const<4>, Const<4>>),
    /// Those of a larger matrix.
    Larger(LU<f64, Dyn, Dyn>),
}

impl Space for Unknowns {
    type Matrix = Square;
    type Factors = Factors;

    fn size(&self) -> usize {
        self.0.len()
    }

    fn filled(&self, value: f64) -> Self {
        Self::filled(self, value)
    }

    fn dot(&self, other: &Self) -> f64 {
        let first = self.first().dot(&other.first());
        let others = self.0[4..].iter().zip(&other.0[4..]).map(|(a, b)| a * b);
        others.fold(first, |sum, product| sum + product)
    }

    fn component_mul(&self, other: &Self) -> Self {
        Self::component_mul(self, other)
    }

    fn component_div(&self, other: &Self) -> Self {
        Self::component_div(self, other)
    }

    fn set_last_row(matrix: &mut Square, row: &Self) {
        let last = matrix.size - 1;
        row.iter().enumerate().for_each(|(column, entry)| matrix[[last, column]] = *entry);
    }

    fn scale_columns(&self, matrix: &mut Square) {
        let columns = matrix.entries.chunks_exact_mut(matrix.size);
        for (column, factor) in columns.zip(&self.0) {
            column.iter_mut().for_each(|entry| *entry *= factor);
        }
    }

    fn factors(matrix: Square) -> Factors {
        match matrix.size {
            4 => Factors::Four(Matrix4::from_column_slice(&matrix.entries).lu()),
            size => Factors::Larger(DMatrix::from_column_slice(size, size, &matrix.entries).lu()),
        }
    }

    fn solved(&self, factors: &Factors) -> Option<Self> {
        match factors {
            Factors::Four(factors) => factors.solve(&self.first()).map(Self::from),
            Factors::Larger(factors) => {
                let solution = factors.solve(&DVector::from_column_slice(&self.0))?;
                Some(Self(solution.as_slice().iter().copied().collect()))
            }
        }
    }
}
