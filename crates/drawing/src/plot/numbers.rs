//! The numbers along an axis: at the finest round step at which they keep their distance, and short for
//! any range.
//!
//! Where numbers would be long, they are printed as a power of ten times the value minus a round number,
//! which the axis title states: `10⁹ A`, `ω − 0.4321`, `10⁶ (ω − 0.4321)`.

use crate::error::DrawingError;
use crate::ink::font::Fonts;
use crate::ink::markup::Label;
use crate::ink::style::TICK_SIZE;
use crate::plot::ticks::{TickStep, decimal, scientific};

/// The least distance between the numbers along an axis, in points.
const NUMBER_GAP: f64 = 9.0;
/// Numbers with more significant digits than this are printed minus a round number.
const MOST_DIGITS: i32 = 5;
/// Numbers with a decimal exponent outside this range are printed with a power of ten in the title; the
/// range is smaller for numbers from which a round number has been subtracted.
const PLAIN_EXPONENTS: std::ops::RangeInclusive<i32> = -4..=4;
const PLAIN_REST_EXPONENTS: std::ops::RangeInclusive<i32> = -2..=4;

/// The direction of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Direction {
    Across,
    Up,
}

/// The scale of printed numbers: `10^power` times the value minus an offset, which is `offset` units of
/// ten to the `exponent`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Scale {
    offset: i128,
    exponent: i32,
    power: i32,
}

/// An axis for numbers of either sign over many decades: beyond the least decade the position is the
/// logarithm of the absolute value, and zero is in the middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Decades {
    /// The exponent of the least decade.
    pub(crate) least: i32,
}

impl Decades {
    /// The distance from zero to the least decade, in decades.
    const MIDDLE: f64 = 2.0;

    /// The position of a number on the axis.
    pub(crate) fn at(self, value: f64) -> f64 {
        let away = libm::log10(value.abs()) - f64::from(self.least) + Self::MIDDLE;
        libm::copysign(away.max(0.0), value)
    }

    /// The numbers along such a vertical axis, between two positions: every decade has a tick, and as
    /// many have numbers as keep their distance.
    fn numbers(self, fonts: &Fonts, [low, high]: [f64; 2], room: f64) -> Result<Numbers, DrawingError> {
        let decades = (high - Self::MIDDLE).floor().max(0.0) as i32;
        let written = (1..).find(|each| f64::from(*each) / (high - low) * room >= TICK_SIZE + NUMBER_GAP);
        let (mut ticks, mut minor, mut width) = (Vec::new(), Vec::new(), 0.0_f64);
        for (sign, print) in [(1.0, ""), (-1.0, "−")] {
            for decade in 0..=decades {
                let value = sign * (f64::from(decade) + Self::MIDDLE);
                minor.push(value);
                if decade % written.unwrap_or(1) == 0 {
                    let label = format!("${print}10^{{{}}}$", self.least + decade);
                    width = width.max(fonts.measure(&Label::parse(&label)?, TICK_SIZE)?.room());
                    ticks.push(Tick { value, label });
                }
            }
        }
        if Self::MIDDLE / (high - low) * room >= TICK_SIZE + 1.0 {
            ticks.push(Tick { value: 0.0, label: "0".to_owned() });
        }
        Ok(Numbers { ticks, minor, width, scale: Scale::none(TickStep::ONE) })
    }
}

/// A tick and the number at it.
pub(crate) struct Tick {
    pub(crate) value: f64,
    pub(crate) label: String,
}

/// The numbers along an axis, with their ticks.
pub(crate) struct Numbers {
    pub(crate) ticks: Vec<Tick>,
    /// The smaller ticks, without numbers.
    pub(crate) minor: Vec<f64>,
    /// The width of the widest number, in points.
    pub(crate) width: f64,
    scale: Scale,
}

