//! Second-order jets: a value with its first and second derivatives.
//!
//! Every map of the paper between the surfaces Σ and Π sends two coordinates to two coordinates and
//! depends on the two parameters (μ, η), so one type, [`MapJet`], serves them all, and composition
//! is one function. The surfaces at which a map starts and ends are part of the type, so that only
//! maps that fit can be composed. The order is a constant parameter: with `ORDER = 1` the second
//! derivatives are left at zero and cost nothing.

use core::marker::PhantomData;

use nalgebra::{Matrix2, Matrix2x4, Matrix2x6, Matrix4, Matrix6, Vector2};

use crate::state::Surface;

/// Jet of a map `(u, w; μ, η) ↦ (u', w')` at one point, from the surface `A` to the surface `B`;
/// these parameters are left out where the surfaces do not matter.
///
/// The four variables are, in this order, the two coordinates ([`OnWall`](crate::OnWall),
/// [`AtRest`](crate::AtRest), [`AtPhase`](crate::AtPhase)), the primary parameter μ and the
/// secondary parameter η. All are dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapJet<A = (), B = ()> {
    /// The image.
    pub value: Vector2<f64>,
    /// First derivatives; row = component of the image, column = variable.
    pub jacobian: Matrix2x4<f64>,
    /// Second derivatives of either component; zero where only the first order was requested.
    pub hessians: [Matrix4<f64>; 2],
    surfaces: PhantomData<(A, B)>,
}

impl<A: Surface> MapJet<A, A> {
    /// The jet of the identity.
    #[inline]
    pub fn identity(point: A) -> Self {
        let mut jet = Self::constant(point.coordinates());
        jet.jacobian[(0, 0)] = 1.0;
        jet.jacobian[(1, 1)] = 1.0;
        jet
    }
}

impl<A, B> MapJet<A, B> {
    /// The jet of a map that has this value everywhere.
    #[inline]
    pub(crate) fn constant(value: Vector2<f64>) -> Self {
        Self::new(value, Matrix2x4::zeros(), [Matrix4::zeros(); 2])
    }

    #[inline]
    fn new(value: Vector2<f64>, jacobian: Matrix2x4<f64>, hessians: [Matrix4<f64>; 2]) -> Self {
        Self { value, jacobian, hessians, surfaces: PhantomData }
    }

    /// The image as a point of the surface to which the map leads.
    #[inline]
    pub fn image(&self) -> B
    where
        B: Surface,
    {
        B::at(self.value)
    }

    /// The jet without its surfaces.
    #[inline]
    pub fn plain(&self) -> MapJet {
        MapJet::new(self.value, self.jacobian, self.hessians)
    }

    /// The jet of `self ∘ inner`, both at the same parameters.
    ///
    /// With G the derivative of `(u, z, μ, η) ↦ (inner, μ, η)`: the first derivatives are D self ·
    /// G, the second Gᵀ · D² self · G + D self · D² inner.
    #[inline]
    pub fn after<const ORDER: usize, C>(&self, inner: &MapJet<C, A>) -> MapJet<C, B> {
        let mut jacobian = self.derivative() * inner.jacobian;
        for i in 0..2 {
            jacobian[(i, 2)] += self.jacobian[(i, 2)];
            jacobian[(i, 3)] += self.jacobian[(i, 3)];
        }
        let mut hessians = [Matrix4::zeros(); 2];
        if ORDER >= 2 {
            for (i, hessian) in hessians.iter_mut().enumerate() {
                *hessian = inner.pull_back(&self.hessians[i])
                    + inner.hessians[0] * self.jacobian[(i, 0)]
                    + inner.hessians[1] * self.jacobian[(i, 1)];
            }
        }
        MapJet::new(self.value, jacobian, hessians)
    }

    /// Sets a second derivative of one component, and with it the one in the other order.
    #[inline]
    pub(crate) fn set_second(&mut self, component: usize, [a, b]: [usize; 2], entry: f64) {
        self.hessians[component][(a, b)] = entry;
        self.hessians[component][(b, a)] = entry;
    }

    /// Derivatives with respect to the two coordinates alone.
    pub fn derivative(&self) -> Matrix2<f64> {
        self.jacobian.fixed_columns::<2>(0).into_owned()
    }

    /// The jet of the inverse map at the image, with the parameters fixed.
    ///
    /// Returns `None` where the derivative with respect to the coordinates is singular.
    pub fn inverse<const ORDER: usize>(&self, preimage: A) -> Option<MapJet<B, A>>
    where
        A: Surface,
    {
        let inverse = self.derivative().try_inverse()?;
        let mut jet = MapJet::constant(preimage.coordinates());
        jet.jacobian.fixed_view_mut::<2, 2>(0, 0).copy_from(&inverse);
        jet.jacobian
            .fixed_view_mut::<2, 2>(0, 2)
            .copy_from(&(-inverse * self.jacobian.fixed_columns::<2>(2)));
        if ORDER >= 2 {
            let pulled = [jet.pull_back(&self.hessians[0]), jet.pull_back(&self.hessians[1])];
            for (i, hessian) in jet.hessians.iter_mut().enumerate() {
                *hessian = -(pulled[0] * inverse[(i, 0)] + pulled[1] * inverse[(i, 1)]);
            }
        }
        Some(jet)
    }

    /// Gᵀ H G for the derivative G of `(u, z, μ, η) ↦ (u', z', μ, η)`, whose lower half is (0 I).
    fn pull_back(&self, hessian: &Matrix4<f64>) -> Matrix4<f64> {
        let j = &self.jacobian;
        // The first two rows of H G; the rest of H enters through the identity block.
        let mut upper = hessian.fixed_view::<2, 2>(0, 0) * j;
        for i in 0..2 {
            upper[(i, 2)] += hessian[(i, 2)];
            upper[(i, 3)] += hessian[(i, 3)];
        }
        Matrix4::from_fn(|a, b| {
            let mut entry = j[(0, a)] * upper[(0, b)] + j[(1, a)] * upper[(1, b)];
            if a >= 2 {
                entry += hessian[(a, 0)] * j[(0, b)] + hessian[(a, 1)] * j[(1, b)];
                if b >= 2 {
                    entry += hessian[(a, b)];
                }
            }
            entry
        })
    }
}

/// Jet of the flow: position and velocity after a time s, as functions of `(x₀, y₀, z₀, s, μ, η)`.
///
/// The phase needs no entry: it is z₀ + ω(μ, η) s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlowJet {
    /// Position and velocity (x, y) at the end.
    pub value: Vector2<f64>,
    /// First derivatives; columns as in [`flow_variable`](crate::flow_variable).
    pub jacobian: Matrix2x6<f64>,
    /// Second derivatives of x and of y; zero where only the first order was requested.
    pub hessians: [Matrix6<f64>; 2],
}

impl FlowJet {
    /// The jet where a motion does not exist.
    pub(crate) fn nowhere() -> Self {
        Self {
            value: Vector2::repeat(f64::NAN),
            jacobian: Matrix2x6::repeat(f64::NAN),
            hessians: [Matrix6::repeat(f64::NAN); 2],
        }
    }
}

/// Jet of a function of the two parameters (μ, η), such as the forcing frequency ω(μ, η).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterJet {
    /// The value.
    pub value: f64,
    /// Derivatives with respect to (μ, η).
    pub gradient: Vector2<f64>,
    /// Second derivatives.
    pub hessian: Matrix2<f64>,
}

impl ParameterJet {
    /// The jet of a constant.
    pub fn constant(value: f64) -> Self {
        Self { value, gradient: Vector2::zeros(), hessian: Matrix2::zeros() }
    }
}
