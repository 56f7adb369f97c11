//! Tests of values that must be consistent with others in the file.

use grazing_beyond::parameters;
use grazing_input::Text;
use grazing_reproduction::figures::fig01::Figure1;
use grazing_reproduction::figures::fig02::{Figure2, frequency};
use grazing_reproduction::figures::fig07::Figure7;
use grazing_reproduction::figures::fig08::Figure8;
use grazing_reproduction::figures::fig10::Figure10;
use grazing_reproduction::parameters::{ParameterError, Parameters, contains, encloses, strictly_contains};

use super::{DEFAULT, edited, errors, refusal, refused, set};

#[test]
fn figure_7_holds_a_resonance() {
    let allowed = refusal("[fig07]", "frequency", "[0.9, 0.95]", "fig07.frequency");
    assert!(allowed.contains("no resonance"), "{allowed}");
    assert!(allowed.contains("the nearest, p = 3, n = 1"), "{allowed}");
    // One resonance is enough; that of three loops lies outside.
    assert_eq!(refused(&["fig07.frequency=[0.65, 0.82]"]), [""; 0]);
    // Resonances accumulate at zero, where there would be infinitely many.
    let allowed = refusal("[fig07]", "frequency", "[1e-9, 1.1]", "fig07.frequency");
    assert!(allowed.contains("0.05 <= lower"), "{allowed}");
}

#[test]
fn parts_lie_inside_the_whole() {
    refusal("[fig02.magnification]", "amplitude", "[0, 9]", "fig02.magnification.amplitude");
    refusal("[fig02.magnification]", "x", "[-9, 0]", "fig02.magnification.x");
    for (setting, key) in [
        ("fig02.portraits[1].amplitude=9.0", "fig02.portraits[1].amplitude"),
        ("fig08.panels[1].amplitude=[0.1, 9]", "fig08.panels[1].amplitude"),
    ] {
        assert_eq!(refused(&[setting]), [key]);
    }
}

#[test]
fn a_panel_of_figure_8_holds_its_resonance() {
    let window =
        |n| format!("fig08.panels=[{{loops=1, n={n}, amplitude=[0.5, 0.61], frequency=[0.6475, 0.6815]}}]");
    assert_eq!(refused(&[&window(3)]), [""; 0]);
    assert_eq!(refused(&[&window(5)]), ["fig08.panels[1].amplitude"]);
    assert_eq!(refused(&["fig08.panels[1].frequency=[0.7, 0.8]"]), ["fig08.panels[1].frequency"]);
    // Then only the resonance is requested, and the program chooses the window.
    let parameters = set(&["fig08.panels[1].n=2"]).expect("it is TOML");
    let panels = parameters.section::<Figure8>().expect("it is right").panels;
    let shown = panels.iter().map(|panel| (panel.loops, panel.n, panel.amplitude, panel.frequency));
    assert_eq!(shown.take(1).collect::<Vec<_>>(), [(1, 2, None, None)]);
}

#[test]
fn panels_are_about_resonances_that_the_window_holds() {
    // The last of the three resonances lies below this window.
    let parameters = set(&["fig07.frequency=[0.6, 1.02]"]).expect("it is TOML");
    let shown = parameters.section::<Figure8>().expect("it is right");
    let panels: Vec<_> = shown.panels.iter().map(|panel| (panel.loops, panel.n)).collect();
    assert_eq!(panels.len(), 3, "{panels:?}");
    let theory = parameters.oscillator().expect("it is right");
    for (index, (loops, n)) in panels.iter().enumerate() {
        let resonance = theory.resonance(*loops, *n).expect("it is one");
        let window = parameters.section::<Figure7>().expect("it is right").window();
        assert!(contains(window.primary, resonance.grazing().amplitude()), "{loops} {n}");
        assert!(contains(window.secondary, resonance.forcing_frequency()), "{loops} {n}");
        assert!(!panels[..index].contains(&(*loops, *n)), "{panels:?}");
    }
    assert!(shown.notes[0].contains("p = 3, n = 2 does not lie in the window"), "{:?}", shown.notes);
    let parameters = set(&["fig08.panels=[]"]).expect("it is TOML");
    assert_eq!(parameters.section::<Figure8>().expect("it is right").panels.len(), 3);
}

