//! Round numbers along an axis.

use super::scale::Extent;

/// One tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Where, in the numbers of the axis.
    pub at: f64,
    /// Words; empty for a minor tick.
    pub label: String,
}

/// Ticks of a linear axis: 1, 2 or 5 times a power of ten, about `wanted` of them, never more than twice that.
pub fn linear(range: Extent, wanted: usize) -> Vec<Tick> {
    let rough = range.half() / (wanted.max(1) as f64 * 0.5);
    if rough.is_nan() || rough < 1e-300 {
        return Vec::new();
    }
    let power = rough.log10().floor();
    let factor = [1.0, 2.0, 5.0]
        .into_iter()
        .find(|f| *f * 10f64.powf(power) >= rough * 0.85);
    let (factor, power) = factor.map_or((1.0, power + 1.0), |factor| (factor, power));
    let step = factor * 10f64.powi(power as i32);
    if !step.is_finite() || step <= 0.0 {
        return Vec::new();
    }
    let first = (range.lo / step - 1e-6).ceil();
    let at = |i: usize| {
        let x = (first + i as f64) * step;
        // a tick at 1e-17 is one at 0
        if x.abs() < 1e-6 * step { 0.0 } else { x }
    };
    let largest = range.lo.abs().max(range.hi.abs());
    (0..=2 * wanted)
        .map(at)
        .take_while(|x| x.is_finite() && *x <= range.hi + 1e-6 * step)
        .map(|x| Tick {
            at: x,
            label: label(x, power as i32, largest),
        })
        .collect()
}

/// Where the numbers along an axis are counted from: 0, or a round number amid them where they differ only in their fifth digit or
/// later.
pub fn offset(range: Extent) -> f64 {
    let width = 2.0 * range.half();
    let largest = range.lo.abs().max(range.hi.abs());
    if width.is_nan() || width <= 0.0 || largest / width < 1e4 || largest > 1e15 {
        return 0.0;
    }
    let power = width.log10().ceil();
    let step = 10f64.powf(power);
    let offset = ((range.lo * 0.5 + range.hi * 0.5) / step).round() * step;
    // no more digits than it takes to tell steps apart: the product has its rounding in it
    let digits = (offset.abs().log10().floor() - power).clamp(0.0, 17.0) as usize;
    let plain = format!("{offset:.digits$e}").parse();
    plain.ok().filter(|x: &f64| x.is_finite()).unwrap_or(0.0)
}

/// The ticks of [`linear`] with labels that are to be added to `offset`.
pub fn linear_from(offset: f64, range: Extent, wanted: usize) -> Vec<Tick> {
    let shifted = Extent {
        lo: range.lo - offset,
        hi: range.hi - offset,
    };
    let ticks = linear(shifted, wanted).into_iter();
    let tick = |tick: Tick| Tick {
        at: tick.at + offset,
        ..tick
    };
    ticks.map(tick).collect()
}

/// `power`: decimal place of the step; `largest`: of all ticks.
fn label(x: f64, power: i32, largest: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    if power < -4 || largest >= 1e6 {
        let digits = (largest.log10().floor() as i32 - power).clamp(0, 15);
        return format!("{x:.*e}", digits as usize);
    }
    format!("{x:.*}", (-power).max(0) as usize)
}

/// Ticks of a logarithmic axis whose ends are decimal logarithms; about `wanted` of them have a label, never more than twice that.
pub fn logarithmic(range: Extent, wanted: usize) -> Vec<Tick> {
    let decades = 2.0 * range.half();
    if decades < 1.2 {
        // too short for powers of ten: round numbers instead
        let numbers = Extent {
            lo: 10f64.powf(range.lo),
            hi: 10f64.powf(range.hi),
        };
        let ticks = linear(numbers, wanted.min(5)).into_iter();
        return ticks.filter(|tick| tick.at > 0.0).collect();
    }
    let every = (decades / wanted.max(1) as f64).ceil().max(1.0);
    let mut ticks = Vec::new();
    // no f64 is beyond these
    let (first, last) = (
        range.lo.floor().max(-325.0) as i32,
        range.hi.ceil().min(309.0) as i32,
    );
    let plain = range.lo >= -2.5 && range.hi <= 4.5;
    for power in first..=last {
        let minor = if every > 1.0 || decades > 5.0 { 1 } else { 9 };
        for digit in 1..=minor {
            let place = f64::from(power) + f64::from(digit).log10();
            if place < range.lo - 1e-9 || place > range.hi + 1e-9 {
                continue;
            }
            let labelled = digit == 1 && f64::from(power).rem_euclid(every) == 0.0;
            let label = match (labelled, plain) {
                (false, _) => String::new(),
                (true, true) => format!("{}", 10f64.powi(power)),
                (true, false) => format!("10{}", raised(power)),
            };
            ticks.push(Tick {
                at: f64::from(digit) * 10f64.powi(power),
                label,
            });
        }
    }
    ticks
}

