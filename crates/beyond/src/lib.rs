//! What goes beyond the paper, and all of its study together.
//!
//! Each figure beyond the paper has a module with its section of the parameter file, its rows, and the
//! functions that compute and draw it, as the figures of the paper have theirs in
//! [`grazing_reproduction::figures`]. [`all_figures!`] is the list of both; the sections of the parameter
//! file ([`parameters`]) and the outputs of the program follow from it. A new figure needs a module and a
//! line in the list. This crate does not write files.

pub mod atlas;
pub mod attractors;
pub mod branches;
pub mod cascade;
pub mod generations;
pub mod limit_maps;
pub mod loops;
pub mod parameters;
pub mod proofs;
pub mod regions;

#[doc(hidden)]
pub use grazing_reproduction::figures as of_the_paper;

/// The list of all figures, of the paper and beyond it: an array of the results of a generic function for
/// each figure, in order; other elements may precede and follow them.
#[macro_export]
macro_rules! all_figures {
    ($make:ident $(, first $first:expr)? $(, last $($last:expr),+)?) => {
        [
            $($first,)?
            $make::<$crate::of_the_paper::fig01::Figure1>(),
            $make::<$crate::of_the_paper::fig02::Figure2>(),
            $make::<$crate::of_the_paper::fig03::Figure3>(),
            $make::<$crate::of_the_paper::fig04::Figure4>(),
            $make::<$crate::of_the_paper::fig05::Figure5>(),
            $make::<$crate::of_the_paper::fig06::Figure6>(),
            $make::<$crate::of_the_paper::fig07::Figure7>(),
            $make::<$crate::of_the_paper::fig08::Figure8>(),
            $make::<$crate::of_the_paper::fig09::Figure9>(),
            $make::<$crate::of_the_paper::fig10::Figure10>(),
            $make::<$crate::cascade::BeyondCascade>(),
            $make::<$crate::atlas::BeyondAtlas>(),
            $make::<$crate::loops::BeyondLoops>(),
            $make::<$crate::regions::BeyondRegions>(),
            $make::<$crate::attractors::BeyondAttractors>(),
            $make::<$crate::proofs::BeyondProofs>(),
            $make::<$crate::generations::BeyondGenerations>(),
            $make::<$crate::branches::BeyondBranches>(),
            $($($last,)+)?
        ]
    };
}