#[test]
fn panels_of_loops_that_figure_7_leaves_out_show_others() {
    let parameters = set(&["fig07.loops=[4, 7]"]).expect("it is TOML");
    let shown = parameters.section::<Figure8>().expect("none of its panels has four or seven loops");
    let panels: Vec<_> = shown.panels.iter().map(|panel| (panel.loops, panel.n)).collect();
    assert_eq!(panels.len(), 3, "{panels:?}");
    assert!(panels.iter().all(|(loops, _)| [4, 7].contains(loops)), "{panels:?}");
    let replaced = |panel: usize, p: u32| {
        let key = format!("fig08.panels[{panel}].loops");
        let instead = format!("is not among fig07.loops; the panel shows p = {}", panels[panel - 1].0);
        let told = |note: &&String| note.contains(&key) && note.contains(&format!("p = {p},"));
        shown.notes.iter().find(told).is_some_and(|note| note.contains(&instead))
    };
    assert!((1..).zip([1, 2, 3]).all(|(panel, p)| replaced(panel, p)), "{:?}", shown.notes);
    // One of them remains, and none is shown twice.
    let parameters = set(&["fig07.loops=[2]", "fig07.frequency=[0.7, 1.02]"]).expect("it is TOML");
    let shown = parameters.section::<Figure8>().expect("two of its panels have other loops");
    assert_eq!(shown.panels.iter().map(|panel| (panel.loops, panel.n)).collect::<Vec<_>>(), [(2, 1)]);
    let told = "fig07.loops; there is no such panel, as every resonance that is there is shown";
    assert!(
        shown.notes.len() == 2 && shown.notes.iter().all(|note| note.contains(told)),
        "{:?}",
        shown.notes
    );
}

#[test]
fn a_portrait_is_strictly_where_its_amplitude_is_and_otherwise_where_it_can_be() {
    let place = |settings: &[&str]| {
        let parameters = set(settings).expect("it is TOML");
        let portrait = parameters.section::<Figure2>().expect("it is right").portraits.remove(1);
        portrait.wish.map(|wish| (wish.value, wish.must))
    };
    let Some((near, false)) = place(&[]) else { panic!("the default file has wishes") };
    assert_eq!(place(&["fig02.portraits[2].amplitude=0.3"]), Some((0.3, true)));
    assert_eq!(place(&["fig02.portraits[2].near=9.5"]), Some((9.5, false)));
    assert!(near > 0.0);
    let parameters = set(&["fig02.portraits=[]"]).expect("it is TOML");
    assert!(parameters.section::<Figure2>().expect("it is right").portraits.is_empty());
}

#[test]
fn what_is_wrong_in_a_section_concerns_no_other_one() {
    let parameters = set(&["fig10.frequency=-1", "fig04.loops=[]"]).expect("it is TOML");
    assert_eq!(errors(&parameters).len(), 2);
    assert!(errors(&parameters).iter().all(|error| matches!(error, ParameterError::Malformed(_))));
    // The file's values may not suit another oscillator, which is not a mistake in the file.
    let parameters = set(&["oscillator.zeta=0.2"]).expect("it is TOML");
    for error in errors(&parameters) {
        assert!(matches!(error, ParameterError::Unfit(_)), "{error}");
    }
    let parameters = set(&["oscillator.zeta=2"]).expect("it is TOML");
    assert!(parameters.section::<Figure1>().is_ok() && parameters.section::<Figure7>().is_err());
}

#[test]
fn the_frequency_for_figure_10_that_a_refusal_names_is_accepted() {
    let parameters = set(&["fig10.frequency=0.6"]).expect("it is TOML");
    let told = parameters.section::<Figure10>().expect_err("Theorem 2.3 does not apply").to_string();
    let range = told.rsplit("they hold from ").next().expect("a remedy is told");
    for end in range.split(" to ") {
        let middle: f64 =
            range.split(" to ").map(|end| end.parse::<f64>().expect("a number")).sum::<f64>() / 2.0;
        let close: f64 = 0.999 * end.parse::<f64>().expect("a number") + 0.001 * middle;
        let parameters = set(&[&format!("fig10.frequency={close}")]).expect("it is TOML");
        assert!(parameters.section::<Figure10>().is_ok(), "{close} of {told}");
    }
}

