//! Numbers as texts.

use grazing_results::brief;

#[test]
fn brief_numbers_have_no_zeros_at_the_end() {
    for (value, text) in
        [(0.5, "0.5"), (1.0, "1"), (-0.0, "0"), (0.123_456_789, "0.123457"), (1.25e-9, "1.25e-9")]
    {
        assert_eq!(brief(value, 6), text);
    }
}