impl Scale {
    /// The scale at which the multiples of a step are short when printed.
    fn fit(step: TickStep, range: [f64; 2]) -> Self {
        let mut multiples = step.multiples(range).map(|(units, _)| units);
        let first = multiples.next().unwrap_or(0);
        let last = multiples.last().unwrap_or(first);
        let digits = |units: i128| units.unsigned_abs().to_string().len() as i32;
        let largest = |offset: i128| (first - offset).abs().max((last - offset).abs());
        let offset = if digits(largest(0)) > MOST_DIGITS {
            let block = 10_i128.pow(digits(last - first) as u32);
            first.div_euclid(block) * block
        } else {
            0
        };
        let largest = largest(offset);
        let magnitude = digits(largest) - 1 + step.exponent();
        let plain = if offset == 0 { PLAIN_EXPONENTS } else { PLAIN_REST_EXPONENTS };
        let power = if largest == 0 || plain.contains(&magnitude) {
            0
        } else if offset == 0 {
            -magnitude
        } else {
            // In so narrow a range the remainders print as whole numbers.
            -step.exponent()
        };
        Scale { offset, exponent: step.exponent(), power }
    }

    /// The scale at which every number is printed unchanged.
    fn none(step: TickStep) -> Self {
        Scale { offset: 0, exponent: step.exponent(), power: 0 }
    }

    fn ticks(self, step: TickStep, range: [f64; 2]) -> Vec<Tick> {
        let label = |units: i128| decimal(units - self.offset, self.exponent + self.power);
        step.multiples(range).map(|(units, value)| Tick { value, label: label(units) }).collect()
    }
}

impl Numbers {
    /// The numbers along an axis that is `room` points long.
    ///
    /// # Errors
    /// The fonts lack a digit.
    pub(crate) fn along(
        fonts: &Fonts,
        range: [f64; 2],
        room: f64,
        direction: Direction,
    ) -> Result<Self, DrawingError> {
        let (plain, step, fits) = Self::choose(fonts, range, room, direction, Scale::none)?;
        if fits && Scale::fit(step, range) == Scale::none(step) {
            return Ok(plain);
        }
        let fit = |step| Scale::fit(step, range);
        Ok(Self::choose(fonts, range, room, direction, fit)?.0)
    }

    /// The numbers along a vertical axis, possibly one of decades.
    ///
    /// # Errors
    /// As [`along`](Self::along).
    pub(crate) fn up(
        fonts: &Fonts,
        range: [f64; 2],
        room: f64,
        decades: Option<Decades>,
    ) -> Result<Self, DrawingError> {
        match decades {
            Some(decades) => decades.numbers(fonts, range, room),
            None => Self::along(fonts, range, room, Direction::Up),
        }
    }

    /// Chooses the finest round step whose numbers keep their distance, or else the coarsest that has two
    /// numbers; returns the step as well.
    fn choose(
        fonts: &Fonts,
        range: [f64; 2],
        room: f64,
        direction: Direction,
        scale_of: impl Fn(TickStep) -> Scale,
    ) -> Result<(Self, TickStep, bool), DrawingError> {
        let length = range[1] - range[0];
        let mut coarsest = None;
        for step in TickStep::round_steps(length) {
            // A step so fine that its ticks would touch need not be measured.
            if length / step.size() * 4.0 > room {
                continue;
            }
            let scale = scale_of(step);
            let ticks = scale.ticks(step, range);
            if ticks.len() < 2 {
                continue;
            }
            let (mut width, mut height) = (0.0_f64, 0.0_f64);
            for tick in &ticks {
                let extent = fonts.measure(&Label::plain(&tick.label), TICK_SIZE)?;
                (width, height) = (width.max(extent.room()), height.max(extent.height()));
            }
            let least = match direction {
                Direction::Across => width + NUMBER_GAP + 4.0,
                Direction::Up => height + NUMBER_GAP + 6.0,
            };
            let fits = step.size() / length * room >= least;
            let minor = step.minor().multiples(range).map(|(_, value)| value).collect();
            let numbers = Numbers { ticks, minor, width, scale };
            coarsest = Some((numbers, step, fits));
            if fits {
                break;
            }
        }
        let bare = TickStep::ONE;
        let none = || Numbers { ticks: Vec::new(), minor: Vec::new(), width: 0.0, scale: Scale::none(bare) };
        Ok(coarsest.unwrap_or_else(|| (none(), bare, false)))
    }

    /// Whether the printed numbers are the values themselves.
    pub(crate) fn are_plain(&self) -> bool {
        self.scale.offset == 0 && self.scale.power == 0
    }

