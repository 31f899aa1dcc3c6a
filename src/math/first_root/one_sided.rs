//! The first contact of two discs with constant relative acceleration: a finder that cannot step past the first root.
//!
//! `f''` is a parabola in `t`, so its minimum `m` over any stretch is known in closed form, and
//! `f(t) + f'(t) s + m s^2 / 2` is below `f(t + s)` there. The first root of that bound is never behind the first root of `f`:
//! stepping to it again and again converges from the left, quadratically, and a bound without a root proves a miss. The
//! stretch ends at the inflections of `f` and soon after its expected minimum, which keeps the bound tight in grazes.
//!
//! Error: that of the last Newton step, see `error.rs`. A contact that an error of the size of the blur could remove, or move
//! without bound, is [`Contact::Unclear`] instead.

use super::{Approach, Blur, Contact};
use crate::math::Real;

/// More steps than any convergent search takes; beyond it bisection answers.
const PATIENCE: usize = 64;

/// Beyond this many bits a scalar is a witness against the others, and its roots are polished to the last digit.
const MANY_BITS: u32 = 128;

/// First contact up to `limit`, s from now, by the event rule of this module.
#[inline]
pub fn first_contact<T: Real>(approach: &Approach<T>, limit: T, blur: &Blur<T>) -> Contact<T> {
    first_contact_by(approach, limit, limit, blur)
}

/// First contact up to `end`, if anyone wants to know: what is later than `limit` may be answered [`Contact::Never`].
///
/// A contact that is answered is that of [`first_contact`] up to `end`, to the bit, whatever `limit` is: a search that is cut
/// short takes the same steps. Give `limit` a few ulps more than the time that matters.
#[inline]
pub fn first_contact_by<T: Real>(
    approach: &Approach<T>,
    end: T,
    limit: T,
    blur: &Blur<T>,
) -> Contact<T> {
    let curve = Curve::new(approach, blur);
    if curve.stays_apart(limit) {
        return Contact::Never;
    }
    curve.search(end, limit, blur)
}

/// The distance function and the parabola that is its second derivative.
struct Curve<T> {
    approach: Approach<T>,
    square: T,
    /// `f'' = c0 + c1 t + c2 t^2`.
    c0: T,
    c1: T,
    c2: T,
    /// Error of `f` near contact.
    blurred: T,
    /// An ulp of `D^2`.
    ulp: T,
}

/// A time with the value and slope of `f`.
#[derive(Clone, Copy)]
struct Point<T> {
    t: T,
    f: T,
    slope: T,
}

/// A stretch from now on in which `f''` keeps its sign.
struct Stretch<T> {
    end: T,
    convex: bool,
}

impl<T: Real> Curve<T> {
    fn new(approach: &Approach<T>, blur: &Blur<T>) -> Self {
        let Approach { p, v, a, distance } = *approach;
        let dot = |x: [T; 2], y: [T; 2]| x[0] * y[0] + x[1] * y[1];
        Curve {
            approach: *approach,
            square: distance * distance,
            c0: (dot(v, v) + dot(a, p)) * T::lift(2.0),
            c1: dot(v, a) * T::lift(6.0),
            c2: dot(a, a) * T::lift(3.0),
            blurred: (distance + distance) * blur.length,
            ulp: distance * distance * T::lift(T::ULP),
        }
    }

    /// True if the bound over the whole stretch proves a miss: the answer for most pairs, without a root or a division.
    #[inline]
    fn stays_apart(&self, limit: T) -> bool {
        let start = self.start();
        let bound = self.least_curvature(T::zero(), limit);
        let half = bound * T::lift(0.5);
        // a graze is unclear from where its distance function is 3 `blurred` or less
        let margin = self.blurred * T::lift(4.0) + start.f * T::lift(32.0 * T::ULP);
        let clear = start.f - margin;
        if clear <= T::zero() {
            return false;
        }
        if bound > T::zero() {
            // lowest where the slope of the bound vanishes
            start.slope >= T::zero() || start.slope * start.slope < T::lift(4.0) * half * clear
        } else {
            // concave, and positive at both ends
            clear + limit * (start.slope + half * limit) > T::zero()
        }
    }

