//! What each key of the parameter file must hold, in words for whoever has to mend one.

use grazing_source::{Requirements, requirements};

/// The largest number of loops: higher ones do not relate to resonant grazing, and their curves are not told apart.
pub(super) const MOST_LOOPS: u32 = 12;
/// The largest integer n of a resonance; its frequency is already below a twentieth of the natural one.
pub(super) const MOST_N: u32 = 100;
/// The most portraits that fit side by side across a page.
pub(crate) const MOST_PORTRAITS: usize = 6;
/// The most panels of Figure 8 that fit side by side.
pub(super) const MOST_PANELS: usize = 3;
/// The least forcing frequency: the block swings a hundred times to and fro in one forcing period, which no figure resolves, and
/// below it the work grows without bound.
pub(super) const LEAST_FREQUENCY: f64 = 0.01;
/// The least forcing frequency of Figure 7: resonances accumulate at zero, p = 1 has 40 above this one.
pub(super) const LEAST_WINDOW_FREQUENCY: f64 = 0.05;
/// The greatest forcing frequency; the highest resonance, of p = 12 and n = 0, lies at 24.
pub(super) const MOST_FREQUENCY: f64 = 100.0;
/// The greatest forcing amplitude: ten times that of grazing at the greatest frequency.
pub(super) const MOST_AMPLITUDE: f64 = 1e5;
/// The most orbits of Figure 1: more could not be told apart.
pub(super) const MOST_ARRIVALS: usize = 8;
/// The most coils of Figure 6's spring that can be told apart in print.
pub(super) const MOST_COILS: u32 = 30;
/// The most amplitudes of Figure 2's attractor: more than the columns of any printed figure.
pub(super) const MOST_AMPLITUDES: u32 = 10_000;
/// The most orbits at one amplitude.
pub(super) const MOST_ORBITS: u32 = 1_000;
/// The most forcing periods of one orbit.
pub(super) const MOST_PERIODS: u32 = 1_000_000;
/// The most forcing periods of all orbits together, about a minute of computation.
pub(super) const MOST_PERIODS_IN_ALL: u64 = 200_000_000;