    /// The title of the axis, with the scaling of the values.
    pub(crate) fn title(&self, title: &str) -> String {
        let Scale { offset, exponent, power } = self.scale;
        if title.is_empty() || self.are_plain() {
            return title.to_owned();
        }
        let factor = format!(r"$10^{{{power}}}\,$");
        if offset == 0 {
            return format!("{factor}{title}");
        }
        let sign = if offset < 0 { '+' } else { '-' };
        let less = format!(r"{title}$\,{sign}\,{}$", scientific(offset.abs(), exponent));
        if power == 0 { less } else { format!("{factor}$($") + &less + "$)$" }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(range: [f64; 2], direction: Direction) -> (Vec<String>, String) {
        let fonts = Fonts::load().unwrap();
        let found = Numbers::along(&fonts, range, 120.0, direction).unwrap();
        (found.ticks.iter().map(|tick| tick.label.clone()).collect(), found.title("$A$"))
    }

    #[test]
    fn common_ranges_are_printed_as_they_stand() {
        assert_eq!(numbers([0.35, 1.02], Direction::Up).1, "$A$");
        assert_eq!(numbers([0.35, 1.02], Direction::Up).0[0], "0.4");
        assert_eq!(numbers([0.0, 80_000.0], Direction::Across).1, "$A$");
        assert_eq!(numbers([0.0, 0.008], Direction::Across).1, "$A$");
    }

    #[test]
    fn very_small_and_very_large_numbers_leave_their_power_of_ten_to_the_title() {
        let (labels, title) = numbers([0.0, 1e-9], Direction::Across);
        assert_eq!((labels[0].as_str(), title.as_str()), ("0", r"$10^{9}\,$$A$"));
        assert_eq!(labels.last().unwrap(), "1.0");
        let (labels, title) = numbers([2e6, 9e6], Direction::Up);
        assert_eq!((labels[0].as_str(), title.as_str()), ("2", r"$10^{-6}\,$$A$"));
    }

    #[test]
    fn narrow_ranges_are_printed_less_a_round_number() {
        let (labels, title) = numbers([123_456.000_1, 123_456.000_9], Direction::Across);
        assert_eq!(title, r"$10^{4}\,$$($$A$$\,-\,123456$$)$");
        assert!(labels.iter().all(|label| label.len() == 1), "{labels:?}");
        let (labels, title) = numbers([-0.432_161_9, -0.432_160_2], Direction::Up);
        assert_eq!(title, r"$10^{7}\,$$($$A$$\,+\,0.43217$$)$");
        assert!(labels.iter().all(|label| label.len() <= 2), "{labels:?}");
    }

    #[test]
    fn numbers_are_short_and_distinct_and_their_ticks_true_whatever_the_range() {
        for magnitude in [-300, -30, -9, -4, -1, 0, 3, 6, 12, 100, 300] {
            for (from, width) in [(0.0, 1.0), (-3.0, 7.0), (1.234_567_890_1, 1e-6), (-9.87, 1e-9), (1.0, 0.9)]
            {
                let scale: f64 = format!("1e{magnitude}").parse().unwrap();
                let range = [from * scale, (from + width) * scale];
                for direction in [Direction::Across, Direction::Up] {
                    let fonts = Fonts::load().unwrap();
                    let found = Numbers::along(&fonts, range, 120.0, direction).unwrap();
                    let labels: Vec<&str> = found.ticks.iter().map(|tick| tick.label.as_str()).collect();
                    assert!(labels.len() >= 2, "{range:?}: {labels:?}");
                    assert!(labels.windows(2).all(|pair| pair[0] != pair[1]), "{range:?}: {labels:?}");
                    assert!(labels.iter().all(|label| label.chars().count() <= 8), "{range:?}: {labels:?}");
                    // `multiples` allows a billionth of a step beyond the ends, and there is rounding.
                    let rounding = 4.0 * f64::EPSILON * range[0].abs().max(range[1].abs());
                    let slack = 1e-9 * (range[1] - range[0]) + rounding;
                    assert!(
                        found
                            .ticks
                            .iter()
                            .all(|t| range[0] - slack <= t.value && t.value <= range[1] + slack)
                    );
                    assert!(Label::parse(&found.title("$A$")).is_ok());
                }
            }
        }
    }
}
