//! The behaviour of an oscillator at one place of the parameter plane.

use crate::{Stability, brief, dimensioned, rows, tables};

rows! {
    /// An attractor that some of the initial states lead to.
    PlaceAttractor {
        place: u32 = PLACE,
        secondary: f64 = SECONDARY,
        primary: f64 = PRIMARY,
        attractor: u32 = ATTRACTOR,
        states: u32 = STATES_THAT_REACH,
        share: f64 = SHARE,
        motion: &'static str = MOTION,
        periods: f64 = PERIODS,
        impacts: f64 = IMPACTS_PER_PERIOD,
        second: f64 = IMPACTS_AT_SECOND_WALL,
        rests: f64 = RESTS_PER_PERIOD,
        exponent: f64 = LYAPUNOV,
        exponent_error: f64 = LYAPUNOV_ERROR,
    }

    /// A periodic solution; p = 0 means without impacts.
    PlaceSolution {
        place: u32 = PLACE,
        loops: u32 = LOOPS,
        impacts: u32 = SOLUTION_IMPACTS,
        wall: u32 = WALL,
        impact_velocity: f64 = IMPACT_VELOCITY,
        impact_phase: f64 = PHASE_OF_IMPACT,
        trace: f64 = TRACE,
        determinant: f64 = DETERMINANT,
        stable: Stability = STABLE,
        admissible: bool = ADMISSIBLE,
    }

    /// A point of the motion on an attractor.
    PlaceMotion {
        place: u32 = PLACE,
        attractor: u32 = ATTRACTOR,
        flight: u32 = FLIGHT,
        time: f64 = TIME_AT_PLACE,
        x: f64 = X,
        y: f64 = Y,
    }

    /// An impact on an attractor.
    PlaceImpact {
        place: u32 = PLACE,
        attractor: u32 = ATTRACTOR,
        wall: u32 = WALL,
        impact_phase: f64 = PHASE_OF_IMPACT,
        impact_velocity: f64 = IMPACT_VELOCITY,
    }

    /// An initial state at rest on a lattice, with the attractor that it leads to.
    BasinState {
        place: u32 = PLACE,
        start_phase: f64 = PHASE_OF_START,
        start_x: f64 = X_OF_START,
        motion: &'static str = MOTION,
        attractor: u32 = ATTRACTOR,
    }

    /// A point of motion from a given state.
    SimulatedMotion {
        flight: u32 = FLIGHT,
        time: f64 = TIME_AT_PLACE,
        x: f64 = X,
        y: f64 = Y,
    }

    /// An impact of motion from a given state.
    SimulatedImpact {
        time: f64 = TIME_AT_PLACE,
        wall: u32 = WALL,
        impact_phase: f64 = PHASE_OF_IMPACT,
        impact_velocity: f64 = IMPACT_VELOCITY,
    }
}

tables! {
    /// Motion from a given state.
    MotionFromState {
        motion: SimulatedMotion = "simulated_motion", "a point of the motion",
        impacts: SimulatedImpact = "simulated_impacts", "an impact",
        ;
        /// How the motion ends.
        end: String,
    }

    /// The results for one place, or for several.
    AtPlace {
        attractors: PlaceAttractor = "place_attractors", "an attractor at a place, with the random initial states that reach it",
        solutions: PlaceSolution = "place_solutions", "a periodic solution at a place, stable or not",
        motion: PlaceMotion = "place_motion", "a point of the motion on an attractor",
        impacts: PlaceImpact = "place_impacts", "an impact on an attractor",
        basins: BasinState = "place_basins", "an initial state at rest, with the attractor that it reaches",
        ;
        /// The number of the place, from 1.
        place: u32,
        /// The primary and the secondary parameter there.
        at: [f64; 2],
        /// The number of random initial states.
        states: u32,
        /// The forcing period.
        period: f64,
        /// Whether positions are measured from the wall because the wall is not at x = 0 with the motion
        /// below it.
        from_the_wall: bool,
        /// The numbers of initial states across and up in the pictures of basins.
        lattice: [u32; 2],
    }
}

dimensioned! {
    MotionFromState, |own| {
        own.motion,
        own.impacts,
    }

    AtPlace, |own| {
        own.attractors,
        own.solutions,
        own.motion,
        own.impacts,
        own.basins,
        own.at[0] => "{primary}",
        own.at[1] => "{secondary}",
        own.period => "time",
    }
}

impl AtPlace {
    /// The attractor with a number in the tables.
    pub fn attractor(&self, number: u32) -> Option<&PlaceAttractor> {
        self.attractors.iter().find(|one| one.attractor == number)
    }

