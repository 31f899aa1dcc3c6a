//! Statistics of samples: moments, quantiles, empirical distributions, and whether two samples come from one distribution.

use std::f64::consts::PI;

/// Products of two sample sizes up to which the p-value of Kolmogorov and Smirnov is computed exactly.
const EXACT_UP_TO: u64 = 1_000_000;

/// A sample in ascending order: the empirical distribution. Never empty, free of NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct Distribution {
    sorted: Vec<f64>,
}

impl Distribution {
    /// The distribution of `values`; `None` if there are none, or one is NaN.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = values.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        let usable = !sorted.is_empty() && !sorted.iter().any(|x| x.is_nan());
        usable.then_some(Distribution { sorted })
    }

    /// Number of values.
    pub fn count(&self) -> usize {
        self.sorted.len()
    }

    /// The smallest value.
    pub fn least(&self) -> f64 {
        self.sorted[0]
    }

    /// The largest value.
    pub fn most(&self) -> f64 {
        self.sorted[self.sorted.len() - 1]
    }

    /// Mean, summed as differences from the smallest value: exact where all values are equal.
    pub fn mean(&self) -> f64 {
        let least = self.least();
        let above: f64 = self.sorted.iter().map(|x| x - least).sum();
        least + above / self.sorted.len() as f64
    }

    /// Standard deviation with n - 1 in the denominator; `None` for fewer than two values.
    pub fn deviation(&self) -> Option<f64> {
        let degrees = self.sorted.len().checked_sub(1).filter(|n| *n > 0)?;
        let mean = self.mean();
        let squares: f64 = self.sorted.iter().map(|x| (x - mean).powi(2)).sum();
        Some((squares / degrees as f64).sqrt())
    }

    /// The value below which a part `p` of the sample lies, 0 <= p <= 1: linear between the order statistics, x(k) at
    /// p = (k - 1)/(n - 1). Definition 7 of Hyndman and Fan, "Sample quantiles in statistical packages" (1996).
    pub fn quantile(&self, p: f64) -> f64 {
        let place = p.clamp(0.0, 1.0) * (self.sorted.len() - 1) as f64;
        let (below, above) = (place.floor() as usize, place.ceil() as usize);
        let (low, high) = (self.sorted[below], self.sorted[above]);
        low + (high - low) * (place - below as f64)
    }

    /// The part of the sample at or below `x`.
    pub fn share_up_to(&self, x: f64) -> f64 {
        let at_or_below = self.sorted.partition_point(|value| *value <= x);
        at_or_below as f64 / self.sorted.len() as f64
    }

    /// The staircase of the distribution as points to draw, from share 0 to share 1. Of a sample of more than `most` values
    /// evenly spaced ones are drawn.
    pub fn staircase(&self, most: usize) -> Vec<[f64; 2]> {
        let n = self.sorted.len();
        let steps = n.min(most.max(1));
        let mut points = vec![[self.least(), 0.0]];
        let mut share = 0.0;
        for step in 1..=steps {
            let upto = step * n / steps;
            let x = self.sorted[upto - 1];
            points.push([x, share]);
            share = upto as f64 / n as f64;
            points.push([x, share]);
        }
        points
    }

    /// Distinct values of both samples in ascending order, with how many of each are at or below it.
    fn merged<'a>(&'a self, other: &'a Distribution) -> impl Iterator<Item = (f64, usize, usize)> {
        let (a, b) = (&self.sorted, &other.sorted);
        let (mut i, mut j) = (0, 0);
        std::iter::from_fn(move || {
            let x = match (a.get(i), b.get(j)) {
                (Some(x), Some(y)) => x.min(*y),
                (Some(x), None) | (None, Some(x)) => *x,
                (None, None) => return None,
            };
            while a.get(i).is_some_and(|value| *value <= x) {
                i += 1;
            }
            while b.get(j).is_some_and(|value| *value <= x) {
                j += 1;
            }
            Some((x, i, j))
        })
    }
}

