//! Forces under which motion is known in closed form.

use grazing_model::smooth::SmoothOscillator;

use crate::walls::described;

#[test]
fn linear_forces_with_harmonics_are_recognised_and_no_others() {
    let forced = " - 1 + B*cos(omega*t)";
    let known = [
        ("-2*zeta*v - x", 1),
        // Written in other ways.
        ("-(v*zeta + x/(1 + d) + 0.1*x)*exp(-d*B)", 1),
        ("-x - 2*zeta*(v + B*omega*sin(omega*t))", 1),
        ("-x*omega - zeta*v + d*cos(3*omega*t + 0.4)", 3),
        ("-x + d*(cos(omega*t) - 0.3)^2 + sin(omega*t)*cos(omega*t)^2", 3),
        ("-zeta*v", 1),
        ("-d", 1),
    ];
    for (force, harmonics) in known {
        let read = described(&format!("{force}{forced}"), "").expect("the force is right");
        assert_eq!(read.harmonics(), Some(harmonics), "{force}");
    }
    let unknown = [
        "-x - x^3",
        "-x - zeta*v*x",
        "-sin(x)",
        "-x - zeta*v/(1 + d*x)",
        "-x*(1 + B*cos(omega*t))",
        "-x + d*x*sin(omega*t)",
        "-x - tanh(v)",
        "-x + cos(x)",
        "-x + d*exp(cos(omega*t))",
        "-x + d/(2 + cos(omega*t))",
        "-x + d*cos(omega*t)^8",
        "-x + d*cos(omega*t + x)",
    ];
    for force in unknown {
        let read = described(&format!("{force}{forced}"), "").expect("the force is right");
        assert_eq!(read.harmonics(), None, "{force}");
    }
}

#[test]
fn a_wall_that_moves_adds_its_harmonics() {
    let seen = |position: &str| {
        let wall = format!("[wall]\nposition = \"{position}\"");
        described("-2*zeta*v - x - 1 + B*cos(omega*t)", &wall).expect("the wall is right").harmonics()
    };
    assert_eq!(["d", "d*cos(omega*t)", "0.1*sin(2*omega*t)"].map(seen), [1, 1, 2].map(Some));
    assert_eq!(seen("0.1*exp(cos(omega*t))"), None);
}