/// The requirements of a parameter file: every key with its own; members of lists of tables without their number.
pub(super) const REQUIREMENTS: Requirements = requirements! {
    otherwise "see figures/parameters.toml for what belongs here";
    "oscillator": "the table [oscillator] holds zeta and epsilon";
    "oscillator.zeta": ZETA;
    "oscillator.epsilon": EPSILON;
    "fig01": "the table [fig01] says what Figure 1 shows";
    "fig01.zeta": ZETA;
    "fig01.epsilon": EPSILON;
    "fig01.amplitude": POSITIVE_AMPLITUDE;
    "fig01.frequency": FREQUENCY;
    "fig01.velocity": AROUND_ZERO;
    "fig01.view": VIEW;
    "fig01.view.turn": TURN;
    "fig01.view.tilt": TILT;
    "fig01.view.stretch": STRETCH;
    "fig01.orbits": "[[fig01.orbits]] must be one to eight tables, one for each orbit";
    "fig01.orbits.velocity": "the velocity must not be negative, and lie inside fig01.velocity as its recoil does";
    "fig01.orbits.phase": "the phase must lie strictly between 0 and 2 pi";
    "fig01.orbits.before": "the phase before must be positive, and the orbit must begin at 0 or later";
    "fig01.orbits.after": "the phase after must be positive, and the orbit must end before 2 pi";
    "fig02": "the table [fig02] says what Figure 2 shows";
    "fig02.frequency": FREQUENCY;
    "fig02.amplitude": AMPLITUDES;
    "fig02.near": AMPLITUDES;
    "fig02.x": "the x-values must be a range [lower, upper] with -100000 <= lower < upper <= 100000";
    "fig02.loops": LOOPS;
    "fig02.magnification": "the table [fig02.magnification] holds amplitude and x";
    "fig02.magnification.amplitude":
        "the magnified amplitudes must be a range [lower, upper] inside those of Figure 2";
    "fig02.magnification.x": "the magnified x-values must be a range [lower, upper] inside fig02.x";
    "fig02.attractor": "the table [fig02.attractor] holds amplitudes, orbits, transient, recorded and seed";
    "fig02.attractor.amplitudes": "the number of amplitudes must be a whole number from 2 to 10000";
    "fig02.attractor.orbits": "the number of orbits must be a whole number from 1 to 1000";
    "fig02.attractor.transient": "the periods before recording must be a whole number from 0 to 1000000";
    "fig02.attractor.recorded": "the recorded periods must be a whole number from 1 to 1000000";
    "fig02.attractor.seed": "the seed must be a whole number that is not negative";
    "fig02.portraits":
        "[[fig02.portraits]] must be at most six tables, one for each phase portrait; without any they are chosen";
    "fig02.portraits.loops": "the number of loops must be one of fig02.loops, or 0 for the non-impacting solution";
    "fig02.portraits.amplitude": "the forcing amplitude must lie inside those of Figure 2";
    "fig02.portraits.near": "the forcing amplitude must be a number that is not negative";
    "fig03": "the table [fig03] says what Figure 3 shows";
    "fig03.zeta": ZETA;
    "fig03.frequency": FREQUENCY;
    "fig03.start": "the point must be [x, z - z_graz] with x in fig03.position and z - z_graz in fig03.phase";
    "fig03.position": AROUND_ZERO;
    "fig03.phase": "the phases must be a range [lower, upper] within 1.5 on either side of 0, with 0 inside";
    "fig03.radius": "the radius must lie above 2, which is the width of the grazing orbit, and be at most 100";
    "fig03.axes": "the phase of the axes must lie between 0 and 2 pi";
    "fig03.view": VIEW;
    "fig03.view.turn": TURN;
    "fig03.view.tilt": TILT;
    "fig03.view.stretch": STRETCH;
    "fig04": "the table [fig04] says what Figure 4 shows";
    "fig04.loops": "the numbers of loops must be a list of different whole numbers from 2 to 12, as [2, 3, 4]";
    "fig05": "the table [fig05] says what Figure 5 shows";
    "fig05.loops": "the number of loops must be a whole number from 1 to 12";
    "fig05.n": "the integer n of the resonance must be a whole number from 1 to 100, or 0 for two or more loops";
    "fig05.mu": "the values of mu must be a range [lower, upper] with lower < 0 < upper";
    "fig05.eta": "the values of eta must be a range [lower, upper] with lower < 0 < upper";
    "fig06": "the table [fig06] says what Figure 6 shows";
    "fig06.frequency": FREQUENCY;
    "fig06.amplitude": "the forcing amplitude must lie above 0 and below the grazing amplitude of fig06.frequency";
    "fig06.phase": "the phase must be a number from 0 to below 2 pi";
    "fig06.coils": "the number of coils must be a whole number from 1 to 30";
    "fig07": "the table [fig07] says what Figure 7 shows";
    "fig07.amplitude": AMPLITUDES;
    "fig07.frequency":
        "the forcing frequencies must be a range [lower, upper] with 0.05 <= lower < upper <= 100; resonances accumulate at 0";
    "fig07.loops": LOOPS;
    "fig08": "the table [fig08] holds the panels of Figure 8";
    "fig08.panels":
        "[[fig08.panels]] must be at most three tables, one for each magnification; without any they are chosen";
    "fig08.panels.loops": "the number of loops must be one of fig07.loops";
    "fig08.panels.n":
        "the integer n of the resonance must be a whole number from 1 to 100, or 0 for two or more loops";
    "fig08.panels.amplitude": "the forcing amplitudes must be a range [lower, upper] inside fig07.amplitude";
    "fig08.panels.frequency": "the forcing frequencies must be a range [lower, upper] inside fig07.frequency";
    "fig08.panels.near": "the table [fig08.panels.near] holds amplitude and frequency";
    "fig08.panels.near.amplitude": "the forcing amplitudes must be a range [lower, upper]";
    "fig08.panels.near.frequency": "the forcing frequencies must be a range [lower, upper]";
    "fig09": "the table [fig09] says what Figure 9 shows";
    "fig09.zeta": ZETA;
    "fig09.epsilon": EPSILON;
    "fig09.amplitude": POSITIVE_AMPLITUDE;
    "fig09.frequency": FREQUENCY;
    "fig09.impact": "the impact must be [y, z - z_graz] with 0 < y in fig09.velocity and z - z_graz in fig09.phase";
    "fig09.loops": "the number of loops must be a whole number from 1 to 3";
    "fig09.position": AROUND_ZERO;
    "fig09.velocity": AROUND_ZERO;
    "fig09.phase": "the phases must be a range [lower, upper] with lower < upper, not wider than 2 pi";
    "fig09.view": VIEW;
    "fig09.view.turn": TURN;
    "fig09.view.tilt": TILT;
    "fig09.view.stretch": STRETCH;
    "fig10": "the table [fig10] says what Figure 10 shows";
    "fig10.frequency": FREQUENCY;
    "fig10.loops": "the number of loops must be a whole number from 3 to 12";
};

