//! A second finder for the first contact of two discs, for cross-checks only: it shares no code with the first.
//!
//! Between neighbouring roots of a derivative a function is monotone, so each of its roots there is bracketed. From the
//! roots of `f''` (a quadratic) follow those of `f'`, from those the first root of `f`, each by bisection to the last bit. It
//! is slow and has nothing that could be tuned.

use super::Approach;

/// First contact up to `limit`, s from now, by the event rule; `None` if there is none.
///
/// It does not know the blur of its input: a graze is a hit or a miss as its digits say.
pub fn bracketed_contact(approach: &Approach<f64>, limit: f64) -> Option<f64> {
    let Approach { p, v, a, distance } = *approach;
    let offset = |t: f64| [0, 1].map(|i| p[i] + v[i] * t + 0.5 * a[i] * t * t);
    let velocity = |t: f64| [0, 1].map(|i| v[i] + a[i] * t);
    let f = |t: f64| {
        let d = offset(t);
        (d[0].hypot(d[1]) - distance) * (d[0].hypot(d[1]) + distance)
    };
    let slope = |t: f64| {
        let (d, u) = (offset(t), velocity(t));
        d[0] * u[0] + d[1] * u[1]
    };
    let mut marks = vec![0.0];
    marks.extend(roots_of_curvature(approach, limit));
    marks.push(limit);
    let mut turns = vec![0.0];
    for pair in marks.windows(2) {
        if (slope(pair[0]) < 0.0) != (slope(pair[1]) < 0.0) {
            turns.push(bisect(slope, pair[0], pair[1]));
        }
    }
    turns.push(limit);
    for pair in turns.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        if to <= from || slope(0.5 * (from + to)) >= 0.0 {
            continue;
        }
        if f(from) <= 0.0 {
            return Some(from);
        }
        if f(to) <= 0.0 {
            return Some(bisect(f, from, to));
        }
    }
    None
}

/// Roots within (0, limit) of `f''/2 = v.v + a.p + 3 (v.a) t + 3/2 (a.a) t^2`, ascending.
fn roots_of_curvature(approach: &Approach<f64>, limit: f64) -> Vec<f64> {
    let Approach { p, v, a, .. } = *approach;
    let dot = |x: [f64; 2], y: [f64; 2]| x[0] * y[0] + x[1] * y[1];
    let (c, b, q) = (dot(v, v) + dot(a, p), 3.0 * dot(v, a), 1.5 * dot(a, a));
    let square = b * b - 4.0 * q * c;
    if q == 0.0 || square <= 0.0 {
        return Vec::new();
    }
    let big = -0.5 * (b + square.sqrt().copysign(b));
    let mut roots = vec![big / q, if big == 0.0 { 0.0 } else { c / big }];
    roots.retain(|t| *t > 0.0 && *t < limit);
    roots.sort_by(f64::total_cmp);
    roots
}

/// The point where `g` changes sign between `from` and `to`, to the last bit; on the side of `to`.
fn bisect(g: impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> f64 {
    let start = g(from) > 0.0;
    loop {
        let middle = 0.5 * (from + to);
        if middle <= from || middle >= to {
            return to;
        }
        if (g(middle) > 0.0) == start {
            from = middle;
        } else {
            to = middle;
        }
    }
}