    #[inline(never)]
    fn search(&self, last: T, limit: T, blur: &Blur<T>) -> Contact<T> {
        let start = self.start();
        if start.f <= self.blurred {
            self.search_from_inside(&start, last, limit, blur)
        } else {
            self.search_from_outside(start, last, limit, blur)
        }
    }

    fn start(&self) -> Point<T> {
        let Approach { p, v, .. } = &self.approach;
        let slope = p[0] * v[0] + p[1] * v[1];
        Point {
            t: T::zero(),
            f: p[0] * p[0] + p[1] * p[1] - self.square,
            slope: slope + slope,
        }
    }

    fn at(&self, t: T) -> Point<T> {
        let Approach { p, v, a, .. } = &self.approach;
        let half = t * T::lift(0.5);
        let x = p[0] + t * (v[0] + a[0] * half);
        let y = p[1] + t * (v[1] + a[1] * half);
        let slope = x * (v[0] + a[0] * t) + y * (v[1] + a[1] * t);
        Point {
            t,
            f: x * x + y * y - self.square,
            slope: slope + slope,
        }
    }

    fn curvature(&self, t: T) -> T {
        self.c0 + t * (self.c1 + t * self.c2)
    }

    /// Smallest `f''` between two times.
    fn least_curvature(&self, from: T, to: T) -> T {
        let vertex = -self.c1; // over 2 c2
        let twice = self.c2 + self.c2;
        if vertex <= from * twice {
            self.curvature(from)
        } else if vertex >= to * twice {
            self.curvature(to)
        } else {
            self.c0 - self.c1 * self.c1 / (twice + twice)
        }
    }

    /// The two inflections of `f`, if it has any.
    fn inflections(&self) -> Option<(T, T)> {
        let four = T::lift(4.0);
        let square = self.c1 * self.c1 - four * self.c2 * self.c0;
        if square <= T::zero() || self.c2 <= T::zero() {
            return None;
        }
        // without cancellation: the larger root in magnitude first, the other from their product
        let big = if self.c1 >= T::zero() {
            -(self.c1 + square.sqrt()) / T::lift(2.0)
        } else {
            (square.sqrt() - self.c1) / T::lift(2.0)
        };
        let (one, other) = (big / self.c2, self.c0 / big);
        Some((one.at_most(other), one.at_least(other)))
    }

    /// Searches from a point at which the discs are apart up to `last`, for a contact that is not after `limit`.
    fn search_from_outside(
        &self,
        start: Point<T>,
        last: T,
        limit: T,
        blur: &Blur<T>,
    ) -> Contact<T> {
        let inflections = self.inflections();
        let mut here = start;
        loop {
            let stretch = match inflections {
                Some((first, _)) if here.t < first => Stretch {
                    end: first,
                    convex: true,
                },
                Some((_, second)) if here.t < second => Stretch {
                    end: second,
                    convex: false,
                },
                _ => Stretch {
                    end: last,
                    convex: true,
                },
            };
            let end = stretch.end.at_most(last);
            let found = if stretch.convex {
                self.through_convex(here, end, limit, blur)
            } else {
                self.through_concave(here, end, limit, blur)
            };
            if found != Contact::Never || end >= last || end > limit {
                return found;
            }
            here = self.at(end);
            if here.f <= T::zero() {
                // an inflection at the contact itself
                return self.finish(here, blur);
            }
        }
    }