/// How far one sample has to be moved to become the other, on average over its values, in the unit of the values.
///
/// The area between both empirical distribution functions: the Wasserstein distance of order 1 on the line.
pub fn transport(a: &Distribution, b: &Distribution) -> f64 {
    let (n, m) = (a.count() as f64, b.count() as f64);
    let mut area = 0.0;
    let mut last: Option<(f64, f64)> = None;
    for (x, i, j) in a.merged(b) {
        if let Some((from, apart)) = last {
            area += apart * (x - from);
        }
        last = Some((x, (i as f64 / n - j as f64 / m).abs()));
    }
    area
}

/// Kolmogorov and Smirnov's answer to whether two samples come from one distribution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KolmogorovSmirnov {
    /// Largest distance of the two empirical distribution functions, 0 to 1.
    pub distance: f64,
    /// Probability of at least this distance if both are independent samples of one distribution, 0 to 1.
    pub p: f64,
}

/// The two-sample test of Kolmogorov and Smirnov, two-sided.
///
/// Up to 10^6 pairs of values p is exact, given the pooled values: all orders of which value is whose are equally likely, and
/// the distance counts only where the pooled value changes, so ties are taken as they are (Hodges 1958; Schroeer and Trenkler
/// 1995). Beyond that p is Smirnov's limit for n m/(n + m) large (1939), which is too large where values tie (Noether 1963).
pub fn kolmogorov_smirnov(a: &Distribution, b: &Distribution) -> KolmogorovSmirnov {
    let (n, m) = (a.count() as u64, b.count() as u64);
    // in units of 1 / (n m), so that equality is equality
    let apart = |i: usize, j: usize| (i as u64 * m).abs_diff(j as u64 * n);
    let largest = a.merged(b).map(|(_, i, j)| apart(i, j)).fold(0, u64::max);
    let distance = largest as f64 / (n * m) as f64;
    let p = if n * m <= EXACT_UP_TO {
        let mut ends = vec![false; (n + m) as usize + 1];
        for (_, i, j) in a.merged(b) {
            ends[i + j] = true;
        }
        exact_tail(largest, n as usize, m as usize, &ends)
    } else {
        limit_tail(distance * ((n * m) as f64 / (n + m) as f64).sqrt())
    };
    KolmogorovSmirnov { distance, p }
}

/// Probability that a path from (0, 0) to (n, m), all paths being equally likely, meets a place (i, j) with
/// |i m - j n| >= `largest`. Only places with `ends[i + j]` count: there the pooled value changes.
///
/// `met[j]` is that probability for the paths to (i, j), whose last step came from (i - 1, j) with probability i/(i + j).
/// Only sums of positive terms: small tails keep their digits.
fn exact_tail(largest: u64, n: usize, m: usize, ends: &[bool]) -> f64 {
    if largest == 0 {
        return 1.0;
    }
    let (n64, m64) = (n as u64, m as u64);
    let meets =
        |i: usize, j: usize| ends[i + j] && (i as u64 * m64).abs_diff(j as u64 * n64) >= largest;
    let mut met = vec![0.0; m + 1];
    for i in 0..=n {
        for j in 0..=m {
            met[j] = if meets(i, j) {
                1.0
            } else if i + j == 0 {
                0.0
            } else {
                let from_left = if i > 0 { i as f64 * met[j] } else { 0.0 };
                let from_below = if j > 0 { j as f64 * met[j - 1] } else { 0.0 };
                (from_left + from_below) / (i + j) as f64
            };
        }
    }
    met[m]
}

/// Kolmogorov's distribution: the limit of the probability of a scaled distance of at least `x`.
///
/// 2 sum (-1)^(k-1) exp(-2 k^2 x^2), or for small x its transform 1 - sqrt(2 pi)/x sum exp(-(2k - 1)^2 pi^2 / (8 x^2)).
fn limit_tail(x: f64) -> f64 {
    // where both series need four terms for all digits
    const TURN: f64 = 1.0;
    if x <= 0.0 {
        return 1.0;
    }
    let terms = 1..=6;
    if x < TURN {
        let sum: f64 = terms
            .map(|k| (-(f64::from(2 * k - 1) * PI / x).powi(2) / 8.0).exp())
            .sum();
        1.0 - (2.0 * PI).sqrt() / x * sum
    } else {
        let term = |k: i32| {
            let size = (-2.0 * (f64::from(k) * x).powi(2)).exp();
            if k % 2 == 1 { size } else { -size }
        };
        2.0 * terms.map(term).sum::<f64>()
    }
}

