//! Specimens: motion in closed form and integrated, and what makes them generic.

use grazing_claims::specimen::{Law, Specimen, damping_for_decay};
use grazing_model::{ImpactOscillator, State};

#[test]
fn closed_form_and_integration_are_one_oscillator() {
    for law in [Law::varying(0.05), Law::varying(0.05).frequency_first()] {
        let closed = law.grazing(0.8).unwrap().oscillator().clone();
        // A force that is nonlinear in name only is integrated.
        let law = Law { stiffening: f64::MIN_POSITIVE, ..law };
        let integrated = Specimen::new(law, closed.parameters());
        let from = State::on_wall(-0.3, 0.7);
        let [a, b] = [&closed, &integrated].map(|specimen| specimen.flow::<2>(from, 5.0));
        // The error of integration, which grows about tenfold with each derivative.
        assert!((a.value - b.value).amax() < 1e-13);
        assert!((a.jacobian - b.jacobian).amax() < 1e-12);
        assert!((0..2).all(|i| (a.hessians[i] - b.hessians[i]).amax() < 1e-11));
    }
}

#[test]
fn a_nonlinear_specimen_has_none_of_the_accidents_of_the_linear_one() {
    let law = Law::nonlinear(damping_for_decay(1, 1, 0.5));
    let grazing = law.resonance(1, 1).unwrap().resonant_point().grazing;
    let (a, omega) = (grazing.map.a, grazing.forcing_frequency);
    assert!(a.m12.abs() < 1e-10 && (a.m11 - a.m22).abs() > 0.2, "{a}");
    assert!((grazing.gamma / (omega * omega) - 1.0).abs() > 0.02);
    assert!(grazing.alpha() > 0.05 && (grazing.alpha() - 1.0 - grazing.phi).abs() > 0.05);
}

#[test]
fn eigenvalues_can_be_real_and_transversality_negative() {
    let map = Law::nonlinear(0.15).frequency_first().grazing(1.25).unwrap().grazing_point().map;
    let (tau, delta) = (map.trace(), map.determinant());
    assert!(tau * tau > 4.0 * delta && map.transversality() < -1.0, "{map:?}");
}
