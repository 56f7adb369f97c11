//! A region of the parameter plane, and whether it is decided.

use core::fmt;
use std::borrow::Cow;

use grazing_continuation::curve::Window;
use grazing_results::plane::{RegionCorner, RegionKind};
use grazing_results::span;

use crate::faces;
use crate::slices::MOST_BRANCHES;

/// The reason why it is undecided whether solutions are stable and admissible.
#[derive(Clone, Debug, PartialEq)]
pub enum Doubt {
    /// Along a slice solutions gain or lose stability or admissibility where no curve runs.
    Disagreement,
    /// Stability changes on a branch without a saddle-node, period-doubling, torus or grazing
    /// bifurcation.
    UnnamedChange,
    /// A branch could not be followed to its end.
    Broken(String),
    /// There are more branches of solutions than are followed.
    ManyBranches,
    /// No slice was made.
    Unseen,
    /// The computation was cancelled before it was decided.
    NotFinished,
}

impl Doubt {
    /// What all doubts of one kind say, wherever the region is.
    pub fn kind(&self) -> Cow<'static, str> {
        Cow::Borrowed(match self {
            Self::Disagreement => {
                "solutions gain or lose stability or admissibility where no curve was found"
            }
            Self::UnnamedChange => {
                "stability changes without a saddle-node, period-doubling, torus or grazing bifurcation"
            }
            Self::Broken(_) => "a branch of solutions could not be followed to its end",
            Self::ManyBranches => {
                return Cow::Owned(format!("there are {MOST_BRANCHES} branches of solutions or more"));
            }
            Self::Unseen => "no slice crosses it",
            Self::NotFinished => "not finished",
        })
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.kind())?;
        match self {
            Self::Broken(end) => write!(f, ": {end}"),
            _ => Ok(()),
        }
    }
}

/// Regions thinner than this fraction of the ranges cannot be seen: curves are drawn to about this
/// accuracy.
const THIN: f64 = 1e-4;

/// A region, as points (μ, η).
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Number of loops p; 0 for the non-impacting solution.
    pub loops: u32,
    /// The greatest integer n of the resonances that the curves on its border leave; 0 without one,
    /// and for the non-impacting solution.
    pub n: u32,
    /// The border of the region and those of its holes, vertex by vertex: a point lies inside if a
    /// ray from it crosses them an odd number of times.
    pub rings: Vec<Vec<[f64; 2]>>,
    /// The reason why it is undecided whether solutions are stable and admissible; `None` if they
    /// are.
    pub doubt: Option<Doubt>,
}

impl Region {
    /// The whole window as undecided, because the computation was cancelled.
    pub fn not_finished(window: Window, loops: u32) -> Self {
        let ([left, right], [low, high]) = (window.primary, window.secondary);
        let border = vec![[left, low], [right, low], [right, high], [left, high]];
        Self { loops, n: 0, rings: vec![border], doubt: Some(Doubt::NotFinished) }
    }

    /// The fraction of the window's area that lies in the region.
    pub fn share(&self, window: Window) -> f64 {
        let [width, height] = window.widths();
        faces::area(&self.rings) / (width * height)
    }

    /// The kind of the region.
    pub fn kind(&self) -> RegionKind {
        match (&self.doubt, self.loops) {
            (Some(_), _) => RegionKind::Undecided,
            (None, 0) => RegionKind::NonImpacting,
            (None, _) => RegionKind::Mps,
        }
    }

    /// The vertices, one ring after the other.
    pub fn vertices(&self) -> impl Iterator<Item = RegionCorner> {
        let reason = self.doubt.as_ref().map(Doubt::to_string).unwrap_or_default();
        let rings = (0..).zip(&self.rings);
        let all = rings.flat_map(|(ring, vertices)| vertices.iter().map(move |at| (ring, *at)));
        all.map(move |(ring, [primary, secondary])| RegionCorner {
            secondary,
            primary,
            ring,
            reason: reason.clone(),
        })
    }

    /// The parts of the region inside a window.
    pub(crate) fn within(&self, window: Window) -> impl Iterator<Item = Self> {
        let ([left, right], [low, high]) = (window.primary, window.secondary);
        let [from, to] = self.extent();
        let across = [low, high].map(|level| vec![[from[0].min(left), level], [to[0].max(right), level]]);
        let up = [left, right].map(|place| vec![[place, from[1].min(low)], [place, to[1].max(high)]]);
        let part = |rings| Self { rings, ..self.clone() };
        let inside = move |part: &Self| {
            let [from, to] = part.extent();
            window.contains([0, 1].map(|k| 0.5 * (from[k] + to[k])))
        };
        faces::part(&self.rings, &[across, up].concat()).into_iter().map(part).filter(inside)
    }

    /// Whether the region is decided and thinner than the accuracy of drawn curves: twice its area
    /// is less than this fraction of the ranges times the length of its border.
    pub fn is_thin(&self, window: Window) -> bool {
        let shares: Vec<Vec<[f64; 2]>> =
            self.rings.iter().map(|ring| ring.iter().map(|at| window.shares(*at)).collect()).collect();
        let thickness = 2.0 * faces::area(&shares) / faces::perimeter(&shares);
        self.doubt.is_none() && thickness < THIN
    }

    /// The least and the greatest (μ, η).
    pub fn extent(&self) -> [[f64; 2]; 2] {
        let [primary, secondary] = [0, 1].map(|k| span(self.rings.iter().flatten().map(|point| point[k])));
        [0, 1].map(|end| [primary[end], secondary[end]])
    }

    /// The intervals of μ in which a line of constant η lies inside.
    pub fn chords(&self, secondary: f64) -> Vec<[f64; 2]> {
        faces::chords(&self.rings, secondary)
    }

    /// Whether a point (μ, η) lies inside.
    pub fn contains(&self, point: [f64; 2]) -> bool {
        faces::holds(&self.rings, point)
    }
}
