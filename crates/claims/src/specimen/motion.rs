//! Motion of a specimen, in closed form or integrated.

use grazing_model::LinearMotion;
use grazing_model::motion::{Bounds, Kinematics, Motion, Walk};
use grazing_model::smooth::IntegratedMotion;

use super::Law;

/// The motion of a [`Specimen`](super::Specimen).
#[derive(Debug)]
pub enum SpecimenMotion {
    /// In closed form.
    Linear(LinearMotion),
    /// Integrated.
    Integrated(IntegratedMotion<Law>),
}

/// What either kind of motion does.
macro_rules! either {
    ($motion:expr, $inner:ident => $value:expr) => {
        match $motion {
            SpecimenMotion::Linear($inner) => $value,
            SpecimenMotion::Integrated($inner) => $value,
        }
    };
}

impl Motion for SpecimenMotion {
    fn at(&self, time: f64) -> Kinematics {
        either!(self, motion => motion.at(time))
    }

    fn bounds(&self, from: f64, to: f64) -> Bounds {
        either!(self, motion => motion.bounds(from, to))
    }

    fn bounds_between(&self, from: f64, to: f64, all: &Bounds) -> Bounds {
        either!(self, motion => motion.bounds_between(from, to, all))
    }

    fn foresight(&self) -> f64 {
        either!(self, motion => motion.foresight())
    }

    fn stride(&self, horizon: f64) -> f64 {
        either!(self, motion => motion.stride(horizon))
    }

    fn time_after(&self, strides: f64) -> f64 {
        either!(self, motion => motion.time_after(strides))
    }

    fn strides_within(&self, horizon: f64) -> f64 {
        either!(self, motion => motion.strides_within(horizon))
    }

    fn walk(&self) -> impl Walk {
        match self {
            Self::Linear(motion) => EitherWalk::Linear(motion.walk()),
            Self::Integrated(motion) => EitherWalk::Integrated(motion.walk()),
        }
    }
}

#[derive(Clone, Copy)]
enum EitherWalk<L, I> {
    Linear(L),
    Integrated(I),
}

impl<L: Walk, I: Walk> Walk for EitherWalk<L, I> {
    fn position(&self) -> f64 {
        match self {
            Self::Linear(walk) => walk.position(),
            Self::Integrated(walk) => walk.position(),
        }
    }

    fn kinematics(&self) -> Kinematics {
        match self {
            Self::Linear(walk) => walk.kinematics(),
            Self::Integrated(walk) => walk.kinematics(),
        }
    }

    fn advance(&mut self) {
        match self {
            Self::Linear(walk) => walk.advance(),
            Self::Integrated(walk) => walk.advance(),
        }
    }
}
