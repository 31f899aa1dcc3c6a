//! What has no place on a logarithmic axis: zeros, and runs without a number. They stand at marks beside all others.

use crate::finding::Mark;

/// Where zeros stand: the power of ten that is half a decade or more below the smallest number above zero, `otherwise` if there is
/// none.
pub fn zero_among(numbers: impl IntoIterator<Item = f64>, otherwise: f64) -> f64 {
    let positive = numbers.into_iter().filter(|x| x.is_finite() && *x > 0.0);
    let least = positive.fold(f64::INFINITY, f64::min);
    if least.is_finite() {
        10f64
            .powf((least.log10() - 0.5).floor())
            .max(f64::MIN_POSITIVE)
    } else {
        otherwise
    }
}

/// Where runs without a number stand: the power of ten that is half a decade or more above the largest, `otherwise` if there is none.
pub fn beyond(numbers: impl IntoIterator<Item = f64>, otherwise: f64) -> f64 {
    let finite = numbers.into_iter().filter(|x| x.is_finite() && *x > 0.0);
    let most = finite.fold(0.0, f64::max);
    if most > 0.0 {
        10f64.powf((most.log10() + 0.5).ceil()).min(f64::MAX)
    } else {
        otherwise
    }
}

/// A mark with words.
pub fn mark(at: f64, label: impl Into<String>) -> Mark {
    Mark {
        at,
        label: label.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::{beyond, zero_among};

    #[test]
    fn zeros_and_runs_without_a_number_stand_clear_of_all_others() {
        for numbers in [&[0.0, 3e-4, 20.0][..], &[1e-300], &[1.0, f64::INFINITY]] {
            let finite = || {
                numbers
                    .iter()
                    .copied()
                    .filter(|x| *x > 0.0 && x.is_finite())
            };
            let (zero, far) = (
                zero_among(numbers.iter().copied(), 1.0),
                beyond(numbers.iter().copied(), 1.0),
            );
            // half a decade, to within the rounding of a power
            for x in finite() {
                assert!(zero * 3.1 < x && far > 3.1 * x, "{zero} {x} {far}");
            }
            assert!(finite().count() > 0);
        }
        assert_eq!(
            (zero_among([0.0], 7.0), beyond([f64::NAN], 7.0)),
            (7.0, 7.0)
        );
    }
}
