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
const STEPS: usize = 4096;

/// Halvings of the time in which a parting gap is looked for.
const HALVINGS: i32 = 60;

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

/// A gap that may close: its size and its rate, both at a time, and how much the rate may fall in a second.
pub struct Gap<'a, T> {
    /// Size, length, and rate, length/s, at a time, s.
    pub at: &'a dyn Fn(T) -> (T, T),
    /// The rate falls no faster than this, length/s^2.
    pub falls: T,
}

/// The gap between two discs that touch at `distance`.
pub fn between<'a, T: Real>(
    one: Path<'a, T>,
    other: Path<'a, T>,
    distance: T,
) -> (impl Fn(T) -> (T, T) + 'a, T) {
    let falls = one.strongest() + other.strongest();
    let at = move |t: T| {
        let ((p, v), (q, w)) = (one.at(t), other.at(t));
        let (x, y) = (q[0] - p[0], q[1] - p[1]);
        let apart = (x * x + y * y).sqrt();
        let rate = ((w[0] - v[0]) * x + (w[1] - v[1]) * y) / apart;
        (apart - distance, rate)
    };
    (at, falls)
}

/// The first time from `from` on, up to `until`, s, at which the gap has closed and goes on closing. `parting`: the gap begins at nothing and has to
/// open first.
pub fn closes<T: Real>(
    gap: &Gap<'_, T>,
    [from, until]: [T; 2],
    parting: bool,
    blur: &Blur<T>,
) -> Option<T> {
    let zero = T::zero();
    let mut t = from;
    if parting {
        let clear = blur.length * T::lift(CLEAR);
        let (begins, _) = (gap.at)(from);
        let open = (0..=HALVINGS).rev().find_map(|halvings| {
            let t = from + (until - from) * T::lift(0.5_f64.powi(halvings));
            let opened = (gap.at)(t).0 - begins;
            (opened.abs() > clear).then_some((t, opened))
        });
        match open {
            Some((opens, opened)) if opened > zero => t = opens,
            Some((closes, _)) => return Some(closes),
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
        if closed && rate < -blur.speed {
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
            if rate < -blur.speed {
                return Some(t);
            }
            // it touches without closing in: to where rounding lets it tell
            t += tick(t) * T::lift(64.0);
        } else {
            t += step;
        }
    }
    None
}
