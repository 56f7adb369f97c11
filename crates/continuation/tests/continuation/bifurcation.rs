//! Names of bifurcations.

use grazing_continuation::bifurcation::Bifurcation;

#[test]
fn each_kind_has_its_name_and_all_are_listed() {
    let [others @ .., last] = Bifurcation::ALL.map(Bifurcation::name);
    assert_eq!(Bifurcation::NAMES, format!("{} or {last}", others.join(", ")));
    assert!(Bifurcation::ALL.into_iter().all(|kind| Bifurcation::named(kind.name()) == Some(kind)));
    assert!(Bifurcation::ALL.into_iter().all(|kind| Bifurcation::understood(kind.name()) == Some(kind)));
}
