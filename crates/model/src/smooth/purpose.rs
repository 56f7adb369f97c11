//! What motion is computed for, so that the steps of integration can be counted by their purpose.

use core::cell::Cell;

/// What motion is computed for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Everything that is not named below.
    Other,
    /// Motion without impacts that is left to relax.
    Relaxation,
    /// Branches of motion without impacts.
    FreeBranches,
    /// Lattices of impacts, or of states at rest, on which solutions are looked for.
    Lattices,
    /// Solutions carried from slice to slice, or from curves and columns to slices.
    Carrying,
    /// Branches of solutions with an impact at constant η.
    Branches,
    /// The same at constant μ.
    Columns,
    /// Grazing curves, resonances and bifurcation curves.
    Curves,
    /// Vertices of curves beside others.
    Vertices,
    /// Coefficients, magnifications and straightened curves at resonances.
    Coefficients,
    /// Events on branches and curves.
    Events,
    /// The highest maxima of solutions, which decide whether they are admissible.
    Admissibility,
    /// Stable solutions beside curves.
    Witnesses,
    /// Long-time motion.
    Simulation,
}

thread_local! {
    static CURRENT: Cell<Purpose> = const { Cell::new(Purpose::Other) };
}

impl Purpose {
    /// All purposes, in the order of their declaration.
    pub const ALL: [Self; 14] = [
        Self::Other,
        Self::Relaxation,
        Self::FreeBranches,
        Self::Lattices,
        Self::Carrying,
        Self::Branches,
        Self::Columns,
        Self::Curves,
        Self::Vertices,
        Self::Coefficients,
        Self::Events,
        Self::Admissibility,
        Self::Witnesses,
        Self::Simulation,
    ];

    /// The purpose of what this thread computes now.
    #[inline]
    pub(super) fn current() -> Self {
        CURRENT.get()
    }

    /// What `work` returns; the steps that this thread makes meanwhile have this purpose, apart from
    /// those for which `work` names another.
    pub fn during<T>(self, work: impl FnOnce() -> T) -> T {
        /// Restores the purpose also when `work` panics.
        struct Before(Purpose);
        impl Drop for Before {
            fn drop(&mut self) {
                CURRENT.set(self.0);
            }
        }
        let _before = Before(CURRENT.replace(self));
        work()
    }

    /// The name in a table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Other => "other",
            Self::Relaxation => "relaxation without impacts",
            Self::FreeBranches => "branches without impacts",
            Self::Lattices => "lattices",
            Self::Carrying => "carrying to slices",
            Self::Branches => "branches on slices",
            Self::Columns => "columns",
            Self::Curves => "curves and resonances",
            Self::Vertices => "vertices beside others",
            Self::Coefficients => "coefficients, magnifications",
            Self::Events => "events",
            Self::Admissibility => "admissibility",
            Self::Witnesses => "witnesses",
            Self::Simulation => "long-time motion",
        }
    }
}
