//! Tables as CSV.

use grazing_cli::tables::csv;
use polars::prelude::df;

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).expect("CSV is text")
}

#[test]
fn computed_numbers_have_17_significant_digits_and_come_back_bit_by_bit() {
    let numbers = [1.0 / 3.0, 2.0_f64.sqrt() * 1e-200, -5e-324, f64::MAX, 0.1 + 0.2, 1e22];
    let frame = df!("x" => numbers).expect("a frame");
    let written = text(csv(&frame).expect("the frame can be written"));
    let cells: Vec<&str> = written.lines().skip(1).collect();
    assert_eq!(cells.len(), numbers.len());
    for (cell, number) in cells.iter().zip(numbers) {
        let mantissa = cell.split('e').next().unwrap_or_default();
        assert_eq!(mantissa.bytes().filter(u8::is_ascii_digit).count(), 17, "{cell}");
        assert_eq!(cell.parse::<f64>().map(f64::to_bits), Ok(number.to_bits()), "{cell}");
    }
}

#[test]
fn negative_zero_is_zero_and_what_is_not_a_number_is_empty() {
    let frame = df!("kind" => ["a", "b", "c"], "x" => [Some(-0.0), Some(f64::NAN), None]).expect("a frame");
    let written = text(csv(&frame).expect("the frame can be written"));
    assert_eq!(written, "kind,x\na,0.0000000000000000e0\nb,\nc,\n");
}

#[test]
fn words_whole_numbers_and_truth_values_are_plain() {
    let frame = df!("kind" => ["SN-GZ"], "p" => [3u32], "n" => [-2i64], "stable" => [true]).expect("a frame");
    assert_eq!(text(csv(&frame).expect("the frame can be written")), "kind,p,n,stable\nSN-GZ,3,-2,true\n");
}
