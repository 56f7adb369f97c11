//! Resonances on the curves at which motion that already hits the wall grazes, and what leaves them.
//!
//! Impacts elsewhere do not affect the smoothness of P_global (section 6 of the paper), so that a
//! curve along which solutions with K impacts touch the wall is a curve of grazing bifurcations, and
//! the theorems hold at the zeros of a₁₂ and κ_q along it. From each, solutions with one impact more than q
//! rounds of the grazing motion leave.

use grazing_continuation::bifurcation::Bifurcation;
use grazing_continuation::curve::Curve;
use grazing_continuation::resonance::ResonanceError;
use grazing_model::smooth::Purpose;

use crate::Scope;
use crate::curves::{DiagramCurve, drawn};
use crate::diagram::Diagram;
use crate::grazing::GrazingCurve;
use crate::parallel;
use crate::progress::Progress;
use crate::resonances::{FoundResonance, Unlocated, distinct, on_curve};

/// A curve along which solutions with impacts graze.
#[derive(Clone, Debug)]
pub struct BaseCurve {
    /// The number of impacts of the solutions.
    pub impacts: usize,
    /// The index of the curve among those of these solutions.
    pub index: usize,
    /// The curve; its number of loops is that of the forcing periods after which the solutions recur.
    pub curve: DiagramCurve,
}

/// The solutions that graze along a curve, and which of their curves it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BaseName {
    /// The number of impacts of the solutions.
    pub impacts: usize,
    /// The number of forcing periods after which they recur.
    pub periods: u32,
    /// The integer n of the curve; 0 without one.
    pub n: u32,
    /// The index of the curve among those of these solutions.
    pub index: usize,
}

impl BaseCurve {
    /// The name of the base.
    pub fn name(&self) -> BaseName {
        let Self { impacts, index, ref curve } = *self;
        BaseName { impacts, periods: curve.loops, n: curve.n, index }
    }
}

/// The curves of a diagram along which its MPSs graze.
pub fn bases(diagram: &Diagram) -> Vec<BaseCurve> {
    let curves = diagram.curves.iter().enumerate().filter(|(_, curve)| curve.kind == Bifurcation::Grazing);
    curves.map(|(index, curve)| BaseCurve { impacts: 1, index, curve: curve.clone() }).collect()
}

/// A resonance of motion with impacts, and the curves that leave it.
#[derive(Clone, Debug)]
pub struct LaterResonance {
    /// The motion that grazes there.
    pub base: BaseName,
    /// The resonance; its number of loops is that of rounds of the grazing motion.
    pub resonance: FoundResonance,
    /// The SN, PD and GZ curves that were followed from it, where a theorem holds.
    pub curves: Vec<Curve>,
    /// The reasons why others are missing.
    pub missing: Vec<ResonanceError>,
}

impl LaterResonance {
    /// The number of impacts of the solutions that leave.
    pub fn impacts(&self) -> usize {
        self.resonance.located.unknowns().impacts()
    }

    /// The number of forcing periods after which they recur.
    pub fn periods(&self) -> u32 {
        self.resonance.located.equations().loops()
    }
}

/// The resonances of motion with impacts.
#[derive(Clone, Debug, Default)]
pub struct Later {
    /// Those that were located, by curve and by q.
    pub resonances: Vec<LaterResonance>,
    /// Those that were detected but could not be located.
    pub unlocated: Vec<Unlocated>,
}

/// The stage in which these resonances are looked for.
const STAGE: &str = "resonances of motion with impacts";

/// The resonances of the scope's numbers of loops on curves at which solutions with impacts graze, by curve
/// and by q, with the curves that leave them.
pub fn later(diagram: &Diagram, bases: &[BaseCurve], scope: &Scope, progress: &dyn Progress) -> Later {
    progress.begin(STAGE, bases.len() as u64);
    let found = parallel::map(bases, |base| {
        let found = Purpose::Curves.during(|| on_base(diagram, base, scope, progress));
        progress.step(STAGE);
        found
    });
    progress.end(STAGE);
    let mut all = Later::default();
    for Later { resonances, unlocated } in found {
        all.resonances.extend(resonances);
        all.unlocated.extend(unlocated);
    }
    all
}

fn on_base(diagram: &Diagram, base: &BaseCurve, scope: &Scope, progress: &dyn Progress) -> Later {
    let equations = diagram.equations(base.curve.loops);
    let grazing = GrazingCurve::of_impacting(&equations, &base.curve.curve, scope);
    let (found, unlocated) = on_curve(&grazing, scope, progress);
    let route = drawn(scope.window);
    let unfold = |resonance: FoundResonance| {
        let unfolded = resonance.theorem.as_ref().ok().map(|point| point.unfold(&route));
        let (curves, missing) = match unfolded {
            Some(Ok(unfolded)) => (unfolded.curves().cloned().collect(), unfolded.missing),
            Some(Err(reason)) => (Vec::new(), vec![reason]),
            None => (Vec::new(), Vec::new()),
        };
        LaterResonance { base: base.name(), resonance, curves, missing }
    };
    Later { resonances: distinct(found, scope.window).into_iter().map(unfold).collect(), unlocated }
}
