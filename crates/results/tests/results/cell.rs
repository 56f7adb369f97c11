//! Numbers as texts.

use grazing_results::{Scientific, brief};

#[test]
fn brief_numbers_have_no_zeros_at_the_end() {
    for (value, text) in
        [(0.5, "0.5"), (1.0, "1"), (-0.0, "0"), (0.123_456_789, "0.123457"), (1.25e-9, "1.25e-9")]
    {
        assert_eq!(brief(value, 6), text);
    }
}

#[test]
fn scientific_numbers_have_one_digit_before_the_point() {
    for (number, mantissa, exponent) in [
        (Scientific::of(-1234.5), "-1.2345", 3),
        (Scientific::of(0.0), "0", 0),
        (Scientific::of(f64::INFINITY), "inf", 0),
        (Scientific::rounded(9.9996e-5, 4), "1.000", -4),
        (Scientific::rounded(0.25, 1), "2", -1),
    ] {
        assert_eq!((&*number.mantissa, number.exponent), (mantissa, exponent));
    }
    assert_eq!(Scientific::rounded(-1.234e-9, 3).to_string(), "-1.23e-9");
}
