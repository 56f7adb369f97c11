//! Bifurcations of codimension one and two, with their names.

use crate::locate::Condition;

/// A bifurcation of codimension one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bifurcation {
    /// Grazing of the non-impacting solution: its highest point touches the wall.
    NonImpactingGrazing,
    /// Saddle-node: a multiplier is 1.
    SaddleNode,
    /// Period doubling: a multiplier is −1.
    PeriodDoubling,
    /// Grazing of an MPS: a maximum between two impacts touches the wall.
    Grazing,
    /// Torus (Neimark-Sacker): a pair of complex multipliers has absolute value 1.
    ///
    /// The product D of the multipliers is 1 there, so there is none where motion contracts areas:
    /// for the paper's oscillator D is ε² e^{−4πζp/ω}.
    Torus,
    /// Pitchfork of symmetric motion without impacts: a multiplier is 1 without a fold, and two
    /// motions begin that are each other's images.
    Pitchfork,
}

impl Bifurcation {
    /// All bifurcations of codimension one.
    pub const ALL: [Self; 6] = [
        Self::NonImpactingGrazing,
        Self::SaddleNode,
        Self::PeriodDoubling,
        Self::Grazing,
        Self::Torus,
        Self::Pitchfork,
    ];

    /// The names of all bifurcations, as messages list them.
    pub const NAMES: &str = "graz, SN, PD, GZ, NS or PF";

    /// The bifurcation with a given name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// The bifurcation that a word of this field means: its name here, in AUTO, COCO, MatCont or
    /// BifurcationKit, or in full, in capitals or not. A word with several meanings, such as BP or grazing,
    /// is none of them.
    pub fn understood(word: &str) -> Option<Self> {
        let plain = |word: &str| word.chars().filter(|letter| !" -_".contains(*letter)).collect::<String>();
        let word = plain(word).to_ascii_lowercase();
        Self::ALL.into_iter().find(|kind| {
            word == kind.name().to_ascii_lowercase() || kind.other_names().contains(&word.as_str())
        })
    }

    /// Other names, in small letters and without blanks and hyphens.
    const fn other_names(self) -> &'static [&'static str] {
        match self {
            Self::NonImpactingGrazing => &["nonimpactinggrazing"],
            Self::SaddleNode => {
                &["saddlenode", "fold", "lp", "lpc", "limitpoint", "limitpointofcycles", "turningpoint"]
            }
            Self::PeriodDoubling => &["perioddoubling", "flip"],
            Self::Grazing => &["interiorgrazing"],
            Self::Torus => &["torus", "tr", "neimarksacker", "naimarksacker", "secondaryhopf"],
            Self::Pitchfork => &["pitchfork", "symmetrybreaking"],
        }
    }

    /// The bifurcation at which solutions with p loops (0 without impacts) satisfy a condition;
    /// `None` if it is no bifurcation.
    pub fn of(condition: Condition, loops: u32) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| {
            kind.condition() == condition
                && (*kind != Self::Grazing || loops > 0)
                && (*kind != Self::NonImpactingGrazing || loops == 0)
        })
    }

    /// The condition that holds at the bifurcation.
    pub const fn condition(self) -> Condition {
        match self {
            Self::SaddleNode => Condition::SADDLE_NODE,
            Self::PeriodDoubling => Condition::PERIOD_DOUBLING,
            Self::NonImpactingGrazing | Self::Grazing => Condition::InteriorGrazing,
            Self::Torus => Condition::TORUS,
            Self::Pitchfork => Condition::SymmetryBreaking,
        }
    }

    /// The name: `graz`, `SN`, `PD`, `GZ`, `NS` or `PF`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::NonImpactingGrazing => "graz",
            Self::SaddleNode => "SN",
            Self::PeriodDoubling => "PD",
            Self::Grazing => "GZ",
            Self::Torus => "NS",
            Self::Pitchfork => "PF",
        }
    }
}

/// A bifurcation of codimension two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
pub enum CodimensionTwo {
    /// A resonance on the grazing curve of the non-impacting solution, from which SN and PD curves
    /// leave.
    Resonance,
    /// An SN and a GZ curve meet.
    SaddleNodeGrazing,
    /// A PD and a GZ curve meet.
    PeriodDoublingGrazing,
    /// Two GZ curves meet: two maxima touch the wall.
    GrazingGrazing,
    /// An SN curve turns back.
    Cusp,
    /// An NS curve ends on an SN curve: both multipliers are 1.
    SaddleNodeTorus,
    /// An NS curve ends on a PD curve: both multipliers are −1.
    PeriodDoublingTorus,
    /// An NS curve ends on a PF curve: both multipliers are 1, and over half a period −1.
    PitchforkTorus,
    /// An NS and a GZ curve meet.
    TorusGrazing,
    /// A PF and a GZ curve meet.
    PitchforkGrazing,
}