    /// A stretch in which `f` has at most one minimum.
    fn through_convex(&self, start: Point<T>, end: T, limit: T, blur: &Blur<T>) -> Contact<T> {
        let zero = T::zero();
        let two = T::lift(2.0);
        let mut here = start;
        for _ in 0..PATIENCE {
            if here.slope >= zero {
                // past the minimum; close to it only if the steps led there
                return if here.f <= self.blurred {
                    Contact::Unclear(here.t)
                } else {
                    Contact::Never
                };
            }
            let now = self.curvature(here.t);
            let ahead = if now > zero {
                end.at_most(here.t - two * here.slope / now)
            } else {
                end
            };
            let bound = self.least_curvature(here.t, ahead).at_least(zero);
            let square = here.slope * here.slope - two * bound * here.f;
            if square < zero {
                let lowest = here.f - here.slope * here.slope / (bound + bound);
                if lowest <= self.blurred + here.f * T::lift(32.0 * T::ULP) {
                    return self.graze(here, end, blur);
                }
            }
            let step = two * here.f / (square.at_least(zero).sqrt() - here.slope);
            if square < zero || here.t + step > ahead {
                if ahead >= end {
                    return Contact::Never;
                }
                here = self.at(ahead);
            } else {
                here = self.at(here.t + step);
            }
            if here.t > limit {
                return Contact::Never;
            }
            if self.converged(&here) {
                return self.finish(here, blur);
            }
        }
        self.graze(here, end, blur)
    }

    /// A stretch in which `f` has no minimum: a contact there shows at its end.
    fn through_concave(&self, start: Point<T>, end: T, limit: T, blur: &Blur<T>) -> Contact<T> {
        let last = self.at(end);
        if last.f > T::zero() {
            return Contact::Never;
        }
        let zero = T::zero();
        let two = T::lift(2.0);
        let mut here = start;
        for _ in 0..PATIENCE {
            let bound = self.least_curvature(here.t, end).at_most(zero);
            let root = (here.slope * here.slope - two * bound * here.f).sqrt();
            let step = if here.slope > zero {
                (here.slope + root) / -bound
            } else {
                two * here.f / (root - here.slope)
            };
            here = self.at((here.t + step).at_most(end));
            if here.t > limit {
                return Contact::Never;
            }
            if self.converged(&here) {
                return self.finish(here, blur);
            }
        }
        self.finish(self.bisect(here.t, end), blur)
    }

    /// True once a Newton step would leave about nothing but rounding, or the root is passed by rounding.
    fn converged(&self, here: &Point<T>) -> bool {
        if here.f <= T::zero() {
            return true;
        }
        // s^2 f'' with s = f / f'; never true by products that vanish below the range of the scalar
        let residual = here.f * here.f * self.curvature(here.t).abs();
        here.slope < T::zero() && residual < here.slope * here.slope * self.ulp
    }

    /// True if the Newton step `s` is off by less than an ulp of `D^2`: by `s^2 f'' / 2 + s^3 f''' / 6`.
    fn is_tight(&self, here: &Point<T>, s: T) -> bool {
        let third = (self.c1 + (self.c2 + self.c2) * here.t).abs();
        s * s * (self.curvature(here.t).abs() + s.abs() * third) <= self.ulp
    }

    /// One Newton step, and whether the contact is deep and fast enough to be one.
    fn finish(&self, here: Point<T>, blur: &Blur<T>) -> Contact<T> {
        if here.slope >= T::zero() {
            return Contact::Unclear(here.t);
        }
        let mut here = here;
        let mut inverse = T::one() / here.slope;
        let mut step = here.f * inverse;
        if T::BITS > MANY_BITS || !self.is_tight(&here, step) {
            here = self.polished(here);
            inverse = T::one() / here.slope;
            step = here.f * inverse;
        }
        let mut t = (here.t - step).at_least(T::zero());
        if T::DIFFERENTIATES && t > T::zero() {
            // the root moves as -(change of f) / f' when the step starts where nothing moves, and at the root itself: a start
            // that is off by s leaves an error of the order of s; the value stays that of a scalar without derivatives
            let there = self.at(self.polished(here).t.detached());
            t = t.following(there.t - there.f / there.slope);
        }
        let square = here.slope * here.slope;
        let slow = (self.approach.distance + self.approach.distance) * blur.speed;
        // where this fails an error of the size of the blur moves the contact without bound: see `error.rs`
        let around = (self.blurred + self.blurred) * inverse;
        let bend = self
            .curvature(t + around)
            .abs()
            .at_least(self.curvature(t - around).abs());
        if square <= bend * (self.blurred + self.blurred) {
            self.doubt(&here, bend)
        } else if square <= slow * slow {
            Contact::Unclear(t)
        } else {
            Contact::At(t)
        }
    }