/// A number in raised digits.
fn raised(power: i32) -> String {
    let digit = |c: char| match c {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        _ => '⁹',
    };
    power.to_string().chars().map(digit).collect()
}

#[cfg(test)]
mod tests {
    use super::{Extent, linear, linear_from, logarithmic, offset};

    fn labels(ticks: Vec<super::Tick>) -> String {
        let labels: Vec<String> = ticks
            .into_iter()
            .map(|tick| tick.label)
            .filter(|label| !label.is_empty())
            .collect();
        labels.join(" ")
    }

    #[test]
    fn ticks_are_round_numbers() {
        for (lo, hi, expected) in [
            (0.0, 1.0, "0 0.2 0.4 0.6 0.8 1.0"),
            (0.0, 24.3, "0 5 10 15 20"),
            (-1.0, 1.0, "-1.0 -0.5 0 0.5 1.0"),
            (0.0, 10.5, "0 2 4 6 8 10"),
            (3e-9, 9e-9, "4e-9 6e-9 8e-9"),
            (1e6, 1.5e6, "1.0e6 1.1e6 1.2e6 1.3e6 1.4e6 1.5e6"),
        ] {
            assert_eq!(
                labels(linear(Extent { lo, hi }, 5)),
                expected,
                "{lo} to {hi}"
            );
        }
    }

    #[test]
    fn logarithmic_ticks_are_powers_of_ten_or_round_numbers() {
        for (lo, hi, expected) in [
            (-1.0, 2.0, "0.1 1 10 100"),
            (-16.0, 1.0, "10⁻¹⁵ 10⁻¹² 10⁻⁹ 10⁻⁶ 10⁻³ 10⁰"),
            (0.0, 0.5, "1.0 1.5 2.0 2.5 3.0"),
        ] {
            assert_eq!(
                labels(logarithmic(Extent { lo, hi }, 7)),
                expected,
                "{lo} to {hi}"
            );
        }
    }

    #[test]
    fn numbers_far_from_zero_are_counted_from_a_round_one() {
        for (lo, hi, from, expected) in [
            (1e8, 1e8 + 11.0, 1e8, "0 2 4 6 8 10"),
            (
                -12345.3,
                -12345.1,
                -12345.0,
                "-0.30 -0.25 -0.20 -0.15 -0.10",
            ),
            (17.44, 17.8, 0.0, "17.5 17.6 17.7 17.8"),
            (0.0, 1e8, 0.0, "0 2.0e7 4.0e7 6.0e7 8.0e7 1.0e8"),
        ] {
            let range = Extent { lo, hi };
            assert_eq!(offset(range), from, "{lo} to {hi}");
            assert_eq!(
                labels(linear_from(from, range, 5)),
                expected,
                "{lo} to {hi}"
            );
        }
    }

    #[test]
    fn ticks_are_few_and_inside_whatever_the_range() {
        for lo in [-1e308, -1e16, -1.0, 0.0, 1e-300, 1.0, 1e16] {
            for width in [1e-290, 1e-12, 0.3, 1e5, 1e300] {
                let range = Extent { lo, hi: lo + width }.widened(0.0);
                let ticks = linear(range, 6);
                assert!(ticks.len() <= 13, "{lo} + {width}: {} ticks", ticks.len());
                for tick in ticks {
                    let slack = 1e-3 * range.half();
                    assert!(
                        tick.at >= range.lo - slack && tick.at <= range.hi + slack,
                        "{lo} + {width}: {tick:?}"
                    );
                }
            }
        }
    }
}
