//! Bifurcations of codimension one and two, with their names.

use crate::locate::Condition;

/// Declares all kinds of a bifurcation, each with its row.
macro_rules! kinds {
    ($(#[$meta:meta])* $name:ident: $row:ident {
        $($(#[$about:meta])* $kind:ident { $($field:ident: $value:expr,)+ })+
    }) => {
        $(#[$meta])*
        pub enum $name { $($(#[$about])* $kind,)+ }

        impl $name {
            /// All kinds.
            pub const ALL: [Self; [$(stringify!($kind)),+].len()] = [$(Self::$kind),+];

            const fn row(self) -> $row {
                match self { $(Self::$kind => $row { $($field: $value,)+ },)+ }
            }

            /// The name, such as `SN`; two that meet as `SN-GZ`.
            pub const fn name(self) -> &'static str {
                self.row().name
            }
        }
    };
}

/// The row of a bifurcation of codimension one.
struct CodimensionOneRow {
    name: &'static str,
    /// Other names, in small letters and without blanks and hyphens.
    other_names: &'static [&'static str],
    /// The condition that holds at it.
    condition: Condition,
    /// Whether it is of solutions with impacts, or of those without; `None` if it may be of either.
    impacts: Option<bool>,
}

kinds! {
    /// A bifurcation of codimension one.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    Bifurcation: CodimensionOneRow {
        /// Grazing of the non-impacting solution: its highest point touches the wall.
        NonImpactingGrazing {
            name: "graz",
            other_names: &["nonimpactinggrazing"],
            condition: Condition::InteriorGrazing,
            impacts: Some(false),
        }
        /// Saddle-node: a multiplier is 1.
        SaddleNode {
            name: "SN",
            other_names: &["saddlenode", "fold", "lp", "lpc", "limitpoint", "limitpointofcycles", "turningpoint"],
            condition: Condition::SADDLE_NODE,
            impacts: None,
        }
        /// Period doubling: a multiplier is −1.
        PeriodDoubling {
            name: "PD",
            other_names: &["perioddoubling", "flip"],
            condition: Condition::PERIOD_DOUBLING,
            impacts: None,
        }
        /// Grazing of an MPS: a maximum between two impacts touches the wall.
        Grazing {
            name: "GZ",
            other_names: &["interiorgrazing"],
            condition: Condition::InteriorGrazing,
            impacts: Some(true),
        }
        /// Torus (Neimark-Sacker): a pair of complex multipliers has absolute value 1.
        ///
        /// The product D of the multipliers is 1 there, so there is none where motion contracts areas:
        /// for the paper's oscillator D is ε² e^{−4πζp/ω}.
        Torus {
            name: "NS",
            other_names: &["torus", "tr", "neimarksacker", "naimarksacker", "secondaryhopf"],
            condition: Condition::TORUS,
            impacts: None,
        }
        /// Pitchfork of symmetric motion without impacts: a multiplier is 1 without a fold, and two
        /// motions begin that are each other's images.
        Pitchfork {
            name: "PF",
            other_names: &["pitchfork", "symmetrybreaking"],
            condition: Condition::SymmetryBreaking,
            impacts: None,
        }
    }
}

impl Bifurcation {
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
            word == kind.name().to_ascii_lowercase() || kind.row().other_names.contains(&word.as_str())
        })
    }

    /// The bifurcation at which solutions with p loops (0 without impacts) satisfy a condition;
    /// `None` if it is no bifurcation.
    pub fn of(condition: Condition, loops: u32) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| {
            let row = kind.row();
            row.condition == condition && row.impacts.is_none_or(|impacts| impacts == (loops > 0))
        })
    }

    /// The condition that holds at the bifurcation.
    pub const fn condition(self) -> Condition {
        self.row().condition
    }
}

/// The row of a bifurcation of codimension two.
struct CodimensionTwoRow {
    name: &'static str,
    /// The curves that meet there.
    curves: [Bifurcation; 2],
}

kinds! {
    /// A bifurcation of codimension two.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
    CodimensionTwo: CodimensionTwoRow {
        /// A resonance on the grazing curve of the non-impacting solution, from which SN and PD curves
        /// leave.
        Resonance { name: "resonance", curves: [Bifurcation::SaddleNode, Bifurcation::PeriodDoubling], }
        /// An SN and a GZ curve meet.
        SaddleNodeGrazing { name: "SN-GZ", curves: [Bifurcation::SaddleNode, Bifurcation::Grazing], }
        /// A PD and a GZ curve meet.
        PeriodDoublingGrazing { name: "PD-GZ", curves: [Bifurcation::PeriodDoubling, Bifurcation::Grazing], }
        /// Two GZ curves meet: two maxima touch the wall.
        GrazingGrazing { name: "GZ-GZ", curves: [Bifurcation::Grazing, Bifurcation::Grazing], }
        /// An SN curve turns back.
        Cusp { name: "cusp", curves: [Bifurcation::SaddleNode, Bifurcation::SaddleNode], }
        /// An NS curve ends on an SN curve: both multipliers are 1.
        SaddleNodeTorus { name: "SN-NS", curves: [Bifurcation::SaddleNode, Bifurcation::Torus], }
        /// An NS curve ends on a PD curve: both multipliers are −1.
        PeriodDoublingTorus { name: "PD-NS", curves: [Bifurcation::PeriodDoubling, Bifurcation::Torus], }
        /// An NS curve ends on a PF curve: both multipliers are 1, and over half a period −1.
        PitchforkTorus { name: "PF-NS", curves: [Bifurcation::Pitchfork, Bifurcation::Torus], }
        /// An NS and a GZ curve meet.
        TorusGrazing { name: "NS-GZ", curves: [Bifurcation::Torus, Bifurcation::Grazing], }
        /// A PF and a GZ curve meet.
        PitchforkGrazing { name: "PF-GZ", curves: [Bifurcation::Pitchfork, Bifurcation::Grazing], }
    }
}

impl CodimensionTwo {
    /// The curves that meet there, in the order of the name; at a cusp, the two branches of one curve.
    pub const fn curves(self) -> [Bifurcation; 2] {
        self.row().curves
    }

    /// The bifurcation at which two curves meet, at least one of which is a GZ or an NS curve.
    pub fn of_meeting(one: Bifurcation, other: Bifurcation) -> Self {
        // Motion without impacts grazes as any other does.
        let [one, other] = [one, other].map(|kind| match kind {
            Bifurcation::NonImpactingGrazing => Bifurcation::Grazing,
            _ => kind,
        });
        let meet = |point: &Self| [[one, other], [other, one]].contains(&point.curves());
        Self::ALL.into_iter().find(meet).unwrap_or(Self::GrazingGrazing)
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
