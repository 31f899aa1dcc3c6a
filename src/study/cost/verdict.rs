//! Whether the errors of a family fall as its steps get smaller, and how fast.

use super::{Point, Quantity};
use crate::math::statistics::Distribution;

/// A run that gains more of its initial energy than this does so by its method: rounding in 24 bits adds up to less over hundreds
/// of hits, each of which is good to some 1e-7.
pub const GAINS: f64 = 1e-4;

/// Errors below this are rounding, R: far above that of any scalar but f32, far below what anybody reads off.
const ROUNDING: f64 = 1e-9;

/// A coarser level follows the law of the finer ones if its error is within this factor of it.
const FOLLOWS: f64 = 2.0;

/// Errors that fall with a smaller power of the step than this do not fall.
const FALLS: f64 = 0.5;

/// An order is fitted to levels whose sizes span this factor or more.
const SPAN: f64 = 7.5;

/// Errors of the last levels that differ by less than this factor have settled.
const SETTLED: f64 = 1.5;

/// The fewest levels that an order is fitted to.
const LEAST: usize = 3;

/// How the errors of a family behave.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// They fall with the step.
    Converging,
    /// They have settled above zero.
    Floor,
    /// They neither fall nor settle, or the collisions are not those of the oracle.
    NotConverging,
    /// The finest runs have more energy than they started with.
    GainingEnergy,
}

impl Kind {
    /// As printed.
    pub fn words(self) -> &'static str {
        match self {
            Kind::Converging => "converging",
            Kind::Floor => "floor",
            Kind::NotConverging => "not converging",
            Kind::GainingEnergy => "gaining energy",
        }
    }
}

/// A power law through the errors of a family's finest levels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Power of the step: the observed order.
    pub order: f64,
    /// Its standard error, from the scatter about the law.
    pub spread: f64,
    /// Number of levels.
    pub sizes: usize,
    /// Index of the coarsest of them.
    pub from: usize,
}

/// What is concluded about a family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// How its errors behave.
    pub kind: Kind,
    /// Observed order of the final position, where it converges with a step.
    pub fit: Option<Fit>,
    /// Median error of the final position at the finest level, R; `None` without an oracle.
    pub finest: Option<f64>,
    /// Largest gain of energy at the finest level, E0.
    pub gained: Option<f64>,
}

/// Judges a family by the final positions at its levels; `None` where nothing ran to its end, or there is no oracle and no gain of energy.
///
/// A level counts by the median over its starts: a single start in which a pair sticks, or two hits change places, says little about
/// the order.
pub fn judge(points: &[Point]) -> Option<Verdict> {
    let last = points.last()?;
    let gained = last.gained();
    let errors: Vec<Option<f64>> = points
        .iter()
        .map(|point| median(point, Quantity::FinalPosition))
        .collect();
    let mut verdict = Verdict {
        kind: Kind::Converging,
        fit: None,
        finest: errors.last().copied().flatten(),
        gained,
    };
    let two = &points[points.len().saturating_sub(2)..];
    if two
        .iter()
        .all(|point| point.gained().is_some_and(|gained| gained > GAINS))
    {
        verdict.kind = Kind::GainingEnergy;
        return Some(verdict);
    }
    // no oracle, or no level that has an answer
    if errors.iter().all(Option::is_none) {
        return None;
    }
    let known = errors
        .iter()
        .rev()
        .take_while(|error| error.is_some_and(f64::is_finite))
        .count();
    let from = points.len() - known;
    let sizes: Option<Vec<f64>> = points[from..]
        .iter()
        .map(|point| point.level.size)
        .collect();
    let values: Vec<f64> = errors[from..].iter().copied().flatten().collect();
    let ordered = points.iter().rev().take(LEAST).all(in_order);
    let line = sizes
        .filter(|_| ordered)
        .and_then(|sizes| fit(&sizes, &values, from));
    verdict.fit = line;
    let at_rounding = verdict.finest.is_some_and(|error| error <= ROUNDING);
    verdict.kind = if line.is_some() || at_rounding {
        Kind::Converging
    } else if settled(&values) && in_order(last) {
        Kind::Floor
    } else {
        Kind::NotConverging
    };
    Some(verdict)
}

/// Median over the starts; `None` where a run has no answer.
pub fn median(point: &Point, quantity: Quantity) -> Option<f64> {
    let values: Option<Vec<f64>> = point
        .errors
        .iter()
        .map(|errors| errors.get(quantity))
        .collect();
    Some(Distribution::of(values?)?.quantile(0.5))
}

