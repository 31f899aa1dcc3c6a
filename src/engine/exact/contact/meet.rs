//! When something meets a ball that is held, or two parties that have just parted meet again.
//!
//! Held balls move along series, which the finders of `math::first_root` do not take. Their bounds are known, though: no gap closes faster than the
//! speeds allow, and its rate changes no faster than the accelerations do. So the search goes on by steps that are safe: within each, the gap cannot
//! close even if everything works towards it. Near a root the steps become those of Newton from outside, and it cannot be passed.

use super::arc::Series;
use crate::engine::exact::flight::Flight;
use crate::math::Real;
use crate::math::first_root::Blur;

/// Steps of a search, at most.
const STEPS: usize = 1024;

/// Halvings of the time in which a parting gap is looked for.
const HALVINGS: i32 = 60;

/// Times at which a gap is looked at that no bound of its acceleration tells of.
const LOOKS: u32 = 256;

/// A gap beyond this many errors of a position is one.
const CLEAR: f64 = 16.0;

/// How a centre moves.
#[derive(Clone, Copy, Debug)]
pub enum Path<'a, T> {
    /// By constant acceleration.
    Flight(&'a Flight<T>),
    /// By a series from a time on, s.
    Series(&'a Series<T>, T),
    /// It stays: a pocket.
    Place([T; 2]),
}

impl<T: Real> Path<'_, T> {
    /// Centre and velocity at time `t`, s.
    pub fn at(&self, t: T) -> ([T; 2], [T; 2]) {
        match self {
            Path::Flight(flight) => flight.at(t),
            Path::Series(series, start) => {
                let moving = series.at(t - *start);
                (moving.position, moving.velocity)
            }
            Path::Place(place) => (*place, [T::zero(); 2]),
        }
    }

    /// Its acceleration at time `t`, s, length/s^2.
    fn acceleration(&self, t: T) -> [T; 2] {
        match self {
            Path::Flight(flight) => flight.acceleration,
            Path::Series(series, start) => series.acceleration(t - *start),
            Path::Place(_) => [T::zero(); 2],
        }
    }

    /// How fast that changes, length/s^3, at most.
    fn jerk(&self) -> T {
        match self {
            Path::Series(series, _) => T::lift(series.jerk),
            Path::Flight(_) | Path::Place(_) => T::zero(),
        }
    }

    /// Its acceleration is no larger than this, length/s^2.
    fn strongest(&self) -> T {
        match self {
            Path::Flight(flight) => {
                let [x, y] = flight.acceleration;
                (x * x + y * y).sqrt()
            }
            Path::Series(series, _) => series.strongest,
            Path::Place(_) => T::zero(),
        }
    }
}

/// How fast the rate of a gap between two paths may fall at any time of a span, s: how far they part sideways only slows that down.
pub fn falls<T: Real>(one: Path<'_, T>, other: Path<'_, T>, [from, until]: [T; 2]) -> T {
    let (first, second) = (one.acceleration(from), other.acceleration(from));
    let [x, y] = [0, 1].map(|axis| second[axis] - first[axis]);
    let changes = (one.jerk() + other.jerk()) * (until - from).at_least(T::zero());
    let now = (x * x + y * y).sqrt();
    (now + changes).at_most(one.strongest() + other.strongest())
}

/// A gap that may close: its size and its rate, both at a time, and how much the rate may fall in a second.
pub struct Gap<'a, T> {
    /// Size, length, and rate, length/s, at a time, s.
    pub at: &'a dyn Fn(T) -> (T, T),
    /// The rate falls no faster than this, length/s^2.
    pub falls: T,
    /// A rate of no more than this is rounding, length/s.
    pub still: T,
}

/// The gap between two discs that touch at `distance`, and how fast its rate may fall at any time of a span, s.
pub fn between<'a, T: Real>(
    one: Path<'a, T>,
    other: Path<'a, T>,
    distance: T,
    span: [T; 2],
) -> (impl Fn(T) -> (T, T) + 'a, T) {
    let falls = falls(one, other, span);
    let at = move |t: T| {
        let ((p, v), (q, w)) = (one.at(t), other.at(t));
        let (x, y) = (q[0] - p[0], q[1] - p[1]);
        let apart = (x * x + y * y).sqrt();
        let rate = ((w[0] - v[0]) * x + (w[1] - v[1]) * y) / apart;
        (apart - distance, rate)
    };
    (at, falls)
}

