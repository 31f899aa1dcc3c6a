//! How good a contact time can be, and how good the finders make it: the error theory of this module.
//!
//! **What the input allows.** The numbers of an approach are rounded, so the motion that was meant differs from the motion
//! that is solved: at time `t` the distance of the centres by up to
//!
//! ```text
//! d(t) = |dp| + |dv| t + |da| t^2 / 2 + dD                                                        (InputError::length)
//! ```
//!
//! Where the centres close in with the normal speed `v_n`, the contact moves by `d / v_n`. That is the condition of the
//! problem, and no finder can do better. Near a graze or a stop `v_n` vanishes and the root moves like a square root; so the
//! bound is not the quotient but the solution of
//!
//! ```text
//! |f'| s - M s^2 / 2 = d (2 D + d),   f' = -2 D v_n,   s <= tau = 2 d (2 D + d) / |f'|                    (time_error)
//! ```
//!
//! with `M` the largest `|f''|` within `tau` of the contact. `f''` is a parabola that opens upwards, so `M` is known from its
//! ends and its vertex, and the bound holds to all orders. Without a real solution (`f'^2 < 2 M d (2 D + d)`: the discs
//! pass through each other by less than about `d`) an error of that size may remove the contact, and there is no bound.
//!
//! **What a finder adds.** Each finder returns the exact contact of an approach whose numbers differ a little from those that it
//! was given (backward error). Counted from the operations that lead to the returned time, in units of `u`, the largest
//! relative error of one operation ([`Real::ROUNDING`], half an ulp where operations round to nearest):
//!
//! | finder | position | velocity | acceleration | of these |
//! |---|---|---|---|---|
//! | `first_contact` | 4 D | 3 v | 5 a | the last Newton step: `p + t (v + a t/2)` D + 2 v + 3 a, the squares and `f` 2 D, what is left of convergence 1 D, rounding of `t` v + 2 a |
//! | `straight_contact` | 5 p + 3 D | 13 v | | miss distance 2 p + 3 D, `f` 3 p or 4 v, `w` 6 v, `t` 3 v |
//! | `first_crossing` | | 5 v | 8 a | the square of the speed at the line, its root, the quotient, rounding of `t` |
//!
//! A contact that the finder reports for a start within the blur (time 0) is early or late by the blur, which is then the
//! error of the position. Everything here is first order in `u`, and for numbers whose squares stay within the range of
//! the scalar.
//!
//! **Where there is no bound there must be no answer.** [`Contact::Unclear`](super::Contact::Unclear) is due where the contact is shallower than
//! the error, and a finder answers so below [`Blur::length`](super::Blur), which its caller sets to the error of all that went
//! before.

use super::Approach;
use crate::math::Real;

/// Errors of the numbers of an approach; lengths of vectors, all >= 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InputError<T> {
    /// Of the relative position and of the contact distance together, length.
    pub position: T,
    /// Of the relative velocity, length/s.
    pub velocity: T,
    /// Of the relative acceleration, length/s^2.
    pub acceleration: T,
}

impl<T: Real> InputError<T> {
    /// Every number of the approach is off by its own rounding.
    ///
    /// `rounding`: largest relative error of one operation of the scalar that holds them, [`Real::ROUNDING`].
    pub fn of_numbers(approach: &Approach<T>, rounding: f64) -> Self {
        Self::in_units(approach, rounding, [1.0, 1.0, 1.0, 1.0])
    }

    /// Backward error of [`first_contact`](super::first_contact) in a scalar with this rounding.
    pub fn of_search(approach: &Approach<T>, rounding: f64) -> Self {
        Self::in_units(approach, rounding, [0.0, 4.0, 3.0, 5.0])
    }

    /// Backward error of [`straight_contact`](super::straight_contact) in a scalar with this rounding.
    pub fn of_straight(approach: &Approach<T>, rounding: f64) -> Self {
        Self::in_units(approach, rounding, [5.0, 3.0, 13.0, 0.0])
    }

    /// Backward error of [`first_crossing`](super::first_crossing) in a scalar with this rounding; `speed` and
    /// `acceleration` as given to it.
    pub fn of_crossing(speed: T, acceleration: T, rounding: f64) -> Self {
        InputError {
            position: T::zero(),
            velocity: speed.abs() * T::lift(5.0 * rounding),
            acceleration: acceleration.abs() * T::lift(8.0 * rounding),
        }
    }

    /// So many roundings of position, distance, velocity and acceleration.
    fn in_units(approach: &Approach<T>, rounding: f64, [p, d, v, a]: [f64; 4]) -> Self {
        let unit = |count: f64| T::lift(count * rounding);
        InputError {
            position: size(approach.p) * unit(p) + approach.distance * unit(d),
            velocity: size(approach.v) * unit(v),
            acceleration: size(approach.a) * unit(a),
        }
    }

