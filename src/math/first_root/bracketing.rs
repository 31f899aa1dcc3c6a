//! A second finder for the first contact of two discs, for cross-checks only: it shares no code with the first.
//!
//! Between neighbouring roots of a derivative a function is monotone, so each of its roots there is bracketed. From the
//! roots of `f''` (a quadratic) follow those of `f'`, from those the first root of `f`, each by bisection to the last bit. It
//! is slow and has nothing that could be tuned.

use super::Approach;
use crate::math::Real;

/// First contact up to `limit`, s from now, by the event rule; `None` if there is none.
///
/// It does not know the blur of its input: a graze is a hit or a miss as its digits say. Bisection takes as many steps as the
/// scalar has bits, and its exponent: with 237 bits it is a witness for any other scalar.
pub fn bracketed_contact<T: Real>(approach: &Approach<T>, limit: T) -> Option<T> {
    let Approach { p, v, a, distance } = *approach;
    let (zero, half) = (T::zero(), T::lift(0.5));
    let offset = |t: T| [0, 1].map(|i| p[i] + v[i] * t + half * a[i] * t * t);
    let velocity = |t: T| [0, 1].map(|i| v[i] + a[i] * t);
    let f = |t: T| {
        let [x, y] = offset(t);
        let apart = (x * x + y * y).sqrt();
        (apart - distance) * (apart + distance)
    };
    let slope = |t: T| {
        let ([x, y], [u, w]) = (offset(t), velocity(t));
        x * u + y * w
    };
    let mut marks = vec![zero];
    marks.extend(roots_of_curvature(approach, limit));
    marks.push(limit);
    let mut turns = vec![zero];
    for pair in marks.windows(2) {
        if (slope(pair[0]) < zero) != (slope(pair[1]) < zero) {
            turns.push(bisect(slope, pair[0], pair[1]));
        }
    }
    turns.push(limit);
    for pair in turns.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        if to <= from || slope(half * (from + to)) >= zero {
            continue;
        }
        if f(from) <= zero {
            return Some(from);
        }
        if f(to) <= zero {
            return Some(bisect(f, from, to));
        }
    }
    None
}

/// Roots within (0, limit) of `f''/2 = v.v + a.p + 3 (v.a) t + 3/2 (a.a) t^2`, ascending.
fn roots_of_curvature<T: Real>(approach: &Approach<T>, limit: T) -> Vec<T> {
    let Approach { p, v, a, .. } = *approach;
    let (zero, half) = (T::zero(), T::lift(0.5));
    let dot = |x: [T; 2], y: [T; 2]| x[0] * y[0] + x[1] * y[1];
    let (c, b) = (dot(v, v) + dot(a, p), T::lift(3.0) * dot(v, a));
    let q = T::lift(1.5) * dot(a, a);
    let square = b * b - T::lift(4.0) * q * c;
    if q == zero || square <= zero {
        return Vec::new();
    }
    let root = square.sqrt();
    let big = -half * if b < zero { b - root } else { b + root };
    let mut roots = vec![big / q, if big == zero { zero } else { c / big }];
    roots.retain(|t| *t > zero && *t < limit);
    if let [one, other] = roots[..]
        && one > other
    {
        roots.reverse();
    }
    roots
}

/// The point where `g` changes sign between `from` and `to`, to the last bit; on the side of `to`.
fn bisect<T: Real>(g: impl Fn(T) -> T, mut from: T, mut to: T) -> T {
    let zero = T::zero();
    let start = g(from) > zero;
    loop {
        let middle = T::lift(0.5) * (from + to);
        if middle <= from || middle >= to {
            return to;
        }
        if (g(middle) > zero) == start {
            from = middle;
        } else {
            to = middle;
        }
    }
}