/// p-values corrected for their number, in the given order (Holm 1979): where all that lie below a level are called
/// significant, the probability of one or more false alarms is at most that level, however the tests depend on each other.
pub fn holm(p_values: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..p_values.len()).collect();
    order.sort_by(|a, b| p_values[*a].total_cmp(&p_values[*b]));
    let mut corrected = vec![0.0; p_values.len()];
    let mut largest = 0.0_f64;
    for (rank, index) in order.into_iter().enumerate() {
        let left = (p_values.len() - rank) as f64;
        largest = largest.max((left * p_values[index]).min(1.0));
        corrected[index] = largest;
    }
    corrected
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::{
        Distribution, EXACT_UP_TO, exact_tail, holm, kolmogorov_smirnov, limit_tail, transport,
    };
    use crate::math::random::Draws;
    use approx::assert_relative_eq;

    // values called "scipy" come from scipy 1.17.1 and numpy 2.4.6, those called "statsmodels" from statsmodels 0.15.0

    const A: [f64; 7] = [0.61, -1.2, 2.4, 0.05, 1.7, -0.4, 0.9];
    const B: [f64; 9] = [1.1, 3.2, 0.7, 2.9, 1.9, 4.4, 2.2, 0.2, 3.7];

    fn sample(values: &[f64]) -> Distribution {
        Distribution::of(values.iter().copied()).unwrap()
    }

    /// A dozen roundings of numbers of one size.
    const ROUNDING: f64 = 1e-14;

    #[test]
    fn moments_and_quantiles_are_those_of_numpy() {
        let values = sample(&[3.5, -1.25, 0.75, 10.0, 2.0, 2.0, 7.25]);
        let close = |got: f64, want: f64| assert_relative_eq!(got, want, max_relative = ROUNDING);
        close(values.mean(), 3.4642857142857144);
        close(values.deviation().unwrap(), 3.8929117514736835);
        for (p, want) in [
            (0.0, -1.25),
            (0.05, -0.65),
            (0.3, 1.75),
            (0.5, 2.0),
            (0.95, 9.175),
            (1.0, 10.0),
        ] {
            close(values.quantile(p), want);
        }
        assert_eq!(
            (values.least(), values.most(), values.count()),
            (-1.25, 10.0, 7)
        );
        assert_eq!(values.share_up_to(2.0), 4.0 / 7.0);
    }

    #[test]
    fn equal_values_have_their_mean_exactly_and_no_deviation() {
        let equal = sample(&[0.1; 13]);
        assert_eq!((equal.mean(), equal.deviation()), (0.1, Some(0.0)));
        assert_eq!(equal.quantile(0.37), 0.1);
        let one = sample(&[4.0]);
        assert_eq!(
            (one.mean(), one.deviation(), one.quantile(0.9)),
            (4.0, None, 4.0)
        );
    }

    #[test]
    fn no_values_and_values_that_are_no_numbers_have_no_distribution() {
        assert_eq!(Distribution::of([]), None);
        assert_eq!(Distribution::of([1.0, f64::NAN]), None);
    }

    #[test]
    fn the_staircase_rises_from_0_to_1_at_the_values() {
        let values = sample(&[3.0, 1.0]);
        let expected = [[1.0, 0.0], [1.0, 0.0], [1.0, 0.5], [3.0, 0.5], [3.0, 1.0]];
        assert_eq!(values.staircase(100), expected);
        let many = Distribution::of((0..1000).map(f64::from)).unwrap();
        let drawn = many.staircase(10);
        assert_eq!(drawn.len(), 21);
        for [x, share] in &drawn[1..] {
            // either side of a drawn step lies within the tenth of the sample that it stands for
            let apart = (many.share_up_to(*x) - share).abs();
            assert!(apart <= 0.1 * (1.0 + ROUNDING), "{x} {share}");
        }
        assert_eq!(drawn.last(), Some(&[999.0, 1.0]));
    }

    #[test]
    fn transport_is_the_mean_shift() {
        let close = |got: f64, want: f64| assert_relative_eq!(got, want, max_relative = ROUNDING);
        // scipy.stats.wasserstein_distance
        close(transport(&sample(&A), &sample(&B)), 1.675555555555556);
        close(
            transport(&sample(&[0.0, 1.0, 3.0]), &sample(&[5.0, 6.0, 8.0])),
            5.0,
        );
        assert_eq!(transport(&sample(&A), &sample(&A)), 0.0);
    }

    #[test]
    fn small_samples_have_the_exact_p_of_scipy() {
        // scipy.stats.ks_2samp(a, b, method="exact")
        let got = kolmogorov_smirnov(&sample(&A), &sample(&B));
        assert_relative_eq!(got.distance, 0.5238095238095238, max_relative = ROUNDING);
        assert_relative_eq!(got.p, 0.1687062937062937, max_relative = ROUNDING);
        // the same routine of scipy for given sizes and distances, as a multiple of 1 / (n m)
        for (n, m, largest, want) in [
            (10, 10, 60, 0.05244755244755244),
            (20, 30, 130, 0.5788675758823734),
            (47, 61, 700, 0.06805031035455372),
        ] {
            let p = exact_tail(largest, n, m, &vec![true; n + m + 1]);
            // two roundings a step
            let steps = (n + m) as f64;
            assert_relative_eq!(p, want, max_relative = 2.0 * steps * f64::EPSILON);
        }
    }

    #[test]
    fn ties_are_taken_as_they_are() {
        // all ways of telling which of the pooled values are whose, counted one by one
        for (a, b) in [
            (
                vec![1.0, 2.0, 2.0, 3.0, 3.0],
                vec![2.0, 3.0, 3.0, 3.0, 4.0, 4.0],
            ),
            (vec![0.0, 0.0, 0.0, 1.0], vec![0.0, 1.0, 1.0, 1.0, 1.0]),
            (vec![5.0, 5.0], vec![5.0, 5.0, 5.0]),
        ] {
            let got = kolmogorov_smirnov(&sample(&a), &sample(&b));
            let pooled: Vec<f64> = a.iter().chain(&b).copied().collect();
            let (mut as_far, mut all) = (0_u32, 0_u32);
            for choice in 0_u32..1 << pooled.len() {
                if choice.count_ones() as usize != a.len() {
                    continue;
                }
                let share = |first: bool, x: f64| {
                    let own = pooled
                        .iter()
                        .enumerate()
                        .filter(|(k, _)| (choice >> k & 1 == 1) == first);
                    let (below, total) = own.fold((0, 0), |(below, total), (_, value)| {
                        (below + u32::from(*value <= x), total + 1)
                    });
                    f64::from(below) / f64::from(total)
                };
                let apart = pooled
                    .iter()
                    .map(|x| (share(true, *x) - share(false, *x)).abs());
                all += 1;
                // distances of so few values differ by 1/30 or are equal
                as_far += u32::from(apart.fold(0.0, f64::max) > got.distance - 1e-9);
            }
            let want = f64::from(as_far) / f64::from(all);
            assert_relative_eq!(got.p, want, max_relative = ROUNDING);
        }
    }

    #[test]
    fn the_limit_is_kolmogorovs_distribution() {
        // scipy.special.kolmogorov
        for (x, want) in [
            (0.3, 0.9999906941986655),
            (0.5, 0.9639452436648751),
            (0.8, 0.5441424115741981),
            (1.0, 0.26999967167735456),
            (1.2238, 0.10002342783567782),
            (1.3581, 0.0499996304316674),
            (1.6276, 0.010001537333060776),
            (2.5, 7.453306344157342e-06),
        ] {
            assert_relative_eq!(limit_tail(x), want, max_relative = ROUNDING);
        }
        assert_eq!(limit_tail(0.0), 1.0);
        // the two series at their turn
        assert_relative_eq!(
            limit_tail(1.0 - f64::EPSILON),
            limit_tail(1.0),
            max_relative = ROUNDING
        );
    }

    #[test]
    fn the_limit_follows_on_the_exact_tail() {
        // the limit takes the multiples of 1/n that a distance can be for a continuum: it is good to one of them, which is
        // 1/sqrt(2 n) of x, and the logarithm of the tail falls by at most 4 x for a unit of x
        let n = EXACT_UP_TO.isqrt() as usize;
        let ends = vec![true; 2 * n + 1];
        for x in [0.5, 0.9, 1.3, 1.7] {
            let largest = (x * (2.0 * n as f64).sqrt()).round() as u64 * n as u64;
            let scaled = largest as f64 / (n * n) as f64 * (n as f64 / 2.0).sqrt();
            let (exact, limit) = (exact_tail(largest, n, n, &ends), limit_tail(scaled));
            let relative = (exact - limit).abs() / exact;
            assert!(
                relative <= 4.0 * scaled / (2.0 * n as f64).sqrt(),
                "{x}: {exact} {limit}"
            );
        }
    }

    #[test]
    fn p_is_uniform_where_both_samples_come_from_one_distribution() {
        const TRIALS: u64 = 4000;
        let (n, m) = (23, 31);
        let p_values: Vec<f64> = (0..TRIALS)
            .map(|trial| {
                let mut draws = Draws::new(11, trial);
                let mut of = |count| Distribution::of((0..count).map(|_| draws.uniform())).unwrap();
                let (a, b) = (of(n), of(m));
                kolmogorov_smirnov(&a, &b).p
            })
            .collect();
        let ends = vec![true; n + m + 1];
        let possible: Vec<f64> = (0..=(n * m) as u64)
            .map(|largest| exact_tail(largest, n, m, &ends))
            .collect();
        for level in [0.01, 0.05, 0.2, 0.5, 0.8] {
            // p takes few values: the chance of at most `level` is the largest of them up to it
            let chance = possible.iter().copied().filter(|p| *p <= level);
            let chance = chance.fold(0.0, f64::max);
            assert!(chance > 0.5 * level, "{level}: {chance}");
            let rounded = chance * (1.0 + 1e-9);
            let below = p_values.iter().filter(|p| **p <= rounded).count() as f64 / TRIALS as f64;
            let deviation = (chance * (1.0 - chance) / TRIALS as f64).sqrt();
            assert!(
                (below - chance).abs() <= 5.0 * deviation,
                "p <= {level} in {below} of the trials instead of {chance} +- {deviation}"
            );
        }
    }

    #[test]
    fn what_is_shifted_is_found_out() {
        let shifted = |by: f64, index| {
            let mut draws = Draws::new(3, index);
            Distribution::of((0..200).map(|_| draws.uniform() + by)).unwrap()
        };
        // half of a uniform distribution moved past the other: chance alone does that with 4 exp(-2 d^2 n m/(n + m)) at most
        let got = kolmogorov_smirnov(&shifted(0.0, 1), &shifted(0.5, 2));
        assert!(got.distance > 0.4 && got.p < 1e-12, "{got:?}");
        let same = kolmogorov_smirnov(&shifted(0.0, 1), &shifted(0.0, 1));
        assert_eq!((same.distance, same.p), (0.0, 1.0));
    }

    #[test]
    fn holm_corrects_as_statsmodels_does() {
        // statsmodels.stats.multitest.multipletests(p, method="holm")
        let got = holm(&[0.01, 0.04, 0.03, 0.005, 0.6, 0.02]);
        for (got, want) in got.iter().zip([0.05, 0.09, 0.09, 0.03, 0.6, 0.08]) {
            assert_relative_eq!(*got, want, max_relative = ROUNDING);
        }
        assert_eq!(holm(&[0.4, 0.9, 0.5]), [1.0; 3]);
        assert_eq!(holm(&[]), [0.0; 0]);
    }
}