    /// Unclear from the earliest time at which the discs could touch, given a point within the blur of contact.
    #[cold]
    fn doubt(&self, here: &Point<T>, bend: T) -> Contact<T> {
        // from one blur above contact to one below it, and back; where the curvature changes on the way, less
        let mut reach = (self.blurred * T::lift(4.0) / bend).sqrt();
        for _ in 0..PATIENCE {
            if self.at(here.t - reach).f <= self.blurred * T::lift(4.0) {
                break;
            }
            reach *= T::lift(0.5);
        }
        Contact::Unclear((here.t - reach).at_least(T::zero()))
    }

    /// Newton steps until they change nothing any more: for the last digit of many, and from a point that passed the root of a
    /// graze, whose slope is far from that at the root.
    #[cold]
    fn polished(&self, mut here: Point<T>) -> Point<T> {
        for _ in 0..PATIENCE {
            let next = here.t - here.f / here.slope;
            let there = self.at(next);
            if next == here.t || there.slope >= T::zero() || there.f.abs() >= here.f.abs() {
                break;
            }
            here = there;
        }
        here
    }

    /// Decides a graze within a convex stretch by its minimum itself.
    #[cold]
    fn graze(&self, start: Point<T>, end: T, blur: &Blur<T>) -> Contact<T> {
        let zero = T::zero();
        if self.at(end).slope < zero {
            // no minimum before the end of the stretch, so a contact would show there
            return if self.at(end).f > zero {
                Contact::Never
            } else {
                self.finish(self.bisect(start.t, end), blur)
            };
        }
        let (mut from, mut to) = (start.t, end);
        while let Some(middle) = between(from, to) {
            if self.at(middle).slope < zero {
                from = middle;
            } else {
                to = middle;
            }
        }
        let lowest = self.at(from).f.at_most(self.at(to).f);
        if lowest > self.blurred {
            Contact::Never
        } else if lowest >= -self.blurred {
            self.doubt(&self.at(from), self.curvature(from))
        } else {
            self.finish(self.bisect(start.t, from), blur)
        }
    }

    /// Where `f` falls through zero between a time at which it is positive and one at which it is not.
    #[cold]
    fn bisect(&self, mut from: T, mut to: T) -> Point<T> {
        while let Some(middle) = between(from, to) {
            if self.at(middle).f > T::zero() {
                from = middle;
            } else {
                to = middle;
            }
        }
        self.at(from)
    }

    /// Searches from a touching or overlapping start: contact now, or at or after the next turn inward.
    fn search_from_inside(
        &self,
        start: &Point<T>,
        last: T,
        limit: T,
        blur: &Blur<T>,
    ) -> Contact<T> {
        let zero = T::zero();
        let slow = (self.approach.distance + self.approach.distance) * blur.speed;
        if start.slope < -slow {
            return Contact::At(zero);
        }
        // the slope falls only between the inflections
        let Some((first, second)) = self.inflections() else {
            return Contact::Never;
        };
        let (mut from, mut to) = (first.at_least(zero), second.at_most(last));
        if from >= to || self.at(to).slope >= -slow {
            return Contact::Never;
        }
        if from == zero && start.slope <= zero {
            // it turns inward already
            to = zero;
        }
        while let Some(middle) = between(from, to) {
            if self.at(middle).slope >= zero {
                from = middle;
            } else {
                to = middle;
            }
        }
        let turn = self.at(to);
        if turn.f <= self.blurred {
            Contact::At(turn.t)
        } else {
            self.search_from_outside(turn, last, limit, blur)
        }
    }
}

/// The number halfway between two others, unless they are neighbours.
fn between<T: Real>(from: T, to: T) -> Option<T> {
    let middle = from + (to - from) / T::lift(2.0);
    (middle > from && middle < to).then_some(middle)
}
