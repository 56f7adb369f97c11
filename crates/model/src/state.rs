//! States, and points of the surfaces between which maps lead: pairs of coordinates that look alike
//! are of different types.

use nalgebra::Vector2;

/// A point (x, y, z) of phase space: position, velocity, and phase of the forcing in radians (not
/// wrapped).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Position x; the wall stands at x = 0 and motion takes place in x ≤ 0.
    pub position: f64,
    /// Velocity y = ẋ.
    pub velocity: f64,
    /// Phase z = ω t (eq:z), not reduced modulo 2π.
    pub phase: f64,
}

impl State {
    /// The point (0, y, z) of the impacting surface Σ.
    pub const fn on_wall(velocity: f64, phase: f64) -> Self {
        Self { position: 0.0, velocity, phase }
    }

    /// The point (x, 0, z) of the Poincaré section Π.
    pub const fn at_rest(position: f64, phase: f64) -> Self {
        Self { position, velocity: 0.0, phase }
    }
}

/// Positions of the arguments of the flow among the columns of a [`FlowJet`](crate::FlowJet).
pub mod flow_variable {
    /// Initial position x₀.
    pub const POSITION: usize = 0;
    /// Initial velocity y₀.
    pub const VELOCITY: usize = 1;
    /// Initial phase z₀.
    pub const PHASE: usize = 2;
    /// Duration s.
    pub const DURATION: usize = 3;
    /// Primary parameter μ.
    pub const PRIMARY: usize = 4;
    /// Secondary parameter η.
    pub const SECONDARY: usize = 5;
}

/// A point of a surface, by its two coordinates.
pub trait Surface: Copy {
    /// Which of the flow's variables the coordinates are.
    const VARIABLES: [usize; 2];

    /// The point with these coordinates.
    fn at(coordinates: Vector2<f64>) -> Self;

    /// Both coordinates.
    fn coordinates(self) -> Vector2<f64>;
}

macro_rules! surface {
    ($(#[$doc:meta])* $name:ident, $first:ident, $first_variable:ident, $second:ident, $second_variable:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name {
            /// The first coordinate.
            pub $first: f64,
            /// The second coordinate; phases are in radians.
            pub $second: f64,
        }

        impl $name {
            /// The point with these coordinates.
            #[inline]
            pub const fn new($first: f64, $second: f64) -> Self {
                Self { $first, $second }
            }
        }

        impl Surface for $name {
            const VARIABLES: [usize; 2] = [flow_variable::$first_variable, flow_variable::$second_variable];

            #[inline]
            fn at(coordinates: Vector2<f64>) -> Self {
                Self::new(coordinates[0], coordinates[1])
            }

            #[inline]
            fn coordinates(self) -> Vector2<f64> {
                Vector2::new(self.$first, self.$second)
            }
        }
    };
}

surface!(
    /// A point (y, z) of the impacting surface Σ, x = 0.
    OnWall, velocity, VELOCITY, phase, PHASE
);
surface!(
    /// A point (x, z) of the Poincaré section Π, y = 0.
    AtRest, position, POSITION, phase, PHASE
);
surface!(
    /// A point (x, y) of a plane of constant phase.
    AtPhase, position, POSITION, velocity, VELOCITY
);

impl AtPhase {
    /// The state, if the plane is that of phase zero.
    #[inline]
    pub const fn at_phase_zero(self) -> State {
        State { position: self.position, velocity: self.velocity, phase: 0.0 }
    }
}

impl From<OnWall> for State {
    #[inline]
    fn from(OnWall { velocity, phase }: OnWall) -> Self {
        Self::on_wall(velocity, phase)
    }
}

impl From<AtRest> for State {
    #[inline]
    fn from(AtRest { position, phase }: AtRest) -> Self {
        Self::at_rest(position, phase)
    }
}