/// The law through the finest levels, and through coarser ones as long as they follow it; `None` if the finest do not fall.
fn fit(sizes: &[f64], values: &[f64], first: usize) -> Option<Fit> {
    let last = sizes.last()?;
    let wide = |start: &usize| sizes.len() - start >= LEAST && sizes[*start] >= SPAN * last;
    let mut start = (0..sizes.len()).rev().find(wide)?;
    while let Some(coarser) = start.checked_sub(1) {
        let (law, _) = power(&sizes[start..], &values[start..])?;
        let off = values[coarser].ln() - law.at(sizes[coarser].ln());
        if off.is_nan() || off.abs() > FOLLOWS.ln() {
            break;
        }
        start = coarser;
    }
    let (law, spread) = power(&sizes[start..], &values[start..])?;
    (law.slope >= FALLS).then_some(Fit {
        order: law.slope,
        spread,
        sizes: sizes.len() - start,
        from: first + start,
    })
}

/// A line through logarithms.
#[derive(Clone, Copy, Debug)]
struct Law {
    slope: f64,
    middle: [f64; 2],
}

impl Law {
    fn at(&self, x: f64) -> f64 {
        self.middle[1] + self.slope * (x - self.middle[0])
    }
}

/// Least squares of log error over log size: the law, and the standard error of its power.
fn power(sizes: &[f64], values: &[f64]) -> Option<(Law, f64)> {
    let n = sizes.len() as f64;
    // an error of zero is one below the last digit
    let logs: Vec<(f64, f64)> = sizes
        .iter()
        .zip(values)
        .map(|(size, value)| (size.ln(), value.max(f64::EPSILON).ln()))
        .collect();
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / n;
    let middle = [mean(|p| p.0), mean(|p| p.1)];
    let sum = |of: &dyn Fn(f64, f64) -> f64| {
        let terms = logs.iter().map(|p| of(p.0 - middle[0], p.1 - middle[1]));
        terms.sum::<f64>()
    };
    let (xx, xy) = (sum(&|dx, _| dx * dx), sum(&|dx, dy| dx * dy));
    let slope = xy / xx;
    let squares = sum(&|dx, dy| (dy - slope * dx).powi(2));
    let spread = (squares / (n - 2.0) / xx).sqrt();
    slope.is_finite().then_some((Law { slope, middle }, spread))
}

/// The last levels have one error.
fn settled(values: &[f64]) -> bool {
    let last = &values[values.len().saturating_sub(LEAST)..];
    let (least, most) = last
        .iter()
        .fold((f64::INFINITY, 0.0_f64), |(least, most), &x| {
            (least.min(x), most.max(x))
        });
    last.len() == LEAST && most <= SETTLED * least
}

/// Most starts of a level have the collisions of the oracle, in their order.
pub fn in_order(point: &Point) -> bool {
    median(point, Quantity::Order).is_none_or(|share| share == 0.0)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::{fit, power, settled};

    const STEPS: [f64; 6] = [1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5];

    #[test]
    fn a_power_law_has_its_order_and_no_spread() {
        let errors = STEPS.map(|h| 7.0 * h * h);
        let (law, spread) = power(&STEPS, &errors).unwrap();
        assert!((law.slope - 2.0).abs() < 1e-12 && spread < 1e-7);
    }

    #[test]
    fn levels_too_coarse_for_the_law_are_left_out_of_it() {
        let mut errors = STEPS.map(|h| 5.0 * h);
        (errors[0], errors[1]) = (20.0, 20.0);
        let fit = fit(&STEPS, &errors, 0).unwrap();
        assert_eq!((fit.from, fit.sizes), (2, 4));
        assert!((fit.order - 1.0).abs() < 1e-12);
    }

    #[test]
    fn errors_that_stay_have_no_order_and_have_settled() {
        let errors = [5.5, 6.4, 6.1, 5.2, 5.3, 5.4];
        assert_eq!(fit(&STEPS, &errors, 0), None);
        // nor if they fell before
        assert_eq!(fit(&STEPS, &[50.0, 15.0, 5.0, 2.0, 2.0, 2.0], 0), None);
        assert!(settled(&errors));
        assert!(!settled(&[20.0, 16.0, 12.0, 8.0]));
        assert!(!settled(&[1.0, 1.0]), "two levels say nothing");
    }
}
