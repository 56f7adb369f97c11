//! The search for the smallest value of a function.

use grazing_claims::sampling::smallest;

#[test]
fn the_bottom_of_a_slanted_valley_is_found() {
    let valley = |[x, y]: [f64; 2]| {
        let (u, v) = (x + y - 0.9, x - y - 0.3);
        u * u + 50.0 * v * v
    };
    let (value, [x, y]) = smallest(1, 10, valley);
    assert!(value < 1e-9 && (x - 0.6).abs() < 1e-4 && (y - 0.3).abs() < 1e-4, "{value} {x} {y}");
}

#[test]
fn the_edge_of_the_domain_is_reached() {
    assert_eq!(smallest(1, 3, |[x]: [f64; 1]| -x).0, -1.0);
}
