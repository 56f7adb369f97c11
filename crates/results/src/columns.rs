//! All columns of all tables, each declared once.
//!
//! In names, `{primary}` and `{secondary}` stand for the names of the two parameters; in units, for their
//! units. Length, velocity and time are those in which an oscillator is described. The paper's oscillator
//! is dimensionless, so all its units are 1. A unit of 1 is omitted.

use crate::{Dimension, Names};

/// A column of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    /// The header, before the names of the parameters are inserted.
    pub name: &'static str,
    /// The symbol of the column in LaTeX, without dollars; empty if the header serves as the symbol.
    symbol: &'static str,
    /// The unit of its numbers.
    pub unit: &'static str,
    /// The dimension of its numbers, as the unit says.
    pub dimension: Dimension,
    /// A description of the values in the column.
    meaning: &'static str,
    /// Labels in the paper, separated by commas.
    pub equations: &'static str,
}

impl Column {
    /// The header with the names of the parameters inserted.
    pub fn header(&self, names: &Names) -> String {
        names.put_into(self.name)
    }

    /// The symbol in LaTeX, without dollars; empty where there is none.
    pub fn symbol(&self, names: &Names) -> String {
        names.symbols_put_into(self.symbol)
    }

    /// The unit of the numbers, if the file names its units; empty where there is none.
    pub fn unit(&self, names: &Names) -> String {
        if self.unit == "1" || !names.have_units() { String::new() } else { names.unit(self.unit) }
    }

    /// A description of the values in the column.
    pub fn meaning(&self) -> &'static str {
        self.meaning.trim_start()
    }
}