const ZETA: &str = "the damping ratio must be a number strictly between 0 and 1";
const EPSILON: &str = "the coefficient of restitution must be a number above 0 and at most 1";
const POSITIVE_AMPLITUDE: &str = "the forcing amplitude must lie above 0 and be at most 100000";
const FREQUENCY: &str = "the forcing frequency must be a number from 0.01 to 100";
const AMPLITUDES: &str =
    "the forcing amplitudes must be a range [lower, upper] with 0 <= lower < upper <= 100000";
const AROUND_ZERO: &str =
    "the range must be [lower, upper] with lower < 0 < upper, neither end beyond 100000";
const VIEW: &str = "the table of the view holds turn, tilt and stretch";
const TURN: &str = "the turn must be an angle in degrees from -180 to 180";
const TILT: &str = "the tilt must be an angle in degrees strictly between 0 and 90";
const STRETCH: &str = "the stretch must be three positive numbers, for x, y and z";

const LOOPS: &str =
    "the numbers of loops must be a list of different whole numbers from 1 to 12, as [1, 2, 3]";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limits_are_told_as_they_are_checked() {
        for (key, limit) in [
            ("fig02.loops", MOST_LOOPS),
            ("fig04.loops", MOST_LOOPS),
            ("fig05.loops", MOST_LOOPS),
            ("fig05.n", MOST_N),
            ("fig06.coils", MOST_COILS),
            ("fig07.loops", MOST_LOOPS),
            ("fig10.loops", MOST_LOOPS),
            ("fig08.panels[2].n", MOST_N),
            ("fig02.attractor.amplitudes", MOST_AMPLITUDES),
            ("fig02.attractor.orbits", MOST_ORBITS),
            ("fig02.attractor.transient", MOST_PERIODS),
            ("fig02.attractor.recorded", MOST_PERIODS),
        ] {
            let told = format!(" to {limit}");
            let requirement = REQUIREMENTS.of(key);
            assert!(requirement.contains(&told), "{key}: `{told}` is not in: {requirement}");
        }
    }

    #[test]
    fn the_known_keys_of_a_table_are_its_own_only() {
        let figures = (1..=10).map(|number| format!("fig{number:02}"));
        let tables: Vec<String> = ["oscillator".to_owned()].into_iter().chain(figures).collect();
        assert_eq!(REQUIREMENTS.known_keys(""), tables);
        assert_eq!(
            REQUIREMENTS.known_keys("fig08.panels[3]"),
            ["loops", "n", "amplitude", "frequency", "near"]
        );
    }
}