#[test]
fn figure_2_holds_its_grazing_amplitude() {
    let grazing = |parameters: &Parameters| {
        let frequency = frequency(parameters).expect("it is right");
        parameters.oscillator().expect("it is right").grazing(frequency).expect("it grazes").amplitude()
    };
    for zeta in [0.001, 0.2, 0.9] {
        let parameters = set(&[&format!("oscillator.zeta={zeta}")]).expect("it is TOML");
        let (figure, grazing) =
            (parameters.section::<Figure2>().expect("it has a place"), grazing(&parameters));
        assert!(strictly_contains(figure.across.value, grazing), "{zeta}");
        assert!(encloses(figure.across.value, figure.magnification.amplitude), "{zeta}");
        // There is a note if it is not where the file says.
        let there = DEFAULT.contains(&format!("[{}, {}]", figure.across.value[0], figure.across.value[1]));
        assert_eq!(figure.notes.is_empty(), there, "{zeta}");
        assert!(there || strictly_contains(figure.magnification.amplitude, grazing), "{zeta}");
    }
    // A mandatory value that does not fit is rejected.
    let text = edited("[fig02]", "near", "amplitude = [0.001, 0.002]");
    let parsed = |text: &str| {
        parameters::parse(&Text::new(text, &[]), "p.toml").expect("it is TOML").section::<Figure2>()
    };
    let told = parsed(&text.replace("amplitude = [0.2704, 0.2748]", "amplitude = [0.0015, 0.002]"));
    let told = told.expect_err("grazing is elsewhere").to_string();
    assert!(
        told.contains("fig02.amplitude = [0.001, 0.002]: the range must contain the grazing amplitude"),
        "{told}"
    );
    let neither = parsed(&edited("[fig02]", "near", ""));
    assert!(neither.expect_err("it has no place").to_string().contains("fig02.near is missing"));
}

#[test]
fn portraits_and_panels_show_loops_that_are_computed() {
    let parameters = set(&["fig02.loops=[1, 2]"]).expect("it is TOML");
    let figure = parameters.section::<Figure2>().expect("it is right");
    assert!(figure.portraits.iter().all(|portrait| portrait.loops != 3), "{:?}", figure.portraits);
    let [note] = &figure.notes[..] else { panic!("{:?}", figure.notes) };
    assert!(note.contains("fig02.portraits[2].loops = 3: no such portrait"), "{note}");
    let must = set(&["fig02.loops=[1, 2]", "fig02.portraits[2].amplitude=0.27"]).expect("it is TOML");
    let told = must.section::<Figure2>().expect_err("nothing else will do").to_string();
    assert!(told.contains("fig02.portraits[2].loops = 3: the number of loops must be one of"), "{told}");
    refusal("[[fig08.panels]]", "loops", "13", "fig08.panels[1].loops");
    refusal("[[fig08.panels]]", "n", "0", "fig08.panels[1].n");
    refusal("[[fig08.panels]]", "n", "101", "fig08.panels[1].n");
}

#[test]
fn the_oscillator_of_figure_6_keeps_off_the_wall() {
    for wrong in ["0.0", "-0.1", "9", "nan"] {
        let allowed = refusal("[fig06]", "amplitude", wrong, "fig06.amplitude");
        assert!(allowed.contains("grazing amplitude"), "{allowed}");
    }
    refusal("[fig06]", "phase", "6.3", "fig06.phase");
    refusal("[fig06]", "coils", "0", "fig06.coils");
}

#[test]
fn the_path_of_figure_10_belongs_to_a_grazing_bifurcation_of_theorem_2_3() {
    // At 0.6 of the natural frequency a12 is negative; at 0.85 tau is below h_6.
    for (wrong, reason) in [("0.6", "a12 alpha"), ("0.85", "h_p")] {
        let allowed = refusal("[fig10]", "frequency", wrong, "fig10.frequency");
        assert!(allowed.contains("Theorem 2.3") && allowed.contains(reason), "{allowed}");
    }
    refusal("[fig10]", "loops", "2", "fig10.loops");
}