    /// The admissible solutions that nearby motion neither approaches nor leaves, so that no attractor shows them.
    pub fn neutral(&self) -> impl Iterator<Item = &PlaceSolution> {
        self.solutions.iter().filter(|one| one.stable == Stability::Neutral && one.admissible)
    }

    /// The number of states of the lattice whose motion has not settled in time.
    pub fn undecided(&self) -> usize {
        self.basins.iter().filter(|state| state.attractor == 0).count()
    }
}

/// The number of loops p of an MPS, or 0 for motion without impacts of one period, from the period (in
/// forcing periods) and the numbers of impacts and of rests per forcing period; nothing for other motion.
pub fn loops(periods: f64, [impacts, rests]: [f64; 2]) -> Option<u32> {
    match () {
        () if rests > 0.0 => None,
        () if impacts == 0.0 && periods == 1.0 => Some(0),
        () if (periods * impacts - 1.0).abs() < 0.5 => Some(periods as u32),
        () => None,
    }
}

/// The solutions with so many impacts in so many forcing periods, briefly: `p = 2` with one impact, and
/// `3 impacts in 2 periods` with more.
pub fn briefly([impacts, periods]: [u32; 2]) -> String {
    match impacts {
        0 | 1 => format!("p = {periods}"),
        _ => struck(periods.into(), [f64::from(impacts) / f64::from(periods), 0.0]),
    }
}

fn several(count: f64, what: &str) -> String {
    format!("{count:.0} {what}{}", if count > 1.5 { "s" } else { "" })
}

/// The impacts and the rests of periodic motion in words, from the period (in forcing periods) and their
/// numbers per forcing period: "3 impacts in 2 periods", "1 impact and a rest in 1 period", or, with
/// infinitely many impacts that accumulate, "chatter and a rest in 1 period".
pub fn struck(periods: f64, [impacts, rests]: [f64; 2]) -> String {
    let [impacts, rests] = [impacts, rests].map(|rate| periods * rate);
    let rest = if rests > 1.5 { several(rests, "rest") } else { "a rest".to_owned() };
    let what = match () {
        () if impacts.is_infinite() => format!("chatter and {rest}"),
        () if rests > 0.0 => format!("{} and {rest}", several(impacts, "impact")),
        () => several(impacts, "impact"),
    };
    format!("{what} in {}", several(periods, "period"))
}

impl PlaceSolution {
    /// A description of the solution in words.
    pub fn words(&self) -> String {
        let velocity = brief(self.impact_velocity, 4);
        match self.impacts {
            0 => "motion without impacts".to_owned(),
            1 => format!("the MPS with p = {} and impact velocity {velocity}", self.loops),
            impacts => format!(
                "the solution with {} and lowest impact velocity {velocity}",
                briefly([impacts, self.loops])
            ),
        }
    }
}

impl PlaceAttractor {
    /// What is hit between two walls: "2 impacts at wall 1 and 1 at wall 2 in 1 period".
    fn walls(&self) -> String {
        let [first, second, rests] =
            [self.impacts - self.second, self.second, self.rests].map(|rate| self.periods * rate);
        let impacts = match (first > 0.5, second > 0.5) {
            (true, true) => format!("{} at wall 1 and {second:.0} at wall 2", several(first, "impact")),
            (true, false) => format!("{} at wall 1", several(first, "impact")),
            _ => format!("{} at wall 2", several(second, "impact")),
        };
        let rest = match rests {
            rests if rests > 1.5 => format!(" and {}", several(rests, "rest")),
            rests if rests > 0.0 => " and a rest".to_owned(),
            _ => String::new(),
        };
        format!("{impacts}{rest} in {}", several(self.periods, "period"))
    }

    /// The number of loops p of an MPS, or 0 for motion without impacts of one period; nothing for other
    /// motion.
    pub fn loops(&self) -> Option<u32> {
        loops(self.periods, [self.impacts, self.rests])
    }

    /// A description of the attractor in words.
    pub fn words(&self) -> String {
        match self.loops() {
            _ if self.second.is_finite() && self.impacts.is_finite() && self.periods * self.impacts > 0.5 => {
                self.walls()
            }
            Some(0) => "no impacts".to_owned(),
            Some(p) => format!("MPS, $p={p}$"),
            None if self.periods.is_nan() => self.motion.to_owned(),
            None if self.impacts == 0.0 => format!("no impacts, {}", several(self.periods, "period")),
            None => struck(self.periods, [self.impacts, self.rests]),
        }
    }
}
