//! Which periodic solutions are admissible.

use grazing_continuation::mps::{Multipliers, PeriodicSolution, Unknowns};

#[test]
fn only_solutions_that_run_into_the_wall_are_admissible() {
    let solution = |loops, velocity| PeriodicSolution {
        loops,
        unknowns: Unknowns::new(velocity, 0.3, 0.5, 0.8),
        multipliers: Multipliers { trace: 0.1, determinant: 0.2 },
        highest_interior_maximum: None,
    };
    assert!(solution(1, 0.1).admissible() && solution(1, 0.1).attracts());
    assert!(!solution(1, -0.1).admissible() && !solution(2, 0.0).admissible());
    // This is the position at phase zero of motion without impacts.
    assert!(solution(0, -0.1).admissible());
}
