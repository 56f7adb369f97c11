//! Families of the paper's oscillator, against closed forms.

use grazing_input::Description;
use grazing_model::smooth::Stop;
use grazing_results::VARIED;
use grazing_results::resonance::Coefficients;
use grazing_theorems::LinearOscillator;
use grazing_unfold::family::{FamilyPlan, Varied, assemble, records};
use grazing_unfold::progress::Silent;

/// Coefficients from derivatives of the numerical map: as accurate as those of the second order.
const EXACT: f64 = 1e-6;

#[test]
fn resonances_and_the_curves_between_them_have_the_coefficients_of_the_closed_form() {
    let text = include_str!("../../../../examples/paper.toml");
    let narrow = text
        .replace("range = [0.3, 1.1]", "range = [0.6, 0.9]")
        .replace("loops = [1, 2, 3]", "loops = [1, 2]");
    let description = Description::parse(&narrow, "paper.toml").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((description.loops(), description.secondary().range()), (&[1, 2][..], [0.6, 0.9]));
    let plan =
        FamilyPlan { varied: vec![Varied { name: "zeta".to_owned(), values: vec![0.02, 0.03, 0.05] }] };
    let member = |index: usize| {
        let zeta = plan.values(index)[0];
        (index, description.with_constant("zeta", zeta).unwrap_or_else(|error| panic!("{error}")))
    };
    let members: Vec<_> = (0..plan.count()).map(member).collect();
    let tell = |_: &Description, error: &_| panic!("{error:?}");
    let records = records(&plan, &members, &tell, &Stop::default(), &Silent);
    let family = assemble(&plan, &description, records);

    let held = |(varied, loops, n): ([f64; VARIED], u32, u32),
                [omega, amplitude]: [f64; 2],
                found: &Coefficients| {
        let theory = LinearOscillator::new(varied[VARIED - 1], 0.9).expect("it is in the domain");
        let resonance = theory.resonance(loops, n).expect("it exists");
        let stability = resonance.stability_coefficients();
        let Coefficients { s_plus, s_minus, c_sn, c_pd } = *found;
        for (found, wanted) in [
            (omega, resonance.forcing_frequency()),
            (amplitude, resonance.grazing().amplitude()),
            (s_plus, stability.plus),
            (s_minus, stability.minus),
            (c_sn, resonance.saddle_node_coefficient()),
            (c_pd, resonance.period_doubling_coefficient()),
        ] {
            assert!(
                (found - wanted).abs() <= EXACT * wanted.abs(),
                "p = {loops}, n = {n}: {found}, not {wanted}"
            );
        }
    };
    for row in &family.resonances {
        held((row.varied, row.loops, row.n), [row.secondary, row.primary], &row.coefficients);
    }
    for row in &family.curves {
        held((row.varied, row.loops, row.n), [row.secondary, row.primary], &row.coefficients);
    }
    let curves = family.resonances.iter().map(|row| row.curve).max().unwrap_or_default();
    assert!(curves >= 2 && family.resonances.len() == 3 * curves as usize, "{curves}");
    assert!(family.curves.len() > 2 * family.resonances.len(), "{}", family.curves.len());
}