/// The first time from `from` on, up to `until`, s, at which the gap has closed and goes on closing. `parting`: a gap that begins at nothing has to
/// open first.
pub fn closes<T: Real>(
    gap: &Gap<'_, T>,
    [from, until]: [T; 2],
    parting: bool,
    blur: &Blur<T>,
) -> Option<T> {
    let zero = T::zero();
    let mut t = from;
    let clear = blur.length * T::lift(CLEAR);
    let (begins, rate) = (gap.at)(from);
    // its rate does not tell what a gap does that begins at nothing; parties that have parted meet again like any others
    if begins <= clear && (parting || rate >= -gap.still) {
        let looks = (0..=HALVINGS).rev();
        let looks = looks.map(|halvings| from + (until - from) * T::lift(0.5_f64.powi(halvings)));
        let mut before = from;
        let told = looks.into_iter().find_map(|t| {
            let opened = (gap.at)(t).0 - begins;
            let told = (opened.abs() > clear).then_some((before, t, opened));
            before = t;
            told
        });
        match told {
            Some((_, opens, opened)) if opened > zero => t = opens,
            Some((before, closes, _)) => {
                return Some(crossing(gap, [before, closes], begins - blur.length));
            }
            None => return None,
        }
    }
    let tick = |t: T| t.abs().at_least(until.abs()) * T::lift(T::ULP);
    for _ in 0..STEPS {
        if t > until {
            return None;
        }
        let (size, rate) = (gap.at)(t);
        let closed = size <= blur.length;
        if closed && rate < -gap.still {
            return Some(t);
        }
        // within this time the gap cannot close: size + rate s - falls s^2 / 2 >= 0
        let size = size.at_least(zero);
        let root = (rate * rate + (gap.falls + gap.falls) * size).sqrt();
        let step = if rate < zero {
            // the other form cancels where the gap closes by its rate alone
            (size + size) / (root - rate)
        } else if gap.falls > zero {
            (rate + root) / gap.falls
        } else {
            return None;
        };
        if step <= tick(t) {
            if rate < -gap.still {
                return Some(t);
            }
            // it touches without closing in: to where rounding lets it tell
            t += tick(t) * T::lift(64.0);
        } else {
            t += step;
        }
    }
    // parties that go nearly alongside, for which that bound is far too careful
    let mut before = t;
    let looks =
        (1..=LOOKS).map(|look| t + (until - t) * T::lift(f64::from(look) / f64::from(LOOKS)));
    looks.into_iter().find_map(|t| {
        let closed = (gap.at)(t).0 < -blur.length;
        let found = closed.then(|| crossing(gap, [before, t], zero));
        before = t;
        found
    })
}

/// When a gap falls to a size between two times, s, of which it is larger at the first and smaller at the second.
fn crossing<T: Real>(gap: &Gap<'_, T>, [mut low, mut high]: [T; 2], size: T) -> T {
    for _ in 0..HALVINGS {
        let middle = (low + high) * T::lift(0.5);
        if (gap.at)(middle).0 < size {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use super::*;

    /// When a gap closes that begins with a size, a rate and an acceleration; one that falls by 1 length/s^2 at most, for all that is known.
    fn closing(size: f64, rate: f64, acceleration: f64, parting: bool) -> Option<f64> {
        let at = |t: f64| {
            let half = 0.5 * acceleration * t;
            (size + (rate + half) * t, rate + acceleration * t)
        };
        let gap = Gap {
            at: &at,
            falls: 1.0,
            still: 1e-18,
        };
        let blur = Blur {
            length: 1e-16,
            speed: 0.0,
        };
        closes(&gap, [0.0, 1.0], parting, &blur)
    }

    #[test]
    fn parties_that_touch_and_go_nearly_alongside_close_where_their_gap_has_no_size_any_more() {
        // opens by its rate, by less than rounding, and closes by an acceleration far below what bounds it
        let found = closing(-7e-17, 1e-13, -2e-9, false).unwrap_or(f64::NAN);
        let size = -7e-17 + (1e-13 - 1e-9 * found) * found;
        // what it begins with and what is clear of it are told apart no better
        assert!(size.abs() <= CLEAR * 1e-16, "{found}: {size:e}");
    }

    #[test]
    fn parties_that_have_parted_do_not_meet_before_their_gap_is_closed() {
        let found = closing(0.25, -0.5, 0.0, true).unwrap_or(f64::NAN);
        assert!((found - 0.5).abs() < 1e-12, "{found}");
        // and those that part from contact meet when they come back
        let found = closing(0.0, 0.25, -1.0, true).unwrap_or(f64::NAN);
        assert!((found - 0.5).abs() < 1e-12, "{found}");
        assert_eq!(closing(0.0, 0.25, 0.0, true), None);
    }
}
