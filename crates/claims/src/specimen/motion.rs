//! Motion of a specimen, in closed form or integrated.

use grazing_model::LinearMotion;
use grazing_model::motion::{Bounds, Enclosure, Kinematics, Motion, Walk};
use grazing_model::smooth::IntegratedMotion;

use super::Law;

/// The motion of a [`Specimen`](super::Specimen).
pub(crate) type SpecimenMotion = Either<LinearMotion, IntegratedMotion<Law>>;

/// One of two, both of which do the same.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Either<L, I> {
    /// In closed form.
    Linear(L),
    /// Integrated.
    Integrated(I),
}

/// The value for whichever it is.
macro_rules! either {
    ($self:ident, $inner:ident => $value:expr) => {
        match $self {
            Self::Linear($inner) => $value,
            Self::Integrated($inner) => $value,
        }
    };
}

impl<L: Motion, I: Motion> Motion for Either<L, I> {
    fn at(&self, time: f64) -> Kinematics {
        either!(self, motion => motion.at(time))
    }

    fn enclose(&self, horizon: f64) -> impl Enclosure {
        match self {
            Self::Linear(motion) => Either::Linear(motion.enclose(horizon)),
            Self::Integrated(motion) => Either::Integrated(motion.enclose(horizon)),
        }
    }

    fn foresight(&self) -> f64 {
        either!(self, motion => motion.foresight())
    }
}

impl<L: Enclosure, I: Enclosure> Enclosure for Either<L, I> {
    fn bounds(&self) -> Bounds {
        either!(self, enclosure => enclosure.bounds())
    }

    fn bounds_between(&self, from: f64, to: f64) -> Bounds {
        either!(self, enclosure => enclosure.bounds_between(from, to))
    }

    fn stride(&self) -> f64 {
        either!(self, enclosure => enclosure.stride())
    }

    fn strides(&self) -> usize {
        either!(self, enclosure => enclosure.strides())
    }

    fn time_after(&self, strides: usize) -> f64 {
        either!(self, enclosure => enclosure.time_after(strides))
    }

    fn walk(&self) -> impl Walk {
        match self {
            Self::Linear(enclosure) => Either::Linear(enclosure.walk()),
            Self::Integrated(enclosure) => Either::Integrated(enclosure.walk()),
        }
    }
}

impl<L: Walk, I: Walk> Walk for Either<L, I> {
    fn position(&self) -> f64 {
        either!(self, walk => walk.position())
    }

    fn kinematics(&self) -> Kinematics {
        either!(self, walk => walk.kinematics())
    }

    fn advance(&mut self) {
        either!(self, walk => walk.advance());
    }
}