impl CodimensionTwo {
    /// All bifurcations of codimension two.
    pub const ALL: [Self; 10] = [
        Self::Resonance,
        Self::SaddleNodeGrazing,
        Self::PeriodDoublingGrazing,
        Self::GrazingGrazing,
        Self::Cusp,
        Self::SaddleNodeTorus,
        Self::PeriodDoublingTorus,
        Self::PitchforkTorus,
        Self::TorusGrazing,
        Self::PitchforkGrazing,
    ];

    /// The bifurcation at which two curves meet, at least one of which is a GZ or an NS curve.
    pub fn of_meeting(one: Bifurcation, other: Bifurcation) -> Self {
        use Bifurcation::{PeriodDoubling, Pitchfork, SaddleNode, Torus};
        match (one, other) {
            (SaddleNode, Torus) | (Torus, SaddleNode) => Self::SaddleNodeTorus,
            (PeriodDoubling, Torus) | (Torus, PeriodDoubling) => Self::PeriodDoublingTorus,
            (Pitchfork, Torus) | (Torus, Pitchfork) => Self::PitchforkTorus,
            (Torus, _) | (_, Torus) => Self::TorusGrazing,
            (SaddleNode, _) | (_, SaddleNode) => Self::SaddleNodeGrazing,
            (PeriodDoubling, _) | (_, PeriodDoubling) => Self::PeriodDoublingGrazing,
            (Pitchfork, _) | (_, Pitchfork) => Self::PitchforkGrazing,
            _ => Self::GrazingGrazing,
        }
    }

    /// The name: `resonance`, `SN-GZ`, `PD-GZ`, `GZ-GZ`, `cusp`, `SN-NS`, `PD-NS`, `PF-NS`,
    /// `NS-GZ` or `PF-GZ`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Resonance => "resonance",
            Self::SaddleNodeGrazing => "SN-GZ",
            Self::PeriodDoublingGrazing => "PD-GZ",
            Self::GrazingGrazing => "GZ-GZ",
            Self::Cusp => "cusp",
            Self::SaddleNodeTorus => "SN-NS",
            Self::PeriodDoublingTorus => "PD-NS",
            Self::PitchforkTorus => "PF-NS",
            Self::TorusGrazing => "NS-GZ",
            Self::PitchforkGrazing => "PF-GZ",
        }
    }
}

/// A value for the SN curve at a resonance, and one for the PD curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair<T> {
    /// The value for the saddle-node curve.
    pub saddle_node: T,
    /// The value for the period-doubling curve.
    pub period_doubling: T,
}

impl Pair<Bifurcation> {
    /// The two bifurcations themselves.
    pub const BIFURCATIONS: Self =
        Self { saddle_node: Bifurcation::SaddleNode, period_doubling: Bifurcation::PeriodDoubling };
}

impl Pair<Condition> {
    /// The conditions that hold on the two curves.
    pub const CONDITIONS: Self =
        Self { saddle_node: Condition::SADDLE_NODE, period_doubling: Condition::PERIOD_DOUBLING };
}

impl<T> Pair<T> {
    /// The pair with a function applied to both values.
    pub fn map<U>(self, mut change: impl FnMut(T) -> U) -> Pair<U> {
        Pair { saddle_node: change(self.saddle_node), period_doubling: change(self.period_doubling) }
    }

    /// The pair with both values borrowed.
    pub const fn as_ref(&self) -> Pair<&T> {
        Pair { saddle_node: &self.saddle_node, period_doubling: &self.period_doubling }
    }

    /// The pair of both values with those of another pair.
    pub fn zip<U>(self, other: Pair<U>) -> Pair<(T, U)> {
        Pair {
            saddle_node: (self.saddle_node, other.saddle_node),
            period_doubling: (self.period_doubling, other.period_doubling),
        }
    }

    /// Both values, that of the SN curve first.
    pub fn into_array(self) -> [T; 2] {
        self.starting_with(Bifurcation::SaddleNode)
    }

    /// Both values, that of the given bifurcation first.
    pub fn starting_with(self, kind: Bifurcation) -> [T; 2] {
        let Self { saddle_node, period_doubling } = self;
        match kind {
            Bifurcation::PeriodDoubling => [period_doubling, saddle_node],
            _ => [saddle_node, period_doubling],
        }
    }

    /// Both values with their bifurcations, that of the SN curve first.
    pub fn named(self) -> [(Bifurcation, T); 2] {
        Pair::BIFURCATIONS.zip(self).into_array()
    }
}
