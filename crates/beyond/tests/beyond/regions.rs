//! Regions of admissibility: where visits are before the wall.

use grazing_beyond::regions::BeyondRegions;
use grazing_theorems::auxiliary::scaled_visit_position;

use super::study;

#[test]
fn all_visits_are_before_the_wall_inside_of_regions_and_one_is_not_beside_them() {
    let shown = study().shown::<BeyondRegions>().expect("it can be computed");
    let mut seen = 0;
    for row in
        shown.levels.iter().filter(|row| (0.1..0.999).contains(&row.delta) && row.high - row.low > 1e-6)
    {
        let sign = if 2 * row.turns <= row.loops { 1.0 } else { -1.0 };
        let before = |tau: f64| {
            (1..row.loops).all(|j| sign * scaled_visit_position(j, row.loops, tau, row.delta) < 0.0)
        };
        let width = row.high - row.low;
        assert!(before(0.5 * (row.low + row.high)), "{row:?}");
        for beside in [row.low - 0.01 * width, row.high + 0.01 * width] {
            if beside.abs() < 1.0 + row.delta {
                assert!(!before(beside), "{row:?} {beside}");
                seen += 1;
            }
        }
    }
    assert!(seen > 1000, "{seen}");
}