    /// Both errors together.
    pub fn and(self, other: Self) -> Self {
        InputError {
            position: self.position + other.position,
            velocity: self.velocity + other.velocity,
            acceleration: self.acceleration + other.acceleration,
        }
    }

    /// By how much the distance of the centres is off at time `t`, length.
    pub fn length(&self, t: T) -> T {
        self.position + t * (self.velocity + t * self.acceleration * T::lift(0.5))
    }

    /// By how much the relative velocity is off at time `t`, length/s.
    pub fn speed(&self, t: T) -> T {
        self.velocity + t * self.acceleration
    }
}

/// By how much a contact at time `t` can move when the numbers of the approach are off by `error`, s.
///
/// `None` if an error of that size may remove the contact: it is a graze or a stop at the level of the error, or the
/// discs do not close in at `t` at all.
pub fn time_error<T: Real>(approach: &Approach<T>, t: T, error: &InputError<T>) -> Option<T> {
    let Approach { p, v, a, distance } = *approach;
    let half = T::lift(0.5);
    let at = |i: usize| (p[i] + t * (v[i] + a[i] * t * half), v[i] + a[i] * t);
    let ((x, u), (y, w)) = (at(0), at(1));
    let closing = -(x * u + y * w) * T::lift(2.0);
    let two = T::lift(2.0);
    let dot = |x: [T; 2], y: [T; 2]| x[0] * y[0] + x[1] * y[1];
    // f'' = c0 + c1 t + c2 t^2
    let c0 = (dot(v, v) + dot(a, p)) * two;
    let (c1, c2) = (dot(v, a) * T::lift(6.0), dot(a, a) * T::lift(3.0));
    let curvature = |t: T| (c0 + t * (c1 + t * c2)).abs();
    let steepest = |tau: T| {
        let ends = curvature(t - tau).at_least(curvature(t + tau));
        let vertex = -c1 / (c2 + c2);
        // without acceleration there is none
        if (vertex - t).abs() < tau {
            ends.at_least(curvature(vertex))
        } else {
            ends
        }
    };
    let off = |tau: T| {
        let length = error.length(t + tau);
        length * (distance + distance + length)
    };
    moved(closing, off, steepest)
}

/// By how much the time `t` of a crossing can move when gap, speed and acceleration are off by `error`, s. `speed` and
/// `acceleration` as given to [`first_crossing`](super::first_crossing).
///
/// `None` if an error of that size may remove the crossing.
pub fn crossing_error<T: Real>(
    speed: T,
    acceleration: T,
    t: T,
    error: &InputError<T>,
) -> Option<T> {
    let outward = speed + acceleration * t;
    moved(outward, |tau| error.length(t + tau), |_| acceleration.abs())
}

/// By how much the time `t` at which an overlapping pair turns inward can move when the numbers of the approach are off by
/// `error`, s; there `f'` is zero, and it is `f''` that carries the condition.
///
/// `None` if an error of that size may remove the turn.
pub fn turn_error<T: Real>(approach: &Approach<T>, t: T, error: &InputError<T>) -> Option<T> {
    let Approach { p, v, a, .. } = *approach;
    let dot = |x: [T; 2], y: [T; 2]| x[0] * y[0] + x[1] * y[1];
    let half = T::lift(0.5);
    let position = [0, 1].map(|i| p[i] + t * (v[i] + a[i] * t * half));
    let velocity = [0, 1].map(|i| v[i] + a[i] * t);
    let falling = -(dot(velocity, velocity) + dot(a, position));
    let off = |tau: T| {
        let t = t + tau;
        let (length, speed) = (error.length(t), error.speed(t));
        size(position) * speed + size(velocity) * length + length * speed
    };
    let third = |t: T| (dot(v, a) + dot(a, a) * t).abs() * T::lift(3.0);
    moved(falling, off, |tau| third(t - tau).at_least(third(t + tau)))
}

/// By how much the root of a function can move that falls with `slope` and whose value is off by `off(tau)`, where its
/// second derivative is at most `curvature(tau)`, both within `tau` of the root.
fn moved<T: Real>(slope: T, off: impl Fn(T) -> T, curvature: impl Fn(T) -> T) -> Option<T> {
    let zero = T::zero();
    if slope <= zero {
        return None;
    }
    let (two, four) = (T::lift(2.0), T::lift(4.0));
    // room for an error that grows within the window
    let tau = four * off(zero) / slope;
    let e = off(tau);
    let square = slope * slope - two * curvature(tau) * e;
    if square < zero || two * e > tau * slope {
        return None;
    }
    Some(two * e / (slope + square.sqrt()))
}

fn size<T: Real>(v: [T; 2]) -> T {
    (v[0] * v[0] + v[1] * v[1]).sqrt()
}
