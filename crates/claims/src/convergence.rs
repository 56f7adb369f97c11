//! The order at which remainders vanish.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::{Measure, Outcome};

/// The largest size is two to the minus this; each further size is half the previous one.
const FIRST: i32 = 6;
/// The number of sizes.
const SIZES: i32 = 16;
/// The ratio to its rounding above which a remainder is resolved.
const RESOLVED: f64 = 100.0;

/// The observed order of a remainder: log₂ of the ratio at the two smallest sizes, a factor of two apart,
/// at which it is resolved.
///
/// `remainder` returns, for a size, the remainder and its rounding, or `None` where the size is too large
/// for it to exist. The order is infinite if the remainder is never resolved twice, so that none is
/// visible. It is NaN if the remainder does not exist down to the smallest size.
pub fn order(mut remainder: impl FnMut(f64) -> Option<(f64, f64)>) -> f64 {
    let mut resolved: Vec<f64> = Vec::new();
    let mut exists = false;
    for k in FIRST..FIRST + SIZES {
        let found = remainder(libm::ldexp(1.0, -k));
        exists = found.is_some();
        match found {
            Some((value, rounding)) if value.abs() > RESOLVED * rounding => resolved.push(value.abs()),
            // NaN does not count as small.
            Some((value, _)) if value.is_nan() => return f64::NAN,
            // Once below rounding, the remainder stays below it.
            Some(_) => break,
            None => resolved.clear(),
        }
    }
    match resolved[..] {
        [.., coarse, fine] => libm::log2(coarse / fine),
        _ if !exists => f64::NAN,
        _ => f64::INFINITY,
    }
}

/// The order of a remainder in all directions at once: that of the largest remainder at each size.
pub fn uniform_order<const N: usize>(
    directions: &[[f64; N]],
    remainder: impl Fn([f64; N], f64) -> Option<(f64, f64)>,
) -> f64 {
    order(|h| {
        let mut largest = (0.0_f64, 0.0_f64);
        for direction in directions {
            let (value, rounding) = remainder(*direction, h)?;
            if value.is_nan() {
                return Some((value, rounding));
            }
            largest = (largest.0.max(value.abs()), largest.1.max(rounding));
        }
        Some(largest)
    })
}

/// The tolerated difference of the observed order below the stated one: remainders are last resolved at
/// sizes below 10⁻³, where the next term is as small, times a coefficient of order ten at most.
pub const SLACK_AT_GRAZING: f64 = 0.1;

/// A function that computes each value once, for several remainders of the same solution.
pub fn remembered<T: Clone>(f: impl Fn(f64) -> Option<T>) -> impl Fn(f64) -> Option<T> {
    let known: RefCell<BTreeMap<u64, Option<T>>> = RefCell::default();
    move |size| known.borrow_mut().entry(size.to_bits()).or_insert_with(|| f(size)).clone()
}

/// The orders of remainders that are computed together, each with its rounding and the stated order.
pub fn together<const N: usize>(
    each: [(f64, f64); N],
    remainders: impl Fn(f64) -> Option<[f64; N]>,
) -> Vec<Observed> {
    let values = remembered(remainders);
    let one = |i: usize, rounding: f64| order(|size| Some((values(size)?[i], rounding)));
    each.into_iter().enumerate().map(|(i, (rounding, stated))| (one(i, rounding), stated)).collect()
}

/// The order of the difference of extrapolations to 0 from both sides: at least 3 in C³.
pub fn seam(rounding: f64, f: impl Fn(f64) -> Option<f64>) -> Observed {
    let observed = order(|size| {
        let side = |h: f64| Some(4.0 * f(h)? - 6.0 * f(2.0 * h)? + 4.0 * f(3.0 * h)? - f(4.0 * h)?);
        Some((side(size)? - side(-size)?, rounding))
    });
    (observed, 3.0)
}

/// An observed order and the stated one.
pub type Observed = (f64, f64);

/// The order that is lowest relative to the stated one; if none is too low, that among the highest
/// stated.
pub fn lowest(orders: &[Observed]) -> Measure {
    let measure =
        |(observed, stated): Observed| Measure::Order { observed, stated, slack: SLACK_AT_RESONANCE };
    let lower = |a: Observed, b: Observed| if b.0 - b.1 < a.0 - a.1 || b.0.is_nan() { b } else { a };
    let highest = orders.iter().fold(f64::NEG_INFINITY, |highest, order| highest.max(order.1));
    let all = || orders.iter().copied();
    let worst = all().reduce(lower).filter(|order| !measure(*order).holds());
    let reported = worst.or_else(|| all().filter(|order| order.1 == highest).reduce(lower));
    measure(reported.unwrap_or((f64::NAN, f64::NAN)))
}

/// The lowest order, as an outcome.
pub fn of_orders(orders: &[Observed], over: &str) -> Outcome {
    Outcome::new(lowest(orders), orders.len(), over)
}

/// The tolerated difference of the observed order below the stated one, due to the next term at resolved
/// sizes.
pub const SLACK_AT_RESONANCE: f64 = 0.3;