macro_rules! columns {
    ($($(#[doc = $meaning:literal])+ $column:ident = $name:literal, $symbol:literal, $unit:literal $(, $equations:literal)?;)+) => {$(
        $(#[doc = $meaning])+
        pub const $column: Column = Column {
            name: $name,
            symbol: $symbol,
            unit: $unit,
            dimension: $crate::Dimension::of($unit),
            meaning: concat!($($meaning),+),
            equations: concat!($($equations)?),
        };
    )+};
}

mod beyond;
mod measured;
pub use beyond::*;
pub use measured::*;

// The two parameters, and the numbers that identify solutions.
columns! {
    /// primary parameter μ; for the paper's oscillator, the forcing amplitude 𝒜
    PRIMARY = "{primary}", "{primary}", "{primary}", "eq:oscf";
    /// secondary parameter η; for the paper's oscillator, the forcing frequency ω
    SECONDARY = "{secondary}", "{secondary}", "{secondary}", "eq:oscf";
    /// primary parameter at the resonance
    PRIMARY_AT_GRAZING = "{primary}_graz", "{primary_graz}", "{primary}", "eq:Agraz";
    /// secondary parameter at the resonance
    SECONDARY_AT_RESONANCE = "{secondary}_star", "{secondary}^*", "{secondary}", "eq:resonance1, eq:resonancep";
    /// number of loops of the solution, in which it recurs: as many forcing periods; 0: non-impacting
    LOOPS = "p", "p", "1";
    /// number of impacts of the solution in p forcing periods; 0: non-impacting, 1: MPS
    SOLUTION_IMPACTS = "impacts", "K", "1";
    /// wall that is hit, from 1 in the order of the file; 0: none. Only with two walls; impact velocity and phase are those that it sees
    WALL = "{wall}", "", "1";
    /// integer n of the resonance: in one forcing period, neighbouring motion makes n half-turns (p = 1) or n whole turns (p ≥ 2); for the paper's oscillator, ω₁/ω =
    /// n/2 for p = 1 and n + 1/(2p) for p ≥ 2. A SN or PD curve has the n of the resonance that it leaves, in the window or
    /// beyond it; a GZ curve or a point that of the curves that end there, a region the greatest of those on its border; 0 without a resonance of the same p
    RESONANCE_INDEX = "n", "n", "1", "eq:resonance1, eq:resonancep";
    /// rows with the same number form one polyline, in order; in all tables of one oscillator, a number refers to the same piece of the grazing curve
    ARC = "arc", "", "1";
    /// why the curve could not be followed beyond this point, within the ranges; otherwise empty
    LOST = "lost", "", "1";
    /// whether both multipliers lie inside the unit circle; `neutral` if they lie on it, not real, and nearby motion neither approaches nor leaves
    STABLE = "stable", "", "1";
    /// whether no maximum of x between two impacts lies beyond the wall (it may touch the wall)
    ADMISSIBLE = "admissible", "", "1";
    /// reason for this result; empty where none is needed
    REASON = "reason", "", "1";
}

// Two-parameter diagrams.
columns! {
    /// `graz`: grazing of the non-impacting solution; `SN`, `PD`, `GZ`, `NS`: saddle-node, period-doubling, grazing, torus (Neimark-Sacker) bifurcation of the p-loop
    /// solution; `PF`: pitchfork, where motion loses its symmetry; for p = 0, SN, PD, NS and PF are bifurcations of the non-impacting solution. A GZ curve of solutions that are unstable on both sides bounds no region
    /// and is followed only where another curve leads to it
    BIFURCATION = "kind", "", "1";
    /// `resonance`; `SN-GZ`, `PD-GZ`, `GZ-GZ`, `NS-GZ`, `PF-GZ`, `SN-NS` or `PD-NS`, named after the curves that meet; or `cusp`, where an SN curve turns back
    CODIMENSION_TWO = "kind", "", "1";
    /// `non-impacting`: the non-impacting solution is stable and admissible; `mps`: a p-loop MPS is; `both`: both are; `several-impacts`: a solution with several impacts is; `undecided`: this could not be decided
    REGION_KIND = "kind", "", "1";
    /// velocity y of the solution's impact; of several, of that beside this row, or else the lowest
    IMPACT_VELOCITY = "impact_velocity", r"y_{\mathrm{imp}}", "length/time";
    /// z_imp − z_graz(η), reduced to (−π, π]
    IMPACT_PHASE = "impact_phase", r"z_{\mathrm{imp}}-z_{\mathrm{graz}}", "rad";
    /// sum of the multipliers, or its limit where y_imp = 0; on the grazing curve, that of the map without impacts; empty where a GZ curve ends on the grazing curve,
    /// since there is no limit
    TRACE = "trace", "T", "1", "eq:TD";
    /// product of the multipliers, with the same conventions
    DETERMINANT = "determinant", "D", "1", "eq:TD";
    /// highest local maximum of x between two impacts; empty if there is none
    MAX_INTERIOR_X = "max_interior_x", r"\max x", "length";
    /// number of the region; its rows, in order, are its vertices
    REGION = "region", "", "1";
    /// number of the ring: 0 is the outer boundary of the region, the others bound holes; a point lies inside if a ray from it crosses the rings an odd number of
    /// times
    RING = "ring", "", "1";
    /// number of the panel: 1 is (a); p and n of its resonance are in its rows with the quadratic approximations
    PANEL = "panel", "", "1";
    /// `continuation`, or `quadratic` for μ = μ_graz(η) + c (η − η*)²
    SOURCE = "source", "", "1";
    /// η: secondary parameter minus its value at the resonance
    FROM_RESONANCE = "from_resonance", r"\eta", "{secondary}";
    /// (μ − μ_graz(η))/η², as far as the curve exists; in the last row of a curve it ends or turns back
    SCALED_DISTANCE = "scaled_distance", r"({primary}-{primary_graz})/\eta^2", "{primary}/{secondary}^2";
    /// estimated relative error of the scaled distance
    RELATIVE_ERROR = "relative_error", "", "1";
    /// its theoretical limit: c_SN,p or c_PD,p, or the corresponding coefficient of a curve of solutions with more loops that leaves a resonance with p = 1
    SCALED_LIMIT = "scaled_limit", r"\lim_{\eta\to0}", "{primary}/{secondary}^2", "eq:coeffs1, eq:coeffsp";
}

// Quantities read off motion.
columns! {
    /// highest minus lowest position between impacts; for simulated motion, of everything recorded. With impacts, the highest position is the wall
    PEAK_TO_PEAK = "peak_to_peak", "", "length";
    /// m (1 + Φ) y, the momentum transferred to the wall at the impact; empty if the file gives no mass
    IMPULSE = "impulse", "", "mass*length/time";
    /// mean force on the wall: the impulses over a time, divided by that time; empty if the file gives no mass, and for motion that rests at the wall
    MEAN_FORCE = "mean_force", "", "mass*length/time^2";
    /// mean power dissipated by impacts: m/2 (1 − Φ²) y² of the impacts over a time, divided by that time; empty if the file gives no mass
    POWER = "power", "", "mass*length^2/time^3";
    /// initial state: `random`; `up`, `down`: the motion reached at the next lower, next higher value of the parameter
    SWEEP = "sweep", "", "1";
    /// number of the place, in the order of the command line
    PLACE = "place", "", "1";
    /// number of the attractor; 1 is the one that most random states reach; 0: none, as motion is not followed further or has not settled in time
    ATTRACTOR = "attractor", "", "1";
    /// number of the random states that reach it
    STATES_THAT_REACH = "states", "", "1";
    /// share of the random states that reach it
    SHARE = "share", "", "1";
    /// largest Lyapunov exponent: displacements grow like exp(λt); empty for motion that rests at the wall, which forgets its state (its multipliers are 0)
    LYAPUNOV = "lyapunov_exponent", r"\lambda", "1/time";
    /// its estimated error
    LYAPUNOV_ERROR = "lyapunov_error", "", "1/time";
    /// time; the phase of the forcing is zero at time zero
    TIME_AT_PLACE = "time", "t", "time";
    /// number of the flight between two impacts; motion without impacts is one flight
    FLIGHT = "flight", "", "1";
    /// phase of the forcing at which the motion starts, at rest
    PHASE_OF_START = "start_phase", "", "rad";
    /// position at which it starts
    X_OF_START = "start_x", "x", "length";
    /// number of the orbit among those at the same value of the parameter
    ORBIT = "orbit", "", "1";
    /// long-term behaviour: `non-impacting`, `periodic`, `chaotic`, `resting` (held at the wall by the force for a whole period), `escaping`, or `unsettled` if it could not be decided
    MOTION = "motion", "", "1";
    /// period, in forcing periods; empty if the motion is not periodic
    PERIODS = "periods", "", "1";
    /// mean number of impacts per forcing period; empty where infinitely many accumulate at the wall
    IMPACTS_PER_PERIOD = "impacts", "", "1";
    /// mean number of these impacts at the second wall, in the order of the file, per forcing period. Only with two walls
    IMPACTS_AT_SECOND_WALL = "impacts_at_{wall}_2", "", "1";
    /// mean number of rests at the wall per forcing period, each until the force turns
    RESTS_PER_PERIOD = "rests", "", "1";
    /// virtual x of the impact on Π; without impacts, the highest position
    X_OF_IMPACT = "x", "x", "length";
}

// Curves that a file requests.
columns! {
    /// name of the curve, from the file
    CURVE_NAME = "name", "", "1";
    /// property that all solutions on the curve share
    PROPERTY = "property", "", "1";
}

// Families: the constants that vary from member to member. A family with fewer than three constants has
// no columns for the first ones.
columns! {
    /// a constant of the oscillator that varies
    VARIED_1 = "{varied1}", "{varied1}", "as in the file";
    /// a constant of the oscillator that varies
    VARIED_2 = "{varied2}", "{varied2}", "as in the file";
    /// a constant of the oscillator that varies
    VARIED_3 = "{varied3}", "{varied3}", "as in the file";
    /// resonances with the same number are connected by continuation in the constant that varies first
    FAMILY_CURVE = "curve", "", "1";
    /// `search`: found along the member's grazing curve; `continuation`: followed from the previous member, because the search missed it
    FOUND_BY = "found_by", "", "1";
    /// number of resonances of the member
    RESONANCES = "resonances", "", "1";
    /// number of its other codimension-two points, as far as curves from resonances lead to them
    POINTS = "points", "", "1";
    /// what was left out or could not be computed, and why; otherwise empty
    MEMBER_REASON = "missing", "", "1";
    /// quantity that is zero
    DEGENERATE_QUANTITY = "quantity", "", "1";
    /// what its being zero means
    DEGENERATE_MEANING = "meaning", "", "1";
    /// how the curve ends, if it ends between two members; otherwise empty
    FAMILY_END = "end", "", "1";
    /// whether all hypotheses of the theorem hold
    THEOREM_HOLDS = "theorem_holds", "", "1";
    /// hypotheses that fail, with the values of their quantities; empty if all hold
    FAILING = "failing", "", "1";
}

// Coefficients and the quantities in their formulas.
columns! {
    /// s_p⁺, whose sign determines on which side of the SN curve solutions are stable
    S_PLUS = "s_plus", "s_p^+", "1", "eq:c1, eq:cp";
    /// s_p⁻, which does the same for the PD curve
    S_MINUS = "s_minus", "s_p^-", "1", "eq:c1, eq:cp";
    /// c_SN,p by the closed form of Propositions 3.2 and 3.3
    C_SN_CLOSED_FORM = "c_sn_closed_form", r"c_{\mathrm{SN},p}\text{, closed form}", "{primary}/{secondary}^2", "eq:impFormula1odd, eq:impFormula1even, eq:impFormulap";
    /// c_PD,p by the closed form of Propositions 3.2 and 3.3
    C_PD_CLOSED_FORM = "c_pd_closed_form", r"c_{\mathrm{PD},p}\text{, closed form}", "{primary}/{secondary}^2", "eq:impFormula1odd, eq:impFormula1even, eq:impFormulap";
    /// c_SN,p by Theorem 2.4 or 2.5: μ = μ_graz(η) + c (η − η*)² to leading order along the SN curve
    C_SN = "c_sn", r"c_{\mathrm{SN},p}", "{primary}/{secondary}^2", "eq:coeffs1, eq:coeffsp";
    /// c_PD,p by Theorem 2.4 or 2.5, the same along the PD curve
    C_PD = "c_pd", r"c_{\mathrm{PD},p}", "{primary}/{secondary}^2", "eq:coeffs1, eq:coeffsp";
    /// error of the theorem's value: rounding, and the disagreement between differences of first derivatives and the second derivatives in the formula
    C_SN_ERROR = "c_sn_error", r"\Delta c_{\mathrm{SN},p}", "{primary}/{secondary}^2";
    /// the same for c_PD,p
    C_PD_ERROR = "c_pd_error", r"\Delta c_{\mathrm{PD},p}", "{primary}/{secondary}^2";
    /// limit of (μ − μ_graz)/(η − η*)² along the continued SN curve; empty if it cannot be measured
    C_SN_FIT = "c_sn_fit", r"c_{\mathrm{SN},p}\text{, curve}", "{primary}/{secondary}^2";
    /// the same along the PD curve
    C_PD_FIT = "c_pd_fit", r"c_{\mathrm{PD},p}\text{, curve}", "{primary}/{secondary}^2";
    /// estimated error of the measured value
    C_SN_FIT_ERROR = "c_sn_fit_error", r"\Delta c_{\mathrm{SN},p}\text{, curve}", "{primary}/{secondary}^2";
    /// estimated error of the measured value
    C_PD_FIT_ERROR = "c_pd_fit_error", r"\Delta c_{\mathrm{PD},p}\text{, curve}", "{primary}/{secondary}^2";
    /// `agree`: theorem and SN curve differ by less than their errors; `not measurable`: one of them is not known to two digits; `contradict`: they differ by more
    /// (exit code 1)
    SN_VERDICT = "sn_verdict", "", "1";
    /// why the verdict on the SN curve is not `agree`
    SN_REASON = "sn_reason", "", "1";
    /// the same for the PD curve
    PD_VERDICT = "pd_verdict", "", "1";
    /// why the verdict on the PD curve is not `agree`
    PD_REASON = "pd_reason", "", "1";
    /// whether event-driven simulation of the hybrid system on both sides of the SN curve agrees with the theorem, at an impact velocity at which the leading terms
    /// dominate: `yes`, `no` (exit code 1) or `undecided`
    SN_AS_SIMULATED = "sn_as_simulated", "", "1";
    /// why the answer is not `yes`
    SN_SIMULATION_REASON = "sn_simulation_reason", "", "1";
    /// the same for the PD curve
    PD_AS_SIMULATED = "pd_as_simulated", "", "1";
    /// why the answer is not `yes`
    PD_SIMULATION_REASON = "pd_simulation_reason", "", "1";
    /// limit at the resonance of y² times the normal-form coefficient of the period doubling: positive if supercritical, negative if subcritical
    PD_CRITICALITY = "pd_criticality", "", "1";
    /// trace of A
    TAU = "tau", r"\tau", "1", "eq:A";
    /// determinant of A
    DELTA = "delta", r"\delta", "1", "eq:A";
    /// factor of the square-root term
    ALPHA = "alpha", r"\alpha", "1", "eq:alpha";
    /// transversality coefficient (1 − a₂₂) b₁ + a₁₂ b₂
    BETA = "beta", r"\beta", "length/{primary}", "eq:beta";
    /// −F at the wall, the deceleration at grazing
    GAMMA = "gamma", r"\gamma", "length/time^2", "eq:phipsigamma";
    /// Φ at grazing: the restitution in the limit of zero impact velocity
    PHI = "phi", r"\phi", "1", "eq:phipsigamma";
    /// Ψ at grazing: the phase that an impact takes, divided by its velocity
    PSI = "psi", r"\psi", "rad time/length", "eq:phipsigamma";
    /// κ_p, whose zero is the resonance for p ≥ 2, like that of a₁₂ for p = 1; empty for p = 1
    KAPPA = "kappa", r"\kappa_p", "1", "eq:gp";
    /// ξ_p, the second derivative with respect to phase in the coefficients
    XI = "xi", r"\xi_p", "length", "eq:xi";
    /// a₁₂', the derivative with respect to η along the grazing curve, for p = 1; otherwise empty
    A12_PRIME = "a12_prime", "a_{12}'", "length/{secondary}", "eq:xi1proof5";
    /// κ_p', the derivative with respect to η along the grazing curve, for p ≥ 2; otherwise empty
    KAPPA_PRIME = "kappa_prime", r"\kappa_p'", "1/{secondary}", "eq:xipproof5";
    /// z_graz, continuous along each piece of the curve
    GRAZING_PHASE = "phase", r"z_{\mathrm{graz}}", "rad";
    /// the forcing frequency ω
    FREQUENCY = "frequency", r"\omega", "1/time";
    /// entry of A, the derivative of the Poincaré map P_global with respect to (x, z) at grazing
    A11 = "a11", "a_{11}", "1", "eq:A";
    /// entry of A
    A12 = "a12", "a_{12}", "length", "eq:A";
    /// entry of A
    A21 = "a21", "a_{21}", "1/length", "eq:A";
    /// entry of A
    A22 = "a22", "a_{22}", "1", "eq:A";
    /// entry of b, the derivative of P_global with respect to μ at grazing
    B1 = "b1", "b_1", "length/{primary}", "eq:b";
    /// entry of b
    B2 = "b2", "b_2", "1/{primary}", "eq:b";
    /// hypothesis of the theorem, such as `a12 alpha > 0`
    HYPOTHESIS = "hypothesis", "", "1";
    /// value of the left-hand side of the hypothesis; its unit is that of the quantity
    HYPOTHESIS_VALUE = "value", "", "that of the quantity";
    /// whether the hypothesis holds
    HOLDS = "holds", "", "1";
}

// One-parameter diagrams.
columns! {
    /// x on the Poincaré section Π; virtual and positive on loop p, which has the impact
    X_ON_SECTION = "x", "x", "length";
    /// number of the one-parameter diagram, as in the name of its figure
    DIAGRAM = "diagram", "", "1";
    /// phase z of the impact, reduced to (−π, π]; empty without an impact
    PHASE_OF_IMPACT = "z", r"z_{\mathrm{imp}}", "rad";
    /// number of the loop, 1 to p
    LOOP = "loop", "", "1";
    /// rows with the same number form one curve, in order
    BRANCH = "branch", "", "1";
    /// number of the phase portrait: 1 is (a)
    PORTRAIT = "portrait", "", "1";
    /// `periodic` or `attractor`
    PORTRAIT_KIND = "kind", "", "1";
    /// time since the start of the orbit; an empty row follows each flight between two impacts
    TIME = "time", "t", "time";
    /// position
    X = "x", "x", "length";
    /// velocity
    Y = "y", "y", "length/time";
}

// Scenes in phase space.
columns! {
    /// `orbit`, `virtual` (continued beyond the wall), `periodic` (Γ), `reset` (R, from impact to recoil), `global` (P_global: a line from a point to its image)
    SPACE_CURVE = "kind", "", "1";
    /// `incoming`, `outgoing`, `section` (outlines), `tangency`, `circle` (x = y = 0), `x_axis`, `y_axis`, `z_axis`
    SPACE_SURFACE = "kind", "", "1";
    /// `impact`, `recoil`, `graze`, `virtual` (x̂, 0, ẑ), `section` (on Π)
    SPACE_MARK = "kind", "", "1";
    /// number of the curve or surface; for points, the number of the orbit or the j of (x⁽ʲ⁾, 0, z⁽ʲ⁾), and in Figure 3, 0 for the point and 1 for its image
    NUMBER = "number", "", "1";
    /// part of a curve or surface: rows with the same number and piece form one polyline, in order
    PIECE = "piece", "", "1";
    /// painting order: 0 to 2 behind Σ (below, on and above Π), 3 on Σ, 4 to 6 in front of Σ; in Figure 3 only 0 to 2. A point has the layer directly in front of it
    LAYER = "layer", "", "1";
    /// phase z: in Figure 1 within [0, 2π); in Figures 3 and 9 continuous, and near z_graz on Π
    Z = "z", "z", "rad";
    /// position after projection, to the right; like the next two, a length in stretched phase space
    ACROSS = "across", "", "1";
    /// position after projection, upwards
    UP = "up", "", "1";
    /// position after projection, away from the viewer
    DEPTH = "depth", "", "1";
}

// Figures 4, 5, 6 and 10.
columns! {
    /// `trapesium` (its outline), `limit` (2√δ), `g` or `h`
    BOUNDARY = "kind", "", "1", "eq:cT, eq:gp, le:admissibilityBoundary";
    /// `fig02`: the grazing bifurcation of Figure 2
    STAR = "kind", "", "1";
    /// 𝒜 − 𝒜_graz(ω)
    MU = "mu", r"\mu", "1";
    /// ω minus its value at the resonance
    ETA = "eta", r"\eta", "1";
    /// part of the drawing
    PART = "part", "", "1";
    /// coordinate perpendicular to x, in the unit of x
    HEIGHT = "height", "", "1";
    /// number j of the visit to Π, from 0 to p
    VISIT = "visit", "j", "1";
    /// u⁽ʲ⁾, the scaled x of the visit
    U = "u", "u", "1", "eq:ujwj";
    /// w⁽ʲ⁾, the scaled z of the visit
    W = "w", "w", "1", "eq:ujwj";
}

// Theorems 2.2 to 2.5 in action.
columns! {
    /// number of the theorem, `2.2` to `2.5`
    THEOREM = "theorem", "", "1";
    /// damping ratio ζ
    ZETA = "zeta", r"\zeta", "1", "eq:oscf";
    /// coefficient of restitution ε
    EPSILON = "epsilon", r"\epsilon", "1", "eq:oscf";
    /// forcing frequency
    OMEGA = "omega", r"\omega", "1", "eq:oscf";
    /// δ + 1 − |τ|
    TRAPESIUM_MARGIN = "trapesium_margin", r"\delta+1-|\tau|", "1", "eq:cT";
    /// a₁₂ α
    A12_ALPHA = "a12_alpha", r"a_{12}\alpha", "1";
    /// τ − h_p(δ), if the theorem has a hypothesis on it
    TAU_MINUS_H = "tau_minus_h", r"\tau-h_p(\delta)", "1", "le:admissibilityBoundary";
    /// a₁₂ β, if the theorem has a hypothesis on it
    A12_BETA = "a12_beta", r"a_{12}\beta", "1";
    /// β κ_p, if the theorem has a hypothesis on it
    BETA_KAPPA = "beta_kappa", r"\beta\kappa_p", "1";
    /// sign of μ by the theorem, or `silent`
    PREDICTED = "predicted", "", "1";
    /// sign of μ for which y > 0 and no interior loop meets the wall, by the first-order terms of section 4; `none` if there is none
    FIRST_ORDER = "first_order", "", "1";
    /// sign of μ for which the MPS is found by following the branch from grazing
    CONTINUATION = "continuation", "", "1";
    /// the same by simulating the hybrid system from the impact of every solution that could be an MPS
    SIMULATION = "simulation", "", "1";
    /// whether the MPS is unstable, by its multipliers
    UNSTABLE_BRANCH = "unstable_branch", "", "1";
    /// whether the MPS is unstable, by simulation of nearby orbits
    UNSTABLE_SIMULATION = "unstable_simulation", "", "1";
    /// slope of the impact velocity at grazing, by section 4
    DY_DMU = "dy_dmu", r"\mathrm{d}y/\mathrm{d}\mu", "1";
    /// slope of the impact phase at grazing, by section 4
    DZ_DMU = "dz_dmu", r"\mathrm{d}z/\mathrm{d}\mu", "1";
    /// the first slope, by a quadratic equation for the impact velocity
    DY_DMU_EXACT = "dy_dmu_exact", r"\mathrm{d}y/\mathrm{d}\mu\text{, exact}", "1";
    /// the second slope, likewise
    DZ_DMU_EXACT = "dz_dmu_exact", r"\mathrm{d}z/\mathrm{d}\mu\text{, exact}", "1";
    /// the first slope, measured along the branch
    DY_DMU_FIT = "dy_dmu_fit", r"\mathrm{d}y/\mathrm{d}\mu\text{, branch}", "1";
    /// the second slope, likewise
    DZ_DMU_FIT = "dz_dmu_fit", r"\mathrm{d}z/\mathrm{d}\mu\text{, branch}", "1";
    /// largest relative difference between the slopes
    SLOPE_DIFFERENCE = "slope_difference", "", "1";
    /// `agreement`: all hypotheses hold and the whole conclusion is observed; `explained`: a hypothesis fails, and the observations are as this leads one to expect;
    /// `unexplained`: anything else. No row is unexplained
    VERDICT = "verdict", "", "1";
    /// which resonance: ω₁/ω = n/2, n + 1/(2p), or n − 1/(2p), where MPSs are virtual
    RATIO = "ratio", "", "1", "eq:resonance1, eq:resonancep";
    /// E_p
    E_P = "e_p", "E_p", "1", "eq:Ep";
    /// ε E_p, which is 1 where s_p⁺ (for p = 1 and even n: s_1⁻) vanishes
    EPSILON_E_P = "epsilon_e_p", r"\epsilon E_p", "1";
    /// a₁₂' or κ_p'
    UNFOLDING = "unfolding", "", "1";
    /// sign of η for which the saddle-node curve exists, by the theorem
    SN_PREDICTED = "sn_predicted", "", "1";
    /// the same by following the curve
    SN_CONTINUATION = "sn_continuation", "", "1";
    /// the same by simulation
    SN_SIMULATION = "sn_simulation", "", "1";
    /// whether a multiplier crosses 1 between MPSs on either side of the curve, by simulated derivatives
    SN_CROSSED = "sn_crossed", "", "1";
    /// whether simulated orbits approach one of these MPSs and leave the other; empty if |D| ≥ 1 or no curve was found
    SN_STABILITY_CHANGES = "sn_stability_changes", "", "1";
    /// limit of μ/η² along the curve given by the quadratic equation
    C_SN_EXACT = "c_sn_exact", r"c_{\mathrm{SN},p}\text{, exact}", "1";
    /// largest relative difference of the closed form and the exact limit from the theorem's value
    C_SN_DIFFERENCE = "c_sn_difference", "", "1";
    /// relative difference of the measured coefficient from the theorem's value
    C_SN_FIT_DIFFERENCE = "c_sn_fit_difference", "", "1";
    /// sign of η for which the curve with multiplier −1 exists, by the theorem
    PD_PREDICTED = "pd_predicted", "", "1";
    /// the same by following the curve
    PD_CONTINUATION = "pd_continuation", "", "1";
    /// the same by simulation
    PD_SIMULATION = "pd_simulation", "", "1";
    /// whether a multiplier crosses −1 between MPSs on either side of the curve, by simulated derivatives
    PD_CROSSED = "pd_crossed", "", "1";
    /// whether simulated orbits approach one of these MPSs and leave the other; empty if |D| ≥ 1 or no curve was found
    PD_STABILITY_CHANGES = "pd_stability_changes", "", "1";
    /// limit of μ/η² along the curve given by the quadratic equation
    C_PD_EXACT = "c_pd_exact", r"c_{\mathrm{PD},p}\text{, exact}", "1";
    /// largest relative difference of the closed form and the exact limit from the theorem's value
    C_PD_DIFFERENCE = "c_pd_difference", "", "1";
    /// relative difference of the measured coefficient from the theorem's value
    C_PD_FIT_DIFFERENCE = "c_pd_fit_difference", "", "1";
}
