//! Rows of regions.

use grazing_unfold::plane::regions;
use grazing_unfold::regions::{Doubt, Region};

#[test]
fn holes_of_a_region_have_rings_of_their_own_and_a_doubt_is_told_at_each_vertex() {
    let ring = |size: f64| vec![[0.5, 0.5], [0.5 + size, 0.5], [0.5, 0.5 + size]];
    let decided = Region { loops: 2, n: 1, rings: vec![ring(0.4), ring(0.2), ring(0.1)], doubt: None };
    let undecided = Region { rings: vec![ring(0.3)], doubt: Some(Doubt::Unseen), ..decided.clone() };
    let rows = regions(&[decided, undecided]);
    let told: Vec<(u32, u32, &str)> =
        rows.iter().step_by(3).map(|row| (row.region, row.at.ring, row.at.reason.as_str())).collect();
    let doubt = Doubt::Unseen.to_string();
    assert_eq!(told, [(1, 0, ""), (1, 1, ""), (1, 2, ""), (2, 0, doubt.as_str())]);
    assert!(rows.iter().all(|row| row.at.reason == if row.region == 1 { "" } else { &doubt }));
    assert_eq!((rows.len(), rows[4].at.primary, rows[5].at.secondary), (12, 0.7, 0.7));
}
