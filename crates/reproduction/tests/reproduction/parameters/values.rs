//! Tests of values that are invalid by themselves.

use grazing_reproduction::parameters::Parameters;

use super::{edited, parse, refusal, refusal_quoting};

#[test]
fn damping_ratio_lies_strictly_between_0_and_1() {
    for wrong in ["0", "0.0", "1", "-0.5", "1.5", "nan", "inf", "-inf", "\"small\"", "[0.1]", "true"] {
        let allowed = refusal("[oscillator]", "zeta", wrong, "oscillator.zeta");
        assert!(allowed.contains("between 0 and 1"), "{allowed}");
    }
    // The resonances differ little from those of the default damping, so the windows contain them.
    let slight = parse(&edited("[oscillator]", "zeta", "zeta = 0.01"));
    assert_eq!(slight.map(|parameters| parameters.oscillator().map(|of| of.damping_ratio())), Ok(Ok(0.01)));
}

#[test]
fn restitution_lies_above_0_and_may_be_1() {
    for wrong in ["0", "-0.1", "1.0000001", "nan"] {
        refusal("[oscillator]", "epsilon", wrong, "oscillator.epsilon");
    }
    let elastic = parse(&edited("[oscillator]", "epsilon", "epsilon = 1"));
    let epsilon = |parameters: Parameters| parameters.oscillator().map(|of| of.coefficient_of_restitution());
    assert_eq!(elastic.map(epsilon), Ok(Ok(1.0)));
}

#[test]
fn ranges_are_two_finite_numbers_and_run_upwards() {
    for wrong in ["[0.3, 0.3]", "[0.4, 0.2]", "[nan, 0.4]", "[0.2, inf]", "[0.2]", "[0.2, 0.3, 0.4]", "0.3"] {
        refusal("[fig02]", "near", wrong, "fig02.near");
        refusal("[fig02]", "x", wrong, "fig02.x");
        refusal("[fig07]", "frequency", wrong, "fig07.frequency");
        refusal("[[fig08.panels]]", "frequency", wrong, "fig08.panels[1].near.frequency");
    }
    refusal("[fig07]", "amplitude", "[-0.1, 1.3]", "fig07.amplitude");
    refusal("[fig07]", "frequency", "[0, 1.1]", "fig07.frequency");
}

#[test]
fn loops_are_different_whole_numbers_from_1_on() {
    for section in ["fig02", "fig07"] {
        let (table, key) = (format!("[{section}]"), format!("{section}.loops"));
        for (wrong, culprit) in [
            ("[0, 1]", "0"),
            ("[1, -2]", "-2"),
            ("[1, 2.0]", "2.0"),
            ("[13]", "13"),
            ("[]", "[]"),
            ("1", "1"),
        ] {
            refusal_quoting(culprit, &table, "loops", wrong, &key);
        }
        let allowed = refusal(&table, "loops", "[1, 2, 1]", &key);
        assert!(allowed.contains("twice"), "{allowed}");
    }
}

#[test]
fn boundaries_in_the_trapesium_begin_with_two_loops() {
    refusal_quoting("1", "[fig04]", "loops", "[2, 1]", "fig04.loops");
    refusal("[fig04]", "loops", "[]", "fig04.loops");
    refusal_quoting("13", "[fig04]", "loops", "[13]", "fig04.loops");
}

#[test]
fn figure_5_is_about_a_resonance_with_both_parameters_around_zero() {
    refusal("[fig05]", "n", "101", "fig05.n");
    for key in ["mu", "eta"] {
        for wrong in ["[0.0, 0.1]", "[-0.1, 0.0]", "[0.1, -0.1]", "[-0.1]"] {
            refusal("[fig05]", key, wrong, &format!("fig05.{key}"));
        }
    }
}

#[test]
fn the_work_of_the_attractor_is_bounded() {
    let section = "[fig02.attractor]";
    refusal(section, "amplitudes", "1", "fig02.attractor.amplitudes");
    refusal(section, "orbits", "0", "fig02.attractor.orbits");
    refusal(section, "recorded", "0", "fig02.attractor.recorded");
    refusal(section, "seed", "-1", "fig02.attractor.seed");
    let allowed = refusal(section, "transient", "999999", "fig02.attractor.transient");
    assert!(allowed.contains("forcing periods"), "{allowed}");
}

#[test]
fn views_stand_above_the_plane_and_stretches_are_three_positive_numbers() {
    for figure in ["fig01", "fig03", "fig09"] {
        let section = format!("[{figure}.view]");
        for (key, wrongs) in [
            ("turn", vec!["181", "-200.0", "nan"]),
            ("tilt", vec!["0", "90", "-10", "inf"]),
            ("stretch", vec!["[1.0, 1.0]", "[1.0, 0.0, 1.0]", "[1, 1, 1, 1]", "[1.0, nan, 1.0]", "1.0"]),
        ] {
            for wrong in wrongs {
                refusal(&section, key, wrong, &format!("{figure}.view.{key}"));
            }
        }
    }
}

#[test]
fn surfaces_of_the_scenes_hold_the_wall_and_the_points_given() {
    refusal("[fig01]", "velocity", "[0.1, 1.0]", "fig01.velocity");
    refusal("[fig03]", "position", "[-1.0, -0.5]", "fig03.position");
    refusal("[fig03]", "phase", "[-2.0, 0.5]", "fig03.phase");
    refusal("[fig03]", "start", "[-5.0, 0.0]", "fig03.start");
    refusal("[fig03]", "radius", "2.0", "fig03.radius");
    refusal("[fig03]", "axes", "7.0", "fig03.axes");
    refusal("[fig09]", "position", "[0, 1]", "fig09.position");
    refusal("[fig09]", "phase", "[-4.0, 4.0]", "fig09.phase");
    refusal("[fig09]", "impact", "[0.0, 0.0]", "fig09.impact");
    refusal("[fig09]", "impact", "[9.0, 0.0]", "fig09.impact");
    refusal("[fig09]", "loops", "4", "fig09.loops");
    for figure in ["fig01", "fig09"] {
        let section = format!("[{figure}]");
        refusal(&section, "zeta", "1", &format!("{figure}.zeta"));
        refusal(&section, "epsilon", "1.5", &format!("{figure}.epsilon"));
        refusal(&section, "amplitude", "0", &format!("{figure}.amplitude"));
        refusal(&section, "frequency", "-1", &format!("{figure}.frequency"));
    }
}

#[test]
fn orbits_of_figure_1_stay_within_one_period_of_the_phase() {
    let section = "[[fig01.orbits]]";
    refusal(section, "velocity", "-0.5", "fig01.orbits[1].velocity");
    refusal(section, "velocity", "9.0", "fig01.orbits[1].velocity");
    refusal(section, "phase", "6.3", "fig01.orbits[1].phase");
    refusal(section, "before", "4.0", "fig01.orbits[1].before");
    refusal(section, "after", "5.0", "fig01.orbits[1].after");
}
