//! Names of parameters and units in headings and titles.

use grazing_results::{Names, UnitNames, symbol};

#[test]
fn units_have_the_names_that_a_file_gives_them() {
    let names = Names::new("F_0", "omega");
    assert_eq!(names.unit("length/{primary}"), "length/F_0");
    let some = |unit: &str| Some(unit.to_owned());
    let units = UnitNames {
        length: some("mm"),
        time: some("s"),
        mass: None,
        primary: some("N"),
        secondary: some("rad/s"),
    };
    let force = "mass*length/time^2";
    assert_eq!(names.clone().with_units(units.clone()).named_unit(force), None);
    let weighed = UnitNames { mass: some("kg"), ..units.clone() };
    assert_eq!(names.clone().with_units(weighed).named_unit(force), some("kg*mm/s^2"));
    let partly = UnitNames { primary: None, ..units.clone() };
    assert_eq!(names.clone().with_units(partly).named_unit("{primary}/{secondary}^2"), None);
    let named = names.with_units(units);
    let shown = ["length/time^2", "{primary}/{secondary}^2", "{secondary}", "rad time/length", "1"];
    let wanted = ["mm/s^2", "N/(rad/s)^2", "rad/s", "rad s/mm", "1"];
    assert_eq!(shown.map(|declared| named.unit(declared)), wanted);
    assert_eq!(shown.map(|declared| named.named_unit(declared)), wanted.map(some));
    assert_eq!(named.titles(), ["$F_{0}$ (N)", r"$\omega$ (rad/s)"]);
    for (unit, title) in [
        ("m/s^2", "$a$ (m/s$^{2}$)"),
        ("m s⁻²", "$a$ (m s$^{-2}$)"),
        ("m s^-2 kg^10", "$a$ (m s$^{-2}$ kg$^{10}$)"),
        ("a^b", "$a$ (a^b)"),
    ] {
        let units = UnitNames { primary: some(unit), ..UnitNames::default() };
        assert_eq!(Names::new("a", "f").with_units(units).titles()[0], title);
    }
}

#[test]
fn names_become_letters_words_and_subscripts() {
    for (name, latex) in [
        ("A", "A"),
        ("omega", r"\omega"),
        ("Omega", r"\Omega"),
        ("F_0", "F_{0}"),
        ("F0", "F_{0}"),
        ("omega_2", r"\omega_{2}"),
        ("omega12", r"\omega_{12}"),
        ("kappa_max", r"\kappa_{\mathrm{max}}"),
        ("F_0_x", "F_{0,x}"),
        ("k_x1", "k_{x1}"),
        ("x_omega", r"x_{\omega}"),
        ("amplitude", r"\mathrm{amplitude}"),
        ("amplitude_2", r"\mathrm{amplitude}_{2}"),
        ("forcing_amplitude", r"\mathrm{forcing amplitude}"),
        ("mass_ratio2", r"\mathrm{mass ratio}_{2}"),
        ("max_F", r"\mathrm{max}_{F}"),
        ("_a__b_", "a_{b}"),
    ] {
        assert_eq!(symbol(name).as_deref(), Some(latex), "{name}");
    }
    assert!(["_", "_1", "a b", "a$"].iter().all(|name| symbol(name).is_none()));
}

#[test]
fn axes_and_the_grazing_curve_are_named_by_symbols_where_there_are_letters() {
    assert_eq!(Names::new("F_0", "Omega").titles(), ["$F_{0}$", r"$\Omega$"]);
    for (name, title) in
        [("A", r"$A_{\mathrm{graz}}$"), ("F_0", r"$F_{0,\mathrm{graz}}$"), ("amplitude", "grazing")]
    {
        assert_eq!(Names::new(name, "omega").grazing_title(), title);
    }
    assert_eq!(Names::of_the_paper().grazing_title(), r"$\mathcal{A}_{\mathrm{graz}}$");
}

#[test]
fn names_and_symbols_take_their_places() {
    let names = Names::new("F_0", "Omega");
    assert_eq!(names.put_into("{primary}_graz/{secondary}^2"), "F_0_graz/Omega^2");
    assert_eq!(names.symbols_put_into("{primary_graz}, {secondary}^*"), r"F_{0,\mathrm{graz}}, \Omega^*");
    assert_eq!(Names::of_the_paper().symbols_put_into("{primary_graz}"), r"\mathcal{A}_{\mathrm{graz}}");
}
